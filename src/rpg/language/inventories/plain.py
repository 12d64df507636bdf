"""An inventory that is told first, in the words that every rule knows: "there are three green blocks and a mat"."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.inventories.frames import Stock, counted, looks_of, stock_of
from rpg.language.inventories.lots import Lot, Lots, in_each_color
from rpg.language.tokens import Token

STOPS = frozenset({".", "!", ";"})
_ASKING = frozenset({
    "must", "should", "shall", "want", "wants", "wish", "would", "needs", "need", "has", "have", "ought", "may", "can",
    "will", "end", "finally", "final", "finished", "finish", "goal", "task", "aim", "done", "to", "let", "please",
    "result", "finishes", "ends", "like",
})  # fmt: skip
"""Words of what is asked for; without them all may be told of how it looks in the end."""


@dataclass(frozen=True)
class Told:
    """What is told to be there. `looks`: how many blocks of each colour and with each symbol; `closed`: nothing else
    is; `rest`: the words of all that follows; `marks`: the colours of the patches, where that of each is told."""

    looks: Counter[str]
    closed: bool
    rest: tuple[Token, ...]
    marks: frozenset[str] = frozenset()


def told_plainly(tokens: list[Token]) -> tuple[list[Token], Told | None]:
    """The tokens with the inventory that they begin with in plain words, and what it tells."""
    tokens = _in_each_color(tokens)
    parts = sentences(tokens, STOPS)
    stock, used = _first(parts)
    if stock is None and parts and (apart := _set_off(parts[0], len(parts) > 1)) is not None:
        parts = [*apart, *parts[1:]]
        stock, used = _first(parts)
    rest = [token for part in parts[used:] for token in part]
    if stock is None or not rest or (stock.lying and not _asks(parts[used:])):
        return tokens, None
    looks = Counter(_looks(stock.lots))
    told = Told(looks, stock.closed and bool(looks), tuple(rest), _marks(stock.lots))
    return [*in_words(stock, [t for part in parts[:used] for t in part]), *rest], told


def told_behind(tokens: list[Token]) -> Told | None:
    """What a later sentence alone tells of how the blocks look: "build towers of three. Nine red blocks are there."."""
    parts = sentences(tokens, STOPS)
    stocks = [(n, stock) for n, part in enumerate(parts[1:], 1) if (stock := stock_of(bare(part))) is not None]
    if len(stocks) != 1 or any(lot.labels or lot.color is None for lot in stocks[0][1].lots):
        return None
    marks = _marks(stocks[0][1].lots)
    if not marks and any(lot.patch for lot in stocks[0][1].lots):
        return None
    rest = tuple(token for n, part in enumerate(parts) for token in part if n != stocks[0][0])
    told = any(token.word in lexicon.COLOR or token.kind in ("quote", "literal") for token in rest)
    looks = Counter(_looks(stocks[0][1].lots))
    return None if told or not looks else Told(looks, True, rest, marks)


def _in_each_color(tokens: list[Token]) -> list[Token]:
    """ "Two blocks in each of the colours red and blue": two red blocks and two blue ones."""
    if all(token.word != "colors" for token in tokens):
        return tokens
    for n in range(len(tokens)):
        for lots, end in in_each_color(tokens, n):
            return [*tokens[:n], *lots_in_words(lots), *_in_each_color(tokens[end:])]
    return tokens


def _set_off(part: list[Token], more: bool) -> list[list[Token]] | None:
    """ "There are four red blocks, and two of them should be stacked": what there is, and what is asked. `more`: where
    more follows, that may be what is so as well: "... on the table, and a blue one is on it. Swap them."."""
    words = [token.word for token in part]
    for n in reversed(range(2, len(words) - 3)):  # the longest list of what there is
        after = n + 1 + (words[n] in (",", ":", "-") and words[n + 1] == "and")
        joined = words[n] in (",", ":", "and") and (words[after] in _THEY or words[after] in lexicon.NUMBER)
        which = after if words[n] == "," and words[after] in ("which", "that") else 0
        which = n if words[n] in ("which", "that") and words[n - 1] in ("table", "tabletop") else which
        said = _MODAL | _STATES if more and "and" in (words[n], words[after - 1]) else _MODAL
        asked = words[which + 1] in _MODAL if which else joined and not said.isdisjoint(words[after:])
        stock = stock_of(part[:n]) if asked else None
        if stock is None or (which and (any(lot.patch for lot in stock.lots) or not (stock.closed or stock.lying))):
            continue
        they = [part[which].saying("they"), *part[which + 1 :]] if which else part[after:]
        return [[*part[:n], part[n].saying(".")], they]
    return None


_THEY = frozenset({"they", "all", "the", "each", "every", "both", "exactly", "only", "these", "none", "no", "a",
                   "an"})  # fmt: skip
_STATES = frozenset({"is", "are", "lies", "lie", "stands", "stand"})
_MODAL = frozenset({"should", "must", "shall", "have", "need", "ought"})


def bare(part: list[Token]) -> list[Token]:
    """A sentence without its stop."""
    return part[:-1] if part and part[-1].kind == "punct" and part[-1].word in STOPS else part


def _first(parts: Sequence[list[Token]]) -> tuple[Stock | None, int]:
    """What the first sentences tell to be there, and how many of them do."""
    if len(parts) < 2:
        return None, 0
    stock = stock_of(bare(parts[0]))
    used = 1
    if stock is None and (number := counted(bare(parts[0]))) is not None:
        many, noun, lying = number
        lots = looks_of(bare(parts[1]), many, noun)
        stock, used = (None, 0) if lots is None else (Stock(lots, True, lying), 2)
    while stock is not None and used < len(parts) and (more := _further(parts[used])) is not None:
        if not _looks(stock.lots).keys().isdisjoint(_looks(more.lots)):
            break
        stock = Stock((*stock.lots, *more.lots), stock.closed or more.closed, stock.lying or more.lying, stock.beside)
        used += 1
    return stock, used


def _further(part: list[Token]) -> Stock | None:
    """ "There is also a mat.": another sentence of the inventory."""
    more = stock_of(bare(part)) if {"is", "are", "lie", "lies"} & {t.word for t in part} else None
    return None if more is None or more.beside else more


def _asks(parts: Sequence[list[Token]]) -> bool:
    """Whether something is asked for in one of the sentences."""
    if any(token.word in _ASKING for part in parts for token in part):
        return True
    return any(part[0].word in lexicon.COMMANDS for part in parts)


def _looks(lots: Lots) -> dict[str, int]:
    found: Counter[str] = Counter()
    for lot in lots:
        for label in lot.labels:
            found[str(label.value).upper() if label.kind in ("quote", "literal") else label.word.upper()] += 1
        if lot.color is not None and not lot.patch and not lot.labels:
            found[lexicon.COLOR[lot.color.word]] += lot.many
    return found


def _marks(lots: Lots) -> frozenset[str]:
    """The colours of the patches; none where that of one is not told."""
    hues = [lot.color for lot in lots if lot.patch]
    return frozenset(lexicon.COLOR[hue.word] for hue in hues if hue is not None) if None not in hues else frozenset()


def in_words(stock: Stock, said: list[Token]) -> list[Token]:
    """ "there are three green blocks and a mat", in the place of what was said."""
    first, last = said[0], said[-1]
    lots = stock.lots
    several = len(lots) > 1 or lots[0].size > 1
    out = [first.saying("there"), first.saying("are" if several else "is")]
    for n, lot in enumerate(lots):
        if n:
            out.append(_start(lot).saying("and" if n == len(lots) - 1 else ","))
        out += _lot_in_words(lot)
    if stock.beside:
        out += [last.saying("."), *_beside(lots, last)]
    stop = last if last.word in STOPS else last.saying(".")
    return [*out, stop.saying(".")]


def lots_in_words(lots: Lots) -> list[Token]:
    """ "three green blocks and a mat"."""
    out: list[Token] = []
    for n, lot in enumerate(lots):
        if n:
            out.append(_start(lot).saying("and" if n == len(lots) - 1 else ","))
        out += _lot_in_words(lot)
    return out


def _start(lot: Lot) -> Token:
    found = lot.color or (lot.labels[0] if lot.labels else lot.noun)
    assert found is not None
    return found


def _lot_in_words(lot: Lot) -> list[Token]:
    at = _start(lot)
    if lot.labels:
        kind = lot.kind if len(lot.labels) > 1 else lot.kind.removesuffix("s")
        out = [at.saying("the"), at.saying(kind)]
        for n, label in enumerate(lot.labels):
            out += [at.saying("and" if n == len(lot.labels) - 1 else ",")] if n else []
            out.append(label)
        return out
    number = at.saying("a") if lot.many == 1 else _number(at, lot.many)
    return [number, *lot.marks, *([lot.color] if lot.color else []), *([lot.noun] if lot.noun else [])]


def _number(at: Token, many: int) -> Token:
    return Token("number", str(many), str(many), at.span, float(many))


def _beside(lots: Lots, at: Token) -> list[Token]:
    """ "at the start the green block is next to the mat"."""
    out = [at.saying(word) for word in ("at", "the", "start")]
    blocks = [lot for lot in lots if not lot.patch]
    for n, lot in enumerate(blocks):
        out += [at.saying("and" if n == len(blocks) - 1 else ",")] if n else []
        words = _lot_in_words(lot)
        out += words if lot.labels else [at.saying("the"), *words[lot.many == 1 :]]
    several = len(blocks) > 1 or blocks[0].size > 1
    out += [at.saying(word) for word in ("are" if several else "is", "next", "to", "the")]
    mat = next(lot for lot in lots if lot.patch)
    return [*out, *mat.marks, *([mat.color] if mat.color else []), *([mat.noun] if mat.noun else [])]
