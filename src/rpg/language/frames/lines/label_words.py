"""What people say of rows of letters and digits: the labels, lists and ranges of them, and how they are sorted."""

from __future__ import annotations

import re
import string

from rpg.language.frames.pieces import Pattern, number, patterns

_NOUN = "(?:letters?|vowels?|consonants?|digits?|numbers?|numerals?|symbols?|characters?|figures?)"
_ONE = "(?:block|cube|tile|piece|letter|digit|number)"
_CARRIES = (
    "(?:(?:that |which )?(?:with|has|have|showing|shows|bearing|bears|labelled|labeled|marked|numbered|lettered|"
    "carrying))"
)
_NEXT = (
    r"(?:,|and|→|[A-Z]|[b-hj-z]|BE|to|through|at|on|in the|in a|in one|from left|from right|left|right|before|after|"
    r"first|last|second|third|\.)"
)
_SPEAKS = "(?:can|could|want|need|have|would|like|see|wish|should|am|will|must|may|read|do|get|expect)"
LABEL = (
    rf"[A-HJ-Z]|I(?= (?:(?:,|and|[A-Z]|in|on|at|from|is|are|to|block|cube|\.) |$))|[b-hj-z]|"
    rf"\d(?! (?:of|plain|colored|more|other|further|different) )|'[A-Z0-9]'|"
    rf"a(?= (?:{_NEXT} |$))|i(?= (?:,|and|[A-Z]|[b-hj-z]|BE) )"
)
_DIGITS, _LETTERS = string.digits, string.ascii_uppercase


def _bare(said: str) -> str:
    return "1" if said == "one" else said.strip("'").upper()


def between(first: str, last: str) -> list[str]:
    """All labels from one to another, either way; none where they are of different kinds."""
    for known in (_DIGITS, _LETTERS):
        if first in known and last in known:
            a, b = known.index(first), known.index(last)
            return list(known[a : b + 1] if a <= b else known[b : a + 1][::-1])
    return []


def _range(match: re.Match[str]) -> list[str]:
    return between(_bare(match["first"]), _bare(match["last"]))


def _every_other(match: re.Match[str]) -> list[str]:
    """The even or odd digits of a range ("from 2 to 8 from right to left" tells two ways, and is left alone)."""
    return [label for label in _range(match) if label.isdigit() and int(label) % 2 == (match["which"] == "odd")]


_TO = "(?:to|through|thru|till|until|up to|…|down to|up through)"
LABELS: list[Pattern] = [
    *patterns("lot", None,
        rf"(?:(?P<det>the|a|an|one|my) )?(?:{_ONE} )?(?:{_ONE} (?:{_CARRIES} (?:the |a |an )?(?:{_NOUN} "
        rf")?)?)?(?P<label>{LABEL})(?: {_ONE})?(?! blocks)",
        r"(?P<count>\d|a|an|one|two|three|four|five|six) (?P<label>[A-Z]) (?:blocks|block|cubes|cube)",
        rf"(?:the )?(?P<label>[A-Z])(?: {_ONE})? (?:(?:x|times) (?P<count>\d)|(?:(?:appears|occurs|comes) )?"
        r"(?P<often>once(?! each)|twice|\d(?= times))(?: times)?)",
        r"(?P<count>\d) (?:x|times) (?:the )?(?P<label>[A-Z])"),
    *patterns("range", _range,
        rf"(?:the )?(?:{_NOUN} |blocks |cubes )?(?:(?P<way>from|starting with|beginning with) )?(?P<first>{LABEL}|"
        rf"one) {_TO} (?P<last>{LABEL})(?: inclusive)?",
        rf"(?:from )?(?P<first>{LABEL}) (?:at|on) the (?P<side>left|right)(?: end| side)? {_TO} (?P<last>{LABEL}) (?:"
        rf"at|"
        rf"on) the (?:left|right)(?: end| side)?"),
    *patterns("range", _every_other,
        rf"(?:all )?(?:of )?(?:the )?(?P<which>even|odd) (?:{_NOUN}|BLOCK)(?: from)? (?P<first>{LABEL}|one) {_TO} "
        rf"(?P<last>{LABEL})(?: inclusive)?(?! from )"),
    *patterns("range", lambda match: list(_LETTERS[: int(match["n"])]),
        r"(?:the )?first (?P<n>\d+) letters(?: of the alphabet| in the alphabet)?"),
    *patterns("range", lambda match: list(_DIGITS), r"all (?:of )?(?:the )?(?:10 )?(?:digits|numerals)(?= )(?! "
        r"(?:from|0|1))"),
    *patterns("range", list(_DIGITS), r"(?:all )?(?:the )?10 (?:digits|numerals) ,? ?(?:from )?0 (?:to|through) 9"),
    *patterns("extreme", "low",
        rf"(?:the )?(?:smallest|lowest|least|minimum)(?: (?:{_NOUN}|one|BLOCK|value)(?: BLOCK)?)?(?: of (?:them|"
        rf"these|those|all|the 3|the 4|the 5))?"),
    *patterns("extreme", "high",
        rf"(?:the )?(?:largest|biggest|highest|greatest|maximum)(?: (?:{_NOUN}|one|BLOCK|value)(?: BLOCK)?)?(?: of "
        rf"(?:them|these|those|all|the 3|the 4|the 5))?"),
    *patterns("total", lambda match: number(match["n"]),
        r"(?:the |all |these |my |of )*(?P<n>\d+) (?:(?:letter|digit|number|numbered|lettered|alphabet) "
        r")?(?:letters|digits|numbers|numerals|BLOCK|characters|symbols)",
        r"of (?P<n>\d+)(?= (?:[:(]|with|where|that|which|in|from|made) )"),
]  # fmt: skip
"""Kinds "lot" (named "label": see `lot_of`), "range" (a list of labels), "extreme" ("low", "high") and "total"."""

