"""What "not" denies, and what it leaves open: "nor does", "need not", "must not stay", "may"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.clauses.verbs import ever
from rpg.language.grammar.core import Parser
from rpg.language.meaning import Amount, Clause, Coord, In, Loc, Manner, Meaning, Noun, Pronoun, replace

_NOT = frozenset({"not", "never"})
BARRED = (*(f"at no {time}{during}" for time in ("time", "point", "moment")
             for during in ("", *(f" {during} the {run}" for during in ("during", "throughout", "of", "in")
                                  for run in ("episode", "task", "run", "whole episode")))),
           "under no circumstances", "in no case", "in no event", "never")  # fmt: skip
"""What comes before a question's order of words: "at no time may the red block be on ..."."""


def of_none(theme: Meaning | None) -> bool:
    """ "No red block", "neither red nor blue": what is said of these with "or" is denied altogether."""
    return (isinstance(theme, Coord) and theme.op == "nor") or (isinstance(theme, Noun) and theme.det == "no")


def nor_does(p: Parser, j: int, k: int, before: Clause, item: Meaning) -> bool:
    """ "Do not let red touch blue or green touch yellow", "no mat has A or B on it": denied as well, and not the other
    possibility."""
    if p.words[j - 1] != "or" or not isinstance(item, Clause) or item.negated or isinstance(item.theme, Pronoun):
        return False
    marks = (a.landmark for a in before.adjuncts if isinstance(a, Loc))
    told = p.words[j:k]
    if any(isinstance(mark, Noun) and mark.det == "no" for mark in marks):
        return told[-1:] == ["it"]
    return before.negated and bool(_BARE_VERBS & {*told}) and not _MODALS & {*told}


_BARE_VERBS = frozenset({"touch", "be", "lie", "stand", "sit", "rest", "go", "stay", "end"})
_MODALS = frozenset({"must", "should", "shall", "may", "has", "have", "will", "can"})


def denies_places(p: Parser, before: Clause) -> bool:
    """ "Put red on the mat but not on blue (or next to green)", "anywhere but on the mat (or next to green)": what is
    denied reaches over the "or" that follows."""
    last = before.adjuncts[-1] if before.adjuncts and not before.negated else None
    if not isinstance(last, Loc | In):
        return False
    anywhere = any(token.word == "anywhere" and token.span[0] == last.span[0] for token in p.tokens)
    return last.negated or (anywhere and isinstance(last, Loc) and last.rel == "off")


def nor_there(item: Clause) -> Clause:
    """The same block as before, denied of a further place."""
    denied = (replace(a, negated=True) if isinstance(a, Loc | In) else a for a in item.adjuncts)
    return replace(item, adjuncts=tuple(denied))


def needless(words: set[str]) -> bool:
    """ "need not", "does not have to": neither asked for nor forbidden."""
    denied = bool(words & _NOT)
    return denied and (bool(words & {"need", "needs"}) or ({"have", "to"} <= words and bool(words & {"do", "does"})))


def stays(found: Clause, allowed: bool) -> Clause:
    """ "stays on the patch": there from the start on; "stays empty", "must not stay there" are about the end.

    `allowed`: "at most one may stay there" is so too, and "at most one stays there", where more of them start.
    """
    many = getattr(found.theme, "amount", None)
    if allowed or (many is not None and many.strict and many.high is not None):
        return found
    placed = any(isinstance(a, Loc | In) for a in found.adjuncts)
    if placed and (found.negated or getattr(found.theme, "det", "") == "no"):
        gone = Manner(kind="gone", span=found.span)
        return replace(found, adjuncts=(*found.adjuncts, gone)) if found.negated else found
    return ever(found, placed)


def leave(found: Clause, only: bool, span: Span) -> Clause:
    """ "A may be there" asks for nothing; "only two of the four may be there": no more than two."""
    theme = found.theme
    amount = theme.amount if isinstance(theme, Noun) else None
    if only and isinstance(theme, Noun) and amount is not None and amount.strict and amount.low == amount.high:
        return replace(found, theme=replace(theme, amount=Amount(0, amount.high, True)))
    return replace(found, adjuncts=(*found.adjuncts, Manner(kind="allowed", span=span)))
