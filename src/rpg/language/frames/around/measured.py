"""How large the blocks or a patch are, told in the middle of something else: taken out, and told in a sentence of its
own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain, pairwise

from rpg.language import lexicon
from rpg.language.frames.around.beside import stopped
from rpg.language.frames.pieces import Pattern, coded, joined, patterns
from rpg.language.tokens import Token

_UNIT = "(?:cm|mm|centimet(?:er|re)s?|millimet(?:er|re)s?)"
_SIZE = rf"(?P<size>\d+(?:\.\d+)? {_UNIT})"
_EDGE = (
    "(?:(?:side|edge|block|cube) )?(?:lengths?|sizes?|dimensions?|widths?|edges?|sides?)(?: (?:length|size)s?)?"
    "(?: of (?:its |their |the )?(?:edges?|sides?))?"
)
_LARGE = "(?:wide|large|big|on (?:an|the|a|each) (?:edge|side)|in size|across|per (?:edge|side)|edges?|cubes)"
_BE = "(?:(?:must|should|shall|will) )?(?:be|is|are|being|measures?|has|have|having|with|was|:|=|,)"
_ALL = "(?:both|all|all the|all of the|each of the|each|every|both the|the|all (?:three|four|five|\\d+))"
_WHO = r"(?:blocks|cubes|pieces|elements|block|cube|ones|of (?:them|the blocks|the cubes)|of both)"
_LEAD = r"(?:(?:[,;.:]|and|with|where|while|note that|please|use|using|now) )*"
_A = "(?:(?:a|an|the) )?"
_PATCHED = r"(?:the|this|that)(?: (?P<color>COLOR))?(?: (?:square|round|circular))? (?P<patch>PATCH)"
TOLD: list[Pattern] = [
    *patterns("blocks", None,
        rf"{_LEAD}{_A}{_EDGE}(?: {_BE})? {_SIZE} (?:for|on|of) (?:{_ALL} )?{_WHO}",
        rf"{_LEAD}{_A}{_EDGE}(?: (?:for|of|on))? (?:{_ALL} )?{_WHO}(?: {_BE})? {_SIZE}",
        rf"{_LEAD}(?:{_ALL} )?{_WHO} (?:{_BE} )+{_A}(?:{_EDGE}(?: of| is)? )?(?:exactly )?{_SIZE}(?: {_LARGE})?",
        rf"{_LEAD}(?:{_ALL} )(?:(?:{_BE}|of|at) )*{_A}{_EDGE}(?: of| is| :)? {_SIZE}",
        rf"{_LEAD}(?:{_ALL} )?(?:blocks|cubes) (?:of|at) {_SIZE}(?: {_EDGE}| {_LARGE})?",
        rf"{_LEAD}{_A}(?:block|cube|edge) (?:size|length)(?: {_BE})? {_SIZE}",
        rf"{_LEAD}{_SIZE} (?:blocks|cubes)",
        rf"{_LEAD}(?:{_ALL} )?(?:blocks|cubes) {_SIZE}(?: {_LARGE})?",
        rf"{_LEAD}(?:each|all|both) {_SIZE}(?: {_LARGE})?"),
    *patterns("counted", None,
        rf"(?:that |which |both |all |each )?(?:{_BE} )+{_A}(?:{_EDGE}(?: of| is)? )?(?:exactly )?{_SIZE}"
        rf"(?: {_LARGE}| {_EDGE})?"),
    *patterns("patch", None,
        rf"{_LEAD}{_PATCHED}(?: {_BE})? {_A}(?:{_EDGE}(?: of)? )?(?:exactly )?{_SIZE}(?: {_LARGE})?",
        rf"{_LEAD}{_A}{_EDGE} of {_PATCHED}(?: {_BE})? {_SIZE}"),
]  # fmt: skip
_LAST = re.compile(r"\b(?:both|each|all) (?!(?:the |of the )?(?:blocks|cubes))")
"""This may be of those alone that the sentence before it is about."""
_MANY = frozenset({"blocks", "cubes"})
_COLORED = frozenset({*lexicon.COLORS, *(f"{color}s" for color in lexicon.COLORS)})
_SIDED = frozenset({"square", "rectangle", "triangle", "wall", "circle"})
"""These may have sides of such a length."""
_SIZED = re.compile(
    rf"\b(?:cm|mm) (?:(?:{'|'.join(lexicon.COLORS)})s? (?!{'|'.join(lexicon.PATCH_NOUNS.split())})|(?:block|cube|"
    rf"one))"
)
"""Some of the blocks have a size of their own."""
_STOPS = frozenset({".", ";", "!", "?", ":"})
_BOUNDS = _STOPS | {",", "and", "with", "where", "while"}


def without_measures(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], list[Token], str]]:
    """The text without the stretches that tell how large all blocks, or a patch, are; the first of those, and what they
    say. Each is a sentence of its own or stands at an end of the text."""
    words = coded(tokens)
    if not any(word in ("cm", "mm") or word.startswith(("centim", "millim")) for word in words):
        return
    text, places = joined(words)
    rest: list[Token] = []
    stretch: list[Token] = []
    said: dict[str, str] = {}
    n = 0
    while n < len(words):
        kinds = {"blocks", "patch"} if n == 0 or words[n] in _BOUNDS or words[n - 1] in _BOUNDS else set()
        kinds |= (
            {"counted"}
            if words[n - 1] in _MANY and _COLORED.isdisjoint(words[:n]) and _SIDED.isdisjoint(words)
            else set()
        )
        ways = [(match.end(), pattern.kind, match) for pattern in TOLD if pattern.kind in kinds
                if (match := pattern.expression.match(text, places[n])) and match.end() in places]  # fmt: skip
        ways = [way for way in ways if (end := places.index(way[0])) == len(words) or words[end] in _STOPS | {","}]
        if not ways:
            rest.append(tokens[n])
            n += 1
            continue
        end, kind, match = max(ways, key=lambda way: way[0])
        who = f"The {match['color'] or ''} {match['patch']}".replace("  ", " ") if kind == "patch" else "All blocks"
        if said.get(who, match["size"]) != match["size"]:
            return
        said[who] = match["size"]
        stretch = stretch or list(tokens[n : places.index(end)])
        rest.append(tokens[n].saying("."))
        n = places.index(end)
    left = coded(rest)
    of_last = said and _LAST.search(" ".join(coded(stretch)))
    if of_last and sum(a in _STOPS and b not in _STOPS for a, b in pairwise(left)):
        return
    if "All blocks" in said and _SIZED.search(" ".join(left)):
        return
    if said and any(word not in _STOPS for word in left):
        plain = stopped(_once(rest), rest[-1])
        told = [f"{who} {'is' if who != 'All blocks' else 'are'} {size}{' wide' * (who != 'All blocks')}."
                for who, size in said.items()]  # fmt: skip
        yield plain, stretch, " ".join(told)


def _once(tokens: Sequence[Token]) -> list[Token]:
    """Without marks that follow on another."""
    pairs = zip(tokens, chain([None], tokens), strict=False)
    marks = _STOPS | {","}
    return [token for token, ahead in pairs if token.word not in marks or (ahead and ahead.word not in marks)]
