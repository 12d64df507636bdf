"""As many blocks again for each of several places: "two blocks on each patch"."""

from __future__ import annotations

from rpg.language.meaning import Loc, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def one_lot_each(theme: Ref, lots: int, scene: Scene) -> list[tuple[str, ...]]:
    """ "two blocks on each patch": as many again for every further patch."""
    made = [theme.names]
    for _ in range(lots - 1):
        more = []
        for name in theme.names:
            like = scene.things[name]
            if like.declared:
                more.append(_next_declared(name, scene))
                continue
            if like.label is not None:
                raise refuse("ambiguous", "one cube for all of these, or one for each?", theme.span,
                             "name as many cubes as there are places")  # fmt: skip
            new = scene.fresh(color=like.color, kind=like.kind, size=like.size, edge=like.edge, scheme=like.scheme)
            new.batch, new.quality = like.batch, like.quality
            scene.used.add(new.name)
            more.append(new.name)
        made.append(tuple(more))
    for mention in (m for m in scene.mentions if m.clause == scene.clause and m.ref.names == theme.names):
        mention.ref = replace(mention.ref, names=tuple(n for lot in made for n in lot), plural=True)
    return made


def _next_declared(name: str, scene: Scene) -> str:
    """A further block like one of those that there are said to be."""
    like = scene.things[name]
    look = (like.color, like.label, like.kind, like.size, like.edge)
    for thing in scene.blocks():
        here = (thing.color, thing.label, thing.kind, thing.size, thing.edge)
        if thing.declared and not thing.extra and here == look and thing.name not in scene.used:
            scene.used.add(thing.name)
            return thing.name
    raise refuse("too-many-asked", "there are not so many of these blocks", None, "name more blocks, or fewer patches")


def along_a_line(mark: Ref, loc: Loc, scene: Scene) -> Loc:
    """ "A red block behind each of them", of blocks of one row: each is straight behind its own."""
    across = {"row": ("front", "behind"), "line": ("front", "behind"), "column": ("left", "right")}
    lined = any(loc.rel in across.get(b.kind, ()) and {*mark.names} <= {*b.members} for b in scene.built)
    return replace(loc, mods=(*loc.mods, "directly")) if lined else loc
