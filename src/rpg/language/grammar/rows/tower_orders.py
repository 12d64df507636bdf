"""In which order the blocks of one tower lie: what is not at its end, above or between others, and the words that are
read down it, as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MANY, MUST, TOWER, WAY

_LABEL = (
    "(?:[b-z0-9](?= |$)|a(?= (?:on|at|in|is|has|as|must|should|goes|comes|gets|over|under|above|below|and|not|from|"
    "somewhere|,)))"
)
_KNOWN = f"((?:the )?(?:{COLOR}(?: (?:block|cube|one))?|(?:(?:block|cube|letter|number|digit) )?{_LABEL}))"
_THING = f"((?:(?:the|an?|one) )?(?:{COLOR}(?: (?:block|cube|one))?|(?:(?:block|cube|letter|number|digit) )?{_LABEL}))"
_BLOCKS = "(?:blocks|cubes|ones|colors|letters|digits|numbers)"
_ORDER = "(?:any|whatever|whichever) order(?: (?:that )?you like)?"
_AT_BOTTOM = "(?:at the (?:very )?bottom|lowest|as (?:its|the) (?:lowest block|bottom|base|bottom block|lowest))"
_AT_TOP = "(?:at the (?:very )?top|on top|topmost|as (?:its|the) (?:highest block|top|top block|topmost block))"
_BUT = "(?:but|except|except for|other than|save)"
_IS = f"(?:is|{MUST} be|goes|{MUST} go|stands|sits|lies)"
_IN_ONE = f"(?:in (?:one|the same|a single|this|the)(?: and the same)? {TOWER}|in an? {TOWER})"
_BEGUN = "(?:^|(?<=, )|(?<=: ))"
_INDIRECT = "(?:but )?not (?:directly|immediately|right)(?: on (?:top of )?(?:it|that)| above it)?"
_AMID = "(?:in between|between (?:them|the two|these two|those two|the other two)|in the middle)"


def _not_at(place: str, said: str) -> tuple[Turn, ...]:
    """What is not to be at an end of the tower."""
    return (
        (f"(?: ,)? (?:in {_ORDER}|(?:with )?anything)(?: ,)? (?:{_BUT} (?:with )?|(?:that|which) (?:does|must|may) not "
         f"have ){_KNOWN} {place}$", f", with {{1}} not {said}"),
        (f"(?: ,)? (?:with )?anything {place} {_BUT} {_KNOWN}$", f", with {{1}} not {said}"),
    )  # fmt: skip


def _not_block(nouns: str, said: str) -> Turn:
    return (f"(?: ,)? (?:as long as|so long as|provided that|so that) (?:its|the) (?:{nouns})(?: block| cube| one)? "
     f"(?:is|"
            f"{MUST} be) not {_KNOWN}$", f", with {{1}} not {said}")  # fmt: skip


_SYMBOL = f"(?:(?:block|cube|letter|number|digit) )?{_LABEL}"
_ONE = f"((?:(?:the|an?|one|another) )?(?:{COLOR}(?: (?:block|cube|one))?|{_SYMBOL}))"
_LINE = "(?:tower|stack|row|line|column)"
_AND = "(?:, and|and|,|, and then|and then|, then|, and finally|and finally)"
_COMES = "(?:is |being |goes |comes |stands |lies |sits )?"
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

UPRIGHT_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b({TOWER}s?\\b.*?)(?: ,)? (?:as )?(?:seen|viewed|looked at) from (?:the )?top(?: down)?(?= [:,]|$)",
     "{1} from top to bottom"),
    (f"^anything at the (?:very )?bottom {_BUT} {_KNOWN}$", "{1} is not at the bottom"),
    *_not_at(_AT_BOTTOM, "at the bottom"),
    *_not_at(_AT_TOP, "on top"),
    (f"^any ({TOWER} of .+?) (?:passes|will do|is fine|counts|is ok)(?: ,)? ((?:as long as|provided that|if) .+)$",
     "a {1} {2}"),
    _not_block("topmost|top|highest|uppermost", "on top"),
    _not_block("bottommost|bottom|lowest|lowermost", "at the bottom"),
    (f"(?: ,)? in {_ORDER} (?:that|which) (?:puts|has|places|leaves) {_KNOWN} (?:somewhere )?(above|below) {_KNOWN}$",
     "so that {1} is somewhere {2} {3}"),
    (f"(?: ,)? in {_ORDER}(?: that| which)? keeps {_KNOWN} from (?:touching|being on) {_KNOWN}$",
     "so that {1} does not touch {2}"),
    (f"(?: ,)? (?:in {_ORDER} )?(?:as long as|so long as|provided that|so that) {_KNOWN} is higher(?: up)?(?: in "
     f"(?:it|the {TOWER}))? than {_KNOWN}$", "so that {1} is somewhere above {2}"),
    (f"^(stack|pile up) all {MANY} of (.+?) (so that .+)$", "{1} {2} {3}"),
    (f"^(.*\\b{TOWER}\\b.*?)(?: ,)? (?:in which|so that|where|with) (?:neither|none of the) ({COLOR}) (?:one|ones|"
     "block|blocks|cube|cubes) (?:is |are )?(?:touching|touches|touch) (?:the other|another|each other)(?: one| "
     "ones)?$", "{1} so that no two {2} blocks touch"),
    (f"^(.*\\b(?:{TOWER}|stack)\\b.*?)(?: ,)? (?:in which|so that|where|with) no (?:block|cube) (?:is |lies |sits |"
     "being )?(?:directly )?(?:on top of|on|touching) (?:one|another|another one|a block|another block) of (?:its own|"
     "the same) color$", "{1} so that no two blocks of the same color touch"),
    # what is between two of them
    (f"{_BEGUN}{_KNOWN} (?:{_IS} )?(?:somewhere )?above {_KNOWN} {_IN_ONE}(?: ,)? {_INDIRECT}$",
     "{1} must be somewhere above {2} . {1} must not be on {2}"),
    (f"{_BEGUN}{_KNOWN} (?:{_IS} )?(?:somewhere )?above {_KNOWN} {_IN_ONE}(?: ,)? (?:and|with) (?:only )?{_THING} "
     f"(?:is |{MUST} be |goes )?(?:in the middle of|between|separating) (?:them|the two)$",
     "a tower of {2} , {3} and {1} from bottom to top"),
    (f"{_BEGUN}{_KNOWN} (?:{_IS} )?(?:somewhere )?above {_KNOWN} {_IN_ONE}(?: ,)? (?:and|with) (?:only )?{_THING} "
     f"(?:is |{MUST} be |goes )?{_AMID}$", "a tower of {2} , {3} and {1} from bottom to top"),
    (f"^somewhere above {_KNOWN} {_IN_ONE} (?:there )?(?:is|{MUST} be) {_KNOWN}(?: ,)? (?:and|with) {_THING} (?:is |"
     f"{MUST} be |goes )?{_AMID}$", "a tower of {1} , {3} and {2} from bottom to top"),
    (f"^somewhere above {_KNOWN} {_IN_ONE} (?:there )?(?:is|{MUST} be) {_KNOWN}$", "{2} must be somewhere above {1}"),
    (f"^(?:stack|put|place) {_KNOWN} (?:over|above|on) {_KNOWN} ,? ?{_INDIRECT} [:,] {_THING} (?:is|goes|comes|{MUST} "
     f"be|{MUST} go) {_AMID}$", "a tower of {2} , {3} and {1} from bottom to top"),
    (f"\\b({TOWER}) (?:with|where|in which) {_KNOWN} (?:is |being )?(?:in )?between {_KNOWN} and {_KNOWN}$",
     "{1} of {3} , {2} and {4} with {2} in the middle"),
    (f"^(.*\\b{TOWER}\\b.*?)(?: ,)? with {_KNOWN} (?:somewhere )?above {_KNOWN} ,? ?{_INDIRECT}$",
     "{1} , with {2} somewhere above {3} . {2} must not be on {3}"),
    (f"^(.*\\b{TOWER} (?:of|out of|from) .*?)(?: ,)? with {_KNOWN} at the bottom , {_KNOWN} (?:on top|at the top) and "
     f"the (?:other|third|last|remaining)(?: one| block| cube)? {_AMID}$", "{1} with {2} at the bottom and {3} on top"),
    (f"\\b(?:put|stack|place) both (?:the )?({COLOR}) {_BLOCKS} on {_KNOWN} so that (?:it is|there is|you get|this is|"
     f"they form) (an? {TOWER}) of three$", "{3} of {2} and two {1} blocks from bottom to top"),
    (f"\\bthe ({COLOR}) the ({COLOR}) and the ({COLOR}) (?=block|cube|one)", "the {1} , the {2} and the {3}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
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
    # "sandwiched in between", "layer them"
    ("\\bsandwiched (?:right |directly |exactly )?(?:in between|(?:in )?between the two(?: of them)?|in the (?:middle|"
     "center)(?: of (?:them|the two|those|these))?)(?= ,|$)", "sandwiched between them"),
    (f"^(?:in (?:the|an?) {TOWER} , )?(the .+?) (?:is|{MUST} be) sandwiched between (the .+?) below(?: it)? and (the "
     f".+?) above(?: it)?$", "{1} must be on {2} and {3} must be on {1}"),
    (f"^(?:stack|pile up) {_THING} , (?:and )?then {_THING}(?: ,)? (?:and )?then (another {COLOR} "
     f"(?:block|cube|one))(?: on (?:the )?top)?$", "stack {1} , {2} and {3}"),
    (f"\\b({TOWER} (?:where|in which) .+?) , (?:and )?{_THING} is (at the top|on top)$", "{1} and {2} {3}"),
    (f"^(?:please )?layer (?:me |us )?(?=an? {TOWER}\\b)", "build "),
    (f"^(?:please )?layer (?=(?:them|these|those|all|the|an?) |{COLOR}\\b|{MANY} {COLOR}\\b)", "stack "),
    (f"(^(?:stack|pile)\\b[^:]*|\\b{TOWER}) in layers(?= ,| :|$)", "{1}"),
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
    (f"\\bwithout (?:having )?(?:an?|any) ({COLOR}) (?:ones?|blocks?|cubes?) ("
     "(?:at|on) (?:the |its )?(?:very )?(?:bottom|top|base|left end|right end))\\b", "with no {1} block {2}"),
    *_SPELT,
    ("^((?:the|an?) (?:\\w+ )+?(?:block|cube)) (?:forms|makes|is) the (?:base|bottom)(?: of (?:the|an?) (?:tower|"
     "stack))?(?: ,)? and ((?:the|an?) (?:\\w+ )+?(?:block|cube|one)) (?:is placed|is put|is stacked|is|sits|stands|"
     "goes|lies) on (?:top of )?it$", "put {2} on {1}"),
    (f"\\ba sandwich(?: ,)?(?: that is ,| i.e. ,)? an? ({TOWER})", "a {1}"),
    ("\\ba sandwich(?: (?:out of|of|from|made of|with) blocks)?(?= ,| :| with)", "a tower"),
    (f"^in (?:the|an?|one) ({TOWER})(?: ,)? {_KNOWN} (?:is |comes |lies )?{_HIGH}(?: ,)? (?:and )?then (?:comes |"
     f"follows )?{_KNOWN} {_AND} {_KNOWN} {_COMES}{_LOW}$", "a {1} of {2} , {3} and {4} from top to bottom"),
    (f"^in (?:the|an?|one) ({TOWER})(?: ,)? {_KNOWN} comes first {_UP} , {_KNOWN} (?:comes )?(?:after (?:it|that)|"
     f"second|next) {_AND} {_KNOWN} (?:comes )?(?:last|third)$", "a {1} of {2} , {3} and {4} from bottom to top"),
    (f"^stack (?:the |these )?(?:{MANY} )?(?:blocks|cubes)? ?(?:so|like this|like so|as follows|this way|in this way) "
     f"[:,] {_KNOWN} {_COMES}{_LOW} {_AND} {_KNOWN} {_COMES}in the middle {_AND} {_KNOWN} {_COMES}{_HIGH}$",
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
WORDS = ("following foot keeps meet passes sandwich sandwiched separating stacked vertically whichever",)
"""Words that these take besides those that are read anyway."""
