"""Questions about numbers with what is to be done behind them: "Which is bigger, 3 or 7? Put the bigger one there."
tells of the larger of 3 and 7, and "What is 2 + 3? Put the answer on the mat." of the answer to 2 + 3."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.grammar.core import Parser
from rpg.language.grammar.structures.equations import operation, value_of
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_LARGER = "larger|bigger|greater|higher|largest|biggest|greatest|highest"
_SMALLER = "smaller|lower|less|smallest|lowest"
_RANKS = frozenset(f"{_LARGER}|{_SMALLER}".split("|"))
_THING = "number|digit|one|cube|block|value"
_WHICH = Patterns(f"which|what {_THING}? is the? {_LARGER}|{_SMALLER} {_THING}? ,|:|of?")
_HOW_MUCH = Patterns("what|how_much is|are|makes|equals", "what do|does", "calculate|compute|work_out :?")
_ANSWER = "answer|result|solution"
_IT = Patterns(f"the {_LARGER}|{_SMALLER} {_THING}?", f"that {_THING}?", f"the {_ANSWER}", "it",
               f"the right|correct {_THING}|answer", f"the cube|block|digit|number with the {_ANSWER}")  # fmt: skip
_WRITTEN = frozenset({"=", "equals", "equal", "equation", "sign", "sum", "calculation"})
"""With these the answer is to be written behind the question."""
_OR = frozenset({",", "or", "and"})


def about_numbers(question: Sequence[Token], told: Sequence[Token]) -> list[Token] | None:
    """What is said behind a question, with what is asked for in the place of the words that mean it."""
    asked = _compared(question) or _calculated(question)
    if not asked or any(token.word in _WRITTEN for token in told):
        return None
    p = Parser([*told])
    found = [(n, max(ends)) for n in range(p.end) if (ends := [*_IT.matches(p, n)])]
    found = [(n, j) for n, j in found if not any(m < n < k for m, k in found)]
    ranks = {*(t.word for t in asked)} & _RANKS
    if not found and _named(question, p):
        return [*told]
    if len(found) != 1 or not _same_rank({*p.words[slice(*found[0])]} & _RANKS, ranks):
        return None
    begin, end = found[0]
    return [*told[:begin], *asked, *told[end:]]


def _named(question: Sequence[Token], told: Parser) -> bool:
    """ "What is 2 + 3? Put the 5 there.": the result is named."""
    calculated = _calculated(question)
    side, _ = operation(Parser(calculated), 3) if calculated else ("", 0)
    return bool(side) and str(value_of(side)) in told.words


def _same_rank(said: set[str], asked: set[str]) -> bool:
    """ "Which is bigger? Put the smaller one there." is no slip, but tells of another one."""
    large = frozenset(_LARGER.split("|"))
    return not said or (bool(asked) and bool(said & large) == bool(asked & large))


def _compared(question: Sequence[Token]) -> list[Token]:
    """ "which number is bigger, 3 or 7": the bigger of 3 and 7."""
    p = Parser([*question])
    for j in _WHICH.matches(p, 0):
        rest = question[j:]
        numbers = [token for token in rest if token.kind == "number" and len(token.word) == 1]
        plain = all(token.kind == "number" or token.word in _OR for token in rest)
        if len(numbers) < 2 or not plain or len({t.word for t in numbers}) < len(numbers):
            continue
        rank = next(token for token in question[:j] if token.word in _RANKS)
        listed = [token for number in numbers[1:] for token in (rank.saying(","), number)]
        rank = rank.saying("smaller") if rank.word == "less" else rank
        return [rank.saying("the"), rank, rank.saying("of"), numbers[0], *_joined(listed)]
    return []


def _joined(listed: list[Token]) -> list[Token]:
    """The last of a list behind "and"."""
    return [*listed[:-2], listed[-2].saying("and"), listed[-1]]


def _calculated(question: Sequence[Token]) -> list[Token]:
    """ "what is 2 + 3", "4 - 1 = ?": the answer to it."""
    p = Parser([*question])
    for j in (*_HOW_MUCH.matches(p, 0), 0):
        side, k = operation(p, j)
        end = p.opt(p.opt(k, "=", "is", "equals", "makes"), "?") if k else 0
        if k and end == p.end and value_of(side) is not None:
            at = question[0]
            return [at.saying("the"), at.saying("answer"), at.saying("to"), *question[j:k]]
    return []