_SORTS = (
    "(?:(?:in|into|by|the|an|a|with|BE|sorted|sort|ordered|order|arranged|arrange|their|its|according to|following|"
    "strictly|run|they|stand|put|going|listed|running|goes|go|runs|all|so that they are) )*"
)
_ABC = "(?:alphabetical(?:ly)?|alphabetic|alphabet|abc|a to z|A to Z|a to Z|dictionary|lexicographic(?:al)?)"
_BACK = "(?:reverse|reversed|inverse|inverted|backwards?|opposite)"
_ORDER = "(?: (?:order|sequence|sorted|ordered|arranged|value|number|numerical|numeric|values))*"
_LOW = "(?:smallest|lowest|least|low|small|smaller|lower)"
_HIGH = "(?:largest|biggest|highest|greatest|high|big|large|bigger|larger|higher)"
_WHAT = rf"(?: (?:{_NOUN}|one|BLOCK))?"
_TOWARD = "(?: (?:to|towards?) the (?P<toward>left|right))?"
_UP = "(?:ascending|increasing|counting up|going up|(?:rising|growing)(?= (?:order|sequence|numerical|number|to|from)))"
_DOWN = (
    "(?:descending|decreasing|counting down|going down|(?:falling|diminishing)(?= (?:order|sequence|numerical|number|"
    "to|from)))"
)
SORTED: list[Pattern] = [
    *patterns("sort", "abc", f"{_SORTS}{_ABC}{_ORDER}{_TOWARD}"),
    *patterns("sort", "zyx",
        f"{_SORTS}{_BACK} {_ABC}{_ORDER}{_TOWARD}", f"{_SORTS}(?:z to a|Z to A|Z to a|z to A)",
        f"{_SORTS}{_ABC}{_ORDER} (?:in reverse|reversed|backwards?|but (?:in reverse|backwards?|reversed))"),
    *patterns("sort", "rises", f"{_SORTS}{_UP}{_ORDER}{_TOWARD}"),
    *patterns("sort", "falls", f"{_SORTS}{_DOWN}{_ORDER}{_TOWARD}"),
    *patterns("sort", "up",
        f"(?:they |that |which )?(?:counts?|goes|go|climbs?|runs?) up(?:wards)?{_TOWARD}",
        f"(?:so that |and |with )?(?:(?:the|their) )?(?:{_NOUN}|values?|they|which|it) (?:must |should |shall |to |"
        f"have to |may only )?(?:increase|increases|increasing|rise|rises|grow|grows|ascend|ascends|go up|get "
        f"(?:bigger|larger|higher)|gets? (?:bigger|larger|higher)){_TOWARD}",
        f"{_SORTS}(?:from )?(?:the )?{_LOW}{_WHAT} (?:to|up to) (?:the )?{_HIGH}{_WHAT}", f"(?:with )?(?:the "
        f")?{_LOW}{_WHAT} (?:BE )?first",
        f"(?:with )?(?:the )?{_HIGH}{_WHAT} (?:BE )?last"),
    *patterns("sort", "down",
        f"{_SORTS}{_BACK} (?:numerical|numeric|number|counting)(?: (?:order|sequence))?",
        f"(?:they |that |which )?(?:counts?|goes|go|runs?) down(?:wards)?{_TOWARD}",
        f"(?:so that |and |with )?(?:(?:the|their) )?(?:{_NOUN}|values?|they|which|it) (?:must |should |shall |to |"
        f"have to |may only )?(?:decrease|decreases|decreasing|fall|falls|shrink|descend|descends|go down|gets? "
        f"(?:smaller|lower)){_TOWARD}",
        f"{_SORTS}(?:from )?(?:the )?{_HIGH}{_WHAT} (?:to|down to) (?:the )?{_LOW}{_WHAT}", f"(?:with )?(?:the "
        f")?{_HIGH}{_WHAT} (?:BE )?first",
        f"(?:with )?(?:the )?{_LOW}{_WHAT} (?:BE )?last"),
    *patterns("sort", "numbers",
        f"{_SORTS}(?:numerical(?:ly)?|numeric(?:ally)?|number|counting|natural|normal number)(?: (?:order|sequence|"
        f"sorted|ordered))+{_TOWARD}", f"{_SORTS}numerically(?: (?:sorted|ordered))?",
        "(?:sorted|sort|ordered|arranged) (?:them )?by (?:number|value|size of the number|numerical value|their "
        "numbers?|their value)"),
    *patterns("sort", "listed", "(?:all )?in (?:(?:the |their )?(?:right |correct |proper |usual |natural "
        "))?(?:order|sequence)", "sorted", "ordered", "sort(?: them)?", "order(?= the)"),
    *patterns("backwards", None, "(?:but )?(?:in )?(?:the )?(?:reverse|reversed|backwards?)(?: "
        "order)?", "(?:but )?(?:in )?(?:the )?(?:opposite|inverse) order"),
]  # fmt: skip
"""Kind "sort": "abc" and "zyx" of letters, "up", "down" and "numbers" (which may run either way) of digits, "listed" as
they are listed, which must be sorted; "backwards": as they are listed, the last first."""

