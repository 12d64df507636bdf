"""How many there are, said afterwards: "put the red blocks in a row. There are four of them"."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

from rpg.language.meaning import Amount, Chain, Clause, Meaning, Noun, Pronoun, Traits, parts_of
from rpg.passes.schema.resolve.things.world import refuse

_THEM = frozenset({"them", "they", "these", "those"})


def counted_later(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences with such numbers where the blocks are named."""
    found = list(chains)
    for n, chain in enumerate(chains):
        for clause in chain.clauses:
            if (many := _number(clause)) is None:
                continue
            before = [*found[:n], replace(found[n], clauses=found[n].clauses[: _at(found[n], clause)])]
            lots = {x: None for c in before for x in parts_of(c) if isinstance(x, Noun) and _open(x)}
            if len({(x.traits, x.head) for x in lots}) != 1:
                raise refuse("ambiguous", "it is not clear of which blocks so many are there", clause.span,
                             "say for example 'the four red blocks'")  # fmt: skip
            lot = next(iter(lots))
            rest = tuple((c, x) for c, x in zip(found[n].clauses, found[n].links, strict=True) if c != clause)
            found[n] = replace(found[n], clauses=tuple(c for c, _ in rest), links=tuple(x for _, x in rest))
            told = replace(lot, amount=many, det="bare" if lot.det == "some" else lot.det)
            found = [put(c, lot, told) for c in found]
    kept = [n for n, chain in enumerate(found) if chain.clauses]
    return [links[n] for n in kept], tuple(found[n] for n in kept)


def _at(chain: Chain, clause: Meaning) -> int:
    return chain.clauses.index(clause) if clause in chain.clauses else len(chain.clauses)


def _number(clause: Meaning) -> Amount | None:
    """The number in "there are four (of them)"."""
    theme = clause.theme if isinstance(clause, Clause) and clause.verb == "exist" and clause.mode == "given" else None
    if not isinstance(theme, Noun) or theme.amount is None or theme.traits != Traits() or theme.head != "any":
        return None
    if theme.amount.low != theme.amount.high or (isinstance(clause, Clause) and clause.adjuncts):
        return None
    them = isinstance(theme.part_of, Pronoun) and theme.part_of.word in _THEM
    return Amount(theme.amount.low, theme.amount.low) if them or theme.part_of is None else None


def _open(noun: Noun) -> bool:
    """Blocks of which it is not said how many they are."""
    looks = noun.traits.colors or noun.traits.kind or noun.traits.size or noun.traits.edge
    plain = noun.head in ("block", "any") and noun.plural and noun.amount is None and noun.part_of is None
    listed = len(noun.traits.colors) > 1 or noun.traits.labels or noun.traits.extra
    return plain and bool(looks) and not listed and noun.det in ("the", "all", "bare", "some")


def put(meaning: Any, old: Meaning, new: Meaning) -> Any:
    """`meaning` with `new` for `old`."""
    if meaning == old:
        return new
    if isinstance(meaning, tuple) and not isinstance(meaning, Amount):
        return tuple(put(item, old, new) for item in meaning)
    if is_dataclass(meaning) and isinstance(meaning, Meaning):
        told = {f.name: getattr(meaning, f.name) for f in fields(meaning)}
        changed = {name: put(value, old, new) for name, value in told.items() if isinstance(value, Meaning | tuple)}
        changed = {name: value for name, value in changed.items() if value != told[name]}
        return replace(meaning, **changed) if changed else meaning
    return meaning
