"""What a later clause says of the parts of a structure belongs to the clause that builds it."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.meaning import Absolute, Chain, Clause, Coord, Into, Meaning, OrderBy, Structure

_LINES = ("stack", "arrange")


def hoisted(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with "the top block is red" said where the tower is built; sentences that say no more are gone."""
    found: list[list[tuple[str, Meaning]]] = []
    for chain in chains:
        kept: list[tuple[str, Meaning]] = []
        found.append(kept)
        for link, clause in zip(chain.links, chain.clauses, strict=True):
            if not isinstance(clause, Clause):
                kept.append((link, clause))
                continue
            told = clause.verb == "part" and link != "then"
            host = _host(found, _of_wholes(clause)) if told else None
            if told and host is None and _of_lines(clause):
                host = _host(found, True)
            if host is None:
                kept.append((link, clause))
                continue
            line, place, builder = host
            built = replace(builder, adjuncts=(*builder.adjuncts, *clause.adjuncts))
            found[line][place] = (found[line][place][0], built)
    left = [n for n, kept in enumerate(found) if kept]
    return [links[n] for n in left], tuple(
        replace(chains[n], clauses=tuple(c for _, c in found[n]), links=tuple(link for link, _ in found[n]))
        for n in left
    )


def _of_wholes(clause: Clause) -> bool:
    """ "the left tower is red": of one of several structures."""
    parts = [x for a in clause.adjuncts for x in (a.items if isinstance(a, Coord) else (a,))]
    if all(isinstance(x, OrderBy) and x.by == "each" for x in parts):
        return True
    return all(isinstance(x, Absolute) and getattr(x.adjuncts[0], "unit", "") == "whole" for x in parts)


def _of_lines(clause: Clause) -> bool:
    """ "The far row is red": of one of several rows, where no grid was built."""
    parts = [x for a in clause.adjuncts for x in (a.items if isinstance(a, Coord) else (a,))]
    return all(isinstance(x, Absolute) and getattr(x.adjuncts[0], "unit", "") in ("row", "column") for x in parts)


def _host(found: list[list[tuple[str, Meaning]]], several: bool) -> tuple[int, int, Clause] | None:
    """Where the structure was built that is spoken of: the clause before, if it builds a single one (or several)."""
    for line in range(len(found) - 1, -1, -1):
        for place in range(len(found[line]) - 1, -1, -1):
            clause = found[line][place][1]
            if not isinstance(clause, Clause):
                return None
            if clause.verb == "exist" and clause.mode == "given":
                continue
            return (line, place, clause) if _builds(clause, several) else None
    return None


def _builds(clause: Clause, several: bool) -> bool:
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    if isinstance(clause.theme, Structure):
        shapes.append(clause.theme)
    if clause.negated or clause.mode == "start" or len(shapes) > 1:
        return False
    if not shapes:
        return clause.verb in _LINES and not several
    return isinstance(shapes[0], Structure) and shapes[0].plural == several
