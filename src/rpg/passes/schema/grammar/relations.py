"""Where things are: relations to landmarks, regions of the table, distances."""

from __future__ import annotations

from dataclasses import replace

from rpg.passes.schema.grammar.amounts import length
from rpg.passes.schema.grammar.core import Parser, Results, rule
from rpg.passes.schema.grammar.nouns import noun_phrase
from rpg.passes.schema.grammar.regions import region
from rpg.passes.schema.meaning import Coord, Loc, Meaning, Noun, Pronoun, TableTop

_SIMPLE = {
    "on top of": "on", "on the top of": "on", "atop of": "on", "atop": "on", "on top": "on", "onto": "on",
    "on to": "on", "upon": "on",
    "on": "on", "onto the top of": "on", "to the top of": "on", "over": "above", "above": "above",
    "over the top of": "above",
    "on to the top of": "on", "at the top of": "on", "on the surface of": "on", "supported by": "on",
    "carried by": "on", "to rest on": "on",
    "in": "in", "inside": "in", "inside of": "in", "into": "in", "within": "in", "at": "in", "to": "in",
    "under": "under", "underneath": "under", "beneath": "under", "below": "under",
    "in front of": "front", "ahead of": "front", "to the front of": "front", "on the front side of": "front",
    "at the front of": "front", "on the near side of": "front", "on the front of": "front", "nearer than": "front",
    "behind": "behind", "in back of": "behind", "to the back of": "behind", "at the back of": "behind",
    "to the rear of": "behind",
    "on the back side of": "behind", "beyond": "behind", "on the far side of": "behind", "at the rear of": "behind",
    "next to": "beside", "beside": "beside", "alongside": "beside", "by the side of": "beside",
    "at the side of": "beside",
    "side by side with": "beside", "by": "beside", "to the side of": "beside", "besides": "beside",
    "adjacent to": "adjacent", "adjoining": "adjacent", "adjacent with": "adjacent", "right next to": "adjacent",
    "touching": "touching", "in contact with": "touching", "against": "touching", "up against": "touching",
    "flush against": "touching", "flush with": "touching", "making contact with": "touching", "to touch": "touching",
    "near": "near", "close to": "near", "near to": "near", "nearby": "near", "in the vicinity of": "near",
    "far from": "apart", "away from": "apart", "far away from": "apart", "well away from": "apart",
    "apart from": "apart", "off": "off", "off of": "off", "away off": "off",
    "along with": "together", "together with": "together",
}  # fmt: skip
"""Prepositions with a landmark. "in" and "to" only fit patches and structures; resolution says so where they do not."""

_CHOICE = ("left", "right")
_DIRECT = ("directly", "exactly", "straight", "precisely", "squarely")
_CLOSE = ("immediately", "right", "just")
_LOOSE = ("somewhere", "anywhere", "generally")


@rule
def side_relation(p: Parser, i: int) -> Results[tuple[str, str]]:
    """ "to the left of", "on the right-hand side of", "left of": (relation, how close)."""
    j = (
        p.any_of(
            i,
            (
                "to the",
                "on the",
                "at the",
                "onto the",
                "to",
                "on",
                "in the",
                "off to the",
                "towards the",
                "toward the",
                "over to the",
            ),
        )
        or i
    )
    near = p.one(j, frozenset({"immediate", "near", "direct"}))
    far = p.one(j, "far")
    k = near or far or j
    if p.words[k : k + 1] and p.words[k] in _CHOICE:
        side = p.words[k]
        k = p.reach(k + 1)
        k = p.opt(k, "hand")
        k = p.any_of(k, ("side",)) or k
        if of := p.one(k, frozenset({"of", "from"})):
            yield (side, p.words[j] if near else ""), of
        elif k > i and p.words[k - 1] != "hand":
            yield (side + "?", ""), k


