"""Facts that are told of the start by what stands beside them: what a mat is cleared of, what ends a sentence."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from rpg.language.meaning import (
    At,
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Quality,
    Structure,
    TableTop,
    Traits,
    Using,
    parts_of,
    replace,
)


def cleared_of(chains: tuple[Chain, ...], links: Sequence[str] | None = None) -> tuple[Chain, ...]:
    """ "Clear the mat. A red cube is on it.": the fact behind tells what it is cleared of, which is there at first.

    `links`: those of the sentences, where a fact must name the very patch, "a red cube is on the mat", in a sentence of
    its own, and not follow in time. "The mat is empty and a red cube is on it" tells of both in one way.
    """
    found, emptied = [], False
    patches: list[Traits] = []
    for n, chain in enumerate(chains):
        clauses: list[Meaning] = []
        before = emptied
        so = False
        for link, said in zip(chain.links, chain.clauses, strict=True):
            if not emptied:
                clauses.append(said)
                if _empties(said):
                    emptied, patches, so = True, _marks(said), isinstance(said, Clause) and said.mode == "goal"
                continue
            fact = isinstance(said, Clause) and said.lemma == "fact" and said.mode == "goal" and not said.negated
            on = isinstance(said, Clause) and bool(said.adjuncts) and all(map(_on_it, said.adjuncts))
            marks = _marks(said)
            named = link != "then" and bool(marks) and all(x in patches for x in marks)
            on = on and (links is None or (named and before and links[n] != "then"))
            begun_ = fact and on and not so
            clauses.append(replace(said, mode="start") if begun_ and isinstance(said, Clause) else said)
            patches += _marks(said) if _empties(said) else []
        found.append(replace(chain, clauses=tuple(clauses)) if emptied else chain)
    return tuple(found)


def _marks(said: Meaning) -> list[Traits]:
    """The looks of the patches that are named in a clause."""
    return [x.traits for x in parts_of(said) if isinstance(x, Noun) and x.head == "patch" and x.det == "the"]


def moved_from(clause: Clause) -> Clause:
    """ "Put the red block, which is on the mat, on the blue one": what is said aside of a block that is moved, or left
    where it is, is so before; and so it is of one that belongs on something else."""
    theme = clause.theme
    goes_on = wanted(clause) and not clause.negated and any(map(_on_it, clause.adjuncts))
    lies = isinstance(theme, Noun) and theme.det in ("the", "bare") and any(map(_on_it, theme.conditions))
    if clause.mode != "command" and not (goes_on and lies):
        return clause
    if isinstance(theme, Coord):
        return replace(clause, theme=replace(theme, items=tuple(as_begun(x) for x in theme.items)))
    return replace(clause, theme=as_begun(theme)) if isinstance(theme, Noun) and theme.conditions else clause


def as_begun(noun: Meaning) -> Meaning:
    """A phrase of which what is told aside is told of the start."""
    if not isinstance(noun, Noun) or not noun.conditions:
        return noun
    told = (
        replace(x, mods=tuple(m for m in x.mods if m not in ("asserted", "aside")))
        if isinstance(x, Loc) and "aside" in x.mods
        else x
        for x in noun.conditions
    )
    return replace(noun, conditions=tuple(told))


def wanted(clause: Clause) -> bool:
    """ "must lie in a heap", "ends on the mat": told of the end, where a fact or a bare phrase may be a start."""
    return clause.verb == "be" and clause.lemma != "fact" and clause.word is not None


def indicative(chain: Chain, text: str) -> bool:
    """Whether a sentence says how it is or is not: "the mat is free", "red is not on blue"; and not how it stays."""
    told = [c for c in chain.clauses if not (isinstance(c, Clause) and c.lemma == "tally")]
    return bool(told) and all(
        isinstance(c, Clause)
        and (c.lemma, c.mode) == ("fact", "goal")
        and not any(isinstance(a, Manner) and a.kind == "stay" for a in c.adjuncts)
        and _LASTING.search(text[slice(*c.span)]) is None
        for c in told
    )


_LASTING = re.compile(
    r"\b(?:never|always|ever|throughout|time|times|moves?|moved|stays?|remains?|keeps?)\b", re.IGNORECASE
)
"""Words of what goes on."""


def _on_it(place: Meaning) -> bool:
    return isinstance(place, Loc) and place.rel == "on" and not place.negated


def _empties(said: Meaning) -> bool:
    """Whether a clause asks for something to be taken away, or for a patch with nothing on it."""
    if not isinstance(said, Clause) or said.negated or said.mode == "start":
        return False
    bare = any(isinstance(a, Quality) and a.traits.empty for a in said.adjuncts)
    off = any(isinstance(a, Loc) and a.rel == "off" for a in said.adjuncts)
    none = getattr(said.theme, "det", "") == "no" or getattr(said.theme, "word", "") == "nothing"
    none = none and any(map(_on_it, said.adjuncts))
    return bare or off or none or said.verb == "remove"


AND = re.compile(r"\W*(?:and)?\W*", re.IGNORECASE)
"""What stands between facts that are told in one way."""


def all_begun(chain: Chain, text: str, alone: bool) -> Chain:
    """ "Red is on the mat and blue on the patch at the start": what begins or ends the sentence is said of both facts;
    and so is "blue starts on the patch", but for what a sentence that is `alone` wishes."""
    told = [c for c in chain.clauses if isinstance(c, Clause)]
    clauses = [c for c in told if c.lemma == "fact" and c.mode == "goal"]
    begun = sum(c.mode == "start" for c in told)
    if len(clauses) + begun < len(chain.clauses) or len(told) < 2 or {*chain.links} != {"and"}:
        return chain
    timed = any(isinstance(a, Manner) and a.kind == "time" for c in clauses for a in c.adjuncts)
    plain = all(AND.fullmatch(text[a.span[1] : b.span[0]]) for a, b in pairwise(told))
    if begun and clauses and (plain or not alone) and not (timed or any(c.negated for c in clauses)):
        return replace(chain, clauses=tuple(replace(c, mode="start") for c in told))
    if begun:
        return chain
    times = [[a.kind for a in c.adjuncts if isinstance(a, Manner) and a.kind in _TIMES] for c in clauses]
    ahead = "start" in times[0] and plain and _headed(clauses[0])
    if any(times[:-1][ahead:]) or "start" not in times[0 if ahead else -1]:
        return chain
    return replace(chain, clauses=tuple(replace(c, mode="start") for c in clauses))


def _headed(clause: Clause) -> bool:
    """ "At the start red is on the mat ...": words of time in front are said of all that follows."""
    theme = clause.theme
    return any(isinstance(a, Manner) and theme is not None and a.span < theme.span for a in clause.adjuncts)


_TIMES = ("start", "finally", "time")


_IS_SO = re.compile(r"\b(?:is|consists|reads)\b|:", re.IGNORECASE)
_WANTED = re.compile(
    r"\b(?:must|should|shall|has to|needs? to|will|can|want|end|finally|final|goal|target|then|after\w*)\b",
    re.IGNORECASE,
)


def lined_up_first(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "The tower is red, blue, white from bottom to top. Move the red block to the top.": so it is at the start, for
    the next sentence changes it."""
    for n, chain in enumerate(chains):
        line, order = chain.clauses[0], chains[n + 1].clauses[0] if n + 1 < len(chains) else None
        before = text[chains[n - 1].span[1] if n else 0 : chain.span[1]]
        if len(chain.clauses) > 1 or not isinstance(line, Clause) or line.mode != "goal":
            continue
        plain = _IS_SO.search(before) is not None and _WANTED.search(before) is None
        changed = _takes_out(chains[:n]) or (isinstance(order, Clause) and _moves_one(order, _listed_in(line)))
        if plain and changed and _listed_in(line):
            chains = (*chains[:n], replace(chain, clauses=(replace(line, mode="start"),)), *chains[n + 1 :])
    return chains


