""" "Stack A, B and C, order matters": in the order in which they are named."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_BINDS = (
    "(?:matters|counts|(?:is|does) (?:very |really |quite )?(?:matter|important|crucial|essential|relevant|vital|"
    "fixed)|(?:must|has to|should) be (?:kept|respected|followed|observed))"
)
ORDER_BINDS = f"(?:the |their |this |that )?order {_BINDS}(?: here| to me| to us| though)?"
_TELL = "(?:list|listed|name|named|mention|mentioned|give|gave|given|say|said|tell|told|wrote|written|stated|typed)"
_AS_TOLD = (
    "in (?:exactly |precisely |just )?(?:the|this) (?:exact |same |very )?order "
    "(?:(?:(?:in which|as|that|in that|how) )?"
    f"(?:they|i|we|you|these)(?: have| are| were| had)?(?: just| all)? {_TELL}|as {_TELL}|{_TELL})(?: them| these)?"
    "(?: here| above| just now)?(?= ,| :| from | with |$)"
)
"""In the order in which they are listed."""
_ENDS = (("left", "leftmost", "from left to right"), ("right", "rightmost", "from right to left"),
         ("(?:near|front)", "(?:nearest|closest)(?: to me)?", "from front to back"),
         ("(?:back|far)", "(?:farthest|furthest)", "from back to front"))  # fmt: skip
_FREE = "(?:the |their )?order (?:does not matter|is (?:not important|free|up to you|irrelevant|open))"
_FACT = "(?!not\\b)[^,]* (?:is|are|must|comes?|goes?|has|should|stands?|lies)\\b"

ORDER_MATTERS_AT_ONCE: tuple[Turn, ...] = (
    (f"^{ORDER_BINDS}$", "in that order"),
    (f"^{ORDER_BINDS} [:,] (.+)$", "{1} , in that order"),
    (_AS_TOLD, "in the order given"),
    ("\\bin the (?:listed|stated|mentioned|named|specified) order(?= ,| from |$)", "in the order given"),
    *((f"\\b(in (?:this|that) order|in the order given)(?: ,)? (?:with )?(?:the )?(?:{most}|{end})(?: one| block| "
       "cube)? first$", f"{{1}} {way}") for end, most, way in _ENDS),
    (f"(?<=\\S)(?: ,| -)? {_FREE}(?: ,)? (?:except|but|only|just|apart from the fact|other than)(?: that)? (?={_FACT})",
     " , in any order , but "),
    ("(?: , but| ,| but)(?: just| only)? not ((?:the )?\\w+(?: block| cube| one)?) (on top|at the (?:bottom|top)|first|"
     "last|in the middle)$", " , {1} not {2}"),
    ("(?: ,)? (?:and |but )?otherwise (?:any|all|whatever|free|arbitrary) colors?(?: (?:is|are) fine)?$", ""),
    (f"(?: ,| -| \\(|(?: ,)? and|(?: ,)? but) {ORDER_BINDS}(?: \\))?$", " , in that order"),
)  # fmt: skip
