"""Goals in words: clauses for atoms, joined by the connectives."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from rpg.blocks.english import relations, structures
from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import join, number
from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Behind, Facing, InFrontOf, InRegion, LeftOf, On, OnPatch, OnTable, RightOf, Stayed
from rpg.ir.walk import names, rename

CLAUSES: dict[str, Callable[[Any, Speaker], str]] = {**relations.TABLE, **structures.TABLE}
"""A clause for each kind of atom."""
ANY = "any"
"""Stands for the block that alternatives differ in; repeated for those within."""
OF_EACH = OnPatch | OnTable | InRegion | LeftOf | RightOf | InFrontOf | Behind
"""What is said of several blocks is said of each, be it denied or not."""
ORDINALS = ("First", "Then", "After that", "Next")


def spoken(goal: g.Goal, say: Speaker) -> str:
    """A goal as one clause."""
    match goal:
        case g.All():
            return join([spoken(part, say) for part in goal.goals])
        case g.Any() if (turned := _sideways(goal, say)) is not None:
            return turned
        case g.Any() if (counted := _any_of(goal, say)) is not None:
            return spoken(counted, say)
        case g.Any():
            with say.strictly():
                return _alternatives([spoken(part, say) for part in goal.goals])
        case g.Not():
            with say.strictly():
                return _negated(goal.goal, say)
        case g.Count():
            with say.strictly():
                return _counted(goal, say)
        case g.Sequence():
            return ", then ".join(_stage(goal, i, say) for i in range(len(goal.stages)))
        case g.Always(goal=Stayed() as stayed):
            return _never_moved(stayed, say)
        case g.Always():
            with say.strictly(), say.at_all_times():
                return spoken(goal.goal, say)
    return CLAUSES[goal.kind](goal, say)


def _any_of(goal: g.Any, say: Speaker) -> g.Count | None:
    """Alternatives that say the same of several blocks, as "at least one of"."""
    first, *others = goal.goals
    for name in names(first):
        over = [name]
        for other in others:
            like = (n for n in names(other) if n not in over and say.alike((name, n)))
            over += [n for n in like if rename(first, {name: n}) == other][:1]
        if not say.alike(over):
            continue
        if len(over) == len(goal.goals) > 1 and not set(over[1:]) & set(names(first)):
            var = ANY * (1 + sum(known.startswith(ANY) for known in say.aliases))
            return g.Count(over=tuple(over), var=var, at_least=1, goal=rename(first, {name: var}))
    return None


def _alternatives(said: list[str]) -> str:
    """ "A or B", and "either A and B, or C and D" where one of them lists something."""
    if any(f" {word} " in text for text in said for word in ("and", "or")):
        return f"either {', or '.join(said)}"
    return " or ".join(said)


def sentences(goal: g.Goal, say: Speaker) -> list[str]:
    """A goal as sentences without their full stops."""
    match goal:
        case g.All():
            return [sentence for part in goal.goals for sentence in _beside_others(part, say)]
        case g.Sequence():
            last = len(goal.stages) - 1
            leads = [ORDINALS[min(i, 2)] if i < last else "Finally" if last > 1 else "Then" for i in range(last + 1)]
            return [f"{lead}, {_stage(goal, i, say)}" for i, lead in enumerate(leads)]
    text = spoken(goal, say)
    return [text[:1].upper() + text[1:]]


def _beside_others(part: g.Goal, say: Speaker) -> list[str]:
    """Sentences for one of several goals: stages share a sentence, so that the others are no part of them."""
    return [f"First, {spoken(part, say)}"] if isinstance(part, g.Sequence) else sentences(part, say)


def _stage(goal: g.Sequence, index: int, say: Speaker) -> str:
    """A stage; what stays where it is, after an earlier stage had it elsewhere, is moved back."""
    stage = goal.stages[index].goal
    gone = {name for before in goal.stages[:index] if before.undone for name in names(before.goal)}
    if isinstance(stage, Stayed) and gone.intersection(members(stage.a)):
        where = "it was" if say.single(stage.a) else "they were"
        return f"{say.the(stage.a)} {say.be(stage.a)} moved back to where {where}"
    return spoken(stage, say)


def _never_moved(stayed: Stayed, say: Speaker) -> str:
    with say.strictly(), say.at_all_times():
        before, say.negated = say.negated, True
        text = f"{say.the(stayed.a)} {say.be(stayed.a)} moved"
        say.negated = before
    return text


def _sideways(goal: g.Any, say: Speaker) -> str | None:
    """A symbol that may be turned a quarter turn either way."""
    parts = [part for part in goal.goals if isinstance(part, Facing) and part.toward == "up" and not part.face]
    if len(parts) != 2 or len(goal.goals) != 2 or {part.turn for part in parts} != {90.0, -90.0}:
        return None
    same = parts[0].block == parts[1].block
    return f"{say.the(parts[0].block)} {say.be(parts[0].block)} sideways" if same else None


def _negated(goal: g.Goal, say: Speaker) -> str:
    """The opposite of a goal: of an atom by its verb, of a compound by what that means for its parts."""
    match goal:
        case g.Not():
            return spoken(goal.goal, say)
        case g.Any():
            return join([_negated(part, say) for part in goal.goals])
        case g.All():
            return _alternatives([_negated(part, say) for part in goal.goals])
        case g.Count() if not say.negated:
            return _alternatives([spoken(part, say) for part in _of_other_numbers(goal)])
    say.negated = not say.negated
    text = spoken(goal, say)
    say.negated = not say.negated
    if isinstance(goal, OF_EACH) and isinstance(goal.a, tuple) and len(goal.a) > 1:
        # "Red and blue must not be there" would deny it of each of them.
        text = _NOT.sub(r"\1 both" if len(goal.a) == 2 else r"\1 all", text, count=1)
    return text


def _of_other_numbers(goal: g.Count) -> list[g.Goal]:
    """What is left where so many are not: fewer, or more. "Not exactly two" is "at most one, or at least three"."""
    fewer: dict[str, int | None] = {"at_least": 0, "at_most": goal.at_least - 1}
    more: dict[str, int | None] = {"at_least": (goal.at_most or 0) + 1, "at_most": None}
    found = [fewer] if goal.at_least > 0 else []
    found += [more] if goal.at_most is not None and goal.at_most < len(goal.over) else []
    return [goal.model_copy(update=numbers) for numbers in found] or [goal]


_NOT = re.compile(r"\b(not|never)\b")


def _on_whichever(goal: g.Count, say: Speaker) -> str | None:
    """ "Two are on any of the patches": it is counted over all of them, and not on each by itself."""
    parts = goal.goal.goals if isinstance(goal.goal, g.Any) else ()
    on = [part for part in parts if isinstance(part, OnPatch) and part.a == (goal.var,)]
    if not on or len(on) < len(parts) or len({part.patch for part in on}) < len(on):
        return None
    return f"{say.the((goal.var,))} {say.be((goal.var,))} on any of {say.the(tuple(part.patch for part in on))}"


def _bearing(goal: g.Count, say: Speaker) -> str | None:
    """ "At least two red blocks have a blue block on them": each of them one of its own."""
    parts = goal.goal.goals if isinstance(goal.goal, g.Any) else ()
    above = [name for part in parts if isinstance(part, On) and part.b == (goal.var,) for name in members(part.a)]
    every = len({*above}) == len(parts) > 1 and len(said := say.like(above)) == 1 and said[0].startswith("the ")
    if not every or say.negated:
        return None
    them = "it" if say.single((goal.var,)) else "them"
    return f"{say.the((goal.var,))} {say.do((goal.var,), 'have', 'has')} {say.some(above[:1])[0]} on {them}"


def _of_the_same(goal: g.Count, say: Speaker) -> str | None:
    """ "Exactly two are on the mat and in the left half": it is counted of which both is true."""
    parts = goal.goal.goals if isinstance(goal.goal, g.All) else ()
    who = f"{say.aliases[goal.var]} "
    told = [spoken(part, say) for part in parts]
    if len(told) < 2 or not all(text.startswith(who) for text in told):
        return None
    lead = next((f"{who}{be} " for be in ("must be", "is", "are") if told[0].startswith(f"{who}{be} ")), who)
    denied = lead.replace("must be", "must not be") if "must be" in lead else f"{lead}not "
    if not all(text.startswith((lead, denied)) for text in told):
        return join([told[0], *(text[len(who) :] for text in told[1:])])
    rest = (f"not {text[len(denied) :]}" if text.startswith(denied) else text[len(lead) :] for text in told[1:])
    return join([told[0], *rest])


def _to_the_same(goal: g.Count, say: Speaker) -> str | None:
    """ "It is right of at least one of these and 6 cm from the same one": no two of them each have a part of it."""
    parts = goal.goal.goals if isinstance(goal.goal, g.All) else ()
    if len(parts) < 2 or any(goal.var not in names(part) for part in parts):
        return None
    first = spoken(parts[0], say)
    say.plural.discard(goal.var)
    say.aliases[goal.var] = "the same one"
    return join([first, *(spoken(part, say) for part in parts[1:])])


def _counted(goal: g.Count, say: Speaker) -> str:
    low, high, total = goal.at_least, goal.at_most, len(goal.over)
    if high == 0:
        many = "none"
    elif high == low:
        many = f"exactly {number(low)}"
    elif high is None or high >= total:
        many = f"at least {number(low)}" if low else "any number"
    elif low == 0:
        many = f"at most {number(high)}"
    else:
        many = f"between {number(low)} and {number(high)}"
    one = say.like(goal.over[:1])[0] if goal.var.startswith(ANY) and say.aliases and say.alike(goal.over) else ""
    say.aliases[goal.var] = one or f"{many} of {say.the(goal.over)}"
    if many != "exactly one" and not one:
        say.plural.add(goal.var)
    same = _bearing(goal, say) or _of_the_same(goal, say) or (None if one else _to_the_same(goal, say))
    text = _on_whichever(goal, say) or same or spoken(goal.goal, say)
    say.plural.discard(goal.var)
    del say.aliases[goal.var]
    return text
