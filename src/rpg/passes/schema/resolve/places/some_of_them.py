"""Relations of some blocks of several to each other: "two of the three red blocks touch"."""

from __future__ import annotations

from itertools import combinations

from rpg.core.diagnostics import Span
from rpg.language.meaning import Loc
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj, negation
from rpg.passes.schema.resolve.orders.positions import looks
from rpg.passes.schema.resolve.places.mutual import reciprocal
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def to_each_other(theme: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms:
    """What a relation "to each other" says of the blocks, or of so many of them."""
    some = _among_some(theme, loc, scene, span)
    return some if some is not None else reciprocal(theme, loc, span, denied=loc.negated or scene.denying)


def _among_some(theme: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms | None:
    """So many of look-alikes are so related, and no others; None where it is said of all of them, or of none."""
    many = theme.quant
    if many is None or (many.low == 0 and many.high in (0, 1)) or len(theme.names) < 2:
        return None
    parting = loc.rel == "apart" or (loc.rel == "distance" and loc.high is None)
    if loc.negated or scene.denying or parting or many.low < 2 or theme.built:
        raise refuse("ambiguous", "is this said of every two of them, or of some?", span, "say 'every two of ...', "
                     "or name the blocks")  # fmt: skip
    if len({looks(scene.things[n]) for n in theme.names}) > 1:
        raise refuse("ambiguous", "it is not said which of the blocks are meant", span, "name the blocks")
    if many.high != many.low:
        lots = combinations(theme.names, many.low)
        return [disj([conj(reciprocal(Ref(names=lot), loc, span), span) for lot in lots], span)]
    chosen = theme.names[: many.low]
    others = (two for two in combinations(theme.names, 2) if not set(two) <= set(chosen))
    apart = negation([conj(reciprocal(Ref(names=two), loc, span), span) for two in others], span)
    return [*reciprocal(Ref(names=chosen), loc, span), *apart]
