"""Orders that stand for blocks, "line them up as follows: black, white, black", and those that a verb says."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Amount, At, Clause, Into, Meaning, Noun, OrderBy, Places, Pronoun, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Scene

_WORDS = ("them", "these", "those", "they", "all of them", "all of these")


def ahead(theme: Meaning, verb: str, spec: Spec, scene: Scene) -> bool:
    """Whether it stands for the blocks of the order behind it, for nothing was spoken of before."""
    if not isinstance(theme, Pronoun) or theme.word not in _WORDS or scene.things or scene.mentions:
        return False
    if verb == "stack" and (items := _one_by_one(spec.absolutes)):
        spec.orders.append(OrderBy(by="named", items=items, first="bottom", span=theme.span))
        spec.absolutes = []
    return any(o.items and o.by in ("given", "named") for o in spec.orders) and not spec.usings


_ORDERING = {"alphabetize": "label", "alternate": "alternating"}
"""Verbs that say in which order."""


def by_verb(clause: Clause, spec: Spec) -> None:
    """ "alternate red and blue blocks": the order that the verb says. "Each red on a blue": the blocks are towers."""
    if clause.lemma in _ORDERING and clause.theme is not None:
        spec.orders.append(OrderBy(by=_ORDERING[clause.lemma], span=clause.word or clause.span))
    if not spec.intos and not isinstance(clause.theme, Structure):
        upright = [o for o in spec.orders if o.by == "each" and o.first == "bottom"]
        spec.intos += [Into(structure=Structure(kind="stack", plural=True, span=o.span), span=o.span) for o in upright]


def _one_by_one(parts: list[Absolute]) -> tuple[Meaning, ...]:
    """ ": a brown one first, then a black one, then a white one on top": from the bottom up."""
    found: list[Meaning] = []
    for n, part in enumerate(parts):
        place = part.adjuncts[0] if len(part.adjuncts) == 1 else None
        one = isinstance(part.theme, Noun) and part.theme.amount in (None, Amount(1, 1)) and not part.theme.plural
        first = isinstance(place, At | Places) and place.side in ("first", "bottom") and place.index in (None, 1)
        after = isinstance(place, At) and place.side == "next"
        last = isinstance(place, At) and place.side == "top" and place.index is None and n == len(parts) - 1
        if not one or not (first if n == 0 else after or last):
            return ()
        found.append(part.theme)
    return tuple(found) if len(found) > 1 else ()
