"""Requests for another order: reverse, mirror, sort, list."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, longest, m, noun_phrase, order, phrases, simple
from rpg.steer.requests.phrases import old, subjects

REVERSE = (
    "reverse",
    "flip",
    "invert",
    "turn around",
    "turn over",
    "flip around",
    "turn upside down",
    "flip over",
    "turn",
)
SORT = (
    "sort",
    "order",
    "reorder",
    "arrange",
    "rearrange",
    "organize",
    "organise",
    "line up",
    "put",
    "rank",
    "keep",
    "stack",
    "have",
    "make",
    "group",
)
_THEIR = phrases(
    "the color order of | the order of | the colour order of | the sequence of | the arrangement of | the "
    "colors of | the colours of | the stacking order of | the letters of | the direction of"
)
_PLAIN = phrases(
    "the color order | the colour order | the order | the sequence | the arrangement | the direction | "
    "the stacking order | the direction of ascent | the colors | its order | their order | the block order"
)
BY = {
    "label": "label", "number": "number", "rainbow": "rainbow", "size": "size", "alternating": "alternating",
    "mirrored": "mirrored", "any": "any", "size_down": "size_down", "size_up": "size_up", "ascending": "ascending",
    "even_first": "even_first",
    "odd_first": "odd_first", "vowel_first": "vowel_first", "consonant_first": "consonant_first",
}  # fmt: skip
_ATTRIBUTES = {"color": "color", "label": "label", "size": "size", "kind": "kind", "parity": "parity", "vowel": "vowel"}
_COLORS = phrases(
    "by different colors | by different colours | by their colors | by colors | by colours | by their "
    "colours | by color | by colour | by their color | into different colors | by the colors | according "
    "to color | according to their colors"
)


def reorder(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Every way to ask for another order."""
    yield from _reverse(p, i)
    yield from _mirror(p, i)
    yield from _listed(p, i)
    yield from _in_turn(p, i)
    yield from _sort(p, i)
    yield from _no_matter(p, i)
    yield from _swap_them(p, i)


