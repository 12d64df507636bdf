"""A story in plain words, before its words are looked up: it is read as what it says of the blocks."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.stories.doings import DOINGS, WISHES
from rpg.language.stories.motives import MOTIVES
from rpg.language.stories.roles import ROLES
from rpg.language.stories.wardrobe import WARDROBE
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_TURNS = Turns((*MOTIVES, *WISHES, *DOINGS, *WARDROBE, *ROLES))


_HONORED = listed("mr mrs ms miss mister madam sir lady lord doctor dr professor king queen prince princess captain "
                  "sergeant uncle aunt auntie grandma grandpa granny mummy mommy daddy mama papa")  # fmt: skip
"""Ahead of a colour of which nothing else is told these make a name of it: "Mr Blue and Mrs Green"."""


def as_a_story(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with what blocks do, wish and wear in plain words; this needs no note, for it is in the task."""
    return turned([token for n, token in enumerate(tokens) if not _honors(tokens, n)], _TURNS), []


def _honors(tokens: list[Token], at: int) -> bool:
    """Whether a word, or the stop behind it, is how somebody is addressed whose name is a colour."""
    if tokens[at].word == "." and at and tokens[at - 1].word in _SHORT:
        return _named_by_color(tokens, at + 1)
    behind = at + 1 + (tokens[at].word in _SHORT and [t.word for t in tokens[at + 1 : at + 2]] == ["."])
    return tokens[at].word in _HONORED and _named_by_color(tokens, behind)


_SHORT = frozenset({"mr", "mrs", "ms", "dr"})


def _named_by_color(tokens: list[Token], at: int) -> bool:
    behind = tokens[at + 1].word if at + 1 < len(tokens) else ""
    return at < len(tokens) and tokens[at].word in lexicon.COLOR and behind not in _NOUNS


_NOUNS = frozenset({*lexicon.BLOCK, *lexicon.PATCH, *lexicon.COLOR, "one", "ones"})
