""" "Two towers of equal height out of seven blocks, the leftover one on the mat": as high as they can be, so that some
are left."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Manner, Meaning, Noun, Size, Structure, Using, parts_of, replace

_LEAST = 2


def left_over(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with the size of equal structures that leave some of the blocks, where these are spoken of."""
    nouns = [part for chain in chains for part in parts_of(chain) if isinstance(part, Noun)]
    others = {noun.plural for noun in nouns if noun.det == "other" and noun.head != "patch"}
    if len(others) != 1:
        return chains
    several = others.pop()
    return tuple(replace(chain, clauses=tuple(_sized(said, several) for said in chain.clauses)) for chain in chains)


def _sized(said: Meaning, several: bool) -> Meaning:
    """A clause that builds equal structures of more blocks than they can share, with so many for each."""
    shape = said.theme if isinstance(said, Clause) else None
    if not isinstance(said, Clause) or not isinstance(shape, Structure) or shape.amount is None or shape.sizes:
        return said
    equal = [a for a in (*said.adjuncts, *shape.details) if isinstance(a, Manner) and a.kind == "equal"]
    used = [a.members for a in said.adjuncts if isinstance(a, Using)]
    stock = used[0] if len(used) == 1 else None
    if not equal or not isinstance(stock, Noun) or stock.amount is None or stock.det != "bare" or shape.members:
        return said
    each, left = divmod(stock.amount.low, shape.amount.low)
    if each < _LEAST or left == 0 or (left > 1) != several:
        return said
    sizes = (Size(what="size", amount=Amount(each, each), span=shape.span),)
    kept, details = (tuple(a for a in part if a not in equal) for part in (said.adjuncts, shape.details))
    return replace(said, theme=replace(shape, sizes=sizes, details=details), adjuncts=kept)
