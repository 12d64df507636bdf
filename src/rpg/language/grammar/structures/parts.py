"""Parts of a structure and what they are made of: "the first row red", "a blue one in each corner", "white ends".

A part is one or more of its places; a statement about it is an `Absolute` whose theme says what stands there.
"""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.sides import OTHER_END, far_end
from rpg.language.grammar.structures.parity import every_other
from rpg.language.grammar.structures.part_there import ONE_OR_MORE, line_there, next_to_it, rest_beyond, told_there
from rpg.language.grammar.structures.part_words import (
    BETWEEN,
    FROM,
    IS,
    LEADS,
    NOT,
    NOUNS,
    OWN,
    PAIRS,
    REST,
    SIDES,
    TIPS,
    UNITS,
)
from rpg.language.grammar.structures.sizes import dimensions
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import adjectives
from rpg.language.grammar.things.labels import literal
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Structure, Traits, replace


@rule
def part(p: Parser, i: int, unit: str = "") -> Results[Meaning]:
    """ "the first row", "the two middle blocks", "each corner", "the rest"; `unit`: what is counted if it is not said.

    A single block at a side is an `At`, everything else `Places`.
    """
    if p.follows(i, ("at",)) and (k := p.any_of(i, OTHER_END)):
        yield Places(side="ends", unit="block", several=1, span=p.span(i, k)), k
        return
    if k := p.any_of(i, REST):
        yield Places(side="rest", unit="block", span=p.span(i, k)), k
    yield from rest_beyond(p, i)
    j, each, owned = p.opt(i, "only", "just"), False, False
    while k := p.one(j, OWN):
        each = each or p.words[j] in ("each", "every", "either")
        owned, j = True, k
    if k := p.any_of(j, ("of the", "of its")):
        j = k
    if (k := p.one(j, ("a", "an"))) and p.words[k] in NOUNS and p.words[k + 1] == "of":
        owned, j = True, k
    yield from told_there(p, i, j, unit)
    yield from line_there(p, i, j, unit)
    yield from every_other(p, i, j)
    if both := p.any_of(j, PAIRS):
        found = UNITS.get(p.words[both]) if both < p.end else None
        end = p.reach(both + 1) if found else p.opt(both, "end", "ends", "side", "sides")
        yield Places(side="ends", unit=found or "block", span=p.span(i, end)), end
        return
    along = p.peek(j, SIDES)
    if along in ("top", "bottom", "back", "front") and p.stands(j + 1, ("left", "right")):
        across = p.words[j + 1]
        end = p.opt(p.reach(j + 2), "corner", "block", "one", "cell", "cube")
        if not far_end(p, j):
            yield Places(side=f"{along} {across}", unit="cell", span=p.span(i, end)), end
        return
    if (line := p.peek(j, UNITS)) in _LAYERS and (turn := p.number(j + 1)) and p.number(j + 2) is None:
        yield Places(side="first", unit=line or "", index=turn, span=p.span(i, j + 2)), p.reach(j + 2)
    several = p.number(j)
    after = j + 1 if several is not None else j
    after = p.opt(after, "very")
    if p.words[after : after + 1] == ["outer"] and NOUNS.get(p.words[after + 1]) == "edge":
        after += 1
    if side := p.peek(after, SIDES):
        p.reach(after + 1)
        yield from _sided(p, i, after + 1, side, several, each, unit)
    side = p.peek(after, NOUNS)
    if p.words[after : after + 2] in (["cross", "bar"], ["horizontal", "bar"], ["top", "bar"], ["vertical", "bar"]):
        side, after = "stem" if p.words[after] == "vertical" else "bar", p.reach(after + 1)
    if side and (owned or several is not None or not p.stands(after, ("corner", "end"))):
        end = p.any_of(p.reach(after + 1), ("of it", "of them", "pieces", "places")) or after + 1
        yield _place(p, i, end, side, "block", several, each), end


