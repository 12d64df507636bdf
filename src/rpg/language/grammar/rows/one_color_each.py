"""Lines of one colour each, no two of the same: "one color per column, all columns different"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import BUILD, MANY

_ONE = "(?:just |only )?(?:one|a single|a) color"


def _no_two_alike(unit: str) -> Turn:
    """Of one kind of line."""
    each = (
        f"(?:(?:each|every) {unit}(?: is| being)?(?: in| of| has| having)? {_ONE}|{_ONE} (?:per|for each|for every|in "
        f"each) {unit})"
    )
    different = (
        f"(?:no two(?: of them| {unit}s)?(?: are| being)? (?:the same|alike|(?:of|in|having|have) the same color)|all "
        f"(?:the )?(?:{unit}s |two |three |four )?(?:are |being )?(?:of |in )?different(?: colors)?|(?:in )?different "
        "colors)"
    )
    return f"\\b{each}(?: ,| and| with)+ {different}$", f"each {unit} of a different color"


ONE_COLOR_EACH: tuple[Turn, ...] = (
    *map(_no_two_alike, ("tower", "stack", "row", "line", "column", "layer", "level", "one")),
    (f"^((?:{BUILD} )?{MANY} (?:rows|lines) of {MANY}(?: blocks| cubes)?)(?: ,)? {_ONE} (?:each|per (?:row|line))"
     "(?= ,|$)", "{1} , each row in one color"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
