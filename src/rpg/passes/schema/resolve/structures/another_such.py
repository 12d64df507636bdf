"""Structures of which only that is said in which they differ from one before: "a tower of three red blocks here and one
of two there", "and another one there"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.structures.each_placed import each_placed
from rpg.passes.schema.resolve.structures.of_its_own import of_its_own
from rpg.passes.schema.resolve.structures.the_same_again import the_same_again
from rpg.passes.schema.resolve.things.counted import put
from rpg.passes.schema.resolve.things.world import refuse

_LINES = ("stack", "row", "line", "column")


def another_such(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with each of them told in full."""
    chains = the_same_again(chains)
    if sum(isinstance(part, Structure) for chain in chains for part in parts_of(chain)) > 1:
        chains = _of_such_blocks(chains)
    chains = of_its_own(chains)
    return each_placed(tuple(_with_others(_on_both_sides(chain)) for chain in chains))


_ACROSS = {"across": ("left", "right"), "deep": ("front", "behind")}


def _on_both_sides(chain: Chain) -> Chain:
    """ "To the left and to the right of a blue block there is a tower of two": a tower on each of these sides."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        shape = said.theme if isinstance(said, Clause) else None
        sides = _two_sides(said) if isinstance(said, Clause) and not said.negated else ()
        links.append(link)
        if not sides or not isinstance(said, Clause) or not isinstance(shape, Structure) or not _is_built(shape):
            clauses.append(said)
            continue
        one, other = sides
        mark = other.landmark
        if isinstance(mark, Noun):
            other = replace(other, landmark=replace(mark, det="the", amount=None))
        clauses += [replace(said, adjuncts=(one,)), replace(said, theme=_copy(shape, shape), adjuncts=(other,))]
        links.append("and")
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _two_sides(said: Clause) -> tuple[Loc, ...]:
    """The two places of a clause that tells both sides of one thing; none where it does not."""
    place = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    if isinstance(place, Loc) and place.rel == "flank" and "each" not in place.mods and not place.negated:
        rels = next((_ACROSS[mod] for mod in place.mods if mod in _ACROSS), ())
        return tuple(replace(place, rel=rel, mods=()) for rel in rels)
    items = place.items if isinstance(place, Coord) and place.op == "and" else ()
    both = tuple(x for x in items if isinstance(x, Loc) and not x.negated and isinstance(x.landmark, Noun))
    marks = {x.landmark.span for x in both if x.landmark is not None}
    return both if len(both) == len(items) == 2 and len(marks) == 1 and {x.rel for x in both} <= _SIDES else ()


def _of_such_blocks(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "A tower of three red blocks and a tower of two": of two red ones. In another sentence that is not clear."""
    told = [said for chain in chains for said in chain.clauses if isinstance(said, Clause)]
    there = (said for said in told if said.verb == "exist" or said.mode in ("start", "given"))
    if any(not isinstance(said.theme, Structure) for said in there):
        return chains  # it is of the blocks that there are
    model: tuple[int, Structure] | None = None
    found: list[Chain] = []
    for n, chain in enumerate(chains):
        clauses = list(chain.clauses)
        for at, said in enumerate(clauses):
            if not isinstance(said, Clause) or _of_what_blocks(said):
                continue
            shapes = [part for part in parts_of(said) if isinstance(part, Structure)]
            for shape in sorted(shapes, key=lambda x: x.span):
                if not _plain(shape):
                    continue
                if isinstance(shape.members, Noun) and _of_one_look(shape.members):
                    model = n, shape
                elif model is not None and model[1].kind == shape.kind and (many := _number(shape)):
                    _in_one_breath(model[0] == n, shape)
                    such = replace(model[1].members, amount=many, span=shape.span)
                    clauses[at] = put(clauses[at], shape, replace(shape, members=such, sizes=()))
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def _of_what_blocks(said: Clause) -> bool:
    """Whether a clause itself may say of which blocks it speaks: "... from these", "a row of three, those yellow"."""
    items = said.theme.items if isinstance(said.theme, Coord) else ()
    listed = any(isinstance(x, Noun) and x.head == "any" for x in items)
    return listed or any(isinstance(part, Using) for part in said.adjuncts)


def _in_one_breath(so: bool, shape: Structure) -> None:
    if not so:
        raise refuse("ambiguous", "of blocks that look like those before, or of any?", shape.span,
                     "say what its blocks look like")  # fmt: skip