def _sided(p: Parser, i: int, j: int, side: str, several: int | None, each: bool, unit: str) -> Results[Meaning]:
    """What follows the word for the side: "two", "two rows", "row", "of them", or nothing where the unit is known."""
    count = p.number(j)
    if count is not None and several is None and p.words[j] not in ("one", "ones"):
        several, j = count, j + 1
    if side.isdigit() and (k := p.any_of(p.opt(j, "one", "block", "cube", "position", "place", "spot"), FROM)):
        where = p.words[k - 1]
        yield At(side=where, index=int(side), span=p.span(i, k)), k
        if p.words[j] in ("position", "place", "spot"):
            return
    found = UNITS.get(p.words[j]) if j < p.end else None
    if side in ("left", "right") and p.words[j] == "hand" and not found:
        j = p.reach(j + 1)
        found = UNITS.get(p.words[j]) if j < p.end else None
    if found not in ("row", "column", "layer") and p.words[j - 1] in ("nearer", "farther", "further"):
        return  # "nearer than the other"
    if found != "step" and p.words[j - 1] in ("smallest", "shortest", "tallest", "largest", "biggest"):
        return  # that of several
    if found and unit and p.words[j] in ("one", "ones"):
        found = unit
    if found:
        end = p.any_of(p.reach(j + 1), ("of it", "of them", "of blocks", "of cubes")) or j + 1
        yield _place(p, i, end, side, found, several, each), end
        return
    end = p.any_of(j, ("of them", "of these")) or j
    if end > j and p.words[j - 1] in ("left", "right") and p.words[j - 2] not in OWN:  # beside them
        return
    if side in ("left", "right", "front", "back") and p.words[j - 1] != "rear" and (k := p.one(j, ("end",))):
        if p.words[k] not in ("of", "row") or p.any_of(k, _OF_IT):
            yield At(side=side, span=p.span(i, k)), k
        return
    if end > j or unit or several is not None:
        yield _place(p, i, end, side, unit or "block", several, each), end
    elif side not in ("ends", "corners", "edge") and p.words[j - 1].endswith(("est", "most")):
        yield _place(p, i, j, side, "block", several, each), j


def _place(p: Parser, i: int, j: int, side: str, unit: str, several: int | None, each: bool) -> Meaning:
    index = int(side) if side.isdigit() else None
    if (
        unit == "block"
        and several in (None, 1)
        and side in ("top", "bottom", "left", "right", "front", "back", "middle")
    ):
        tip = not TIPS.isdisjoint(p.words[i:j])
        return At(side=side, own=p.words[j - 1] in ONE_OR_MORE, tip=tip, span=p.span(i, j))
    if index is not None:
        side = "first"
    if several is None and not each and _is_single(p.words[i:j]):
        several = 1
    return Places(side=side, unit=unit, index=index, several=several, each=each, span=p.span(i, j))


def _is_single(words: list[str]) -> bool:
    """ "The corner", "its end block": one block, of which it is not clear which it is where there are several."""
    return not _CORNER.isdisjoint(words) and _MANY.isdisjoint(words)


_CORNER = frozenset({"corner", "end"})
_MANY = frozenset({"blocks", "cubes", "bricks", "ones", "pieces", "places", "positions", "cells", "rows", "columns",
                   "layers", "both", "all"})  # fmt: skip


_OF_IT = tuple(
    f"{of} {the} {noun}"
    for of in ("of", "in")
    for the in ("the", "this", "that")
    for noun in ("tower", "stack", "row", "line", "column", "grid", "square", "wall", "pyramid", "circle", "structure",
                 "staircase", "plus", "plus sign", "cross", "letter", "outline", "triangle", "rectangle")
)  # fmt: skip
"""What a part belongs to, where only one structure is spoken of."""
_OF_LETTER = tuple(f"of the {x}{shape}" for x in "ltuv" for shape in ("", " shape"))
_LIMBS = frozenset({"corners", "point", "bar", "stem"})
"""Parts that letters have, and blocks with letters do not."""
_OF_STEP = tuple(f"{of} the {high} step" for of in ("of", "on", "in") for high in ("highest", "top", "tallest", "last"))


def _of_step(p: Parser, i: int, place: Meaning, j: int) -> tuple[Meaning, int]:
    """ "the top block (of the highest step)": the one block on top of stairs."""
    k = p.any_of(j, _OF_STEP) if isinstance(place, At) and place.side == "top" else 0
    return (Places(side="top", unit="cell", span=p.span(i, k)), k) if k else (place, j)


