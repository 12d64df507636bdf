"""No colour twice in succession along a line: "never the same colour twice in a row", "same colours must not touch"."""

from __future__ import annotations

from rpg.language.grammar.talk.slots import Patterns

_LEAD = "so_that|so|such_that|in_which|where|with|and|but|of_which?"
_SAME = "the? same|equal|identical|like color|colors"
_MAY = "must|may|should|shall|can|could|is|are|has_to|have_to|is_to|are_to|do|does"
_SIDE_BY_SIDE = (
    "next_to|beside|after|behind|touching|on|above|on_top_of|directly_on|directly_next_to|directly_above|"
    "directly_on_top_of|right_next_to|right_after|directly_after each_other|one_another"
)
_ADJOINING = "touching|adjacent|together|neighbors|side_by_side|back_to_back|in_a_row|in_succession|one_after_the_other"
_REPEATED = "repeat|repeats|repeating|repeated|be_repeated|recur two_times|twice?"
_TWO = "two|any_two|two_of|any_two_of? blocks|cubes|ones|neighbors? of|in|with|having? the? same|equal color|colors"
_TWICE = "twice|two_times in_a_row|in_succession|running|side_by_side|back_to_back|one_after_the_other"
_NEVER = "not|never"
_MEET = "touch|meet|follow"
_ON = "on|directly_on|next_to|directly_next_to|touching|on_top_of|directly_on_top_of"
_BE = "be|come|appear|occur|stand|sit|lie|end_up|follow|used"
NEVER_TWICE = Patterns(
    *(
        f"{said} {twice}"
        for said in (
            f"{_LEAD} {_NEVER} {_SAME}",
            f"{_LEAD} {_SAME} {_MAY}? {_NEVER} {_BE}?",
            f"without {_SAME} {_BE}?",
            f"without any|a? color|colors {_BE}?",
            f"{_LEAD} no same? color|colors {_MAY}? {_BE}?",
        )
        for twice in (_TWICE, f"twice|two_times {_SIDE_BY_SIDE}", "twice|two_times directly? after_each_other")
    ),
    *(
        f"{said} {beside}"
        for said in (
            f"{_LEAD} {_NEVER} {_SAME}",
            f"{_LEAD} {_SAME} {_MAY}? {_NEVER} {_BE}?",
            f"{_LEAD} no|never same|equal|identical color|colors {_MAY}? {_BE}?",
            f"{_LEAD} {_TWO} {_MAY}? {_NEVER} {_BE}?",
            f"{_LEAD} no|never|not {_TWO} {_MAY}? {_BE}?",
            f"{_LEAD} never|do_not put|place|stack|have {_TWO}",
            f"{_LEAD} no color|colors {_MAY}? {_REPEATED}",
            f"{_LEAD} the|a? color|colors {_MAY}? {_NEVER} {_REPEATED}",
            f"{_LEAD} with? no|never repeating|repeated color|colors",
        )
        for beside in (_ADJOINING, _SIDE_BY_SIDE)
    ),
    *(
        f"{said} {_MEET} each_other|one_another?"
        for said in (
            f"{_LEAD} {_SAME} {_MAY}? {_NEVER}",
            f"{_LEAD} {_TWO} {_MAY}? {_NEVER}",
            f"{_LEAD} no|never {_TWO} {_MAY}?",
        )
    ),
    f"{_LEAD} no block|cube|one {_MAY}? {_BE}? {_ON} one|another|a_block|another_one of|with the same|its_own color",
)
"""The ways to say so; of neighbours, not of the whole line."""
TOLD_BY = ("twice", "two", "repeat", "repeats", "repeating", "repeated", "recur", "same", "equal", "identical", "like")
"""Words without one of which it is not said."""
