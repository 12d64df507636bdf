"""Lines and words beside which something stands, or that stand there: "three white blocks in a row on it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.prepositions import relation
from rpg.language.grammar.things.labels import literal
from rpg.language.meaning import Loc, Meaning, Noun, Structure

_SHAPES = {"in a row": "row", "in a line": "line", "stacked": "stack", "in a stack": "stack", "in a tower": "stack",
           "stacked up": "stack", "lined up": "line", "piled up": "stack", "in one row": "row"}  # fmt: skip


def formed(p: Parser, k: int, theme: Meaning) -> Results[Structure]:
    """ "(a mat with) three white blocks in a row (on it)": a row of them."""
    counted = isinstance(theme, Noun) and theme.head != "patch" and theme.amount is not None and theme.amount.low > 1
    for phrase, end in p.standing(k, _SHAPES) if counted else ():
        span = (theme.span[0], p.span(k, end)[1])
        yield Structure(kind=_SHAPES[phrase], members=theme, span=span, cost=1), end  # dearer than "these are stacked"


_SIDES = frozenset({"left", "right", "front", "behind"})


def beside_word(p: Parser, k: int) -> Results[Loc]:
    """ "(write CAT) behind DOG": beside another word."""
    for (name, mods), j in relation(p, k):
        text = literal(p, j) if name in _SIDES and j < p.end and p.tokens[j].kind != "quote" else None
        if text is not None and len(text) > 1 and text.isalpha():
            word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
            yield Loc(rel=name, landmark=word, mods=mods, span=p.span(k, j + 1)), j + 1
