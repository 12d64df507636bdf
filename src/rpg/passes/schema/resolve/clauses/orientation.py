"""How a block faces and how its symbol is turned: "upside down", "facing left"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Manner
from rpg.passes.schema.resolve.things.finish import label_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def turn_of(name: str, facing: Manner | None, flat: Manner | None, scene: Scene, span: Span) -> g.Goal:
    """How a block is to be turned; "sideways" is a quarter turn either way."""
    found = oriented(name, facing, flat, scene, span)
    if flat is None or flat.value != 90.0 or not isinstance(found, r.Facing):
        return found
    return g.Any(goals=(found, found.model_copy(update={"turn": -90.0})), span=span)


def others_not_turned(
    theme: Ref, among: tuple[str, ...], facing: Manner | None, flat: Manner | None, scene: Scene, span: Span
) -> list[g.Goal]:
    """ "Only the B is upside down": no other of those that show a symbol is."""
    if theme.op != "only":
        return []
    if flat is None or facing is not None:
        raise refuse("misplaced", "'only' does not fit this", theme.span, "say which way the other blocks face")
    others = [n for n in among if n not in theme.names and (scene.things[n].label or scene.things[n].kind)]
    return [g.Not(goal=turn_of(name, facing, flat, scene, span), span=span) for name in others]


def oriented(name: str, facing: Manner | None, flat: Manner | None, scene: Scene, span: Span) -> g.Goal:
    """How a block is to face, and its symbol to be turned."""
    thing = scene.things[name]
    if thing.kind is None and thing.label is None:
        raise refuse(
            "order-misfit",
            "a plain block looks the same on every side",
            span,
            "use a letter block, or say 'by 90 degrees'",
        )
    piled = any(b.kind == "word" and b.side == "top" and name in b.members for b in scene.built)
    toward = str(facing.value) if facing is not None else "viewer" if piled else "up"
    label = label_of(thing, scene)
    turned = float(flat.value or 0.0) if flat is not None else None
    if flat is None and toward == "viewer" and (name in scene.on_top or name in scene.on_top.values()):
        turned = 0.0  # in a tower, symbols are read from the viewer's side
    elif flat is None and thing.faces is None:
        thing.faces = {"front": label}
        scene.assume(f"{label} shows on one face of its block; the other faces are blank")
    if facing is None and not piled:
        scene.assume("the letter is read from above")
    return r.Facing(block=name, label=label, toward=toward, turn=turned, span=span)  # type: ignore[arg-type]
