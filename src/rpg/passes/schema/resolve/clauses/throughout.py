"""What is so all the time beside what is to be done: "put red on green, keeping blue on the mat throughout"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Absolute, Chain, Clause, In, Into, Loc, Manner, Meaning, Structure, That, replace
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene


def of_the_rest(clause: Clause) -> Clause:
    """The clause with "always" said of what goes on beside it alone: what is so all the time need not be done."""
    said = clause.adjuncts
    at = [n for n, x in enumerate(said) if _always(x)]
    if len(at) != 1 or clause.mode == "start" or clause.verb == "keep":
        return clause
    if said[at[0]].span < said[0].span:  # "stays on the table, with blue on it"
        return clause
    beside = [n for n in (at[0] - 1,) if n >= 0 and _beside(said[n])]
    beside += [n for n in (at[0] + 1,) if n < len(said) and isinstance(said[n], That) and _beside(said[n])]
    if not beside or not (_asked(clause) or any(isinstance(x, Loc | In | Into) for x in said[: min(beside)])):
        return clause
    kept = _kept(said[beside[0]], said[at[0]])
    adjuncts = [kept if n == beside[0] else x for n, x in enumerate(said) if n != at[0]]
    return replace(clause, adjuncts=tuple(adjuncts))


def _asked(clause: Clause) -> bool:
    """Whether something is to be done, or made, whatever is told beside it."""
    return clause.mode == "command" or isinstance(clause.theme, Structure)


def _always(part: Meaning) -> bool:
    return isinstance(part, Manner) and part.kind == "always"


def _beside(part: Meaning) -> bool:
    """ "with blue next to it", "keeping blue on the mat"."""
    if isinstance(part, That):
        inside = part.clauses.clauses if isinstance(part.clauses, Chain) else ()
        return part.kind == "while" and len(inside) == 1 and isinstance(inside[0], Clause) and inside[0].verb == "keep"
    return isinstance(part, Absolute) and all(isinstance(x, Loc | In) for x in part.adjuncts)


def _kept(part: Meaning, always: Meaning) -> That:
    inside = part.clauses.clauses if isinstance(part, That) and isinstance(part.clauses, Chain) else ()
    if inside and isinstance(own := inside[0], Clause):
        keep = own if any(map(_always, own.adjuncts)) else replace(own, adjuncts=(*own.adjuncts, always))
    else:
        told = part if isinstance(part, Absolute) else None
        theme, places = (told.theme, told.adjuncts) if told is not None else (None, ())
        keep = Clause(verb="keep", lemma="keep", theme=theme, adjuncts=(*places, always), span=part.span)
    return That(kind="while", clauses=Chain(clauses=(keep,), links=("and",), span=part.span), span=part.span)


def held_throughout(goals: list[g.Goal], scene: Scene, span: Span) -> list[g.Goal]:
    """ "at all times": true from the start on, so that it is arranged at the start too."""
    goals = [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
    scene.start_goals += [
        x for x in goals if not isinstance(x, g.Not | g.Always | r.OnTable | r.Stayed) and x not in scene.start_goals
    ]
    return [g.Always(goal=conj(goals, span), span=span)] if goals else []
