"""Blocks, or a small figure, that are told with their place beside a figure: taken out of what tells of the figure,
and told in a sentence of their own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rpg.language import lexicon
from rpg.language.frames.around.beside import stopped
from rpg.language.frames.pieces import coded, joined, patterns
from rpg.language.tokens import Token

_FIGURE = (
    "tower|stack|pillar|row|line|column|wall|grid|pyramid|staircase|stairs|square|rectangle|circle|ring|triangle|"
    "cross|"
    "plus|word"
)
_DET = "(?:(?:the|a|an|my|our|another|one|single|just|some|also) )*"
_LOT = (
    rf"{_DET}(?:(?:\d+|extra|more|further|additional|lone|other) )*(?:SIZE )?(?:plain )?COLOR(?:s)?"
    "(?: BLOCK| ones| one)?"
)
_LETTER = r"(?:the |a )?(?:(?:letter )?BLOCK )?(?:letter )?[A-Z](?: BLOCK)?"
_SMALL = "(?:(?:small|second|little|similar|smaller|short|separate) )*"
_BUILT = (
    rf"(?:a|an|another|one|the) {_SMALL}(?:tower|stack|row|line|one) (?:made |built |formed )?"
    rf"(?:of|from|with|out of) {_LOT}(?: and {_LOT})*"
)
_THINGS = rf"(?P<things>{_BUILT}|{_LOT}(?: and {_LOT})?|{_LETTER})"
OF_IT = (
    rf"(?:it|them|that|this|(?:the|that|this|these|your|its)(?: (?:whole|entire|finished|new|same))? (?:{_FIGURE})|"
    r"(?:(?:the|that|this) )?(?P<patch>(?:COLOR )?PATCH))"
)
_CLOSE = "(?P<close>(?:right|directly|just|immediately|straight) )?"
SIDES = (
    ("in front of", "in front(?: side)? of|before"),
    ("behind", "behind|in back of|at the back of"),
    ("to the left of", "(?:(?:to|on|at) )?(?:the |its )?left(?: hand)?(?: side)? of|left from"),
    ("to the right of", "(?:(?:to|on|at) )?(?:the |its )?right(?: hand)?(?: side)? of|right from"),
    ("next to", "next to|beside|alongside|by the side of|at the side of|adjacent to"),
    ("near", "near|near to|close to|nearby"),
    ("on top of", "on top of|on|onto|upon|atop|on the top of"),
    ("on both sides of", "on both sides of|on each side of|on either side of"),
)
"""How things stand to the figure, and the ways in which that is said with the figure named behind."""
_ALONE = (
    ("in front of", "in front|at the front"),
    ("behind", "behind|at the back|in the back"),
    ("to the left of", "(?:to|on|at) its left(?: hand)?(?: side)?"),
    ("to the right of", "(?:to|on|at) its right(?: hand)?(?: side)?"),
    ("next to", "beside|alongside|next to"),
)
"""The same where it is not named."""
_FREE = tuple((way, said if way not in ("behind", "next to") else "<>") for way, said in _ALONE)
"""Those that cannot be followed by what they are relative to."""
VERB = (
    "(?:(?:please|also|just|i|we|you|can|could|would|like|want|to|should|must|the robot|need) )*(?:put|place|set|"
    "add|lay|"
    "position|stand|build|make|have|leave|there (?:is|are|should be|must be|shall be))(?: also| then)?"
)
BE = (
    "(?:(?:that|which) )?(?:(?:must|should|shall|will|is to|has to|are to|have to|needs to) )?(?:be |is |are "
    ")?(?:also )?(?:"
    "put|placed|set|added|laid|positioned|built|go|goes|come|comes|stand|stands|standing|lie|lies|lying|sit|sits|"
    "sitting|"
    "rest|rests|resting|be|is|are|being|waiting|following|follows|follow)"
)
_LEAD = r"(?P<lead>(?:(?:[,;.:]|and|with|plus|while|where|but|as well as|also|then|afterwards|after that|next) )*)"


def _sides(ways: Sequence[tuple[str, str]]) -> str:
    return "|".join(f"(?P<side{n}>{way})" for n, (_, way) in enumerate(ways))


TOLD = [
    *patterns("named", None,
        rf"{_LEAD}(?:(?P<verb>{VERB}) )?{_THINGS}(?: {BE})? {_CLOSE}(?:{_sides(SIDES)}) {OF_IT}",
        rf"{_LEAD}{_CLOSE}(?:{_sides(SIDES)}) {OF_IT}(?: ,| :)?(?: (?P<verb>{VERB})| {BE})? {_THINGS}"),
    *patterns("alone", None,
        rf"{_LEAD}(?:(?P<verb>{VERB}) )?{_THINGS}(?: {BE})? {_CLOSE}(?:{_sides(_ALONE)})",
        rf"{_LEAD}{_CLOSE}(?:{_sides(_ALONE)})(?: of it)?(?: ,| :| (?P<verb>{VERB})| {BE}) {_THINGS}",
        rf"{_LEAD}{_CLOSE}(?:{_sides(_FREE)})(?: of it)? {_THINGS}"),
]  # fmt: skip
_POINTS = re.compile(r"\b(?:it|its|that|this|them)\b")
_LONG = frozenset({"row", "line", "column", "word"})
"""Blocks that lie at the side of these may be at their ends."""
_COUNT = re.compile(r"\b\d+ (?:blocks|cubes|pieces|elements)\b")
_DONE = re.compile(r"(?:^|[.;,] |and |please )(?:stack|line up) (?!of )")
"""What is to be done may be done with what is told behind it, too."""
_AFTER = frozenset({"then", "afterwards", "next", "after"})
_BOUNDS = frozenset({".", ",", ";", "!", "?", "and", "while", "but", "with", "then"})
_STOPS = frozenset({".", ";", "!", "?"})
_COLOR = rf"\b(?:{'|'.join(lexicon.COLORS)})(?=s?\b)"
_MANY = re.compile(r"\b(?:towers|stacks|rows|lines|columns|walls|squares)\b")
UNBOUND = frozenset({
    "or", "if", "until", "unless", "before", "first", "initial", "initially", "start", "starts", "begin", "begins",
    "already", "each", "every", "both", "swap", "not", "never", "no", "without", "except", "instead", "remove", "take",
    "either", "neither", "nor", "goal", "reverse", "exchange", "replace",
})  # fmt: skip
"""With these it is not clear that what is told is of the figure as it is to be."""
_COUNTED = re.compile(
    r"(?<!of )(?<!from )(?<!with )(?<!using )(?<!x )\b\d+ (?:blocks|cubes|pieces|elements)\b(?! (?:high|tall|wide|"
    r"long))"
)
_NAMED = re.compile(rf"\b(?P<figure>{_FIGURE})s?\b")
_GIVEN = re.compile(r"(?:^|[.;,] )(?:there (?:is|are)|the (?:tower|stack|row|line|wall|pyramid)|we have|given)\b")
"""How a figure is told of that may be there already."""


def without_attached(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], list[Token], str]]:
    """The text of a figure without the stretches that tell what is beside it; the first of those, and what all say."""
    if not UNBOUND.isdisjoint(coded(tokens)) or sum(token.word in _STOPS for token in tokens) > 4:
        return
    rest, stretch, said = list(tokens), list[Token](), list[str]()
    pointed = False
    while len(said) < 3 and (found := _last(rest)) is not None:
        rest, stretch, told, points = found
        if pointed:
            return  # "beside it a white block, and on it a green one": on which?
        pointed = points
        said.insert(0, told)
        yield rest, stretch, " ".join(said)


def _last(tokens: Sequence[Token]) -> tuple[list[Token], list[Token], str, bool] | None:
    """The text without the stretch at its end, that stretch, what it says, and whether it says of "it"."""
    words = coded(tokens)
    while words and words[-1] in _STOPS:
        words.pop()
    text, places = joined(words)
    for n in reversed(range(1, len(words))):
        if words[n] not in _BOUNDS and words[n - 1] not in _BOUNDS:
            continue
        for pattern in TOLD:
            match = pattern.expression.fullmatch(text, places[n])
            if match is None or not _apart(match, pattern.kind, words[:n]):
                continue
            rest = stopped(tokens[:n], tokens[n])
            if said := _told(match, pattern.kind, coded(rest)):
                return rest, list(tokens[n:]), said, _POINTS.search(match[0]) is not None
    return None


def _apart(match: re.Match[str], kind: str, ahead: Sequence[str]) -> bool:
    """Whether what is told is no part of a list of the figure's blocks, and not to be built as the figure is."""
    lead = (match["lead"] or "").split()
    if match.groupdict().get("verb"):
        return kind == "named"
    things = match["things"]
    first = match[0][len(match["lead"] or "") :].startswith(things)
    figure = re.match(rf"(?:a|an|another|one|the) {_SMALL}(?:tower|stack|row|line|one) ", things) is not None
    many = re.match(r"[2-9] |\d\d ", things) is not None or (" and " in things and not figure)
    if many and "with" not in lead:
        return False
    if not first or ahead[-1] in _STOPS or lead[-1:] not in (["and"], [","]):
        return True
    counted = re.match(r"(?:a|an|the|one|another|\d+) ", things) is not None
    return counted or (lead[-1] != "and" and lead[:1] == [","] and ahead[-1] not in lexicon.COLORS)


