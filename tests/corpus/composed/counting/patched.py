"""Wishes about patches: each on its own, so many of them there, none, the one and the other."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.counting.phrasing import (
    COLORS,
    NOUNS,
    PATCHES,
    Wish,
    counted,
    listed,
    number,
    on,
    plural,
    stock,
)

MUST = "[must|should|has to|needs to|is to|shall|is supposed to]"
GO = (
    "[goes|belongs|lies|stands|rests|ends up|must be|should be|has to be|needs to be|is to be|shall be|should end up|"
    "is]"
)
GOES = "[go|belong|lie|stand|end up|must be|should be|have to be|need to be|are to be|shall be|should end up|are]"
PUT = "[put|place|move|bring|set|get|lay|I want you to put|please put|you should place|could you put]"
OWN = (
    "[of its colour|of its own colour|of the same colour|with the same colour|that has its colour|which has "
    "its colour|"
    "that matches its colour|matching its colour|in its own colour|with its colour|that has the same "
    "colour|of matching colour]"
)
OWNS = "[of their colour|of their own colour|of the same colour|with their colour|matching their colour]"


def own_patch(rng: Random) -> Wish:
    """Every block on the patch of its colour."""
    colors = rng.sample(COLORS, rng.choice((2, 2, 3)))
    n = rng.choice((1, 1, 2, 2, 3))
    noun, mat = rng.choice(NOUNS), rng.choice(PATCHES)
    mats = listed([counted(rng, 1, c, mat) for c in colors])
    both = [f"{inv}, and {mats}" for inv in stock(rng, [(n, c) for c in colors], noun)] + [
        f"{inv}, and {plural(mat)} of the same colours" for inv in stock(rng, [(n, c) for c in colors], noun)[:3]
    ]
    goals: tuple[str, ...] = (
        f"{PUT} [each|every|each and every] {noun} [on|onto] the {mat} {OWN}",
        f"{PUT} [each|every] {noun} on its [own|matching] [colour|{mat}]",
        f"[each|every|every single] {noun} {GO} on the {mat} {OWN}",
        f"[every one|each one|each] of them {GO} on the {mat} {OWN}",
        f"[all {plural(noun)}|the {plural(noun)}|they|all of them] {GOES} on the {plural(mat)} {OWNS}",
        f"{PUT} [all the {plural(noun)}|the {plural(noun)}|them|all of them] on the {plural(mat)} {OWNS}",
        f"for each colour, {PUT} the {plural(noun)} [of that colour|in that colour] on the {mat} of that colour",
        f"[sort|distribute] the {plural(noun)} [onto|to] the {plural(mat)} by colour",
        f"at the end, [each|every] {noun} [is|lies|must be|should be] on the {mat} {OWN}",
        f"[each|every] {mat} [gets|holds|has|carries|should get|must hold] [the {plural(noun)}|all "
        f"{plural(noun)}] of its [own|] colour",
        f"no {noun} may [be|lie] on a {mat} of another colour, and [every one|each {noun}] must be on a {mat}",
        f"the {plural(noun)} [of each colour|of every colour] {GOES} on the {mat} of that colour",
    )
    wholes: tuple[str, ...] = (
        f"{PUT} each of {{inv}} on the {mat} {OWN}",
        f"{{inv}}, [each|every one] on the {mat} {OWN}",
        f"{{inv}} {GOES} on the {plural(mat)} {OWNS}",
        f"each of {{inv}} {GO} on the {mat} {OWN}",
    )
    if n == 1:
        wholes = (wholes[0], wholes[1], wholes[3])
        goals = tuple(
            g for g in goals if "for each colour" not in g and "of every colour" not in g and "[gets|holds" not in g
        )
    hold = "; ".join(on([c] * n, f"{c}_patch") for c in colors)
    turned = colors[1:] + colors[:1]
    miss = "; ".join(on([c] * n, f"{p}_patch") for c, p in zip(colors, turned, strict=True))
    part = "; ".join(on([c] * n, f"{c}_patch") for c in colors[1:])
    meaning = {
        "assets": dict.fromkeys(colors, n) | {f"{c}_patch": 1 for c in colors},
        "hold": [hold],
        "miss": [miss, part],
    }
    plain = stock(rng, [(n, c) for c in colors], noun)
    first = rng.random() < 0.7
    return Wish("own patch", tuple(both) if first else plain, goals, wholes if not first else (), meaning)


def piled_on_own(rng: Random) -> Wish:
    """The blocks of each colour stacked on the patch of that colour."""
    colors, n = rng.sample(COLORS, rng.choice((2, 2, 3))), rng.choice((2, 2, 3))
    noun, mat = rng.choice(NOUNS), rng.choice(PATCHES)
    many, mats = plural(noun), listed([counted(rng, 1, c, mat) for c in colors])
    goals: tuple[str, ...] = (
        f"[stack|pile|pile up] the {many} of [each|every] colour on the {mat} [of that colour|of the same "
        "colour|of their colour]",
        f"{many} of the same colour must be stacked, each stack on the {mat} [which has its colour|of its "
        "colour|of the same colour]",
        f"[stack|pile up] [each|every] colour on the {mat} [of the same colour|of its colour|of its own colour]",
        f"[each|every] colour [becomes|forms] a [tower|stack] on its own {mat}",
        f"on [each|every] {mat} [stands|there is|there should be|I want] a tower of the {many} of its colour",
        f"make a tower of each colour, on the {mat} of [that|the same] colour",
        f"for each of the colours, stack the {many} of the colour on the {mat} of the same colour",
        f"the {many} of each colour [should|must|shall] be stacked on the {mat} of that colour",
    )
    wholes: tuple[str, ...] = (
        "{inv} [get|must be|should be|are to be] stacked, each colour on the " + f"{mat} of the same colour",
        "stack {inv}, each colour on the " + f"{mat} of its [own|] colour",
    )
    inv = stock(rng, [(n, c) for c in colors], noun)
    told = tuple(f"{i}, and {mats}" for i in inv) if rng.random() < 0.6 else inv
    hold = "; ".join(f"{'^'.join([c] * n)} at={c}_patch" for c in colors)
    flat = "; ".join(on([c] * n, f"{c}_patch") for c in colors)
    turned = "; ".join(
        f"{'^'.join([c] * n)} at={p}_patch" for c, p in zip(colors, colors[1:] + colors[:1], strict=True)
    )
    meaning = {
        "assets": dict.fromkeys(colors, n) | {f"{c}_patch": 1 for c in colors},
        "hold": [hold],
        "miss": [flat, turned],
    }
    return Wish("piled on its own patch", told, goals, wholes if told is inv else (), meaning)


def _of_them(how: str, be: str, sort: str, color: str, many: str, mats: str) -> tuple[str, ...]:
    """What is said of blocks that were told of before."""
    may = "may be" if sort == "most" else be
    is_ = "is" if be.startswith("[is") else "are"
    colored = f"{color} {many}"
    return (
        f"{how} of them {may} on {mats}",
        f"on {mats} [there must be|there should be|there {is_}] {how} of them",
        f"{how} of the {many} {may} on {mats}",
        f"I want {how} of [them|the {many}] on {mats}",
        f"{how} of [them|the {colored}|these] [may|can|should] [be|lie|stand] on {mats}"
        if sort == "most"
        else f"{PUT} {how} of [them|the {many}] on {mats}",
        f"of these, {how} {may} on {mats}",
        f"[the number of {colored} on {mats}|the number of {many} on {mats}] [must be|should be|is] {how}".replace(
            ", no more and no fewer,", ""
        ),
        f"[at the end|in the end|finally], {how} of them {may} on {mats}",
    )


def _of_the_stock(how: str, be: str, sort: str, kk: str, mats: str) -> tuple[str, ...]:
    """What is said of them where they are told of first."""
    may = "may be" if sort == "most" else be
    return (
        f"{how} of {{inv}} {may} on {mats}",
        f"of {{inv}}, {how} {may} on {mats}",
        f"{{inv}}, of which {how} {may} on {mats}",
        f"on {mats} [there should be|there must be|I want] {how} of {{inv}}",
        f"I [want|need|would like] {how} of {{inv}} [on {mats}|to be on {mats}]",
        f"{{inv}}, {how} of them on {mats}",
        f"{how} of {{inv}} [should|must|shall] [be|lie|be found|be placed|end up] on {mats}"
        if sort != "most"
        else f"{how} of {{inv}} may [be|lie|stand] on {mats}",
        f"{mats} [must hold|should hold|gets|has] {how} of {{inv}}",
        f"{{inv}}, and {how} of them {may} on {mats}",
        f"[let|have] {how} of {{inv}} be on {mats}"
        if sort != "most"
        else f"no more than {kk} of {{inv}} in the end on {mats}",
    )


def so_many_there(rng: Random) -> Wish:
    """Exactly, at least or at most so many of the blocks on a patch."""
    color, there = rng.sample(COLORS, 2)
    n = rng.choice((3, 4, 4, 5))
    k = rng.choice(range(1, n))
    noun, mat = rng.choice(NOUNS), rng.choice(PATCHES)
    many = plural(noun)
    kk = FROM_NONE[k]
    sort = rng.choice(("exactly", "exactly", "least", "most"))
    how = {
        "exactly": f"[exactly {kk}|precisely {kk}|just {kk}|only {kk}|{kk}, no more and no fewer,]",
        "least": f"[at least {kk}|{kk} or more|no fewer than {kk}|a minimum of {kk}|not fewer than {kk}]",
        "most": f"[at most {kk}|no more than {kk}|not more than {kk}|{kk} at most]",
    }[sort]
    be = "[is|lies|goes|must be|should be|has to be]" if k == 1 else "[are|lie|go|must be|should be|have to be]"
    mats = f"the {there} {mat}"
    goals = _of_them(how, be, sort, color, many, mats)
    wholes = _of_the_stock(how, be, sort, kk, mats)
    inv: tuple[str, ...] = (
        f"{number(rng, n)} {color} {many}",
        f"{number(rng, n)} {many}, all {color}",
        f"{number(rng, n)} {many}, all of them {color}",
    )
    good = {"exactly": [k], "least": [k, n], "most": [k, 0]}[sort]
    bad = {"exactly": [k - 1, k + 1], "least": [k - 1], "most": [k + 1]}[sort]
    patch = f"{there}_patch"
    meaning = {
        "assets": {color: n, patch: 1},
        "hold": [on([color] * i, patch) if i else color for i in good],
        "miss": [on([color] * i, patch) if i else color for i in bad],
    }
    return (
        Wish(f"{sort} so many there", inv if rng.random() < 0.5 else inv[:1], goals, (), meaning)
        if rng.random() < 0.5
        else Wish(f"{sort} so many there", inv[:1], (), wholes, meaning)
    )


FROM_NONE = ("none", "one", "two", "three", "four", "five")


def all_but(rng: Random) -> Wish:
    """All but so many, half, none, both, all of them on a patch."""
    color, there = rng.sample(COLORS, 2)
    n = rng.choice((2, 3, 4, 4))
    noun, mat = rng.choice(NOUNS), rng.choice(PATCHES)
    many, place, patch = plural(noun), f"the {there} {mat}", f"{there}_patch"
    ways = {
        "none": (0, "[none|not one|not a single one]", "[is|may be|should be|must be|is allowed]"),
        "all": (n, "all" if n > 2 else "both", "[are|go|belong|must be|should be|have to be]"),
        "but one": (n - 1, "all but one", "[are|go|must be|should be|have to be]"),
        "half": (n // 2, "[half|exactly half]", "[are|go|must be|should be|have to be]"),
    }
    kind = rng.choice([w for w in ways if not (w == "half" and n % 2) and not (w == "but one" and n == 2)])
    k, how, be = ways[kind]
    goals: tuple[str, ...] = (
        f"{how} of them {be} on {place}",
        f"{how} of the {many} {be} on {place}",
        f"[at the end|in the end], {how} of them {be} on {place}",
        f"I want {how} of them on {place}",
    )
    wholes: tuple[str, ...] = (
        f"{how} of the {{inv}} {be} on {place}",
        f"of the {{inv}}, {how} {be} on {place}",
        f"{{inv}}, {how} of [them|which] on {place}",
        f"I want {how} of the {{inv}} on {place}",
    )
    if kind == "none":
        goals = goals[:3]
        wholes = (
            *wholes[:2],
            f"no {noun} of the {{inv}} may be on {place}",
        )
    elif kind == "all":
        goals += (
            f"{place} [must hold|gets|carries] {how} of them",
            f"{PUT} {how} of them on {place}",
            f"they {be} all on {place}" if n > 2 else f"they {be} both on {place}",
        )
        wholes += (
            f"{PUT} {how} [of the|the|] {{inv}} on {place}" if n > 2 else f"{PUT} both {color} {many} on {place}",
            f"on {place} [are|lie|I want|there should be] the {{inv}}",
        )
    else:
        goals += (f"{PUT} {how} of them on {place}", f"{place} [gets|holds|carries|must hold] {how} of them")
        wholes += (f"{PUT} {how} of the {{inv}} on {place}",)
    meaning = {
        "assets": {color: n, patch: 1},
        "hold": [on([color] * k, patch) if k else color],
        "miss": [on([color] * i, patch) if i else color for i in {k - 1, k + 1} if 0 <= i <= n],
    }
    return Wish(f"{kind} there", (f"{number(rng, n)} {color} {many}",), goals, wholes, meaning)


def one_and_other(rng: Random) -> Wish:
    """Two or three of a kind, each at another place."""
    color, *hues = rng.sample(COLORS, 4)
    n = rng.choice((2, 2, 3))
    hues = hues[:n]
    noun, mat = rng.choice(NOUNS), rng.choice(PATCHES)
    many = plural(noun)
    patchy = rng.random() < 0.6
    places = [f"on the {c} {mat}" if patchy else f"on the {c} {'block' if noun == 'block' else noun}" for c in hues]
    ones = (
        ["one", "[the other|the other one|the second|the second one]"]
        if n == 2
        else ["one", "[another|another one|the second|one]", "[the third|the last one|one|the third one]"]
    )
    if n == 3 and rng.random() < 0.5:
        ones = ["one", "one", "one"]
    short = listed([f"{one} {place}" for one, place in zip(ones, places, strict=True)])
    verb = "[goes|is|stands|must be|should be|has to be|belongs]"
    full = listed([f"{one} {verb} {place}" for one, place in zip(ones, places, strict=True)])
    others = listed([f"{o} {p}" for o, p in zip(ones[1:], places[1:], strict=True)])
    first = f"{ones[0]} {verb} {places[0]}, {others}"
    first_of = f"{ones[0]} of [them|the {many}] {verb} {places[0]}, {others}"
    goals: tuple[str, ...] = (
        full,
        first,
        first_of,
        f"{PUT} {short}",
        f"I want {short}",
        f"{PUT} them so that {full}",
        f"{PUT} one of them {places[0]} and [the other|the other one] {places[1]}" if n == 2 else f"{PUT} {short}",
    )
    wholes: tuple[str, ...] = (
        f"{{inv}}, {short}",
        f"{{inv}}: {short}",
        f"of {{inv}}, {full}",
        f"{PUT} {{inv}}, {short}",
        f"there [are|should be] {{inv}}, {short}",
        f"one of {{inv}} {verb} {places[0]}, {listed([f'{o} {p}' for o, p in zip(ones[1:], places[1:], strict=True)])}",
        f"{{inv}} with {short}" if n == 2 else f"{{inv}}, {short}",
    )
    if patchy:
        assets = {color: n} | {f"{c}_patch": 1 for c in hues}
        hold = "; ".join(f"{color} at={c}_patch" for c in hues)
        miss = [on([color] * n, f"{hues[0]}_patch"), f"{color} at={hues[0]}_patch"]
    else:
        assets = {color: n} | dict.fromkeys(hues, 1)
        hold = "; ".join(f"{c}^{color}" for c in hues)
        miss = ["; ".join(f"{color}^{c}" for c in hues), f"{hues[0]}^{color}^{color}"]
    return Wish(
        "one and the other",
        (f"{number(rng, n)} {color} {many}",),
        goals,
        wholes,
        {"assets": assets, "hold": [hold], "miss": miss},
    )


def each_on_one(rng: Random) -> Wish:
    """Of two colours equally many, one of the first on each of the second."""
    low, high = rng.sample(COLORS, 2)
    n = rng.choice((2, 2, 3))
    noun = rng.choice(NOUNS)
    many, nn = plural(noun), FROM_NONE[n]
    goals: tuple[str, ...] = (
        f"{PUT} [a|one] {high} {noun} on [each|every] {low} [{noun}|one]",
        f"[each|every] {high} {noun} {GO} on a {low} [one|{noun}]",
        f"[each|every] {low} [one|{noun}] [carries|gets|has|should carry|must get|bears] [a|one] {high} [one|{noun}]",
        f"on [each|every] {low} [one|{noun}] [sits|stands|there is|there should be|put|I want] a {high} one",
        f"[each|every one] of the {high} [ones|{many}] {GO} on [a different|its own] {low} [one|{noun}]",
        f"the {high} [ones|{many}] {GOES} on the {low} [ones|{many}], one on each",
        f"no {low} {noun} [may be|is|should be] without a {high} {noun} on [it|top]",
        f"make {nn} [pairs|towers|stacks], [each|each of them] a {high} {noun} on a {low} [one|{noun}]",
        f"make {nn} [towers|stacks] of two, each with a {low} {noun} at the bottom and a {high} one on top",
        f"[each|every] tower [is|consists of] a {high} {noun} on a {low} one; there are {nn} towers",
    )
    wholes: tuple[str, ...] = (
        f"{nn} {low} {many}, each with a {high} {noun} on [it|top|top of it]",
        f"{nn} {low} {many}, each [carrying|bearing|topped by|topped with] a {high} one",
        f"[each|every one] of {nn} {low} {many} [carries|has|gets|should carry|must bear] a {high} {noun}",
        f"{nn} {low} {many} with a {high} {noun} on each [of them|]",
        f"on each of {nn} {low} {many} [there is|sits|stands|put|place] a {high} {noun}",
        f"{PUT} a {high} {noun} on each of {nn} {low} {many}",
        f"make {nn} [pairs|towers|stacks], [each|each of them] a {high} {noun} on a {low} [one|{noun}]",
    )
    hold = "; ".join([f"{low}^{high}"] * n)
    miss = ["; ".join([f"{high}^{low}"] * n), "; ".join([f"{low}^{high}"] * (n - 1)), f"{low}^{high}^{high}"]
    meaning = {"assets": {low: n, high: n}, "hold": [hold], "miss": miss}
    return Wish("each on one", stock(rng, [(n, low), (n, high)], noun), goals, wholes, meaning)


KINDS = (own_patch, piled_on_own, so_many_there, all_but, one_and_other, each_on_one)
