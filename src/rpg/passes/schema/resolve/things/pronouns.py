"""Pronouns and "the other", "the rest": something that was mentioned before."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.later import later
from rpg.language.meaning import OWNER, TOLD_HERE, Amount, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.orders.one_of_two import the_other_of_two
from rpg.passes.schema.resolve.structures.towers_apart import one_of_them
from rpg.passes.schema.resolve.things.left_of_them import (
    check_no_extra_since,
    more_like_it,
    of_the_last,
    the_like_of_it,
)
from rpg.passes.schema.resolve.things.off_it import check_off_it, check_owner, lies_there
from rpg.passes.schema.resolve.things.others_open import made_up, not_acted_on, of_the_start
from rpg.passes.schema.resolve.things.parallel import ACROSS, parallel
from rpg.passes.schema.resolve.things.second_patch import one_alone, one_of_the_patches, only_one_patch
from rpg.passes.schema.resolve.things.them import each_whole, neither, them, whichever_there_are
from rpg.passes.schema.resolve.things.which import which
from rpg.passes.schema.resolve.things.world import Mention, Ref, Scene, Scope, Thing, refuse, said, which_one

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.by_the_way import named_by_the_way
    from rpg.passes.schema.resolve.things.things import alike, create, further, matching
else:
    (named_by_the_way,) = later(__name__, "rpg.passes.schema.resolve.things.by_the_way", "named_by_the_way")
    alike, create, further, matching = later(
        __name__, "rpg.passes.schema.resolve.things.things", "alike", "create", "further", "matching"
    )

_EACH_OTHER = frozenset({"each other", "one another", "itself", "themselves"})
_REST = frozenset({"the other ones", "the others", "the rest", "others", "the other two",
                   "the other half", "the other third", "everything else",
    "the remaining ones", "the remainder", "all others",
                   "all the others", "all the rest"})  # fmt: skip
_ALL_ELSE = frozenset({"all the others", "all others", "all the rest", "everything else"})
_OTHER = frozenset({"the other one", "the other", "the second one", "another"})
PAIR = 2
"""So many are "the other two"."""


def pronoun(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    """What a pronoun stands for."""
    if word.word.startswith("anything"):
        raise refuse("misplaced", f"{word.word!r} names no block", word.span, "say 'any block', or 'nothing'")
    if word.word in _EACH_OTHER:
        return Ref(reciprocal=True, span=word.span)
    if word.word.startswith("="):
        return Ref(names=tuple(word.word[1:].split()), plural=" " in word.word)
    if (towers := one_of_them(word, scene)) is not None:
        return towers
    if word.word in ("same", "both the same"):
        last = _last_theme(scene, word)
        return replace(last, op="and") if last.op == "nor" and word.word != "same" else last
    of_some = bool(scene.whole) and _NUMBERED.get(word.word) is None  # "one of the two is on red, the other is not"
    if word.word in _NUMBERED and len(scene.built) > 1 and not of_some:
        return _numbered(word, scene)
    if word.word in _REST or word.word in _OTHER:
        noun = Noun(head="any", det="other", plural=word.word in _REST, span=word.span)
        there = {t.name: bool(t.color or t.label) for t in scene.blocks()}
        found = others(noun, scene, scope, scope.like_patch)
        if word.word == "the other two" and found.names and len(found.names) != PAIR:
            raise refuse("count-mismatch", f"there are {len(found.names)} others, and not two", word.span,
                         "say how many there are of all", there=len(found.names))  # fmt: skip
        if word.word == "another" and any(there.values()) and not found.patch and not set(found.names) & set(there):
            raise refuse("ambiguous", "it is not said what this block looks like", word.span, "name its colour")
        return replace(found, not_acted_on=not_acted_on(scene)) if word.word in _ALL_ELSE else found
    if word.word in ("the latter", "the former"):
        return _one_of_two(word, scene)
    if word.word == "which":
        return which(word, scene)
    if word.word == "there":
        return _there(word, scene, scope)
    if word.word == OWNER:
        return _owner(word, scene)
    if (named := _last_named(word, scene, scope)) is not None:
        return named
    if word.word in ("it", "that", "this", "the first one"):
        check_off_it(word, scene, scope)
        found = _it(word, scene, scope)
        return replace(found, op="and") if found.op == "only" else found
    if word.word == "neither of them":
        return neither(word, scene, scope)
    if word.word in ("nothing", "nothing else", "none of them"):
        names = tuple(t.name for t in scene.blocks() if not t.extra)
        beyond = Traits() if word.word == "nothing else" else None
        return Ref(names=names, quant=Amount(0, 0, True), plural=True, everything=True, beyond=beyond)
    if word.word in ("everything", "all", "all of it", TOLD_HERE):
        here = [n for m in scene.mentions if m.sentence == scene.sentence and not m.ref.patch for n in m.ref.names]
        blocks = here if word.word == TOLD_HERE else [t.name for t in scene.blocks()]
        names = tuple(dict.fromkeys(n for n in blocks if not scene.things[n].extra))
        return Ref(names=names, plural=True, each=False) if names else whichever_there_are(word, scene, scope)
    if word.word == "one" or word.word in ("each", "each one", "each of them", "either of them"):
        return _one(word, scene, scope)
    found = them(word, scene, scope)
    both = word.word in ("both", "both of them") and scope.role == "landmark" and found.patch
    return replace(found, det="both") if both else found


_NUMBERED = {"the first one": 0, "the second one": 1, "the other one": None, "the other": None}


def _numbered(word: Pronoun, scene: Scene) -> Ref:
    """ "the second one" where two structures were built: the second of them."""
    index = _NUMBERED[word.word]
    if index is None or len({b.kind for b in scene.built}) > 1:
        raise which_one(f"it is not clear what {word.word!r} is", word.span, "name it")
    built = scene.built[index]
    return Ref(names=built.members, built=(built,), span=word.span)


def _last_theme(scene: Scene, word: Pronoun) -> Ref:
    """What the clause before spoke of, and not what it said of it: "the white block, with red on it, is ..." """
    themes = [m.ref for m in scene.mentions if m.role == "theme"]
    if themes:
        return next((ref for ref in reversed(themes) if ref.span == word.span), themes[-1])
    raise refuse("no-referent", "nothing was mentioned before that this could refer to", word.span)


def _owner(word: Pronoun, scene: Scene) -> Ref:
    """What "it" is where it has something on it: as the subject of other verbs, what was spoken of last."""
    told = [m.ref for m in scene.mentions if m.role in ("theme", "given") and m.clause < scene.clause and m.ref.names]
    if not told or (len(told[-1].names) > 1 and not told[-1].built):
        raise refuse("ambiguous", "it is not clear what has this", scene.mentions[-1].ref.span, "name it")
    check_owner(replace(word, word="it"), told[-1], scene)
    return told[-1]


def _last_named(word: Pronoun, scene: Scene, scope: Scope) -> Ref | None:
    """ "Red goes on blue and that one on green": the block that was named last in the clause before."""
    if word.word not in ("that one", "this one", "that") or scope.role != "theme":
        return None
    told = [m for m in scene.mentions if m.clause < scene.clause and m.ref.names]
    last = sorted((m for m in told if m.clause == told[-1].clause), key=lambda m: m.ref.span)
    if not last or (word.word == "that" and last[-1].sentence != scene.sentence):
        return None
    named = last[-1].ref
    single = len(named.names) == 1 and not named.patch and not named.built and named.quant is None
    return replace(named, span=word.span) if single and last[-1].role in ("theme", "landmark") else None


def _it(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    told = [m for m in scene.mentions if m.ref.names and m.clause <= scene.clause]
    there = [m for m in told if m.ref.quant is None or m.ref.quant.high != 0]  # "nothing on it" is no block
    single = [m for m in there if len(m.ref.names) == 1 or m.ref.built]
    if scope.role == "landmark":
        current = [m for m in scene.mentions if m.clause == scene.clause and m.role in ("theme", "given")]
        single = [m for m in single if not {n for x in current for n in x.ref.names} & set(m.ref.names)]
        single = [m for m in single if not (len(current) == 1 and lies_there(m, scene, scope))] or single
    if not single and (named := named_by_the_way(scene, scope)) is not None:
        return named
    if not single:
        several = them(word, scene, scope)
        none = any(m.ref.quant is not None and m.ref.quant.high == 0 for m in told if m.clause == scene.clause)
        itself = scope.role == "theme" or none  # "none of them to the left of it"
        looks = {(t.color, t.label) for t in map(scene.things.__getitem__, several.names)}
        one = word.word == "the first one" or (word.word == "it" and (itself or len(looks) > 1))
        if one and len(several.names) > 1 and not several.built:
            raise which_one(f"{word.word!r} could be any of several blocks", word.span,
                         "name the one you mean")  # fmt: skip
        return several
    if scope.role == "theme":
        themes = [m for m in single if m.role in ("theme", "given")]
        found = (themes or single)[-1].ref
        _check_listed(word, scene, single)
        check_owner(word, found, scene)
        check_no_extra_since(word, found, scene)
        if word.word == "the first one" and (found.built or len({m.ref.names for m in there}) > 1):
            raise which_one("the first of which, or of its blocks?", word.span, "name the one you mean")
        return found
    last = single[-1].clause
    counted = [m for m in scene.mentions if m.clause == last and m.ref.quant is not None and not m.ref.patch]
    if any(m.role == "landmark" or m.ref.quant == Amount(1, 1, True) for m in counted):
        raise refuse("ambiguous", f"{word.word!r} could be what lies there, or what it lies on", word.span,
                     "name the one you mean")  # fmt: skip
    again = [m for m in single if m.word == "it" and m.role == "theme" and m.clause == last]
    patched = scope.rel in ("off", "not on") and any(m.ref.patch for m in single if m.clause == last)  # "stay off it"
    if again and not patched and again[-1].sentence == scene.sentence and not single[-1].word and word.word == "it":
        return again[-1].ref
    rivals = [*{m.ref.names: m for m in single if m.clause == last}.values()]
    if len(rivals) > 1 and not any(m.ref.built for m in rivals):
        return parallel(word, rivals, scene, scope) or _decide(word, scene, rivals, scope.rel)
    return _built_there(word, rivals, scene, scope) or single[-1].ref


def _check_listed(word: Pronoun, scene: Scene, single: list[Mention]) -> None:
    """ "There is a red and a blue block, so put it on the mat": either."""
    told = [m for m in single if m.clause < scene.clause]
    listed = [m for m in told if m.sentence == told[-1].sentence and not m.word]
    given = bool(listed) and listed[0].role == "given" and not any(m.ref.built for m in listed)
    if given and len({m.ref.names for m in listed}) > 1 and all(m.role in ("theme", "given") for m in listed):
        raise refuse("ambiguous", f"{word.word!r} could be any of several blocks", word.span, "name the one you mean")


def _built_there(word: Pronoun, rivals: list[Mention], scene: Scene, scope: Scope) -> Ref | None:
    """ "Build a tower on the mat. Put a red block next to it": next to the tower; "A tower left of the mat and a block
    right of it": of the mat; None where the last one is meant.

    "Build a tower next to the blue block. Put a red block on it" is on the tower or on the blue block, and so is "it"
    in "Beside the tower put white, and on it purple", and "this" in "to its right put white, and to the right of this
    purple".
    """
    last = max((m.ref.span for m in rivals), default=(0, 0))
    fronted = next((m for m in rivals if m.ref.built and m.role == "landmark" and m.ref.span < last), None)
    across = word.word not in ("this", "that") and {fronted.rel if fronted else "", scope.rel} <= set().union(*ACROSS)
    if fronted is not None and not across:
        return _decide(word, scene, rivals, scope.rel)
    built = [m for m in rivals if m.ref.built and m.role == "theme"]
    marks = [m for m in rivals if m.role == "landmark"]
    if len(built) != 1 or not marks or rivals[-1] is built[0]:
        return None
    if all(m.ref.patch for m in marks) and scope.rel.removeprefix("not ") not in ("on", "in", "off", ""):
        if marks[-1].rel in ("on", "in", "") or marks[-1].sentence != scene.sentence:
            return built[0].ref
        return parallel(word, rivals, scene, scope) or _decide(word, scene, rivals, scope.rel)
    off = scope.rel == "off" and len(marks) == 1 and marks[0].ref.patch and marks[0].rel in ("on", "in")
    return marks[0].ref if off else _decide(word, scene, rivals, scope.rel)  # and so off the structure as well


def _there(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    """ "Put a green block there": on the patch that was spoken of last, if no other place was spoken of since. "Take it
    off", "it must no longer be there": the block that it was said to be on."""
    told = [m for m in scene.mentions if m.ref.names and m.ref.span < word.span]  # commands are read before what was so
    told = [m for m in told if m.ref.patch or (m.role == "landmark" and m.word != "there")]
    last = [m for m in told if told and m.clause == told[-1].clause]
    patches = {m.ref.names for m in last if m.ref.patch and m.rel in ("", "on", "in", "off", "not on")}
    under = ("on", "off") if scope.rel == "on" else ("on",)
    below = {m.ref.names for m in last if m.rel in under and len(m.ref.names) == 1 and not m.ref.built}
    taken = any(m.rel == "off" and m.sentence == scene.sentence for m in scene.mentions)  # "... and put blue there"
    alone = not patches and len(below) == 1 == len({m.ref.names for m in last})
    if alone and (scope.rel in ("off", "not on") or (scope.rel == "on" and taken)):
        return Ref(names=next(iter(below)), span=word.span)
    if len(patches) != 1 or len(patches) < len({m.ref.names for m in last}) or any(len(x) > 1 for x in patches):
        raise refuse("no-referent", "it is not clear where 'there' is", word.span, "name the place")
    several = any(m.clause == scene.clause and m.role == "theme" and len(m.ref.names) > 1 for m in scene.mentions)
    if several and len({m.ref.names for m in scene.mentions if m.ref.patch and m.sentence == scene.sentence}) > 1:
        raise refuse("ambiguous", "each on its own place, or all of them on the last one?", word.span, "name the place")
    return Ref(names=next(iter(patches)), patch=True, span=word.span)