@rule
def relation(p: Parser, i: int) -> Results[tuple[str, tuple[str, ...]]]:
    """A relation that wants a landmark: (name, modifiers)."""
    starts: list[tuple[tuple[str, ...], int]] = [((), i)]
    for words, mod in ((_DIRECT, "directly"), (_CLOSE, "immediate"), (_LOOSE, "somewhere")):
        if i < p.end and p.words[i] in words:
            starts.append(((mod,), p.opt(p.reach(i + 1), "and")))
    for mods, j in starts:
        for phrase, name in _SIMPLE.items():
            if k := p.seq(j, phrase):
                yield (name, mods), k
        for (side, how), k in side_relation(p, j):
            if not side.endswith("?"):
                extra = {"immediate": ("immediate",), "direct": ("directly",)}.get(how, ())
                yield (side, (*mods, *extra)), k


@rule
def loc(p: Parser, i: int) -> Results[Meaning]:
    """One statement of place, perhaps negated."""
    j = p.one(i, "not")
    for found, k in _loc(p, j or i):
        if j and isinstance(found, Loc | Coord):
            if isinstance(found, Coord):
                parts = tuple(replace(x, negated=True) for x in found.items if isinstance(x, Loc))
                yield Coord(op="and" if found.op == "or" else "or", items=parts, span=p.span(i, k)), k
                continue
            yield replace(found, negated=True, span=p.span(i, k)), k
        elif not j:
            yield found, k
    if j:
        for found, k in region(p, j):
            yield replace(found, negated=True), k


_SPOTS = ("to a spot", "to a place", "to a position", "in a spot", "in a place", "at a spot", "in a position",
    "to the spot", "at a point", "to a point", "at the spot", "to the place", "to a location", "at a location",
          "in the spot", "to the position", "in the position")  # fmt: skip


@rule
def _loc(p: Parser, i: int) -> Results[Meaning]:
    if j := p.any_of(i, _SPOTS):
        yield from _loc(p, j)
    yield from region(p, i)
    yield from _measured(p, i)
    for (name, mods), j in relation(p, i):
        if p.words[j - 1] == "by" and p.figure(j) is not None:
            continue
        for landmark, k in noun_phrase(p, j):
            if isinstance(landmark, TableTop) and name not in ("on", "off", "above", "behind", "front"):
                continue
            if isinstance(landmark, TableTop) and (name == "in" or p.words[i] in ("at", "to")):
                continue
            cost = _listed_cost(landmark) + (2 if name == "in" or p.words[i] == "by" else 0)
            yield Loc(rel=name, landmark=landmark, mods=mods, span=p.span(i, k), cost=cost), k
    yield from _either_relation(p, i)
    yield from _either_place(p, i)
    yield from _between(p, i)
    yield from _possessive(p, i)
    yield from _bare(p, i)


def _either_relation(p: Parser, i: int) -> Results[Meaning]:
    """ "to the left or to the right of", "left of and behind": two relations with one landmark."""
    start = p.one(i, "either") or i
    firsts = [(name, j) for (name, _), j in relation(p, start)] + [
        (s.rstrip("?"), j) for (s, _), j in side_relation(p, start)
    ]
    if p.words[start : start + 1] in (["left"], ["right"]):
        firsts.append((p.words[start], p.reach(start + 1)))
    for first, j in firsts:
        k = p.one(j, frozenset({"or", "and"}))
        op = p.words[j] if k else ""
        for (second, mods), m in relation(p, k) if k else ():
            for landmark, end in noun_phrase(p, m):
                if isinstance(landmark, TableTop):
                    continue
                span = p.span(i, end)
                parts = (
                    Loc(rel=first, landmark=landmark, span=span),
                    Loc(rel=second, landmark=landmark, mods=mods, span=span),
                )
                yield Coord(op=op, items=parts, span=span), end


def _either_place(p: Parser, i: int) -> Results[Meaning]:
    """ "either left of the red block or behind the blue one"."""
    start = p.one(i, "either")
    for first, j in _loc(p, start) if start else ():
        k = p.one(j, "or")
        for second, end in _loc(p, k) if k else ():
            if isinstance(first, Loc) and isinstance(second, Loc):
                yield Coord(op="or", items=(first, second), span=p.span(i, end)), end


