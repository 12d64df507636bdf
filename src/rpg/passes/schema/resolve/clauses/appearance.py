"""Clauses about how blocks look: "both blocks are blue", "the patch is long"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.assets import EDGE
from rpg.ir.schema import COLORS_BARRED
from rpg.language.meaning import Clause, Meaning, Noun, Pronoun, Quality, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.so_many_of import so_many_of
from rpg.passes.schema.resolve.things.operands import crown
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import check_cubes, give
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse, said


def appear(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """Let the objects have the looks that the clause gives them; "empty" and "clear" are goals."""
    if all(q.traits == Traits(empty=True) for q in spec.qualities):
        return _empty(clause, spec, scene, scope)
    if isinstance(clause.theme, Noun) and clause.theme.conditions and clause.mode == "goal":
        raise refuse("ambiguous", "is this so at the start, or at the end?", clause.theme.conditions[0].span,
                     "say 'at the start' or 'must be'")  # fmt: skip
    listed = [q for q in spec.qualities if len(set(q.traits.colors)) < len(q.traits.colors)]
    if listed and isinstance(clause.theme, Structure):  # "the row is red, blue, red"
        raise refuse("misplaced", "this lists the blocks one by one", listed[0].span, "say from which side on")
    if any(q.traits.scheme == "mixed" for q in spec.qualities):
        raise refuse("misplaced", "it is not said how these are mixed", clause.span,
                     "say 'alternating', or in which order the colours come")  # fmt: skip
    said_of = _told_by_size(clause.theme, spec, scene)
    theme = refer(said_of, scene, Scope(given=scope.given)) if said_of is not None else Ref()
    if theme.table:
        raise refuse("misplaced", "the table has one look", clause.span)
    if getattr(clause.theme, "det", "") == "not all":
        raise refuse("misplaced", "looks can be given, not excluded", clause.span, "say which colour they have")
    if clause.negated or (theme.quant is not None and theme.quant.high == 0):
        return _barred(theme, clause, spec, scene)
    several = next((q for q in spec.qualities if len(q.traits.colors) > 1), None)
    if several is not None and theme.built and all(scene.things[n].color for n in theme.names):
        raise refuse("ambiguous", "are these the colours that it has, or an order that it should have?", several.span,
                     "say from which side on, and of the start 'there is a row of A, B and C'")  # fmt: skip
    if theme.part is not None:
        raise refuse("no-referent", f"it is not clear which block the {theme.part} is", theme.span, "name the block")
    _one_of_several(clause.theme, theme, spec, scene)
    if isinstance(clause.theme, Pronoun) and theme.plural and any(q.traits.colors for q in spec.qualities):
        theme = _all_open(theme, scene)
    theme = _so_many_alike(theme, scene)
    for quality in spec.qualities:
        _give(theme, quality, clause, scene)
    spec.qualities = []
    return []


def _so_many_alike(theme: Ref, scene: Scene) -> Ref:
    """ "One of the Os is blue": one of those of no told colour, whichever it is of several that look alike."""
    quant, things = theme.quant, [scene.things[n] for n in theme.names]
    if quant is None or theme.patch or quant.low >= len(things):
        return theme
    open_ = [t for t in things if t.color is None]
    alike = len({(t.label, t.size) for t in open_}) == 1 and open_[0].label is not None
    if not alike or not 0 < quant.low <= len(open_) or theme.op != "and":
        raise refuse("ambiguous", "it is not clear which of these look so, and how the others look", theme.span,
                     "say how many blocks there are of each look")  # fmt: skip
    return replace(theme, names=tuple(t.name for t in open_[: quant.low]), quant=None)


def _barred(theme: Ref, clause: Clause, spec: Spec, scene: Scene) -> list[g.Goal]:
    """ "None of them is green": so that what is left open of their colours is chosen otherwise."""
    things = [scene.things[n] for n in theme.names]
    colors = frozenset(color for q in spec.qualities for color in q.traits.colors)
    told = all(replace(q.traits, either=False) == Traits(colors=q.traits.colors) for q in spec.qualities)
    some = theme.op != "and" or (theme.quant is not None and theme.quant.high != 0)
    some = some or spec.manner("not all") is not None
    listed = theme.built and any(len(q.traits.colors) > 1 and not q.traits.either for q in spec.qualities)
    if listed:  # "the row must not be red, blue, green"
        raise refuse("ambiguous", "none of these colours, or not in this order?", clause.span, "say 'red or blue'")
    known = theme.part is not None or (len(things) == 1 and not _open(things[0]))
    if not told or not things or theme.patch or some or known:
        raise refuse("misplaced", "looks can be given, not excluded", clause.span, "say which colour they have")
    for thing in things:
        if thing.color in colors:
            raise refuse("contradiction", f"{said(thing)} is said not to be {thing.color}", clause.span,
                         "name one colour")  # fmt: skip
        thing.barred |= colors
    scene.assume(f"{COLORS_BARRED}: {', '.join(sorted(colors))}")
    spec.qualities = []
    return []


def _open(thing: Thing) -> bool:
    """Whether nothing was said of how a block looks."""
    return thing.color is None and thing.label is None


def _one_of_several(said_of: Meaning | None, theme: Ref, spec: Spec, scene: Scene) -> None:
    """Refuse "exactly one block is on the patch, and it is red" as said of the patch, where blocks may be red."""
    chosen = [m.ref for m in scene.mentions if m.ref.quant is not None and m.clause >= scene.clause - 1]
    looks = {scene.things[n].color for ref in chosen if not ref.patch for n in ref.names}
    given = {color for q in spec.qualities for color in (None, *q.traits.colors)}
    if isinstance(said_of, Pronoun) and theme.patch and len(given) > 1 and looks & given:
        raise refuse("ambiguous", "this could be said of the block or of the patch", said_of.span, "name it")


_COMPARED = {"larger": "big", "smaller": "small"}


def _told_by_size(theme: Meaning | None, spec: Spec, scene: Scene) -> Meaning | None:
    """ "The small one is blue": of what colour it is, is said by this."""
    colored = any(len(q.traits.colors) == 1 for q in spec.qualities)
    one = isinstance(theme, Noun) and theme.head != "patch" and theme.det == "the" and not theme.plural
    if not colored or not one or not isinstance(theme, Noun):
        return theme
    marks = theme.traits
    sizes = [t.size for t in scene.blocks()]
    if marks.rank in _COMPARED and sizes in ([], ["big" if marks.rank == "smaller" else "small"]):
        marks = replace(marks, rank=None, size=_COMPARED[marks.rank])
    return replace(theme, head="block", traits=marks) if marks.size or marks.edge else theme


def _all_open(theme: Ref, scene: Scene) -> Ref:
    """ "Three blocks on the left and two on the right. They are all white": all of which no look was said yet."""
    things = [t for t in scene.blocks() if t.color is None and t.label is None and t.kind is None and not t.extra]
    names = tuple(t.name for t in things)
    return replace(theme, names=names) if set(theme.names) < set(names) else theme


def _empty(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "the patch stays empty", "keep the top of the red block clear"."""
    if _one_of_the_patches(clause.theme, scene):
        scope = replace(scope, like_patch=True)
    theme = refer(clause.theme, scene, scope) if clause.theme is not None else Ref()
    spec.qualities = []
    if isinstance(clause.theme, Pronoun) and not theme.patch and any(m.ref.patch for m in scene.mentions):
        raise refuse("ambiguous", "it is not clear which is to be empty", clause.span, "name the patch or the block")
    if theme.patch:
        return [so_many_of([r.Empty(patch=p, span=clause.span) for p in theme.names], theme, clause.span)]
    if not theme.names:
        raise refuse(
            "misplaced", "patches can be empty, and blocks clear on top", clause.span, "name a patch or a block"
        )
    return [r.Clear(a=crown(theme), span=clause.span)]