_KINDS = {
    "even": "evens?(?: (?:digits|numbers|ones|BLOCK))?",
    "odd": "odds?(?: (?:digits|numbers|ones|BLOCK))?",
    "vowel": "vowels",
    "consonant": "consonants",
    "letter": "letters",
    "digit": "(?:digits|numbers)",
}
_PAIRS = (
    ("even", "odd"),
    ("odd", "even"),
    ("vowel", "consonant"),
    ("consonant", "vowel"),
    ("letter", "digit"),
    ("digit", "letter"),
)


_COME = "(?: (?:must |should |shall )?(?:BE|come|comes|go|goes|stand|placed))?"
_SEP = "(?: ,| ;)?(?: and| but| with)?"
_THEN = "(?: then| followed by| after (?:that|them|those|these)| next| behind them)"
_TAIL = (
    "(?: (?:also )?(?:at the (?:end|back)|after (?:that|them|those|these)|afterwards|last|second|next|on the right|"
    "at the right|behind|"
    "to the right))?"
)


def _kinds() -> list[Pattern]:
    """Ways to say that labels of one kind stand ahead of those of another."""
    found = []
    for ahead, behind in _PAIRS:
        one, other = (f"(?:the |all |all the |any |its )?{_KINDS[kind]}" for kind in (ahead, behind))
        found += patterns("kinds", (ahead, behind),
            f"{one}{_COME} (?:before|ahead of|preceding|to the left of|left of|in front of) (?:any of "
            f")?{other}", f"{one}(?: (?:must|should|shall|have to|to))? (?:precede|come before) {other}",
            f"{one}{_COME} (?:first|on the left|at the left|to the left|in front|at the (?:front|start|"
            f"beginning)){_SEP}{_THEN}?{_SEP} {other}{_COME}{_TAIL}",
            f"first {one}{_SEP}{_THEN}?{_SEP} {other}{_COME}{_TAIL}",
            f"{one}{_SEP}{_THEN} {other}{_COME}{_TAIL}",
            f"{one}{_COME} first", f"{other}{_COME} last", f"{other}{_COME} (?:after|behind|following|to the right "
            f"of|right of) {one}")  # fmt: skip
    return found