def _between(p: Parser, i: int) -> Results[Meaning]:
    mods: tuple[str, ...] = ()
    j = i
    if p.words[j : j + 1] and p.words[j] in ("directly", "exactly", "right", "somewhere"):
        mods, j = (("somewhere",) if p.words[j] == "somewhere" else ("directly",)), p.reach(j + 1)
    name = "between"
    k = p.any_of(j, ("in between", "in the middle of", "midway between", "halfway between", "between",
        "in the middle between",
                     "in the space between", "in the center of", "centered between", "in the gap between",
                     "among"))  # fmt: skip
    if not k:
        k = p.any_of(j, ("sandwiched between", "sandwiched in between", "sandwiched by"))
        name = "sandwiched"
    if k:
        for landmark, end in noun_phrase(p, k):
            if isinstance(landmark, TableTop):
                continue
            yield Loc(rel=name, landmark=landmark, mods=mods, span=p.span(i, end)), end


def _possessive(p: Parser, i: int) -> Results[Meaning]:
    """ "on its left", "to its right", "on the blue block's left side"."""
    j = p.any_of(i, ("on", "to", "at"))
    if not j:
        return
    if k := p.one(j, frozenset({"its", "their"})):
        owners: list[tuple[Meaning, int]] = [
            (Pronoun(word="it" if p.words[j] == "its" else "them", span=p.span(j, k)), k)
        ]
    else:
        owners = [(o, p.one(k, "'s")) for o, k in noun_phrase(p, j) if p.one(k, "'s")]
    for owner, k in owners:
        k = p.any_of(k, ("immediate",)) or k
        for word, name in (
            ("left", "left"),
            ("right", "right"),
            ("front", "front"),
            ("back", "behind"),
            ("top", "on"),
            ("side", "beside"),
        ):
            if end := p.one(k, word):
                end = p.any_of(end, ("hand side", "side")) or end
                yield Loc(rel=name, landmark=owner, span=p.span(i, end)), end


def _bare(p: Parser, i: int) -> Results[Meaning]:
    """Relations whose landmark is left unsaid: "nearby", "apart", "side by side"."""
    yield from _measured_bare(p, i)
    for phrase, name in (
        ("side by side", "side_by_side"), ("next to each other", "side_by_side"), ("beside each other", "side_by_side"),
        ("adjacent to each other", "adjacent"), ("next to one another", "side_by_side"),
        ("beside one another", "side_by_side"),
        ("far apart", "apart"), ("apart", "apart"), ("far away from each other", "apart"), ("separated", "apart"),
        ("away from each other", "apart"),
        ("apart from each other", "apart"), ("far apart from each other", "apart"), ("separately", "apart"),
        ("close together", "near"), ("together", "together"), ("near each other", "near"),
        ("close to each other", "near"),
        ("touching", "touching"), ("in contact", "touching"), ("adjacent", "adjacent"), ("nearby", "near"),
        ("shoulder to shoulder", "side_by_side"), ("in one place", "together"), ("spread out", "apart"),
        ("touching each other", "touching"), ("touching one another", "touching"),
        ("in contact with each other", "touching"),
        ("right next to each other", "adjacent"), ("immediately next to each other", "adjacent"),
        ("directly next to each other", "adjacent"),
        ("on top of each other", "heaped"), ("on top of one another", "heaped"), ("one on top of the other", "heaped"),
        ("one on top of another", "heaped"), ("on each other", "heaped"), ("one upon another", "heaped"),
        ("one over the other", "heaped"),
        ("one above the other", "heaped"), ("one atop the other", "heaped"), ("atop each other", "heaped"),
        ("atop one another", "heaped"),
        ("one on the other", "heaped"), ("on one another", "heaped"), ("one on another", "heaped"),
        ("on top of itself", "heaped"),
        ("each on top of the other", "heaped"), ("on top of each", "heaped"),
        ("one by one on top of each other", "heaped"),
        ("all on top of each other", "heaped"), ("upon each other", "heaped"),
        ("directly on top of each other", "heaped"),
        ("one next to the other", "side_by_side"), ("one beside the other", "side_by_side"),
        ("each next to the other", "side_by_side"),
        ("in between", "between"), ("between them", "between"), ("in between them", "between"),
        ("between the two", "between"), ("in the space between them", "between"),
        ("one in front of the other", "one_behind"), ("one behind the other", "one_behind"),
        ("one behind another", "one_behind"),
    ):  # fmt: skip
        if j := p.seq(i, phrase):
            landmark = Pronoun(word="them" if name == "between" else "each other", span=p.span(i, j))
            yield Loc(rel=name, landmark=landmark, span=p.span(i, j)), j


