"""Names that are told what they are: "bin 1 is the red patch", "landmark: black cube", "let A be the red cube", "sheep
are white cubes", "call the red cube Bob".

A name means nothing here, or something else: what it is stands in its place wherever it is named again, and where it is
told there is such a thing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language import lexicon
from rpg.language.nicknames import (
    PLACES,
    as_a_kind,
    colored,
    labels,
    named_behind,
    names_at,
    said,
    thing_at,
    things_at,
)
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_LED = frozenset({"let", "where", "suppose", "say", "pretend", "imagine", "assume"})
_BEFORE = frozenset({".", ",", ";", ":", "!", "?", "and", "("}) | _LED
"""What a naming stands behind."""
_IS = (("is",), (":",), ("=",), ("be",), ("means",), ("will", "be"), ("shall", "be"), ("stands", "for"), ("are",),
       ("refers", "to"), ("denotes",), ("denote",))  # fmt: skip
_CLOSED = frozenset({",", ".", ";", "!", "?", "and", ")"})
_PARTING = frozenset({",", "and"})
_ARTICLES = frozenset({"the", "a", "an", "my", "our", "your"})
_DETERMINED = frozenset({"a", "an", "all", "each", "every", "any", "one", "no", "both", "these", "those", "this",
                         "that", *lexicon.NUMBER})  # fmt: skip
_LOOKS = lexicon.COLOR.keys() | lexicon.SIZE.keys()
_OF_LETTERS = _CLOSED | {"is", "=", ":", "be", "are", "goes", "on", "onto", "should", "must", "to", "in", "into",
                         "behind", "left", "right", "next", "beside", "under", "above", "has", "will", "stays",
                         "between", "means", "denotes"}  # fmt: skip
"""Behind an "A" that is a name, and no article."""


@dataclass(frozen=True)
class _Naming:
    """Where a naming stands; the name in it; the look and the noun of what it is; and whether that is told first."""

    begin: int
    end: int
    name: list[Token]
    thing: list[Token]
    behind: bool = False

    @property
    def words(self) -> list[str]:
        return [token.word for token in self.name]

    @property
    def plural(self) -> bool:
        return bool({**lexicon.BLOCK, **lexicon.PATCH}.get(self.thing[-1].word))


def with_names(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the things themselves for names that are told what they are, and notes of these."""
    words = [token.word for token in tokens]
    found: list[_Naming] = []
    at = 0
    while at < len(tokens):
        naming = next(_named(tokens, words, at, found), None) if at == 0 or words[at - 1] in _BEFORE else None
        found += [naming] if naming is not None else []
        at = naming.end if naming is not None else at + 1
    names = [pair for naming in found for pair in _forms(naming)]
    outside = set(range(len(words))) - {n for naming in found for n in range(naming.begin, naming.end)}
    used = [n for n, naming in enumerate(found) if any(_stands(tokens, words, at, name) for at in outside
            for name, _ in _forms(naming))]  # fmt: skip
    if not used and not any(naming.behind or as_a_kind(naming.name) for naming in found):
        return tokens, []
    out: list[Token] = []
    at = 0
    for n, naming in enumerate(found):
        first = tokens[naming.begin]
        there = ("there", "are") if naming.plural else ("there", "is", "a")
        led = naming.begin - (naming.begin > 0 and words[naming.begin - 1] in _LED)
        led -= 2 * (led < naming.begin and words[max(0, led - 2) : led] == ["let", "us"])
        set_off = led < naming.begin and led > at and words[led - 1] == ","
        out += _again(tokens, words, at, led - set_off, names)
        out += [first.saying(".")] if set_off else []
        out += [*map(first.saying, there), *naming.thing] if n not in used or not naming.plural else []
        at = naming.end
        if words[at : at + 1] and words[at] in _PARTING:
            out.append(tokens[at].saying("."))
            at += 1 + (words[at : at + 2] == [",", "and"])
        if out and out[-1].word == "." and words[at : at + 1] == ["."]:
            at += 1
    return [*out, *_again(tokens, words, at, len(tokens), names)], [
        f"'{said(naming.name)}' {'are' if naming.plural else 'is the'} {said(naming.thing)}" for naming in found
    ]


