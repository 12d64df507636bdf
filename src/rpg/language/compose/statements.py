"""What the clauses of a text say of what they speak of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, pairwise

from rpg.language.compose.nouns import resolve
from rpg.language.compose.places_of import places
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import (
    Bears,
    Both,
    Chain,
    Clause,
    Labels,
    Looks,
    Made,
    Noun,
    Phrase,
    Place,
    Predicate,
    Pronoun,
)

_SIDES = {"left": "to the left of", "right": "to the right of", "front": "in front of", "behind": "behind"}
_RELATIONS = {**_SIDES, "next": "next to", "near": "near"}
_BARE_PLACES = frozenset({"top", "bottom", "middle", "left", "right", "front", "behind"})
_FIRST_ROW = {"left": ("left",), "right": ("right",), "middle": ("middle",)}


def say(scene: Scene, clause: Clause) -> None:
    """Puts what a clause says into the scene. Raises Unclear where it does not say it clearly."""
    scene.next_clause()
    facts, figures = len(scene.facts), len(scene.figures)
    _say(scene, clause)
    if clause.later:
        scene.stage += 1
    for n in range(facts, len(scene.facts)):
        scene.facts[n] = replace(scene.facts[n], stage=-1 if clause.mood == "start" else scene.stage)
    for figure in scene.figures[figures:]:
        figure.stage = -1 if clause.mood == "start" else scene.stage


def _say(scene: Scene, clause: Clause) -> None:
    subject = clause.subject
    if isinstance(subject, Chain):
        if clause.predicates:
            raise Unclear
        _stacked(scene, subject)
        return
    if (
        scene.pending
        and isinstance(subject, Noun)
        and subject.count < 2
        and not subject.det
        and not subject.color
        and not subject.ranks
    ):
        _one_by_one(scene, subject, clause.predicates)
        return
    if _each_of_a_new_one(subject, clause.predicates):
        _one_for_each(scene, subject, clause.predicates[0])
        return
    ref = resolve(scene, subject)
    if isinstance(subject, Noun) and subject.det in {"a", "another", ""} and ref.kind == "block" and any(
        isinstance(said, Place) and said.no for said in clause.predicates
    ) and not subject.of and len([b for b in scene.blocks if b.look == scene.blocks[ref.ids[0]].look]) > 1:  # fmt: skip
        raise Unclear  # one of them, or none
    if not clause.mood and clause.predicates and ref.kind == "block" and len(ref.ids) > 1 and scene.figures:
        raise Unclear  # these may form what was told ahead
    if clause.aside is not None:
        _aside(scene, ref, clause.aside)
    if not clause.predicates:
        _there_is(scene, ref)
    scene.subject = (ref.kind, ref.ids)
    for said in clause.predicates:
        _said(scene, ref, said)
    scene.subject = None
    if clause.predicates and ref.kind == "block":
        scene.used.update(ref.ids)


def _aside(scene: Scene, ref: Ref, clause: Clause) -> None:
    """ "the third, with the white block on top,": on what is spoken of."""
    place = clause.predicates[0]
    if not isinstance(place, Place) or len(ref.ids) != 1:
        raise Unclear
    other = resolve(scene, clause.subject)
    if ref.kind == "figure":
        _bare(scene, other, place)
    elif place.relation == "top" and ref.kind == "block":
        _on(scene, other, ref, "on", no=False)
    else:
        raise Unclear


def _there_is(scene: Scene, ref: Ref) -> None:
    """Blocks that are told of by themselves are those that the rest of the text is about."""
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
        lots: dict[tuple[str, str, int], list[int]] = {}
        for n in ref.ids:
            lots.setdefault(scene.blocks[n].look, []).append(n)
        for lot in lots.values():
            scene.stock.append(lot)
        if len(lots) == 1:
            scene.whole, scene.taken = list(ref.ids), []


def _stacked(scene: Scene, chain: Chain) -> None:
    """ "blue over red": each on the next one."""
    refs = [resolve(scene, part) for part in chain.parts]
    if any(ref.kind != "block" or len(ref.ids) != 1 for ref in refs):
        raise Unclear
    for upper, lower in zip(refs, refs[1:], strict=False):
        _on(scene, upper, lower, "on", no=False)
    if len(refs) == 2:
        figure = Figure("tower", [refs[1].ids[0], refs[0].ids[0]], told=True)
        if not any(set(figure.blocks) & set(f.blocks) for f in scene.figures):
            figure.kind = "chain"
    for ref in refs:
        scene.used.update(ref.ids)


def _one_by_one(scene: Scene, subject: Noun, said: Sequence[Predicate]) -> None:
    """ "one on each end": where those are that lie somewhere on the figure told before."""
    upper, lower = scene.pending.pop()
    if (
        subject.noun not in {"", "one", "block"}
        or len(said) != 1
        or not isinstance(said[0], Place)
        or said[0].of is None
    ):
        raise Unclear
    target = resolve(scene, said[0].of)
    if (
        said[0].relation != "on"
        or said[0].no
        or target.kind != "block"
        or not target.each
        or not set(target.ids) <= set(lower)
    ):
        raise Unclear
    _on(scene, Ref("block", upper), Ref("block", target.ids), "on", no=False)


def _each_of_a_new_one(subject: Phrase, said: Sequence[Predicate]) -> bool:
    """Whether there is a further one for each of those that it is put on."""
    if len(said) != 1 or not isinstance(said[0], Place) or said[0].no:
        return False
    target = said[0].of
    return (
        isinstance(subject, Noun) and subject.det in {"a", "another"} and not subject.many and subject.count < 2
        and isinstance(target, Noun) and target.det in {"each", "both", "all"}
    )  # fmt: skip


def _one_for_each(scene: Scene, subject: Phrase, said: Predicate) -> None:
    """ "a white block on each end": as many white blocks as there are ends."""
    assert isinstance(said, Place) and said.of is not None and isinstance(subject, Noun)
    target = resolve(scene, said.of)
    if said.relation not in {"on", "next", *_SIDES} or target.no or target.bound:
        raise Unclear
    for n in target.ids:
        one = resolve(scene, replace(subject, det="a"))
        if not one.fresh:
            raise Unclear
        _place(scene, one, Ref(target.kind, [n]), said)
        scene.used.update(one.ids)


def _said(scene: Scene, ref: Ref, said: Predicate) -> None:
    if isinstance(said, Place) and said.no and (ref.each or ref.no or ref.every):
        raise Unclear
    if isinstance(said, Place) and isinstance(said.of, Noun):
        if said.no and said.of.det in {"each", "all", "both", "a", "another", "any"}:
            raise Unclear
        if said.relation == "on" and not said.of.noun and scene.patches:
            raise Unclear  # a block or a patch of that colour
        if (
            said.relation == "on"
            and not said.of.noun
            and any(scene.blocks[n].label for n in ref.ids if ref.kind == "block")
        ):
            raise Unclear  # a block, or the colour of the block with the symbol
    if ref.no:
        if not isinstance(said, Place) or said.of is None:
            raise Unclear
        said, ref = replace(said, no=not said.no), replace(ref, no=False)
    if isinstance(said, Made):
        _forms(scene, ref, said.figure)
    elif isinstance(said, Looks):
        _looks(scene, ref, said.like)
    elif isinstance(said, Bears):
        _bears(scene, ref, said)
    elif said.relation == "region":
        _in_region(scene, ref, said)
    elif said.of is None:
        _bare(scene, ref, said)
    else:
        of = said.of
        if said.relation == "between":
            _between(scene, ref, of, said)
            return
        if isinstance(of, Noun) and of.det == "another":
            raise Unclear
        target = resolve(scene, of)
        if target.fresh and target.kind == "block" and (ref.each or len(ref.ids) > len(target.ids)):
            raise Unclear  # one for each, or one for all
        _place(scene, ref, target, said)


def _forms(scene: Scene, ref: Ref, phrase: Phrase) -> None:
    """These blocks form a figure."""
    if ref.kind == "figure" and isinstance(phrase, Noun) and phrase.noun in {"row", "line"} and len(ref.ids) > 1:
        _in_line(scene, ref, phrase)
        return
    if ref.kind != "block" or not isinstance(phrase, Noun) or phrase.content is not None or ref.each or ref.bound:
        raise Unclear
    if phrase.count > 1 or phrase.det not in {"a", ""} or phrase.color:
        raise Unclear
    in_order = phrase.ranks == ("left",)
    if in_order and len({scene.blocks[n].look for n in ref.ids}) < len(ref.ids):
        raise Unclear
    made = replace(phrase, det="a", ranks=(), content=Pronoun("them"))
    here, scene.here = scene.here, [Ref("block", ref.ids)]
    subject, scene.subject = scene.subject, None
    figure = scene.figures[resolve(scene, made).ids[0]]
    scene.here, scene.subject = [*here, *scene.here[1:]], subject
    if in_order:
        figure.told = figure.sided = True


def _in_line(scene: Scene, ref: Ref, phrase: Noun) -> None:
    """Towers that stand in a row: their lowest blocks do; told from left to right, each is left of the next one."""
    figures = [scene.figures[n] for n in ref.ids]
    if (
        any(f.kind != "tower" for f in figures)
        or phrase.content is not None
        or phrase.det not in {"a", ""}
        or phrase.color
    ):
        raise Unclear
    for figure in figures:
        scene.settle(figure)
    scene.facts.append(Fact(Ref("block", [f.blocks[0] for f in figures]), "in a row"))
    if phrase.ranks == ("left",):
        scene.facts += [Fact(Ref("figure", [a]), "to the left of", Ref("figure", [b])) for a, b in pairwise(ref.ids)]


def _looks(scene: Scene, ref: Ref, like: Phrase) -> None:
    """These blocks are of a colour: blocks of which nothing was said of how they look."""
    if not isinstance(like, Noun) or not like.color or like.noun not in {"", "block", "one"} or like.count > 1:
        raise Unclear
    if ref.kind == "figure":
        ref = Ref("block", [n for at in ref.ids for n in scene.figures[at].blocks])
    if ref.kind != "block" or ref.bound:
        raise Unclear
    for n in ref.ids:
        block = scene.blocks[n]
        if block.label or block.color not in {"", like.color}:
            raise Unclear
        block.color = like.color


def _bears(scene: Scene, ref: Ref, said: Bears) -> None:
    """Something lies on it, or nothing does."""
    if isinstance(said.what, Labels):
        raise Unclear  # it may be the symbol on it
    if said.what is None:
        for n in _tops(scene, ref):
            scene.facts.append(Fact(Ref("block", [n]), "clear"))
        return
    if said.place is not None and said.place.relation != "top":
        if said.place.of is None:
            raise Unclear
        what = resolve(scene, said.what)
        _place(scene, what, resolve(scene, said.place.of), said.place)
        return
    tops = _tops(scene, ref)
    if isinstance(said.what, Noun) and said.what.det in {"a", "each"} and len(tops) > 1:
        for n in tops:
            one = resolve(scene, replace(said.what, det="a"))
            _on(scene, one, Ref("block", [n]), "on", no=False)
        return
    _on(scene, resolve(scene, said.what), Ref("block", tops), "on", no=False)


def _tops(scene: Scene, ref: Ref) -> list[int]:
    """The blocks that something lies on when it lies on these."""
    if ref.kind == "block" and not ref.bound:
        return ref.ids
    if ref.kind != "figure":
        raise Unclear
    tops = []
    for at in ref.ids:
        figure = scene.figures[at]
        if figure.kind != "tower" or figure.stage < 0:
            raise Unclear
        scene.settle(figure)
        tops.append(figure.blocks[-1])
    return tops


def _bare(scene: Scene, ref: Ref, said: Place) -> None:
    """A place that is told without what it is a place of."""
    name = said.relation
    if name == "free" and ref.kind == "patch" and not said.no:
        scene.facts += [Fact(Ref("patch", [n]), "empty") for n in ref.ids]
    elif name in {"free", "table", "flat"} and ref.kind == "block" and not ref.bound:
        word = {"free": "clear", "table": "table", "flat": "table"}[name]
        if said.no:
            raise Unclear
        scene.facts += [Fact(Ref("block", [n]), word) for n in ref.ids]
    elif name in {"side by side", "touching", "apart"} and not ref.each and not ref.bound:
        if ref.rest and said.cm:
            raise Unclear
        if len(ref.ids) != 2 and (name != "apart" and not said.no):
            raise Unclear
        word = {"side by side": "next to", "touching": "touch", "apart": "apart"}[name]
        if said.cm:
            bound = {"least": "at least ", "most": "at most "}.get(said.bound, "")
            word = f"{bound}{said.cm:g} cm from"
        scene.facts += [
            Fact(Ref(ref.kind, [a]), word, Ref(ref.kind, [b]), no=said.no) for a, b in combinations(ref.ids, 2)
        ]
    elif name in _BARE_PLACES and not said.no:
        _in_figure(scene, ref, name)
    else:
        raise Unclear


def _in_region(scene: Scene, ref: Ref, said: Place) -> None:
    if ref.kind not in {"block", "figure"} or said.no or ref.bound:
        raise Unclear
    for ids in (scene.figures[n].blocks for n in ref.ids) if ref.kind == "figure" else (ref.ids,):
        scene.facts.append(Fact(Ref("block", ids), f"{said.how} of the table"))


def _in_figure(scene: Scene, ref: Ref, name: str) -> None:
    """ "on top", "at the left end": in the figure that was spoken of, if it is one of its blocks; else on or beside."""
    spoken = [r for refs in (scene.here, scene.before) for r in refs if r.kind == "figure" and r is not ref]
    if ref.kind == "block" and len(ref.ids) == 1 and (own := scene.figure_of(ref.ids[0])) is not None:
        spoken = [Ref("figure", [scene.figures.index(own)])]
    if len({tuple(r.ids) for r in spoken}) > 1:
        raise Unclear
    last = spoken[0] if spoken else None
    if last is not None and any(scene.blocks[n].look[2] for at in last.ids for n in scene.figures[at].blocks):
        raise Unclear  # it may be one of its blocks
    if last is None or len(last.ids) != 1 or ref.kind == "table":
        raise Unclear
    figure = scene.figures[last.ids[0]]
    if ref.kind == "block" and set(ref.ids) <= set(figure.blocks) and len(ref.ids) == 1:
        at = places(figure, (name,))
        if len(at) != 1 or figure.told or figure.placed.get(at[0], ref.ids[0]) != ref.ids[0]:
            raise Unclear
        figure.placed[at[0]] = ref.ids[0]
        scene.place = (figure.blocks, at[0])
        figure.sided |= name in {"left", "right"}
        return
    if name == "top" and ref.kind == "block":
        _on(scene, ref, Ref("block", _tops(scene, last)), "on", no=False)
    elif name in _SIDES:
        scene.facts.append(Fact(ref, _SIDES[name], last))
    else:
        raise Unclear


def _between(scene: Scene, ref: Ref, of: Phrase, said: Place) -> None:
    """Between two things, told one by one or as two."""
    if isinstance(of, Both) and len(of.parts) == 2:
        first, second = (resolve(scene, part) for part in of.parts)
    else:
        both = resolve(scene, of)
        if len(both.ids) != 2:
            raise Unclear
        first, second = (Ref(both.kind, [n]) for n in both.ids)
    if said.no or said.cm or ref.bound or first.kind == "patch" or second.kind == "patch":
        raise Unclear
    scene.facts.append(Fact(ref, "between", first, second))


def _place(scene: Scene, ref: Ref, target: Ref, said: Place) -> None:
    """A relation to something that is told."""
    name = said.relation
    if target.no:
        said, target = replace(said, no=not said.no), replace(target, no=False)
    if ref.kind in {"patch", "table"} or target.bound:
        raise Unclear
    if name in {"in", "on"} and target.kind == "patch":
        _on_patch(scene, ref, target, no=said.no)
        if said.how == "flat":
            _bare(scene, ref, Place("flat", no=said.no))
    elif name == "off" and target.kind == "patch":
        _on_patch(scene, ref, target, no=not said.no)
    elif name in {"off", "in", "opposite"}:
        raise Unclear
    elif name == "on" and target.kind == "table":
        if ref.kind != "block" or said.no:
            raise Unclear
        scene.facts += [Fact(Ref("block", [n]), "table") for n in ref.ids]
    elif name == "under":
        if ref.kind != "block" or len(ref.ids) != 1 or said.how == "somewhere":
            raise Unclear
        _on(scene, target, ref, "on", no=said.no)
    elif name == "on":
        _on(scene, ref, target, "somewhere above" if said.how == "somewhere" else "on", no=said.no)
    else:
        _beside(scene, ref, target, said)


def _on_patch(scene: Scene, ref: Ref, target: Ref, *, no: bool) -> None:
    if len(target.ids) != 1 or (ref.bound and no) or ref.bound == "most":
        raise Unclear
    if ref.kind == "figure":
        for at in ref.ids:
            scene.facts.append(Fact(Ref("block", scene.figures[at].blocks), "patch", target, no=no))
        return
    if no:
        scene.facts += [Fact(Ref("block", [n]), "patch", target, no=True) for n in ref.ids]
    else:
        scene.facts.append(Fact(Ref("block", ref.ids), "patch", target))
    scene.facts += [Fact(Ref("block", [n]), "patch", target, no=True) for n in ref.rest]


def _on(scene: Scene, ref: Ref, target: Ref, word: str, *, no: bool) -> None:
    """One on one, or one on each of as many."""
    if target.kind == "figure" and len(target.ids) == 1 and ref.kind == "block" and not no and word == "on":
        figure = scene.figures[target.ids[0]]
        if figure.kind != "tower" and len(ref.ids) > 1:
            scene.pending.append((ref.ids, figure.blocks))
            return
    if target.kind == "figure" or (target.kind == "block" and len(target.ids) > 1 and len(ref.ids) == 1):
        target = Ref("block", _tops(scene, target))
    upper = ref.ids
    if ref.kind == "figure":
        upper = []
        for at in ref.ids:
            scene.settle(scene.figures[at])
            upper.append(scene.figures[at].blocks[0])
    if target.kind != "block" or ref.bound in {"exactly", "most", "least"} or len(upper) != len(target.ids):
        raise Unclear
    if no and len(upper) > 1:
        raise Unclear
    if len(upper) > 1 and not (scene.alike(upper) or scene.alike(target.ids)):
        raise Unclear
    if any(n in scene.used for n in upper) and len(upper) > 1:
        raise Unclear
    for a, b in zip(upper, target.ids, strict=True):
        scene.facts.append(Fact(Ref("block", [a]), word, Ref("block", [b]), no=no))
        if word == "on" and not no and (tower := next((f for f in scene.figures if f.blocks[-1] == b), None)):
            if tower.implied:
                tower.blocks.append(a)
        elif word == "on" and not no and not any({a, b} & set(f.blocks) for f in scene.figures):
            scene.figures.append(Figure("tower", [b, a], told=True, implied=True))


def _beside(scene: Scene, ref: Ref, target: Ref, said: Place) -> None:
    """Sides, distances, touch."""
    if ref.bound or target.kind == "table":
        raise Unclear
    some = (
        [Ref(ref.kind, [n]) for n in ref.ids]
        if ref.each or said.no or said.relation in {"touch", "apart", "far"}
        else [ref]
    )
    several = len(target.ids) > 1
    others = [target]
    if said.relation in _SIDES and not said.no and not said.cm:
        some = [replace(ref, each=False)]
        target = replace(target, each=False)
    if target.each or (several and said.relation in {"apart", "far", "near"}) or (several and said.no):
        others = [Ref(target.kind, [n]) for n in target.ids]
    if several and said.relation == "touch" and not said.no:
        others = [Ref(target.kind, [n]) for n in target.ids]
    for a in some:
        for b in others:
            if set(_blocks(scene, a)) & set(_blocks(scene, b)) and a.kind == b.kind:
                raise Unclear
            scene.facts += _facts_beside(a, b, said)


def _facts_beside(a: Ref, b: Ref, said: Place) -> list[Fact]:
    how = {"directly": "directly ", "immediately": "immediately ", "somewhere": "somewhere ", "": ""}[said.how]
    bound = {"": "", "least": "at least ", "most": "at most ", "exactly": ""}[said.bound]
    far = [Fact(a, f"{bound}{said.cm:g} cm from", b, no=said.no)] if said.cm else []
    if said.relation in _SIDES:
        if said.no and (said.cm or said.how):
            raise Unclear
        return [Fact(a, f"{how}{_SIDES[said.relation]}", b, no=said.no), *far]
    if said.relation == "apart" and said.cm and not said.how:
        return far
    if said.cm or said.how == "somewhere":
        raise Unclear
    if said.relation in {"next", "near"}:
        return [Fact(a, _RELATIONS[said.relation], b, no=said.no)]
    if said.relation == "touch":
        return [Fact(a, "touch", b, no=said.no)]
    if said.relation == "far":
        return [Fact(a, "far from", b, no=said.no)]
    raise Unclear


def _blocks(scene: Scene, ref: Ref) -> list[int]:
    if ref.kind == "figure":
        return [n for at in ref.ids for n in scene.figures[at].blocks]
    return ref.ids if ref.kind == "block" else []