@rule
def part_statement(p: Parser, i: int, unit: str = "") -> Results[Absolute]:
    """ "the first row is red", "white on both ends", "black corners", "red in between"."""
    for place, j in (*part(p, i, unit), *_blocks_of(p, i)):
        place, j = _of_step(p, i, place, j)
        j = p.any_of(j, _OF_IT) or p.any_of(j, ("of which", "of it")) or j
        j = (p.any_of(j, _OF_LETTER) if getattr(place, "side", "") in _LIMBS else 0) or j
        if isinstance(place, At) and p.words[j : j + 1] == ["one"]:  # "the top one red" is no top of one red block
            continue
        if p.words[j] == "of" and p.follows(j, ("left", "right")):  # "right of the red block" is beside it
            continue
        if p.words[i : i + 2] == ["top", "of"] and p.all.isdisjoint(lexicon.STRUCTURE):  # "top of white" is on it
            continue
        lines = list(_cells(p, i, j, place))
        yield from lines
        for theme, k in _looks(p, p.any_of(j, (", which is", "which is")) or p.any_of(j, IS) or j):
            one = isinstance(place, At) and (place.own or p.words[j - 1] == "end")
            if one and theme.plural and theme.amount is None:
                continue  # "the left end consists of red blocks": of one block nothing such can be said
            if p.follows(j, _A_BLOCK) and p.stands(j, _OWNS) and p.follows(k, _A_BLOCK):
                continue  # "the left one has a red one (on it)": it is none
            if all(k != end for _, end in lines):
                end = p.one(k, ("instead",)) or k
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end)), end
        for theme, k in _looks(p, never) if (never := p.any_of(j, NOT)) else ():
            if isinstance(theme, Noun) and theme.amount is None and p.stands(never, lexicon.COLOR):
                yield Absolute(theme=replace(theme, det="no"), adjuncts=(place,), span=p.span(i, k)), k
        for word, k in _word(p, j) if isinstance(place, Places) else ():
            yield Absolute(theme=word, adjuncts=(place,), span=p.span(i, k)), k
    for where, j in next_to_it(p, i):
        for theme, k in _looks(p, p.any_of(j, IS) or j):
            if not theme.plural and theme.amount is None:
                yield Absolute(theme=theme, adjuncts=(where,), span=p.span(i, k)), k
    yield from _coloured(p, i)
    yield from _put(p, i, unit)
    yield from _place_first(p, i, unit)


_OWNS = frozenset({"has", "have", "contains", "contain"})
_A_BLOCK = frozenset({"one", "block", "cube", "brick"})
_BLOCKS_OF = Patterns(
    "all|all_of? the|these? cubes|blocks|bricks|ones|those in|of|on|from|inside",
    "every|each cube|block|brick|one in|of|on",
    "everything in|on",
)


_BLOCK_IN = Patterns("the cube|block|brick|one in|at")


def _blocks_of(p: Parser, i: int) -> Results[Meaning]:
    """ "All cubes in the left column (are green)": the column. "The cube in the near left corner": that corner."""
    for j in _BLOCK_IN.matches(p, i):
        yield from ((x, k) for x, k in part(p, j) if isinstance(x, Places) and x.unit == "cell")
    for j in _BLOCKS_OF.matches(p, i):
        for place, k in part(p, j):
            if isinstance(place, Places) and place.unit in _LAYERS and p.words[k - 1] in _LINE_WORDS:
                yield place, k
        for place, k in part(p, j, "column") if p.stands(j, ("the",)) else ():
            if isinstance(place, Places) and place.unit in _LAYERS and p.words[k - 1] == "one":
                yield place, k


_LINE_WORDS = frozenset({"row", "rows", "column", "columns", "layer", "layers", "level", "one"})


