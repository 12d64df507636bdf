"""Which parts blocks have in a scene, and what is set out in it, in plain words: "guards on both sides" are on both
sides, "as a lookout" tells no more of a place, "load up the mat with" is put on it."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW

_AS = "as (?:(?:an?|the|its|their|our|his|her|one) )?"
_ROLE = (
    "(?:(?:little|nice|pretty|final|special|lovely) )?(?:decoration|ornament|centerpiece|centrepiece|highlight|eye - "
    "catcher|focal point|finishing touch|treasure|jewel|guard|guardian|lookout|watchman|sentinel|sentry|star|mascot|"
    "guest|visitor|king|queen|prince|princess|boss|hero|friend|companion|spectator|accent)s?"
)
_PLACED = (
    "(?:on|onto|atop|next to|beside|behind|in front of|in between|between|under|below|above|around|(?:to the )?(?:left|"
    "right) of|(?:in|at|on|to) (?:the|each|its|either|both|every))"
)
_BOTH_SIDES = (
    "(?:(?:on|from|at|to) )?(?:both sides|either side|each side|(?:the |its )?left and (?:the |its )?right|(?:the |its "
    ")?right and (?:the |its )?left)(?: of it| side)?"
)
_FELLOW = "(?:friend|buddy|pal|mate|companion|fellow|guy|chap|guard|guardian|guest|visitor)"
_WHAT = f"(?:the|an?|my|our|this|that|all|both|\\d+|{FEW})"
_LOT = f"{_WHAT} (?:(?:{FEW}|{COLOR}|big|small|large|little) )*(?:{'|'.join(lexicon.BLOCK)}|ones?)"
_LOTS = f"{_LOT}(?:(?: , {_LOT})*(?: ,)? and {_LOT})?"
_MAT = f"(?:the|an?|my|our) (?:\\w+ ){{0,2}}?(?:{'|'.join(lexicon.PATCH)}|pallet)"
_TWO = f"(?:the )?two {COLOR} (?:blocks|cubes|ones)"
_BASE = "(?:pedestal|podium|plinth|platform|throne|stage|bed|nest)"
_STACKED = "(?:stack|stacked|tower|pile|piled|on top of)"
_ORDERED = "(?:the top|on top(?! of (?:each|one))|bottom|order|below|under|first|then|left|right|from|row|line|column)"

ROLES: tuple[Turn, ...] = (
    # whose place is told anyway
    (f" {_AS}{_ROLE} (?={_PLACED}\\b)", " "),
    (f"^(.*\\b{_PLACED} .*?)(?: ,)? {_AS}{_ROLE}(?= ,|$| and\\b)", "{1}"),
    # whom they have between them
    (f"^(?:a pair of|two)(?: matching| identical| equal)? ({COLOR} (?:blocks|cubes|ones)) (?:bookend|flank|frame|"
     "border|bracket) (an? (?:row|line) of [^,]+)$", "{2} , flanked by two {1}"),
    *((f"^one ({COLOR}) (?:block|cube) (?:guards|watches|protects|flanks) {whom} (?:on|from|at|to) (?:the|its) {one}"
       f"(?: ,)? and (?:one|another)(?: one)? (?:does so )?(?:on|from|at|to) (?:the|its) {other}$",
       f"{told} is flanked by two {{1}} cubes")
      for whom, told in ((f"({THING})", "{2}"), ("(?:it|her|him)", "it"))
      for one, other in (("left", "right"), ("right", "left"))),
    (f"\\b(?:flanked|framed|guarded|bordered|bracketed|protected) by (?:two )?({COLOR}) (blocks|cubes|ones) "
     f"{_BOTH_SIDES}$", "flanked by two {1} {2}"),
    (f"^({_TWO}) (?:guard|flank|frame|protect|watch over|watch|shield) ({THING}) {_BOTH_SIDES}$",
     "{2} is flanked by {1}"),
    (f"^({_TWO}) (?:guard|protect|hold|hide|shield|hug|sandwich|embrace) ({THING}) (?:in )?between them$",
     "{2} is flanked by {1}"),
    (f"\\b({COLOR}) {_FELLOW}\\b", "{1} block"),
    (f"\\b({COLOR}) {_FELLOW}s\\b", "{1} blocks"),
    # what something stands on
    (f"\\b(make|build|form|create) an? (?:\\w+ )?{_BASE} (?:of|from|out of|with) ({_WHAT} (?:{COLOR} )?(?:blocks|cubes|"
     "boxes|bricks)) (?=in an? (?:square|row|line|circle)\\b|side by side|next to each other)", "put {2} "),
    # how red, yellow and green stand in a traffic light
    (f"^(?=.*\\bred\\b)(?=.*\\bgreen\\b)(?!.*\\b{_ORDERED}\\b)(?=.*\\b{_STACKED}\\b)(.*\\b(yellow|orange)\\b.*?)"
     "(?: ,)? (?:just |exactly |arranged |colored )?(?:like|as in|as on) (?:an?|the) traffic lights?$",
     "{1} , red on top , {2} in the middle , green at the bottom"),
    # how it is brought there, and away
    ("\\bbreak ((?:the|that|this|my|our|an?) [^,]*?\\b(?:tower|stack|pile|wall|row|pyramid)\\b[^,]*?) (?:down|apart|up)"
     "(?= ,|$| and)", "break down {1}"),
    (f"\\b(?:load|load up|fill|fill up|stock|cover|pack) ({_MAT}) with ({_LOTS})(?=$| ,| in an?)", "put {2} on {1}"),
    (f"\\b(?:offload|unload) ({_WHAT} [^,:]+?) from (?=the|an?)", "take {1} from"),
)  # fmt: skip