KINDS: list[Pattern] = [
    *_kinds(),
    *patterns("alternate", None,
        "(?:(?:in which|so that|with|the|where) )*(?:letters and digits|letters and numbers|digits and letters|"
        "numbers and letters) (?:alternate|alternating|take turns|in turn|by turns)",
        "alternating (?:letters and digits|letters and numbers|digits and letters|numbers and letters)"),
    *patterns("each kind", None,
        "(?:and )?(?:(?:both|each|either|every|each of the) (?:kind|group|part|half|set|lot|ones)s?|both(?: of "
        "them)?|each of (?:them|these)|each|each (?:2|two) groups)(?= (?:BE |sorted |in |ascending|descending|from |"
        "increasing|again|going))(?: BE)?",
        "(?:also )?(?:in|within|inside) (?:each|both|either|every|the|its) (?:kind|group|part|half|set|lot|own "
        "group)s?(?: itself)?", "too", "each", "likewise"),
]  # fmt: skip
"""Kinds "kinds" (which kind of labels stands ahead of which), "alternate", and "each kind" is sorted for itself."""

_LOOK = rf"(?:(?:the|a|an) )?(?:{_ONE} )?(?:{LABEL}|COLOR)(?: {_ONE})?"
_JUST = "(?:immediately|directly|right|just)"
_LEFT, _RIGHT = (
    "(?:to the left of|left of|on the left of|left from|on the left side of)",
    "(?:to the right of|right of|on the right of|right from|on the right side of)",
)
_RELATIONS = {
    "left of": f"(?:{_LEFT}|before)",
    "right of": f"(?:{_RIGHT}|after)",
    "immediately left of": f"{_JUST} (?:{_LEFT}|before)",
    "immediately right of": f"{_JUST} (?:{_RIGHT}|after)",
    "next to": f"(?:{_JUST} )?(?:next to|beside|adjacent to)",
    "in front of": "in front of",
    "behind": "behind",
}


def _relation(relation: str) -> list[Pattern]:
    def told(match: re.Match[str]) -> tuple[str, str, str]:
        return _named(match["x"]), relation, _named(match["y"])

    return patterns("relation", told, f"(?P<x>{_LOOK}) (?:BE )?{_RELATIONS[relation]} (?P<y>{_LOOK})")


def _named(said: str) -> str:
    """The label or colour that is named."""
    words = [word for word in said.split() if not re.fullmatch(f"the|an|{_ONE}", word)]
    return words[-1] if len(words[-1]) > 1 and words[-1][0] != "'" else _bare(words[-1])


RELATIONS: list[Pattern] = [pattern for relation in _RELATIONS for pattern in _relation(relation)]
"""Kind "relation": two blocks of the row, and how the first stands to the second."""

WORDS: list[Pattern] = [
    *patterns("glue", None, f"(?:with |of |using |from )?(?:the |all |these |those |my |single |your "
        f")*{_NOUN}", "(?:with |of |using |from )?(?:the |these |those )*(?:letter|digit|number|numbered|lettered|"
        "labelled|labeled|alphabet|symbol) (?:BLOCK|tiles)"),
    *patterns("glue", None, "(?:labelled|labeled|marked|numbered|lettered|bearing|carrying|showing)(?: "
        "with)?(?: the)?(?: (?:letters|digits|numbers|labels|symbols))?",
        "with (?:the )?(?:letters|digits|numbers|labels|symbols)",
        "(?:each )?(?:exactly |just |only )?once(?: each)?", "one (?:of )?each", "one (?:block|cube|letter|digit) "
        "each", "one after (?:the other|another)", rf"I(?= {_SPEAKS} )"),
    *patterns("free", None, "(?:the )?(?:other|remaining) (?:2|3|4|ones|letters|digits|BLOCK)?(?: (?:may|can|could|"
        "might))?(?: (?:be|come|stand|go))? ?(?:in )?(?:any|either|whatever|whichever) (?:order|position|place)(?: "
        "(?:you|they) (?:like|want|please))?",
        "(?:in )?(?:any|whatever|whichever) order(?: (?:you|they|we) (?:like|want|please))?"),
]  # fmt: skip
