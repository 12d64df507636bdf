"""Names with what they are right behind them: "put the green cube on the lava (the red patch)", "the grass, that is the
green patch", "the patches are plates".

A name means nothing here: the thing stands in its place, there and wherever the name stands again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.harmless import ANIMALS, PEOPLE
from rpg.language.nicknames import (
    PLACES,
    ROLES,
    again,
    as_a_kind,
    colored,
    definite,
    labels,
    names_at,
    said,
    strange,
    thing_at,
)
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_IS = (("that", "is"), ("which", "is"), ("meaning",), ("namely",), ("i", "mean"))
_CALLED = (("called",), ("alias",), ("also", "called"), ("aka",), ("=",), ("that", "is"), ("or",))
_ARTICLES = frozenset({"the", "a", "an", "my", "our", "your"})
_BEFORE = frozenset({".", ",", ";", ":", "!", "?", "and"})
_CLOSED = frozenset({",", ".", ";", "!", "?", ")"})
_MEANS = {True: "is", False: "stands for"}
_KINDS = {**lexicon.BLOCK, **lexicon.PATCH}


@dataclass(frozen=True)
class _Gloss:
    """Where a gloss stands; the name in it; and what it is, as it is to be said there and wherever it is named."""

    begin: int
    end: int
    named: list[Token]
    here: list[Token]
    thing: list[Token]

    @property
    def name(self) -> list[str]:
        return [token.word for token in self.named]


def without_glosses(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the things themselves for names that are told what they are, and notes of these."""
    found: list[_Gloss] = []
    at = 0
    while at < len(tokens):
        gloss = next(_glossed(tokens, at), None)
        found += [gloss] if gloss is not None else []
        at = gloss.end if gloss is not None else at + 1
    names = [(gloss.name, gloss.thing) for gloss in found] + [x for gloss in found for x in _several(gloss)]
    out: list[Token] = []
    at = 0
    for gloss in found:
        out += [*again(tokens[at : gloss.begin], names), *gloss.here]
        at = gloss.end
    notes = [f"'{said(gloss.named)}' {_MEANS[len(gloss.thing) > 1]} {said(gloss.thing)}" for gloss in found]
    return ([*out, *again(tokens[at:], names)], notes) if found else (tokens, [])


def _glossed(tokens: list[Token], at: int) -> Iterator[_Gloss]:
    """A gloss that begins here."""
    words = [token.word for token in tokens]
    yield from _kind(tokens, words, at)
    yield from _named_first(tokens, words, at)
    thing = thing_at(words, at)
    if thing > at and words[thing : thing + 1] == ["("]:
        name = thing + 1 + length_at(words, thing + 1, _CALLED)
        name += words[name : name + 1] != [] and words[name] in _ARTICLES
        letter = words[name + 1 : name + 2] == [")"] and labels(tokens[name]) and words[name].isalpha()
        letter = letter and words[name] not in ("a", "i")
        end = name + 1 if letter else _name(tokens, name)
        if end > name and words[end : end + 1] == [")"] and _elsewhere(words, name, end):
            yield _Gloss(at, end + 1, tokens[name:end], tokens[at:thing], definite(tokens[at:thing]))


def _named_first(tokens: list[Token], words: list[str], at: int) -> Iterator[_Gloss]:
    """ "the lava (the red patch)", "the grass, that is the green patch,", "the target, a yellow cube,"."""
    name = at + (words[at] in _ARTICLES)
    end, labelled = next(names_at(tokens, words, name), (name, False))
    if end > name and name == at and not labelled and not strange(tokens[end - 1]):
        return
    mark = words[end] if name < end < len(words) else ""
    begin = end + 1 + length_at(words, end + 1, _IS) if mark in ("(", ",") else 0
    bare = mark == "," and begin == end + 1
    if not begin or begin >= len(words) or (bare and (words[begin] not in ("a", "an") or name == at)):
        return
    thing = thing_at(words, begin)
    hue = mark == "(" and words[begin] in lexicon.COLOR and words[begin + 1 : begin + 2] == [")"]
    if hue and words[end - 1] in PEOPLE | ANIMALS:  # no patch would be called so
        told = [tokens[begin].saying("the"), tokens[begin], tokens[begin].saying("block")]
        yield _Gloss(at, begin + 2, tokens[name:end], told, told)
        return
    closed = words[thing : thing + 1] == [")"] if mark == "(" else thing == len(words) or words[thing] in _CLOSED
    if bare and (words[thing : thing + 2] == [",", "and"] or not _apposed(tokens, words, (at, name, end), thing)):
        return
    if thing > begin and closed and (not as_a_kind(tokens[name:end]) or colored(words[begin:thing])):
        told = definite(tokens[begin:thing])
        last = thing + (mark == "(" or words[thing : thing + 1] == [","])
        yield _Gloss(at, last, tokens[name:end], told, told)


