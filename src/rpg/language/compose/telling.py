"""A scene told in plain sentences, which the grammar reads and everything behind it checks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from rpg.blocks.nouns import article, join, number
from rpg.language import lexicon
from rpg.language.compose.changing import finish
from rpg.language.compose.facing import check_facing
from rpg.language.compose.kept_clear import keep_clear
from rpg.language.compose.lined import FROM_LEFT, IN_A_ROW, IN_ORDER, IN_ROW_NEXT, told_by_neighbours
from rpg.language.compose.places_of import DRAWN, columns, steps
from rpg.language.compose.scene import Block, Fact, Figure, Patch, Ref, Scene, Unclear

_PALETTE = (*lexicon.RAINBOW, "brown", "black", "gray", "white")
_MOST = 30
_MANY = 7
"""Of so many blocks that look alike not each one can be told apart."""


def tell_all(scenes: Sequence[Scene]) -> tuple[str, list[str]]:
    """What scenes have in common, and what is so in one or another of them; and each of them by itself."""
    for scene in scenes:
        finish(scene)
    if not any(scene.facts or scene.figures for scene in scenes):
        raise Unclear
    _check_told_of(scenes)
    told = set[int]().union(*map(_told, scenes))
    if len(scenes) == 1:
        return (text := " ".join(tell(scenes[0], told))), [text]
    ways = list({tuple(tell(scene, told)): None for scene in scenes})
    if len({way[0] for way in ways}) > 1 or any(scene.stage for scene in scenes):
        raise Unclear
    common = [said for said in ways[0] if all(said in way for way in ways)]
    rest = [[_small(said).rstrip(".") for said in way if said not in common] for way in ways]
    if not all(rest):
        raise Unclear
    either = _sentence(f"either {', or '.join(map(' and '.join, rest))}")
    return " ".join([*common, either]), [" ".join(way) for way in ways]


def _told(scene: Scene) -> set[int]:
    """The blocks of which something is told."""
    return scene.told_of("block").union(*(figure.blocks for figure in scene.figures))


def tell(scene: Scene, told_of: set[int]) -> list[str]:
    """All that a scene has, block by block, figure by figure, fact by fact; nothing is said but of those `told_of`."""
    if scene.pending:
        raise Unclear
    if not scene.blocks or len(scene.blocks) > _MOST or not (scene.facts or scene.figures):
        raise Unclear
    check_facing(scene)
    _color_in(scene)
    keep_clear(scene)
    told_by_neighbours(scene)
    figures = [figure for figure in scene.figures if not figure.implied]
    last = max((*(figure.stage for figure in figures), *(fact.stage for fact in scene.facts)), default=0)
    told = {stage: _of_stage(scene, figures, stage) for stage in range(-1, last + 1)}
    said = [_assets(scene, told_of), *(f"At the start, {_small(sentence)}" for sentence in told[-1])]
    if last > 0:
        _check_moved_once(scene)
        if not all(told[stage] for stage in range(last + 1)):
            raise Unclear
        parts = [" and ".join(_small(sentence).rstrip(".") for sentence in told[stage]) for stage in range(last + 1)]
        said += [f"{'Then' if n else 'First'}, {part}." for n, part in enumerate(parts)]
    elif last < 0:
        raise Unclear  # nothing but how it starts
    else:
        said += told[0]
    return list(dict.fromkeys(said))


def _check_moved_once(scene: Scene) -> None:
    """What is put somewhere and then elsewhere need not stay where it was: not told so here."""
    for fact in scene.facts:
        earlier = [f for f in scene.facts if 0 <= f.stage < fact.stage and f.b is not None]
        where = {n for f in earlier for ref in ((f.a,) if f.said in {"on", "patch"} else (f.a, f.b)) if ref
                 for n in ref.ids if ref.kind == "block"}  # fmt: skip
        if fact.a.kind == "block" and where & set(fact.a.ids):
            raise Unclear


def _of_stage(scene: Scene, figures: list[Figure], stage: int) -> list[str]:
    there = scene.asked and stage < 0  # what there is when something is asked for is there from the start
    said = [_figure(scene, figure) for figure in figures if figure.stage == stage or (there and figure.there)]
    return [*said, *(_fact(scene, fact) for fact in scene.facts if fact.stage == stage)]


def _small(sentence: str) -> str:
    """A sentence that goes on behind something."""
    return sentence if sentence[1:2] == " " else f"{sentence[0].lower()}{sentence[1:]}"


def _color_in(scene: Scene) -> None:
    """Gives blocks of no told look a colour that no other has: all of them one, so that any may stand for another."""
    free = next((c for c in _PALETTE if c not in {block.color for block in scene.blocks}), "")
    for block in scene.blocks:
        if not block.color and not block.label:
            if not free or scene.looked:
                raise Unclear
            block.color = free
    patches = [patch.color for patch in scene.patches]
    for patch in scene.patches:
        patch.color = patch.color or next(c for c in ("gray", *_PALETTE) if c not in patches)


def _check_told_of(scenes: Sequence[Scene]) -> None:
    """Of every block something has to be said, unless it is one of a lot of which something is."""
    told, blocks = set[int]().union(*map(_told, scenes)), scenes[0].blocks
    looks = {blocks[n].look for n in told if n < len(blocks)}
    spare = set.intersection(*(scene.spare for scene in scenes))
    if any(block.look not in looks and n not in spare for n, block in enumerate(blocks)):
        raise Unclear


def _look(block: Block) -> str:
    return " ".join(filter(None, (block.size, block.color, block.label)))


def _patch_name(patch: Patch) -> str:
    return f"{patch.shape} {patch.color}".strip()


def _assets(scene: Scene, told: set[int]) -> str:
    spare = [block for n, block in enumerate(scene.blocks) if n in scene.spare - told]
    said = [f"There {_are(block for n, block in enumerate(scene.blocks) if n not in scene.spare - told)}."]
    said += [f"There is {article(name := _patch_name(patch))} {name} patch." for patch in scene.patches]
    return " ".join([*said, *([f"There {_are(spare, 'also ')} as distractors."] if spare else [])])


def _are(blocks: Iterable[Block], also: str = "") -> str:
    """ "are two red blocks and a blue block"."""
    lots = Counter(map(_look, blocks))
    said = [
        f"{article(look)} {look} block" if many == 1 else f"{number(many)} {look} blocks" for look, many in lots.items()
    ]
    return f"{'are' if lots.total() > 1 else 'is'} {also}{join(said)}"


def _name(scene: Scene, n: int) -> str:
    block = scene.blocks[n]
    same = [m for m, other in enumerate(scene.blocks) if _look(other) == _look(block)]
    if len(same) == 1:
        return f"the {_look(block)} block"
    nth = same.index(n) + 1
    return f"{block.label} block number {nth}" if block.label else f"{_look(block)} block {nth}"


def _names(scene: Scene, ids: list[int]) -> str:
    return join([_name(scene, n) for n in ids])


def _operand(scene: Scene, ref: Ref) -> str:
    if ref.kind == "figure":
        if len(ref.ids) != 1:
            raise Unclear
        figure = scene.figures[ref.ids[0]]
        names = _names(scene, figure.blocks)
        return f"the tower of {names}" if figure.kind == "tower" else names
    if ref.kind == "patch":
        return f"the {_patch_name(scene.patches[ref.ids[0]])} patch"
    return _names(scene, ref.ids)


def _sentence(text: str) -> str:
    return f"{text[0].upper()}{text[1:]}."


def _fact(scene: Scene, fact: Fact) -> str:
    must = "must not" if fact.no else "must"
    a = _operand(scene, fact.a)
    if fact.said == "clear":
        if fact.no:
            raise Unclear
        return _sentence(f"nothing must be on {a}")
    if fact.said == "stay":
        return _sentence(f"{a} must stay where {'it is' if len(fact.a.ids) == 1 else 'they are'}")
    if fact.said == "moved":
        return _sentence(f"{a} must be moved")
    if fact.said == "table":
        return _sentence(f"{a} {must} be on the table")
    if fact.said in {IN_ORDER, FROM_LEFT}:
        order = f"in the order {', '.join(_name(scene, n) for n in fact.a.ids)}"
        way = f" from left to right {order}" if fact.said == FROM_LEFT else f" {order} in either direction"
        return _sentence(f"{a} must be {IN_A_ROW}{way}")
    if fact.b is None and fact.said.startswith("in a grid"):
        return _sentence(f"{a} must form {fact.said.removeprefix('in ')}")
    if fact.b is None and fact.said.endswith((IN_A_ROW, "on the table", "of the table")):
        return _sentence(f"{a} must be {fact.said}")
    if fact.said == "empty":
        return _sentence(f"{a} {must} be empty")
    assert fact.b is not None
    tower = _topped(scene, fact)
    b = _operand(scene, tower or fact.b)
    if fact.said == IN_ROW_NEXT:
        return _sentence(f"{a} must be at most 10 cm directly to the left of {b}")
    if fact.said == "touch":
        return _sentence(f"{a} {must} touch {b}")
    if fact.said.startswith("gap"):
        return f"There must be a {fact.said} between {a} and {b}."
    if fact.said == "swapped":
        return _sentence(f"{a} and {b} must be swapped")
    if fact.said == "apart":
        return _sentence(f"{a} {must} be apart from {b}")
    if fact.said == "between":
        assert fact.c is not None
        return _sentence(f"{a} {must} be between {b} and {_operand(scene, fact.c)}")
    return _sentence(f"{a} {must} be {'on' if fact.said == 'patch' else fact.said} {b}")


def _in_one_order(scene: Scene, figure: Figure) -> None:
    """What is in any order has one, where what is placed leaves no other."""
    loose = [n for n in figure.blocks if n not in figure.placed.values()]
    if not figure.placed or len(loose) < 2 or scene.alike(loose):
        figure.free = False
    elif figure.free and figure.kind in {"row", "line"} and list(figure.placed) == [1] and len(figure.blocks) == 3:
        figure.blocks, figure.placed = [loose[0], figure.placed[1], loose[1]], {}
        figure.free, figure.told, figure.sided = False, True, False  # each of the others is at one end


def _figure(scene: Scene, figure: Figure) -> str:
    """The sentence that says what blocks form."""
    _in_one_order(scene, figure)
    if figure.free:
        return _in_part(scene, figure)
    if figure.placed:
        scene.settle(figure)
    names, many = _names(scene, figure.blocks), len(figure.blocks)
    alone = figure.kind == "tower" or sum(bool(scene.blocks[f.blocks[0]].label) for f in scene.figures) == 1
    listed = _sorted(scene, figure) if figure.in_order and alone else f"in the order {_in_turn(scene, figure)}"
    told = figure.told and not _is_only_topped(scene, figure) and not _alike_at_start(scene, figure)
    order = f" {listed}" if told else ""
    if figure.kind == "tower":
        order = order and f" from bottom to top{order}"
        turns = " in alternating colors" if figure.alternates and not figure.told else ""
        return _sentence(f"{names} must {_tower(scene, figure, many)}{order}{turns}")
    if figure.kind in {"row", "line"}:
        side = f" from left to right{order}" if figure.sided else f"{order} in either direction"
        turns = " in alternating colors" if figure.alternates and not figure.told else ""
        return _sentence(f"{names} must be in a {figure.kind}{turns}{order and side}{figure.gaps}")
    if figure.kind == "column":
        if order:
            return _sentence(f"{names} must be in a row from front to back{order}{figure.gaps}")
        return _sentence(f"{names} must be in a column on the table{figure.gaps}")
    if figure.kind in {"word", "equation"}:
        row = f"be in a row from left to right {listed} and " if figure.sided and figure.stage >= 0 else ""
        shown = f"spell the word {figure.word}" if figure.kind == "word" else f"show the equation {figure.word}"
        return _sentence(f"{names} must {row}{shown}")
    if figure.kind == "group" and not figure.told:
        return _sentence(f"{names} must be in one group")
    if figure.kind in {"circle", "triangle"} and figure.told:
        raise Unclear
    if figure.kind == "pyramid" and figure.told and _differs_on_top(scene, figure):
        order = f" with {_name(scene, figure.blocks[0])} at the top"
    return _sentence(f"{names} must form {_form(figure, many)}{order}")


def _sorted(scene: Scene, figure: Figure) -> str:
    """The order of what is sorted by its symbols, which can be read then."""
    labels = [scene.blocks[n].label for n in figure.blocks]
    if labels[0].isalpha():
        return "in alphabetical order"
    return f"in {'ascending' if labels == sorted(labels) else 'descending'} numerical order"


def _differs_on_top(scene: Scene, pyramid: Figure) -> bool:
    """Whether nothing is told of its other blocks apart, which look alike."""
    top, rest = pyramid.blocks[0], pyramid.blocks[1:]
    return scene.alike(rest) and not scene.alike([top, rest[0]]) and not scene.told_of("block") & set(rest)


def _topped(scene: Scene, fact: Fact) -> Ref | None:
    """The tower that something lies on, where none of its blocks is told apart otherwise."""
    if fact.said != "on" or fact.b is None or fact.no:
        return None
    on = [n for n, figure in enumerate(scene.figures) if figure.blocks[-1:] == fact.b.ids]
    return Ref("figure", on) if len(on) == 1 and _is_only_topped(scene, scene.figures[on[0]]) else None


def _is_only_topped(scene: Scene, figure: Figure) -> bool:
    """Whether no block of a tower is told apart but the one on top, by what lies on it."""
    if figure.kind != "tower" or figure.implied or not scene.alike(figure.blocks):
        return False
    refs = [(ref, fact) for fact in scene.facts for ref in (fact.a, fact.b, fact.c) if ref and ref.kind == "block"]
    own = [(ref, fact) for ref, fact in refs if set(ref.ids) & set(figure.blocks) and len(ref.ids) < len(figure.blocks)]
    on_top = [
        fact.said == "on" and ref is fact.b and ref.ids == figure.blocks[-1:] and not fact.no for ref, fact in own
    ]
    return bool(own) and all(on_top)


def _alike_at_start(scene: Scene, figure: Figure) -> bool:
    """Whether no block of a large figure that is there is told apart."""
    many, alike = len(figure.blocks) >= _MANY, scene.alike(figure.blocks)
    own = [set(ref.ids) & set(figure.blocks) for ref in scene.refs("block")]
    return figure.stage < 0 and many and alike and not any(own)


def _in_turn(scene: Scene, figure: Figure) -> str:
    """The blocks one after the other; of many, those next to each other of which nothing else is told in any order."""
    if len(figure.blocks) < _MANY:
        return ", ".join(_name(scene, n) for n in figure.blocks)
    told = scene.told_of("block")
    runs: list[list[int]] = []
    for n in figure.blocks:
        if runs and not told & {n, runs[-1][0]} and scene.alike([n, runs[-1][0]]):
            runs[-1].append(n)
        else:
            runs.append([n])
    return ", then ".join(f"{_names(scene, run)}{' in no fixed order' * (len(run) > 1)}" for run in runs)


def _form(figure: Figure, many: int) -> str:
    """What figure it is, with the way in which its places are counted."""
    wide = columns(figure)
    down = " from top to bottom" if figure.told else ""
    drawn = " from its first drawn place on" if figure.told else ""
    if figure.kind == "wall":
        return f"a wall {number(wide)} blocks wide and {number(many // wide)} blocks high{down}"
    if figure.kind == "grid":
        by_row = " row by row" if figure.told else ""
        return f"a grid of {number(many // wide)} rows and {number(wide)} columns{by_row}"
    if figure.kind == "cube":
        return f"a {'x'.join(str(n) for n in figure.size)} cube{down}"
    if figure.kind == "pyramid" and steps(many):
        return f"a pyramid with a base of {number(steps(many))} blocks{down}"
    if figure.kind == "staircase":
        way = f" going up to the {figure.way}" if figure.way else ""
        return f"a staircase of {number(steps(many))} steps{way}{drawn}"
    if figure.kind in DRAWN:
        side = {"near": "front", "far": "back"}.get(figure.way, figure.way)
        ways = {"L": f" with its foot to the {side}", "U": f" open to the {side}", "T": f" with its stem to the {side}"}
        return f"a {figure.kind}{_lengths(figure)}{ways.get(figure.kind, '') if side else ''}{drawn}"
    if figure.kind == "plus":
        return "a plus sign"
    if figure.kind in {"circle", "triangle", "square"}:
        return {"circle": "a circle"}.get(figure.kind, f"the outline of a {figure.kind}")
    raise Unclear


def _lengths(figure: Figure) -> str:
    """How long the parts of a letter are, if this was told."""
    if len(figure.size) < 2:
        return ""
    long, other = map(number, figure.size)
    return {
        "T": f" with a bar of {long} blocks", "L": f" {long} blocks long",
        "U": f" {other} blocks wide and {long} blocks deep",
    }[figure.kind]  # fmt: skip


_LEFT_TO_RIGHT = ("at the left end", "at the right end", "from the left")
_ENDS = {
    "tower": ("at the bottom", "at the top", "from the bottom"), "row": _LEFT_TO_RIGHT, "line": _LEFT_TO_RIGHT,
    "column": ("at the front end", "at the back end", ""),
}  # fmt: skip
"""How the first and the last place is told, and from where the others are counted."""


def _in_part(scene: Scene, figure: Figure) -> str:
    """A figure of which it is said at some places alone what is there."""
    names, many = _names(scene, figure.blocks), len(figure.blocks)
    if figure.kind not in _ENDS or figure.gaps:
        raise Unclear
    form = _tower(scene, figure, many) if figure.kind == "tower" else f"be in a {figure.kind}"
    form += " on the table" if figure.kind == "column" else ""
    first, last, side = _ENDS[figure.kind]
    where = {0: first, many - 1: last}
    if many % 2:
        where[many // 2] = "in the middle"
    told = []
    for at, block in sorted(figure.placed.items()):
        if at not in where and not side:
            raise Unclear
        told.append(f"{_name(scene, block)} {where.get(at) or f'{lexicon.ORDINALS[at + 1].split()[0]} {side}'}")
    if not figure.sided and figure.kind in {"row", "line"} and set(figure.placed) - {many // 2 if many % 2 else -1}:
        raise Unclear  # from which end is not told
    return _sentence(f"{names} must {form}{f' with {join(told)}' if told else ''}")


def _tower(scene: Scene, figure: Figure, many: int) -> str:
    """A tower of exactly so many, unless something else lies on it or it stands on a block."""
    own = set(figure.blocks)
    for fact in scene.facts:
        if fact.said in {"on", "somewhere above"} and fact.b is not None and not fact.no:
            if set(fact.b.ids) & own and not set(fact.a.ids) & own:
                return "be stacked"
            if set(fact.a.ids) & own and not set(fact.b.ids) & own:
                return "be stacked"
    return f"form a tower of exactly {number(many)}"
