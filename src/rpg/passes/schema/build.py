"""Readings -> the task: resolve the cheapest readings that make sense; two that differ are an ambiguity."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from contextlib import suppress
from itertools import product
from typing import Any

from pydantic import ValidationError

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir.reconcile import reconcile, reconciled
from rpg.ir.relations import Above, OnTable
from rpg.ir.schema import InitialState, TaskSchema
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Chain, OrderBy, Pronoun, Traits, cost_of, parts_of, replace
from rpg.language.read import Sentence, read_sentences
from rpg.language.tokens import Token
from rpg.passes.schema.ambiguity import TwoReadings, same
from rpg.passes.schema.atop import check_atop, check_top_of_which
from rpg.passes.schema.evidence import unfounded
from rpg.passes.schema.feasibility import Feasibility, Repair, Repairable, examine
from rpg.passes.schema.invented import check_invented
from rpg.passes.schema.joints import check_joints
from rpg.passes.schema.names import family_name
from rpg.passes.schema.patience import FINAL, LOST, aimless, patience, torn
from rpg.passes.schema.reading_order import THEM, as_they_are_read, of_everything, stock_apart
from rpg.passes.schema.resolve.clauses.beginning import UNMEANT, begun
from rpg.passes.schema.resolve.clauses.begun_facts import cleared_of, start_first
from rpg.passes.schema.resolve.clauses.chains import at_their_times, chain_goals, join
from rpg.passes.schema.resolve.clauses.each_of_what import check_each
from rpg.passes.schema.resolve.clauses.fitting import check_besides, check_words
from rpg.passes.schema.resolve.clauses.hoist import hoisted
from rpg.passes.schema.resolve.clauses.in_parts import links_left
from rpg.passes.schema.resolve.clauses.kinds_last import kinds_last, waits
from rpg.passes.schema.resolve.clauses.left_out_behind import left_out_behind
from rpg.passes.schema.resolve.clauses.lists_cut import check_lists
from rpg.passes.schema.resolve.clauses.marks_joined import marks_joined
from rpg.passes.schema.resolve.clauses.moments import in_time
from rpg.passes.schema.resolve.clauses.readied import readied
from rpg.passes.schema.resolve.clauses.rows_again import check_lines_again
from rpg.passes.schema.resolve.clauses.set_below import check_set_below
from rpg.passes.schema.resolve.clauses.taken_for_granted import either_way
from rpg.passes.schema.resolve.clauses.told_order import in_told_order
from rpg.passes.schema.resolve.clauses.tower_or_block import of_their_colors
from rpg.passes.schema.resolve.clauses.whole_or_part import check_it, of_the_one
from rpg.passes.schema.resolve.goals.contradictions import check_all
from rpg.passes.schema.resolve.goals.meant import with_what_is_meant
from rpg.passes.schema.resolve.goals.only_denied import still_ahead
from rpg.passes.schema.resolve.goals.tidy import once, tidy
from rpg.passes.schema.resolve.goals.untouched import left_as_they_are, the_other_way
from rpg.passes.schema.resolve.orders.between_ends import told_as_ranges
from rpg.passes.schema.resolve.orders.parts_behind import parts_behind
from rpg.passes.schema.resolve.orders.then_longer import then_longer
from rpg.passes.schema.resolve.orders.told_places import places_told
from rpg.passes.schema.resolve.places.patches_alike import either_way_round
from rpg.passes.schema.resolve.places.sided_patches import settle_sides
from rpg.passes.schema.resolve.structures.built_for_a_part import built_for_a_part
from rpg.passes.schema.resolve.structures.heaps import from_heaps, heaps_begun, heaps_last, placed, told_later
from rpg.passes.schema.resolve.structures.lots_related import lots_related
from rpg.passes.schema.resolve.structures.rows_told import words_in_rows
from rpg.passes.schema.resolve.structures.unbuilt import check_known
from rpg.passes.schema.resolve.things import finish
from rpg.passes.schema.resolve.things.bare_numbers import check_bare_numbers
from rpg.passes.schema.resolve.things.begun_of_stock import begun_of_stock
from rpg.passes.schema.resolve.things.counted import counted_later
from rpg.passes.schema.resolve.things.inventory import each_agrees
from rpg.passes.schema.resolve.things.of_each import each_later
from rpg.passes.schema.resolve.things.rest import listed_alone, selects, speaks_of_rest
from rpg.passes.schema.resolve.things.same_blocks import check_counted, told_one_by_one
from rpg.passes.schema.resolve.things.sized import sized
from rpg.passes.schema.resolve.things.spare import none_ignored
from rpg.passes.schema.resolve.things.taken import all_plainly
from rpg.passes.schema.resolve.things.things import fits, matching, note_named
from rpg.passes.schema.resolve.things.world import Scene, refuse, said
from rpg.passes.schema.told_of_which import check_of_which
from rpg.passes.schema.wordings import wording

MAX_COMBINATIONS = 48


def build(
    words: list[Token], text: str, notes: list[str], *, name: str | None, seed: int, author: str | None
) -> Feasibility:
    """The task that the words state, and what made it possible."""
    sentences = read_sentences(words)
    first: tuple[Refusal, tuple[Chain, ...]] | None = None
    best: tuple[int, Feasibility] | None = None
    limit: int | None = None
    links = [s.link for s in sentences]
    said_before: set[Hashable] = set()
    known: dict[int, Hashable] = {}
    for cost, chosen in (combinations := _combinations(sentences)):
        if (best is not None and cost > best[0]) or (limit is not None and cost > limit):
            break
        if len(combinations) > 1:
            if (told := wording(chosen, known)) in said_before:
                continue
            said_before.add(told)
        try:
            found = either_way(
                lambda ls, cs, ns: resolve(ls, cs, text, ns, name, seed, author), links, chosen, notes, text
            )
            if best is not None and same(best[1].task, found.task):
                continue  # that task was looked at
            if (token := next(unfounded(words, found.task, found.chosen), None)) is not None:
                raise _lost(token)
            check_joints(words, found.task)
            check_invented(words, found.task)
            check_of_which(words, found.task)
            check_atop(words, found.task)
            check_top_of_which(words, found.task)
        except Refusal as refusal:
            if refusal.diagnostics[0].code in FINAL and best is None:
                raise
            if (more := patience(refusal.diagnostics[0])) is not None and (limit is None or more < 0):
                kept = first is not None and (aimless(first[0]) or torn(refusal))
                limit, first = cost + more, first if kept else (refusal, chosen)
            first = (refusal, chosen) if first is None or torn(first[0]) else first
            continue
        if best is not None:
            raise TwoReadings(best[1].task, found.task, text)
        best = (cost, found)
    if best is not None:
        return best[1]
    if first is None:
        raise refuse("incomplete", "nothing is said that could be done", (0, len(text)))
    failure, chosen = first
    if failure.diagnostics[0].code != "order-conflict":
        raise failure
    first_order = _one_order(lambda: resolve(links, chosen, text, notes, name, seed, author, lenient=True))
    raise Repairable(failure.diagnostics, [first_order])


def _lost(token: Token) -> Refusal:
    return refuse("misplaced", f"{LOST} of {token.raw!r}", token.span, "say this part in a sentence of its own")


def _one_order(resolved: Callable[[], Feasibility]) -> Iterator[Repair]:
    """The task under the first of two orders."""
    with suppress(Refusal):
        yield Repair("SWITCH_ORDERING_PATTERN", resolved().task, "the first of the two orders")


def _combinations(sentences: list[Sentence]) -> list[tuple[int, tuple[Chain, ...]]]:
    found = []
    for chosen in product(*(s.readings for s in sentences)):
        found.append((sum(cost_of(c) for c in chosen), chosen))
        if len(found) > 4000:
            break
    found.sort(key=lambda item: item[0])
    return found[:MAX_COMBINATIONS]


def resolve(
    links: list[str],
    chains: tuple[Chain, ...],
    text: str,
    notes: list[str],
    name: str | None,
    seed: int,
    author: str | None,
    *,
    lenient: bool = False,
) -> Feasibility:
    """One reading of every sentence -> the task, or a refusal. Facts that no end fits are about the start."""
    check_lists(chains, text)
    check_each(chains, text)
    chains = of_their_colors(chains)
    check_lines_again(chains)
    check_set_below(chains)
    check_it(chains := built_for_a_part(of_the_one(chains)))
    chains = then_longer(from_heaps(readied(marks_joined(chains), text), text), text)
    links, chains = lots_related(*in_told_order(*left_out_behind(*parts_behind(links, chains, text)), text))
    links, chains = hoisted(*places_told(*words_in_rows(links, chains)))
    told = begun_of_stock(begun(chains, text), text)
    links, every = links_left(links, chains, told), links
    facts = cleared_of(told, links)
    if (last := heaps_last(*told_later(links, facts))) is not None:
        with suppress(Refusal):
            return _resolved(*last, text, notes, name, seed, author, lenient)
    if (heaped := heaps_begun(facts)) is not None:
        with suppress(Refusal):
            found = _resolved(*told_later(links, heaped), text, notes, name, seed, author, lenient)
            if set().union(*found.task.init.heaps) <= placed(found.task.goal):
                return found
    try:
        return _resolved(*told_later(links, facts), text, notes, name, seed, author, lenient)
    except Refusal as refusal:
        unmeant = refusal.diagnostics[0].code in UNMEANT
        bold = begun_of_stock(begun(chains, text, bold=True), text) if unmeant else facts
        for left, other in ((links_left(every, chains, bold), bold), (links, cleared_of(facts))) if unmeant else ():
            with suppress(Refusal):
                if other != facts:
                    return _resolved(*told_later(left, other), text, notes, name, seed, author, lenient)
        if (named := told_one_by_one(links, facts, refusal, text)) is not None:
            with suppress(Refusal):
                return _resolved(*told_later(*named), text, notes, name, seed, author, lenient)
        if (ahead := start_first(*told_later(links, facts))) is not None:
            with suppress(Refusal):
                return _resolved(*ahead, text, notes, name, seed, author, lenient)
        if isinstance(refusal, Repairable):
            raise refusal.blaming("order-misfit", _ordering(chains)) from None
        raise


def _ordering(chains: tuple[Chain, ...]) -> Span | None:
    """The words that ask for an order by letters or numbers."""
    parts = (part for chain in chains for part in parts_of(chain))
    return next((p.span for p in parts if isinstance(p, OrderBy) and p.by in SYMBOLIC), None)


SYMBOLIC = frozenset({"label", "number", "ascending", "count_up", "countdown", "number_up", "number_down"})
"""Orders that ask for letters or numbers."""


def _resolved(
    links: list[str],
    chains: tuple[Chain, ...],
    text: str,
    notes: list[str],
    name: str | None,
    seed: int,
    author: str | None,
    lenient: bool,
) -> Feasibility:
    scene = Scene(lenient=lenient)
    for note in notes:
        scene.assume(note)
    links, chains = counted_later(*stock_apart(links, each_later(chains)))
    links, chains = sized(links, all_plainly(chains, scene), scene)
    scene.speaks_of_rest = speaks_of_rest([part for chain in chains for part in parts_of(chain)])
    note_named(chains, scene)
    scene.ranges = told_as_ranges(chains, text)
    check_words(chains, scene)
    pointed = any(isinstance(part, Pronoun) and part.word in THEM for chain in chains for part in parts_of(chain))
    chains = chains if pointed else kinds_last(chains)
    late = [
        n for n, chain in enumerate(chains) if of_everything(chain, pointed) or (not pointed and waits(chain, chains))
    ]
    stated: dict[int, list[g.Goal]] = {}
    for n in as_they_are_read(chains, late):
        scene.sentence, loose, scene.later = n, len(scene.loose), n > 0 and links[n] == "then"
        stated[n] = chain_goals(chains[n], scene)
        at_their_times(links[max(n, 1) : n + 2], stated[n], loose, scene)
    links, sequence = in_time(links, chains, (0, len(text)))
    goal = join([(links[n], stated[n]) for n in sequence], scene, (0, len(text)))
    if isinstance(goal, g.All) and not goal.goals:
        raise _no_goal(scene, text)
    goal = with_what_is_meant(goal, scene)
    check_counted(chains, scene, text)
    settle_sides(scene)
    chosen = finish.choose(scene)
    goal = tidy(the_other_way(left_as_they_are(goal, scene), scene), scene)
    check_all(goal := either_way_round(goal, scene, chosen), scene)
    _all_used(goal, scene, chains)
    check_bare_numbers(goal, scene, chains)
    names = finish.naming(scene)
    start = InitialState(
        arranged=reconciled(once(finish.renamed(x, names) for x in scene.start_goals)),
        heaps=tuple(tuple(names[n] for n in heap) for heap in scene.heaps),
    )  # fmt: skip
    final = reconcile(finish.renamed(goal, names))
    made = finish.assets(scene, names)
    start, assumed = still_ahead(final, start, made)
    found = _schema(
        name=name or family_name(final), instruction=text, author=author, seed=seed, assets=made, init=start,
        goal=final,
        assumptions=(*scene.assumptions, *assumed), open_={names[t.name]: t.open for t in scene.blocks() if t.open},
    )  # fmt: skip
    return replace(found, chosen=frozenset(names[thing] for thing in chosen))


def _schema(open_: dict[str, str], **fields: Any) -> Feasibility:
    """The task, if its parts fit together and it is feasible: a reading that leaves something dangling is none."""
    try:
        schema = TaskSchema(**fields)
    except ValidationError:
        raise refuse(
            "misplaced",
            "this cannot be put together in one task",
            (0, len(fields["instruction"])),
            "say it in several short sentences",
        ) from None
    return examine(schema, open_)


def _all_used(goal: g.Goal, scene: Scene, chains: tuple[Chain, ...]) -> None:
    """Every block that was spoken of must matter: one that no condition mentions was lost on the way."""
    check_besides(scene)
    each_agrees(scene)
    none_ignored(goal, scene)
    for traits, count, span in scene.closed:
        there = len(matching(traits, scene, False))
        if there != count and there + _passed_over(traits, scene) != count:
            raise refuse(
                "count-mismatch",
                f"there are only {count} of these, but {there} are needed",
                span,
                f"say {there}, or use {count}",
                there=count,
                needed=there,
            )
    check_known(chains, scene)
    alone = listed_alone(chains)
    some = any(selects(part, alone) for chain in chains for part in parts_of(chain))
    told = (
        set(names_in(goal))
        | {n for x in scene.start_goals for n in names_in(x)}
        | {n for heap in scene.heaps for n in heap}
    )
    some = some or _leaves_room(goal)
    for thing in scene.things.values():
        listed = thing.declared and (thing.name not in scene.tallied or some or thing.name in scene.stocked)
        if thing.name in told or thing.extra or listed or thing.name in scene.spare:
            continue
        span = next((m.ref.span for m in scene.mentions if thing.name in m.ref.names), chains[0].span)
        raise refuse(
            "unused-block",
            f"{said(thing)} is spoken of, but nothing is said of where it should be",
            span,
            "say where it should be, or that it is a distractor",
        )


def _leaves_room(goal: g.Goal) -> bool:
    """ "(There are red and brown blocks.) No red one is on the table", "purple is somewhere above green": what is not
    spoken of may be what these lie on."""
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    return any(isinstance(x, Above) or (isinstance(x, g.Not) and isinstance(x.goal, OnTable)) for x in parts)


def _passed_over(traits: Traits, scene: Scene) -> int:
    """How many blocks of these looks were said to be distractors after they were counted."""
    things = [scene.things[name] for name in scene.ignored]
    return sum(not thing.patch and fits(thing, traits) for thing in things)


def _no_goal(scene: Scene, text: str) -> Refusal:
    if scene.picked:
        hint = "say where to put it down"
        return refuse("no-goal", "a block that is held has no place at the end", scene.picked, hint)
    hint = "say where the blocks should be at the end"
    return refuse("no-goal", "it is not said what should be done", (0, len(text)), hint)
