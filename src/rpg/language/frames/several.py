"""Several groups or towers side by side: which blocks belong to which of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from re import Match

from rpg.language.frames.lots import Lot, lot_of
from rpg.language.frames.pieces import Pattern, Piece, Unclear, number, patterns

_LETTERS = (
    "the |these |those |my |our |your |all |all the |following |given |just |only |with |showing |labell?ed |named "
    "|called "
)
_NOUN = "(?:letter|digit|number|symbol|character|numeral|sign)s?(?: (?:BLOCK))?|BLOCK|tiles?"
_SAID = (
    "(?:numbered |labell?ed |with |showing |marked |in play |to use |we have |are |is |here |given |: |called |"
    "named |namely |from |\\( )*"
)
_EDGE = (
    "(?! (?:(?:SIZE|more|of|to|by|x|high|tall|each) )?(?:COLOR|BLOCK|groups?|piles?|towers?|stacks?|cm|mm|each|"
    r"high|tall|of|or)\b)"
)
_LIST = (
    r"(?:[A-Z]|[b-z]|a(?= (?:[,a]|[B-Z] (?!BLOCK)))|\d|one(?= ,? ?[2-9])|'[A-Z]')(?:(?: ,)?(?: and)?(?: the)? (?:[A-Z]|"
    rf"(?<=[,d] )a|[b-z]|\d|one|'[A-Z]')(?! [A-Za-z]?BLOCK\b))+{_EDGE}"
)
_RANGE = r"(?:from )?(?:[A-Z]|\d|one) (?:to|through|up to|till|until) (?:[A-Z]|\d)" + _EDGE
_ONE = r"(?:[A-Z]|\d|'[A-Z]')" + _EDGE


def glyphs(said: str) -> tuple[str, ...]:
    """The symbols of a list such as "A , B and C", or from the first to the last: "1 to 6"."""
    words = [word.strip("'") for word in said.split()]
    found = [
        "1" if word == "one" else word.upper() for word in words if (len(word) == 1 and word != ",") or word == "one"
    ]
    if {"to", "through", "till", "until"} & set(words):
        return tuple(map(chr, range(ord(found[0]), ord(found[1]) + 1)))
    return tuple(found)


def _listed(match: Match[str]) -> tuple[str, ...]:
    return glyphs(match["list"])


GLYPHS: list[Pattern] = [
    *patterns(
        "glyphs", _listed,
        f"(?:{_LETTERS})*(?:(?:{_NOUN}) )(?:{_SAID})(?P<list>{_LIST}|{_RANGE}|{_ONE})(?: BLOCK)?(?: \\))?",
        f"(?:the )?(?P<list>{_LIST}|{_RANGE})", "(?:the |a |an )?(?P<list>[A-HJ-Z])(?: BLOCK)?",
        "(?:the )?(?P<list>I)(?: BLOCK)?(?! [a-z])",
    ),
    *patterns(
        "glyphs", lambda match: (match["list"],) * number(match["count"]),
        r"(?:the )?(?P<count>\d) (?P<list>[A-Z])(?: BLOCK)?",
        r"(?:the )?(?P<count>\d) (?:BLOCK|letters|tiles) (?:with|showing|labell?ed|marked) (?:an? |the letter "
        r")?(?P<list>[A-Z])(?! ,? ?(?:and )?[A-Z]\b)",
    ),
]  # fmt: skip
"""Lists of symbols."""
LOTS: list[Pattern] = [
    *patterns("lot", None,
        r"(?:(?P<det>the|these|those|my|our|your|all|all the|both|both the|a|an|exactly|just|only|every|with) )?"
        r"(?:(?P<count>NUM) )?(?:of the |of )?(?:(?P<size>SIZE) )?(?:plain )?(?P<color>COLOR)(?P<many>s)?"
        r"(?: (?P<behind>SIZE))?(?: (?P<noun>BLOCK|ones|one(?! (?:COLOR|of|pile|group|heap|tower|stack))))?"
        r"(?: \( (?P<paren>NUM)(?: BLOCK| of them)? \)| , (?P<among>NUM) of them(?: ,)?)?"),
    *patterns(
        "total", lambda match: number(match["count"]),
        "(?:of |from |with |using )?(?:the |all |exactly |all the |these |those )?(?P<count>NUM) (?:identical |"
        "plain )?BLOCK(?: in total| in all| altogether| overall)?",
        "(?P<count>NUM) (?:in total|in all|altogether|overall)",
        "there (?:are|is) (?P<count>NUM) of them(?: in total| in all)?",
    ),
    *patterns(
        "each", lambda match: number(match["count"]),
        "(?:(?:exactly|there are|with|always) )?(?P<count>NUM) (?:BLOCK )?(?:each(?: of| in)?|apiece|(?:of|in|per|"
        "for) (?:each|every) color|of (?:each|every|both)(?: one| kind| color)?)",
        "(?:exactly )?(?P<count>NUM) (?:BLOCK )?each",
    ),
    *GLYPHS,
]  # fmt: skip
"""Lots as in `lots`, but "the other red" is not one; and lists of symbols."""
_HEAP = (
    "(?:(?:all|mixed up|jumbled|mixed|together|out|lying|thrown|tossed) )*(?:in|as|on) (?:a|one) (?:(?:big|single|"
    "messy|random|large|mixed) )*(?:heap|pile|jumble)(?: on the TABLE)?"
)
_BEGIN = (
    "starts?|begins?|starts? out|begins? out|starts? off|are now|are at present|are at the moment|are currently|"
    "now lie|currently lie"
)
START = "At the start, the blocks are in a heap."
STARTS: list[Pattern] = patterns(
    "start", None, f"(?:(?:which|that|they|all|the BLOCK|now) )*(?:{_BEGIN}) {_HEAP}(?: now| at first)?",
    f"(?:(?:which|that|they|all|the BLOCK) )*(?:are|lie|is) {_HEAP} (?:now|at first|at the start|at the beginning|"
    "initially|to begin with|at the moment|right now)",
    "(?:at first|at the start|at the beginning|initially|to begin with|right now|now)(?: ,)? (?:(?:they|all|the "
    f"BLOCK|everything) )*(?:are|lie|is) {_HEAP}",
)  # fmt: skip
"""Kind "start": what is said of the blocks before they are moved."""
OF = (
    "(?:of|in|with|from|for|is for|has|have|having|contains|contain|containing|comprises|comprise|comprising|holds|"
    "hold|holding|includes|include|including|takes|gets|uses|using|BE|shall|should|must|has to|ought to|to|be|"
    "consists of|consist of|consisting of|composed of|made of|made out of|made from|made up of|made only of|made|"
    "built|built of|built from|formed by|formed of|formed from|out of|all|entirely|only|purely|completely)"
)
"""What stands between a group or a tower and its blocks."""
ALSO: list[Pattern] = patterns(
    "glue",
    None,
    "ought to|is to|supposed to|desired|wanted|required|needed|expected|result|results|resulting|emerge|erected|"
    "raised|erect|raise|take|become|becomes|turn into|turned into|end up|ends up|them|these|those|they|that have|"
    "hold|holds|comprise|available|given|that is to say|following|the following|in other words|namely|make up|"
    "makes up|its|let there be|is what (?:I|i|we) (?:want|need)|what (?:I|i|we) (?:want|need) (?:is|are)",
)
"""More words that say nothing beside what several things are made of."""
STOPS: list[Pattern] = [
    *patterns(
        "stop", None, "[.;!?:]",
        "(?:by |when )?(?:using|use|there (?:are|is)|we have|i have|you have|given)(?: got)?",
    ),
    *patterns("from", None, "from|out of|apart from|away from|separate from|separated from"),
    *patterns("break", None, "[,()&]", "and|with|while|where|but|whereas|plus|n"),
]  # fmt: skip
"""Behind a stop the blocks of one thing are not those of the thing before."""


@dataclass
class Gathered:
    """Blocks by look: all of them, and those of each place that is told, in the order of the text."""

    lots: dict[str, Lot] = field(default_factory=dict)
    places: list[tuple[str, dict[str, Lot]]] = field(default_factory=list)


def said_of(lots: Iterable[Lot], noun: str = "the blocks ") -> str:
    """Blocks as they are told in a list: "2 red blocks, A and B"."""
    lots = list(lots)
    shown = [lot.look for lot in lots if len(lot.look) == 1 for _ in range(lot.count or 1)]
    plain = [lot.blocks for lot in lots if len(lot.look) > 1]
    if shown and plain:
        plain += [f"1 {glyph} block" for glyph in shown]
    elif shown:
        return (noun if len(shown) > 1 else "") + listed(shown)
    return listed(plain)


def listed(words: Sequence[str]) -> str:
    """ "a, b and c"."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def lots_in(piece: Piece) -> list[Lot]:
    """The lots that a piece of the kind "lot" or "glyphs" names; a class of symbols is one: "<vowels>"."""
    if piece.kind == "lot":
        lot, said = lot_of(piece), piece.named
        if "paren" in said or "among" in said:
            count = number(said.get("paren") or said["among"])
            if lot.count not in (None, count):
                raise Unclear
            return [replace(lot, count=count)]
        left_open = "count" not in said and "noun" not in said and said.get("det") not in ("a", "an")
        return [replace(lot, count=None) if left_open else lot]
    if piece.kind == "class":
        return [Lot(piece.value)]
    return [Lot(glyph, count) for glyph, count in Counter(piece.value).items()]


