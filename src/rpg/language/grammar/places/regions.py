"""Regions of the table: halves, corners, edges, the middle."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.corners import told_corners
from rpg.language.meaning import Coord, In

_NEAR = frozenset({"near", "front", "nearer", "bottom", "lower", "closest", "nearest"})
_FAR = frozenset({"far", "back", "rear", "farther", "top", "upper", "farthest", "furthest"})
_TABLE = frozenset({"table"})
_HALVES = {"left": "left", "right": "right", **dict.fromkeys(_NEAR, "near"), **dict.fromkeys(_FAR, "far")}


def _half(word: str) -> str | None:
    return _HALVES.get(word)


def of_table(p: Parser, i: int) -> int:
    j = p.any_of(i, ("of", "on", "in")) or (i if p.lex(i, lexicon.TABLE) is False else 0)
    if not j:
        return 0
    j = p.opt(j, "the")
    j = p.opt(j, "work")
    if p.lex(j, lexicon.TABLE) is False:
        return p.opt(j + 1, "top", "surface", "area")
    return 0


def _lead(p: Parser, i: int) -> int:
    """ "in the", "to the", "at a", "near the", ... or nothing."""
    j = (
        p.any_of(
            i,
            (
                "on",
                "in",
                "at",
                "to",
                "into",
                "onto",
                "near",
                "within",
                "inside",
                "along",
                "toward",
                "towards",
                "over to",
                "by",
                "against",
            ),
        )
        or i
    )
    return p.opt(j, "the", "a", "an", "any", "one") if j > i else i


EVERY_CORNER = (
    "each corner", "every corner", "each of the corners", "each of the four corners", "every one of the corners",
    "every one of the four corners", "all four corners", "all corners", "the four corners", "all the corners",
    "the corners",
)  # fmt: skip
_OVER = ("over", "among", "across")
_DEALING = (",", "one", "per", *_OVER)
_LEADS = ("in", "at", "on", "into", "to", *_OVER, "one in", ", one in", ", one block in", ", one each in")
EACH_CORNER = (
    "per corner", ", one per corner", "one per corner",
    *(f"{lead} {which}" for lead in _LEADS for which in EVERY_CORNER),
)  # fmt: skip
TWO_CORNERS = {
    f"{lead} {which}": side
    for word, side in (("far", "far"), ("back", "far"), ("rear", "far"), ("near", "near"), ("front", "near"),
                       ("left", "left"), ("right", "right"))
    for lead in _LEADS
    for which in (f"each of the two {word} corners", f"each of the {word} corners", f"each {word} corner",
                  f"every {word} corner", f"both {word} corners", f"both of the {word} corners",
                  f"both the {word} corners", f"the two {word} corners", f"the {word} corners",
                  f"each of the two corners on the {word}", f"both corners on the {word}",
                  f"the two corners on the {word}")
}  # fmt: skip
"""The two corners on one side of the table."""


@rule
def region(p: Parser, i: int) -> Results[In]:
    """A region, with or without "of the table" where its name alone is plain."""
    exact = p.opt(i, "exactly", "right", "precisely", "just", "directly", "somewhere", "anywhere")
    if k := p.any_of(exact, EACH_CORNER) if p.stands(i, _DEALING) else 0:
        end = of_table(p, k)
        yield In(region=_of_corners(p, i, k, end), span=p.span(i, end or k)), end or k
    for phrase, k in p.standing(exact, TWO_CORNERS):
        end = of_table(p, k)
        one_by_one = not _ONE_BY_ONE.isdisjoint(p.words[i:k])
        both = f"each_corner{'' if one_by_one else 's'}:{TWO_CORNERS[phrase]}{'' if end else '?'}"
        yield In(region=both, span=p.span(i, end or k)), end or k
    j = _lead(p, exact)
    around = p.any_of(exact, _AROUND)
    if j == exact and not around:
        return
    for name, k, plain in [x for x in _names(p, around or j) if x[0] == "edge" or not around]:
        end = of_table(p, k)
        if end:
            yield In(region=name, span=p.span(i, end)), end
        elif plain:
            yield In(region=name, vague=name in ("corner", "edge") or name.endswith("half"), span=p.span(i, k)), k
    if k := p.any_of(exact, EACH_CORNER):
        end = of_table(p, k)  # else they may as well be those of a board that was built
        yield In(region=_of_corners(p, i, k, end), span=p.span(i, end or k), cost=int(not end)), end or k
    if (k := p.any_of(i, _AT_TABLE)) and p.one(k, "'s"):
        for name, end, _ in _names(p, k + 1):
            yield In(region=name, span=p.span(i, end)), end


_AT_TABLE = tuple(f"{at} the table" for at in ("on", "in", "at", "along", "near", "around"))
"""What stands ahead of "'s left edge"."""
_AROUND = ("around the", "round the", "all along the")
"""What stands ahead of edges, and of no other part."""


@rule
def quarter(p: Parser, i: int) -> Results[Coord]:
    """ "In the far left quarter of the table": in both of these halves; what is not there may still be in one."""
    j = _lead(p, i)
    sides = [_half(word) for word in p.words[j : j + 2]] if p.rarely(_QUARTERS) else []
    k = p.one(j + 2, _QUARTERS) if j > i and len(sides) == 2 else 0
    if not k or len(_ACROSS & {*sides}) != 1 or None in sides or not p.all.isdisjoint(_DENYING):
        return
    end = of_table(p, k) or k
    halves = tuple(In(region=f"{side}_half", span=p.span(i, end)) for side in sides)
    yield Coord(op="and", items=halves, span=p.span(i, end)), end


_QUARTERS = frozenset({"quarter", "quadrant"})
_ACROSS = frozenset({"left", "right"})
_DENYING = frozenset({"not", "no", "never", "neither", "nor", "nothing", "none", "without", "outside", "out", "except",
                      "but", "anywhere"})  # fmt: skip


def _of_corners(p: Parser, i: int, k: int, table: int) -> str:
    """ "In each corner" deals out as many to every one, "in the four corners" all of them to the corners."""
    one_by_one = not _ONE_BY_ONE.isdisjoint(p.words[i:k])
    return f"each_corner{'' if one_by_one else 's'}{'' if table else '?'}"


_ONE_BY_ONE = frozenset({"each", "every", "per", "one"})


def named_regions(p: Parser, i: int) -> list[tuple[str, int]]:
    """Regions that their names alone tell: "near right corner", "left half of the table"."""
    return [(name, of_table(p, k) or k) for name, k, plain in _names(p, i) if plain or of_table(p, k)]


def _names(p: Parser, j: int) -> list[tuple[str, int, bool]]:
    """(region, next position, whether it stands for itself)."""
    found: list[tuple[str, int, bool]] = []
    if side := p.peek(j, _HALVES):
        word = p.words[j]
        k = p.opt(p.reach(j + 1), "hand", "most")
        if e := p.one(k, "half") or (p.one(k, "one") if "half" in p.words[:k] else 0):
            found.append((f"{side}_half", e, True))
        if e := p.one(k, "side"):
            again = word in _NEAR | _FAR and not p.all.isdisjoint(_TABLE) and not p.stands(e, ("of",))
            found.append((f"{side}_half", e, again))  # "on the near side of the table, ... on the far side"
        if e := p.one(k, ("part", "portion")):
            found.append((f"{side}_half", e, not p.all.isdisjoint(_TABLE) and not p.stands(e, ("of",))))
        if e := p.one(k, "edge"):
            found.append((f"{side}_edge", e, True))
        if e := p.one(k, "end"):
            found.append((f"{side}_edge", e, False))
        if side in ("left", "right") or word in ("front", "back", "rear"):
            found.append((f"{side}_half", k, False))
        found += _corner(p, k, side)
    if (very := p.one(j, "very")) and (utmost := p.peek(very, _HALVES)):
        found.append((f"{utmost}_edge", p.opt(p.reach(very + 1), "edge", "end"), False))
    k = p.any_of(p.opt(j, "exact", "very", "dead"), ("middle", "center", "central area", "central part"))
    if k and not p.stands(k, ("between",)):
        found.append(("middle", p.opt(k, "part", "area"), False))
    if k := p.any_of(j, ("edges", "table edges")):
        found.append(("edge", k, p.words[k - 2] == "table" or not p.all.isdisjoint(_TABLE)))
    if k := p.any_of(j, ("edge", "table edge")):
        found.append(("edge", k, False))
        found += [(f"{_BY_ROBOT[told]}_edge", e, True) for told, e in p.standing(of_table(p, k) or k, _BY_ROBOT)]
    found += [(_SOME[phrase], k, True) for phrase, k in p.standing(j, _SOME)]
    found += [(name, k, True) for name, k in told_corners(p, j)]
    for phrase, k in p.standing(j, _OPPOSITE):
        if p.words[k - 1] != "one" or "corner" in p.words[:j]:
            found.append((_OPPOSITE[phrase], k, True))
    found += [(_TWO_SIDES[phrase], k, False) for phrase, k in p.standing(j, _TWO_SIDES)]
    if k := p.any_of(j, ("other half", "opposite half", "other side", "opposite side")):
        found.append(("other_half", k, p.words[k - 1] == "half"))
    if k := p.any_of(j, ("half", "side")):
        found += [(_HALF_BY_ROBOT[phrase], e, True) for phrase, e in p.standing(of_table(p, k) or k, _HALF_BY_ROBOT)]
    return found


_SOME = {
    **dict.fromkeys(("of the corners", "of the four corners", "one of the corners", "one of the four corners",
                     "any one of the four corners", "any of the corners", "any of the four corners"), "corner"),
    **dict.fromkeys(("of the edges", "one of the edges", "any of the edges", "one of the four edges"), "edge"),
    "corner": "corner",
}  # fmt: skip
_OPPOSITE = {
    "opposite corner": "opposite_corner", "diagonally opposite corner": "opposite_corner",
    "opposite one": "opposite_corner", "opposite corners": "opposite_corners",
    "diagonally opposite corners": "opposite_corners",
    **dict.fromkeys(("different corners", "separate corners", "corners of their own", "three different corners",
                     "two different corners"), "different_corners"),
    **dict.fromkeys(("different corner", "separate corner", "corner of its own"), "different_corner"),
    **{f"corner {diagonally}{opposite}{it}": "opposite_corner" for diagonally in ("", "diagonally ")
       for opposite in ("opposite", "across") for it in ("", " it", " to it", " from it", " of it", " to that")
       if diagonally or opposite == "opposite"},
}  # fmt: skip
_TWO_SIDES = {
    f"{opposite} {sides}": region
    for region, places in (("opposite_halves", ("sides", "halves")), ("opposite_edges", ("ends", "edges")))
    for opposite in ("opposite", "different", "opposing")
    for sides in places
}
"""Of the table: of a block or of a patch they are told otherwise."""
_BY_ROBOT = {
    f"{way} {whom}": side
    for side, ways in (
        ("near", ("closest to", "nearest to", "nearest", "near", "near to", "close to", "next to")),
        ("far", ("farthest from", "furthest from", "far from", "away from", "farthest away from")),
    )
    for way in ways
    for whom in ("the robot", "me", "you", "us", "the viewer", "the camera")
}
_HALF_BY_ROBOT = {told: f"{side}_half" for told, side in _BY_ROBOT.items()}


def _corner(p: Parser, k: int, side: str) -> list[tuple[str, int, bool]]:
    """ "left corner" needs a second word; "far left corner" and "left front corner" have it."""
    second = _half(p.words[k]) if k < p.end else None
    if second is None:
        return []
    e = p.opt(p.reach(k + 1), "hand")
    e = p.one(e, "corner") or (p.one(e, "one") if "corner" in p.words[:e] else 0)
    if not e:
        return []
    across, along = (side, second) if side in ("left", "right") else (second, side)
    if across not in ("left", "right") or along not in ("near", "far"):
        return []
    return [(f"{along}_{across}_corner", e, True)]


def named(p: Parser, i: int) -> list[tuple[str, int]]:
    """A region by its name alone, as a note ends: "far left corner", "middle", "left", "corner near right"."""
    found = [(name.rstrip("?"), of_table(p, k) or k) for name, k, _ in _names(p, i)]
    if k := p.one(i, "corner"):
        sides = (p.words[k], p.words[k + 1] if k + 1 < p.end else "")
        halves = [h for h in (_half(side) for side in sides) if h is not None]
        if len(halves) == 2:
            across = next((h for h in halves if h in ("left", "right")), None)
            along = next((h for h in halves if h in ("near", "far")), None)
            if across and along:
                found.append((f"{along}_{across}_corner", p.reach(k + 2)))
    return found
