"""Which objects a noun phrase speaks of: finds them, or brings them into the task."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.core.diagnostics import Refusal
from rpg.language.grammar.things.retold import counted_again, retold
from rpg.language.later import later
from rpg.language.meaning import Amount, Coord, Meaning, Noun, PartOf, Pronoun, Structure, TableTop, Traits, replace
from rpg.passes.schema.resolve.clauses.alls import note_all
from rpg.passes.schema.resolve.orders.by_size import BY_SIZE
from rpg.passes.schema.resolve.structures.towers_apart import one_of_them
from rpg.passes.schema.resolve.things.counting import (
    check_both,
    counted_among,
    denied,
    elliptical,
    not_of_a_structure,
    some_more,
)
from rpg.passes.schema.resolve.things.excepted import besides, excepted, none_but
from rpg.passes.schema.resolve.things.extras import extras
from rpg.passes.schema.resolve.things.listing import (
    all_colored,
    all_such,
    bounded,
    check_unmixed,
    fewer_than,
    listed,
    lot,
    one_more,
    quantified,
    repeats,
)
from rpg.passes.schema.resolve.things.one_there import no_patch
from rpg.passes.schema.resolve.things.pronouns import PAIR, others, pronoun
from rpg.passes.schema.resolve.things.second_patch import the_only_patch
from rpg.passes.schema.resolve.things.select import select
from rpg.passes.schema.resolve.things.shares import SHARES, share_of
from rpg.passes.schema.resolve.things.spoken import one_built
from rpg.passes.schema.resolve.things.theirs import THEIRS, begun_on, in_their_colors, its_own
from rpg.passes.schema.resolve.things.them import all_of_it, of_whom, patches_of_each, sorted_out
from rpg.passes.schema.resolve.things.things import (
    alike,
    check_cubes,
    compared,
    looks_said,
    matching,
    note_of_whole,
    note_premises,
    told_of_whole,
)
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse, which_one

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.orders.among_places import blocks_at, named_part, one_on_each
    from rpg.passes.schema.resolve.orders.ranks import middle_of, of_the_whole, ranked, top_block
    from rpg.passes.schema.resolve.structures.structures import refer_structure
else:
    blocks_at, named_part, one_on_each = later(
        __name__, "rpg.passes.schema.resolve.orders.among_places", "blocks_at", "named_part", "one_on_each"
    )
    middle_of, of_the_whole, ranked, top_block = later(
        __name__, "rpg.passes.schema.resolve.orders.ranks", "middle_of", "of_the_whole", "ranked", "top_block"
    )
    (refer_structure,) = later(__name__, "rpg.passes.schema.resolve.structures.structures", "refer_structure")


def refer(meaning: Meaning, scene: Scene, scope: Scope) -> Ref:
    """The objects that a noun phrase stands for; remembered for pronouns."""
    match meaning:
        case Noun():
            found = _noun(meaning, scene, scope)
        case Coord():
            found = _coord(meaning, scene, scope)
        case Pronoun():
            found = pronoun(meaning, scene, scope)
        case TableTop():
            return Ref(table=True, span=meaning.span)
        case PartOf():
            found = _part(meaning, scene, scope)
        case Structure():
            shape, told = told_of_whole(meaning)
            found = refer_structure(shape, scene, scope)
            note_of_whole(told, shape, found, scene, scope)
        case _:
            raise refuse("misplaced", "this is no description of blocks or patches", meaning.span)
    found = replace(found, span=meaning.span)
    note_all(meaning, found, scene, scope)
    if not found.reciprocal:
        scene.mention(found, scope.role, scope.rel, getattr(meaning, "word", ""), scope.start or scope.given)
    if found.names and scope.role == "landmark":
        scene.last_landmark_patch = found.patch
        scene.last_landmark_at = meaning.span[0]
    return found


_KNOWN = ("the", "each", "all", "any", "both")


def _coord(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    if meaning.op == "except":
        return excepted(meaning, scene, scope)
    if meaning.op == "none but":
        return none_but(meaning, scene, scope)
    if meaning.op == "besides":
        return besides(meaning, scene, scope)
    if meaning.op == "only":
        alone = refer(meaning.items[-1], scene, scope)
        scene.mentions.pop()
        return replace(alone, op="only", plural=len(alone.names) > 1)
    if retold(meaning.items):
        raise refuse("ambiguous", "these could be further blocks, or what was counted before told apart", meaning.span,
                     "say 'and' between further blocks, or leave the number out")  # fmt: skip
    if counted_again(meaning.items):
        raise refuse("misplaced", "these numbers are told behind the list", meaning.span, "say them in the list")
    check_unmixed(meaning)
    parts: list[Ref] = []
    seen: list[Traits] = []
    last = meaning.items[-1]
    if (
        isinstance(last, Noun)
        and last.head == "patch"
        and all(isinstance(x, Noun) and x.head in ("patch", "any") for x in meaning.items)
    ):
        scope = replace(scope, like_patch=True)
    for item in bounded(meaning):
        if isinstance(item, Noun) and repeats(item, seen, scope.role == "member"):
            item = replace(item, det="another", amount=item.amount or Amount(1, 1))
        if parts and all_such(item) and not all(all_such(x) and all_colored(x) for x in meaning.items):
            raise refuse("misplaced", "this could describe the blocks before it", item.span, "say it in front of them")
        if isinstance(item, Noun):
            seen.append(item.traits)
            if item.det == "each" and (item.part_of is not None or (parts and item.head == "any")):
                raise which_one("it is not clear what belongs to 'each'", item.span, "say it in two sentences")
        parts.append(refer(item, scene, scope))
        if parts[-1].table:
            raise refuse("misplaced", "the table is no block", parts[-1].span, "name blocks")
        scene.mentions.pop()
    if len({part.patch for part in parts}) > 1:
        raise refuse("misplaced", "blocks and patches are listed together here", meaning.span,
                     "name them in clauses of their own")  # fmt: skip
    names = tuple(dict.fromkeys(n for part in parts for n in part.names))
    if meaning.op == "and" and len(names) < sum(len(part.names) for part in parts if part.quant is None):
        raise refuse("ambiguous", "a block is named twice in this list", meaning.span, "name each block once")
    built = tuple(b for part in parts for b in part.built)
    single = all(len(x.names) == 1 or x.listed or lot(m, x) for m, x in zip(meaning.items, parts, strict=True))
    return Ref(
        names=names,
        patch=parts[0].patch,
        built=built,
        op=meaning.op,
        parts=tuple(parts),
        plural=True,
        span=meaning.span,
        listed=single,
    )


def _part(meaning: PartOf, scene: Scene, scope: Scope) -> Ref:
    whole = refer(meaning.whole, scene, scope) if meaning.whole else None
    if meaning.part == "blocks":
        return blocks_at(meaning, whole, scene, scope)
    if whole is None:
        raise refuse("no-referent", "it is not clear of what this is a part", meaning.span)
    built = whole.built[0] if len(whole.built) == 1 and whole.built[0].ordered else None
    if meaning.part == "top" and scope.role == "theme" and scene.placing and whole.built:
        return of_the_whole(top_block(meaning.span), whole, scene, scope)
    if meaning.part == "top" or (meaning.part == "middle" and whole.patch and len(whole.names) == 1):
        return replace(whole, part=meaning.part)
    if (
        meaning.part == "middle"
        and scope.role == "theme"
        and len(whole.names) == 1
        and not (whole.built or whole.patch)
    ):
        return whole  # "its centre lies on the mat": a block is where its middle is
    if built is not None and (named := named_part(meaning.part, built)) is not None:
        return named
    if meaning.part == "middle" and (middle := middle_of(whole, meaning.span, scene, scope)) is not None:
        return middle
    raise which_one(f"it is not clear which block the {meaning.part} of it is", meaning.span, "name the block")


def _noun(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    there = {t.name: bool(t.color or t.label or t.kind) for t in scene.blocks()}
    found = _described(noun, scene, scope)
    if not found.patch:
        looks_said(noun, found.names, there, scene)
    note_premises(noun, found, scene, scope)
    return found


def _described(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    if (towers := one_of_them(noun, scene)) is not None:
        return towers
    noun = one_more(noun, scene)
    if noun.part_of is None and elliptical(noun, scene, scope):
        if noun.amount is not None and (noun.amount.strict or scene.speaks_of_rest):
            return _of_them(noun, scene, scope)
        not_of_a_structure(noun, scene)
    if noun.traits.rank and isinstance(noun.part_of, Structure):
        return of_the_whole(noun, refer(noun.part_of, scene, replace(scope, role="landmark")), scene, scope)
    if noun.part_of is not None and noun.traits.rank not in BY_SIZE:
        return _partitive(noun, scene, scope)
    if noun.det == "no other" and noun.head != "patch":
        if scope.role != "theme":
            raise refuse("misplaced", "'no other' does not fit here", noun.span, "name the blocks")
        names = tuple(t.name for t in matching(noun.traits, scene, False))
        return Ref(names=names, quant=Amount(0, 0, True), plural=True, everything=True, beyond=noun.traits)
    if noun.traits.extra:
        return extras(noun, scene)
    if noun.traits.rank:
        return ranked(noun, scene, scope)
    if (told := one_built(noun, scene, scope)) is not None:
        return told
    bare = (noun.head, noun.det, noun.amount, noun.plural, noun.traits) == ("any", "bare", None, False, Traits())
    if bare and not noun.conditions:
        return pronoun(Pronoun(word="one", span=noun.span), scene, scope)
    patch = _is_patch(noun, scene, scope)
    if not patch:
        check_cubes(noun.traits, noun.span)
    if not patch and compared(noun):
        raise refuse("ambiguous", "it is not said of what colour", noun.span, "name the colour")
    if patch and (noun.traits.scheme == THEIRS or (noun.traits.matching and scope.given)):
        return in_their_colors(noun, scene, scope)
    if patch and (noun.traits.matching or its_own(noun, scene)):
        return Ref(patch=True, matching=True, plural=noun.plural, det=noun.det)
    if patch and (there := begun_on(noun, scene, scope)) is not None:
        return there
    if noun.det in ("other", "another"):
        return _besides(noun, scene, scope, patch)
    return _plain(noun, scene, scope, patch)


def _of_them(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """ "at least two": of the blocks that were spoken of, never further ones."""
    if (more := some_more(noun, scene, scope)) is not None:
        return more
    try:
        return _partitive(replace(noun, part_of=Pronoun(word="them", span=noun.span)), scene, scope)
    except Refusal as refusal:
        if refusal.diagnostics[0].code == "too-many-asked":
            raise
        hint = "say for example 'two of the three red blocks'"
        raise which_one("it is not said of which blocks so many are meant", noun.span, hint) from None


def _besides(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    """ "another red block", "the other one": besides one that is in the task, which is looked into at the end."""
    if noun.det == "other" or noun.amount is None:
        found = others(noun, scene, scope, patch)
    else:
        found = _plain(noun, scene, scope, patch)
    scene.besides.append((noun.traits, replace(found, patch=patch), noun.span))
    return found


def _plain(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    if len(noun.traits.labels) > 1 or (len(noun.traits.colors) > 1 and not noun.traits.either):
        return listed(noun, scene, scope, patch)
    if noun.det == "no" and noun.traits == Traits() and noun.head == "block":
        names = scope.pool or tuple(t.name for t in scene.blocks() if not t.extra)
        two = noun.amount is not None and not noun.amount.strict  # "neither block" is none of the two
        det = "no two" if two else "no"
        if noun.amount is not None and noun.amount.low > PAIR:
            raise refuse("misplaced", "this is told of any two of them alone", noun.span, "say 'no two'")
        return Ref(names=names, quant=Amount(0, 0, True), plural=True, everything=True, det=det)
    if noun.traits.either:
        return _alternatives(noun, scene, scope, patch)
    if noun.det == "no" and noun.amount == Amount(PAIR, PAIR) and noun.traits.colors and not patch:
        those = replace(noun, det="the", amount=None)  # "no two red ones": of the red ones that there are
        return _partitive(replace(noun, head="any", traits=Traits(), part_of=those), scene, scope)
    names = (
        denied(noun, scene, scope, patch)
        or counted_among(noun, scene, scope, patch)
        or select(noun, scene, scope, patch)
    )
    found = Ref(names=names, patch=patch, det=noun.det, plural=noun.plural or len(names) > 1, each=noun.det == "each")
    return quantified(found, noun)


def _is_patch(noun: Noun, scene: Scene, scope: Scope) -> bool:
    if noun.head == "any":
        if noun.traits.size and matching(noun.traits, scene, False) and not matching(noun.traits, scene, True):
            return False  # "push the big block onto the mat, then put the small one on the big one"
        if scope.like_patch and noun.traits.colors and not (scope.given and noun.det == "a"):
            pool = [t for t in scene.things.values() if t.color in noun.traits.colors]
            last = next((m.ref.names for m in reversed(scene.mentions) if m.ref.patch and m.ref.names), ())
            if not pool and len(last) == 1 and all(scene.things[n].color is None for n in last):
                if the_only_patch(last[0], scene):
                    return False
                raise refuse("ambiguous", "this could be a block or a patch", noun.span, "say 'block' or 'patch'")
            return all(t.patch for t in pool) if pool else True
        many = noun.amount.low if noun.amount and noun.traits == Traits() else 1
        there = many <= max(1, sum(t.patch for t in scene.things.values()))  # "A and B are on the mat, each of the two"
        like = scope.like_patch or (scope.role == "landmark" and _the_marked(noun, scene))
        return there and like and not no_patch(noun, scene, scope)
    return noun.head == "patch"


def _the_marked(noun: Noun, scene: Scene) -> bool:
    """ "the red one" where there is a red patch, and no red block; "red" where it is said which blocks there are."""
    listed = any(t.declared for t in scene.blocks()) and any(t.declared for t in scene.things.values() if t.patch)
    said = (noun.det in _KNOWN or (noun.det == "bare" and listed)) and bool(noun.traits.colors)
    return said and bool(matching(noun.traits, scene, True)) and not matching(noun.traits, scene, False)


def _partitive(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """ "two of the four red blocks", "none of them"."""
    bare = isinstance(noun.part_of, Noun) and noun.part_of.det == "bare"
    if bare and noun.amount == Amount(1, 1) and noun.det in ("any", "some") and scene.built:
        raise refuse("ambiguous", "one of the blocks, or one more structure of so many?", noun.span,
                     "say 'one of the ...', or name the structure again")  # fmt: skip
    if isinstance(noun.part_of, Structure):
        raise refuse("misplaced", "this is not understood of some of several structures", noun.span,
                     "say it of each of them by itself")  # fmt: skip
    if scene.sized and isinstance(noun.part_of, Pronoun) and noun.det == "some" and not any(scene.blocks()):
        return refer(replace(noun, head="block", det="bare", part_of=None), scene, scope)  # "the cubes are 3 cm wide"
    whole = sorted_out(noun, refer(of_whom(noun), scene, scope), scene)
    scene.mentions.pop()
    if noun.det == "no" and isinstance(noun.part_of, Pronoun) and scope.role == "landmark":
        patches = patches_of_each(scene, scope, of_none=True)
        whole = Ref(names=patches, patch=True, plural=True) if patches else whole
    check_both(noun, whole, scene.denying, borne=scope.role == "landmark" and scope.rel == "on")
    amount = noun.amount
    if noun.det in ("all", "each", "both"):
        whole = all_of_it(whole) if noun.det == "both" else whole
        one_each = isinstance(noun.part_of, PartOf) and one_on_each(noun.part_of, scene, scope)
        return replace(whole, each=noun.det == "each" or one_each, quant=None, det=noun.det)
    if noun.det == "no":
        return replace(whole, quant=fewer_than(noun.amount))
    if noun.det in SHARES:
        noun = replace(noun, amount=(amount := share_of(noun, whole, scene)))
    if noun.det == "any" and scene.speaks_of_rest and noun.amount == Amount(1, 1):
        return _some_of(whole, 1, noun, scene)
    if noun.det == "any":
        amount = noun.amount or Amount(1, None, True)
        return replace(whole, quant=Amount(amount.low, amount.high, True), det="any")
    if amount is None:
        return whole
    high, count = amount.high, len(whole.names)
    most = count - (high == -1)
    if high is not None and amount.low > most:
        raise refuse(
            "too-many-asked",
            f"{amount.low} are asked for, but {'there are only' if most == count else 'not all of'} {count}",
            noun.span,
            f"ask for at most {most}",
            asked=amount.low,
            there=count,
        )
    if high == -1:
        return replace(whole, quant=Amount(amount.low, most, True))
    if scene.speaks_of_rest and not amount.strict and high is not None:
        return _some_of(whole, amount.low, noun, scene)
    told_apart = amount.strict and not scene.parted.isdisjoint(whole.names)  # "the others" are those of before
    if scene.speaks_of_rest and not told_apart and amount.low == high and high is not None and high < len(whole.names):
        return _some_of(whole, amount.low, noun, scene)
    return replace(whole, quant=Amount(amount.low, amount.high, True))


def _some_of(whole: Ref, count: int, noun: Noun, scene: Scene) -> Ref:
    """So many of several look-alikes, told apart from "the others" that are spoken of elsewhere."""
    free = [n for n in whole.names if n not in scene.parted]
    things = [scene.things[n] for n in free]
    if not alike(things) and any(t.color or t.label for t in things):
        raise refuse("ambiguous", f"it is not said which of {len(free)} different blocks are meant", noun.span,
                     "name the blocks", blocks=len(free))  # fmt: skip
    if len(free) < count:
        raise refuse(
            "too-many-asked",
            f"{count} are asked for, but only {len(free)} are left",
            noun.span,
            f"ask for at most {len(free)}",
            asked=count,
            there=len(free),
        )
    for thing in things:
        thing.scheme = thing.scheme or "same"
    scene.parted.update(free[:count])
    scene.whole = whole.names
    some = Ref(names=tuple(free[:count]), plural=count > 1)
    if noun.amount is not None and noun.amount.strict and len(free) > count:
        return replace(some, op="except", parts=(some, Ref(names=tuple(free[count:]))))
    return some


def _alternatives(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    parts = []
    if (noun.head, noun.det) == ("any", "any"):
        noun = replace(noun, det="bare")
    for color in noun.traits.colors:
        one = replace(
            noun, traits=replace(noun.traits, colors=(color,), either=False), plural=noun.plural and noun.head != "any"
        )
        parts.append(Ref(names=select(one, scene, scope, patch), patch=patch, span=noun.span))
    names = tuple(n for part in parts for n in part.names)
    return Ref(names=names, patch=patch, op="or", parts=tuple(parts), plural=True)
