"""How what is told is joined to what is asked for behind it: "also", "make sure", of the same block."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from rpg.language.meaning import (
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    TableTop,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.begun_facts import AND

BESIDES = re.compile(r"\b(?:also|too|as well|both|in addition|additionally)\b", re.IGNORECASE)
_DEMANDED = re.compile(
    r"\b(?:make|ensure|see to it|reach|achieve|get|until|goal|task|aim|want|like|wish|please|must|should|shall|has to|"
    r"have to|needs? to|ought|let|can|could)\b",
    re.IGNORECASE,
)
_TITLED = re.compile(r"\b(?!(?:the|my|our|your|this|next|for|with)\b)\w+ task *[:.!]", re.IGNORECASE)
"""A title, "swap task:", asks for nothing."""
_KNOWN = re.compile(r"\b(?:sees?(?! to it)|look|imagine|know|note|assume|suppose|say|given)\b", re.IGNORECASE)


def added(before: Chain, after: Chain, text: str) -> bool:
    """ "... Also put green on the mat", "Put green there as well": of other blocks than were spoken of before."""
    fact, order = before.clauses[-1], after.clauses[0]
    told = [c for c in before.clauses if isinstance(c, Clause)]
    if not isinstance(fact, Clause) or not isinstance(order, Clause) or any(same_one(c, order) for c in told):
        return False
    said = text[before.span[1] : order.span[1]] + re.split(r"[,.;!?]", text[order.span[1] :])[0]
    return BESIDES.search(said.replace("both", "")) is not None


def orders_something(chain: Chain) -> bool:
    """Whether a sentence orders something to be done."""
    said = [c for c in chain.clauses if isinstance(c, Clause) and not c.negated]
    return any(c.mode == "command" or (c.mode, c.verb) == ("goal", "exist") for c in said)


def staying(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "(Red is on the green mat, blue on the white one.) Move the red block onto the white mat as well.": what is said
    to be there stays there."""
    found = list(chains)
    for n, chain in enumerate(chains[1:], 1):
        order = chain.clauses[-1]
        said = text[chain.span[0] : chain.span[1]] + re.split(r"[,.;!?]", text[chain.span[1] :])[0]
        too = isinstance(order, Clause) and order.mode == "command" and BESIDES.search(said.replace("both", ""))
        told = [c for before in chains[:n] for c in before.clauses if isinstance(c, Clause)]
        if not too or not isinstance(order, Clause) or not any(same_one(c, order) for c in told):
            continue
        stay = [c for c in told if not c.negated and not same_one(c, order) and _same_place(c, order)]
        kept = tuple(_as_it_is(c) for c in stay if isinstance(c.theme, Noun))
        found[n] = replace(chain, clauses=(*chain.clauses, *kept), links=(*chain.links, *("and" for _ in kept)))
    return tuple(found)


def by_itself(chains: tuple[Chain, ...], ordered: int) -> tuple[Chain, ...]:
    """ "(The red block is on the blue one.) The green block stands alone. Put ...": on the table, where such a thing is
    told beside others before an order (the sentence `ordered`)."""
    had: list[Clause] = []
    found = list(chains)
    for n, chain in enumerate(chains[:ordered]):
        clauses: list[Meaning] = []
        for said in chain.clauses:
            alone = isinstance(said, Clause) and had and _alone(said) and not any(same_one(c, said) for c in had)
            clauses.append(_on_table(said) if alone and isinstance(said, Clause) else said)
            had += [said] if isinstance(said, Clause) and not said.negated else []
        found[n] = replace(chain, clauses=tuple(clauses))
    return tuple(found)


def _on_table(said: Clause) -> Clause:
    place = Loc(rel="on", landmark=TableTop(span=said.span), span=said.span)
    return replace(said, lemma="fact", adjuncts=(place,))


def _alone(said: Clause) -> bool:
    """ "is alone", "is free", "is by itself", "is somewhere else on the table"."""
    block = isinstance(said.theme, Noun) and said.theme.head != "patch"
    places = [a for a in said.adjuncts if not (isinstance(a, Loc) and isinstance(a.landmark, TableTop))]
    if said.lemma not in ("fact", "") or said.mode != "goal" or said.negated or not block or len(places) != 1:
        return False
    match places[0]:
        case Manner(kind="alone") | Loc(rel="moved", mods=("else", *_)):
            return said.verb == "be"
        case Loc(rel="beside", landmark=Pronoun(word="itself")):
            return said.verb == "be"
        case Quality(traits=traits, negated=False):
            return traits == Traits(empty=True)
    return False


def _same_place(fact: Clause, order: Clause) -> bool:
    marks = [
        (a.rel, a.landmark.head, a.landmark.traits)
        for clause in (fact, order)
        for a in clause.adjuncts
        if isinstance(a, Loc) and isinstance(a.landmark, Noun)
    ]
    return len(marks) == 2 and marks[0] == marks[1]


