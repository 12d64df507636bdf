"""What a block is to another one: "with a yellow hat" is with a yellow block on top, "guard it on both sides" has it
between them, and "as a lookout" tells no more of a place."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW

_HAT = "(?:top )?(?:hat|cap|crown|roof|lid|helmet|bonnet|beret|beanie|tiara|rooftop|topper)(?! (?:block|cube|one)\\b)"
_LOOK = f"(?:(?:little|small|big|large|tiny) )?{COLOR}"
_A_BLOCK = f"(?:an?|one|the) {_LOOK} (?:block|cube|brick|one)"
_ITS = "(?:an?|the|its|their|our|his|her|one)"
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
    "(?:(?:on|from|at|to) )?(?:both sides|either side|each side|(?:the |its )?left and (?:the |its )?right|(?:the |its )?"
    "right and (?:the |its )?left)(?: of it| side)?"
)
_LOAD = "(?:load|load up|fill|fill up|stock|cover|pack)"
_WHAT = "(?:the|an?|my|our|this|that|all|both|\\d+|" + FEW + ")"
_LOT = f"{_WHAT} (?:(?:{COLOR}|big|small|large|little) )*(?:{'|'.join(lexicon.BLOCK)}|ones?)"
_BIT = "(?:(?:an? |some |more |extra |added |the )*(?:bit|touch|hint|dash|splash|pinch) of |some |more |extra |added |the )?"
_EFFECT = "(?:drama|contrast|effect|elegance|style|flair|charm|interest|emphasis|sparkle|glamour|variety|luck|decoration)"
_TWO = f"(?:the )?two {COLOR} (?:blocks|cubes|ones)"

WARDROBE: tuple[Turn, ...] = (
    # what is on top
    (f" like {_ITS} {_HAT} (?=(?:on|over|atop)\\b)", " "),
    (f"\\b({COLOR} (?:one|block|cube)) (?:perched|perching|sitting|seated|balanced|balancing|resting|enthroned|riding|"
     "standing|placed) (?=on top(?: of it)?(?: ,|$))", "{1} "),
    (f"\\bwearing ({_ITS} {_LOOK}) {_HAT}(?: on (?:top|its head))?", "with {1} block on top"),
    (f"\\b(?:wears|carries|gets|has) ({_ITS} {_LOOK}) {_HAT}(?: on (?:top|its head))?", "has {1} block on top"),
    (f"\\b(with|and|give (?:the|an?|this|that) [^,:]+?|give it) ({_ITS} {_LOOK}) {_HAT}(?: on (?:top|its head))?(?= ,|$| and\\b)",
     "{1} {2} block on top"),
    (f"\\b({_ITS} {_LOOK}) {_HAT} (on|onto|over|for|to)(?: top of)? (?=(?:the|an?|this|that|it|top)\\b)",
     "{1} block on top of"),
    (f"\\b({_A_BLOCK}) as {_ITS} {_HAT} (?:on|onto|over|for|of|to)(?: top of)? (?=(?:the|an?|this|that|it)\\b)",
     "{1} on top of"),
    (f"^(.*\\b(?:on|onto|atop|on top)\\b.*?)(?: ,)? as {_ITS} {_HAT}(?= ,|$| and\\b)", "{1}"),
    ("\\b(?:topped|capped|crowned|finished) off (?=(?:with|by)\\b)", "topped "),
    ("\\bcolumn(?= of [^,]+?(?: ,)? (?:topped|crowned|capped) )", "tower"),
    # whose place is told anyway
    (f" as {_ITS} {_ROLE} (?={_PLACED}\\b)", " "),
    (f"^(.*\\b{_PLACED} .*?)(?: ,)? as (?:{_ITS} )?{_ROLE}(?= ,|$| and\\b)", "{1}"),
    # whom they have between them
    (f"^(?:a pair of|two)(?: matching| identical| equal)? ({COLOR} (?:blocks|cubes|ones)) (?:bookend|flank|frame|border|"
     "bracket) (an? (?:row|line) of [^,]+)$", "{2} , flanked by two {1}"),
    (f"^one ({COLOR}) (block|cube) (?:guards|watches|protects|flanks) ({THING}|it|her|him) (?:on|from|at|to) (?:the|its) (left|"
     "right)(?: ,)? and (?:one|another)(?: one)? (?:does so )?(?:on|from|at|to) (?:the|its) (left|right)$",
     "one {1} {2} is to the {4} of {3} and one is to the {5} of {3}"),
    (f"\\b(?:flanked|framed|guarded|bordered|bracketed|protected) by (?:two )?({COLOR}) (blocks|cubes|ones) {_BOTH_SIDES}$",
     "flanked by two {1} {2}"),
    (f"^({_TWO}) (?:guard|flank|frame|protect|watch over|watch|shield) ({THING}) {_BOTH_SIDES}$", "{2} is flanked by {1}"),
    (f"^({_TWO}) (?:guard|protect|hold|hide|shield|hug|sandwich|embrace) ({THING}) (?:in )?between them$",
     "{2} is flanked by {1}"),
    (f"\\b({COLOR}) (?:friend|buddy|pal|mate|companion|neighbor|fellow|guy|chap|guard|guardian|guest|visitor)\\b",
     "{1} block"),
    (f"\\b({COLOR}) (?:friends|buddies|pals|mates|companions|neighbors|fellows|guys|guards|guardians|guests|visitors)\\b",
     "{1} blocks"),
    # a base, and what is said of looks alone
    (f"\\b(make|build|form|create) an? (?:\\w+ )?(?:pedestal|podium|plinth|platform|throne|stage|bed|nest) (?:of|from|out of|"
     f"with) ({_WHAT} (?:{COLOR} )?(?:blocks|cubes|boxes|bricks)) (?=in an? (?:square|row|line|circle)\\b|side by side|next to "
     "each other)", "put {2} "),
    (f"^(?:for|to add|adding) {_BIT}{_EFFECT} ,", ""),
    (f"(?: ,)? (?:for|to add|adding) {_BIT}{_EFFECT}$", ""),
    # how red, yellow and green stand in a traffic light
    ("^(?=.*\\bred\\b)(?=.*\\bgreen\\b)(?!.*\\b(?:the top|on top(?! of (?:each|one))|bottom|order|below|under|first|then|"
     "left|right|from|row|line|column)\\b)(?=.*\\b(?:stack|stacked|tower|pile|piled|on top of)\\b)(.*\\b(yellow|"
     "orange)\\b.*?)(?: ,)? (?:just |exactly |arranged |colored )?"
     "(?:like|as in|as on) (?:an?|the) traffic lights?$", "{1} , red on top , {2} in the middle , green at the bottom"),
    # how it is brought there
    ("\\bbreak ((?:the|that|this|my|our|an?) [^,]*?\\b(?:tower|stack|pile|wall|row|pyramid)\\b[^,]*?) (?:down|apart|up)"
     "(?= ,|$| and)", "break down {1}"),
    (f"\\b{_LOAD} ({_WHAT} [^,:]+?) with ({_LOT}(?: , {_LOT})*(?: ,)? and {_LOT})(?= ,|$)", "put {2} on {1}"),
    (f"\\b{_LOAD} ({_WHAT} [^,:]+?) with (?={_LOT}(?: ,|$))", "load {1} with"),
    (f"\\b(?:offload|unload) ({_WHAT} [^,:]+?) from (?=the|an?)", "take {1} from"),
)
