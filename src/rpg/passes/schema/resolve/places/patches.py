"""Blocks on patches: one for all, one for each, the one of its colour."""

from __future__ import annotations

from itertools import permutations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH, members
from rpg.ir.schema import COLORS_UNSAID
from rpg.language.meaning import Amount, Coord, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj
from rpg.passes.schema.resolve.places.lots import one_lot_each
from rpg.passes.schema.resolve.places.own_patches import by_color
from rpg.passes.schema.resolve.things.operands import spread
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.second_patch import the_only_patch
from rpg.passes.schema.resolve.things.shares import just_these, so_many_each
from rpg.passes.schema.resolve.things.things import alike, matching
from rpg.passes.schema.resolve.things.world import Mention, Ref, Scene, Scope, refuse

MAX_SHARED = 3
"""So many groups of blocks are dealt out to patches in every possible way."""


def on_patches(theme: Ref, mark: Ref, scene: Scene, span: Span) -> g.Goal:
    patches = mark.names
    if theme.patch:
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", span, "move blocks instead")
    if mark.op == "or" or (mark.quant is not None and mark.quant.low == 1):
        if theme.quant is not None and theme.quant.low > 1:
            raise refuse("ambiguous", "so many on the same one, or on any of them?", span,
                         "say 'together on one of ...', or name the patch")  # fmt: skip
        if (theme.each and not theme.built) or theme.quant is not None:
            return _on_any(theme, patches, span)
        _on_the_same(theme, mark, scene, span)
        return disj([_on_patch(theme, p, span) for p in patches], span)
    if len(patches) == 1:
        return _on_patch(theme, patches[0], span)
    if mark.quant is not None and mark.quant.low > 1 and not mark.each:
        raise refuse("ambiguous", "one on each of them, or anywhere on them?", span, "say what each patch gets")
    if indefinite(theme) and theme.quant is None and not (mark.each or theme.built or scene.denying):
        theme = replace(theme, names=scene.fit(theme.names, len(patches)))  # "red blocks on all three mats"
    if scene.denying and mark.det == "both":
        if len(theme.names) == 1:
            raise refuse("ambiguous", "no block is on both at once: is it to be on neither?", span,
                         "say 'on neither', or 'not on the red one'")  # fmt: skip
        return conj([_on_patch(theme, p, span) for p in patches], span)
    one = len(theme.names) == 1 or (theme.each and not theme.built and len(mark.parts) > 1)
    if (one and not mark.each and not scene.denying) or theme.op not in ("and", "except"):
        raise refuse("ambiguous", "a block cannot be on several patches at once", span,
                     "name one of them, say 'or', or say which block goes on which")  # fmt: skip
    theme = so_many_each(theme, mark, scene)
    if mark.each and theme.quant is not None and _known(theme, scene):
        return conj([_on_patch(theme, p, span) for p in patches], span)
    if mark.each and theme.quant is not None and not just_these(theme, scene):
        raise refuse(
            "ambiguous", "it is not clear which blocks are counted on each patch", span, "say it of one patch at a time"
        )
    _each_or_together(theme, mark, span)
    if mark.each and indefinite(theme) and not theme.built:
        return _a_lot_each(theme, patches, scene, span)
    units = theme.built if len(theme.built) == len(patches) else ()
    whole = not units and len(theme.built) == 1 and (mark.each or theme.built[0].kind == "stack")
    as_many = units or (len(theme.names) == len(patches) and not whole)
    if as_many and not _in_turn(theme, mark, scene):
        return dealt([b.members for b in units] or [(name,) for name in theme.names], patches, span)
    if units:
        return conj(
            [_on_patch(Ref(names=b.members, built=(b,)), p, span) for b, p in zip(units, patches, strict=True)], span
        )
    if mark.each and (theme.built or len(theme.names) < len(patches)):
        raise refuse("ambiguous", "this cannot be on each of several patches at once", span, "name what each one gets")
    if theme.quant is not None and mark.det == "both" and theme.quant.high != 0:
        return conj([_on_patch(theme, p, span) for p in patches], span)
    if theme.quant is not None and not mark.each:
        return _on_any(theme, patches, span)
    if len(theme.names) == len(patches) and not whole:
        pairs = zip(theme.names, patches, strict=True)
        return conj([r.OnPatch(a=(a,), patch=p, span=span) for a, p in pairs], span)
    if len(theme.names) > len(patches) and all(scene.things[p].elastic is not None for p in patches):
        raise refuse("ambiguous", "it is not said how many patches there are, and which block goes on which", span,
                     "say how many, and 'one on each', or name the patch of each")  # fmt: skip
    return _on_any(replace(theme, built=()), patches, span)