def named_there(chain: Chain) -> Chain:
    """ "Pull the C out of the row A, C, B": such a row is there."""
    for n, clause in enumerate(chain.clauses):
        source = clause.adjuncts[0] if isinstance(clause, Clause) and len(clause.adjuncts) == 1 else None
        whole = source.members if isinstance(source, Using) and source.lead == "out of" else None
        if not isinstance(clause, Clause) or not isinstance(source, Using) or not isinstance(whole, Structure):
            continue
        if whole.members is not None or whole.details:
            span = whole.span
            there = Clause(verb="exist", lemma="begun", theme=replace(whole, det="a"), mode="given", span=span)
            known = Structure(kind=whole.kind, det="the", span=span)
            taken = replace(clause, adjuncts=(replace(source, members=known),))
            clauses = (*chain.clauses[:n], there, taken, *chain.clauses[n + 1 :])
            return replace(chain, clauses=clauses, links=(*chain.links[: n + 1], "and", *chain.links[n + 1 :]))
    return chain


def _takes_out(chains: tuple[Chain, ...]) -> bool:
    """ "Pull the red block out of the tower and put it ...": the tower that is told of behind it is that."""
    return any(isinstance(x, Using) and x.lead == "out of" for chain in chains for x in parts_of(chain))


def _listed_in(line: Clause) -> list[Traits]:
    """The looks of the blocks in the order of "the tower", "the row"."""
    shape = line.theme if isinstance(line.theme, Structure) and line.verb in ("build", "part") else None
    if shape is None or shape.det != "the" or shape.plural:
        return []
    orders = [x for x in parts_of(line) if isinstance(x, OrderBy) and x.by == "named"]
    return [x.traits for x in orders[0].items if isinstance(x, Noun)] if len(orders) == 1 else []


