"""Turned "in place", "on the spot", "without moving it elsewhere": what is turned is left where it is."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_TURN = frozenset({"turn", "rotate", "flip", "spin", "twist", "turned", "rotated", "flipped", "spun"})
_IN_PLACE = Patterns(
    "in_place|on_the_spot|in_its_place|at_its_place|where_it_is|where_it_stands|where_it_lies|where_they_are|"
    "where_they_stand|where_they_lie|in_their_places",
    "without moving|shifting|displacing it|them elsewhere|somewhere_else|away|anywhere|anywhere_else|around|at_all?",
)
_OTHER = frozenset({"then", ";", "or", "before", "after", "if", "not", *lexicon.VERB}) - _TURN
"""Behind these words something else is told."""
_GOES_ON = (",", "and", ".", ";", "by", "upside")
_SEVERAL = frozenset({*(word for word, plural in lexicon.BLOCK.items() if plural), "all", "both", "them", "letters"})


def left_in_place(part: list[Token]) -> list[Token]:
    """The tokens with "but leave it where it is" for what says so of something that is turned."""
    p = Parser(part)
    if _TURN.isdisjoint(p.all):
        return part
    verb = next(i for i in range(p.end) if p.words[i] in _TURN)
    for i in range(verb + 2, p.end):
        if p.words[i - 1] in _OTHER:
            break
        for j in sorted(_IN_PLACE.matches(p, i), reverse=True):
            if j < p.end and not p.stands(j, _GOES_ON):
                continue
            several = not _SEVERAL.isdisjoint(p.words[verb:j])
            told = ", but leave them where they are" if several else ", but leave it where it is"
            before = part[: i - 1] if p.words[i - 1] == "," else part[:i]
            more = next((n for n in range(j, p.end) if p.words[n] in (",", "and", ".", ";")), p.end)
            return [*before, *part[j:more], *(part[i].saying(word) for word in told.split()), *part[more:]]
    return part
