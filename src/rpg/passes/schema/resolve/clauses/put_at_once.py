""" "First take red and put it on blue, then ...": what is taken up and where it is put are one step."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Manner, Meaning, Pronoun, replace

_PUTS = frozenset({"place", "stack"})
_IT = frozenset({"it", "them", "both", "both of them"})


def put_at_once(chain: Chain) -> Chain:
    """Where steps follow each other, what is taken up and put somewhere as the one step that it is."""
    if not _in_time(chain):
        return chain
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        before = clauses[-1] if clauses else None
        if isinstance(clause, Clause) and isinstance(before, Clause) and _puts_it(before, link, clause):
            clauses[-1] = replace(clause, theme=before.theme)
        else:
            clauses.append(clause)
            links.append(link)
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _in_time(chain: Chain) -> bool:
    """Whether anything is told of what comes before what."""
    timed = (a for c in chain.clauses if isinstance(c, Clause) for a in c.adjuncts if isinstance(a, Manner))
    return not {"then", "before", "after"}.isdisjoint(chain.links) or any(a.kind == "time" for a in timed)


def _puts_it(taken: Clause, link: str, clause: Clause) -> bool:
    bare = taken.verb == "pick" and not taken.adjuncts and not taken.negated and taken.theme is not None
    it = isinstance(clause.theme, Pronoun) and clause.theme.word in _IT
    return bare and link == "and" and clause.verb in _PUTS and it and not clause.negated
