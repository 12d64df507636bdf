"""A structure that is brought up where one of its parts is named is built: "on each end block of a row of three"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import (
    Absolute,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    PartOf,
    Structure,
    Traits,
    parts_of,
)
from rpg.language.meaning import replace as changed

_OPEN = ("a", "bare")
_LINES = ("row", "line", "column")


def built_for_a_part(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with a clause that builds such a structure ahead of the clause that speaks of its part."""
    told = [part.kind for chain in chains for part in parts_of(chain) if isinstance(part, Structure)]
    return tuple(
        _built(chain, told) if any(_brought_up(part, told) for part in parts_of(chain)) else chain for chain in chains
    )


def _built(chain: Chain, told: Sequence[str]) -> Chain:
    clauses: list[Meaning] = []
    links: list[str] = []
    there: set[Structure] = set()
    for link, said in zip(chain.links, chain.clauses, strict=True):
        wholes = list(dict.fromkeys(x for part in parts_of(said) if (x := _brought_up(part, told)) is not None))
        wholes = [whole for whole in wholes if whole not in there]  # "its middle has red on it and blue behind it"
        there.update(wholes)
        if len(wholes) == 1 and isinstance(said, Clause) and said.mode in ("command", "goal") and said.verb != "build":
            built = changed(wholes[0], det="a")
            clauses.append(Clause(verb="build", theme=built, mode="goal", span=built.span))
            links += [link, "and"]
            adjuncts = tuple(_known(part, told) for part in said.adjuncts)
            clauses.append(changed(said, theme=_known(said.theme, told), adjuncts=adjuncts))
        else:
            clauses.append(said)
            links.append(link)
    return changed(chain, clauses=tuple(clauses), links=tuple(links))


def _brought_up(part: Meaning, told: Sequence[str]) -> Structure | None:
    """The structure of which this is a part, if it is told here for the first time; `told`: the kinds of all structures
    that are spoken of, of which "the row" is one only if there is another."""
    whole = part.part_of if isinstance(part, Noun) else part.whole if isinstance(part, PartOf) else None
    new = isinstance(whole, Structure) and whole.det in _OPEN and not whole.plural
    if isinstance(part, PartOf) and isinstance(whole, Structure) and whole.det == "the" and not whole.plural:
        new = part.part == "blocks" and whole.kind in _LINES and told.count(whole.kind) == 1
    if isinstance(part, PartOf) and part.part != "blocks":
        new = new and part.part == "middle" and isinstance(whole, Structure) and whole.kind in _LINES
    return whole if new and isinstance(whole, Structure) and (whole.members or whole.sizes or whole.dims) else None


def _known(said: Meaning | None, told: Sequence[str]) -> Meaning | None:
    """What is said of a part, of the structure that is built by now."""
    match said:
        case Loc():
            return changed(said, landmark=_known(said.landmark, told), second=_known(said.second, told))
        case Coord():
            return changed(said, items=tuple(_known(item, told) for item in said.items))
        case Absolute():
            adjuncts = tuple(_known(part, told) for part in said.adjuncts)
            return changed(said, theme=_known(said.theme, told), adjuncts=adjuncts)
        case Noun() if _brought_up(said, told):
            return changed(said, part_of=None)
        case Noun() if said.part_of is not None:
            return changed(said, part_of=_known(said.part_of, told))
        case PartOf(part="middle") if _brought_up(said, told):
            return Noun(head="any", det="the", traits=Traits(rank="middle"), span=said.span)
        case PartOf() if _brought_up(said, told):
            return changed(said, whole=None)
    return said
