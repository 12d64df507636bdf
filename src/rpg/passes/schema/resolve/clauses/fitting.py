"""Descriptions in which a word has nothing to say: a patch that shows a letter, a free block, a lying tower.

Every such word is refused, for what nobody uses later would be dropped in silence.
"""

from __future__ import annotations

import string
from collections.abc import Sequence
from itertools import pairwise

from rpg.core.diagnostics import Span
from rpg.language.grammar.clauses.some_way import SOME_WAY
from rpg.language.grammar.things.retold import tally
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Spacing,
    Structure,
    Toward,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.order_again import check_borne_again, check_order_again, check_rebuilt
from rpg.passes.schema.resolve.things.things import matching, quality_fits
from rpg.passes.schema.resolve.things.world import Built, Scene, Thing, refuse

_LYING = frozenset({"stack", "wall", "staircase", "pile", "cube"})
"""Structures that do not lie on the table."""
_STANDING = frozenset({"stack", "wall", "staircase", "pyramid", "line", "row", "column", "word", "cube"})
"""Structures that can stand upright."""
_OUTLINED = frozenset({"square", "rectangle", "triangle", "circle", "grid"})
"""Structures that can be mere outlines."""
_VAGUE = {
    "size": "{!r} names no size of a structure: as large as its number of blocks makes it",
    "pace": "{!r} is no part of the goal: how fast or how gently it is done is not judged",
}


_QUALITY = {"even": "even", "odd": "odd", "vowel": "a vowel", "consonant": "a consonant"}


def check_words(chains: Sequence[Chain], scene: Scene) -> None:
    """Refuse words that cannot mean anything where they stand; record those whose sense is not judged."""
    told = any(len(chain.clauses) > 1 for chain in chains)
    _contrast(chains)
    for chain in chains:
        check_order_again(chain)
        check_borne_again(chain)
        for part in parts_of(chain):
            match part:
                case Noun():
                    _noun(part)
                case Coord(op="and"):
                    _listed_with(part.items, part.span)
                case Structure():
                    _structure(part)
                case Clause():
                    check_rebuilt(part, told)
                    _clause(part)
                    _wholly(part)
                    _own_parts(part)
                case Using() | OrderBy() | Absolute():
                    _certain(part)
                case Manner(kind="shift", value=str(said)):
                    raise _unfit(f"it is not clear how far which way {said!r} is", part.span,
                                 "say '10 cm to the left', or 'a bit closer to the robot'")  # fmt: skip
                case Manner(kind="idle", value=str(said)):
                    _idle(said, told, part.span, scene)
                case Manner(value=way) if way == SOME_WAY:
                    raise refuse("ambiguous", "it is not said which way", part.span, "say 'left', or 'to the camera'")
        told = True


_TALL = frozenset({"tall", "long", "big", "large", "huge", "giant"})
_SHORT = frozenset({"short", "small", "little", "tiny", "mini"})


def _contrast(chains: Sequence[Chain]) -> None:
    """Refuse "a tall tower and a short one" where it is not said how many blocks they have."""
    said: dict[str, Structure] = {}
    for shape in (part for chain in chains for part in parts_of(chain) if isinstance(part, Structure)):
        counted = shape.sizes or shape.dims or getattr(shape.members, "amount", None) is not None
        for detail in shape.details if not counted else ():
            if isinstance(detail, Manner) and detail.kind == "idle":
                word = str(detail.value).partition(" ")[2]
                said.setdefault("tall" if word in _TALL else "short" if word in _SHORT else "", shape)
    if {"tall", "short"} <= set(said):
        raise _unfit("it is not said how many blocks each of them has", said["short"].span, "say how many blocks")


def check_besides(scene: Scene) -> None:
    """Refuse "another" where there is nothing that it could be besides, or where more came than it was said of."""
    for traits, ref, span in scene.besides:
        if all(t.name in ref.names for t in matching(replace(traits, scheme=None), scene, ref.patch)):
            what = "patch" if ref.patch else "block"
            raise refuse("no-referent", f"there is no {what} besides which this is another", span, "say 'a' instead")
    for traits, names, span in scene.surveyed:
        if any(t.name not in names and not t.extra for t in matching(traits, scene, False)):
            raise refuse("ambiguous", "more blocks are named behind this: are these meant as well?", span,
                         "say before it which blocks there are")  # fmt: skip


def _idle(said: str, told: bool, span: Span, scene: Scene) -> None:
    """Words that no goal can use: their sense, then the word itself, such as "pace slowly"."""
    sense, _, word = said.partition(" ")
    if sense in ("any", "whole", "view"):
        return
    if sense in _VAGUE:
        scene.assume(_VAGUE[sense].format(word))
    elif not told:
        raise _unfit(f"{word!r} speaks of what was so before, and nothing was", span, "say how it starts")