def _added(lots: dict[str, Lot], new: Lot) -> None:
    """A lot put to others: told again it is the same one.

    Raises:
        Unclear: it has another number.
    """
    old = lots.get(new.look)
    if old and old.count and new.count and old.count != new.count:
        raise Unclear
    if old and new.count and not new.known and len(new.look) > 1:
        raise Unclear  # "a red block" beside red blocks that were told before
    lots[new.look] = old if old and old.count else new


def _stretches(pieces: Sequence[Piece]) -> tuple[list[Piece], list[tuple[str, list[Piece]]]]:
    """What stands with no place, and what stands with each: all places stand before their blocks, or all behind."""
    free: list[Piece] = []
    placed: list[tuple[str, list[Piece]]] = []
    part: list[Piece] = []
    for n, piece in enumerate([*pieces, Piece("stop", ".")]):
        if piece.kind in ("lot", "glyphs", "class", "slot"):
            part.append(piece)
        if piece.kind not in ("stop", "from") or (piece.words == ":" and pieces[n - 1].kind == "slot"):
            continue
        if any(p.kind == "slot" for p in part):
            _place(part, free, placed)
        else:
            free += part
        part = []
    return free, placed


def _without_stock(part: list[Piece], kinds: list[bool], free: list[Piece]) -> list[Piece]:
    """The places and their blocks, without those told ahead or behind of which all of them are.

    Raises:
        Unclear: there are none such, or they may be either.
    """
    first, last = kinds.index(True), len(kinds) - kinds[::-1].index(True)
    ahead, behind = part[:first], part[last:]
    classes = all(p.kind in ("slot", "class") for p in part[:last]) and all(p.kind == "glyphs" for p in behind)
    placed_first = classes or _are_of(part[:last], behind)
    if placed_first is _are_of(part[first:], ahead):
        raise Unclear
    free += behind if placed_first else ahead
    return part[:last] if placed_first else part[first:]


