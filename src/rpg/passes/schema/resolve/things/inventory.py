"""What blocks there are by a list of their own: it completes the other clauses, and must agree with them."""

from __future__ import annotations

from collections import Counter

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.schema import COLORS_UNSAID
from rpg.language.grammar.things.retold import tally as count
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import give
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def tally(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "2 red, 2 blue", "two of each": things that the other clauses speak of."""
    for size in [z for z in spec.sizes if z.what == "each" and z.amount is not None]:
        spec.sizes.remove(size)
        amount = size.amount or Amount(1, 1)
        if amount.low != amount.high or (scene.each is not None and scene.each[0] != amount.low):
            raise refuse("ambiguous", "it is not said how many of each there are", size.span, "say one number")
        scene.each, scene.each_in = (amount.low, size.span), scene.sentence
    if (kinds := blocks_and_patches(clause)) is not None:
        return [goal for one in kinds for goal in tally(one, spec, scene, scope)]
    whole = told_apart(clause.theme)
    if whole is None:
        return []
    if whole != clause.theme and isinstance(clause.theme, Coord):
        _counts(clause.theme.items[0], scene)
    if told_of(whole, scene):
        return []
    found = refer(whole, scene, replace(scope, given=True, start=True))
    if not found.names:
        raise refuse("misplaced", "it is not clear what there is", clause.span, "say 'there are two red blocks'")
    scene.mentions[-1].role = "given"
    for item in whole.items if isinstance(whole, Coord) else (whole,):
        _counts(item, scene)
    for name in found.names:
        scene.things[name].declared = True
        scene.tallied.add(name)
        if clause.lemma == "stock":
            scene.stocked.add(name)
    return []


def mark_given(theme: Ref, scene: Scene, span: Span) -> None:
    """What is said to be there; the table is no such thing. Blocks of several lines, of which nothing else is said, are
    as good as those of one."""
    if theme.table:
        raise refuse("misplaced", "the table is always there", span, "say what is on it")
    scene.mentions[-1].role = "given"
    for name in theme.names:
        scene.things[name].declared = True
    plain = [thing for thing in map(scene.things.__getitem__, theme.names) if not (thing.color or thing.label)]
    for thing in plain if len(theme.built) > 1 else ():
        thing.batch = plain[0].batch


def _counts(item: Meaning, scene: Scene) -> None:
    """There are as many as are listed, no more."""
    if (
        isinstance(item, Noun)
        and item.amount is not None
        and not item.traits.extra
        and not item.traits.labels
        and item.head != "patch"
    ):
        scene.closed.append((replace(item.traits, scheme=None), item.amount.low, item.span))


def told_of(whole: Meaning, scene: Scene) -> bool:
    """ "There are six blocks. Two are red and four are blue": these are the six, if it comes to as many."""
    items = [x for x in (whole.items if isinstance(whole, Coord) else (whole,)) if isinstance(x, Noun)]
    open_ = [t for t in scene.blocks() if t.declared and t.elastic is None and not t.extra and t.name not in scene.used]
    open_ = [t for t in open_ if t.color is None and t.label is None and t.kind is None and not t.claims]
    counts = [x.amount.low if x.amount else 1 for x in items if _plainly_colored(x)]
    lots = len(whole.items) if isinstance(whole, Coord) else 1
    if not open_ or len(counts) != lots:
        return False
    if sum(counts) != len(open_):
        raise refuse("ambiguous", "these could be some of the blocks named before, or further ones", whole.span,
                     "say of all of them what they look like, or 'another ...'")  # fmt: skip
    looks = [x.traits for x, many in zip(items, counts, strict=True) for _ in range(many)]
    for thing, traits in zip(open_, looks, strict=True):
        give(thing, traits)
        thing.claims = 0
    return True


def _plainly_colored(item: Noun) -> bool:
    return len(item.traits.colors) == 1 and not item.traits.labels and not item.traits.extra and item.part_of is None


def told_apart(theme: Meaning | None) -> Meaning | None:
    """ "four blocks, two red and two blue": the four, told apart."""
    if not isinstance(theme, Coord) or theme.op != "and":
        return theme
    first, *rest = theme.items
    if len(rest) < 2 and len(getattr(getattr(rest[0], "traits", None), "labels", ())) < 2:
        return theme
    if not isinstance(first, Noun) or first.head != "block" or first.amount is None:
        return theme
    if first.traits not in (Traits(), Traits(kind="plain")):
        return theme
    things = [item for item in rest if isinstance(item, Noun) and (item.traits.colors or item.traits.labels)]
    if len(things) != len(rest):
        return theme
    if sum(x.amount.low if x.amount else len(x.traits.labels) or 1 for x in things) != first.amount.low:
        raise refuse("ambiguous", "it is not clear how many blocks there are", theme.span, "say how many of each")
    return replace(theme, items=tuple(rest))


def blocks_and_patches(clause: Clause) -> tuple[Clause, Clause] | None:
    """ "there are three blocks and two mats": a clause for the blocks and one for the patches."""
    theme = clause.theme
    if not isinstance(theme, Coord) or theme.op != "and" or clause.adjuncts:
        return None
    theme = replace(theme, items=_retold_away(tuple(x for item in theme.items for x in _flat(item))))
    heads = [item.head if isinstance(item, Noun) else "" for item in theme.items]
    for index in reversed(range(len(heads))):
        if heads[index] == "any":
            heads[index] = (heads[index + 1 :] or [next((h for h in reversed(heads[:index]) if h != "any"), "")])[0]
    if set(heads) != {"block", "patch"}:
        return None
    items = [replace(x, head=head) if isinstance(x, Noun) and head == "patch" else x
             for x, head in zip(theme.items, heads, strict=True)]  # fmt: skip
    lots = [tuple(x for x, at in zip(items, heads, strict=True) if at == head) for head in ("block", "patch")]
    blocks, patches = (lot[0] if len(lot) == 1 else replace(theme, items=lot) for lot in lots)
    return replace(clause, theme=blocks), replace(clause, theme=patches)


def _retold_away(items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "three patches (red, yellow and blue) and ...": the patches one by one."""
    for n, whole in enumerate(items):
        plain = isinstance(whole, Noun) and whole.traits == Traits() and whole.amount is not None
        for end in range(n + 2, len(items) + 1) if plain else ():
            if isinstance(whole, Noun) and whole.amount is not None and count(items[n + 1 : end]) == whole.amount.low:
                told = (replace(x, head=whole.head) for x in items[n + 1 : end] if isinstance(x, Noun))
                return _retold_away((*items[:n], *told, *items[end:]))
    return items


def _flat(item: Meaning) -> tuple[Meaning, ...]:
    """The items of a list inside a list."""
    return tuple(x for one in item.items for x in _flat(one)) if isinstance(item, Coord) else (item,)


def each_agrees(scene: Scene) -> None:
    """ "two of each" holds of every kind of block that its sentence speaks of, or that there is."""
    if scene.each is None:
        return
    many, span = scene.each
    told = {n for m in scene.mentions if m.sentence == scene.each_in for n in m.ref.names}
    looks = {t.label or t.color for t in scene.blocks() if t.name in told or not told}
    blocks = [t for t in scene.blocks() if not t.extra and (t.label or t.color) in looks]
    kinds = Counter((t.label or t.color, (t.kind, t.size, t.edge)) for t in blocks)
    odd = next(((look, n) for (look, _), n in kinds.items() if n != many), None)
    if odd is not None and any(note.startswith(COLORS_UNSAID) for note in scene.assumptions):
        raise refuse("ambiguous", "it is not said which colors these are", span,
                     "name them: 'two red, two blue and two green blocks'")  # fmt: skip
    if odd is not None:
        raise refuse(
            "count-mismatch", f"there are {many} of each, but {odd[1]} {odd[0]}", span, "say how many of each kind",
            each=many, there=odd[1],
        )  # fmt: skip


__all__ = ["blocks_and_patches", "each_agrees", "mark_given", "tally", "told_apart"]
