"""stack, towers, row, spells, equation on hand-made states: what must hold, and what must not."""

from __future__ import annotations

import math

import pytest

from rpg.blocks.state import BlockState, yaw_quat
from rpg.ir.node import Axis, Slope
from rpg.ir.order import Order
from rpg.ir.structures import Equation, Row, Spells, Stack, Towers
from tests.blocks.structure_states import E, check_built, cubes, letters, patch, plain, state, value, world

RGB = world(plain(red="red", green="green", blue="blue"), plain(other="yellow"))
THREE = ("red", "green", "blue")
GIVEN = Order(by="given", ranks=(("red",), ("green",), ("blue",)))
UPRIGHT_STACK = {"red": (0, 0, 0), "green": (0, 0, 1), "blue": (0, 0, 2), "other": (0.1, 0.1)}


def test_stack_in_any_order() -> None:
    node = Stack(blocks=THREE)
    assert value(node, state(RGB, UPRIGHT_STACK))
    assert value(node, state(RGB, {**UPRIGHT_STACK, "red": (0, 0, 2), "blue": (0, 0, 0)}))
    assert not value(node, state(RGB, {**UPRIGHT_STACK, "blue": (0.1, 0, 0)}))


def test_stack_follows_its_order() -> None:
    node = Stack(blocks=THREE, order=GIVEN)
    assert value(node, state(RGB, UPRIGHT_STACK))
    assert not value(node, state(RGB, {**UPRIGHT_STACK, "red": (0, 0, 2), "blue": (0, 0, 0)}))
    down = Stack(blocks=THREE, order=GIVEN.model_copy(update={"first": "top"}))
    assert not value(down, state(RGB, UPRIGHT_STACK))
    assert value(down, state(RGB, {**UPRIGHT_STACK, "red": (0, 0, 2), "blue": (0, 0, 0)}))


@pytest.mark.parametrize(("offset", "holds"), [(0.0215, True), (0.0225, False)])
def test_stack_offset_tolerance(offset: float, holds: bool) -> None:
    for yaw in (0.0, 0.7, 2.0):
        assert value(Stack(blocks=THREE), state(RGB, {**UPRIGHT_STACK, "blue": (0, offset, 2)}, yaw=yaw)) is holds


def test_more_on_top_of_a_named_stack() -> None:
    crowned = state(RGB, {**UPRIGHT_STACK, "other": (0, 0, 3)})
    assert value(Stack(blocks=THREE), crowned)
    assert not value(Stack(blocks=THREE, exact=True), crowned)
    assert value(Stack(blocks=THREE, exact=True), state(RGB, UPRIGHT_STACK))
    raised = {"other": (0, 0, 0), "red": (0, 0, 1), "green": (0, 0, 2), "blue": (0, 0, 3)}
    assert not value(Stack(blocks=THREE), state(RGB, raised))
    between = {"red": (0, 0, 0), "other": (0, 0, 1), "green": (0, 0, 2), "blue": (0, 0, 3)}
    assert not value(Stack(blocks=THREE), state(RGB, between))


def test_stack_on_a_patch() -> None:
    objects = world(plain(red="red", green="green"), [patch("goal", "green", 0.55, 0.0)])
    node = Stack(blocks=("red", "green"), patch="goal")
    assert value(node, state(objects, {"red": (0.04, 0.04), "green": (0.04, 0.04, 1)}))
    assert not value(node, state(objects, {"red": (0.06, 0), "green": (0.06, 0, 1)}))


def test_look_alikes_change_places_in_a_given_order() -> None:
    objects = world(plain(r1="red", blue="blue", r2="red"))
    node = Stack(blocks=("r1", "blue", "r2"), order=Order(by="given", ranks=(("r1",), ("blue",), ("r2",))))
    assert value(node, state(objects, {"r2": (0, 0, 0), "blue": (0, 0, 1), "r1": (0, 0, 2)}))
    assert not value(node, state(objects, {"r2": (0, 0, 0), "blue": (0, 0, 2), "r1": (0, 0, 1)}))
    named = node.model_copy(update={"order": node.order.model_copy(update={"match": "name"})})
    assert not value(named, state(objects, {"r2": (0, 0, 0), "blue": (0, 0, 1), "r1": (0, 0, 2)}))


