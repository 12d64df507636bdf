"""Lists of what there is: "three red blocks, a green one and two mats, one white and one black"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language import lexicon
from rpg.language.inventories.labels import KINDS, labels_at, labels_to
from rpg.language.tokens import Token

Lots = tuple["Lot", ...]


@dataclass(frozen=True)
class Lot:
    """So many things that look alike, or blocks that show `labels`. `noun`: nothing where it is told elsewhere;
    `again`: "one" stands in its place, for what was named before."""

    many: int = 1
    marks: tuple[Token, ...] = ()
    color: Token | None = None
    noun: Token | None = None
    labels: tuple[Token, ...] = ()
    kind: str = ""
    again: bool = False
    theirs: bool = False
    """Patches of the colours of the blocks, one of each."""

    @property
    def size(self) -> int:
        return len(self.labels) or self.many

    @property
    def patch(self) -> bool:
        return self.noun is not None and self.noun.word in lexicon.PATCH


_JOINTS = (
    (",", "and", "also"), (",", "as", "well", "as"), (",", "together", "with"), (",", "along", "with"), (",", "and"),
    (",", "plus"), ("and", "also"), ("as", "well", "as"), ("together", "with"), ("along", "with"), ("and",), (",",),
    ("plus",), ("with",),
)  # fmt: skip
_OF_THEM = (("of", "them"), ("of", "these"), ("of", "those"), ("of", "which"))
_ONES = frozenset({"one", "ones"})
_SOLE = frozenset({"single", "exactly", "just", "only"})
_OTHER = (("the", "other"), ("the", "remaining"), ("and", "the", "other"))
_ARE = frozenset({"is", "are"})
_OPENED = {",": "", ":": "", "(": ")"}
_EACH_OF = (("each", "of"), ("each",), ("each", "in"), ("of", "each", "of"), ("of", "each", "color", ":"))
_EACH = ((",", "one", "of", "each"), (",", "one", "each"), ("(", "one", "of", "each", ")"), (",", "one", "of", "each",
         "color"), ("(", "one", "each", ")"))  # fmt: skip
_MARKS = frozenset({*lexicon.SIZE, *lexicon.SHAPE_ADJECTIVE, "long", "elongated"})
MOST_LOTS = 16


def words_at(tokens: Sequence[Token], i: int, *phrases: Sequence[str]) -> int:
    """The position after the first of `phrases` that stands there, or 0."""
    for phrase in phrases:
        if [t.word for t in tokens[i : i + len(phrase)]] == [*phrase]:
            return i + len(phrase)
    return 0


def count_at(tokens: Sequence[Token], i: int) -> tuple[int, int]:
    """A number and the position after it; no number is 0."""
    if i >= len(tokens):
        return 0, i
    token = tokens[i]
    if token.kind == "number" and isinstance(token.value, float) and token.value.is_integer():
        return int(token.value), i + 1
    if token.word in ("a", "an"):
        return 1, i + 1
    return (lexicon.NUMBER[token.word], i + 1) if token.word in lexicon.NUMBER else (0, i)


def lots_at(tokens: Sequence[Token], i: int, bare: bool = False) -> Iterator[tuple[Lots, int]]:
    """Lists that begin there, longest first. `bare`: colours without a number are of one block each."""
    for first, j in _lot(tokens, i, bare):
        for joint in _JOINTS:
            if j and (k := words_at(tokens, j, joint)):
                for rest, end in lots_at(tokens, k, bare):
                    if len(rest) < MOST_LOTS:
                        yield (*first, *rest), end
        yield first, j


def several_at(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """Things of several looks that are counted at once: "six blocks, three red and three blue", "two each of ..."."""
    yield from _told_apart(tokens, i)
    yield from _in_each(tokens, i)
    yield from _of_each(tokens, i)


def _lot(tokens: Sequence[Token], i: int, bare: bool) -> Iterator[tuple[Lots, int]]:
    yield from several_at(tokens, i)
    yield from _theirs(tokens, i)
    yield from _labelled(tokens, i)
    yield from _colored(tokens, i, bare)


def _colored(tokens: Sequence[Token], i: int, bare: bool) -> Iterator[tuple[Lots, int]]:
    """ "three red blocks", "a large green one", "two of them white", "a mat"."""
    start = i + (i < len(tokens) and tokens[i].word in _SOLE)
    start = (words_at(tokens, start, *_OTHER) or start) if bare else start
    many, j = count_at(tokens, start)
    unsaid = not many and bare
    j = (words_at(tokens, j, *_OF_THEM) or j) if many and bare else j
    j += bare and tokens[j : j + 1] != [] and tokens[j].word in _ONES and j > start
    j += bare and tokens[j : j + 1] != [] and tokens[j].word in _ARE
    j += j < len(tokens) and tokens[j].word in _SOLE and many == 1
    marks = []
    while j < len(tokens) and tokens[j].word in _MARKS:
        marks.append(tokens[j])
        j += 1
    color = tokens[j] if j < len(tokens) and tokens[j].word in lexicon.COLOR else None
    j += color is not None
    if not (many or unsaid):
        return
    lot = Lot(many=many or 1, marks=tuple(marks), color=color)
    noun = tokens[j] if j < len(tokens) else None
    if noun is not None and _fits(noun, lot.many) and (color is not None or noun.word in lexicon.PATCH):
        yield (replace(lot, noun=noun),), j + 1
    elif color is not None:
        ones = noun is not None and noun.word in _ONES
        yield (replace(lot, again=ones),), j + ones


def _fits(noun: Token, many: int) -> bool:
    """Whether a noun is of that many blocks or patches."""
    plural = lexicon.BLOCK.get(noun.word, lexicon.PATCH.get(noun.word))
    return plural is not None and plural == (many > 1)


def total_at(tokens: Sequence[Token], i: int) -> tuple[int, Token | None, str, int]:
    """ "five blocks", "three letter cubes": how many, of what, of which kind, and the position after them."""
    many, j = count_at(tokens, i + (i < len(tokens) and tokens[i].word in _SOLE))
    kind = KINDS.get(tokens[j].word, "") if many and j < len(tokens) else ""
    noun = tokens[j + bool(kind)] if many and j + bool(kind) < len(tokens) else None
    if noun is not None and _fits(noun, many):
        end = j + 1 + bool(kind)
        shown = (
            KINDS.get(tokens[end + 1].word, "") if words_at(tokens, end, ("with",)) and end + 1 < len(tokens) else ""
        )
        if shown:
            return many, noun, shown, words_at(tokens, end + 2, ("on", "them")) or end + 2
        return many, noun, kind, end
    if kind and noun is not None and tokens[j].word.endswith("s"):
        return many, None, kind, j + 1
    return 0, None, "", i


def _told_apart(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "three mats, a red, a blue and a green one", "five blocks (two red and three blue)"."""
    many, noun, kind, j = total_at(tokens, i)
    if many < 2 or noun is None or kind or j >= len(tokens) or tokens[j].word not in _OPENED:
        return
    close = _OPENED[tokens[j].word]
    begin = words_at(tokens, j + 1, ("namely",)) or j + 1
    for lots, end in apart(tokens, begin, many, noun):
        if not close or (end < len(tokens) and tokens[end].word == close):
            yield lots, end + bool(close)


