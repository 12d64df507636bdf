""" "Stack the four blocks. Leave out the red one": one of the four, told in a sentence of its own."""

from __future__ import annotations

from typing import TypeGuard

from rpg.language.meaning import Chain, Clause, Coord, Meaning, Noun, Traits, replace


def left_out_behind(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with what is left out of so many blocks as an exception where these are spoken of."""
    told: list[Chain] = []
    linked: list[str] = []
    for link, chain in zip(links, chains, strict=True):
        first = chain.clauses[0] if len(chain.clauses) == 1 else None
        whole = _without(told[-1], first) if told and link == "and" else None
        if whole is not None:
            told[-1] = whole
        else:
            told.append(_in_one(chain))
            linked.append(link)
    return linked, tuple(told)


def _in_one(chain: Chain) -> Chain:
    """ "Put the five blocks in a row, but leave out the red one"."""
    if len(chain.clauses) < 2 or chain.links[-1] != "and":
        return chain
    before = replace(chain, clauses=chain.clauses[:-1], links=chain.links[:-1])
    return _without(before, chain.clauses[-1]) or chain


def _without(chain: Chain, left_out: Meaning | None) -> Chain | None:
    """The sentence, where its blocks are so many that are there, and one of them is left out."""
    clause = chain.clauses[-1]
    one = left_out.theme if isinstance(left_out, Clause) and _leaves_out(left_out) else None
    if not isinstance(one, Noun) or not isinstance(clause, Clause) or not _so_many(clause.theme):
        return None
    whole = Coord(op="except", items=(clause.theme, one), span=clause.theme.span)
    return replace(chain, clauses=(*chain.clauses[:-1], replace(clause, theme=whole)))


def _leaves_out(clause: Clause) -> bool:
    theme = clause.theme
    unused = clause.verb == "ignore" or (clause.verb == "use" and clause.negated)
    one = isinstance(theme, Noun) and theme.det == "the" and theme.traits != Traits() and theme.head != "patch"
    return unused and not clause.adjuncts and one


def _so_many(theme: Meaning | None) -> TypeGuard[Noun]:
    """ "The four blocks", "all the blocks"."""
    if not isinstance(theme, Noun) or theme.head != "block" or theme.traits != Traits() or not theme.plural:
        return False
    exact = theme.amount is None or theme.amount.low == theme.amount.high
    return exact and theme.part_of is None and theme.det in ("the", "all") and bool(theme.amount or theme.det == "all")
