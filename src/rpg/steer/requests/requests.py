"""What an edit asks for, before anybody looks at the task: small frozen records with their places in the request."""

from __future__ import annotations

from dataclasses import dataclass

from rpg.core.diagnostics import Span
from rpg.steer.requests.language import m

NO_TRAITS = m.Traits()


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """The root of every record. `cost` ranks readings: natural ones are free."""

    span: Span
    cost: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Spot:
    """A place in a line: an end of it, its middle, or next to a member (`side` of `landmark`)."""

    side: str
    whole: m.Meaning | None = None


Place = Spot | m.Meaning


@dataclass(frozen=True, slots=True, kw_only=True)
class Add(Request):
    """New objects and where they go. `stay`: they must not be moved. `lacking`: only if the task has none like it."""

    theme: m.Meaning
    places: tuple[Place, ...] = ()
    stay: bool = False
    lacking: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Remove(Request):
    """Objects that leave the task; with `others`, all blocks but these."""

    theme: m.Meaning
    others: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Replace(Request):
    """`new` takes the place of `old` (None: of every block of the structure, or of the task)."""

    old: m.Meaning | None
    new: m.Meaning


@dataclass(frozen=True, slots=True, kw_only=True)
class Restyle(Request):
    """Objects get another colour, symbol or size. `scale`: bigger (> 1) or smaller. `plainly`: what was said can be
    nothing but that; a mere number could also be how many blocks there are. `former`: what they look like so far."""

    theme: m.Meaning | None
    traits: m.Traits = NO_TRAITS
    former: m.Traits = NO_TRAITS
    scale: float | None = None
    plainly: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Recount(Request):
    """A structure gets another number of blocks, or other dimensions. `lines`: these are its rows and columns, as they
    were called. `by`: so many more (or fewer); `times`: so many times as many. `what`: "blocks", "height", "length", or
    "number" where only a number was said."""

    theme: m.Meaning | None
    amount: int | None = None
    dims: tuple[int, ...] = ()
    lines: bool = False
    by: int | None = None
    times: float | None = None
    what: str = "blocks"
    of_them: bool = False

    def fewer_of(self, there: int) -> bool:
        """Whether "two of them" are some of those that are there, rather than how many there should be."""
        return self.of_them and self.amount is not None and self.amount < there


@dataclass(frozen=True, slots=True, kw_only=True)
class Reorder(Request):
    """A line or a figure is ordered anew. `how`: "reverse", "mirror", "label", "number", "color", "size", "given",
    "alternating", "mirrored", "together", "any", "steps". `of_doing`: the words are of the order in which things are
    done, where the task has one."""

    how: str
    theme: m.Meaning | None = None
    items: m.Meaning | None = None
    descending: bool = False
    first: str | None = None
    of_doing: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Keep(Request):
    """Objects that the other requests of the sentence leave where they are. `still`: they must not be moved at all.
    `place`: where they are and stay.
    """

    theme: m.Meaning
    still: bool = False
    place: Place | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Free(Request):
    """Objects that had to stay where they are need not do so any more."""

    theme: m.Meaning


@dataclass(frozen=True, slots=True, kw_only=True)
class Trade(Request):
    """Two objects (or groups) change places in the goal."""

    a: m.Meaning
    b: m.Meaning


@dataclass(frozen=True, slots=True, kw_only=True)
class Move(Request):
    """Objects of the task go elsewhere. `piled`: as a stack."""

    theme: m.Meaning
    place: Place
    piled: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Reshape(Request):
    """The same blocks form something else."""

    structure: m.Meaning
    theme: m.Meaning | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Loosen(Request):
    """Tolerances or gaps change: by a factor, or to a value in metres. `what`: "tolerance", "gap", "even" ...
    `bare`: the value is said without a bound, so that it takes the place of the one that there is."""

    what: str
    factor: float | None = None
    value: float | None = None
    low: float | None = None
    bare: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Copies(Request):
    """So many of the structure that is there."""

    amount: int
    kind: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Divide(Request):
    """All blocks get colours: so many this one, so many that one."""

    parts: tuple[tuple[int, str], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Closer(Request):
    """The relation that the goal has holds directly, or immediately."""

    rel: str
    mods: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Climb(Request):
    """A staircase goes up to a side."""

    to: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Some(Request):
    """What was asked of all is asked of so many. `bound`: "exactly", "at_least", "at_most"."""

    bound: str
    amount: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Enough(Request):
    """Fewer blocks will do: in what is built, or of those that something is asked of. `of_them`: of those there."""

    amount: int
    of_them: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Turn(Request):
    """A relation or a region points another way: `to` instead of `old`, among "left", "right", "front", "behind"."""

    to: str
    old: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Across(Request):
    """What is on one side, of something or of the table, is on the other one."""

    theme: m.Meaning | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Outliers(Request):
    """Groups trade members, so that each has so many strangers."""

    count: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Kinds(Request):
    """Blocks become a mixture of kinds in equal shares."""

    kinds: tuple[str, ...]
    theme: m.Meaning | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Group(Request):
    """Blocks are sorted into groups; `by` is None where the request leaves what tells them apart to the blocks."""

    by: str | None = None
    theme: m.Meaning | None = None
