"""Blocks that lie on a mat and are moved off it, all or some of them, and the mats of "its own" color."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "start", "end"),
    [
        ("Move two of the three blocks on the red mat to the blue mat.",
         "At the start, the red, blue and green blocks are on the red patch",
         "Exactly two of the red, blue and green blocks must be on the blue patch."),
        ("Move at least one of the two green blocks in the left half to the right half of the table.",
         "At the start, the two green blocks are in the left half of the table",
         "At least one of the two green blocks must be in the right half of the table."),
        ("Move two of the three white blocks from the red mat to the blue one.",
         "At the start, the three white blocks are on the red patch",
         "Exactly two of the three white blocks must be on the blue patch."),
        ("Move the three white blocks lying on the red mat to the blue one.",
         "At the start, the three white blocks are on the red patch",
         "The three white blocks must be on the blue patch."),
        ("Move the two yellow bricks off the red mat and onto the blue one.",
         "At the start, the two yellow blocks are on the red patch",
         "The two yellow blocks must be on the blue patch."),
        ("There is a blue block and a yellow block. Move the yellow block off the red mat onto the blue block.",
         "At the start, the yellow block is on the red patch",
         "The yellow block must be on the blue block. The yellow block must not be on the red patch."),
    ],
)  # fmt: skip
def test_where_they_are_and_where_they_go(text: str, start: str, end: str) -> None:
    assert start_and_end(text) == (start, end)


_OWN = "The red block must be on the red patch. The blue block must be on the blue patch."


@pytest.mark.parametrize(
    "text",
    [
        "Every patch must have a block of its own colour on it. We have red and blue.",
        "The colours are red and blue. Each patch must have a block of its own colour on it.",
        "Put every cube onto the mat whose colour matches. There are two colours: red and blue.",
        "Put each cube on the same-coloured mat: red, blue.",
        "Two mats: red, blue. Two blocks in the same colours. Each block on its own mat.",
    ],
)
def test_the_mat_of_its_color(text: str) -> None:
    assert start_and_end(text) == ("", _OWN)


def test_a_mat_of_its_own_is_any() -> None:
    text = "There are a red and a blue block and a red and a blue mat. Each block goes on a mat of its own."
    assert "Exactly one of the red and blue blocks must be on the red patch." in means(text).replace("\n", " ")


def test_equally_many_of_two_colors_may_be_the_colors() -> None:
    assert code_of("Put the same number of green and yellow blocks on each of the two mats.") == "incomplete"
    one_color = means("Put the same number of green blocks on each of the two mats.")
    assert "exactly two of the four green blocks" in one_color.replace("\n", " ")


@pytest.mark.parametrize(
    "text",
    ["The two blocks lie at the edges of the table.", "Put the red and the blue block around the table's edges."],
)
def test_edges_of_the_table(text: str) -> None:
    assert start_and_end(text)[1] == "The red and blue blocks must be at the edge of the table."
