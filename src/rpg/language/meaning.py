"""What words mean before anybody asks which blocks they speak of: small frozen records with spans.

A noun phrase with its adjuncts knows nothing of the other sentences; `resolve` turns these records into objects and a
goal. `cost` ranks readings: natural ones are free.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from operator import attrgetter
from typing import Any, NamedTuple, TypeVar, cast, dataclass_transform

from rpg.core.diagnostics import Span

R = TypeVar("R")


@dataclass_transform(frozen_default=True, kw_only_default=True)
def record(kind: type[R]) -> type[R]:
    """Makes a class a record. None is ever changed, which types tell and nothing at run time: a sentence makes hundreds
    of them, and one that defends itself takes several times as long to make."""
    return dataclass(slots=True, kw_only=True)(kind)


class Amount(NamedTuple):
    """How many: from `low` to `high` (None: no limit). `strict`: "exactly", "at least" ... was said."""

    low: int
    high: int | None
    strict: bool = False


class _Remembered:
    """Room for what is worked out once of a record that never changes: its hash, its whole cost, and what is inside."""

    __slots__ = ("_hash", "_inside", "_whole_cost")
    _hash: int
    _inside: tuple[Meaning, ...]
    _whole_cost: int

    def __init_subclass__(cls) -> None:
        cls.__hash__ = _Remembered.__hash__  # type: ignore[method-assign]

    def __hash__(self) -> int:
        known: int | None = getattr(self, "_hash", None)  # nothing is raised for those that have none
        if known is None:
            kind: Any = type(self)
            known = self._hash = hash((kind, _values(kind)(self)))
        return known


@record
class Meaning(_Remembered):
    """The root of every record."""

    span: Span
    cost: int = 0


@record
class Traits(_Remembered):
    """What a noun phrase says of each of its objects (colours and labels: of all of them together)."""

    colors: tuple[str, ...] = ()
    either: bool = False
    labels: tuple[str, ...] = ()
    open_ended: bool = False
    kind: str | None = None
    quality: str | None = None
    edge: float | None = None
    size: str | None = None
    scheme: str | None = None
    shape: str | None = None
    long: bool = False
    extent: tuple[float, float] | None = None
    matching: bool = False
    empty: bool = False
    rank: str | None = None
    extra: bool = False
    target: bool = False
    shade: str | None = None


@record
class Noun(Meaning):
    """Blocks or patches by description. `head`: "block", "patch", or "any" for "one" and bare adjectives.

    `det`: "a", "the", "all", "each", "any", "no", "both", "some", "other", "another", "bare". `part_of`: "two of ...".
    """

    head: str
    det: str = "bare"
    amount: Amount | None = None
    plural: bool = False
    traits: Traits = Traits()
    part_of: Meaning | None = None
    conditions: tuple[Meaning, ...] = ()


@record
class Size(Meaning):
    """Dimensions said after the noun: "three blocks high", "a base of 3 x 3"; `named` as rows, then columns."""

    what: str
    amount: Amount | None = None
    dims: tuple[int, ...] = ()
    named: bool = False


@record
class Structure(Meaning):
    """Something that blocks form. `size`: blocks along it; `dims`: its extents; `details`: adjuncts of its own."""

    kind: str
    det: str = "a"
    amount: Amount | None = None
    plural: bool = False
    dims: tuple[int, ...] = ()
    members: Meaning | None = None
    traits: Traits = Traits()
    details: tuple[Meaning, ...] = ()
    letter: str | None = None
    filled: bool | None = None
    upright: bool | None = None
    each_size: bool = False
    sizes: tuple[Size, ...] = ()

    def extent(self, *whats: str) -> int | None:
        """The plain number said of one of `whats` ("high", "rows" ...)."""
        found = next((s.amount for s in self.sizes if s.what in whats and s.amount is not None), None)
        return found.low if found is not None and found.low == found.high else None

    @property
    def size(self) -> Amount | None:
        """The first number said of its size."""
        return next((s.amount for s in self.sizes if s.amount is not None), None)


@record
class Coord(Meaning):
    """Several noun phrases joined by "and" or "or"."""

    op: str
    items: tuple[Meaning, ...]


@record
class Pronoun(Meaning):
    """ "it", "them", "each other", "one", "other": something mentioned before."""

    word: str


TOLD_HERE, OWNER = "all told here", "it that has"
"""Pronouns for all blocks that the sentence brought up so far, "put red on blue, but do it in the left half", and for
what the clause before spoke of, "it has a gray block on it"."""


@record
class TableTop(Meaning):
    """The table. `bare`: beside the patches on it."""

    bare: bool = False


@record
class PartOf(Meaning):
    """The top, bottom, middle ... of a structure, or an end of it; `part` "blocks": those at some of its `places`."""

    part: str
    whole: Meaning | None
    places: Meaning | None = None


@record
class Loc(Meaning):
    """A relation to a landmark (`second`: the other end of "between"). Distances in metres.

    `mods` among "directly", "immediate", "somewhere", "start" (where the episode finds it), "level" (on the table).
    """

    rel: str
    landmark: Meaning | None = None
    second: Meaning | None = None
    mods: tuple[str, ...] = ()
    low: float | None = None
    high: float | None = None
    measure: str = "centres"
    negated: bool = False


@record
class In(Meaning):
    """A region of the table. `vague`: it is not said of what this is a corner or an edge."""

    region: str
    negated: bool = False
    vague: bool = False


@record
class OrderBy(Meaning):
    """How the members of a line are ordered, or by what groups are told apart (`values`: those that were named)."""

    by: str
    items: tuple[Meaning, ...] = ()
    first: str | None = None
    attribute: str = "color"
    values: tuple[str, ...] = ()
    descending: bool = False
    reverse: bool = False


@record
class Toward(Meaning):
    """The side where an order begins ("from left to right": left), or an axis alone."""

    first: str | None = None
    axis: str | None = None


@record
class At(Meaning):
    """A place in the structure spoken of. `own`: that of one of its blocks, "the top one red"; `utmost`: "leftmost";
    `tip`: named as the one to which a figure narrows."""

    side: str
    index: int | None = None
    whole: str | None = None
    own: bool = False
    utmost: bool = False
    tip: bool = False


@record
class Places(Meaning):
    """Some places of a structure: "the first row" (`side` "first", `index` 1), "the two middle blocks", "each corner".

    `side` is a side, "first", "last", or "ends", "corners", "edge", "inner", "rest" (`beyond`: on this side of what was
    told); `unit` what is counted: "block", "row", "column", "half"; `several` of them, `of` so many such units."""

    side: str
    unit: str
    index: int | None = None
    several: int | None = None
    each: bool = False
    of: int | None = None
    beyond: str | None = None


@record
class Absolute(Meaning):
    """ "with the red block on top": a thing and what is said of it."""

    theme: Meaning
    adjuncts: tuple[Meaning, ...]


@record
class Using(Meaning):
    """ "with / from / using" the blocks to be used; `lead`: which of these words was said."""

    members: Meaning
    lead: str = ""


@record
class Into(Meaning):
    """ "into a tower", "in a row", "so that they form a circle"."""

    structure: Meaning


@record
class Pattern(Meaning):
    """ "each row a different colour": members of each unit agree; units differ if `different`."""

    unit: str
    different: bool = True
    attribute: str = "color"
    values: tuple[str, ...] = ()


@record
class Spacing(Meaning):
    """ "evenly", "touching", "5 cm apart" inside a structure."""

    kind: str
    low: float | None = None
    high: float | None = None


@record
class Manner(Meaning):
    """How a verb is meant: "upside down", "clockwise", "by 90 degrees", "upright"; values by kind."""

    kind: str
    value: str | float | None = None


@record
class Quality(Meaning):
    """A predicate adjective: "are blue", "is long", "of the same colour"."""

    traits: Traits
    negated: bool = False


@record
class That(Meaning):
    """ "so that ..." with the clauses that follow, or "without ..." (`kind` "without")."""

    kind: str
    clauses: Meaning


@record
class Clause(Meaning):
    """A verb (of the lexicon, "be", "exist") with its theme and adjuncts; `subject`: of whom it tells, if not it."""

    verb: str
    lemma: str = ""
    theme: Meaning | None = None
    adjuncts: tuple[Meaning, ...] = ()
    negated: bool = False
    mode: str = "command"
    word: Span | None = None
    subject: Meaning | None = None


@record
class Chain(Meaning):
    """Clauses in a row; `links[i]` joins clause i to the one before it: "and", "then", "or", "before", "after"."""

    clauses: tuple[Meaning, ...]
    links: tuple[str, ...]


def replace(one: R, **changes: Any) -> R:
    """A record like another but for some of its fields: `dataclasses.replace`, in a third of the time."""
    kind: Any = type(one)
    made: R = _copier(kind)(one)
    for name, value in changes.items():
        object.__setattr__(made, name, value)
    return made


@cache
def _copier(kind: Any) -> Callable[[Any], Any]:
    """Copies a record field by field, without what was worked out of it."""
    line = " put(made, '{0}', one.{0})" if kind.__dataclass_params__.frozen else " made.{0} = one.{0}"
    code = ["def copied(one):", " made = new(kind)", *(line.format(f.name) for f in fields(kind)), " return made"]
    made: dict[str, Any] = {"new": object.__new__, "put": object.__setattr__, "kind": kind}
    exec("\n".join(code), made)
    return cast(Callable[[Any], Any], made["copied"])


@cache
def _values(kind: Any) -> Callable[[Any], tuple[Any, ...]]:
    """What all fields of a kind of record hold."""
    return attrgetter(*[f.name for f in fields(kind)])


@cache
def _inner(kind: Any) -> tuple[str, ...]:
    """The fields of a kind of record that may hold others."""
    return tuple(f.name for f in fields(kind) if not _ATOMIC.issuperset(re.findall(r"\w+", str(f.type))))


_ATOMIC = frozenset({"int", "float", "str", "bool", "None", "tuple", "Span", "Amount", "Traits"})


def cost_of(meaning: Any) -> int:
    """The sum of the costs of a meaning and everything in it."""
    if isinstance(meaning, Meaning):
        whole: int | None = getattr(meaning, "_whole_cost", None)
        if whole is None:
            kind: Any = type(meaning)
            held = [getattr(meaning, name) for name in _inner(kind)]
            whole = meaning._whole_cost = meaning.cost + sum([cost_of(part) for part in held if part])
        return whole
    if isinstance(meaning, tuple) and not isinstance(meaning, Amount):
        return sum([cost_of(item) for item in meaning])
    return 0


def parts_of(meaning: Any) -> Sequence[Any]:
    """Every record inside `meaning`, itself first, in order of reading."""
    if isinstance(meaning, Meaning):
        inside: tuple[Any, ...] | None = getattr(meaning, "_inside", None)
        if inside is None:
            kind: Any = type(meaning)
            held = [getattr(meaning, name) for name in _inner(kind)]
            inside = meaning._inside = tuple([part for one in held if one for part in parts_of(one)])
        return (meaning, *inside)
    listed = meaning if isinstance(meaning, tuple) and not is_dataclass(meaning) else ()
    return [part for item in listed for part in parts_of(item)]