def _one_of_two(word: Pronoun, scene: Scene) -> Ref:
    """ "the former", "the latter": of the two things that the clause before named, in the order of the words."""
    again = {m.clause for m in scene.mentions if m.word in ("the former", "the latter")}
    last = max((m.clause for m in scene.mentions if m.ref.names and m.clause not in {*again, scene.clause}), default=-1)
    named = sorted((m for m in scene.mentions if m.clause == last), key=lambda m: m.ref.span)
    here = [m for m in scene.mentions if m.clause == scene.clause and m.ref.span < word.span and m.ref.names]
    if last < 0:
        named, last = sorted(here, key=lambda m: m.ref.span), scene.clause
    spoken = {m.clause for m in scene.mentions if m.ref.names and named and m.sentence == named[-1].sentence}
    if spoken - {*again, last, scene.clause}:
        raise refuse("ambiguous", f"it is not clear which two {word.word!r} is one of", word.span, "name the block")
    if len(named) == 1 and len(named[0].ref.names) == 2 and not named[0].ref.built:
        both = [scene.things[n] for n in named[0].ref.names]
        if len({(t.color, t.label, t.size) for t in both}) == 2:
            return Ref(names=(both[word.word == "the latter"].name,), patch=named[0].ref.patch)
    if len(named) == 1 and len(named[0].ref.parts) == PAIR and not named[0].ref.built:  # "three red and two blue ones"
        return replace(named[0].ref.parts[word.word == "the latter"], span=word.span)
    both_built = [m.ref.built for m in named if len(m.ref.built) == PAIR and not m.ref.quant]
    if both_built:
        whole = both_built[-1][word.word == "the latter"]
        return Ref(names=whole.members, built=(whole,), plural=True, span=word.span)
    named = [m for m in named if not any({*other.ref.names} < {*m.ref.names} for other in named)]
    if len(named) != PAIR or {*named[0].ref.names} & {*named[1].ref.names}:  # what is built of both is neither of them
        raise refuse("ambiguous", f"{word.word!r} wants two things named before", word.span, "name the block")
    found = named[1 if word.word == "the latter" else 0].ref
    if (len(found.parts) > 1 or len(found.names) > 1) and len(found.built) != 1:
        raise refuse("ambiguous", f"it is not clear which {word.word} is", word.span, "name the block")
    return found


