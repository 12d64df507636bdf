"""What is asked of a tower whose order is left open: "in any order except with red on top", "whatever order keeps red
from touching blue", "red above blue in one stack, with white between them", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, TOWER

_LABEL = "(?:[b-z0-9](?= |$)|a(?= (?:on|at|in|is|as|must|should|goes|above|below|and|not|from|somewhere)))"
_KNOWN = f"((?:the )?(?:{COLOR}(?: (?:block|cube|one))?|(?:(?:block|cube|letter|number|digit) )?{_LABEL}))"
_THING = f"((?:(?:the|an?|one) )?(?:{COLOR}(?: (?:block|cube|one))?|(?:(?:block|cube|letter|number|digit) )?{_LABEL}))"
_BLOCKS = "(?:blocks|cubes|ones)"
_ORDER = "(?:any|whatever|whichever) order(?: (?:that )?you like)?"
_LOW = "(?:at the (?:very )?bottom|lowest|as (?:its|the) (?:lowest block|bottom|base|bottom block|lowest))"
_HIGH = "(?:at the (?:very )?top|on top|topmost|as (?:its|the) (?:highest block|top|top block|topmost block))"
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


UPRIGHT_AT_ONCE: tuple[Turn, ...] = (
    (f"^anything at the (?:very )?bottom {_BUT} {_KNOWN}$", "{1} is not at the bottom"),
    *_not_at(_LOW, "at the bottom"),
    *_not_at(_HIGH, "on top"),
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
WORDS = ("passes keeps separating whichever",)
"""Words that these take besides those that are read anyway."""
