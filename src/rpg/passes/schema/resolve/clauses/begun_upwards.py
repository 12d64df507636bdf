""" "Start: blue at the bottom, yellow on it, white on top": a tower of the start that is told block by block."""

from __future__ import annotations

from rpg.language.meaning import At, Chain, Clause, Loc, Meaning, Noun, OrderBy, Pronoun, Structure, Toward, replace


def begun_upwards(chain: Chain) -> Chain:
    """The sentence with the tower told as one, from the bottom up."""
    chain = replace(chain, clauses=tuple(map(_ends_on_top, chain.clauses)))
    run = 0
    while run < len(chain.clauses) and (run == 0 or chain.links[run] == "and"):
        below = chain.clauses[run - 1] if run else None
        if not _stands(chain.clauses[run], below):
            break
        run += 1
    told = [c for c in chain.clauses[:run] if isinstance(c, Clause)]
    tops = [n for n, c in enumerate(told) if _at(c) == "top"]
    if run < 2 or (tops and tops != [run - 1]):
        return chain
    span = (told[0].span[0], told[-1].span[1])
    items = tuple(c.theme for c in told if c.theme is not None)
    order = OrderBy(by="named", items=items, span=span)
    tower = Structure(kind="stack", details=(order,), span=span)
    up = Toward(first="bottom", axis="z", span=told[0].adjuncts[0].span)
    there = Clause(verb="exist", lemma="begun", theme=tower, adjuncts=(up,), mode="given", span=span)
    return replace(chain, clauses=(there, *chain.clauses[run:]), links=("and", *chain.links[run:]))


def _ends_on_top(clause: Meaning) -> Meaning:
    """ "There is a stack: green, blue, and orange on top": listed from the bottom up."""
    if not isinstance(clause, Clause) or (clause.verb, clause.mode) != ("exist", "given"):
        return clause
    tower = clause.theme
    listed = [x for x in tower.details if isinstance(x, OrderBy)] if isinstance(tower, Structure) else []
    named = len(listed) == 1 and listed[0].by == "named" and len(listed[0].items) > 1 and listed[0].first is None
    side = _at(clause)
    if not isinstance(tower, Structure) or tower.kind != "stack" or not named or side not in ("top", "bottom"):
        return clause
    first = "bottom" if side == "top" else "top"
    return replace(clause, adjuncts=(Toward(first=first, axis="z", span=clause.adjuncts[0].span),))


def _stands(clause: Meaning, below: Meaning | None) -> bool:
    """Whether a clause of the start says of one block that it is at the bottom, or on the one that was told before."""
    if not isinstance(clause, Clause) or (clause.verb, clause.mode, clause.negated) != ("be", "start", False):
        return False
    theme, place = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if not isinstance(theme, Noun) or theme.plural or len(theme.traits.colors) + len(theme.traits.labels) != 1:
        return False
    if not isinstance(below, Clause):
        return _at(clause) == "bottom"
    if isinstance(place, Loc):
        mark = place.landmark
        known = isinstance(mark, Noun) and isinstance(below.theme, Noun) and mark.traits == below.theme.traits
        it = isinstance(mark, Pronoun) and mark.word == "it"
        return place.rel == "on" and not place.negated and (known or it)
    return _at(clause) in ("middle", "top")


def _at(clause: Clause) -> str:
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    return place.side if isinstance(place, At) and place.index is None and not place.own else ""
