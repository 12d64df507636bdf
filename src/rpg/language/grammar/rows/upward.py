"""Towers told from an end in roundabout ways: "the black one below it and the red one above", "with the following
blocks from top to bottom", "X, Y, Z: that is the tower I want", as rows that list them from one end to the other."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MANY, MUST, TOWER, WAY

_LABEL = "(?:[b-z0-9](?= |$)|a(?= (?:on|at|in|is|has|must|should|goes|comes|gets|over|under|above|below|and|,)))"
_SYMBOL = f"(?:(?:block|cube|letter|number|digit) )?{_LABEL}"
_ONE = f"((?:(?:the|an?|one|another) )?(?:{COLOR}(?: (?:block|cube|one))?|{_SYMBOL}))"
_KNOWN = f"((?:the )?{COLOR}(?: (?:block|cube|one))?|(?:the )?{_LABEL})"
_LINE = "(?:tower|stack|row|line|column)"
_BLOCKS = "(?:blocks|cubes|ones|colors|letters|digits|numbers)"
_AND = "(?:, and|and|,|, and then|and then|, then|, and finally|and finally)"
_IS = "(?:is |being |goes |comes |stands |lies |sits )?"
_LOW = "(?:at the (?:very )?(?:bottom|foot|base)|lowest|the lowest|down|below|right at the bottom)"
_HIGH = "(?:at the (?:very )?top|on (?:the )?(?:very )?top|highest|the highest|uppermost|topmost|up|above)"
_BELOW = "(?:(?:directly|right|just) )?(?:below|under|underneath|beneath)"
_ABOVE = "(?:(?:directly|right|just) )?(?:on top of|above|over|on)"
_DOWN = "(?:from the top down|from (?:the )?top to (?:the )?bottom|downwards|going down)"
_OVER = "(?:directly )?(?:on top(?: of it)?|on it)"
_UP = "(?:from the bottom up|from (?:the )?bottom to (?:the )?top|upwards|going up|from the bottom)"
_LIST = f"{_ONE[:-1]}(?:(?: , and| ,| and) {_ONE[1:-1]})+)"

_WORD = f"(?!(?:{COLOR}|{_BLOCKS})\\b)(\\S{{2,}})"
_WHEN_READ = f"(?:(?:when|if) )?(?:it is |you |one )?reads? (?:it )?{_DOWN}"
_SPELT: tuple[Turn, ...] = (
    (f"^spell (?!(?:{COLOR}|{_BLOCKS})\\b)((\\S)\\S+) (?:going down|down|downwards) (?:in )?an? ({TOWER})(?: , \\2 on "
     "top)?$", "a {3} that spells {1} from top to bottom"),
    (f"^an? ({TOWER}) (?:is (?:needed|wanted) )?(?:which|that)(?: ,)? {_WHEN_READ}(?: ,)? (?:spells|reads|says|shows) "
     f"(?:the word )?{_WORD}$", "a {1} that spells {2} from top to bottom"),
    (f"^an? ({TOWER}) (?:is (?:needed|wanted) )?(?:which|that)(?: ,)? (?:spells|reads|says|shows) (?:the word "
     f")?{_WORD} {_WHEN_READ}$", "a {1} that spells {2} from top to bottom"),
    (f"^{_WORD}(?: ,)? stacked(?: up)?(?: ,)? (?:read|reading|to be read) {_DOWN}$",
     "a tower that spells {1} from top to bottom"),
)  # fmt: skip
"""Words that are read down a tower."""

UPWARD_AT_ONCE: tuple[Turn, ...] = (
    (f"^spell {_WORD} in an? ({TOWER})(?: ,)? (?:downwards|down) from the (?:uppermost|top|topmost|highest) (?:block|"
     "cube|letter|one)$", "a {2} that spells {1} from top to bottom"),
    (f"\\b({TOWER}) (?:in|on) which (?:you|one|we|i) can read (?:the word )?{_WORD} {_DOWN}$",
     "{1} that spells {2} from top to bottom"),
    (f"^(?:on|in) an? ({TOWER})(?: ,)? the word {_WORD} {MUST} be (?:legible|readable|read|seen) {_DOWN}$",
     "a {1} that spells {2} from top to bottom"),
    (f"\\b({_LINE}) (?:with|of|from|out of) the following {_BLOCKS}(?: ,)? ({WAY}) :", "{1} {2} :"),
    (f"\\b({TOWER}) (?:with {_ONE} in the middle {_AND}|(?:in which|where) {_KNOWN} has) {_ONE} {_BELOW}(?: it)? "
     f"{_AND} {_ONE} (?:directly |right )?(?:on top|{_ABOVE} it|above|on it)(?: of it| it)?$",
     "{1} of {4} , {2} {3} and {5} from bottom to top"),
    (f"^{_KNOWN} (?:has|{MUST} have|gets) {_ONE} {_OVER} and {_ONE} ({_BELOW}) it$",
     "{2} must be on {1} and {3} must be {4} {1}"),
    (f"^{_KNOWN} (?:has|{MUST} have|gets) {_ONE} ({_BELOW}) it and {_ONE} {_OVER}$",
     "{2} must be {3} {1} and {4} must be on {1}"),
    (f"^{_LIST} : (?:build|make|form|stack) (an?|one) ({TOWER}) (?:that|which) (?:shows|has|with) (?:these|those) "
     f"{_BLOCKS}(?: when)?(?: read)? {_DOWN}$", "a {3} of {1} from top to bottom"),
    (f"^{_LIST} : (?:that|this) is the ({_LINE}) (?:that )?(?:i|we) (?:want|need|would like)(?: to see)?(?: ,)? "
     f"({WAY})$", "a {2} of {1} {3}"),
    (f"^(.+ (?:{_LOW}|{_HIGH})) : (?:build|make|form|stack) (?:that|this|such a) ({TOWER})$", "a {2} with {1}"),
    (f"^(.*?)({_ONE}(?: {_ABOVE} {_ONE[1:-1]})+) , (?:all )?(?:in )?one ({TOWER})$", "{1} a {4} of {2}"),
    (f"\\b(?:put|set|place) {_ONE} between two ({COLOR}) (?:ones|blocks|cubes) ,? ?(?:vertically ,? ?)?in (?:an?|one) "
     f"({TOWER})$", "a {3} of {2} , {1} and {2} from bottom to top"),
    (f"\\b({TOWER})(?: of three| of 3)?(?: blocks| cubes)?(?: ,| :)? (?:that has |with |of )?{_ONE} (?:sandwiched |"
     f"lying |squeezed )?(?:in )?between two ({COLOR}) (?:ones|blocks|cubes)$",
     "{1} of {3} , {2} and {3} from bottom to top"),
    (f"\\b{_KNOWN} at the bottom of (an?|one) ({TOWER}) {_AND} {_ONE} on (?:it|that|top of it) {_AND} {_ONE} on "
     "(?:top of )?(?:it|that|\\4)$", "{2} {3} of {1} , {4} and {5} from bottom to top"),
    (f"\\b({TOWER}) with (.+?) at the (?:very )?bottom , (?:and )?then ({MANY} .+?)(?: ,)? (?:and )?(?:finally|then|"
     "lastly) (.+?) (?:at the (?:very )?top|on (?:the )?(?:very )?top)(?= ,|$)",
     "{1} of {2} , {3} and {4} from bottom to top"),
    (f"^{_KNOWN} (?:is sandwiched|{MUST} be sandwiched|is|{MUST} be|is in the middle) in an? ({TOWER}) ,? ?(?:having|"
     f"with) {_ONE} {_BELOW} it and {_ONE} (?:above|{_ABOVE} it|on top)(?: it| of it)?$",
     "a {2} of {3} , {1} and {4} from bottom to top"),
    (f"^(?:put |place )?{_KNOWN} (?:at|on) the (?:very )?top of an? ({TOWER}) (?:that|which) has {_KNOWN} {_BELOW} it "
     f"and {_KNOWN} {_BELOW} (?:\\3|the .+|that)$", "a {2} of {1} , {3} and {4} from top to bottom"),
    (f"^an? ({TOWER}) (?:starts|begins) with (.+?) at the bottom and ends with (.+?) (?:at the|on) top ,? ?(?:and |"
     "with )?(.+?) (?:is |are )?(?:in )?between(?: them)?$",
     "a {1} with {2} at the bottom , {4} in the middle and {3} on top"),
    (f"^(?:put|place) {_ONE} on (?:top of )?the ({TOWER}) (?:made )?(?:of|from) {_LIST}(?: ,)? (?:in (?:that|this) "
     f"order )?{_UP}$", "a {2} , from bottom to top : {3} , then {1}"),
    (f"^(?:put |have |place )?{_KNOWN} between the (?:others|other two|other ones) in an? ({TOWER}) , {_ONE} {_ABOVE} "
     f"it and {_ONE} {_BELOW} it$", "a {2} of {4} , {1} and {3} from bottom to top"),
    (f"^use {_ONE} as (?:the|a) base and (?:stack|put|build) {_ONE} (?:and )?then {_ONE} on (?:top of )?it$",
     "a tower of {1} , {2} and {3} from bottom to top"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

UPWARD: tuple[Turn, ...] = (
    *_SPELT,
    ("^((?:the|an?) (?:\\w+ )+?(?:block|cube)) (?:forms|makes|is) the (?:base|bottom)(?: of (?:the|an?) (?:tower|"
     "stack))?(?: ,)? and ((?:the|an?) (?:\\w+ )+?(?:block|cube|one)) (?:is placed|is put|is stacked|is|sits|stands|"
     "goes|lies) on (?:top of )?it$", "put {2} on {1}"),
    (f"\\ba sandwich(?: ,)?(?: that is ,| i.e. ,)? an? ({TOWER})", "a {1}"),
    ("\\ba sandwich(?: (?:out of|of|from|made of|with) blocks)?(?= ,| :| with)", "a tower"),
    (f"^in (?:the|an?|one) ({TOWER})(?: ,)? {_KNOWN} (?:is |comes |lies )?{_HIGH}(?: ,)? (?:and )?then (?:comes |"
     f"follows )?{_KNOWN} {_AND} {_KNOWN} {_IS}{_LOW}$", "a {1} of {2} , {3} and {4} from top to bottom"),
    (f"^in (?:the|an?|one) ({TOWER})(?: ,)? {_KNOWN} comes first {_UP} , {_KNOWN} (?:comes )?(?:after (?:it|that)|"
     f"second|next) {_AND} {_KNOWN} (?:comes )?(?:last|third)$", "a {1} of {2} , {3} and {4} from bottom to top"),
    (f"^stack (?:the |these )?(?:{MANY} )?(?:blocks|cubes)? ?(?:so|like this|like so|as follows|this way|in this way) "
     f"[:,] {_KNOWN} {_IS}{_LOW} {_AND} {_KNOWN} {_IS}in the middle {_AND} {_KNOWN} {_IS}{_HIGH}$",
     "a tower with {1} at the bottom , {2} in the middle and {3} on top"),
    (f"^the stacked {_BLOCKS} (?:are|{MUST} be)(?: ,| :)? (.+)$", "a tower with {1}"),
    (f"\\b({TOWER}) (?:which|that)(?: ,)? (?:starting|beginning|begun) (?:at|from) the top(?: and going "
     "down(?:wards)?)?(?: ,)? (?:shows|has|is|reads|goes) (.+)$", "{1} of {2} from top to bottom"),
    (f"\\b({TOWER}) (?:that|which) (?:counts|goes|runs) (?:up |down )?from (\\d) (?:at the|on) top to (\\d) at the "
     "bottom", "{1} of the numbers {2} to {3} from top to bottom"),
    (f"\\b({TOWER} of {MANY}(?: blocks| cubes)?|{TOWER}(?: please)? {MANY}(?: blocks| cubes)? (?:high|tall)) "
     f"(?=(?:{FEW}|the) )", "{1} ,"),
    (f"\\bthe (?:upper|top|topmost) (?:block|cube|one) (?:is )?({COLOR}) {_AND} the ({MANY}) (?:blocks |cubes |ones "
     f")?(?:{_BELOW}) it (?:are )?({COLOR})$", "the top block {1} and the {2} lower blocks {3}"),
    (f"^(?:put |place )?{_KNOWN} (?:goes |is |{MUST} be |{MUST} go )?between {_KNOWN} (?:below|underneath) and "
     f"{_KNOWN} (?:above|on top) ,? ?(?:all )?in (?:an?|one) ({TOWER})$",
     "a {4} of {2} , {1} and {3} from bottom to top"),
    (f"^the ({TOWER}) (?:to be built |to build )?{MUST} have (.+?) (?:at|as) (?:its|the) (?:base|bottom|foot) {_AND} "
     "(.+?) (?:in|as) (?:the|its) middle (?:and|, and) (.+?) (?:at|as) (?:its|the) top$",
     "a {1} with {2} at the bottom , {3} in the middle and {4} at the top"),
    (f"^(rainbow {TOWER})(?: ,)? {_ONE} at the bottom : (.+)$", "a {1} of {3} , with {2} at the bottom"),
    (f"^(?:up)?on (the .+?) {MUST} (?:stand|be|lie)(?: ,)? ({WAY})(?: ,| :)? {_LIST}$", "a tower of {3} {2} on {1}"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
WORDS = ("sandwich sandwiched following foot vertically meet stacked",)
"""Words that these take besides those that are read anyway."""
