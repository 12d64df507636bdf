"""What is denied of several blocks and several landmarks at once holds of each of them."""

from __future__ import annotations

from rpg.language.meaning import Amount, Loc, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

_SOME = Amount(1, None, True)
"""At least one."""


def one_and_all(theme: Ref, mark: Ref, loc: Loc, scene: Scene) -> list[tuple[Ref, Ref]] | None:
    """The pairs of which a relation is said one by one; None where it is said of all of them together.

    "No green block touches any red block": of each red block that none of the green ones touches it. "The green blocks
    touch none of the red ones": of each green block. "Green must not touch any of the red ones": not a single one.
    """
    if mark.quant is None or theme.patch:
        return None
    nobody = theme.quant is not None and theme.quant.high == 0
    single = mark.det == "any" and mark.quant == Amount(1, 1, True)
    if nobody and (mark.quant == _SOME or single):
        return [(theme, Ref(names=(name,), patch=mark.patch)) for name in mark.names]
    if nobody:
        raise refuse("ambiguous", "it is not clear how much of this is denied", loc.span, "use two sentences")
    if mark.quant.high == 0 and mark.patch and theme.built:
        raise refuse("ambiguous", "it is not clear how much of this is denied", loc.span, "say 'not on the ...'")
    if mark.quant.high == 0 and mark.patch and theme.quant is None and not theme.built and theme.op == "and":
        none = replace(theme, quant=Amount(0, 0, True))
        return [(none, Ref(names=(name,), patch=True)) for name in mark.names]
    several = theme.quant is None and theme.op == "and" and len(theme.names) > 1 and not theme.built
    if mark.quant.high == 0 and several:
        return [(Ref(names=(name,)), mark) for name in theme.names]
    if single and (loc.negated or scene.denying):
        return [(theme, replace(mark, quant=_SOME))]
    return None