def _reverse(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    for phrase in REVERSE:
        j = p.seq(i, phrase)
        if not j:
            continue
        for of in _THEIR:
            if k := p.seq(j, of):
                yield from _upside(p, i, k, "reverse", list(subjects(p, k)))
        for plain in _PLAIN:
            if k := p.seq(j, plain):
                k = longest(p, k, ("around", "upside down")) or k
                yield r.Reorder(how="reverse", of_doing="color" not in plain, span=p.span(i, k)), k
        yield from _upside(p, i, j, "reverse", list(subjects(p, j)), wanted=phrase == "turn")
        if phrase != "turn" and (k := longest(p, j, ("everything", "things", "all"))):
            yield r.Reorder(how="reverse", span=p.span(i, k)), k
    if j := longest(p, i, "spell | read | write | build | stack | do | have | put | make | order | arrange"):
        for theme, k in [(None, j), *subjects(p, j)]:
            if theme is not None and not old(theme):
                continue
            if end := longest(p, k, _BACKWARDS):
                doing = "order" in p.words[k:end] or p.words[i] == "do"
                yield r.Reorder(how="reverse", theme=theme, of_doing=doing, span=p.span(i, end)), end
    if j := longest(p, i, _STEPS):
        yield r.Reorder(how="steps", span=p.span(i, j)), j
    if j := longest(
            p,
            i,
            "do it in reverse order | do it reverse | do it in reverse | "
            "reverse | in reverse order | the other way around | the other way "
            "round | make it the other way around | do it the other way around | make it the "
            "other way round | upside down | in reverse | turn it upside down | in the opposite "
            "order | put them in reverse order | the opposite order | opposite order | reverse order | "
            "other way round | other way around | in the opposite direction | the order the other way round | "
            "use the opposite order | "
            "use the reverse order | backwards | reversed | turned around | in the other order",
        ):  # fmt: skip
        doing = "order" in p.words[i:j] or "do" in p.words[i:j]
        yield r.Reorder(how="reverse", of_doing=doing, span=p.span(i, j)), j


_BACKWARDS = phrases(
    "backwards | backward | in reverse | in reverse order | the other way round | the other way around | "
    "in the reverse order | in the opposite order | in opposite order"
)
_STEPS = tuple(
    f"{verb} {what}"
    for verb in ("swap", "switch", "exchange", "reverse", "interchange", "turn around")
    for what in (
        "the steps", "the two steps", "both steps", "the stages", "the two stages", "the order of the steps",
        "the order of the two steps", "the order of the stages", "the first and the second step", "step 1 and step 2",
        "steps 1 and 2", "the two moves", "the order of the moves",
    )
)  # fmt: skip


def _upside(
    p: Parser, i: int, _at: int, how: str, themes: list[tuple[m.Meaning, int]], wanted: bool = False
) -> Iterator[tuple[r.Request, int]]:
    for theme, k in themes:
        if isinstance(theme, m.Noun) and (not theme.plural or p.words[k - 1].isdigit()):
            continue
        end = longest(p, k, "upside down | around | over | the other way around") or (k if not wanted else 0)
        if end:
            yield r.Reorder(how=how, theme=theme, span=p.span(i, end)), end


def _mirror(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    for phrase in (
        "mirror",
        "mirror image",
        "flip horizontally",
        "make a mirror image of",
        "swap left and right in",
        "reflect",
    ):
        if j := p.seq(i, phrase):
            for theme, k in simple(p, j):
                end = longest(p, k, "left to right | horizontally | left and right | sideways") or k
                yield r.Reorder(how="mirror", theme=theme, span=p.span(i, end)), end
            if k := longest(p, j, "everything | the whole thing | the arrangement | the scene | the goal | the task"):
                yield r.Reorder(how="mirror", span=p.span(i, k)), k
    if j := longest(
            p,
            i,
            "swap left and right | exchange left and right | switch left and right | make it "
            "mirrored left to right | flip left and right | flip it horizontally | flip it left "
            "to right | mirror left and right",
        ):  # fmt: skip
        yield r.Reorder(how="mirror", span=p.span(i, j)), j


def _sort(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "sort them alphabetically", "order the row by size, from right to left"."""
    starts: list[tuple[m.Meaning | None, int]] = []
    for phrase in SORT:
        if j := p.seq(i, phrase):
            starts.append((None, j))
            starts += [(theme, k) for theme, k in noun_phrase(p, j) if not isinstance(theme, m.Coord) and old(theme)]
            if k := longest(p, j, "the letters | the numbers | the colors | the order"):
                starts.append((None, k))
    for phrase in (
        "change the order to",
        "change the order",
        "the order should be",
        "use the order",
        "with the order",
        "set the order to",
        "the same order but",
        "same order but",
        "the same order",
        "same order",
        "keep the order but",
    ):
        if j := p.seq(i, phrase):
            starts.append((None, j))
    if j := p.one(i, "alternate"):
        for whole, k in noun_phrase(p, j):
            if old(whole):
                yield r.Reorder(how="alternating", theme=whole, span=p.span(i, k)), k
    for whole, j in noun_phrase(p, i):
        if old(whole) and (k := longest(p, j, "should | must | have to | need to | shall")) and p.one(k, "alternate"):
            yield r.Reorder(how="alternating", theme=whole, span=p.span(i, k + 1)), p.reach(k + 1)
    if not starts and p.words[i] in ("alphabetically", "numerically", "in", "from", "descending", "ascending"):
        starts.append((None, i))
    for theme, j in starts:
        if k := longest(
            p,
            j,
            "alternate the colors | alternating colors | with alternating colors | alternate in color | alternate | "
            "alternate in colour | alternate colors | alternate by color",
        ):
            yield r.Reorder(how="alternating", theme=theme, span=p.span(i, k)), k
        j = p.opt(j, "now", "so", "to")
        j = longest(p, j, "be sorted | be ordered | be arranged | sorted | ordered | be") or j
        yield from _orders(p, i, j, theme)


def _orders(p: Parser, i: int, j: int, theme: m.Meaning | None) -> Iterator[tuple[r.Request, int]]:
    for phrase in _COLORS:
        if k := p.seq(j, phrase):
            yield r.Reorder(how="color", theme=theme, span=p.span(i, k)), k
    for found, k in order(p, j):
        if isinstance(found, m.Toward) and found.first:
            yield (r.Reorder(how="toward", theme=theme, first=found.first, span=p.span(i, k)), k)
        if not isinstance(found, m.OrderBy):
            continue
        how = _how(found)
        if how is None:
            continue
        items = m.Coord(op="and", items=found.items, span=found.span) if found.items else None
        for first, end in _first(p, k):
            end = _given_up(p, end)
            yield (
                r.Reorder(
                    how=how, theme=theme, items=items, descending=found.descending, first=first, span=p.span(i, end)
                ),
                end,
            )


def _given_up(p: Parser, i: int) -> int:
    """The position after an order that is given up: "instead of ascending"."""
    j = longest(p, i, "instead of | rather than | , not | not | and not")
    return max((k for found, k in order(p, j) if isinstance(found, m.OrderBy)), default=i) if j else i


_ORDERS = phrases(
    "the order should be | the order must be | the order is | make the order | i want the order | the new order is | "
    "set the order to | change the order to | the order should now be | in the order | order them as | "
    "arrange them as | "
    "put them as | have them as | make it | make them | i want | they should be | it should be | it should go | it goes"
)
_DIRECTIONS = {
    f"{lead}{a} to {b}": a
    for a, b in (
        ("bottom", "top"), ("top", "bottom"), ("left", "right"), ("right", "left"), ("front", "back"),
        ("back", "front"),
    )
    for lead in ("from ", "", "going from ")
}  # fmt: skip


def _listed(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "the order should be red, blue, green from bottom to top", "bottom to top: red, blue, green"."""
    for first, j in _direction(p, i):
        start = longest(p, j, "should be | must be | is | : | , | it should be | it is | should read") or j
        for listed, k in noun_phrase(p, start):
            if isinstance(listed, m.Coord):
                yield (r.Reorder(how="given", items=listed, first=first, span=p.span(i, k)), k)
    j = longest(p, i, _ORDERS)
    for listed, k in noun_phrase(p, j) if j else ():
        for first, end in _direction(p, p.opt(k, ",")) if isinstance(listed, m.Coord) else ():
            yield (r.Reorder(how="given", items=listed, first=first, span=p.span(i, end)), end)


_ENDS = {
    "at the bottom": "bottom", "on the bottom": "bottom", "at the very bottom": "bottom", "on top": "top",
    "at the top": "top", "on the left": "left", "at the left": "left", "at the left end": "left",
    "on the right": "right", "at the right": "right", "at the right end": "right", "in front": "front",
    "at the front": "front", "at the back": "back", "on the far left": "left", "on the far right": "right",
}  # fmt: skip
_THEN = phrases(", then | , and then | then | and then | , on it | , next | , followed by | followed by | , and on it")


def _in_turn(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "black at the bottom, then white, then red on top": every block, from one end to the other."""
    for lowest, j in noun_phrase(p, longest(p, i, "with") or i):
        first = next(((end, k) for phrase, end in _ENDS.items() if (k := p.seq(j, phrase))), None)
        if first is None or isinstance(lowest, m.Coord | m.Structure):
            continue
        items, j = [lowest], first[1]
        while n := longest(p, j, _THEN):
            listed, j = max(noun_phrase(p, n), key=lambda found: found[1], default=(None, 0))
            if listed is None:
                break
            items += listed.items if isinstance(listed, m.Coord) and listed.op in ("and", "then") else (listed,)
        if len(items) < 2 or not j:
            continue
        other = (k for phrase, end in _ENDS.items() if end == _OTHER[first[0]] and (k := p.seq(j, phrase)))
        end = next(other, j)
        every = m.Coord(op="and", items=tuple(items), span=p.span(i, end))
        yield r.Reorder(how="given", items=every, first=first[0], span=p.span(i, end)), end


_OTHER = {"bottom": "top", "top": "bottom", "left": "right", "right": "left", "front": "back", "back": "front"}


def _direction(p: Parser, i: int) -> Iterator[tuple[str, int]]:
    for phrase, first in _DIRECTIONS.items():
        if j := p.seq(i, phrase):
            yield first, j


def _how(found: m.OrderBy) -> str | None:
    if found.by == "attribute":
        return _ATTRIBUTES.get(found.attribute)
    if found.by == "given":
        return "given" if found.items else None
    return "reverse" if found.by == "reverse" else BY.get(found.by)


def _first(p: Parser, i: int) -> Iterator[tuple[str | None, int]]:
    """The side where the order begins: "from right to left"."""
    for found, k in order(p, p.opt(i, ",")):
        if isinstance(found, m.Toward) and found.first:
            yield found.first, k
    yield None, i


def _two(both: m.Noun) -> bool:
    """Phrases such as "the two patches", "both blocks", "the top blocks"; not "the red and blue blocks", which are two
    phrases."""
    amount = both.amount.low if both.amount else 2 if both.traits.rank or both.det == "both" else 0
    return both.plural and amount == 2 and not both.traits.labels and len(both.traits.colors) < 2


_SWAPPED = phrases(
    "around | over | round | places | in the stack | in the tower | in the row | in the line | in the column | "
    "in the pile | of the tower | of the stack | of the row | with each other | of the towers | of the stacks | "
    "of the two towers | of the two stacks | of both towers | of both stacks | of each tower"
)


def _swap_them(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap them", "exchange the two": for two blocks, the reverse order."""
    j = longest(p, i, "swap | exchange | switch | interchange | swap around | swap round")
    for both, k in subjects(p, j) if j else ():
        if isinstance(both, m.Noun) and _two(both):
            end = longest(p, k, _SWAPPED) or k
            yield r.Reorder(how="swap", theme=both, span=p.span(i, end), cost=1), end
    k = (
        longest(p, j, "them | the two | the two blocks | both | both blocks | them around | the blocks | those two")
        if j
        else 0
    )
    if k:
        k = longest(p, k, _SWAPPED) or k
        yield r.Reorder(how="swap", span=p.span(i, k)), k


def _no_matter(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    j = longest(
        p,
        i,
        "the order does not matter | the order does not matter any more | in any order | "
        "ignore the order | drop the order | forget the order | remove the order | any order "
        "is fine | the order no longer matters | order does not matter | let the order be "
        "free | any order will do | in no particular order",
    )
    if j:
        yield (r.Reorder(how="any", span=p.span(i, j)), longest(p, j, ("any more", "anymore")) or j)
