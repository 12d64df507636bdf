"""Blocks in groups: by a property, or lot by lot."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from rpg.language.frames.lots import Lot, counted, one
from rpg.language.frames.pieces import Piece, Unclear, number, patterns
from rpg.language.frames.several import LOTS, START, STARTS, STOPS, Gathered, check_clauses, gathered, listed, said_of, settled
from rpg.language.frames.shared import GLUE, WHERE

_G = "(?:group|pile|cluster|bunch|heap|clump|bundle|lot|set|gathering|collection)"
_GS = "(?:groups|piles|clusters|bunches|heaps|clumps|bundles|sets|lots)"
_ADJ = "(?:(?:own|separate|single|little|small|neat|different|big|tidy|distinct|common|proper|clear) )"
_ORD = "first|second|third|fourth|fifth|last|left|right|middle|center"
_IN = "(?:(?:BE )?(?:all )?(?:together )?(?:put |gathered |sorted )?(?:in|into|on|onto|to|forms?|makes?|get|gets|as|inside) )?"
_OF = "(?: (?:of|with|has|have|contains|containing|holds|holding|for|is for|BE|gets|consists of|consisting of|made of|made from|takes|includes|only))*(?: :)?"
_EACH = f"(?:each|every|either|both|any)(?: of the(?: NUM)?)?(?: {_G}s?| {_GS}| one)?(?: of them)?"
_ODD = ("(?:stranger|outlier|odd one out|intruder|misfit|foreigner|odd one|wrong one|wrong BLOCK|foreign BLOCK|stray|stray BLOCK|stray one|exception|"
        "BLOCK (?:of|in|with) (?:the|a|another|an) ?(?:other|wrong|different)? color|(?:BLOCK|one|member) (?:that|which) (?:does|do) not belong(?: there| to it| in it)?)s?")
_KINDS = {
    "vowels": "vowels and consonants", "consonants": "vowels and consonants", "odd": "odd and even", "even": "odd and even",
    "letters": "letters and digits", "digits": "letters and digits",
}  # fmt: skip
"""What blocks are sorted by where one of its classes is told."""
_C = "(?: numbers| digits| ones| cubes?| blocks?| letters| numerals| number BLOCK| digit BLOCK)?"
_SAME = "(?:only |just |exactly )?(?:of |the |a )*(?:one|single|same|only one|just one|its own|one single|one and the same)"

PATTERNS = [
    *LOTS,
    *WHERE,
    *STARTS,
    *STOPS,
    *GLUE,
    *patterns("figure", lambda match: number(match["count"]) if match["count"] else None,
        rf"(?:(?:in|into|to|as|of) )?(?:the )?(?:exactly )?(?:(?P<count>NUM) )?{_ADJ}*{_GS}"),
    *patterns("figure", None, "group|grouped|grouping|cluster|clustered|gather|gathered|gathering|segregate|partition|collect|collected"),
    *patterns("parted", None, "divide|divided|split|split up|separate|separated|separating|sort out|distribute|distributed|keep|kept|keep apart|part"),
    *patterns("glue", None, "sort|sorted|sorting|tidy up|tidied up|own|set apart|in such a way|so that|such that|so|that|up|by themselves|cleanly|clean up|arranged|organized"),
    *patterns("odd", None, "stranger|outlier|intruder|misfit|odd one out"),
    *patterns("size", lambda match: number(match["size"]),
        rf"of (?:exactly )?(?P<size>NUM)(?: BLOCK)?(?: each)?(?! (?:COLOR|SIZE|each)\b)", rf"{_EACH} (?:of|with|has|have|contains?|consists? of) (?:exactly )?(?P<size>NUM)(?: BLOCK)?(?! (?:COLOR|SIZE)\b)"),
    *patterns("even", None, "(?:of )?(?:the )?(?:equal|equally large|equally big|same|equal in|identical)(?: size)?|equally|evenly|in half|into halves|into (?:two )?equal parts"),
    *patterns("basis", "color",
        "(?:by|per|for each|for every|according to|on the basis of|based on|with respect to|depending on|after|for) (?:their |its |the |own )*color",
        "by their colors", "color wise|by matching color",
        rf"one {_ADJ}*{_G} (?:per|for each|for every|of each|of every|for) (?:one )?color",
        rf"(?:a|an) {_ADJ}*{_G} (?:per|for each|for every|of each|of every) color",
        rf"(?:each|every) color (?:BE |has |have |gets |forms |makes |becomes |goes |should have |must have |must form |must be |should form |into |to |in )*(?:a |an |its |one |in )*{_ADJ}*{_G}(?: of its own| for itself| by itself)?",
        rf"(?:each|every) color (?:BE |kept |placed |put |gathered )*(?:by itself|on its own|separately|together|separate|apart)",
        rf"{_EACH} (?:BE |must |should |shall |may |can |has |have |to |contains |contain |show |hold |be |holds |with |consists |consist |only |of |blocks of |cubes of |pieces of |made of |for )*{_SAME} color(?: only| alone)?",
        f"(?:{_GS} |{_G} )?(?:of|with|in) {_SAME} color(?: each| only)?", "(?:same|equal|like) colors? (?:BE )?(?:with |to |and )?(?:(?:same|equal|like) colors?)?(?: ?together)?",
        "(?P<color>COLOR)s? (?:BLOCK )?(?:BE )?with (?P=color)s?(?: BLOCK)?(?: ,)?(?: and)?(?: (?P<other>COLOR)s? (?:BLOCK )?with (?P=other)s?(?: BLOCK)?)*",
        "(?:no|without) (?:mixed colors|mixing(?: of)? (?:the )?colors|color mixing)", "(?:do not|never) mix (?:the )?colors", "colors (?:do not mix|must not mix|BE not mixed|stay apart|BE separate|BE separated)",
        f"no {_G} (?:may |can |should |must )?(?:has|have|contain|contains|mixes|mix) (?:more than one color|2 colors|different colors|several colors)"),
    *patterns("basis", "kind", "(?:by|according to|per) (?:their |its |the )*(?:kind|type|sort|kinds|types)", "letters (?:BE )?with letters(?: ,)?(?: and)? (?:digits|numbers) with (?:digits|numbers)"),
    *patterns("basis", "odd and even", "by (?:their )?parity", "(?:by|into|in|as)? ?(?:odd and even|even and odd|odd or even|even or odd|whether they are odd or even|evenness)(?: numbers| digits| ones)?"),
    *patterns("basis", "vowels and consonants", "(?:by|into|in|according to) (?:vowels and consonants|consonants and vowels|vowel and consonant|vowel or consonant|consonant or vowel|whether they are vowels or consonants)",
        "vowels (?:BE )?with vowels(?: ,)?(?: and)? consonants with consonants"),
    *patterns("basis", "letters and digits", "(?:by|into|in|according to) (?:letters and (?:digits|numbers)|(?:digits|numbers) and letters)"),
    *patterns("basis", "size", "(?:by|according to|per) (?:their |its |the )*size"),
    *patterns("basis", "label", "(?:by|according to|per) (?:their |its |the )*(?:letter|label|symbol|number|digit|letters|labels|numbers)", rf"(?:each|every) (?:letter|number|digit|symbol) (?:BE )?(?:in |forms |has |gets |makes )?(?:its|a|an|one) {_ADJ}*{_G}(?: of its own)?"),
    *patterns("class", "<vowels>", "(?:(?:the|all|all the) )?vowels?(?: letters| BLOCK| ones)?"),
    *patterns("class", "<consonants>", "(?:(?:the|all|all the) )?consonants?(?: letters| BLOCK| ones)?"),
    *patterns("class", "<odd>", rf"(?:(?:the|all|all the) )?(?:odd|uneven){_C}"),
    *patterns("class", "<even>", rf"(?:(?:the|all|all the) )?even{_C}"),
    *patterns("class", "<letters>", "(?:(?:the|all|all the) )?(?:letters|letter BLOCK)"),
    *patterns("class", "<digits>", "(?:(?:the|all|all the) )?(?:digits|numbers|numerals|number BLOCK|digit BLOCK)"),
    *patterns("class", "<rest>", "(?:the )?(?:rest|others|remaining ones|remaining BLOCK|other BLOCK|other ones)(?: of them)?"),
    *patterns("slot", lambda match: match["slot"],
        rf"{_IN}(?:the |a |an |its |their )*(?P<slot>one|a|other|another|{_ORD})(?: (?:hand|side))? {_ADJ}*{_G}{_OF}",
        rf"{_IN}(?:the )?(?P<slot>other|another|{_ORD})(?: one| hand side)?{_OF}",
        rf"in (?P<slot>one)(?: of them)?{_OF}", rf"(?P<slot>one)(?: of them)? (?:of|with|has|contains|containing|holds|holding|for|consists of|consisting of|made of|BE|gets|:)(?: (?:of|for))?",
        rf"{_IN}(?P<slot>a) {_ADJ}*{_G}{_OF}"),
    *patterns("slot", lambda match: match["slot"],
        r"(?:BE )?(?:(?:on|at|to|in) )?(?:the |my )?(?P<slot>left|right)(?: (?:hand )?side| half| end| hand)?(?: of the TABLE)?(?: :)?", "(?:BE |over )?(?P<slot>here|there)(?: :)?",
        f"(?:the )?{_G} (?P<slot>[123])(?: :| =| has| contains| BE| with| gets)"),
    *patterns("strange", lambda match: number(match["count"]),
        rf"(?:with|has|have|contains?|but|there (?:is|are)|leave|leaving|keep|hold|holds|and|having|includes|including|gets|also) (?:only |just |exactly |a |an |always )*(?P<count>NUM)(?: single| lone)? {_ODD}",
        rf"(?:exactly |just |precisely |only )+(?P<count>NUM)(?: single)? {_ODD}", rf"(?P<count>NUM) {_ODD}"),
    *patterns("every", None, rf"(?:(?:in|per|for|to|of|within|inside|among) )?{_EACH}(?: (?:BE|has|have|contains|gets))?", f"per {_G}"),
    *patterns("mixed", lambda match: (match["color"], number(match["count"]), match["other"]),
        rf"(?:with |has |have |there is |and )*(?:exactly |just |a |an )*(?P<count>NUM) (?P<color>COLOR) (?:stranger|outlier|intruder|misfit|BLOCK|one|odd one out)(?: BE)? (?:in|into|among|inside) the (?P<other>COLOR)s? ?(?:ones|BLOCK|{_G})?"),
    *patterns("apart", lambda match: f"at least {match['length']} {match['unit']} apart",
        rf"(?:the )?(?:{_GS} |NUM )?(?:BE )?(?:at least|no less than|minimum) (?P<length>[\d.]+) (?P<unit>cm|mm|centimeters?|centimetres?)(?: of space)? (?:apart|from each other|between (?:them|the {_GS}|the NUM {_GS}|each other)|away from each other|distance(?: between them| between the {_GS})?)"),
    *patterns("glue", None, rf"(?:well |clearly |far |a bit )?(?:apart|separated|separate|distinct)(?: from (?:each other|one another))?", "(?:the )?NUM kinds", "(?:the )?(?:different )?colors"),
]  # fmt: skip
_NAMED = re.compile(rf"\b(?:{_G}|{_GS})\b")
_COMMAND = re.compile("(?:make|build|create|form|put|place|bring|gather|collect|cluster|group|arrange|keep|sort|tidy up|clean up|must|should|shall|want|need)\\b")
_UNIQUE = frozenset({*_ORD.split("|"), "here", "there", "other", "1", "2", "3"})


def _belongs(name: str, look: str) -> bool:
    """Whether a symbol is of a class."""
    match name:
        case "<vowels>":
            return look in tuple("AEIOU")
        case "<consonants>":
            return look in tuple("BCDFGHJKLMNPQRSTVWXYZ")
        case "<odd>":
            return look in tuple("13579")
        case "<even>":
            return look in tuple("02468")
        case "<letters>":
            return len(look) == 1 and look.isalpha()
        case "<digits>":
            return len(look) == 1 and look.isdigit()
    return False


def told(pieces: Sequence[Piece]) -> str:
    """The groups in plain sentences.

    Raises:
        Unclear: it is not told what belongs together, or how many blocks there are.
    """
    check_clauses(pieces)
    pieces = _parted(pieces)
    named = {piece.kind for piece in pieces if piece.kind in ("figure", "parted")}
    if not named and not any(_NAMED.search(piece.words) for piece in pieces if piece.kind in ("slot", "basis")):
        raise Unclear
    found = gathered(pieces)
    figures = {piece.value for piece in pieces if piece.kind == "figure" and piece.value is not None}
    bases = {piece.value for piece in pieces if piece.kind == "basis"}
    classes = [look for look in found.lots if look[:1] == "<"]
    for look in classes:
        bases.add(_KINDS.get(look.strip("<>"), "")) if look != "<rest>" else None
        del found.lots[look]
    if len(bases) > 1 or "" in bases or len(figures) > 1:
        raise Unclear
    basis, count = next(iter(bases), None), next(iter(figures), None)
    total, where, apart = (one(pieces, kind) for kind in ("total", "where", "apart"))
    lots = counted(list(found.lots.values()), total.value if total else None, evenly="even" in [p.kind for p in pieces])
    found.lots = {lot.look: lot for lot in lots}
    if found.places:
        text = _by_lots(pieces, found, basis, count)
    elif basis:
        text = _by_basis(pieces, found, basis, count)
    else:
        text = _without_basis(pieces, found, count)
    text += f" The groups are {apart.value}." if apart else ""
    text += f" All blocks are {where.value}." if where else ""
    return text + (f" {START}" if any(piece.kind == "start" for piece in pieces) else "")


def _parted(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Separate X from Y": what stands on either side is a group."""
    found = list(pieces)
    begin = 0
    for n, piece in enumerate(pieces):
        if piece.kind == "stop":
            begin = n
        if piece.kind != "from":
            continue
        parted = [k for k in range(begin, n) if pieces[k].kind == "parted"]
        blocks = [k for k in range(begin, n) if pieces[k].kind in ("lot", "glyphs", "class")]
        if not blocks or (piece.words == "from" and not (parted and parted[0] < blocks[0])) or piece.words == "out of":
            continue
        end = next((k for k in range(n + 1, len(pieces)) if pieces[k].kind in ("stop", "from", "figure")), len(pieces))
        if "slot" in [p.kind for p in pieces[begin:end]]:
            continue
        found[n] = Piece("slot", f"group {piece.words}", "one")
        found.insert(end, Piece("slot", "group", "other"))
        found.insert(end + 1, Piece("stop", "."))
        return found
    return found


