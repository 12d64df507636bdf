"""Which objects of a task a phrase of an edit speaks of. What the task does not have is refused, never invented."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.traits import symbol_of
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.structures import GroupBy, Towers
from rpg.ir.walk import names as mentions
from rpg.steer.absent import ambiguous, choices, diagnostic, missing
from rpg.steer.matching import matches
from rpg.steer.operations.guard import check_picked
from rpg.steer.requests.language import m
from rpg.steer.view import Line, View
from rpg.steer.wholes import Found, several_of, structure, structures_of

RANKS = {"top": -1, "bottom": 0, "left": 0, "right": -1, "front": 0, "back": -1, "last": -1, "base": 0}
AXES = {"top": "tower", "bottom": "tower", "left": "row", "right": "row", "front": "column", "back": "column"}
ALL_OF = frozenset({"them", "they", "these", "those", "all of them", "everything", "all", "themselves", "all of it"})
EVERYTHING = frozenset({"everything", "all", "all of it", "all of them"})
BOTH = frozenset({"both", "both of them", "the two", "those two", "these two", "the two of them"})
OTHERS = frozenset(
    {"the other one", "the others", "the other ones", "the rest", "others", "the other", "all others", "all the others"}
    | {"all the rest", "everything else", "the remaining ones", "the other two"}
)


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
            return structure(view, phrase, _members_named(view, phrase))
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
    built = Found(line.members, line) if line else Found(figure.members, None, figure) if figure else None
    if phrase.word in OTHERS:
        rest = tuple(name for name in view.world.blocks if name not in view.focus)
        wanted = {"the other one": 1, "the other": 1, "the other two": 2}.get(phrase.word, len(rest))
        if rest and (not view.focus or len(rest) != wanted):
            raise ambiguous(view, phrase.span, rest, phrase.word)
        if rest:
            return Found(rest)
        raise missing(view, phrase.span, phrase.word)
    if phrase.word in BOTH and (parties := _two_parties(view)):
        return Found(parties, None, built.figure if built else None)
    if phrase.word in BOTH:
        two = view.focus if len(view.focus) == 2 else built.names if built else view.busy
        if len(two) != 2:
            raise ambiguous(view, phrase.span, tuple(two), phrase.word)
        return built if built and set(built.names) == set(two) else Found(tuple(two))
    if phrase.word.startswith("the "):
        raise ambiguous(view, phrase.span, tuple(view.world.blocks), phrase.word)
    if phrase.word in ALL_OF:
        whole = phrase.word in EVERYTHING or (not view.focus and phrase.word != "themselves")
        if whole and built and set(built.names) != set(view.busy):
            return Found(view.busy)
        if len(view.focus) > 1 and not built:
            return Found(view.focus)
        if built and line and line.kind == "tower" and any(isinstance(shape.node, Towers) for shape in view.figures):
            raise ambiguous(view, phrase.span, view.busy, phrase.word)  # the blocks of one tower, or all the towers
        return built or Found(view.busy or tuple(view.world.blocks))
    if built and (not view.focus or len(view.focus) > 1):
        return built
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


def _members_named(view: View, phrase: m.Structure) -> tuple[str, ...]:
    """The blocks that a structure is said to be of, where there are several structures."""
    if phrase.members is None or len(view.lines) + len(view.figures) < 2:
        return ()
    return resolve(view, phrase.members).names


def lines_of(view: View, phrase: m.Meaning | None) -> list[Line]:
    """The lines that a phrase speaks of where it speaks of several: "both towers", "each row", "both"."""
    if isinstance(phrase, m.Structure) and several_of(phrase):
        wholes = structures_of(view, phrase, _members_named(view, phrase))
        return [each.line for each in wholes if each.line is not None]
    if not isinstance(phrase, m.Pronoun) or phrase.word == "it":
        return []
    found = _pronoun(view, phrase)
    lines = [line for line in view.lines if set(line.members) <= set(found.names)]
    return lines if len(lines) > 1 and not found.whole else []


def _part(view: View, phrase: m.PartOf) -> Found:
    """The phrase "the top of the tower": the block there."""
    if several := lines_of(view, phrase.whole):
        return Found(tuple(_at(view, phrase, line) for line in several))
    whole = resolve(view, phrase.whole) if phrase.whole is not None else None
    return Found((_at(view, phrase, whole.line if whole else view.main_line()),))


def _at(view: View, phrase: m.PartOf, line: Line | None) -> str:
    """The block at a place of a line."""
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
    return line.members[index]


def _noun(view: View, phrase: m.Noun) -> tuple[str, ...]:
    if phrase.det == "no":
        told, hint = "this names no block and no patch", "say 'not on the red patch'"
        raise Refusal([diagnostic("edit-unclear", phrase.span, told, hint)])
    if phrase.part_of is not None:
        return _some_of(view, phrase)
    check_picked(phrase)
    pool: Sequence[str] = tuple(view.world.patches if phrase.head == "patch" else view.world.blocks)
    found = tuple(name for name in pool if matches(view, name, phrase.traits))
    if not found and phrase.head == "any" and phrase.traits.colors:
        found = tuple(name for name in view.world.patches if matches(view, name, phrase.traits))
    found = _each_named(view, phrase, found)
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


def _each_named(view: View, phrase: m.Noun, found: tuple[str, ...]) -> tuple[str, ...]:
    """Blocks in the order in which a phrase lists their symbols; "D and A" where there is no D speaks of nothing."""
    labels, colors = phrase.traits.labels, phrase.traits.colors
    world = view.world
    several = len(labels) > 1 or (len(colors) > 1 and not phrase.traits.either)
    if not found or not several or phrase.det in ("a", "any", "some", "no"):
        return found
    if len(labels) > 1:
        if not set(labels) <= {symbol_of(world, name) for name in found}:
            raise missing(view, phrase.span, "")
        return tuple(sorted(found, key=lambda name: labels.index(symbol_of(world, name))))
    if not set(colors) <= {world.assets[name].color for name in found}:
        raise missing(view, phrase.span, "")
    return found


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
    wanted = phrase.amount.low if phrase.amount else 1
    if phrase.plural and wanted > 1 and len(lines) == 1 and rank in RANKS:
        members = lines[0].members
        return members[:wanted] if RANKS[rank] == 0 else members[-wanted:]
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
    return members[RANKS[rank]] if rank in RANKS else ""


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
