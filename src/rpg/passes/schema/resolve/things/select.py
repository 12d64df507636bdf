"""The names that a plain description stands for: those there are, or new ones."""

from __future__ import annotations

import string

from rpg.core.diagnostics import Refusal
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.walk import names as names_in
from rpg.language import lexicon
from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.things import alike, create, elastic, further, give, is_open, matching, open_to
from rpg.passes.schema.resolve.things.world import Scene, Scope, Thing, refuse, said, which_one


def select(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    """The names that a plain description (one colour, at most one label) stands for."""
    found = matching(noun.traits, scene, patch)
    if scope.pool and not patch:
        inside = [t for t in found if t.name in scope.pool]
        found = inside or found
    if (
        noun.traits.scheme in ("same", "different")
        and found
        and noun.det in ("the", "bare", "all")
        and noun.amount is None
    ):
        colors = {t.color for t in found}
        if None in colors or len(colors) != (1 if noun.traits.scheme == "same" else len(found)):
            raise which_one("it is not clear which of the blocks are meant", noun.span, "name their colours")
    amount = noun.amount
    indefinite = noun.det in ("a", "some", "another") or (noun.det == "bare" and amount is not None)
    if noun.det in ("any", "no", "bare", "some") and amount is None and (noun.plural or noun.det in ("any", "no")):
        indefinite = not found
    if scope.given and not scope.start:
        indefinite = indefinite or noun.det == "bare"
    if noun.det == "some" and amount is None and any(t.declared for t in found) and not scope.given:
        raise refuse("ambiguous", "it is not said how many of them", noun.span, "say how many, or 'all'")
    if indefinite:
        return _indefinite(noun, found, scene, scope, patch)
    return _definite(noun, found, scene, scope, patch)


def _indefinite(noun: Noun, found: list[Thing], scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    count = wanted(noun, scene, scope, patch)
    free = [t for t in found if t.name not in scene.used and (t.declared or t.name in scope.pool)]
    told = [t for t in found if t.name in scene.tallied]
    if scope.start and noun.traits == Traits() and not patch and count > 1 and len(told) == len(found) == count:
        return tuple(t.name for t in told)
    if (
        noun.det == "another"
        and scene.parted
        and (left := [t for t in found if t.declared and t.name not in scene.parted | scene.used])
    ):
        scene.parted.add(left[0].name)
        return (left[0].name,)
    if noun.det == "another" and not scope.given and (more := further(found, count, scene)):
        chosen = more
    elif noun.det != "another" and not scope.given and len(free) >= count:
        chosen = free[:count]
        if len(free) > count and not alike(free):
            raise refuse(
                "ambiguous",
                f"{count} of {len(free)} different blocks are meant, but not which",
                noun.span,
                "name their colours, or say 'any'",
            )
    elif claimed := _claim(noun, scene, scope, patch, count):
        chosen = claimed
    else:
        listed = any(t.declared and t.elastic is None for t in found)  # all of them may be used by now
        if (free or listed) and noun.det in ("bare", "some") and not scope.given and not patch and is_counted(noun):
            raise _too_few(noun, len(free), count)
        if noun.det == "a" and count == 1 and not scope.given and not patch:
            _one_more(noun, found, scene)
            _of_no_color(noun, [t for t in scene.blocks() if noun.head == "any"])
        scene.new_batch()
        chosen = _marked([create(noun.traits, scene, patch) for _ in range(count)], noun, scene, patch)
        for thing in chosen:
            thing.declared = scope.given
    if not scope.given:
        scene.used.update(t.name for t in chosen)
    return tuple(t.name for t in chosen)


def _too_few(noun: Noun, there: int, asked: int) -> Refusal:
    """Fewer are left of those that there are said to be, or none: all of them have a place."""
    left = f"there are only {there} of these" if there else "all of these have a place already"
    hint = f"ask for {there}, or for others ('another {asked}')" if there else f"say 'another {asked}', or 'the same'"
    return refuse("count-mismatch", f"{left}, but {asked} are asked for", noun.span, hint, there=there, asked=asked)


def _one_more(noun: Noun, found: list[Thing], scene: Scene) -> None:
    """Refuse "a red one" behind "two red blocks": one of the two, or a third one?"""
    there = {t.name for t in found}
    lots = [m.ref for m in scene.mentions if not m.ref.patch and len(m.ref.names) > 1]
    if noun.traits.colors and any(len(there & set(ref.names)) > 1 for ref in lots):
        raise which_one("this could be one of the blocks before it, or a further one", noun.span,
                        "say 'one of them', or 'another'")  # fmt: skip


def is_counted(noun: Noun) -> bool:
    """Whether a phrase says how many of one colour or label there are."""
    return noun.amount is not None and noun.amount.low > 0 and bool(noun.traits.colors or noun.traits.labels)


def _claim(noun: Noun, scene: Scene, scope: Scope, patch: bool, count: int) -> list[Thing]:
    """Members of the structure spoken of, or blocks there are said to be, take on looks that are open."""
    if patch or scope.given:
        return []
    if not scope.pool:
        return _claim_declared(noun, scene, count)
    open_ = [scene.things[n] for n in scope.pool if open_to(scene.things[n], noun.traits)]
    if len(open_) < count:
        return []
    for thing in open_[:count]:
        give(thing, noun.traits)
    return open_[:count]


def _begun(scene: Scene) -> set[str]:
    """The blocks of towers and rows that are there at the start: "put a blue block on top of it" is none of them."""
    wholes = [start for start in scene.start_goals if isinstance(start, s.Stack | s.Row | s.Grid | s.Figure)]
    return {name for whole in wholes for name in whole.blocks} if not scene.describing else set()


def _may_show(thing: Thing, traits: Traits) -> bool:
    """Whether a block may turn out to show one of these symbols: "turn the letter block so that the A is upright"."""
    sorts = {"letter": string.ascii_uppercase, "digit": string.digits}
    return thing.kind is None or (bool(traits.labels) and set(traits.labels) <= set(sorts.get(thing.kind, "")))


def _claim_declared(noun: Noun, scene: Scene, count: int) -> list[Thing]:
    """ "there are five blocks; put the red one ...", "stack five blocks so that the red one ...": one of the five."""
    if not noun.traits.colors and not noun.traits.labels:
        return []
    begun = _begun(scene) if noun.det == "a" and noun.head != "any" and not noun.part_of else set()
    open_ = [
        t
        for t in scene.blocks()
        if t.name not in begun
        and (t.name in scene.told or (t.declared and t.name not in scene.used))
        and t.elastic is None
        and _may_show(t, noun.traits)
        and not t.extra
        and open_to(t, noun.traits)
        and t.size is None
        and t.scheme in (None, "different")
    ]
    if len(open_) < count:
        return []
    for thing in open_[:count]:
        give(thing, noun.traits)
    return open_[:count]


def _claim_one(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> list[Thing]:
    """ "three blocks next to each other, the red one in the middle": one of the three."""
    if (
        patch
        or scope.given
        or noun.head != "any"
        or noun.det != "the"
        or not (noun.traits.colors or noun.traits.labels)
    ):
        return []
    open_ = [t for t in scene.blocks() if not t.extra and t.elastic is None and t.kind is None and t.size is None]
    open_ = [t for t in open_ if t.color is None and t.label is None and open_to(t, noun.traits)]
    if len({t.batch for t in open_}) != 1 or sum(t.batch == open_[0].batch for t in scene.blocks()) < 2:
        return []
    give(open_[0], noun.traits)
    return open_[:1]


def _so_many_told(noun: Noun, amount: int, scene: Scene) -> tuple[str, ...]:
    """ "Stack red, green and blue. The three ...": the blocks that were told together, if only once so many were. "Put
    red on blue, both 5 cm wide": those that the sentence speaks of, if they are so many."""
    if noun.traits != Traits() or noun.det not in ("the", "all") or noun.head == "patch":
        return ()
    here = [n for m in scene.mentions if m.sentence == scene.sentence and not m.ref.patch for n in m.ref.names]
    if len(dict.fromkeys(here)) == amount:
        return tuple(dict.fromkeys(here))
    told = {frozenset(m.ref.names): m.ref.names for m in scene.mentions if len(set(m.ref.names)) == amount}
    found = next(iter(told.values())) if len(told) == 1 else ()
    return () if any(scene.things[name].patch for name in found) else found


def _definite(noun: Noun, found: list[Thing], scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    if not found and noun.head == "any" and noun.traits == Traits() and not scope.pool:
        raise refuse("no-referent", "it is not clear what this refers to", noun.span, "name the block")
    amount = noun.amount.low if noun.amount and noun.det != "a" else (2 if noun.det == "both" else None)
    some = noun.det in ("all", "each") or (noun.det == "any" and len(found) > 1)
    single = not noun.plural and amount in (None, 1) and not some
    if single:
        found = _left_empty(noun, found, scene) if patch and noun.traits.empty else found
        if len(found) == 1:
            return (found[0].name,)
        if len(found) > 1:
            return (_pick(noun, found, scene, scope).name,)
        if claimed := _claim(noun, scene, scope, patch, 1) or _claim_one(noun, scene, scope, patch):
            return (claimed[0].name,)
        if scope.role != "landmark" and (shown := _shown_on(noun, scene)) is not None:
            return (shown,)
        if noun.head == "any" and noun.det == "the" and not patch:
            if (strange := _odd_one_out(noun, scene)) is not None:
                return (strange,)
            _known_one(noun, scene, scope)
        scene.new_batch()
        return (create(noun.traits, scene, patch).name,)
    if amount is not None:
        if len(found) > amount and (told := _so_many_told(noun, amount, scene)):
            return told
        if len(found) > amount:
            message = f"{amount} are spoken of, but there are {len(found)} such blocks"
            raise which_one(message, noun.span, "say which, or 'any'")
        if any(t.declared for t in found) and len(found) < amount and not scope.given:
            raise refuse(
                "too-many-asked",
                f"{amount} are spoken of, but there are only {len(found)}",
                noun.span,
                f"say {len(found)}",
                asked=amount,
                there=len(found),
            )
        if not found and (claimed := _claim(noun, scene, scope, patch, amount)):
            return tuple(t.name for t in claimed)
        if len(found) < amount:
            if not found or not scope.given:
                scene.new_batch()
            found = found + [create(noun.traits, scene, patch) for _ in range(amount - len(found))]
        return tuple(t.name for t in found)
    if len(found) >= (2 if noun.plural and noun.traits.colors else 1) or (found and noun.det in ("all", "each")):
        return tuple(t.name for t in found)
    if found and (not noun.plural or all(t.name in scene.tallied for t in found)):
        return tuple(t.name for t in found)
    count = wanted(noun, scene, scope, patch)
    scene.new_batch()
    found = found + _marked(
        [create(noun.traits, scene, patch) for _ in range(max(0, count - len(found)))], noun, scene, patch
    )
    return tuple(t.name for t in found)


def _odd_one_out(noun: Noun, scene: Scene) -> str | None:
    """ "the odd one (out)" where all the others look alike: the one that does not."""
    there = [t for t in scene.blocks() if not t.extra]
    looks = [(t.color, t.label, t.kind, t.size, t.edge) for t in there]
    single = [t.name for t, look in zip(there, looks, strict=True) if looks.count(look) == 1]
    if noun.traits != Traits(quality="odd") or len(there) < 3:
        return None
    if len(single) != 1 or len(set(looks)) != 2:
        raise refuse("ambiguous", "it is not clear which block does not look like the others", noun.span, "name it")
    return single[0]


def _known_one(noun: Noun, scene: Scene, scope: Scope) -> None:
    """Refuse "the big one" of no colour beside coloured blocks, and "the purple one" where all blocks were listed."""
    there = [t for t in scene.blocks() if not t.extra]
    look = noun.traits
    _of_no_color(noun, there)
    begun = {name for goal in scene.start_goals for name in names_in(goal)}
    listed = [t for t in there if t.declared and t.name not in begun]
    before = any(m.role == "given" and m.ref.span[0] < noun.span[0] for m in scene.mentions)
    if look.colors and len(listed) > 1 and before and not scope.given:
        raise refuse("no-referent", "there is no such block among those that were listed", noun.span,
                     "name one of those, or list this one too")  # fmt: skip


def _of_no_color(noun: Noun, there: list[Thing]) -> None:
    """Refuse "the big one", "a big one" beside coloured blocks."""
    look = noun.traits
    sized = bool(look.size or look.edge) and look == Traits(size=look.size, edge=look.edge)
    if sized and any(t.color or t.label for t in there):
        raise refuse("ambiguous", "it is not said what colour this block has", noun.span, "name its colour")


def _shown_on(noun: Noun, scene: Scene) -> str | None:
    """ "rotate a block so that the letter ...": the letter is the one that the block just spoken of shows."""
    last = scene.mentions[-1] if scene.mentions else None
    if noun.det != "the" or noun.traits.kind not in ("letter", "digit") or noun.traits.colors or noun.traits.labels:
        return None
    if last is None or len(last.ref.names) != 1 or last.role == "landmark":
        return None
    thing = scene.things[last.ref.names[0]]
    if thing.patch or thing.label is not None or thing.kind is not None:
        return None
    thing.kind = noun.traits.kind
    return thing.name


def wanted(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> int:
    """How many objects a phrase brings in; a default where it does not say."""
    if counted_each(noun, scene, patch) and scene.each is not None:
        return scene.each[0]
    if noun.amount is not None:
        low, high = noun.amount.low, noun.amount.high
        return high if high is not None and high > low else low or 1
    if not noun.plural and noun.det in ("a", "the", "bare", "another", "its"):
        return 1
    return scope.need or (3 if noun.det in ("all", "each", "any", "no", "some") else 2)


def _marked(things: list[Thing], noun: Noun, scene: Scene, patch: bool) -> list[Thing]:
    return things if counted_each(noun, scene, patch) else elastic(things, noun, patch)


def counted_each(noun: Noun, scene: Scene, patch: bool) -> bool:
    """ "the red blocks" where "there are two of each"."""
    return scene.each is not None and not patch and is_open(noun) and len(noun.traits.colors) == 1


def _last_named(noun: Noun, found: list[Thing], scene: Scene, scope: Scope) -> Thing | None:
    """ "Red goes on blue and that one on green": the block that the clause before named last, in the same sentence.
    Where something is put on "that one", or beside it on the same side, it may as well be the block that was put there.
    "Behind it green. Behind that one blue": the only one that the clause before named."""
    told = [m for m in scene.mentions if m.clause == scene.clause - 1 and m.ref.names]
    last = max(told, key=lambda m: m.ref.span, default=None)
    bare = (noun.head, noun.traits, noun.amount, noun.conditions, noun.part_of) == ("any", Traits(), None, (), None)
    if last is None or not bare or noun.det != "the":
        return None
    named = [m for m in told if not m.word]
    alone = scope.role == "landmark" and len(named) == 1 < len(told) and not named[0].ref.patch
    last = named[0] if alone else last
    if not alone and (last.sentence != scene.sentence or last.role != "landmark"):
        return None
    if not alone and scope.role != "theme" and last.rel in ("on", "above", "in", scope.rel):
        return None
    single = len(last.ref.names) == 1 and not last.ref.built and last.ref.quant is None
    return next((t for t in found if t.name == last.ref.names[0]), None) if single else None


def _left_empty(noun: Noun, found: list[Thing], scene: Scene) -> list[Thing]:
    """ "The empty patch": the one on which nothing starts, or was put in what was said before."""
    begun = {x.patch for x in scene.start_goals if isinstance(x, r.OnPatch)}
    put = {n for m in scene.mentions if m.ref.patch and m.rel == "on" for n in m.ref.names}
    free = [t for t in found if t.name not in (begun or put)]
    if found and not free:
        raise refuse("no-referent", "there is something on this patch", noun.span, "name its colour")
    return free


def _pick(noun: Noun, found: list[Thing], scene: Scene, scope: Scope) -> Thing:
    """The one of several that was spoken of last, if just one was; else the phrase is ambiguous."""
    if scope.role == "landmark":  # what is placed is not placed relative to itself
        placed = {n for m in scene.mentions if (m.clause, m.role) == (scene.clause, "theme") for n in m.ref.names}
        found = [t for t in found if t.name not in placed] or found
    if len(found) == 1:
        return found[0]
    singles = {m.ref.names[0] for m in scene.mentions if len(m.ref.names) == 1}
    recent = [t for t in found if t.name in singles]
    if len(recent) == 1 and (len(found) == 1 or not any(t.declared for t in found)):
        return recent[0]
    if (last := _last_named(noun, found, scene, scope)) is not None:
        return last
    what = said(found[0])[4:]
    if len({(t.color, t.label, t.size) for t in found}) > 1:
        names = ", ".join(dict.fromkeys(said(t) for t in found))
        raise which_one(f"this could be {names}", noun.span, "name its colour or its label")
    raise which_one(
        f"there are {len(found)} of them: it could be any {what}",
        noun.span,
        f"say 'one of the {lexicon.plural_of(what)}' or 'a {what}'",
    )
