"""How far things are apart and on which side of one, told by what is as wide, by the other side, or behind "which", as
rows that say it plainly: "equally far from red and from blue", "one on one side of it and one on the other"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import ASIDE, IS, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LENGTH, MUST, N

_BLOCK = "(?:block|cube|brick)"
_LIMIT = "(?:(?:at least|at most|more than|less than|no more than|no less than|exactly) )"
_FAR = f"(?:{_LIMIT}|(?:about|around|roughly) )?{LENGTH}"
_GAP = "(?:gap|space|room|distance)"
_THE_TWO = f"the two(?: of them| {_BLOCK}s| ones)?"
_SAME = "(?:the same|an equal|equal) distance"
_FROM = "(?:from|to)"
_EVEN = f"(?:(?:{MUST} )?have|has|{MUST} be at|is at|{MUST} be|is|{MUST} (?:lie|stand) at)"
_ARE = f"(?:are|{MUST} be|stand|lie|{MUST} (?:stand|lie))"
_SIDE = f"(?:{IS} )?on (?:the )?one side of"
_OTHER = "on (?:the|its) (?:other|opposite)(?: one| side)?"
_ENDS = "(?:at|on|to) (?:the|both|the two|opposite|either|its|the opposite|both of the) ends"
_ROW = "(an? (?:row|line|column) of [^,]+)"

HOW_FAR_AT_ONCE: tuple[Turn, ...] = (
    # "with no gap between the two"
    (f"\\b((?:no|any|a|{LENGTH}(?: of)?) (?:{_GAP} )?(?:in )?between) {_THE_TWO}(?=$| ,)", "{1} them"),
    (f"\\bequally (?:far|distant|far away)(?: away)? from ({THING}) and from ({THING})", "as far from {1} as from {2}"),
    ("\\b(?:at|in|on) the (?:midpoint|halfway point) (?:of|between) ", "halfway between "),
    ("\\bbut not (?:so|too) (?:close|near)(?: together)? that (?:they|the two|it) touch(?:es)?(?: it| each other| one "
     "another)?$", "but not touching it"),
    # on the other side of it
    (f"^(?:{PUT} )?({THING})(?: {IS})? (next to|beside) ({THING})(?: ,)? and ({THING}) (?:{IS} )?{_OTHER}(?: of "
     "(?:it|\\3))?$", "{1} must be {2} {3} . {3} must be between {1} and {4}"),
    (f"^(?:{PUT} )?({THING}) {_SIDE} ({THING})(?: ,)? and ({THING}) (?:{IS} )?{_OTHER}(?: of (?:it|\\2))?$",
     "{2} must be between {1} and {3}"),
    # names behind what is denied of them
    (f"^(?:the |these )?(?:{FEW} )?(?:blocks|cubes) ((?:{MUST}|may|can|do) not) ((?:be|stand|lie|form)(?: in)? an? "
     f"(?:\\w+ )?(?:row|line|column)) : ({THINGS})$", "{3} {1} {2}"),
    # in one line with two others, and on which side of them
    (f"^((?:{PUT} )?)({THING})(?: {IS})? in (?:a |one )?(?:straight )?line with ({THING}) and ({THING})(?: ,)?(?: and)?"
     f" ({ASIDE}) (?:both|both of them|them|the two)$",
     "{1} {2} in line with {3} and {4} . {2} must be {5} {3} and {4}"),
    # so many more of those that were told of
    (f"^((?:{PUT} )?(?:one|an?) ({COLOR}) ({_BLOCK}) (?:(?!\\b(?:an?|one) )[^,])+?(?: ,)? and) (?:another "
     f"({FEW})|({FEW}) (?:more|others?))(?! of) (?=(?:to|on) (?:its|the) |{PLACE}\\b)", "{1} {4} {5} more {2} {3}s "),
    # "on the left of it and on its right"
    (f"^(?:{PUT} )?({THING})(?: {IS})? (?:on|to) ({THING}) 's (left|right)(?: side)?(?: ,)? and ({THING})(?: {IS})? "
     "(?:on|to) its (?!\\3)(left|right)(?: side)?$", "{1} must be to the {3} of {2} and {4} must be to the {5} of {2}"),
    # two that "which" tells of behind what is between them
    (f"^(.*\\bbetween ({THING}) and ({THING})) , which (?:both )?{_ARE} ({_FAR}) (?:apart|away from each other)$",
     "{1} . {2} and {3} must be {4} apart"),
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
    # as far from one as from the other
    (f"^({THING}) {_EVEN} {_SAME} {_FROM} ({THING}) (?:and|as)(?: {_FROM})? ({THING})$",
     "{1} must be as far from {2} as from {3}"),
    (f"^(?:the )?distance (?:from|between) ({THING}) (?:to|and) ({THING}) (?:{MUST} )?(?:equals?|(?:be|is) equal to|"
     f"(?:be|is) the same as|be as (?:large|big|long) as) (?:the distance|that) (?:from|between) \\1 (?:to|and) "
     f"({THING})$", "{1} must be as far from {2} as from {3}"),
    # on one side of it and on the other
    (f"^(?:{PUT} )?(?:the )?two ({COLOR}){N} (?:{_ARE} |go |{IS} )?{_ENDS} of {_ROW}$",
     "{2} with a {1} block at each end"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("midpoint",)
"""Words that these take besides those that are read anyway."""
