"""Numbers, labels, adjectives and nouns: what noun phrases are put together from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.items import FIGURE, PART, PATCH, RANK, SYMBOL, TABLE
from rpg.language.compose.measures import Measures
from rpg.language.compose.syntax import Holds, Label, Noun, Phrase

TOLD_BY = frozenset({"block", *SYMBOL})
"""What stands ahead of a symbol: "the cube Q", "the letters A and B"."""
NAMED = (
    "labelled", "labeled", "numbered", "marked", "lettered",
    *(f"{with_} {a}{kind}".strip()
      for with_ in ("with", "bearing", "showing", "that has", "which has", "that shows", "which shows", "that bears")
      for a in ("the ", "a ", "an ")
      for kind in ("letter", "number", "digit", "")),
)  # fmt: skip
BOUNDS = [
    (words.split(), bound, more)
    for ways, bound, more in (
        ("exactly|one and only", "exactly", 0), ("at least|no fewer than|not fewer than|no less than", "least", 0),
        ("at most|no more than|not more than", "most", 0), ("more than", "least", 1), ("fewer than", "most", -1),
        ("only|just", "exactly", 0), ("about|roughly|around|approximately", "about", 0),
    )
    for words in ways.split("|")
]  # fmt: skip
_RELATIONS: dict[str, tuple[str, ...]] = {
    "on": ("on top of", "atop", "on to", "onto", "upon", "on"),
    "under": ("under", "underneath", "beneath", "below"),
    "left": ("to the left of", "on the left of", "left of", "to left of"),
    "right": ("to the right of", "on the right of", "right of", "to right of"),
    "front": ("in front of", "to the front of"),
    "behind": ("behind", "in back of", "at the back of"),
    "next": ("next to", "beside", "alongside", "by the side of"),
    "near": ("near", "close to"),
    "between": ("in between", "between"),
    "touch": ("touching", "against", "in contact with"),
    "apart": ("away from", "from"),
    "far": ("far from", "far away from", "well away from"),
    "off": ("off of", "off", "outside of", "outside", "not on"),
    "in": ("inside of", "inside", "within", "into", "in", "at", "to"),
    "opposite": ("at the other end of",),
    "flank": ("on opposite side of", "on either side of", "on both side of", "at opposite side of"),
}
RELATIONS = sorted(
    ((words.split(), relation) for relation, ways in _RELATIONS.items() for words in ways), key=lambda way: -len(way[0])
)


_ALL_OF = (", both", ", all", ", both of them", ", all of them", ", each")
_ALONE = frozenset({"tall", "short", "big", "small", "former", "latter", "last"})
_TRAITS = {"round": "round", "circular": "round", "long": "long", "rectangular": "rectangular", "square": "square"}
"""What is said of the shape of a patch."""
_OF_TWO = ("of the two", "of these two", "of those two")
_UTMOST = frozenset({"leftmost", "rightmost", "topmost", "highest", "lowest"})
"""What stands for a block without a noun."""


class Heads(Measures):
    """Reads the nouns of phrases, without what stands behind them."""

    def _labels(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "A", "the cube Q", "the letter K", "the 4 block", "the block numbered 4"."""
        start = at + 1 if self.text(at) == "the" else at
        color = lexicon.COLOR.get(self.text(start), "")
        start += bool(color)
        said = self.text(start) in TOLD_BY
        named = self.past_any(start + said, *NAMED) or start + said
        if said and (color or self.items[start].many):
            return  # "the green cube 3" may be counted; several are told by `phrase`
        if label := self.label(named):
            on_it = self.past_any(named + 1, "on it", "on top") if named > start + said + 1 else 0
            yield Label(label, color), on_it or named + 1
            if not said and self.text(named + 1) == "block" and not self.items[named + 1].many:
                yield Label(label, color), named + 2
            if start > at and not color and not said and self.text(named + 1) == "tower":
                yield Noun(det="the", noun="tower", that=(Holds(Label(label)),)), named + 2  # "the A tower"

    def label(self, at: int) -> str:
        """The symbol that a word is, or nothing."""
        if not 0 <= at < len(self.items):
            return ""
        item = self.items[at]
        if len(item.raw) == 1 and item.raw.isalpha() and (item.raw.isupper() or item.raw not in "ai"):
            return item.raw.upper()
        return item.raw if item.raw.isdigit() and len(item.raw) == 1 else ""

    def _amount(self, at: int) -> Iterator[tuple[Noun, int]]:
        """ "exactly two", "at least one", "three", "half"."""
        for words, bound, more in BOUNDS:
            if bound != "about" and (end := self.past(at, words)) and self.number(end):
                yield Noun(bound=bound, count=self.number(end) + more), end + 1
        if self.number(at):
            yield Noun(count=self.number(at)), at + 1

    def _head(self, at: int, noun: Noun) -> Iterator[tuple[Noun, int]]:
        """Adjectives and a noun; a colour or a rank may stand for one."""
        item = self.items[at] if at < len(self.items) else None
        if item is None:
            return
        text = item.text
        if text in lexicon.COLOR and not noun.color:
            with_color = replace(noun, color=lexicon.COLOR[text], many=item.many)
            yield with_color, at + 1
            yield from self._head(at + 1, replace(with_color, many=False))
        if text in RANK:
            behind = at + 1 + (self.text(at + 1) in {"hand", "most"})  # "the right-hand one"
            yield from self._head(behind, replace(noun, ranks=(*noun.ranks, RANK[text])))
            alone = RANK[text] in _ALONE or item.raw.lower() in _UTMOST or self.past_any(behind, *_OF_TWO)
            if noun.det == "the" and alone:
                yield replace(noun, ranks=(*noun.ranks, RANK[text]), noun="one"), behind
        if noun.ranks and not noun.count and item.number > 1 and noun.det == "the":
            yield replace(noun, count=item.number, noun="one"), at + 1  # "the outer two"
            yield from self._head(at + 1, replace(noun, count=item.number))
        if text in lexicon.ORDINAL and noun.det != "a":
            nth = lexicon.ORDINAL[text]
            yield replace(noun, nth=nth, noun="one"), at + 1
            yield from self._head(at + 1, replace(noun, nth=nth))
        if text in _TRAITS and not noun.word:
            shaped = self._head(at + 1, replace(noun, word=_TRAITS[text]))
            yield from ((patch, end) for patch, end in shaped if patch.noun == "patch")
        if spaced := self.past_any(at, "evenly spaced", "equally spaced"):
            yield from self._head(spaced, replace(noun, gaps=", evenly spaced"))
        upright = text == "upright" and self.text(at + 1) in FIGURE
        if text in {"plain", "such", "more"} or upright or (text == "same" and noun.det == "the"):
            yield from self._head(at + 1, noun)
        for with_size, end in self.sized(noun, at):
            yield from self._head(end, with_size)
        if text in {"first", "last"} and (many := self.number(at + 1)) > 1 and noun == Noun(det="the"):
            yield from self._head(at + 2, replace(noun, ranks=(text,), count=many))
        if text in {"even", "odd"} and (SYMBOL.get(self.text(at + 1)) == "digit" or self.text(at + 1) == "one"):
            yield replace(noun, noun=text, many=noun.many or self.items[at + 1].many), at + 2
        yield from self._named(at, noun)

    def _named(self, at: int, noun: Noun) -> Iterator[tuple[Noun, int]]:
        """The noun itself, with the word or the equation that it is."""
        item, text = self.items[at], self.text(at)
        figure, behind = self.figure_at(at)
        if item.raw.lower() == "cube" and (len(noun.size) == 3 or self.text(behind) == "of"):
            yield replace(noun, noun="cube"), behind
        kind = figure or PART.get(text) or ("block" if text == "block" else "") or SYMBOL.get(text, "")
        kind = kind or ("patch" if text in PATCH else "table" if text in TABLE else "one" if text == "one" else "")
        if not kind or (kind == "middle" and item.many and item.raw[:4].lower() == "cent"):
            return  # "whose centers are 8 cm apart" tells a distance
        following = self.items[behind].value if behind < len(self.items) else ""
        word = item.value or (following if kind in {"word", "equation"} else "")
        end = behind + (word != item.value)
        if kind in {"bottom", "end"} and (stem := self.past_any(end, "of the stem", "of its stem")):
            yield replace(noun, noun="bottom"), stem  # of a T
        word = "pair" if text == "pair" else noun.word if kind == "patch" else word
        yield replace(noun, noun=kind, many=noun.many or item.many, word=word), end
        all_of = self.past_any(end, *_ALL_OF) if kind in {"block", "one"} and noun.count > 1 and not noun.color else 0
        hue = lexicon.COLOR.get(self.text(all_of), "") if all_of else ""
        if hue and self.text(all_of + 1) == ",":  # "two more blocks, both black,"
            yield replace(noun, noun="block", many=True, color=hue), all_of + 2
        if kind == "block" and self.text(at + 1) in {"tower", "row"} and noun.count:
            size = (noun.count,)
            yield replace(noun, count=0, size=size, noun=self.text(at + 1), many=self.items[at + 1].many), at + 2
