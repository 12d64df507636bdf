"""What a later clause says of the parts of a structure belongs to the clause that builds it."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.meaning import Chain, Clause, Into, Structure

_LINES = ("stack", "arrange")


def hoisted(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with "the top block is red" said where the tower is built; sentences that say no more are gone."""
    found: list[list[tuple[str, Clause]]] = []
    for chain in chains:
        kept: list[tuple[str, Clause]] = []
        found.append(kept)
        for link, clause in zip(chain.links, chain.clauses, strict=True):
            assert isinstance(clause, Clause)
            host = _host(found) if clause.verb == "part" and link != "then" else None
            if host is None:
                kept.append((link, clause))
                continue
            line, place = host
            before = found[line][place]
            found[line][place] = (before[0], replace(before[1], adjuncts=(*before[1].adjuncts, *clause.adjuncts)))
    left = [n for n, kept in enumerate(found) if kept]
    return [links[n] for n in left], tuple(
        replace(chains[n], clauses=tuple(c for _, c in found[n]), links=tuple(link for link, _ in found[n]))
        for n in left
    )


def _host(found: list[list[tuple[str, Clause]]]) -> tuple[int, int] | None:
    """Where the structure was built that is spoken of: the clause before, if it builds a single one."""
    for line in range(len(found) - 1, -1, -1):
        for place in range(len(found[line]) - 1, -1, -1):
            clause = found[line][place][1]
            if clause.verb == "exist" and clause.mode == "given":
                continue
            return (line, place) if _builds_one(clause) else None
    return None


def _builds_one(clause: Clause) -> bool:
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    if isinstance(clause.theme, Structure):
        shapes.append(clause.theme)
    if clause.negated or clause.mode == "start" or len(shapes) > 1:
        return False
    if not shapes:
        return clause.verb in _LINES
    return isinstance(shapes[0], Structure) and not shapes[0].plural
