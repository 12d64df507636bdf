"""Words in rows and towers, two words, digits in reading order, and equations."""

from __future__ import annotations

from itertools import permutations
from random import Random

from tests.corpus.composed.ordering.listed import Gaps
from tests.corpus.composed.ordering.phrased import RIGHT, Meaning, joined, listed, once

Drawn = tuple[str, Gaps, Meaning]
WORDS = (
    "CAT",
    "DOG",
    "SUN",
    "MOON",
    "TREE",
    "ROBOT",
    "BREAD",
    "HELLO",
    "NOON",
    "ANNA",
    "FISH",
    "STAR",
    "TEA",
    "LAMP",
    "OTTO",
)
PAIRS = (("CAT", "DOG"), ("UP", "DOWN"), ("HI", "YOU"), ("YES", "NO"), ("RED", "FOX"), ("ON", "OFF"))
SPELT = (
    "[spell|write|form|make|spell out|write out] [the word|] {word} [with|out of|from|using] [letter cubes|letter "
    "blocks|letters|the letter cubes|cubes]",
    f"[spell|write|form|make|spell out|read] [the word|] {{word}} [in a row|{RIGHT}|in a row, {RIGHT}|side by side]",
    "[arrange|put|line up|lay out] [letter cubes|the letters|letters|cubes|the letter cubes] [in a row|] [so that "
    "they|so they|such that they|to] [spell|read|say|form|make] {word} [, reading from left to right|from left to "
    "right|]",
    "[put|arrange|line up] the letters {letters} in a row [so that|so|such that] [they spell|they say|they read|you "
    "can read|one reads|I can read|it reads|it says] {word}",
    "[I want to|I'd like to|I would like to|let me] [read|see] [the word|] {word} [on the table|in letter cubes|in "
    "letters|in a row|in blocks]",
    f"[the word|] {{word}} [should|shall|has to|must] be [readable|spelled|spelled out|written] [in a row|{RIGHT}|on "
    f"the table|with letter cubes]",
    "[the word|] {word} [in letter cubes|in letters|in letter blocks|out of letter cubes|, spelled in a row|, one "
    "letter per cube]",
    "[the letters|the cubes|the blocks|letter cubes] [should|shall|have to|must] [spell|say|read|form|make up] {word} "
    "[in the end|at the end|] {right}",
    "[a row|make a row|I want a row|there should be a row] [that|which] [spells|says|reads] {word} [from left to "
    "right|]",
    "[say|spell] {word} [to me|] with [the letter cubes|letter cubes|the letters|letters]",
    "[the word which|the word that] [shall|should] be [spelled|written] [by|with] the letter [blocks|cubes] is {word}",
    "[take|use] the letters {letters} [and|to] [spell|make|form|write] {word} [with them|]",
    "[from|with|out of|using] the letters {letters}[,|] [spell|make|form|write] [the word|] {word}",
    "[I have|there are|here are] the letters {letters}. [spell|make|form|write] {word} [with them|from them|out of "
    "them|]",
    "[I have|there are|here are] the letters {letters}. [they should|make them|they must|let them] [spell|say|read] "
    "{word}",
    "can you [spell|write|make|form] {word} [with|out of|using] [letter cubes|letter blocks|the letters]?",
    "[letters|letter cubes|cubes] in a row that [spell|read|say|form] {word}",
    f"[in the end|at the end|finally], [the letters|the cubes] {{letters}} [spell|read|say|form the word] {{word}} "
    f"{RIGHT}",
    "{word} is what [the letters|the cubes|the letter cubes] [should|must|have to] [say|spell|read] [in the end|at "
    "the end|]",
    "[the letters|the letter cubes] {letters} [in a row|side by side], [spelling|reading|forming|forming the word] "
    "{word}",
    "[lay out|put|place] the letters of [the word|the name|] {word} [in a row|side by side|next to each other] [so "
    "that|so] [I can read it|one can read it|it can be read|it is readable]",
)
TOWERED = (
    "[spell|write|make] {word} [in a tower|as a tower|in a stack|as a stack|down a tower], [read|reading|readable] "
    "[from top to bottom|from the top down|downwards|top to bottom]",
    "[stack|pile up] the letters {letters} [so that|such that|so] [they spell|they say|they read|it reads|one reads|"
    "you can read] {word} [from top to bottom|from the top down|downwards|top to bottom]",
    "a tower [of letter cubes|of letters|] [that|which] [spells|reads|says] {word} [from top to bottom|from the top "
    "down|downwards|when read from top to bottom|when read downwards]",
    "a [letter tower|stack of letters|tower of letter cubes] [spelling|reading] {word} [from top to bottom|downwards|"
    "when read downwards|when read from top to bottom]",
    "[the word|] {word} [shall|should|must] be [spelled|read|written] [from top to bottom|downwards] by a [stack|"
    "tower] [of letter cubes|of letters]",
    "[build|make] a tower of the letters {letters} [in which|where] you [can read|read] {word} from [top to bottom|"
    "the top down]",
    "[stack|pile] letter [blocks|cubes] so that {word} [can be read|is readable|reads] [downwards|from top to bottom|"
    "from the top down]",
    "[build|make] a [tower|stack] of letter cubes such that, when it is read [downwards|from top to bottom], [the "
    "word|] {word} [results|appears|comes out]",
    "[the letters|the letter cubes] {letters} [form|make|in] a [tower|stack]; [read|reading] from top to bottom [it "
    "says|it spells|they spell] {word}",
)
REVERSED = (
    "[lay|lay out|put] the letters of [the word|] {word} in a row in reverse order, so that they read {reverse}",
    "[spell|write] {word} [backwards|in reverse|reversed|back to front]",
    "[spell|write|lay out] [the word|] {word} [backwards|in reverse], so that it reads {reverse} [from left to right|]",
    "[the word|] {word} [backwards|in reverse|spelled backwards|written backwards]",
    "[the letters of|] {word} in a row[,|] [backwards|in reverse order|in reverse], so [it|that it] reads {reverse} "
    "{right}",
)
TWO_WORDS = (
    "[spell|write|lay out] {far} and[, in front of it,|, nearer to me,] [the word|] {near}",
    "the [back|far] row [spells|says|reads] {far}, the [front|near] row [spells|says|reads] {near}",
    "two words: {far} in the [far|back] row [and|,] {near} in the [near|front] row",
    "[the word|] {near} in front of [the word|] {far}",
    "[put|spell|lay|write] [the word|] {far} behind [the word|] {near}",
    "I['d like to| want to] read {far} and, in front of [it|{far}], [the word|] {near}",
    "the words {far} and {near} [should|must|shall] both be [on the table|readable], [with|] {far} [is|being|] behind "
    "{near}",
    "[spell|write] the words {far} and {near} in two rows, {far} [behind|further away|in the far one]",
    "[spell|write] {far} in [the far|the back|one] row and {near} in [the near row|the front row|another row in front "
    "of it]",
    "two words [shall|should] be [displayed|spelled|readable], {far} in the far row and {near} in the near row",
)
GRIDS = (
    "[the nine digits|the digits 1 to 9|the numbers 1 to 9|the numbers from 1 to 9] in a [3x3|3 by 3|three by three] "
    "[square|grid] [so that|so] you [read|can read] them like [in|] a [book|page]",
    "[put|place|arrange] [the digits 1 to 9|the numbers 1 to 9|the digits from 1 to 9|1 to 9] in a [3x3|3 by 3|three "
    "by three] [grid|square] in reading order",
    "[the digits 1 to 9|the numbers from 1 to 9] in three rows of three, in reading order",
    "three rows of three: 1 2 3 [in the far row|at the back|far], 4 5 6 [in the middle|in the middle row], 7 8 9 [in "
    "the near row|at the front]",
    "a [3x3|3 by 3] grid of the digits 1 to 9, [reading|read] [from left to right and from far to near|row by row "
    "from the far left|like a page|like a book]",
    "[fill|make] a [3x3|3 by 3] grid with [the digits 1 to 9|the numbers 1 to 9], [in reading order|row by row, "
    "starting far left]",
    "[the digits 1 to 9|the numbers 1 to 9] form three rows of three in reading order, [the far row first|starting "
    "with the far row]",
    "[the digits 1 to 9|the numbers 1 to 9] form a [3x3|3 by 3] [square|grid] [that is read|which you read] like a "
    "[page|book]",
)
SUMS = (
    "[make|form|write|build|lay out|lay] a [correct|valid|true] [equation|sum|calculation] [from|out of|with|using] "
    "[the cubes|] {cubes}",
    "[with|from|out of|using] the [cubes|blocks] {cubes}[,|] [make|form|build|write] a [correct|valid|true] [equation|"
    "sum|calculation]",
    "[use|take] [the cubes|the blocks|] {cubes} [to|and] [make|form|write|build] a [correct|valid|true] [equation|sum|"
    "calculation]",
    "[arrange|put|lay out] {cubes} [so that|such that|so] [a correct equation|a true equation|a valid equation|a "
    "correct calculation] [results|comes out|is formed|can be read|appears]",
    "[arrange|put] {cubes} in a row so [that|] [they|it] [make|makes|form|forms] a [correct|true|valid] equation",
    "[I have|there are|here are] the [cubes|blocks] {cubes}. [make|form|build] a [correct|valid|true] [equation|sum] "
    "[with them|from them|out of them|]",
    "[I have|there are|here are] the [cubes|blocks] {cubes}. [arrange them|put them] [into|to form|to make] [an "
    "equation that is true|a true equation|a correct equation|an equation that is correct]",
    "from [the cubes|] {cubes} [an|a] [equation which is true|correct equation|valid equation] [must|should|has to] "
    "[come out|be made|be formed]",
    "a [correct|valid|true] equation [out of|from|with|made of] {cubes}",
    "[make|write] an equation that is [true|correct|right] [with|from|out of] [the cubes|] {cubes}",
    "{cubes} should [form|make|give] a [correct|true|valid] equation",
    "[a sum|a calculation|an equation] [that is correct|that is right|that is true|that works out] [from|with|out of] "
    "[the cubes|] {cubes}",
)
RESULT_RIGHT = (
    "[make|form|write] a [correct|true|valid] equation [with|out of|from] {cubes} [whose result is on the right|with "
    "the result on the right|, the result on the right]",
    "[use|take] {cubes} to write a true equation whose result is on the right of the equals sign",
    "a [correct|true] equation [of|from|with] {cubes}, the result [being|] [to the right of|right of|on the right of] "
    "the equals sign",
)
TOLD_SUMS = (
    "[write|lay out|build|make|show|form] [the equation|] {sum} [with cubes|with number and sign cubes|out of cubes|"
    "in cubes|]",
    "[the equation|] {sum} [should|shall|must] be [readable|shown|laid out|written] [in a row|with cubes|on the table|"
    "by a row of cubes]",
    "[a row|make a row] [that|which] [reads|says|shows] {sum}",
    "[put|arrange] cubes in a row [so that|such that] [they read|one reads|you can read|it reads|they show|they say] "
    "{sum}",
    "[I want to|I'd like to] [read|see] {sum} [on the table|in a row|in cubes]",
    "[show|write|lay out] {told} [with cubes|in cubes|with number and sign cubes|]",
    "{told}, [written in cubes|in cubes|laid out with cubes|with number and sign cubes]",
    "[show|show me] that {told} [with cubes|with number cubes|, using cubes|]",
)
_NAMES = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")


