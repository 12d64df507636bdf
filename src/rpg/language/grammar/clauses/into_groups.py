"""Who forms which group: "the letters form one group, the digits another"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Amount, Chain, Clause, Coord, Into, Meaning, Noun, Pronoun, Structure, That

GROUPS = ("group", "bunch", "cluster", "pile", "heap", "clump")
_MUST = ("", "should ", "must ", "shall ", "are to ", "have to ", "will ")
_FORM = (
    *(f"{must}{form}" for must in _MUST for form in ("form", "make", "make up", "build", "constitute")),
    "forms",
    "makes",
    "to form",
    "forming",
)
_ONE = tuple(f"{one} {group}" for one in ("one", "a", "the first") for group in GROUPS)
_ANOTHER = (
    *(f"{other} {group}" for other in ("another", "the other", "a second", "the second", "a further", "the first")
      for group in (*GROUPS, "one")),
    "another", "the other", "a second", "the second", "one more",
)  # fmt: skip
_AND = (", and", ", while", ", whereas", ", but", "and", "while", "whereas", ",", ";")
_SAID = frozenset(GROUPS)


@rule
def into_groups(p: Parser, i: int, mode: str) -> Results[Clause]:
    """One statement: both groups are formed."""
    if not p.rarely(_SAID):
        return
    for theme, j in noun_phrase(p, i):
        one = p.any_of(p.any_of(j, _FORM), _ONE) if p.any_of(j, _FORM) and _blocks(theme) else 0
        joint = p.any_of(one, _AND) if one else 0
        for other, k in noun_phrase(p, joint) if joint else ():
            end = p.any_of(p.any_of(k, _FORM) or k, _ANOTHER) if _blocks(other) else 0
            if end:
                second = Clause(verb="be", theme=other, adjuncts=(in_a_pile(p.span(k, end), "another"),), mode=mode,
                                span=p.span(joint, end))  # fmt: skip
                also = That(kind="so", clauses=Chain(clauses=(second,), links=("and",), span=second.span),
                            span=second.span)  # fmt: skip
                said = (in_a_pile(p.span(j, one), "bare"), also)
                yield Clause(verb="be", theme=theme, adjuncts=said, mode=mode, span=p.span(i, end)), end


def in_a_pile(span: Span, det: str) -> Into:
    return Into(structure=Structure(kind="pile", det=det, amount=Amount(1, 1), span=span), span=span)


def _blocks(theme: Meaning) -> bool:
    items = theme.items if isinstance(theme, Coord) else (theme,)
    return all((isinstance(x, Noun) and x.head != "patch") or isinstance(x, Pronoun) for x in items)
