"""What a line must not have at a place: "stack white, pink and cyan; the bottom one must not be white", "a row of two
red and three white blocks with no red one in the middle", "black may stand anywhere but at an end"."""

from __future__ import annotations

from functools import lru_cache

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turn, Turns, turned
from rpg.language.grammar.rows.vocabulary import LINE, MUST
from rpg.language.tokens import Token

_PLACES = (
    ("bottom|lowest|bottommost", "at the bottom"),
    ("top|topmost|highest|uppermost", "at the top"),
    ("middle|center|central", "in the middle"),
    ("leftmost", "at the left end"),
    ("rightmost", "at the right end"),
    ("outer|outermost|end|ends", "at an end"),
)
_ONE = "(?: ones?| blocks?| cubes?| bricks?)?"
_SIDE = "(?:(?:left|right|top|bottom|front|back|far|near) end|top|bottom|middle|center|ends?)"
_OF_IT = f"(?: of (?:(?:the|that|this) {LINE}|it))?"
_THERE = f"(?:at|on|in) (?!the end )(?:the |either |an |any |both |one of the )?{_SIDE}{_OF_IT}"
_WHERES = ((f"({_THERE})", "{{{}}}"), (f"(at the end{_OF_IT}|on the outside)", "at an end"))
"""Places as they are told, and as they are said again; what is "at the end" alone may be so finally."""
_NOT = f"(?:(?:{MUST}|may|can) (?:not|never)|cannot|(?:is|are) (?:not|never) (?:allowed|permitted|supposed)(?: to)?)"
_MAY = f"(?:{MUST}|may|can)"
_STAND = "(?: be| stand| sit| lie| go| come| end up)?(?: placed| put)?"
_AND = "(?: (?:,|:)(?: but| and| where| yet| with)?| (?:but|and|where|yet|with|without|so that|such that))"
_SOME = "(?:the |an? |any )?"
_DENYING = frozenset({"not", "no", "neither", "never", "cannot", "without"})
_LINES = frozenset({"row", "line", "tower", "stack", "column", "pile", "rows", "lines", "towers", "stacks", "columns"})


def not_at_end(tokens: list[Token]) -> list[Token]:
    """The tokens, with a color that a place must not have told as a place that blocks must not have: of a color that
    was named before, for of no other it says anything."""
    words = [token.word for token in tokens]
    if _DENYING.isdisjoint(words) or _LINES.isdisjoint(words):
        return tokens
    named = sorted({word for word in words if word in lexicon.COLOR and words.count(word) > 1})
    return turned(tokens, _turns(tuple(named))) if named else tokens


@lru_cache(maxsize=256)
def _turns(colors: tuple[str, ...]) -> Turns:
    look = f"{_SOME}({'|'.join(colors)}){_ONE}"
    rows: list[Turn] = []
    for begun, stop in (("^", ""), (f"(?<=\\w){_AND} ", ". ")):
        for side, where in _PLACES:
            rows += [
                (f"{begun}the (?:{side}){_ONE} (?:{_NOT} be|is not|are not) {look}$",
                 f"{stop}no {{1}} block may be {where}"),
                (f"{begun}(?:with the|in which the) (?:{side}){_ONE} (?:(?:is|being|{MUST} be) )?(?:not|{_NOT} "
                 f"be) {look}$", f"{stop}no {{1}} block may be {where}"),
            ]  # fmt: skip
        for there, again in _WHERES:
            rows += [
                (f"{begun}(?:the (?:block|one|cube|brick)s? )?{there} (?:(?:there )?{_NOT} be|is not|are not) {look}$",
                 f"{stop}no {{2}} block may be {again.format(1)}"),
                (f"{begun}(?:there {_MAY} be (?:no|never)|there {_NOT} be) {look} {there}$",
                 f"{stop}no {{1}} block may be {again.format(2)}"),
            ]  # fmt: skip
        rows.append((f"{begun}(?:neither|no) end (?:is|{_MAY} be) {look}$", f"{stop}no {{1}} block may be at an end"))
    rows += [
        (f"^({'|'.join(colors)}) {_NOT}{_STAND} {there}$", f"no {{1}} block may be {again.format(2)}")
        for there, again in _WHERES
    ]
    rows += [
        (f"(?<=\\w)(?:{_AND})? whose (?:{side}){_ONE} (?:is|are) not {look}$", f". no {{1}} block may be {where}")
        for side, where in _PLACES
    ]
    rows += [
        (f"(?<=\\w)(?:{_AND} (?:no|not)|(?: ,)? without) {look} {there}$", f". no {{1}} block may be {again.format(2)}")
        for there, again in _WHERES
    ]
    return Turns(rows)


NOT_THERE_AT_ONCE: tuple[Turn, ...] = (
    (f"^((?!no ).+? (?:is not|are not|{_NOT} (?:be|stand|lie|sit|go)(?: placed)?)|no .+? (?:is|are|{_MAY} (?:be|stand|"
     f"lie|sit|go)(?: placed)?)) (?:at the end{_OF_IT}|on the outside)$", "{1} at an end"),
)  # fmt: skip
"""What is looked for, and what is said instead, in every sentence: of a line, for nothing is denied of a time."""
NOT_THERE: tuple[Turn, ...] = (
    (f"^(?!no )(.+?) {_NOT}{_STAND} (?:the )?(?:first or (?:the )?last|last or (?:the )?first){_ONE}$",
     "{1} must not be at an end"),
    (f"^(?!no )(.+?) {MUST}{_STAND} neither (?:the )?first nor (?:the )?last{_ONE}$", "{1} must not be at an end"),
)  # fmt: skip
"""What is looked for, and what is said instead, where a sentence cannot be read as it stands."""
WORDS = ("allowed permitted supposed",)
"""Words that these take besides those that are read anyway."""