def _decide(word: Pronoun, scene: Scene, rivals: list[Mention], rel: str) -> Ref:
    """Two things were named in the clause before: the upper one of a stack stands for it, or the lower one for what is
    `rel` "under" it; else it is ambiguous."""
    names = [m.ref.names[0] for m in rivals]
    covered = scene.on_top.keys() if rel == "under" else scene.on_top.values()
    tops = [m for m in rivals if m.ref.names[0] not in covered]
    stacked = any(scene.on_top.get(a) == b for a in names for b in names)
    if stacked and len(tops) == 1:
        return tops[0].ref
    readings = [f"the {m.ref.built[0].kind}" if m.ref.built else said(scene.things[m.ref.names[0]]) for m in rivals]
    raise which_one(f"{word.word!r} could be {' or '.join(readings)}", word.span, "name the one you mean")


def _one(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    if word.word == "one":
        free = _left_over(scene)
        if scope.role == "landmark" and not free and (mat := one_of_the_patches(scene)) is not None:
            return mat
        if free and not alike(free):
            raise refuse("ambiguous", "it is not said which of these blocks is meant", word.span, "name the block")
        if free:
            scene.used.add(free[0].name)
            return Ref(names=(free[0].name,))
        for mention in reversed(scene.mentions):
            if len(mention.ref.names) > 1 and not mention.ref.patch:
                lot = mention.role == "theme" and mention.clause < scene.clause and not mention.ref.built
                if lot or not alike([scene.things[n] for n in mention.ref.names]):
                    raise which_one("this could be one of the blocks before it, or a further one", word.span,
                                    "say 'one of them', or name its colour")  # fmt: skip
                return Ref(names=(mention.ref.names[0],))
        raise refuse("no-referent", "nothing was mentioned before that 'one' could be", word.span, "name the block")
    found = them(word, scene, scope)
    if (towers := each_whole(word, found, scene)) is not None:
        return towers
    return replace(found, each=True)


def _left_over(scene: Scene) -> list[Thing]:
    """Blocks that there are, and of which nothing has been said yet; those like the ones spoken of last come first."""
    free = [t for t in scene.blocks() if t.declared and t.name not in scene.used and not t.extra]
    last = next((m.ref.names for m in reversed(scene.mentions) if m.role == "theme" and not m.ref.patch), ())
    like = {(scene.things[n].color, scene.things[n].label) for n in last}
    return [t for t in free if (t.color, t.label) in like] or free


def others(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    """ "the other (red) block", "the others", "the rest"."""
    patch = patch and not (noun.head == "any" and only_one_patch(scene))
    taken = {
        n
        for m in scene.mentions
        for n in m.ref.names
        if len(m.ref.names) == 1 or (m.ref.quant is None and _partial(m, scene))
    }
    taken |= scene.used
    if scene.whole and not noun.traits.colors:
        taken = set(scene.things) - (set(scene.whole) - scene.parted)
    left = [t for t in matching(noun.traits, scene, patch) if t.name not in taken]
    left = left or the_other_of_two(noun, scene) or of_the_last(noun, scene, patch) or of_the_start(noun, scene, patch)
    left = the_like_of_it(noun, left, scene, patch) or left
    count = noun.amount.low if noun.amount else None
    left = left or more_like_it(noun, count, scene, patch)
    if (open_ := made_up(noun.span, left, scene, patch)) is not None:
        return open_
    _of_all(noun, left, scene, patch)
    if noun.det == "another" and (more := further(matching(noun.traits, scene, patch), count or 1, scene)):
        left = more
    elif noun.det == "another" or not left:
        second = noun.det == "other" and not noun.plural and one_alone(noun, scene, patch)
        if noun.det == "other" and not left and not noun.traits.colors and not second:
            known = any(t.declared for t in scene.things.values())
            told = "every block is spoken for already" if known else "it is not said which other block"
            raise refuse("no-referent", told, noun.span, "say how many there are: 'there are five red blocks'")
        _some_other(noun, count, scene, patch)
        scene.new_batch()
        made = [create(noun.traits, scene, patch) for _ in range(count or (2 if noun.plural else 1))]
        left = made
    elif count is not None and len(left) != count:
        raise refuse("count-mismatch", f"{count} others are spoken of, but {len(left)} are left", noun.span,
                     f"say {len(left)}", asked=count, there=len(left))  # fmt: skip
    elif not noun.plural and count in (None, 1) and len(left) > 1:
        if noun.head != "any" or noun.traits.colors:
            raise refuse(
                "ambiguous",
                f"{len(left)} other blocks are left, and any could be meant",
                noun.span,
                "name its colour or its label",
            )
        message = f"'the other' could be any of {len(left)} blocks"
        raise which_one(message, noun.span, "say 'the others', or name the block")
    names = tuple(t.name for t in left)
    scene.used.update(names)
    scene.parted.update(names)
    return Ref(names=names, patch=patch, plural=len(names) > 1)


def _of_all(noun: Noun, left: list[Thing], scene: Scene, patch: bool) -> None:
    """Refuse "the others" where nobody was spoken of before, so that they would be all."""
    whole = {t.name for t in scene.blocks() if not t.extra}
    if noun.det == "other" and noun.traits == Traits() and not patch and left and whole == {t.name for t in left}:
        raise refuse("no-referent", "of no block is anything said before, so that there are no others", noun.span,
                     "say first what becomes of the one that is no other")  # fmt: skip


def _some_other(noun: Noun, count: int | None, scene: Scene, patch: bool) -> None:
    """Refuse "the other one" beside several things named, and "the other blocks" of which there is no number."""
    if noun.det != "other" or noun.traits.colors or noun.traits.labels:
        return
    named = {n for m in scene.mentions for n in m.ref.names if not m.ref.patch}
    if noun.plural and count is None and (noun.head == "block" or (named and not patch)):
        raise refuse("ambiguous", "it is not said which other blocks there are", noun.span,
                     "name the blocks, or say how many there are of which look")  # fmt: skip
    if patch:
        named = {n for m in scene.mentions for n in m.ref.names if m.ref.patch}
        if noun.head == "any" and any(m.ref.op == "or" and not m.ref.patch for m in scene.mentions):
            raise refuse("no-referent", "this could be the other block, or a further patch", noun.span, "name it")
    if not noun.plural and count in (None, 1) and len(named) > 1:
        what = "patch" if patch else "block"
        raise refuse("no-referent", f"there is no other {what} that this could be", noun.span, f"name the {what}")


def _partial(mention: Mention, scene: Scene) -> bool:
    """Whether a plural mention speaks of less than all blocks (so that "the others" are those outside it)."""
    blocks = {t.name for t in scene.blocks() if not t.extra}
    return bool(blocks - set(mention.ref.names)) and not mention.ref.patch and mention.role != "given"
