"""Words to be spelt that are told in another sentence than the wish to spell them."""

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("can you write my name with the letter blocks? it's LEO", "LEO"),
        ("Spell my daughter's name with letter cubes: EMMA.", "EMMA"),
        ("Write down the following word with blocks: HOUSE", "HOUSE"),
        ("I'm called TOM. Please spell my name.", "TOM"),
    ],
)
def test_a_name_that_is_told_apart(text: str, word: str) -> None:
    assert f"must spell the word {word}" in means(text)


def test_two_words_one_behind_the_other() -> None:
    for text in ("Make two words: HI in front and BYE behind it.", "Two words: BYE behind, HI in front of it."):
        assert "The blocks H and I must be in front of the blocks B, Y and E." in means(text).replace("\n", " ")


def test_what_is_no_name_to_be_spelt() -> None:
    assert "spell" not in means("My name is Anna. Put the red block on the blue one.")
    assert code_of("Write my name with the cubes.")
