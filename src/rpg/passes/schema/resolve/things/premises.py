"""What relative clauses take for granted: "the block that is on the patch" says where it starts."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.schema import NONE_BESIDES
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Coord, In, Loc, Manner, Noun, replace
from rpg.passes.schema.resolve.clauses.throughout import held_throughout
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.goals.logic import conj, denied
from rpg.passes.schema.resolve.places.alone import beyond
from rpg.passes.schema.resolve.places.relations import place
from rpg.passes.schema.resolve.things.things import Premise, alike, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def keep_premises(goal: g.Goal, scene: Scene) -> g.Goal:
    """Premises hold at the start; what is asserted at the end too; blocks other than those alone moved stay put."""
    kept: list[g.Goal] = []
    scene.clause += 1
    while scene.premises:
        kept += _facts(scene.premises.pop(0), scene)
    for span in scene.held.values():
        raise refuse("no-goal", "a block that is held has no place at the end", span, "say where to put it down")
    for alone in scene.exclusive:
        others = beyond(alone, scene)
        if not others and alone.names and not (isinstance(goal, g.All) and not goal.goals):
            scene.assume(NONE_BESIDES)
        elif not others:
            raise refuse("no-referent", "there is no other block", alone.span, "say which other blocks there are")
        kept += [denied(alone.there(n), alone.span) for n in others]
        for name in others:  # a distractor that has to stay away is one of the task's blocks
            scene.things[name].extra = False
            scene.ignored.pop(name, None)
    still = tuple(t.name for t in scene.blocks() if t.name not in scene.only) if scene.only else ()
    if still:
        kept.append(r.Stayed(a=still))
    kept += _without_their_top(conj([goal, *kept]), scene)
    goal = conj([goal, *kept]) if kept else goal
    scene.start_goals += [x for x in _lasting(goal, scene) if x not in scene.start_goals]
    return goal


def _without_their_top(goal: g.Goal, scene: Scene) -> list[g.Goal]:
    """ "(There is a tower of three red blocks.) Put the top one on the mat": it is parted from the others, which stay a
    tower, if no more is said of them. Without that the whole tower on the mat would do, for they look alike. What is
    put on it, or beside it, leaves it there."""
    parts = [*required(goal)]
    told = {n for x in parts if not isinstance(x, g.Not) for n in names_in(x)}
    off = {n for x in parts if isinstance(x, g.Not) and isinstance(x.goal, r.Above) for n in members(x.goal.a)}
    found: list[g.Goal] = []
    for top, below in scene.taken.items():
        if top not in told | off or told & {*below}:
            continue
        if top not in off and not any(top in _moved(x) for x in parts):
            tower = (*below, top)
            found.append(s.Stack(blocks=tower, order=_as_it_stood(tower, scene)))
            continue
        if len(below) > 1:
            found.append(s.Stack(blocks=below, exact=True, order=_as_it_stood(below, scene)))
        else:
            found += [g.Not(goal=r.Above(a=(a,), b=(b,))) for a, b in ((top, *below), (*below, top))]
    return found


_PLACED_BY = (r.On, r.Above, r.Directional, r.Beside, r.Adjacent, r.Touching, r.Near)


def _moved(goal: g.Goal) -> set[str]:
    """The blocks that a goal says something of, and not those that others are placed by."""
    return {*names_in(goal)} - {*members(goal.b)} if isinstance(goal, _PLACED_BY) else {*names_in(goal)}


def _as_it_stood(blocks: tuple[str, ...], scene: Scene) -> Order:
    """The order of blocks from bottom to top, where they can be told apart."""
    if alike([scene.things[name] for name in blocks]):
        return Order()
    return Order(by="given", ranks=tuple((name,) for name in blocks), first="bottom")


def _lasting(goal: g.Goal, scene: Scene) -> list[g.Goal]:
    """ "Don't touch the tower of red on blue": a structure of blocks that all stay where they are is there at first."""
    parts = list(required(goal))
    stay = {n for x in parts if isinstance(x, r.Stayed) for n in names_in(x)} - scene.returned
    lasting: list[g.Goal] = [x for x in parts if isinstance(x, s.Stack | s.Row | r.On) and stay.issuperset(_blocks(x))]
    if lasting and all(x in lasting or isinstance(x, r.Stayed) for x in parts):
        raise refuse("no-goal", "no block that this speaks of may be moved, so that nothing is to be done",
                     lasting[0].span, "say which block is to be moved")  # fmt: skip
    return lasting


def _blocks(goal: s.Stack | s.Row | r.On) -> set[str]:
    patch = goal.patch if isinstance(goal, s.Stack) else None
    return set(names_in(goal)) - {patch}


def _named_since(condition: Loc | In, scene: Scene) -> Loc | In:
    """ "Green, which is left of a blue block, is on the mat. Put red on blue": the blue block that is named behind."""
    mark = condition.landmark if isinstance(condition, Loc) else None
    if not isinstance(mark, Noun) or not isinstance(condition, Loc) or mark.det != "a" or mark.head == "patch":
        return condition
    there = matching(mark.traits, scene, False)
    known = [m.ref for m in scene.mentions if len(there) == 1 and there[0].name in m.ref.names]
    behind = all(ref.span > mark.span and ref.det in ("the", "bare") and len(ref.names) == 1 for ref in known)
    return replace(condition, landmark=replace(mark, det="the")) if known and behind else condition


def _facts(premise: object, scene: Scene) -> list[g.Goal]:
    """What a premise says of the end; what it says of the start is noted. Its landmark may have one of its own."""
    if not isinstance(premise, Premise):
        return []
    if isinstance(premise.condition, Manner) and premise.condition.kind == "stay":
        return [r.Stayed(a=premise.names, span=premise.span)]
    if not isinstance(premise.condition, Loc | In):
        raise refuse("misplaced", "it is not clear of what this is said", premise.span, "say it in its own sentence")
    theme = Ref(names=premise.names, built=premise.built, span=premise.span)
    if isinstance(getattr(premise.condition, "landmark", None), Coord):
        raise refuse("ambiguous", "it is not clear which block is where", premise.span, "say it of each block")
    scene.describing = premise.when == "end"
    condition = _named_since(premise.condition, scene)
    facts = place(theme, condition, scene, Scope(start=premise.when != "end"), premise.span)
    facts = [f for f in facts if not (isinstance(f, g.All) and not f.goals)]
    if premise.when == "always":
        return held_throughout(facts, scene, premise.span)
    asserted = "asserted" in getattr(premise.condition, "mods", ())
    if premise.when != "end" and not asserted:
        scene.start_goals += [f for f in facts if f not in scene.start_goals]
    return facts if asserted or premise.when != "start" else []
