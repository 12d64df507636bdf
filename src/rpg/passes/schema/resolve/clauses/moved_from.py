""" "The tower of red and blue should be moved from the green mat to the yellow one": it is there at the start."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Loc, Meaning, Noun, Structure, Using, replace

_MOVED = frozenset({"move", "bring", "carry", "transfer", "take", "shift", "relocate", "get", "transport"})


def moved_from(chain: Chain) -> Chain:
    """The sentence, with a whole that is moved off a patch told of the start as well."""
    told: list[tuple[str, Meaning]] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        source = _source(clause)
        whole = clause.theme if isinstance(clause, Clause) else None
        if source is None or not isinstance(clause, Clause) or not isinstance(whole, Structure):
            told.append((link, clause))
            continue
        place = Loc(rel="on", landmark=source.members, span=source.span)
        there = Clause(verb="exist", lemma="begun", theme=replace(whole, det="a", amount=Amount(1, 1)), mode="given",
                       adjuncts=(place,), span=whole.span)  # fmt: skip
        known = replace(whole, members=None, sizes=(), details=())
        if whole.kind == "word":
            there, known = replace(there, verb="spell", lemma="", theme=whole, mode="start"), whole
        rest = tuple(x for x in clause.adjuncts if x is not source)
        told += [(link, there), ("and", replace(clause, theme=known, adjuncts=rest))]
    if len(told) == len(chain.clauses):
        return chain
    return replace(chain, clauses=tuple(c for _, c in told), links=tuple(link for link, _ in told))


def _source(clause: Meaning) -> Using | None:
    """The patch that a whole is moved off, where it is said where it goes."""
    whole = clause.theme if isinstance(clause, Clause) and not clause.negated else None
    if not isinstance(clause, Clause) or clause.lemma not in _MOVED or clause.mode == "start":
        return None
    named = isinstance(whole, Structure) and whole.det == "the" and not whole.plural
    if not named or not isinstance(whole, Structure) or not (whole.members or whole.details or whole.letter):
        return None
    patches = [x for x in clause.adjuncts if isinstance(x, Using) and x.lead == "from" and _patch(x.members)]
    return patches[0] if len(patches) == 1 and len(clause.adjuncts) > 1 else None


def _patch(mark: Meaning) -> bool:
    return isinstance(mark, Noun) and mark.head == "patch"
