"""How many there are, said afterwards: "put the red blocks in a row. There are four of them"."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_THEM = frozenset({"them", "they", "these", "those"})


def counted_later(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences with such numbers where the blocks are named."""
    links, chains = _counted_there(links, chains)
    found = list(chains)
    for n, chain in enumerate(chains):
        for clause in chain.clauses:
            if (each := _in_turn(clause)) and (told := _respectively(found, n, clause, each)) is not None:
                found = told
                continue
            if (many := _number(clause)) is None:
                continue
            before = [*found[:n], replace(found[n], clauses=found[n].clauses[: _at(found[n], clause)])]
            alone = not any(isinstance(x, Noun) and _told_by_look(x) for c in found for x in parts_of(c))
            lots = {x: None for c in before for x in parts_of(c) if isinstance(x, Noun) and _open(x, alone)}
            shapes = any(isinstance(x, Structure) and x.plural for x in parts_of(before[-1]))
            if not lots and not shapes and (there := _of_one_look(before, clause, many)) is not None:
                kept_ = tuple(there if c is clause else c for c in found[n].clauses)
                found[n] = replace(found[n], clauses=kept_)
                continue
            if len({(x.traits, x.head) for x in lots}) != 1 or shapes:
                raise refuse("ambiguous", "it is not clear of which blocks so many are there", clause.span,
                             "say for example 'the four red blocks'")  # fmt: skip
            lot = next(iter(lots))
            found[n] = _without(found[n], clause)
            found = [put(c, lot, _so_many(lot, many)) for c in found]
    kept = [n for n, chain in enumerate(found) if chain.clauses]
    return [links[n] for n in kept], tuple(found[n] for n in kept)


def _of_one_look(before: list[Chain], clause: Meaning, many: Amount) -> Clause | None:
    """ "One purple block in each corner. We have four of them": so many purple blocks, the only ones spoken of."""
    told = [x for c in before for x in parts_of(c) if isinstance(x, Noun) and x.head in ("block", "any")]
    one = told[0] if len(told) == 1 else None
    if one is None or one.plural or one.det not in ("a", "bare") or one.amount != Amount(1, 1) or not one.traits.colors:
        return None
    theme = Noun(head="block", amount=many, plural=True, traits=one.traits, span=clause.span)
    return Clause(verb="exist", theme=theme, mode="given", span=clause.span)


def _counted_there(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """ "(Every blue block) on a red block (3)": there are three of these."""
    for one in {x: None for chain in chains for x in parts_of(chain) if isinstance(x, Noun) and x.det == "a"}:
        if not isinstance(one.part_of, Noun) or one.part_of.det != "bare" or one.amount != Amount(1, 1):
            continue
        there = Clause(verb="exist", theme=one.part_of, mode="given", span=one.span)
        chains = tuple(put(chain, one, replace(one, part_of=None)) for chain in chains)
        chains = (Chain(clauses=(there,), links=("and",), span=one.span), *chains)
        links = ["and", *links]
    return links, chains


def _without(chain: Chain, clause: Meaning) -> Chain:
    rest = tuple((c, x) for c, x in zip(chain.clauses, chain.links, strict=True) if c != clause)
    return replace(chain, clauses=tuple(c for c, _ in rest), links=tuple(x for _, x in rest))


def _so_many(lot: Noun, many: Amount) -> Noun:
    if lot.det == "each":
        whole = replace(lot, det="the", amount=many, plural=True)
        return Noun(head="any", det="each", part_of=whole, span=lot.span)
    return replace(lot, amount=many, det="bare" if lot.det == "some" else lot.det)


def _in_turn(clause: Meaning) -> tuple[int, ...]:
    """The numbers in "(white ones in one heap, black ones in another,) 3 and 3"."""
    theme = clause.theme if isinstance(clause, Clause) and clause.verb == "exist" and clause.mode == "given" else None
    if not isinstance(clause, Clause) or clause.adjuncts:
        return ()
    labels = theme.traits.labels if isinstance(theme, Noun) else ()
    if isinstance(theme, Noun) and theme.det == "bare" and theme.amount is None:
        digits = theme.traits == Traits(labels=labels) and all(x.isdigit() for x in labels)
        return tuple(map(int, labels)) if digits else ()
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else ()
    bare = all(isinstance(x, Noun) and x.head == "any" and x.traits == Traits() and x.part_of is None for x in items)
    amounts = [x.amount for x in items if isinstance(x, Noun) and x.amount is not None] if bare else []
    return tuple(x.low for x in amounts if x.low == x.high) if len(amounts) == len(items) else ()


def _respectively(found: list[Chain], n: int, clause: Meaning, each: tuple[int, ...]) -> list[Chain] | None:
    """The sentences with a number for each of the lots whose number is open, in the order in which they are named."""
    before = [*found[:n], replace(found[n], clauses=found[n].clauses[: _at(found[n], clause)])]
    nouns = [x for c in before for x in parts_of(c) if isinstance(x, Noun)]
    lots = list({(x.traits, x.head): x for x in nouns if _open(x)}.values())
    if len(each) < 2 or len(lots) != len(each) or any(x.traits.labels for x in nouns) or 0 in each:
        return None
    found = [*found[:n], _without(found[n], clause), *found[n + 1 :]]
    for lot, many in zip(lots, each, strict=True):
        found = [put(c, lot, _so_many(lot, Amount(many, many))) for c in found]
    return found


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


def _open(noun: Noun, alone: bool = False) -> bool:
    """Blocks of which it is not said how many they are. `alone`: nothing is said of how any block looks."""
    looks = noun.traits.colors or noun.traits.kind or noun.traits.size or noun.traits.edge
    looks = looks or (alone and noun.head == "block" and noun.traits == Traits())
    many = noun.plural or (noun.det == "each" and bool(noun.traits.colors))
    plain = noun.head in ("block", "any") and many and noun.amount is None and noun.part_of is None
    listed = len(noun.traits.colors) > 1 or noun.traits.labels or noun.traits.extra
    return plain and bool(looks) and not listed and noun.det in ("the", "all", "bare", "some", "each")


def _told_by_look(noun: Noun) -> bool:
    return noun.head != "patch" and bool(noun.traits.colors or noun.traits.labels)


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