FOUR = world(plain(r1="red", r2="red", b1="blue", b2="blue"), plain(other="green"))
PAIRS = {"r1": (0, 0, 0), "r2": (0, 0, 1), "b1": (0, 0.1, 0), "b2": (0, 0.1, 1), "other": (0.1, 0.2)}
ALL_FOUR = ("r1", "r2", "b1", "b2")


def test_towers_partition_their_blocks() -> None:
    assert value(Towers(blocks=ALL_FOUR), state(FOUR, PAIRS))
    assert value(Towers(blocks=ALL_FOUR, count=2, equal=True, heights=(2, 2)), state(FOUR, PAIRS))
    assert value(Towers(blocks=ALL_FOUR, each="color", separate=True), state(FOUR, PAIRS))
    lone = {**PAIRS, "r2": (0, 0.1, 2)}
    assert not value(Towers(blocks=ALL_FOUR), state(FOUR, lone))
    one = {**PAIRS, "b1": (0, 0, 2), "b2": (0, 0, 3)}
    assert value(Towers(blocks=ALL_FOUR), state(FOUR, one))
    assert not value(Towers(blocks=ALL_FOUR, count=2), state(FOUR, one))
    assert not value(Towers(blocks=ALL_FOUR), state(FOUR, {**PAIRS, "other": (0, 0, 2)}))
    mixed = {**PAIRS, "r2": (0, 0.1, 1), "b2": (0, 0, 1)}
    assert value(Towers(blocks=ALL_FOUR, count=2), state(FOUR, mixed))
    assert not value(Towers(blocks=ALL_FOUR, each="color"), state(FOUR, mixed))


def test_towers_on_matching_patches() -> None:
    patches = [patch("pr", "red", 0.55, 0.0), patch("pb", "blue", 0.55, 0.12)]
    objects = world(plain(r1="red", r2="red", b1="blue", b2="blue"), patches)
    node = Towers(blocks=ALL_FOUR, matching=("pr", "pb"))
    good = {"r1": (0, 0, 0), "r2": (0, 0, 1), "b1": (0, 0.12, 0), "b2": (0, 0.12, 1)}
    assert value(node, state(objects, good))
    crossed = {"b1": (0, 0, 0), "b2": (0, 0, 1), "r1": (0, 0.12, 0), "r2": (0, 0.12, 1)}
    assert not value(node, state(objects, crossed))


def row_of(objects, names, pitch=0.05, yaw=0.0, **changed):  # type: ignore[no-untyped-def]
    places = {name: (0.0, -pitch * k) for k, name in enumerate(names)}
    return state(objects, {**places, **changed}, yaw=yaw)


@pytest.mark.parametrize("yaw", [0.0, 0.4, 1.2, 2.5])
def test_row_in_any_direction(yaw: float) -> None:
    node = Row(blocks=THREE)
    assert value(node, row_of(RGB, THREE, yaw=yaw))
    assert value(node, row_of(RGB, THREE, yaw=yaw, green=(0.0295, -0.05)))
    assert not value(node, row_of(RGB, THREE, yaw=yaw, green=(0.0305, -0.05)))
    assert value(node, row_of(RGB, THREE, pitch=0.0995, yaw=yaw))
    assert not value(node, row_of(RGB, THREE, pitch=0.1005, yaw=yaw))
    assert not value(node, row_of(RGB, THREE, yaw=yaw, green=(0, -0.05, 1)))


@pytest.mark.parametrize(("degrees", "holds"), [(14.5, True), (15.5, False), (-14.5, True), (165.5, True), (90, False)])
def test_row_along_an_axis(degrees: float, holds: bool) -> None:
    turned = row_of(RGB, THREE, yaw=math.radians(degrees))
    assert value(Row(blocks=THREE, axis="y"), turned) is holds
    across = row_of(RGB, THREE, yaw=math.radians(degrees + 90))
    assert value(Row(blocks=THREE, axis="x"), across) is holds


@pytest.mark.parametrize(
    ("axis", "degrees", "holds"),
    [("rising", 45, True), ("rising", -45, False), ("rising", 32, True), ("rising", 28, False), ("rising", 62, False),
     ("falling", -45, True), ("falling", 45, False), ("diagonal", 45, True), ("diagonal", -45, True),
     ("diagonal", 0, False), ("diagonal", 90, False)],
)  # fmt: skip
def test_row_along_a_diagonal(axis: Axis | Slope, degrees: float, holds: bool) -> None:
    """The row goes from left to right; turned counter-clockwise as seen from above, its right end goes away."""
    turned = row_of(RGB, THREE, yaw=math.radians(degrees))
    assert value(Row(blocks=THREE, axis=axis), turned) is holds


