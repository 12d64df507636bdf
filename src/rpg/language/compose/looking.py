"""How things look, wholly or at places of them: "entirely green", "red below and blue on top"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.items import RANK
from rpg.language.compose.places import Places
from rpg.language.compose.syntax import Both, Clause, InTurn, Looks, Noun, Phrase
from rpg.language.compose.words import Ways

FROM_LEFT = ("from left to right", "left to right", "from the left to the right")
_WHOLLY = ("entirely", "completely", "wholly", "all", "fully", "totally")
_THROUGHOUT = ("all through", "all the way through", "throughout", "through and through", "all over")
_PARTS: dict[str, tuple[str, ...]] = {
    "top": ("on top", "at the top", "on the top"), "bottom": ("at the bottom", "on the bottom", "at its bottom"),
    "middle": ("in the middle", "in between"), "below": ("below", "underneath"), "above": ("above",),
}  # fmt: skip
_IS = ("is", "are", "must be", "should be", "shall be", "is to be", "are to be", "has to be", "have to be")
_EXCEPT = tuple(f"{comma}{words}" for words in ("except for", "except", "apart from", "other than", "but for")
                for comma in ("", ", "))  # fmt: skip


class Looking(Places):
    """Reads how things look."""

    def colored(self, at: int) -> Ways[tuple[Looks, ...]]:
        """ "entirely green", "red all through", "red at the bottom and white on top"."""
        start = self.past_any(at, *_WHOLLY) or at
        color = lexicon.COLOR.get(self.text(start), "")
        if not color:
            return []
        like, end = Noun(color=color), start + 1
        whole = self.past_any(end, *_THROUGHOUT) or (end if start > at else 0)
        found: Ways[tuple[Looks, ...]] = [((Looks(like),), whole)] if whole else []
        for part, ways in _PARTS.items():
            if stop := self.past_any(end, *ways) if start == at else 0:
                found.append(((Looks(like, at=part),), stop))
                more = self.past_any(stop, "and", ", and", ",")
                rest = self.colored(more) if more else []
                found += [((Looks(like, at=part), *said), last) for said, last in rest if said[0].at]
        return found

    def as_high(self, at: int) -> tuple[int, int]:
        """ "are three blocks high", "must both be two high": how high, and where that ends."""
        end = self.past_any(at, *_IS)
        end += self.text(end) in {"all", "both", "each"} if end else 0
        high = end + 1 + (self.text(end + 1) == "block")
        if not end or not self.number(end) or self.text(high) not in {"high", "tall"}:
            return 0, 0
        return self.number(end), high + 1 + (self.text(high + 1) == "each")

    def excepted(self, at: int) -> Ways[Clause]:
        """ "(all are green) except for the middle one, whose top block is yellow": how that one looks."""
        found: Ways[Clause] = []
        start = self.past_any(at, *_EXCEPT)
        for what, end in self.single(start) if start else ():
            parts: Ways[Phrase] = []
            if whose := self.past_any(end, "whose", ", whose"):
                parts += [(replace(part, of=what), stop) for part, stop in self._head(whose, Noun(det="the"))]
            if which := self.past_any(end, "which", ", which", "that"):
                parts.append((what, which))
            for part, stop in parts:
                color = self.past_any(stop, *_IS)
                if color and (name := lexicon.COLOR.get(self.text(color))):
                    found.append((Clause(part, (Looks(Noun(color=name)),), "must"), color + 1))
        return found

    def colors_in_turn(self, at: int) -> Ways[Clause]:
        """ "on top are red and blue, from left to right", "the bottom ones are red and blue from left to right"."""
        part = next((part for part, ways in _PARTS.items() if (self.past_any(at, *ways))), "")
        start = self.past_any(at, *_PARTS[part]) if part else 0
        rank = RANK.get(self.text(at + 1), "") if self.text(at) == "the" else ""
        if rank in _PARTS and self.items[at + 2 : at + 3] and self.items[at + 2].many:
            part, start = rank, at + 3
        start = self.past_any(start, *_IS) if start else 0
        start = self.past_any(start, *(f"{comma}{way} ," for way in FROM_LEFT for comma in (", ", ""))) or start
        colors: list[Phrase] = []
        end = start
        while start and (color := lexicon.COLOR.get(self.text(start))):
            colors.append(Noun(color=color))
            end = start + 1
            start = self.past_any(end, "and", ", and", ",")
        end = self.past_any(end, ", respectively", "respectively", "respectively ,", ", respectively ,") or end
        sided = self.past_any(end, *(f"{comma}{way}" for way in FROM_LEFT for comma in ("", ", ")))
        told = any(item.text == "right" for item in self.items[at:end])
        if part not in {"top", "bottom", "middle"} or len(colors) < 2 or not (sided or told):
            return []
        return [(Clause(Both(tuple(colors)), (InTurn(part),)), sided or end)]
