"""Towers that a command takes for granted: "take the top block off the tower", of which nobody told before."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from rpg.core.diagnostics import Refusal
from rpg.language.lexicon import COLOR
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Loc,
    Manner,
    Meaning,
    Noun,
    PartOf,
    Pronoun,
    Structure,
    That,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.changed_after import in_their_order
from rpg.passes.schema.resolve.clauses.lined_there import lined_there
from rpg.passes.schema.resolve.clauses.row_granted import Told, row_granted
from rpg.passes.schema.resolve.places.shifted import RELS
from rpg.passes.schema.resolve.things.world import refuse

T = TypeVar("T")

_USUAL = 3
"""So many blocks has a tower, or a row that moves as a whole, of which it is not said how many it has."""
_FURTHER = ("yellow", "orange", "purple", "cyan", "pink")
"""Colours for a block that is put on such a tower and of which no look is said."""
_PLACING = ("place", "use", "pick", "remove", "swap", "reverse", "turn", "keep")
_BUILDING = ("build", "stack", "sort", "spell", "exist")
_ENDS = ("top", "bottom")


def either_way(
    read: Callable[[list[str], tuple[Chain, ...], list[str]], T],
    links: list[str],
    chains: tuple[Chain, ...],
    notes: list[str],
    text: str,
) -> T:
    """What the sentences come to: where a tower or a row is taken for granted it is there, if that makes sense."""
    links, chains = lined_there(links, chains)
    chains = in_their_order(links, chains)
    granted = taken_for_granted(links, chains) or row_granted(links, chains, text)
    moved = _moves_a_part(chains)
    if granted is None and moved is not None:
        raise refuse("ambiguous", "a block that is moved out of this is no longer in it", moved.span,
                     "say how the blocks stand at the start, and where each of them is at the end")  # fmt: skip
    if granted is None:
        return read(links, chains, notes)
    there, told, more = granted
    try:
        return read(there, told, [*notes, *more])
    except Refusal as refusal:
        with suppress(Refusal):
            if moved is None:
                return read(links, chains, notes)
        raise refusal from None


def taken_for_granted(links: list[str], chains: tuple[Chain, ...]) -> Told | None:
    """The sentences behind one that says that the tower is there, with what is assumed of it; None where no tower is
    taken for granted, or it is told what it is."""
    clauses = tuple(clause for chain in chains for clause in chain.clauses)
    if both := _swapped_towers(clauses):
        there_are = (Clause(verb="exist", mode="given", theme=replace(x, det="a"), span=x.span) for x in both)
        begun = [Chain(clauses=(clause,), links=("and",), span=clause.span) for clause in there_are]
        return ["and", "and", *links], (*begun, *chains), ("the two towers are there at the start",)
    if not all(isinstance(c, Clause) and _is_done(c) and c.verb not in _BUILDING for c in clauses):
        return None
    changed = getattr(clauses[0], "verb", "") in ("reverse", "turn")
    meanwhile = ("without", *(("so",) if changed else ()))
    if any(isinstance(part, That) and part.kind not in meanwhile for part in parts_of(clauses)):
        return None  # "until there are four in the tower": what comes about is not there yet
    first = clauses[0]
    if not isinstance(first, Clause) or first.verb not in _PLACING or first.negated:
        return None
    whole = _whole(chains, first)
    if whole is None or _spoken_elsewhere(clauses, first, whole):
        return None
    what = "tower" if whole.kind == "stack" else "row"
    notes = [f"{'the' if whole.det == 'the' else 'a'} {what} is there at the start"]
    if whole.members is None:
        notes.append(f"how many blocks the {what} has is not said: {_USUAL}")
        whole = replace(whole, members=_blocks(whole, _USUAL), sizes=())
    there = replace(whole, det="a", amount=Amount(1, 1), traits=Traits(), sizes=())
    if whole.kind == "stack" and (top := _taken_alone(first, clauses)) is not None:
        there = replace(there, details=(top,))
        notes.append("the block that is taken off is the top one: the others are not to be moved")
    spot = _source(first)
    given = Clause(verb="exist", mode="given", theme=there, adjuncts=spot, span=there.span)
    if spot:
        moved = replace(first, adjuncts=tuple(x for x in first.adjuncts if not _from_patch(x)))
        chains = (replace(chains[0], clauses=(moved, *chains[0].clauses[1:])), *chains[1:])
    beside = _Beside(chains, notes)
    rest = tuple(replace(chain, clauses=tuple(map(beside.told, chain.clauses))) for chain in chains)
    return ["and", *links], (Chain(clauses=(given,), links=("and",), span=there.span), *rest), tuple(notes)


def _is_done(clause: Clause) -> bool:
    """ "Move the top block of the tower", "the top block of the tower moves", "must move"."""
    return clause.mode == "command" or (clause.verb == "place" and clause.lemma == "move")


def _swapped_towers(clauses: tuple[Meaning, ...]) -> tuple[Structure, ...]:
    """ "Swap the tower of two red blocks and the tower of two blue ones": both of them."""
    swap = clauses[0] if len(clauses) == 1 else None
    items = (
        swap.theme.items if isinstance(swap, Clause) and swap.verb == "swap" and isinstance(swap.theme, Coord) else ()
    )
    towers = tuple(x for x in items if isinstance(x, Structure) and x.kind == "stack" and x.det == "the")
    looks = {x.members.traits.colors for x in towers if isinstance(x.members, Noun) and x.members.amount}
    apart = len(towers) == len(looks) == len(items) and all(looks) and all(map(_plain, towers))
    return towers if apart and len(towers) == _PAIR else ()


_PAIR = 2
_OTHERS = frozenset({"the rest", "the others", "the other", "the other ones", "others", "everything else"})


def _taken_alone(first: Clause, clauses: tuple[Meaning, ...]) -> Absolute | None:
    """ "Take red off the tower and leave the rest as it is": red is on top of it, for under others it is not taken."""
    block, words = first.theme, {part.word for part in parts_of(clauses) if isinstance(part, Pronoun)}
    one = isinstance(block, Noun) and not block.plural and bool(block.traits.colors or block.traits.labels)
    others = any(isinstance(part, Noun) and part.det == "other" for part in parts_of(clauses))
    if not isinstance(block, Noun) or not one or not any(map(_is_off, first.adjuncts)):
        return None
    if not others and words.isdisjoint(_OTHERS):
        return None
    a_block = replace(block, det="a", head="block", amount=Amount(1, 1))
    return Absolute(theme=a_block, adjuncts=(At(side="top", span=block.span),), span=block.span)


def _source(first: Clause) -> tuple[Meaning, ...]:
    """Where the tower is at the start: "move it from the red patch to the blue one"."""
    if not isinstance(first.theme, Structure):
        return ()
    found = [x.members for x in first.adjuncts if isinstance(x, Using) and _from_patch(x)]
    return tuple(Loc(rel="on", landmark=patch, span=patch.span) for patch in found[:1])


def _from_patch(place: Meaning) -> bool:
    return isinstance(place, Using) and place.lead == "from" and getattr(place.members, "head", "") == "patch"


def _blocks(whole: Structure, many: int) -> Noun:
    marks = Traits(colors=whole.traits.colors)
    return Noun(head="block", amount=Amount(many, many), plural=True, traits=marks, span=whole.span)


def _whole(chains: tuple[Chain, ...], first: Clause) -> Structure | None:
    """The one tower that is spoken of as known, with as much as is told of it."""
    shapes = [part for chain in chains for part in parts_of(chain) if isinstance(part, Structure)]
    if not shapes:
        ends = [part for part in parts_of(first) if isinstance(part, Noun) and part.traits.rank in _ENDS]
        alone = [noun for noun in ends if noun.head != "patch" and noun.part_of is None]
        return Structure(kind="stack", span=ends[0].span) if ends and len(alone) == len(ends) else None
    kinds = ("stack", "row") if _is_shifted(first) else ("stack",)
    known = [shape for shape in shapes if shape.kind in kinds and shape.det == "the" and not shape.plural]
    mine = [part for part in parts_of(first) if isinstance(part, Structure)]
    if len(known) < len(shapes) or not mine or not all(map(_plain, shapes)):
        return None
    told = [shape for shape in map(_counted, shapes) if shape.members is not None or shape.traits.colors]
    return told[0] if told else mine[0] if len(told) < 2 else None


def _plain(shape: Structure) -> bool:
    rank = shape.traits.rank or shape.traits.size
    return not (rank or shape.dims or shape.details or shape.letter or shape.amount not in (None, Amount(1, 1)))


def _counted(shape: Structure) -> Structure:
    """ "the tower of three": of three blocks."""
    many = shape.size.low if shape.size is not None and shape.size.low == shape.size.high else 0
    members = shape.members
    if (
        members is not None
        and isinstance(members, Noun)
        and members == Noun(head="block", plural=True, span=members.span)
    ):
        members = None  # "the stack of blocks"
    if isinstance(members, Noun) and members.head == "any" and members.traits == Traits() and members.amount:
        members = replace(members, head="block")
    return replace(shape, members=members or (_blocks(shape, many) if many else None), sizes=())


def _spoken_elsewhere(clauses: tuple[Meaning, ...], first: Clause, whole: Structure) -> bool:
    """Whether what is said of the tower is how it is to be, or which blocks are to form it: "put the tower of two red
    blocks on the mat" builds it there."""
    taken_of = any(isinstance(part, Noun) and isinstance(part.part_of, Structure) for part in parts_of(clauses))
    taken_of = taken_of or first.verb in ("reverse", "turn", "swap") or any(map(_is_off, first.adjuncts))
    looks_told = bool(whole.traits.colors) or (whole.members is not None and not _mere_number(whole))
    if looks_told and not taken_of and not _is_shifted(first):
        return True
    together = any(isinstance(x, Loc) and getattr(x.landmark, "word", "") == "each other" for x in first.adjuncts)
    if together or any(isinstance(part, Manner) and part.kind == "time" for part in first.adjuncts):
        return True  # "put the tower back together": it is not there yet
    looks = {part.traits for part in parts_of(clauses) if isinstance(part, Noun) and part.head != "patch"
             and part.det == "the" and (part.traits.colors or part.traits.labels)}  # fmt: skip
    looks -= {part.traits for part in parts_of(whole) if isinstance(part, Noun)}
    off = any(map(_is_off, parts_of(clauses)))
    lowest = isinstance(first.theme, Noun) and first.theme.traits.rank == "bottom"
    swapped = any(isinstance(clause, Clause) and clause.verb == "swap" for clause in clauses)
    return (len(looks) > 1 or lowest) if off else bool(looks) and swapped  # are these of the tower, or beside it?


