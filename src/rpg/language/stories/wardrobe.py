"""What blocks wear and carry: "with a yellow hat" is with a yellow block on top, and "on it as its roof" is on it."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR

_HAT = "(?:top )?(?:hat|cap|crown|roof|lid|helmet|bonnet|beret|beanie|tiara|rooftop|topper)(?! (?:block|cube|one)\\b)"
_LOOK = f"(?:(?:little|small|big|large|tiny) )?{COLOR}"
_A_BLOCK = f"(?:an?|one|the) {_LOOK} (?:block|cube|brick|one)"
_ITS = "(?:an?|the|its|their|our|his|her|one)"
_WORN = f"({_ITS} {_LOOK}) {_HAT}(?: on (?:top|its head))?"
_ON = "(?:on|onto|over|for|of|to)(?: top of)? (?=(?:the|an?|this|that|it|top)\\b)"

WARDROBE: tuple[Turn, ...] = (
    (f" like {_ITS} {_HAT} (?=(?:on|over|atop)\\b)", " "),
    (f"\\b({COLOR} (?:one|block|cube)) (?:perched|perching|sitting|seated|balanced|balancing|resting|enthroned|riding|"
     "standing|placed) (?=on top(?: of it)?(?: ,|$))", "{1} "),
    (f"\\bwearing {_WORN}", "with {1} block on top"),
    (f"\\b(?:wears|carries|gets|has) {_WORN}", "has {1} block on top"),
    (f"\\b(with|and|give (?:the|an?|this|that|each|every) [^,:]+?|give it) {_WORN}(?= ,|$| and\\b)",
     "{1} {2} block on top"),
    (f"\\b({_ITS} {_LOOK}) {_HAT} {_ON}", "{1} block on top of"),
    (f"\\b({_A_BLOCK}) as {_ITS} {_HAT} {_ON}", "{1} on top of"),
    (f"^(.*\\b(?:on|onto|atop|on top)\\b.*?)(?: ,)? as {_ITS} {_HAT}(?= ,|$| and\\b)", "{1}"),
    ("\\b(?:topped|capped|crowned|finished) off (?=(?:with|by)\\b)", "topped "),
    ("\\bcolumn(?= of [^,]+?(?: ,)? (?:topped|crowned|capped) )", "tower"),
)  # fmt: skip
