""" "Them", "they", "both", "all of them": several blocks that were spoken of before."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, NoReturn

from rpg.core.diagnostics import Span
from rpg.ir.relations import On
from rpg.ir.structures import Stack
from rpg.ir.walk import names as names_in
from rpg.language.later import later
from rpg.language.meaning import Amount, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.things.operands import DIRECTIONS
from rpg.passes.schema.resolve.things.things import fits
from rpg.passes.schema.resolve.things.two_lots import two_lots
from rpg.passes.schema.resolve.things.world import Built, Mention, Ref, Scene, Scope, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")


def them(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    """The blocks that "them" stands for: the last ones told together, else all of the last clause."""
    own = (
        [m for m in scene.mentions if m.clause == scene.clause and m.role in ("theme", "member")]
        if scope.role == "landmark"
        else []
    )
    here = [n for m in scene.mentions if m.clause == scene.clause and not m.ref.patch for n in m.ref.names]
    if scope.role == "theme" and len(dict.fromkeys(here)) == 2:  # "put G next to H, both upside down"
        return Ref(names=tuple(dict.fromkeys(here)), plural=True)
    if (
        scope.rel == "between"
        and (ends := two_lots(scene.clause - 1, scene) or _two_ends(word, own, scene)) is not None
    ):
        return ends
    if patches := patches_of_each(scene, scope):
        return _of_patches(word, patches)
    before = any(m not in own and len(m.ref.names) > 1 for m in scene.mentions)
    earlier = any(m.clause < scene.clause and m.ref.names for m in scene.mentions)
    for mention in _latest_first(scene):
        if mention in own and (before or (earlier and _put_there(mention, word, own))):
            continue
        if _left_behind(mention, scene) or (scope.role == "theme" and _beside_blocks(word, mention, scene)):
            continue
        if len(mention.ref.names) > 1 and not _idle(mention, scene):
            ref = mention.ref
            if word.word in _BOTH and len(ref.names) != 2:
                continue
            if word.word in _BOTH and _one_of_two_wholes(ref, scene):
                return _two_wholes(word, scene)
            if ref.quant is not None and ref.quant.strict and 0 < ref.quant.low < len(ref.names):
                raise refuse("ambiguous", f"{word.word!r} could be all of these blocks, or just so many of them",
                             word.span, "name the blocks that you mean")  # fmt: skip
            _not_denied(word, mention, scene)
            if word.word == "all of them" and (every := _all_of_them(word, mention, own, scene)) is not None:
                return every
            _no_rivals(word, mention, own, scene)
            if (listed := _listed_in_one(mention, scene)) is not None:
                return listed
            _no_later_ones(word, mention, own, scene)
            built = ref.built if len(ref.built) > 1 or _told_together(ref) else _one_tower(ref, scene, scope)
            return replace(all_of_it(ref, word.word), quant=None, each=False, built=built)
    last = _last_spoken_of(scene, {n for m in own for n in m.ref.names})
    if len(set(last)) == 1 and word.word in (*_SEVERAL, *_EACH):
        told = [m for m in scene.mentions if not scope.rel or m not in own]
        last = list(dict.fromkeys(n for m in told for n in m.ref.names if not scene.things[n].patch))
    if word.word in _BOTH and len(set(last)) > 2:
        return _two_wholes(word, scene)
    if word.word == "all of them":
        last = [n for m in scene.mentions if m not in own for n in m.ref.names if not m.ref.patch]
        return Ref(names=tuple(dict.fromkeys(last)), plural=True) if last else _nobody(word)
    if len(set(last)) == 2 and (piles := _both_piles(word, scene)):
        last = list(piles)
    elif len(set(last)) == 2:
        _no_pairs(word, set(last), scene)
    if last:
        _not_alone(word, last)
        level = scope.role == "landmark" and scope.rel in DIRECTIONS
        return Ref(names=tuple(last), plural=len(last) > 1, built=_tower_of(last, word, scene) if level else ())
    return _nobody(word)


def all_of_it(ref: Ref, word: str = "both") -> Ref:
    """ "(Put A near B or C;) D must be near both": B and C, and not one of them, as "them" may be."""
    if ref.op == "except":  # "exactly three of the four are there, the other one does not touch them"
        return replace(ref, op="and", parts=())
    if ref.op in ("or", "xor") and word in _BOTH:
        return replace(ref, op="and", parts=())
    return replace(ref, op="and") if ref.op == "nor" else ref


def neither(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    """ "(Put A near B or C) and D near neither": none of two that were told before."""
    patches = patches_of_each(scene, scope, of_none=True) if scope.role == "landmark" else ()
    two = Ref(names=patches, patch=True) if patches else them(replace(word, word="both"), scene, scope)
    if len(two.names) < 2:
        raise refuse("ambiguous", "it is not clear which two these are", word.span, "name them")
    return replace(two, quant=Amount(0, 0, True), plural=True, op="and")


def _latest_first(scene: Scene) -> list[Mention]:
    """What was spoken of, as the text tells it: what there is is read first, and may be told last."""
    return sorted(scene.mentions, key=lambda m: m.sentence if m.sentence <= scene.sentence else -1)[::-1]


def _not_denied(word: Pronoun, last: Mention, scene: Scene) -> None:
    """Refuse "they" behind "there are two red and two green blocks. No red block ...": these, or all there are?"""
    none = last.ref.quant is not None and last.ref.quant.strict and last.ref.quant.high == 0
    if none and any(m.role == "given" and {*m.ref.names} > {*last.ref.names} for m in scene.mentions):
        raise refuse("ambiguous", f"{word.word!r} could be these blocks, or all there are", word.span,
                     "name the blocks that you mean")  # fmt: skip


def _put_there(mention: Mention, word: Pronoun, own: list[Mention]) -> bool:
    """ "To the right of them put green on yellow", "put two greens behind them": not these two themselves."""
    subject = next(({*m.ref.names} for m in reversed(own) if m.role == "theme"), set())
    return mention.ref.span[1] >= word.span[1] or subject >= {*mention.ref.names}


def _left_behind(mention: Mention, scene: Scene) -> bool:
    """ "Take red and blue off the tower and put them on the mat": not the tower that several were taken off."""
    if mention.role != "landmark" or mention.rel != "off":
        return False
    themes = [m for m in scene.mentions if m.clause == mention.clause and m.role == "theme"]
    return any(len(m.ref.names) > 1 for m in themes)


def _not_alone(word: Pronoun, names: list[str]) -> None:
    """Refuse "each" of one block."""
    if word.word in _EACH and len(set(names)) == 1:
        raise refuse("no-referent", "one block alone is not each of several", word.span, "name the blocks")


_BOTH = ("both", "both of them")
_SEVERAL = ("them", "they", *_BOTH)
_EACH = ("each", "each one", "each of them", "either of them")
_THEY = frozenset({"them", "they", "all of them"})


def _beside_blocks(word: Pronoun, patches: Mention, scene: Scene) -> bool:
    """ "There are three green blocks and two mats. Two of them should be on the red mat": those that can be moved."""
    verb = scene.verbs.get(scene.clause, (None, False, ""))[2]
    told = [m for m in scene.mentions if m.clause == patches.clause and m.role == "given" and not m.ref.patch]
    if patches.ref.patch and scene.resting:
        return True
    given = patches.ref.patch and patches.role == "given" and word.word in (*_THEY, *_EACH)
    return given and bool(told) and verb in ("be", "place", "stack")


def patches_of_each(scene: Scene, scope: Scope, of_none: bool = False) -> tuple[str, ...]:
    """ "A on the red patch, B on the blue one and C on both": the patches that the clauses before put something on,
    where each told its own; none where something else was said last, or blocks were told together, unless `of_none`
    of them is spoken of: "two reds on the red patch, a blue one on the blue patch and the white one on neither"."""
    if scope.rel not in ("on", "off", "not on"):
        return ()
    told = {m.clause: m for m in scene.mentions if m.role == "landmark" and m.clause < scene.clause}
    each = [m for m in told.values() if m.ref.patch and m.rel == "on" and len(m.ref.names) == 1]
    several = any(len(m.ref.names) > 1 for m in scene.mentions) and not of_none
    names = tuple(dict.fromkeys(n for m in each for n in m.ref.names))
    return names if len(names) > 1 and len(each) == len(told) and not several else ()


def _of_patches(word: Pronoun, patches: tuple[str, ...]) -> Ref:
    if word.word in _EACH:
        no_block_there(word.word, word.span)
    return Ref(names=patches, patch=True, plural=True)


def no_block_there(word: str, span: Span | None) -> NoReturn:
    """Refuse "there is a red block on the green mat and one on the blue mat. Put a yellow one on each"."""
    raise refuse("ambiguous", f"{word!r} could be the patches, or the blocks on them", span,
                 "say 'on each patch', or 'on each block'")  # fmt: skip


def _one_of_two_wholes(ref: Ref, scene: Scene) -> bool:
    """Whether these two blocks are one of two structures that were built there."""
    return len(scene.built) == 2 and any(set(ref.names) == set(b.members) for b in scene.built)


def each_whole(word: Pronoun, found: Ref, scene: Scene) -> Ref | None:
    """ "Build a red tower. Build a blue tower. Top each with a white block": each of the towers.

    Raises:
        Refusal: of other structures, or said "each of them", it could be the blocks of one of them.
    """
    wholes = [set(b.members) for b in scene.built]
    if len(wholes) < 2 or set(found.names) not in wholes or word.word == "either of them":
        return None
    names = tuple(n for b in scene.built for n in b.members)
    towers = len(set(names)) == len(names) and all(b.kind == "stack" for b in scene.built)
    if towers and word.word != "each of them":
        return Ref(names=names, built=tuple(scene.built), plural=True, each=True, span=word.span)
    raise refuse("ambiguous", f"{word.word!r} could be the structures, or the blocks of one of them", word.span,
                 "say 'each of the towers', or name the blocks")  # fmt: skip


def _two_wholes(word: Pronoun, scene: Scene) -> Ref:
    """ "The reds form a row, the blues a column, and both are in the left half": of all that was built there."""
    names = [n for b in scene.built for n in b.members]
    if len(scene.built) != 2 or len(set(names)) < len(names):
        raise refuse("ambiguous", f"it is not clear which two {word.word!r} are", word.span, "name them")
    return Ref(names=tuple(names), built=tuple(scene.built), plural=True, span=word.span)


def _two_ends(word: Pronoun, own: list[Mention], scene: Scene) -> Ref | None:
    """ "Red is on the left, a blue tower on the right. White is between them": the two things there are.

    Not the blocks of one tower; None where it stands for two that were told together.
    """
    told: dict[tuple[str, ...], Ref] = {}
    for ref in (m.ref for m in scene.mentions if m not in own and m.ref.names):
        told[ref.names] = ref if ref.built or ref.names not in told else told[ref.names]
    whole = [ref for ref in told.values() if len(ref.names) == 1 or [b.kind for b in ref.built] == ["stack"]]
    apart = sum(len(names) for names in told) == len({n for names in told for n in names})
    if len(whole) == len(told) == 2 and apart and word.word in ("them", "they"):
        names = tuple(n for names in told for n in names)
        return Ref(names=names, parts=tuple(whole), plural=True, op="and")
    if len(whole) == len(told) and any(ref.built for ref in whole):
        raise refuse("between-two", "it is not clear between which two things", word.span, "name both")
    return None


def _nobody(word: Pronoun) -> NoReturn:
    told = f"{word.word!r} refers to something, but nothing was mentioned before"
    raise refuse("no-referent", told, word.span, "name the blocks")


def of_whom(noun: Noun) -> Meaning:
    """Of what "two of them" are two: of the last ones told together; "all of them" may be more than these, and so may
    those of whom "none of them" is so, for of two it would be "neither"."""
    of_them = isinstance(noun.part_of, Pronoun) and noun.part_of.word in ("them", "these", "those")
    if of_them and (noun.det, noun.amount, noun.traits) == ("all", None, Traits()):
        return Pronoun(word="all of them", span=noun.span)
    two = isinstance(noun.amount, Amount) and noun.amount.strict
    if of_them and noun.det == "no" and not two and noun.traits == Traits():
        return Pronoun(word="all of them", span=noun.span)
    if of_them and (noun.det, noun.amount, noun.traits) == ("each", None, Traits()):
        return Pronoun(word="each of them", span=noun.span)
    return noun.part_of or Pronoun(word="them", span=noun.span)


def sorted_out(noun: Noun, whole: Ref, scene: Scene) -> Ref:
    """ "the vowels of A, B and E": of the blocks that there are those that are such."""
    if noun.traits.quality is None or not isinstance(noun.part_of, Noun):
        return whole
    for thing in (scene.things[n] for n in whole.names):
        thing.declared = True
    names = tuple(n for n in whole.names if fits(scene.things[n], noun.traits))
    if not names:
        raise refuse("no-referent", "none of these is such", noun.span, "name the blocks")
    return replace(whole, names=names, parts=(), plural=len(names) > 1)


def _all_of_them(word: Pronoun, last: Mention, own: list[Mention], scene: Scene) -> Ref | None:
    """ "Put red on blue, and green next to it. All of them ...": all three, for two are both; None where the `last`
    several are meant, because nothing else was spoken of or this sentence spoke of them."""
    said = [n for m in scene.mentions if m not in own for n in m.ref.names if not scene.things[n].patch]
    every = tuple(dict.fromkeys(n for n in said if n in scene.things and not scene.things[n].extra))
    if set(last.ref.names) >= set(every) or last.ref.patch or last.ref.quant is not None:
        return None
    if len(last.ref.names) > 2:
        if last.sentence == scene.sentence:
            return None
        later = {n for m in scene.mentions[scene.mentions.index(last) + 1 :] if m not in own for n in m.ref.names}
        if not later - set(last.ref.names):
            raise refuse("ambiguous", f"{word.word!r} could be the last ones, or all those spoken of before", word.span,
                         "name the blocks that you mean")  # fmt: skip
    return Ref(names=every, plural=True)


def _no_later_ones(word: Pronoun, last: Mention, own: list[Mention], scene: Scene) -> None:
    """Refuse "them" behind "put A, B and C in a row. Put red next to blue": the three, the two, or all five?"""
    several: dict[int, set[str]] = {}
    one_more = False
    for mention in scene.mentions[scene.mentions.index(last) + 1 :]:
        if mention.clause not in (last.clause, scene.clause) and mention not in own:
            told = [n for n in mention.ref.names if not (scene.things[n].patch or scene.things[n].extra)]
            several.setdefault(mention.clause, set()).update(told)
            one_more |= _in_one_breath(last, mention, scene) and not {*told} <= {*last.ref.names}
    if one_more or any(len(names) > 1 and not names & set(last.ref.names) for names in several.values()):
        raise refuse("ambiguous", f"{word.word!r} could be the last ones, or all those spoken of before", word.span,
                     "name the blocks that you mean")  # fmt: skip


def _in_one_breath(last: Mention, other: Mention, scene: Scene) -> bool:
    """ "Put two on the red mat and one on the blue one": what is told of by the same verb, in an earlier sentence."""
    themes = last.role == other.role == "theme" and last.sentence == other.sentence < scene.sentence
    return themes and scene.verbs.get(last.clause) == scene.verbs.get(other.clause)


def _both_piles(word: Pronoun, scene: Scene) -> tuple[str, ...]:
    """ "Red is on blue and green is on white. Unstack both": all that stands on something else, in two piles."""
    if word.word not in _BOTH or scene.verbs.get(scene.clause, (None, False, ""))[2] != "unstack":
        return ()
    piles = [{*names_in(goal)} for goal in scene.start_goals if isinstance(goal, On | Stack)]
    apart = len(piles) == 2 and piles[0].isdisjoint(piles[1])
    return tuple(name for name in scene.things if name in piles[0] | piles[1]) if apart else ()


def _no_pairs(word: Pronoun, last: set[str], scene: Scene) -> None:
    """Refuse "them" behind "A on B, C on D": the last two, or all of them? In the sentence of the last two alone, "put
    C on D and move them ...", these are meant."""
    told = max((m.clause for m in scene.mentions if m.clause < scene.clause), default=0)
    now = [m for m in scene.mentions if m.clause == told and m.role == "landmark"]
    before = [m for m in scene.mentions if m.clause == told - 1 and m.role == "landmark"]
    alike = {m.rel for m in now} & {m.rel for m in before} - {""}
    apart = not last & {n for m in scene.mentions if m.clause == told - 1 for n in m.ref.names}
    alone = {m.sentence for m in now} == {scene.sentence} and scene.sentence not in {m.sentence for m in before}
    if alike and apart and not alone:
        raise refuse("ambiguous", f"{word.word!r} could be the last ones, or all those spoken of before", word.span,
                     "name the blocks that you mean")  # fmt: skip


