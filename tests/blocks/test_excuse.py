"""A turn that is asked for wins over the uprightness that an order or a word would ask of the cube."""

from __future__ import annotations

from random import Random

from rpg.blocks.arrange import arrange
from rpg.blocks.evaluate import evaluate
from rpg.ir.excuse import excuse
from rpg.ir.goal import All
from rpg.ir.relations import Facing
from rpg.ir.structures import Spells, Stack
from tests.blocks.structure_states import letters, world

WORD = Spells(blocks=("s0", "s1", "s2"), word="CAT")


def test_a_turned_letter_is_excused_and_the_others_are_not() -> None:
    goal = excuse(All(goals=(WORD, Facing(block="s1", turn=180.0))))
    assert isinstance(goal, All) and isinstance(goal.goals[0], Spells)
    assert goal.goals[0].excused == ("s1",)
    objects = world(letters("CAT"))
    for state in arrange(goal, objects, rng=Random(0), count=2):
        assert evaluate(goal, state)
        assert not evaluate(WORD, state), "without the turn the word is unreadable"


def test_what_turns_nothing_excuses_nothing() -> None:
    goal = All(goals=(WORD, Stack(blocks=("s0", "s1")), Facing(block="s1", turn=0.0)))
    assert excuse(goal) is goal
    assert excuse(WORD) is WORD