def _a_lot_each(theme: Ref, patches: tuple[str, ...], scene: Scene, span: Span) -> g.Goal:
    """ "A red block on each patch": as many again for every patch."""
    lots = one_lot_each(theme, len(patches), scene)
    if _unnamed(lots, scene):
        names, each = tuple(n for lot in lots for n in lot), len(lots[0])
        return conj([_so_many(names, p, each, each, span) for p in patches], span)
    return conj([r.OnPatch(a=lot, patch=p, span=span) for lot, p in zip(lots, patches, strict=True)], span)


def _on_the_same(theme: Ref, mark: Ref, scene: Scene, span: Span) -> None:
    """Refuse "all of them must be on one of the mats"."""
    if len(theme.names) > 1 and theme.det in ("all", "bare") and scene.describing and not (theme.built or mark.parts):
        raise refuse("ambiguous", "all on the same one, or each on any of them?", span,
                     "say 'all on the same patch', or 'each of them'")  # fmt: skip


def _each_or_together(theme: Ref, mark: Ref, span: Span) -> None:
    """Refuse "two blocks are on both mats", "at least two are on the red and the blue mat"."""
    if mark.each or theme.built:
        return
    some = theme.quant is not None and theme.quant.high != 0 and len(mark.parts) > 1 and mark.det != "both"
    if some or (mark.det == "both" and indefinite(theme) and theme.quant is None and len(theme.names) > 1):
        raise refuse("ambiguous", "so many on each of them, or on all of them together?", span,
                     "say 'on each of the ... patches'")  # fmt: skip


def _in_turn(theme: Ref, mark: Ref, scene: Scene) -> bool:
    """Whether patches are listed like the blocks, or it is all the same which block goes where: "red and blue on the
    two patches" leaves it open."""
    looks = {(t.color, t.label, t.kind, t.size, t.edge) for t in (scene.things[name] for name in theme.names)}
    alike = len(looks) == 1 and looks != {(None, None, None, None, None)}
    one_each = mark.each and bool(theme.built)  # "a tower on each of the red and the blue patch"
    return alike or (not one_each and (len(mark.parts) > 1 or mark.listed))


def _on_any(theme: Ref, patches: tuple[str, ...], span: Span) -> g.Goal:
    """Each of the blocks, or so many of them, on any of the patches."""
    return spread(theme, lambda a: disj([r.OnPatch(a=a, patch=p, span=span) for p in patches], span), span)


def check_same(theme: Ref, loc: Loc, scene: Scene) -> None:
    """Refuse "red is next to blue and on the same mat", where no mat is spoken of: it is said of both."""
    same = isinstance(loc.landmark, Noun) and loc.landmark.head == "patch" and loc.landmark.traits.scheme == "same"
    if same and len(theme.names) == 1 and not any(m.ref.patch for m in scene.mentions):
        raise refuse("ambiguous", "it is not clear which blocks these are the same for", loc.span,
                     "name all of them: 'red and blue are on the same patch'")  # fmt: skip


def like_the_last(loc: Loc, scene: Scene) -> bool:
    """Whether a landmark without a noun is a patch like the last one: "red on the green patch, blue on (the) yellow".

    Behind "nothing on the green patch" and "the green patch stays empty" only "the yellow one" is. In another sentence,
    or with a verb of its own, "blue on yellow" may be the next of several patches, or blocks alone.
    """
    before = scene.last_landmark_patch and scene.last_landmark_at < loc.span[0]
    told = [m for m in scene.mentions if m.clause < scene.clause]
    last = [m for m in told if m.clause == told[-1].clause]
    if isinstance(loc.landmark, Noun) and loc.landmark.det == "the" and loc.landmark.head == "any":
        there = [m.ref.names for m in scene.mentions if m.ref.patch and m.ref.names]
        if there and loc.landmark.traits.colors and len(there[-1]) == 1 and the_only_patch(there[-1][0], scene):
            return False
        same = _other_patch(loc.landmark, [m for m in last if m.ref.span < loc.span], scene)
        one_of = any(not m.ref.patch and m.ref.quant is not None for m in told)
        borne = any(not m.ref.patch and m.role == "theme" and m.sentence < scene.sentence for m in last)
        which = loc.landmark.traits == Traits() and (one_of or borne)  # "Red is on the mat. Put blue on that one."
        if before and (which or _with_another_verb(loc.landmark, scene)):
            raise refuse("ambiguous", "this could be a block or a patch", loc.landmark.span, "say 'block' or 'patch'")
        return before or same or (bool(last) and all(m.ref.patch and m.role == "theme" for m in last))
    if not before or any(m.ref.everything and m.ref.quant is not None for m in last):
        return False
    patch = next((m.ref.names for m in reversed(scene.mentions) if m.ref.patch and m.ref.names), ())
    bare = isinstance(loc.landmark, Noun) and loc.landmark.det == "bare" and loc.landmark.traits.colors
    if bare and len(patch) == 1 and scene.things[patch[0]].color is None:
        return False  # "red on the mat, green on blue": a patch that has no colour is no example of one told by colour
    if isinstance(loc.landmark, Noun) and _from_afar(loc.landmark, scene):
        raise refuse("ambiguous", "this could be a block or a patch", loc.landmark.span, "say 'block' or 'patch'")
    return True


