"""Numbers of blocks: which blocks are counted, where that goes without saying or nothing is named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace as changed
from typing import TYPE_CHECKING

from rpg.language.later import later
from rpg.language.meaning import Amount, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.things.listing import quantified
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse, which_one

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")


def elliptical(noun: Noun, scene: Scene, scope: Scope) -> bool:
    """ "at least two", "exactly one", "two" without a noun."""
    bare = noun.head == "any" and noun.traits == Traits() and noun.det in ("bare", "some") and not scope.like_patch
    return bare and noun.amount is not None and bool(scene.blocks())


def some_more(noun: Noun, scene: Scene, scope: Scope) -> Ref | None:
    """ "Two of the four on the red mat and at least one on the blue one": of those of which the first are some."""
    last = next((m.ref for m in reversed(scene.mentions) if m.role == scope.role == "theme"), None)
    if last is None or last.quant is None or not last.quant.strict or not 0 < last.quant.low < len(last.names):
        return None
    return quantified(changed(last, quant=None, each=False, det=noun.det), noun)


def not_of_a_structure(noun: Noun, scene: Scene) -> None:
    """ "a pyramid of six blocks, two above ...": so many where all that was spoken of is in a structure."""
    built = {name for one in scene.built for name in one.members}
    if built and built >= {block.name for block in scene.blocks()}:
        kind = scene.built[-1].kind
        raise refuse(
            "ambiguous",
            f"these could be blocks of the {kind} or further ones",
            noun.span,
            "say what they look like, or how the structure is made in the sentence that builds it",
        )


def check_both(noun: Noun, whole: Ref, denied: bool, *, borne: bool = False) -> None:
    """ "both of the three", "on neither" behind one thing alone: there are two, or it is not said of both."""
    if noun.det == "no" and noun.amount == Amount(2, 2, True) and len(whole.names) == 1:
        raise refuse("no-referent", "it is not clear which two are meant by 'neither'", noun.span, "name both")
    if noun.det == "both" and len(whole.names) != 2:
        raise refuse("count-mismatch", f"'both' is of two, but there are {len(whole.names)}", noun.span, "say 'all'")
    none = denied and noun.det == "any"  # "not on any of them": on no tower is on none of its blocks
    if isinstance(noun.part_of, Pronoun) and noun.det not in _OF_EACH and not none:
        _of_the_blocks(noun, whole.built, borne=borne)


def _of_the_blocks(noun: Noun, built: Sequence[Built], *, borne: bool = False) -> None:
    """Refuse "two towers, exactly one of them on the mat": one of the towers, or a block of theirs?

    Where something lies on one of them (`borne`), it may be the towers: they have room on top."""
    several = len(built) > 1 or any(one.kind == "towers" for one in built)
    if several and noun.traits == Traits():
        kind = {"stack": "tower"}.get(built[0].kind, built[0].kind.rstrip("s"))
        message, hint = f"so many of the {kind}s, or of their blocks?", f"say it of one {kind}: 'the {kind} of A and B'"
        raise which_one(message, noun.span, hint) if borne else refuse("ambiguous", message, noun.span, hint)


_OF_EACH = frozenset({"all", "each", "both", "no"})
"""What is said of every tower is said of its blocks, or of the lowest one."""


def denied(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    """ "no red block": every red block that there is, or that the structure spoken of has."""
    if noun.det != "no" or noun.amount is not None or noun.conditions:
        return ()
    there = tuple(thing.name for thing in matching(noun.traits, scene, patch) if not thing.extra)
    return tuple(name for name in there if name in scope.pool) or there


def _none_told(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    """ "At most one block is on the mat", where no block was told of: there are more of them than may be there."""
    amount, marks = noun.amount, noun.traits
    plain = noun.head == "block" and not patch and marks == Traits(colors=marks.colors) and len(marks.colors) < 2
    if not plain or amount is None or not amount.high or scope.start or any(scene.blocks()):
        return ()
    count = amount.high + MORE
    lot = replace(noun, det="bare", amount=Amount(count, count), plural=True)
    those = refer(lot, scene, changed(scope, role="part"))
    scene.mentions.pop()
    color = f"{marks.colors[0]} " if marks.colors else ""
    scene.assume(f"the number of {color}blocks is not said: {count}")
    for name in those.names:
        scene.things[name].declared = True
    return those.names


MORE = 2
"""So many more blocks there are than may be somewhere."""


def counted_among(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    """ "at most one white block" counts all the white blocks there are."""
    amount = noun.amount
    if (noun.head, noun.det, noun.conditions) == ("any", "any", ()) and not patch:
        _of_the_blocks(noun, scene.built)  # "either one"
    if amount is None or not amount.strict or noun.det not in ("bare", "some"):
        return ()
    there = [t for t in matching(noun.traits, scene, patch) if t.declared or t.name in scene.told]
    if amount.low == 0 and (invented := _none_told(noun, scene, scope, patch)):
        return invented
    if amount.low == 0 and len(there) <= (amount.high or 0):
        raise refuse(
            "ambiguous",
            "it is not said how many such blocks there are",
            noun.span,
            "say for example 'at most one of the three white blocks'",
        )
    return tuple(t.name for t in there) if len(there) > amount.low else ()
