"""The adjuncts of a clause, sorted by kind."""

from __future__ import annotations

from dataclasses import dataclass, field

from rpg.language.meaning import (
    Absolute,
    At,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    OrderBy,
    Pattern,
    Places,
    Quality,
    Size,
    Spacing,
    That,
    Toward,
    Using,
)
from rpg.passes.schema.resolve.things.world import Scene, refuse


@dataclass
class Spec:
    """What a clause says besides its verb and theme. `left`: what nobody has used yet; `lined`: towers in a row;
    `values`: the kinds that groups were said to be of; `in_turn`: the blocks of each of several that come in turn;
    `viewed`: who looks at it was told."""

    orders: list[OrderBy] = field(default_factory=list)
    toward: list[Toward] = field(default_factory=list)
    ats: list[At] = field(default_factory=list)
    absolutes: list[Absolute] = field(default_factory=list)
    usings: list[Using] = field(default_factory=list)
    patterns: list[Pattern] = field(default_factory=list)
    spacings: list[Spacing] = field(default_factory=list)
    sizes: list[Size] = field(default_factory=list)
    manners: list[Manner] = field(default_factory=list)
    places: list[Meaning] = field(default_factory=list)
    intos: list[Into] = field(default_factory=list)
    thats: list[That] = field(default_factory=list)
    qualities: list[Quality] = field(default_factory=list)
    parts: list[Places] = field(default_factory=list)
    values: tuple[str, ...] = ()
    in_turn: tuple[tuple[str, ...], ...] = ()
    listed: bool = False
    lined: bool = False
    any_way: bool = False
    viewed: bool = False

    def first(self, *allowed: str) -> str | None:
        """The side where an order begins, if one of `allowed` was said."""
        return next((t.first for t in self.toward if t.first in allowed), None)

    def manner(self, kind: str) -> Manner | None:
        """The manner of a kind, taken out of the list."""
        found = next((m for m in self.manners if m.kind == kind), None)
        if found is not None:
            self.manners.remove(found)
        return found


_KINDS: dict[type, str] = {
    OrderBy: "orders", Toward: "toward", At: "ats", Absolute: "absolutes", Using: "usings", Pattern: "patterns",
    Spacing: "spacings",
    Size: "sizes", Manner: "manners", Loc: "places", In: "places", Into: "intos", That: "thats", Quality: "qualities",
    Places: "parts",
}  # fmt: skip


def sort_adjuncts(adjuncts: tuple[Meaning, ...]) -> Spec:
    """Adjuncts by kind, each list in order of reading."""
    spec = Spec()
    for item in adjuncts:
        if isinstance(item, Coord) and item.op == "absolutes":
            spec.absolutes += [a for a in item.items if isinstance(a, Absolute)]
        elif isinstance(item, Coord):
            spec.places.append(item)
        elif isinstance(item, Manner) and item.kind == "idle":
            spec.any_way = spec.any_way or item.value == "any way"
            spec.viewed = spec.viewed or item.value == "view"
        elif isinstance(item, Manner) and any((m.kind, m.value) == (item.kind, item.value) for m in spec.manners):
            pass  # "upright and readable" says one thing twice
        else:
            getattr(spec, _KINDS[type(item)]).append(item)
    if any(isinstance(p, Loc) and getattr(p.landmark, "word", "") == "it" for p in spec.places):
        spec.places.sort(key=lambda p: p.span)  # "beside the red block and touching it": told of it after that
    return spec


def check_built(clause: Clause, spec: Spec, scene: Scene) -> None:
    """Refuse "line up" of no blocks, and "build with seven cubes, flat on the table", which does not say what."""
    if not any(True for _ in scene.blocks()) and not spec.usings:
        raise refuse("no-goal", "it is not said which blocks", clause.word or clause.span, "name the blocks")
    if clause.verb == "build" and spec.usings and spec.places and not (spec.orders or spec.toward or spec.manners):
        raise refuse("no-goal", "it is not said what is built of them", clause.word or clause.span,
                     "say 'a tower', 'a row' or another structure")  # fmt: skip