def _shuffled(rng: Random, items: str) -> list[str]:
    return rng.sample(items, len(items))


def _wrong(word: str, right: set[str]) -> list[str]:
    """Some other orders of the same symbols."""
    others = ["".join(p) for p in permutations(word)] if len(word) < 5 else [word[::-1], word[1] + word[0] + word[2:]]
    return [" ".join(o) for o in dict.fromkeys(others) if o not in right][:4]


def words(rng: Random) -> Drawn:
    """One word in a row."""
    word = rng.choice(WORDS)
    shown = rng.choice((word, word, word, f'"{word}"'))
    gaps = {"word": shown, "letters": listed(rng, _shuffled(rng, word)), "right": f"[{RIGHT}|in a row|]"}
    return rng.choice(SPELT), gaps, {"assets": once(list(word)), "hold": [" ".join(word)], "miss": _wrong(word, {word})}


def reversed_words(rng: Random) -> Drawn:
    """A word from its end."""
    word = rng.choice([w for w in WORDS if w != w[::-1]])
    gaps = {"word": word, "reverse": word[::-1], "right": "from left to right"}
    back = word[::-1]
    return rng.choice(REVERSED), gaps, {"assets": once(list(word)), "hold": [" ".join(back)], "miss": [" ".join(word)]}


def towers(rng: Random) -> Drawn:
    """A word down a tower."""
    word = rng.choice([w for w in WORDS if w != w[::-1] and len(w) < 5])
    gaps = {"word": word, "letters": listed(rng, _shuffled(rng, word))}
    miss = ["^".join(word), " ".join(word)]
    return rng.choice(TOWERED), gaps, {"assets": once(list(word)), "hold": ["^".join(word[::-1])], "miss": miss}