@choice
def _place_first(p: Parser, i: int, unit: str) -> Results[Absolute]:
    """ "at both ends a red block", "in the far row blue", "on both sides of it a white one"."""
    if (end := p.any_of(i, _EACH_SIDE)) and p.anywhere(_LINES):
        both = Places(side="beside", unit="block", each=True, span=p.span(i, end))
        for theme, k in _looks(p, p.any_of(end, IS) or p.opt(end, ",", "there")):
            yield Absolute(theme=theme, adjuncts=(both,), span=p.span(i, k)), k
    lead = p.any_of(i, ("at", "in", "on", "for"))
    for place, j in part(p, lead, unit) if lead else ():
        on_block = p.words[i] == "on" and UNITS.get(p.words[j - 1]) == "block"  # "on its front left block a pink one"
        if isinstance(place, Places) and place.side != "rest" and not on_block:
            lines = list(_cells(p, i, j, place))
            yield from lines
            for theme, k in _looks(p, p.any_of(j, _THERE_IS) or j):
                if all(k != end for _, end in lines):
                    yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, k)), k


_THERE_IS = ("there is", "there are", "comes", "come", "is", "are", "goes", "go", "stands", "stand", ":")


def _word(p: Parser, j: int) -> Results[Structure]:
    """ "(the far row) spells CAT"."""
    k = p.any_of(j, _SPELLS)
    text = literal(p, k) if k else None
    if text is not None and len(text) > 1:
        yield Structure(kind="word", det="the", letter=text, span=p.span(j, k + 1)), k + 1


def _looks(p: Parser, j: int) -> Results[Noun]:
    """What a part is made of: a colour, or blocks of it."""
    for theme, k in simple(p, j):
        if isinstance(theme, Noun) and _plain(theme) and not (theme.plural and theme.det == "the"):
            yield theme, k


def _cells(p: Parser, i: int, j: int, place: Meaning) -> Results[Absolute]:
    """ "(the far row:) red, white, red": the blocks of a row one by one."""
    if not isinstance(place, Places) or place.unit not in ("row", "layer") or place.several is not None:
        return
    for items, k in listed(p, p.any_of(j, IS) or j):
        if all(map(_single, items)) and (len(items) > 2 or "and" not in p.words[j:k]):
            line = Coord(op="then", items=items, span=p.span(j, k))
            yield Absolute(theme=line, adjuncts=(place,), span=p.span(i, k)), k


def _single(theme: Meaning) -> bool:
    """One block, told by its look and without an article."""
    one = isinstance(theme, Noun) and theme.det == "bare" and theme.amount is None and not theme.plural
    return one and _plain(theme) and len(theme.traits.colors + theme.traits.labels) == 1  # type: ignore[attr-defined]


def _plain(theme: Meaning) -> bool:
    """Whether a phrase says only how blocks look, and how many there are."""
    if not isinstance(theme, Noun) or theme.head == "patch" or theme.part_of is not None or theme.conditions:
        return False
    marks = theme.traits
    return bool(marks.colors or marks.labels or marks.size or marks.quality) and marks.rank is None and not marks.extra


@choice
def _coloured(p: Parser, i: int) -> Results[Absolute]:
    """ "black corners", "a green middle column", "a yellow top"."""
    j = p.opt(i, "a", "an", "the", "its", "all", "four")
    for marks, k in adjectives(p, j):
        if set(marks) != {"colors"} or k >= p.end or p.words[k] in OWN:
            continue
        if p.words[j - 1] == "four" and j > i and not p.stands(k, ("arms", "corners")):
            continue
        sides = p.one(k, "sides")
        there = [(Places(side="rest", unit="block", span=p.span(k, sides)), sides)] if sides else part(p, k)
        for place, end in there:
            if isinstance(place, Places) and place.side == "rest" and p.words[k] not in ("arms", "sides"):
                continue
            theme = Noun(head="any", traits=Traits(colors=marks["colors"]), span=p.span(j, k))
            yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end)), end


