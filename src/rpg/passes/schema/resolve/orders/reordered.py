"""Structures that are there already, put into another order: reversed, or one block of them moved to an end."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import At
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms
from rpg.passes.schema.resolve.orders.turned_over import comes_of_reversing
from rpg.passes.schema.resolve.things.operands import UPRIGHT, crown, on_any
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse, which_one

FIRST = {"stack": "bottom", "row": "left", "line": "left", "column": "front"}
LAST = {"bottom": "top", "left": "right", "front": "back", "top": "bottom", "right": "left", "back": "front"}


def reverse(theme: Ref, scene: Scene, span: Span, spec: Spec, around: bool = False) -> Atoms:
    """ "reverse the tower": the same blocks, the other way round. `around`: it is turned, and its symbols as well?"""
    spec.thats = [that for that in spec.thats if not comes_of_reversing(that)]
    built = _ordered(theme, scene, span)
    if around and any(scene.things[n].label for n in built.members):
        raise refuse("ambiguous", "are the cubes turned, or is their order?", span, "say 'reverse the order'")
    looks = [(scene.things[n].color, scene.things[n].label, scene.things[n].size) for n in built.members]
    if looks == looks[::-1] and None not in {c or x for c, x, _ in looks}:
        raise refuse("no-goal", "this looks the same the other way round", span, "use blocks that differ")
    return [_again(built, built.members[::-1], scene, span)]


def within(theme: Ref, verb: str, spec: Spec, scene: Scene, span: Span) -> Atoms | None:
    """A block put at an end of the structure that it is part of, or on top of the one spoken of last."""
    if verb == "place" and not spec.ats:
        _end_of_its_line(theme, spec, scene)
    if len(spec.ats) != 1:
        return None
    again = moved_within(theme, spec.ats[0], scene, span) if verb != "be" else None
    if again is None and spec.ats[0].own and spec.ats[0].side == "first":
        raise refuse("no-referent", "it is not clear in which row this is", span, "say 'there is a row' of its blocks")
    if again is None and verb in ("place", "be") and not spec.intos:
        again = topped(theme, spec.ats[0], scene, span)
    return again


def _end_of_its_line(theme: Ref, spec: Spec, scene: Scene) -> None:
    """ "Put the green one last", "put it at the end" of a block in a row: a place there, and no time."""
    home = _home(theme, scene)
    more = spec.places or spec.intos or spec.orders or spec.absolutes or spec.thats or spec.usings or spec.toward
    told = [m for m in spec.manners if (m.kind, m.value) in _WHEN]
    if home is None or home.kind == "stack" or more or len(told) != 1 or len(spec.manners) != 1:
        return
    spec.manners = []
    spec.ats = [At(side="first", index=_WHEN[told[0].kind, told[0].value], span=told[0].span)]


_WHEN: dict[tuple[str, str | float | None], int] = {
    ("finally", None): -1, ("time", 99.0): -1, ("time", 1.0): 1, ("start", None): 1,
}  # fmt: skip
"""Words of time that are places in a line as well."""


def _home(theme: Ref, scene: Scene) -> Built | None:
    """The one structure of the start that a block is part of."""
    home = [b for b in scene.built if b.kind in FIRST and set(theme.names) < set(b.members)]
    alone = len(home) == len(theme.names) == 1 and theme.quant is None
    return home[0] if alone and _begun(home[0], scene) is not None else None


def with_two_swapped(one: str, other: str, scene: Scene, span: Span) -> g.Goal | None:
    """ "(A row of A, B, C and D.) Swap A and D": the line with these two in each other's place and the rest in theirs;
    None where they are not of one line whose order is told, or one other at most is in it."""
    home = _home(Ref(names=(one,)), scene)
    if home is None or other not in home.members or not home.ordered or len(home.members) < 4:
        return None
    places = {one: other, other: one}
    return _again(home, tuple(places.get(n, n) for n in home.members), scene, span)


def lines_of_the_start(scene: Scene) -> list[Built]:
    """The rows and towers that are there at the start, each as what it is then."""
    begun = [(b, _begun(b, scene)) for b in scene.built if b.kind in FIRST]
    return [b for b, node in begun if node is not None and isinstance(node, s.Stack) == (b.kind == "stack")]


def line_of_the_start(scene: Scene, span: Span) -> Built:
    """The one row or tower that is there at the start, in its order."""
    there = lines_of_the_start(scene)
    if len({frozenset(b.members) for b in there}) != 1:
        hint = "say which row or tower is there at the start: 'there is a tower of red, green and blue'"
        raise refuse("no-referent", "it is not clear which order this is", span, hint)
    return _ordered(Ref(names=there[0].members, built=(there[0],), span=span), scene, span)


def moved_within(theme: Ref, at_: At, scene: Scene, span: Span) -> Atoms | None:
    """ "move the red block to the top" of the tower that is there: the others keep their order."""
    home = _home(theme, scene)
    if home is None:
        return None
    built = _ordered(Ref(names=home.members, built=(home,), span=theme.span), scene, span)
    rest = tuple(n for n in built.members if n not in theme.names)
    index = _place_among(built, at_)
    if index is None or not -1 <= index <= len(rest):
        return None
    others = [scene.things[n] for n in rest]
    one_more = scene.things[theme.names[0]].claims and any((t.color, t.label) == (None, None) for t in others)
    index = len(rest) if index < 0 else index
    there = (*rest[:index], *theme.names, *rest[index:]) == built.members
    if (theme.det == "a" and not there) or one_more:  # of blocks of no told look, one is said to look so only here
        raise refuse("ambiguous", f"this could be a block of the {built.kind} or a further one", theme.span,
                     "say what the blocks look like that are there at the start")  # fmt: skip
    if there:
        raise refuse("no-goal", "it is there at the start", at_.span, "say where else it should be")
    return [_again(built, (*rest[:index], *theme.names, *rest[index:]), scene, span)]


def _place_among(built: Built, at_: At) -> int | None:
    """How many of the others are before a place of a structure; -1: all of them."""
    first = built.side or FIRST[built.kind]
    if at_.index is None:
        return {first: 0, LAST[first]: -1}.get(at_.side)
    if at_.side != "first" or built.kind == "stack":
        return None
    return at_.index - 1 if at_.index > 0 else -1


def topped(theme: Ref, at_: At, scene: Scene, span: Span) -> Atoms | None:
    """ "put D on top": of the tower or the block spoken of last, where it is no part of that."""
    if at_.side != "top" or at_.index is not None or at_.whole or len(theme.names) != 1 or theme.quant is not None:
        return None
    latest = [b for b in scene.built if b.kind in UPRIGHT]
    if any({*theme.names, *latest[-1].members} <= {*b.members} for b in latest):
        return None  # of a tower of which two blocks were spoken of in between
    if latest and not set(theme.names) & set(latest[-1].members):
        together = [b for b in latest if b.span == latest[-1].span]
        if len(together) > 1:
            raise refuse("ambiguous", "it is not clear on which of these", at_.span, "name the one you mean")
        here = any(latest[-1] in m.ref.built for m in scene.mentions if m.sentence == scene.sentence)
        if latest[-1].kind == "pyramid" and here:
            told = "this could be the top of the pyramid, or one more block on it"
            raise refuse("ambiguous", told, at_.span, "say which, in a sentence of its own")
        scene.topped.append(latest[-1])
        if latest[-1].kind == "wall":
            return [on_any(theme.names, latest[-1].members, span)]
        base = crown(Ref(names=latest[-1].members, built=(latest[-1],)))
    else:
        said = [m for m in scene.mentions if m.role == "theme" and m.clause < scene.clause and len(m.ref.names) == 1]
        if latest or scene.built or not said or said[-1].ref.patch or said[-1].ref.names == theme.names:
            return None
        base = said[-1].ref.names
        beside = [m for m in scene.mentions if m.clause == said[-1].clause and m.role == "landmark"]
        several = {m.ref.names for m in said if m.clause == said[-1].clause and not m.ref.patch}
        sides = ("left", "right", "front", "behind", "beside", "under")
        near = any(m.rel in sides and not m.ref.patch for m in beside)
        if near or len(several) > 1:
            raise refuse("ambiguous", "on top of which of the two?", at_.span, "name the block below")
    if isinstance(base, tuple) and len(base) == 1:
        scene.stacked(theme.names[0], base[0], span)
    return [r.On(a=theme.names, b=base, span=span)]


def _again(built: Built, names: tuple[str, ...], scene: Scene, span: Span) -> g.Goal:
    """The structure with its blocks in the order of `names`."""
    first = built.side or FIRST[built.kind]
    order = Order(by="given", ranks=tuple((n,) for n in names), first=first)  # type: ignore[arg-type]
    scene.add_built(built.kind, names, True, span, built.side)
    if built.kind == "stack":
        for upper, lower in zip(names[1:], names[:-1], strict=True):
            scene.on_top[upper] = lower
        scene.on_top.pop(names[0], None)
        return s.Stack(blocks=names, order=order, exact=True, span=span)
    return s.Row(blocks=names, axis="y" if first in ("left", "right") else "x", order=order, span=span)


def kind_again(theme: Ref, spec: Spec, scene: Scene) -> str:
    """ "(There is a tower of A, B and C.) Put it in the order C, A, B": as what these blocks are lined up."""
    figures = [b.kind for b in scene.built if b.kind not in FIRST and {*b.members} == {*theme.names}]
    if spec.absolutes and figures:  # "four blocks in a square, 2 cm between neighbours, with a blue one in the middle"
        raise refuse("ambiguous", f"these blocks form a {figures[-1]} already", theme.span,
                     "say first what the figure is made of, and then how wide its gaps are")  # fmt: skip
    if not spec.toward and any(order.first in ("bottom", "top") for order in spec.orders):
        return "stack"  # "two blocks: a red one and a blue one on it"
    if spec.toward or spec.absolutes:
        return "line"
    if len(theme.built) == 1 and theme.built[0].kind in FIRST:
        return theme.built[0].kind
    there = [b for b in scene.built if b.kind in ("stack", "column") and {*b.members} == {*theme.names}]
    if there and any(order.by == "given" for order in spec.orders):
        first = FIRST[there[-1].kind]
        raise refuse("ambiguous", "in a row, or as these blocks are lined up at the start?", theme.span,
                     f"say 'in a row', or 'from {first} to {LAST[first]}'")  # fmt: skip
    return "line"


def begun_in_order(built: Built, scene: Scene) -> Built | None:
    """A structure of the start whose blocks differ, in the order in which they were named; None for others."""
    looks = {(t.color, t.label) for t in (scene.things[n] for n in built.members)}
    node = _begun(built, scene)
    if node is None or node.order.by != "any" or built.kind not in FIRST:
        return None
    if len(looks) < len(built.members) and looks != {(None, None)}:
        return None
    return _ordered(Ref(names=built.members, built=(built,), span=built.span), scene, built.span)


def _begun(built: Built, scene: Scene) -> s.Stack | s.Row | None:
    """The structure as the start has it."""
    for goal in scene.start_goals:
        if isinstance(goal, s.Stack | s.Row) and set(goal.blocks) == set(built.members):
            return goal
    return None


def _ordered(theme: Ref, scene: Scene, span: Span) -> Built:
    """The structure with its order; one that the start leaves open is taken as its blocks were named."""
    built = (
        theme.built[-1]
        if theme.built
        else next((b for b in reversed(scene.built) if set(b.members) == set(theme.names)), None)
    )
    if built is None and len(scene.built) == 1 and set(theme.names) <= set(scene.built[0].members):
        built = scene.built[0]
    if built is None or built.kind not in FIRST or len(theme.built) > 1:
        raise refuse(
            "no-referent", "it is not clear which row or tower this is about", span, "name its blocks in order"
        )
    if built.ordered:
        return built
    node = _begun(built, scene)
    if node is None or node.order.by != "any":
        raise which_one("the order of these blocks is not said in full", span, "name its blocks one by one")
    first = FIRST[built.kind]
    order = Order(by="given", ranks=tuple((n,) for n in built.members), first=first)  # type: ignore[arg-type]
    fixed = (
        {"order": order} if isinstance(node, s.Stack) else {"order": order, "axis": "x" if first == "front" else "y"}
    )
    scene.start_goals[scene.start_goals.index(node)] = node.model_copy(update=fixed)
    scene.assume(f"at the start, from {first} to {LAST[first]} in the order in which the blocks are named")
    scene.built.remove(built)
    return scene.add_built(built.kind, built.members, True, built.span, first if built.kind != "stack" else None)
