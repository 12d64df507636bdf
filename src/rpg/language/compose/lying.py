"""What lies there before something is done: "the tower is red, white, black from the bottom up", "the letters spell
STOP", "red, blue and green lie in a row from left to right"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.compose.becoming import Becoming
from rpg.language.compose.items import FIGURE
from rpg.language.compose.syntax import Chain, Clause, Label, Made, Noun, Phrase, is_figure
from rpg.language.compose.words import Ways

_LISTS = ("is", "goes", "runs", "reads", "reads as", "has", "consists of", "starts as", "starts out as", "begins as",
          "is at the start", "is now", "is currently", "was", "is :", ":", "are", "read")  # fmt: skip
_SPELLS = frozenset({"spell", "spells", "read", "reads", "say", "says", "show", "shows"})
_LIE = frozenset({"lie", "stand", "sit", "are", "rest"})
_LINES = frozenset({"tower", "row", "line", "column"})
_FIRST = {"tower": "bottom", "row": "left", "line": "left", "column": "front"}
_LAST = {"tower": "top", "row": "right", "line": "right", "column": "back"}
_ENDS = {"row": ("left", "right"), "line": ("left", "right"), "column": ("near", "far")}
_THERE = ("is there", "is already there", "is there already", "is already spelled out", "is spelled out",
          "is already spelled", "is already spelt", "is there now", "is already laid out", "is laid out")  # fmt: skip
_STANDS_THERE = tuple(
    f"{verb} {there}" for verb in ("is", "stands", "lies")
    for there in ("there", "already there", "there already", "on the table", "there at the start", "there now")
)  # fmt: skip
_ABOVE = ("above it", "above that", "on it", "next", "on that", "over it")
_IN_LINE = {"row": ("in a row", "in one row", "in this order", "in order", "in that order", "in a row in this order"),
            "line": ("in a line", "in one line"), "column": ("in a column", "in a line")}  # fmt: skip


class Lying(Becoming):
    """Reads what lies there."""

    def lying(self, at: int) -> Ways[Clause]:
        """All ways to read it; "lies" is the mood of what is told so."""
        found: Ways[Clause] = []
        ahead = next((way for way in self._ways_round(at, *_LINES)), None) if self.text(at) == "from" else None
        start = ahead[2] + (self.text(ahead[2]) == ",") if ahead else at
        if ahead and self.text(start) in _LIE:
            parts, end, _ = self.parts_in_turn(start + 1)
            found += self._of_line(ahead[0], parts, ahead[1], end)
        if self.text(at) in {"a", "the"} and (told := self._told_ahead(at)):
            found += told
        for what, end in self._plain_or_new(start):
            if listed := self.past_any(end, *_LISTS):
                found += self._listed_there(what, listed, ahead)
            if what.noun == "tower" and self.text(end) == "has":
                found += self._by_places(end + 1)
            if self.text(end) in _SPELLS and what.noun in {"row", "letter", "block", "word"}:
                found += self._word_there(what, end + 1)
            if what.noun == "word" and what.word and (there := self.past_any(end, *_THERE)):
                found.append((Clause(Noun(det="a", noun="word", word=what.word), (), "lies"), there))
        if self.items[at : at + 1] and self.items[at].value.isalpha() and (there := self.past_any(at + 1, *_THERE)):
            found.append((Clause(Noun(det="a", noun="word", word=self.items[at].value), (), "lies"), there))
        if self.text(at) in {"from", "in", "of"}:
            ahead_of = [way for way in self.single(at + 1) if self.text(way[1]) == "," and is_figure(way[0])]
            found += [(Clause(figure, (), "lies"), end) for figure, end in ahead_of]
        if self.text(at) in {"a", "the"}:
            for figure, end in self.single(at):
                if is_figure(figure) and isinstance(figure, Noun) and figure.det == "a":
                    stands = self.past_any(end + (self.text(end) == ","), *_STANDS_THERE)
                    found += [(Clause(figure, (), "lies"), stands)] if stands else []
        found += self._in_line(at)
        return found

    def _told_ahead(self, at: int) -> Ways[Clause]:
        """ "a row of three, left to right: red, white, blue"."""
        kind = FIGURE.get(self.text(at + 1), "")
        if kind not in _FIRST:
            return []
        of = self.past_any(at + 2, "of") or 0
        many = self.number(of) if of else 0
        end = of + 1 + (self.text(of + 1) == "block") if many else at + 2
        end += self.text(end) == ","
        for _, back, stop in self._ways_round(end, kind):
            parts, last, _ = self.parts_in_turn(stop + (self.text(stop) in {":", ","}))
            if not many or many == len(parts):
                return self._of_line(kind, parts, back, last)
        return []

    def _plain_or_new(self, at: int) -> list[tuple[Noun, int]]:
        """ "the tower", "a row": what is told of without more."""
        heads = [way for way in self.simple(at) if isinstance(way[0], Noun)] if self.text(at) in {"the", "a"} else []
        bare = [(noun, end) for noun, end in heads if isinstance(noun, Noun) and not (noun.of or noun.content)]
        plain = [(noun, end) for noun, end in bare if noun.det in {"the", "a"} and not noun.ranks and not noun.that]
        return [way for way in plain if way[0].noun in {*_LINES, "letter", "block", "word"}]

    def _listed_there(self, what: Noun, at: int, ahead: tuple[str, bool, int] | None) -> Ways[Clause]:
        """ "(the tower is) red, white, black from the bottom up"."""
        if what.noun not in _LINES or what.color:
            return []
        parts, end, topped = self.parts_in_turn(at)
        if len(parts) < 2:
            return []
        found: Ways[Clause] = []
        for _, back, stop in self._ways_round(end + (self.text(end) == ","), what.noun):
            found += self._of_line(what.noun, parts, back, stop)
        if ahead and ahead[0] == what.noun:
            found += self._of_line(what.noun, parts, ahead[1], end)
        elif topped or (not found and (what.noun in {"row", "line"} or parts == parts[::-1])):
            found += self._of_line(what.noun, parts, False, end)
        return found

    def _by_places(self, at: int) -> Ways[Clause]:
        """ "(the tower has) red at the bottom, green in the middle and blue on top"."""
        parts: list[Phrase] = []
        while True:
            at += self.text(at) in {"a", "the"}
            color, label = lexicon.COLOR.get(self.text(at), ""), self.label(at)
            if not (color or label):
                return []
            end = at + 1 + (self.text(at + 1) in {"block", "one"})
            top = self.past_any(end, "on top", "at the top") if parts else 0
            there = self.past_any(end, *(_ABOVE if parts else ("at the bottom", "on the bottom")))
            middle = self.past_any(end, "in the middle") if len(parts) == 1 else 0
            parts.append(Label(label) if label else Noun(color=color))
            if top:
                return self._of_line("tower", parts, False, top) if len(parts) > 2 or not middle else []
            at = self.past_any(there or middle, ", and", "and", ",", ", then", "then") if there or middle else 0
            if not at:
                return []

    def _of_line(self, kind: str, parts: list[Phrase], back: bool, end: int) -> Ways[Clause]:
        if len(parts) < 2:
            return []
        listed = Chain(tuple(parts if back else parts[::-1]))
        return [(Clause(Noun(det="a", noun=kind, content=listed, made="of", order="listed"), (), "lies"), end)]

    def _ways_round(self, at: int, *kinds: str) -> list[tuple[str, bool, int]]:
        """ "from the bottom up", "from left to right": of what, whether from its far end, and where that stops."""
        found = []
        for kind in kinds:
            first, last = _FIRST[kind], _LAST[kind]
            up, down = (" up", " down") if kind == "tower" else (f" to {last}", f" to {first}")
            for back, one, other, on in ((False, first, last, up), (True, last, first, down)):
                ways = [f"{lead}{the}{one} to {the}{other}" for lead in ("", "from ") for the in ("", "the ")]
                ways += [f"from {the}{one}{go}" for the in ("", "the ") for go in (on, "") if kind == "tower" or go]
                if end := self.past_any(at, *ways):
                    found.append((kind, back, end))
        return found

    def _word_there(self, what: Noun, at: int) -> Ways[Clause]:
        """ "(the letters) spell STOP"."""
        start = self.past_any(at, "the word", "out", "out the word") or at
        word = self.items[start].value if start < len(self.items) else ""
        if not word.isalpha() or (what.noun == "row" and what.word):
            return []
        end = self.past_any(start + 1, "from left to right", "now") or start + 1
        return [(Clause(Noun(det="a", noun="word", word=word), (), "lies"), end)]

    def _in_line(self, at: int) -> Ways[Clause]:
        """ "A, B and C stand in a row from left to right", "1 to 5 lie in order from left to right"."""
        found: Ways[Clause] = []
        for what, end in self.phrase(at):
            aux = self.past_any(end, "all", "already") or end
            if self.text(aux) not in _LIE | {"start", "begin", "form"}:
                continue
            for kind, ways in _IN_LINE.items():
                if start := self.past_any(aux + 1, *ways):
                    rounds = self._ways_round(start, kind)
                    for _, back, stop in rounds:
                        row = Noun(det="a", noun=kind, ranks=(_ENDS[kind][back],))
                        found.append((Clause(what, (Made(row),), "lies"), stop))
        return found
