"""What the clauses of a text say of what they speak of."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise, permutations

from rpg.language.compose.bearing import bears
from rpg.language.compose.besides import told_besides
from rpg.language.compose.changing import change
from rpg.language.compose.coloring import colored_in_turn, looks, looks_but_for
from rpg.language.compose.forming import forms
from rpg.language.compose.items import PARTS
from rpg.language.compose.kept_clear import kept_clear
from rpg.language.compose.lined import put_in_line
from rpg.language.compose.nouns import resolve
from rpg.language.compose.one_each import each_of_a_new_one, in_turn, one_by_one, one_for_each
from rpg.language.compose.others import check_only
from rpg.language.compose.pronouns import landmark
from rpg.language.compose.reading import read_as
from rpg.language.compose.relating import at_part, bare, between, in_region, place
from rpg.language.compose.resting import on
from rpg.language.compose.scene import Impossible, Ref, Scene, Unclear
from rpg.language.compose.storeys_told import told_in_turn
from rpg.language.compose.subjects import (
    about_a_block,
    at_its_side,
    check_said,
    check_subject,
    one_of_it,
    one_that_lies,
    there_is,
    told_of_figures,
)
from rpg.language.compose.syntax import (
    STAY,
    TOLD,
    TOWER,
    Among,
    Bears,
    Chain,
    Change,
    Clause,
    Either,
    Holding,
    Holds,
    InLine,
    InTurn,
    Label,
    Looks,
    Made,
    NotBoth,
    Noun,
    Owns,
    Phrase,
    Place,
    Predicate,
    Pronoun,
    Reads,
    Same,
    Shares,
    changes,
    on_an_end,
)

_THE_BLOCK, _THE_ONE = Noun(det="the", noun="block"), Noun(det="the", noun="one")


def say(scene: Scene, clause: Clause) -> None:
    """Puts what a clause says into the scene. Raises Unclear where it does not say it clearly."""
    scene.next_clause()
    if clause.other is not None:
        _one_or_other(scene, clause)
        return
    if clause.mood == "start" and STAY in clause.predicates:
        raise Unclear
    scene.at_start = clause.mood == "start"
    if changes(clause):
        scene.begin()
    facts, figures = len(scene.facts), len(scene.figures)
    if clause.mood == "change":
        scene.stage += clause.later
        change(scene, clause)
    else:
        _say_all(scene, clause)
        if clause.only:
            check_only(scene, clause, facts)
        scene.stage += clause.later
    scene.wanted |= clause.mood not in TOLD
    scene.said += 1
    for n in range(facts, len(scene.facts)):
        scene.facts[n] = replace(scene.facts[n], stage=-1 if clause.mood == "start" else scene.stage)
    there = clause.mood == "start" or STAY in clause.predicates  # what stays where it is is there already
    scene.asked |= clause.mood == "put"
    for figure in scene.figures[figures:]:
        figure.there = clause.mood == "there" and not clause.predicates
        figure.stage = -1 if there or figure.stage < 0 else scene.stage


def _say_all(scene: Scene, clause: Clause) -> None:
    """What a clause says, behind what it tells by the way."""
    clause, besides = told_besides(clause)
    for told in besides:
        _say(scene, told)
    _say(scene, clause)


def _one_or_other(scene: Scene, clause: Clause) -> None:
    """Either this is so, or something else."""
    ways = (replace(clause, other=None), clause.other)
    known = _introduced(scene, [partial(say, clause=way) for way in ways if way])
    chosen = ways[scene.choose(2)]
    assert chosen is not None
    say(scene, chosen)
    if clause.mood == "start" or len(scene.blocks) > known:
        raise Unclear


def _stacked_on(scene: Scene, said: Sequence[Predicate]) -> None:
    """ "(Two are) stacked on the gray one": that is spoken of before there is a tower that it could be one of."""
    if len(said) > 1 and said[0] == Made(TOWER):
        of = said[1].of if isinstance(said[1], Place) else None
        if isinstance(of, Noun) and of.det == "the" and of.noun in {"block", "one"} and not of.ranks:
            resolve(scene, of)


def _not_the_other(scene: Scene, ref: Ref, said: Predicate) -> None:
    """ "(red or blue on the patch,) but not both": the other one is not there."""
    if not ref.either or not isinstance(said, Place) or said.no:
        raise Unclear
    for other in scene.instead:
        _said(scene, replace(other, fresh=False), replace(said, no=True))


def _shared(scene: Scene, ref: Ref, said: Shares) -> None:
    """Each of several at a place of its own, whichever is where."""
    if ref.kind != "block" or len(ref.ids) != len(said.places) or ref.bound or ref.rest or ref.no:
        raise Unclear
    orders = list(permutations(ref.ids))
    chosen = ref.ids if scene.alike(ref.ids) else orders[scene.choose(len(orders))]
    for n, there in zip(chosen, said.places, strict=True):
        _said(scene, Ref("block", [n]), there)


def _one_place(scene: Scene, ref: Ref, said: Either) -> None:
    """It is at one of several places."""
    if len(ref.ids) > 1 or ref.each:
        raise Unclear  # all at one, or some at each
    known = _introduced(scene, [partial(_said, ref=ref, said=place) for place in said.places])
    _said(scene, ref, said.places[scene.choose(len(said.places))])
    if len(scene.blocks) > known:
        raise Unclear


def _introduced(scene: Scene, ways: Sequence[Callable[[Scene], None]]) -> int:
    """Puts the blocks and patches that any of these tells of into the scene, so that they are there in any case."""
    told: Scene = pickle.loads(pickle.dumps(scene))
    told.script, told.choices = (), []
    figures = [figure for figure in told.figures if not figure.implied]
    for way in ways:
        way(told)
    if told.choices or len([figure for figure in told.figures if not figure.implied]) > len(figures):
        raise Unclear
    scene.blocks, scene.patches, scene.lots = told.blocks, told.patches, told.lots
    return len(scene.blocks)


def _narrow(scene: Scene, clause: Clause, said: Among) -> None:
    """ "(One of A, B and C,) but not B": leaves those ways to have what was said ahead in which this is so."""
    known, taken = len(scene.blocks), set(scene.taken)
    if not any(ref.kind == "block" and set(ref.ids) == taken for ref in scene.before) or not taken < set(scene.whole):
        raise Unclear
    them = resolve(scene, clause.subject)
    if them.kind != "block" or len(scene.blocks) > known or not set(them.ids) <= set(scene.whole):
        raise Unclear
    if (set(them.ids) <= taken) == said.no:
        raise Impossible
    scene.here, scene.spare = list(scene.before), scene.spare | set(scene.whole)


def _say(scene: Scene, clause: Clause) -> None:
    if isinstance(among := clause.predicates[0] if clause.predicates else None, Among):
        _narrow(scene, clause, among)
        return
    if colored_in_turn(scene, clause):
        return
    told = told_in_turn(scene, clause)
    if told is None or kept_clear(scene, told) or read_as(scene, told):
        return
    clause = at_its_side(scene, about_a_block(scene, told_of_figures(scene, told)))
    subject = clause.subject
    if isinstance(subject, Chain):
        if clause.predicates:
            raise Unclear
        _stacked(scene, subject)
        return
    if scene.pending and isinstance(subject, Noun) and _is_one(subject):
        one_by_one(scene, subject, clause.predicates)
        return
    subject = one_that_lies(scene, clause)
    own = one_of_it(scene, clause)
    if own is None and each_of_a_new_one(subject, clause.predicates):
        one_for_each(scene, subject, clause.predicates[0])
        return
    if clause.mood != "may" and _is_at(scene, subject, clause.predicates):
        return
    ref = own or resolve(scene, subject)
    check_subject(scene, clause, ref)
    check_said(clause, ref)
    if clause.aside is not None and isinstance(like := clause.predicates[0] if clause.predicates else None, Looks):
        looks_but_for(scene, ref, like, clause.aside)
        return
    if clause.aside is not None:
        _aside(scene, ref, clause.aside)
    if not clause.predicates:
        if isinstance(subject, Noun) and not (subject.noun or subject.det or subject.count):
            raise Unclear  # a mere colour
        there_is(scene, ref, clause.mood)
    scene.subject = (ref.kind, ref.ids)
    _stacked_on(scene, clause.predicates)
    for n, said in enumerate(clause.predicates):
        if said == Made(TOWER) and ref.kind == "block" and len(ref.ids) == 1 and len(clause.predicates) > 1:
            continue  # "stacked on it"
        if isinstance(said, NotBoth):
            _not_the_other(scene, ref, clause.predicates[n - 1])
            continue
        _said(scene, ref, said)
        if isinstance(said, Made) and ref.kind == "block" and scene.figures[-1].kind == "tower":
            ref = Ref("figure", [len(scene.figures) - 1])  # what is said next is said of the tower
    if clause.fronted:
        scene.mention(replace(ref, fresh=False))  # "behind it stands a tower, which ...": told last
        scene.around = scene.around if clause.mood else None  # behind "next to it a red block", which is told first
    scene.subject = None
    scene.place_barred()
    if clause.predicates and ref.kind == "block":
        scene.used.update(ref.ids)


def _is_one(noun: Noun) -> bool:
    return noun.count < 2 and not (noun.det or noun.color or noun.ranks)


def _is_at(scene: Scene, subject: Phrase, said: Sequence[Predicate]) -> bool:
    """ "The middle one is the white block", "B is the last one": tells which block of a figure is at a place of it."""
    like = said[0].like if len(said) == 1 and isinstance(said[0], Looks) else None
    for block, there in ((like, subject), (subject, like)):
        known = isinstance(block, Label) or (_is_the_one(block) and isinstance(block, Noun) and block.color)
        if known and block and isinstance(there, Noun) and there.that and _is_the_one(replace(there, that=())):
            block = replace(block, noun="block") if isinstance(block, Noun) else block
            _said_of(scene, resolve(scene, block), there.that)  # "the block on top of white is the red one"
            return True
        ranked = isinstance(there, Noun) and (there.ranks or there.nth) and not (there.color or there.many)
        if block and isinstance(there, Noun) and ranked and known:
            at_part(scene, resolve(scene, block), there, no=False)
            return True
    return False


def _is_the_one(phrase: Phrase | None) -> bool:
    """ "The block", "the red one": one by its colour alone, or by nothing."""
    return isinstance(phrase, Noun) and replace(phrase, color="") in (_THE_BLOCK, _THE_ONE)


def _said_of(scene: Scene, ref: Ref, said: Sequence[Predicate]) -> None:
    """Says it of these; "it" is something else."""
    scene.subject = (ref.kind, ref.ids)
    for one in said:
        _said(scene, ref, one)
    scene.subject = None


def _aside(scene: Scene, ref: Ref, clause: Clause) -> None:
    """ "the third, with the white block on top,": on what is spoken of."""
    place = clause.predicates[0]
    if not isinstance(place, Place) or len(ref.ids) != 1:
        raise Unclear
    other = resolve(scene, clause.subject)
    if ref.kind == "figure":
        bare(scene, other, place)
    elif place.relation == "top" and ref.kind == "block":
        on(scene, other, ref, "on", no=False)
    else:
        raise Unclear


def _stacked(scene: Scene, chain: Chain) -> None:
    """ "blue over red": each on the next one."""
    lowest = chain.parts[-1]
    if scene.patches and isinstance(lowest, Noun) and not lowest.noun:
        raise Unclear  # a block or a patch of that colour
    if any(isinstance(part, Pronoun) for part in chain.parts):
        raise Unclear  # a place, not a tower that is told
    refs = [resolve(scene, part) for part in chain.parts]
    if any(ref.kind != "block" or len(ref.ids) != 1 for ref in refs):
        raise Unclear
    for lower, upper in pairwise(reversed(refs)):  # from the bottom up, so that they grow to one tower
        on(scene, upper, lower, "on", no=False)
    for ref in refs:
        scene.used.update(ref.ids)


def _said(scene: Scene, ref: Ref, said: Predicate) -> None:
    if isinstance(said, Either):
        _one_place(scene, ref, said)
        return
    if isinstance(said, Shares):
        _shared(scene, ref, said)
        return
    if isinstance(said, Place) and said.no and (ref.each or ref.no or ref.every or ref.either):
        raise Unclear
    if isinstance(said, Place) and isinstance(said.of, Noun):
        if said.no and said.of.det in {"each", "all", "both", "a", "another", "any"}:
            raise Unclear
        if ref.no and said.of.det == "any":
            raise Unclear  # "neither of them touches either of those": none of all
        if on_an_end(said):
            raise Unclear
        only_color = said.of.color and not said.of.noun
        if said.relation == "on" and only_color and scene.patches:
            raise Unclear  # a block or a patch of that colour
        if said.relation == "on" and only_color and any(scene.blocks[n].label for n in ref.ids if ref.kind == "block"):
            raise Unclear  # a block, or the colour of the block with the symbol
    if ref.kind == "mixed" and isinstance(said, Place) and said == Place("side by side"):
        ref = replace(ref, kind="block")
    rising = isinstance(said, Place) and said.relation == "rising"
    if ref.kind == "mixed" and not isinstance(said, Made) and not rising:
        raise Unclear
    if ref.no:
        if not isinstance(said, Place) or said.of is None:
            raise Unclear
        if isinstance(said.of, Noun) and said.of.det == "any":  # "neither of them touches any of those"
            said = replace(said, of=replace(said.of, det="each"))
        said, ref = replace(said, no=not said.no), replace(ref, no=False)
    if isinstance(said, InLine):
        put_in_line(scene, ref, said.places)
    elif isinstance(said, Made):
        forms(scene, ref, said.figure)
    elif isinstance(said, Looks) and said.no:
        raise Unclear
    elif isinstance(said, Looks):
        looks(scene, ref, said)
    elif isinstance(said, Bears):
        bears(scene, ref, said)
    elif isinstance(said, Among | Change | Holds | Holding | InTurn | NotBoth | Owns | Reads | Same):
        raise Unclear
    elif said.relation == "region":
        in_region(scene, ref, said)
    elif said.of is None:
        bare(scene, ref, said)
    else:
        _placed(scene, ref, said)


def _placed(scene: Scene, ref: Ref, said: Place) -> None:
    """It is somewhere to something else."""
    of = said.of
    assert of is not None
    if said.relation == "in" and isinstance(of, Noun) and of.noun in PARTS and ref.kind == "block":
        at_part(scene, ref, of, no=said.no)
        return
    if said.relation == "between":
        between(scene, ref, of, said)
        return
    if isinstance(of, Noun) and of.det == "another":
        raise Unclear
    around, scene.around = landmark(scene, said), None
    scene.placed = ref.ids if ref.kind == "figure" else []
    target = scene.mention(around) if around else resolve(scene, of)
    scene.placed = []
    if len(target.ids) == 1:
        scene.around = (said.relation, target, of in {Pronoun("it"), Pronoun("its")})
    if target.either and (said.no or len(ref.ids) > 1 or ref.each):
        raise Unclear  # on none of them, or not on one; all on one, or some on each
    both = isinstance(of, Noun) and of.det == "both" and ref.kind == "figure"
    if ref.fresh and said.relation != "on" and ((target.each and of == Pronoun("each")) or both):
        raise Unclear  # one for each, or one for all
    if said.how == "respectively":
        in_turn(scene, ref, target, said)
        return
    named = isinstance(of, Noun) and of.det == "the" and not of.many
    if target.fresh and not named and target.kind == "block" and (ref.each or len(ref.ids) > len(target.ids)):
        raise Unclear  # one for each, or one for all
    place(scene, ref, target, said)
