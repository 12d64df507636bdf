""" "Stack A, B and C, order matters": in the order in which they are named."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_BINDS = (
    "(?:matters|counts|(?:is|does) (?:very |really |quite )?(?:matter|important|crucial|essential|relevant|vital|"
    "fixed)|(?:must|has to|should) be (?:kept|respected|followed|observed))"
)
ORDER_BINDS = f"(?:the |their |this |that )?order {_BINDS}(?: here| to me| to us| though)?"

ORDER_MATTERS_AT_ONCE: tuple[Turn, ...] = (
    (f"^{ORDER_BINDS}$", "in that order"),
    (f"^{ORDER_BINDS} [:,] (.+)$", "{1} , in that order"),
    (f"(?: ,| -| \\(|(?: ,)? and|(?: ,)? but) {ORDER_BINDS}(?: \\))?$", " , in that order"),
)
