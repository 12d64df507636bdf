"""Blocks of which only a part is counted, or a share told: "two blocks on the patch, the others on the table", "half of
the blocks on the left". How many there are is assumed, where nothing else says which blocks there are."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    Toward,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.counted import put
from rpg.passes.schema.resolve.things.world import Scene

_SHARES = {"half": 4, "most": 4, "third": 6, "quarter": 8}
"""So many blocks are there, where a share of them is told: at least one for each part of a half."""
_PARTS = {"half": 2, "most": 1, "third": 3, "quarter": 4}
_OTHER_PART = frozenset({"the other half", "the rest", "the others"})
_OTHERS = frozenset({"the others", "the rest", "the other ones", "others", "the remaining ones", "the remainder",
                     "all others", "all the others", "all the rest"})  # fmt: skip
MORE = 2
"""So many are "the others"."""
_ACROSS = ({"left", "right"}, {"front", "back"})


def lots_open(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences with what is assumed of the number of such blocks."""
    chains = _on_halves(tuple(_one_more(chain, chains) for chain in chains))
    blocks = [x for chain in chains for x in parts_of(chain) if _names_blocks(x)]
    shared = {x for x in blocks if isinstance(x, Noun) and _of_open(x)}
    if len(shared) == 1:
        share = next(iter(shared))
        whole = share.part_of
        if isinstance(whole, Noun) and all(x in (share, whole) for x in blocks):
            many = _SHARES[share.det]
            scene.assume(f"the number of {_look(whole)}blocks is not said: {many}")
            counted = replace(share, part_of=replace(whole, det="the", amount=Amount(many, many)))
            if any(isinstance(x, Pronoun) and x.word in _OTHER_PART for chain in chains for x in parts_of(chain)):
                part = Amount(many // _PARTS[share.det], many // _PARTS[share.det])
                counted = replace(counted, det="some", amount=part)
            return tuple(put(chain, share, counted) for chain in chains)
    lots = [x for x in blocks if not _others(x)]
    first = lots[0] if len(lots) == 1 else None
    if isinstance(first, Noun) and _plainly_counted(first) and _then_others(chains, first) and first.amount:
        many = first.amount.low + MORE
        scene.assume(f"the number of blocks is not said: {many}")
        whole = Noun(head="block", det="the", amount=Amount(many, many), plural=True, span=first.span)
        some = replace(first, det="some", plural=first.amount.low > 1, part_of=whole)
        return tuple(put(chain, first, some) for chain in chains)
    return chains


def _names_blocks(part: Meaning) -> bool:
    """Nouns for blocks, and structures, which bring blocks with them."""
    return isinstance(part, Structure) or (isinstance(part, Noun) and part.head != "patch" and part.det != "no")


def _of_open(noun: Noun) -> bool:
    """ "Half of the blocks": a share of as many as there are."""
    whole = noun.part_of
    if noun.det not in _SHARES or not isinstance(whole, Noun) or whole.head != "block" or whole.part_of is not None:
        return False
    plain = whole.amount is None and whole.plural and not whole.conditions and whole.det in ("the", "all", "bare")
    look = whole.traits
    return plain and look in (Traits(), Traits(colors=look.colors[:1]))


def _look(noun: Noun) -> str:
    return "".join(f"{color} " for color in noun.traits.colors)


def _others(part: Meaning) -> bool:
    return isinstance(part, Noun) and (part.det, part.amount, part.traits) == ("other", None, Traits()) and part.plural


def _then_others(chains: tuple[Chain, ...], first: Noun) -> bool:
    """Whether "the others" are told of behind, and "them" could be nobody else."""
    theirs = [x for chain in chains for c in chain.clauses for x in parts_of(getattr(c, "theme", None))]
    named = [x for x in theirs if (isinstance(x, Pronoun) and x.word in _OTHERS) or _others(x)]
    pronouns = [x for chain in chains for x in parts_of(chain) if isinstance(x, Pronoun)]
    others = [x for x in pronouns if x not in named and x.word not in ("it", "each other")]
    return len(named) == 1 and not others and named[0].span[0] >= first.span[1]


def _plainly_counted(noun: Noun) -> bool:
    """ "Two blocks", of which nothing else is said."""
    exact = noun.amount is not None and noun.amount.low == noun.amount.high and noun.amount.low > 0
    plain = noun.head == "block" and noun.det == "bare" and noun.part_of is None and not noun.conditions
    return exact and plain and noun.traits == Traits()


def _one_more(chain: Chain, chains: tuple[Chain, ...]) -> Chain:
    """ "Two blocks on the red patch and one on the blue patch": one more, as one of the two is on the other patch.

    Not where blocks were listed before, of which it could be one.
    """
    if any(isinstance(c, Clause) and c.mode == "given" for told in chains for c in told.clauses):
        return chain
    clauses = _further_ones(chain.clauses)
    clauses = tuple(_in_notes(clause) for clause in clauses)
    return replace(chain, clauses=clauses) if clauses != chain.clauses else chain


def _in_notes(clause: Meaning) -> Meaning:
    """The same of a note, "two blocks on the left, one on the right"."""
    listed = clause.adjuncts[0] if isinstance(clause, Clause) and clause.verb == "part" and clause.adjuncts else None
    if not isinstance(clause, Clause) or not isinstance(listed, Coord) or listed.op != "absolutes":
        return clause
    return replace(clause, adjuncts=(replace(listed, items=_further_ones(listed.items)), *clause.adjuncts[1:]))


def _further_ones(told: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """What is told of one lot after the other, with a block of the look of the one before for "one"."""
    found = list(told)
    for n in range(1, len(found)):
        one, before = found[n], found[n - 1]
        if not isinstance(one, Clause | Absolute) or not isinstance(before, Clause | Absolute):
            continue
        lot = before.theme
        counted = isinstance(lot, Noun) and lot.amount is not None and lot.amount.low == lot.amount.high
        if (
            not isinstance(lot, Noun)
            or not counted
            or not (many := _how_many(one.theme))
            or not _in_other_places(before, one)
            or not _of_one_look(lot)
        ):
            continue
        span = one.theme.span if one.theme is not None else one.span
        again = Noun(head="block", amount=Amount(many, many), plural=many > 1, traits=lot.traits, span=span)
        found[n] = replace(one, theme=again, adjuncts=(_other_patch(one.adjuncts[0]),))
    return tuple(found)


def _how_many(theme: Meaning | None) -> int:
    """ "One", of which nothing is said, and a bare digit, which counts as the number of the lot before it does."""
    if isinstance(theme, Noun) and theme.det == "bare" and theme.part_of is None and not theme.conditions:
        if theme.head == "any" and not theme.plural and theme.traits == Traits():
            return 1 if theme.amount in (None, Amount(1, 1)) else 0
        alone = theme.span[1] - theme.span[0] == 1 and theme.traits == Traits(labels=theme.traits.labels[:1])
        shown = theme.traits.labels[0] if alone and theme.traits.labels else ""
        return int(shown) if shown.isdigit() else 0
    return int(isinstance(theme, Pronoun) and theme.word == "one")


def _of_one_look(lot: Noun) -> bool:
    plain = lot.head in ("block", "any") and lot.det == "bare" and lot.part_of is None and not lot.conditions
    return plain and lot.traits == Traits(colors=lot.traits.colors[:1])


def _other_patch(place: Meaning) -> Meaning:
    """ "(On one patch,) on the other": on another patch."""
    mark = place.landmark if isinstance(place, Loc) else None
    other = isinstance(mark, Pronoun) or (isinstance(mark, Noun) and mark.det == "other")
    if not isinstance(place, Loc) or mark is None or not other:
        return place
    return replace(place, landmark=Noun(head="patch", det="another", amount=Amount(1, 1), span=mark.span))


def _in_other_places(before: Clause | Absolute, one: Clause | Absolute) -> bool:
    """Whether these are two places of a kind, of which no block can be in both."""
    denied = any(isinstance(x, Clause) and x.negated for x in (before, one))
    if len(before.adjuncts) != 1 or len(one.adjuncts) != 1 or denied:
        return False
    here, there = before.adjuncts[0], one.adjuncts[0]
    if isinstance(here, At) and isinstance(there, At):
        plain = all(x.index is None and not x.whole for x in (here, there))
        return plain and {here.side, there.side} in _ACROSS
    if isinstance(here, In) and isinstance(there, In):
        return here.region != there.region and not (here.negated or there.negated)
    marks = [x.landmark for x in (here, there) if isinstance(x, Loc) and x.rel in ("on", "in") and not x.negated]
    if len(marks) > 1 and isinstance(marks[0], Noun) and (isinstance(marks[1], Pronoun) or _other_one(marks[1])):
        single = marks[0].head == "patch" and marks[0].amount == Amount(1, 1) and marks[0].det in ("a", "bare")
        return single and (not isinstance(marks[1], Pronoun) or marks[1].word in ("the other", "the other one"))
    patches = [x for x in marks if isinstance(x, Noun) and not x.plural and x.part_of is None]
    if len(patches) < len((here, there)) or patches[0].head != "patch" or patches[1].head not in ("patch", "any"):
        return False
    one_, other = patches[0].traits, patches[1].traits
    told = one_ != other and (one_.colors, one_.rank) != (other.colors, other.rank)
    return told or patches[1].det == "another"


def _other_one(mark: Meaning | None) -> bool:
    return isinstance(mark, Noun) and mark.det == "other" and not mark.plural and mark.traits == Traits()


def _on_halves(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Most of the six blocks on the left": in that half of the table, as it is not said which they are, and no line
    is spoken of that would have such a side."""
    parts = [x for chain in chains for x in parts_of(chain)]
    lined = any(isinstance(x, Structure | Into | OrderBy | Toward | Absolute) for x in parts)
    clauses = [c for chain in chains for c in chain.clauses if isinstance(c, Clause)]
    sided = [c for c in clauses if len(c.adjuncts) == 1 and _table_side(c.adjuncts[0])]
    some = any(isinstance(c.theme, Noun) and _share(c.theme) for c in sided)
    others = any(isinstance(x, Pronoun) and x.word in _OTHER_PART for x in parts)
    if lined or not some or others or len(sided) < len(clauses) or sum(isinstance(x, At) for x in parts) > len(sided):
        return chains
    for clause in sided:
        side = clause.adjuncts[0]
        if isinstance(side, At):
            there = replace(clause, adjuncts=(In(region=_HALVES[side.side], span=side.span),))
            chains = tuple(put(chain, clause, there) for chain in chains)
    return chains


_HALVES = {"left": "left_half", "right": "right_half"}


def _table_side(place: Meaning) -> bool:
    return isinstance(place, At) and place == At(side=place.side, span=place.span) and place.side in _HALVES


def _share(noun: Noun) -> bool:
    """So many of some blocks, whichever they are."""
    some = noun.det in _SHARES or (noun.amount is not None and noun.det in ("some", "any"))
    return some and isinstance(noun.part_of, Noun | Pronoun) and noun.traits == Traits()
