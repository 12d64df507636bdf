"""Objects and descriptions: which fit, which are made, which are still open."""

from __future__ import annotations

import string

from rpg.blocks.traits import symbols_of
from rpg.core.diagnostics import Span
from rpg.language.lexicon import BIG_EDGE, MEDIUM_EDGE, SMALL_EDGE
from rpg.language.meaning import (
    Amount,
    Coord,
    Loc,
    Manner,
    Meaning,
    Noun,
    Structure,
    That,
    Traits,
    parts_of,
    record,
    replace,
)
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, Thing, refuse

PATCH_SCALE = {"big": 1.5, "small": 0.7}
"""How much larger a patch is than one of which nothing is said."""
EDGES = {"big": BIG_EDGE, "medium": MEDIUM_EDGE, "small": SMALL_EDGE}


def fits(thing: Thing, traits: Traits) -> bool:
    """Whether everything that `traits` says is known to hold of `thing`."""
    if traits.colors and thing.color not in traits.colors:
        return False
    if traits.labels and thing.label not in traits.labels:
        return False
    if traits.kind and not _kind_fits(thing, traits.kind):
        return False
    if traits.quality and not quality_fits(thing, traits.quality) and (thing.label or thing.quality != traits.quality):
        return False
    if traits.size and thing.size != traits.size:
        return False
    if traits.edge and thing.edge != traits.edge:
        return False
    if traits.long and not thing.long:
        return False
    return not (traits.shape and thing.patch and thing.shape != traits.shape)


def _kind_fits(thing: Thing, kind: str) -> bool:
    if kind == "plain":
        return thing.kind is None
    if kind == "symbol":
        return thing.kind is not None
    return thing.kind == kind


def quality_fits(thing: Thing, quality: str) -> bool:
    """Vowel, consonant, even, odd, or one of some symbols."""
    return thing.label is not None and thing.label in symbols_of(quality)


def matching(traits: Traits, scene: Scene, patch: bool) -> list[Thing]:
    """The objects that a description fits, distractors left out."""
    found = [t for t in scene.things.values() if t.patch == patch and not t.extra and fits(t, traits)]
    return found or (_by_edge(traits, scene) if traits.size in ("big", "small") and not patch else [])


def _by_edge(traits: Traits, scene: Scene) -> list[Thing]:
    """ "the small one" beside blocks of 5 and of 3 cm: those of the smaller edge."""
    there = [t for t in scene.blocks() if not t.extra and fits(t, replace(traits, size=None))]
    edges = sorted({t.edge or MEDIUM_EDGE for t in there})
    if len(edges) != 2 or any(t.size for t in there) or not any(t.edge for t in there):
        return []
    return [t for t in there if (t.edge or MEDIUM_EDGE) == (edges[0] if traits.size == "small" else edges[1])]


def create(traits: Traits, scene: Scene, patch: bool) -> Thing:
    """Bring an object into the task."""
    label = traits.labels[0] if traits.labels else None
    kind = _kind_of(label) if label else (traits.kind if traits.kind != "plain" else None)
    if traits.quality and not kind:
        kind = _kind_of(symbols_of(traits.quality)[0])
    return scene.fresh(
        patch=patch, color=traits.colors[0] if traits.colors else None, label=label, kind=kind, quality=traits.quality,
        edge=traits.edge if not patch else None, size=traits.size, shape=traits.shape if patch else None,
        long=traits.long, plain=traits.kind == "plain",
        extent=(traits.edge, traits.edge) if patch and traits.edge else None, scheme=traits.scheme,
    )  # fmt: skip


def _kind_of(label: str) -> str:
    if label in string.ascii_uppercase:
        return "letter"
    return "digit" if label in string.digits else "symbol"


def alike(things: list[Thing]) -> bool:
    looks = {(t.color, t.label, t.kind, t.size, t.edge, t.shape) for t in things}
    return len(looks) == 1 and (things[0].color is not None or things[0].label is not None)


def further(found: list[Thing], count: int, scene: Scene) -> list[Thing]:
    """ "another red block" where three were counted, and one of them is spoken of: the next one."""
    free = [t for t in found if t.declared and t.name not in scene.used]
    spoken = any(t.declared and t.name in scene.used for t in found)
    return free[:count] if spoken and len(free) >= count and alike(free) else []


def open_to(thing: Thing, traits: Traits) -> bool:
    """Whether an object's looks are still open to what `traits` says."""
    if thing.claims or (traits.size and thing.size not in (None, traits.size)):
        return False
    if traits.colors and (thing.color is not None or thing.label is not None):
        return False
    if traits.labels and (thing.plain or thing.label is not None or (thing.color is not None and thing.kind is None)):
        return False
    if traits.labels and thing.quality and not _shows_such(traits.labels, thing.quality):
        return False
    return bool(traits.colors or traits.labels or traits.size)


