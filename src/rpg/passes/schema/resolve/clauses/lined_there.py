"""Blocks that are told by the line they are in: "stack the three blocks that are in the row"."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Loc, Meaning, Noun, Structure, replace

_LINES = frozenset({"row", "stack", "line", "column"})


def lined_there(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences behind one that says that these blocks are there as that line, if the first is told of such."""
    first = chains[0].clauses[0]
    theme = first.theme if isinstance(first, Clause) and first.mode == "command" and not first.negated else None
    line = _line_of(theme)
    if line is None or not isinstance(theme, Noun) or not isinstance(first, Clause):
        return links, chains
    members = replace(theme, conditions=(), det="bare", span=theme.span)
    there = replace(line, det="a", amount=Amount(1, 1), members=members)
    given = Clause(verb="exist", mode="given", theme=there, span=theme.span)
    rest = replace(first, theme=replace(theme, det="the", conditions=()))
    if first.verb in ("pick", "use") and not first.adjuncts and len(chains[0].clauses) > 1:
        more = replace(chains[0], clauses=chains[0].clauses[1:], links=("and", *chains[0].links[2:]))
    else:
        more = replace(chains[0], clauses=(rest, *chains[0].clauses[1:]))
    return ["and", *links], (Chain(clauses=(given,), links=("and",), span=theme.span), more, *chains[1:])


def _line_of(theme: Meaning | None) -> Structure | None:
    """The line that some blocks are said to be in, of which nothing else is told."""
    if not isinstance(theme, Noun) or theme.head == "patch" or theme.det not in ("the", "all") or not theme.plural:
        return None
    if len(theme.conditions) != 1 or theme.part_of is not None:
        return None
    (where,) = theme.conditions
    line = where.landmark if isinstance(where, Loc) and where.rel == "in" and not where.negated else None
    told = isinstance(line, Structure) and (line.members or line.details or line.sizes or line.dims or line.plural)
    return line if isinstance(line, Structure) and line.kind in _LINES and not told else None
