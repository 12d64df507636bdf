"""Rows that alternate, are their own mirror image, are told by a few places, or keep distances."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.ordering.listed import Gaps, gaps_for, looks
from tests.corpus.composed.ordering.phrased import BLOCK, BLOCKS, PUT, RIGHT, WANT, Meaning, count, once

Drawn = tuple[str, Gaps, Meaning]
ALTERNATING = (
    f"{WANT} a row of {{n}} {{a}} and {{n}} {{b}} {BLOCKS} [with alternating colors|that alternate|, alternating|"
    f"alternating in color|taking turns]",
    f"{{n}} {{a}} and {{n}} {{b}} {BLOCKS} [in a row|in one row|in a line], [alternating|always alternating|taking "
    f"turns|with the colors alternating]",
    f"{{n}} {{a}} and {{n}} {{b}} {BLOCKS} in a row, [always one {{a}} one {{b}}|always one {{a}} and one {{b}} in "
    f"turn|one {{a}} one {{b}} and so on]",
    f"{PUT} {{n}} {{a}} and {{n}} {{b}} {BLOCKS} in a row [so that|such that|so] [the colors|{{a}} and {{b}}] "
    f"alternate",
    f"{PUT} {{n}} {{a}} and {{n}} {{b}} {BLOCKS} in a row [so that|such that] no two [{BLOCKS}|] of the same color "
    f"[are next to each other|touch|are neighbors]",
    f"[I have|there are] {{n}} {{a}} and {{n}} {{b}} {BLOCKS}. {PUT} them in a row, [alternately|alternating|"
    f"alternating in color|in alternating colors]",
    f"[the|] {{a}} and {{b}} {BLOCKS}, {{n}} of each, [alternate in a row|alternate along a row|in a row, alternating|"
    f"in an alternating row]",
    f"a row [in which|where] {{a}} and {{b}} {BLOCKS} alternate, {{n}} [of each|each|of each color]",
    "{n} {a} [ones|blocks] alternating with {n} {b} [ones|blocks] in [a|one|a single] row",
    "[an alternating row|alternating row|row, alternating]: {n} {a}, {n} {b}",
    f"{WANT} a row of {{n2}} {BLOCKS}, {{n}} {{a}} and {{n}} {{b}}, [alternating|the colors alternating|with "
    f"alternating colors|taking turns]",
    f"the colo[u|]rs [of the blocks|] in the row [should|must|have to|are to] alternate[: | between {{a}} and {{b}}, |"
    f", ]{{n}} {{a}} and {{n}} {{b}} {BLOCKS}",
)
LED = (
    f"{WANT} a row of {{n}} {{a}} and {{n}} {{b}} {BLOCKS}, alternating, [starting with|beginning with] {{a}} [on the "
    f"left|at the left end]",
    "{n} {a} n {n} {b} in a row, always one {a} one {b}, {a} is the first on the left",
    f"{PUT} {{n}} {{a}} and {{n}} {{b}} {BLOCKS} in a row, alternating, [the leftmost is {{a}}|a {{a}} one leftmost|"
    f"with {{a}} leftmost]",
    f"{{a}}, {{b}}, {{a}}, {{b}} and so on [in a row|], [{{n}} of each|{{n2}} in all|{{n2}} {BLOCKS} altogether], "
    f"{RIGHT}",
    f"alternating row {RIGHT}: {{n}} {{a}}, {{n}} {{b}}, {{a}} [first|comes first]",
)
ODD = (
    f"a row of {{m}} {BLOCKS} alternating {{a}} and {{b}}, [that begins and ends with {{a}}|with {{a}} at both ends|"
    f"{{a}} on both ends]",
    f"{WANT} a row that alternates, {{n1}} {{a}} and {{n}} {{b}} {BLOCKS}[, with {{a}} [on|at] both ends|]",
    f"{{n1}} {{a}} and {{n}} {{b}} {BLOCKS} in a row, alternating",
    f"alternating {{a}} and {{b}} {BLOCKS} in a row of {{m}}[, which|, that| that] [begins and ends|starts and ends] "
    f"with {{a}}",
    f"{PUT} {{n1}} {{a}} and {{n}} {{b}} {BLOCKS} in a row with a {{b}} one between [any two|each two|every two] "
    f"{{a}} ones",
    f"every other {BLOCK} in a row of {{m}} is {{a}}, [beginning|starting] with the leftmost[;|, and|.] the [rest|"
    f"others] are {{b}}",
)
MIRRORED = (
    f"{WANT} a row of two {{a}}, two {{b}} and one {{c}} {BLOCKS} [that|which] {{same}}",
    f"{PUT} two {{a}}, two {{b}} and one {{c}} {BLOCK} in a row [so that|such that] [it|the row] {{same}}",
    f"{PUT} two {{a}}, two {{b}} and one {{c}} {BLOCK} in a row. [It|The row] [should|must|has to] {{same_inf}}",
    f"[I have|there are] two {{a}}, two {{b}} and one {{c}} {BLOCK}. [make|build|form] a row [that|which] {{same}} "
    f"[from them|with them|]",
    "[a symmetric|a symmetrical|a mirrored|a mirror-symmetric|a palindromic] row [of|from|with] two {a}, two {b} and "
    "one {c} [block|cube]",
    "[symmetric|mirrored|palindromic|mirror-symmetric] row: two {a}, two {b}, one {c}",
    f"five {BLOCKS} in a row, two {{a}}, two {{b}} and one {{c}}, [so that|placed so that|arranged so that] [it|the "
    f"row] {{same}}",
    f"a row of five {BLOCKS}: two {{a}}, two {{b}}, one {{c}}. [It|the row|this row] {{same}}",
    f"the row [made of|of|consisting of] two {{a}}, two {{b}} and one {{c}} {BLOCK} {{same}}",
    f"with two {{a}}, two {{b}} and one {{c}} {BLOCK}, [make|build] a row [that|which] {{same}}",
    f"[at the end|in the end], two {{a}}, two {{b}} and one {{c}} {BLOCK} [stand|are] in a row [that|which] {{same}}",
    f"{WANT} a [symmetric|symmetrical|mirrored|palindromic] row [out of|from] two {{a}}, two {{b}} and one {{c}} "
    f"{BLOCK}",
)
SAME = (
    "[looks the same|reads the same|is the same] [from the left and from the right|from left and right|from both ends|"
    "from both sides|"
    "when read from the left and from the right|forwards and backwards|from left to right and from right to left|from "
    "either end|"
    "whether you read it from the left or from the right|in both directions]",
    "is [symmetric|symmetrical|mirror-symmetric|mirror symmetric] [about its middle|about its centre|about the middle|"
    "]",
    "is [a palindrome|a palindrome of colors|its own mirror image|a mirror image of itself]",
)
SAME_INF = (
    "[look the same|read the same|be the same] [from the left and from the right|from left and right|from both ends|"
    "from both sides|"
    "when read from the left and from the right|forwards and backwards|from left to right and from right to left]",
    "be [symmetric|symmetrical|mirror-symmetric] [about its middle|about its centre|]",
    "be [a palindrome|its own mirror image|a mirror image of itself]",
)
CENTERED = (
    f"{WANT} a row of two {{a}}, two {{b}} and one {{c}} {BLOCKS}, {{c}} in the [middle|center], {{a}} at [both ends|"
    f"the ends|either end|each end]",
    f"{PUT} five {BLOCKS} in a row: {{c}} in the middle, a {{b}} one on [each|either] side of [it|the {{c}} one], and "
    f"a {{a}} one at [either end|each end|both ends]",
    "symmetric row of five: {c} in the [middle|centre], {a} at [both ends|the ends], {b} in between",
    f"a row of five {BLOCKS} [in which|where] the [middle one|one in the middle] is {{c}}, the [outermost|outer] two "
    f"are {{a}} and the [remaining two|other two|rest] are {{b}}",
    f"five {BLOCKS} in a row. the [middle one|one in the middle] is {{c}}, [the ones at the ends|the two at the ends|"
    f"both ends] are {{a}} and the others are {{b}}",
    f"in a row of five {BLOCKS}, the two [at the ends|outer ones|on the outside] are {{a}}, the [middle one|one in "
    f"the middle] is {{c}} and the [other two|remaining two] are {{b}}",
)
PLACED = (
    f"{PUT} {{a_shuffled}} in a row [so that|such that|with] {{third}} [is|being] the third from the left and "
    f"{{first}} [is|being] the leftmost",
    f"{PUT} {{the_shuffled}} in a row. {{first}} is [the leftmost|leftmost|the first from the left|on the far left|at "
    f"the left end], {{third}} is [the third from the left|third from the left|third]",
    "{first} is [the leftmost|leftmost] [and|,] {third} the third from the left in a row of {the_shuffled}",
    "a row of {the_shuffled} [in which|where] {third} is [the|] third from the left [and|,] {first} [is|] [on "
    "the far left|at the left end|leftmost]",
    "in a row of {the_shuffled}, {third} [comes third from the left|is the third from the left|is third from the left|"
    "stands third from the left] and {first} [first|is first|comes first]",
    f"{PUT} {{the_shuffled}} in a row, {{first}} [on the far left|leftmost|at the left end|first from the left], "
    f"{{third}} third from the left",
    "[there are|I have] {a_shuffled}. [they|they should|they are to] [stand|be] in a row, {first} [leftmost|at "
    "the left end] and {third} third from the left",
)
MIDDLE = (
    f"{PUT} {{the_shuffled3}} in a row [with|so that|such that] {{second}} [in the middle|is in the middle|is between "
    f"the other two]",
    "{the_shuffled3} in a row[,| with] {second} in the [middle|center]",
    "a row of {the_shuffled3}[;|,|:] {second} [is|should be|has to be] [in the middle|the middle one]",
    f"{PUT} {{the_shuffled3}} in a row, in [any order|whatever order you like], [but|as long as|provided that|so long "
    f"as] {{second}} is in the middle",
    f"{PUT} {{the_shuffled3}} in a row. [The middle one|the one in the middle] [should be|is|has to be|must be] "
    f"{{second}}",
    "[the middle one|the middle block] of a row of {the_shuffled3} [is|should be] {second}",
    "{the_shuffled3} [are|should be|have to be] in a row, {second} [being|] in the middle",
)
SPACED = (
    f"{PUT} {{n}} {{a}} {BLOCKS} in a row [so that|such that|,] [every one touches|each one touches|each touches|"
    f"every block touches] [the next one|the next|its neighbo[u|]r]",
    f"{{n}} {{a}} {BLOCKS} in a row, every one has to touch the next one, no gaps",
    f"{{n}} {{a}} {BLOCKS} in a row [without gaps|with no gaps|, no gaps between them|, no gaps|without any gaps|"
    f"touching each other|with no space between them|, touching|tightly packed]",
    f"{WANT} a row of {{n}} {{a}} {BLOCKS} [that touch each other|touching one another|in which neighbors touch|"
    f"without gaps between them|where each one touches the next]",
    f"{PUT} {{n}} {{a}} {BLOCKS} in a row. [There should be no gaps|no gaps|there must be no gaps between them|they "
    f"should touch|they have to touch each other|neighbors touch]",
    f"a row of {{n}} {{a}} {BLOCKS} with [no gaps|no gaps between them|no space in between|nothing between them|all "
    f"neighbors touching|the blocks touching]",
)
NAMES = {"alternating": ALTERNATING, "led": LED, "odd": ODD, "mirrored": MIRRORED, "centered": CENTERED}


def alternating(rng: Random) -> Drawn:
    """Two colours in turn, as many of each, or one more of the first."""
    a, b, n = *looks(rng, "colors", 2), rng.choice((2, 3, 3))
    kind = rng.choice(("alternating", "alternating", "led", "odd"))
    gaps = {
        "a": a,
        "b": b,
        "n": count(rng, n),
        "n1": count(rng, n + 1),
        "n2": count(rng, 2 * n),
        "m": count(rng, 2 * n + 1),
    }
    if kind == "odd":
        row = [*([a, b] * n), a]
        return rng.choice(ODD), gaps, _meaning([row], [[b, a, *row[2:]], sorted(row)])
    row, back = [a, b] * n, [b, a] * n
    if kind == "led":
        return rng.choice(LED), gaps, _meaning([row], [back, sorted(row)])
    return rng.choice(ALTERNATING), gaps, _meaning([row, back], [[b, a, *row[2:]], sorted(row)])


def mirrored(rng: Random) -> Drawn:
    """The same read from both ends."""
    a, b, c = looks(rng, "colors", 3)
    gaps = {"a": a, "b": b, "c": c, "same": rng.choice(SAME), "same_inf": rng.choice(SAME_INF)}
    row, other = [a, b, c, b, a], [b, a, c, a, b]
    miss = [[a, b, c, a, b], [a, a, c, b, b], [a, c, b, b, a]]
    if rng.random() < 0.4:
        return rng.choice(CENTERED), gaps, _meaning([row], [*miss, other])
    return rng.choice(MIRRORED), gaps, _meaning([row, other], miss)


def placed(rng: Random) -> Drawn:
    """One or two blocks of a row told by their places."""
    kind = rng.choice(("colors", "letters", "digits"))
    if rng.random() < 0.5:
        a, b, c = looks(rng, kind, 3)
        gaps = gaps_for(rng, kind, [a, b, c])
        gaps |= {"second": gaps["x2"], "the_shuffled3": gaps["the_shuffled"]}
        return rng.choice(MIDDLE), gaps, _meaning([[a, b, c], [c, b, a]], [[b, a, c], [a, c, b]])
    a, b, c, d = looks(rng, kind, 4)
    gaps = gaps_for(rng, kind, [a, b, c, d])
    gaps |= {"first": gaps["x1"], "third": gaps["x3"]}
    return rng.choice(PLACED), gaps, _meaning([[a, b, c, d], [a, d, c, b]], [[d, c, b, a], [a, c, b, d], [b, a, c, d]])


def spaced(rng: Random) -> Drawn:
    """A row whose blocks touch."""
    a, n = looks(rng, "colors", 1)[0], rng.choice((3, 4))
    row = " ".join([a] * n)
    gaps = {"a": a, "n": count(rng, n)}
    return (
        rng.choice(SPACED),
        gaps,
        {
            "assets": {a: n},
            "hold": [f"{row} pitch=1"],
            "miss": [f"{row} pitch=1.4", "^".join([a] * n)],
        },
    )


def _meaning(hold: list[list[str]], miss: list[list[str]]) -> Meaning:
    return {"assets": once(hold[0]), "hold": [" ".join(r) for r in hold], "miss": [" ".join(r) for r in miss]}