def _shows_such(labels: tuple[str, ...], quality: str) -> bool:
    """Whether a vowel may turn out to be one of these symbols."""
    return all(quality_fits(Thing(name="", label=label), quality) for label in labels)


def check_cubes(traits: Traits, span: Span) -> None:
    """Refuse a shape that no block has.

    Raises:
        Refusal: "misplaced", for long, round and other blocks that are no cubes.
    """
    if traits.long or traits.shape not in (None, "square"):
        raise refuse("misplaced", "blocks are cubes, all of one shape", span, "leave the shape out")


def give(thing: Thing, traits: Traits) -> None:
    """Let `thing` have what `traits` says."""
    thing.claims += 1
    if traits.colors:
        thing.color = traits.colors[0]
    if traits.labels:
        thing.label = traits.labels[0]
        thing.kind = _kind_of(traits.labels[0])
        thing.elastic = None
    if traits.size:
        thing.size = traits.size
    if traits.edge:
        thing.edge = traits.edge
        if thing.patch:
            thing.extent = (traits.edge, traits.edge)
    if traits.long:
        thing.long = True
    if traits.shape and thing.patch:
        thing.shape = traits.shape


def is_open(noun: Noun) -> bool:
    """Whether a phrase leaves the number of its objects open."""
    return (
        noun.amount is None
        and not (not noun.plural and noun.det in ("a", "the", "bare", "another", "its"))
        and noun.det != "both"
    )


def elastic(things: list[Thing], noun: Noun, patch: bool) -> list[Thing]:
    """Mark new objects whose number is open."""
    if is_open(noun):
        for thing in things:
            thing.elastic = _words(noun.traits) + ("patches" if patch else "blocks")
    return things


_QUALITIES = {"even": "even number", "odd": "odd number", "vowel": "vowel", "consonant": "consonant"}


def _words(traits: Traits) -> str:
    sort = {"letter": "letter", "digit": "number"}.get(traits.kind or "", "")
    words = [*traits.colors, _QUALITIES.get(traits.quality or "", sort)]
    return "".join(w + " " for w in words if w)


def compared(meaning: Meaning | None) -> bool:
    """ "a block of the same colour", "a matching block": told by something else's colour."""
    if not isinstance(meaning, Noun) or meaning.head == "patch" or meaning.traits.colors or meaning.traits.labels:
        return False
    one = not meaning.plural and meaning.det in ("a", "another", "its", "bare")
    return meaning.traits.matching or (meaning.traits.scheme == "same" and one)


@record
class Premise(Meaning):
    """What a relative clause takes for granted of some objects. `when`: at the "start", at the "end", at "both", or
    "always"."""

    names: tuple[str, ...]
    condition: Meaning
    when: str = "start"
    built: tuple[Built, ...] = ()


def note_premises(noun: Noun, found: Ref, scene: Scene, scope: Scope) -> None:
    """The relative clauses of a phrase: of the start, as "the block that is on the mat" is there already. A landmark
    that they bring up, "red is to be on a blue block that is on a green one", is so at the end; and one that a picture
    names, "red is next to the blue block that is on the green one", is so all along."""
    if noun.conditions and (noun.det == "no" or (found.quant is not None and found.quant.high == 0)):
        raise refuse("ambiguous", "it is not clear which blocks are there at the start", noun.span, "use two sentences")
    mark = scope.role == "landmark" and not (scope.start or scope.given)
    new = mark and noun.det in ("a", "bare", "some")
    when = "end" if new and scene.describing else "both" if new or (mark and scene.describing) else "start"
    if any(isinstance(condition, Manner) and condition.kind == "staying" for condition in noun.conditions):
        when = "always"  # "a block that stays off the mat"
    for condition in noun.conditions:
        if isinstance(condition, Manner) and condition.kind == "staying":
            continue
        begun = _of_the_start(condition) if scope.start and scope.given else condition
        scene.premises.append(Premise(span=condition.span, names=found.names, condition=begun, when=when))


def _of_the_start(condition: Meaning) -> Meaning:
    """What is told by the way of a start is told of it alone."""
    if not isinstance(condition, Loc) or "aside" not in condition.mods:
        return condition
    return replace(condition, mods=tuple(m for m in condition.mods if m not in ("asserted", "aside")))


def told_of_whole(shape: Structure) -> tuple[Structure, tuple[That, ...]]:
    """A structure, and what a clause behind its blocks tells of all of it: "a tower of two, which is left of B"."""
    blocks = shape.members
    told = tuple(x for x in blocks.conditions if isinstance(x, That)) if isinstance(blocks, Noun) else ()
    if not told or not isinstance(blocks, Noun):
        return shape, ()
    kept = tuple(x for x in blocks.conditions if x not in told)
    return replace(shape, members=replace(blocks, conditions=kept)), told