def _strangers(pieces: Sequence[Piece]) -> str:
    """What is said of strangers in the groups.

    Raises:
        Unclear: it is not said of each group, or not one number.
    """
    strange, mixed = one(pieces, "strange"), [piece.value for piece in pieces if piece.kind == "mixed"]
    every = any(piece.kind == "every" for piece in pieces)
    if mixed:
        if strange or every or len(mixed) != 2 or mixed[0] != (mixed[1][2], mixed[1][1], mixed[1][0]):
            raise Unclear
        number_each = mixed[0][1]
    elif strange:
        if not every:
            raise Unclear
        number_each = strange.value
    elif every:
        raise Unclear
    else:
        return ""
    return f" with exactly {number_each} outlier{'s' if number_each > 1 else ''} in each group"


def _by_basis(pieces: Sequence[Piece], found: Gathered, basis: str, count: int | None) -> str:
    """Groups by a property.

    Raises:
        Unclear: there are not so many groups, or a number of blocks is open.
    """
    lots, size = list(found.lots.values()), one(pieces, "size")
    if size:
        lots = [Lot(lot.look, lot.count or size.value) for lot in lots]
        if any(lot.count != size.value for lot in lots) or basis != "color":
            raise Unclear
    if any(lot.count is None for lot in lots) or not lots or any(piece.kind == "odd" for piece in pieces):
        raise Unclear
    sorts = {_of_basis(lot.look, basis) for lot in lots}
    if len(sorts) != (count or len(sorts)) or len(sorts) < 2 or None in sorts:
        raise Unclear
    return f"Group {said_of(lots)} by {basis}{_strangers(pieces)}."