def _are_of(placed: Sequence[Piece], stock: Sequence[Piece]) -> bool:
    """Whether the looks of the blocks at the places are those of the stock."""
    return {_look(p) for p in placed if p.kind != "slot"} == {_look(p) for p in stock}


def _look(piece: Piece) -> object:
    return lot_of(piece).look if piece.kind == "lot" else piece.value


_BARE = frozenset({"group", "pile", "cluster", "bunch", "heap", "tower", "stack", "pillar"})
"""Names of things that are told with no article."""


def _place(part: list[Piece], free: list[Piece], placed: list[tuple[str, list[Piece]]]) -> None:
    """Put what is told between two stops to the places, or to what has none.

    Raises:
        Unclear: a place without blocks, or blocks without a place.
    """
    kinds = [piece.kind == "slot" for piece in part]
    if kinds[0] and kinds[-1]:
        raise Unclear
    if not kinds[0] and not kinds[-1]:
        part = _without_stock(part, kinds, free)
        kinds = [piece.kind == "slot" for piece in part]
    runs = [list(run) for _, run in groupby(part, lambda piece: piece.kind == "slot")]
    for n in range(0, len(runs), 2):
        slots, blocks = (runs[n], runs[n + 1]) if kinds[0] else (runs[n + 1], runs[n])
        if len(slots) > 1:
            raise Unclear
        if not kinds[0] and not placed:
            again = [k for k, p in enumerate(blocks) if any(_same(p, q) for q in blocks[:k])]
            free += blocks[: again[0]] if again else []
            blocks = blocks[again[0] :] if again else blocks
        placed.append(("one" if slots[0].value in _BARE else slots[0].value, blocks))


