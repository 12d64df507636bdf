"""A slip of the keyboard never makes another task."""

from __future__ import annotations

from random import Random

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.mutations import read, sample
from tests.corpus.slips import misread, slips


@pytest.mark.parametrize("text", sample(50, 11, ("heldout", "fresh")))
def test_a_slip_makes_no_other_task(text: str) -> None:
    assert not misread(text, Random(text))


def test_slips_are_made_and_read() -> None:
    changed = list(slips("put the yellow block behind the orange block", Random(1)))
    assert changed and all(text != "put the yellow block behind the orange block" for text in changed)
    assert any(read(text) is not None for text in changed)


@pytest.mark.parametrize("text", ["Put thee red blocks on the mat.", "a row of thee blue blocks"])
def test_a_number_is_not_guessed_at(text: str) -> None:
    schema, wrong = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [(d.code, text[slice(*d.span)]) for d in wrong if d.span] == [("unknown-word", "thee")]