def _moves_a_part(chains: tuple[Chain, ...]) -> Clause | None:
    """ "Move the left block of the row of three red blocks onto the mat": that row is not to be built first."""
    first = chains[0].clauses[0]
    if not isinstance(first, Clause) or first.lemma != "move" or not isinstance(first.theme, Noun):
        return None
    of = first.theme.part_of
    whole = of.whole if isinstance(of, PartOf) else of
    told = isinstance(whole, Structure) and whole.det == "the" and whole.members is not None
    return first if told and any(isinstance(x, Loc) for x in first.adjuncts) else None


def _is_shifted(first: Clause) -> bool:
    """Whether something is moved so far from where it is, so that it is there."""
    return any(isinstance(place, Loc) and place.rel in RELS for place in first.adjuncts)


def _is_off(place: Meaning) -> bool:
    return (isinstance(place, Loc) and place.rel == "off") or (
        isinstance(place, Using) and place.lead in ("from", "out of")
    )


def _mere_number(shape: Structure) -> bool:
    members = shape.members
    return isinstance(members, Noun) and members.traits == Traits() and members.amount is not None


class _Beside:
    """What the clauses say of a tower that is there: blocks that are named with "the" are none of the tower's, but
    for those that are taken off it."""

    def __init__(self, chains: tuple[Chain, ...], notes: list[str]) -> None:
        self.notes = notes
        self.colors = {color for chain in chains for part in parts_of(chain) if isinstance(part, Noun)
                       for color in part.traits.colors}  # fmt: skip
        self.brought: set[Traits] = set()

    def told(self, clause: Meaning) -> Meaning:
        """A clause behind the one that says that the tower is there."""
        if not isinstance(clause, Clause):
            return clause
        theme = clause.theme
        off_it = any(isinstance(a, Using) or isinstance(a.landmark, Structure)
                     for a in clause.adjuncts if isinstance(a, Loc | Using) and _is_off(a))  # fmt: skip
        places = [a for a in clause.adjuncts if isinstance(a, Loc) and a.rel != "off"]
        sides = len(places) + any(a.rel == "flank" for a in places)
        on_it = any(isinstance(a.landmark, Structure) for a in places)
        if off_it and isinstance(theme, Noun):
            self.brought.add(theme.traits)
            if theme.traits == Traits() and theme.amount == Amount(1, 1):
                self.notes.append("the block that is taken off the tower is the top one")
                theme = replace(theme, det="the", amount=None, traits=Traits(rank="top"))
        elif isinstance(theme, Noun):
            theme = self._further(theme) if on_it and theme.traits == Traits() else self._one_beside(theme, sides)
        if clause.lemma == "take" and clause.verb in ("use", "pick") and not clause.adjuncts:
            clause = replace(clause, verb="remove", lemma="remove")  # "take the top block off"
        adjuncts = tuple(_known(self._landmark(part)) for part in clause.adjuncts)
        return replace(clause, theme=_known(theme) if theme is not None else None, adjuncts=adjuncts)

    def _one_beside(self, noun: Noun, sides: int = 0) -> Noun:
        if sides > 1 or noun.head == "patch" or noun.det != "the" or noun.traits.rank or noun.part_of is not None:
            return noun
        if noun.traits in self.brought or not (noun.traits.colors or noun.traits.labels) or noun.plural:
            return noun
        self.brought.add(noun.traits)
        return replace(noun, det="a", head="block", amount=noun.amount or Amount(1, 1))

    def _landmark(self, place: Meaning) -> Meaning:
        mark = place.landmark if isinstance(place, Loc) else None
        return replace(place, landmark=self._one_beside(mark)) if isinstance(mark, Noun) else place

    def _further(self, theme: Noun) -> Noun:
        """A block of no told look that is put on the tower."""
        color = next((c for c in _FURTHER if c not in self.colors), next(iter(COLOR.values())))
        self.notes.append(f"the colour of the further block is not said: {color}")
        return replace(theme, det="a", amount=theme.amount or Amount(1, 1), traits=Traits(colors=(color,)))


def _known(said: Meaning) -> Meaning:
    """The tower without what was told of it, wherever it is spoken of."""
    match said:
        case Structure():
            return replace(said, members=None, sizes=(), traits=Traits())
        case Loc():
            mark = _known(said.landmark) if said.landmark is not None else None
            return replace(said, landmark=mark)
        case PartOf() if said.whole is not None:
            return replace(said, whole=_known(said.whole))
        case Coord():
            return replace(said, items=tuple(map(_known, said.items)))
        case Using():
            return replace(said, members=_known(said.members))
        case Noun() if said.part_of is not None:
            return replace(said, part_of=_known(said.part_of))
    return said