@choice
def _put(p: Parser, i: int, unit: str) -> Results[Absolute]:
    """ "a blue one in each corner", "white on both ends", "red in between", "red for the first row"."""
    for theme, k in noun_phrase(p, i):
        if not _plain(theme):
            yield from _so_many(p, i, theme, k, unit)
            continue
        k = p.any_of(k, ("is", "are", "being", "goes", "go")) or k
        if end := p.any_of(k, BETWEEN):
            rest = Places(side="rest", unit="block", span=p.span(k, end))
            yield Absolute(theme=theme, adjuncts=(rest,), span=p.span(i, end)), end
        if (end := p.any_of(k, _EACH_SIDE)) and p.anywhere(_LINES):
            both = Places(side="beside", unit="block", each=True, span=p.span(k, end))
            yield Absolute(theme=theme, adjuncts=(both,), span=p.span(i, end)), end
        yield from _as_base(p, i, theme, k) if isinstance(theme, Noun) else ()
        if lead := p.any_of(k, LEADS):
            for place, end in (_of_step(p, lead, *told) for told in part(p, lead, unit)):
                block = UNITS.get(p.words[end - 1]) == "block" or p.number(end - 1) is not None  # "on the outer two"
                corner = getattr(place, "unit", "") == "cell" and p.words[lead] == "its"
                on_block = p.words[k] == "on" and (block or corner or isinstance(place, At))
                own = (
                    p.words[k] in ("for", "as")
                    or p.words[lead] in ("its", "each", "every", "either")
                    or getattr(place, "index", None) is not None
                )
                if (isinstance(place, Places) or own) and not on_block:
                    yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end)), end


_SIDES_OF_IT = tuple(
    f"{on}{of}"
    for on in ("on each side", "on both sides", "on either side", "left and right", "to the left and right",
               "to the left and to the right", "on the left and right", "on the left and the right",
               "on its left and right", "at each side", "at both sides")
    for of in (" of it", " of that", " of this", " of them", "")
)  # fmt: skip
_EACH_SIDE = (
    *_SIDES_OF_IT,
    *(f"{by} {on}" for by in ("next to it", "beside it", "beside that", "next to that")
      for on in ("on each side", "on both sides", "on either side", "left and right")),
)  # fmt: skip
"""Places of a line on both sides of what was told before."""
_LINES = frozenset({"row", "line", "column"})


def _as_base(p: Parser, i: int, theme: Noun, k: int) -> Results[Absolute]:
    """ "four white blocks as a 2x2 base", "as the base"."""
    lead = p.any_of(k, ("as a", "as the", "as its", "as", "form the", "forming the", "in a", "for the", "make up the"))
    for dims, j in dimensions(p, lead) if lead else ():
        if len(dims) == 2 and dims[0] == dims[1] and theme.amount == Amount(dims[0] ** 2, dims[0] ** 2):
            lead = j
    if end := p.any_of(lead, ("base", "foundation", "bottom", "bottom layer", "first layer", "base layer")):
        base = Places(side="bottom", unit="layer", span=p.span(lead, end))
        yield Absolute(theme=theme, adjuncts=(base,), span=p.span(i, end)), end


_LAYERS = ("layer", "row", "column")


def _so_many(p: Parser, i: int, theme: Meaning, k: int, unit: str) -> Results[Absolute]:
    """ "two (blocks) in the second layer", "a red and a blue one in the front row": a mere number, or a list."""
    bare = isinstance(theme, Noun) and theme.traits == Traits() and theme.head != "patch" and theme.part_of is None
    told = isinstance(theme, Noun) and theme.amount is not None and theme.det == "bare" and not theme.conditions
    listed_ = isinstance(theme, Coord) and theme.op == "and" and all(map(_plain, theme.items))
    if not (bare and told) and not listed_:
        return
    lead = p.any_of(k, LEADS)
    for place, end in part(p, lead, unit) if lead else ():
        if isinstance(place, Places) and place.unit in _LAYERS and place.side not in ("rest", "ends"):
            yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end)), end


def unit_of(found: Absolute) -> str:
    """The unit that a further statement in the list may leave unsaid."""
    place = found.adjuncts[0]
    return place.unit if isinstance(place, Places) else "block" if isinstance(place, At) else ""


_SPELLS = ("spells", "spelling", "reads", "reading", "says", "saying", "shows", "showing", "should spell", "must spell",
           "should read", "must read", "should say", "must say", "spells the word", "reads the word", "with the word",
           "spelling the word")  # fmt: skip
