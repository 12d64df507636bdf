"""Speaker: how a text refers to objects, and the forms of its verbs."""

from __future__ import annotations

import re
import string
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from rpg.blocks.nouns import article, bare, join, number
from rpg.blocks.state import World
from rpg.ir.node import Highest, Lowest, Operand, members

_COLOR = re.compile(r"[a-z]+ block")
_SYMBOL = re.compile(r"[A-Z0-9] block")
_LABEL = re.compile(r"([A-Z0-9+*/=]|minus) block")


class Inexpressible(Exception):
    """A goal that refers to look-alike blocks in a way that no short phrase tells apart: which `noun` needs numbers."""

    def __init__(self, noun: str) -> None:
        super().__init__(f"which of the {_plural(noun)} is meant?")
        self.noun = noun


@dataclass
class Speaker:
    """Speaks of one task. `modal` "must" makes goals of statements ("must be"), "" leaves them ("is").

    `aliases` are phrases for names that stand for something else (the counted block of a `Count`), some of them
    `plural`. `numbered`: look-alikes that are told apart by number, "red block 1". `known` are the sets of look-alikes
    spoken of already, which "the other one" and "another" lean on; where `exact`, such a phrase would say too little
    (in what is denied, counted or always so). `together`: what look-alikes of which
    all were spoken of at once are called. `figures`: what structures are called, by their blocks, where the text
    has spoken of them. `always`: statements are of every moment, "must never touch".
    """

    world: World
    modal: str = ""
    negated: bool = False
    aliases: dict[str, str] = field(default_factory=dict)
    numbered: frozenset[str] = frozenset()
    exact: bool = False
    always: bool = False
    plural: set[str] = field(default_factory=set)
    known: list[frozenset[str]] = field(default_factory=list)
    together: set[str] = field(default_factory=set)
    figures: dict[frozenset[str], str] = field(default_factory=dict)

    def be(self, operand: Operand | str) -> str:
        """The form of "to be" that agrees with `operand`."""
        verb = "is" if self.single(operand) else "are"
        adverb = self._adverb()
        return f"{self.modal}{adverb} be" if self.modal else f"{verb}{adverb}"

    def do(self, operand: Operand | str, many: str, one: str) -> str:
        """The form of another verb: `do(a, "touch", "touches")`."""
        adverb = self._adverb()
        if self.modal:
            return f"{self.modal}{adverb} {many}"
        if self.negated and not self.always:
            return f"does not {many}" if self.single(operand) else f"do not {many}"
        return f"{adverb} {one if self.single(operand) else many}".strip()

    def _adverb(self) -> str:
        if self.always:
            return " never" if self.negated else " always"
        return " not" if self.negated else ""

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

    @contextmanager
    def strictly(self) -> Iterator[None]:
        """No "a red block" for one of several for a while."""
        before, self.exact = self.exact, True
        yield
        self.exact = before

    @contextmanager
    def at_all_times(self) -> Iterator[None]:
        """Statements of every moment for a while."""
        self.always = True
        yield
        self.always = False

    def the(self, operand: Operand | str) -> str:
        """A noun phrase for one or several objects, for a tower or for what tops it."""
        if isinstance(operand, Lowest | Highest):
            known = self.figures.get(frozenset(members(operand)))
            return known or f"the tower of {self._listed(members(operand))}"
        return self._listed(members(operand))

    def ordered(self, blocks: tuple[str, ...], ranks: tuple[tuple[str, ...], ...]) -> str:
        """Blocks whose order is told behind: "the four blocks" where these are all there are and it lists each."""
        told = sorted(name for rank in ranks for name in rank) == sorted(blocks)
        if told and len(blocks) > 2 and set(blocks) == set(self.world.blocks) and all(map(self.unique, blocks)):
            return f"the {number(len(blocks))} blocks"
        return self.the(blocks)

    def like(self, names: Iterable[str]) -> list[str]:
        """Blocks by their look alone: "a red block", "two blue blocks", "the green block" where all such are meant."""
        groups: dict[str, int] = {}
        for name in names:
            groups[self.noun(name)] = groups.get(self.noun(name), 0) + 1
        return [
            self._whole(noun, count) if count == len(self._alike(noun)) else _some(noun, count)
            for noun, count in groups.items()
        ]

    def some(self, names: Iterable[str]) -> list[str]:
        """The objects as if never heard of: "a red block", "two blue blocks"."""
        counts: dict[str, int] = {}
        for name in names:
            noun = self.noun(name)
            counts[noun] = counts.get(noun, 0) + 1
        return [_some(noun, count) for noun, count in counts.items()]

    def noun(self, name: str) -> str:
        """What a block or patch is called without an article."""
        said = self.aliases.get(name) or bare(name, self.world)
        return "minus block" if said == "- block" else said

    def alike(self, names: Iterable[str]) -> bool:
        """Whether objects are called the same, and one of them is not told from another by a number."""
        nouns = {self.noun(name) for name in names}
        return len(nouns) == 1 and (nouns.isdisjoint(self.numbered) or len(self._alike(min(nouns))) == 2)

    def short(self, names: Iterable[str]) -> list[str]:
        """The colors or symbols alone, where they tell all there is to the looks of the blocks; else nothing."""
        nouns = [self.noun(name) for name in names]
        plain = any(all(form.fullmatch(noun) for noun in nouns) for form in (_COLOR, _SYMBOL))
        return [noun.removesuffix(" block") for noun in nouns] if plain else []

    def unique(self, name: str) -> bool:
        """Whether no other object is called so."""
        return len(self._alike(self.noun(name))) == 1

    def _listed(self, names: tuple[str, ...]) -> str:
        parts: dict[str, list[str]] = {}
        for name in names:
            parts.setdefault(self.noun(name), []).append(name)
        whole = join([noun.removesuffix(" block").replace("minus", "-") for noun in parts])
        if len(parts) > 1 and all(len(self._alike(noun)) == 1 for noun in parts):
            if all(_COLOR.fullmatch(noun) for noun in parts):
                return f"the {whole} blocks"
            if all(_LABEL.fullmatch(noun) for noun in parts):
                return f"the blocks {_run([noun.removesuffix(' block') for noun in parts]) or whole}"
        return join([said for noun, mine in parts.items() for said in self._references(noun, mine)])

    def _alike(self, noun: str) -> list[str]:
        return [name for name in self.world.assets if self.noun(name) == noun]

    def _references(self, noun: str, names: list[str]) -> list[str]:
        if names[0] in self.aliases:
            return [self.aliases[names[0]]]
        alike = self._alike(noun)
        if len(names) == len(alike):
            self.together.add(noun)
            return [self._whole(noun, len(names))]
        if noun in self.numbered:
            return [_numbered(noun, alike.index(name) + 1) for name in names]
        return [self._part(noun, frozenset(names), alike)]

    def _whole(self, noun: str, count: int) -> str:
        return f"the {noun}" if count == 1 else f"the {number(count)} {_plural(noun)}"

    def _part(self, noun: str, chosen: frozenset[str], alike: list[str]) -> str:
        """Some of several look-alikes: "a red block", "another red block", "the other two red blocks"."""
        spoken = [known for known in self.known if known <= set(alike)]
        if (
            (spoken and (noun in self.together or _LABEL.fullmatch(noun)))
            or self.exact
            or any(chosen & known for known in spoken)
        ):
            raise Inexpressible(noun)
        self.known.append(chosen)
        count, left = len(chosen), len(alike) - sum(len(known) for known in spoken)
        if not spoken:
            return _some(noun, count)
        if left == count:
            return f"the other {noun}" if count == 1 else f"the other {number(count)} {_plural(noun)}"
        return f"another {noun}" if count == 1 else f"another {number(count)} {_plural(noun)}"


def _run(labels: list[str]) -> str:
    """Letters or digits without a gap: "A to F"; nothing for fewer than four, which are as short as a list."""
    if len(labels) < 4 or not any("".join(sorted(labels)) in row for row in (string.ascii_uppercase, string.digits)):
        return ""
    return f"{min(labels)} to {max(labels)}"


def _some(noun: str, count: int) -> str:
    return f"{article(noun)} {noun}" if count == 1 else f"{number(count)} {_plural(noun)}"


def _numbered(noun: str, index: int) -> str:
    """ "red block 2", and "the 7 block number 2": two symbols in a row would be two labels."""
    return f"the {noun} number {index}" if _LABEL.fullmatch(noun) else f"{noun} {index}"


def _plural(noun: str) -> str:
    """ "red blocks", and 'blocks labelled "O"': a symbol in front of a plural reads like a number or a word."""
    if _LABEL.fullmatch(noun):
        return f'blocks labelled "{noun.removesuffix(" block")}"'
    return noun + ("es" if noun.endswith(("ch", "x")) else "s")