def _named(tokens: list[Token], words: list[str], at: int, found: Sequence[_Naming]) -> Iterator[_Naming]:
    """A naming that begins here; behind another one it may go on without "is", "let A be the red cube and B the blue
    one"."""
    for begin, behind, name, end in named_behind(tokens, words, at, bool(found)):
        own = begin + (words[begin] in _ARTICLES)
        yield _Naming(at, end, tokens[name:end], _look(tokens[own:behind]), True)
    letter = labels(tokens[at]) and words[at + 1 : at + 2] != [] and words[at + 1] in _OF_LETTERS
    name = at + (words[at] in _ARTICLES and not letter)
    for end, labelled in names_at(tokens, words, name):
        verb = length_at(words, end, _IS)
        begin = end + verb
        letter = end == name + 1 and labels(tokens[name])
        if letter and (
            (words[at - 1 : at] == ["and"] and labels(tokens[at - 2]))
            or words[end : end + 2] in (["is", "a"], ["is", "an"], ["are", "the"])
        ):
            continue  # it shows that letter
        if begin >= len(words) or not (verb or (found and (labelled or words[begin] in _ARTICLES))):
            continue
        thing = things_at(words, begin)
        if thing > begin and (thing == len(words) or words[thing] in _CLOSED) and not _listed(words, thing):
            own = begin + (words[begin] in _ARTICLES)
            if not as_a_kind(tokens[name:end]) or colored(words[own:thing]):
                yield _Naming(at, thing, tokens[name:end], _look(tokens[own:thing]))
        noun = _noun(words, name, end)
        if verb and labelled and noun and words[begin] in _LOOKS:
            if as_a_kind(tokens[name:end]) and not colored(words[begin : begin + 1]):
                continue
            closed = begin + 1 == len(words) or words[begin + 1] in _CLOSED
            if closed:
                yield _Naming(at, begin + 1, tokens[name:end], [tokens[begin], tokens[name].saying(noun)])


def _noun(words: list[str], name: int, end: int) -> str:
    """Of what a name is, where its look alone is told: "zone 1 is red", "block X: blue", "the target cube is green"."""
    if words[end - 1] in lexicon.BLOCK:
        return words[end - 1]
    if words[name] in lexicon.BLOCK:
        return words[name] if words[end] in (":", "=") else ""
    return words[name] if words[name] in lexicon.PATCH else "patch" if words[name] in PLACES else ""


def _listed(words: list[str], at: int) -> bool:
    """Whether more things follow, "a red cube, a blue cube and ...": what is to be made, and no name."""
    begin = at + (words[at : at + 1] == [","]) + (words[at : at + 1] == ["and"] or words[at : at + 2] == [",", "and"])
    return begin > at and begin < len(words) and words[begin] in _ARTICLES and thing_at(words, begin) > begin


def _look(thing: list[Token]) -> list[Token]:
    """A thing without its article; "blue one" as a block."""
    return [*thing[:-1], thing[-1].saying("block")] if thing[-1].word == "one" else thing


def _forms(naming: _Naming) -> Iterator[tuple[list[str], list[Token]]]:
    """The forms of a name, and what is said for each: one of several is called as they are."""
    yield naming.words, naming.thing
    if naming.plural:
        noun = naming.thing[-1]
        one = next(x for x in (*lexicon.BLOCK, *lexicon.PATCH) if lexicon.plural_of(x) == noun.word)
        single = [*naming.words[:-1], naming.words[-1].removesuffix("s")]
        yield single, [*naming.thing[:-1], replace(noun, word=one, raw=one)]


def _stands(tokens: list[Token], words: list[str], at: int, name: list[str]) -> bool:
    """Whether a name stands here; an "a" in front of what it would be said of is none, nor "target" in front of a
    patch."""
    end = at + len(name)
    if words[at:end] != name:
        return False
    if len(name) > 1 or len(name[0]) > 1:
        shown = tokens[end - 1].kind == "number" or len(name[-1]) > 1 or tokens[end - 1].raw.isupper()
        return shown and (end == len(words) or words[end] not in lexicon.PATCH)
    return tokens[at].raw.isupper() and (name != ["a"] or end == len(words) or words[end] in _OF_LETTERS)


def _again(
    tokens: list[Token], words: list[str], at: int, end: int, names: Sequence[tuple[list[str], list[Token]]]
) -> list[Token]:
    """A part of the text with the things in place of their names."""
    out: list[Token] = []
    while at < end:
        hit = next(((n, t) for n, t in names if _stands(tokens, words, at, n)), None)
        if hit is None:
            out.append(tokens[at])
            at += 1
            continue
        name, thing = hit
        before = out[-1].word if out else ""
        if before in _ARTICLES - {"a", "an"}:
            out[-1] = out[-1].saying("the")
        elif before not in _DETERMINED and not (lexicon.BLOCK.get(thing[-1].word) or lexicon.PATCH.get(thing[-1].word)):
            out.append(tokens[at].saying("the"))
        out += [replace(token, span=tokens[at].span) for token in thing]
        at += len(name)
    return out
