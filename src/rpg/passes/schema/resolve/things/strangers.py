"""Things that were made up beside ones that are named: they may be meant to be the same."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir.walk import names as names_in
from rpg.passes.schema.resolve.clauses.alls import none_after_all
from rpg.passes.schema.resolve.things.world import Scene, Thing, refuse, said

_UNCOUNTED = (
    "the number of blocks is not said",
    "the size of the pyramid",
    "the number of steps",
    "the size of the grid",
)


def _unnamed(scene: Scene) -> None:
    """Blocks of which neither look nor number was said are not made up beside blocks that are named."""
    blocks = list(scene.blocks())
    open_ = [t for t in blocks if t.color is None and t.label is None and not t.kind and not t.extra]
    vague = [t for t in open_ if t.elastic is not None]
    vague += [t for t in blocks if t.name in scene.vague]
    if not vague and any(a.startswith(_UNCOUNTED) for a in scene.assumptions):
        vague = [t for t in open_ if t.batch == open_[-1].batch]
    if any(a.startswith("the number of letter blocks") for a in scene.assumptions):
        vague += [t for t in blocks if t.kind == "letter" and t.label is None and not t.extra]
    named = [t for t in blocks if t not in vague and not t.extra] if vague else []
    if named:
        raise refuse(
            "ambiguous",
            "some blocks are named or counted, but of others neither number nor look is said",
            None,
            "name all blocks, or say how many others there are",
            named=len(named),
        )


def _set_apart(scene: Scene) -> bool:
    """ "A pyramid to the left of a row of three", "a pyramid and a row of three": several structures of one clause,
    and no block that is in none of them."""
    places = [{*built.members} for built in scene.built]
    inside = set[str]().union(*places)
    clauses = {mention.clause for mention in scene.mentions}
    whole = all(thing.name in inside and not thing.extra for thing in scene.blocks())
    return len(places) > 1 and whole and len(clauses) == 1 and len(inside) == sum(map(len, places))


def _apposed(scene: Scene) -> None:
    """ "Three blocks, tan ones": so many without a look, and some of a look without a number, may be the same; so may
    the five letters beside the word ROBOT, and just as many that are named in another sentence."""
    blocks = [t for t in scene.blocks() if not t.extra]
    bare = [t for t in blocks if not (t.color or t.label or t.kind) or t.name in scene.painted]
    counted = [t for t in bare if t.elastic is None]
    letters = [t for t in blocks if t.kind == "letter"]
    if not counted and not letters:
        return
    spelt = [t for t in letters if t.label]
    blank = all(t.plain for t in counted)  # none of these is one of the letters
    looks = [t for t in blocks if t not in bare and (t.color or (t.label and not blank))]
    uncounted = [t for t in looks if t.elastic is not None]
    lots = [{t.name for t in lot} for lot in (counted, looks)]
    joint = any(all(lot & {*built.members} for lot in lots) for built in scene.built)
    same = len(counted) > 1 and len(looks) == len(counted) and not joint
    stock = [t for t in looks if t.name in scene.stocked]
    if same or (counted and stock) or (counted and uncounted) or (spelt and len(letters) == 2 * len(spelt)):
        told, hint = "the blocks that are counted may be those that are described", "say 'three red blocks'"
        raise refuse("ambiguous", told, None, hint)


def no_strangers(scene: Scene) -> None:
    """Refuse things that were made up, where they could be among those that are named."""
    apart = _set_apart(scene)
    if not apart:
        _unnamed(scene)
    if not (apart and any(mention.role == "landmark" and mention.ref.built for mention in scene.mentions)):
        _apposed(scene)
    _uncounted(scene)
    _like_distractors(scene)
    _uncoloured(scene)
    none_after_all(scene)
    _after_the_start(scene)


def _uncounted(scene: Scene) -> None:
    """ "None of the red blocks is on the mat. A red block is on the table.": one of them, or one more?"""
    further = {name for _, ref, _ in scene.besides for name in ref.names}
    for one in (t for t in scene.things.values() if t.elastic is not None and not t.extra):
        others = (t for t in scene.things.values() if t.batch != one.batch and not t.extra)
        like = [t for t in others if _look(t) == _look(one) and {t.quality, one.quality} not in _OPPOSITES]
        if any(t.name not in further for t in like):
            raise refuse(
                "ambiguous",
                f"it is not said how many blocks like {said(one)} there are, nor whether these are among them",
                _span(like, scene),
                "say how many there are, or 'another'",
            )


_OPPOSITES = ({"even", "odd"}, {"vowel", "consonant"})
"""What no block is at once: even numbers are not among the odd ones."""


def _span(things: list[Thing], scene: Scene) -> Span | None:
    """Where some of these things were spoken of last."""
    names = {thing.name for thing in things}
    return next((m.ref.span for m in reversed(scene.mentions) if names & set(m.ref.names)), None)


def _after_the_start(scene: Scene) -> None:
    """ "Take the tower of four red blocks apart and build two towers of two": of the same blocks, or of others?"""
    begun = {name for goal in scene.start_goals for name in names_in(goal) if not scene.things[name].patch}
    begun |= {n for heap in scene.heaps for n in heap}
    open_ = [t for t in scene.blocks() if not (t.color or t.label or t.kind or t.extra or t.declared)]
    open_ = [t for t in open_ if t.name not in begun]
    if begun and open_:
        raise refuse(
            "ambiguous",
            "these could be the blocks that there are at the start, or further ones",
            _span(open_, scene),
            "say 'them', or what the others look like",
        )


def _look(thing: Thing) -> tuple[object, ...]:
    return thing.patch, thing.color, thing.label, thing.kind, thing.size, thing.edge


def _like_distractors(scene: Scene) -> None:
    """ "Three white blocks are lying around. Put the white block on the mat.": one of the three, or a fourth?"""
    spare = {_look(t) for t in scene.blocks() if t.extra and (t.color or t.label)}
    like = [t for t in scene.blocks() if not t.extra and _look(t) in spare]
    if like:
        raise refuse("ambiguous", "blocks that look like this one lie about besides", _span(like, scene),
                     "say which are distractors, or say 'one of' them")  # fmt: skip


def _uncoloured(scene: Scene) -> None:
    """ "Each on a patch: A on the red one, B on the blue one": patches of no colour beside ones that have one."""
    patches = [t for t in scene.things.values() if t.patch and not t.extra]
    counted = [t for t in patches if t.color is None and t.elastic is not None]
    if counted and scene.stocked:
        raise refuse("ambiguous", "what is listed could be the patches or the blocks", _span(counted, scene),
                     "say 'blocks' or 'patches' where they are listed")  # fmt: skip
    further = {name for _, ref, _ in scene.besides for name in ref.names}
    open_ = [t for t in patches if t.color is None and t.name not in further]
    if open_ and len(open_) < len(patches) and any(t.color is not None for t in patches):
        raise refuse(
            "ambiguous",
            "some patches are named by their colour; this could be one of them or a further one",
            _span(open_, scene),
            "name all patches by their colours",
        )
