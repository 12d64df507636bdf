"""Names that a person reads against the instruction: classes, and the booleans of a success check."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Facing
from rpg.ir.schema import shortened
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import rename

LONGEST = 44
DIGITS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
RESERVED = frozenset({"self", "at_rest", "_success_check", "_fail_check"})

TEMPLATES = {
    "on_patch": "{a}_on_{patch}",
    "empty": "{patch}_empty",
    "clear": "{a}_clear",
    "adjacent": "{a}_adjacent_to_{b}",
    "apart": "{a}_apart_from_{b}",
    "distance": "{a}_distance_to_{b}",
    "between": "{a}_between_{b}_and_{c}",
    "closer": "{a}_closer_to_{b}_than_{c}",
    "equidistant": "{a}_as_far_from_{b}_as_{c}",
    "in_region": "{a}_in_{region}",
    "facing": "{block}_facing_{toward}",
    "shifted": "{a}_shifted_{toward}",
    "swapped": "{a}_and_{b}_swapped",
    "took_place": "{a}_in_place_of_{b}",
    "turned": "{block}_turned",
    "stack": "{blocks}_stacked",
    "towers": "{blocks}_in_towers",
    "row": "{blocks}_in_row",
    "grid": "{blocks}_in_grid",
    "pyramid": "{blocks}_in_pyramid",
    "staircase": "{blocks}_in_staircase",
    "figure": "{blocks}_form_{shape}",
    "group_by": "{groups}_in_groups",
    "spells": "{word}_spelled",
    "equation": "equation_true",
}
"""How the boolean of an atom is called; every other kind is "a kind b"."""
ORDERS = {
    "given": "_in_order",
    "label": "_alphabetically",
    "number": "_numerically",
    "rainbow": "_like_a_rainbow",
    "size": "_by_size",
    "alternating": "_alternating",
    "mirrored": "_mirrored",
    "together": "_equals_together",
}
"""What the boolean of a line or a stack says of its order."""
_FIELD = re.compile(r"\{(\w+)\}")
TURNS = {0.0: "upright", 180.0: "upside_down"}
"""What the boolean says of a symbol that is turned so many degrees."""


def class_name(task: str) -> str:
    """`red-on-yellow` -> `RedOnYellow`, `3-blocks-on-patch` -> `ThreeBlocksOnPatch`."""
    first, *others = task.split("-")
    first = DIGITS[int(first)] if first.isdecimal() and int(first) < len(DIGITS) else first
    name = "".join(part[:1].upper() + part[1:] for part in (first, *others))
    return name if name[:1].isalpha() and not keyword.iskeyword(name) else "Task" + name


def boolean_name(goal: g.Goal) -> str:
    """A readable name for the truth of `goal`; not yet unique."""
    match goal:
        case g.Not():
            return _tidy("not_" + boolean_name(goal.goal))
        case g.Always():
            return _tidy("always_" + boolean_name(goal.goal))
        case g.Count():
            return _tidy(_quantity(goal) + "_" + boolean_name(rename(goal.goal, {goal.var: ""})))
        case g.All() | g.Any() if not goal.goals:
            return "nothing_asked"
        case g.All() | g.Any():
            word = "_and_" if isinstance(goal, g.All) else "_or_"
            name = word.join(boolean_name(part) for part in goal.goals)
            return _tidy(name) if 0 < len(name) <= LONGEST else _tidy(f"{boolean_name(goal.goals[0])}{word}more")
        case g.Sequence():
            return "in_order"
        case _:
            return _tidy(_atom_name(goal))


def _quantity(goal: g.Count) -> str:
    low, high = goal.at_least, goal.at_most
    if high is None or high >= len(goal.over):
        return f"at_least_{_number(low)}"
    if low == high:
        return "none" if low == 0 else f"exactly_{_number(low)}"
    return f"at_most_{_number(high)}" if low == 0 else f"{_number(low)}_to_{_number(high)}"


def _number(value: int) -> str:
    return DIGITS[value] if value < len(DIGITS) else str(value)


def _atom_name(atom: g.Atom) -> str:
    fields = vars(atom)
    template = TEMPLATES.get(atom.kind)
    if template is None:
        template = (
            "{a}_" + atom.kind + ("_{b}" if fields.get("b", fields["a"]) != fields["a"] else "")
            if "a" in fields
            else atom.kind
        )
    if isinstance(atom, Facing) and atom.turn in TURNS and atom.toward in ("up", "viewer"):
        template = "{block}_" + TURNS[atom.turn]
    if isinstance(atom, Row | Stack):
        template += ORDERS.get(atom.order.by, "")
    if isinstance(atom, Stack) and atom.patch is not None:
        template += "_on_{patch}"
    return _FIELD.sub(lambda field: _words(fields[field[1]]), template)


def _words(value: object) -> str:
    """An operand in a few letters: one or two names, or what its members have in common."""
    if isinstance(value, str):
        return short(value)
    if isinstance(value, tuple) and value and all(isinstance(item, tuple) for item in value):
        return _words(tuple(name for item in value for name in item))
    try:
        found = members(value)
    except TypeError:
        return ""
    names = [short(name) for name in found if isinstance(name, str)]
    kind = _kind_of(names)
    if len(names) > 1 and kind not in ("letters", "blocks"):
        return f"{_number(len(names))}_{kind}"
    return "_and_".join(names) if len(names) <= 2 else kind


def collective(names: Iterable[str]) -> str:
    """What many blocks are called together."""
    return _tidy(_kind_of([short(name) for name in names]))


def _kind_of(names: list[str]) -> str:
    stems = {re.sub(r"_\d+$", "", name) for name in names}
    if len(stems) == 1:
        return f"{stems.pop()}_blocks"
    return "letters" if all(len(stem) == 1 for stem in stems) else "blocks"


def short(name: str) -> str:
    """`red_block_2` -> `red_2`, `A_block` -> `a`, `5_block` -> `five`."""
    name = re.sub(r"_block(?=_|$)", "", name).lower()
    first, _, rest = name.partition("_")
    if first.isdigit() and int(first) < len(DIGITS):
        first = DIGITS[int(first)]
    return f"{first}_{rest}" if rest else first


def _tidy(name: str) -> str:
    """A valid identifier that is not too long."""
    name = re.sub(r"[^a-z0-9_]+", "_", name.lower())
    name = shortened(re.sub(r"__+", "_", name).strip("_"), LONGEST, "_")
    if not name or not name[0].isalpha() or keyword.iskeyword(name):
        name = f"is_{name}".rstrip("_")
    return name


def unique(name: str, taken: Iterable[str]) -> str:
    """`name`, or `name_2`, `name_3` ... where it is taken."""
    used = set(taken) | RESERVED
    candidate, number = name, 1
    while candidate in used:
        number += 1
        candidate = f"{name}_{number}"
    return candidate