def _other_patch(noun: Noun, last: list[Mention], scene: Scene) -> bool:
    """ "On the white patch A is next to B, on the black one C next to D": that is a patch, for no block is black."""
    colors = noun.traits.colors
    plain = bool(colors) and noun.traits == Traits(colors=colors)
    verbs = [scene.verbs[n][2] for n in (scene.clause, *(m.clause for m in last)) if n in scene.verbs]
    several = any(m.clause == scene.clause and m.role == "theme" and len(m.ref.names) > 1 for m in scene.mentions)
    together = several and any(m.sentence == scene.sentence for m in last)
    if verbs[:1] == ["stack"] and set(verbs) != {"stack"} and not together:
        return False  # "Put A on the white patch. Stack C on the black one": blocks are stacked on blocks
    there = any(thing.color in colors and not thing.patch for thing in scene.things.values())
    return plain and not there and any(m.ref.patch and m.role == "landmark" and m.rel == "on" for m in last)


def _from_afar(noun: Noun, scene: Scene) -> bool:
    """Whether a colour alone is new, and the last patch was spoken of in another sentence, or with its own verb."""
    if noun.head != "any" or noun.det != "bare" or not noun.traits.colors:
        return False
    last = next((m for m in reversed(scene.mentions) if m.ref.patch), None)
    known = any(t.color in noun.traits.colors for t in scene.things.values())
    if known or last is None:
        return False
    return last.sentence != scene.sentence or scene.verbs.get(last.clause) != scene.verbs.get(scene.clause)


def _with_another_verb(noun: Noun, scene: Scene) -> bool:
    """Whether no block has a look, and the last patch was spoken of with another verb, and of other blocks: "once red
    is on the white patch, put the blue cube on the green one"."""
    last = next((m for m in reversed(scene.mentions) if m.ref.patch), None)
    known = any(t.color in noun.traits.colors and not t.patch for t in scene.things.values())
    if last is None or known or not noun.traits.colors or last.clause == scene.clause:
        return False
    here, there = ({n for m in scene.mentions if m.clause == clause and m.role == "theme" for n in m.ref.names}
                   for clause in (scene.clause, last.clause))  # fmt: skip
    verbs = [scene.verbs[n][2] for n in (last.clause, scene.clause) if n in scene.verbs]
    return here.isdisjoint(there) and len(set(verbs)) > 1


def _unnamed(lots: list[tuple[str, ...]], scene: Scene) -> bool:
    """Whether nothing says which blocks these are; plain ones are then taken alike."""
    things = [scene.things[n] for lot in lots for n in lot]
    if any(t.color or t.label or t.declared or t.scheme not in (None, "different") for t in things):
        return False
    if all(t.kind is None and t.scheme is None for t in things):
        for thing in things:
            thing.scheme = "same"
        return False
    return True


def indefinite(theme: Ref) -> bool:
    """Whether blocks are called for that were not known: "a red and a blue block", "two blocks"."""
    if theme.op == "and" and theme.parts:
        return all(indefinite(part) for part in theme.parts)
    return theme.op == "and" and theme.det in ("a", "bare", "some")


def _known(theme: Ref, scene: Scene) -> bool:
    """Whether so many of blocks are meant that are known: those there are, those spoken of, "one of A, B and C"."""
    if all(n in scene.told or scene.things[n].declared for n in theme.names):
        return True
    bound = theme.quant and (theme.quant.low if theme.quant.high is None else theme.quant.high)
    return bound is not None and len(theme.names) > bound


