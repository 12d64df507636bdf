"""What is told over several sentences and is one thing: "Is A next to B? If not, put it there.", "Scatter six cubes.
Success if they form a row.", "One: ... Two: ... In that order.", as rows over a whole text that say it at once."""

from __future__ import annotations

from rpg.language.grammar.rows.begun import HEAP
from rpg.language.grammar.rows.contrasted import WRONG_WAY_ROUND
from rpg.language.grammar.rows.kinds_in_rows import ROWS_HAVE
from rpg.language.grammar.rows.rows_alike import ROWS_ALIKE
from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.two_rows import WORDS_IN_ROWS
from rpg.language.grammar.rows.two_words import TWO_WORDS
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, END, LIES, LINE, MANY, MUST, PATCH, PATCHES

_NEXT = (
    "(?=success\\b|the (?:task|goal|game|robot|player)\\b|goal\\b|it is\\b|now\\b|then\\b|at the end\\b|in the end\\b|"
    "finally\\b)"
)
_TAKE = "(?:take|pull|get|pick|remove|bring|fetch|grab|lift|move|put|place|carry)"
_ORDER = "(?: (?:all )?(?:in|exactly in) (?:that|this|the given) (?:order|sequence) \\.?)"
_ABOUT = (
    "(?: randomly| at random)?(?: all)?(?: (?:on|over|around|across|about)(?: the table)?)?(?: randomly| at random)?"
)
_THERE = "(?:there|that way|like that|so)"

_NUMBERED = ("one|1 \\.", "two|2 \\.", "three|3 \\.")


_TIDY = "^(?:(?:please|kindly|can|could|would|will|you|now) )*(?:tidy|clean)(?: up)? "
_FOR = "(?: up)?(?: for (?:me|us|her|him|them))?(?: please)? [.:?!] (?=.)"
_SYMBOLS = f"(?:letters|digits|numbers|{CUBE}s|(?:letter|digit|number) {CUBE}s)(?: (?:\\w|,|and|to)\\b| ,)+"


def _of_two(one: str, both: str) -> str:
    """ "One mat is blue and the other white"."""
    return (
        f"one (?:of the (?:two )?{both}|{one}) is ({COLOR})(?: ,| and| , and)+ (?:the other|one)(?: one| {one})?"
        f"(?: is)? ({COLOR})(?= \\.|$)"
    )


def _in_steps(many: int) -> Turn:
    """ "One: red on blue. Two: green on red. In that order."."""
    steps = " ".join(f"(?:{number}) :? ?(.+?) \\." for number in _NUMBERED[:many])
    told = " . then , ".join(f"{{{n}}}" for n in range(1, many + 1))
    return f"^(?:(?:checklist|list|steps|plan|sequence) [.:] )?{steps}{_ORDER}$", f"first , {told} ."


