"""Diagnostics as people read them: the right words are underlined, whatever the instruction is made of."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from rich.cells import cell_len

from rpg.cli.report import diagnostic_lines, wrapped
from rpg.core.diagnostics import Diagnostic, Label

TEXT = "Put the red blok on the blue block and the blue block on the red block"


def shown(diagnostic: Diagnostic, instruction: str = TEXT, width: int = 80) -> list[str]:
    return [line.plain.rstrip() for line in diagnostic_lines(diagnostic, instruction, width)]


def make(span: tuple[int, int] | None = None, *labels: tuple[int, int, str], hint: str | None = None) -> Diagnostic:
    return Diagnostic(
        code="unknown-word",
        message="no such word",
        span=span,
        labels=tuple(Label(span=(start, end), text=text) for start, end, text in labels),
        hint=hint,
    )


def test_one_word_is_underlined_and_the_hint_follows() -> None:
    assert shown(make((12, 16), hint='did you mean "block"?')) == [
        "error[unknown-word]: no such word",
        f"  │ {TEXT}",
        "  │             ^^^^",
        '  = hint: did you mean "block"?',
    ]


def test_two_clashing_phrases_are_labelled() -> None:
    assert shown(make((4, 34), (43, 70, "and this puts it below"), (4, 34, "this puts red on top")), width=120) == [
        "error[unknown-word]: no such word",
        f"  │ {TEXT}",
        "  │     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^         --------------------------- and this puts it below",
        "  │     this puts red on top",
    ]


def test_several_labels_hang_below_their_words() -> None:
    assert shown(make((0, 3), (8, 11, "first"), (24, 28, "second"), (0, 3, "main")))[2:] == [
        "  │ ^^^     ---             ---- second",
        "  │ │       first",
        "  │ main",
    ]


def test_a_long_instruction_is_wrapped_and_only_its_neighbourhood_shown() -> None:
    lines = shown(make((500, 504)), "word " * 400, width=60)
    assert lines[1].strip() == lines[-1].strip() == "│ …"
    assert len(lines) == 7
    assert all(cell_len(line) <= 60 for line in lines)


def test_wide_characters_keep_the_underline_in_place() -> None:
    assert shown(make((4, 6)), "把红色积木块")[1:] == ["  │ 把红色积木块", "  │         ^^^^"]


@pytest.mark.parametrize("text", ["a\x1b[31mb", "a\nb", "a\u202eb", "\x07", "a\u2028b"])
def test_a_terminal_obeys_nothing_in_an_instruction(text: str) -> None:
    quoted = "".join(shown(make((0, 1)), text)[1:])
    assert not set(quoted) & set("\x1b\n\u202e\x07\u2028")


def test_nothing_is_quoted_where_there_is_nothing_to_quote() -> None:
    assert len(shown(make((0, 0)), "")) == 1
    assert len(shown(make(None))) == 1


def test_the_end_of_an_instruction_can_be_pointed_at() -> None:
    assert shown(make((5, 5)), "Stack")[-1] == "  │      ^"


@example("0" * 18 + "⺀", 0, 19, 20)
@given(st.text(max_size=200), st.integers(0, 250), st.integers(0, 250), st.integers(20, 90))
def test_any_text_and_span_can_be_shown(text: str, start: int, end: int, width: int) -> None:
    for line in shown(make((start, end), (end, start, "said")), text, width)[1:]:
        assert cell_len(line) <= max(width, 24) + len(" said")


@given(st.text(alphabet="ab 把", max_size=100), st.integers(4, 30))
def test_wrapping_loses_nothing(text: str, width: int) -> None:
    lines = list(wrapped(text, width))
    assert "".join(text[line.start : line.end] for line in lines) == text
    assert all(cell_len(text[line.start : line.end]) <= width for line in lines)
