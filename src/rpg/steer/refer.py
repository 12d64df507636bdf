"""Which objects of a task a phrase of an edit speaks of. What the task does not have is refused, never invented."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rpg.blocks.nouns import join
from rpg.blocks.traits import VOWELS, kind_of, symbol_of
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.structures import Figure, GroupBy, Towers
from rpg.ir.walk import names as mentions
from rpg.steer.absent import ambiguous, choices, diagnostic, missing
from rpg.steer.language import m
from rpg.steer.operations.guard import check_picked
from rpg.steer.view import NOUNS, Line, Shape, View

RANKS = {"top": -1, "bottom": 0, "left": 0, "right": -1, "front": 0, "back": -1, "last": -1, "base": 0}
AXES = {"top": "tower", "bottom": "tower", "left": "row", "right": "row", "front": "column", "back": "column"}
ALL_OF = frozenset({"them", "they", "these", "those", "all of them", "everything", "all", "themselves", "all of it"})
BOTH = frozenset({"both", "both of them", "the two", "those two", "these two", "the two of them"})
OTHERS = frozenset(
    {"the other one", "the others", "the other ones", "the rest", "others", "the other", "all others", "all the others"}
    | {"all the rest", "everything else", "the remaining ones", "the other two"}
)
LINE_NOUNS = {"stack": "tower", "row": "row", "column": "column"}


@dataclass(frozen=True)
class Found:
    """The objects of a phrase; the line or figure it named, if it named one."""

    names: tuple[str, ...]
    line: Line | None = None
    figure: Shape | None = None

    @property
    def whole(self) -> bool:
        """Whether the phrase meant a structure rather than single blocks."""
        return self.line is not None or self.figure is not None


def resolve(view: View, phrase: m.Meaning) -> Found:
    """The objects that `phrase` speaks of; raises Refusal where there are none, or where it could be several."""
    found = _resolved(view, phrase)
    if not found.names:
        raise missing(view, phrase.span, "")
    return found


def _resolved(view: View, phrase: m.Meaning) -> Found:
    match phrase:
        case m.Pronoun():
            return _pronoun(view, phrase)
        case m.Noun():
            return Found(_noun(view, phrase))
        case m.Structure():
            return _structure(view, phrase)
        case m.Coord():
            return Found(_several(view, phrase))
        case m.PartOf():
            return _part(view, phrase)
    raise Refusal(
        [Diagnostic(code="edit-unclear", message="this does not name a block", span=phrase.span, origin="steer")]
    )


def _several(view: View, phrase: m.Coord) -> tuple[str, ...]:
    """The objects of a list; of all but some, the rest."""
    first, *others = (resolve(view, item).names for item in phrase.items)
    if (
        isinstance(phrase.items[0], m.Pronoun)
        and phrase.op == "and"
        and any(set(names) <= set(first) for names in others)
    ):
        told, hint = "these are among the blocks that were named before", "say what is to be done with each of them"
        raise Refusal([diagnostic("ambiguous-object", phrase.span, told, hint)])
    if phrase.op == "and":
        return tuple(dict.fromkeys(name for names in (first, *others) for name in names))
    if phrase.op == "except":
        return tuple(name for name in first if not any(name in names for names in others))
    told = "this leaves open which blocks are meant"
    raise Refusal([diagnostic("ambiguous-object", phrase.span, told, "name one of them, or join them with 'and'")])


def exists(view: View, phrase: m.Meaning) -> bool:
    """Whether the task has what `phrase` speaks of."""
    try:
        return bool(resolve(view, phrase).names)
    except Refusal:
        return False


def _pronoun(view: View, phrase: m.Pronoun) -> Found:
    line, figure = view.main_line(), view.main_figure()
    if line is not None and line.node is None and line.kind != "tower":
        line = None
    structure = Found(line.members, line) if line else Found(figure.members, None, figure) if figure else None
    if phrase.word in OTHERS:
        rest = tuple(name for name in view.world.blocks if name not in view.focus)
        if rest:
            return Found(rest)
        raise missing(view, phrase.span, phrase.word)
    if phrase.word in BOTH and (parties := _two_parties(view)):
        return Found(parties, None, structure.figure if structure else None)
    if phrase.word in BOTH:
        two = view.focus if len(view.focus) == 2 else structure.names if structure else view.busy
        if len(two) != 2:
            raise ambiguous(view, phrase.span, tuple(two), phrase.word)
        return structure if structure and set(structure.names) == set(two) else Found(tuple(two))
    if phrase.word.startswith("the "):
        raise ambiguous(view, phrase.span, tuple(view.world.blocks), phrase.word)
    if phrase.word in ALL_OF:
        if len(view.focus) > 1 and not structure:
            return Found(view.focus)
        return structure or Found(view.busy or tuple(view.world.blocks))
    if structure and (not view.focus or len(view.focus) > 1):
        return structure
    if view.focus:
        return Found(view.focus[-1:])
    if len(view.world.blocks) == 1:
        return Found(tuple(view.world.blocks))
    raise ambiguous(view, phrase.span, tuple(view.world.blocks), phrase.word)


def _two_parties(view: View) -> tuple[str, ...]:
    """The blocks of the two towers, rows or groups of a task that has two; none where it has not."""
    for figure in view.figures:
        node = figure.node
        if isinstance(node, Towers) and 2 in (node.count, len(node.heights or ())):
            return figure.members
        if isinstance(node, GroupBy) and len(node.groups) == 2:
            return figure.members
    lines = view.lines if not view.figures else ()
    return tuple(name for line in lines for name in line.members) if len(lines) == 2 else ()


def _structure(view: View, phrase: m.Structure) -> Found:
    """The phrase "the tower", "the row", "the pyramid": the last one of its kind that was mentioned."""
    wanted = LINE_NOUNS.get(phrase.kind)
    lines = [line for line in view.lines if wanted == line.kind or (phrase.kind == "row" and line.kind == "column")]
    figures = [figure for figure in view.figures if _is_kind(phrase.kind, figure)]
    if phrase.kind == "pile" and not figures:
        lines = [line for line in view.lines if line.kind == "tower"]
    words = [line for line in view.lines if line.node is not None and line.node.kind == _WORDS.get(phrase.kind)]
    found = [Found(line.members, line) for line in (words or lines)] + [Found(f.members, None, f) for f in figures]
    if phrase.members is not None and len(found) > 1:
        named = set(resolve(view, phrase.members).names)
        found = [each for each in found if named <= set(each.names)] or found
    if not found:
        kinds = sorted({noun_of(view, line) for line in view.lines} | {NOUNS[type(f.node)] for f in view.figures})
        hint = f"the task builds {join(['a ' + kind for kind in kinds])}" if kinds else "name the blocks instead"
        raise Refusal([diagnostic("no-such-object", phrase.span, f"the task has no {phrase.kind} like this", hint)])
    if phrase.plural:
        return Found(tuple(name for each in found for name in each.names), None, found[-1].figure)
    found = _described(view, phrase, found) or found
    recent = [each for each in found if set(each.names) & set(view.focus)]
    chosen = (recent or found)[-1]
    _check_described(view, phrase, chosen)
    return chosen


def _described(view: View, phrase: m.Structure, found: Sequence[Found]) -> list[Found]:
    """Of several structures those whose blocks are all as the phrase says; else the only one with most of them so."""
    told = [phrase.traits, phrase.members.traits if isinstance(phrase.members, m.Noun) else m.Traits()]
    share = []
    for each in found:
        blocks = [name for name in each.names if name in view.world.blocks]
        fitting = sum(all(matches(view, name, traits) for traits in told) for name in blocks)
        share.append(fitting / max(1, len(blocks)))
    every = [each for each, part in zip(found, share, strict=True) if part == 1.0]
    most = [each for each, part in zip(found, share, strict=True) if part > 0.5]
    return every or (most if len(most) == 1 and sum(part > 0.0 for part in share) == 1 else [])


def _check_described(view: View, phrase: m.Structure, found: Found) -> None:
    """Refuse a structure of another size, or of other blocks, than the phrase says."""
    members = phrase.members if isinstance(phrase.members, m.Noun) else None
    size = phrase.size or (members.amount if members is not None else None)
    if size is not None and phrase.kind in ("stack", "row", "column", "circle") and size.low != len(found.names):
        told = f"it has {len(found.names)} blocks, not {size.low}"
        raise Refusal([diagnostic("no-such-object", phrase.span, told, "say how many it has, or leave that out")])
    for traits in (phrase.traits, members.traits if members is not None else m.Traits()):
        fits = [matches(view, name, traits) for name in found.names if name in view.world.blocks]
        if sum(fits) * 2 > len(fits) and traits.colors and not traits.labels:
            continue
        if not all(matches(view, name, traits) for name in found.names if name in view.world.blocks):
            told = "its blocks are not all like this"
            raise Refusal([diagnostic("no-such-object", phrase.span, told, "leave out what its blocks look like")])


_WORDS = {"word": "spells", "equation": "equation"}
_FIGURES = {
    "grid": ("grid",), "wall": ("grid",), "square": ("grid", "figure"), "pyramid": ("pyramid",),
    "staircase": ("staircase",), "pile": ("group_by", "towers"), "stack": ("towers",), "cube": ("grid",),
    "checkerboard": ("grid",), "rectangle": ("grid", "figure"),
    "circle": ("figure",), "triangle": ("figure",), "plus": ("figure",),
    "set": ("group_by",),
}  # fmt: skip


def _is_kind(kind: str, figure: Shape) -> bool:
    if figure.node.kind not in _FIGURES.get(kind, ("figure",) if kind in ("letter", "shape", "figure") else ()):
        return False
    return not isinstance(figure.node, Figure) or kind in ("letter", "shape", "figure", figure.node.shape)


def noun_of(view: View, line: Line) -> str:
    """What a line is called: a tower, a row, a word."""
    return NOUNS.get(type(line.node), line.kind) if line.node is not None else line.kind


def _part(view: View, phrase: m.PartOf) -> Found:
    """The phrase "the top of the tower": the block there."""
    whole = resolve(view, phrase.whole) if phrase.whole is not None else None
    line = whole.line if whole else view.main_line()
    if line is None or not line.ordered:
        raise Refusal(
            [
                diagnostic(
                    "edit-unclear",
                    phrase.span,
                    f"it is not settled which block is at the {phrase.part}",
                    "name the block",
                )
            ]
        )
    if phrase.part == "middle" and len(line.members) % 2 == 0:
        raise missing(view, phrase.span, "")
    index = {"middle": len(line.members) // 2}.get(phrase.part, RANKS.get(phrase.part, -1))
    return Found((line.members[index],))


def _noun(view: View, phrase: m.Noun) -> tuple[str, ...]:
    if phrase.part_of is not None:
        return _some_of(view, phrase)
    check_picked(phrase)
    pool: Sequence[str] = tuple(view.world.patches if phrase.head == "patch" else view.world.blocks)
    found = tuple(name for name in pool if matches(view, name, phrase.traits))
    if not found and phrase.head == "any" and phrase.traits.colors:
        found = tuple(name for name in view.world.patches if matches(view, name, phrase.traits))
    for condition in phrase.conditions:
        found = tuple(name for name in found if _placed(view, name, condition))
    if phrase.traits.extra:
        found = tuple(name for name in found if name in view.idle)
    if phrase.det == "other":
        found = tuple(name for name in found if name not in view.focus) or found
    if phrase.traits.rank:
        found = _ranked(view, found, phrase)
    if not found:
        raise missing(view, phrase.span, "")
    return _counted(view, found, phrase)


def _counted(view: View, found: tuple[str, ...], phrase: m.Noun) -> tuple[str, ...]:
    """As many as the phrase says: "the" is all there are of the number said, "a" is any one of look-alikes."""
    amount = phrase.amount.low if phrase.amount else None
    every = phrase.plural or phrase.det in ("all", "each", "both") or phrase.traits.extra
    if phrase.det in ("a", "another", "some", "any") or (phrase.det == "bare" and amount is not None):
        wanted = amount or 1
        if len(found) < wanted:
            raise missing(view, phrase.span, "")
        if len({view.world.look.get(name, (name,)) for name in found}) == 1:
            return found[len(found) - wanted :]
        if len(found) > wanted:
            raise ambiguous(view, phrase.span, found, "")
        return found
    if amount is not None and amount != len(found):
        shown = tuple(name for name in found if symbol_of(view.world, name) == str(amount))
        if len(shown) == 1 and phrase.det == "the" and phrase.head == "any" and phrase.traits == m.Traits():
            return shown
        counted = f"there are {len(found)} such blocks, not {amount}"
        raise Refusal([diagnostic("ambiguous-object", phrase.span, counted, choices(view, found))])
    if len(found) > 1 and not every and amount is None:
        recent = [name for name in found if name in view.focus[-1:]]
        if len(recent) != 1:
            raise ambiguous(view, phrase.span, found, "")
        return tuple(recent)
    return found


def _some_of(view: View, phrase: m.Noun) -> tuple[str, ...]:
    """The phrase "one of the red blocks", "two of them", "all of them"."""
    whole = resolve(view, phrase.part_of).names if phrase.part_of is not None else ()
    if phrase.det in ("all", "each", "both"):
        if phrase.amount is not None and phrase.amount.low != len(whole):
            counted = f"there are {len(whole)} such blocks, not {phrase.amount.low}"
            raise Refusal([diagnostic("ambiguous-object", phrase.span, counted, choices(view, whole))])
        return whole
    wanted = phrase.amount.low if phrase.amount else 1
    if wanted > len(whole):
        raise missing(view, phrase.span, "")
    if len({view.world.look.get(name, (name,)) for name in whole}) > 1 and wanted < len(whole):
        raise ambiguous(view, phrase.span, whole, "")
    return whole[len(whole) - wanted :]


def _ranked(view: View, found: tuple[str, ...], phrase: m.Noun) -> tuple[str, ...]:
    """The phrase "the top block", "the leftmost one", "the second block", "the biggest block"."""
    rank = phrase.traits.rank or ""
    if rank in ("largest", "smallest"):
        sizes = {name: view.world.edge[name] for name in found if name in view.world.edge}
        wanted = (max if rank == "largest" else min)(sizes.values(), default=0.0)
        return tuple(name for name, size in sizes.items() if size == wanted)
    lines = [line for line in view.lines if line.kind == AXES.get(rank, line.kind)] or list(view.lines)
    lines = [line for line in lines if line.ordered]
    recent = [line for line in lines if set(line.members) & set(view.focus)]
    lines = lines if phrase.plural else (recent or lines)[-1:]
    if not lines:
        raise Refusal(
            [
                diagnostic(
                    "edit-unclear", phrase.span, "it is not settled which block this is", "name its colour or letter"
                )
            ]
        )
    picked = [
        _nth([name for name in line.members if name in found] if rank.isdigit() else line.members, rank)
        for line in lines
    ]
    return tuple(name for name in picked if name in found)


def _nth(members: Sequence[str], rank: str) -> str:
    if rank.isdigit():
        return members[int(rank) - 1] if int(rank) <= len(members) else ""
    if rank == "middle":
        return members[len(members) // 2] if len(members) % 2 else ""
    return members[RANKS.get(rank, 0)]


def matches(view: View, name: str, traits: m.Traits) -> bool:
    """Whether an object has the colours, labels, kind and size that a phrase says."""
    asset = view.world.assets[name]
    if traits.colors and asset.color not in traits.colors:
        return False
    if name in view.world.patches:
        return traits.shape is None or getattr(asset, "shape", None) == traits.shape
    symbol = symbol_of(view.world, name)
    if traits.labels and symbol not in traits.labels:
        return False
    if traits.kind is not None and kind_of(symbol) != traits.kind and not (traits.kind == "symbol" and symbol):
        return False
    if traits.scheme == "some" and symbol:
        return False
    if traits.quality and not _of_quality(symbol, traits.quality):
        return False
    edge = view.world.edge[name]
    if traits.edge is not None and abs(edge - traits.edge) > 1e-6:
        return False
    edges = view.world.edge.values()
    if traits.size == "big":
        return edge == max(edges) > min(edges) or edge > 0.04
    if traits.size == "small":
        return edge == min(edges) < max(edges) or edge < 0.04
    return True


def _of_quality(symbol: str, quality: str) -> bool:
    if quality in ("vowel", "consonant"):
        return symbol.isalpha() and (symbol in VOWELS) == (quality == "vowel")
    return symbol.isdigit() and (int(symbol) % 2 == 1) == (quality == "odd")


def _placed(view: View, name: str, condition: m.Meaning) -> bool:
    """Whether the goal puts a block where a relative clause says it is: on something, under it, on a patch."""
    if not isinstance(condition, m.Loc) or condition.landmark is None:
        return True
    others = resolve(view, condition.landmark).names
    line = view.line_of((name,))
    if condition.rel in ("on", "above", "under") and line is not None and line.kind == "tower":
        at = line.members.index(name)
        near = line.members[:at] if condition.rel != "under" else line.members[at + 1 :]
        return bool(set(near) & set(others))
    return any(name in mentions(atom) and set(mentions(atom)) & set(others) for _, atom in view.atoms)
