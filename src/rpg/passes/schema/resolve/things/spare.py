"""Distractors: blocks of which the goal says nothing, because they are said to be only there."""

from __future__ import annotations

from typing import TypeGuard

from rpg.ir import goal as g
from rpg.ir.relations import Stayed
from rpg.ir.walk import atoms
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Chain, Clause, Coord, In, Loc, Meaning, Noun, Pronoun, Structure, That, Traits, replace
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse, said


def left_out_first(chain: Chain) -> Chain:
    """ "Build a tower of three without using the white one": what is left out is told before what is built of the
    rest."""
    clauses: list[Meaning] = []
    first: list[Clause] = []
    for clause in chain.clauses:
        if isinstance(clause, Clause) and clause.verb == "build" and isinstance(clause.theme, Structure):
            unused = [(part, theme) for part in clause.adjuncts if (theme := _unused(part)) is not None]
            first += [Clause(verb="ignore", lemma="spare", theme=x, mode="goal", span=part.span) for part, x in unused]
            clause = replace(clause, adjuncts=tuple(a for a in clause.adjuncts if _unused(a) is None))
        if clauses and leaves_out(clause):
            first.append(clause)
        else:
            clauses.append(clause)
    built = [c.theme for c in clauses if isinstance(c, Clause) and c.verb == "build" and not c.negated]
    if not first or not any(map(_of_any_blocks, built)) or any(link != "and" for link in chain.links):
        return chain
    told_first = (*first, *clauses)
    return replace(chain, clauses=told_first, links=("and",) * len(told_first))


def _unused(part: Meaning) -> Noun | None:
    """ "Without using the white one"."""
    inner = part.clauses if isinstance(part, That) and part.kind == "without" else None
    told = inner.clauses[0] if isinstance(inner, Chain) and len(inner.clauses) == 1 else None
    using = isinstance(told, Clause) and told.verb == "use" and not told.adjuncts
    return told.theme if using and isinstance(told, Clause) and isinstance(told.theme, Noun) else None


def _of_any_blocks(shape: Meaning | None) -> bool:
    """ "A tower of three", "a row of the blocks"."""
    blocks = shape.members if isinstance(shape, Structure) and shape.traits == Traits() else None
    bare = isinstance(shape, Structure) and shape.traits == Traits() and blocks is None
    return bare or (isinstance(blocks, Noun) and blocks.traits == Traits())


def leaves_out(clause: Meaning) -> TypeGuard[Clause]:
    """ "Do not use the white block", "without the white one"."""
    theme = clause.theme if isinstance(clause, Clause) and clause.verb == "ignore" and not clause.adjuncts else None
    return isinstance(theme, Noun) and theme.det == "the" and theme.traits != Traits()


def without_spare(chain: Chain) -> Chain:
    """The sentence with a clause of their own for distractors that stand beside what it speaks of."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        extras: list[Noun] = []
        if isinstance(clause, Clause) and clause.verb not in ("exist", "ignore") and clause.theme is not None:
            theme = _without(clause.theme, extras)
            if isinstance(theme, Structure) and theme.members is not None:
                theme = replace(theme, members=_without(theme.members, extras))
            places = tuple(_without_place(a, extras) for a in clause.adjuncts)
            clause = replace(clause, theme=theme, adjuncts=places) if extras else clause
        _there_without(clause, clauses[-1] if clauses else None)
        clauses.append(clause)
        clauses += [Clause(verb="ignore", lemma="spare", theme=x, mode="goal", span=x.span) for x in extras]
        links += [link, *("and" for _ in extras)]
    return replace(chain, clauses=tuple(clauses), links=tuple(links)) if len(clauses) > len(chain.clauses) else chain


def _there_without(left: Meaning, before: Meaning | None) -> None:
    """Refuse "red is on the mat without the blue one": it is not used, or it is not there?"""
    out = isinstance(left, Clause) and left.verb == "ignore" and left.lemma == "without"
    placed = isinstance(before, Clause) and before.verb in ("be", "place") and not isinstance(before.theme, Structure)
    if out and placed and isinstance(before, Clause) and any(isinstance(a, Loc | In) for a in before.adjuncts):
        raise refuse("ambiguous", "is this block not used at all, or is it not to be there?", left.span,
                     "say 'but not the ...' in front of 'on', or 'do not use ...'")  # fmt: skip


def _without_place(place: Meaning, extras: list[Noun]) -> Meaning:
    """ "on the blue block and a green distractor": on the blue block."""
    if not isinstance(place, Loc) or place.landmark is None or place.rel == "between":
        return place
    return replace(place, landmark=_without(place.landmark, extras))


def _without(meaning: Meaning, extras: list[Noun]) -> Meaning:
    """A list without its distractors, which go to `extras`."""
    if not isinstance(meaning, Coord) or meaning.op != "and":
        return meaning
    spare = [x for x in meaning.items if isinstance(x, Noun) and x.traits.extra]
    rest = tuple(x for x in meaning.items if x not in spare)
    if not spare or not rest:
        return meaning
    extras += spare
    return rest[0] if len(rest) == 1 else replace(meaning, items=rest)


def ignore(clause: Clause, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "ignore the green block", "two black ones serve as a distraction"."""
    first = clause.theme is not None and clause.theme.span[0] == clause.span[0]  # not "ignore the rest"
    left_open = first and _of_no_others(clause.theme, scene)
    items = clause.theme.items if isinstance(clause.theme, Coord) and clause.theme.op == "and" else ()
    mixed = {isinstance(x, Noun) and x.head == "patch" for x in items} == {True, False}
    for theme in items if mixed else (clause.theme,):  # "a white patch and a red block serve as distractors"
        if theme is not None and not left_open:
            passed = refer(_so_many_more(theme, scene), scene, scope)
            pass_over(passed, scene)
            if not first:  # "do not use D": nor is it on top of what is built
                scene.left_out |= {n for n in passed.names if not scene.things[n].patch}
    return []


