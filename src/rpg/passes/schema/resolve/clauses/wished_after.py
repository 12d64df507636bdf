""" "The A is on the B. The B should be on the C": what is so, and in the next sentence what should be so. The first is
how it starts; it is still wanted at the end where nothing that it tells of is to be elsewhere."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Quality,
    Structure,
    Toward,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.begun_facts import indicative
from rpg.passes.schema.resolve.clauses.joined_facts import BESIDES, asked_of, how_far_off, moves

_SHOULD = re.compile(r"\b(?:must|should|shall|has to|have to|needs? to|ought|(?:is|are) (?:not )?to)\b", re.IGNORECASE)
_STOP = re.compile(r"[.!?]")


def wished_after(chains: tuple[Chain, ...], text: str, final: Sequence[bool]) -> tuple[Chain, ...]:
    """The sentences, with such facts told of the start. `final`: which of them tell of the end anyway."""
    chains = (*chains[:1], *(_those_left(_so_many_left(chain), text) for chain in chains[1:]))
    found = list(chains)
    for n, chain in enumerate(chains):
        if final[n]:
            continue
        if parted := _wished_beside(chains, n, text):
            found[n] = parted
            continue
        told = not _so(chain, text) or how_far_off(chains[n : n + 2])
        wish = None if told else _wish(chains, n, text)
        if wish is None:
            continue
        facts = tuple(c for c in chain.clauses if isinstance(c, Clause))
        if any(isinstance(x, Quality) for c in facts for x in c.adjuncts):
            continue  # "three are green": so they look, at the start and at the end
        begun = tuple(replace(c, mode="start") for c in facts)
        besides = BESIDES.search(text[slice(*wish.span)].replace("both", "")) is not None
        if (wish.mode == "command" and not besides) or any(_of_these(wish.theme, fact) for fact in facts):
            found[n] = replace(chain, clauses=begun)
            found = [_remaining(x, wish, facts[-1]) for x in found]
        elif all(map(_definite, facts)) and not _of_a_part(wish):
            found[n] = replace(chain, clauses=(*begun, *map(_known, facts)), links=(*chain.links, *chain.links))
    return tuple(found)


def _wished_beside(chains: Sequence[Chain], n: int, text: str) -> Chain | None:
    """ "The blue block is on the mat, and the red one should be there too": the same in one sentence; and where a block
    is on one thing and should be on another. None where it is told otherwise."""
    chain, after = chains[n], chains[n + 1 : n + 2]
    count = next((k for k, c in enumerate(chain.clauses) if not _fact(c, text)), len(chain.clauses))
    wish = (*chain.clauses, *(c for x in after for c in x.clauses), None)[count]
    if not count or not isinstance(wish, Clause) or wish.mode != "goal" or wish.negated:
        return None
    facts = tuple(c for c in chain.clauses[:count] if isinstance(c, Clause))
    said = text[facts[-1].span[1] : wish.span[1]]
    one_sentence = _JOINED.match(said) and _STOP.search(said) is None and {*chain.links[: count + 1]} == {"and"}
    if not one_sentence or _SHOULD.search(said) is None or _RELATIVE.search(said):
        return None
    begun: tuple[Meaning, ...] = tuple(replace(c, mode="start") for c in facts)
    if not any(moves(fact, wish) for fact in facts):
        if any(_of_these(wish.theme, fact) for fact in facts) or _of_a_part(wish) or not all(map(_definite, facts)):
            return None
        pair = [Chain(clauses=x, links=("and",) * len(x), span=chain.span) for x in (facts, (wish,))]
        if how_far_off(pair):
            return None
        begun = (*begun, *map(_known, facts))
    rest = chain.links[count:]
    return replace(chain, clauses=(*begun, *chain.clauses[count:]), links=(*("and" for _ in begun), *rest))


def _fact(clause: Meaning, text: str) -> bool:
    """Whether a clause says where something is, and not how that should be, or how it looks."""
    if not isinstance(clause, Clause) or clause.negated or clause.mode != "goal":
        return False
    said = text[slice(*clause.span)]
    placed = all(isinstance(x, Loc | In | Into | OrderBy | Toward) for x in clause.adjuncts)
    made = _made_so(Chain(clauses=(clause,), links=("and",), span=clause.span), said)
    return _SHOULD.search(said) is None and (made or (clause.lemma == "fact" and placed))


_JOINED = re.compile(r"\s*(?:[,;]|[-–—] |and\b|but\b)", re.IGNORECASE)
_RELATIVE = re.compile(r"\b(?:which|who|whose|that|where)\b", re.IGNORECASE)


def _so_many_left(chain: Chain) -> Chain:
    """ "(Three red blocks are on the mat.) Leave one there": just one of them is to be there."""
    left = chain.clauses[0]
    there = isinstance(left, Clause) and left.lemma == "leave" and len(left.adjuncts) == 1 and not left.negated
    place = left.adjuncts[0] if there and isinstance(left, Clause) else None
    on = isinstance(place, Loc) and isinstance(place.landmark, Pronoun) and place.landmark.word == "there"
    if not on or not isinstance(left, Clause) or len(chain.clauses) > 1:
        return chain
    one = isinstance(left.theme, Pronoun) and left.theme.word == "one"
    many = Amount(1, 1) if one else getattr(left.theme, "amount", None)
    bare = one or (isinstance(left.theme, Noun) and left.theme.head == "any" and left.theme.traits == Traits())
    if many is None or not bare or left.theme is None:
        return chain
    span = left.theme.span
    some = Noun(head="any", det="some", amount=many._replace(strict=True), plural=True,
                part_of=Pronoun(word="them", span=span), span=span)  # fmt: skip
    return replace(chain, clauses=(replace(left, verb="be", lemma="", theme=some, mode="goal"),))


def _those_left(chain: Chain, text: str) -> Chain:
    """ "(A tower of four blocks stands on the mat.) Only two blocks should remain there": two of these."""
    left = chain.clauses[0]
    if not isinstance(left, Clause) or left.mode != "goal" or _REMAIN.search(text[slice(*left.span)]) is None:
        return chain
    noun = left.theme
    plain = isinstance(noun, Noun) and noun.head == "block" and noun.traits == Traits() and noun.part_of is None
    if not plain or not isinstance(noun, Noun) or noun.amount is None or noun.det != "bare" or noun.conditions:
        return chain
    them = Pronoun(word="them", span=noun.span)
    some = replace(noun, head="any", det="some", amount=noun.amount._replace(strict=True), plural=True, part_of=them)
    return replace(chain, clauses=(replace(left, theme=some), *chain.clauses[1:]))


_REMAIN = re.compile(r"\b(?:remain|stay|be left)\b", re.IGNORECASE)


def _remaining(chain: Chain, wish: Clause, fact: Clause) -> Chain:
    """ "(Three blocks are on the mat.) Exactly one should remain": there, and not just where it is."""
    stays = len(wish.adjuncts) == 1 and isinstance(wish.adjuncts[0], Manner) and wish.adjuncts[0].kind == "stay"
    places = [x for x in fact.adjuncts if isinstance(x, Loc | In)]
    if not stays or len(places) != 1 or not any(c is wish for c in chain.clauses):
        return chain
    told = tuple(replace(wish, adjuncts=tuple(places)) if c is wish else c for c in chain.clauses)
    return replace(chain, clauses=told)


def _so(chain: Chain, text: str) -> bool:
    """Whether a sentence of its own says how it is."""
    said = text[slice(*chain.span)]
    ended = _STOP.match(text[chain.span[1] :].lstrip()) is not None
    told = indicative(chain, text) and all(isinstance(c, Clause) and c.lemma == "fact" for c in chain.clauses)
    return ended and (told or _made_so(chain, said)) and _SHOULD.search(said) is None


def _made_so(chain: Chain, said: str) -> bool:
    """ "A, B and C are stacked", "the letters spell STOP": one structure, in the indicative."""
    made = chain.clauses[0]
    one = len(chain.clauses) == 1 and isinstance(made, Clause) and made.verb in _MAKING and not made.negated
    return one and isinstance(made, Clause) and made.mode == "goal" and _IS.search(said) is not None


_MAKING = ("stack", "build", "arrange", "spell")
_IS = re.compile(r"\S \b(?:is|are|forms?|makes?|spells?|reads?|shows?|stands?|lies?)\b", re.IGNORECASE)


def _wish(chains: tuple[Chain, ...], n: int, text: str) -> Clause | None:
    """What the first sentence behind the facts asks for, where it says that something should be somewhere."""
    after = next((chain for chain in chains[n + 1 :] if not _so(chain, text)), None)
    asked = asked_of(after) if after is not None else None
    if not isinstance(asked, Clause) or asked.negated or asked.theme is None:
        return None
    wished = asked.mode == "goal" and _SHOULD.search(text[slice(*asked.span)]) is not None
    return asked if asked.mode == "command" or wished else None


def _of_these(theme: Meaning | None, fact: Clause) -> bool:
    """Whether it is one of the things that the fact tells of, or "it", "they", "the tower"."""
    if any(isinstance(x, Pronoun) for x in parts_of(theme)):
        return True
    if isinstance(theme, Structure) and theme.det == "the" and theme.members is None:
        return any(isinstance(x, Structure) and x.kind == theme.kind for x in parts_of(fact)) or fact.verb == theme.kind
    if isinstance(theme, Noun) and theme.head == "any" and theme.traits == Traits():
        return True  # "exactly one (of them)"
    named = [x.traits for x in parts_of(fact) if isinstance(x, Noun) and x.head != "patch"]
    return any(_looks_so(x.traits, one) for x in parts_of(theme) if isinstance(x, Noun) for one in named)


def _of_a_part(wish: Clause) -> bool:
    """ "Its top block must be red", "the middle one must be on the mat": what is said of a part of what is told."""
    theme = wish.theme
    part = isinstance(theme, Noun) and (theme.det == "its" or theme.traits.rank is not None or theme.part_of is not None)
    return part or any(isinstance(x, Quality) for x in wish.adjuncts)


def _looks_so(traits: Traits, told: Traits) -> bool:
    """Whether a look is that of one of the blocks that a noun tells of: "C" of "A, B and C", also "A and C"."""
    looks = {*traits.colors, *traits.labels}
    among = not looks.isdisjoint({*told.colors, *told.labels}) and traits.size in (None, told.size)
    return among or (not looks and traits.size is not None and traits.size == told.size)


def _definite(fact: Clause) -> bool:
    """Whether what a fact tells of can be spoken of again: single things, blocks that are named one by one, and blocks
    of one look that are counted; and whether it does not tell of a structure by more than its kind."""
    if fact.verb == "spell":
        return True
    nouns, theme = [x for x in parts_of(fact) if isinstance(x, Noun)], _told_of(fact)
    counted = isinstance(theme, Noun) and theme.amount is not None and bool(theme.traits.colors)
    single = all(x.det in ("the", "bare") and not x.amount and not x.plural for x in nouns if x is not theme)
    known = single and (counted or not nouns or (nouns[0].det in ("the", "bare") and _one_by_one(nouns[0])))
    shapes = [x for x in parts_of(fact) if isinstance(x, Structure)]
    return known and all(x == Structure(kind=x.kind, amount=x.amount, dims=x.dims, members=x.members, span=x.span)
                         for x in shapes)  # fmt: skip


def _one_by_one(noun: Noun) -> bool:
    """ "the red block", "A, B and C"."""
    return not noun.plural or len(noun.traits.labels) > 1 or len(noun.traits.colors) > 1


def _told_of(fact: Clause) -> Meaning | None:
    """What a fact tells of: in "six blocks form a circle" and "a circle of six blocks is on the mat" the blocks."""
    made_of = fact.adjuncts[0] if len(fact.adjuncts) == 1 and isinstance(fact.theme, Structure) else None
    if isinstance(made_of, Using):
        return made_of.members
    return fact.theme.members if isinstance(fact.theme, Structure) else fact.theme


def _known(fact: Clause) -> Clause:
    """The fact, of blocks that are there by then: "the two red blocks"."""
    noun = _told_of(fact)
    if not isinstance(noun, Noun) or noun.amount is None or noun.det not in ("a", "bare"):
        return fact
    known = replace(noun, det="the", amount=noun.amount if noun.plural else None)
    if isinstance(fact.theme, Structure) and fact.theme.members is not None:
        return replace(fact, theme=replace(fact.theme, members=known))
    if isinstance(fact.theme, Structure):
        return replace(fact, adjuncts=tuple(replace(x, members=known) for x in fact.adjuncts if isinstance(x, Using)))
    return replace(fact, theme=known)