@pytest.mark.parametrize("steeper", [-8, 8])
def test_a_diagonal_is_counted_from_its_left_end_whichever_way_it_leans(steeper: float) -> None:
    for axis, degrees in (("rising", 45 + steeper), ("falling", -45 + steeper)):
        turned = row_of(RGB, THREE, yaw=math.radians(degrees))
        left, right = (Order(by="given", ranks=GIVEN.ranks, first=first) for first in ("left", "right"))
        assert value(Row(blocks=THREE, axis=axis, order=left), turned)
        assert not value(Row(blocks=THREE, axis=axis, order=right), turned)


def test_a_two_by_two_square_is_no_row() -> None:
    objects = world(cubes(4))
    square = {"b0": (0, 0), "b1": (E, 0), "b2": (0, E), "b3": (E, E)}
    assert not value(Row(blocks=("b0", "b1", "b2", "b3")), state(objects, square))


@pytest.mark.parametrize("pitch", [E, 1.1 * E, 0.05])
def test_three_blocks_in_an_l_are_no_row(pitch: float) -> None:
    corner = {"red": (0, 0), "green": (0, pitch), "blue": (pitch, 0)}
    for yaw in (0.0, 0.3, 0.8):
        assert not value(Row(blocks=THREE), state(RGB, corner, yaw=yaw))


def test_row_orders() -> None:
    left = Row(blocks=THREE, order=GIVEN.model_copy(update={"first": "left"}))
    assert value(left, row_of(RGB, THREE))
    assert not value(left, row_of(RGB, THREE[::-1]))
    assert value(Row(blocks=THREE, order=GIVEN), row_of(RGB, THREE[::-1]))
    assert not value(Row(blocks=THREE, order=GIVEN), row_of(RGB, ("red", "blue", "green")))
    assert not value(left, row_of(RGB, THREE, yaw=math.pi / 2))
    front = Row(blocks=THREE, order=GIVEN.model_copy(update={"first": "front"}))
    assert value(front, row_of(RGB, THREE, yaw=math.pi / 2))
    assert not value(front, row_of(RGB, THREE, yaw=-math.pi / 2))


def test_rainbow_alternating_mirrored_together() -> None:
    objects = world(plain(r1="red", r2="red", y="yellow", b1="blue", b2="blue"))
    names = ("r1", "r2", "y", "b1", "b2")

    def holds(by: str, sequence: str) -> bool:
        order = Order(by=by)  # type: ignore[arg-type]
        return value(Row(blocks=names, order=order), row_of(objects, sequence.split()))

    assert holds("rainbow", "r1 r2 y b1 b2") and holds("rainbow", "b1 b2 y r2 r1")
    assert not holds("rainbow", "y r1 r2 b1 b2")
    assert holds("alternating", "r1 b1 r2 y b2") and not holds("alternating", "r1 r2 b1 y b2")
    assert holds("mirrored", "r1 b1 y b2 r2") and not holds("mirrored", "r1 b1 y r2 b2")
    assert holds("together", "b1 b2 r1 r2 y") and not holds("together", "b1 r1 r2 b2 y")


def test_row_spacing() -> None:
    spaced = Row(blocks=THREE, spacing=0.08)
    assert value(spaced, row_of(RGB, THREE, pitch=0.089)) and not value(spaced, row_of(RGB, THREE, pitch=0.0915))
    gap = Row(blocks=THREE, gap=0.03)
    assert value(gap, row_of(RGB, THREE, pitch=0.079)) and not value(gap, row_of(RGB, THREE, pitch=0.0815))
    touching = Row(blocks=THREE, touching=True)
    assert value(touching, row_of(RGB, THREE, pitch=0.0419)) and not value(touching, row_of(RGB, THREE, pitch=0.0425))
    even = Row(blocks=THREE, evenly=True)
    assert value(even, row_of(RGB, THREE, blue=(0, -0.119))) and not value(even, row_of(RGB, THREE, blue=(0, -0.121)))


CATS = world(letters("CATS"))
CAT = ("s0", "s1", "s2")


