"""A text told again by the one family that knows all of its parts."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import groupby, product

from rpg.language import lexicon
from rpg.language.frames.around import attached, beside, changed, measured, moments, turned
from rpg.language.frames.around.attached import without_attached
from rpg.language.frames.around.beside import without_distractors
from rpg.language.frames.around.changed import changes
from rpg.language.frames.around.given import existing, with_given
from rpg.language.frames.around.measured import without_measures
from rpg.language.frames.around.paired import pairs
from rpg.language.frames.around.turned import without_turns
from rpg.language.frames.families import FAMILIES, LAST, LATER, Family
from rpg.language.frames.lots import check_joined
from rpg.language.frames.pieces import CLASSES, Piece, Unclear, coded, cut
from rpg.language.frames.relations import relations
from rpg.language.frames.shared import asked
from rpg.language.tokens import Token, tokenize

_ENDS = frozenset({".", "!", "?", ";"})
_LEADS = frozenset({"please", "then", "now", "you", "to", ",", "and", "first", "just", "should"})
"""Behind these a command may begin."""
_BINDING = frozenset({
    "another", "other", "others", "same", "again", "after", "afterwards", "before", "then", "first", "finally", "next",
    "initial", "initially", "start", "starting", "begin", "beginning", "goal", "end", "ends", "until", "or", "if", ":",
    "second", "least", "most",
})  # fmt: skip
"""With these, sentences do not stand for themselves."""
_REFERRING = frozenset({"it", "they", "this", "these", "them", "those", "all", "both", "each"})
"""A sentence that begins with these is of what is told before it."""
_ANY = re.compile(r"(?:from|Lay) \d+ blocks|^There (?:is|are) |The blocks do not touch")
"""Blocks of no told look may be those that another sentence names, what there is may be there already, and "the blocks"
that are not to touch would be all."""
_ONE_OF = re.compile(r"\bone (?:of|is|has) ")
"""What one of the blocks of another sentence is like, or where it is."""
_ALL = re.compile(r"\bthere (?:is|are) \w+ (?:blocks?|cubes?)(?= ?[.,;!?]|$)", re.IGNORECASE)
"""So many blocks may be all that the other sentence names."""
_ASKS = frozenset({"is", "are", "was", "were", "does", "did", "has", "why", "how", "what", "which", "where", "who"})
"""A text that begins with these is a question."""
_HAVE_ASKED = [["have", who] for who in ("you", "we", "they")]
_MOST = 120
"""Longer texts are not told again."""


def retold(tokens: list[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text in plain sentences, and the words of that: all of it, or its first or last part, where the other part
    is left as it is. Most of the text comes first. Told words stand where what they tell again stands."""
    if not 0 < len(tokens) <= _MOST or tokens[0].word in _ASKS or [t.word for t in tokens[:2]] in _HAVE_ASKED:
        return
    given = [(start, behind) for start, _, behind in with_given(tokens, plainly)]
    yield from ((standing(told, tokens), told) for told in changes(tokens, plainly, given))
    if not given:  # else what is there already would be told as what is to be built
        yield from _as_a_whole(tokens)
    yield from ((standing(told, tokens), told) for told in pairs(tokens, plainly))
    yield from _with_given(tokens)
    asides = (without_distractors, without_turns, without_measures, without_attached)
    for without, (rest, stretch, aside) in ((way, found) for way in asides for found in way(tokens)):
        rest = beside.stopped(rest, stretch[0])
        if without is without_attached:  # "it" may be another thing where the rest is no figure by itself
            whole = asked(plainly(rest) or "")
            told = [(standing(whole, rest), whole)] if whole else []
        else:
            told = [(rest, _text(rest)), *_as_a_whole(rest)]
        stands = standing(aside, stretch)
        if without is without_turns and rest and stretch[-1].span < rest[0].span:  # what is there is told at the front
            told = [([*stands, *plain], f"{aside} {said}") for plain, said in told]
            stands, aside = [], ""
        for plain, said in told if rest else [([], "")]:
            yield [*plain, *stands], f"{said} {aside}".strip()
    if not _BINDING.isdisjoint(token.word for token in tokens):
        return
    parts = [
        (ahead, behind)
        for ahead, behind in _parted(tokens)
        if (commands(ahead) or not commands(behind)) and behind[0].word not in _REFERRING
    ]
    for ahead, behind in reversed(parts):
        if (first := plainly(ahead)) is not None and not _ANY.search(first) and _by_itself(behind):
            first = asked(first)
            yield [*standing(first, ahead), *behind], f"{first} {_text(behind)}"
    for ahead, behind in parts:
        if (last := plainly(behind)) is not None and not _ANY.search(last) and _by_itself(ahead):
            yield [*ahead, *standing(last, behind)], f"{_text(ahead)} {last}"