def _one_of_the_patches(theme: Meaning | None, scene: Scene) -> bool:
    """ "(Both go on the red patch,) and the black one stays empty": no block, where patches are spoken of."""
    one = isinstance(theme, Noun) and theme.head == "any" and bool(theme.traits.colors)
    return one and any(t.patch for t in scene.things.values())


def _give(theme: Ref, quality: Quality, clause: Clause, scene: Scene) -> None:
    traits = quality.traits
    if isinstance(clause.theme, Structure) and clause.theme.kind == "equation" and quality.traits.labels:
        raise refuse("incomplete", "it is not said which numbers these are", clause.span,
                     "write the whole equation, as in 'make 4 + 6 = 10'")  # fmt: skip
    if traits.rank or traits.target or traits.matching or (traits.labels and len(traits.labels) != 1):
        raise refuse(
            "misplaced", "this is understood, but is no look that can be given", quality.span, "say it as a place"
        )
    told = len(traits.colors) if len(traits.colors) > 1 and not theme.patch else None  # "the cubes are red and blue"
    things = [scene.things[n] for n in scene.fit(theme.names, told)]
    if any(not thing.patch for thing in things):
        check_cubes(traits, quality.span)
    if traits == Traits(scheme="some"):
        raise refuse("misplaced", "it is not said what colour these have", quality.span, "name the colour")
    if traits.extra:
        for thing in things:
            thing.extra = True
        return
    if len(traits.colors) > 1 and len(traits.colors) != len(things):
        raise refuse(
            "count-mismatch",
            f"{len(traits.colors)} colours for {len(things)} objects",
            quality.span,
            "name one colour for each",
        )
    before = any({*m.ref.names} & {*theme.names} for m in scene.mentions if m.clause < scene.clause)
    if len(traits.colors) > 1 and before and all(thing.patch and not thing.declared for thing in things):
        raise refuse("ambiguous", "it is not said which of the patches has which of these colors", quality.span,
                     "name the color of each patch where you say what lies on it")  # fmt: skip
    for index, thing in enumerate(things):
        color = traits.colors[index if len(traits.colors) > 1 else 0] if traits.colors else None
        if color and thing.color not in (None, color):
            raise refuse(
                "contradiction",
                f"{said(thing)} is said to be {color} here",
                quality.span,
                "name one colour",
                labels=((theme.span, f"{thing.color} here"),),
            )
        if traits.labels and thing.label not in (None, traits.labels[0]):
            raise refuse("contradiction", f"{said(thing)} is said to show {traits.labels[0]} here", quality.span,
                         "name one symbol")  # fmt: skip
        if _of_another_size(thing, traits):
            raise refuse(
                "contradiction", f"another size of {said(thing)} is told before", quality.span, "name one size"
            )
        give(thing, replace(traits, colors=(color,) if color else ()))
        if traits.scheme:
            thing.scheme = traits.scheme
        if traits.kind and thing.kind is None:
            thing.kind = traits.kind
        thing.claims -= 1


def _of_another_size(thing: Thing, traits: Traits) -> bool:
    """Whether a block or patch of which a size was told cannot have this one."""
    if thing.edge is not None and traits.edge is not None:
        return thing.edge != traits.edge
    sizes = {size for size in (thing.size, traits.size) if size is not None}
    edge = (thing.edge or traits.edge) if not thing.patch else None
    sizes |= {"big" if edge > EDGE else "small" if edge < EDGE else "medium"} if edge and sizes else set()
    return len(sizes) > 1
