"""Letters and plus signs told by their size and their direction, all of one colour."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.building import shapes
from tests.corpus.composed.building.plain import SOME, Told, gaps

TOWARD = {
    "me": "[toward me|towards me|to the front|towards the viewer|toward the robot|to the near side]",
    "far": "[away from me|to the back|toward the back|to the far side|away from the robot]",
    "left": "[to the left|toward the left]",
    "right": "[to the right|towards the right]",
}
POINTS = {"T": "[stem|foot|leg]", "U": "[opening|open side|mouth]", "V": "[point|tip]"}
VERBS = {"T": ("point", "pointing"), "U": ("[face|point]", "[facing|pointing]"), "V": ("point", "pointing")}
COUNTS = {"L": 5, "T": 5, "U": 7, "V": 5}
FORMS = {"T": shapes.T, "U": shapes.U, "V": shapes.V}


def name_of(letter: str) -> str:
    """What a letter's shape is called."""
    article = "an" if letter == "L" else "a"
    return f"[{article} {letter}|the letter {letter}|{article} {letter} shape]"


def ell(rng: Random) -> Told:
    side = rng.choice(("left", "right"))
    told = gaps(rng, n=5) | {"side": side, "L": name_of("L")}
    told["way"] = (
        f"[its [foot|lower arm] to the {side}|with its foot to the {side}|its foot pointing {side}|with the foot "
        f"pointing to the {side}|the foot on the {side}|with the foot towards the {side}]"
    )
    frame = rng.choice((
        "{want} {L} [of|from] {n} {bs}, {way}", "{want} {L} of {n} {bs} whose foot points to the {side}",
        "{want} {L} [of|out of] {n} {bs}. [Its foot points|The foot should point|Its foot goes] to the {side}",
        "{want} {L} of {bs}, three along each [arm|leg|side], {way}",
        "{want} {L} of {n} {bs} [with two equal arms|with arms of the same length|with both arms equally long]",
    ))  # fmt: skip
    other = shapes.of("xxxx", "x...")
    if "equal" in frame:
        meaning = shapes.of_one_color(shapes.L["left"], told["c"], [shapes.PLUS, other], shapes.L["right"])
    else:
        meaning = shapes.of_one_color(shapes.L[side], told["c"], [shapes.L[shapes.ACROSS[side]], other])
    return frame, told, meaning


def pointed(rng: Random) -> Told:
    """A T, a U or a V."""
    letter, side = rng.choice("TUV"), rng.choice(tuple(TOWARD))
    verb, pointing = VERBS[letter]
    told = gaps(rng, n=COUNTS[letter]) | {"there": TOWARD[side], "part": POINTS[letter], "s": verb}
    told |= {"X": name_of(letter), "pointing": pointing}
    frames = [
        "{want} {X} [of|out of|from|made of] {n} {bs}, its {part} [|{pointing}] {there}",
        "{want} {X} of {n} {bs} with [its|the] {part} [{pointing}|] {there}",
        "{want} {X} of {n} {bs}. [The|Its] {part} [should|must|has to] {s} {there}",
        "{want} {X} of {n} {bs} whose {part} [is {pointing}|should {s}] {there}",
        "{want} {X} of {n} {bs}, the {part} {there}",
    ]
    if letter == "U":
        frames += ["{want} {X} of {n} {bs}[, open| that is open| opening|, opening| which opens] {there}"]
    forms = FORMS[letter]
    meaning = shapes.of_one_color(forms[side], told["c"], [forms[shapes.ACROSS[side]]])
    return rng.choice(frames), told, meaning


def plus(rng: Random) -> Told:
    told = gaps(rng, n=5) | {"X": "[a plus sign|a plus|a plus shape|a cross]"}
    frame = rng.choice((
        "{want} {X} [of|made of|out of|from|consisting of] {n} {bs}",
        f"{{want}} a {{c}} [plus sign|plus|cross] of {{n}} {SOME}",
        "{want} {n} {bs} [in the shape of|arranged as|forming|in the form of] {X}",
    ))  # fmt: skip
    return frame, told, shapes.of_one_color(shapes.PLUS, told["c"], [shapes.L["right"], shapes.T["me"]])
