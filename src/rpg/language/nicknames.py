"""What blocks and patches are called behind what they are: "the red cube is the queen", "call the red cube Bob"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.harmless import ANIMALS, PEOPLE
from rpg.language.not_here import HINTS
from rpg.language.phrases import length_at
from rpg.language.slips import slips_of
from rpg.language.spelling import vocabulary
from rpg.language.telling import may_tell, tells
from rpg.language.tokens import Token

_IS = (("is", "called"), ("is", "named"), ("is",), ("represents",), ("stands", "for"), ("plays",), ("will", "be"),
       ("shall", "be", "called"), ("should", "be", "called"), ("serves", "as"), ("acts", "as"), ("functions", "as"),
       ("is", "used", "as"), ("=",))  # fmt: skip
_CALL = tuple((*who, *call) for who in ((), ("let", "us"), ("we",), ("i",), ("i", "will"), ("we", "will"))
              for call in (("call",), ("name",), ("label",), ("refer", "to"), ("denote",), ("let",))
              if who == () or call != ("let",))  # fmt: skip
_AS = (("as",), ("be",), ("by",))
_OWN = frozenset({"the", "my", "our", "your"})
_ONE = frozenset({"a", "an"})
_BREAKS = frozenset({".", "!", "?", ";", ",", "and", ":", "-", "…"})
_LOOKS: tuple[Collection[str], ...] = (lexicon.COLOR, lexicon.SIZE)
_PERSONS = PEOPLE | ANIMALS
_CAPITAL = 2
"""A name in capitals of so many letters or more is a word to be spelt."""


def named_behind(tokens: list[Token], words: list[str], at: int, goes_on: bool) -> Iterator[tuple[int, int, int, int]]:
    """Where a thing begins and ends that is given a name here, and where the name does: "the red cube is the queen",
    "call the red cube Bob", "let the red cube be the anchor". `goes_on`: behind another, "and the blue one Bill"."""
    call = length_at(words, at, _CALL)
    thing = thing_at(words, at + call)
    if thing <= at + call:
        yield from _several_named(tokens, words, at)
        return
    verb = length_at(words, thing, _AS if call else (*_IS, *_AS) if goes_on else _IS)
    if not (call or verb or goes_on) or (words[at] == "let" and call == 1 and words[thing : thing + 1] != ["be"]):
        return
    begin = thing + verb
    article = words[begin] if begin < len(words) and words[begin] in _OWN | _ONE else ""
    name = begin + bool(article)
    end = name
    while end < len(words) and end < name + 2 and strange(tokens[end]):
        end += 1
    told = bool(call) or goes_on or verb > 1
    known = end == name < len(words) and (words[end] in ROLES or (told and labels(tokens[end])))
    end += known
    if end == name or (end < len(words) and words[end] not in _BREAKS):
        return
    called = (
        bool(call) or (goes_on and not verb) or verb > 1 or tokens[name].raw[0].isupper() or _stuff(words, name, end)
    )
    again = any(words[n : n + end - name] == words[name:end] for n in range(len(words)) if n != name)
    if known and not again and words[name] not in _MERELY:
        return
    if called or article in _OWN or (article in _ONE and again and HINTS.keys().isdisjoint(words[name:end])):
        yield at + call, thing, name, end


def _several_named(tokens: list[Token], words: list[str], at: int) -> Iterator[tuple[int, int, int, int]]:
    """ "The green blocks are the frogs": what several are called that are named so again; one of them would be no
    others."""
    many = words[at] in lexicon.NUMBER and lexicon.NUMBER[words[at]] > 1
    things = things_at(words, at + many)
    verb = length_at(words, things, _ARE) if things > at + many else 0
    name = things + verb + (words[things + verb : things + verb + 1] == ["the"])
    if not verb or name >= len(words) or not strange(tokens[name]) or words[name + 1 : name + 2] not in _ENDED:
        return
    called = words[name]
    if (called.endswith("s") or called in _ALIKE) and words.count(called) > 1:
        yield at, things, name, name + 1


_ARE = (("are", "called"), ("are", "named"), ("are",), ("represent",), ("stand", "for"), ("play",), ("serve", "as"))
_ALIKE = frozenset({"sheep", "mice", "people", "men", "women", "children", "fish", "geese", "deer"})
"""Plurals without an "s"."""
_ENDED = ([], *([mark] for mark in _BREAKS))


def _stuff(words: list[str], name: int, end: int) -> bool:
    """ "(The red mat is) lava ... the lava": what is named so again, and not what something else is like, as in "the
    dirty one"."""
    again = [n + end - name for n in range(end, len(words)) if words[n : n + end - name] == words[name:end]]
    nouns = lexicon.BLOCK.keys() | lexicon.PATCH.keys() | lexicon.STRUCTURE.keys() | {"one", "ones"}
    named = all(words[n - end + name - 1] == "the" and (n == len(words) or words[n] not in nouns) for n in again)
    return bool(again) and named


