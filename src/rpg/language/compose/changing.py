"""What becomes of a figure that is there: of which blocks it is then, and in which order."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rpg.language.compose.nouns import resolve
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Taken, Unclear
from rpg.language.compose.syntax import Change, Clause, Label, Noun, Phrase, Pronoun

_ENDS = {
    "tower": {"bottom": 0, "top": -1},
    "column": {"near": 0, "far": -1, "first": 0, "last": -1},
    **{kind: {"left": 0, "right": -1} for kind in ("row", "line", "word")},
}
_ONE = (Noun(noun="one"), Noun(count=1), Noun(count=1, noun="block"), Noun(det="a", noun="block"))
_READ = {"first": 0, "last": -1}
_FORWARD = {"right": ("row", "line", "word"), "up": ("tower",)}
_BACK = {"left": ("row", "line", "word"), "down": ("tower",)}


def change(scene: Scene, clause: Clause) -> None:
    """Puts what a command changes into the scene."""
    said = clause.predicates[0]
    if not isinstance(said, Change) or len(clause.predicates) > 1:
        raise Unclear
    scene.begin()
    _CHANGES[said.how](scene, clause.subject, said)


def _out(scene: Scene, subject: Phrase, said: Change) -> None:
    """Some blocks are taken from a figure."""
    left: list[int] = []
    if said.of is not None and isinstance(said.of, Noun) and said.of.noun == "end" and subject in _ONE:
        subject, said = said.of, replace(said, of=None)
    if said.of is not None:
        whole = resolve(scene, said.of)
        scene.begin()  # it is there
        if len(whole.ids) != 1 or (whole.fresh and whole.kind == "block"):
            raise Unclear
        left = [] if whole.kind == "figure" else whole.ids
    if subject == Noun(det="all", noun="block"):
        if not left or (under := scene.figure_of(left[0])) is None or under.kind != "tower":
            raise Unclear
        order = _order(scene, under)
        ids = order[order.index(left[0]) + 1 :]
        scene.mention(Ref("block", ids))
    else:
        ids = _of_top(scene, subject, said) or _blocks(scene, subject)
    figure = _figure_of(scene, ids)
    order = _from_top(figure, ids) or _order(scene, figure)
    if left and (figure.kind != "tower" or left[0] not in order):
        raise Unclear
    if left and min(map(order.index, ids)) < order.index(left[0]):
        raise Unclear
    kept = left or [n for n in order if n not in ids]
    if not ids or not kept or set(ids) & set(kept):
        raise Unclear
    looks = {scene.blocks[n].look for n in kept}
    if figure.kind != "tower" and any(scene.blocks[n].look in looks for n in ids):
        raise Unclear  # which of those that look alike is where then
    scene.changed.append(Taken(figure, ids, kept, scene.stage, rest=_rest(figure, said)))
    scene.moved = ids


def _rest(figure: Figure, said: Change) -> str:
    """What is left stays where it is, if nothing else is moved; of a tower that was built before, it is a tower."""
    built = figure.kind == "tower" and figure.stage >= 0
    return "stay" if said.only else "one" if built else ""


def _swap(scene: Scene, subject: Phrase, said: Change) -> None:
    """Two blocks take each other's places."""
    ids = _blocks(scene, subject)
    if said.of is not None:
        ids = [*ids, *_blocks(scene, said.of)]
    if len(ids) != 2 or scene.alike(ids):
        raise Unclear
    a, b = ids
    figures = [scene.figure_of(n) for n in ids]
    one = figures[0]
    if one is None or figures[1] is not one:
        if one is None and figures[1] is None:
            scene.facts.append(Fact(Ref("block", [a]), "swapped", Ref("block", [b])))
            return
        raise Unclear
    _next(scene, one, [b if n == a else a if n == b else n for n in _order(scene, one)])


