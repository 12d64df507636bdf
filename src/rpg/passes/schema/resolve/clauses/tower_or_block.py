""" "Two towers of three blocks. The red one must not touch the blue one.": towers, or blocks of theirs?"""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

from rpg.language.meaning import Amount, Chain, Coord, Meaning, Noun, Pattern, Structure, Traits, parts_of, replace
from rpg.passes.schema.resolve.things.world import refuse


def of_their_colors(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """Two towers of which no colours are told, and "the red one" and "the blue one" behind them: a red tower and a blue
    one.

    Raises:
        Refusal: "ambiguous", for "the red one" alone, which would be a tower or a block in one of them.
    """
    parts = [part for chain in chains for clause in chain.clauses for part in parts_of(clause)]
    if any(isinstance(part, Pattern) and part.unit == "stack" for part in parts):
        return chains  # "each of one color"
    several: Structure | None = None
    named: set[str] = set()
    ones: list[Noun] = []
    for part in parts:
        if isinstance(part, Structure) and part.plural and part.det == "bare" and not _colored(part):
            several = part
        if not isinstance(part, Noun | Structure) or getattr(part, "head", "") == "patch":
            continue
        if several is not None and isinstance(part, Noun) and _one(part) and not named & {*part.traits.colors}:
            ones.append(part)
        else:
            named |= {*part.traits.colors}
    colors = [*dict.fromkeys(one.traits.colors[0] for one in ones)]
    if several is None or not ones:
        return chains
    if several.amount != Amount(len(colors), len(colors)) or named & {*colors}:
        raise refuse("ambiguous", f"one of the {_NAMES.get(several.kind, several.kind)}s, or a block in one of them?",
                     ones[0].span, "say 'the red block', or which colour each has")  # fmt: skip
    whole = Coord(op="and", items=tuple(_in_color(several, color) for color in colors), span=several.span)
    those = {id(one): _in_color(several, one.traits.colors[0], one) for one in ones}
    return tuple(_changed(chain, {id(several): whole, **those}) for chain in chains)


_NAMES = {"stack": "tower"}


def _one(part: Noun) -> bool:
    """ "the red one"."""
    alone = (part.head, part.det, part.plural, part.part_of, part.conditions) == ("any", "the", False, None, ())
    return alone and len(part.traits.colors) == 1 and part.traits == Traits(colors=part.traits.colors)


def _in_color(several: Structure, color: str, one: Noun | None = None) -> Structure:
    """One of them, as it is built, or as it is spoken of."""
    if one is not None:
        return Structure(kind=several.kind, det="the", traits=Traits(colors=(color,)), span=one.span)
    traits = replace(several.traits, colors=(color,))
    return replace(several, det="a", amount=Amount(1, 1), plural=False, traits=traits)


def _changed(part: Any, into: dict[int, Meaning]) -> Any:
    """A meaning with others in the place of some of its parts."""
    if id(part) in into:
        return into[id(part)]
    if type(part) is tuple:
        return tuple(_changed(item, into) for item in part)
    if not isinstance(part, Meaning) or not is_dataclass(part):
        return part
    told = {field.name: getattr(part, field.name) for field in fields(part)}
    new = {
        name: _changed(value, into)
        for name, value in told.items()
        if isinstance(value, Meaning) or type(value) is tuple
    }
    return replace(part, **{name: value for name, value in new.items() if value is not told[name]})


def _colored(towers: Structure) -> bool:
    """Whether it is told of which colours they are, or their blocks."""
    return any(isinstance(part, Noun | Structure) and part.traits.colors for part in parts_of(towers))
