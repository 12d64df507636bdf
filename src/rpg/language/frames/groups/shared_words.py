"""The words that several groups, towers or patches and their blocks are told in."""

from __future__ import annotations

from re import Match

from rpg.language.frames.pieces import Pattern, number, patterns
from rpg.language.frames.wishes import MOVED, WISHES

_LETTERS = (
    "the |these |those |my |our |your |all |all the |following |given |just |only |with |showing |labell?ed |named "
    "|called "
)
_NOUN = "(?:letter|digit|number|symbol|character|numeral|sign)s?(?: (?:BLOCK))?|BLOCK|tiles?"
_SAID = (
    "(?:numbered |labell?ed |with |showing |marked |in play |to use |we have |are |is |here |given |: |called |"
    "named |namely |from |\\( )*"
)
_EDGE = (
    "(?! (?:(?:SIZE|more|of|to|by|x|high|tall|each) )?(?:COLOR|BLOCK|groups?|piles?|towers?|stacks?|cm|mm|each|"
    r"high|tall|of|or)\b)"
    r"(?! (?:odd|even|vowels?|consonants?|letters?|digits?|numbers?|numerals?)\b)"
)
_LIST = (
    r"(?:[A-Z]|[b-z]|a(?= (?:[,a]|[B-Z] (?!BLOCK)|[b-z] |and [b-z] ))|\d|one(?= ,? ?[2-9])|'[A-Z]')(?:(?: ,)?(?: "
    r"and)?(?: the)? (?:[A-Z]|"
    rf"(?<=[,d] )a|[b-hj-z]|i(?! (?:want|need|have|would|like|wish|am|can|could|should|see|got|think|m|d)\b)|\d|"
    rf"one(?= (?:,|and \d|\d|[.;:)]|are|go|$))|'[A-Z]')(?! [A-Za-z]?BLOCK\b))+{_EDGE}"
)
_RANGE = r"(?:from )?(?:[A-Z]|\d|one) (?:to|through|up to|till|until) (?:[A-Z]|\d)" + _EDGE
_ONE = r"(?:[A-Z]|\d|'[A-Z]')" + _EDGE


def glyphs(said: str) -> tuple[str, ...]:
    """The symbols of a list such as "A , B and C", or from the first to the last: "1 to 6"."""
    words = [word.strip("'") for word in said.split()]
    found = [
        "1" if word == "one" else word.upper() for word in words if (len(word) == 1 and word != ",") or word == "one"
    ]
    if {"to", "through", "till", "until"} & set(words):
        return tuple(map(chr, range(ord(found[0]), ord(found[1]) + 1)))
    return tuple(found)


def _listed(match: Match[str]) -> tuple[str, ...]:
    return glyphs(match["list"])


