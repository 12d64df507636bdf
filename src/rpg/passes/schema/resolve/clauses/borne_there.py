""" "There is a red patch with a blue block and a yellow block with a green one on it": what lies on what at first."""

from __future__ import annotations

import re

from rpg.language.meaning import Absolute, Chain, Clause, Coord, Loc, Meaning, Noun, Pronoun, replace
from rpg.passes.schema.resolve.things.world import refuse


def borne_there(chain: Chain, text: str) -> Chain:
    """The sentence with such things as "a blue block on a red patch"."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        given = isinstance(said, Clause) and said.verb == "exist" and said.mode == "given" and not said.negated
        told = (_on_it(said) or _with_blocks(said, text)) if given and isinstance(said, Clause) else ()
        clauses += told or (said,)
        links += [link, *("and" for _ in told[1:])]
    return replace(chain, clauses=tuple(clauses), links=tuple(links)) if clauses != [*chain.clauses] else chain


def _on_it(said: Clause) -> tuple[Clause, ...]:
    """ "(And) a patch with a green block on it"."""
    *others, owner = said.theme.items if isinstance(said.theme, Coord) and said.theme.op == "and" else (said.theme,)
    borne = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    single = isinstance(owner, Noun) and owner.det == "a" and not owner.plural
    place = borne.adjuncts[0] if single and isinstance(borne, Absolute) and len(borne.adjuncts) == 1 else None
    if not isinstance(place, Loc) or not isinstance(borne, Absolute) or place.rel != "on" or place.negated:
        return ()
    if not isinstance(place.landmark, Pronoun) or place.landmark.word != "it":
        return ()
    there = replace(said, theme=borne.theme, adjuncts=(replace(place, landmark=owner),))
    return (*(replace(said, theme=other, adjuncts=()) for other in others), there)


def _with_blocks(said: Clause, text: str) -> tuple[Clause, ...]:
    """ "A red patch with a blue block and a blue patch with a red block".

    Raises:
        Refusal: further blocks are listed behind one that a patch has.
    """
    items = said.theme.items if isinstance(said.theme, Coord) and said.theme.op == "and" else ()
    if said.adjuncts or not any(map(_is_patch, items)) or not _ENDS.match(text, items[-1].span[1]):
        return ()
    found: list[Clause] = []
    n = 0
    while n < len(items):
        patch, block = items[n], items[n + 1] if n + 1 < len(items) else None
        has = _is_patch(patch) and block is not None and text[patch.span[1] : block.span[0]].split()[:1] == ["with"]
        if not has or not isinstance(block, Noun) or block.det != "a":
            found.append(replace(said, theme=patch))
            n += 1
            continue
        if n + 2 < len(items) and not _is_patch(items[n + 2]):
            raise refuse("ambiguous", "which of these blocks are on the patch?", said.span,
                         "say 'with a blue block on it', and what else there is in a sentence of its own")  # fmt: skip
        on = Loc(rel="on", landmark=patch, span=block.span)
        found.append(replace(said, theme=block, adjuncts=(on,)))
        n += 2
    return tuple(found) if any(x.adjuncts for x in found) else ()


_ENDS = re.compile(r"\s*(?:[.,;:!?]|and\b|$)")
"""What follows a list behind which it is not told where its blocks are: "with a red and a blue block around it"."""


def _is_patch(item: Meaning) -> bool:
    return isinstance(item, Noun) and item.head == "patch" and item.det == "a" and not item.plural