def _told(match: re.Match[str], kind: str, told: Sequence[str]) -> str:
    """The sentence that tells what is beside the figure of which the rest tells, if that is clear."""
    rest = " ".join(told)
    figures = [found["figure"] for found in _NAMED.finditer(rest)]
    if len(set(figures)) != 1 or len(figures) > 3 or _COUNTED.search(rest) or _MANY.search(rest):
        return ""
    things, figure = match["things"].strip(), figures[0]
    if not match.groupdict().get("verb") and (
        _GIVEN.search(rest) or (kind == "alone" and figure in _LONG) or _DONE.search(rest)
    ):
        return ""
    if match.groupdict().get("patch"):
        return ""  # the figure may be on it, or beside it
    named = _NAMED.search(match[0].replace(things, ""))
    known = re.search(_COLOR, things) if things.startswith("the ") else None
    letter = re.search(r"\b[A-Z]\b", things)
    if (named and named["figure"] != figure) or (known and known[0] in rest) or (letter and letter[0] in told):
        return ""  # it may be one of those of the figure
    if not re.search(rf"{_COLOR}|'\w+'|\b[A-Z]\b|\b(?:rainbow|colors)\b", rest):
        return ""  # nor is it told which blocks make the figure
    things = re.sub(r"(?<=\b)one (?=(?:of|from|with|made|built|out) )", f"{figure} ", things)
    ways = SIDES if kind == "named" else _ALONE
    side = next(way for n, (way, _) in enumerate(ways) if match.groupdict().get(f"side{n}"))
    if side == "on top of" and (_POINTS.search(match[0]) or _COUNT.search(rest)):
        return ""  # on another thing, or one of those that are counted
    verb = "build" if re.search(rf"\b(?:{_FIGURE})\b", things) else "put"
    lead = f"Then {verb}" if _AFTER & set((match["lead"] or "").split()) else verb.capitalize()
    return f"{lead} {things} {match['close'] or ''}{side} the {figure}."
