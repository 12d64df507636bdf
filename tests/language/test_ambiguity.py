"""Two readings are said in English: they differ, and each is worded so that it is read as just that."""

import pytest

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

TWO_WAYS = (
    "Arrange the letters from A to D in a row.",
    "white goes on black, but pink has to go on gray before this",
)


@pytest.mark.parametrize("text", TWO_WAYS)
def test_both_readings_are_sentences_that_differ(text: str) -> None:
    schema, (found,) = BuiltinFrontEnd().read(text)
    assert schema is None and found.code == "ambiguous"
    _, first, between, second, _ = found.message.split('"')
    assert between == ", or " and first != second
    for reading in (first, second):
        assert reading[0].isupper() and reading.endswith(".")
        assert not set("_();=") & set(reading)


@pytest.mark.parametrize("text", TWO_WAYS)
def test_the_hint_works_when_followed(text: str) -> None:
    front_end = BuiltinFrontEnd()
    _, (found,) = front_end.read(text)
    words = found.facts["readings"]
    assert len(words) == 2 and all(f'"{reading}"' in (found.hint or "") for reading in words)
    one, two = (front_end.read(reading)[0] for reading in words)
    assert one is not None and two is not None
    assert not same(one, two)


def test_readings_that_come_to_the_same_are_one() -> None:
    front_end = BuiltinFrontEnd()
    one, _ = front_end.read("put the red block on the blue block and put the red block on the blue block")
    two, _ = front_end.read("put the red block on the blue block")
    assert one is not None and two is not None and same(one, two)