_AMONG = ("between them", "between each other", "in between them", "in between", "between the two",
    "between the blocks", "between each", "between neighbors",
          "between neighboring blocks", "between each block", "between blocks", "between each pair",
          "between each of them", "between every two blocks", "between adjacent blocks",
          "between each of the blocks")  # fmt: skip
_AROUND = (
    ("about", 0.25),
    ("around", 0.25),
    ("roughly", 0.25),
    ("approximately", 0.25),
    ("nearly", 0.25),
    ("exactly", 0.0),
)


@rule
def bounds(p: Parser, i: int) -> Results[tuple[float | None, float | None]]:
    """A length as a range: "5 cm" is ±1 cm, "about 5 cm" ±25 %, "at least 5 cm", "no more than 5 cm"."""
    for phrase, kind in (("at least", "low"), ("more than", "low"), ("no less than", "low"), ("a minimum of", "low"),
                         ("at most", "high"), ("less than", "high"), ("no more than", "high"), ("within", "high"),
                         ("up to", "high"),
                         ("not more than", "high"), ("a maximum of", "high"), ("closer than", "high"),
                         ("over", "low"), ("under", "high")):  # fmt: skip
        if j := p.seq(i, phrase):
            for metres, k in length(p, j):
                yield ((metres, None) if kind == "low" else (None, metres)), k
    for word, share in _AROUND:
        if j := p.one(i, word):
            for metres, k in length(p, j):
                slack = metres * share if share else 0.01
                yield (round(max(0.0, metres - slack), 6), round(metres + slack, 6)), k
    if j := p.one(i, "between"):
        low = p.figure(j)
        after = p.one(j + 1, "and") if low is not None else 0
        for metres, k in length(p, after) if after else ():
            factor = metres / (p.figure(after) or 1.0)
            yield (round(float(low or 0) * factor, 6), metres), k
    for metres, k in length(p, i):
        if end := p.any_of(k, ("or more", "or farther", "or further", "and more")):
            yield (metres, None), end
        if end := p.any_of(k, ("or less", "or closer", "or nearer")):
            yield (None, metres), end
        yield (round(max(0.0, metres - 0.01), 6), round(metres + 0.01, 6)), k


def _measured(p: Parser, i: int) -> Results[Meaning]:
    """ "5 cm from the red block", "at least 10 cm to the left of it", "within 3 cm of ..."."""
    start = p.any_of(i, ("at a distance of", "with a distance of", "a distance of")) or (
        i + 1 if p.words[i] == "at" and p.words[i + 1] not in ("least", "most") else i
    )
    for (low, high), j in bounds(p, start):
        if k := p.any_of(j, ("away from", "from", "of", "apart from", "far from", "distance from")):
            for landmark, end in noun_phrase(p, k):
                yield Loc(rel="distance", landmark=landmark, low=low, high=high, span=p.span(i, end)), end
        for (name, mods), k in relation(p, j):
            if name not in ("left", "right", "front", "behind"):
                continue
            for landmark, end in noun_phrase(p, k):
                yield Loc(rel=name, landmark=landmark, mods=mods, low=low, high=high, span=p.span(i, end)), end
    if j := p.any_of(i, ("with a gap of", "leaving a gap of", "a gap of")):
        for (low, high), k in bounds(p, j):
            if k := p.any_of(k, ("from", "to")):
                for landmark, end in noun_phrase(p, k):
                    yield (
                        Loc(
                            rel="distance", landmark=landmark, low=low, high=high, measure="faces", span=p.span(i, end)
                        ),
                        end,
                    )


