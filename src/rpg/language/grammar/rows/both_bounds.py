"""How many at most and how many at least, told apart: "at most two of them on the mat, but not zero", "one or two, but
no more, of the four", as rows that say both of the number."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY

_MOST = "(?:at most|no more than|not more than|up to|a maximum of)"
_LEAST = "(?:at least|no fewer than|not fewer than|no less than|not less than|a minimum of)"
_BUT = "(?:(?: ,)? (?:but|and|yet|though|however)(?: also| still)?)"
_LOT = "( [^,.:;]+?)"
_OF_THEM = "(?:(?: of (?:them|these|those))?(?: (?:either|there|on it|in it))?)"
_SOME = "(?:not (?:zero|none|no blocks?|0)|never (?:zero|none))(?: at all| of (?:them|these))*"

BOTH_BOUNDS: tuple[Turn, ...] = (
    (f"\\b{_MOST} ({MANY}){_LOT}{_BUT} {_LEAST} ({MANY}){_OF_THEM}$", "at least {3} but at most {1} {2}"),
    (f"\\b{_LEAST} ({MANY}){_LOT}{_BUT} {_MOST} ({MANY}){_OF_THEM}$", "at least {1} but at most {3} {2}"),
    (f"\\b{_MOST} ({MANY}){_LOT}{_BUT} {_SOME}$", "at least one but at most {1} {2}"),
    (f"\\b(?:do|should|must|shall) not ((?:put|place|have|get) )more than ({MANY}){_LOT}{_BUT} (?:not|no) "
     f"(?:fewer|less) than ({MANY}){_OF_THEM}$", "{1} at least {4} but at most {2} {3}"),
    (f"\\b({MANY} or {MANY}) , but (?:no|not|never) more(?: than that)? ,? ?(?=of\\b)", "{1} "),
)  # fmt: skip
"""What is looked for in every sentence, and what is said instead."""
