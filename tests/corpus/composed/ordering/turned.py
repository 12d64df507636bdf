"""Cubes that are turned: upright, upside down, by an angle, towards a side."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.ordering.listed import Gaps
from tests.corpus.composed.ordering.phrased import Meaning, once

Drawn = tuple[str, Gaps, Meaning]
THE = "[the {x}|the letter {x}|the cube {x}|the {x} cube|the cube with the {x}|{x}|the block with the letter {x}]"
OVER = (
    f"[turn|flip|rotate|put] {THE} upside down",
    f"{THE} [should be|must be|has to be|is to be|shall be] upside down",
    f"[turn|rotate] {THE} [so that|until|such that] [it|the letter on top|the letter on its top face|its letter|the "
    f"letter] [is|appears|stands] upside down",
    f"[turn|rotate] {THE} [by 180 degrees|180 degrees|by half a turn|half a turn|by a half turn]",
    "[give|] {the_x} a half turn",
    f"{THE}, [upside down|turned upside down|rotated by 180 degrees|turned by 180 degrees]",
    f"I want to see {THE} upside down",
    "[the letter on top of {the_x}|the top of {the_x}|the top face of {the_x}] [should be|has to be|is|must "
    "be] upside down",
    f"[at the end|in the end|finally] {THE} [is|should be] upside down",
    f"{THE} should [show its letter upside down|stand on its head|be turned upside down|lie upside down]",
)
UPRIGHT = (
    f"[turn|rotate] {THE} [so that it is|until it is|so it is|such that it is] [upright|the right way up|readable|"
    f"readable for me]",
    f"[turn|rotate] {THE} [until|so that] the letter on [the top face|top|its top|its top face] is [upright|upright "
    f"for me|readable]",
    f"{THE} [should be|must be|has to be|is to be|shall be] [upright|readable|upright and readable]",
    f"[I want to|I'd like to] be able to read {THE}",
    f"[I want to|I'd like to] see {THE} upright",
    f"[put|place|set] {THE} upright",
    f"[make sure|see to it] that {THE} is [upright|readable]",
    "[the letter|the {x}] on [top of {the_x}|the top face of {the_x}] [should be|has to be|is|must be] upright",
    f"[at the end|in the end] {THE} [is|should be] [upright|readable for me]",
    f"{THE}, [upright|readable for the camera|readable from my side|the right way up for the viewer]",
)
QUARTER = (
    f"[turn|rotate|twist] {THE} [by 90 degrees|90 degrees|by a quarter turn|a quarter turn|by a quarter of a turn] "
    f"{{way}}{{seen}}",
    f"[turn|rotate|twist] {THE} {{way}} [by 90 degrees|by a quarter turn|by a quarter of a turn]{{seen}}",
    "give {the_x} a [quarter turn|90 degree turn|90-degree turn] {way}{seen}",
    "give {the_x} a {way} [quarter turn|90 degree turn|90-degree twist|90 degree rotation]{seen}",
    f"{THE}, [turned|rotated] [by 90 degrees|a quarter turn|90 degrees] {{way}}{{seen}}",
    f"{THE} [should be|must be|has to be|shall be|is] [turned|rotated] [by 90 degrees|a quarter turn|90 degrees] "
    f"{{way}}{{seen}}",
    "[make|let] a quarter turn {way} with {the_x}{seen}",
    f"{THE} is to be [rotated|turned] [by 90 degrees|by a quarter turn|a quarter turn] {{way}}{{seen}}",
)
POINTING = (
    f"[turn|rotate] {THE} [so that|such that|until] [its top|the top of its letter|the top of the letter] [points|is "
    f"pointing|faces] [to the right|right|to the left|left]",
)
WORD_OVER = (
    "[spell|write] {word}[ with|, with| but with] {the_m} upside down",
    "[spell|write] {word}[, but|; but|, and] [turn|flip] {the_m} upside down",
    "[spell|write] {word}, but {the_m} [is|should be|must be|has to be] upside down",
    "the word {word}, [but its {m} has to be upside down|but with the {m} upside down|its {m} upside down|where the "
    "{m} is upside down]",
    "[spell|write] {word}. {the_m} [should|must|has to] be upside down",
    "{word} in letter cubes[, the {m} upside down| with the {m} upside down|, only the {m} turned upside down]",
    "[the cubes|the letters] read {word} from left to right, but the {m} [in the middle|] is upside down",
)
WORD_ALL_OVER = (
    "[spell|write] {word} with [all letters|all the letters|every letter|each letter] upside down",
    "the word {word} with [all letters|every letter|all its letters] upside down",
    "[put|line up] {a}, {b} and {c} in a row from left to right, [all upside down|all of them upside down|each upside "
    "down|every one of them upside down]",
)
READABLE = (
    "[put|line up|place] {a}, {b} and {c} in a row from left to right so that [all are|they are all|they are|each is|"
    "every one is] [upright|readable|readable for me|upright for me]",
    "{a}, {b} and {c} in a row from left to right, [all upright|all readable|all of them upright|each of them upright|"
    "upright and readable]",
    "{a} and {b} [next to each other|side by side], both [upright|readable|upright and readable]",
    "[put|place] {a} [to the left of|left of] {b}, both [upright|readable]",
    "[put|place] {b} [to the right of|right of] {a}, [both upright|both readable|both of them upright]",
    "both {a} and {b} must be [upright|readable], with {a} left of {b}",
    "{b} is [upside down and|] to the right of {a}, which is upright",
)


def turns(rng: Random) -> Drawn:
    """One letter turned."""
    x = rng.choice("ABCEFGJKLPQRTU")
    gaps = {"x": x, "the_x": f"[the {x}|the letter {x}|the cube {x}|the {x} cube]"}
    kind = rng.choice(("over", "over", "upright", "upright", "quarter", "quarter", "pointing"))
    if kind == "over":
        return rng.choice(OVER), gaps, _one(x, "180", "0", "90")
    if kind == "upright":
        return rng.choice(UPRIGHT), gaps, _one(x, "0", "180", "90")
    if kind == "pointing":
        text = rng.choice(POINTING)
        left = rng.random() < 0.5
        text = text.replace(
            "[to the right|right|to the left|left]", "[to the left|left]" if left else "[to the right|right]"
        )
        return text, gaps, _one(x, *(("90", "-90", "0") if left else ("-90", "90", "0")))
    left = rng.random() < 0.5
    gaps["way"] = "[counterclockwise|counter-clockwise|anticlockwise]" if left else "clockwise"
    gaps["seen"] = "[, seen from above|, as seen from above|, viewed from above| seen from above|]"
    return rng.choice(QUARTER), gaps, _one(x, *(("90", "-90", "180") if left else ("-90", "90", "180")))


def words(rng: Random) -> Drawn:
    """A word of which a letter is turned, or all are."""
    word = rng.choice(("CAT", "BAG", "CAR", "LEG", "FUR"))
    a, b, c = word
    gaps = {
        "word": word,
        "m": b,
        "a": a,
        "b": b,
        "c": c,
        "the_m": f"[the {b}|the letter {b}|the middle letter|the {b} in the middle]",
    }
    kind = rng.choice(("one", "one", "all", "none"))
    if kind == "one":
        return (
            rng.choice(WORD_OVER),
            gaps,
            _several(word, f"{a} {b}~180 {c}", f"{a} {b} {c}", f"{a}~180 {b}~180 {c}~180"),
        )
    if kind == "all":
        return (
            rng.choice(WORD_ALL_OVER),
            gaps,
            _several(word, f"{a}~180 {b}~180 {c}~180", f"{a} {b} {c}", f"{a} {b}~180 {c}"),
        )
    text = rng.choice(READABLE)
    if "{c}" in text:
        return (
            text,
            gaps,
            _several(word, f"{a} {b} {c}", f"{c} {b} {a}" if "row" in text else f"{a}~180 {b} {c}", f"{a} {b}~90 {c}"),
        )
    if "upside down" in text:
        text = text.replace("[upside down and|] ", "upside down and ")
        return text, gaps, _several(a + b, f"{a} {b}~180", f"{a} {b}", f"{b}~180 {a}")
    return text, gaps, _several(a + b, f"{a} {b}", f"{a} {b}~180", f"{a}~90 {b}")


def _one(x: str, hold: str, *miss: str) -> Meaning:
    return {"assets": {x: 1}, "hold": [f"{x}~{hold}"], "miss": [f"{x}~{m}" for m in miss]}


def _several(word: str, hold: str, *miss: str) -> Meaning:
    return {"assets": once(list(word)), "hold": [hold], "miss": list(miss)}
