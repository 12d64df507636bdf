""" "Line up A, B and C upside down": they are lined up, and they are upside down."""

from __future__ import annotations

from rpg.language.meaning import At, Chain, Clause, Coord, Into, Loc, Manner, Meaning, Noun, Pronoun, replace

TURNS = frozenset({"facing", "turn", "by", "by?"})
_LINES = frozenset({"line", "align"})


def turned_as_well(chain: Chain) -> Chain:
    """The sentence with a clause of its own for how blocks lie that it arranges."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        clause = _as_far(clauses[-1] if clauses else None, clause)
        turns = _turns(clause)
        if isinstance(clause, Clause) and turns:
            rest = tuple(part for part in clause.adjuncts if part not in turns)
            they = Pronoun(word="they", span=turns[0].span)
            told = Clause(verb="be", lemma="fact", theme=they, adjuncts=turns, mode="goal", span=turns[0].span)
            clauses += [replace(clause, adjuncts=rest), told]
            links += [link, "and"]
        else:
            clauses.append(clause)
            links.append(link)
    whole = replace(chain, clauses=tuple(clauses), links=tuple(links))
    return whole if whole.clauses != chain.clauses else chain


def _as_far(before: Meaning | None, clause: Meaning) -> Meaning:
    """ "Turn red by 90 degrees to the left and blue to the right": by as much, the other way."""
    if not isinstance(before, Clause) or not isinstance(clause, Clause) or before.word != clause.word:
        return clause
    by = [part for part in before.adjuncts if isinstance(part, Manner) and part.kind == "by"]
    side = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if clause.verb != "turn" or len(by) != 1 or not isinstance(side, At) or side.side not in ("left", "right"):
        return clause
    degrees = abs(float(by[0].value or 0.0)) * (1 if side.side == "left" else -1)
    return replace(clause, adjuncts=(replace(by[0], value=degrees, span=side.span),))


def _turns(clause: Meaning) -> tuple[Manner, ...]:
    """How several blocks are turned that are arranged by the same words, where nothing else is that it could be of."""
    if not isinstance(clause, Clause) or clause.negated or clause.mode not in ("command", "goal"):
        return ()
    several = isinstance(clause.theme, Coord) or (isinstance(clause.theme, Noun) and clause.theme.plural)
    lined = any(isinstance(part, Into) for part in clause.adjuncts) and clause.verb in ("place", "arrange", "be")
    arranged = lined or clause.verb == "stack" or (clause.verb == "arrange" and clause.lemma in _LINES)
    placed = any(isinstance(part, Loc) for part in clause.adjuncts)
    turns = tuple(part for part in clause.adjuncts if isinstance(part, Manner) and part.kind in TURNS)
    return turns if several and arranged and not placed else ()