def two_words(rng: Random) -> Drawn:
    """One word behind another."""
    far, near = rng.sample(rng.choice(PAIRS), 2)
    rows = [" ".join(far), " ".join(near)]
    return (
        rng.choice(TWO_WORDS),
        {"far": far, "near": near},
        {
            "assets": once(list(far + near)),
            "hold": [f"{rows[0]} at=4,0 ; {rows[1]} at=-4,0"],
            "miss": [f"{rows[1]} at=4,0 ; {rows[0]} at=-4,0"],
        },
    )


def grids(rng: Random) -> Drawn:
    """Nine digits like words on a page."""
    rows = ["1 2 3", "4 5 6", "7 8 9"]
    return (
        rng.choice(GRIDS),
        {},
        {
            "assets": once(list("123456789")),
            "hold": [" | ".join(rows)],
            "miss": [" | ".join(rows[::-1]), "1 4 7 | 2 5 8 | 3 6 9", "1 2 3 4 5 6 7 8 9 pitch=1.1"],
        },
    )


def sums(rng: Random) -> Drawn:
    """Numbers and signs to be put in order."""
    sign = rng.choice("++-*")
    a, b, c = rng.choice(
        [(2, 6, 8), (3, 4, 7), (4, 5, 9), (1, 5, 6), (2, 3, 5)] if sign != "*" else [(2, 3, 6), (2, 4, 8)]
    )
    numbers = rng.choice((f"{a} {sign} {b} = {c}", f"{b} {sign} {a} = {c}")) if sign != "-" else f"{c} - {a} = {b}"
    assets = once(numbers.split())
    name = {"+": "[plus|a plus|+|a plus sign]", "-": "[minus|a minus|-|a minus sign]", "*": "[times|a times sign|*|×]"}[
        sign
    ]
    signs = [name, "[equals|an equals sign|=|equals sign]"]
    if rng.random() < 0.35:
        plain = {"+": "+", "-": "-", "*": rng.choice("*×x")}[sign]
        told = (
            numbers.replace("+", "plus")
            .replace("-", "minus")
            .replace("*", "times")
            .replace("=", rng.choice(("equals", "is")))
        )
        if rng.random() < 0.5:
            told = " ".join(_NAMES[int(w)] if w.isdigit() else w for w in told.split())
        text = numbers.replace("*", plain)
        gaps = {"sum": rng.choice((text, text.replace(" ", ""))), "told": told}
        return (
            rng.choice(TOLD_SUMS),
            gaps,
            {
                "assets": assets,
                "hold": [numbers],
                "miss": [f"{numbers.split()[2]} {sign} {numbers.split()[4]} = {numbers.split()[0]}"],
            },
        )
    digits = [str(d) for d in _shuffled(rng, f"{a}{b}{c}")]
    cubes = rng.choice(
        (
            joined(digits + signs),
            joined(digits + signs),
            f"{joined(digits)} [and|with] {joined(signs)}",
            joined([*digits, "+-*"["+-*".index(sign)], "="], " and "),
        )
    )
    mirrored = f"{c} = {a} {sign} {b}" if sign != "-" else f"{b} = {c} - {a}"
    wrong = f"{c} {sign} {a} = {b}" if sign != "-" else f"{a} - {c} = {b}"
    if rng.random() < 0.15:
        return (
            rng.choice(RESULT_RIGHT),
            {"cubes": cubes},
            {"assets": assets, "hold": [numbers], "miss": [mirrored, wrong]},
        )
    return rng.choice(SUMS), {"cubes": cubes}, {"assets": assets, "hold": [numbers, mirrored], "miss": [wrong]}