def _of_basis(look: str, basis: str) -> str | None:
    """What a block is by a property."""
    if basis == "color":
        return look.split()[-1] if len(look) > 1 else None
    if basis == "size":
        return look.split()[0] if " " in look else "medium"
    if basis == "label":
        return look if len(look) == 1 else None
    if basis == "kind" and len(look) > 1:
        return "plain"
    names = ["letters", "digits"] if basis == "kind" else basis.split(" and ")
    return next((name for name in names if _belongs(f"<{name}>", look)), None)


def _by_lots(pieces: Sequence[Piece], found: Gathered, basis: str | None, count: int | None) -> str:
    """Groups of which each is told with its blocks.

    Raises:
        Unclear: there are not so many groups, or they are not those of the property.
    """
    places, size = settled(found, _belongs), one(pieces, "size")
    slots = [slot for slot, _ in places]
    told_twice = any(slot in _UNIQUE and slots.count(slot) > 1 for slot in slots)
    if len(places) != (count or len(places)) or told_twice or "other" in slots[:-1] or slots == ["other"]:
        raise Unclear
    if size:
        places = [(slot, [Lot(lot.look, lot.count or size.value) for lot in lots]) for slot, lots in places]
        if any(sum(lot.count or 0 for lot in lots) != size.value for _, lots in places):
            raise Unclear
    if any(lot.count is None for _, lots in places for lot in lots):
        raise Unclear
    sorts = [{_of_basis(lot.look, basis) for lot in lots} for _, lots in places] if basis else []
    if basis and (any(len(of) > 1 for of in sorts) or len(set.union(*sorts)) < len(places)):
        raise Unclear
    strangers = _strangers(pieces)
    if strangers:
        if set(slots) & {"left", "right", "middle", "center"} or any(len(lots) > 1 for _, lots in places):
            raise Unclear
        return f"Group {said_of(lots[0] for _, lots in places)} by {basis or 'color'}{strangers}."
    if len(places) == 1:
        if slots[0] not in ("one", "a") or not _asked(pieces):
            raise Unclear
        return f"Make one group of {said_of(places[0][1])}."
    groups = listed([f"one of {said_of(lots)}" for _, lots in places])
    return f"Make {len(places)} groups, {groups}.{_sides(places)}"


