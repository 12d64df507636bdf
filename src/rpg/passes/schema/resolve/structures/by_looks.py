"""Structures told by the looks of their blocks: "stack three red and two green blocks, so that you get a red tower and
a green tower" makes each of the blocks that are such."""

from __future__ import annotations

from itertools import chain as joined

from rpg.language.meaning import (
    Chain,
    Clause,
    Coord,
    Into,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    That,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.operands import base_of
from rpg.passes.schema.resolve.things.world import Scene

_VERBS = frozenset({"stack", "sort", "arrange", "place", "build"})
_TOLD = frozenset({"exist", "be", "build"})
_THESE = frozenset({"them", "these", "those", "everything"})


def by_looks(chain: Chain) -> Chain:
    """The sentence with a clause for what there is and one for each of such structures."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for clause, link in zip(chain.clauses, chain.links, strict=True):
        told = _told(clause) if isinstance(clause, Clause) and not clause.negated else [clause]
        clauses += told
        links += [link, *["and"] * (len(told) - 1)]
    told_plainly = replace(chain, clauses=tuple(clauses), links=tuple(links))
    return chain if told_plainly == chain else told_plainly


def as_results(chain: Chain, scene: Scene) -> Chain:
    """What "so that there is a tower" tells of: what is built, not what there was."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for clause, link in zip(chain.clauses, chain.links, strict=True):
        told = _standing(clause, scene) or [_result(clause)]
        clauses += told
        links += [link, *["and"] * (len(told) - 1)]
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _standing(clause: Meaning, scene: Scene) -> list[Meaning]:
    """ "(Red on blue, green on yellow,) so that there are two towers": those are the towers, each on the table."""
    shape = clause.theme if isinstance(clause, Clause) and clause.verb in _TOLD and not clause.negated else None
    if not isinstance(shape, Structure) or shape.kind != "stack" or not shape.plural or shape.amount is None:
        return []
    bare = not (shape.members or shape.details or shape.dims or shape.traits != Traits())
    lying = {upper: lower for upper, lower in scene.on_top.items() if upper not in scene.begun_on}
    feet = [name for name in dict.fromkeys(lying.values()) if name not in lying]
    towers = [(foot, *(name for name in lying if base_of(name, scene) == foot)) for foot in feet]
    tall = all(z.amount and {z.amount.low, z.amount.high} == {len(tower)} for z in shape.sizes for tower in towers)
    count = shape.amount.low if shape.amount.low == shape.amount.high else 0
    if not bare or not tall or count != len(feet) or not isinstance(clause, Clause) or clause.adjuncts:
        return []
    one = Structure(kind="stack", det="a", span=shape.span)
    themes = [replace(one, members=Pronoun(word="=" + " ".join(tower), span=shape.span)) for tower in towers]
    return [replace(clause, verb="build", theme=theme, mode="goal") for theme in themes]


def _result(clause: Meaning) -> Meaning:
    there = isinstance(clause, Clause) and clause.verb == "exist" and clause.mode == "given"
    if not there or not isinstance(clause, Clause) or not any(isinstance(x, Structure) for x in _items(clause.theme)):
        return clause
    one = clause.theme
    if isinstance(one, Structure) and one.members is None and one.traits == Traits() and not one.letter:
        one = replace(one, members=Pronoun(word="them", span=one.span))
    return replace(clause, verb="build", theme=one, mode="goal")


def _items(theme: Meaning | None) -> tuple[Meaning | None, ...]:
    return theme.items if isinstance(theme, Coord) else (theme,)


def _told(clause: Clause) -> list[Meaning]:
    """What a clause says in plainer ones; itself where it names no such structures, or more is said."""
    blocks = clause.theme
    named = [(part, _wholes(part)) for part in clause.adjuncts if isinstance(part, Into | That)]
    wholes = named[0][1] if len(named) == 1 else []
    if clause.verb == "sort" and len(wholes) > 1 and isinstance(blocks, Pronoun) and blocks.word in _THESE:
        told: list[Meaning] = [
            Clause(verb="build", theme=x, mode="goal", span=clause.span, word=clause.word) for x in wholes
        ]
        return told if all(x.kind == "pile" for x in wholes) and len(clause.adjuncts) == 1 else [clause]
    more = [a for a in clause.adjuncts if not named or a is not named[0][0]]
    apart = [a.members for a in more if isinstance(a, Using) and a.lead == "from" and clause.verb == "sort"]
    if apart and blocks is not None:
        blocks = Coord(op="and", items=(blocks, *apart), span=blocks.span)
        more = [a for a in more if not isinstance(a, Using)]
    if clause.verb not in _VERBS or not wholes or blocks is None or not all(map(_by_color, more)):
        return [clause]
    colors = [whole.traits.colors for whole in wholes]
    of_each = [x.traits.colors for x in parts_of(blocks) if isinstance(x, Noun)]
    if not _bare(blocks) or len({*colors}) < len(colors) or {*colors} != {(c,) for c in joined(*of_each)}:
        return [clause]
    if all(whole.kind == "pile" for whole in wholes):
        by = OrderBy(by="attribute", attribute="color", span=named[0][0].span)
        return (
            [replace(clause, verb="sort", lemma="sort", theme=blocks, adjuncts=(by,))] if len(wholes) > 1 else [clause]
        )
    counted = any(isinstance(x, Noun) and x.amount is not None for x in parts_of(blocks))
    there = [Clause(verb="exist", theme=blocks, mode="given", span=blocks.span)] if counted else []
    return [*there, *(Clause(verb="build", theme=x, mode="goal", span=clause.span, word=clause.word) for x in wholes)]


def _wholes(part: Meaning) -> list[Structure]:
    """The structures that a clause names as what its blocks become, if each is told by one colour and no more."""
    if isinstance(part, Into):
        target: Meaning | None = part.structure
    else:
        inner = part.clauses if isinstance(part, That) and part.kind == "so" else None
        one = inner.clauses[0] if isinstance(inner, Chain) and len(inner.clauses) == 1 else None
        plain = isinstance(one, Clause) and one.verb in _TOLD and not (one.adjuncts or one.negated)
        target = one.theme if plain and isinstance(one, Clause) else None
    items = _alike(_items(target)) if getattr(target, "op", "and") == "and" else ()
    items = tuple(map(_by_its_blocks, items))
    found = [x for x in items if isinstance(x, Structure) and _plain(x)]
    return found if items and len(found) == len(items) and (len(found) > 1 or isinstance(part, That)) else []


def _alike(items: tuple[Meaning | None, ...]) -> tuple[Meaning | None, ...]:
    """ "A red tower and a green one": a green tower."""
    first = items[0]
    ones = [x for x in items[1:] if isinstance(x, Noun) and (x.head, x.det, x.plural) == ("any", "a", False)]
    if not isinstance(first, Structure) or len(ones) != len(items) - 1 or not ones:
        return items
    return (first, *(replace(first, traits=x.traits, span=x.span) for x in ones))


def _by_its_blocks(shape: Meaning | None) -> Meaning | None:
    """ "A group of red ones": a red group."""
    if not isinstance(shape, Structure) or shape.kind != "pile" or not isinstance(lot := shape.members, Noun):
        return shape
    plain = lot.plural and lot.amount is None and lot.det == "bare" and not lot.conditions and lot.part_of is None
    told = plain and shape.traits == Traits() and lot.traits == Traits(colors=lot.traits.colors)
    return replace(shape, members=None, traits=lot.traits) if told else shape


def _plain(shape: Structure) -> bool:
    colors = shape.traits.colors
    only = shape.traits == Traits(colors=colors) and len(colors) == 1
    more = shape.members or shape.details or shape.sizes or shape.dims or shape.letter or shape.plural
    return only and not more and shape.det in ("a", "bare", "one", "another")


def _bare(blocks: Meaning) -> bool:
    """Whether all of these are blocks by their colours and numbers."""
    if isinstance(blocks, Coord):
        return blocks.op == "and" and all(map(_bare, blocks.items))
    traits = blocks.traits if isinstance(blocks, Noun) and blocks.head != "patch" else None
    told = isinstance(blocks, Noun) and not blocks.conditions and blocks.part_of is None
    return told and traits is not None and bool(traits.colors) and traits == Traits(colors=traits.colors)


def _by_color(part: Meaning) -> bool:
    """ "By colour", which such structures say as well."""
    return isinstance(part, OrderBy) and part.by == "attribute" and part.attribute == "color"
