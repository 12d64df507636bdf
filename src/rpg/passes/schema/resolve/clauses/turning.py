"""Verbs about the start: keep, leave, move, pick up, take off."""

from __future__ import annotations

from functools import partial
from itertools import pairwise, product

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.structures import GroupBy, Stack
from rpg.ir.walk import atoms
from rpg.language.grammar.clauses.absent import nothing_at_all
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    That,
    Using,
    replace,
)
from rpg.passes.schema.resolve.clauses.begun_facts import as_begun
from rpg.passes.schema.resolve.clauses.kept import left_so, of_what_is_built, put_so
from rpg.passes.schema.resolve.clauses.left_alone import not_elsewhere
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.clauses.started import taken_out
from rpg.passes.schema.resolve.clauses.taken_apart import pile_of
from rpg.passes.schema.resolve.clauses.throughout import held_throughout
from rpg.passes.schema.resolve.clauses.whose_turn import is_none, neither, turned_of, unturned
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.places.bare_table import is_table, lies_on
from rpg.passes.schema.resolve.places.moved import put_there
from rpg.passes.schema.resolve.places.placing import absolutes
from rpg.passes.schema.resolve.places.relations import place
from rpg.passes.schema.resolve.places.stacking import Towers
from rpg.passes.schema.resolve.things.operands import crown, spread
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spoken import as_it_stands
from rpg.passes.schema.resolve.things.theirs import off_which
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Goals = list[g.Goal]


