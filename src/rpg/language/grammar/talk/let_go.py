"""That a block is let go of when it is where it belongs, and that all is at rest then: of every goal this is asked
anyway. How long it lasts is not said here, nor is a block that is named kept where it is."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.talk.framing import CLOSING
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.talk.wishes import TAGS
from rpg.language.phrases import Classes

_BLOCK = "block|cube|brick|box"
_BUILT = "tower|stack|pile|structure|pyramid|wall|row|line|staircase|arrangement|building|construction|result"
_FALL = "fall|topple|collapse|tip|tumble|wobble|sway"
_CLASSES = Classes(
    {
        "and": ("and|then|and_then|and_finally|finally|after_that|and_afterwards|afterwards|, ,?",),
        "arm": ("the|your|its? gripper|hand|arm|robot_arm|fingers|claw|manipulator|end_effector",),
        "robot": ("the? robot|arm|robot_arm|gripper",),
        "held": (
            "it|them",
            f"the|your {'|'.join(lexicon.COLOR)}? {_BLOCK}",
            "the blocks|cubes|bricks",
        ),
        "away": (
            "back|away|up|home|clear|out_of_the_way|to_the_side",
            "to|into the|its|your? home|rest|start|starting|initial|neutral position|pose|configuration",
            "from it|the_stack|the_tower|the_block|the_cube|the_blocks|the_cubes|the_table",
        ),
        "all": (
            "it|they|everything|all|both|all_of_them|both_of_them|all_of_it|the_whole_thing",
            f"the|this {_BUILT}",
            "both|all|all_the|the_two|both_the|all_of_the? blocks|cubes|bricks",
            f"the resulting|finished|final|completed|whole|entire {_BUILT}",
            "the blocks|cubes|bricks",
        ),
        "must": ("should|must|shall|will|has_to|have_to|needs_to|need_to|ought_to|is_to|are_to",),
        "last": ("at|in the end", "then|afterwards|finally|at_last|after_release|upon_release|when_released|on_its_own",
                 "when|once you|we let_go|are_done|release_it", "when|once done|released|finished"),
        "still": (
            "static|stationary|motionless|stable|steady|settled|balanced|at_rest|immobile|secure",
            "static|stationary|stable|steady|settled and|,|& at_rest|stable|steady|secure|balanced|motionless|static",
        ),
        "lasting": ("stable|standing|upright|balanced|steady|intact",),
        "over": ("over|down|apart|off|to_the_side",),
        "sure": ("make|making|be sure that?", "ensure|ensuring|check|see|see_to_it|verify that?",
                 "be careful|carefully ,? so_that?", "so|so_that|such_that"),
    }
)  # fmt: skip
_RELEASED = (
    "<and>* release|releasing <held>? <last>?",
    "<and>* release|let_go_of|letting_go_of <held>|<arm> <last>?",
    "<and>* let_go|letting_go <last>?",
    "<and>* let <held> go <last>?",
    "<and>* open|reopen|opening <arm> <last>?",
    "<and>* move|retract|withdraw|raise|return|lift <arm>|<robot> <away>*",
    "<and>* <arm> open|opened|empty|released|away <last>?",
    "<and>* retreat|return|go|back <away> <away>?",
    "and|then|and_then|, then? wait|stop|rest",
    "and|, then|just? keep|leave|hold it|them there|like_that|in_place|that_way",
    "<and>* without dropping|losing|breaking|damaging <held>|anything|any_of_them",
    "<and>* retreat|back_off",
    "<and>* go|return home",
)
_RESTING = (
    "<and>* <last>? <sure>? <all> <must> be <still> <last>?",
    "<and>* <sure>? <all> <must> not move|be_moving <last>",
    "<and>* <sure>? <all> is|are|'s <still> <last>?",
    "<and>* <sure>? <all> <must> stay|remain|stand|keep <lasting> <last>?",
    "<and>* <sure>? <all> stays|remains|stay|remain|keeps|stands|stand <lasting> <last>?",
    f"<and>* <sure>? <all> <must>|does|do|will|can|is_going_to not|never {_FALL} <over>? <last>?",
    "<and>* so|so_that|such_that <all> stays|stay|remains|remain|stands|stand|holds|hold there|in_place|put|by_itself|"
    "by_themselves|on_its_own|on_their_own|alone|up <last>?",
    "<and>* without <all>? falling|toppling|collapsing|tipping <over>?",
    "<and>* without anything|it|them|any_cube|any_block falling|toppling|collapsing|tipping <over>?",
    f"<and>* do not let|make <all> {_FALL} <over>?",
    "<and>* <all> comes|come|has_come|have_come to rest",
    "<and>* <sure>? nothing falls|moves|topples|collapses|wobbles <over>? <last>?",
    "<and>* <sure>? nothing|no_cube|no_block <must>|may|can fall|topple|collapse|wobble <over>? <last>?",
)

LET_GO = Patterns(*_RELEASED, *_RESTING, classes=_CLASSES)
"""What may stand behind what is to be done, or in a sentence of its own."""
ENDINGS = (TAGS, CLOSING, LET_GO)
"""What carries nothing at the end of what is said."""
