""" "There is a tower of four. Insert a red block below the top two.": into the tower, which then is higher by one."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Loc, Noun, Structure, parts_of
from rpg.passes.schema.resolve.things.world import refuse

_UPRIGHT = frozenset({"under", "above"})


def check_set_below(chains: tuple[Chain, ...]) -> None:
    """Refuse what goes below some blocks of a tower that is there, where nothing is said of the others."""
    there = False
    for clause in (part for chain in chains for part in chain.clauses if isinstance(part, Clause)):
        if clause.verb == "exist" or clause.mode in ("start", "given"):
            there = there or any(isinstance(x, Structure) and x.kind == "stack" for x in parts_of(clause))
            continue
        new = isinstance(clause.theme, Noun) and clause.theme.det in ("a", "another", "bare") and there
        for place in (a for a in clause.adjuncts if new and isinstance(a, Loc) and a.rel in _UPRIGHT and not a.negated):
            if isinstance(place.landmark, Noun) and not place.mods and _inside(clause, place, place.landmark):
                raise refuse("ambiguous", "into the tower, or anywhere there?", place.span,
                             "say 'directly below B', or name the two blocks, as in 'between A and B'")  # fmt: skip


def _inside(clause: Clause, place: Loc, mark: Noun) -> bool:
    """Whether this may be a place in the tower: "below the top two", "insert it below B", not below the bottom one."""
    end = (mark.traits.rank, place.rel)
    many = mark.amount is not None and mark.amount.low > 1 and end in (("top", "under"), ("bottom", "above"))
    return many or (clause.lemma == "insert" and end not in (("bottom", "under"), ("top", "above")))
