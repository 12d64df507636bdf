"""What blocks and patches are called: "the red cube is the queen; put the queen on the blue cube", "call it Bob".

A name means nothing here; where it stands again, the thing itself is put in its place, and the naming only says that
there is such a thing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language import lexicon
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.not_here import HINTS
from rpg.language.phrases import length_at
from rpg.language.spelling import vocabulary
from rpg.language.tokens import Token

_IS = (("is", "called"), ("is", "named"), ("is",), ("represents",), ("stands", "for"), ("plays",), ("will", "be"),
       ("shall", "be", "called"), ("should", "be", "called"))  # fmt: skip
_CALL = (("call",), ("let", "us", "call"), ("name",), ("we", "call"), ("i", "call"), ("i", "will", "call"))
_OWN = frozenset({"the", "my", "our", "your"})
_ONE = frozenset({"a", "an"})
_BREAKS = frozenset({".", "!", "?", ";", ",", "and", ":", "-", "…"})
_LOOKS: tuple[Collection[str], ...] = (lexicon.COLOR, lexicon.SIZE)
_PERSONS = frozenset({*PEOPLE.split("|"), "baby", "queen", "king"})
_CAPITAL = 2
"""A name in capitals of so many letters or more is a word to be spelt."""


@dataclass(frozen=True)
class _Naming:
    """Where a naming stands: the thing that is named, the name, and the end."""

    begin: int
    thing: tuple[int, int]
    name: tuple[int, int]
    end: int


def without_nicknames(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the things themselves for what they are called, and notes of the names."""
    words = [token.word for token in tokens]
    found: list[_Naming] = []
    at = 0
    while at < len(tokens):
        naming = next(_named(tokens, words, at), None) if at == 0 or words[at - 1] in _BREAKS else None
        found += [naming] if naming is not None else []
        at = naming.end if naming is not None else at + 1
    if not found:
        return tokens, []
    names = [([t.word for t in tokens[slice(*x.name)]], definite(tokens[slice(*x.thing)])) for x in found]
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    for naming in found:
        thing = definite(tokens[slice(*naming.thing)])
        notes.append(f"'{said(tokens[slice(*naming.name)])}' is {said(thing)}")
        there = [tokens[naming.begin].saying(word) for word in ("there", "is", "a")]
        out += [*again(tokens[at : naming.begin], names), *there, *thing[1:]]
        at = naming.end
    return [*out, *again(tokens[at:], names)], notes


def _named(tokens: list[Token], words: list[str], at: int) -> Iterator[_Naming]:
    """A naming that begins here: "the red cube is the queen", "call the red cube Bob"."""
    call = length_at(words, at, _CALL)
    thing = thing_at(words, at + call)
    if thing <= at + call:
        return
    verb = 0 if call else length_at(words, thing, _IS)
    if not (call or verb):
        return
    begin = thing + verb
    article = words[begin] if begin < len(words) and words[begin] in _OWN | _ONE else ""
    name = begin + bool(article)
    end = name
    while end < len(words) and end < name + 2 and strange(tokens[end]):
        end += 1
    if end == name or (end < len(words) and words[end] not in _BREAKS):
        return
    called = bool(call) or verb > 1 or tokens[name].raw[0].isupper()
    again = any(words[n : n + end - name] == words[name:end] for n in range(len(words)) if n != name)
    if called or article in _OWN or (article in _ONE and again and HINTS.keys().isdisjoint(words[name:end])):
        yield _Naming(at, (at + call, thing), (name, end), end)


def thing_at(words: list[str], at: int) -> int:
    """The position behind "the red cube", "my little blue one"; `at` where nothing like it begins."""
    end = at + (words[at : at + 1] != [] and words[at] in _OWN | _ONE)
    looks = end
    while end < len(words) and any(words[end] in table for table in _LOOKS):
        end += 1
    noun = words[end] if end < len(words) else ""
    single = lexicon.BLOCK.get(noun) is False or lexicon.PATCH.get(noun) is False or noun == "one"
    return end + 1 if single and end > looks else at


def strange(token: Token) -> bool:
    """A word that means nothing here, or is a person."""
    shouted = token.raw.isupper() and len(token.raw) >= _CAPITAL
    known = token.word in vocabulary() and token.word not in _PERSONS
    return token.kind == "word" and len(token.word) > 1 and not shouted and not known


def definite(thing: list[Token]) -> list[Token]:
    """The thing with "the" before it; "the blue one" as a block."""
    the = thing[0].saying("the")
    own = thing[1:] if thing[0].word in _OWN | _ONE else thing
    noun = own[-1].saying("block") if own[-1].word == "one" else own[-1]
    return [the, *own[:-1], noun]


def again(part: list[Token], names: Sequence[tuple[list[str], list[Token]]]) -> list[Token]:
    """A part of the text with the things in place of their names."""
    out: list[Token] = []
    at = 0
    while at < len(part):
        hit = next(((n, t) for n, t in names if [x.word for x in part[at : at + len(n)]] == n), None)
        if hit is None:
            out.append(part[at])
            at += 1
            continue
        name, thing = hit
        if out and out[-1].word in _OWN:
            out.pop()
        out += [replace(token, span=part[at].span) for token in thing]
        at += len(name)
    return out


def said(tokens: list[Token]) -> str:
    return " ".join(token.raw for token in tokens)
