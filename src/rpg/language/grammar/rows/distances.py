"""How far blocks are from each other, told of every two of them, of their centres, or with a tolerance behind it, as
rows that say it in one way."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, LABEL, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH, MUST

_LEAST = "(?:at least|more than|no less than|not less than|at most|less than|no more than|not more than)"
_ABOUT = "(?:about|around|roughly|approximately|exactly|precisely|just)"
_FAR = f"(?:(?:{_LEAST}|{_ABOUT}) )?{LENGTH}"
_MUST_BE = f"(?:{MUST} (?:be|stand|lie)|is|are|stands?|lies?|be)"
_EVERY_TWO = "(?:every two|(?:every|each|any) pair)"
_APART = "(?:apart(?: from (?:each other|one another))?|(?:away )?from (?:each other|one another))"
_ONE = f"(?:{THING}|{BLOCK} {LABEL})"
_SIDE = "(?:side|edge)"
_CENTER = "(?:center|middle)"
DISTANCES: tuple[Turn, ...] = (
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
)  # fmt: skip
WORDS = ("pairwise equilateral leeway",)
"""Words that these take besides those that are read anyway."""
