"""Who is to read something, and from where: "so that a child sitting in front can read them" asks that they are
readable, which is seen from the viewer's side; "from the front" is no order there."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.face_read import without_face
from rpg.language.grammar.talk.layers_told import in_layers
from rpg.language.grammar.talk.people import WHO
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.phrases import Classes
from rpg.language.tokens import Token

_THERE = "from the? front|camera|viewer|robot|robot_'s_side|camera_'s_side"
_HERE = (
    "from_here|from_in_front|from_my_side|from_where_i_sit|from_where_i_am_sitting|from_my_seat|from_my_chair|"
    "from_our_side|from_there"
)
_SITTING = "who_sits|who_is|sitting|standing|seated? in_front|at_the_table|in_front_of_the_table|in_front_of_it?"
_WHAT = (
    "them|it|everything|all_of_them|the_numbers|the_letters|the_symbols|the_digits|what_they_show|what_is_on_them|"
    "the_number|the_letter|the_digit"
)
_CAN_READ = Patterns(
    *(
        f"so_that|so|such_that <person> {_SITTING} can|could|may|is_able_to read {_WHAT} "
        f"well|easily|clearly|properly? {place}"
        for place in ("please?", _THERE, _HERE)
    ),
    classes=Classes(WHO),
)
_READABLE = Patterns(f"readable|legible {_THERE}", f"readable|legible {_HERE}")
_IT = frozenset({"it", "number", "letter", "digit"})
_LINES = frozenset({"grid", "rows", "columns", "wall", "square"})
"""Where there are several lines, what can be read has an order as well."""
_GOES_ON = frozenset({"to", "in", "like", "as", "row"})


def legible(parts: list[list[Token]]) -> list[list[Token]]:
    """Sentences, with what is readable said plainly."""
    return [_plainly(without_face(in_layers(part))) for part in parts]


def _plainly(part: list[Token]) -> list[Token]:
    p = Parser(part)
    lines = not p.all.isdisjoint(_LINES) or any(token.kind == "dims" for token in part)
    for i in range(p.end):
        if j := 0 if lines else max(_CAN_READ.matches(p, i), default=0):
            one = not _IT.isdisjoint(p.words[i:j])
            if any(token.raw.isupper() and len(token.raw) > 1 for token in part[:i]):
                return part  # a word, which has its order
            told = ("so", "that", "it", "is", "readable") if one else ("so", "that", "they", "are", "readable")
            if not p.stands(j, _GOES_ON):
                return [*part[:i], *(part[i].saying(word) for word in told), *part[j:]]
        if (j := max(_READABLE.matches(p, i), default=0)) and not p.stands(j, _GOES_ON):
            return [*part[: i + 1], *part[j:]]
    return part
