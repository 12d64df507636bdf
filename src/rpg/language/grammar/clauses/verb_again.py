"""A verb that is meant again behind a place: "line up three reds, and behind them three blues"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.things.retold import named_by
from rpg.language.meaning import (
    At,
    Clause,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Toward,
    parts_of,
    replace,
)

_LEMMAS = frozenset({"line", "group"})
"""Ways of "arrange" and "sort" that need no more than their blocks."""


def verb_again(p: Parser, j: int, before: Clause | None, item: Meaning) -> Meaning:
    """ "(Stack two reds) and next to them two blues": these are stacked as well. Nothing is done again with a single
    block, nor behind a mere comma: "stack the red ones, the blue ones beside them"."""
    if before is None or not isinstance(item, Clause) or not _of_several(before) or not merely_placed(item):
        return item
    fronted = item.theme is not None and item.theme.span[0] > p.char(j, 0)
    if not (fronted or p.words[j - 1] == "and") or not several(item.theme):
        return item
    if (in_an_order(before) and not alike(item.theme)) or (item.theme and in_line_already(item.theme, before)):
        return item
    return replace(item, verb=before.verb, lemma=before.lemma, mode=before.mode, word=before.word)


def _of_several(before: Clause) -> bool:
    """Whether a command says what is done with several blocks, and at most how, and on which part of the table."""
    plain = before.verb == "stack" or (before.verb in ("arrange", "sort") and before.lemma in _LEMMAS)
    there = all(isinstance(x, At | In | OrderBy | Toward) or _idle(x) or _on_a_patch(x) for x in before.adjuncts)
    return plain and there and before.mode == "command" and not before.negated and several(before.theme)


def in_line_already(theme: Meaning, before: Clause) -> bool:
    """ "Line up A to E in alphabetical order, the vowels on the mat": of those that the clause before lines up, which
    are not lined up once more."""
    if before.verb not in ("stack", "arrange") or not isinstance(theme, Noun) or theme.head == "patch":
        return False
    nouns = [x for x in parts_of(before.theme) if isinstance(x, Noun)] if before.theme is not None else []
    labels = {label for noun in nouns for label in noun.traits.labels}
    colors = {color for noun in nouns for color in noun.traits.colors}
    if theme.traits.labels or (theme.traits.colors and len(nouns) > 1):
        return labels.issuperset(theme.traits.labels) and colors.issuperset(theme.traits.colors)
    named = any(named_by(theme, (label,)) for label in labels)
    return theme.det == "the" and bool(theme.traits.kind or theme.traits.quality) and named


def _idle(how: Meaning) -> bool:
    """ "neatly", "side by side", "with gaps of 3 cm"."""
    mutual = isinstance(how, Loc) and isinstance(how.landmark, Pronoun) and how.landmark.word == "each other"
    return mutual or (isinstance(how, Manner) and how.kind == "idle")


def _on_a_patch(place: Meaning) -> bool:
    return isinstance(place, Loc) and isinstance(place.landmark, Noun) and place.landmark.head == "patch"


def merely_placed(item: Clause) -> bool:
    """Whether a clause without a verb says where blocks are, and no more."""
    told = item.verb == "be" and item.mode == "goal" and item.word is None and not item.negated
    places = all(isinstance(x, At) or (isinstance(x, Loc | In) and not x.negated) for x in item.adjuncts)
    return told and bool(item.adjuncts) and places


def in_an_order(clause: Clause) -> bool:
    return any(isinstance(x, OrderBy | Toward) for x in clause.adjuncts)


def several(theme: Meaning | None) -> bool:
    if isinstance(theme, Coord):
        return theme.op == "and"
    return isinstance(theme, Noun) and theme.plural and theme.head != "patch" and theme.part_of is None


def alike(theme: Meaning | None) -> bool:
    """Blocks that have no order, as they look alike."""
    return isinstance(theme, Noun) and not theme.traits.labels and len(theme.traits.colors) < 2
