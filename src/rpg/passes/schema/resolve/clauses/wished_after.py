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
    Loc,
    Manner,
    Noun,
    Pronoun,
    Quality,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.begun_facts import indicative
from rpg.passes.schema.resolve.clauses.joined_facts import BESIDES, asked_of, demanded, how_far_off
from rpg.passes.schema.resolve.clauses.same_at_the_end import (
    SHOULD,
    definite,
    known_by_then,
    made_so,
    of_a_part,
    of_these,
)
from rpg.passes.schema.resolve.clauses.wished_beside import wished_beside

_STOP = re.compile(r"[.!?]")


def wished_after(chains: tuple[Chain, ...], text: str, final: Sequence[bool]) -> tuple[Chain, ...]:
    """The sentences, with such facts told of the start. `final`: which of them tell of the end anyway."""
    chains = (*chains[:1], *(_those_left(_so_many_left(chain), text) for chain in chains[1:]))
    found = list(chains)
    for n, chain in enumerate(chains):
        if final[n]:
            continue
        if parted := wished_beside(chains, n, text):
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
        if _goes_off(wish, text):
            found[n] = replace(chain, clauses=begun) if any(_of_this(wish, fact) for fact in facts) else chain
            continue
        if (wish.mode == "command" and not besides) or any(of_these(wish, fact) for fact in facts):
            found[n] = replace(chain, clauses=begun)
            found = [_remaining(x, wish, facts[-1]) for x in found]
        elif all(map(definite, facts)) and not of_a_part(wish):
            found[n] = replace(chain, clauses=(*begun, *map(known_by_then, facts)), links=(*chain.links, *chain.links))
    return tuple(found)


def _goes_off(wish: Clause, text: str) -> bool:
    """ "(A, B and C stand in a row.) The middle one goes on the mat", "... moves away", "... must be taken off": out of
    what was told; "A goes on the left" may tell more of it."""
    away = [
        isinstance(x, In)
        or (isinstance(x, Loc) and (x.rel in ("on", "off") or getattr(x.landmark, "head", "") == "patch"))
        for x in wish.adjuncts
    ]
    if wish.mode != "goal" or wish.theme is None or not away or not all(away):
        return False
    return wish.verb == "place" or _GOES.fullmatch(text[wish.theme.span[1] : wish.adjuncts[0].span[0]]) is not None


_GOES = re.compile(r"\W*(?:all |both |each )?go(?:es)?(?: up| down| over)?\s*", re.IGNORECASE)


def _of_this(wish: Clause, fact: Clause) -> bool:
    """Whether a part of the line that the fact tells of, or one of the blocks in it, is meant."""
    lined = any(isinstance(x, Structure) for x in parts_of(fact)) or fact.verb == "stack"
    return lined and (of_these(wish, fact) or of_a_part(wish))


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
    return ended and (told or made_so(chain, said)) and SHOULD.search(said) is None


def _wish(chains: tuple[Chain, ...], n: int, text: str) -> Clause | None:
    """What the first sentence behind the facts asks for, where it says that something should be somewhere."""
    later = range(n + 1, len(chains))
    m = next((m for m in later if demanded(chains, m, text) or not _so(chains[m], text)), None)
    asked = asked_of(chains[m]) if m is not None else None
    if m is None or not isinstance(asked, Clause) or asked.negated or asked.theme is None:
        return None
    wished = demanded(chains, m, text) or SHOULD.search(text[slice(*asked.span)]) is not None
    wished = wished or _goes_off(asked, text)
    return asked if asked.mode == "command" or (asked.mode == "goal" and wished) else None