def _no_rivals(word: Pronoun, last: Mention, own: list[Mention], scene: Scene) -> None:
    """Refuse "them" behind "a red tower left of a blue tower", "... of a blue block": the one of them, or both?"""
    fewest = 0 if last.role == "theme" and [b.kind for b in last.ref.built] == ["stack"] else 1
    for other in (m for m in scene.mentions if m.clause == last.clause and m not in own and m is not last):
        if len(other.ref.names) > fewest and not other.ref.patch and not set(other.ref.names) & set(last.ref.names):
            raise refuse("ambiguous", f"{word.word!r} could be several things spoken of before", word.span,
                         "name the blocks that you mean")  # fmt: skip


def _listed_in_one(last: Mention, scene: Scene) -> Ref | None:
    """ "There are a red and a green block, and there are two blue ones. Stack them": all that the sentence lists."""
    lists = [m for m in scene.mentions if (m.role, m.sentence, m.ref.patch) == ("given", last.sentence, False)]
    names = [n for m in lists for n in m.ref.names if not scene.things[n].extra]
    more = last in lists and len({m.clause for m in lists}) > 1 and not {*names} <= {*last.ref.names}
    return Ref(names=tuple(dict.fromkeys(names)), plural=True) if more else None


def _idle(mention: Mention, scene: Scene) -> bool:
    """ "There are two distractors. Put red next to blue; they ...": distractors, behind which others were told."""
    later = [n for m in scene.mentions[scene.mentions.index(mention) + 1 :] for n in m.ref.names]
    others = any(not scene.things[n].extra and not scene.things[n].patch for n in later)
    return others and all(scene.things[n].extra for n in mention.ref.names)


