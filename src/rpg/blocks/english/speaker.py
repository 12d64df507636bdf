"""Speaker: how a text refers to objects, and the forms of its verbs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from rpg.blocks.nouns import bare, join, number
from rpg.blocks.state import World
from rpg.ir.node import Highest, Lowest, Operand, members

_COLOR = re.compile(r"[a-z]+ block")
_LABEL = re.compile(r"[-A-Z0-9+*/=] block")


class Inexpressible(Exception):
    """A goal that refers to look-alike blocks in a way that no short phrase tells apart."""


@dataclass
class Speaker:
    """Speaks of one task. `modal` "must" makes goals of statements ("must be"), "" leaves them ("is").

    `aliases` are phrases for names that stand for something else (the counted block of a `Count`), some of them
    `plural`. `known` are the sets of look-alikes spoken of already, which "the other one" and "another" lean on.
    `figures`: what structures are called, by their blocks, where the text has spoken of them.
    """

    world: World
    modal: str = ""
    negated: bool = False
    aliases: dict[str, str] = field(default_factory=dict)
    plural: set[str] = field(default_factory=set)
    known: list[frozenset[str]] = field(default_factory=list)
    figures: dict[frozenset[str], str] = field(default_factory=dict)

    def be(self, operand: Operand | str) -> str:
        """The form of "to be" that agrees with `operand`."""
        if self.modal:
            return f"{self.modal} not be" if self.negated else f"{self.modal} be"
        verb = "is" if self.single(operand) else "are"
        return f"{verb} not" if self.negated else verb

    def do(self, operand: Operand | str, many: str, one: str) -> str:
        """The form of another verb: `do(a, "touch", "touches")`."""
        if self.modal:
            return f"{self.modal} not {many}" if self.negated else f"{self.modal} {many}"
        if self.negated:
            return f"does not {many}" if self.single(operand) else f"do not {many}"
        return one if self.single(operand) else many

    def single(self, operand: Operand | str) -> bool:
        """Whether the phrase for `operand` is singular."""
        if isinstance(operand, Lowest | Highest):
            return True
        return len(members(operand)) == 1 and self.plural.isdisjoint(members(operand))

    @contextmanager
    def speaking(self, modal: str) -> Iterator[None]:
        """Statements of another modality for a while."""
        before, self.modal = self.modal, modal
        yield
        self.modal = before

    def the(self, operand: Operand | str) -> str:
        """A noun phrase for one or several objects, for a tower or for what tops it."""
        if isinstance(operand, Lowest | Highest):
            known = self.figures.get(frozenset(members(operand)))
            return known or f"the tower of {self._listed(members(operand))}"
        return self._listed(members(operand))

    def one(self, name: str) -> str:
        """One object, whichever of those that look like it: "the blue block", "a red block"."""
        noun = self.noun(name)
        return f"the {noun}" if len(self._alike(noun)) == 1 else f"{_article(noun)} {noun}"

    def some(self, names: Iterable[str]) -> list[str]:
        """The objects as if never heard of: "a red block", "two blue blocks"."""
        counts: dict[str, int] = {}
        for name in names:
            noun = self.noun(name)
            counts[noun] = counts.get(noun, 0) + 1
        return [f"{_article(n)} {n}" if k == 1 else f"{number(k)} {_plural(n)}" for n, k in counts.items()]

    def noun(self, name: str) -> str:
        """What a block or patch is called without an article."""
        return self.aliases.get(name) or bare(name, self.world)

    def _listed(self, names: tuple[str, ...]) -> str:
        parts: dict[str, list[str]] = {}
        for name in names:
            parts.setdefault(self.noun(name), []).append(name)
        whole = join([noun.removesuffix(" block") for noun in parts])
        if len(parts) > 1 and all(len(self._alike(noun)) == 1 for noun in parts):
            if all(_COLOR.fullmatch(noun) for noun in parts):
                return f"the {whole} blocks"
            if all(_LABEL.fullmatch(noun) for noun in parts):
                return f"the blocks {whole}"
        return join([self._reference(noun, mine) for noun, mine in parts.items()])

    def _alike(self, noun: str) -> list[str]:
        return [name for name in self.world.assets if self.noun(name) == noun]

    def _reference(self, noun: str, names: list[str]) -> str:
        if names[0] in self.aliases:
            return self.aliases[names[0]]
        alike = self._alike(noun)
        count = len(names)
        if count == len(alike):
            return f"the {noun}" if count == 1 else f"the {number(count)} {_plural(noun)}"
        return self._part(noun, frozenset(names), alike)

    def _part(self, noun: str, chosen: frozenset[str], alike: list[str]) -> str:
        """Some of several look-alikes: "one of the three red blocks", "another red block", "the other two"."""
        spoken = [known for known in self.known if known <= set(alike)]
        if chosen in spoken or any(chosen & known for known in spoken):
            raise Inexpressible(f"which of the {_plural(noun)} is meant?")
        self.known.append(chosen)
        count, left = len(chosen), len(alike) - sum(len(known) for known in spoken)
        if not spoken:
            return f"{number(count)} of the {number(len(alike))} {_plural(noun)}"
        if left == count:
            return f"the other {noun}" if count == 1 else f"the other {number(count)} {_plural(noun)}"
        return f"another {noun}" if count == 1 else f"another {number(count)} {_plural(noun)}"


def _plural(noun: str) -> str:
    """ "red blocks", and "blocks labelled O": a symbol in front of a plural reads like a number or a word."""
    if _LABEL.fullmatch(noun):
        return f"blocks labelled {noun.removesuffix(' block')}"
    return noun + ("es" if noun.endswith(("ch", "x")) else "s")


def _article(noun: str) -> str:
    vowel = noun[0] in "aeio8" or (len(noun.split()[0]) == 1 and noun[0] in "AEFHILMNORSX")
    return "an" if vowel else "a"