def keep(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "leave the red block where it is", "keep the blue block on the table"."""
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    stays = [m for m in spec.manners if m.kind == "stay"]
    ever = any(m.kind == "always" for m in spec.manners)
    spec.manners = [m for m in spec.manners if m.kind not in ("stay", "always")]
    if spec.places and not stays:
        goals: Goals = []
        stood = left_so(clause, theme, scene)
        for item in spec.places:
            goals += place(theme, item, scene, scope, clause.span)
        spec.places = []
        stood = stood and not of_what_is_built(goals, scene)
        if (clause.lemma == "keep" and not put_so(clause, theme, scene)) or ever or stood:
            there = len(scene.start_goals)
            found = held_throughout(goals, scene, clause.span)
            goals = goals if stood and not ever else list(found)
            scene.kept += [] if ever else [(kept, scene.start_goals[there:]) for kept in goals]
        if spec.absolutes and not ever:  # "keep red and blue apart, with yellow between them"
            scene.mention(theme, "theme")
            goals += absolutes(theme, spec, scene, scope)
        return goals
    more = [x for item in spec.places for x in place(theme, item, scene, scope, clause.span)]
    spec.places = []
    if clause.verb == "place":
        scene.returned.update(theme.names)
    stayed = _stayed(theme, clause.span)
    if any(m.value == "wholly" for m in stays):
        scene.untouched.update(theme.names)
    if isinstance(clause.theme, Structure) and stays:  # "leave the tower of red and blue alone": it is there
        _there_already(scene)
    return [g.Always(goal=stayed, span=clause.span) if ever else stayed, *more]


def _there_already(scene: Scene) -> None:
    """What the clause builds is how it starts; a group that is taken apart is a heap then."""
    begun = scene.goals.pop(scene.clause, [])
    heaps = [lot for x in begun if isinstance(x, GroupBy) for lot in x.groups]
    scene.heaps += heaps
    scene.start_goals += [] if heaps else begun


def _stayed(theme: Ref, span: Span) -> g.Goal:
    if theme.patch or theme.table:
        raise refuse("fixed-patch", "patches and the table never move", theme.span, "name blocks")
    if not theme.names:
        raise refuse("no-referent", "there is no such block", theme.span)
    if theme.op == "only":
        raise refuse("ambiguous", "it is not said what becomes of the others", theme.span, "say where they should be")
    if theme.quant is not None or theme.mixed:
        return spread(theme, lambda a: r.Stayed(a=a, span=span), span, together=True)
    return r.Stayed(a=tuple(dict.fromkeys((*theme.not_acted_on, *theme.names))), span=span)


def stay(clause: Clause, spec: Spec, scene: Scene, scope: Scope, stays: bool) -> Goals:
    """ "do not move the red block" (the negation is in the verb's meaning), "move ..." alone: moved."""
    of_any = clause.negated and getattr(clause.theme, "det", "") == "any"
    told = _moved_theme(clause) if of_any else neither(clause.theme)
    theme = refer(told, scene, scope) if told else Ref()
    if not stays and not is_none(theme):
        raise refuse(
            "no-goal", "touching a block leaves nothing to check", clause.span, "say where the block should be"
        )
    if clause.lemma != "move":
        scene.untouched.update(theme.names)
    if not stays:  # "neither of them may be touched"
        return [r.Stayed(a=theme.names, span=clause.span)]
    return [g.Not(goal=_stayed(theme, clause.span), span=clause.span)]


def moved(theme: Ref, scene: Scene, span: Span) -> Goals:
    """ "Move the red block", of which no more is said; "move neither of them"."""
    if is_none(theme):
        return [r.Stayed(a=theme.names, span=span)]
    others = tuple(thing.name for thing in scene.blocks() if thing.name not in theme.names)
    if theme.op == "only" and not others:
        raise refuse("ambiguous", "it is not said what becomes of the others", span, "say which others there are first")
    scene.assume("moved: at least 5 cm away from where it started")
    still = [r.Stayed(a=others, span=span)] if theme.op == "only" else []
    return [*still, spread(theme, lambda a: r.Moved(a=a, span=span), span, together=True)]


def without(that: That, scene: Scene, turned: bool = False) -> Goals:
    """ "without moving the red block", "without touching it"; what is `turned` itself may be what is not moved."""
    goals: Goals = []
    chain = that.clauses
    for clause in chain.clauses if isinstance(chain, Chain) else ():
        if not isinstance(clause, Clause):
            continue
        manners = [m for m in clause.adjuncts if isinstance(m, Manner)]
        lasting = any(m.kind == "always" for m in manners)
        if any(m.kind == "time" for m in manners):
            raise refuse("ambiguous", "it is not clear when this is forbidden", that.span, "say 'without ever ...'")
        clause = not_elsewhere(clause)
        if clause.verb in ("place", "touch", "turn", "swap", "pick") and len(clause.adjuncts) == lasting:
            before = len(scene.goals.get(scene.clause, []))
            own = clause.verb == "turn" or (turned and isinstance(clause.theme, Pronoun) and clause.theme.word in _OWN)
            role = "theme" if own else "landmark"  # what is moved anyway is not turned
            theme = refer(as_begun(_moved_theme(clause)), scene, Scope(role=role))
            scene.start_goals += scene.goals.get(scene.clause, [])[before:]
            del scene.goals.get(scene.clause, [])[before:]
            still = _untouched(clause, theme, scene, that.span)
            goals.append(g.Always(goal=still, span=that.span) if lasting else still)
        elif clause.verb in ("place", "stack", "use"):
            from rpg.passes.schema.resolve.clauses.clauses import clause_goals

            if clause.verb == "use":
                raise refuse("misplaced", "only blocks that are called for are used", that.span, "leave this out")
            goals += clause_goals(nothing_at_all(replace(clause, negated=not clause.negated)), scene, False)
        else:
            raise refuse("misplaced", "this cannot be forbidden here", clause.span, "say 'without moving ...'")
    return goals


def _untouched(clause: Clause, theme: Ref, scene: Scene, span: Span) -> g.Goal:
    """ "next to the red block without touching it" is about the two blocks; else the block stays where it is."""
    if clause.verb == "turn":
        return conj(turned_of(theme, partial(unturned, span=span), span, done=True), span)
    now = [m for m in scene.mentions if m.clause == scene.clause]
    placed = next((m.ref for m in now if m.role == "theme" and m.ref.names), None)
    marks = {n for m in now if m.role == "landmark" and m.rel not in ("", "on") for n in m.ref.names}
    of_these = not isinstance(clause.theme, Pronoun) or clause.theme.word in _LANDMARKS
    if clause.verb == "touch" and placed is not None and of_these and marks & set(theme.names):
        pairs = product(placed.names, theme.names)
        return conj([g.Not(goal=r.Touching(a=(a,), b=(b,), span=span), span=span) for a, b in pairs], span)
    if clause.verb == "touch":
        scene.untouched.update(theme.names)
    return _stayed(theme, span)


_LANDMARKS = frozenset({"it", "them", "this", "that", "these", "those", "both", "both of them", "either of them"})
"""Pronouns for what something is put beside, as "the others" are not."""
_OWN = frozenset({"it", "them"})
"""Pronouns for what is turned: "turn it without moving it"."""


def _moved_theme(clause: Clause) -> Meaning:
    """ "without moving a blue block", "do not move any of them": all that there are."""
    if (
        isinstance(clause.theme, Noun)
        and clause.theme.det in ("any", "a")
        and clause.theme.amount in (None, Amount(1, 1))
    ):
        some = clause.theme.part_of
        return some if isinstance(some, Pronoun) else replace(clause.theme, det="all", amount=None, plural=True)
    if isinstance(clause.theme, Pronoun) and clause.theme.word == "either of them":
        return replace(clause.theme, word="them")  # "without moving either of them"
    if isinstance(clause.theme, Pronoun) and clause.theme.word == "anything else":
        return replace(clause.theme, word="all the others")
    return neither(clause.theme) or Pronoun(word="everything", span=clause.span)


def pick(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "pick up the red block" (and put it ...): on its own it is no goal that can be checked at rest."""
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    off = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("off", "apart")]
    if clause.negated:
        return _unlifted(theme, spec, clause)
    if clause.lemma == "take" and off:
        return remove(clause, spec, scene, scope, theme)
    if spec.places and (clause.lemma == "take" or _laid_on(spec)):
        goals = [x for item in spec.places for x in place(theme, item, scene, scope, clause.span)]
        spec.places = []
        return [*(as_it_stands(theme, scene) if theme.built else ()), *goals]
    if isinstance(clause.theme, Noun) and clause.theme.det == "both":
        _both_there(theme, scene)
    scene.picked = clause.span
    scene.held.update(dict.fromkeys(theme.names, clause.span))
    if len(spec.usings) == 1 and spec.usings[0].lead == "out of":
        taken_out(theme, spec.usings.pop(0).members, scene, scope)
    if len(spec.usings) == 1 and spec.usings[0].lead == "from":
        picked_from(theme, spec.usings.pop(0), scene, scope, clause.span)
    return []


def _both_there(theme: Ref, scene: Scene) -> None:
    """ "Take both yellow blocks, put one ...": these there are, and nothing is said of either yet."""
    for name in theme.names:
        scene.things[name].declared = True
    scene.used.difference_update(theme.names)


def _laid_on(spec: Spec) -> bool:
    """ "lift the orange block onto the gray one": where it comes to lie."""
    told = all(isinstance(p, In) or (isinstance(p, Loc) and p.rel == "on" and not p.negated) for p in spec.places)
    return told and not spec.usings


def _unlifted(theme: Ref, spec: Spec, clause: Clause) -> Goals:
    """ "never lift the red block off the table": it lies there all the time."""
    places = spec.places
    table = len(places) == 1 and is_table(places[0])
    if not table or not theme.names or theme.quant is not None:
        raise refuse("no-goal", "picking a block up leaves nothing to check", clause.span, "say 'do not move ...'")
    spec.places = []
    if not any(m.kind == "always" for m in spec.manners):
        spec.manners.append(Manner(kind="always", span=clause.span))
    return [g.Not(goal=r.OnTable(a=theme.names, span=clause.span), span=clause.span)]


def moved_from(theme: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span) -> None:
    """ "move the red block from the blue patch to the green one": where it starts."""
    for using in [using for using in spec.usings if using.lead == "from"]:
        late = any(place.span[0] < using.span[0] for place in spec.places)
        if isinstance(using.members, Noun) and using.members.det == "the" and not using.members.plural and not late:
            spec.usings.remove(using)
            picked_from(theme, using, scene, scope, span)


def picked_from(theme: Ref, using: Using, scene: Scene, scope: Scope, span: Span) -> None:
    """ "pick up the red block from the blue patch": where it starts, and is no longer."""
    loc = Loc(rel="on", landmark=using.members, span=using.span)
    before = Towers.of(scene)
    scene.start_goals += place(theme, loc, scene, replace(scope, start=True), span)
    before.after(scene, start=True, denied=True)
    for name in theme.names:
        scene.on_clause.pop(name, None)


def remove(clause: Clause, spec: Spec, scene: Scene, scope: Scope, theme: Ref | None = None) -> Goals:
    """ "take the red block off the blue one", "unstack the blocks", "clear the patch"."""
    theme = theme or (refer(clause.theme, scene, scope) if clause.theme else Ref())
    if theme.patch:
        return [r.Empty(patch=p, span=clause.span) for p in theme.names]
    if theme.part == "top" and clause.lemma in ("clear", "empty") and not spec.places:
        return [r.Clear(a=crown(theme), span=clause.span)]
    if theme.table:
        raise refuse("out-of-reach", "blocks cannot leave the table", clause.span, "say where they should go")
    sources: list[Meaning] = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("off", "apart")]
    sources = sources or [p for p in spec.places if clause.lemma == "remove" and lies_on(p)]
    undone = clause.verb == "unstack" and not clause.negated  # onto the table, where else
    rest = [p for p in spec.places if p not in sources and not (undone and is_table(p))]
    landmarks = [p.landmark for p in sources if isinstance(p, Loc)] + [u.members for u in spec.usings]
    spec.places, spec.usings = rest, []
    goals: Goals = []
    if theme.quant is not None and landmarks and not rest:
        return _so_many_off(theme, [landmark for landmark in landmarks if landmark], scene, scope, clause.span)
    for landmark in filter(None, landmarks):
        mark = refer(landmark, scene, replace(scope, role="landmark"))
        if mark.matching:
            raise off_which(clause.span)
        goals += _off(theme, mark, scene, clause.span)
    if rest:
        if undone and not landmarks and len(theme.names) > 1:
            raise refuse("ambiguous", "is it there, or do its blocks go there?", clause.span, "say it in two sentences")
        for item in rest:
            goals += place(theme, item, scene, scope, clause.span)
        spec.places = []
        return goals
    if clause.verb == "unstack" and not landmarks and not clause.negated:
        theme = pile_of(theme, clause.theme, scene)
    names = theme.names
    if theme.op == "only" and not clause.negated:  # "remove only the top one": the others stay
        scene.only += names
    if theme.quant is not None and not landmarks:
        raise refuse("ambiguous", "it is not clear which of these are meant", clause.span, "name the blocks")
    if clause.negated:
        if not goals:
            raise refuse("misplaced", "it is not clear what must not be taken away", clause.span, "say 'do not move'")
        return [conj(goals, clause.span)]
    if clause.verb == "unstack":
        scene.unstacked.update(names)
        _there_already(scene) if theme.built else None
    if not landmarks and clause.lemma in _AWAY:
        if below := _under(theme, scene):
            scene.assume("a block that is removed is put on the table")
            goals.append(g.Not(goal=r.On(a=theme.names, b=below, span=clause.span), span=clause.span))
        elif gone := _off_its_patch(theme, scene, clause.span):
            return gone
        else:
            raise refuse("no-goal", "blocks cannot leave the table; it is not said where they should go", clause.span,
                         "say 'take the red block off the blue block'")  # fmt: skip
    if len(names) > 1 and not landmarks and not _stacked_at_start(names, scene) and not _built_before(theme, scene):
        from rpg.ir import structures as s

        scene.start_goals.append(s.Stack(blocks=names, span=clause.span))
        scene.assume("what is unstacked starts as a stack")
    goals.append(r.OnTable(a=names, span=clause.span))
    return goals


_AWAY = ("remove", "clear", "empty")


def _off_its_patch(theme: Ref, scene: Scene, span: Span) -> Goals:
    """ "There are a red and a blue block on the mat. Remove red.": off the patch on which it starts."""
    begun = {n: x.patch for x in scene.start_goals if isinstance(x, r.OnPatch) for n in members(x.a)}
    left = theme.parts[-1].names if theme.op == "except" else ()
    if theme.quant is not None or theme.op not in ("and", "except") or not begun.keys() >= {*theme.names, *left}:
        return []
    scene.assume("a block that is removed is put beside the patch on which it was")
    gone = [g.Not(goal=r.OnPatch(a=(n,), patch=begun[n], span=span), span=span) for n in theme.names]
    return [*gone, *(r.OnPatch(a=(n,), patch=begun[n], span=span) for n in left)]


def _under(theme: Ref, scene: Scene) -> tuple[str, ...]:
    """The block that a single block lies on in a tower of the start."""
    begun = {name for x in scene.start_goals if isinstance(x, Stack) for name in x.blocks}
    if len(theme.names) != 1 or theme.quant is not None or theme.built or theme.names[0] not in begun:
        return ()
    towers = [built.members for built in scene.built if built.kind == "stack" and built.ordered]
    pairs = [pair for tower in towers for pair in pairwise(tower) if pair[1] in theme.names]
    return pairs[-1][:1] if pairs else ()


def _built_before(theme: Ref, scene: Scene) -> bool:
    """ "Build a tower, then take it apart": it is there by then, and not at the start."""
    earlier = [built for m in scene.mentions if m.clause < scene.clause for built in m.ref.built]
    piled = any(scene.on_top.get(name) in theme.names for name in theme.names)
    stacked = (m.ref for m in scene.mentions if m.clause < scene.clause and m.role == "theme" and not m.start
               and scene.verbs.get(m.clause, (None, True, ""))[1:] == (False, "stack"))  # fmt: skip
    piled = piled or any({*theme.names} <= {*ref.names} for ref in stacked)
    return piled or (bool(theme.built) and all(built in earlier for built in theme.built))


def _stacked_at_start(names: tuple[str, ...], scene: Scene) -> bool:
    piled = any(getattr(goal, "kind", "") in ("stack", "on", "towers") for goal in scene.start_goals)
    return piled or any(set(names) <= {*heap} for heap in scene.heaps)


def _so_many_off(theme: Ref, landmarks: list[Meaning], scene: Scene, scope: Scope, span: Span) -> Goals:
    """ "Remove two of the three from the mat": all start there, and so many of them are not there at the end."""
    offs = [Loc(rel="off", landmark=landmark, span=span) for landmark in landmarks]
    goals = [goal for off in offs for goal in place(theme, off, scene, scope, span)]
    patches = dict.fromkeys(atom.patch for goal in goals for atom in atoms(goal) if isinstance(atom, r.OnPatch))
    if not patches:
        raise refuse("ambiguous", "it is not clear which of these lies there", span, "name the block")
    _off(Ref(names=theme.names), Ref(names=tuple(patches), patch=True), scene, span)
    return goals


def _off(theme: Ref, mark: Ref, scene: Scene, span: Span) -> Goals:
    """Off a patch or a block: it starts there and is not there at the end."""
    if mark.table:
        raise refuse("out-of-reach", "blocks cannot leave the table", span, "say where on the table, or on which block")
    loc_goals: Goals = []
    for a in theme.names:
        for b in mark.names:
            there: g.Goal = r.OnPatch(a=(a,), patch=b, span=span) if mark.patch else r.On(a=(a,), b=(b,), span=span)
            if there not in scene.start_goals and not put_there(a, b, scene):
                scene.start_goals.append(there)
            loc_goals.append(g.Not(goal=there, span=span))
    return loc_goals
