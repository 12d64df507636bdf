"""Sides and directions: "from left to right", "at the bottom", "third from the left"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.line_ends import line_end
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import At, Meaning, Toward, replace

SIDES = {
    "left": "left", "right": "right", "top": "top", "bottom": "bottom", "front": "front", "back": "back",
    "near": "front",
    "far": "back", "base": "bottom", "ground": "bottom", "rear": "back", "leftmost": "left", "rightmost": "right",
}  # fmt: skip


OPPOSITE = {"left": "right", "right": "left", "top": "bottom", "bottom": "top", "front": "back", "back": "front"}


AXIS = {"left": "y", "right": "y", "front": "x", "back": "x", "top": "z", "bottom": "z"}


_ME = "me|us|you|viewer|robot|camera|observer"
_GOING = (
    "going|running|leading|heading|extending|stretching|pointing|runs|run|goes|go|leads|extends|stretches|that_goes|"
    "that_runs|which_runs|which_goes|that_leads|that_extends"
)
_AWAY = Patterns(
    f"{_GOING}? straight? away_from the? {_ME}",
    f"{_GOING} straight? away|back|backwards from the? {_ME}",
    f"{_GOING} straight? away|back|backwards",
)
_NEARER = Patterns(f"{_GOING}|coming|comes|that_comes straight? towards|toward|to the? {_ME}")
"""Lines that begin near the viewer, and far from them."""
_EDGE = "edge|side of_the_table|of_the_desk|of_the_workspace?"
_OF_TABLE = "the|its? table_'s|desk_'s|workspace_'s?"
_SIDEWAYS = Patterns(f"running? parallel to|with {_OF_TABLE} front|near|back|far|rear {_EDGE}")
_DEEPWARDS = Patterns(f"running? parallel to|with {_OF_TABLE} left|right {_EDGE}",
                      f"running? perpendicular to {_OF_TABLE} front|near|back|far|rear {_EDGE}")  # fmt: skip
"""Lines by the edges of the table."""
_ENDS = {"left": "y", "right": "y", "bottom": "z", "top": "z", "front": "x", "back": "x"}
_BEGINNING = {
    **{f"{starting} {at} {the}{side}{end}": (side, axis) for starting in ("starting", "beginning", "begin", "start")
       for at in ("from", "at", "on") for side, axis in _ENDS.items() for the in ("the ", "")
       for end in ("", " end", " side", " edge")},
    **{f"{starting} {at} the {far} end": (side, "x") for starting in ("starting", "beginning") for at in ("from", "at")
       for far, side in (("near", "front"), ("far", "back"))},
    **{f"{starting} {near} me": (side, "x") for starting in ("starting", "beginning") for near, side in
       (("nearest to", "front"), ("closest to", "front"), ("farthest from", "back"), ("furthest from", "back"))},
    **{f"{going} {way}": (side, axis) for going in ("going", "moving", "working", "working your way", "progressing")
       for ways, side, axis in (
           (("right", "to the right", "rightwards", "rightward"), "left", "y"), (("up", "upward"), "bottom", "z"),
           (("left", "to the left", "leftwards", "leftward"), "right", "y"), (("down", "downward"), "top", "z"))
       for way in ways},
    "upwards": ("bottom", "z"), "downwards": ("top", "z"), "downward": ("top", "z"),
    "bottom up": ("bottom", "z"), "top down": ("top", "z"), "upward": ("bottom", "z"),
    "from near to far": ("front", "x"),
    **{f"in {side} to {other} order": (side, axis) for side, axis in _ENDS.items() for other in (OPPOSITE[side],)},
    **{f"{starting} with the {utmost}{one}": (side, axis) for starting in ("starting", "beginning")
       for side, axis, *words in (
           ("left", "y", "leftmost"), ("right", "y", "rightmost"), ("front", "x", "nearest", "closest", "frontmost"),
           ("back", "x", "farthest", "furthest"), ("top", "z", "top", "topmost", "uppermost", "highest"),
           ("bottom", "z", "bottom", "bottommost", "lowermost", "lowest"))
       for utmost in words for one in ("", " one")},
    **{f"{word} first": (side, axis) for words, side, axis in (
        (("nearest", "frontmost", "closest", "nearest to me", "closest to me"), "front", "x"),
        (("farthest", "furthest", "farthest away", "furthest away"), "back", "x"),
        (("leftmost", "left end", "left"), "left", "y"), (("rightmost", "right end", "right"), "right", "y"),
        (("topmost", "highest", "uppermost", "top"), "top", "z"),
        (("bottommost", "lowest", "lowermost", "bottom"), "bottom", "z"),
    ) for word in words},
    "from far to near": ("back", "x"), "away from the robot": ("front", "x"), "towards the robot": ("back", "x"),
}  # fmt: skip
"""Where an order begins, and its axis."""
TOWERS = frozenset({"tower", "towers", "stack", "stacks", "stacked", "pile", "piled"})
_ROWS = frozenset({"row", "rows", "line", "lines", "lined"})
_DEEP = _ROWS | {"column", "columns", "file", "queue", "order", "ordered"}
_UPRIGHT = {"from below": "bottom", "from above": "top"}
_SIDEWARD = {"rightwards": "left", "rightward": "left", "leftwards": "right", "leftward": "right"}
"""Of towers, and of rows, these tell where an order begins; else how something is seen, or moved."""
_VALUES = frozenset({"highest", "lowest"})
"""What numbers may be along any line."""
_BIDDING = ("begin", "start")
_SET_OFF = (",", "and")
_ALONG = {
    "horizontally": "y", "vertically": "z", "upright": "z", "along the y axis": "y", "along the x axis": "x",
    "across the table": "y", "lengthwise": "x", "along the left right direction": "y",
    "in left right direction": "y", "in the left right direction": "y", "along the left right axis": "y",
    "along the front back direction": "x", "in front back direction": "x", "in the front back direction": "x",
    "along the front back axis": "x",
}  # fmt: skip
"""The axis of a line."""


_VIEWED = frozenset({"seen", "viewed", "looking", "looked", "watched"})
_READ_OFF = _VIEWED | {
    "reading",
    "read",
    "counting",
    "counted",
    "listed",
    "told",
    "named",
    "written",
    "taken",
    "ordered",
}
"""How a line is told in a direction. "Seen from the left" is no direction, "seen from left to right" is one."""
_ONWARD = frozenset({"to", "towards", "up", "down", "upwards", "downwards", "upward", "downward"})
_FROM = frozenset({"from", "bottom", "top", "left", "right"})
_THE_LINE = tuple(f"{the} {line}" for the in ("the", "this", "that", "along the")
                  for line in ("tower", "stack", "row", "line", "column", "pile"))  # fmt: skip
"""What is read, or gone along, from one end to the other."""
_COUNTED = frozenset({"block", "cube", "brick", "one", "layer", "row", "blocks", "cubes", *lexicon.ORDINAL})
"""What is counted "from the bottom", so that this is no direction."""


@rule
def toward(p: Parser, i: int) -> Results[Meaning]:
    """ "from left to right", "bottom to top", "from the bottom up", "vertically", "starting from the left"."""
    j = p.one(i, "from") or i
    j2 = p.opt(j, "the")
    if first := p.peek(j2, SIDES):
        k = p.reach(j2 + 1)
        k = p.opt(k, "side", "end", "edge")
        if e := p.one(k, ("to", "towards")):
            e = p.opt(e, "the")
            last = SIDES.get(p.words[e]) if e < p.end else None
            if last == OPPOSITE[first]:
                yield (
                    Toward(first=first, axis=AXIS[first], span=p.span(i, e + 1)),
                    p.opt(p.reach(e + 1), "side", "end", "edge"),
                )
        if j2 > j > i and first in ("left", "right") and p.words[k] not in ("to", "towards"):
            yield Toward(first=first, axis="y", span=p.span(i, k)), k
        depth = first in ("front", "back") and p.words[j2] != "near" and p.words[k] not in ("row", "half")
        upright = (first in ("top", "bottom") or depth) and not p.follows(i, _COUNTED)
        if j2 > j > i and upright and not p.stands(k, ("to", "towards", "up", "down", "of", "upwards", "downwards")):
            yield Toward(first=first, axis=AXIS[first], span=p.span(i, k), cost=1), k
        if j2 == j > i and p.words[k] == ":":
            yield Toward(first=first, axis=AXIS[first], span=p.span(i, k)), k
        if p.words[k : k + 1] in (["up"], ["upwards"], ["upward"]) and first == "bottom" and j > i:
            yield Toward(first="bottom", axis="z", span=p.span(i, k + 1)), p.reach(k + 1)
        if p.words[k : k + 1] in (["down"], ["downwards"], ["downward"]) and first == "top" and j > i:
            yield Toward(first="top", axis="z", span=p.span(i, k + 1)), p.reach(k + 1)
    for along in _READ_ALONG.matches(p, i):
        for way, k in toward(p, along) if p.stands(along, _FROM) else ():
            if isinstance(way, Toward) and way.first is not None and not _ONWARD.isdisjoint(p.words[along:k]):
                yield replace(way, span=p.span(i, k)), k
    lead = p.one(i, _READ_OFF)
    lead = p.opt(lead, "at", "off") if lead else 0
    named = p.any_of(lead, _THE_LINE) if lead else 0
    lead = named or lead
    for way, k in toward(p, lead) if lead else ():
        onward = not _ONWARD.isdisjoint(p.words[lead:k]) or p.words[i] not in _VIEWED
        if isinstance(way, Toward) and way.first is not None and onward and (named or p.words[lead] in _FROM):
            yield replace(way, span=p.span(i, k)), k
    for phrase, k in p.standing(i, _BEGINNING):
        side, axis = _BEGINNING[phrase]
        if (p.words[i] in _VALUES or phrase == "going up") and any(token.kind == "number" for token in p.tokens):
            continue  # that of the numbers
        if p.words[i] in _BIDDING and not p.follows(i, _SET_OFF):
            continue  # "the blocks start at the left"
        yield Toward(first=side, axis=axis, span=p.span(i, k)), k
    for lines, begun in ((TOWERS, _UPRIGHT), (_ROWS, _SIDEWARD)):
        for phrase, k in p.standing(i, begun):
            if not p.all.isdisjoint(lines):
                yield Toward(first=begun[phrase], axis=AXIS[begun[phrase]], span=p.span(i, k)), k
    for ways, side in ((_AWAY, "front"), (_NEARER, "back")):
        for k in ways.matches(p, i):
            if p.words[i] != "away" or not p.all.isdisjoint(_DEEP):  # "put the two blocks away from me"
                yield Toward(first=side, axis="x", span=p.span(i, k)), k
    if k := p.any_of(i, ("from its first drawn place on",)):
        yield Toward(first="drawn", span=p.span(i, k)), k
    for axis, ways in (("y", _SIDEWAYS), ("x", _DEEPWARDS)):
        yield from ((Toward(axis=axis, span=p.span(i, k)), k) for k in ways.matches(p, i))
    for phrase, k in p.standing(i, _ALONG):
        yield Toward(axis=_ALONG[phrase], span=p.span(i, k)), k


_READ_ALONG = Patterns(
    ",? that|which is|can_be|may_be|should_be|must_be|is_to_be|has_to_be? read|reads|written",
    ",? so|so_that|such_that|when|if|and|where|that|which you|i|one|we|they|people can|may|should|must? read|reads "
    "it|them?",
    ",? so|so_that|such_that|when|if|and it|they|the_word is|can_be|are|is_to_be|has_to_be? read|reads",
    "to be read",
)
"""What tells from which end a line is read."""
_FLAT = (("row", "row"), ("line", "row"), ("column", "row"))
_WHOLES = (
    *_FLAT, ("stack", "stack"), ("tower", "stack"), ("pile", "stack"), ("pyramid", "pyramid"),
)  # fmt: skip
_WHOLE_OF = {noun: (f"of the {noun}", f"of this {noun}", f"of that {noun}") for noun, _ in _WHOLES}


UTMOST = {
    "leftmost": "left", "rightmost": "right", "topmost": "top", "bottommost": "bottom", "nearest": "front",
    "frontmost": "front", "farthest": "back", "closest": "front", "furthest": "back", "lowermost": "bottom",
    "lowest": "bottom", "highest": "top", "uppermost": "top",
    "up top": "top", "right up top": "top", "down below": "bottom", "at the summit": "top",
}  # fmt: skip
"""Words for the place beyond all others."""
_REACH = Patterns(
    "to the? me|us|you|viewer|robot|camera|observer", "away? from the? me|us|you|viewer|robot|camera|observer", "away"
)
"""What tells that the nearest and the farthest are meant as the viewer has it."""
_LEADS = (
    "at the very", "on the very", "at the", "on the", "in the", "to the", "at", "on", "as the", "as", "being the", "in",
    "forming the",
)  # fmt: skip
_SOMEWHERE = tuple(f"{any_} {at} the" for any_ in ("somewhere", "anywhere") for at in ("on", "to"))
_TAILS = ("end", "side", "most", "layer", "layers", "position", "level", "hand", "block", "spot", "place")
_INSIDES = {**SIDES, "middle": "middle", "center": "middle", "hole": "middle"}


OVER = frozenset({"over", "up", "down", "out"})
_THERE = frozenset({"in", "on", "at"})
"""What these may stand before without saying more: "over on the left"."""


@rule
def at(p: Parser, i: int) -> Results[Meaning]:
    """A place within the structure: "at the bottom", "in the middle", "on the left", "third from the left"."""
    if (j := p.one(i, OVER)) and p.stands(j, _THERE):
        i = j
    if j := p.any_of(i, _LEADS) or p.any_of(i, _SOMEWHERE):
        yield from inside(p, i, j)
    yield from extreme(p, i)
    yield from line_end(p, i)
    if j := p.any_of(i, _EITHER_END):
        yield At(side="end", span=p.span(i, j)), j
    if j := p.any_of(i, _BOTH_ENDS):
        yield At(side="ends", span=p.span(i, j), cost=2), j
    nth = p.opt(i, "the")
    ordinal = p.lex(nth, lexicon.ORDINAL)
    for side, phrases in _FROM_SIDES.items() if ordinal else ():
        if k := p.any_of(p.opt(nth + 1, "one", "block", "cube") if nth > i else nth + 1, phrases):
            yield At(side=side, index=ordinal, span=p.span(i, k)), k


_OF_A_LINE = frozenset({"end", "side"})


def extreme(p: Parser, i: int) -> Results[Meaning]:
    """ "leftmost", "nearest to me", "farthest away"."""
    if p.follows(i, _OF_A_LINE):
        return  # "the end closest to me": which end
    for word, k in p.standing(p.opt(i, "the"), UTMOST):
        side = UTMOST[word]
        far = max(_REACH.matches(p, k), default=0) if side in ("front", "back") else 0
        if p.words[far or k] == "first":  # "leftmost first": how a line is told
            continue
        if far or p.words[k] not in ("to", "from"):
            yield At(side=side, utmost=True, span=p.span(i, far or k)), far or k
        one = p.opt(k, "one", "block", "cube") if p.words[i] == "the" and not far else k
        if one > k and p.words[one] in ("", ".", ",", "and"):
            yield At(side=side, utmost=True, span=p.span(i, one)), one


_FROM_SIDES = {
    side: (f"from the {side}", f"from {side}") for side in ("left", "right", "bottom", "top", "front", "back")
}
_EITHER_END = tuple(
    f"{at} {end}"
    for at in ("at", "on")
    for end in ("an end", "either end", "one end", "any end", "one of the ends", "one of its ends", "the other end",
                "the opposite end")
)  # fmt: skip
"""No certain end."""
OTHER_END = ("the other end", "the other", "the opposite end")
"""Behind "one end" these are the end that is left."""
_BOTH_ENDS = tuple(f"{at} {the} ends" for at in ("at", "on") for the in ("the", "both", "its", "the two", "opposite",
                                                                         "the outer", "its two"))  # fmt: skip
"""Each of two blocks is at one of them."""


_ALONG_X = frozenset({"column", "columns", "line", "file", "queue", "then", "lined"})
"""What has a near and a far end besides the table."""


_IN_A_ROW = frozenset({"row", "line", "lineup", "queue"})
_SQUARE = frozenset({"grid", "grids", "square", "checkerboard", "matrix", "rows", "columns", "array", "near", "corner"})


def far_end(p: Parser, j: int) -> bool:
    """ "far left" where a row is told of and nothing that has corners: its left end."""
    far = p.stands(j, ("far",)) and p.stands(j + 1, ("left", "right"))
    return far and not p.all.isdisjoint(_IN_A_ROW) and p.all.isdisjoint(_SQUARE)


def inside(p: Parser, i: int, j: int) -> Results[Meaning]:
    """A place from i on, whose side is named at j."""
    if p.words[i : i + 3] == ["in", "front", "of"]:
        return  # ahead of all of it, and no place in it
    j = p.opt(j, "exact") if p.stands(j + 1, ("middle", "center")) else j
    word = p.words[j] if j < p.end else ""
    ended = word in ("far", "near") and p.words[j + 1] in ("left", "right") and p.words[j + 2] == "end"
    if ended or far_end(p, j):
        j, word = p.reach(j + 1), p.words[j + 1]
    side = _INSIDES.get(word) if not p.stands(j + 1, ("between",)) else None
    ending = word in ("near", "far") and p.words[j + 1] in ("end", "side") and p.words[j + 2] != "of"
    if side and (ending or word not in ("ground", "near", "far")):
        k = p.opt(p.opt(p.reach(j + 1), *_TAILS), "side")
        most = word in UTMOST
        for noun, whole in _FLAT if side in ("left", "right", "front", "back") else _WHOLES:
            if end := p.any_of(k, _WHOLE_OF[noun]):
                yield At(side=side, whole=whole, utmost=most, span=p.span(i, end)), end
        one_there = p.words[k - 1] in ("block", "leftmost", "rightmost") or side == "middle"
        if p.words[i] == "on" and one_there:  # on top of what is there
            return
        if p.words[i] == "in" and k == j + 1 and p.stands(k, ("tower", "stack")):  # "in the left tower"
            return
        of_it = p.any_of(k, ("of it", "of which")) if side in ("top", "bottom", "middle") else 0
        own = ending and p.words[j + 1] == "end" and p.all.isdisjoint(_ALONG_X)
        yield At(side=side, own=own, utmost=most, span=p.span(i, k)), of_it or k
    counted = word in ("first", "last", *lexicon.ORDINAL)
    if counted and (k := p.any_of(j + 1, ("position", "place", "spot", "from the left"))):
        index = lexicon.ORDINAL.get(word, -1)
        yield At(side="first", index=index, span=p.span(i, k)), k
        for side, phrases in _FROM_SIDES.items():
            if index > 0 and (end := p.any_of(k, phrases)):
                yield At(side=side, index=index, span=p.span(i, end)), end
