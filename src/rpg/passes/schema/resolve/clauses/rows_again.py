"""Several lines of which nothing else is said, and some of them told behind: "two rows of three: ..., and a row of the
digits 1 and 2 in front of it"."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Chain, Clause, Structure, Traits, parts_of
from rpg.passes.schema.resolve.things.world import refuse


def check_lines_again(chains: tuple[Chain, ...]) -> None:
    """Refuse what is told of a line where it could be one of these.

    Raises:
        Refusal: "ambiguous".
    """
    for clause in (x for chain in chains for x in chain.clauses if isinstance(x, Clause)):
        lines = clause.theme
        if not isinstance(lines, Structure) or not lines.plural or lines.members or lines.traits != Traits():
            continue
        told = [x for a in clause.adjuncts if isinstance(a, Absolute) for x in parts_of(a.theme)]
        again = next((x for x in told if isinstance(x, Structure) and x.kind == lines.kind and not x.plural), None)
        if again is not None:
            raise refuse("ambiguous", f"this could be one of the {lines.kind}s, or a further one", again.span,
                         f"tell each {lines.kind} in a sentence of its own")  # fmt: skip