def spell(node: Spells, **changed: tuple[float, ...]) -> bool:
    places = {"s0": (0, 0.05), "s1": (0, 0), "s2": (0, -0.05), "s3": (0.15, 0.2), **changed}
    return value(node, state(CATS, places))  # type: ignore[arg-type]


def test_spells_from_left_to_right_and_nothing_else_adjoins() -> None:
    word = Spells(blocks=(*CAT, "s3"), word="cat")
    assert spell(word)
    assert not spell(word, s3=(0, -0.1)) and not spell(word, s3=(0, 0.1))
    assert not spell(word, s3=(0.05, 0)) and not spell(word, s3=(0, 0, 1))
    assert spell(word, s3=(0, -0.17))
    assert spell(Spells(blocks=(*CAT, "s3"), word="cats"), s3=(0, -0.1))
    assert not spell(word, s0=(0, -0.05), s2=(0, 0.05))
    assert spell(word.model_copy(update={"reverse": True}), s0=(0, -0.05), s2=(0, 0.05))
    assert not spell(word, s2=(0, -0.16))


def test_what_is_told_to_be_beside_a_word_may_adjoin_it() -> None:
    word = Spells(blocks=(*CAT, "s3"), word="cat", beside=("s3",))
    assert spell(word, s3=(0.05, 0)), "behind a letter"
    assert not spell(word, s3=(0, -0.1)), "cats"
    assert not spell(word, s3=(0, 0, 1))
    objects = world(letters("CAT"), plain(red="red"))
    places = {"s0": (0, 0.05), "s1": (0, 0), "s2": (0, -0.095)}
    beside = Spells(blocks=CAT, word="CAT", beside=("red",))
    assert value(beside, state(objects, {**places, "red": (0, -0.14)})), "a plain block at the end"
    assert not value(beside, state(objects, {**places, "red": (0, -0.0475)})), "a plain block in a gap"


def test_a_plain_block_in_a_gap_spoils_a_word() -> None:
    objects = world(letters("CAT"), plain(red="red"))
    word = Spells(blocks=CAT, word="CAT")
    places = {"s0": (0, 0.05), "s1": (0, 0), "s2": (0, -0.095)}
    assert value(word, state(objects, {**places, "red": (0.15, 0.2)}))
    assert not value(word, state(objects, {**places, "red": (0, -0.0475)}))
    assert value(word, state(objects, {**places, "red": (0.045, -0.0475)})), "behind the gap"
    assert value(word, state(objects, {**places, "red": (-0.045, 0)})), "in front of a letter"


def test_an_alphabetical_row_has_no_other_symbol_in_it() -> None:
    objects = world(letters("ABD7"), plain(red="red"))
    order = Order(by="label", first="left")
    node = Row(blocks=("s0", "s1", "s2"), order=order, readable=True)
    places = {"s0": (0, 0.05), "s1": (0, 0), "s2": (0, -0.05), "s3": (0.15, 0.2), "red": (-0.1, 0.2)}
    assert value(node, state(objects, places))
    assert not value(node, state(objects, {**places, "s3": (0, -0.1)}))
    assert not value(node, state(objects, {**places, "s0": (0, 0.09), "s3": (0, 0.045)}))
    assert value(node, state(objects, {**places, "red": (0, 0.1)})), "a plain block is not read"
    assert not value(node, state(objects, {**places, "red": (0, 0, 1)})), "a covered symbol is not seen"


def test_spelled_symbols_must_be_readable() -> None:
    word = Spells(blocks=CAT, word="CAT")
    places = {"s0": (0, 0.05), "s1": (0, 0), "s2": (0, -0.05), "s3": (0.15, 0.2)}
    assert value(word, state(CATS, places, turns={"s1": yaw_quat(math.radians(19))}))
    assert not value(word, state(CATS, places, turns={"s1": yaw_quat(math.radians(21))}))
    assert not value(word, state(CATS, places, turns={"s1": yaw_quat(math.pi)}))
    excused = word.model_copy(update={"excused": ("s1",)})
    assert value(excused, state(CATS, places, turns={"s1": yaw_quat(math.pi)}))
    assert not value(word, state(CATS, places, yaw=math.pi))
    assert value(word.model_copy(update={"readable": False}), state(CATS, places, turns={"s1": yaw_quat(1.0)}))


