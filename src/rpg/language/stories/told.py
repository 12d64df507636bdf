"""A story in plain words, before its words are looked up: it is read as what it says of the blocks."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.stories.doings import DOINGS, WISHES
from rpg.language.stories.motives import MOTIVES
from rpg.language.stories.wardrobe import WARDROBE
from rpg.language.tokens import Token

_TURNS = Turns((*MOTIVES, *WISHES, *DOINGS, *WARDROBE))


def as_a_story(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with what blocks do, wish and wear in plain words; this needs no note, for it is in the task."""
    return turned(tokens, _TURNS), []
