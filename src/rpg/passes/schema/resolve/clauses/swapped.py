""" "Swap the red and the blue block": each stands where the other began."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.schema import EXCHANGED
from rpg.ir.walk import names as names_in
from rpg.language.grammar.clauses.shared import are_patches
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, Structure, replace
from rpg.passes.schema.resolve.clauses.replacing import replace_there
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.conflicts import OPPOSITE
from rpg.passes.schema.resolve.orders.reordered import with_two_swapped
from rpg.passes.schema.resolve.places.relations import place
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spoken import as_it_stands
from rpg.passes.schema.resolve.things.things import Premise
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def swap(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "swap the red and the blue block", "swap A with B"; "replace A by B"."""
    if clause.verb == "replace":
        return replace_there(clause, spec, scene, scope)
    if isinstance(clause.theme, Coord) and clause.theme.op == "then":
        raise refuse("ambiguous", "it is not clear which of these change places with each other", clause.span,
                     "say 'swap' of each pair")  # fmt: skip
    told = len(scene.premises)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    _check_lots(clause, theme, scene)
    parts: tuple[Ref, ...] = theme.parts
    if spec.usings:
        other = refer(spec.usings.pop(0).members, scene, replace(scope, role="landmark"))
        parts = (theme, other)
    elif len(theme.names) == 2 and not isinstance(clause.theme, Structure):
        parts = tuple(Ref(names=(n,)) for n in theme.names)
    elif len(theme.built) == 2 and not parts:
        parts = tuple(Ref(names=built.members, built=(built,)) for built in theme.built)
    if len(parts) == 2:
        _one_on_each(theme, clause, spec, scene, scope)
    scene.premises[told:] = [_as_it_begins(premise) for premise in scene.premises[told:]]
    spec.manners = [m for m in spec.manners if m.kind != "idle"]
    if len(parts) != 2 or len(parts[0].names) != len(parts[1].names):
        raise refuse(
            "count-mismatch",
            "two blocks are swapped with each other",
            clause.span,
            "say 'swap the red block and the blue block'",
        )
    if any(p.patch for p in parts):
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", clause.span, "swap blocks")
    swap = r.Swapped(a=parts[0].names, b=parts[1].names, span=clause.span)
    only = spec.manner("only") is not None or theme.op == "only"
    pair = (*swap.a, *swap.b)
    line = with_two_swapped(*pair, scene, clause.span) if len(pair) == 2 else None
    whole = [goal for part in parts for goal in as_it_stands(part, scene)]
    return [
        swap,
        *whole,
        *([line] if line is not None else _on_each_others(parts[0], parts[1], scene, clause.span)),
        *(_others_stay(swap, scene) if only else ()),
    ]


def _others_stay(swap: r.Swapped, scene: Scene) -> list[g.Goal]:
    """ "Swap only A and B": the others stay where they are."""
    others = tuple(t.name for t in scene.blocks() if t.name not in (*swap.a, *swap.b))
    return [r.Stayed(a=others, span=swap.span)] if others else []


def _check_lots(clause: Clause, theme: Ref, scene: Scene) -> None:
    """Refuse "two red blocks are on the mat, two blue ones are not. They should swap" as the two spoken of last."""
    own = [m for m in scene.mentions if {*theme.names} <= {*m.ref.names} and m.clause < scene.clause]
    lots = [m.ref.names for m in scene.mentions if own and m.sentence == own[-1].sentence and m.role == "theme"]
    if isinstance(clause.theme, Pronoun) and any(len(n) > 1 and not {*n} & {*theme.names} for n in lots):
        raise refuse("ambiguous", "these with each other, or with those named before them?", clause.span,
                     "say 'swap the red ones with the blue ones'")  # fmt: skip


def _on_each_others(one: Ref, other: Ref, scene: Scene, span: Span) -> list[g.Goal]:
    """ "(Red on blue, green on yellow.) Swap red and green": each lies on what the other lay on; that whole towers
    change places is none of it."""
    if len(one.names) != 1 or len(other.names) != 1 or one.built or other.built:
        return []
    a, b = one.names[0], other.names[0]
    below = [scene.on_top.get(name) for name in (b, a)]
    begun = [{*names_in(x)} for x in scene.start_goals if isinstance(x, r.On | s.Stack)]
    there = all(low is not None and any({up, low} <= x for x in begun) for up, low in zip((b, a), below, strict=True))
    if not there or {a, b} & {*below} or below[0] == below[1]:
        return []
    return [r.On(a=(up,), b=(low,), span=span) for up, low in zip((a, b), below, strict=True) if low is not None]


def _one_on_each(theme: Ref, clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> None:
    """ "Swap the two cubes on the patches": each of them begins on one."""
    lain = [p for p in spec.places if isinstance(p, Loc) and p.rel == "on" and not p.negated]
    plain = isinstance(clause.theme, Noun) and clause.theme.plural and not any(m.ref.patch for m in scene.mentions)
    if plain and len(lain) == 1 and len(spec.places) == 1 and are_patches(lain[0].landmark):
        scene.start_goals += place(theme, lain[0], scene, replace(scope, start=True), clause.span)
        spec.places = []


def mere_result(goals: list[g.Goal], results: list[g.Goal], scene: Scene) -> list[g.Goal]:
    """ "A starts on B. Exchange them, so that B is on A": the start the other way round is all that is meant by the
    exchange, and nothing of where on the table it is to be."""
    if len(goals) != 1 or len(results) != 1 or not isinstance(swapped := goals[0], r.Swapped):
        return goals
    other = {swapped.a: swapped.b, swapped.b: swapped.a}
    result = results[0]
    if not any(_the_same(result, _exchanged(goal, other)) for goal in scene.start_goals):
        return goals
    scene.assume(EXCHANGED)
    return [result.model_copy(update={"span": swapped.span})]


def _exchanged(goal: g.Goal, other: dict[tuple[str, ...], tuple[str, ...]]) -> g.Goal | None:
    """A relation between the two that are swapped with each in the place of the other; None for what is no such."""
    a, b = getattr(goal, "a", None), getattr(goal, "b", None)
    return goal.model_copy(update={"a": other[a], "b": other[b]}) if a in other and b in other and a != b else None


def _the_same(one: g.Goal, other: g.Goal | None) -> bool:
    """ "red is right of blue" says what "blue is left of red" says."""
    if other is None:
        return False
    told, meant = one.model_dump(exclude={"span"}), other.model_dump(exclude={"span"})
    turned = {**meant, "kind": OPPOSITE.get(other.kind), "a": meant["b"], "b": meant["a"]}
    return told in (meant, turned)


def _as_it_begins(premise: Meaning) -> Meaning:
    """ "swap A, which is on the mat, with B": what changes its place is told of as it begins."""
    if isinstance(premise, Premise) and isinstance(premise.condition, Loc):
        return replace(premise, condition=replace(premise.condition, mods=()))
    return premise