def _to(scene: Scene, subject: Phrase, said: Change) -> None:
    """A block goes to another place of its figure."""
    ids = _it(scene) if subject == Pronoun("it") else _blocks(scene, subject)
    figure = _figure_of(scene, ids)
    order = _order(scene, figure)
    if len(ids) != 1 or len(order) < 2 or figure.kind not in _ENDS:
        raise Unclear
    if said.side in _READ and figure.kind != "column" and not (
        isinstance(subject, Noun) and (subject.nth or subject.ranks)
    ):  # fmt: skip
        raise Unclear  # the front of the table, or of the word
    others = [n for n in order if n != ids[0]]
    at = _place(scene, figure, order.index(ids[0]), others, said)
    after = [*others[:at], ids[0], *others[at:]]
    if [scene.blocks[n].look for n in after] == [scene.blocks[n].look for n in order]:
        raise Unclear
    _next(scene, figure, after)
    scene.kept = others


def _it(scene: Scene) -> list[int]:
    """ "(The red one at the right end.) Move it two places to the left": the one block that was spoken of."""
    spoken = {tuple(ref.ids) for ref in scene.before if ref.kind == "block" and len(ref.ids) == 1}
    if len(spoken) != 1:
        raise Unclear
    return list(spoken.pop())


def _place(scene: Scene, figure: Figure, now: int, others: list[int], said: Change) -> int:
    """How many of the others are ahead of the block then."""
    many = len(others)
    if said.of is not None:
        ref = resolve(scene, said.of)
        if ref.kind != "block" or len(ref.ids) != 1 or ref.ids[0] not in others or figure.kind in {"tower", "column"}:
            raise Unclear
        return others.index(ref.ids[0]) + (said.side == "after")
    if said.steps:
        step = said.steps if figure.kind in _FORWARD.get(said.side, ()) else -said.steps
        if step < 0 and figure.kind not in _BACK.get(said.side, ()):
            raise Unclear
        if not 0 <= now + step <= many:
            raise Unclear
        return now + step
    if said.side == "middle" and many % 2 == 0:
        return many // 2
    if said.side == "other" and now in {0, many}:
        return many - now
    ends = _ENDS[figure.kind] | (_READ if figure.kind in {"row", "line", "word"} else {})
    if said.side == "first" and figure.kind != "word" and not _reads(scene, figure):
        raise Unclear  # the front of the table, or of the row
    if said.side not in ends:
        raise Unclear
    return 0 if ends[said.side] == 0 else many


def _reads(scene: Scene, figure: Figure) -> bool:
    return all(scene.blocks[n].label for n in figure.blocks) or figure.kind == "column"


def _replace(scene: Scene, subject: Phrase, said: Change) -> None:
    """Other blocks take the places of some."""
    ids = _blocks(scene, subject)
    figure = _figure_of(scene, ids)
    order = _order(scene, figure)
    new = _new(scene, said.of, len(ids))
    there = dict(zip(ids, new, strict=True))
    _next(scene, figure, [there.get(n, n) for n in order])
    scene.moved = new


def _add(scene: Scene, subject: Phrase, said: Change) -> None:
    """A further block goes to an end of a figure."""
    built = [figure for figure in scene.figures if figure.kind in _ENDS]
    if len(built) != 1 or said.side in {"middle", "other"}:
        raise Unclear
    figure = built[0]
    if scene.wanted and figure.stage == scene.stage:
        raise Unclear  # "line up three blocks and put one at the left end": one more, or on top of it
    order = _order(scene, figure)
    new = _new(scene, subject, 1)
    ends = _ENDS[figure.kind] | (_READ if figure.kind in {"row", "line", "word"} else {})
    if said.side not in ends or (said.side == "first" and not _reads(scene, figure)):
        raise Unclear
    _next(scene, figure, [*new, *order] if ends[said.side] == 0 else [*order, *new])


def _new(scene: Scene, phrase: Phrase | None, count: int) -> list[int]:
    """Blocks that are no part of anything: further ones, or such as lie by themselves."""
    if isinstance(phrase, Noun) and phrase.color and phrase.noun == "one":
        phrase = replace(phrase, noun="block")
    if isinstance(phrase, Noun) and phrase.color and phrase.many and not phrase.count and phrase.det == "":
        phrase = replace(phrase, count=count)
    if not isinstance(phrase, Noun | Label):
        raise Unclear
    many = len(scene.blocks)
    if isinstance(phrase, Noun) and phrase.det == "a" and phrase.color and not phrase.count and count == 1 and any(
        block.color == phrase.color for block in scene.blocks
    ):  # fmt: skip
        ref = Ref("block", scene.new_blocks(1, phrase.color), fresh=True)
    else:
        ref = resolve(scene, phrase)
    if ref.kind != "block" or len(ref.ids) != count or ref.bound or ref.either or ref.no:
        raise Unclear
    if any(n < many and scene.figure_of(n) is not None for n in ref.ids):
        raise Unclear
    return ref.ids