def _certain(part: Using | OrderBy | Absolute) -> None:
    """Refuse "or" and "no" among blocks that something is made of, put in order with, or described by."""
    items: tuple[Meaning, ...]
    match part:
        case Using():
            items = (part.members,)
            if _none(part.members):
                raise _unfit("nothing can be made of no blocks", part.span, "name the blocks to be used")
        case OrderBy():
            items = part.items
            _listed_with(items, part.span)
        case _:
            items = (part.theme,)
    if any(_open(item) for item in items):
        raise _either(part.span)


def _open(meaning: Meaning | None) -> bool:
    """Whether a phrase leaves open which of several things it means."""
    return (isinstance(meaning, Coord) and meaning.op in ("or", "xor")) or (
        isinstance(meaning, Noun) and meaning.traits.either
    )


def _either(span: Span) -> Exception:
    return refuse("ambiguous", "'or' leaves open here which of them is meant", span, "say 'and', or name one of them")


def _noun(noun: Noun) -> None:
    traits = noun.traits
    single = not noun.plural and (noun.amount is None or noun.amount.high == 1)
    if noun.head == "patch":
        if traits.kind or traits.quality or traits.labels:
            raise _unfit("patches show no letters or numbers", noun.span, "describe the patch by its colour")
        if traits.matching and len(traits.colors) == 1:
            raise _unfit("a patch of one colour cannot match several", noun.span, "leave out the colour or 'matching'")
        return
    if traits.empty:
        raise _unfit("patches can be empty; blocks cannot", noun.span, "say 'with nothing on it' of a block")
    if single and traits.scheme == "mixed":
        raise _unfit("a single block is not mixed", noun.span, "name its colour")
    _all_such(traits.labels, traits.quality, noun.span)
    for label in traits.labels:
        if (traits.kind == "letter" and label not in string.ascii_uppercase) or (
            traits.kind == "digit" and label not in string.digits
        ):
            what = {"letter": "letter", "digit": "number"}[traits.kind]
            raise _unfit(f"{label} is no {what}", noun.span, f"leave out the word '{what}'")


def _listed_with(items: tuple[Meaning, ...], span: Span) -> None:
    """Refuse "the odd digits 1, 3 and 4" as two odd digits and one more: what is listed with them is such as well."""
    first, *others = items or (None,)
    if not isinstance(first, Noun) or not first.plural or not first.traits.labels:
        return
    for other in others:
        if not isinstance(other, Noun) or other.traits != Traits(labels=other.traits.labels) or other.det != "bare":
            return
        _noun(replace(first, traits=replace(first.traits, labels=other.traits.labels), span=span))


def _all_such(labels: tuple[str, ...], quality: str | None, span: Span) -> None:
    """Refuse "the even digits 2 to 8", of which some are odd."""
    for label in labels if quality else ():
        if quality and not quality_fits(Thing(name="", label=label), quality):
            what = _QUALITY.get(quality, "such a number")
            raise _unfit(f"{label} is not {what}", span, "name those that are meant one by one")


def _clause(clause: Clause) -> None:
    theme = clause.theme
    _cut_short(theme)
    _excepted(clause)
    aside = [x for x in clause.adjuncts if isinstance(x, Loc) and x.rel in ("side_by_side", "adjacent", "beside")]
    if clause.verb == "stack" and len(aside) == len(clause.adjuncts) == 1 and isinstance(aside[0].landmark, Pronoun):
        raise _unfit("blocks of one stack are not next to each other", aside[0].span, "say how many stacks there are")
    if isinstance(theme, Noun) and theme.traits.quality:
        orders = (a for a in parts_of(clause.adjuncts) if isinstance(a, OrderBy))
        shown = (i for a in orders for i in a.items if isinstance(i, Noun))
        _all_such(tuple(label for item in shown for label in item.traits.labels), theme.traits.quality, clause.span)
        _among(clause)
    if isinstance(theme, Noun) and clause.verb == "be":
        _run_of(theme, clause)
        _numbers_below(theme, clause)
    if _open(theme):
        _alternatives(clause)
    _by_color(clause)
    if isinstance(theme, Noun):
        _tallied(theme, clause.adjuncts)
    if isinstance(theme, Noun) and theme.traits.extra and theme.head == "block" and not clause.negated:
        placed = any(isinstance(a, Loc) and not a.negated for a in clause.adjuncts)
        if placed and clause.verb in ("place", "stack") and clause.mode == "command":
            raise _unfit("a distractor has no place in the goal", theme.span, "leave out the word, or its place")