def each_its_own(theme: Ref, mark: Ref, loc: Loc, scene: Scene) -> list[tuple[Ref, Ref]] | None:
    """ "on each of the three blue blocks there is one of the three red ones": one on each, as there are as many."""
    if theme.quant != Amount(1, 1, True) or not mark.each or mark.built or mark.quant is not None or loc.rel != "on":
        return None
    looks = {(t.color, t.label, t.kind, t.size) for t in (scene.things[n] for n in theme.names)}
    alike_ = len(looks) == 1 and looks != {(None, None, None, None)}  # those come to differ where nothing is said
    if len(theme.names) != len(mark.names) or len(mark.names) < 2 or not alike_ or loc.negated:
        return None
    pairs = zip(theme.names, mark.names, strict=True)
    return [(Ref(names=(a,)), Ref(names=(b,), patch=mark.patch)) for a, b in pairs]


def _on_patch(theme: Ref, patch: str, span: Span) -> g.Goal:
    return spread(theme, lambda a: r.OnPatch(a=a, patch=patch, span=span), span, together=True)


def matching_patches(theme: Ref, mark: Ref, scene: Scene, span: Span) -> Atoms:
    """ "(no) block on the patch of its colour"."""
    if theme.quant is None or theme.quant.high != 0:
        return _of_their_colors(theme, scene, span)
    if not theme.names:
        raise refuse("no-referent", "it is not said which blocks there are", span, "say first which blocks there are")
    own = _of_their_colors(replace(theme, quant=None), scene, span)
    there = [(n, x) for x in own if isinstance(x, r.OnPatch) for n in members(x.a)]
    return [g.Not(goal=x.model_copy(update={"a": (n,)}), span=span) for n, x in there]


def _of_their_colors(theme: Ref, scene: Scene, span: Span) -> Atoms:
    """ "each block on the patch of its colour": one patch for every colour among the theme."""
    blocks = [scene.things[n] for n in theme.names]
    if any(b.kind == "towers" and set(b.members) >= set(theme.names) for b in scene.built):
        raise refuse("misplaced", "each tower or each block?", span, "say 'each tower on the patch of its colour'")
    spare = iter(
        c
        for c in ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink")
        if c not in {b.color for b in blocks}
    )
    for block in blocks:
        if block.color is None:
            block.color = next(spare, "red")
            scene.assume(f"{COLORS_UNSAID}: one of each colour")
    goals: Atoms = []
    for color in dict.fromkeys(b.color for b in blocks):
        patch = next((t for t in scene.things.values() if t.patch and t.color == color), None) or next(
            (t for t in scene.things.values() if t.patch and t.color is None), None
        )
        if patch is None:
            patch = scene.fresh(patch=True, color=color)
        patch.color = color
        members = tuple(b.name for b in blocks if b.color == color)
        goals.append(r.OnPatch(a=members, patch=patch.name, span=span))
    return goals


def any_of_the_rest(mark: Ref, loc: Loc) -> Ref:
    """ "on any patch except the red one": on one of the others; "on every patch except ..." on each of them."""
    if not mark.patch or loc.rel not in ("on", "above", "in"):
        raise refuse("misplaced", "'except' does not fit a place", loc.span,
                     "say 'all blocks except ...' where they are named")  # fmt: skip
    whole = loc.landmark.items[0] if isinstance(loc.landmark, Coord) else None
    if isinstance(whole, Noun) and whole.det in ("each", "all"):
        return replace(mark, op="and", parts=(), each=True)
    return replace(mark, op="or", parts=tuple(Ref(names=(name,), patch=True) for name in mark.names))


