"""How large the blocks are, said of all of them at once: "use 5 cm cubes", "with small blocks, ..."."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Meaning, Noun, Structure, Traits, Using, replace
from rpg.passes.schema.resolve.things.world import Scene, refuse

SIZE = "size"
"""The lemma of a clause that says nothing but how large the blocks are."""


def sized(links: list[str], chains: tuple[Chain, ...], scene: Scene) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences without what is said of the size of all blocks, which goes to the scene."""
    found: list[tuple[str, Chain]] = []
    for link, chain in zip(links, chains, strict=True):
        kept = [(joint, _stripped(c, scene)) for joint, c in zip(chain.links, chain.clauses, strict=True)]
        left = [(joint, c) for joint, c in kept if not (isinstance(c, Clause) and c.lemma == SIZE)]
        for joint, clause in kept:
            if (joint, clause) not in left and isinstance(clause, Clause) and isinstance(clause.theme, Noun):
                _tell(clause.theme, scene)
        if left:
            found.append((link, replace(chain, clauses=tuple(c for _, c in left), links=tuple(x for x, _ in left))))
    return [link for link, _ in found], tuple(chain for _, chain in found)


def _stripped(clause: Meaning, scene: Scene) -> Meaning:
    """A clause that names its blocks, without the size of the blocks to be used."""
    if not isinstance(clause, Clause) or clause.theme is None or clause.lemma == SIZE:
        return clause
    theme = clause.theme
    if isinstance(theme, Structure) and theme.members is None and theme.letter is None:
        return clause
    kept = []
    for part in clause.adjuncts:
        if isinstance(part, Using) and isinstance(part.members, Noun) and of_size(part.members):
            _tell(part.members, scene)
        else:
            kept.append(part)
    return replace(clause, adjuncts=tuple(kept)) if len(kept) < len(clause.adjuncts) else clause


def of_size(noun: Noun) -> bool:
    """ "5 cm cubes", "small blocks": of so many as there are, and nothing else is said of them."""
    marks = noun.traits
    plain = noun.head == "block" and noun.plural and noun.amount is None and noun.det in ("bare", "all", "the")
    plain = plain and noun.part_of is None and not noun.conditions
    return plain and bool(marks.edge or marks.size) and marks == Traits(edge=marks.edge, size=marks.size)


def _tell(noun: Noun, scene: Scene) -> None:
    if scene.sized is not None:
        raise refuse("contradiction", "the size of all blocks is said twice", noun.span, "say it once")
    scene.sized = (noun.traits, noun.span)


def size_all(scene: Scene) -> None:
    """Give every block whose size is not said the one that is said of all."""
    if scene.sized is None:
        return
    marks, span = scene.sized
    open_ = [t for t in scene.blocks() if t.edge is None and t.size is None]
    told = [t for t in scene.blocks() if t not in open_]
    if told or not open_:
        raise refuse("contradiction", "the size of all blocks is said, and another one of some", span,
                     "say it of each of them, or of all")  # fmt: skip
    for thing in open_:
        thing.edge, thing.size = marks.edge, marks.size
