"""The things that statements are about: which have been told of, and which of them a name means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from rpg.language.frames.pieces import Piece, Unclear, number

_MANY = ("blocks", "cubes", "bricks", "boxes", "ones")
_NOUNS = ("block", "cube", "brick", "box")
_POINTING = ("the", "this", "that", "these", "those", "both", "all", "my", "our", "your")


@dataclass(frozen=True)
class Known:
    """Things that look alike, or one. `part`: how some of them are told of ("exactly 2 of the 3 red blocks")."""

    look: str
    count: int = 1
    patch: bool = False
    part: str = ""

    @property
    def rest(self) -> bool:
        """Whether they are all of a lot but those told of ahead."""
        return self.part.startswith("the other")

    @property
    def name(self) -> str:
        """The things as they are spoken of when they are known."""
        if self.part:
            return self.part
        if self.look.startswith(("letter", "number")) or self.patch:
            return f"the {self.look}"
        return f"the {self.look} block" if self.count == 1 else f"the {self.count} {self.look} blocks"

    @property
    def new(self) -> str:
        """The things as they are told of first."""
        article = "an" if self.look[0] in "aeiou" else "a"
        if self.look.startswith(("letter", "number")) or self.patch:
            return f"{article} {self.look}"
        return f"{article} {self.look} block" if self.count == 1 else f"{self.count} {self.look} blocks"


@dataclass
class Things:
    """What has been told of, in order; which of it stands in a statement, and in one of
    the start; how many of a lot a part
    of it is; what is told of without a noun, and may be a patch; whether others are spoken of that are not told."""

    known: list[Known] = field(default_factory=list)
    used: set[str] = field(default_factory=set)
    seen: set[str] = field(default_factory=set)
    parted: dict[str, int] = field(default_factory=dict)
    bare: set[str] = field(default_factory=set)
    others: bool = False

    def copied(self) -> Things:
        """The same, to be changed by itself."""
        return Things([*self.known], {*self.used}, {*self.seen}, {**self.parted}, {*self.bare}, self.others)

    @property
    def all_used(self) -> bool:
        """Whether something is said of each thing."""
        return {known.look for known in self.known} <= self.used | self.seen

    @property
    def unclear(self) -> bool:
        """Whether something may be a block or a patch: "put A on the red and B on the blue patch"."""
        return bool(self.bare) and any(known.patch for known in self.known)

    @property
    def told(self) -> str:
        """What there is."""
        names = [known.new for known in self.known]
        be = "is" if len(names) == 1 and self.known[0].count == 1 else "are"
        return f"There {be} {' and '.join([*([', '.join(names[:-1])] if len(names) > 1 else []), names[-1]])}."

    def use(self, *things: Known, start: bool = False) -> None:
        """Something is said of them.

        Raises:
            Unclear: it is said of some of a lot, of which something is said as a whole, or the other way round.
        """
        for thing in things:
            if not start and (thing.look in self.parted) != bool(thing.part):
                raise Unclear
        into = self.seen if start else self.used
        into |= {thing.look for thing in things}

    def only_patch(self) -> Known:
        """The one patch that there is."""
        return self._one([known for known in self.known if known.patch])

    def subjects(self, pieces: Sequence[Piece], objects: Sequence[Known]) -> list[Known]:
        """What a statement is about."""
        return self._meant(pieces, objects, subject=True)

    def objects(
        self, pieces: Sequence[Piece], subjects: Sequence[Known], *, on: bool, into: bool = False
    ) -> list[Known]:
        """What that stands to. `on`: it is on it, and that may be a block or a patch; `into`: it is inside or outside
        of it, and that is a patch."""
        return self._meant(pieces, subjects, subject=False, on=on, into=into)

    def _meant(
        self, pieces: Sequence[Piece], others: Sequence[Known], *, subject: bool, on: bool = False, into: bool = False
    ) -> list[Known]:
        found: list[Known] = []
        pieces = _one_of_each(pieces)
        for n, piece in enumerate(pieces):
            if piece.kind == "they":
                found += self._all(piece, [known for known in self.known if known not in others], subject=subject)
            elif piece.kind == "other":
                found.append(self._other(others))
            elif piece.kind == "it" and into:
                found.append(self.only_patch())
            elif piece.kind == "it":
                found.append(self._it(piece, others, subject=subject))
            elif piece.kind == "thing":
                if len(pieces) > n + 1 and not piece.named.get("noun") and pieces[n + 1].value == "patch":
                    raise Unclear  # "the red and the blue patch"
                found.append(self._thing(piece, on=on, both=_says_both(pieces, n)))
            elif not subject:
                raise Unclear
            else:
                found.append(self._some(piece))
        if len({(known.look, known.part) for known in found}) < len(found):
            raise Unclear
        return found

    def _all(self, piece: Piece, known: list[Known], *, subject: bool) -> list[Known]:
        """Both things that there are, or the one lot; or all of so many."""
        blocks = [thing for thing in known if not thing.patch] if subject or "all" in piece.named else known
        if "all" in piece.named:
            if sum(thing.count for thing in blocks) != number(piece.named["all"]):
                raise Unclear
            return blocks
        if (len(blocks) == 1 and blocks[0].count == 2) or [thing.count for thing in blocks] == [1, 1]:
            return blocks
        raise Unclear

    def _other(self, others: Sequence[Known]) -> Known:
        """The other one of two blocks."""
        if len(self.known) != 2 or len(others) != 1 or any(known.patch or known.count > 1 for known in self.known):
            raise Unclear
        return self._one([known for known in self.known if known not in others])

    def empty(self, things: Sequence[Known]) -> str:
        """That nothing is on a thing, in plain words."""
        thing = self._one(things)
        if thing.count > 1 or thing.part:
            raise Unclear
        return f"{thing.name} must be empty" if thing.patch else f"nothing must be on {thing.name}"

    def left(self) -> list[Known]:
        """The blocks of which nothing is said."""
        if self.parted:
            raise Unclear
        return [known for known in self.known if not known.patch and known.look not in self.used]

    def _it(self, piece: Piece, others: Sequence[Known], *, subject: bool) -> Known:
        blocks = [known for known in self.known if known.count == 1 and known not in others]
        if piece.value in ("former", "latter"):
            if len(self.known) != 2 or any(known.patch or known.count > 1 for known in self.known):
                raise Unclear
            return self.known[1 if piece.value == "latter" else 0]
        if self.parted:
            raise Unclear  # "one of them is on the mat. Put the other two next to it"
        return self._one([known for known in blocks if not known.patch or not (subject or piece.value == "block")])

    def _thing(self, piece: Piece, *, on: bool, both: int) -> Known:
        """What a name with a look means. `both`: how many are meant where "both" stands ahead."""
        named = piece.named
        pointing = named.get("det", "").split()[:1] in [[word] for word in _POINTING]
        new = _named(piece)
        new = replace(new, count=both) if both else new
        same = [known for known in self.known if known.patch == new.patch and known.look == new.look]
        if not same:
            words = set(new.look.split())
            same = [known for known in self.known if known.patch == new.patch and words < set(known.look.split())]
            if same and not pointing:
                raise Unclear
        if len(same) > 1:
            raise Unclear
        noun = named.get("noun", "")
        if not on or noun.startswith(_NOUNS):
            self.bare.discard(new.look)
        elif piece.value == "block" and not same and (not noun or any(known.patch for known in self.known)):
            self.bare.add(new.look)
        if same:
            return self._again(piece, new, same[0])
        if (
            new.count == 0
            or named.get("det") == "another"
            or (new.look == "patch" and pointing and any(known.patch for known in self.known))
        ):
            raise Unclear
        self.known.append(new)
        return new

    def _again(self, piece: Piece, new: Known, known: Known) -> Known:
        """Something that is known, named again."""
        det = piece.named.get("det", "")
        if det in ("a", "an", "one", "another") or (
            piece.named.get("count") in ("one", "single", "lone", "1") and det != "the"
        ):
            raise Unclear
        if piece.named.get("count") and new.count != known.count:
            raise Unclear
        if known.count > 1 and new.count == 1:
            raise Unclear
        if known.count == 1 and new.count == 0:
            raise Unclear
        return known

    def _some(self, piece: Piece) -> Known:
        """Some of a lot: "2 of the 3 red blocks", "one of them", "the other"."""
        named = piece.named
        if piece.kind == "part":
            return self._part(piece)
        lots = [known for known in self.known if known.count > 1]
        if "color" in named:
            lots = [known for known in lots if known.look == named["color"]]
        lot = self._one(lots)
        taken = self.parted.get(lot.look, 0)
        left = lot.count - taken
        if not taken or ("count" in named and number(named["count"]) != left):
            raise Unclear
        single = "nth" in named or piece.words.endswith(("the other", "one", *_NOUNS))
        if (single and left != 1) or left < 1 or not _last(named.get("nth"), lot.count):
            raise Unclear
        self.parted[lot.look] = 0
        other = f"the other {lot.look} block" if left == 1 else f"the other {left} {lot.look} blocks"
        return replace(lot, count=left, part=other)

    def _part(self, piece: Piece) -> Known:
        """So many of a lot; no more can be told of these but what the rest of them is."""
        named = piece.named
        lots = [known for known in self.known if known.count > 1 and not known.patch]
        look = named["color"] if "color" in named else self._one(lots).look
        same = [known for known in self.known if known.look == look and not known.patch]
        count = number(named["count"]) if "count" in named else same[0].count if same else 0
        lot = same[0] if same else Known(look, count)
        part = _how_many(named, count)
        if lot.count != count or not 0 < part < count or look in (*self.parted, *self.used):
            raise Unclear
        if not same:
            self.known.append(lot)
        how = named.get("how", "") if "but" not in named else "exactly"
        self.parted[look] = part if how in ("", "exactly", "precisely") else 0
        of = f"of the {count} {look} blocks"
        return replace(lot, count=part, part=f"{how} {part} {of}".strip())

    @staticmethod
    def _one(things: Sequence[Known]) -> Known:
        if len(things) != 1:
            raise Unclear
        return things[0]


def _how_many(named: Mapping[str, str], count: int) -> int:
    """How many a part is of so many: "2", "all but 2", "half".

    Raises:
        Unclear: half of an odd number.
    """
    if "half" in named:
        if count % 2:
            raise Unclear
        return count // 2
    return count - number(named["but"]) if "but" in named else number(named["part"])


def _named(piece: Piece) -> Known:
    """What a name says. `count`: 0 where several are meant and it is not said how many."""
    named = piece.named
    if piece.value in ("letter", "number"):
        return Known(f"{piece.value} {named[piece.value].upper()}")
    if piece.value == "patch":
        told = [named[part].replace("circle", "round") for part in ("shape", "behind", "form") if part in named]
        if len(told) > 1:
            raise Unclear
        shape = "".join(told)
        return Known(" ".join(filter(None, (named.get("size"), shape, named.get("color"), "patch"))), patch=True)
    look = " ".join(filter(None, (named.get("size"), named.get("color"))))
    if "count" in named:
        count = number(named["count"])
        if (count > 1) != ("many" in named or named.get("noun") in _MANY) and "noun" in named:
            raise Unclear
    else:
        count = 0 if "many" in named or named.get("noun") in _MANY else 1
    return Known(look, count)


def _one_of_each(pieces: Sequence[Piece]) -> Sequence[Piece]:
    """ "The red and the blue blocks": one of each."""
    *ahead, last = pieces or (None,)
    bare = {"count", "many", "noun"}
    if (
        not ahead
        or last is None
        or last.kind != "thing"
        or last.named.get("noun") not in _MANY
        or "count" in last.named
    ):
        return pieces
    if any(p is None or p.kind != "thing" or p.value != "block" or bare & p.named.keys() for p in ahead):
        return pieces
    if any(p.named.get("det", "").startswith(("both", "all", "each")) for p in pieces):
        return pieces
    return [*pieces[:-1], replace(last, named={**last.named, "noun": "block"})]


def _says_both(pieces: Sequence[Piece], n: int) -> int:
    """How many a name with "both" means: two of one look, or one of the two that are listed; 0 where it has none.

    Raises:
        Unclear: "both green", "both of the three green blocks".
    """
    named = pieces[n].named
    if not named.get("det", "").startswith("both"):
        return 0
    many = "many" in named or named.get("noun") in _MANY
    listed = len(pieces) == 2 and not n and not pieces[1].named.get("det", "").startswith("both")
    if named.get("count", "2") != "2" or (not many and not listed):
        raise Unclear
    if listed and many and not named.get("noun"):
        raise Unclear
    return 2 if many else 1


def _last(nth: str | None, count: int) -> bool:
    """Whether the one that is counted so is the last of so many."""
    return nth in (None, "last") or {"third": 3, "fourth": 4, "fifth": 5, "sixth": 6}[nth] == count
