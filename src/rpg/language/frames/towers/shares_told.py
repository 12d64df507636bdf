"""Several towers of one height of which it is told which colours each has, and at which end: "three towers of two from
three red and three blue blocks, none of them in a single color". They are told again one by one, where all ways to
build them so differ in nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations_with_replacement, pairwise, permutations, product

from rpg.language.frames.groups.shared import listed
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.shares_words import PATTERNS
from rpg.language.lexicon import COLORS

__all__ = ["PATTERNS", "told"]

Tower = tuple[str, ...]
"""The colours of its blocks from bottom to top."""
Way = tuple[Tower, ...]
_ANY = ""
"""Another colour than those that are told, where it is not told which blocks there are."""
_MOST_WAYS = 20000
_STOPS = frozenset({".", ";", "!", "?"})


@dataclass
class _Shares:
    """What is told. `said`: of which towers what is so: (who, how many of them, (what, of which colour), whether)."""

    count: int = 0
    size: int = 0
    stock: dict[str, int] = field(default_factory=dict)
    said: list[tuple[str, int, tuple[str, str], bool]] = field(default_factory=list)
    slots: int = 0


def told(pieces: Sequence[Piece]) -> str:
    """The towers in plain sentences.

    Raises:
        Unclear: it does not follow which blocks each of them has, and in which order.
    """
    if any(a.words.endswith(("there are", "there is")) and b.kind == "towers" for a, b in pairwise(pieces)):
        raise Unclear  # these may be there at the start
    shares = _gathered(pieces)
    ways = set(_ways(shares))
    if any(_all_or_one(what, ways) for *_, what, _ in shares.said) and ("turns", "") not in [x[2] for x in shares.said]:
        raise Unclear
    kinds = {tuple(sorted(tuple(sorted(tower)) for tower in way)) for way in ways}
    if len(kinds) != 1 or any(_ANY in tower for kind in kinds for tower in kind):
        raise Unclear
    return " ".join(f"Build {text}." for text in _one_by_one(kinds.pop(), ways))


def _all_or_one(what: tuple[str, str], ways: set[Way]) -> bool:
    """ "With green on top", where a tower has several green ones: all of them, or one?"""
    color, _, bare = what[1].partition(" ")
    return bare == "bare" and any(tower.count(color) > 1 for way in ways for tower in way)


def _gathered(pieces: Sequence[Piece]) -> _Shares:
    shares, who, waiting = _Shares(), ("", 0), list[tuple[tuple[str, str], bool]]()
    for piece in [*pieces, Piece("break", ".")]:
        if piece.kind == "towers" and (not piece.value or shares.count in (0, piece.value)):
            shares.count = piece.value or shares.count
        elif piece.kind == "size" and shares.size in (0, piece.value):
            shares.size = piece.value
        elif piece.kind == "lot" and not who[0] and piece.value[0] not in shares.stock:
            shares.stock[piece.value[0]] = piece.value[1]
        elif piece.kind == "who":
            who = piece.value
            shares.slots += who[0] == "slot"
            who = (who[0], shares.slots) if who[0] == "slot" else who
            shares.said += [(*who, what, so) for what, so in waiting]
            waiting = []
        elif piece.kind in ("told", "denied"):
            so = piece.kind == "told"
            waiting.append((piece.value, so))
            if (
                who[0]
                or not so
                or shares.count == 1
                or "always" in piece.words.split()
                or piece.words.startswith(("bottoms", "tops"))
            ):
                shares.said += [(*(who if who[0] else ("each", 0)), *waiting.pop())]
        elif piece.kind == "break" and piece.words in _STOPS:
            who = ("", 0)
            if waiting:
                raise Unclear  # of each of them, or of one?
        elif piece.kind not in ("glue", "break"):
            raise Unclear
    if not shares.count and shares.size:
        shares.count = sum(shares.stock.values()) // shares.size
    if shares.count == 1 and not shares.size:
        shares.size = sum(shares.stock.values())
    if not shares.count or shares.size < 2 or not shares.said or (shares.count == 1 and not shares.stock):
        raise Unclear
    return shares


def _ways(shares: _Shares) -> Iterator[Way]:
    """Every way to build the towers as it is told."""
    named = [color for *_, (_, of), _ in shares.said for color in of.split() if color in COLORS]
    looks = list(dict.fromkeys([*shares.stock, *named, *([] if shares.stock else [_ANY])]))
    if shares.stock and (sum(shares.stock.values()) != shares.count * shares.size or {*named} - {*shares.stock}):
        raise Unclear
    towers = [tower for tower in product(looks, repeat=shares.size) if _as_each(tower, shares, looks)]
    if len(towers) ** shares.count > _MOST_WAYS:
        raise Unclear
    for way in combinations_with_replacement(sorted(towers), shares.count):
        taken = Counter(color for tower in way for color in tower)
        if (not shares.stock or taken == shares.stock) and _as_told(way, shares, looks):
            yield way


def _as_each(tower: Tower, shares: _Shares, looks: Sequence[str]) -> bool:
    """Whether a tower is as it is told of each of them, or of none."""
    of_all = ((what, so) if who == "each" else (what, not so) for who, _, what, so in shares.said if who in _OF_ALL)
    return all(_holds(what, tower, looks) == so for what, so in of_all)


_OF_ALL = ("each", "none")


def _as_told(way: Way, shares: _Shares, looks: Sequence[str]) -> bool:
    """Whether so many of the towers are as it is told of these."""
    some = [(n, what, so) for who, n, what, so in shares.said if who == "exactly"]
    rest = [(what, so) for who, _, what, so in shares.said if who == "rest"]
    if shares.slots:
        slots = [(n, what, so) for who, n, what, so in shares.said if who == "slot"]
        if some or (shares.slots != shares.count and not rest):
            raise Unclear
        return any(
            all(_holds(what, one[n - 1], looks) == so for n, what, so in slots)
            and all(_holds(what, tower, looks) == so for what, so in rest for tower in one[shares.slots :])
            for one in permutations(way)
        )
    left = [tower for tower in way if not any(_holds(what, tower, looks) == so for _, what, so in some)]
    if rest and len(some) != 1:
        raise Unclear
    return all(sum(_holds(what, tower, looks) == so for tower in way) == n for n, what, so in some) and all(
        _holds(what, tower, looks) == so for what, so in rest for tower in left
    )


def _holds(what: tuple[str, str], tower: Tower, looks: Sequence[str]) -> bool:
    """Whether a tower is so."""
    kind, of = what
    color, _, more = of.partition(" ")
    match kind:
        case "top" | "bottom":
            return tower[-1 if kind == "top" else 0] == color
        case "single" | "mixed":
            return (len({*tower}) == 1) == (kind == "single")
        case "every":
            return {*tower} == {*looks}
        case "ends":
            return (tower[0] == tower[-1]) == (of == "same")
        case "turns":
            return _by_turns(tower)
        case "one each":
            return len(tower) == len(looks) == len({*tower})
        case "plain":
            return {*tower} == {color}
        case "capped":
            return {*tower[:-1]} == {color} and tower[-1] == more
        case "more":
            return tower.count(color) > int(more)
        case _:
            return tower.count(color) == int(more)


def _by_turns(tower: Tower) -> bool:
    return all(one != other for one, other in pairwise(tower))


def _one_by_one(kinds: Sequence[Tower], ways: set[Way]) -> list[str]:
    """Each tower, so that together they may be built in just these ways.

    Raises:
        Unclear: that is not told of one after the other.
    """
    for forms in product(*(_forms(kind) for kind in kinds)):
        if {tuple(sorted(way)) for way in product(*(orders for _, orders in forms))} == ways:
            return [text for text, _ in forms]
    raise Unclear


def _forms(kind: Tower) -> list[tuple[str, set[Tower]]]:
    """How blocks of these colours may be told to form a tower, and in which orders they then do."""
    orders = {*permutations(kind)}
    blocks = listed([f"{n} {color} block{'s' if n > 1 else ''}" for color, n in Counter(kind).items()])
    found = [(f"a tower of {blocks}", orders)]
    if len(orders) == 1:
        return found
    for end, at in (("top", -1), ("bottom", 0)):
        for color in dict.fromkeys(kind):
            found.append(
                (f"a tower of {blocks} with a {color} block at the {end}", {x for x in orders if x[at] == color})
            )
    for word, so in (("mirrored", lambda x: x == x[::-1]), ("alternating", _by_turns)):
        found.append((f"a tower of {blocks} with {word} colors", {*filter(so, orders)}))
    return [*found, *((f"a tower, from bottom to top: {', '.join(f'a {c} block' for c in x)}", {x}) for x in orders)]
