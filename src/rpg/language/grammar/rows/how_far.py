"""How far things are apart, told by what is as wide, by another distance, or behind "which", as rows that say it
plainly: "equally far from red and from blue", "a block's width between them", "the two, which are 20 cm apart"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import ASIDE, IS, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import FEW, LENGTH, MUST

_BLOCK = "(?:block|cube|brick)"
_LIMIT = "(?:(?:at least|at most|more than|less than|no more than|no less than|exactly) )"
_FAR = f"(?:{_LIMIT}|(?:about|around|roughly) )?{LENGTH}"
_GAP = "(?:gap|space|room|distance)"
_THE_TWO = f"the two(?: of them| {_BLOCK}s| ones)?"
_EACH = "(?:each other|one another)"
_SAME = "(?:the same|an equal|equal) distance"
_FROM = "(?:from|to)"
_EVEN = f"(?:(?:{MUST} )?have|has|{MUST} be at|is at|{MUST} be|is|{MUST} (?:lie|stand) at)"
_EQUALS = "(?:equals?|(?:be|is) equal to|(?:be|is) the same as|be as (?:large|big|long) as)"
_ARE = f"(?:are|{MUST} be|stand|lie|{MUST} (?:stand|lie))"
_APART = (
    f"(?:{_FAR} (?:apart|away from {_EACH})|(?:next to|near|close to|far from) {_EACH}|side by side|"
    f"touching(?: {_EACH})?|(?:close|near) together|far apart)"
)
_BESIDE_TWO = f"(.*\\b(?:between|{ASIDE})(?: both)? ({THING}) and ({THING}))"

HOW_FAR_AT_ONCE: tuple[Turn, ...] = (
    # "with no gap between the two"
    (f"\\b((?:no|any|a|{LENGTH}(?: of)?) (?:{_GAP} )?(?:in )?between) {_THE_TWO}(?=$| ,)", "{1} them"),
    (f"\\bequally (?:far|distant|far away)(?: away)? from ({THING}) and from ({THING})", "as far from {1} as from {2}"),
    ("\\b(?:at|in|on) the (?:midpoint|halfway point) (?:between|of (?!(?:the|an?) (?:\\w+ )?(?:table|mat|patch|pad|"
     "zone|area|row|line|tower)\\b)) ", "halfway between "),
    ("\\bbut not (?:so|too) (?:close|near)(?: together)? that (?:they|the two|it) touch(?:es)?(?: it| each other| one "
     "another)?$", "but not touching it"),
    # two that "which" tells of behind what is told beside them
    (f"^{_BESIDE_TWO} , which (?:both )?{_ARE} ({_APART})$", "{1} . {2} and {3} must be {4}"),
    (f"^{_BESIDE_TWO} , which (?:both |must )?(touch {_EACH})$", "{1} . {2} and {3} must {4}"),
    # from one side to another
    *((f"^there (?:is|{MUST} be) ({_FAR})(?: of (?:space|room))? between the {one} (?:side|face|edge) of ({THING}) and "
       f"the {other} (?:side|face|edge) of ({THING})$",
       f"{{2}} must be to the {other} of {{3}} with a gap of {{1}} between them")
      for one, other in (("left", "right"), ("right", "left"))),
    (f"^(?:the )?distance between (?:their|the|the two) centers ({MUST} be|is) ({_FAR})$", "they must be {2} apart"),
)  # fmt: skip
"""What is read otherwise as it stands."""
HOW_FAR: tuple[Turn, ...] = (
    (f"\\b(?:just )?(?:a (?:little |tiny |small )?bit|a little|slightly|some way) (?:away )?from ({THING})(?: ,)? "
     f"(?:say|by|about|maybe)(?: ,)? ({LENGTH})$", "about {2} away from {1}"),
    ("\\bwithout (?:leaving )?(?:any|a) (?:gaps?|space|room|distance)(?: in between| between them)?$",
     "without a gap between them"),
    # as wide as blocks are
    (f"^(?!.*\\b{_GAP} of\\b)(.*?)\\b({_LIMIT}?(?:an?|{FEW}) {_BLOCK})(?: 's)? (?:widths?|lengths?)(?: of (?:space|"
     "room))? between ", "{1} a gap of {2} width between "),
    (f"^between ({THING} and {THING}) there ({MUST}) be (a gap of [^,]+)$", "there {2} be {3} between {1}"),
    (f"\\b(?:a )?{_GAP} as (?:wide|large|big|long) as (?:a|one) {_BLOCK}(?: {IS})?(?= between|$)",
     "a gap of one block width"),
    (f"\\ba (?:small|little|narrow|tiny|slight) (gap|space) ,? ?(?:of )?(?:(?:say|about|roughly|maybe) ,? ?)?({LENGTH})"
     "(?: ,)? (?=between )", "a {1} of about {2} "),
    # as far from one as from the other
    (f"^({THING}) {_EVEN} {_SAME} {_FROM} ({THING}) (?:and|as)(?: {_FROM})? ({THING})$",
     "{1} must be as far from {2} as from {3}"),
    (f"^(?:the )?distance (?:from|between) ({THING}) (?:to|and) ({THING}) (?:{MUST} )?{_EQUALS} (?:the distance|that) "
     f"(?:from|between) \\1 (?:to|and) ({THING})$", "{1} must be as far from {2} as from {3}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("midpoint",)
"""Words that these take besides those that are read anyway."""
