"""What people add to be sure, and what they say in more words than it takes: "of red blocks only", "do put it there",
"on any one of them", "nothing is on top of anything", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MANY, MUST

_STOP = r"(?= (?:,|and|\.|;)|$)"
_LIES = f"(?:{MUST} (?:be|lie|sit|stand|rest)|may be|can be|is|sits|lies|stands|rests)"
_BESIDE = "of|behind|between|on|beside|near|to|above|over"
_BUILT = "tower|stack|row|column|line|pyramid"
_READER = "(?:one|you|we|i|people|everyone|everybody)"
_PART = "corner|middle|center|central|end|top|bottom|lowest|highest|topmost|leftmost|rightmost|uppermost"
_FIGURE = "(?:[ltuv]|plus|plus sign|cross|pyramid|staircase|wall|grid|figure|shape|letter)"

EMPHATIC_AT_ONCE: tuple[Turn, ...] = (
    (f"(?: , and| ,| and) all of (?:that|this) (?=(?:{_LIES} |goes )?(?:in|on|onto|inside) )", " , all of them "),
    ("\\b(?:please |kindly )*do the needful(?: (?:,|:))?(?: (?:and|to|by))?(?: please)? (?=\\w)", ""),
    ("\\bdo not (?:you )?(?:ever )?dare (?:to )?(?=(?:move|touch|put|place|stack|shift|push|turn|lift|use)\\b)",
     "do not "),
    (f"^(?:and )?nothing {_LIES} (?:on top of|on|atop|above) (?:anything|another thing|another block)(?: else)?$",
     "no block must be on another block"),
    ("\\b(carry|carries|support|supports|bear|bears) (.+?)(?: ,)? respectively$", "{1} {2}"),
    ("\\b(in (?:a|one) (?:single )?(?:row|line)) , one (?:next to|beside|after) (?:the|an) ?other(?: one)?$", "{1}"),
    ("\\bevery two of (?=(?:them|these|those|the)\\b)", "any two of "),
    ("\\balways (?=with (?:the same|equal|an equal)\\b)", ""),
    # what is flat is no pile
    ("\\bsandwiched between (?=.*\\b(?:in (?:a|one) (?:row|line)|side by side|on the table)\\b)", "between "),
    ("\\bbelong in (?=(?:a|one) (?:stack|tower|pile|row|line)\\b)", "go in "),
    # the first of two structures is none the less one
    (f"\\b({_BESIDE}) (an?) ({COLOR}) and (an?) ({COLOR}) ({_BUILT})\\b(?! (?:of|with|that|which))",
     "{1} {2} {3} {6} and {4} {5} {6}"),
    # what is read
    (f"^{_READER} (?:can|could|must be able to|should be able to) read (.+?) on (?:the )?(?:{CUBE}s|them)", "make {1}"),
    ("^((?:swap|exchange|switch|rearrange|arrange|move|order|stack|lay) .+?) so (?:that )?it (?:says|reads|spells)\\b",
     "{1} so that they spell"),
    ("\\b(on top of|on|onto) any one of (?=them\\b|these\\b|those\\b|the\\b)", "{1} any of "),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
EMPHATIC: tuple[Turn, ...] = (
    # all of it, and nothing else
    (f"\\bof ((?:{MANY} )?{COLOR} (?:{CUBE}s|bricks|ones)) (?:only|alone){_STOP}", "of {1}"),
    # an order that is insisted on
    ("(?<!not )(?<!n't )\\bdo (?=(?:put|place|stack|set|move|leave|keep|make|build|line|arrange) (?:the|an?|all|it|"
     f"them|both|{MANY}|{COLOR}|\\w\\b))", ""),
    (f"\\b({THING}) to be (?:kept|placed|put) (?={PLACE} )", "{1} must be "),
    # parts of the one figure there is
    (f"\\b((?:the|its|one|a|each|every) (?:{_PART})(?: (?:block|cube|one|step))?) of the {_FIGURE}(?: shape)?{_STOP}",
     "{1} of it"),
    # off it, and how
    (f"\\b(take|get|bring|lift) ({THING}) (?:down|off) from (?:the top of |on top of )?(?={THING})", "{1} {2} off "),
    ("\\b(?:in )?(?:a )?rainbow (?:fashion|style|manner)\\b", "in rainbow order"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read, and what is said instead."""
WORDS = ("dare needful",)
"""Words that these take besides those that are read anyway."""