def _asked(pieces: Sequence[Piece]) -> bool:
    """Whether something is to be done: what lies in a heap may be told of the start."""
    return any(_COMMAND.search(piece.words) for piece in pieces if piece.kind in ("figure", "glue", "parted"))


def _sides(places: Sequence[tuple[str, Sequence[Lot]]]) -> str:
    """Where groups are that are told by their sides.

    Raises:
        Unclear: only some have a side, or a group has no block of its own by which it can be named.
    """
    order = [slot if slot != "center" else "middle" for slot, _ in places]
    if not set(order) & {"left", "right", "middle"}:
        return ""
    ways = [["left", "right"], ["left", "middle", "right"]]
    named = order if "other" not in order else [*order[:-1], "right" if order[0] == "left" else "left"]
    if sorted(named) not in [sorted(way) for way in ways]:
        raise Unclear
    by_side = dict(zip(named, (lots for _, lots in places), strict=True))
    names = []
    for side in ("left", "middle", "right"):
        if side not in by_side:
            continue
        elsewhere = {lot.look for other, lots in by_side.items() for lot in lots if other != side}
        lot = by_side[side][0]
        if lot.look in elsewhere or len(by_side[side]) > 1 and len(lot.look) > 1:
            raise Unclear
        names.append(f"the group of {lot.look}" if len(lot.look) == 1 else f"the {lot.blocks}")
    return "".join(f" {a.capitalize()} is left of {b}." if "group" in a else f" {a.capitalize()} are left of {b}." for a, b in pairwise(names))


def _without_basis(pieces: Sequence[Piece], found: Gathered, count: int | None) -> str:
    """One group, equal groups of look-alikes, or as many groups as there are lots.

    Raises:
        Unclear: it is open which blocks belong together.
    """
    lots, size = list(found.lots.values()), one(pieces, "size")
    kinds = [piece.kind for piece in pieces]
    if any(lot.count is None for lot in lots) or not lots or _strangers(pieces) or count is None:
        raise Unclear
    if count == 1 and not size:
        if not _asked(pieces):
            raise Unclear
        return f"Make one group of {said_of(lots)}."
    if len(lots) == 1 and (size or "even" in kinds):
        each = size.value if size else (lots[0].count or 0) // count
        if each * count != lots[0].count:
            raise Unclear
        return f"Split {lots[0].blocks} into {count} groups of {each}."
    ahead = [piece.kind for piece in pieces[: kinds.index("figure")]]
    behind = [piece.words for piece in pieces[kinds.index("figure") + 1 :]][:1]
    if count != len(lots) or "lot" in ahead or "glyphs" in kinds or behind not in (["of"], [":"], [","]) or size:
        raise Unclear
    groups = listed([f"one of {lot.blocks}" for lot in lots])
    return f"Make {count} groups, {groups}."
