"""What a list behind a structure tells, and what is taken first to be used: clauses that say the same more plainly."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    Traits,
    Using,
    replace,
)
from rpg.passes.schema.resolve.clauses.among_all import among_all
from rpg.passes.schema.resolve.structures.another_such import another_such
from rpg.passes.schema.resolve.structures.by_looks import by_looks
from rpg.passes.schema.resolve.structures.capped import capped
from rpg.passes.schema.resolve.structures.one_here_one_there import one_here_one_there
from rpg.passes.schema.resolve.structures.one_place_told import one_place_told
from rpg.passes.schema.resolve.structures.stacked_groups import stacked_groups
from rpg.passes.schema.resolve.things.lots_open import lots_open
from rpg.passes.schema.resolve.things.named_behind import named_behind
from rpg.passes.schema.resolve.things.others_open import others_left_open
from rpg.passes.schema.resolve.things.shared_out import shared_out
from rpg.passes.schema.resolve.things.spare import left_out_first, without_spare
from rpg.passes.schema.resolve.things.world import Scene

_TAKES = frozenset({"pick", "use"})


def all_plainly(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences with such clauses, with every structure told in full, and every lot counted."""
    scene.others_open = others_left_open(chains)
    chains = among_all(lots_open(shared_out(named_behind(chains, scene), scene), scene))
    chains = one_place_told(tuple(left_out_first(without_spare(plainly(chain))) for chain in chains), scene)
    return another_such(chains)


def plainly(chain: Chain) -> Chain:
    """The sentence with such clauses."""
    return by_looks(_another(_taken(_listed_apart(_no_block(stacked_groups(capped(one_here_one_there(chain))))))))


def _no_block(chain: Chain) -> Chain:
    """ "Never put a block on the green one": not any, rather than one more block that is not put there."""
    told = tuple(
        replace(c, theme=replace(c.theme, det="any", amount=None))
        if isinstance(c, Clause) and c.negated and isinstance(c.theme, Noun) and _some_block(c.theme)
        else c
        for c in chain.clauses
    )
    return replace(chain, clauses=told) if told != chain.clauses else chain


def _some_block(noun: Noun) -> bool:
    plain = noun.traits == Traits() and not noun.conditions and noun.part_of is None
    return noun.head == "block" and noun.det == "a" and noun.amount == Amount(1, 1) and plain


def _another(chain: Chain) -> Chain:
    """ "A yellow block goes on the red one and another one on the blue one", "... and one on the blue one": another
    yellow block; also of the ends of a line, "with a blue block at the left end and one at the right end"."""
    clauses = [_another_inside(clause) for clause in chain.clauses]
    for n in range(len(clauses) - 1):
        first, second = clauses[n : n + 2]
        if isinstance(first, Clause) and isinstance(second, Clause) and first.verb == second.verb and _in_front(second):
            clauses[n + 1] = replace(second, theme=_one_more(first.theme, second.theme))
    return replace(chain, clauses=tuple(clauses))