GLYPHS: list[Pattern] = [
    *patterns(
        "glyphs", _listed,
        f"(?:{_LETTERS})*(?:(?:{_NOUN}) )(?:{_SAID})(?P<list>{_LIST}|{_RANGE}|{_ONE})(?: BLOCK)?(?: \\))?",
        f"(?:{_LETTERS})*(?:(?P<number>[2-9]) )?(?:(?P<sort>odd|even|vowel|consonant) (?=\\w+ "
        f"(?!:)))?(?:(?:{_NOUN}) )(?:{_SAID})"
        f"(?P<list>{_LIST}|{_RANGE})",
        f"(?:{_LETTERS})*(?:(?P<number>[2-9]) )?(?P<sort>vowel|consonant)s (?!:)(?:{_SAID})(?P<list>{_LIST}|{_RANGE})",
        f"(?:the )?(?P<list>{_LIST}|{_RANGE})", "(?:the |a |an )?(?P<list>[A-HJ-Z])(?: BLOCK)?",
        "(?:the )?(?P<list>I)(?: BLOCK)?(?! [a-z])",
    ),
    *patterns(
        "glyphs", lambda match: (match["list"],) * number(match["count"]),
        r"(?:the )?(?P<count>\d|two|three|four|five|six) (?P<list>[A-Z])s?(?: BLOCK)?",
        r"(?:the )?(?P<count>\d) (?:BLOCK|letters|tiles) (?:with|showing|labell?ed|marked) (?:an? |the letter "
        r")?(?P<list>[A-Z])(?! ,? ?(?:and )?[A-Z]\b)",
    ),
]  # fmt: skip
"""Lists of symbols."""
LOTS: list[Pattern] = [
    *patterns("lot", None,
        r"(?:(?P<det>the|these|those|my|our|your|all|all the|all of the|both|both the|a|an|exactly|just|only|every|"
        r"each(?! NUM\b)|with|all of them|all of which|(?:all of them|all of which|all|they|they all) are) )?"
        r"(?:(?P<count>NUM) )?(?:of the |of )?(?:(?P<size>SIZE) )?(?:plain )?(?P<color>COLOR)(?P<many>s)?"
        r"(?: (?P<behind>SIZE))?(?: (?P<noun>BLOCK|ones|one(?! (?:COLOR|of|pile|group|heap|tower|stack))))?"
        r"(?: \( (?P<paren>NUM)(?: BLOCK| of them)? \)| , (?P<among>NUM) of them(?: ,)?)?"),
    *patterns(
        "total", lambda match: number(match["count"]),
        "(?:of |from |with |using )?(?:the |all |exactly |all the |these |those )?(?P<count>NUM) (?:identical |"
        "plain )?BLOCK(?: in total| in all| altogether| overall)?",
        "(?P<count>NUM) (?:in total|in all|altogether|overall)",
        "there (?:are|is) (?P<count>NUM) of them(?: in total| in all)?",
    ),
    *patterns(
        "each", lambda match: number(match["count"]),
        "(?:(?:exactly|there are|with|always) )?(?P<count>NUM) (?:BLOCK )?(?:each(?: of| in)?|apiece|(?:of|in|per|"
        "for) (?:each|every)(?: one)?(?: of| of the| of these)?(?: NUM)? colors?|of (?:each|every|both)(?: one| "
        "kind| color)?)",
        "(?:exactly )?(?P<count>NUM) (?:BLOCK )?each", "(?:of )?(?:each|every)(?: of the)? colors? (?:has |gets |"
        "with |of |: |is "
        "|there are |we have |i have |exactly |just )*(?P<count>NUM)(?: BLOCK| ones| of them| pieces)?(?! COLOR)",
    ),
    *patterns("lot", None,
        r"(?P<count>[2-9](?! is)|NUM(?= of))(?: BLOCK)? (?:of (?:them|these|those|which|the BLOCK) )?(?:are|is) "
        r"(?P<color>COLOR)"
        r"(?! BLOCK)", r"(?P<color>COLOR)(?P<many>s)?(?: BLOCK)? (?:x|×|\*|<\*>) (?P<count>NUM)",
        r"(?P<color>COLOR)(?P<many>s)? (?:: |= )?(?P<count>[2-9])(?: (?:BLOCK|pcs|of them)(?! (?:high|tall|each|in|"
        r"per|for)))",
        r"(?P<count>NUM) (?:x|×|\*|<\*>) (?P<color>COLOR)(?P<many>s)?(?: (?P<noun>BLOCK))?"),
    *patterns("lot", None,
        r"BLOCK (?P<color>COLOR)(?P<many>) (?P<count>[2-9])(?= (?:,|and|\.|;))",
        "(?:(?:the|all|all the|those|these) )?BLOCK (?:that|which) (?:are|is) (?P<color>COLOR)(?P<many>)(?! BLOCK)",
        "(?:everything|all|anything) (?:that is |which is )?(?P<color>COLOR)(?P<many>)(?! BLOCK)"),
    *GLYPHS,
]  # fmt: skip
"""Lots as in `lots`, but "the other red" is not one; and lists of symbols."""
_HEAP = (
    "(?:(?:all|mixed up|jumbled|mixed|together|out|lying|thrown|tossed) )*(?:in|as|on) (?:a|one) (?:(?:big|single|"
    "messy|random|large|mixed) )*(?:heap|pile|jumble)(?: on the TABLE)?"
)
_BEGIN = (
    "starts?|begins?|starts? out|begins? out|starts? off|are now|are at present|are at the moment|are currently|"
    "now lie|currently lie"
)
START = "At the start, the blocks are in a heap."
STARTS: list[Pattern] = patterns(
    "start", None, f"(?:(?:which|that|they|all|the BLOCK|now) )*(?:{_BEGIN}) {_HEAP}(?: now| at first)?",
    f"(?:(?:which|that|they|all|the BLOCK) )*(?:are|lie|is) {_HEAP} (?:now|at first|at the start|at the beginning|"
    "initially|to begin with|at the moment|right now)",
    "(?:at first|at the start|at the beginning|initially|to begin with|right now|now)(?: ,)? (?:(?:they|all|the "
    f"BLOCK|everything) )*(?:are|lie|is) {_HEAP}",
)  # fmt: skip
"""Kind "start": what is said of the blocks before they are moved."""
OF = (
    "(?:of|in|with|from|for|is for|has|have|having|contains|contain|containing|comprises|comprise|comprising|holds|"
    "hold|holding|includes|include|including|takes|gets|uses|using|BE|shall|should|must|has to|ought to|to|be|"
    "consists of|consist of|consisting of|composed of|made of|made out of|made from|made up of|made only of|made|"
    "'s|'s got|has got|have got|got|all the|with all|"
    "built|built of|built from|formed by|formed of|formed from|out of|all|entirely|only|purely|completely)"
)
"""What stands between a group or a tower and its blocks."""
ALSO: list[Pattern] = [*WISHES, *patterns(
    "glue", None, MOVED,
    "(?:have|has|need|needs|ought|are|is) to(?: be)?|(?:can|will|shall|could|would|may) be",
    "ought to|is to|supposed to|desired|wanted|required|needed|expected|result|results|resulting|emerge|erected|"
    "raised|erect|raise|take|become|becomes|turn into|turned into|end up|ends up|them|these|those|they|that have|"
    "hold|holds|comprise|available|given|that is to say|following|the following|in other words|namely|make up",
    "(?:all )?(?:the|my|these|those) (?:things|items|objects|toys|stuff|shapes|bunch|lot|guys)",
    "makes up|its|say|let us say|let there be|is what (?:I|i|we) (?:want|need)|what (?:I|i|we) (?:want|need) (?:is|"
    "are)",
)]  # fmt: skip
"""More words that say nothing beside what several things are made of."""
STOPS: list[Pattern] = [
    *patterns(
        "stop", None, "[.;!?:]",
        "(?:altogether|in total|in all|overall|all in all)(?: ,)? (?:there are|we have|i have|you have|there will "
        "be|use|using)",
        "(?:by |when )?(?:using|use|(?:have|got)(?= NUM)|there (?:are|is|'s)|we have|i have|you have|given)(?: got)?",
    ),
    *patterns("from", None, "from|out of|apart from|away from|separate from|separated from"),
    *patterns("break", None, "[,()&/]|<[+/]>", "and|with|while|where|but|whereas|plus|n"),
]  # fmt: skip
"""Behind a stop the blocks of one thing are not those of the thing before."""
