"""What is at one place of each of several towers or rows: "two towers of three, each with a red block in the middle",
"two stacks of two; the bottom of one is red, the bottom of the other blue". They are told again one by one."""

from __future__ import annotations

from functools import lru_cache

from rpg.language.grammar.rows.turned import Turn, Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST
from rpg.language.tokens import Token

_UPRIGHT = {
    "on top": "top|topmost|highest|uppermost|upper", "at the bottom": "bottom|bottommost|lowest|lower",
    "in the middle": "middle|center|central",
}  # fmt: skip
_FLAT = {
    "at the left end": "leftmost|left|first", "at the right end": "rightmost|right|last",
    "in the middle": "middle|center|central",
}  # fmt: skip
"""Places, and what a block there is called."""
_THERE = {
    "on top": "on top|at the top|on the top", "at the bottom": "at the bottom|at the base|below|at its base",
    "in the middle": "in the middle|in the center|in its middle", "at the left end": "(?:at|on) (?:the|its) left end",
    "at the right end": "(?:at|on) (?:the|its) right end",
}  # fmt: skip
_STARTS, _ENDS = "(?:starts?|begins?|starting|beginning)", "(?:ends?|finish|finishes|ending|finishing)"
_KINDS = {f"{kind}s": kind for kind in ("tower", "stack", "row", "line", "column")}
_COUNTS = {2: "two|2", 3: "three|3", 4: "four|4"}
_BUILD = "(?:(?:please )?(?:build|make|create|construct|form|stack up|set up|arrange) |i (?:want|need) |we need )?"
_BLOCKS = "(?: blocks| cubes| bricks)?"
_BLOCK = "(?: block| cube| brick| one)?"
_AND = "(?: ,| and| , and| :| ;| \\.)"
_HAS = f"(?:with|having|has|have|gets?|contains?|{MUST} have|{MUST} contain)"
_IS = f"(?:is|are|{MUST} be|being)"
_END = "(?= ?[.!]| *$)"
_BESIDE = f" , (?:side by side|next to each other|beside each other){_END}"


def parts_of_each(tokens: list[Token]) -> list[Token]:
    """The tokens, with such structures told one by one. Of blocks of a told look it may be one more, so that the looks
    of the others must be left open."""
    words = [token.word for token in tokens]
    for n, word in enumerate(words):
        if word in _KINDS and (many := next((m for m, told in _COUNTS.items() if words[n - 1] in told.split("|")), 0)):
            return turned(tokens, _turns(_KINDS[word], many), all_of_it)
    return tokens


@lru_cache(maxsize=32)
def _turns(kind: str, many: int) -> Turns:
    flat = kind in ("row", "line", "column")
    rows: list[Turn] = []
    for place, called in (_FLAT if flat else _UPRIGHT).items():
        for look, here in _each(kind, many, place, called):
            one = f"{kind} of {{1}} blocks with a {{2}} block {here}"
            told = " . ".join([f"build a {one}", *[f"build another {one}"] * (many - 1)])
            rows += [(f"{look}{_BESIDE}", f"{told} . the {kind}s must be next to each other"), (f"{look}{_END}", told)]
        if many == len(_PAIR):
            rows += _two(kind, place, called)
    return Turns(rows)


def _head(kind: str, many: int) -> str:
    """The structures, of which group 1 is the number of blocks."""
    return f"^{_BUILD}(?:{_COUNTS[many]}) {kind}s (?:of|with|made of|made from) ({MANY}){_BLOCKS}(?: each)?"


def _each(kind: str, many: int, place: str, called: str) -> list[tuple[str, str]]:
    """What is said of all of them alike: in a sentence of its own "each has a red block on top" may be of one more."""
    head, there = _head(kind, many), _THERE[place]
    them = f"(?: of (?:them|these|which|the (?:{MANY} )?{kind}s))?(?: {kind}s?)?"
    all_ = f"(?:each|every|both|all|every one)(?: the)?{them}"
    look = f"(?:an? )?({COLOR}){_BLOCK}"
    ends = {"on top": _ENDS, "at the bottom": _STARTS, "at the left end": _STARTS, "at the right end": _ENDS}.get(place)
    stop = "(?: ,| and| , and| :| ;)" if place == "on top" else _AND
    noun = called.split("|")[0]
    nouns = f"(?:{noun}|base|foot)" if place == "at the bottom" else noun
    told = [
        f"{head}{stop} {all_} {_HAS} {look} (?:{there})",
        f"{head}(?: ,)?(?: (?:each|both|all))? with {look} (?:{there})(?: of (?:each|both|each {kind}))?",
        f"{head}{_AND} (?:the )?(?:{called}){_BLOCK}s? (?:of|in) {all_} {_IS} ({COLOR})",
        f"{head}{_AND} (?:each|every) {kind} 's (?:{called}){_BLOCK} {_IS} ({COLOR})",
    ]
    if ends:
        told.append(f"{head}{_AND} {all_} {ends} (?:in|with|on|at) {look}")
    if not place.startswith("at the") or place == "at the bottom":
        told += [
            f"{head}(?: ,)? (?:with|having) ({COLOR}) {nouns}s",
            f"{head}(?:{_AND} {all_})? {_HAS} (?:an? |the )?({COLOR}) {nouns}",
            f"{head}{_AND} (?:all|both|the|all the|both the) {noun}(?: blocks| cubes|s) {_IS} (?:all )?({COLOR})",
        ]
    return [(pattern, place) for pattern in told]


_PAIR = (("one", "the other"), ("the first", "the second"))


def _two(kind: str, place: str, called: str) -> list[Turn]:
    """What is said of the one, and of the other: of the left and of the right one, they stand so as well."""
    head, there, noun = _head(kind, len(_PAIR)), _THERE[place], called.split("|")[0]
    rows: list[Turn] = []
    ways = [*_PAIR, ("the left", "the right")]
    for one, other in ways:
        a, b = (f"{x}(?: one| {kind})?" for x in (one, other))
        part, look = f"(?:the )?(?:{called}){_BLOCK}", f"an? ({COLOR})(?: {noun}|{_BLOCK} (?:{there}))"
        two = f"build a {kind} of {{1}} blocks with a {{2}} block {place} . " \
              f"build another {kind} of {{1}} blocks with a {{3}} block {place}"  # fmt: skip
        two += " . the first tower is left of the second tower" if one == "the left" and kind == "tower" else ""
        if one == "the left" and kind != "tower":
            continue
        rows += [
            (f"{head}{_AND} {part} of {a} {_IS} ({COLOR}){_AND} {part} of {b}(?: {_IS})? ({COLOR}){_END}", two),
            (f"{head}{_AND} {a} {_HAS} {look}{_AND} {b}(?: {_HAS})? an? ({COLOR})(?: {noun}|{_BLOCK}(?: (?:{there}))?)"
             f"{_END}", two),
        ]  # fmt: skip
    return rows
