"""What those who speak are doing, or want help with, as what is to be done: "we are stacking A on B", "can you help my
son make a tower", "can the arm manage a pyramid"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

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
_FIGURE = "tower|stack|row|line|column|pyramid|wall|grid|square|circle|ring|staircase|triangle|rectangle"
_WHOSE = "(?:his|her|my|our|their|its)"
_NAME = (
    "((?!(?:in|with|on|to|and|well|right|correctly|nicely|left|from|the|that|like|as|properly|easily|is|are|goes|"
    "alphabetically|backwards|spelled|written|shown|out|laid)\\b)[a-z]{2,})"
)

_WANT = "(?:want|need|(?:would|should) (?:like|love|have)|must have|have in mind|am (?:after|thinking of))"
_OF_IT = f"(?:is|are|has|have|consists?|goes|stands?|{MUST}) "

WISHED_ALOUD_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b(the (?:\\w+ )?(?:{_FIGURE})s?) (?:(?:that|which) )?(?:i|we) {_WANT}(?: (?:to (?:see|have|get)|built|made))? "
     f"(?={_OF_IT})", "{1} "),
)  # fmt: skip
"""Where "the tower I want" might have to do with a block I."""
WISHED_ALOUD: tuple[Turn, ...] = (
    *((f"^{_NOW}(?:we|i) (?:are|am){_JUST} {doing} {_THING}", f"{do} ") for doing, do in _DOING.items()),
    (f"^(?:please )?(?:can|could|will|would) (?:you|the robot|somebody|someone)(?: please)? help {_WHOM} "
     f"(?:to |with |in )?(?={_DO} )", ""),
    (f"^(.*\\b(?:have|got|are) (?:these |those |the )?{MANY} (?:\\w+ )?(?:blocks|cubes|bricks|letters|digits)) right ,",
     "{1} ,"),
    (f"\\b(?:manage|handle|pull off) (?=(?:an?|{MANY}|\\d+x\\d+) (?:\\w+ )*(?:{_FIGURE})s?\\b)", "build "),
    (f"^(?:i|we) (?:only|merely) (need|want|would like|am after) (?=(?:an?|{MANY}) )", "i {1} "),
    (f"^(?:please )?demonstrate (?=(?:an?|{MANY}) )", "build "),
    (f"^(?:can|could|would|will) it (?:please )?(?={_DO} )", ""),
    ("^(?:looking|searching|hoping|asking) for (?=(?:an?|one) )", "i want "),
    (f"^((?:an?|one|any) (?:\\w+ )?(?:{_FIGURE})\\b[^,]*|any {MANY} (?:blocks|cubes|ones) [^,]*?) (?:will do|(?:is|are|"
     "would be|will be) (?:just |perfectly )?(?:fine|ok|okay|good|enough|perfect|sufficient))$", "i want {1}"),
    (f"^(?:\\w+ )*?(?:wants?|would like|likes?|needs?|asks for|asked for) (?:to (?:see|have|read) )?{_WHOSE} (?:first |"
     f"own )?name(?: ,)? {_NAME}(?: ,)?(?: spelled| written| out| shown| laid)*(?: (?:in|with|from|out of|using) "
     "(?:the |letter )*(?:blocks|cubes|letters|bricks))?$", "spell {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
