"""Where blocks stand to each other and to patches, alone and composed."""

from __future__ import annotations

import re
from random import Random

from tests.corpus.composed import Composed
from tests.corpus.composed.scenes import wordings as w
from tests.corpus.composed.scenes.cells import Told, meaning
from tests.corpus.composed.scenes.passing import PASSING
from tests.corpus.composed.scenes.special import SPECIAL

ANY = ("on", "on", "under", "above", *w.PLAIN, *w.PLAIN, *w.FLAT)
FLAT = (*w.PLAIN, *w.FLAT)
ON = ("on",)

ONE = {
    "{put} {a} {P1} {b}": ("ab", ANY),
    "please {put} {a} {P1} {b}": ("ab", ANY),
    "could you {put} {a} {P1} {b}?": ("ab", ANY),
    "{a} {should} {P1} {b}": ("ab", ANY),
    "{a} {P1} {b}": ("ab", ANY),
    "{want} {a} {P1} {b}": ("ab", ANY),
    "{P1} {b} {inv} {a}": ("ab", ANY),
    "{b} {has} {a} {H1}": ("ab", ANY),
    "{b} with {a} {H1}": ("ab", ANY),
    "{end} {a} {should} {P1} {b}": ("ab", ANY),
    "{a} {should} {P1} {b} {lastly}": ("ab", ANY),
    "{end} , {P1} {b} {inv} {a}": ("ab", ANY),
    "{b} {carry} {a}": ("ab", ON),
    "{a} {carried} {b}": ("ab", ON),
    "{b} {topped} {a}": ("ab", ON),
    "what I want is {a} {P1} {b}": ("ab", ANY),
    "it is {P1} {b} that {a} {should}": ("ab", FLAT),
    "it is {a} that {should} {P1} {b}": ("ab", ANY),
    "the place for {a} is {P1} {b}": ("ab", ANY),
    "{a}: {P1} {b}": ("ab", ANY),
    "goal: {a} {P1} {b}": ("ab", ANY),
    "{a} - {P1} {b}": ("ab", ANY),
    "take {a} and {put} it {P1} {b}": ("ab", ANY),
    "there is {ai} and {bi} . {a2} {should} {P1} {b2}": ("ab", ANY),
    "there are {ai} and {bi} ; {put} {a2} {P1} {b2}": ("ab", ANY),
    "of {a} and {b} , {a2} {should} {P1} {b2}": ("ab", ANY),
    "given {ai} and {bi} , {put} {a2} {P1} {b2}": ("ab", ANY),
    "in the picture I see {a} {P1} {b}": ("ab", ANY),
    "arrange {a} and {b} so that {a2} {is} {P1} {b2}": ("ab", ANY),
    "arrange {a} and {b} in such a way that {b2} has {a2} {H1}": ("ab", ANY),
    "the one {P1} {b} should be {a}": ("ab", ANY),
    "the block {P1} {b} {be} {a}": ("ab", ANY),
    "{b} is the one that {a} {should} {P1}": ("ab", ("on", "-behind", "-front", "beside")),
    "{a} , which {should} {P1} {b}": ("ab", ()),
    "where does {a} go? {P1} {b}": ("ab", ANY),
    "where should {a} be? {P1} {b}": ("ab", ANY),
    "do {put} {a} {P1} {b} , will you": ("ab", ANY),
    "{a} is at the wrong place ; it {should} {P1} {b}": ("ab", ()),
    "let {a} be {P1} {b}": ("ab", ANY),
    "you are done when {a} is {P1} {b}": ("ab", ANY),
    "the task is to {put} {a} {P1} {b}": ("ab", ANY),
    "nothing else than {a} {P1} {b}": ("ab", ()),
}
TWO = {
    "{put} {a} {P1} {b} and {c} {P2} {d}": ("ab cd", ANY),
    "{a} {should} {P1} {b} , {c} {P2} {b2}": ("ab cb", ANY),
    "{a} {should} {P1} {b} , and {P2} {b2} {inv} {c}": ("ab cb", ANY),
    "{P1} {b} {inv} {a} , and {P2} {b2} {inv} {c}": ("ab cb", ANY),
    "{P1} {b} {inv} {a} ; {P2} {a2} {inv} {c}": ("ab ca", ANY),
    "{a} {should} {P1} {b} and {P2} {b2} there is {c}": ("ab cb", ANY),
    "{a} {should} {P1} {b} and {P2} {b2} there should be {c}": ("ab cb", ANY),
    "{a} {should} {P1} {b} , and {P2} {c}": ("ab ac", ANY),
    "{put} {a} {P1} {b} and {P2} {c}": ("ab ac", ANY),
    "{put} {a} {P1} {b} but {P2} {c}": ("ab ac", ("-left", "dright", "sfront"), ("-behind", "beside")),
    "{a} {should} both {P1} {b} and {P2} {c}": ("ab ac", ANY),
    "{a} {should} {P1} {b} , which {should} {P2} {c}": ("ab bc", ANY),
    "{put} {a} {P1} {b} , which in turn {should} {P2} {c}": ("ab bc", ANY),
    "{a} {should} {P1} {b} , and {b2} {P2} {c}": ("ab bc", ANY),
    "{a} {should} {P1} {b} and that one {P2} {c}": ("ab bc", ANY),
    "{a} {should} {P1} {b} . {c} {should2} {P2} {a2}": ("ab ca", ANY),
    "{a} {must} {be_there} {P1} {b} . {P2} {b2} {inv} {c}": ("ab cb", ANY),
    "{put} {a} {P1} {b} . then {put} {c} {P2} {a2}": ("ab ca", ()),
    "{b} {has} {a} {H1} and {c} {H2}": ("ab cb", FLAT),
    "{b} with {a} {H1} and {c} {H2}": ("ab cb", FLAT),
    "{b} , with {a} {H1} and {c} {H2}": ("ab cb", FLAT),
    "{put} {b} on the table with {a} {H1} and {c} {H2}": ("ab cb", FLAT),
    "{put} {a} {P1} {b} , which {has} {c} {H2}": ("ab cb", ANY),
    "{put} {a} {P1} {b} , which {carry} {c}": ("ab cb", ("on", *FLAT), ON),
    "{put} {a} {P1} {b} , which {topped} {c}": ("ab cb", FLAT, ON),
    "{a} , which {topped} {c} , {should} {P1} {b}": ("ab ca", FLAT, ON),
    "{a} , which {carry} {c} , {should} {P1} {b}": ("ab ca", ("on", *FLAT), ON),
    "{a} , which {has} {c} {H2} , {should} {P1} {b}": ("ab ca", ANY),
    "{b} , on which {a} {should} , {should2} {P2} {c}": ("ab bc", ON, ANY),
    "{put} {b} , on which {a} lies , {P2} {c}": ("ab bc", ON, ANY),
    "{a} {should} {P1} {b} , on which {c} lies": ("ab cb", FLAT, ON),
    "{a} , with {c} {H2} , {should} {P1} {b}": ("ab ca", ANY),
    "{a} with {c} {H2} {should} {P1} {b}": ("ab ca", FLAT, ON),
    "{a} {should} {P1} {b} with {c} {H2}": ("ab cb", FLAT, ON),
    "the one on which {a} {should} is {b} , and {P2} {b2} there is {c}": ("ab cb", ON, FLAT),
    "{a} {must} {be_there} {P1} {b} and have {c} {H2}": ("ab ca", ANY),
    "{a} {should} {P1} {b} and {carry} {c}": ("ab ca", ("on", *FLAT), ON),
    "{P1} {b} {inv} {a} and {P2} it {c}": ("ab cb", ()),
    "{P1} {b} , {a} ; {P2} {b2} , {c}": ("ab cb", ANY),
    "{a} {P1} {b} , {c} {P2} {b2}": ("ab cb", ANY),
    "{a} {P1} {b} and {b2} {P2} {c}": ("ab bc", ANY),
    "{a} {P1} {b} {P2} {c}": ("ab bc", ()),
    "{a} {should} {P1} {b} , while {c} {should2} {P2} {a2}": ("ab ca", ANY),
    "{a} {should} {P1} {b} , whereas {c} {should2} {P2} it": ("ab cb", ()),
    "while {a} is {P1} {b} , {c} {should} {P2} {b2}": ("ab cb", ()),
    "{put} {a} {P1} {b} so that {c} is {P2} {a2}": ("ab ca", ()),
    "I have {ai} , {bi} and {ci} . {put} {a2} {P1} {b2} and {c2} {P2} {b2}": ("ab cb", ANY),
    "three blocks: {a} , {b} , {c} . {a2} {should} {P1} {b2} . {c2} {should2} {P2} {a2}": ("ab ca", ANY),
    "the block {P1} {b} is {a} , and the block {P2} {b2} is {c}": ("ab cb", ANY),
    "the block {P1} {b} is {a} , the one {P2} {a2} {c}": ("ab ca", ANY),
    "{put} {a} {P1} {b} and {c} {P2} the latter": ("ab cb", ANY),
    "{put} {a} {P1} {b} and {c} {P2} the former": ("ab ca", ANY),
    "{put} {a} {P1} {b} , with {c} {P2} {a2}": ("ab ca", ANY),
    "{a} {should} {P1} {b} , {c} being {P2} {b2}": ("ab cb", ANY),
    "{a} being {P1} {b} , {put} {c} {P2} {b2}": ("ab cb", ()),
    "{put} {a} {P1} {b} . {a2} {must} also {be_there} {P2} {c}": ("ab ac", ANY),
    "{put} {a} {P1} {b} . it {must} also {be_there} {P2} {c}": ("ab ac", ANY),
    "{put} {a} {P1} {b} . it {must} {be_there} also {P2} {c}": ("ab ac", ANY),
    "{a} {should} {P1} {b} . it {must} also have {c} {H2}": ("ab ca", ANY),
    "{a} {must} {be_there} {P1} {b} . {put} {c} {P2} {b2}": ("ab cb", ANY),
    "{b} {should} on the table . {a} goes {P1} it , {c} {P2} it": ("ab cb", FLAT),
    "in the middle {b} , {P1} it {a} , {P2} it {c}": ("ab cb", ()),
    "{a} {should} {P1} {b} ; the same goes for {c}": ("ab cb alike", FLAT),
    "both {a} and {c} must be {P1} {b}": ("ab cb same", FLAT),
    "{a} and {c} are both {P1} {b}": ("ab cb same", FLAT),
    "{P1} {b} {inv} both {a} and {c}": ("ab cb same", FLAT),
}
_SLOT = re.compile(r"\{(\w+)\}")


