"""The ways to read a whole text, clause by clause: one that makes no sense is not gone on with."""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from rpg.language.compose.clauses import Reader, Step
from rpg.language.compose.scene import Impossible, Scene, Unclear
from rpg.language.compose.statements import say
from rpg.language.compose.syntax import Both, Clause, Made, Noun, Place, Predicate, Same, is_figure, several

_MOST = 300
"""So many ways to read a text are looked at; one with more of them is not read."""
_MOST_SCENES = 6
"""So many ways to have what is said are told."""
_MOST_OPEN = 20
"""So many may be left by what is said ahead of a clause that leaves fewer of them."""
_MOST_CLAUSES = 2000
"""So many clauses are tried for it."""


_ONE_MORE = (Noun(noun="one"), Noun(count=1), Noun(det="another", noun="one"), Noun(det="another"))


class TooMany(Exception):
    """There are more ways to read a text than are looked at."""


def readings(reader: Reader) -> Iterator[tuple[tuple[Clause, ...], list[Scene]]]:
    """Each way to read the text that makes sense, and what is told of then: a scene for each way to have it.

    Raises TooMany where there are more of them than are looked at.
    """
    tried = found = 0
    begun: list[tuple[tuple[Clause, ...], list[bytes], Step | None]] = [((), [pickle.dumps(Scene())], None)]
    while begun:
        way, told, last = begun.pop()
        steps = reader.steps(last.at, said=last.said) if last else reader.steps(0)
        for step in reversed(list(steps)):
            tried += 1
            with suppress(Unclear):
                clause = _behind(last, step.clause) if last else step.clause
                if last and last.joined and last.clause.mood == "start" and not reader.led(last.at):
                    clause = _so_at_start(clause)
                scenes = [scene for before in told for scene in _said(before, clause)]
                most = _MOST_OPEN if step.at < len(reader.items) else _MOST_SCENES
                if not 0 < len(scenes) <= most:
                    raise Unclear
                if step.at < len(reader.items):
                    begun.append(((*way, clause), list(map(pickle.dumps, scenes)), step._replace(clause=clause)))
                elif not step.later:
                    found += 1
                    yield (*way, clause), scenes
            if tried > _MOST_CLAUSES or found > _MOST:
                raise TooMany


def _said(told: bytes, clause: Clause) -> list[Scene]:
    """The scenes behind a clause: one for each way to have what it says; none where that cannot be."""
    scenes: list[Scene] = []
    scripts: list[tuple[int, ...]] = [()]
    while scripts:
        script = scripts.pop()
        scene: Scene = pickle.loads(told)
        scene.script = script
        with suppress(Impossible):
            say(scene, clause)
            scenes.append(scene)
        taken = (*script, *(0 for _ in scene.choices[len(script) :]))
        for n in range(len(script), len(scene.choices)):
            scripts += [(*taken[:n], other) for other in range(1, scene.choices[n])]
        scene.script, scene.choices = (), []
        if len(scenes) > _MOST_OPEN:
            raise Unclear
    return scenes


def _of_same_place(last: Clause, clause: Clause) -> Clause:
    """ "(A must not be on the mat,) but B must be": on the mat."""
    if not any(isinstance(said, Same) for said in clause.predicates):
        return clause
    place = last.predicates[0] if len(last.predicates) == 1 and last.other is None else None
    if not isinstance(place, Place) or (isinstance(place.of, Noun) and place.of.det in {"no", "any", "each", "a"}):
        raise Unclear
    said = tuple(replace(place, no=one.no) if isinstance(one, Same) else one for one in clause.predicates)
    return replace(clause, predicates=said)


def _one_more(last: Clause, clause: Clause) -> Clause:
    """ "(A white block to its left and) another to its right", "one behind it": one more that looks like that."""
    ahead = last.subject
    if clause.subject not in _ONE_MORE or clause.mood or not clause.predicates or not isinstance(ahead, Noun):
        return clause
    new = ahead.det == "a" or (not ahead.det and ahead.count == 1 and not ahead.bound)
    if not new or not ahead.color or replace(ahead, det="", count=0, color="", noun="") != Noun():
        return clause
    return replace(clause, subject=Noun(det="a", color=ahead.color, noun="block"))


def _is_new(said: Predicate) -> bool:
    """Whether something is told without regard to what was told ahead."""
    return not (isinstance(said, Place) and isinstance(said.of, Noun) and (said.of.that or said.of.det == "other"))


def _is_either(said: Predicate) -> bool:
    return isinstance(said, Place) and isinstance(said.of, Both) and said.of.either


def _so_at_start(clause: Clause) -> Clause:
    """ "At the start A is on B and C on D": both are."""
    said = clause.predicates and clause.mood in {"so", ""}
    return replace(clause, mood="start") if said else clause


def _behind(last: Step, clause: Clause) -> Clause:
    """A clause behind another one: it may be of later, or have its verb."""
    clause = replace(clause, later=last.later or clause.later)
    clause = _one_more(last.clause, _of_same_place(last.clause, clause))
    subject = last.clause.subject
    new = is_figure(subject) and not (isinstance(subject, Noun) and subject.det == "the")
    if last.said and not clause.mood and clause.predicates:
        return replace(clause, mood="with")  # "with a block on it" tells how it is to be
    built = new and last.clause.mood in {"build", "put"} and last.clause.predicates
    if last.joined and built and not clause.mood and clause.predicates and not is_figure(clause.subject):
        raise Unclear  # "a row of red blocks on the left and blue ones on the right": another row, or not
    denied = any(isinstance(said, Place) and said.no for said in last.clause.predicates)
    if last.joined and denied and not clause.mood and last.clause.mood == "put":
        raise Unclear  # "do not put A on B and C on D": is that denied, too?
    told = last.joined and not clause.mood and all(map(_is_new, clause.predicates))
    if told and any(map(_is_either, last.clause.predicates)):
        raise Unclear  # "put A on B or C, and D on the mat": what does "and" join, and what "or"?
    if not last.joined or clause.mood or not clause.predicates or last.clause.mood != "put":
        return clause
    stacked = last.clause.predicates[:1]
    if not isinstance(stacked[0], Made) or not several(clause.subject):
        stacked = ()
    return replace(clause, mood="put", predicates=(*stacked, *clause.predicates))