def _theirs(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "(two red and two blue blocks and) mats of the same colours"."""
    at = words_at(tokens, i, ("two",), ("three",), ("the",), ("also",)) or i
    if at < len(tokens) and lexicon.PATCH.get(tokens[at].word) and (end := words_at(tokens, at + 1, *_THEIR_COLORS)):
        yield (Lot(noun=tokens[at], theirs=True),), end


_THEIR_COLORS = (("of", "the", "same", "colors"), ("in", "the", "same", "colors"), ("of", "these", "colors"), ("in",
                 "these", "colors"), ("of", "the", "same", "two", "colors"), ("in", "the", "same", "two", "colors"),
                 ("in", "the", "same", "three", "colors"), ("of", "matching", "colors"), ("in", "matching", "colors"),
                 ("of", "their", "colors"), ("in", "their", "colors"), ("of", "the", "same", "color"))  # fmt: skip


def with_their_patches(lots: Lots) -> Lots | None:
    """The lots with a patch of each colour of the blocks for patches of the same colours; None: they have none."""
    found: list[Lot] = []
    for lot in lots:
        hues = {x.color.word: x.color for x in lots if x.color is not None and not x.patch}
        if lot.theirs and not hues:
            return None
        found += [Lot(color=hue, noun=_numbered(lot.noun, 1)) for hue in hues.values()] if lot.theirs else [lot]
    return tuple(found)


def _in_each(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "two blocks in each of the colours red and blue", "two blocks each of red and blue", "five blocks, all red"."""
    many, noun, kind, j = total_at(tokens, i)
    if not many or noun is None or kind:
        return
    each = words_at(tokens, j, *_IN_EACH)
    for lots, end in _colors(tokens, each) if each else ():
        yield tuple(replace(lot, many=many, noun=noun) for lot in lots), end
    alike = words_at(tokens, j, *_ALL_ALIKE)
    if alike and alike < len(tokens) and tokens[alike].word in lexicon.COLOR:
        yield (Lot(many=many, color=tokens[alike], noun=noun),), alike + 1


def in_each_color(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "Two blocks in each of the colours red and blue", the longest list of colours."""
    found = [(lots, end) for lots, end in _in_each(tokens, i) if len(lots) > 1 and "colors" in _said(tokens[i:end])]
    yield from found[-1:]


def _said(tokens: Sequence[Token]) -> set[str]:
    return {token.word for token in tokens}


def _of_each(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "red, green and blue blocks, two of each"."""
    for lots, j in _colors(tokens, i):
        noun = tokens[j] if j < len(tokens) and _fits(tokens[j], 2) else None
        comma = j + 1 + (noun is not None and j + 1 < len(tokens) and tokens[j + 1].word in (",", "("))
        many, k = count_at(tokens, comma) if noun is not None else (0, 0)
        end = words_at(tokens, k, *_OF_EACH) if many else 0
        if end and comma > j + 1 and tokens[comma - 1].word == "(":
            end = words_at(tokens, end, (")",))
        if end:
            yield tuple(replace(lot, many=many, noun=_numbered(noun, many)) for lot in lots), end


def _colors(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """Colours that are listed, without numbers: two at least."""
    lots: Lots = ()
    while i < len(tokens) and tokens[i].word in lexicon.COLOR:
        lots += (Lot(color=tokens[i]),)
        i += 1
        if len(lots) > 1:
            yield lots, i
        i = words_at(tokens, i, (",", "and"), (",",), ("and",)) or len(tokens)


_IN_EACH = (
    ("in", "each", "of", "the", "colors"), ("in", "each", "of", "the", "colors", ":"), ("of", "each", "of", "the",
    "colors"), ("each", "of"), ("each", "in"), ("of", "each", "of"), ("in", "each", "of"), ("each", "of", "the",
    "colors"), ("each", "in", "the", "colors"), ("of", "each", "of", "these", "colors", ":"),
)  # fmt: skip
_OF_EACH = (("of", "each"), ("of", "each", "color"), ("each",), ("per", "color"), ("of", "every", "color"),
            ("in", "each", "color"), ("of", "each", "kind"))  # fmt: skip
_ALL_ALIKE = ((",", "all"), (",", "all", "of", "them"), (",", "all", "of", "which", "are"), (",", "both"),
              (",", "each", "of", "them"), ("that", "are", "all"), ("which", "are", "all"))  # fmt: skip


def apart(tokens: Sequence[Token], i: int, many: int, noun: Token | None) -> Iterator[tuple[Lots, int]]:
    """How so many things look, told of all of them: "two red, three blue", "two each of red and blue"."""
    each, begin = count_at(tokens, i)
    begin = words_at(tokens, begin, *_EACH_OF) if each else 0
    lists = [(_each_of(lots, each), end) for lots, end in lots_at(tokens, begin, True)] if begin else []
    for lots, end in (*lists, *lots_at(tokens, i, True)):
        if sum(lot.size for lot in lots) != many or any(lot.labels or lot.noun for lot in lots):
            continue
        if all(lot.color for lot in lots):
            named = tuple(replace(lot, noun=_numbered(noun, lot.many)) for lot in lots)
            yield named, words_at(tokens, end, *_EACH) or end


def _each_of(lots: Lots, each: int) -> Lots:
    """So many of each of the colours that are listed."""
    return tuple(replace(lot, many=each) if lot.many == 1 else lot for lot in lots)


def _numbered(noun: Token | None, many: int) -> Token | None:
    """The noun of so many."""
    if noun is None:
        return None
    table = lexicon.BLOCK if noun.word in lexicon.BLOCK else lexicon.PATCH
    if table[noun.word] == (many > 1):
        return noun
    stem = noun.word.removesuffix("es") if noun.word in ("boxes", "patches") else noun.word.removesuffix("s")
    plural = stem + ("es" if stem in ("box", "patch") else "s")
    return noun.saying(plural if many > 1 else stem)


def with_nouns(lots: Lots, told: Token | None = None) -> Lots | None:
    """The lots, "a red, a green and a blue block" being a block each; None where some are of nothing. `told`: what they
    are where none of them says so."""
    out: list[Lot] = []
    for n, lot in enumerate(lots):
        ahead = next((x.noun for x in lots[n:] if x.noun is not None and not x.labels), None)
        before = next((x.noun for x in reversed(out) if x.noun is not None), None)
        if lot.color is not None and ahead is not None and _told_again(lots[n:]):
            ahead = lot.color.saying("block")
        noun = lot.noun or (before if lot.again else ahead or before) or told
        if noun is None and not lot.labels:
            return None
        out.append(lot if lot.labels else replace(lot, noun=_numbered(noun, lot.many)))
    return tuple(out)


def _told_again(lots: Lots) -> bool:
    """Whether lots of nothing begin "two red, two blue, a red mat and a blue mat": the red ones are no mats."""
    end = next((n for n, lot in enumerate(lots) if lot.noun is not None), len(lots))
    of_nothing = {lot.color.word for lot in lots[:end] if lot.color is not None}
    marks = {lot.color.word for lot in lots[end:] if lot.color is not None and lot.patch}
    return end < len(lots) and lots[end].patch and not of_nothing.isdisjoint(marks)


def _labelled(tokens: Sequence[Token], i: int) -> Iterator[tuple[Lots, int]]:
    """ "three letter blocks, A, B and C", "blocks with the digits 7 and 3", "the letter T", "a block marked A"."""
    for kind, many, begin, close in labels_to(tokens, i, count_at):
        for labels, end in labels_at(tokens, begin):
            if many and len(labels) != many:
                continue
            if close and (end >= len(tokens) or tokens[end].word != close):
                continue
            end += bool(close)
            end = words_at(tokens, end, ("on", "them"), ("on", "it")) or end
            yield (Lot(many=len(labels), labels=labels, kind=kind),), end


def labelled(tokens: Sequence[Token], i: int, many: int, kind: str) -> Iterator[tuple[Lots, int]]:
    """The symbols that so many blocks show."""
    for labels, end in labels_at(tokens, i):
        if len(labels) == many:
            yield (Lot(many=many, labels=labels, kind=kind),), end
