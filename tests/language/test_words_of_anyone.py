"""Whoever acts and looks on, what things are called where people work and play, names that are told what they are,
verbs that tell how things lie, and words typed in a hurry."""

from __future__ import annotations

from itertools import product
from typing import Any

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

PLACED: dict[str, Any] = {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue", "red blue"]}
ROW: dict[str, Any] = {"assets": {"red": 3}, "hold": ["red red red"], "miss": ["red^red^red", "red | red | red"]}
MAT: dict[str, Any] = {"assets": {"red": 1, "blue_patch": 1}, "hold": ["at=blue_patch red"], "miss": ["red"]}
AROUND: dict[str, Any] = {
    "assets": {"green": 4, "yellow": 1},
    "hold": [". green . | green yellow green | . green ."], "miss": ["green green yellow green green"],
}  # fmt: skip
WHO = ("the trainee", "our new intern", "a curious toddler", "the test subject", "every apprentice", "the zookeeper",
       "the forklift driver", "Dad")  # fmt: skip
SEVERAL = (
    "participants",
    "our visitors",
    "the volunteers",
    "the museum's guests",
    "my little brothers",
    "the zookeepers",
)
MUST = ("must", "should", "has to", "is to", "could", "ought to", "needs to", "is supposed to")


@pytest.mark.parametrize(("who", "must"), list(product(WHO, MUST)))
def test_whoever_it_is_does_it(who: str, must: str) -> None:
    assert_means(f"{who[0].upper()}{who[1:]} {must} put the red cube on the blue cube.", PLACED)


@pytest.mark.parametrize("who", [*SEVERAL, "the curator", "my grandfather"])
@pytest.mark.parametrize("see", ["should see", "must be able to see", "will find", "would like"])
def test_whoever_it_is_sees_and_wants_it(who: str, see: str) -> None:
    assert_means(f"{who[0].upper()}{who[1:]} {see} a row of three red cubes.", ROW)


@pytest.mark.parametrize(
    "text",
    [
        "Have the interns put the red cube on the blue cube.",
        "Could you get the trainee to put the red cube on the blue cube?",
        "Let the children put the red cube on the blue cube.",
        "Ask the zookeeper to put the red cube on the blue cube.",
        "The dockers put the red cube on the blue cube.",
        "The docker puts the red cube on the blue cube.",
    ],
)
def test_whoever_is_made_to_do_it(text: str) -> None:
    assert_means(text, PLACED)


WISHES = ("wants", "has asked for", "insists on", "requests", "would like", "proposes", "decided on", "expects")
TELLING_MORE = ("The zookeeper", "A friend of mine", "The person at the table", "The member of staff on duty", "Team B",
                "One of the students", "The machine operator")  # fmt: skip


@pytest.mark.parametrize("wishes", WISHES)
@pytest.mark.parametrize("who", TELLING_MORE)
def test_whoever_it_is_wishes_it(who: str, wishes: str) -> None:
    assert_means(f"{who} {wishes} a row of three red cubes.", ROW)


@pytest.mark.parametrize("who", ["The glorp", "The interns", "The machine operator", "A friend of mine"])
def test_what_somebody_has_done_is_so_at_the_start(who: str) -> None:
    has = "have" if who.endswith("s") else "has"
    meant = {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["green^red blue"], "miss": ["blue^red green"],
             "start": ["blue^red green"], "start_miss": ["red blue green"]}  # fmt: skip
    assert_means(f"{who} {has} put the red cube on the blue cube. Put the red cube on the green cube.", meant)


@pytest.mark.parametrize(
    "text",
    [
        "An observer standing at the back should see the red cube left of the blue cube.",
        "A person opposite should see the red cube left of the blue cube.",
        "The children with the red cubes should build a tower of three.",
        "The landmark asks for a row.",
        "My teacher never asks for a row of three red cubes.",
        "The glossy cube must put the red cube on the blue cube.",
        "The glorp should get a red cube on its top.",
        "The glorp needs a red cube on its top.",
        "The target should touch the glorp.",
        "The glorp should stand on the red cube.",
        "The kids should form a circle.",
        "Each child should build a tower of three.",
        "Two children should build a tower of three.",
        "If the visitors see a row, stack two red cubes.",
        "No visitor should see the red cube on the blue one.",
        "The intern must glorp the red cube.",
    ],
)
def test_who_could_be_a_block_or_tells_more_is_asked(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


GOODS = ("crate", "carton", "parcel", "package", "piece", "toy", "unit", "item")
PLACES = ("bin", "pallet", "tray", "slot", "station", "bay", "target area", "section")


@pytest.mark.parametrize(("good", "place"), list(product(GOODS, PLACES)))
def test_goods_are_blocks_and_their_places_patches(good: str, place: str) -> None:
    assert_means(f"Put the red {good} in the blue {place}.", MAT)


@pytest.mark.parametrize("table", ["bench", "workbench", "worktop", "counter", "desk"])
def test_a_bench_is_the_table(table: str) -> None:
    said = f"There is a red cube on a blue cube. Put the red cube on the {table}."
    assert_means(said, {"assets": {"red": 1, "blue": 1}, "hold": ["red blue"], "miss": ["blue^red"]})


@pytest.mark.parametrize(
    "text",
    [
        "Put the red cube in the blue crate.",
        "Put the red cube into the second slot.",
        "Move the red cube one unit to the left.",
        "Put the red toy car on the blue cube.",
        "The red tile must be on the blue tile.",
    ],
)
def test_what_is_no_block_and_no_patch(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Put a red cube on the middle one.", 3),
        ("Put a red cube on the left one and a green cube on the middle one.", 3),
        ("Put a red cube on the front one and a green cube on the middle one.", 3),
    ],
)
def test_the_middle_one_of_three_patches_lies_in_the_middle(said: str, told: int) -> None:
    schema, _ = BuiltinFrontEnd().read(f"There are three patches. {said}")
    assert schema is not None
    assert describe(schema).count("At the start") == told


@pytest.mark.parametrize(
    "told",
    [
        "{a} is the red cube. {b} is the blue cube.", "{a} is the red cube, {b} is the blue cube.",
        "{a}: red cube. {b}: blue cube.", "{a} = red cube, {b} = blue cube.",
        "Let {a} be the red cube and {b} the blue cube.", "Let {a} be a red cube. Let {b} be a blue cube.",
        "{a} means the red cube and {b} means the blue cube.",
    ],
)  # fmt: skip
@pytest.mark.parametrize(("a", "b"), [("A", "B"), ("X", "Y"), ("Alpha", "Beta"), ("Cube 1", "cube 2"),
                                      ("The landmark", "the target"), ("The widget", "the base")])  # fmt: skip
def test_names_in_front_of_what_they_are(told: str, a: str, b: str) -> None:
    inside = "Let " in told
    first = a[0].lower() + a[1:] if inside and a.startswith("The") else a
    behind = a[0].lower() + a[1:] if " " in a else a
    assert_means(f"{told.format(a=first, b=b)} Put {behind} on {b}.", PLACED)


@pytest.mark.parametrize(
    "text",
    [
        "Call the red cube Alpha and the blue cube Beta. Put Alpha on Beta.",
        "The red cube is called Alpha and the blue cube Beta. Alpha goes on Beta.",
        "We refer to the red cube as Alpha and the blue cube as Beta. Put Alpha on Beta.",
        "Let the blue cube be the anchor. Put the red cube on the anchor.",
        "Put the target, a red cube, on the landmark, a blue cube.",
        "Put the red cube on the base, which is the blue cube.",
        "Block X: red, block Y: blue. Put block X on block Y.",
        "The target cube is red, the landmark cube is blue. Put the target cube on the landmark cube.",
        "The blue cube serves as the landmark. Put the red cube on the landmark.",
        "There is a red cube (R) and a blue cube (B). Put R on B.",
        "Put A on B, where A is the red cube and B is the blue cube.",
        "Suppose the red cube is called R and the blue cube B. R must be on B.",
    ],
)
def test_names_behind_what_they_are(text: str) -> None:
    assert_means(text, PLACED)


@pytest.mark.parametrize(
    "text",
    [
        "Bin 1 is the blue patch, bin 2 is the green patch. Put the red cube in bin 1.",
        "Zone A: blue, zone B: green. Put the red cube in zone A.",
        "The depot is the blue patch and the pick-up spot is the green patch. Put the red cube on the depot.",
        "Gate 1 is the blue mat, gate 2 the green mat. Bring the red cube to gate 1.",
    ],
)
def test_places_with_names(text: str) -> None:
    assert_means(text, MAT | {"assets": {"red": 1, "blue_patch": 1, "green_patch": 1}, "miss": ["at=green_patch red"]})


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("What you see at the end is the word OK and, in front of the O, a green block.",
         {"assets": {"O": 1, "K": 1, "green": 1}, "hold": ["O K | green ."], "miss": ["green . | O K"]}),
        ("On the target, a red cube.",
         {"assets": {"red": 1, "patch": 1}, "hold": ["at=patch red"], "miss": ["red"]}),
    ],
)  # fmt: skip
def test_what_lies_at_a_place_is_not_the_place(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


def test_several_with_one_name() -> None:
    assert_means("Sheep are white cubes. Put three sheep in a row.",
                 {"assets": {"white": 3}, "hold": ["white white white"], "miss": ["white^white^white"]})  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "The anchor, a yellow cube, and a red cube go on the blue patch.",
        "The target is a red cube, a blue cube and a green cube in a row. The target must be reached.",
        "The top is a red cube. Put a red cube on top of a blue cube.",
        "The left patch is the red patch. Put the blue cube on the left patch.",
        "Bin 1 is the blue patch. Put the red cube in bin 2.",
    ],
)
def test_what_is_no_name_is_asked(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


@pytest.mark.parametrize("lead", ["The red cube must {}", "Let the red cube {}"])
@pytest.mark.parametrize("verb", ["crown", "top", "cap", "surmount", "ride on", "wind up on", "sit on"])
def test_verbs_of_lying_on_it(lead: str, verb: str) -> None:
    assert_means(f"{lead.format(verb)} the blue cube.", PLACED)


@pytest.mark.parametrize("verb", ["underpins", "props up", "must underpin", "must support", "shoulders"])
def test_verbs_of_bearing_it(verb: str) -> None:
    assert_means(f"The blue cube {verb} the red cube.", PLACED)


@pytest.mark.parametrize("must", ["", "must "])
@pytest.mark.parametrize(
    "verb", ["surround", "encircle", "enclose", "gather around", "stand around", "hem in", "frame"]
)
def test_verbs_of_being_around_it(must: str, verb: str) -> None:
    assert_means(f"The four green cubes {must}{verb} the yellow cube.", AROUND)


@pytest.mark.parametrize("verb", ["ring", "circle", "form a ring around", "dance around", "stand in a circle around"])
def test_a_ring_has_what_it_is_around_in_its_middle(verb: str) -> None:
    meant = {"assets": {"green": 6, "yellow": 1}, "hold": ["at=0,0 yellow ; circle=2 at=0,0 green*"],
             "miss": ["circle=2 green* yellow"]}  # fmt: skip
    assert_means(f"Six green cubes must {verb} the yellow cube.", meant)


@pytest.mark.parametrize(
    "form", ["constitute a row", "make up a row", "arrange themselves in a row", "line themselves up in a row"]
)
def test_verbs_of_being_a_figure(form: str) -> None:
    assert_means(f"The three red cubes must {form}.", ROW)


@pytest.mark.parametrize("verb", ["Accept", "Achieve", "Aim for", "Go for", "Opt for", "We aim for", "Obtain"])
def test_what_is_aimed_for(verb: str) -> None:
    assert_means(f"{verb} a row of three red cubes.", ROW)


@pytest.mark.parametrize(
    "text",
    [
        "u shud put the red cube on the blue 1 pls", "put da red 1 on da blue 1 thx m8",
        "red cube shld b on the blue 1", "the red cube needs 2 be on the blue cube",
        "k put the red cube on the blue cube", "wanna c a red cube on a blue 1",
        "so um like put the red cube you know sort of on top of the blue cube I mean",
    ],
)  # fmt: skip
def test_what_is_typed_in_a_hurry(text: str) -> None:
    assert_means(text, PLACED)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("put n on b", {"assets": {"N": 1, "B": 1}, "hold": ["B^N"], "miss": ["N^B"]}),
        ("u must be on b", {"assets": {"U": 1, "B": 1}, "hold": ["B^U"], "miss": ["U^B"]}),
        ("can b go on c", {"assets": {"B": 1, "C": 1}, "hold": ["C^B"], "miss": ["B^C"]}),
        ("put u on top of a", {"assets": {"U": 1, "A": 1}, "hold": ["A^U"], "miss": ["U^A"]}),
        ("put the red 1 on the blue 1",
         {"assets": {"red:1": 1, "blue:1": 1}, "hold": ["blue:1^red:1"], "miss": ["blue:1 red:1"]}),
        ("put red next 2 blue", {"assets": {"red": 1, "blue": 1}, "hold": ["red blue"], "miss": ["red . . blue"]}),
    ],
)  # fmt: skip
def test_symbols_are_no_words(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "As the background stimulus, put the red cube on the blue cube.",
        "As an odd-one-out item, put the red cube on the blue cube.",
        "In condition B, put the red cube on the blue cube.",
        "In preparation for the audit, put the red cube on the blue cube.",
        "On behalf of the logistics department, put the red cube on the blue cube.",
        "Put the red cube on the blue cube for quality control.",
        "Put the red cube on the blue cube for the archive.",
        "Put the red cube on the blue cube as a warm-up exercise.",
    ],
)
def test_what_it_is_for_tells_nothing(text: str) -> None:
    assert_means(text, PLACED)


@pytest.mark.parametrize(
    "text",
    [
        "Put the red cube on the blue cube for a minute.",
        "Make room on the blue cube for the glorp.",
        "Swap the red cube for the glorp.",
        "Build a tower of two red cubes for each glorp.",
        "In the zorb, put the red cube on the blue cube.",
        "Put the red cube on the blue cube for the taller glorp.",
    ],
)
def test_what_could_tell_more_is_asked(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