def note_of_whole(told: tuple[That, ...], shape: Structure, found: Ref, scene: Scene, scope: Scope) -> None:
    """What is told of a structure by the way, or in a picture of the end, is so at the end; else it may be there."""
    pictured = shape.det == "a" and scene.describing
    if told and not (pictured or all("aside" in getattr(x.clauses, "mods", ()) for x in told)):
        raise refuse("misplaced", "it is not clear of what this is said", told[0].span, "say it in its own sentence")
    begun = scope.start or scope.given
    for that in told:
        so = _of_the_start(that.clauses) if begun else that.clauses
        when = "start" if begun else "end"
        scene.premises.append(Premise(span=that.span, names=found.names, condition=so, when=when, built=found.built))


def looks_said(noun: Noun, names: tuple[str, ...], there: dict[str, bool], scene: Scene) -> None:
    """Refuse further blocks of which no look is said beside ones that have a look (`there`), and symbols not named.

    "Two red blocks on the mat and three on the table": three more red ones, not three of whatever look.
    """
    new = [scene.things[name] for name in names if name not in there]
    alone = noun.det == "all" and not noun.traits.labels and len(new) == len(names) and not scene.opposites
    if alone and noun.traits.quality:
        which = "letters A to F" if symbols_of(noun.traits.quality)[0].isalpha() else "digits 1 to 8"
        raise refuse("ambiguous", "it is not said which symbols there are", noun.span,
                     f"say it first, as in 'There are the {which}.'")  # fmt: skip
    many = noun.amount
    if many is not None and many.strict and many.low != many.high and noun.traits == Traits():
        scene.vague.update(thing.name for thing in new if noun.head == "block" and noun.part_of is None)
    bare = noun.head == "any" and noun.traits == Traits() and any(there.values())
    if bare and any(not thing.declared and thing.color is None and not thing.kind for thing in new):
        raise refuse("ambiguous", "it is not said what these blocks look like", noun.span, "name their colour")


def amount_of(meaning: Meaning | None) -> int | None:
    """The plain number in a noun phrase."""
    amount: Amount | None = getattr(meaning, "amount", None)
    return amount.low if amount is not None and amount.low == amount.high else None


def plain_colors(theme: Meaning) -> tuple[str, ...]:
    """The colours of "red and blue", where they are all that is said."""
    if isinstance(theme, Coord) and theme.op == "and":
        return tuple(c for item in theme.items for c in plain_colors(item))
    plain = isinstance(theme, Noun) and theme.amount is None and theme.det == "bare" and theme.head == "any"
    return theme.traits.colors if plain and isinstance(theme, Noun) and not theme.traits.either else ()


def bare_colors(theme: Meaning) -> tuple[str, ...]:
    """The colours of "red and blue", or of "red and blue blocks"."""
    named = isinstance(theme, Noun) and theme.plural and theme.amount is None and theme.det == "bare"
    plain = isinstance(theme, Noun) and theme.traits == Traits(colors=theme.traits.colors)
    return theme.traits.colors if named and plain and isinstance(theme, Noun) else plain_colors(theme)


def of_no_look(meaning: Meaning) -> bool:
    """ "the letters", "no two blocks", "all of the blocks": beside a structure these are its own."""
    if not isinstance(meaning, Noun) or meaning.head != "block" or meaning.part_of is not None or meaning.conditions:
        return False
    told = meaning.det in ("the", "no", "all", "each", "both")
    told = told or (meaning.det == "bare" and meaning.plural and meaning.amount is None)
    return told and meaning.traits == Traits(kind=meaning.traits.kind)


def note_named(chains: tuple[Meaning, ...], scene: Scene) -> None:
    """Note whether the sentences say how blocks look or how many there are, and whether they tell of both of two
    opposites: "all odd numbers left, all even ones right"."""
    parts = [x for chain in chains for x in parts_of(chain) if isinstance(x, Noun | Structure)]
    scene.colors = frozenset(color for x in parts for color in x.traits.colors)
    blocks = [x for x in parts if isinstance(x, Noun) and x.head != "patch"]
    looks = {(x.traits.colors, x.traits.labels) for x in blocks} - {((), ())}
    scene.looks = len(looks)
    joined = {item for chain in chains for x in parts_of(chain) if isinstance(x, Coord) for item in x.items}
    qualities = {x.traits.quality for x in blocks if x not in joined}
    scene.opposites = qualities >= {"odd", "even"} or qualities >= {"vowel", "consonant"}
    scene.names_blocks = bool(looks) or any(x.amount is not None and x.head == "block" for x in blocks)