def _apposed(tokens: list[Token], words: list[str], name: tuple[int, int, int], thing: int) -> bool:
    """Whether a thing is what is named in front of its comma: "(put it on) the anchor, a red cube"; but not where it is
    what lies at a place that is told first, "on the mat, a red cube", nor behind a letter, which blocks show."""
    at, begin, end = name
    place = words[end - 1] in PLACES - ROLES
    while at and words[at - 1] in _PLACED:
        at -= 1
    closed = any(words[n] == "," and thing_at(words, n + 1) == at - 1 for n in range(max(0, at - _NEAR), at - 1))
    fronted = at < name[0] and (at == 0 or words[at - 1] in _BEFORE) and not closed
    letter = end == begin + 1 and labels(tokens[begin])
    return not fronted and not letter and (not place or words[thing - 1] in lexicon.PATCH)


_NEAR = 8
_PLACED = frozenset({"on", "onto", "in", "into", "at", "to", "front", "of", "behind", "left", "right", "next", "beside",
                     "above", "below", "under", "near", "around", "between", "top", "the", "with", "from"})  # fmt: skip


def _kind(tokens: list[Token], words: list[str], at: int) -> Iterator[_Gloss]:
    """ "each patch is a plate", "the cubes are people": what all of a kind are called."""
    begins = at == 0 or words[at - 1] in _BEFORE
    noun = at + (words[at] in ("each", "every", "the", "all"))
    noun += words[noun - 1 : noun + 1] == ["all", "the"]
    many = noun if words[noun : noun + 1] != [] and words[noun] in lexicon.NUMBER else None
    noun += many is not None
    plural = _KINDS.get(words[noun]) if begins and noun < len(words) else None
    if plural is None or not (plural or words[at] in ("each", "every")):
        return
    name = noun + 2 + (words[noun + 2 : noun + 3] != [] and words[noun + 2] in _ARTICLES)
    end = name
    if words[noun + 1 : noun + 2] == ["are" if plural else "is"]:
        same = any({words[noun], *words[name : name + 1]} <= table.keys() for table in (lexicon.BLOCK, lexicon.PATCH))
        end = name + 1 if same else _name(tokens, name)
    if end == name + 1 and (end == len(words) or words[end] in _CLOSED) and _elsewhere(words, name, end, plural):
        end += words[end : end + 1] != []
        there = [tokens[at].saying(word) for word in ("there", "are")]
        here = [*there, tokens[many], tokens[noun], tokens[noun].saying(".")] if many is not None else []
        yield _Gloss(at, end, tokens[name : name + 1], here, [tokens[noun]])


def _several(gloss: _Gloss) -> Iterator[tuple[list[str], list[Token]]]:
    """One of a kind for several, and the other way round."""
    noun = gloss.thing[-1]
    if len(gloss.thing) != 1:
        return
    one = next(x for x in _KINDS if not _KINDS[x] and noun.word in (x, lexicon.plural_of(x)))
    name = gloss.name[0].removesuffix("s") if _KINDS[noun.word] else lexicon.plural_of(gloss.name[0])
    yield [name], [noun.saying(one if _KINDS[noun.word] else lexicon.plural_of(one))]


def _name(tokens: list[Token], at: int) -> int:
    """The position behind one or two words that mean nothing here; `at` where none stand there."""
    end = at
    while end < len(tokens) and end < at + 2 and strange(tokens[end]):
        end += 1
    return end


def _elsewhere(words: list[str], name: int, end: int, plural: bool = False) -> bool:
    """Whether a name stands again."""
    forms = [words[name:end], [*words[name : end - 1], lexicon.plural_of(words[end - 1])]]
    forms += [[*words[name : end - 1], words[end - 1].removesuffix("s")]] if plural else []
    return any(words[n : n + end - name] in forms for n in range(len(words)) if not name <= n < end)
