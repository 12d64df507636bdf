"""Predicates that are left out because they were said before: "... and the blue one is", "... but C yes"."""

from __future__ import annotations

from rpg.language.grammar.clauses.denied_of_all import denied_of_all
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, In, Loc, Manner, Meaning, Noun, Pronoun, Structure, That, replace

_SO = (
    "should not be", "must not be", "is not", "are not", "should be", "must be", "is", "are", "yes",
    *(f"{verb} {too}" for verb in ("is", "are", "does", "do", "should", "must") for too in ("too", "as well")),
)  # fmt: skip


def said_too(p: Parser, i: int, j: int, theme: Meaning, before: Clause) -> Results[Meaning]:
    """ "... or the green block is", "before the red one is": the same is said of something else."""
    if (k := p.any_of(j, _SO)) and before.verb in ("be", "place") and before.adjuncts:
        negated = "not" in p.words[j:k]
        kept = tuple(a for a in _affirmed(before) if not isinstance(a, Manner | That))
        told = replace(before, theme=theme, adjuncts=kept, negated=negated, span=p.span(i, k), cost=1)
        said = denied_of_all(p, j, told)
        for end in dict.fromkeys((p.any_of(k, (", but not both", "but not both", ", not both")) or k, k)):
            both = Manner(kind="xor", span=p.span(k, end))
            yield (replace(said, adjuncts=(*said.adjuncts, both)) if end > k else said), end


def _affirmed(before: Clause) -> tuple[Meaning, ...]:
    """The places of "A not on the mat", of which "but B is" says that B is there; of "next to it but not touching it"
    both are said again."""
    if any(isinstance(a, Loc | In) and not a.negated for a in before.adjuncts):
        return before.adjuncts
    return tuple(replace(a, negated=False) if isinstance(a, Loc | In) and a.negated else a for a in before.adjuncts)


_SO_ARE = (
    "not", "should be", "must be", "should", "must", "is", "are", "does", "do", "has to be", "have to be", "should not",
    "must not", "should not be", "must not be", "is not", "are not", "can be", "may be", "has to", "have to", "will be",
    "will", "shall", "does not", "do not", "may not", "can not", "shall not", "will not", "can not be", "may not be",
)  # fmt: skip
"""What stands for the whole predicate of the clause before: "... and the blue one should be"."""
_GONE = ("any more", "anymore", "any longer")


def meant_again(p: Parser, i: int, before: Clause) -> Results[Meaning]:
    """ "... and the blue one should be", "... all others may", closed by a comma: what was said before, of others."""
    done = before.mode == "goal" and (before.verb == "stack" or (before.verb == "place" and bool(before.adjuncts)))
    for theme, j in noun_phrase(p, i) if done or (before.verb == "be" and before.adjuncts) else ():
        k = p.any_of(p.opt(j, "all"), _SO_ARE)
        gone = p.any_of(k, _GONE) if k and p.follows(k, ("not",)) else 0
        if gone:
            past = Manner(kind="gone", span=p.span(k, gone))
            yield replace(before, theme=theme, negated=True, adjuncts=(*_affirmed(before), past), cost=1,
                          span=p.span(i, gone)), gone  # fmt: skip
        unbuilt = isinstance(theme, Structure) and p.words[k - 1] == "not"
        if k and not unbuilt and (p.opt(k, "too", "as") >= p.end or p.words[k] in (",", ";")):
            leave = p.words[k - 1] in ("may", "can") or p.words[k - 2] in ("may", "can")
            kept = tuple(a for a in _affirmed(before) if leave or not (isinstance(a, Manner) and a.kind == "allowed"))
            denied = p.words[k - 1] == "not" or p.words[k - 2] == "not"
            if leave and not denied and not before.negated and not any(map(_allowed, kept)):
                kept = (*kept, Manner(kind="allowed", span=p.span(j, k)))  # "red must be there, and blue may be"
            told = replace(before, theme=theme, negated=denied, adjuncts=kept, span=p.span(i, k), cost=1)
            yield denied_of_all(p, j, told), k


def _allowed(adjunct: Meaning) -> bool:
    return isinstance(adjunct, Manner) and adjunct.kind == "allowed"


def there_in_turn(before: Clause, link: str) -> bool:
    """ "First red goes on the mat, then (blue)": on a patch or in a part of the table, where both find room."""
    places = [x for x in before.adjuncts if not (isinstance(x, Manner) and x.kind == "time")]
    patch = [getattr(getattr(x, "landmark", None), "head", "") == "patch" for x in places if isinstance(x, Loc)]
    room = len(places) == 1 and (isinstance(places[0], In) or patch == [True])
    return link == "then" and room and not before.negated and before.verb in ("be", "place")


def in_its_turn(p: Parser, k: int, before: Clause, said: Clause) -> Clause | None:
    """What is said in its turn of a block of which no more is told than what it is; "on the green mat, then the blue
    one" may be a mat."""
    theme = said.theme
    block = isinstance(theme, Noun) and isinstance(before.theme, Noun) and theme.head != "patch"
    marks = [x.landmark.traits.colors for x in before.adjuncts if isinstance(x, Loc) and isinstance(x.landmark, Noun)]
    if any(marks) and isinstance(theme, Noun) and theme.head == "any":
        return None
    kept = tuple(x for x in said.adjuncts if not (isinstance(x, Manner) and x.kind == "time"))
    return replace(said, adjuncts=kept) if block and (k >= p.end or p.stands(k, (",", ";"))) else None


def but_that(p: Parser, j: int, before: Clause, item: Meaning) -> bool:
    """ "Nothing goes on the mat but the W, ...": what follows is what goes there, and no clause of its own."""
    nothing = isinstance(before.theme, Pronoun) and before.theme.word == "nothing" and not before.negated
    return nothing and p.words[j - 1] == "but" and not p.follows(j - 1, (",",))
