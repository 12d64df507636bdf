"""What a clause is about: things that it tells of for the first time, and those of which it may say something."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.facing import SIDED
from rpg.language.compose.items import FIGURES
from rpg.language.compose.scene import OPPOSITE, SIDES, Ref, Scene, Unclear
from rpg.language.compose.syntax import (
    ALL,
    Bears,
    Both,
    Chain,
    Clause,
    Either,
    Label,
    Listing,
    Looks,
    Made,
    Noun,
    Phrase,
    Place,
    Pronoun,
    Shares,
    is_figure,
)

_BESIDE = frozenset({*SIDES, "next", "near", "far"})
LINED = frozenset({"tower", "row", "line", "column"})
_UPON = frozenset({"top", "left", "right"})
_ITS = (None, Pronoun("it"))
_MUTUAL = frozenset({"touching", "side by side", "apart"})


def told_of_figures(scene: Scene, clause: Clause) -> Clause:
    """ "One tower is white on red", "the three stacks are ...": new ones are made of what is told of them."""
    subject, said = clause.subject, clause.predicates[:1]
    if clause.mood == "reads" and any(f.kind in LINED and not scene.blocks[f.blocks[0]].label for f in scene.figures):
        raise Unclear  # is it that one?
    if not said or not isinstance(said[0], Looks) or not isinstance(said[0].like, Chain | Listing):
        return clause
    if not isinstance(subject, Noun) or subject.content is not None or subject.of is not None:
        raise Unclear
    subject = _at_its_side(scene, subject)
    if subject == Noun(det="another", noun="one") and scene.figures:
        subject = replace(subject, noun=scene.figures[-1].kind)
    if subject.det == "other" and len(scene.figures) == 1 and subject.noun in {"", "one", *FIGURES}:
        subject = replace(subject, det="another", noun=scene.figures[0].kind)
    elif (
        subject.noun not in FIGURES
        or not (subject.det or subject.count or subject.many)
        or (subject.det not in {"", "a"} and scene.figures)
    ):
        raise Unclear
    return replace(clause, subject=replace(subject, content=said[0].like, made="of"), predicates=clause.predicates[1:])


def about_a_block(scene: Scene, clause: Clause) -> Clause:
    """ "(Put red on the mat,) the white one must be off it": what is put somewhere is no mat."""
    subject = clause.subject
    placed = bool(clause.predicates) and all(isinstance(said, Place) and said.of for said in clause.predicates)
    if not isinstance(subject, Noun) or subject != Noun(det="the", color=subject.color, noun="one") or not placed:
        return clause
    known = any(block.color == subject.color for block in scene.blocks)
    told = [ref.kind for ref in scene.before]
    if known or not subject.color or set(told) != {"block", "patch"} or scene.figures:
        return clause
    return replace(clause, subject=replace(subject, noun="block"))


def at_its_side(scene: Scene, clause: Clause) -> Clause:
    """ "On the left a tower of four, on the right one of two": towers that are told apart by their sides."""
    subject, said = clause.subject, clause.predicates
    place = said[0] if len(said) == 1 and not clause.mood and isinstance(clause.subject, Noun) else None
    if not isinstance(place, Place) or not isinstance(subject, Noun) or place.of is not None or place.no or place.cm:
        return clause
    if scene.facing and isinstance(subject.of, Noun) and subject == Noun(count=1, of=subject.of):
        subject = Noun(det="a", noun="one", content=subject.of, made="of")  # "on the right one of two"
    side = {"front": "near", "behind": "far"}.get(place.relation, place.relation)
    new = subject.det in {"a", ""} and subject.count < 2 and not subject.ranks and subject.content is not None
    known = subject.noun in FIGURES or (subject.noun == "one" and bool(scene.facing) and not subject.color)
    if side not in SIDED or not new or not known or len(scene.figures) > len(scene.facing):
        return clause
    kind = scene.figures[-1].kind if subject.noun == "one" else subject.noun
    return replace(clause, subject=replace(subject, det="a", noun=kind, ranks=(side,)), predicates=())


def _at_its_side(scene: Scene, noun: Noun) -> Noun:
    """ "The left tower", "the tower on the right", where no others were told of: it is told of for the first time."""
    where = noun.that[0] if len(noun.that) == 1 else None
    rank = noun.ranks[0] if len(noun.ranks) == 1 else ""
    if isinstance(where, Place) and where.of is None and not where.no:
        rank = {"front": "near", "behind": "far"}.get(where.relation, where.relation)
    if noun.noun == "one" and scene.facing and rank not in scene.facing:
        noun = replace(noun, noun=scene.figures[-1].kind)  # "the right one", behind "the left tower"
    if rank not in SIDED or noun.det != "the" or noun.noun not in FIGURES or len(scene.figures) > len(scene.facing):
        return noun
    return replace(noun, det="a", ranks=(rank,), that=())


def one_of_it(scene: Scene, clause: Clause) -> Ref | None:
    """ "(A row of two reds and three blues,) with a blue one in the middle", "with a red one at each end": blocks of
    the figure that was told last, which are at these places of it. None where they may be further ones."""
    subject, said = clause.subject, clause.predicates[0] if len(clause.predicates) == 1 else None
    if not isinstance(said, Place) or said.no or not isinstance(subject, Noun):
        return None
    new = replace(subject, color="", noun="", det="") == Noun() and subject.color and subject.det == "a"
    ends = isinstance(said.of, Noun) and said.of.noun == "end" and said.of.det in ALL and said.of.of in _ITS
    inside = said.how == "at" or (ends and said.relation == "in")
    last = next((ref for ref in scene.before if ref.kind == "figure" and len(ref.ids) == 1), None)
    figure = scene.figures[last.ids[0]] if last is not None else None
    if not new or not (inside or said.relation in _UPON) or figure is None or figure.kind not in LINED or figure.told:
        return None
    like = [n for n in figure.blocks if scene.blocks[n].color == subject.color and n not in figure.placed.values()]
    count = 2 if ends else 1
    if len(like) < count:
        return None
    if not inside and scene.alike(figure.blocks):
        return None
    if not inside or not scene.alike(like):
        raise Unclear  # one of them, or a further one
    return scene.mention(Ref("block", like[:count]))


def one_that_lies(scene: Scene, clause: Clause) -> Phrase:
    """ "(The red block is not on the mat,) but the blue one is on it": a block, as ahead; no mat."""
    subject, said = clause.subject, clause.predicates[0] if clause.predicates else None
    if not isinstance(said, Place) or not isinstance(subject, Noun) or subject.noun != "one":
        return subject
    if said.relation == "empty" and scene.patches:
        return replace(subject, noun="patch")
    lies = said.relation in {"on", "in", "off"} or (said.relation in _BESIDE and not scene.patches)
    if not lies or said.of is None or not subject.color or subject.ranks:
        return subject
    ahead = scene.before[0] if scene.before else None
    blocks = ahead is not None and ahead.kind == "block" and subject.det in {"the", *ALL}
    return replace(subject, noun="block") if blocks else subject


def _is_lower(scene: Scene, block: int) -> bool:
    """Whether a block is in a tower of blocks that look alike, and not on top of it."""
    tower = scene.figure_of(block)
    if tower is None or tower.kind != "tower" or tower.implied:
        return False
    return block in tower.blocks[:-1] and scene.alike(tower.blocks)


def check_subject(scene: Scene, clause: Clause, ref: Ref) -> None:
    """Raises Unclear where something may be said of other blocks than of those."""
    subject = clause.subject
    if clause.mood == "build" and not ref.fresh and any(isinstance(said, Looks) for said in clause.predicates):
        raise Unclear  # "make each of them red": what is there has its colour
    in_turn = [said.of for said in clause.predicates if isinstance(said, Place) and said.how == "respectively"]
    for of in (subject, *in_turn) if in_turn else ():
        if not isinstance(of, Both) or of.either or any(not _is_one(part) for part in of.parts):
            raise Unclear  # in which order they are is not told
    if ref.kind != "block":
        return
    if isinstance(subject, Noun):
        if subject.det == "any":
            raise Unclear  # every one of them, or just one
        sided = any(
            isinstance(said, Place) and said.of is None and said.relation in SIDES for said in clause.predicates
        )
        if sided and not clause.mood and not (subject.det or subject.noun or subject.count):
            raise Unclear  # "a row of three orange blocks, white on the left": at its end, or beside it
        like = sum(block.look == scene.blocks[ref.ids[0]].look for block in scene.blocks)
        denied = any(isinstance(said, Place) and said.no for said in clause.predicates)
        if denied and subject.det in {"a", "another", ""} and not subject.of and like > 1:
            raise Unclear  # of one of them, or of none
        moves = clause.mood == "put" and bool(subject.ranks or subject.of or subject.nth)
        if moves and any(_is_lower(scene, n) for n in ref.ids[:1]):
            raise Unclear  # one that looks like it, and lies on top, would do
        bears = all(isinstance(said, Bears) for said in clause.predicates)
        built = [f for f in scene.figures if not f.implied and f.stage == scene.stage]
        moved = clause.mood == "put" and bool(subject.ranks or subject.of) and not bears
        whole = scene.figure_of(ref.ids[0])
        if moved and whole is not None and not whole.implied and whole.kind != "tower":
            rest = {scene.blocks[n].look for n in whole.blocks if n not in ref.ids}
            if any(scene.blocks[n].look in rest for n in ref.ids):
                raise Unclear  # which of those that look alike is where then
        if clause.mood == "put" and not (scene.wanted or clause.later) and _is_elsewhere(scene, ref, clause):
            scene.begin()
        if moved and any(set(ref.ids) & set(f.blocks) for f in built):
            if scene.wanted or clause.later:
                raise Unclear  # what it is taken from is there already
            scene.begin()
    if not clause.mood and clause.predicates and len(ref.ids) > 1 and scene.figures and ref.fresh:
        raise Unclear  # these may form what was told ahead


def _is_elsewhere(scene: Scene, ref: Ref, clause: Clause) -> bool:
    """ "(Blue is on red.) Move blue onto green": it was told to be where it can not be then, so it is there first."""
    said = clause.predicates[0] if clause.predicates else None
    if not isinstance(said, Place) or said.no or said.how == "somewhere":
        return False
    own = [fact for fact in scene.facts if fact.a.ids == ref.ids and fact.a.kind == ref.kind and not fact.no]
    if said.relation == "region":
        return any(
            fact.said.replace(side, other) == f"{said.how} of the table"
            for fact in own for side, other in OPPOSITE.items() if side in fact.said
        )  # fmt: skip
    of = said.of
    if said.relation != "on" or not isinstance(of, Noun | Label):
        return False
    patches = isinstance(of, Noun) and of.noun == "patch"
    return any(fact.said == ("patch" if patches else "on") for fact in own)


def _is_one(phrase: Phrase) -> bool:
    return isinstance(phrase, Label) or (isinstance(phrase, Noun) and not phrase.many and phrase.count < 2)


def there_is(scene: Scene, ref: Ref, mood: str) -> None:
    """Blocks that are told of by themselves are those that the rest of the text is about."""
    if (ref.kind == "patch" and mood in {"there", "seen", "in"}) or ref.kind == "mixed":
        return
    if mood == "so" and ref.kind == "figure":
        return  # how high it is
    if mood == "in" and ref.kind == "block" and all(scene.blocks[n].label for n in ref.ids) and not scene.whole:
        scene.whole, scene.taken = list(ref.ids), []
        return
    if not ref.fresh or ref.kind not in {"block", "figure"}:
        raise Unclear
    if ref.kind == "block":
        if any(
            scene.blocks[n].look == block.look
            for n in ref.ids
            for m, block in enumerate(scene.blocks)
            if m not in ref.ids
        ):
            raise Unclear  # these, or further ones
        lots: dict[tuple[str, str, int, str], list[int]] = {}
        for n in ref.ids:
            lots.setdefault(scene.blocks[n].look, []).append(n)
        for lot in lots.values():
            scene.stock.append(lot)
        if len(lots) == 1:
            scene.whole, scene.taken = list(ref.ids), []


def check_said(clause: Clause, ref: Ref) -> None:
    """Raises Unclear where what is said may be said of one thing or of another, or is not asked for."""
    places = [said for said in clause.predicates if isinstance(said, Place)]
    if clause.mood == "may" and not ref.no and not all(isinstance(said, Either) for said in clause.predicates):
        raise Unclear  # this is allowed, not asked for
    several = isinstance(clause.subject, Both) and not clause.subject.either and is_figure(clause.subject)
    if several and clause.mood != "put" and any(said.of is not None for said in places):
        raise Unclear  # "a row and a tower on the mat": both of them, or the last one
    if (
        len(clause.predicates) > 1
        and not isinstance(clause.predicates[0], Made)
        and any(said.how == "immediately" for said in places)
    ):
        raise Unclear  # "right next to it, on its left": how near is said of both
    if any(said.relation in {"touch", "touching"} for said in places) and any(said.cm for said in places):
        raise Unclear
    to_others = any(said.of is not None and said.relation in _BESIDE for said in places)
    if to_others and any(said.of is None and said.relation in _MUTUAL for said in places):
        raise Unclear  # "next to the blue ones, touching": one another, or them
    if any(said.relation == "flank" for said in places) and not any(isinstance(p, Shares) for p in clause.predicates):
        raise Unclear  # which one is on which side?
