"""A request in words -> the version it refers to and the changes it asks for."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from rpg.core.diagnostics import Span
from rpg.steer.requests import requests as r
from rpg.steer.requests.backrefs import Reference, references
from rpg.steer.requests.grammar import request, skip, tail
from rpg.steer.requests.language import Parser, Token, TooMuchWork, longest, m, phrases, tokenize
from rpg.steer.requests.terse import Tint

MAX_REQUESTS = 8
_STOPS = frozenset({".", ";", "!", "?", "…"})


@dataclass(frozen=True)
class Parsed:
    """What was understood. `rest`: the part of the text, from that character on, that no edit grammar covers."""

    reference: Reference | None = None
    requests: tuple[r.Request, ...] = ()
    rest: Span | None = None
    whole: bool = True
    cost: int = field(default=0, compare=False)


def parse(text: str) -> tuple[Parsed, ...]:
    """Every reading of `text`, the best first: those that cover it all, then those that leave words over."""
    tokens, _ = tokenize(text)
    while tokens and tokens[-1].word in _STOPS:
        tokens = tokens[:-1]
    p = Parser(_plainly(tokens))
    found: list[Parsed] = []
    try:
        for reference, start in _openings(p):
            found += _chains(p, start, reference)
    except TooMuchWork:
        return ()
    found.sort(key=lambda each: (not each.whole, _left(each, text), each.cost))
    return tuple(found)


_PLACES = {"upper": "top", "uppermost": "top", "lower": "bottom", "lowermost": "bottom"}


def _plainly(tokens: list[Token]) -> list[Token]:
    """Places by the words that noun phrases have for them: "the upper block" is the top one."""
    tokens = _as_one(tokens)
    after_the = (token.word in _PLACES and k > 0 and tokens[k - 1].word == "the" for k, token in enumerate(tokens))
    return [
        replace(token, word=_PLACES[token.word]) if placed else token
        for token, placed in zip(tokens, after_the, strict=True)
    ]


_EVERYTHING = ("the whole thing", "the entire thing", "the whole lot", "the whole structure", "the entire structure")


_WHOLE = frozenset({"whole", "entire", "complete"})
_BELOW = frozenset({"of", "under", "beneath", "below", "underneath"})


def _as_one(tokens: list[Token]) -> list[Token]:
    """Words for all that is built, as the one word that stands for it."""
    found: list[Token] = []
    wholes: list[int] = []
    for token in tokens:
        below = token.word == "everything" and bool(found) and found[-1].word in _BELOW
        found.append(replace(token, word="them") if below else token)
        if token.word in _WHOLE and len(found) > 1 and found[-2].word in ("the", "its"):
            wholes.append(len(found) - 1)
        words = " ".join(each.word for each in found[-3:])
        if len(found) > 2 and words in _EVERYTHING:
            first, last = found[-3], found[-1]
            found[-3:] = [replace(first, word="them", span=(first.span[0], last.span[1]))]
            wholes = [k for k in wholes if k < len(found)]
        elif " ".join(each.word for each in found[-2:]) == "it all":
            found[-2:] = [replace(found[-2], word="them", span=(found[-2].span[0], token.span[1]))]
    return [token for k, token in enumerate(found) if k not in wholes or k + 1 == len(found)]


_EDITS = phrases(
    "add | include | insert | append | introduce | attach | remove | delete | discard | eliminate | omit | leave out | "
    "take out | take away | take off | get rid of | do without | replace | substitute | change | convert | transform | "
    "recolor | recolour | paint | relabel | resize | enlarge | shrink | swap | switch | exchange | undo | revert | "
    "reverse | invert | mirror | tighten | loosen | relax | extend | shorten | lengthen | go back | instead | use"
)


def is_edit(text: str) -> bool:
    """Whether a request begins with a verb that only makes sense of a task that is there."""
    p = Parser(tokenize(text)[0])
    return bool(longest(p, skip(p, 0), _EDITS))


def _left(parsed: Parsed, text: str) -> int:
    return 0 if parsed.rest is None else len(text) - parsed.rest[0]


def _openings(p: Parser) -> list[tuple[Reference | None, int]]:
    """Where the changes begin: after a reference to a version, or at once."""
    found: list[tuple[Reference | None, int]] = []
    start = skip(p, 0)
    for reference, j in references(p, start):
        k = longest(p, j, ", but | but | , and | and | , then | then | , | : | . | ;") or j
        found.append((reference, skip(p, k)))
    found.append((None, 0))
    return found


def _chains(p: Parser, start: int, reference: Reference | None) -> list[Parsed]:
    """Requests one after the other; for every chain that stops early, what it leaves over.

    A colour alone is no further request of a sentence: "stack them, red, blue" lists blocks.
    """
    done: list[Parsed] = []
    if start >= p.end:
        return [Parsed(reference=reference)] if reference else []

    def go(i: int, so_far: tuple[r.Request, ...], cost: int) -> None:
        if len(so_far) >= MAX_REQUESTS or len(done) > 200:
            return
        extended = False
        for found, j in request(p, i):
            if so_far and p.words[i - 1] not in _STOPS and (isinstance(found, Tint) or _of_the_new(p, i, so_far[-1])):
                continue
            j = tail(p, j)
            total = cost + found.cost + m_cost(found) + 1
            if j >= p.end:
                done.append(Parsed(reference, (*so_far, found), None, True, total))
                extended = True
            elif (k := _join(p, j)) and not (isinstance(found, Tint) and p.words[j] == "and"):
                go(k, (*so_far, found), total)
                extended = True
        if not extended and i < p.end:
            place = (p.tokens[i].span[0], p.tokens[-1].span[1])
            done.append(Parsed(reference, so_far, place, False, cost))

    go(start, (), 0)
    return done


def _of_the_new(p: Parser, i: int, last: r.Request) -> bool:
    """Whether "in red" behind what is added is about that, rather than about everything."""
    return isinstance(last, r.Add) and p.words[i] == "in"


def _join(p: Parser, i: int) -> int:
    """The position after what joins two requests."""
    j = i
    while j < p.end and (p.words[j] in _STOPS or p.words[j] == ","):
        j += 1
    k = (
        longest(
            p, j, "and then | and also | and | then | but also | but | also | while | plus | afterwards | after that"
        )
        or j
    )
    return k if k > i else 0


def m_cost(found: r.Request) -> int:
    """The cost of the phrases inside a request."""
    total = 0
    for name in type(found).__dataclass_fields__:
        value = getattr(found, name)
        if isinstance(value, m.Meaning):
            total += m.cost_of(value)
        elif isinstance(value, tuple):
            total += sum(m.cost_of(each) for each in value if isinstance(each, m.Meaning))
    return total
