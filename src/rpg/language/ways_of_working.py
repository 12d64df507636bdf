"""How the work is done: "use the left arm", "work slowly", "you have two minutes", "it must not fall".

None of this is a part of a goal, which is of where blocks are in the end; that what stands will not fall is checked in
any case. It is left out, and a note says so. What could be meant of a place, or of what is to stay as it is, is none
of it.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.phrases import Classes, Rows
from rpg.language.tokens import Token

_CLASSES = Classes({
    "work": ("work|go|act|proceed|operate|move|be|do_it|do_this|do_that|do_so|handle_it|handle_them|take_it|move_it|"
             "lift_it|lift_them|handle_the_blocks|move_the_blocks|handle_everything",),
    "how": ("very|really|as|so? slowly|carefully|gently|quickly|fast|precisely|calmly|slow|quick|careful|gentle|swift|"
            "swiftly|smoothly|steadily|precise|easy|patient|exact|accurate",
            "with a|great|much|some? care|caution|precision|patience|delicacy"),
    "harm": ("drop|break|damage|scratch|crush|squeeze|smash|hurt|lose|throw|squash|dent|ruin|bend|chip|spill",),
    "things": ("anything|it|them|everything|any of_them|block|blocks|cube|cubes?", "a|the block|blocks|cube|cubes"),
    "many": ("one|two|three|four|five|ten|fifteen|twenty|thirty|sixty|ninety|only_one|a|a_few|2|3|4|5|10|15|20|30|60|"
             "90|unlimited|limited|no",),
    "hand": ("hand|hands|arm|arms|gripper|grippers|manipulator",),
    "it": ("it|this|that|they|everything|the_whole_thing|all_of_it", "the? tower|stack|structure|pile|wall|pyramid|"
           "construction|building|towers|stacks|result|arrangement",),
    "must": ("must|should|shall|may|can|has_to|have_to|needs_to|need_to|had_better|will|is_to|are_to|ought_to",),
    "end": ("at_the_end|in_the_end|afterwards|when_done|when_you_are_done|when_finished|then|after_that|once_done",),
})  # fmt: skip
_WAYS = (
    "please? <work> <how> please|now|about_it|with_it|with_them|here|at_all_times?",
    "please? <how> please|now|with_it|with_them?",
    "please? in|with|using as_few|as_little|the_fewest|the_least|the_least_number_of|the_smallest_number_of|"
    "the_minimum_number_of|minimal|few moves|steps|actions|movements as_possible|you_can|needed|necessary?",
    "please? as fast|quickly|efficiently|slowly|gently|carefully|precisely as possible|you_can|needed",
    "please? without knocking|tipping|pushing|throwing <things>|any_of_them|the_others|others over|down|off",
    "please? without bumping|running|crashing|driving into <things>|any_of_them|the_others|others|each_other",
    "please? being careful|gentle|gentle_with_them|careful_with_them|gentle_with_it",
    "please? being careful|cautious not_to bump|hit|knock|drop <things>|any_of_them|the_others|others over|down?",
    "please? without rushing|hurrying|hesitating|hesitation|waiting|stopping|pausing|talking|swearing|laughing",
    "and? with a steady|firm|light|gentle|calm hand|touch|grip",
    "please? make|do|keep it|this quick|fast|snappy|swift|brief please|okay?",
    "please? use|with|take|using only|just? one|the|your|a left|right|other|same|free|single? <hand> only|for_this|"
    "for_that|please?",
    "please? use|with both|two <hand> for_this|please?",
    "please? do not|never|try_not_to|be_careful_not_to|take_care_not_to|without <harm> <things> please|on_the_way|"
    "while_you_do_it|in_the_process?",
    "please? without <harm> <things> please|on_the_way|in_the_process?",
    "without dropping|breaking|damaging|scratching|crushing|losing|throwing <things>",
    "please? do not|never|try_not_to|be_careful_not_to knock|tip|push <things> over|down|off",
    "and? then you|we can|may|should|are? stop|finished|done|through",
    "and? then stop|finish|rest|relax|wait",
    "and? stop then|there|afterwards|after_that",
    "please? release|let_go_of|ungrasp it|them|everything|the_block|the_blocks|the_last_block <end>?",
    "please? open|retract|raise|withdraw|lift|home the|your <hand> <end>",
    "the|your <hand> <must> be|end|end_up|stay|remain open|empty|free|back|retracted|up|clear|away|home|still <end>?",
    "please? move|go|drive|return|pull back|home|away? to_the_start|to_home|home|out_of_the_way|to_the_home_position "
    "<end>",
    "you|we|i|the_robot|it have|has|'ve|get|gets|got only|just|exactly|at_most|about? <many> "
    "minute|minutes|seconds|second|tries|try|attempts|attempt|chances|chance|hours|hour|shot|shots|time for_it|"
    "for_this|"
    "to_do_it|for_that|left|total|in_total?",
    "the? time|speed limit is <many> minute|minutes|second|seconds",
    "there is|'s no|not_any|a time|speed limit|pressure|deadline here|for_this|on_this|this_time?",
    "no time|speed limit|pressure|deadline",
    "time|speed|efficiency|elegance is|does|do not|no? matter|important|an_issue|measured|relevant|a_problem|"
    "being_measured here|today|at_all|though?",
    "time|speed|precision|accuracy|safety|patience|quality|efficiency|stability|neatness|care "
    "matters|counts|first|comes_first|above_all|is_important|is_key|is_everything|is_essential|is_crucial|is_the_key|"
    "is_a_must here|today|most|a_lot|too|always?",
    "the order in_which|that? you|we|the_robot|the_arm do|does|work|works|proceed|proceeds|act|acts|move|moves it|this|"
    "things|them|that? does_not_matter|is_free|is_up_to_you|is_not_important|is_irrelevant|is_yours|is_your_choice",
    "how you|we|the_robot|it|exactly|precisely do|does|manage|manages|get|gets|go_about|goes_about|handle|handles? it|"
    "this|that|there? is_up_to_you|is_left_to_you|does_not_matter|is_not_important|is_irrelevant|is_your_business|"
    "is_your_choice",
    "points|marks|credit|a_bonus|bonus_points is|are given|awarded for accuracy|precision|speed|neatness|style",
    "<many> points|marks|stars|credits|point if|when|for it|this|you|that works|stands|holds|succeed|success|manage_it",
    "<it> <must> not|never ever? fall|topple|collapse|tip|wobble|tumble|crash|fall_apart|come_down|"
    "tip_over|fall_over over|down|off|apart|afterwards|please?",
    "one is|'s|will_be|would_be enough|sufficient|fine|okay|ok|plenty",
    "not before|earlier|sooner|until_then|any_earlier",
    "i|we? do_not|dont care|mind what|which color|colors|colours the|these|those corner|other|remaining|outer|end? "
    "cubes|blocks|ones are|have|get",
    "i|we? do_not|dont care|mind what|which|about_the|about color|colors|colours? it_is|they_are|"
    "they_have|it_has|you_use|you_take?",
    "nothing|none_of_them|no_block|no_cube <must> fall|topple|collapse|tip|wobble|fall_down|tip_over|fall_over|"
    "fall_off afterwards|please?",
    "<it> <must> be|stay|remain|stand stable|steady|firm|standing|secure|sturdy|stably|firmly|steadily enough|please|"
    "at_the_end|in_the_end|for_a_while|for_a_second|for_two_seconds?",
    "<it> <must> hold|balance by_itself|on_its_own|without_help|firmly|steadily",
    "so|so_that <it> does|do|will|would|can not fall|topple|collapse|tip|wobble over|down|off|apart?",
    "so|so_that it|they is|are easy|easier|simple|nice|handy to find|see|clean|remember|grab|film|"
    "photograph|look_at|spot",
    "the|these|those|my|our|all|all_the|your blocks|cubes|bricks|pieces|boxes are|'re very|quite|all|really|rather|"
    "a_bit|brand? fragile|slippery|new|heavy|expensive|old|clean|dirty|dusty|precious|delicate|antique|wooden|soft|"
    "breakable|borrowed|brittle|smooth|rough|handmade|shiny|hollow",
    "the|these|those|my|our|all|all_the blocks|cubes|bricks|pieces|boxes are|have all? the? "
    "same_size|equal_size|equally_big|equally_large|equal_in_size|of_the_same_size|of_equal_size|identical_in_size",
    "there is|are|will_be nothing|no else|other_blocks|other_things|more_blocks|other_objects|other_cubes|"
    "further_blocks "
    "on_the_table|around|here|in_the_scene|involved",
)
_ROWS = Rows(_WAYS, _CLASSES)


def way_of_working(tokens: Sequence[Token]) -> bool:
    """Whether these words tell nothing but how the work is done."""
    plain = tokens and all(token.kind in ("word", "number") for token in tokens)
    return bool(plain) and _ROWS.whole([token.word for token in tokens])