def _measured_bare(p: Parser, i: int) -> Results[Meaning]:
    """ "5 cm apart", "with 5 cm between them", "with a gap of 2 cm"."""
    start = p.any_of(i, ("at a distance of", "spaced", "separated by", "with", "placed")) or i
    for (low, high), j in bounds(p, start):
        end = p.any_of(j, ("apart from each other", "from each other", "away from each other", "apart",
            "from one another",
                           "of each other", "of one another", "center to center", "from center to center",
                           "between centers", "apart from one another"))  # fmt: skip
        measure = "centres"
        if not end:
            end = p.any_of(j, ("between them", "between each other", "in between them", "in between", "between the two",
                               "between the blocks", "between each", "between neighbors", "between each block",
                               "between neighboring blocks",
                               "of space between them", "of empty space between them",
                               "of space between the blocks"))  # fmt: skip
            measure = "faces"
        if not end and p.words[start - 1 : start] == ["by"]:
            end, measure = j, "faces"
        if end:
            each = Pronoun(word="each other", span=p.span(i, end))
            yield Loc(rel="distance", landmark=each, low=low, high=high, measure=measure, span=p.span(i, end)), end
    yield from _moved(p, i)
    if j := p.any_of(i, ("with a", "leaving a", "with", "leaving", "at a", "keeping a")):
        for (low, high), k in bounds(p, j):
            gap = p.any_of(
                k,
                ("gap", "gaps", "of space", "of free space", "space", "wide gap", "spacing", "distance", "of distance"),
            )
            end = p.any_of(gap, _AMONG) if gap else 0
            if gap:
                measure = "centres" if p.words[gap - 1] in ("spacing", "distance") else "faces"
                each = Pronoun(word="each other", span=p.span(i, end or gap))
                yield (
                    Loc(rel="distance", landmark=each, low=low, high=high, measure=measure, span=p.span(i, end or gap)),
                    end or gap,
                )
            if end := p.any_of(
                k,
                (
                    "between their centers",
                    "between centers",
                    "between the centers",
                    "from center to center",
                    "center to center",
                ),
            ):
                each = Pronoun(word="each other", span=p.span(i, end))
                yield Loc(rel="distance", landmark=each, low=low, high=high, span=p.span(i, end)), end
    if j := p.any_of(i, ("with a gap of", "with gaps of", "leaving a gap of", "with a spacing of", "leaving gaps of",
                         "at intervals of", "with a distance of", "with spacing of")):  # fmt: skip
        for (low, high), k in bounds(p, j):
            end = p.any_of(k, ("between them", "between the blocks", "between each other", "between the two",
                "between blocks",
                               "between each block", "between each", "between neighbors",
                               "between neighbours")) or k  # fmt: skip
            measure = "faces" if "gap" in p.words[i:j] or "gaps" in p.words[i:j] else "centres"
            each = Pronoun(word="each other", span=p.span(i, end))
            yield Loc(rel="distance", landmark=each, low=low, high=high, measure=measure, span=p.span(i, end)), end


def _moved(p: Parser, i: int) -> Results[Meaning]:
    """ "by at least 10 cm": how far something moves."""
    far = p.one(i, "by") or i
    for (low, high), j in bounds(p, far):
        if high is None or far > i:
            yield Loc(rel="moved", low=low, high=high, span=p.span(i, j), cost=1), j


def _listed_cost(landmark: Meaning) -> int:
    """A list as a landmark is less natural than a clause that begins with its last item."""
    if isinstance(landmark, Coord):
        return 1 if landmark.op == "and" else 0
    if not isinstance(landmark, Noun):
        return 0
    return (
        1
        if (landmark.head == "any" and len(landmark.traits.colors) > 1)
        or (landmark.det == "bare" and len(landmark.traits.labels) > 1)
        else 0
    )