def _moves_one(order: Clause, listed: list[Traits]) -> bool:
    """ "Move the red block to the top", "put A at the right end", "swap 1 and 3", said of those that are listed."""
    theme, at_ = order.theme, order.adjuncts
    if order.verb in ("swap", "reverse", "unstack", "replace") and order.mode == "command" and not order.negated:
        named = [x.traits for x in parts_of(theme) if isinstance(x, Noun)]
        looks = {look for x in listed for look in (*x.colors, *x.labels)}
        return not named or not all(looks.isdisjoint((*x.colors, *x.labels)) for x in named)
    one = isinstance(theme, Noun) and not theme.plural and listed.count(theme.traits) == 1
    ranked = isinstance(theme, Noun) and theme.det == "the" and not theme.plural and theme.traits.rank is not None
    one = one or (ranked and isinstance(theme, Noun) and theme.traits == Traits(rank=theme.traits.rank))
    if one and (order.mode, order.verb) == ("command", "pick") and not order.negated:
        return True
    told = (order.mode, order.verb) == ("command", "place") and not order.negated
    return one and told and len(at_) == 1 and (isinstance(at_[0], At | In) or _beside(at_[0], listed))


def _beside(place: Meaning, listed: list[Traits]) -> bool:
    """On a patch, the table or a block that is none of those listed."""
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" and not place.negated else None
    return isinstance(mark, TableTop) or (
        isinstance(mark, Noun) and (mark.head == "patch" or mark.traits not in listed)
    )


def start_first(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]] | None:
    """The sentences with what they say of the start in front: "Unstack the two, then stack them the other way round. At
    the start green is on yellow". None where that changes nothing."""
    told = [(n, c) for n, chain in enumerate(chains) for c in chain.clauses]
    starts = [isinstance(c, Clause) and c.mode == "start" for _, c in told]
    if True not in starts or starts == sorted(starts, reverse=True):
        return None
    front = tuple(
        Chain(clauses=(c,), links=("and",), span=c.span) for (_, c), begun in zip(told, starts, strict=True) if begun
    )
    left: list[tuple[str, Chain]] = []
    for link, chain in zip(links, chains, strict=True):
        pairs = [
            (joint, c)
            for joint, c in zip(chain.links, chain.clauses, strict=True)
            if not (isinstance(c, Clause) and c.mode == "start")
        ]
        if pairs:
            joints = ("and", *(joint for joint, _ in pairs[1:]))
            left.append((link, replace(chain, clauses=tuple(c for _, c in pairs), links=joints)))
    return [*("and" for _ in front), *(link for link, _ in left)], (*front, *(chain for _, chain in left))
