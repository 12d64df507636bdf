""" "Stack A, B and C, order matters": in the order in which they are named."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_BINDS = (
    "(?:matters|counts|(?:is|does) (?:very |really |quite )?(?:matter|important|crucial|essential|relevant|vital|"
    "fixed)|(?:must|has to|should) be (?:kept|respected|followed|observed))"
)
ORDER_BINDS = f"(?:the |their |this |that )?order {_BINDS}(?: here| to me| to us| though)?"
_FREE = "(?:the |their )?order (?:does not matter|is (?:not important|free|up to you|irrelevant|open))"
_FACT = "(?!not\\b)[^,]* (?:is|are|must|comes?|goes?|has|should|stands?|lies)\\b"

ORDER_MATTERS_AT_ONCE: tuple[Turn, ...] = (
    (f"^{ORDER_BINDS}$", "in that order"),
    (f"^{ORDER_BINDS} [:,] (.+)$", "{1} , in that order"),
    (f"(?<=\\S)(?: ,| -)? {_FREE}(?: ,)? (?:except|but|only|just|apart from the fact|other than)(?: that)? (?={_FACT})",
     " , in any order , but "),
    ("(?: , but| ,| but)(?: just| only)? not ((?:the )?\\w+(?: block| cube| one)?) (on top|at the (?:bottom|top)|first|"
     "last|in the middle)$", " , {1} not {2}"),
    ("(?: ,)? (?:and |but )?otherwise (?:any|all|whatever|free|arbitrary) colors?(?: (?:is|are) fine)?$", ""),
    (f"(?: ,| -| \\(|(?: ,)? and|(?: ,)? but) {ORDER_BINDS}(?: \\))?$", " , in that order"),
)  # fmt: skip
