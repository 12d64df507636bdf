"""Wishes about groups, halves, corners, and what is only lying about."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.counting.patched import GO, GOES, PUT
from tests.corpus.composed.counting.phrasing import (
    COLORS,
    NOUNS,
    NUMBERS,
    PATCHES,
    Wish,
    counted,
    listed,
    number,
    plural,
    stock,
)

GROUP = ("group", "group", "pile", "bunch", "cluster", "heap")
SORT = "[group|sort|gather|organise|organize]"


def by_color(rng: Random) -> Wish:
    """A group for each colour."""
    colors, n = rng.sample(COLORS, rng.choice((2, 2, 3))), rng.choice((2, 3, 3))
    noun, g = rng.choice(NOUNS), rng.choice(GROUP[:5])
    many, k = plural(noun), NUMBERS[len(colors)]
    goals: tuple[str, ...] = (
        f"{SORT} [them|the {many}] by colour",
        f"[sort|divide|split|separate] [them|the {many}] into {g}s by colour",
        f"[sort|divide|split] [them|the {many}] into {k} {g}s, one [per|for each|for every] colour",
        f"[each|every] colour [forms|makes|gets|should form|is] a {g} [of its own|]",
        f"[each|every] colour [in|goes in|goes into|belongs in] [its own [little|] {g}|a {g} of its own]",
        f"{many} of the same colour [belong|go|must be|should be|are] [together|in one {g}|in the same {g}]",
        f"[put|bring|gather] [{many}|the ones|those] of the same colour together, [apart|separate|away] from "
        "the [others|rest|other colours]",
        f"[make|form|I want] a {g} [of|for] each colour",
        f"[make|form|I want] one {g} per colour",
        f"[sort|group] [them|the {many}] by colour",
        f"the {colors[0]} ones [form|make up] one {g} and the {colors[1]} ones [another|another one|a second one]"
        if len(colors) == 2
        else f"one {g} for each colour",
        f"separate the {colors[0]} ones from the {colors[1]} ones"
        if len(colors) == 2
        else "separate the colours [from each other|]",
        f"keep the colours [apart|separate], each in [its own|one] {g}",
    )
    wholes: tuple[str, ...] = (
        f"{SORT} {{inv}} by colour",
        f"[sort|divide|split] {{inv}} into {g}s by colour",
        f"{k} {g}s by colour[:|,] {{inv}}",
        "{inv}, [grouped|sorted] by colour",
        f"a {g} of {listed([f'{NUMBERS[n]} {c} {many}' for c in colors], f'and a {g} of')}"
        if len(colors) == 2
        else f"{SORT} {{inv}} by colour",
        f"put {{inv}} [in|into] {k} {g}s, [each of one colour|one for each colour]",
        "{inv} [are|should be|must be] [grouped|sorted] by colour",
    )
    hold = " . . . ".join(" ".join([c] * n) for c in colors)
    if len(colors) == 3:
        rows = [" ".join([c] * n) for c in colors]
        hold = f"{rows[0]} . . . {rows[1]} | . | . | . | {rows[2]}"
    mixed = " . . . ".join(" ".join(colors[(i + j) % len(colors)] for j in range(n)) for i in range(len(colors)))
    meaning = {
        "assets": dict.fromkeys(colors, n),
        "hold": [hold],
        "miss": [mixed, " ".join(" ".join([c] * n) for c in colors[:2])],
    }
    return Wish("groups by colour", stock(rng, [(n, c) for c in colors], noun), goals, wholes, meaning)


def strangers(rng: Random) -> Wish:
    """Groups by colour with exactly one stranger in each."""
    (a, b), n = rng.sample(COLORS, 2), rng.choice((3, 4))
    noun, g = rng.choice(NOUNS), rng.choice(GROUP[:3])
    many = plural(noun)
    odd = f"[outlier|stranger|odd one out|{noun} of the other colour|{noun} of the wrong colour|intruder]"
    one = f"exactly one {odd}"
    tail = (
        f"[with {one} in each [{g}|]|but with {one} in each|but exactly one {odd} must be in each {g}|and "
        f"let exactly one in each {g} be of the [other|wrong] colour|each [{g}|] with {one}|each "
        f"containing {one}|but let {one} be in each {g}]"
    )
    goals: tuple[str, ...] = (
        f"[group|sort] [them|the {many}] by colour, {tail}",
        f"[make|form] two {g}s by colour, {tail}",
        f"[make|form] a {a} {g} and a {b} {g}, {tail}",
        f"[sort|split|divide] [them|the {many}] into a {a} {g} and a {b} {g}, {tail}",
        f"[each|every] colour forms a {g}, {tail}",
    )
    wholes: tuple[str, ...] = (
        f"[group|sort] {{inv}} by colour, {tail}",
        f"two {g}s by colour, {{inv}}, {tail}",
        f"{{inv}} [in|form] two {g}s by colour, {tail}",
        f"[make|form] two {g}s, a {a} one and a {b} one, out of {{inv}}, {tail}",
        f"[sort|divide|split] {{inv}} into two {g}s by colour, {tail}",
    )
    rows = [" ".join([a] * (n - 1) + [b]), " ".join([b] * (n - 1) + [a])]
    miss = [f"{' '.join([a] * n)} . . . {' '.join([b] * n)}"]
    meaning = {"assets": {a: n, b: n}, "hold": [" . . . ".join(rows)], "miss": miss}
    return Wish("strangers", stock(rng, [(n, a), (n, b)], noun), goals, wholes, meaning)


KINDS_OF = (
    ("vowels", "consonants", "AEIOU", "BCDFKT", "letters"),
    ("odd numbers", "even numbers", "13579", "2468", "digits"),
    ("odd digits", "even digits", "13579", "2468", "numbers"),
    ("letters", "digits", "ABCDEFGH", "123456", "cubes"),
    ("letters", "numbers", "ABCDEFGH", "123456", "cubes"),
)


def by_kind(rng: Random) -> Wish:
    """Vowels and consonants, odd and even, letters and digits: in groups, or on two patches."""
    one, two, firsts, seconds, word = rng.choice(KINDS_OF)
    a = rng.sample(firsts, rng.choice((2, 2, 3)))
    b = rng.sample(seconds, rng.choice((2, 3)))
    mixed = a + b
    rng.shuffle(mixed)
    cubes = listed(mixed if rng.random() < 0.6 and word != "cubes" else a + b)
    inv: tuple[str, ...] = (
        f"the {word} {cubes}",
        f"the [{'letter cubes|' if word == 'letters' else ''}cubes|blocks] {cubes}",
        cubes,
    )
    g = rng.choice(GROUP[:4])
    hold = f"{' '.join(a)} . . . {' '.join(b)}"
    bad = [b[0], *a[1:]], [a[0], *b[1:]]
    miss = [f"{' '.join(bad[0])} . . . {' '.join(bad[1])}", f"{' '.join(a)} {' '.join(b)}"]
    assets = dict.fromkeys(mixed, 1)
    if rng.random() < 0.5:
        mat, (ca, cb) = rng.choice(PATCHES), rng.sample(COLORS, 2)
        goals = (
            f"{PUT} the {one} on the {ca} {mat} and the {two} on the {cb} [{mat}|one]",
            f"the {one} {GOES} on the {ca} {mat}, the {two} on the {cb} [{mat}|one]",
            f"all {one} {GOES} on the {ca} {mat} and all {two} on the {cb} {mat}",
            f"[each|every] {one[:-1]} {GO} on the {ca} {mat}, [each|every] {two[:-1]} on the {cb} {mat}",
            f"the {ca} {mat} gets the {one}, the {cb} [{mat}|one] the {two}",
        )
        patches = {f"{ca}_patch": 1, f"{cb}_patch": 1}
        on = [
            f"{' '.join(x[:2])} | {' '.join(x[2:])} at={c}_patch".replace("|  at", "at") for x, c in ((a, ca), (b, cb))
        ]
        off = [
            f"{' '.join(x[:2])} | {' '.join(x[2:])} at={c}_patch".replace("|  at", "at") for x, c in ((a, cb), (b, ca))
        ]
        meaning = {"assets": assets | patches, "hold": ["; ".join(on)], "miss": ["; ".join(off), on[0]]}
        return Wish("kinds on patches", inv, goals, (), meaning)
    goals: tuple[str, ...] = (
        f"separate the {one} from the {two}",
        f"the {one} [form|make up|make|should form] one {g} and the {two} [another|another one|a second one|the other]",
        f"the {one} [go|belong] [in|into] one {g}, the {two} [in|into] [another|the other|a second one]",
        f"[sort|divide|split] them into {one} and {two}",
        f"[sort|divide|split] them into two {g}s, {one} and {two}",
        f"[make|form] two {g}s, [one of the {one} and one of the {two}|one with the {one}, the other with the "
        f"{two}|the {one} and the {two}]",
        f"[make|form] a {g} of {one} and a {g} of {two}",
        f"{one} in one {g}, {two} in [another|the other]",
        f"keep the {one} and the {two} [apart|in separate {g}s]",
        f"all {one} together, and all {two} together, in two {g}s",
    )
    wholes: tuple[str, ...] = (
        f"[separate|sort|split|divide] {{inv}} into {one} and {two}",
        f"among {{inv}}, the {one} [form|make up] one {g} and the {two} another",
        f"[sort|divide|split] {{inv}} into two {g}s, {one} and {two}",
        f"from {{inv}}, [make|form] a {g} of {one} and a {g} of {two}",
    )
    return Wish("kinds in groups", inv, goals, wholes, {"assets": assets, "hold": [hold], "miss": miss})


def halves(rng: Random) -> Wish:
    """One colour in each half of the table."""
    (a, b), n = rng.sample(COLORS, 2), rng.choice((1, 2, 2, 3))
    m = rng.choice((1, 2, 3))
    noun = rng.choice(NOUNS)
    sides = rng.choice((("left", "right"), ("right", "left"), ("near", "far"), ("far", "near")))
    half = [f"[in|into] the {s} half[ of the table|]" for s in sides]
    here, there = (place.replace("[in|into]", "in") for place in half)
    A, B = (f"the {c} [ones|{plural(noun)}]" if k > 1 else f"the {c} [one|{noun}]" for c, k in ((a, n), (b, m)))
    be = "[go|belong|must be|should be|are|have to be]" if n > 1 else "[goes|belongs|must be|should be|is|has to be]"
    goals: tuple[str, ...] = (
        f"{A} {be} {here}, {B} {there}",
        f"{PUT} {A} {half[0]} and {B} {half[1]}",
        f"{here} I want {A} and {there} {B}",
        f"all {a} ones {be} {here} and all {b} ones {there}" if n > 1 and m > 1 else f"{A} {be} {here}, {B} {there}",
    )
    wholes: tuple[str, ...] = (
        f"{PUT} {counted(rng, n, a, noun)} {half[0]} and {counted(rng, m, b, noun)} {half[1]}",
        f"{counted(rng, n, a, noun)} in the {sides[0]} half, {counted(rng, m, b, noun)} in the {sides[1]} half",
        f"{sides[0]} half of the table: {counted(rng, n, a, noun)}; {sides[1]} half: {counted(rng, m, b, noun)}",
        f"{PUT} {counted(rng, n, a, noun)} in the {sides[0]} half of the table and {counted(rng, m, b, noun)} "
        "in the other [half|one|]",
    )
    spot = {"left": "0,3", "right": "0,-3", "far": "2,0", "near": "-2,0"}
    one, two = (" ".join([c] * k) for c, k in ((a, n), (b, m)))
    hold = f"{one} at={spot[sides[0]]} pitch=1.2; {two} at={spot[sides[1]]} pitch=1.2"
    miss = f"{one} at={spot[sides[1]]} pitch=1.2; {two} at={spot[sides[0]]} pitch=1.2"
    return Wish(
        "halves",
        stock(rng, [(n, a), (m, b)], noun),
        goals,
        wholes,
        {"assets": {a: n, b: m}, "hold": [hold], "miss": [miss]},
    )


def corners(rng: Random) -> Wish:
    """One in every corner."""
    color, noun = rng.choice(COLORS), rng.choice(NOUNS)
    goals: tuple[str, ...] = (
        f"{PUT} one in [each|every] corner [of the table|]",
        f"{PUT} one of them in [each|every] corner [of the table|]",
        f"[each|every] corner [of the table|] [gets|holds|has|should have|must have] [one|one of them|a {noun}]",
        "there [should|must] be one in [each|every] corner [of the table|]",
        f"[each|every one] of them {GO} in [a different corner|another corner|a corner of its own|its own "
        "corner] of the table",
        "in [each|every] corner [of the table|] [lies|stands|there is|I want] [one|one of them]",
        "they [go|belong|are|should be] in the four corners of the table, one in each",
    )
    wholes: tuple[str, ...] = (
        f"[four {color} {plural(noun)}|4 {color} {plural(noun)}], one in [each|every] corner [of the table|]",
        f"a {color} {noun} in [each|every] [corner|one of the four corners] [of the table|]",
        f"{PUT} a {color} {noun} in [each|every] corner [of the table|]",
        f"[each|every] corner of the table [gets|has|holds|should have] a {color} {noun}",
        "{inv}, each in [a different corner|a corner of its own|another corner] of the table",
    )
    four = ["3,5", "3,-5", "-3,5", "-3,-5"]
    hold = "; ".join(f"{color} at={spot}" for spot in four)
    miss = "; ".join(f"{color} at={spot}" for spot in four[:3])
    return Wish(
        "corners",
        (f"{number(rng, 4)} {color} {plural(noun)}",),
        goals,
        wholes,
        {"assets": {color: 4}, "hold": [hold], "miss": [miss]},
    )


def distractors(rng: Random) -> Wish:
    """A small wish, and blocks that are only lying about."""
    a, b, c = rng.sample(COLORS, 3)
    n = rng.choice((1, 2, 3))
    noun = rng.choice(NOUNS)
    loose = counted(rng, n, c, noun)
    be, serve, matter, lies = (
        ("is", "serves", "does not matter", "lies") if n == 1 else ("are", "serve", "do not matter", "lie")
    )
    plain = "a distractor" if n == 1 else "distractors"
    main, assets, hold, miss = rng.choice(
        (
            (f"[put|stack] the {a} {noun} on the {b} [one|{noun}]", {a: 1, b: 1}, f"{b}^{a}", f"{a}^{b}"),
            (f"the {a} {noun} {GO} on the {b} [one|{noun}]", {a: 1, b: 1}, f"{b}^{a}", f"{a}^{b}"),
            (f"[build|make] a tower of three {a} {plural(noun)}", {a: 3}, f"{a}^{a}^{a}", f"{a}^{a}"),
            (
                f"[lay|put] three {a} {plural(noun)} in a row",
                {a: 3},
                f"{a} {a} {a}",
                f"{a}^{a}^{a}",
            ),
            (f"{PUT} the {a} {noun} on the {b} patch", {a: 1, f"{b}_patch": 1}, f"{a} at={b}_patch", a),
        )
    )
    goals: tuple[str, ...] = (
        f"{main}. {loose} [{be} only there as|{serve} as|{be} just] {plain}",
        f"{main}, with {loose} as [{plain}|mere {plain}|{'a distractor' if n == 1 else 'distractors'} only]",
        f"{main}. there [{be}|{be} also] {loose}, [only as|as|just as] {plain}",
        f"{main}. {loose} {matter}",
        f"{main}; {loose} may lie [wherever|anywhere]",
        f"{main}. {loose} [may|can] [lie|be] [anywhere|wherever|wherever you like]",
        f"{main}. distractor{'' if n == 1 else 's'}: {loose}",
        f"{main}, plus {loose} [as {plain}|to distract]",
        f"{main}. {loose}, which [{matter}|{be} not needed|{be} not used|{be} only {plain}], {lies} [on the "
        "table|around] [too|as well]",
        f"{main}. ignore {loose} [that {lies} around|on the table|]",
        f"{main}. [besides|in addition], {loose} {be} lying around [as {plain}|]",
        f"[there {be}|on the table {lies}] {loose} [as {plain}|only as {plain}]. {main}",
        f"{main}. {loose} {be} [not needed|not used|of no importance|to be ignored|irrelevant]",
    )
    return Wish("distractors", (), (), goals, {"assets": assets | {c: n}, "hold": [hold], "miss": [miss]})


KINDS = (by_color, strangers, by_kind, halves, corners, distractors)
