"""Whether what is left over is spoken of, so that the blocks spoken of before are to be told apart from it."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Chain, In, Meaning, Noun, Pronoun, Structure, Traits
from rpg.passes.schema.resolve.places.different_corners import CORNERS


def speaks_of_rest(parts: Sequence[Meaning]) -> bool:
    """ "the others", "the rest"; "the third one" beside "two of them"."""
    nouns = [x for x in parts if isinstance(x, Noun)]
    counted = {x.amount.low for x in nouns if x.amount is not None and (x.part_of is not None or _so_many(x))}
    counted |= {len(CORNERS) for x in parts if isinstance(x, In) and x.region.startswith("each_corner")}
    ranks = {x.traits.rank for x in nouns if x.traits == Traits(rank=x.traits.rank) and x.head == "any"}
    last = bool(counted) and "last" in ranks and not any(isinstance(x, Structure) for x in parts)
    return last or any(map(_rest, parts)) or any(str(many + 1) in ranks for many in counted)


def _so_many(noun: Noun) -> bool:
    """ "(Three red blocks.) Two (go there)"."""
    return noun.head == "any" and noun.traits == Traits() and noun.det in ("bare", "some")


def _rest(part: Meaning) -> bool:
    """ "the others", "the rest", "another red block": what is left when some are spoken of."""
    if isinstance(part, Noun):
        return part.det in ("other", "another")
    return (
        isinstance(part, Pronoun)
        and ("other" in part.word or "rest" in part.word or "remain" in part.word)
        and part.word not in ("each other", "one another")
    )


_SELECTING = ("all", "each")


def listed_alone(chains: tuple[Chain, ...]) -> bool:
    """ "Two red blocks, a green one. ...": a sentence that lists and does nothing else says what there is."""
    lists = [[getattr(c, "lemma", "") == "tally" for c in chain.clauses] for chain in chains]
    return len(lists) > 1 and any(map(all, lists)) and all(all(x) or not any(x) for x in lists)


def selects(part: Meaning, alone: bool) -> bool:
    """ "All the red ones", "none of the red ones": of what there is, with others that are not meant. `alone`: what
    there is is said in a sentence of its own, so that "the red one" is one of that, too."""
    whole = part.part_of if isinstance(part, Noun) and part.det == "no" else part
    among = (*_SELECTING, "the") if alone else _SELECTING
    marks = whole.traits if isinstance(whole, Noun) and (whole is not part or whole.det in among) else Traits()
    return bool(marks.colors or marks.kind or marks.quality or marks.size or marks.edge) and not marks.labels