def _plain(shape: Structure) -> bool:
    """A single line of which no more is told than its blocks, or their number."""
    single = shape.kind in _LINES and not shape.plural and shape.det in ("a", "another")
    return single and not (shape.details or shape.letter or shape.dims) and shape.traits == Traits()


def _of_one_look(members: Noun) -> bool:
    """ "three red blocks": a number of blocks of one colour, and no more."""
    plain = members.det == "bare" and members.part_of is None and not members.conditions and members.head == "block"
    one = plain and members.amount is not None and members.amount.low == members.amount.high
    return one and len(members.traits.colors) == 1 and members.traits == Traits(colors=members.traits.colors)


def _number(shape: Structure) -> Amount | None:
    """How many blocks a structure has of which no more is said; None where something is."""
    if isinstance(shape.members, Noun):
        plain = shape.members.traits == Traits() and shape.members.det == "bare" and not shape.members.conditions
        return shape.members.amount if plain and not shape.sizes and shape.members.part_of is None else None
    size = shape.sizes[0] if len(shape.sizes) == 1 and shape.members is None else None
    return size.amount if size is not None and size.what in ("size", "high", "long") else None


def _with_others(chain: Chain) -> Chain:
    """ "... on the green mat and another one on the yellow mat", "... on its left and another on its right"."""
    clauses = [_further_one(said) if isinstance(said, Clause) else said for said in chain.clauses]
    for n in range(1, len(clauses)):
        before, said = clauses[n - 1], clauses[n]
        told = isinstance(before, Clause) and isinstance(said, Clause) and chain.links[n] in ("and", "while")
        if told and isinstance(before, Clause) and isinstance(said, Clause) and before.mode == said.mode:
            clauses[n] = _once_more(said, before)
    return replace(chain, clauses=tuple(clauses))


def _further_one(said: Clause) -> Clause:
    for a in said.adjuncts:
        items = a.items if isinstance(a, Coord) and a.op == "absolutes" else ()
        parts = [x for x in items if isinstance(x, Absolute)]
        for one, two in pairwise(parts):
            if isinstance(one.theme, Structure) and _is_built(one.theme) and _another(two.theme) and _alike(one, two):
                said = put(said, two, replace(two, theme=_copy(one.theme, two.theme)))
    return said


def _once_more(said: Clause, before: Clause) -> Clause:
    """What a clause says of another one, told of the structure of the clause before."""
    told = [x for x in before.adjuncts if isinstance(x, Absolute)]
    one = told[-1] if told else before
    shape, theme = one.theme, said.theme
    if not isinstance(shape, Structure) or theme is None or not _is_built(shape) or said.negated:
        return said
    again = Structure(kind=shape.kind, det="the", traits=Traits(scheme="same"), span=theme.span)
    if not (_another(theme) or replace(theme, cost=0) == again) or not _alike(one, said):
        return said
    place = said.adjuncts[0]
    it = isinstance(place, Loc) and isinstance(place.landmark, Pronoun) and isinstance(before.theme, Noun)
    if told and it and isinstance(before.theme, Noun):  # "red with a tower on its left and another on its right"
        place = replace(place, landmark=replace(before.theme, det="the", amount=None))
    return replace(said, verb="build", theme=_copy(shape, theme), adjuncts=(place,))


def _is_built(shape: Structure) -> bool:
    told = bool(shape.members or shape.sizes or shape.traits.colors)
    return not shape.plural and shape.det in ("a", "another") and told


def _another(theme: Meaning) -> bool:
    if isinstance(theme, Pronoun):
        return theme.word == "another"
    plain = isinstance(theme, Noun) and theme.head == "any" and theme.part_of is None and not theme.conditions
    return plain and isinstance(theme, Noun) and (theme.det, theme.traits) == ("another", Traits())


def _copy(shape: Structure, said: Meaning) -> Structure:
    return replace(shape, det="another", span=said.span)


_SIDES = frozenset({"left", "right", "front", "behind"})


def _alike(one: Clause | Absolute, other: Clause | Absolute) -> bool:
    """Whether two places are told in the same way: both on a patch, or both on a side of something."""
    if len(one.adjuncts) != 1 or len(other.adjuncts) != 1:
        return False
    first, second = one.adjuncts[0], other.adjuncts[0]
    if not isinstance(first, Loc) or not isinstance(second, Loc) or first.negated or second.negated:
        return False
    marks = (first.landmark, second.landmark)
    if {first.rel, second.rel} <= _SIDES:
        return None not in marks
    return first.rel == second.rel == "on" and any(isinstance(x, Noun) and x.head == "patch" for x in marks)
