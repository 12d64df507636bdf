"""The versions of a family as requests refer to them, and which one a reference means."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod

from rpg.blocks.nouns import join
from rpg.blocks.state import World
from rpg.blocks.traits import kind_of, symbol_of
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Spells
from rpg.ir.walk import atoms
from rpg.steer.matching import matches
from rpg.steer.operations.guard import SELECTS, unused
from rpg.steer.refer import exists
from rpg.steer.requests.backrefs import Reference
from rpg.steer.requests.language import m
from rpg.steer.view import View

UNTOLD = frozenset({"some", "mixed"})


@dataclass(frozen=True)
class Past:
    """One version: its number, its parent's number, its task, and what was mentioned last when it was made."""

    number: int
    schema: TaskSchema
    parent: int | None = None
    focus: tuple[str, ...] = ()


@dataclass(frozen=True)
class History:
    """Every version of a family, and the number of the current one."""

    versions: tuple[Past, ...]
    head: int

    @property
    def current(self) -> Past:
        return self[self.head]

    def __getitem__(self, number: int) -> Past:
        return next(version for version in self.versions if version.number == number)

    def find(self, reference: Reference) -> Past:
        """The version that `reference` means; raises Refusal where there is none."""
        if reference.number is not None:
            return self._numbered(reference)
        if reference.base:
            return self[min(version.number for version in self.versions)]
        if reference.steps is not None:
            return self._back(reference)
        return self._described(reference)

    def latest_with(self, kind: str) -> Past | None:
        """The latest earlier version whose blocks are of a kind: the snapshot with the assets that a request needs."""
        for version in self._others():
            kinds = {_kind(version.schema, asset.name) for asset in version.schema.blocks}
            if kinds == {kind}:
                return version
        return None

    def _others(self) -> Sequence[Past]:
        """Versions other than the current one, latest first."""
        return [v for v in sorted(self.versions, key=lambda v: -v.number) if v.number != self.head]

    def _numbered(self, reference: Reference) -> Past:
        found = next((v for v in self.versions if v.number == reference.number), None)
        if found is None:
            numbers = join([str(v.number) for v in self.versions])
            raise _refused(reference, f"there is no version {reference.number}", f"the family has {numbers}")
        return found

    def _back(self, reference: Reference) -> Past:
        at = self.current
        for done in range(reference.steps or 0):
            if at.parent is None:
                steps = f"only {done} step{'s' if done != 1 else ''} back" if done else "nothing to undo"
                raise _refused(reference, f"version {self.head} has {steps}", "version 0 is the base")
            at = self[at.parent]
        return at

    def _described(self, reference: Reference) -> Past:
        for version in (*self._others(), self.current):
            if _fits(version.schema, reference):
                return version
        hint = "say its number: go back to version 0"
        raise _refused(reference, "no version of this task fits the description", hint)


def _kind(schema: TaskSchema, name: str) -> str:
    return kind_of(symbol_of(World(schema.assets), name))


def _fits(schema: TaskSchema, reference: Reference) -> bool:
    """Whether a version is what a reference describes."""
    view = View(schema)
    said = [*reference.marks, *(_traits(phrase) for phrase in _each(reference.description))]
    structures = [phrase for phrase in _each(reference.description) if isinstance(phrase, m.Structure)]
    if reference.without:
        return not any(exists(view, phrase) for phrase in reference.description)
    if not all(_has_structure(view, phrase) for phrase in structures):
        return False
    if not all(_has(view, traits) for traits in said if traits is not None):
        return False
    if not all(_as_many(view, phrase) for phrase in _each(reference.description)):
        return False
    if reference.part and not _at_the_end(view, reference.part, said[0] if len(said) == 1 else None):
        return False
    return not reference.only or _nothing_else(view, [traits for traits in said if traits is not None])


def _at_the_end(view: View, part: str, traits: m.Traits | None) -> bool:
    """Whether the tower has such a block on top, or at the bottom."""
    line = view.main_line()
    if line is None or line.kind != "tower" or not line.ordered or traits is None:
        return False
    return matches(view, line.members[-1 if part == "top" else 0], traits)


def _each(phrases: Sequence[m.Meaning]) -> list[m.Meaning]:
    return [item for phrase in phrases for item in (phrase.items if isinstance(phrase, m.Coord) else (phrase,))]


def _traits(phrase: m.Meaning) -> m.Traits | None:
    if isinstance(phrase, m.Noun):
        return phrase.traits
    if isinstance(phrase, m.Structure):
        return phrase.members.traits if isinstance(phrase.members, m.Noun) else phrase.traits
    return None


def _has(view: View, traits: m.Traits) -> bool:
    """Every colour, label and shape said is there, and blocks of the kind said make up the task."""
    if unused(traits, SELECTS | {"scheme"}) or traits.rank or traits.scheme not in (None, "some", "mixed"):
        return False
    if traits.shape is not None and not any(patch.shape == traits.shape for patch in view.schema.patches):
        return False
    if traits.long and not any(max(patch.size) >= 2 * min(patch.size) for patch in view.schema.patches):
        return False
    if traits.size is not None or traits.edge is not None or traits.quality is not None:
        sized = m.Traits(size=traits.size, edge=traits.edge, quality=traits.quality)
        if not any(matches(view, name, sized) for name in view.world.blocks):
            return False
    for color in traits.colors:
        if not any(asset.color == color for asset in view.schema.assets):
            return False
    symbols = {name: symbol_of(view.world, name) for name in view.world.blocks}
    if any(label not in symbols.values() for label in traits.labels):
        return False
    if (traits.kind is not None and not traits.labels) or traits.scheme in UNTOLD:
        kind = "plain" if traits.kind is None else traits.kind
        return all(kind_of(s) == kind or (kind == "symbol" and bool(s)) for s in symbols.values())
    return True


def _has_structure(view: View, phrase: m.Structure) -> bool:
    if phrase.kind == "word" and phrase.letter:
        return any(isinstance(atom, Spells) and atom.word == phrase.letter for atom in atoms(view.schema.goal))
    if not exists(view, phrase):
        return False
    from rpg.steer.refer import resolve

    names = resolve(view, phrase).names
    dims = phrase.dims or next((size.dims for size in phrase.sizes if size.dims), ())
    if len(dims) > 1 and prod(dims) != len(names):
        return False
    size = phrase.size or (phrase.members.amount if isinstance(phrase.members, m.Noun) else None)
    return size is None or len(names) == size.low


def _as_many(view: View, phrase: m.Meaning) -> bool:
    """Phrases such as "the three-block version", "when there were two red blocks"."""
    if not isinstance(phrase, m.Noun) or phrase.amount is None:
        return True
    fitting = [name for name in view.world.blocks if matches(view, name, phrase.traits)]
    return len(fitting) == phrase.amount.low if phrase.plural else bool(fitting)


def _nothing_else(view: View, said: Sequence[m.Traits]) -> bool:
    """Phrases such as "just red and blue": no block of another colour."""
    colors = {color for traits in said for color in traits.colors}
    if colors:
        return all(block.color in colors for block in view.world.blocks.values())
    return all(any(matches(view, name, traits) for traits in said) for name in view.world.blocks)


def _refused(reference: Reference, message: str, hint: str) -> Refusal:
    return Refusal(
        [Diagnostic(code="no-such-version", message=message, span=reference.span, hint=hint, origin="steer")]
    )