def on_separate_patches(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> Atoms | None:
    """ "on different patches", "each on a patch of its own": no two share one; None where that is not said."""
    noun = loc.landmark
    if not isinstance(noun, Noun) or noun.head != "patch" or loc.rel not in ("on", "in") or loc.negated:
        return None
    if theme.det == "no two" and theme.everything:
        return _not_together(theme, noun, scene, scope, span)
    if noun.traits.scheme != "different" or noun.traits.colors or theme.quant is not None or theme.op != "and":
        return None
    whole = len(theme.built) > 1 and {n for b in theme.built for n in b.members} == set(theme.names)
    parts = [b.members for b in theme.built] if whole else [p.names for p in theme.parts]
    units: list[tuple[str, ...]] = parts if len(parts) > 1 else [(n,) for n in theme.names]
    if all(len(u) == 1 for u in units) and len(units) == 1:
        return None
    many = replace(noun, plural=True, traits=replace(noun.traits, scheme=None))
    if noun.det in ("a", "its"):
        many = replace(many, det="bare", amount=None)
    mark = refer(many, scene, replace(scope, role="landmark", pool=(), need=len(units)))
    if len(mark.names) < len(units):
        raise refuse(
            "count-mismatch",
            f"{len(units)} cannot each have one of {len(mark.names)} patches",
            noun.span,
            "name as many patches",
            wanted=len(units),
            there=len(mark.names),
        )
    if noun.det == "its" and (own := by_color(units, mark.names, scene)):
        return [r.OnPatch(a=unit, patch=patch, span=span) for unit, patch in own]
    return [dealt(units, mark.names, span)]


def _not_together(theme: Ref, noun: Noun, scene: Scene, scope: Scope, span: Span) -> Atoms:
    """ "no two blocks are on the same mat", "... on the red mat": one at most."""
    same = noun.traits.scheme == "same"
    named = () if same else refer(noun, scene, replace(scope, role="landmark", pool=(), need=None)).names
    patches = [t.name for t in scene.things.values() if t.patch] if same else named
    if len(theme.names) < 2 or len(patches) < 1 + same:
        raise refuse("ambiguous", "it is not said which blocks and patches these are", span,
                     "say first which blocks and which patches there are")  # fmt: skip
    return [_so_many(theme.names, p, 0, 1, span) for p in patches]


def _so_many(names: tuple[str, ...], patch: str, least: int, most: int, span: Span) -> g.Goal:
    on = r.OnPatch(a=(EACH,), patch=patch, span=span)
    return g.Count(over=names, at_least=least, at_most=most, goal=on, span=span)


def one_for_each_patch(theme: Meaning, places: list[Meaning], scene: Scene) -> Meaning:
    """ "one block on each patch", "two blocks on each", of as many different blocks as that takes: exactly so many on
    each. What is only "each" in `places` is each patch then."""
    if not isinstance(theme, Noun) or theme.traits != Traits() or theme.part_of is not None or theme.conditions:
        return theme
    one = Amount(1, 1) if theme.head == "any" and not theme.plural else None  # "put one on each"
    many = theme.amount or one
    if theme.det not in ("a", "bare") or theme.head == "patch" or many is None or many.low != many.high:
        return theme
    blocks = [t for t in scene.blocks() if t.declared and not t.extra]
    for n, place in enumerate(places):
        mark = place.landmark if isinstance(place, Loc) and place.rel == "on" and not place.negated else None
        patches = _each_of_so_many(mark, scene)
        if isinstance(place, Loc) and len(blocks) == many.low * patches > 1 and (one or not alike(blocks)):
            if _points(mark):
                places[n] = replace(place, landmark=Noun(head="patch", det="each", span=place.span))
            return replace(theme, head="block", det="bare", amount=many._replace(strict=True))
    return theme


def _each_of_so_many(mark: Meaning | None, scene: Scene) -> int:
    """How many patches these are, where something is on each of them; none where it is on no such."""
    there = [t for t in scene.things.values() if t.patch]
    whole = mark.part_of or mark if isinstance(mark, Noun) and mark.det == "each" else None
    if _points(mark) or not isinstance(whole, Noun) or whole.head != "patch":
        return len(there) if _points(mark) else 0
    named = 0 if whole.traits.either else len(whole.traits.colors)
    counted = named if named > 1 else whole.amount.low if whole.amount is not None and not there else 0
    return counted or len(matching(whole.traits, scene, True))


def _points(mark: Meaning | None) -> bool:
    """ "each", "each of them"."""
    of = mark.part_of if isinstance(mark, Noun) and mark.det == "each" else None
    return any(isinstance(x, Pronoun) and x.word == word for x, word in ((mark, "each"), (of, "them")))


def dealt(units: list[tuple[str, ...]], patches: tuple[str, ...], span: Span) -> g.Goal:
    """One unit on each patch at most, every unit on one."""
    if all(len(u) == 1 for u in units):
        names = tuple(u[0] for u in units)
        least = 1 if len(patches) == len(units) else 0
        counted = [_so_many(names, p, least, 1, span) for p in patches]
        placed = [disj([r.OnPatch(a=(n,), patch=p, span=span) for p in patches], span) for n in names]
        return conj(counted if least else [*placed, *counted], span)
    if len(patches) > MAX_SHARED and len(units) == len(patches):  # one on each, so that each is on one
        return conj([disj([r.OnPatch(a=u, patch=p, span=span) for u in units], span) for p in patches], span)
    if len(patches) > MAX_SHARED:
        raise refuse("ambiguous", "it is not said which go on which patch", span, "name the patch of each")
    ways = permutations(patches, len(units))
    options = [
        conj([r.OnPatch(a=u, patch=p, span=span) for u, p in zip(units, way, strict=True)], span) for way in ways
    ]
    return disj(options, span)
