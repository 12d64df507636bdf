"""How much "not" denies: each of several things, or all of them together."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.clauses.verbs import ever
from rpg.language.grammar.core import Parser
from rpg.language.meaning import Amount, Clause, Coord, In, Loc, Manner, Meaning, Noun, Pronoun, replace

_NOT = frozenset({"not", "never"})
_ALL = (["both"], ["all"])
BARRED = (*(f"at no {time}{during}" for time in ("time", "point", "moment")
             for during in ("", *(f" {during} the {run}" for during in ("during", "throughout", "of", "in")
                                  for run in ("episode", "task", "run", "whole episode")))),
           "under no circumstances", "in no case", "in no event", "never")  # fmt: skip
"""What comes before a question's order of words: "at no time may the red block be on ..."."""
REACH = 3
"""So many words on "not" is looked for: "are not", "must not", "do not"."""


def denied_of_all(p: Parser, j: int, found: Clause) -> Clause:
    """ "are not both ...", "must not all be ...", "do not put both ...": it may be so of some of them."""
    denial = next((k for k in range(j, min(j + REACH, p.end)) if p.words[k] in _NOT), None)
    if denial is None or not found.negated:
        return found
    ahead = found.verb == "be" and found.theme is not None and found.theme.span[1] <= p.char(denial, 0)
    if ahead and _so_many(found.theme):
        some = Manner(kind="not all", value="of them", span=found.span)
        return replace(found, adjuncts=(*found.adjuncts, some))
    skipped = p.words[denial + 1 : denial + 2] in (["be"], *([word] for word in _verbs(found)))
    at = denial + 1 + skipped
    if p.words[at : at + 1] not in _ALL and not _of_both(p, at, found):
        return found
    return replace(found, adjuncts=(*found.adjuncts, Manner(kind="not all", span=found.span)))


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


def _so_many(theme: Meaning | None) -> bool:
    """ "at least one of the red blocks (is not)", "exactly two red blocks (are not)": so many are not, and no more is
    said of the others."""
    if not isinstance(theme, Noun) or theme.amount is None or theme.det in ("no", "any", "all", "both", "the"):
        return False
    many = theme.amount
    return (many.low > 0 or bool(many.high)) and (many.strict or theme.part_of is not None)


def needless(words: set[str]) -> bool:
    """ "need not", "does not have to": neither asked for nor forbidden."""
    denied = bool(words & _NOT)
    return denied and (bool(words & {"need", "needs"}) or ({"have", "to"} <= words and bool(words & {"do", "does"})))


def _of_both(p: Parser, at: int, found: Clause) -> bool:
    """ "is not left of both red and blue", "is not on both patches"."""
    end = next((k for k in range(at, p.end) if p.tokens[k].span[0] >= found.span[1]), p.end)
    return "both" in p.words[at:end] and any(isinstance(a, Loc) and a.landmark is not None for a in found.adjuncts)


def _verbs(clause: Clause) -> tuple[str, ...]:
    return tuple(clause.lemma.split()[:1])


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
