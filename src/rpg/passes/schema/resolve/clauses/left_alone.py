"""What is not touched meanwhile: "without touching blue", "leaving it where it is"."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Loc, Manner, Meaning, Noun, Pronoun, That, Traits, replace


def left_alone(clause: Clause) -> Clause:
    """The clause, with what stands beside it told plainly."""
    told = not_elsewhere(clause) if clause.negated else clause
    return apart_from(_in_place(_not_moved(_only_moved(_nothing_else(told)))))


def not_elsewhere(clause: Clause) -> Clause:
    """ "Do not move it elsewhere", where it is denied: it stays where it is, and is not just kept from going far."""
    if clause.verb != "place" or clause.lemma not in _MOVING:
        return clause
    rest = tuple(p for p in clause.adjuncts if not (isinstance(p, Loc) and p.rel == "moved" and "else" in p.mods))
    return replace(clause, adjuncts=rest)


def _nothing_else(clause: Clause) -> Clause:
    """ "Touch nothing else", "do not move anything else": the others stay where they are."""
    word = clause.theme.word if isinstance(clause.theme, Pronoun) else ""
    touched = clause.verb == "touch" or (clause.verb == "place" and clause.lemma == "move")
    if clause.mode != "command" or not touched or clause.adjuncts or clause.theme is None:
        return clause
    if (word, clause.negated) not in (("nothing else", False), ("anything else", True)):
        return clause
    others = Pronoun(word="all the others", span=clause.theme.span)
    stay = Manner(kind="stay", span=clause.span)
    return replace(clause, verb="keep", lemma="leave", theme=others, adjuncts=(stay,), negated=False)


def _only_moved(clause: Clause) -> Clause:
    """ "Only red should be moved to the mat", as "move only red": no other block is."""
    theme = clause.theme
    passive = clause.mode == "goal" and clause.verb == "place" and clause.lemma in _MOVING and not clause.negated
    if not passive or not isinstance(theme, Coord) or theme.op != "only" or not clause.adjuncts:
        return clause
    only = Manner(kind="only", span=theme.span)
    return replace(clause, mode="command", theme=theme.items[0], adjuncts=(*clause.adjuncts, only))


_MOVING = ("move", "take", "bring", "carry", "transfer", "relocate", "shift")


def _not_moved(clause: Clause) -> Clause:
    """ "Put red on blue, leaving it where it is": without moving it, for what is put somewhere does not stay."""
    if clause.negated or clause.verb not in ("be", "place", "stack"):
        return clause
    return replace(clause, adjuncts=tuple(_without_moving(part) for part in clause.adjuncts))


def _in_place(clause: Clause) -> Clause:
    """ "Turn the E upside down where it is": without moving it."""
    stays = [a for a in clause.adjuncts if isinstance(a, Manner) and a.kind == "stay"]
    if clause.verb != "turn" or clause.negated or len(stays) != 1 or len(clause.adjuncts) == 1 or clause.theme is None:
        return clause
    at = stays[0].span
    whole = Pronoun(word="them" if getattr(clause.theme, "plural", isinstance(clause.theme, Coord)) else "it", span=at)
    moves = Clause(verb="place", lemma="move", theme=whole, mode="command", span=at)
    still = That(kind="without", clauses=Chain(clauses=(moves,), links=("and",), span=at), span=at)
    return replace(clause, adjuncts=(*(a for a in clause.adjuncts if a is not stays[0]), still))


def _without_moving(part: Meaning) -> Meaning:
    inside = part.clauses if isinstance(part, That) and part.kind == "while" else None
    told = inside.clauses[0] if isinstance(inside, Chain) and len(inside.clauses) == 1 else None
    if not isinstance(told, Clause) or told.verb != "keep" or not isinstance(told.theme, Pronoun) or told.negated:
        return part
    stays = [a for a in told.adjuncts if isinstance(a, Manner) and a.kind == "stay"]
    if told.theme.word != "it" or not stays or not all(isinstance(a, Manner) for a in told.adjuncts):
        return part
    rest = tuple(a for a in told.adjuncts if a not in stays)
    moves = replace(told, verb="place", lemma="move", adjuncts=rest)
    chain = Chain(clauses=(moves,), links=("and",), span=part.span)
    return That(kind="without", clauses=chain, span=part.span)


def apart_from(clause: Clause) -> Clause:
    """ "Red is on the mat without touching blue": how it is to be, where of a command it says what not to touch."""
    if clause.verb != "be" or clause.mode != "goal" or clause.negated:
        return clause
    marks = [x.landmark for x in clause.adjuncts if isinstance(x, Loc) and x.rel == "on" and not x.negated]
    below = [mark.traits for mark in marks if isinstance(mark, Noun)]
    return replace(clause, adjuncts=tuple(_no_contact(part, below) for part in clause.adjuncts))


def _no_contact(part: Meaning, below: list[Traits]) -> Meaning:
    inside = part.clauses if isinstance(part, That) and part.kind == "without" else None
    told = inside.clauses[0] if isinstance(inside, Chain) and len(inside.clauses) == 1 else None
    if not isinstance(told, Clause) or told.lemma != "touch" or told.theme is None or told.adjuncts:
        return part
    if isinstance(told.theme, Noun) and told.theme.traits in below:
        return part  # what a block lies on is touched by it: this tells whoever puts it there
    return Loc(rel="touching", landmark=told.theme, negated=True, span=part.span)
