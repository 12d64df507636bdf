"""Several towers by their heights: "of heights 2, 3 and 4", ": one block, two blocks and three blocks high"; a bar
chart is such towers from left to right."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things.adjectives import color
from rpg.language.meaning import Size, Structure, Toward, replace

_HEIGHTS = ("of heights", "with heights", "with heights of", "with the heights", "having heights", "heights :",
            "of height", "with the heights of", "of the heights", "whose heights are", "with heights :", "heights",
            "heights of", "their heights", "their heights are", "with height", "having height", "height",
            "with bars of heights", "with bars of height", "with bars", *(
                f"with {n} bars{of}" for n in ("two", "three", "four", "five") for of in (" of heights", " of height",
                                                                                         " :", "")))  # fmt: skip
_LEADS = ("of", "with", "that are", "having", "which are", ":", "being")
_TALL = (*(f"{blocks}{tall}" for blocks in ("blocks", "cubes", "block", "cube")
           for tall in (" high", " tall", " each", "")), "high", "tall")  # fmt: skip
_LOTS = ("blocks", "cubes", "block", "cube", "high", "tall", "block high", "blocks high", "block tall", "blocks tall",
         "cube high", "cubes high", "cube tall", "cubes tall")  # fmt: skip
_NEXT = ("and then", "then", "and finally", "and", "and one of", "and one", "one of")
_UPRIGHT = frozenset({"high", "tall", "heights", "height"})
"""One of these makes columns towers: others lie on the table."""
_PLACED = frozenset({"on", "in", "at", "next", "beside", "behind"})


@rule
def heights(p: Parser, i: int, count: int) -> Results[tuple[Size, tuple[str, ...]]]:
    """Behind `count` towers: "of heights 2, 3 and 4", "with two and three (red) blocks", with the blocks' colour."""
    comma = p.opt(i, ",")
    lead = p.any_of(comma, _HEIGHTS)
    j = lead or p.any_of(comma, _LEADS) or (comma if comma > i else 0)
    listed: list[int] = []
    while j and (n := p.number(j)) is not None:
        listed.append(n)
        ends: list[tuple[tuple[str, ...], int]] = [
            ((), e) for e in (p.any_of(j + 1, _TALL), j + 1 if lead or count == len(listed) else 0) if e
        ]
        ends += [((named,), e) for named, k in color(p, j + 1) if (e := p.one(k, ("blocks", "cubes")))]
        counted = p.any_of(j + 1, _LOTS) or j + 1
        after = p.any_of(p.opt(counted, ","), _NEXT) or p.opt(counted, ",")
        on = after > counted and p.number(after) is not None
        for named, end in ends if len(listed) > 1 else ():
            if on and end <= counted:
                continue  # the list goes on
            if not lead and p.words[end - 1] == "one" and p.stands(end, _PLACED):
                continue  # "two towers of two, one on each patch": one of the towers
            end = p.any_of(end, (", respectively", "respectively")) or end
            yield (Size(what="heights", dims=tuple(listed), span=p.span(i, end)), named), end
        j = after if after > counted else 0


def with_heights(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    """Several towers, or columns that are said to be so high, with their heights."""
    many = base.amount.low if base.amount is not None else 0
    for (tall, named), k in heights(p, j, many) if base.kind in ("stack", "column") else ():
        if base.kind == "stack" or not _UPRIGHT.isdisjoint(p.words[j:k]):
            traits = replace(base.traits, colors=base.traits.colors or named)
            yield replace(base, kind="stack", sizes=(*base.sizes, tall), traits=traits, span=p.span(i, k)), k


_CHARTS = ("bar chart", "bar graph", "bar diagram", "histogram", "column chart")


@choice
def bar_chart(p: Parser, i: int) -> Results[Structure]:
    """ "a bar chart with heights 3, 1, 2", "a bar chart: 1, 2 and 3 blocks high": its bars are read as a text is."""
    chart = p.any_of(p.opt(i, "a", "the"), _CHARTS)
    for (tall, named), j in heights(p, chart, 0) if chart else ():
        across = Toward(axis="y", span=p.span(i, chart))
        towers = Structure(kind="stack", det="bare", plural=True, sizes=(tall,), details=(across,), span=p.span(i, j))
        yield replace(towers, traits=replace(towers.traits, colors=named)), j
