"""Things done in turn: "Do it in this order: A on B, C on A.", "The sequence is: 1) red on blue 2) green on red"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.commands import IN_ORDER
from rpg.language.meaning import Chain, Clause, Loc, Meaning, replace
from rpg.language.tokens import Token


def announced(part: list[Token]) -> bool:
    """Whether a sentence says that what it tells, or what follows it, is done in turn."""
    return part[0].word in IN_ORDER.firsts and any(True for _ in IN_ORDER.matches(Parser(part), 0))


def heads(part: list[Token]) -> bool:
    """Whether it says no more than that."""
    return part[0].word in IN_ORDER.firsts and len(part) in IN_ORDER.matches(Parser(part), 0)


def in_turn(chain: Chain) -> Chain:
    """The clauses of a sentence one after the other, where each of them says what is done."""
    plain = set(chain.links) == {"and"} and len(chain.clauses) > 1 and all(map(_done, chain.clauses))
    return replace(chain, links=("and", *("then" for _ in chain.links[1:]))) if plain else chain


def _done(clause: Meaning) -> bool:
    on = isinstance(clause, Clause) and any(isinstance(a, Loc) and a.rel == "on" for a in clause.adjuncts)
    return isinstance(clause, Clause) and (clause.mode == "command" or (on and clause.mode == "goal"))