def composed(rng: Random) -> Composed:
    """A frame with its gaps filled, and the states in which it is so."""
    while True:
        if rng.random() < 0.5:
            if (special := rng.choice((*SPECIAL, *PASSING))(rng)) is not None:
                return Composed(special[0], finished(rng, special[1]), special[2])
            continue
        made = _related(rng, *rng.choice([(f, s) for table in (ONE, TWO, TWO) for f, s in table.items() if s[1]]))
        if made is not None:
            return made


def _related(rng: Random, frame: str, spec: tuple[str | tuple[str, ...], ...]) -> Composed | None:
    pairs = str(spec[0]).split()
    same = "same" in pairs
    alike = same or "alike" in pairs
    pairs = [pair for pair in pairs if pair not in ("same", "alike")]
    kinds = [rng.choice(spec[min(n + 1, len(spec) - 1)]) for n in range(len(pairs))]
    if alike:
        kinds = [kinds[0]] * len(pairs)
    names = w.Names(rng, len(set("".join(pairs))))
    if "{carry}" in frame and any(look.isupper() for look in names.looks.values()):
        return None  # "carries the letter W": it may well show it
    told = [
        told_of(f"s{kind[1:]}" if same and kind[0] == "-" else kind, names.looks[a], names.looks[b])
        for kind, (a, b) in zip(kinds, pairs, strict=True)
    ]
    means = meaning(rng, told, {look: look for look in names.looks.values()})
    if means is None:
        return None
    return Composed(frame, finished(rng, _SLOT.sub(lambda slot: _filled(rng, slot[1], names, kinds), frame)), means)


