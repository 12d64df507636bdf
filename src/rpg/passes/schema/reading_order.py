"""In which order sentences are read: what there is first, wherever it is told, and what is said of all last."""

from __future__ import annotations

from collections.abc import Collection

from rpg.language.grammar.clauses.heights_bounded import BOUNDED
from rpg.language.meaning import (
    Chain,
    Clause,
    Coord,
    In,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    Size,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.between_two import of_a_line
from rpg.passes.schema.resolve.clauses.moved_alone import moved_alone
from rpg.passes.schema.resolve.places.mutual import WHATEVER
from rpg.passes.schema.resolve.things.spare import definite, leaves_out
from rpg.passes.schema.resolve.things.world import refuse


def as_they_are_read(chains: tuple[Chain, ...], late: Collection[int]) -> list[int]:
    """The places of the sentences in the text, in the order in which they are read."""

    def first(n: int) -> tuple[bool, bool, bool, int]:
        later = not _sets_scene(chains[n]) or _told_besides(n, chains)
        return n in late, later, not _counts_each(chains[n]), n

    return sorted(range(len(chains)), key=first)


def stock_apart(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """ "Red is on a blue block. There are two blue blocks, and green is next to red.": what there is as a sentence of
    its own where blocks like these were spoken of before, for it counts those as well."""
    found: list[tuple[str, Chain]] = []
    for n, chain in enumerate(chains):
        first, *rest = chain.clauses
        if n == 0 or not rest or links[n] != "and" or not _counts_again(first, chains[:n]):
            found.append((links[n], chain))
            continue
        if any(isinstance(part, Pronoun) and part.word in _POINTING for part in parts_of(tuple(rest))):
            raise refuse("ambiguous", "it is not clear whether such a block that was spoken of before is one of these",
                         first.span, "say first how many blocks there are")  # fmt: skip
        found.append(("and", replace(chain, clauses=(first,), links=chain.links[:1])))
        found.append((chain.links[1], replace(chain, clauses=tuple(rest), links=("and", *chain.links[2:]))))
    return [link for link, _ in found], tuple(chain for _, chain in found)


def _counts_again(first: Meaning, before: tuple[Chain, ...]) -> bool:
    """Whether a clause says how many there are of a look that some block without a number was said to have."""
    there = isinstance(first, Clause) and first.verb == "exist" and _brings_up(first) and not first.adjuncts
    theme = first.theme if there and isinstance(first, Clause) else None
    if not isinstance(theme, Noun) or theme.det != "bare" or theme.amount is None or theme.part_of:
        return False
    some = (part for chain in before for part in parts_of(chain) if isinstance(part, Noun))
    return any(part.det in ("a", "any", "no") and part.traits == theme.traits and part.head == theme.head
               for part in some)  # fmt: skip


def _told_besides(at: int, chains: tuple[Chain, ...]) -> bool:
    """ "There is a red block. Put it on the mat. There is also a blue block": blocks of which nothing was said before,
    behind "it" or "them", which were said of those that were there by then."""
    before = [chain for chain in chains[:at] if not _sets_scene(chain)]
    if not before or not any(map(_sets_scene, chains[: chains.index(before[0])])):
        return False
    parts = [part for chain in before for part in parts_of(chain)]
    pointed = any(isinstance(part, Pronoun) and part.word in _POINTING for part in parts)
    told = {look for part in parts if isinstance(part, Noun) for look in (*part.traits.colors, *part.traits.labels)}
    clauses = [clause for clause in chains[at].clauses if isinstance(clause, Clause)]
    return pointed and all(clause.verb == "exist" and _anew(clause.theme, told) for clause in clauses)


def _anew(theme: Meaning | None, told: set[str]) -> bool:
    """Whether these are blocks that are brought up, none of them of a look that was told."""
    if isinstance(theme, Coord):
        return all(_anew(item, told) for item in theme.items)
    if not isinstance(theme, Noun) or theme.det not in ("a", "bare") or theme.part_of is not None:
        return False
    looks = (*theme.traits.colors, *theme.traits.labels)
    return bool(looks) and told.isdisjoint(looks)


_POINTING = frozenset({"it", "them", "they", "these", "those", "both", "both of them", "all of them", "each of them"})


def _counts_each(chain: Chain) -> bool:
    """ "Two blocks of each": as many of every look that is listed, before or behind."""
    clauses = [clause for clause in chain.clauses if isinstance(clause, Clause) and clause.theme is None]
    sizes = [part for clause in clauses for part in clause.adjuncts]
    return bool(sizes) and all(isinstance(x, Size) and x.what == "each" for x in sizes)


def _sets_scene(chain: Chain) -> bool:
    """Whether a sentence only says what there is or how it starts: it is read first."""
    return all(leaves_out(c) or (isinstance(c, Clause) and _brings_up(c)) for c in chain.clauses)


def _brings_up(clause: Clause) -> bool:
    """What there is; or "two blue blocks lie around": blocks that come into the task by this."""
    extra = any(isinstance(m, Manner) and m.kind == "extra" for m in clause.adjuncts)
    told = clause.mode == "given" and not of_a_line(clause)
    return told or (extra and clause.theme is not None and not definite(clause.theme))


THEM = frozenset(
    {"them", "they", "these", "those", "everything", "all", "all of them", "each of them", "the others", "the rest"}
)


def of_everything(chain: Chain, pointed: bool) -> bool:
    """ "All blocks are 5 cm wide": what all look like can only be said of those that the other sentences bring up."""
    if all(isinstance(clause, Clause) and _of_no_block(clause) for clause in chain.clauses):
        return True
    if not pointed and all(isinstance(clause, Clause) and _begins_with_all(clause) for clause in chain.clauses):
        return True
    if not pointed and all(moved_alone(clause) is not None for clause in chain.clauses):
        return True
    return all(
        isinstance(clause, Clause)
        and clause.verb == "be"
        and isinstance(clause.theme, Noun)
        and clause.theme.head == "block"
        and (clause.theme.det in ("all", "each") or (clause.theme.det == "the" and _sizes(clause)))
        and (clause.theme.traits, clause.theme.part_of) == (Traits(), None)
        and (clause.theme.amount is None or clause.theme.det == "all")
        and bool(clause.adjuncts)
        and all(isinstance(adjunct, Quality) for adjunct in clause.adjuncts)
        for clause in chain.clauses
    )


def _sizes(clause: Clause) -> bool:
    """ "The cubes are 5 cm wide"."""
    plural = isinstance(clause.theme, Noun) and clause.theme.plural
    marks = [a.traits for a in clause.adjuncts if isinstance(a, Quality)]
    return plural and all(x == Traits(edge=x.edge, size=x.size) for x in marks)


def _of_no_block(clause: Clause) -> bool:
    """ "No block is in the middle of the table", "the right half stays empty": whichever blocks there are."""
    theme = clause.theme
    if clause.verb == BOUNDED:
        return True  # "no stack may be higher than two"
    if clause.adjuncts and all(getattr(getattr(x, "landmark", None), "word", "") in WHATEVER for x in clause.adjuncts):
        return True
    if isinstance(theme, Noun) and theme.det == "no" and theme.amount and not (theme.part_of or theme.traits.colors):
        return True  # "no two letters may touch"
    none = isinstance(theme, Noun) and theme.head == "block" and theme.det == "no" and theme.traits == Traits()
    return none and {type(part) for part in clause.adjuncts} in ({In}, {In, Manner})


def _begins_with_all(clause: Clause) -> bool:
    """ "The blocks start in a heap": those that the other sentences bring up."""
    theme = clause.theme
    if clause.mode != "start" or not isinstance(theme, Noun) or theme.head != "block" or not theme.plural:
        return False
    plain = (theme.traits, theme.part_of) == (Traits(), None)
    named = (part.traits for part in parts_of(clause.adjuncts) if isinstance(part, Noun))
    plain = plain and not any(traits.colors or traits.labels for traits in named)
    return plain and (theme.det == "all" or (theme.det == "the" and theme.amount is None))