def _by_color(clause: Clause) -> None:
    """Refuse "put them on two mats by colour", "put them together by colour": that is no line of them."""
    shaped = any(isinstance(a, Into | At | Toward) for a in clause.adjuncts)
    for order in clause.adjuncts if clause.verb == "place" and not shaped else ():
        if isinstance(order, OrderBy) and (order.by, order.attribute) == ("attribute", "color"):
            raise refuse("ambiguous", "in a line, in groups, or each on the patch of its colour?", order.span,
                         "say 'sort by color', 'in a row', or 'on the patch of its color'")  # fmt: skip


_UNDONE = frozenset({"unstack", "remove", "reverse"})


def _wholly(clause: Clause) -> None:
    """ "completely" adds nothing where something is taken apart or emptied; elsewhere it is not clear what it does."""
    for part in clause.adjuncts if clause.verb not in _UNDONE else ():
        if isinstance(part, Manner) and part.kind == "idle" and str(part.value).startswith("whole "):
            word = str(part.value).partition(" ")[2]
            raise _unfit(f"it is not clear what is {word!r} here", part.span, "leave it out")


def _among(clause: Clause) -> None:
    """Refuse "the vowels among A, B and C", of which it would be said that they lie between these."""
    marks = [a.landmark for a in clause.adjuncts if isinstance(a, Loc) and a.rel == "between"]
    if any(isinstance(mark, Noun) and mark.traits.labels for mark in marks):
        raise _unfit("it is not clear which of these are meant", clause.span, "name them one by one")


def _numbers_below(theme: Noun, clause: Clause) -> None:
    """Refuse "the digits below 8", of which it would be said that they lie under it."""
    marks = [a.landmark for a in clause.adjuncts if isinstance(a, Loc) and a.rel in ("under", "above")]
    single = any(isinstance(x, Noun) and len(x.traits.labels) == 1 and x.traits.labels[0].isdigit() for x in marks)
    if single and theme.plural and theme.traits.kind == "digit" and not theme.traits.labels:
        raise _unfit("smaller ones, or ones that lie there?", clause.span, "name them one by one")


_SORTED = ("ascending", "number", "label", "in_order")


def _run_of(theme: Noun, clause: Clause) -> None:
    """Refuse an order in "the digits from 1 to 5", which says which they are."""
    runs = any(isinstance(a, OrderBy) and a.by == "run" for a in clause.adjuncts)
    lined = (Into, Toward)  # with a direction, or an order besides, they stand in a line
    formed = any(isinstance(a, lined) or (isinstance(a, OrderBy) and a.by in _SORTED) for a in clause.adjuncts)
    if runs and not formed and theme.traits.kind in ("letter", "digit") and not theme.traits.labels:
        raise _unfit("these are no order, but tell which are meant", clause.span, "say 'in a row', or in order")


def _excepted(clause: Clause) -> None:
    """Refuse "a red and a blue tower, except the red one", "between blue and green, but not the blue one"."""
    for told in (x for x in parts_of(clause) if isinstance(x, Coord) and x.op == "except"):
        *listed, last = told.items
        new = any(isinstance(x, Structure) and x.det in ("a", "bare") for x in listed)
        looks = [x.traits for x in listed if isinstance(x, Noun) and len(listed) > 1]
        if new or (isinstance(last, Noun) and last.traits in looks):
            raise _unfit("this is an exception to something said before it", last.span, "name only what is meant")


_SINGLE = Amount(1, 1)


def _cut_short(theme: Meaning | None) -> None:
    """Refuse "a tower of red, blue and green" as a tower of two blocks and a third one, and "two towers, the left one"
    as something besides them."""
    for shape, other in pairwise(theme.items) if isinstance(theme, Coord) else ():
        several = isinstance(shape, Structure) and shape.plural
        if several and isinstance(other, Noun) and (other.head, other.det) == ("any", "the") and other.traits.rank:
            raise _unfit("this is one of those before it", other.span, "say it in a sentence of its own")
        blocks = shape.members if isinstance(shape, Structure) else None
        items = blocks.items if isinstance(blocks, Coord) else (blocks, blocks)
        bare = [x for x in (*items, other) if isinstance(x, Noun) and x.det == "bare" and x.amount in (None, _SINGLE)]
        marks = [bool(x.traits.labels) for x in bare if x.traits.labels or x.traits.colors]
        listed = isinstance(blocks, Coord) or (isinstance(blocks, Noun) and len(blocks.traits.labels) > 1)
        if listed and len(marks) == len(items) + 1 and len({*marks}) == 1:
            raise _unfit("this could be one more block of the structure, or one beside it", other.span,
                         "say 'and a ... block' of one beside it")  # fmt: skip


def _alternatives(clause: Clause) -> None:
    """ "The red or the blue block": where one of them is to be, not of what there is or what they do together."""
    theme = clause.theme
    shapes = isinstance(theme, Coord) and any(isinstance(item, Structure) for item in theme.items)
    together = any(
        isinstance(a, OrderBy | Into | Spacing)
        or (isinstance(a, Manner) and a.kind == "respectively")
        or (isinstance(a, Loc) and isinstance(a.landmark, Pronoun) and "other" in a.landmark.word)
        for a in clause.adjuncts
    )
    if shapes or together or clause.mode == "given" or clause.verb in ("swap", "sort", "spell", "exist"):
        raise _either(clause.span if theme is None else theme.span)


