"""What those who speak are doing, or want help with, as what is to be done: "we are stacking A on B", "can you help my
son make a tower", "can the arm manage a pyramid"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY

_DOING = {
    "stacking": "stack", "putting": "put", "placing": "place", "building": "build", "making": "make",
    "lining up": "line up", "arranging": "arrange", "spelling": "spell", "writing": "write", "sorting": "sort",
    "moving": "move", "laying": "lay", "forming": "form", "setting up": "set up", "piling": "pile",
}  # fmt: skip
_NOW = "(?:(?:today|now|so|here|and|okay|ok|right)(?: ,)? )*"
_JUST = "(?: just| now| today| currently| all| both)?"
_THING = f"(?=(?:an?|the|both|all|one|it|up|{MANY}|{COLOR}|\\S|\\S\\S\\S+) (?!(?:demo|video|film|game|show)\\b))"
_DO = "(?:build|make|stack|put|place|lay|spell|write|sort|arrange|line up|form|set up|create|do)"
_WHOM = "(?:me|us|him|her|them|(?:my|our|the|his|her|their|a) (?:little |young |dear )?\\w+)"

WISHED_ALOUD: tuple[Turn, ...] = (
    *((f"^{_NOW}(?:we|i) (?:are|am){_JUST} {doing} {_THING}", f"{do} ") for doing, do in _DOING.items()),
    (f"^(?:please )?(?:(?:can|could|will|would) (?:you|the robot|somebody|someone)(?: please)? )?help {_WHOM} "
     f"(?:to |with |in )?(?={_DO} )", ""),
    (f"^(.*\\b(?:have|got|are) (?:these |those |the )?{MANY} (?:\\w+ )?(?:blocks|cubes|bricks|letters|digits)) right ,",
     "{1} ,"),
)  # fmt: skip
"""What makes no sense as it stands."""
