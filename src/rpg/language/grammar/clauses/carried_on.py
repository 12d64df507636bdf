"""A further predicate of the same subject: "... but must be next to it", "(red with white on it) is behind it"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.becoming import staying
from rpg.language.grammar.clauses.moves import moves
from rpg.language.grammar.clauses.states import BOUND, MODALS, NOT, auxiliaries, lasts, predicate_after_be
from rpg.language.grammar.clauses.verbs import ever
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.retold import some_of_which, told_of
from rpg.language.meaning import Absolute, Clause, Manner, Meaning, Noun, replace

_ENDS = frozenset({"end", "ends", "winds", "finishes"})
"""What tells of the end: "A starts on B and ends up beside it"."""
_LASTING = frozenset({"stays", "stay", "remains", "remain"})


@rule
def carried_on(p: Parser, i: int, before: Clause) -> Results[Meaning]:
    """ "the red block must not be on the mat but must be next to it", "it starts on the red mat and ends on the blue
    one": a further predicate of the same subject."""
    if before.theme is None or not before.adjuncts or some_of_which(p, i, before.theme) or before.mode == "command":
        return
    moved = before.lemma in ("move", "take") or any(getattr(x, "rel", "") == "off" for x in before.adjuncts)
    moved = moved and before.mode == "goal"
    if before.verb == "be" or moved:  # "must come off the blue one and move to the mat"
        for going, j in moves(p, i, i, told_of(before), "goal", False):
            yield replace(going, cost=going.cost + 1), j
    if before.verb != "be" and not moved:
        return
    k, words = auxiliaries(p, i)
    for kept, j in staying(p, i, k, told_of(before), "goal") if words & NOT else ():
        yield ever(replace(kept, cost=kept.cost + 1), lasts(words)), j
    later = before.mode == "start" and p.words[k] in BOUND | _LASTING
    onward = p.stands(i, ("goes", "go")) and p.follows(i, ("then",))  # "goes to A and then goes to B"
    had = moved or all(isinstance(a, Absolute) for a in before.adjuncts)
    had = had and p.stands(i, lexicon.POSTURE)
    if k == i and not (later or onward or had) and p.words[i : i + 1] not in (["is"], ["are"]):
        return
    both = "both" in words or p.words[i - 1] == "both"
    same = told_of(before, both)
    mode = "goal" if later or words & (MODALS | _ENDS) else before.mode
    for found, j in predicate_after_be(p, i, k, same, mode, bool(words & NOT)):
        if isinstance(found, Clause):
            step = mode == "start" and any(isinstance(a, Manner) and a.kind == "time" for a in found.adjuncts)
            found = replace(found, mode="goal") if step else found  # "it starts there and is put on blue first"
            yield ever(replace(found, cost=found.cost + 1), lasts(words)), j


def on_with_it(p: Parser, i: int, before: Meaning) -> Results[tuple[Meaning, ...]]:
    """ "the red block with a white one on it (stands behind the blue one)": what has something beside it goes on."""
    had = isinstance(before, Clause) and bool(before.adjuncts) and all(isinstance(a, Absolute) for a in before.adjuncts)
    if had and isinstance(before, Clause) and isinstance(before.theme, Noun):
        yield from (((told,), j) for told, j in carried_on(p, i, before))