def _tallied(whole: Noun, adjuncts: tuple[Meaning, ...]) -> None:
    """ "Four blocks ..., three cyan and two brown": a list that tells what was counted has to agree with it."""
    for part in adjuncts:
        if isinstance(part, OrderBy) and whole.amount is not None and whole.amount.low == whole.amount.high:
            told = tally(part.items)
            counted = part.by == "named" or any(isinstance(i, Noun) and i.amount is not None for i in part.items)
            if counted and told not in (0, whole.amount.low):
                raise refuse(
                    "count-mismatch",
                    f"{whole.amount.low} blocks are spoken of, but {told} are listed",
                    part.span,
                    f"say {told}, or list {whole.amount.low}",
                    asked=whole.amount.low,
                    listed=told,
                )


def _own_parts(clause: Clause) -> None:
    """Refuse "a tower of four blue blocks with the top one red", and "four blocks, red and blue by turns" with it: then
    only three of the four look so."""
    intos = [x.structure for x in clause.adjuncts if isinstance(x, Into)]
    shape = next((x for x in (clause.theme, *intos) if isinstance(x, Structure)), None)
    blocks = clause.theme if shape is None or shape is not clause.theme else shape.members
    if clause.verb != "stack" if shape is None else shape.kind != "stack":
        return
    items = [x for x in (blocks.items if isinstance(blocks, Coord) else (blocks,)) if isinstance(x, Noun)]
    turns = [x for a in clause.adjuncts if isinstance(a, OrderBy) and a.by == "alternating" for x in a.items]
    told = [c for x in (*items, *turns, shape) if isinstance(x, Noun | Structure) for c in x.traits.colors]
    if not told or all(x.amount is None for x in items):
        return
    for part in parts_of((*(shape.details if shape else ()), *clause.adjuncts)):
        own = isinstance(part, Absolute) and isinstance(part.adjuncts[0], At) and part.adjuncts[0].own
        looks = part.theme.traits.colors if own and isinstance(part.theme, Noun) else ()
        if not {*told}.issuperset(looks):
            raise refuse("ambiguous", "this could be one of the blocks before it, or a further one", part.span,
                         f"say how many are {told[0]}, and how many {looks[0]}")  # fmt: skip


def _structure(shape: Structure) -> None:
    traits = shape.traits
    if _open(shape.members):
        raise _either(shape.span)
    if shape.det == "no" or _none(shape.members):
        raise _unfit("what should not be there is no goal to build", shape.span, "say what should be there")
    if traits.scheme == "different" and shape.kind == "stack" and shape.det == "bare" and shape.amount is None:
        raise _unfit("this says only which tower a block is not in", shape.span,
                     "say what each tower is made of, or 'not in one tower'")  # fmt: skip
    if traits.empty:
        raise _unfit("only patches can be empty", shape.span, "leave the word out")
    if isinstance(shape.members, Noun):
        _members(shape, shape.members)
    if shape.members is not None and traits.quality:
        said = traits.quality if traits.quality in _QUALITY else "which numbers these are"
        raise _unfit(f"{said!r} says nothing of this structure", shape.span, "say it of its blocks")
    if shape.upright is False and shape.kind in _LYING:
        raise _unfit("this structure stands upright", shape.span, "say 'a row' for blocks side by side")
    if shape.filled is False and shape.kind not in _OUTLINED:
        raise _unfit("this structure has no inside", shape.span, "leave the word out, or ask for a square or a circle")
    if shape.upright is True and shape.kind not in _STANDING:
        raise _unfit("figures lie flat on the table", shape.span, "leave the word out, or ask for a wall")


def _members(shape: Structure, members: Noun) -> None:
    _tallied(members, shape.details)
    if members.traits.extra:
        raise _unfit("distractors take no part in a structure", members.span, "leave the word out")
    if shape.traits.scheme and members.traits.colors and shape.det in ("a", "bare"):
        raise _unfit("the colours of its blocks are said already", shape.span, "name its colours once")


def uses_orders(built: Sequence[Built]) -> bool:
    """Whether the goal of these structures holds an order that was said: several towers, words and piles have none."""
    towers = [b for b in built if b.kind == "stack"]
    return len(towers) < 2 and not any(b.kind in ("word", "equation", "pile") for b in built)


def _none(members: Meaning | None) -> bool:
    return isinstance(members, Noun) and members.det == "no"


def _unfit(message: str, span: Span, hint: str) -> Exception:
    return refuse("misplaced", message, span, hint)
