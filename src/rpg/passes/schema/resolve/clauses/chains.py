"""Chains of clauses: and, or, sequences in time; and what is settled once all are read."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.language.meaning import (
    Chain,
    Clause,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    TableTop,
    That,
    replace,
)
from rpg.passes.schema.resolve.clauses.again_later import comes_later
from rpg.passes.schema.resolve.clauses.as_one import each_by_itself, named_ahead, put_at_once
from rpg.passes.schema.resolve.clauses.clauses import clause_goals, not_both
from rpg.passes.schema.resolve.clauses.one_or_all import one_or_all
from rpg.passes.schema.resolve.clauses.staged import staged
from rpg.passes.schema.resolve.clauses.started import and_in_the_end
from rpg.passes.schema.resolve.clauses.turned_as_well import turned_as_well
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.orders.loose import settle
from rpg.passes.schema.resolve.places.stacking import Towers
from rpg.passes.schema.resolve.things.world import Scene, refuse

Goals = list[g.Goal]


def chain_goals(chain: Chain, scene: Scene, start: bool = False) -> Goals:
    """The goals of a chain of clauses; those about the start go to the scene instead."""
    chain = put_at_once(each_by_itself(named_ahead(turned_as_well(chain))))
    if timed(chain):
        return chain_goals(untimed(chain), scene, start)
    chain = _earlier_first(in_that_order(_told_of_the_end(and_in_the_end(chain))))
    _check_sides(chain)
    stages: list[Goals] = [[]]
    towers, free, later = Towers.of(scene), {*scene.used}, scene.later
    pairs = _given_first(chain)
    before: Clause | None = None
    for (link, clause), after in zip(pairs, [*(link for link, _ in pairs[1:]), ""], strict=True):
        if not isinstance(clause, Chain | Clause):
            continue
        towers, free = (Towers.of(scene), {*scene.used}) if link != "or" else (towers, free)
        if isinstance(clause, Chain):
            with _instead(link, towers, free, scene):
                goals = chain_goals(clause, scene, start)
            _append(stages, link, [conj(goals)], scene)
            continue
        clause = _begun(clause, _lying(chain))
        both = [m for m in clause.adjuncts if isinstance(m, Manner) and m.kind == "xor"] if link == "or" else []
        clause = replace(clause, adjuncts=tuple(a for a in clause.adjuncts if a not in both))
        starts = start or clause.mode in ("start", "given")
        one_or_all(clause, before)
        before = clause
        loose, scene.later = len(scene.loose), later or link == "then"
        with _instead(link, towers, free, scene):
            goals = clause_goals(clause, scene, starts)
        goals = [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
        at_their_times((link, after), goals, loose, scene)
        if clause.mode == "given" and "before" in (link, after):
            raise refuse("ambiguous", "it is not said what is before what", clause.span, "say where they should be")
        if after == "or" and len(goals) > 1:
            goals = [conj(goals, clause.span)]
        if link == "and" and comes_later(stages[-1], goals, clause, scene):
            link = "then"
        _no_exception(clause, link)
        if link == "or" and not (goals and (stages[-1] or starts)):
            raise refuse("ambiguous", "it is not clear what 'or' leaves open here", clause.span, "say 'and'")
        if starts and clause.verb != "exist":
            scene.start_goals += goals
            continue
        _append(stages, link, goals, scene)
        if both:
            stages[-1] = [*stages[-1][:-1], *not_both(stages[-1][-1:], clause.span)]
    return _sequence(stages, scene, chain)


@contextmanager
def _instead(link: str, towers: Towers, free: set[str], scene: Scene) -> Iterator[None]:
    """What "or" tells stands for itself: nothing of what it is told instead of is so, and it leaves nothing behind."""
    if link != "or":
        yield
        return
    used = {*scene.used}
    towers.after(scene, start=False, denied=True)
    scene.used = {*free}  # of a stock, each alternative may take the same ones
    yield
    towers.after(scene, start=False, denied=True)
    scene.used |= used


def _check_sides(chain: Chain) -> None:
    """Refuse "A on the mat and B on red, or B on the mat and A on red" unless "either" tells what each side has."""
    links, clauses = chain.links, chain.clauses
    for n in range(2, len(clauses) - 1):
        one, other = clauses[n - 1], clauses[n]
        if links[n - 1 : n + 2] != ("and", "or", "and") or not (isinstance(one, Clause) and isinstance(other, Clause)):
            continue
        if other.theme is not None and one.theme != other.theme and not (one.negated or other.negated):
            raise refuse("ambiguous", "it is not clear which of these belong together on each side of 'or'", other.span,
                         "say 'either ... and ..., or ... and ...'")  # fmt: skip


def at_their_times(links: Collection[str], goals: Collection[object], loose: int, scene: Scene) -> None:
    """Note "put red on blue, then move it to the left": of what, when it is on blue already?"""
    if not goals and not _TIMES.isdisjoint(links):
        scene.untimed += scene.loose[loose:]


_TIMES = frozenset({"then", "before"})


def _no_exception(clause: Clause, link: str) -> None:
    """Refuse "red is on blue or on green, not on the table": is the last said of one of the two, or of both?"""
    spots = [a for a in clause.adjuncts if isinstance(a, Loc | In)]
    if link == "or" and not clause.negated and {a.negated for a in spots} == {False, True}:
        raise refuse("ambiguous", "it is not clear whether this is said of both alternatives", spots[-1].span,
                     "say it in a sentence of its own")  # fmt: skip


def _told_of_the_end(chain: Chain) -> Chain:
    """ "A, B and C in a row, and there is a red block on B": what is told beside how it should be is so as well."""
    told: list[Meaning] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        before = told[-1] if told else None
        ends = isinstance(before, Clause) and before.mode == "goal" and before.verb not in ("exist", "ignore")
        here = isinstance(clause, Clause) and (clause.verb, clause.mode, clause.lemma) == ("exist", "given", "")
        if link == "and" and ends and here and isinstance(clause, Clause) and _placed(clause):
            clause = replace(clause, verb="be", mode="goal")
        told.append(clause)
    return replace(chain, clauses=tuple(told)) if tuple(told) != chain.clauses else chain


def _placed(clause: Clause) -> bool:
    """Whether a clause says where something is, and not that it is so at the start."""
    spots = [x for x in clause.adjuncts if isinstance(x, Loc | In)]
    return (
        bool(spots) and len(spots) == len(clause.adjuncts) and all("start" not in getattr(x, "mods", ()) for x in spots)
    )


def _earlier_first(chain: Chain) -> Chain:
    """ "A, but first B, and before that C": the clauses in the order in which they are to be done."""
    if "after" not in chain.links:
        return chain
    groups: list[list[tuple[str, Meaning]]] = []
    at = 0
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        if groups and link in ("and", "or"):
            groups[at].append((link, clause))
        else:
            if link == "after" and at:
                raise refuse("ambiguous", "it is not clear before which of these this comes", clause.span,
                             "say what is done in the order in which it is done")  # fmt: skip
            at = at if link == "after" and groups else len(groups)
            groups.insert(at, [("then", clause)])
    pairs = [pair for group in groups for pair in group]
    return replace(chain, clauses=tuple(c for _, c in pairs), links=("and", *(link for link, _ in pairs[1:])))


def _begun(clause: Clause, lying: bool) -> Clause:
    """ "at the start", "scattered at random": the clause, about the start if it says so."""
    begun = [m for m in clause.adjuncts if isinstance(m, Manner) and m.kind in ("start", "strewn")[: 1 + lying]]
    if not begun:
        return clause
    rest = tuple(m for m in clause.adjuncts if m not in begun)
    if any(isinstance(m, Manner) and m.kind == "stay" for m in rest):
        return replace(clause, adjuncts=rest)  # "where it was at the start" is said of the end
    put = clause.verb in ("be", "place", "stack", "build", "arrange")
    if clause.mode == "command" and put and any(m.kind == "start" for m in begun):
        if any(m.value == "first" for m in begun):
            return replace(clause, adjuncts=rest)  # "at first put ...": a first step
        raise refuse("ambiguous", "is this so at the start, or is it to be done first?", begun[0].span,
                     "say where it starts: 'red starts on blue', or say 'first'")  # fmt: skip
    if clause.verb == "be" and _strewn(begun, rest):
        if clause.negated:
            raise refuse("misplaced", "this says nothing of how they lie", clause.span, "say how they start")
        if clause.mode == "start" or any(m.kind == "start" for m in begun):
            table = Loc(rel="on", landmark=TableTop(span=begun[0].span), span=begun[0].span)
            return replace(clause, mode="start", adjuncts=(table,))
        return replace(clause, verb="exist", lemma="", mode="given", adjuncts=())
    return replace(clause, mode="given" if clause.verb == "exist" else "start", adjuncts=rest)


def _lying(chain: Chain) -> bool:
    """Whether all of a sentence says what there is, or how it lies about."""
    clauses = [c for c in chain.clauses if isinstance(c, Clause)]
    strewn = [c for c in clauses if any(isinstance(m, Manner) and m.kind == "strewn" for m in c.adjuncts)]
    return all(c.mode in ("given", "start") or (c.lemma == "fact" and c in strewn) for c in clauses)


def _strewn(begun: list[Manner], rest: tuple[Meaning, ...]) -> bool:
    """ "scattered on the table": so they begin anyway."""
    there = all(isinstance(m, Loc) and isinstance(m.landmark, TableTop) and m.rel in ("on", "above") for m in rest)
    return begun[0].kind == "strewn" and there


def _given_first(chain: Chain) -> list[tuple[str, Meaning]]:
    """Clauses with their links; those that only say what there is come first."""
    pairs = list(zip(chain.links, chain.clauses, strict=True))
    given = [x for x in pairs if isinstance(x[1], Clause) and x[1].mode == "given"]
    return [*given, *(x for x in pairs if x not in given)]


def in_that_order(chain: Chain) -> Chain:
    """ "..., in that order" behind several clauses with a block each, or with several alike: one after the other."""
    last = chain.clauses[-1]
    if len(chain.clauses) < 2 or not isinstance(last, Clause) or not _in_no_order(last.theme):
        return chain
    orders = [a for a in last.adjuncts if isinstance(a, OrderBy) and a.by in ("given", "temporal") and not a.items]
    if not orders:
        return chain
    bare = replace(last, adjuncts=tuple(a for a in last.adjuncts if a not in orders))
    return replace(
        chain, clauses=(*chain.clauses[:-1], bare), links=(chain.links[0], *("then" for _ in chain.links[1:]))
    )


def _in_no_order(theme: Meaning | None) -> bool:
    """Whether there is no order among the blocks themselves: a single one, or "a tower of two pink blocks"."""
    blocks = theme.members if isinstance(theme, Structure) else theme
    alike = isinstance(blocks, Noun) and len(blocks.traits.colors) == 1 and not blocks.traits.labels
    return isinstance(blocks, Noun) and (alike or not blocks.plural)


def time_of(clause: object) -> float | None:
    """When a clause says that it is done: 1 for "first", 99 for "last"."""
    if not isinstance(clause, Clause):
        return None
    found = [float(m.value or 0.0) for m in clause.adjuncts if isinstance(m, Manner) and m.kind == "time"]
    found += [time for part in clause.adjuncts if (one := _told(part)) and (time := time_of(one)) is not None]
    return found[0] if found else None


def _told(part: Meaning) -> Meaning | None:
    """ "Stack red on blue on the mat first": "blue on the mat" is told of the blue one alone, "first" of all."""
    inner = part.clauses if isinstance(part, That) and part.kind == "so" else None
    return inner.clauses[0] if isinstance(inner, Chain) and len(inner.clauses) == 1 else None


def _whenever(clause: Clause) -> Clause:
    """The clause without the words for when it is done."""
    kept: list[Meaning] = []
    for part in clause.adjuncts:
        inner = _told(part)
        if isinstance(part, That) and isinstance(part.clauses, Chain) and isinstance(inner, Clause):
            part = replace(part, clauses=replace(part.clauses, clauses=(_whenever(inner),)))
        if not (isinstance(part, Manner) and part.kind == "time"):
            kept.append(part)
    return replace(clause, adjuncts=tuple(kept))


def unsaid(times: list[float]) -> float:
    """When a clause comes that does not say so: after the one before it, unless that one comes last."""
    before = [time for time in times if time < LAST]
    return before[-1] + 0.5 if before else 1.5


LAST = 99.0
"""The time of what is done last."""


def timed(chain: Chain) -> bool:
    """Whether clauses say when: "... first and ... second"."""
    return any(time_of(c) is not None for c in chain.clauses)


def untimed(chain: Chain) -> Chain:
    """The clauses in the order of their times, joined by "then": those in front of "but C first" in any order."""
    if "or" in chain.links or "after" in chain.links:
        raise refuse("ambiguous", "it is not clear what comes first here", chain.span, "say it in several sentences")
    times: list[float] = []
    for n, clause in enumerate(chain.clauses):
        said = time_of(clause)
        open_ = n > 0 and chain.links[n] == "and" and all(time_of(c) is None for c in chain.clauses[:n])
        times.append(said if said is not None else times[-1] if open_ else unsaid(times))
    order = sorted(range(len(times)), key=lambda n: (times[n], n))
    bare = []
    for n in order:
        clause = chain.clauses[n]
        bare.append(_whenever(clause) if isinstance(clause, Clause) else clause)
    links = tuple(
        "then" if index and times[order[index]] != times[order[index - 1]] else "and" for index in range(len(order))
    )
    return replace(chain, clauses=tuple(bare), links=links)


def _append(stages: list[Goals], link: str, goals: Goals, scene: Scene) -> None:
    if not goals:
        return
    match link:
        case "then" | "before":
            if stages[-1] and not _comes_of_it(stages[-1], goals, scene):
                stages.append([])
            stages[-1] += goals
        case "or" if stages[-1]:
            last = stages[-1].pop()
            options = list(last.goals) if isinstance(last, g.Any) else [last]
            stages[-1].append(disj([*options, conj(goals)]))
        case _:
            stages[-1] += goals


def _comes_of_it(before: Goals, after: Goals, scene: Scene) -> bool:
    """ "The red block is on the mat. Clear it; the block should be on the table afterwards": no later step, for it lies
    on the table all the time, but where it is when the mat is clear."""
    lying = {n for x in scene.start_goals if isinstance(x, r.OnPatch) for n in members(x.a)}
    cleared = bool(before) and all(isinstance(x, r.Empty | g.Not) for goal in before for x in required(goal))
    there = [x for goal in after for x in required(goal) if not isinstance(x, g.Not)]
    told = bool(there) and all(any(True for _ in required(goal)) for goal in after)
    return cleared and told and all(isinstance(x, r.OnTable) and {*members(x.a)} <= lying for x in there)


def _sequence(stages: list[Goals], scene: Scene, chain: Chain) -> Goals:
    stages = [stage for stage in stages if stage]
    if len(stages) < 2:
        return stages[0] if stages else []
    return [g.Sequence(stages=staged([conj(stage) for stage in stages], scene, chain.span), span=chain.span)]


def join(sentences: list[tuple[str, Goals]], scene: Scene, span: tuple[int, int]) -> g.Goal:
    """The goals of all sentences; those that begin with "then" follow the ones before in time."""
    stages: list[g.Stage] = []
    now: Goals = []
    for link, goals in sentences:
        if link == "before" and goals:
            stages += _stages(goals)
            continue
        if goals and ((link == "then" and not _comes_of_it(now, goals, scene)) or comes_later(now, goals, None, scene)):
            stages += _stages(now)
            now = []
        now += goals
    stages += _stages(now)
    if len(stages) > 1:
        fixed = staged([stage.goal for stage in stages], scene, span)
        return settle(g.Sequence(stages=fixed, span=span), scene)
    goals = [stages[0].goal] if stages else []
    return settle(conj(goals, span) if goals else g.All(goals=()), scene)


def _stages(goals: Goals) -> list[g.Stage]:
    if len(goals) == 1 and isinstance(goals[0], g.Sequence):
        return list(goals[0].stages)
    return [g.Stage(goal=conj(goals))] if goals else []