def _of_no_others(theme: Meaning | None, scene: Scene) -> bool:
    """ "the rest does not matter", where all blocks there are were spoken of: it asks for nothing, and neither does it
    of "the others" behind "at least two of the three"."""
    some = any(m.ref.quant is not None and m.ref.quant.low < len(m.ref.names) for m in scene.mentions)
    if getattr(theme, "word", "") not in ("the rest", "everything else", *(("the others",) if some else ())):
        return False
    placed = {name for m in scene.mentions if m.role != "given" for name in m.ref.names}
    return bool(placed) and all(t.extra or t.name in placed for t in scene.blocks())


def _so_many_more(theme: Meaning, scene: Scene) -> Meaning:
    """ "ignore the three other blocks", where all blocks spoken of have their place: three more that are only there."""
    if not isinstance(theme, Noun) or theme.det != "other" or theme.head == "patch" or theme.conditions:
        return theme
    counted = theme.amount is not None and theme.amount.low == theme.amount.high
    if not counted or theme.traits != Traits() or any(t.declared for t in scene.things.values()):
        return theme
    placed = {name for m in scene.mentions if m.role != "given" for name in m.ref.names}
    if not placed or any(not t.extra and t.name not in placed for t in scene.blocks()):
        return theme
    return replace(theme, det="bare", traits=Traits(extra=True))


def pass_over(ref: Ref, scene: Scene) -> None:
    """Let blocks be distractors, of which the goal says nothing."""
    if ref.quant is not None or ref.op not in ("and", "then"):
        raise refuse("ambiguous", "it is not said which of the blocks", ref.span, "name the blocks")
    for name in ref.names:
        scene.things[name].extra = True
        scene.ignored[name] = ref.span


def definite(meaning: Meaning) -> bool:
    """ "the S is a distractor": of a block that may be there already."""
    if isinstance(meaning, Coord):
        return all(map(definite, meaning.items))
    return isinstance(meaning, Pronoun) or (
        isinstance(meaning, Noun) and meaning.det in ("the", "all", "other", "both")
    )


def known(meaning: Meaning, scene: Scene) -> bool:
    """ "the S"; "(There are A, B and C. ...) B and C (are distractors)": blocks of those that were said to be there."""
    if definite(meaning):
        return True
    if isinstance(meaning, Coord):
        return meaning.op == "and" and all(known(item, scene) for item in meaning.items)
    if not isinstance(meaning, Noun) or (meaning.det, meaning.amount) != ("bare", None):
        return False
    looks = max(len(meaning.traits.colors), len(meaning.traits.labels))
    there = matching(meaning.traits, scene, meaning.head == "patch")
    return len(there) == looks > 0 and all(thing.declared for thing in there)


def further(meaning: Meaning) -> bool:
    """ "two more green blocks"."""
    if isinstance(meaning, Coord):
        return any(map(further, meaning.items))
    return isinstance(meaning, Noun) and meaning.det in ("another", "other")


def none_ignored(goal: g.Goal, scene: Scene) -> None:
    """Refuse a distractor of which the goal says something, but that it stays where it is."""
    for dealt, refusal in scene.dealt:
        if not {*dealt} <= {*names_in(goal)}:
            raise refusal
    for name in (name for atom in atoms(goal) if not isinstance(atom, Stayed) for name in names_in(atom)):
        if name in scene.ignored:
            what = said(scene.things[name])
            raise refuse("contradiction", f"{what} is not to be used, and yet something is said of it",
                         scene.ignored[name], "say where it should be, or that it is a distractor")  # fmt: skip
