"""Questions that are answered at once: "Where should the red block go? On the blue one." says where it should go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.talk.asked_first import about_numbers
from rpg.language.grammar.talk.named_first import with_names
from rpg.language.patterns import on_demand
from rpg.language.phrases import behind
from rpg.language.tokens import Token

_DOES = frozenset({"does", "do", "should", "must", "shall", "will"})
_GOES = frozenset({"go", "belong", "be", "stand", "lie", "sit", "rest", "come"})
_PLACES = frozenset({"on", "onto", "in", "into", "at", "to", "next", "beside", "behind", "between", "under", "left",
                     "right", "near", "atop", "directly", "somewhere", "underneath", "beneath", "below", "above",
                     "anywhere", "immediately", "straight", "upon", "alongside", "over"})  # fmt: skip
_SHOWS = frozenset({"show", "spell", "read", "say", "form"})
_ASKED = frozenset(
    {"goes", "belongs", "go", "belong", "is", "comes", "stands", "lies", "sits", "should", "must", "shall"}
)
_NOUNS = frozenset({"block", "cube", "one", "blocks", "cubes", "ones"})
_BACK = frozenset({"it", "they"})
_AT_LAST = (("at", "the", "end"), ("in", "the", "end"), ("finally",), ())
_DOES_TOO = frozenset({"does", "is", "should", "must"})
"""What an answer may end with that the question has said: "What goes on top? The red one does."."""
_NOT_THESE = (("and", "none", "of"), ("but", "none", "of"), ("and", "not"), ("but", "not"), ("not",))
_MODAL = frozenset({"is", "should", "must", "shall"})
"""What follows those that an answer names, before others that it denies."""
_MOST = 8
"""No longer answers are put in the place of what is asked for."""


def with_answers(parts: list[list[Token]]) -> list[list[Token]]:
    """Sentences, each question that is answered with what answers it."""
    out: list[list[Token]] = []
    for part in with_names(parts):
        told = _answered(out[-1], part) if out else None
        out[-1:] = [told] if told is not None else [*out[-1:], part]
    return out


def _answered(question: Sequence[Token], answer: Sequence[Token]) -> list[Token] | None:
    """The statement that a question and the sentence behind it make; None where they make none."""
    question = question[1:] if question[0].word == "and" else question
    words = [token.word for token in question]
    if len(words) < 3 or not answer:
        return None
    if (told := about_numbers(question, answer)) is not None:
        return told
    if len(words) < 4:
        return None
    if words[0] == "is":
        return _made_so(question, words, [token.word for token in answer])
    if words[0] == "where" and words[1] in _DOES and words[-1] in _GOES:
        return _told_of(question[2:-1], question[-1], question[-1:], answer, _PLACES)
    if words[0] in ("which", "what"):
        begin = 1 + (words[1] in ("word", "name"))
        verb = next((n for n in range(begin + 2, len(words)) if words[n] in _SHOWS), 0)
        if words[begin] in _DOES and verb and tuple(words[verb + 1 :]) in _AT_LAST:
            return _told_of(question[begin + 1 : verb], question[verb], question[verb : verb + 1], answer, None)
        return _in_its_place(question[1 + (words[1] in _NOUNS) :], answer)
    return None


_ASKED_OF = on_demand(f"is ({THING}) {PLACE} {THING}")
_MAKE_SO = frozenset(
    f"{unless}{comma}{please}{do}"
    for unless in ("if not", "if it is not")
    for comma in (" ", " , ")
    for please in ("", "please ", "then ")
    for do in ("put it there", "place it there", "move it there", "bring it there", "make it so", "do so")
)


def _made_so(question: Sequence[Token], words: list[str], answer: list[str]) -> list[Token] | None:
    """ "Is the red block on the blue one? If not, put it there.": it must be there."""
    asked = _ASKED_OF.fullmatch(" ".join(words)) if " ".join(answer) in _MAKE_SO else None
    if asked is None:
        return None
    there = 1 + len(asked[1].split())
    return [*question[1:there], question[0].saying("must"), question[0].saying("be"), *question[there:]]


def _told_of(
    theme: Sequence[Token], at: Token, verb: Sequence[Token], answer: Sequence[Token], begins: frozenset[str] | None
) -> list[Token] | None:
    """What is asked for said of what it is asked of. `begins`: the words that an answer may begin with, or a symbol."""
    if answer[0].word in _BACK and len(answer) > 1:
        return [*theme, *answer[1:]]
    if answer[0].word not in begins if begins is not None else (len(answer) > 1 or answer[0].kind != "literal"):
        return None
    must = replace(at, kind="word", word="must", raw="must", value=None)
    return [*theme, must, *verb, *answer]


def _in_its_place(asked: Sequence[Token], answer: Sequence[Token]) -> list[Token] | None:
    """ "Which block goes on top? The red one.": what is asked for stands in front of what is said of it."""
    words = [token.word for token in answer]
    for at in range(2, len(words)):
        begin = at + (words[at] == ",")
        end = behind(words, begin, _NOT_THESE)
        if end and words[end] == "the":  # "The white ones, and not the black ones."
            those = _in_its_place(asked, answer[:at])
            comma, joint = (answer[at].saying(word) for word in (",", "and"))
            if words[end - 1] == "of":
                return [*those, comma, joint, *answer[end - 2 :]] if those else None
            does = [answer[at].saying(asked[0].word if asked[0].word in _MODAL else "does"), answer[at].saying("not")]
            return [*those, comma, joint, *answer[end:], *does] if those else None
    told = len(words) - (words[-1] in _DOES_TOO)
    if not asked or asked[0].word not in _ASKED or words[0] not in ("the", "a", "an") or not 1 < told <= _MOST:
        return None
    if any(word in _ASKED or word in (",", ":") for word in words[:told]):
        return None
    return [*answer[:told], *asked]