_HAS = "(?:has|contains|consists of|is made(?: up)? of|is built (?:of|from))"
_KNOWN = f"(?:the {COLOR}(?: {CUBE}| one)?|[a-z0-9])"
_NOW_ON = f"{LIES}(?: already| now| at the start)* on"
_ON = "(?: \\.| ,| and| , and)"
"""How a sentence goes on, or the next one does."""
ACROSS: tuple[Turn, ...] = (
    ("\\buse (?:one|a) color for (?:one|the \\S+) (row|line|column|tower|stack|layer) and (?:a different|another)(?: "
     "color| one)? for (?:the )?(?:\\S+ )?(?:\\1|one)(?= \\.|$)", "each {1} has a different color"),
    (f"^is (the (?:(?!\\b{PLACE}\\b)[^?.])+?|[^ ]+) ({PLACE} (?:(?!\\b{PLACE}\\b)[^?.])+?) \\? if (?:not|it is not) ,? "
     f"?(?:please )?(?:put|move|bring|place|make|set) it {_THERE}(?: please)?(?= \\.| !|$)", "put {1} {2}"),
    (f"^(?:scatter|strew|randomize|distribute randomly|drop) ((?:the |all )?{MANY} [^.,]+?){_ABOUT} \\. {_NEXT}",
     "there are {1} . "),
    ("^(?:randomize|shuffle|jumble) the (?:start|scene|beginning|initial (?:state|positions?)) [:,.] (.+?) \\. "
     + _NEXT, "at the start : {1} . "),
    *map(_in_steps, (3, 2)),
    ("^the (circle|ring|row|line|column|tower|stack|square|pyramid|wall|grid) (?:has|contains|consists of|is made(?: "
     f"up)? of) (?=(?:an?|{MANY}) (?:\\w+ )+(?:and|,) [^.]+ \\.?$)", "a {1} of "),
    # of what there is, a part is moved
    (f"^(?:the )?({LINE}) {_HAS} (?=(?:{MANY} {CUBE}|[^.]*?{COLOR})[^.]* \\. (?:please |now |then )*(?:{_TAKE}|swap|"
     f"turn|reverse)(?: off| away| down)? (?:the (?:{END}|middle|lowest|highest|first|last)|its|it)\\b)",
     "there is a {1} of "),
    (f"^(.*?\\b{MANY} (?:rows|columns|lines|towers|stacks|layers)(?: of {MANY}(?: {CUBE}s)?)?) \\. (?=each (?:row|"
     "column|line|tower|stack|layer) (?:has|is|must|should) )", "{1} , "),
    (f"^(the (?:numbers|digits|letters|words|blocks|cubes) [^.?]*?|{THING}) (?:got|are|were|have been|have got) (?:all "
     ")?(?:mixed up|jumbled up|jumbled|messed up|scrambled|shuffled|out of order|in disorder|in a mess) \\. "
     "(?=.)", "there are {1} . "),
    (f"\\b(?:(?:in|at) the end ,? ?)?there (?:is|{MUST} be) exactly one (tower|stack)(?: (?:in|at) the end)?{_ON} it "
     f"(?:is made of|is built of|consists of|has) (?:exactly )?({MANY})(?: of them| {CUBE}s)?{_ON} (?=the (?:other|"
     f"remaining) {MANY} .*on the table\\b)",
     "exactly {2} of them must form a {1} . "),
    # what is there, told as what is to be tidied
    (f"{_TIDY}(the {_SYMBOLS}|the {MANY} {COLOR} [^.:?!]*?{CUBE}s){_FOR}", "there are {1} . "),
    (f"{_TIDY}(?:the|my|our) (?:{CUBE}s|letters|digits|numbers|toys){_FOR}", ""),
    *WRONG_WAY_ROUND,
    *WORDS_IN_ROWS,
    *TWO_WORDS,
    *ROWS_ALIKE,
    *ROWS_HAVE,
    ("\\b(in two rows) \\. (?=[^.]* in the (?:back|front|far|near|first|second) row\\b)", "{1} : "),
    # "B on the same mat as A, which is on the red one"
    (f"^(.*\\bon) the same {PATCH} as ({_KNOWN}) (?=[.,;] (.*\\b)?\\2 {_NOW_ON} (the {COLOR} {PATCH})\\b)", "{1} {4}"),
    (f"^(.*\\b({_KNOWN}) {_NOW_ON} (the {COLOR} {PATCH})\\b.*\\bon) the same {PATCH} as \\2(?= [.,;!]|$)", "{1} {3}"),
    # "one mat is blue, the other is white"
    (f"^(.*\\btwo {PATCHES}) \\. {_of_two(PATCH, PATCHES)}", "{1} , one is {2} , the other is {3}"),
    (f"^(.*\\. )?{_of_two(PATCH, PATCHES)}", "{1} there are a {2} patch and a {3} patch"),
    (f" , {_of_two(PATCH, PATCHES)}", " . there are a {1} patch and a {2} patch"),
    (f"^(.*\\. )?{_of_two(CUBE, f'{CUBE}s')}", "{1} one is {2} , the other is {3}"),
    (f"^((?:(?!\\b(?:{HEAP}|{_TAKE})\\b).)*?(?:from|out of) )the ({HEAP}) of (?={MANY} )", "{1} a {2} of "),
    (f"^(.+?) \\. but (?=(?:{THING}|none|no|nothing|not|the) .*(?:{MUST}|may|can|is|are)\\b)", "{1} . "),
)  # fmt: skip
"""What is looked for in a text, and what is said instead."""
WORDS = ("checklist scatter strew",)
"""Words that these take besides those that are read anyway."""