def _last_spoken_of(scene: Scene, own: set[str]) -> list[str]:
    """The blocks of the last clause and of those before it that spoke of one of them, without a clause's `own`."""
    clauses: dict[int, list[str]] = {}
    for mention in scene.mentions:
        there = [n for n in mention.ref.names if n not in own and not scene.things[n].patch]
        clauses.setdefault(max(-mention.clause, 1 - scene.clause), []).extend(there)
    last = clauses.get(1 - scene.clause, [])
    for clause in sorted(clauses):
        if set(last) & set(clauses[clause]):
            last = [*clauses[clause], *last]
    return list(dict.fromkeys(last))


def _tower_of(names: list[str], word: Pronoun, scene: Scene) -> tuple[Built, ...]:
    """ "Red is on blue. To the right of them ...": of the tower that these are."""
    tower = [n for n in names if scene.on_top.get(n) not in names]
    while len(tower) < len(names):
        above = [n for n in names if tower and scene.on_top.get(n) == tower[-1]]
        if len(above) != 1:
            return ()
        tower += above
    if len(tower) < 2 or any(scene.on_top.get(b) != a for a, b in pairwise(tower)):
        return ()
    return (Built(kind="stack", members=tuple(tower), ordered=True, span=word.span, key=-1),)


def _one_tower(ref: Ref, scene: Scene, scope: Scope) -> tuple[Built, ...]:
    """ "Stack A and E. T goes next to them": what is said of a place is said of their tower."""
    if scope.role != "landmark" or scope.rel == "between":
        return ()
    return tuple(b for b in scene.built if b.kind == "stack" and set(b.members) == set(ref.names))[:1]


def _told_together(ref: Ref) -> bool:
    """Several towers of which it is not said which block is in which."""
    return len(ref.built) == 1 and ref.built[0].kind == "towers"


def whichever_there_are(word: Pronoun, scene: Scene, scope: Scope) -> Ref:
    """ "Stack everything", of which nobody spoke before: all the blocks, so many as are taken for these words."""
    if word.word not in ("everything", "all") or scene.names_blocks:
        raise refuse("no-referent", f"{word.word!r} refers to blocks, but none was mentioned before", word.span,
                     "name the blocks")  # fmt: skip
    found = refer(Noun(head="block", det="all", plural=True, span=word.span), scene, scope)
    scene.mentions.pop()
    return found
