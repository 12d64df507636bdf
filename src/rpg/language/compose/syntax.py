"""What the compositional reader makes of words: noun phrases, places, clauses.

Plain data; `nouns` and `statements` work out what it stands for.
"""

from __future__ import annotations

from dataclasses import dataclass

from rpg.language.compose.items import FIGURES
from rpg.language.compose.limbs import Limb


@dataclass(frozen=True, slots=True)
class Noun:
    """A noun phrase.

    `det`: "a", "the", "each", "all", "both", "no", "other", "another", "any", or "" for none. `bound`: "exactly",
    "least" or "most", of `count`. `noun`: "block", "patch", "table", a figure, a part, or "" where it is left out.
    `of`: the whole that it is a part of, or those that it is some of. `content`: what it is made of, told with the word
    `made`. `but`: those that are left out. `that`: what is so of those that are meant, and of no others; `besides`:
    what is told of them by the way; `near`: they were told right before, as "those three". `order`: "alphabetical",
    "ascending", "descending" or "any"; `way`: where a figure rises or points; `gaps`: how far apart the blocks
    of a line are told to be; `limbs`: the parts of a letter.
    """

    det: str = ""
    count: int = 0
    bound: str = ""
    color: str = ""
    ranks: tuple[str, ...] = ()
    nth: int = 0
    noun: str = ""
    many: bool = False
    size: tuple[int, ...] = ()
    word: str = ""
    of: Phrase | None = None
    content: Phrase | None = None
    made: str = ""
    but: Phrase | None = None
    that: tuple[Predicate, ...] = ()
    besides: tuple[Predicate, ...] = ()
    near: bool = False
    order: str = ""
    way: str = ""
    gaps: str = ""
    limbs: tuple[Limb, ...] = ()


@dataclass(frozen=True, slots=True)
class Label:
    """A block by the symbol on it."""

    label: str
    color: str = ""


@dataclass(frozen=True, slots=True)
class Pronoun:
    """ "it", "they", "them", "both"."""

    word: str


@dataclass(frozen=True, slots=True)
class Both:
    """Several phrases joined by "and"; `either`: by "or"; `no`: by "neither ... nor"."""

    parts: tuple[Phrase, ...]
    either: bool = False
    no: bool = False


@dataclass(frozen=True, slots=True)
class Chain:
    """ "blue over red": from top to bottom. `back`: as the other one that was told, but the other way round."""

    parts: tuple[Phrase, ...]
    back: bool = False


@dataclass(frozen=True, slots=True)
class Listing:
    """What each of several figures is made of."""

    parts: tuple[Phrase, ...]


Phrase = Listing | Noun | Label | Pronoun | Both | Chain


@dataclass(frozen=True, slots=True)
class Place:
    """A relation to something.

    `how`: "directly", "immediately", "somewhere", "respectively" or nothing; `cm` with `bound`: a distance;
    `no`: it is denied; `side`: where an order goes.
    """

    relation: str
    of: Phrase | None = None
    how: str = ""
    cm: float = 0.0
    bound: str = ""
    no: bool = False
    side: str = ""


@dataclass(frozen=True, slots=True)
class Made:
    """What is formed: "form a tower"."""

    figure: Phrase


@dataclass(frozen=True, slots=True)
class Looks:
    """What looks so: "is red", "is B"; `at`: at a place of it, "is red at the bottom"; `no`: it does not, told only of
    those that are meant."""

    like: Phrase
    at: str = ""
    no: bool = False


@dataclass(frozen=True, slots=True)
class InTurn:
    """Which of several colours each of several figures has at a place, from left to right."""

    at: str


@dataclass(frozen=True, slots=True)
class InLine:
    """Which of several towers in a row is where: ("tall", "middle")."""

    places: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Bears:
    """What lies on it: "carries a red block"; nothing for "stays free"."""

    what: Phrase | None
    place: Place | None = None
    each: bool = False


@dataclass(frozen=True, slots=True)
class Holds:
    """What is one of its blocks: "with a red block", "without any white". Told only of those that are meant."""

    what: Phrase
    no: bool = False


@dataclass(frozen=True, slots=True)
class Owns:
    """What is so of a part of it: "whose top block is yellow". Told only of those that are meant."""

    part: Noun
    said: Predicate


@dataclass(frozen=True, slots=True)
class Either:
    """One place or another: "on the patch or next to it"."""

    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Holding:
    """What something else is at: "the block that A is not on". Told only of those that are meant."""

    what: Phrase
    relation: str
    no: bool = False