def _by_itself(tokens: Sequence[Token]) -> bool:
    """Whether what a sentence says does not hang on what is told again beside it."""
    text = _text(tokens)
    return not _ALL.search(text) and not _ONE_OF.search(text)


_LEADS_TO = {"start": ("At the start,", "At the start:"), "end": ("", "At the end,", "At the end:"), "": ("",)}


def _as_a_whole(tokens: list[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text of one figure, or with plain words that lead to what is said of the start, and of the end."""
    if (whole := plainly(tokens)) is not None:
        yield standing(whole, tokens), whole
    parts = moments.told_in_time(tokens)
    for leads in product(*(_LEADS_TO[part.moment] for part in parts)) if parts else ():
        out: list[Token] = []
        for lead, part in zip(leads, parts, strict=True):
            alone = part.moment == "end" and not lead and len(parts) == 1  # else its blocks may be told before
            said = plainly(part.said) if alone else None
            told = [*part.said, part.said[-1].saying(".")] if said is None else standing(said, part.said)
            out += [*standing(lead, part.lead or part.said), *told]
        yield out, _text(out)


_TURNED = frozenset({"turn", "upside", "it"})


def _with_given(tokens: list[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text with the figure that is there already told again, and what is to be done as it is or told again."""
    for start, ahead, behind in (*with_given(tokens, plainly), *existing(tokens, plainly)):
        words = {token.word for token in behind}
        if words >= _TURNED or ("it" in words and "is on" in _text(ahead)):
            continue  # the blocks of it, or their order? what is on it, or all of it?
        sentences = re.findall(r"[^.]+\.", start)
        begun = [token for n, text in enumerate(sentences) for token in standing(text, ahead[min(n, len(ahead) - 1) :])]
        yield [*begun, *behind], f"{start} {_text(behind)}"
        if (aim := plainly(behind)) is not None:
            yield [*begun, *standing(aim, behind)], f"{start} {aim}"


def words() -> frozenset[str]:
    """Every word that is known here."""
    told = [
        *attached.TOLD,
        *beside.TOLD,
        *changed.TOLD,
        *measured.TOLD,
        *turned.PATTERNS,
        *(pattern for known, _ in (*FAMILIES, *LATER, *LAST) for pattern in known),
    ]
    texts = [*CLASSES.values(), *(pattern.text for pattern in told), *(lead.pattern for _, lead in moments.PATTERNS)]
    return frozenset(word for text in texts for word in re.findall(r"(?<![<a-z\\])[a-z]{2,}", text))


def plainly(tokens: Sequence[Token]) -> str | None:
    """What the one family that knows all the words says of them; None where none does, or several differ."""
    said = coded(tokens)
    if _misnamed(said):
        return None
    besides = _told_besides(tokens)
    found = next(filter(None, (_tellings(said, tier, besides) for tier in (FAMILIES, LATER, LAST))), set[str]())
    return found.pop() if len(found) == 1 else None


def _tellings(said: Sequence[str], families: Sequence[Family], besides: bool) -> set[str]:
    """What families tell that know all the words."""
    found: set[str] = set()
    for known, told in families:
        if besides and told is not relations.told:
            continue
        pieces = cut(said, known)
        try:
            check_joined(pieces or [])
            found |= {told(pieces)} if pieces and not _placed_apart(pieces) else set()
        except Unclear:
            continue
    return found


def _misnamed(words: Sequence[str]) -> bool:
    """Whether symbols are called what they are not, as "the digits A to D", or one kind is named twice for two."""
    letters = any(re.fullmatch("[A-Z]", word) for word in words)
    digits = re.search(r"\b\d(?:-| to | through )\d\b", " ".join(words)) is not None
    named = {_KINDS[word] for word in words if word in _KINDS}
    twice = [word for word in ("vowels", "consonants") if words.count(word) > 1]
    alone = bool(twice) and not {"vowels", "consonants"} <= {*words}
    return alone or (named == {"digit"} and letters and not digits) or (named == {"letter"} and digits and not letters)


_KINDS = {"letters": "letter", "letter": "letter", "digits": "digit", "digit": "digit", "numbers": "digit"}


def _told_besides(tokens: Sequence[Token]) -> bool:
    """Whether a later sentence tells what there is, "there is (also) a yellow block", where blocks are told before."""
    known = False
    for n, token in enumerate(tokens):
        said = [word.word for word in tokens[n : n + 6]]
        begins = n > 0 and tokens[n - 1].word in _ENDS and said[:2] in (["there", "is"], ["there", "are"])
        begins = begins and "them" not in said
        if begins and (known or "also" in said):
            return True
        known = known or token.word in lexicon.COLOR or (n > 0 and len(token.raw) == 1 and token.raw.isupper())
    return False


def _placed_apart(pieces: Sequence[Piece]) -> bool:
    """Whether blocks of their own have a place beside a figure of others: "a tower of two red blocks; the blue block on
    the mat". Behind an "and" or a comma they may belong to the figure, unless they are "the" ones."""
    return _apart(pieces, frozenset(".;!?"), "") or _apart(pieces, frozenset([*".;!?,", "and"]), "the ")


def _apart(pieces: Sequence[Piece], stops: Collection[str], lead: str) -> bool:
    placed = built = False
    for stop, part in groupby(pieces, lambda piece: piece.kind in ("break", "stop") and piece.words in stops):
        said = list(part)
        kinds = {piece.kind for piece in said}
        lots = [piece for piece in said if piece.kind == "lot"]
        where = "where" in kinds or any(piece.words.endswith("on the table") for piece in said)
        figure = not _FIGURES.isdisjoint(kinds)
        placed = placed or (not stop and where and not figure and any(lot.words.startswith(lead) for lot in lots))
        built = built or (not stop and figure and bool(lots))
    return placed and built


_FIGURES = frozenset({"figure", "slot"})


def commands(tokens: Sequence[Token]) -> bool:
    """Whether a sentence asks for something to be done; one that only describes may tell of the start."""
    begins = [0, *(n + 1 for n, token in enumerate(tokens) if token.word in _ENDS or token.word in _LEADS)]
    return any(tokens[n].word in lexicon.COMMANDS for n in begins if n < len(tokens))


def _parted(tokens: list[Token]) -> Iterator[tuple[list[Token], list[Token]]]:
    """The text in two parts of whole sentences."""
    for n in range(1, len(tokens) - 1):
        if tokens[n].word in _ENDS and tokens[n + 1].word not in _ENDS:
            yield tokens[: n + 1], tokens[n + 1 :]


def standing(text: str, told: Sequence[Token]) -> list[Token]:
    """The words of a text that stands where what it tells again stands."""
    span = (told[0].span[0], told[-1].span[1])
    return [replace(token, span=span) for token in tokenize(text)[0]]


def _text(tokens: Sequence[Token]) -> str:
    return re.sub(
        r" (?=[,.;:!?])", "", " ".join(raw for (_, raw), _ in groupby((token.span, token.raw) for token in tokens))
    )
