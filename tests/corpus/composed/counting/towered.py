"""Wishes about towers by count, height and colour."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.counting.phrasing import (
    COLORS,
    NOUNS,
    NUMBERS,
    PATCHES,
    Wish,
    listed,
    number,
    piled,
    plural,
    stock,
)

BUILD = "[build|make|stack|form|I want|put up|erect|I'd like|please build]"
TOWER = ("tower", "tower", "stack")


def per_color(rng: Random) -> Wish:
    """One tower for each colour."""
    colors, n = rng.sample(COLORS, rng.choice((2, 2, 3))), rng.choice((2, 2, 3))
    noun, t = rng.choice(NOUNS), rng.choice(TOWER)
    many, k = plural(noun), NUMBERS[len(colors)]
    goals: tuple[str, ...] = (
        f"[stack|pile up] [the {many}|them] by colour",
        f"[stack|pile] [the {many}|them] into {k} {t}s, one [for each|per|for every] colour",
        f"[make|build|form|I want] one {t} [per|for each|for every] colour",
        f"[make|build|I want] a {t} [of|for|from] each colour",
        f"[each|every] colour [becomes|forms|makes|gets|should become|should form] a {t}",
        f"[each|every] colour [becomes|forms|gets|should get] [a {t} of its own|its own {t}]",
        f"[cubes|blocks] of the same colour must be stacked [on top of each other|up|into one {t}]",
        f"[stack|put] the {many} [of the same colour|of each colour|of one colour] [on top of each other|into one {t}]",
        f"all {many} of [a|one|the same] colour [form|must form|should form|make up] [one|a] {t}",
        f"tidy [them|it] up into {k} [little|] {t}s, one [for each|per] colour",
        f"at the end there [should be|must be|are] {k} {t}s, [one per colour|each of one colour|each of a "
        "single colour]",
        f"I want to see {k} {t}s, [each in one colour|one for each colour|each of a single colour]",
        f"[each|every] {t} [has|must have|should have] [only one|one|a single] colour, and there are {k} of them",
        f"the {colors[0]} ones [form|make] one {t} and the {colors[1]} ones another"
        if len(colors) == 2
        else f"{k} {t}s, one per colour",
        f"[put|stack] the {colors[0]} ones [in|into] one {t} and the {colors[1]} ones [in|into] [another|the "
        "other|a second one]"
        if len(colors) == 2
        else f"[sort|stack] them into {k} {t}s by colour",
    )
    wholes: tuple[str, ...] = (
        "{inv}, [stacked|piled] by colour",
        f"stack {{inv}} so that [each|every] {t} has [one|a single|only one] colour",
        f"[build|make] {k} {t}s from {{inv}}, [one per colour|each of one colour|one for each colour]",
        f"{k} {t}s of {NUMBERS[n]}, one {', one '.join(colors[:-1])} and one {colors[-1]}",
        f"{listed([f'a {c} {t}' for c in colors])}, each [{NUMBERS[n]} {many} high|of {NUMBERS[n]} {many}]",
        f"{listed([f'a {t} of {NUMBERS[n]} {c} {many}' for c in colors])}",
        f"a {t} each [of|from] {listed([f'{NUMBERS[n]} {c}' for c in colors])} {many}",
    )
    mixed = [[colors[(i + j) % len(colors)] for j in range(n)] for i in range(len(colors))]
    hold = piled(*[[c] * n for c in colors])
    one = "^".join(["^".join([c] * n) for c in colors])
    meaning = {"assets": dict.fromkeys(colors, n), "hold": [hold], "miss": [piled(*mixed), one]}
    return Wish("a tower per colour", stock(rng, [(n, c) for c in colors], noun), goals, wholes, meaning, {}, True)


def heights(rng: Random) -> Wish:
    """Two or three towers of heights told one by one."""
    color = rng.choice((*COLORS, "", ""))
    noun, t = rng.choice(NOUNS), rng.choice(TOWER)
    many = plural(noun)
    tall = rng.choice(([2, 3], [3, 2], [2, 4], [4, 2], [3, 4], [2, 3, 4], [4, 3, 2], [2, 2, 3]))
    same = len(set(tall)) < len(tall)
    k = NUMBERS[len(tall)]
    ns = [number(rng, h) for h in tall]
    ones = ["one", "one", "one"] if len(tall) == 3 else ["one", "[the other|one]"]
    total = sum(tall)
    of = rng.choice(("of", "with", "has", "high", "is high", "heights"))
    b = rng.choice(("", f" {many}", " layers", " floors")) if of in ("has", "with") else rng.choice(("", f" {many}"))
    match of:
        case "high":
            parts = f"{listed([f'{o} {n}{b} high' for o, n in zip(ones, ns, strict=False)])}"
        case "is high":
            parts = f"{listed([f'{o} is {n}{b} [high|tall]' for o, n in zip(ones, ns, strict=False)])}"
        case "heights":
            hs = listed(ns)
            parts = f"[of heights {hs}|{hs} [{many}|] high|with heights of {hs}|with {hs} {many}]"
        case _:
            parts = f"{listed([f'{o} {of} {n}{b}' for o, n in zip(ones, ns, strict=False)])}"
    comma = "" if of == "heights" else ","
    goals: tuple[str, ...] = (
        f"{BUILD} {k} {t}s{comma} {parts}",
        f"{k} {t}s{comma} {parts}",
        f"[at the end there are|there should be|the result is] {k} {t}s{comma} {parts}",
        f"[stack|pile] them into {k} {t}s{comma} {parts}",
        f"[distribute|spread|split] them [over|into|among] {k} {t}s{comma} {parts}",
        f"{BUILD} {listed([f'a {t} of {n}' for n in ns])}",
        f"{ns[0]} of them form [a|one] {t} and the other {ns[-1]} [another|a second one]"
        if len(tall) == 2 and not same
        else f"{BUILD} {k} {t}s{comma} {parts}",
    )
    wholes: tuple[str, ...] = (
        f"{BUILD} {k} {color} {t}s{comma} {parts}",
        f"{k} {color} {t}s{comma} {parts}",
        f"{BUILD} {listed([f'a {color} {t} of {n}' for n in ns])}",
        f"{listed([f'a {t} of {n} {color} {many}' for n in ns])}",
        f"{BUILD} {k} {t}s [from|out of] {{inv}}{comma} {parts}",
        f"{{inv}} [in|as] {k} {t}s{comma} {parts}",
    )
    look = color or "plain"
    hold = piled(*[[look] * h for h in tall])
    other = [tall[0] + 1, *tall[1:]]
    other[1] -= 1
    if sorted(other) == sorted(tall):
        other = [tall[0] - 1, tall[1] + 1, *tall[2:]]
    miss = [piled(*[[look] * h for h in other]), "^".join([look] * total)]
    inv: tuple[str, ...] = (f"{number(rng, total)} {color} {many}",)
    return Wish("heights told", inv, goals, wholes, {"assets": {look: total}, "hold": [hold], "miss": miss}, {}, True)


def equal(rng: Random) -> Wish:
    """So many towers of one height."""
    color = rng.choice((*COLORS, "", ""))
    noun, t = rng.choice(NOUNS), rng.choice(TOWER)
    many = plural(noun)
    k, h = rng.choice(((2, 2), (2, 3), (3, 2), (2, 4), (3, 3)))
    kk = NUMBERS[k]
    goals: tuple[str, ...] = (
        f"{BUILD} {kk} {t}s of [the same height|equal height|equal size] [from|out of] [them|the {many}]",
        f"{BUILD} {kk} [equally [tall|high]|equal] {t}s",
        f"[distribute|spread|divide|split] [them|the {many}] [over|among|into] {kk} {t}s of [the same|equal] height",
        f"[stack|pile] [them|the {many}] into {kk} {t}s [which are equally [tall|high]|that are equally "
        "high|of equal height|of the same height]",
        f"{kk} {t}s, [both|each] equally [tall|high]" if k == 2 else f"{kk} {t}s, all equally [tall|high]",
        f"{kk} {t}s of {NUMBERS[h]} [each|]",
        f"{BUILD} {t}s of {NUMBERS[h]} {many} each",
        f"[put|stack] them into {kk} {t}s, [each|each of them] {NUMBERS[h]} high",
        f"use [them all|all of them] [for|in] {kk} {t}s of [the same|equal] height",
    )
    wholes: tuple[str, ...] = (
        f"[distribute|spread|divide|split] {{inv}} [over|among|into] {kk} {t}s of [the same|equal] height",
        f"[stack|pile] {{inv}} into {kk} [equal|equally tall] {t}s",
        f"{BUILD} {kk} {t}s of [the same|equal] height [from|out of] {{inv}}",
        f"{BUILD} {kk} {color} {t}s [of {NUMBERS[h]}|of {NUMBERS[h]} {many} each|, each {NUMBERS[h]} {many} "
        f"high|each of {NUMBERS[h]} {many}]",
        f"{kk} {color} {t}s, {'both' if k == 2 else 'all'} [{NUMBERS[h]} {many} high|of {NUMBERS[h]}]",
        f"{kk} {t}s of {NUMBERS[h]} {color} {many} each",
        f"{{inv}} [are|should be|must be|get] [stacked|piled] into {kk} {t}s of [the same|equal] height",
        f"each of {kk} {t}s [has|consists of|is made of] {NUMBERS[h]} {color} {many}",
    )
    look = color or "plain"
    hold = piled(*[[look] * h] * k)
    miss = [piled(*[[look] * (h + 1), [look] * (h - 1), *[[look] * h] * (k - 2)]), "^".join([look] * (k * h))]
    inv: tuple[str, ...] = (f"{number(rng, k * h)} {color} {many}",)
    return Wish("equal towers", inv, goals, wholes, {"assets": {look: k * h}, "hold": [hold], "miss": miss}, {}, True)


def part_piled(rng: Random) -> Wish:
    """So many of the blocks in a tower, the rest as told or left open."""
    color = rng.choice(COLORS)
    n = rng.choice((4, 5, 5, 6))
    k = rng.choice(range(2, n - 1))
    noun, t = rng.choice(NOUNS), rng.choice(TOWER)
    many, kk = plural(noun), NUMBERS[k]
    left = NUMBERS[n - k]
    rest = f"[the rest|the others|the other {left}|the remaining {left}|all others|the remaining {many}]"
    lie = "[stay|lie|are|remain|stay|should lie|must lie] [on the table|flat on the table]"
    mat, there = rng.choice(PATCHES), rng.choice([c for c in COLORS if c != color])
    told = rng.random() < 0.5
    tail = f"{rest} [go|are|lie|must be|belong|should be] on the {there} {mat}" if told else f"{rest} {lie}"
    goals: tuple[str, ...] = (
        f"[stack|pile up] {kk} of them, {tail}",
        f"{kk} of them [form|make|are in|should form|must be in] a {t}, {tail}",
        f"{BUILD} a {t} of {kk}, [and|] {tail}",
        f"{BUILD} a {t} from {kk} of them; {tail}",
        f"[stack|pile up] {kk} of the {many}. {tail}",
        f"{kk} are [stacked|piled up|in a {t}], {tail}",
    )
    wholes: tuple[str, ...] = (
        f"[stack|pile up] {kk} of {{inv}}, {tail}",
        f"of {{inv}}, {kk} [form|should form|are in] a {t}, [and|] {tail}",
        f"{BUILD} a {t} from {kk} of {{inv}}; {tail}",
        f"{{inv}}, {kk} of them [stacked|in a {t}|piled up], [and|] [the rest|the others] [flat on the "
        "table|on the table]"
        if not told
        else f"{{inv}}, {kk} of them [stacked|in a {t}], the [rest|others|other {left}] on the {there} {mat}",
    )
    pile = "^".join([color] * k)
    meaning: dict[str, object] = {"assets": {color: n}}
    if told:
        others = (
            " ".join([color] * (n - k))
            if n - k < 3
            else " | ".join([f"{color} {color}", " ".join([color] * (n - k - 2))])
        )
        meaning = {
            "assets": {color: n, f"{there}_patch": 1},
            "hold": [f"{pile}; {others} at={there}_patch"],
            "miss": [pile, f"{color}^{pile} at={there}_patch"],
        }
    else:
        meaning |= {
            "hold": [pile],
            "miss": [f"{pile}; {color}^{color}", "^".join([color] * (k + 1)), "^".join([color] * n)],
        }
    return Wish(
        "part piled" + (", the rest there" if told else ""),
        (f"{number(rng, n)} {color} {many}",),
        goals,
        wholes,
        meaning,
        {},
        True,
    )


def limits(rng: Random) -> Wish:
    """Towers no higher, no lower or no more than so many."""
    color = rng.choice(COLORS)
    noun, t = rng.choice(NOUNS), rng.choice(TOWER)
    many = plural(noun)
    n = rng.choice((5, 6, 7))
    kind = rng.choice(("lowest", "highest", "some"))
    if kind == "lowest":
        goals = (
            f"{BUILD} two {t}s, neither [of them|] lower than two",
            f"{BUILD} two {t}s, [each|each of them|both] at least two {many} high",
            f"{BUILD} two {t}s of at least two {many} each",
            f"all of them go into two {t}s, [each|both] at least two high",
        )
        hold, miss = [piled([color] * 2, [color] * (n - 2))], [piled([color] * (n - 1), [color]), "^".join([color] * n)]
    elif kind == "highest":
        goals = (
            f"[stack|pile] [all of them|them all|all the {many}] in {t}s, none [of them|] higher than three",
            f"[stack|pile] [all of them|them all|all the {many}] in {t}s [of at most three|no higher than "
            "three|at most three high]",
            f"use [them all|all of them] in {t}s, none [of them|] higher than three [{many}|]",
        )
        three = [[color] * 3, [color] * 2, [color] * 2] if n == 7 else [[color] * 3, [color] * (n - 3)]
        hold, miss = [piled(*three)], [piled([color] * 4, [color] * (n - 4)), "^".join([color] * n)]
    else:
        goals = (
            f"{BUILD} a {t} [of at least three|at least three {many} high|that is at least three high] "
            "[from|out of] them",
            f"at least three of them [must|should|have to] [be stacked|be in one {t}|form one {t}]",
            f"there should be a {t} of at least three",
            f"one {t} [must|should] have at least three {many}",
        )
        hold, miss = ["^".join([color] * 3), "^".join([color] * 4)], ["^".join([color] * 2)]
    return Wish(
        f"towers {kind}",
        (f"{number(rng, n)} {color} {many}",),
        goals,
        (),
        {"assets": {color: n}, "hold": hold, "miss": miss},
        {},
        True,
    )


def solid(rng: Random) -> Wish:
    """A cube of eight, its layers coloured; the small ones are no small blocks."""
    low, high = rng.sample(COLORS, 2)
    big = "[one big cube|a big cube|a large cube|a bigger cube|one large cube]"
    goals: tuple[str, ...] = (
        f"[make|build|form] {big} [from|out of] eight [small ones|small cubes|cubes|little ones], [i.e. |that "
        f"is |][2 by 2 by 2|2x2x2]. the [bottom|lower] layer is {low}, the [upper|top] layer {high}",
        f"[make|build] {big}, 2 by 2 by 2, the [bottom|lower] layer {low} and the [top|upper] one {high}",
        f"[make|build] a cube of 2 by 2 by 2 blocks with a {low} [bottom|lower] layer and a {high} [top|upper] one",
        f"eight [small|] cubes make up {big}. the four below are {low}, the four above {high}",
        f"2x2x2 cube, {low} below, {high} above",
    )
    hold = f"{low}^{high} {low}^{high} | {low}^{high} {low}^{high} pitch=1"
    meaning = {
        "assets": {low: 4, high: 4},
        "hold": [hold],
        "miss": [hold.replace("^", "~").replace(low, "@").replace(high, low).replace("@", high).replace("~", "^")],
    }
    return Wish("solid of layers", (), (), goals, meaning)


KINDS = (per_color, heights, equal, part_piled, limits, solid)
