"""An equation: told, or to be made of given symbols."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear, number, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE
from rpg.language.frames.wishes import WISHES

_SIGNS = {
    "+": "<\\+>|plus(?: signs?| symbols?)?",
    "-": "<->|minus(?: signs?| symbols?)?|take away|less",
    "*": "<\\*>|times(?: signs?| symbols?)?|multiplied by|(?:sign of )?multiplication signs?|x",
    "/": "</>|divided by|over|(?:sign of )?division signs?|divide signs?",
    "=": "<=>|equals?(?: signs?| symbols?| to)?|is equal to|makes?|is|gives?|are|equality signs?|(?:sign of )?equality",
}  # fmt: skip
"""Signs as they are told; in a list of symbols, and in an equation in words."""
_SIGN = "|".join(_SIGNS.values())
_LISTED = _SIGN.replace("|makes?|is|gives?|are|", "|")
"""Signs in a list, where "makes" is none."""
_ITEM = (
    rf"(?:(?:the |and |and the |a |and a |an |and an |one )*(?:\d(?! plus signs| minus signs)|(?:2 )?(?:{_LISTED}|"
    "signs?(?: of)? (?:plus|minus|equality))))"
)
_KIND = {"addition": "addition", "sum": "addition", "subtraction": "subtraction", "difference": "subtraction",
    "multiplication": "multiplication", "product": "multiplication", "division": "division",
    "quotient": "division",
}  # fmt: skip
_OF = {"addition": "+", "subtraction": "-", "multiplication": "*", "division": "/"}
_TRUE = (
    "true|correct|valid|right|proper|working|correctly solved|solved|legal|accurate|real|mathematically correct|"
    "mathematically true"
)
_GOOD = f"(?:{_TRUE}|holds|works|works out|adds up|makes sense|comes out right|balanced|balances|in order)"

PATTERNS = [
    *patterns("equation", lambda match: match["said"], r"<(?P<said>[\d+*/=-]{5,})>"),
    *patterns(
        "equation", lambda match: _written(match["words"]),
        rf"(?P<words>\d+ (?:{_SIGN}) \d+(?: (?:{_SIGN}) \d+)*)(?! (?:, |and |, and )?(?:<.>|equals sign|plus|minus|"
        r"times|\d))",
    ),
    *patterns(
        "symbols", lambda match: _symbols(match["list"]),
        "(?:(?:the |these |only |just |exactly |following |given |your |my |i have |we have |you have |there are |"
        "namely )*(?:number |digit |symbol |numbered |operator |sign |operation )?(?:BLOCK|signs|operators|digits|"
        "numbers|symbols|numerals|"
        "tiles|cards) ?(?:: |with |showing |labell?ed |marked |are |is |and signs |and symbols |and operators "
        f")*)?(?P<list>{_ITEM}(?:(?: ,| and| with| ;| together with| as well as| along with| plus(?= an? ))* "
        f"{_ITEM})+)",
    ),
    *patterns(
        "figure", lambda match: _kind(match[0].split()),
        f"(?:(?:a|an|the|one|some|this) )?(?:(?:math|maths|arithmetic|simple|little|single|{_TRUE}|complete|"
        "addition|subtraction|multiplication|division|horizontal) )*(?P<kind>equation|sum|addition|subtraction|"
        "multiplication|division|product|"
        "calculation|formula|difference|quotient)(?: (?:equation|sum|problem|task|exercise))?(?: in one row| in "
        "a row)?",
    ),
    *patterns(
        "true", None,
        "(?:(?:so )?that |which |so |such that |and |, )*(?:(?:it|this|the equation|the sum|the result|the "
        "answer|the calculation|everything|the math|the maths) )?(?:BE |must |should |has to |to |actually |"
        f"really |and )*{_GOOD}(?: out)?",
    ),
    *patterns(
        "all", None,
        "(?:(?:and|by|using|use|with|where|of which) )*(?:each|every|all)(?: one)?(?: (?:of|the|them|these|BLOCK|"
        "symbols?|digits?|numbers?))*(?: (?:BE|must|should|has|have|to|used|gets|getting|only|just|exactly|once|"
        "up|being))*", "(?:and )?(?:leave|leaving) (?:nothing|none)(?: of them)? (?:out|over|unused)",
        "(?:and |with )?(?:nothing|no BLOCK) (?:BE )?(?:left|left over|unused|left out)",
        "(?:exactly|only|just) once(?: each)?", "once each",
    ),
    *patterns(
        "order", "", "(?:(?:from|reading|read|going|to be read) )*(?:the )?left (?:to|through) (?:the )?right",
        "(?:in|as|along|to form|on|into) (?:a |one |the )?(?:single |straight |horizontal )*(?:row|line)",
        "(?:a )?(?:row|line)", "side by side", "next to (?:each other|one another)",
    ),
    *patterns(
        "order", " from top to bottom",
        "(?:(?:from|reading|read|going|to be read) )*(?:the )?top (?:to|through) (?:the )?bottom(?: in (?:a|one) "
        "(?:tower|stack))?",
    ),
    *patterns(
        "gaps", "The blocks touch each other.",
        "(?:with )?(?:all )?(?:the )?(?:BLOCK )?(?:BE )?(?:touching|touch)(?: (?:each other|one another))?",
        "(?:with|leaving) no gaps?(?: between (?:them|the BLOCK))?",
        "without (?:any )?gaps?(?: between (?:them|the BLOCK))?",
    ),
    *patterns(
        "gaps", lambda match: f"The gaps are {match['gap']} {match['unit']}.",
        r"(?:with |leave |leaving |at )*(?:gaps? of )?(?P<gap>[\d.]+) (?P<unit>cm|mm) (?:gaps?|of space|space|"
        "apart|between (?:them|the BLOCK|neighbo(?:u)?rs|neighboring BLOCK))*",
    ),
    *patterns(
        "color", lambda match: match["color"],
        "(?:from |in |with |of |out of |using )?(?:all )?(?P<color>COLOR)s?(?: (?:number|digit|symbol))?(?: "
        "BLOCK)?",
    ),
    *WISHES,
    *WHERE,
    *BREAKS,
    *GLUE,
    *patterns(
        "glue", None,
        "solve|solving|compute|do|complete|write|writes|written|spell out|read|reads|reading|say|says|saying|"
        "states|stating|state|display|displayed|displays|demonstrate|express|expresses|present|that|the fact|by "
        "means of|with|number|symbol|on blocks|blocks|cubes",
    ),
    *patterns(
        "glue", None,
        "for (?:me|us|my|our|the|his|her) (?:class|pupils|kids|children|students|son|daughter|lesson|homework)|"
        "homework|math|maths|arithmetic|puzzle|can be read|readable|legible|visible|completion|task|them|it|they|"
        "so that they|so they|up|out|number and sign BLOCK|number BLOCK|sign BLOCK|digit BLOCK",
    ),
]  # fmt: skip


def _kind(words: Sequence[str]) -> str:
    """What kind of equation is told: "an addition equation"."""
    return next((_KIND[word.rstrip("s")] for word in words if word.rstrip("s") in _KIND), "equation")


def _sign(said: str) -> str:
    """The sign that a word tells."""
    return next(sign for sign, words in _SIGNS.items() if re.fullmatch(words, said))


def _written(words: str) -> str:
    """An equation in words: "2 plus 3 equals 5"."""
    first = words.split()[0]
    return first + "".join(_sign(sign) + after for sign, after in re.findall(rf" ({_SIGN}) (\d+)", words[len(first) :]))


def _symbols(words: str) -> tuple[str, ...]:
    """The symbols of a list: "2 , 3 , plus and equals", "2 plus signs"."""
    words = re.sub(r"\bsigns?(?: of)? (plus|minus|equality)\b", r"\1", words)
    if len(re.findall(r"\bone\b", words)) == 1:
        words = re.sub(r"\bone\b", "1", words)  # "one four and five", and not "one 4 and one 5"
    words = re.sub(r"\b(?:the|an?|one)\b ?", "", words)
    found: list[str] = []
    for count, sign, digit in re.findall(rf"(?:(2) (?=(?:plus|minus|times) signs))?(?:({_SIGN})(?= |$)|(\d))", words):
        found += [_sign(sign)] * number(count or "1") if sign else [digit]
    return tuple(found)


def told(pieces: Sequence[Piece]) -> str:
    """The equation in plain sentences.

    Raises:
        Unclear: it is not told which symbols it is made of, or they do not agree with what is told of it.
    """
    figure, equation, order, gaps, color, where = (
        one(pieces, kind) for kind in ("figure", "equation", "order", "gaps", "color", "where")
    )
    lists = [piece.value for piece in pieces if piece.kind == "symbols"]
    symbols = tuple(symbol for said in lists for symbol in said) if len(set(lists)) == len(lists) else lists[0]
    kind = figure.value if figure else "equation"
    if pieces[0].words in ("is", "are") or (color and where and color.words.startswith("with")):
        raise Unclear  # a question; "with red blocks on the mat", which are not those of the equation
    if equation:
        said = equation.value
        if said.count("=") != 1 or (symbols and sorted(symbols) != sorted(said)):
            raise Unclear
        if kind in _OF and _OF[kind] not in said:
            raise Unclear
        text = f"Make the equation {said}"
    elif symbols and figure:
        text = f"Make {_made_of(symbols, kind)}"
    else:
        raise Unclear
    text += f" from {color.value} blocks" if color and equation else ""
    if color and not equation:
        raise Unclear
    text += f"{order.value if order else ''}."
    text += f" {gaps.value}" if gaps else ""
    return text + (f" The equation is {where.value}." if where else "")


def _made_of(symbols: Sequence[str], kind: str) -> str:
    """An equation of given symbols.

    Raises:
        Unclear: the signs are not those of such an equation.
    """
    signs = {symbol for symbol in symbols if not symbol.isdigit()}
    digits = [symbol for symbol in symbols if symbol.isdigit()]
    if kind in _OF:
        if signs - {"=", _OF[kind]} or (signs and "=" not in signs):
            raise Unclear
        if len(signs) == 1:
            raise Unclear
        if not signs:
            article = "an" if kind == "addition" else "a"
            return f"{article} {kind} from the digits {', '.join(digits)}"
    elif "=" not in signs or len(signs) < 2:
        raise Unclear
    return f"a true equation from {', '.join(symbols[:-1])} and {symbols[-1]}"
