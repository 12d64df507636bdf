"""Places told by whose they are: "two per patch", "on its own colour", "(has) a blue neighbour"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.meaning import Loc, Noun, Pronoun, Traits

_OWN = tuple(
    f"{on} {its}{own}{color}"
    for on in ("on", "onto", "upon", "on top of")
    for its in ("its", "their", "a patch of its", "patches of their")
    for own in (" ", " own ")
    for color in ("color", "colors")
)
_AS_NEIGHBOR = tuple(
    f"{as_} {its}{next_}neighbor{s}"
    for as_ in ("as", "for")
    for its in ("", "a ", "its ", "their ")
    for next_ in ("", "direct ", "next door ")
    for s in ("", "s")
)
_NEIGHBOR = ("neighbor", "neighbors")


@choice
def whose(p: Parser, i: int) -> Results[Loc]:
    """On each patch, on the patch of a block's own colour, or next to a block."""
    if p.stands(i, ("per",)) and p.peek(i + 1, lexicon.PATCH) is False:
        each = Noun(head="patch", det="each", span=p.span(i, i + 2))
        yield Loc(rel="on", landmark=each, span=each.span), p.reach(i + 2)
    if (j := p.any_of(i, _OWN)) and p.peek(j, lexicon.BLOCK) is None:
        end = j + 1 if "patch" not in p.words[i:j] and p.lex(j, lexicon.PATCH) is not None else j
        patch = Noun(head="patch", det="its", traits=Traits(matching=True), span=p.span(i, end))
        yield Loc(rel="on", landmark=patch, span=patch.span), end
    if j := p.any_of(i, _AS_NEIGHBOR) or (p.one(i, _NEIGHBOR) if p.follows(i, lexicon.COLOR) else 0):
        it = Pronoun(word="it", span=p.span(i, j))
        yield Loc(rel="beside", landmark=it, span=it.span), j
