"""Lines told in few words."""

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("Row of five, every second block blue, the others white, white first.", "white, blue, white, blue, white."),
        ("The row is: green, yellow, green. Gap 0.", "green, yellow, green without gaps."),
        ("Spell my initials J, K, P.", "J, K, P."),
    ],
)
def test_all_of_the_order_is_told(text: str, order: str) -> None:
    assert means(text).replace("\n", " ").endswith(f"must be in a row from left to right in the order {order}")


def test_pairs_and_words_row_by_row() -> None:
    assert "the two red blocks, then the two blue blocks" in means("The row consists of pairs: two red, two blue.")
    assert "must be in front of the blocks B, A and D." in means("Write BAD GUY in two rows.").replace("\n", " ")
    assert code_of("Row, yellow first, red last, blue and green between them.")
