"""What a clause about the end says of the start besides."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Chain, Clause, Loc, Manner, Meaning, Noun, PartOf, TableTop, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.reordered import FIRST, LAST
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def was_so(goals: list[g.Goal], clause: Clause, spec: Spec, scene: Scene) -> None:
    """ "the red block is no longer on the patch", "... on the patch, where it starts": it is so at the start."""
    gone, begun = spec.manner("gone"), spec.manner("begun")
    if gone is not None and getattr(clause.theme, "word", "") in ("nothing", "none of them") and scene.start_goals:
        return  # "clear the mat, so that nothing is on it any more": what was on it has been told
    if gone is not None and not clause.negated:
        raise refuse("misplaced", "this goes with 'not'", gone.span, "say 'no longer'")
    if gone is not None or begun is not None:
        parts = [part for goal in goals for part in (goal.goals if isinstance(goal, g.All) else (goal,))]
        facts = [part.goal if isinstance(part, g.Not) else part for part in parts]
        placed = [fact for fact in facts if isinstance(fact, r.On | r.OnPatch)]
        if begun is not None and not placed:
            raise refuse("ambiguous", "it is not clear what is so at the start", begun.span, "say it in two sentences")
        scene.start_goals += [fact for fact in placed if fact not in scene.start_goals]


def laid_down(clause: Clause, spec: Spec) -> bool:
    """ "put a long blue patch on the table": patches are there from the start."""
    theme = clause.theme
    new = isinstance(theme, Noun) and theme.head == "patch" and theme.det in ("a", "bare") and theme.amount is not None
    table = [p for p in spec.places if isinstance(p, Loc) and p.rel == "on" and isinstance(p.landmark, TableTop)]
    if not new or clause.verb != "place" or clause.negated or len(table) != 1 or len(clause.adjuncts) != 1:
        return False
    spec.places = []
    return True


def and_in_the_end(chain: Chain) -> Chain:
    """ "They start touching, at the end 20 cm apart": what stands behind "at the end" is no longer of the start."""
    links: list[str] = []
    clauses: list[Meaning] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        parts = [clause]
        if isinstance(clause, Clause) and clause.mode in ("start", "given"):
            whens = [n for n, a in enumerate(clause.adjuncts) if isinstance(a, Manner) and a.kind == "finally"]
            if whens and 0 < whens[0] < len(clause.adjuncts) - 1:
                start = replace(clause, adjuncts=clause.adjuncts[: whens[0]])
                parts = [start, replace(clause, mode="goal", adjuncts=clause.adjuncts[whens[0] + 1 :])]
        links += [link, "and"][: len(parts)]
        clauses += parts
    return replace(chain, links=tuple(links), clauses=tuple(clauses)) if len(clauses) > len(chain.clauses) else chain


def partly(clause: Clause, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "start partially stacked": two of the blocks, in a way that the goal does not ask for."""
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    pairs = [(a, b) for a in theme.names for b in theme.names if a != b and scene.on_top.get(a) != b]
    pairs.sort(
        key=lambda two: (scene.on_top.get(two[1]) == two[0], theme.names.index(two[0]) < theme.names.index(two[1]))
    )
    if clause.mode != "start" or not pairs:
        raise refuse("misplaced", "only a start can be partial", clause.span, "say which block goes on which")
    scene.assume("partially stacked at the start: one block lies on another")
    return [r.On(a=(pairs[0][0],), b=(pairs[0][1],), span=clause.span)]


def taken_out(theme: Ref, source: Meaning, scene: Scene, scope: Scope) -> None:
    """ "Pull the red block out of the bottom of the tower": it is there at the start, as was told."""
    part = source.part if isinstance(source, PartOf) else None
    whole = source.whole if isinstance(source, PartOf) and source.whole is not None else source
    home = refer(whole, scene, replace(scope, role="landmark"))
    scene.mentions.pop()
    begun = {name for goal in scene.start_goals for name in names_in(goal)} | {n for heap in scene.heaps for n in heap}
    if not home.built or not set(theme.names) < set(home.names) <= begun:
        raise refuse("no-referent", "it is not said that this is in there at the start", source.span,
                     "say for example 'there is a tower: red, blue, white from the bottom'")  # fmt: skip
    built = home.built[-1]
    if part is None or (part == "middle" and not {*theme.names} & {built.members[0], built.members[-1]}):
        return
    first = built.side or FIRST.get(built.kind, "")
    ends = {first: built.members[:1], LAST.get(first, ""): built.members[-1:]}
    if not built.ordered or ends.get(part) != theme.names:
        raise refuse("contradiction", f"this is not said to be at the {part} at the start", source.span,
                     "name the block that is there")  # fmt: skip
