"""Which blocks are left where some are taken out: "all but the red one", "none of them except A and B"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.later import later
from rpg.language.meaning import Amount, Coord, Meaning, Noun, Pronoun, Structure, Traits, replace
from rpg.passes.schema.resolve.things.things import create
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")

OTHERS = 3
"""Blocks besides those that "all blocks except ..." names, where none were spoken of."""


def excepted(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    """ "all blocks except the red one", "the red but not the blue block"."""
    patch = scope.like_patch or getattr(meaning.items[0], "head", "") == "patch"
    those = [refer(item, scene, scope) for item in meaning.items[:-1] if _of_those(item)]
    out = refer(meaning.items[-1], scene, replace(scope, like_patch=patch))
    scene.spare.update(out.names)
    whole = those or [refer(item, scene, scope) for item in meaning.items[:-1]]
    del scene.mentions[-len(meaning.items) :]
    if scope.role == "landmark" and not {n for part in whole for n in part.names} & set(out.names):
        raise refuse("ambiguous", "this is an exception to something said before it", meaning.items[-1].span,
                     "say 'all blocks except ...', or say this part in a sentence of its own")  # fmt: skip
    if _new(meaning.items[0]) and not {n for part in whole for n in part.names} & set(out.names):
        raise refuse("misplaced", "this is none of the blocks that it is an exception to", meaning.items[-1].span,
                     "say how many blocks of each look there are")  # fmt: skip
    names = tuple(dict.fromkeys(n for part in whole for n in part.names if n not in out.names))
    if not names and _everything(meaning.items[0]) and not out.patch:
        scene.new_batch()
        names = tuple(create(Traits(), scene, False).name for _ in range(OTHERS))
        scene.assume(f"how many other blocks there are is not said: {OTHERS}")
    if not names:
        raise refuse("no-referent", "no block is left to speak of", meaning.span)
    if out.quant is not None:
        return _but_some(names, out, [n for part in whole for n in part.names], meaning)
    both, patch = (Ref(names=names), out), whole[0].patch
    return Ref(names=names, patch=patch, op="except", parts=both, plural=True, span=meaning.span)


def _of_those(meaning: Meaning) -> bool:
    """ "All of them": what was spoken of before, and not the exception that is spoken of behind it."""
    return isinstance(meaning, Pronoun) and meaning.word in ("all of them", "them")


def _new(meaning: Meaning) -> bool:
    """ "a circle of eight red blocks", "eight red blocks": what is called for in just this way."""
    counted = isinstance(meaning, Noun) and meaning.amount is not None and meaning.det == "bare"
    return isinstance(meaning, Structure) or (counted and isinstance(meaning, Noun) and bool(meaning.traits.colors))


def _everything(meaning: Meaning) -> bool:
    whole = isinstance(meaning, Noun) and meaning.det in ("all", "each") and meaning.head == "block"
    plain = whole and isinstance(meaning, Noun) and meaning.traits == Traits()
    return plain or (isinstance(meaning, Pronoun) and meaning.word in ("everything", "all"))


def _but_some(names: tuple[str, ...], out: Ref, whole: list[str], meaning: Coord) -> Ref:
    """ "All the blocks except one of the red ones": the others, and all the red ones but one, whichever that is."""
    left, many = len(out.names), out.quant
    if many is None or many.low != many.high or out.op != "and" or out.mixed or not {*out.names} <= {*whole}:
        raise refuse("ambiguous", "it is not said which of the blocks are left out", meaning.items[-1].span,
                     "name these blocks")  # fmt: skip
    kept = replace(out, quant=Amount(left - many.low, left - many.low, True))
    return Ref(names=(*names, *out.names), parts=(Ref(names=names), kept), plural=True, span=meaning.span)


def none_but(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    """ "None of them except the red one", "no letter but A": that one, and not the others."""
    theme, exception = meaning.items
    those = theme.part_of if isinstance(theme, Noun) and theme.part_of is not None else theme
    if isinstance(theme, Pronoun):
        those = Pronoun(word="them", span=theme.span)
    elif isinstance(theme, Noun) and theme.part_of is None:
        those = replace(theme, det="all", amount=None, plural=True)
    spoken = refer(those, scene, scope) if isinstance(those, Pronoun) else None
    only = refer(exception, scene, scope)
    whole = spoken or refer(those, scene, scope)
    del scene.mentions[-2:]
    if only.patch or whole.patch or only.quant is not None or only.op != "and" or whole.quant is not None:
        raise refuse("misplaced", "this exception does not fit here", meaning.span, "say it in two sentences")
    rest = tuple(name for name in whole.names if name not in only.names)
    if not {*only.names} <= {*whole.names} or not rest:
        raise refuse("misplaced", "this is none of the blocks that it is an exception to", exception.span,
                     "say 'no other block than ...'")  # fmt: skip
    return Ref(names=only.names, op="except", parts=(only, Ref(names=rest)), plural=True, span=meaning.span)


def besides(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    """ "All that are not red", "the one that is not red", which is one.

    Raises:
        Refusal: it could be any of several.
    """
    found = replace(excepted(meaning, scene, scope), op="and", parts=())
    if not getattr(meaning.items[0], "plural", True) and len(found.names) > 1:
        raise refuse("ambiguous", f"this could be any of {len(found.names)} blocks", meaning.span, "name it")
    return found