def _as_it_is(fact: Clause) -> Clause:
    assert isinstance(fact.theme, Noun)
    places = tuple(
        replace(a, landmark=replace(a.landmark, det="the"))
        if isinstance(a, Loc) and isinstance(a.landmark, Noun)
        else a
        for a in fact.adjuncts
    )
    return replace(fact, verb="be", lemma="", mode="goal", theme=replace(fact.theme, det="the"), adjuncts=places)


def demanded(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    """ "(There is a red block on a blue one.) Reach a state where ...": what is asked for, and not told or pictured as
    well."""
    before = text[chains[n - 1].span[1] if n else 0 : chains[n].clauses[0].span[0]]
    return asks(re.split(r"[.;!?]", before)[-1])


def asks(words: str) -> bool:
    """Whether words in front of a clause ask for what it tells: "and I want ...", and not "and you can see ..."."""
    return _DEMANDED.search(_TITLED.sub("", words)) is not None and _KNOWN.search(words) is None


def same_one(fact: Clause, order: Clause) -> bool:
    """Whether an order is about the very block of which something was told."""
    theme = order.theme
    same = isinstance(theme, Noun) and isinstance(fact.theme, Noun) and theme.traits == fact.theme.traits
    named = isinstance(theme, Noun) and theme.det in ("the", "bare") and theme.amount is None and same
    return named or (
        isinstance(theme, Pronoun) and theme.word in ("it", "them", "they", "same", "both", "both of them")
    )


def how_far_off(told: Sequence[Chain]) -> bool:
    """Whether the second of two sentences says no more than how far off those beside each other are to be: "red is
    right of white. The gap must be 2 cm"."""
    if [len(chain.clauses) for chain in told[1:]] != [1]:
        return False
    fact, order = told[0].clauses[-1], told[1].clauses[0]
    if not isinstance(fact, Clause) or not isinstance(order, Clause) or order.verb not in ("be", "keep"):
        return False
    far = [isinstance(a, Loc) and a.rel in _FAR and getattr(a.landmark, "word", "") == "each other"
           for a in order.adjuncts]  # fmt: skip
    beside = [isinstance(a, Loc) and a.rel in _BESIDE for a in fact.adjuncts]
    return far == beside == [True]


_FAR = ("distance", "touching")
_BESIDE = ("left", "right", "front", "behind", "beside")


def ends_elsewhere(before: Chain, after: Chain) -> bool:
    """ "The red block sits on the blue one. At the end it is on the mat": what bears a block, and what later."""
    ends = [asked_of(after), *after.clauses[1:]]
    return any(moves(fact, end) for fact in before.clauses for end in ends)


def moves(fact: Meaning, end: Meaning) -> bool:
    """Whether two clauses say of the very same thing that it is on different things."""
    if not isinstance(fact, Clause) or not isinstance(end, Clause) or end.negated:
        return False
    bases = [[x.landmark for x in c.adjuncts if isinstance(x, Loc) and x.rel in ("on", "in")] for c in (fact, end)]
    alone = all(len(base) == 1 for base in bases) and len(fact.adjuncts) == 1
    return alone and same_one(fact, end) and not _same_mark(bases[0][0], bases[1][0])


def _same_mark(one: Meaning | None, other: Meaning | None) -> bool:
    """Whether two phrases name the same block or patch, "the blue mat" and "it" or "there" behind that."""
    if isinstance(other, Pronoun):
        return other.word in ("it", "there", "them")
    if isinstance(one, Noun) and isinstance(other, Noun):
        return (one.head, one.traits) == (other.head, other.traits)
    return isinstance(one, TableTop) and isinstance(other, TableTop)


def same_spot(one: Loc | In, other: Loc | In) -> bool:
    """Whether two places are one: "behind A" and "behind it", "on the left" and "there"."""
    if isinstance(other, Loc) and isinstance(other.landmark, Pronoun) and other.landmark.word == "there":
        return not one.negated
    if isinstance(one, In) or isinstance(other, In):
        return isinstance(one, In) and isinstance(other, In) and one.region == other.region
    plain = (one.rel, one.mods, one.low, one.negated) == (other.rel, other.mods, other.low, other.negated)
    return plain and _same_mark(one.landmark, other.landmark)


def _at_that(place: Meaning, there: Loc | In) -> Meaning:
    """ "Red is on blue. Green should be there instead": on the blue block, which is what the other leaves."""
    if not isinstance(place, Loc) or not isinstance(place.landmark, Pronoun):
        return place
    mark = there.landmark if isinstance(there, Loc) else None
    if isinstance(mark, Noun):
        if mark.head == "patch":
            return place
        return replace(there, landmark=replace(mark, det="the" if mark.det == "a" else mark.det))
    return there if isinstance(there, In) or isinstance(mark, Coord) else place


def instead_of(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "On the mat there is a red block. Put the green one there instead": what is there gives way to it."""
    for n, (before, after) in enumerate(pairwise(chains)):
        fact, end = before.clauses[-1], after.clauses[0]
        if not isinstance(fact, Clause) or not isinstance(end, Clause) or end.negated or fact.negated:
            continue
        told = [a for a in end.adjuncts if isinstance(a, Manner) and a.value == "before instead"]
        there, here = (tuple(x for x in c.adjuncts if isinstance(x, Loc | In)) for c in (fact, end))
        was = fact.mode == "start" or fact.lemma == "fact" or (fact.verb, fact.mode) == ("exist", "given")
        once = len(there) == len(here) == len(after.clauses) == len(fact.adjuncts) == 1
        if not told or not was or not once or not same_spot(there[0], here[0]) or same_one(fact, end):
            continue
        theme = fact.theme
        if not isinstance(theme, Noun) or theme.plural or isinstance(end.theme, Pronoun):
            continue
        begun = fact if fact.mode == "start" else replace(fact, verb="be", lemma="fact", mode="start")
        known = replace(theme, det="the" if theme.det == "a" else theme.det, amount=None)
        gone = Clause(verb="be", theme=known, adjuncts=fact.adjuncts, negated=True, mode="goal", span=end.span)
        put = replace(end, adjuncts=tuple(_at_that(a, there[0]) for a in end.adjuncts if a not in told))
        chains = (*chains[:n], replace(before, clauses=(*before.clauses[:-1], begun)),
                  replace(after, clauses=(put, gone), links=(after.links[0], "and")), *chains[n + 2 :])  # fmt: skip
    return chains


def facts_joined(chain: Chain, text: str) -> Chain:
    """ "On the blue patch lies a red block, on the yellow one a green one": a fact without a verb of its own, which
    nothing in front of it wishes, as in "red starts on blue, and I want blue on red"."""
    told: list[Meaning] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        before = told[-1] if told else None
        between = text[before.span[1] : clause.span[0]] if before is not None else ""
        fact = isinstance(before, Clause) and before.lemma == "fact" and before.mode in ("goal", "start")
        told_so = fact and isinstance(before, Clause) and not before.negated and link == "and"
        if told_so and isinstance(clause, Clause) and _verbless(clause) and AND.fullmatch(between):
            clause = replace(clause, lemma="fact")
        told.append(clause)
    return replace(chain, clauses=tuple(told)) if tuple(told) != chain.clauses else chain


def borne_in_turn(chain: Chain) -> Chain:
    """ "Blue starts on green, which is on red": two facts of the start, of one tower."""
    told: list[tuple[str, Meaning]] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        inner: list[tuple[str, Meaning]] = []
        last = clause.adjuncts[-1] if isinstance(clause, Clause) and clause.adjuncts else None
        mark = last.landmark if isinstance(last, Loc) and last.rel == "on" and not last.negated else None
        if isinstance(clause, Clause) and clause.mode == "start" and isinstance(last, Loc) and isinstance(mark, Noun):
            below = [x for x in mark.conditions if isinstance(x, Loc) and x.rel == "on" and not x.negated]
            if len(below) == len(mark.conditions) == 1 and not mark.plural:
                bare = replace(mark, conditions=())
                plain = tuple(m for m in below[0].mods if m not in ("asserted", "aside", "start"))
                inner = [("and", replace(clause, theme=bare, adjuncts=(replace(below[0], mods=plain),)))]
                known = replace(bare, det="the", amount=None) if bare.det == "a" else bare
                clause = replace(clause, adjuncts=(*clause.adjuncts[:-1], replace(last, landmark=known)))
        told += [*inner, (link, clause)]  # "it" is what was told last
    if len(told) == len(chain.clauses):
        return chain
    return replace(chain, clauses=tuple(c for _, c in told), links=tuple(link for link, _ in told))


def _verbless(clause: Clause) -> bool:
    bare = (clause.verb, clause.lemma, clause.mode, clause.word) == ("be", "", "goal", None) and not clause.negated
    return bare and bool(clause.adjuncts) and all(isinstance(a, Loc | In) for a in clause.adjuncts)


def asked_of(chain: Chain) -> Meaning:
    """What a sentence asks of a block, behind "take it and ..."."""
    asked = [c for c in chain.clauses if not (isinstance(c, Clause) and c.negated)] or list(chain.clauses)
    first = asked[0]
    taken = isinstance(first, Clause) and first.verb == "pick" and not (first.adjuncts or first.negated)
    return asked[1] if taken and len(asked) > 1 else first