def told_of(kind: str, a: str, b: str) -> Told:
    """What a relation says."""
    return Told("over", (b, a)) if kind == "under" else Told(kind, (a, b))


def _filled(rng: Random, slot: str, names: w.Names, kinds: list[str]) -> str:
    if slot[0] in "abcd" and len(slot) == 1:
        return names.first(slot)
    if slot[0] in "abcd" and slot[1:] == "i":
        return names.first(slot[0], indefinite=True)
    if slot[0] in "abcd" and slot[1:] == "2":
        return names.again(slot[0])
    if slot[0] in "PH" and slot[1:].isdigit():
        kind = kinds[int(slot[1]) - 1]
        return rng.choice((w.PLACE if slot[0] == "P" else w.HAVING)[kind])
    if slot == "inv":  # one verb for a sentence: a fact in front of a command would tell of the start
        return names.inverted
    words = {
        "put": w.PUT,
        "should": w.SHOULD,
        "should2": w.SHOULD,
        "has": w.HAS,
        "want": w.WANT,
        "end": w.END,
        "carry": w.CARRY,
        "carried": w.CARRIED,
        "topped": w.TOPPED,
        "is": ("is", "stands", "should be", "ends up"),
        "be": ("is", "should be", "must be", "has to be"),
        "must": w.MUST,
        "lastly": w.END[:2] + w.END[3:6] + w.END[8:],
        "be_there": w.BE_THERE,
    }
    return rng.choice(words[slot])


def finished(rng: Random, text: str) -> str:
    """As it is typed: spaces before marks left out, with a capital and a full stop or without."""
    text = re.sub(r"\s+", " ", text)
    text = re.sub(r" ([,.;:?!])", r"\1", text).strip()
    text = text.replace("that have", "that has")
    if rng.random() < 0.6:
        text = re.sub(r"(^|[.?!] )(\w)", lambda m: m[1] + m[2].upper(), text)
        text = text if text[-1] in ".?!" else text + "."
    return text
