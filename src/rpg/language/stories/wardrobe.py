"""What a block is to another one: "with a yellow hat" is with a yellow block on top, "guard it on both sides" has it
between them, and "as a lookout" tells no more of a place."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR

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
_TWO = f"(?:the )?two {COLOR} (?:blocks|cubes|ones)"

WARDROBE: tuple[Turn, ...] = (
    # what is on top
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
    (f"\\b(?:flanked|framed|guarded|bordered|bracketed|protected) by (?:two )?({COLOR}) (blocks|cubes|ones) {_BOTH_SIDES}$",
     "flanked by two {1} {2}"),
    (f"^({_TWO}) (?:guard|flank|frame|protect|watch over|watch|shield) ({THING}) {_BOTH_SIDES}$", "{2} is flanked by {1}"),
    (f"^({_TWO}) (?:guard|protect|hold|hide|shield|hug|sandwich|embrace) ({THING}) (?:in )?between them$",
     "{2} is flanked by {1}"),
    (f"\\b({COLOR}) (?:friend|buddy|pal|mate|companion|neighbor|fellow|guy|chap|guard|guardian|guest|visitor)\\b",
     "{1} block"),
    (f"\\b({COLOR}) (?:friends|buddies|pals|mates|companions|neighbors|fellows|guys|guards|guardians|guests|visitors)\\b",
     "{1} blocks"),
    # how red, yellow and green stand in a traffic light
    ("^(?=.*\\bred\\b)(?=.*\\bgreen\\b)(?!.*\\b(?:the top|on top(?! of (?:each|one))|bottom|order|below|under|first|then|"
     "left|right|from|row|line|column)\\b)(?=.*\\b(?:stack|stacked|tower|pile|piled|on top of)\\b)(.*\\b(yellow|"
     "orange)\\b.*?)(?: ,)? (?:just |exactly |arranged |colored )?"
     "(?:like|as in|as on) (?:an?|the) traffic lights?$", "{1} , red on top , {2} in the middle , green at the bottom"),
    # how it is brought there
    ("\\bbreak ((?:the|that|this|my|our|an?) [^,]*?\\b(?:tower|stack|pile|wall|row|pyramid)\\b[^,]*?) (?:down|apart|up)"
     "(?= ,|$| and)", "break down {1}"),
    ("\\b(load|fill) up (?=(?:the|an?) [^,]+ with\\b)", "{1}"),
)