ROLES = frozenset({"landmark", "target", "base", "home", "marker", "reference", "key", "distractor"})
"""Words with a meaning of their own, by which a thing may be called as well."""
_MERELY = frozenset({"landmark", "target", "marker", "reference"})
"""Nothing follows for a thing that is one of them."""


def labels(token: Token) -> bool:
    """Whether a token is a number or a letter by which a thing may be called."""
    return token.kind == "number" or (token.kind == "word" and len(token.raw) == 1 and token.raw.isupper())


PLACES = lexicon.PATCH.keys() - {"goal"} | {"station", "slot", "bay", "section", "region", "location", "dock", "site",
                                            "shelf", "rack", "position", "point"}  # fmt: skip
_LONGEST = 2


def names_at(tokens: list[Token], words: list[str], at: int) -> Iterator[tuple[int, bool]]:
    """The positions behind the names that may begin here, and whether it is a letter or has a label: "landmark",
    "bin 1", "A", "the drop point"."""
    if at >= len(tokens):
        return
    labelled = at + 1 < len(tokens) and labels(tokens[at + 1])
    if labelled and (words[at] in PLACES or words[at] in lexicon.BLOCK or strange(tokens[at])):
        yield at + 2, True
    elif labels(tokens[at]) and tokens[at].kind == "word" and tokens[at].raw != "I":
        yield at + 1, True
    called = at + 1
    while called < len(tokens) and tokens[called].joined:
        called += 1
    further = called < len(tokens) and words[called] in ROLES | PLACES
    if as_a_kind(tokens[at : at + 2]):
        yield at + 2, True
    elif words[at] in ROLES and lexicon.BLOCK.get(words[called] if called < len(words) else "") is False:
        yield called + 1, True
    elif words[at] in ROLES | PLACES or (further and (called > at + 1 or named_so(tokens[at]))):
        yield called + further, False
    end = at
    while end < len(tokens) and end < at + _LONGEST and strange(tokens[end]):
        end += 1
    if end > at:
        yield end, False


def as_a_kind(name: list[Token]) -> bool:
    """ "The treasure cube": a name ahead of its noun. It may be a look, unless a colour is told besides."""
    unknown = len(name) == 2 and strange(name[0]) and not slips_of(name[0].word)
    return unknown and lexicon.BLOCK.get(name[1].word) is False


def colored(words: list[str]) -> bool:
    """Whether a colour is among some words."""
    return any(word in lexicon.COLOR for word in words)


def named_so(token: Token) -> bool:
    """Whether a word tells nothing of what is named: "drop point"."""
    shouted = token.raw.isupper() and len(token.raw) >= _CAPITAL
    return token.kind == "word" and token.word.isalpha() and not (shouted or tells(token) or may_tell(token.word))


def thing_at(words: list[str], at: int) -> int:
    """The position behind "the red cube", "my little blue one"; `at` where nothing like it begins."""
    end = at + (words[at : at + 1] != [] and words[at] in _OWN | _ONE)
    looks = end
    while end < len(words) and any(words[end] in table for table in _LOOKS):
        end += 1
    noun = words[end] if end < len(words) else ""
    single = lexicon.BLOCK.get(noun) is False or lexicon.PATCH.get(noun) is False or noun == "one"
    return end + 1 if single and end > looks else at


def things_at(words: list[str], at: int) -> int:
    """The position behind "the red cube", "white cubes"; `at` where nothing like it begins."""
    if (end := thing_at(words, at)) > at:
        return end
    looks = end = at + (words[at : at + 1] != [] and words[at] in _OWN | _ONE)
    while end < len(words) and any(words[end] in table for table in _LOOKS):
        end += 1
    several = end < len(words) and (lexicon.BLOCK.get(words[end]) or lexicon.PATCH.get(words[end]))
    return end + 1 if several and end > looks else at


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
