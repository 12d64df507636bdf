"""Several towers at once: counts, heights, one per colour, on patches."""

from __future__ import annotations

from dataclasses import replace

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.passes.schema.meaning import Amount, Coord, Noun, Structure
from rpg.passes.schema.resolve.members import new_members
from rpg.passes.schema.resolve.refer import refer
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.world import Built, Ref, Scene, Scope, refuse

STACK_COLORS = ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink")
DEFAULT_HEIGHT = 2
DEFAULT_COLORS = 3


def several(
    shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope
) -> tuple[list[Built], list[g.Goal]]:
    """ "two towers of three red blocks", "towers, one per colour", "two stacks"."""
    patterns = [p for p in spec.patterns if p.unit in ("stack", "pile")]
    spec.patterns = [p for p in spec.patterns if p.unit not in ("stack", "pile")]
    by_color = bool(patterns) or shape.traits.scheme == "same" or any(_matching(p) for p in spec.places)
    count = shape.amount.low if shape.amount and shape.amount.low > 1 else None
    per = shape.extent("size", "high", "layers")
    if by_color and count is None and shape.plural and not shape.members and shape.amount is None and theme is None:
        count = 2
    names, count, per = _blocks(shape, spec, theme, count, per, by_color, scene, scope)
    separate = any(p.different for p in patterns) or by_color
    heights = (per,) * count if per is not None and count is not None else None
    node = s.Towers(
        blocks=names, count=count, heights=heights, equal=_equal(spec), each="color" if by_color else None,
        separate=separate and by_color, span=shape.span,
    )  # fmt: skip
    return _remember(node, names, count, per, by_color, scene), [node]


def _matching(place: object) -> bool:
    """A place on patches of the towers' own colours."""
    mark = getattr(place, "landmark", None)
    if not isinstance(mark, Noun) or mark.head != "patch":
        return False
    return mark.traits.matching or (mark.traits.scheme in ("some", "different") and not mark.traits.colors)


def _equal(spec: Spec) -> bool:
    found = spec.manner("equal")
    return found is not None


def _blocks(
    shape: Structure,
    spec: Spec,
    theme: Ref | None,
    count: int | None,
    per: int | None,
    by_color: bool,
    scene: Scene,
    scope: Scope,
) -> tuple[tuple[str, ...], int | None, int | None]:
    """The blocks of all towers together, how many towers, and how many blocks in each where that is fixed."""
    source = shape.members or (spec.usings.pop(0).members if spec.usings else None)
    if theme is not None:
        names = theme.names
        colors = {scene.things[n].color for n in names}
        if by_color:
            count = len(colors)
        if count is not None and len(names) < 2 * count:
            raise refuse(
                "too-few",
                f"{len(names)} blocks do not make {count} towers of two or more",
                shape.span,
                f"use at least {2 * count}",
                blocks=len(names),
                towers=count,
            )
        return names, count, per
    if isinstance(source, Noun):
        each = source.amount.low if source.amount else None
        if shape.plural and each is not None and not source.det.startswith("the"):
            per, total = each, None
        else:
            total = None
        if source.det in ("the", "all", "both") and not source.amount or source.part_of:
            found = refer(
                source, scene, replace(scope, need=(count or 2) * (per or DEFAULT_HEIGHT), role="member")
            ).names
            return found, count, per
        traits = replace(source.traits, colors=source.traits.colors or shape.traits.colors)
    else:
        traits, total = shape.traits, None
    if isinstance(source, Coord):
        found = refer(source, scene, replace(scope, role="member")).names
        return found, count, per
    if count is None:
        count = len(traits.colors) if len(traits.colors) > 1 else (DEFAULT_COLORS if by_color else 2)
        scene.assume(f"the number of towers is not said: {count}")
    if per is None:
        scene.assume(f"the number of blocks is not said: {DEFAULT_HEIGHT * count}")
    height = per or DEFAULT_HEIGHT
    if by_color or len(traits.colors) > 1:
        names: list[str] = []
        if len(traits.colors) > 1 and len(traits.colors) != count:
            raise refuse(
                "count-mismatch",
                f"{count} towers, but {len(traits.colors)} colours",
                shape.span,
                "name one colour for each tower",
                towers=count,
            )
        for color in traits.colors if len(traits.colors) == count else STACK_COLORS[:count]:
            names += new_members(replace(traits, colors=(color,), scheme=None), height, None, scene)
        return tuple(names), count, per
    return new_members(traits, total or height * count, None, scene), count, per


def _remember(
    node: s.Towers, names: tuple[str, ...], count: int | None, per: int | None, by_color: bool, scene: Scene
) -> list[Built]:
    """Towers whose members are told apart by colour are structures of their own; others are known together only."""
    colors = list(dict.fromkeys(scene.things[n].color for n in names))
    if by_color and None not in colors:
        return [
            scene.add_built("stack", [n for n in names if scene.things[n].color == c], False, node.span or (0, 0))
            for c in colors
        ]
    return [scene.add_built("towers", names, False, node.span or (0, 0))]


def on_patches(shape: Structure, amount: Amount | None) -> bool:
    """Whether each tower is to have a patch of its own."""
    return shape.plural
