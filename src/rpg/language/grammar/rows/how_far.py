"""How far things are apart and on which side of one, told by what is as wide, by the other side, or behind "which", as
rows that say it plainly: "equally far from red and from blue", "one on one side of it and one on the other"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import IS, PUT, THING
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
    # two that "which" tells of behind what is between them
    (f"^(.*\\bbetween ({THING}) and ({THING})) , which (?:both )?{_ARE} ({_FAR}) (?:apart|away from each other)$",
     "{1} . {2} and {3} must be {4} apart"),
)  # fmt: skip
"""What is read otherwise as it stands."""
HOW_FAR: tuple[Turn, ...] = (
    ("\\bwithout (?:leaving )?(?:any|a) (?:gaps?|space|room|distance)(?: in between| between them)?$",
     "without a gap between them"),
    # as wide as blocks are
    (f"^(?!.*\\b{_GAP} of\\b)(.*?)\\b({_LIMIT}?(?:an?|{FEW}) {_BLOCK})(?: 's)? (?:widths?|lengths?)(?: of (?:space|room)"
     ")? between ", "{1} a gap of {2} width between "),
    (f"^between ({THING} and {THING}) there ({MUST}) be (a gap of [^,]+)$", "there {2} be {3} between {1}"),
    (f"\\b(?:a )?{_GAP} as (?:wide|large|big|long) as (?:a|one) {_BLOCK}(?: {IS})?(?= between|$)",
     "a gap of one block width"),
    # as far from one as from the other
    (f"^({THING}) {_EVEN} {_SAME} {_FROM} ({THING}) (?:and|as)(?: {_FROM})? ({THING})$",
     "{1} must be as far from {2} as from {3}"),
    (f"^(?:the )?distance (?:from|between) ({THING}) (?:to|and) ({THING}) (?:{MUST} )?(?:equals?|be equal to|be the same "
     f"as|is equal to|is the same as|be as (?:large|big|long) as) (?:the distance|that) (?:from|between) \\1 (?:to|and) "
     f"({THING})$", "{1} must be as far from {2} as from {3}"),
    # on one side of it and on the other
    (f"^(?:{PUT} )?({THING}) {_SIDE} ({THING})(?: ,)? and ({THING}) (?:{IS} )?{_OTHER}(?: of (?:it|\\2))?$",
     "{2} must be between {1} and {3}"),
    (f"^(?:{PUT} )?(?:the )?two ({COLOR}){N} (?:{_ARE} |go |{IS} )?{_ENDS} of {_ROW}$", "{2} with a {1} block at each end"),
)  # fmt: skip
"""What makes no sense as it stands."""
