""" "Clear the green patch of all blocks", "the patch must be left empty": nothing is on it at the end."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Noun
from rpg.language.phrases import Classes

_CLASSES = Classes(
    {
        "empty": ("empty|clear|free|vacant|uncovered|bare|unoccupied|like_that|that_way",),
        "thing": ("blocks|cubes|things|objects|items|block|cube|thing|object",),
        "blocks": ("of|from all|any|the|every? <thing>|it", "of everything|anything"),
        "left": (",? and? then? leave|keep it <empty>",),
        "end": ("at|in|by the end",),
    }
)
_CLEAR = Patterns("uncover|unload|empty|clear|vacate|free|free_up|empty_out|clear_off|clear_out")
_MORE = Patterns("<blocks> <left>? <end>?", "<left> <end>?", "<end>", classes=_CLASSES)
_CLEARED = Patterns(
    "must|should|shall|will|has_to|needs_to|is_to|ought_to be cleared|emptied|vacated|unloaded|freed|freed_up|"
    "cleared_off|cleared_out <blocks>? <end>?",
    "must|should|shall|will|has_to|needs_to|is_to|ought_to be left|kept <empty> <blocks>? <end>?",
    "must|should|shall|will|has_to|needs_to|is_to|ought_to become <empty> <blocks>? <end>?",
    classes=_CLASSES,
)
_ALONE = frozenset({"uncover", "unload", "vacate", "free", "up"})
"""Behind these verbs nothing more need be said of a patch; the others take what they are about as all verbs do."""
_CLOSED = frozenset({",", ";", "and", "then", "."})


@rule
def emptied(p: Parser, i: int) -> Results[Clause]:
    """A patch that is to be cleared, as a command or told of the patch."""
    for patch, k in _patch(p, i):
        for end in _CLEARED.matches(p, k):
            yield _clear(p, i, end, k, patch), end
    for j in _CLEAR.matches(p, i):
        for patch, k in _patch(p, j):
            ends = [*_MORE.matches(p, k)]
            if p.words[j - 1] in _ALONE and (k >= p.end or p.stands(k, _CLOSED)):
                ends.append(k)
            for end in ends:
                yield _clear(p, i, end, i, patch), end


def _patch(p: Parser, i: int) -> Iterator[tuple[Noun, int]]:
    return ((thing, j) for thing, j in simple(p, i) if isinstance(thing, Noun) and thing.head == "patch")


def _clear(p: Parser, i: int, end: int, verb: int, patch: Noun) -> Clause:
    word = p.span(verb, verb + 1)
    return Clause(verb="remove", lemma="clear", theme=patch, span=p.span(i, end), word=word)