@dataclass(frozen=True, slots=True)
class Shares:
    """Where each of several is: "one on its left and one on its right"."""

    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Reads:
    """Which word they show: "so it reads CAT"."""

    word: str


@dataclass(frozen=True, slots=True)
class Same:
    """What was said of something else ahead: "(A must not be on the mat,) but B must be"."""

    no: bool = False


@dataclass(frozen=True, slots=True)
class NotBoth:
    """Of two that "or" joins, the other one is not there."""


@dataclass(frozen=True, slots=True)
class Among:
    """Whether these are among those that were taken of several: "one of them must be the C", "but not both"."""

    no: bool = False


@dataclass(frozen=True, slots=True)
class Change:
    """What becomes of what is there.

    `how`: it is taken "out", "swap"ped, moved "to" an end or a place, "replace"d, "add"ed, taken "apart", or alone
    "move"d; the gap is "close"d, or the rest "keep" their order. `of`: from where, with what, or to which block;
    `side`: which end, or in which direction, where `steps` are counted; `only`: nothing else is moved.
    """

    how: str
    of: Phrase | None = None
    side: str = ""
    steps: int = 0
    only: bool = False


ALL = frozenset({"each", "all", "both"})
"""What is said of every one of several."""
OWN = "own"
"""The colour of what has that of the thing that it is put on: "a block of its own colour"."""
TOWER = Noun(det="a", noun="tower")
NOTHING = Noun(det="no", noun="block")
TOLD = frozenset({"", "so", "there", "seen", "start", "lies", "with", "in"})
"""The moods of what may be so at the start."""
STAY = Place("stay")
"""What is said of things that stay where they are."""
Predicate = (
    Among
    | Change
    | InLine
    | InTurn
    | Reads
    | Shares
    | NotBoth
    | Same
    | Place
    | Made
    | Looks
    | Bears
    | Holds
    | Holding
    | Owns
    | Either
)


@dataclass(frozen=True, slots=True)
class Clause:
    """What is said of something; no predicate: there is such a thing, or it is to be built.

    `mood`: "put" and "build" are commands, "so" says that it is so, "must" that it has to be, "there" what there is,
    "seen" what a picture shows, "reads" what one reads there, "start" and "end" what is so then, "may" what is allowed,
    "change" what becomes of what is there; "lies" tells what there is before that. `aside`: what is told between the
    subject and its verb. `first`, `later`: "first", "then". `other`: what else may be so instead. `only`: it is so of
    nothing else. `fronted`: the place is told ahead.
    """

    subject: Phrase
    predicates: tuple[Predicate, ...] = ()
    mood: str = ""
    aside: Clause | None = None
    first: bool = False
    later: bool = False
    other: Clause | None = None
    only: bool = False
    fronted: bool = False


def is_figure(phrase: Phrase, but: str = "") -> bool:
    """Whether a phrase tells a figure, alone or among others; one of another kind than `but`."""
    if isinstance(phrase, Both):
        return any(is_figure(part, but) for part in phrase.parts)
    return isinstance(phrase, Noun) and phrase.noun in FIGURES - {but}


def counted(phrase: Phrase) -> bool:
    """ "Three", "three blocks": no more than how many they are."""
    return isinstance(phrase, Noun) and phrase == Noun(count=phrase.count, noun="block", many=True)


def any_number(noun: Noun) -> bool:
    """ "Red blocks": as many as they are put on."""
    return bool(noun.color) and noun == Noun(color=noun.color, noun="block", many=True)


def on_an_end(said: Place) -> bool:
    """Whether "on" may be on top of an end, or at the end."""
    of = said.of
    while isinstance(of, Noun) and of.noun != "end":
        of = of.of
    return said.relation == "on" and isinstance(of, Noun) and said.how not in {"top", "directly"}


def changes(clause: Clause) -> bool:
    """Whether it changes what is there, so that this is how it is at the start."""
    turned = any(isinstance(said, Made) and _reversed(said.figure) for said in clause.predicates)
    return clause.mood == "change" or (clause.mood == "build" and turned)


def _reversed(figure: Phrase) -> bool:
    return isinstance(figure, Noun) and figure.order == "reversed"


def several(phrase: Phrase) -> bool:
    """Whether more than one block is told."""
    return not isinstance(phrase, Label | Noun) or (isinstance(phrase, Noun) and (phrase.many or phrase.count > 1))
