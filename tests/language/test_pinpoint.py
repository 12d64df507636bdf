"""Refusals of whole sentences name the part that is to blame, and no more."""

from __future__ import annotations

import pytest

from rpg.pipeline import CompileOptions, compile_instruction


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("Spell GUM, but not on the pink patch.", "but not on the pink patch"),
        ("Put red on blue. Build a row of A, B and C, from above", "from above"),
        ("Spell CAT, not quite.", "not quite"),
    ],
)
def test_the_part_that_is_not_understood_is_underlined(text: str, part: str) -> None:
    outcome = compile_instruction(text, CompileOptions(paraphrases=0))
    assert outcome.status == "refused"
    (found,) = outcome.diagnostics
    assert found.code == "incomplete"
    assert found.span is not None
    assert text[slice(*found.span)] in part
    assert "is not understood with the rest of this" in found.message


@pytest.mark.parametrize("text", ["the red block and", "the red block"])
def test_a_sentence_that_stops_too_early_is_told_so(text: str) -> None:
    (found,) = compile_instruction(text, CompileOptions(paraphrases=0)).diagnostics
    assert "not understood" not in found.message


def test_words_that_mean_nothing_together_are_told_so() -> None:
    text = "The white cube shall be the leftmost one of a row in which the three other cubes are black."
    (found,) = compile_instruction(text, CompileOptions(paraphrases=0)).diagnostics
    assert found.message == "the words of this are known, but not what they mean together"
    assert found.span == (0, len(text) - 1)


def test_the_hint_of_a_word_that_does_not_fit_names_its_part() -> None:
    text = "Build a tower of three red blocks, one diagonal is white"
    (found,) = compile_instruction(text, CompileOptions(paraphrases=0)).diagnostics
    assert found.code == "misplaced-word"
    assert found.hint is not None
    assert "'one diagonal is white'" in found.hint
