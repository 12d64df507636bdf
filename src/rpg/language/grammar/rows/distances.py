"""How far blocks are from each other: gaps, distances of centres, of every two, evenly spaced, with a tolerance, as
rows that say it in one way."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, LABEL, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, FEW, LENGTH, MUST, PATCH

_LEAST = "(?:at least|more than|no less than|not less than|at most|less than|no more than|not more than)"
_ABOUT = "(?:about|around|roughly|approximately|exactly|precisely|just)"
_FAR = f"(?:(?:{_LEAST}|{_ABOUT}) )?{LENGTH}"
_MUST_BE = f"(?:{MUST} (?:be|stand|lie)|is|are|stands?|lies?|be)"
_EVERY_TWO = "(?:every two|(?:every|each|any) pair)"
_APART = "(?:apart(?: from (?:each other|one another))?|(?:away )?from (?:each other|one another))"
_ONE = f"(?:{THING}|{BLOCK} {LABEL})"
_SIDE = "(?:side|edge)"
_CENTER = "(?:center|middle)"
_LONG = f"((?:(?:about|approximately|roughly|around|exactly|at least|at most) )?{LENGTH})"
_SPACE = "(?:(?:free |empty )?(?:space|room|gap|air|clearance))"
_BLOCKS = "(?:blocks|cubes|ones|of them)"
_NEXT_TO_EACH = "(?:neighboring|adjacent|successive|consecutive)"
_NEIGHBORS = (
    f"(?:(?:the |their )?neighbors|(?:each pair of |(?:every|any|each|all) two |two |all )?"
    f"(?:{_NEXT_TO_EACH} )?{_BLOCKS}"
    f"|(?:every|any|each) (?:two|pair)(?: of)? neighbors|each (?:{_NEXT_TO_EACH} )?pair|each of them|the {_BLOCKS})"
)
_IN_LINE = " (?:in|into|from|between|row|line|column|tower|stack|pile|heap|structure|evenly|equally)\\b"
_BUILT = "(?:towers|stacks|columns|rows|pyramids)"
_MOST_OFF = "(?:by )?(?:no more than|not more than|at most|less than|up to)"
_ROW = f"((?:an?|the|one) (?:row|line|column) of (?:(?:{FEW}|\\d+) )?(?:\\w+ )?(?:blocks|cubes|ones))"
_THERE = f"there (?:is|are|{MUST} be)"
_SAME = "(?:(?:always|everywhere|all) )?(?:the same|equal|identical|equally (?:large|big|wide))(?: everywhere| size)?"
_A_BIT = "(?:(?:just )?(?:a (?:little|tiny|small) bit|a bit|a little|a touch|a tad|slightly|somewhat))"
_GAPS = "(?:gaps?|distances?|spaces?|spacing|intervals?)"
_FACES = "(?:(?:their|the|its) )?(?:facing |adjacent |neighboring )?(?:faces|sides|surfaces)"
_BARE = f"(?:(?! is | {MUST} | be | measured ).)"
_NAMED = f"(?:(?:the|an?) (?:\\w+ )?)?(?:{COLOR}|{BLOCK}|{LABEL})\\b"
_MEASURED = "(?:(?:,|as|when)? ?measured )?(?:from )?(?:center to center|(?:their )?centers? to (?:their )?centers?)"

_ONE_LINE = (
    "(?=.*\\b(?:row|line|column|spell|write)\\b)(?!.*\\b(?:rows|lines|columns|towers|stacks|words|twice|cm|mm)\\b)"
)
_SOME_GAPS = "(?:(?:an?|some) )?(?:free |empty )?(?:gaps?|spaces?|room|air)(?: left)?"

DISTANCES: tuple[Turn, ...] = (
    # from one to the next
    (f"(?: ,)?(?: with)? ({_FAR}) from (?:the |one |each )?center(?: of (?:one|each)(?: {BLOCK})?)? to (?:the )?(?:"
     f"center of )?(?:the )?next(?: one| center| {BLOCK})?$", " , {1} from center to center"),
    (f"^the (gap|distance) between (.+?) {_MUST_BE} ({_FAR})(?= , with )", "there must be a {1} of {3} between {2}"),
    # gaps of any width in a line
    *((f"^{_ONE_LINE}(.+?)(?: ,)?(?: and)? (?:with|leaving|leave|having|keeping|keep) {_SOME_GAPS}(?: in)? between "
       f"{whom}$", f"{{1}} so that {they} do not touch each other")
      for whom, they in (("(?:the |neighboring |any two |every two |all )?(letter|block|cube|digit)s", "the {2s}"),
                         ("(?:them|each other|(?:the )?neighbors)", "the blocks"))),
    ("\\bfrom every other(?: one| block| cube)?(?=$| ,)", "from all others"),
    (f"^(.+? and .+?) ({MUST}) (?:keep|have|maintain) (?:a|their) distance of ({_FAR})(?: (?:from|to) (?:each other|"
     "one another))?$", "{1} {2} be {3} apart"),
    (f"\\bat a distance from ({THING}) (greater|larger|smaller|shorter) than (?:its distance|that)(?: from| to)? "
     f"({THING})",
     "at a {2} distance from {1} than from {3}"),
    # of the middles of what is named
    (f"\\b({LENGTH}) between the (?:centers|middles) of (?:the (?:two )?|these )?{_BUILT}$",
     "{1} between their centers"),
    (f"\\b({LENGTH})((?: of)? {_SPACE})? between (?:the|these) (?:two )?{_BUILT}$", "{1} {2} between them"),
    # from one to the other
    (f"\\b(?:so(?: that)? )there (?:is|are|{MUST} be) ({_FAR}) from (?:the )?one to the other$",
     "so that they are {1} apart"),
    # how exactly
    (f"\\b({LENGTH})( apart| (?:away )?from {THING})(?: ,| with)* (?:(?:to )?within ({LENGTH})|(?:an? )?({LENGTH}) "
     f"(?:of )?(?:tolerance|leeway|margin)|(?:but )?(?:up to )?({LENGTH}) (?:more or less|either way|in either "
     "direction|too (?:much|many) or too (?:little|few))(?: (?:is|are|would be) (?:fine|okay|ok|allowed|good enough|"
     "acceptable))?)$", "{1} {2} with a tolerance of {3} {4} {5}"),
)  # fmt: skip
"""What makes no sense as it stands, and what is said instead."""
DISTANCES_AT_ONCE: tuple[Turn, ...] = (
    ("\\beach ([^,]+?) from both(?: of)? the others(?=$| ,)", "each {1} from the other two"),
    (f"^(.*\\b{_GAPS} between .+?)(?: ,)? with the ({COLOR})(?: one| {CUBE})? on the (left|right)$",
     "{1} , and the {2} block is on the {3}"),
    # "to the left a little bit, about 5 cm"
    (f"^((?:please )?(?:move|shift|push|slide|nudge|drag|bring|pull) [^,]+?)(?: {_A_BIT})? (to the (?:left|right|front|"
     f"back))(?:(?: ,)?(?: but)?(?: only)? {_A_BIT})?(?: ,)? (?:(?:by|say|like|maybe|so)(?: ,)? )?{_LONG}( or so)?"
     "(?: say)?$",
     "{1} {3} {2} {4}"),
    (f"\\b({LENGTH}(?: of {_SPACE})?|{_SPACE} of {LENGTH}) between (?:every|any|each) two$",
     "{1} between neighboring blocks"),
    # lines, which have gaps of their own
    *((f"^(.*\\b(?:rows|columns|lines)\\b.*?)(?: ,)? (?:(?:with|leaving|and) )?{told} between (?:the|these) (?:two "
       "|three )?(rows|columns|lines)$", f"{{1}} . the {what} between the {{3}} must be {{2}}")
      for told, what in ((f"(?:an? )?{_SPACE} of {_LONG}", "gap"), (f"{_LONG} of {_SPACE}", "gap"),
                         (f"(?:an? )?{_LONG} {_SPACE}", "gap"), (f"(?:an? )?distance of {_LONG}", "distance"))),
    # of every two
    (f"\\b({LENGTH})(?: (apart|away|from each other|from one another) or (?:more|farther|further)| or (?:more|farther|"
     "further) (apart))\\b", "at least {1} {2} {3}"),
    (f"\\b({LENGTH})(?: (apart|away|from each other|from one another) or (?:less|closer|nearer)| or (?:less|closer|"
     "nearer) (apart))\\b", "at most {1} {2} {3}"),
    (f"\\bany two of (?:them|these|those) ({_MUST_BE}) ({_LEAST} {LENGTH}) {_APART}", "they {1} pairwise {2} apart"),
    (f"\\b{_EVERY_TWO} of ((?:the|my) [^,]+?|{THINGS}) ({_MUST_BE}) ({_FAR}) {_APART}", "{1} {2} pairwise {3} apart"),
    (f"(?: ,|,? with| :) {_EVERY_TWO} (?:of them )?(?:(?:are|being|standing|lying) )?({_FAR}) {_APART}$",
     "pairwise {1} apart"),
    (f"(?: ,)? (?:so that|until|such that) {_EVERY_TWO} (?:of (?:blocks|cubes|them) )?({_MUST_BE}) ({_FAR}) {_APART}$",
     "so that they {1} pairwise {2} apart"),
    (f"\\b(?:at )?(?:equal distances?|the same distance) of ({LENGTH}) (?:from|to) (?:each other|one another)",
     "pairwise {1} apart"),
    ("\\b(\\d[\\d.]*) (plus or minus|plus minus|give or take) (\\d[\\d.]*) (cm|mm|centimeters|millimeters)\\b",
     "{1} {4} {2} {3} {4}"),
    ("\\b(closer|nearer) (?:together|to (?:each other|one another)) than\\b", "{1} than"),
    # of centres
    (f"\\b(?:an? (?:distance|spacing) of )?({LENGTH})(?: ,)? {_MEASURED}(?: ,)? between (?={_NAMED})",
     "{1} between the centers of "),
    (f"\\b(?:an? (?:distance|gap|spacing) of )?({LENGTH})(?: ,)?(?: from)? (?:edge|face|side) to (?:edge|face|"
     f"side)(?: ,)? "
     f"between (?={_NAMED})", "a gap of {1} between "),
    (f"(?: ,)? (?:with )?(?:its|the) {_CENTER} (?:off|out|displaced|shifted)(?: center)?(?: by)? ({_MOST_OFF} "
     f"{LENGTH})$", " , centered to within {1}"),
    (f"(?<! each)(?: ,)? ({_MOST_OFF} {LENGTH}) off (?:the )?(?:- )?{_CENTER}$", " , centered to within {1}"),
    (f"^(the {_CENTER}s of .+? and )(?:that |the {_CENTER} )?of ", "{1}"),
    (f"\\bthe {_CENTER} of ({_ONE}) and the {_CENTER} of ({_ONE}) ", "the centers of {1} and {2} "),
    (f"\\b({THING}) 's {_CENTER} ({_MUST_BE}) ({_FAR}) (?:away )?from (?:the {_CENTER} of )?({THING})(?: 's "
     f"{_CENTER})?", "{1} {2} {3} from {4}"),
    (f"\\b(?:its {_CENTER}|the {_CENTER} of it) ({_MUST_BE}) ({_FAR}) (?:away )?from (?:the {_CENTER} of )({THING})",
     "it {1} {2} from {3}"),
    (f"^(?:the )?({COLOR}) ({COLOR}) (?:{_CENTER}|center to center) distance(?: ,| :| (?:of|is|{MUST} be))? ({_FAR})",
     "the distance between {1} and {2} must be {3}"),
    # three at the corners of a triangle
    ("\\b(?:in|as|form|make|forming|making|so that they form) an? (?:equilateral )?triangle(?: ,)? (?:with|of|having) "
     f"(?:an? )?(?:{_SIDE}s?(?: length)?(?: of)? ({LENGTH})(?: each| long)?(?: length)?|({LENGTH}) {_SIDE}(?:s| "
     "length))$", "pairwise {1} {2} apart"),
    # measures
    (f"(?<=[:,] )({COLOR}) ({LENGTH})(?= ,|$| and)", "a {2} {1} block"),
    ("\\bthe (?:center|center - to - center) distance (?:of|between) ", "the distance between the centers of "),
    ("\\bbetween the facing sides of\\b", "between"),
)  # fmt: skip
SPACED_AT_ONCE: tuple[Turn, ...] = (
    # not in one place
    *((f"^((?:please )?spread) {one}(?!{_IN_LINE}) (?:on|onto|over|across) (the (?:table|{COLOR} {PATCH}|{PATCH}))$",
       "{1} {2} apart on {3}")
      for one in (f"((?:(?!{_IN_LINE}| out\\b).)+) out", f"out ((?:(?!{_IN_LINE}).)+?)")),
    (f"^(.+ {MUST} (?:be|lie)) spread out (?:on|over|across) (the (?:table|{COLOR} {PATCH}|{PATCH}))$",
     "{1} apart on {2}"),
    # all alike
    (f"(?: ,)? (?:with|at|leaving) (?:always )?(?:equal|the same|identical|uniform|even|regular|constant) {_GAPS}(?: "
     f"(?:in )?between (?:them|{_NEIGHBORS}))?(?=$| ,)", " , evenly spaced"),
    (f"(?: ,)? (?:so that|such that|and|where|with) the {_GAPS} (?:(?:in )?between (?:them|{_NEIGHBORS}) )?(?:is|are|"
     f"being|{MUST} be) {_SAME}$", " , evenly spaced"),
    ("(?: ,)? (?:so that|such that|where) (?:all (?:of them )?|(?:every|any|each) two |the )?(?:neighbors |"
     f"{_NEXT_TO_EACH} {_BLOCKS} )?(?:are|stand|have) (?:equally|all equally|the same distance|evenly) (?:far "
     ")?(?:apart|spaced|from each other)$", " , evenly spaced"),
    # along a line
    (f"^(?:leave|keep|put|allow) (?:a gap of )?{_LONG}(?: of {_SPACE})? between {_NEIGHBORS} (?:in|of) {_ROW}$",
     "{2} with gaps of {1}"),
    (f"^between {_NEIGHBORS} of {_ROW}(?: ,)? (?:{_THERE}|leave|keep) (?:a gap of )?{_LONG}(?: of {_SPACE})?$",
     "{1} with gaps of {2}"),
    (f"^between {_NEIGHBORS} (?:of|in) the (row|line|column) , which {MUST} (?:consist of|have|be made of) (.+?) , "
     f"(?:a )?gap of {_LONG} {MUST} be (?:provided|left|kept)$", "a {1} of {2} with gaps of {3}"),
    (f"(?: ,)? (?:(?:with|leaving) )?(?:a )?{_LONG} (?:of )?{_SPACE} (?:in )?between {_NEIGHBORS}$",
     " with gaps of {1}"),
    (f"(?: ,)? each(?: one)?(?: with)? {_LONG} of {_SPACE} (?:from|to|before) the next(?: one)?$", " with gaps of {1}"),
    (f"(?: ,)? each(?: one)? {_LONG} (?:away )?from the next(?: one)? {_MEASURED}$",
     " with a distance of {1} between their centers"),
    (f"(?: ,)? {_MEASURED} (?:it|this|they|the distance) {MUST} be {_LONG}$",
     " with a distance of {1} between their centers"),
    (f"\\b(?:with|at|and) an? center (?:- )?to (?:- )?center (?:distance|spacing) of {_LONG}",
     "with a distance of {1} between their centers"),
    # between two
    (f"\\b(distance between .+?) (?:{MUST} not exceed|does not exceed|is below|is under) (?={LENGTH}\\b)",
     "{1} must be at most "),
    (f"\\b(distance between .+?) (?:(?:must )?exceeds?|is above|is over|is beyond) (?={LENGTH}\\b)",
     "{1} must be more than "),
    (f"\\b(?:with|leaving) {_LONG} of (?:gap|space|room) between {_FACES}", "with a gap of {1} between them"),
    (f"\\b(gap of {LENGTH}) between {_FACES}(?! of)", "{1} between them"),
    (f"(?: ,)? so that {_THERE} {_LONG}(?: of {_SPACE})? between them$", " with a gap of {1} between them"),
    (f"^((?:the )?\\S+(?: (?:block|cube))? and (?:the )?\\S+(?: (?:block|cube))?) (?:{MUST} )?have {_LONG}(?: of "
     f"{_SPACE})? between them$", "there must be a gap of {2} between {1}"),
    (f"^between {_FACES} of (.+? and .+?) there {MUST} be (?:left )?a gap of {_LONG}$",
     "there must be a gap of {2} between {1}"),
    (f"^(?:leave|keep|place|put|{_THERE}) a gap of {_LONG} between (the .+?) on the (left|right) and (the .+?) on the "
     "(?:left|right)$", "{2} must be to the {3} of {4} with a gap of {1} between them"),
    (f"^(?:place|put|leave) a gap of {_LONG} between (two .+)$", "there must be a gap of {1} between {2}"),
    (f"^(?:the )?center (?:- )?to (?:- )?center distance (?:between|of) (.+? and .+?) (?:is|{MUST} be) {_LONG}",
     "the distance between the centers of {1} must be {2}"),
    (f"^(?:the )?(distance between {_BARE}+? and {_BARE}+?) {_LONG}(?= plus| ,|$)", "the {1} must be {2}"),
    (f"^(?:the )?neighbors {MUST} be {_LONG} apart(?: ,)? (?:from )?face to face",
     "there must be a gap of {1} between neighboring blocks"),
    (f"^the center of (.+?) {MUST} be {_LONG} (to the left|to the right|in front|behind) (?:of )?the center of "
     "(.+?)(?=$| ,)", "{1} must be {2} {3} of {4} , measured from center to center"),
    (f"^(.+?) (?:is|{MUST} be) {_LONG} away (?:\\( face to face \\)|, face to face ,|face to face) from (.+?) , on "
     "its (left|right)$", "{1} must be to the {4} of {3} with a gap of {2} between them"),
    (f"^(.+?) {MUST} keep a distance of {_LONG} (?:from|to) (.+)$", "{1} must be at a distance of {2} from {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("air clearance constant equilateral everywhere identical intervals leeway pairwise spaces uniform",)
"""Words that these take besides those that are read anyway."""