def test_spells_down_a_stack() -> None:
    down = Spells(blocks=CAT, word="CAT", along="stack")
    assert spell(down, s0=(0, 0, 2), s1=(0, 0, 1), s2=(0, 0, 0))
    assert not spell(down, s2=(0, 0, 2), s1=(0, 0, 1), s0=(0, 0, 0))
    assert not spell(down, s0=(0, 0, 2), s1=(0, 0, 1), s2=(0, 0, 0), s3=(0, 0, 3))
    turned = {"s0": (0, 0, 2), "s1": (0, 0, 1), "s2": (0, 0, 0)}
    assert value(down, state(CATS, turned, yaw=math.pi / 2))  # every face shows the letter
    assert not value(down, state(CATS, turned, yaw=math.pi / 4))


def test_words_with_repeated_and_spare_letters() -> None:
    objects = world(letters("ROBOTO"))
    word = Spells(blocks=tuple(objects.blocks), word="ROBOT")
    at = {f"s{k}": (0.0, 0.1 - 0.05 * k) for k in range(5)} | {"s5": (0.14, 0.2)}
    assert value(word, state(objects, at))
    assert value(word, state(objects, {**at, "s5": at["s1"], "s1": (0.14, 0.2)}))
    assert not value(word, state(objects, {**at, "s2": at["s1"], "s1": at["s2"]}))


def says(written: str, **fields: object) -> bool:
    objects = world(letters(written))
    node = Equation(blocks=tuple(objects.blocks), **fields)  # type: ignore[arg-type]
    return value(node, state(objects, {name: (0.0, 0.25 - 0.045 * k) for k, name in enumerate(objects.blocks)}))


def test_equations_are_computed() -> None:
    assert says("2+3=5") and says("5=2+3") and says("1+2*3=7") and says("6/4=3/2") and says("8/2-4=0")
    assert not says("2+2=5") and not says("+2=2") and not says("2=3=5") and not says("235") and not says("1/0=1/0")
    assert says("12=12", longer=True) and not says("12=12") and not says("01=1", longer=True)
    assert says("2+3=5", text="2+3=5") and says("5=2+3", text="2+3=5") and not says("3+2=5", text="2+3=5")


@pytest.mark.parametrize(
    "node",
    [
        Stack(blocks=THREE),
        Stack(blocks=THREE, order=GIVEN, exact=True),
        Row(blocks=THREE),
        Row(blocks=THREE, order=GIVEN),
        Row(blocks=THREE, axis="x", touching=True),
        Row(blocks=THREE, axis="y", evenly=True, order=GIVEN.model_copy(update={"first": "right"})),
        Row(blocks=THREE, spacing=0.1),
        Row(blocks=THREE, axis="rising", order=GIVEN.model_copy(update={"first": "right"})),
        Row(blocks=THREE, axis="falling", touching=True),
        Row(blocks=THREE, gap=0.02),
    ],
)
def test_built_states_hold_and_their_near_misses_do_not(node: Stack | Row) -> None:
    check_built(node, RGB, {"other": (0.14, 0.2)}, least=3)


@pytest.mark.parametrize(
    "node",
    [
        Towers(blocks=ALL_FOUR),
        Towers(blocks=ALL_FOUR, count=2),
        Towers(blocks=ALL_FOUR, heights=(2, 2)),
        Towers(blocks=ALL_FOUR, each="color", separate=True),
        Towers(blocks=ALL_FOUR, count=1),
    ],
)
def test_built_towers(node: Towers) -> None:
    check_built(node, FOUR, {"other": (-0.14, 0.6)}, least=3)


@pytest.mark.parametrize("along", ["row", "stack"])
def test_built_texts(along: str) -> None:
    node = Spells(blocks=(*CAT, "s3"), word="CAT", along=along)  # type: ignore[arg-type]
    check_built(node, CATS, {"s3": (0.14, 0.2)}, least=6)
    objects = world(letters("=2+35"))
    check_built(Equation(blocks=tuple(objects.blocks), along=along), objects, least=6)  # type: ignore[arg-type]


def test_names_do_not_matter() -> None:
    """Renaming look-alikes changes nothing."""
    good = state(FOUR, PAIRS)
    renamed = BlockState(
        FOUR, {**good.position, "r1": good.position["r2"], "r2": good.position["r1"]}, good.orientation
    )
    assert value(Towers(blocks=ALL_FOUR, each="color"), renamed)