def _another_inside(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or not any(isinstance(x, Coord) and x.op == "absolutes" for x in clause.adjuncts):
        return clause
    told: list[Meaning] = []
    for part in clause.adjuncts:
        items = list(part.items) if isinstance(part, Coord) and part.op == "absolutes" else []
        for n in range(len(items) - 1):
            first, second = items[n : n + 2]
            if isinstance(first, Absolute) and isinstance(second, Absolute):
                items[n + 1] = replace(second, theme=_one_more(first.theme, second.theme) or second.theme)
        told.append(replace(part, items=tuple(items)) if items else part)
    return replace(clause, adjuncts=tuple(told))


def _in_front(clause: Clause) -> bool:
    """Whether who it is stands before what is said of it: "one on the mat", and not "not on the blue one"."""
    return clause.theme is not None and all(clause.theme.span[0] < place.span[0] for place in clause.adjuncts)


def _one_more(one: Meaning | None, two: Meaning | None) -> Meaning | None:
    """The second, as a further block that looks like the first, where it is "one", or "another one"."""
    if not isinstance(one, Noun) or one.head != "block" or not (one.traits.colors or one.traits.labels):
        return two
    single = one.det in ("a", "another") or (one.det == "bare" and one.amount == Amount(1, 1))
    bare = isinstance(two, Noun) and two.head == "any" and two.det in ("a", "bare", "another") and not two.plural
    bare = bare and isinstance(two, Noun) and two.traits == Traits() and two.amount in (None, Amount(1, 1))
    bare = bare and isinstance(two, Noun) and two.part_of is None and not two.conditions
    further = bare or (isinstance(two, Pronoun) and two.word == "one")
    return replace(one, det="another", span=two.span) if single and further and two is not None else two


def _taken(chain: Chain) -> Chain:
    """ "Take two of the four red blocks and stack them": stack two of the four."""
    for n, (first, second) in enumerate(pairwise(chain.clauses)):
        if not isinstance(first, Clause) or not isinstance(second, Clause):
            continue
        if _only_moved(first, second) and chain.links[n + 1] in ("and", "then"):
            clauses = (*chain.clauses[:n], replace(first, verb="pick"), *chain.clauses[n + 1 :])
            return replace(chain, clauses=clauses)
        if first.verb not in _TAKES:
            continue
        if not isinstance(first.theme, Noun) or not isinstance(second.theme, Pronoun) or second.negated:
            continue
        some = first.theme.part_of is not None and first.theme.det == "some" and second.theme.word == "them"
        some = some or (first.theme.det == "any" and second.theme.word == "it")
        if some and not first.adjuncts and not first.negated and chain.links[n + 1] in ("and", "then"):
            told = replace(second, theme=first.theme)
            clauses = (*chain.clauses[:n], told, *chain.clauses[n + 2 :])
            return replace(chain, clauses=clauses, links=(*chain.links[: n + 1], *chain.links[n + 2 :]))
    return chain


def _only_moved(first: Clause, second: Clause) -> bool:
    """ "Remove the top block and put it on the mat": where it goes is said by the second."""
    it = second.theme if isinstance(second.theme, Pronoun) and second.verb == "place" else None
    source = first.adjuncts[0] if len(first.adjuncts) == 1 else None
    plain = not first.adjuncts or (isinstance(source, Using) and source.lead == "from")
    taken = first.lemma == "remove" and plain and isinstance(first.theme, Noun) and first.theme.head != "patch"
    return taken and it is not None and it.word in ("it", "them") and not (first.negated or second.negated)


def _listed_apart(chain: Chain) -> Chain:
    """ "All but the red one in a row: red, green and blue": a list that names what is left out tells what there is."""
    for n, clause in enumerate(chain.clauses):
        if not isinstance(clause, Clause) or not isinstance(clause.theme, Coord) or clause.theme.op not in _APART:
            continue
        out = clause.theme.items[-1]
        for index, into in enumerate(clause.adjuncts):
            if not isinstance(into, Into) or not isinstance(shape := into.structure, Structure):
                continue
            if not isinstance(out, Noun) or out.amount is not None:
                continue
            lists = [d for d in shape.details if isinstance(d, OrderBy) and d.by == "named" and d.first is None]
            if len(lists) != 1 or not any(_same(out, item) for item in lists[0].items):
                continue
            bare = replace(shape, details=tuple(d for d in shape.details if d is not lists[0]))
            adjuncts = list(clause.adjuncts)
            adjuncts[index] = replace(into, structure=bare)
            items = tuple(_one(item) for item in lists[0].items)
            whole = Coord(op="and", items=items, span=lists[0].span)
            there = Clause(verb="exist", lemma="tally", theme=whole, mode="given", span=lists[0].span)
            told = replace(clause, adjuncts=tuple(adjuncts))
            clauses = (*chain.clauses[:n], there, told, *chain.clauses[n + 1 :])
            return replace(chain, clauses=clauses, links=(*chain.links[:n], "and", *chain.links[n:]))
    return chain


_APART = ("except", "besides")


def _same(out: Noun, item: Meaning) -> bool:
    """Whether this is of the look that was left out."""
    look = isinstance(item, Noun) and (item.traits.colors, item.traits.labels)
    return look == (out.traits.colors, out.traits.labels)


def _one(item: Meaning) -> Meaning:
    """ "red" in a list of what there is: one red block."""
    if isinstance(item, Noun) and item.amount is None and len(item.traits.colors) < 2:
        return replace(item, head="block", amount=Amount(1, 1)) if not item.traits.labels else item
    return item