def _apart(scene: Scene, subject: Phrase, said: Change) -> None:
    """Each block of a tower goes on the table."""
    ref = resolve(scene, subject)
    ids = [n for at in ref.ids for n in scene.figures[at].blocks] if ref.kind == "figure" else ref.ids
    figure = _figure_of(scene, ids)
    if figure.kind != "tower" or set(figure.blocks) != set(ids):
        raise Unclear
    scene.facts += [Fact(Ref("block", [n]), "table") for n in ids]


def _move(scene: Scene, subject: Phrase, said: Change) -> None:
    """This alone is moved."""
    ids = _blocks(scene, subject)
    figure = scene.figure_of(ids[0])
    others = [n for n in (figure.blocks if figure else range(len(scene.blocks))) if n not in ids]
    if not others or (figure is not None and not set(ids) <= set(figure.blocks)):
        raise Unclear
    if figure is not None and figure.kind == "tower" and _order(scene, figure)[-len(ids) :] != sorted(
        ids, key=figure.blocks.index
    ):  # fmt: skip
        raise Unclear
    scene.facts += [Fact(Ref("block", [n]), "moved") for n in ids]
    scene.facts.append(Fact(Ref("block", others), "stay"))
    scene.moved = ids


def _close(scene: Scene, subject: Phrase, said: Change) -> None:
    """What is left is one figure again."""
    if not scene.changed:
        raise Unclear
    taken = scene.changed[-1]
    if isinstance(subject, Noun) and subject.noun == "word":
        labels = "".join(scene.blocks[n].label for n in taken.kept)
        if labels != subject.word or taken.figure.kind not in {"word", "row", "line"}:
            raise Unclear
    elif taken.figure.kind == "tower":
        raise Unclear
    scene.changed[-1] = taken._replace(rest="one")


def _keep(scene: Scene, subject: Phrase, said: Change) -> None:
    """What is left stays in its order."""
    if not scene.changed and not scene.kept:
        raise Unclear
    kept = scene.changed[-1].kept if scene.changed else scene.kept
    if isinstance(subject, Noun) and subject.det == "other":
        if subject.color or subject.of or (subject.count and subject.count != len(kept)) or subject.noun == "patch":
            raise Unclear
    elif sorted(_blocks(scene, subject)) != sorted(kept):
        raise Unclear
    if scene.changed:
        scene.changed[-1] = scene.changed[-1]._replace(rest="one")


_CHANGES: dict[str, Callable[[Scene, Phrase, Change], None]] = {
    "out": _out, "swap": _swap, "to": _to, "replace": _replace, "add": _add, "apart": _apart, "move": _move,
    "close": _close, "keep": _keep,
}  # fmt: skip


def finish(scene: Scene) -> None:
    """What is left of the figures that blocks were taken from, once all is told of it."""
    for taken in scene.changed:
        facts = len(scene.facts)
        _finish(scene, taken)
        scene.facts[facts:] = [replace(fact, stage=taken.stage) for fact in scene.facts[facts:]]
    if scene.changed:
        scene.facts.sort(key=lambda fact: fact.said == "stay")
    scene.changed = []


