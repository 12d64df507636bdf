"""Two figures and how one stands to the other: each told again by its family, and the relation in a sentence."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.frames.around.attached import BE, OF_IT, SIDES, UNBOUND, VERB
from rpg.language.frames.pieces import Pattern, coded, joined
from rpg.language.frames.shared import asked
from rpg.language.tokens import Token

Plainly = Callable[[Sequence[Token]], str | None]

_ENDS = frozenset(
    {",", ".", ";", ":", "!", "and", "with", "while", "where", "but", "plus", "there", "is", "are", "then"}
)
_JOINTS = frozenset({",", ".", ";", "and", "with", "while", "plus", "but", "where"})
_RELATIONS = [
    Pattern("side", rf"(?:{BE} )?(?:(?:right|directly|just|immediately) )?(?:{ways})", side)
    for side, ways in SIDES
    if side not in ("on top of", "on both sides of")
]
_MUTUAL = Pattern(
    "mutual", rf"(?:{BE} )?(?:(?:right )?(?:next to|beside|alongside) (?:each other|one another)|side by side)"
)
_HOST = Pattern("host", rf"(?:{OF_IT}|which)(?: ,| :)?(?: (?:{VERB}|{BE}))?")
_NOUN = re.compile(
    r"(?:Build|Lay) (?:an? |.+? in an? )(?:\S+ )??(?P<noun>tower|wall|grid|pyramid|staircase|row|line|column|square|"
    r"rectangle|triangle|circle|cross|checkerboard)\b|(?P<word>Spell)\b"
)
_BLOCKS = re.compile(r"(?:from|Lay) (?P<blocks>\d+ \S+ blocks?(?:(?:, | and )\d+ \S+ blocks?)*)")
_COLORS = re.compile(rf"\b(?:{'|'.join(lexicon.COLORS)})\b")
_GIVEN = re.compile(r"\b(?:there (?:is|are)|we have|already|given|the (?:tower|row|wall|stack|pyramid))\b")
_SET_OFF = re.compile(r" , (?:[^,]* )?(?:apart|touching)\b")
"""What may be told of the two figures, and not of the blocks of the one behind which it stands."""
_MANY = frozenset({"which", "whose", "what", "those", "these", "that", "both", "each", "every", "all", "its", "their"})
"""What begins with these is told of by what stands ahead."""
_CLOSE = re.compile(r"\b(?:right|directly|just|immediately) (?=next|beside|behind|in |to |on |at |left|right)")


@dataclass(frozen=True)
class _Figure:
    """A figure that is told: in plain sentences, what it is called, and its colours."""

    told: str
    noun: str
    blocks: str
    looks: frozenset[str]

    @property
    def named(self) -> str:
        """The figure where another of its kind is told besides."""
        blocks = re.sub(r"\b1 ", "the ", re.sub(r"\b(?=[2-9] |\d\d )", "the ", self.blocks))
        return f"the {self.noun} of {blocks}"


def pairs(tokens: Sequence[Token], plainly: Plainly) -> Iterator[str]:
    """Two figures in plain sentences, in each way that the text can be cut in two."""
    words = coded(tokens)
    while words and words[-1] in (".", "!", ";"):
        words.pop()
    if not UNBOUND.isdisjoint(words) or not _mentions(words):
        return
    text, places = joined(words)
    for n in range(2, len(words)):
        if (match := _MUTUAL.expression.match(text, places[n])) and match.end() == len(text):
            for one, other in _joined(tokens[:n], plainly):
                yield from _told(one, other, "next to")
        for known in _RELATIONS:
            match = known.expression.match(text, places[n])
            if not match or match.end() not in places:
                continue
            side, behind = str(known.value), places.index(match.end())
            side = f"{close[0]}{side}" if (close := _CLOSE.search(match[0])) else side
            host = _HOST.expression.match(text, match.end())
            if host and host["patch"]:
                continue
            if host is None and not _MANY.isdisjoint(words[behind : behind + 1]):
                continue
            if host is None:
                for one, other in _both(tokens[:n], tokens[behind : len(words)], plainly):
                    yield from _told(one, other, side)
            elif host.end() == len(text):
                for one, other in _joined(tokens[:n], plainly):
                    yield from _told(other, one, side)
            elif host.end() in places and words[n - 1] in _JOINTS:
                ahead = tokens[:n]
                for one, other in _both(ahead, tokens[places.index(host.end()) : len(words)], plainly):
                    yield from _told(other, one, side)


def _mentions(words: Sequence[str]) -> bool:
    """Whether two things are spoken of that may be figures."""
    named = sum(re.fullmatch(rf"(?:{_FIGURES})s?|'\w+'|\d+x\d+", word) is not None for word in words)
    return named > 1


_FIGURES = (
    "tower|stack|pillar|row|line|column|wall|grid|pyramid|staircase|stairs|square|rectangle|circle|ring|triangle|"
    "cross|"
    "word|stacked|one|spell|checkerboard|block"
)


def _joined(tokens: Sequence[Token], plainly: Plainly) -> Iterator[tuple[_Figure, _Figure]]:
    """Two figures that are told one after the other."""
    for n in range(2, len(tokens) - 2):
        if tokens[n].word in _JOINTS:
            yield from _both(tokens[:n], tokens[n + 1 :], plainly)


def _both(ahead: Sequence[Token], behind: Sequence[Token], plainly: Plainly) -> Iterator[tuple[_Figure, _Figure]]:
    one, other = _figure(_trimmed(ahead), plainly), _figure(_trimmed(behind), plainly)
    given = _GIVEN.search(" ".join(coded(ahead)))
    asked = any(token.word in lexicon.COMMANDS for token in behind)
    shared = _SET_OFF.search(" ".join(coded(behind))) and not _SET_OFF.search(" ".join(coded(ahead)))
    if one and other and not (given and asked) and not shared:
        yield one, other


def _trimmed(tokens: Sequence[Token]) -> Sequence[Token]:
    """Without words at the ends that only bind it to something else."""
    begin, end = 0, len(tokens)
    while begin < end and tokens[begin].word in _ENDS:
        begin += 1
    while end > begin and tokens[end - 1].word in _ENDS:
        end -= 1
    return tokens[begin:end]


def _figure(tokens: Sequence[Token], plainly: Plainly) -> _Figure | None:
    """The figure that the words tell of, if they tell of one and of all of it."""
    said = plainly(tokens) if len(tokens) > 2 else None
    found = _NOUN.match(said) if said else None
    if said is None or found is None or re.search(r"\b(?:Put|There|Then|First)\b", said):
        return None
    blocks = _BLOCKS.search(said)
    return _Figure(said, found["noun"] or "word", blocks["blocks"] if blocks else "", frozenset(_COLORS.findall(said)))


def _told(one: _Figure, other: _Figure, side: str) -> Iterator[str]:
    """That one stands so to the other, and what both are, in the order in which they are told."""
    if one.looks & other.looks or (one.noun == other.noun and not (one.blocks and other.blocks)):
        return
    if not all(figure.noun == "word" or re.search(r"\d", figure.told) for figure in (one, other)):
        return  # "a red square" may be a patch
    if not all(figure.looks or figure.noun == "word" or "blocks " in figure.told for figure in (one, other)):
        return
    names = (one.named, other.named) if one.noun == other.noun else (f"the {one.noun}", f"the {other.noun}")
    yield f"{asked(one.told)} {asked(other.told)} {names[0].capitalize()} must be {side} {names[1]}."