def _same(one: Piece, other: Piece) -> bool:
    return one.kind == other.kind == "lot" and lot_of(one).look == lot_of(other).look


def gathered(pieces: Sequence[Piece]) -> Gathered:
    """The blocks and their places.

    Raises:
        Unclear: a lot is told with two numbers, or a place has no blocks.
    """
    free, placed = _stretches(pieces)
    found = Gathered()
    each = {piece.value for piece in pieces if piece.kind == "each"}
    for lot in (lot for piece in free for lot in lots_in(piece)):
        _added(found.lots, lot)
    for slot, said in placed:
        found.places.append((slot, _together(said)))
    if len(each) > 1:
        raise Unclear
    if not found.lots and not {"left", "right"} & {slot for slot, _ in found.places}:
        for _, here in found.places:
            here |= {look: replace(lot, count=lot.count or max(each, default=None)) for look, lot in here.items()}
    for look, lot in found.lots.items():
        found.lots[look] = replace(lot, count=lot.count or max(each, default=None))
    return found


def _together(said: Sequence[Piece]) -> dict[str, Lot]:
    """The blocks of one place; "red, red, blue" is a list of single blocks.

    Raises:
        Unclear: a lot is told twice, and not in such a list.
    """
    lots = [lot for piece in said for lot in lots_in(piece)]
    looks = Counter(lot.look for lot in lots)
    if len(looks) < len(lots):
        bare = all(piece.kind == "lot" and not piece.named.keys() & {"many", "noun", "det", "count"} for piece in said)
        if not bare:
            raise Unclear
        return {look: Lot(look, count) for look, count in looks.items()}
    return {lot.look: lot for lot in lots}


def settled(found: Gathered, belongs: Callable[[str, str], bool]) -> list[tuple[str, list[Lot]]]:
    """Each place with its blocks, where every block has one. `belongs`: whether a class ("vowels") has a symbol.

    Raises:
        Unclear: blocks without a place, or with several; or numbers that do not agree.
    """
    places = [(slot, _members(here, found, belongs)) for slot, here in found.places]
    looks = [look for _, here in places for look in here]
    for look, lot in found.lots.items():
        told = [here[look].count for _, here in places if look in here]
        if not told or (None in told and len(told) > 1):
            raise Unclear
        if lot.count and None not in told and sum(count or 0 for count in told) != lot.count:
            raise Unclear
    if any(looks.count(look) > 1 and here[look].count is None for _, here in places for look in here):
        raise Unclear
    return [
        (
            slot,
            [
                replace(lot, count=lot.count or (found.lots[look].count if look in found.lots else None))
                for look, lot in here.items()
            ],
        )
        for slot, here in places
    ]


def _members(here: dict[str, Lot], found: Gathered, belongs: Callable[[str, str], bool]) -> dict[str, Lot]:
    """The blocks of a place, where those of a class are told one by one elsewhere.

    Raises:
        Unclear: a class that no symbol belongs to, or a symbol beside a class that it does not belong to.
    """
    classes = [look for look in here if look[:1] == "<"]
    own = {look: lot for look, lot in here.items() if look[:1] != "<"}
    if not classes:
        return own
    if own:
        if len(classes) > 1 or not all(belongs(classes[0], look) for look in own):
            raise Unclear
        return own
    elsewhere = {look for _, other in found.places for look in other if other is not here}
    rest = "<rest>" in classes
    members = {
        look: replace(lot, count=None)
        for look, lot in found.lots.items()
        if any(belongs(name, look) for name in classes)
        or (rest and look not in elsewhere and not any(belongs(name, look) for name in elsewhere))
    }
    if not members:
        raise Unclear
    return members


def check_clauses(pieces: Sequence[Piece]) -> None:
    """No letter A was taken for an article, and a place on the table is that of all the blocks.

    Raises:
        Unclear: else.
    """
    for n, piece in enumerate(pieces):
        behind = pieces[n + 1] if n + 1 < len(pieces) else Piece("stop", ".")
        if piece.kind == "glue" and piece.words == "a" and behind.kind in ("glyphs", "stop", "break"):
            raise Unclear
        if piece.kind != "where":
            continue
        ends = [k for k in range(n) if pieces[k].kind in ("stop", "break")]
        clause = {p.kind for p in pieces[ends[-1] if ends else 0 : n]}
        if clause & {"lot", "glyphs", "class", "slot"} and "figure" not in clause:
            raise Unclear  # "..., the letters on the blue patch"
