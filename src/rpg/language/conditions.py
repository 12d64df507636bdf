""" "If the red block is on the mat, ...", "... unless it is blue": what would be asked for only under a condition."""

from __future__ import annotations

from rpg.core.diagnostics import Diagnostic
from rpg.language import lexicon
from rpg.language.grammar.core import Parser

_CONDITIONS = (("if",), ("unless",), ("in", "case"), ("depending", "on"), ("otherwise",), ("else",), ("whenever",),
               ("only", "if"), ("even", "if"), ("provided",), ("on", "condition"), ("in", "the", "event"),
               ("except", "if"), ("or", "else"))  # fmt: skip
_ANY_BLOCK = frozenset({"a", "any", "each", "every", "it", "block", "cube", "box", "is", "has"})
_LONGEST = 3
_STOPS = (",", ":", ";", "then")
_NO_SUBJECT = frozenset({"be", "have", "look", "also", "only", "not", "i", "we", "you", "end", "get", "form"})


def conditional(p: Parser, at: int) -> Diagnostic | None:
    """The refusal of a condition, where the reading came to a halt at one."""
    for begin in range(max(0, at - 2 - _LONGEST), min(at + 1, p.end)):
        said = max((len(x) for x in _CONDITIONS if tuple(p.words[begin : begin + len(x)]) == x), default=0)
        if said and begin <= at <= begin + said + _subject(p, begin + said):
            return _refused(p, begin)
    return None


def _subject(p: Parser, i: int) -> int:
    """How many words of a subject without looks stand there, "a block is": a reading may come as far as that."""
    end = i
    while end - i < _LONGEST and p.stands(end, _ANY_BLOCK):
        end += 1
    return end - i


def inverted(p: Parser, i: int) -> Diagnostic | None:
    """ "Should red be on blue, put green on red": a condition, and no question how it should be."""
    if i + 1 >= p.end or p.words[i] not in ("should", "were", "had") or p.words[i + 1] in _NO_SUBJECT:
        return None
    for comma in (n for n in range(i + 3, p.end - 1) if p.words[n] in (",", "then")):
        forms = lexicon.VERB.get(p.words[p.opt(comma + 1, "then", "please")], ())
        if any(form == "base" for _, _, form in forms):
            return _refused(p, i)
    return None


def _refused(p: Parser, begin: int) -> Diagnostic:
    end = next((n for n in range(begin + 1, p.end) if p.words[n] in _STOPS), p.end)
    return Diagnostic(
        code="conditional", message="a task does not depend on a condition", span=p.span(begin, end),
        hint="say how it should be at the end, or what comes first and what then", origin="schema",
    )  # fmt: skip
