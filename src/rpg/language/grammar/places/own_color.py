"""The patch that has a block's own colour, told by the colour alone: "no cube stands on its own colour"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.meaning import Loc, Meaning, Noun, Traits

_OWN = tuple(
    f"{on} {its}{own}{color}"
    for on in ("on", "onto", "upon", "on top of")
    for its in ("its", "their", "a patch of its", "patches of their")
    for own in (" ", " own ")
    for color in ("color", "colors")
)


@choice
def on_its_color(p: Parser, i: int) -> Results[Meaning]:
    """ "on its own colour", "on their own colour patch"."""
    j = p.any_of(i, _OWN)
    if not j or p.peek(j, lexicon.BLOCK) is not None:
        return
    end = j + 1 if "patch" not in p.words[i:j] and p.lex(j, lexicon.PATCH) is not None else j
    patch = Noun(head="patch", det="its", traits=Traits(matching=True), span=p.span(i, end))
    yield Loc(rel="on", landmark=patch, span=p.span(i, end)), end