def _finish(scene: Scene, taken: Taken) -> None:
    figure, ids, kept = taken.figure, taken.ids, taken.kept
    stays = {n for fact in scene.facts if fact.said == "stay" for n in fact.a.ids}
    if taken.rest == "one" and len(kept) > 1:
        if _from_top(figure, ids) and not scene.alike(kept):
            raise Unclear  # in any order
        _next(scene, figure, kept, stage=taken.stage)
        if figure.kind == "tower":
            return
    tower = figure.kind == "tower"
    order = _from_top(figure, ids) or figure.blocks
    if tower and taken.rest != "one" and sorted(order[order.index(kept[-1]) + 1 :]) != sorted(ids):
        raise Unclear  # what becomes of those above it
    said = "somewhere above" if tower else "apart"
    scene.facts += [Fact(Ref("block", [a]), said, Ref("block", [b]), no=tower) for a in ids for b in kept]
    if (taken.rest == "stay" or (not tower and taken.rest != "one")) and not set(kept) <= stays:
        scene.facts.append(Fact(Ref("block", kept), "stay"))


def _is_some(phrase: Phrase) -> bool:
    """ "One of them": any of several."""
    return isinstance(phrase, Noun) and phrase.of is not None and phrase.count > 0 and phrase.det != "the"


def _of_top(scene: Scene, subject: Phrase, said: Change) -> list[int]:
    """ "(Take) one block off the tower", "two of its blocks": of those that look alike, the ones on top."""
    if not isinstance(subject, Noun) or not subject.count or subject.bound or said.of is None:
        return []
    if subject not in {Noun(count=subject.count), Noun(count=subject.count, noun="block", many=subject.many)}:
        return []
    whole = resolve(scene, said.of)
    figure = scene.figures[whole.ids[0]] if whole.kind == "figure" and len(whole.ids) == 1 else None
    if (
        figure is None
        or figure.kind != "tower"
        or not scene.alike(figure.blocks)
        or subject.count >= len(figure.blocks)
    ):
        return []
    scene.begin()
    return list(scene.mention(Ref("block", _order(scene, figure)[-subject.count :])).ids)


def _blocks(scene: Scene, phrase: Phrase) -> list[int]:
    some = _is_some(phrase)
    told = [figure.told for figure in scene.figures]
    ref = resolve(scene, phrase)
    if ref.kind != "block" or ref.bound or ref.no or ref.either or ref.fresh:
        raise Unclear
    scene.begin()  # what is told of here is there, too
    if some and (figure := scene.figure_of(ref.ids[0])) is not None and not told[scene.figures.index(figure)]:
        raise Unclear  # any of them, at any of their places
    return list(ref.ids)


def _figure_of(scene: Scene, ids: list[int]) -> Figure:
    figure = scene.figure_of(ids[0]) if ids else None
    if figure is None or not set(ids) <= set(figure.blocks):
        raise Unclear
    return figure


def _order(scene: Scene, figure: Figure) -> list[int]:
    """Its blocks in the order of their places, which has to be known."""
    loose = [n for n in figure.blocks if n not in figure.placed.values()]
    figure.free &= len(loose) > 1 and not scene.alike(loose)
    scene.settle(figure)
    if figure.kind in {"row", "line"} and not figure.sided and not scene.alike(figure.blocks):
        raise Unclear  # from which end?
    return list(figure.blocks)


def _from_top(figure: Figure, ids: list[int]) -> list[int]:
    """The blocks of a tower of which these are said to be on top, whatever the order of the others."""
    places = sorted(at for at, n in figure.placed.items() if n in ids)
    many = len(figure.blocks)
    if figure.kind != "tower" or not places or places != list(range(many - len(ids), many)):
        return []
    return [*(n for n in figure.blocks if n not in ids), *(figure.placed[at] for at in places)]


def _next(scene: Scene, figure: Figure, blocks: list[int], stage: int | None = None) -> None:
    """The figure as it is then."""
    kind = "row" if figure.kind == "word" else figure.kind
    size = figure.size if len(blocks) == len(figure.blocks) else ()
    if len(blocks) != len(figure.blocks) and kind not in _ENDS:
        raise Unclear
    after = replace(figure, kind=kind, blocks=blocks, size=size, word="", placed={}, barred={}, implied=False)
    after.told, after.alternates, after.in_order = True, False, False
    after.sided = figure.sided or kind in {"row", "line"}
    labels = "".join(scene.blocks[n].label for n in blocks)
    if figure.kind == "word" and len(labels) == len(blocks):
        after.kind, after.word, after.sided = "word", labels, False
    after.stage = scene.stage if stage is None else stage
    scene.figures.append(after)
