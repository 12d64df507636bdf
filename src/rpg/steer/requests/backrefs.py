"""References to versions: undo, go back to ..., version N, like before but."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.core.diagnostics import Span
from rpg.steer.requests.language import (
    Parser,
    Results,
    adjectives,
    colors,
    count,
    lexicon,
    literal,
    longest,
    m,
    noun_phrase,
    phrases,
    rule,
)


@dataclass(frozen=True)
class Reference:
    """A version as a request names it: a number, so many steps back, the base, or a description.

    `only`: the description is complete ("just red and blue"). `without`: blocks that the version does not have yet
    ("before I added the green one"). `part`: where in the tower it has what is described, "top" or "bottom".
    """

    span: Span
    number: int | None = None
    steps: int | None = None
    base: bool = False
    description: tuple[m.Meaning, ...] = ()
    marks: tuple[m.Traits, ...] = ()
    only: bool = False
    without: bool = False
    part: str = ""


_UNDO = phrases(
    "undo | revert | back | back please | never mind | nevermind | take that back | take it back | roll back | "
    "rollback | step back | scratch that | forget that | cancel that | go back | go one back | back up | undo that | "
    "undo that last thing | undo the last thing | undo what you just did | undo "
    "it | undo this | revert that | undo the last change | undo the last edit | undo the last step | undo "
    "my last change | revert the last change | undo the change | undo the previous change | go back a "
    "step | undo the latest change | revert the last edit"
)
_BACK = phrases(
    "go back to | return to | revert to | revert back to | go to | get back to | back to | switch back to "
    "| restore | take | roll back to | jump back to | undo to | undo back to | bring back | change back "
    "to | continue from | start from | starting from | from | in | as in | like | same as | like in | "
    "based on | use | take me back to | let us go back to | take us back to | checkout | check out | same as in | "
    "going back to | starting with | turn back to | do the same as in | reuse"
)
_OPEN = phrases(
    "go back to | return to | revert to | revert back to | get back to | back to | switch back to | restore | "
    "roll back to | jump back to | undo to | undo back to | bring back | take me back to | take us back to | "
    "let us go back to | "
    "going back to | change back to | turn back to"
)
_VERSION = frozenset({"version", "v", "variant", "revision", "step", "snapshot", "task", "number"})
_NOUN = frozenset(
    {
        "version",
        "one",
        "variant",
        "task",
        "state",
        "revision",
        "arrangement",
        "setup",
        "step",
        "design",
        "configuration",
        "goal",
    }
)
_BASE = phrases(
    "the original | the base | the beginning | the start | the first | the very first | the very "
    "beginning | the initial | the original base | square one | the starting | the root | how it was at the start | "
    "how it was at the beginning | how it was at the very beginning | how it was at the very start | how it began | "
    "how it was originally | how it was in the beginning | the way it was at the start | where we started | "
    "the way it was at the beginning | what we started with | what it was at the start | what it was originally"
)
_LAST = phrases(
    "the previous | the last | the one before | the earlier | before | the prior | the preceding | what "
    "we had before | what it was before | how it was before | last time | what it was | how it was | the "
    "way it was before | the way it was"
)
_WHEN = phrases(
    "when it was | when there was | when there were | when we had | when it had | when they were | where "
    "it was | the time when it was | where there was | where there were | where we had | when i had | "
    "when you had | when it used | when it only had | when it was a"
)


_ENDS = {
    "top": "on top | at the top | on the top | is on top | was on top | was at the top | topmost | as the top block",
    "bottom": "at the bottom | on the bottom | underneath | was at the bottom | below | lowest | as the bottom block",
}
"""Where in a tower something was."""


@rule
def references(p: Parser, i: int) -> Results[Reference]:
    """A reference to a version at the beginning of a request."""
    yield from _undo(p, i)
    if p.one(i, frozenset({"version", "v"})):
        yield from _numbered(p, i, i)
    for phrase in _BACK:
        if j := p.seq(i, phrase):
            yield from _target(p, i, j, phrase in _OPEN)


def _undo(p: Parser, i: int) -> Iterator[tuple[Reference, int]]:
    for phrase in _UNDO:
        if j := p.seq(i, phrase):
            for n, k in _times(p, j):
                yield Reference(span=p.span(i, k), steps=n), k


def _times(p: Parser, i: int) -> Iterator[tuple[int, int]]:
    if j := longest(p, i, "again | once more | one more time | once again"):
        yield 1, j
    if j := longest(
        p,
        i,
        "twice | two times | both | again and again | both changes | both edits | both steps | both of them",
    ):
        yield 2, j
    if j := longest(p, i, ("the last", "my last", "the previous")) or i:
        for n, k in count(p, j):
            if end := longest(
                p, k, "times | steps | changes | edits | versions | step | change | edit | version | turns"
            ):
                yield n, longest(p, end, ("back", "ago")) or end
    yield 1, i


def _target(p: Parser, i: int, j: int, plainly: bool) -> Iterator[tuple[Reference, int]]:
    """What comes after "go back to"."""
    start = p.opt(j, "the")
    yield from _numbered(p, i, start)
    for phrase in _BASE:
        if k := p.seq(j, phrase):
            end = p.one(k, _NOUN) or k
            yield Reference(span=p.span(i, end), base=True), end
    yield from _latest(p, i, j)
    yield from _before(p, i, j)
    yield from _described(p, i, j, plainly)


def _numbered(p: Parser, i: int, start: int) -> Iterator[tuple[Reference, int]]:
    """Phrases such as "version 2", "v2", "the second version"."""
    if k := p.one(start, _VERSION):
        k = p.opt(k, "number", "no", "#")
        for number, end in count(p, k):
            yield Reference(span=p.span(i, end), number=number), end
    token = p.token(start)
    if token is not None and token.kind == "word" and token.word == "v" and (n := p.number(start + 1)) is not None:
        yield Reference(span=p.span(i, start + 2), number=n), start + 2
    ordinal = p.lex(start, lexicon.ORDINAL)
    if ordinal and (k := p.one(start + 1, frozenset({"version", "edit", "change"}))):
        yield (Reference(span=p.span(i, k), number=ordinal - (p.words[k - 1] == "version")), k)


def _latest(p: Parser, i: int, j: int) -> Iterator[tuple[Reference, int]]:
    """Phrases such as "the previous one", "two steps back"."""
    for phrase in _LAST:
        if k := p.seq(j, phrase):
            end = p.one(k, _NOUN) or k
            if not (phrase == "before" and p.one(k, "i")):
                yield Reference(span=p.span(i, end), steps=1), end
    for n, k in count(p, j):
        if end := longest(
            p,
            k,
            "versions ago | steps back | versions back | steps ago | edits ago | changes ago | version ago | step back",
        ):
            yield Reference(span=p.span(i, end), steps=n), end


def _before(p: Parser, i: int, j: int) -> Iterator[tuple[Reference, int]]:
    """Phrases such as "before I added the green one", "before the letter was added"."""
    k = longest(
        p,
        j,
        "before i added | before we added | before adding | the version before i added | "
        "before you added | the version before adding | the one before i added | the one "
        "without | the version without | when there was no | before there was | when there "
        "were no",
    )
    for phrase, end in noun_phrase(p, k) if k else ():
        yield Reference(span=p.span(i, end), description=(phrase,), without=True), end
    if k := p.one(j, "before"):
        for phrase, end in noun_phrase(p, k):
            if stop := longest(p, end, "was added | were added | came in | was there | got added"):
                yield (Reference(span=p.span(i, stop), description=(phrase,), without=True), stop)


def _described(p: Parser, i: int, j: int, plainly: bool) -> Iterator[tuple[Reference, int]]:
    """Phrases such as "when it was just red and blue", "the letter version", "the version with the purple block"."""
    for phrase in _WHEN:
        if k := p.seq(j, phrase):
            n = longest(p, k, "just | only | simply | still just | still only") or k
            for (listed, _), end in colors(p, n):
                yield (
                    Reference(span=p.span(i, end), marks=(m.Traits(colors=listed),), only=n > k),
                    longest(p, end, ("blocks", "block")) or end,
                )
            for found, end in noun_phrase(p, n):
                yield (Reference(span=p.span(i, end), description=(found,), only=n > k), end)
    start = (
        longest(
            p,
            j,
            "the earlier | the previous | the old | the last | the first | an earlier | that | "
            "our | the original | my earlier",
        )
        or p.one(j, "the")
        or 0
    )
    if start:
        for marks, k in adjectives(p, start):
            if marks and (end := p.one(k, _NOUN - {"one"})):
                yield Reference(span=p.span(i, end), marks=(m.Traits(**marks),)), end
        for found, k in noun_phrase(p, start):
            if end := p.one(k, _NOUN - {"one"}):
                yield Reference(span=p.span(i, end), description=(found,)), end
        if (k := p.one(start, _NOUN)) and (
            n := longest(
                p, k, "with | that had | that has | which had | where it was | where there was | of | using | that used"
            )
        ):
            n = longest(p, n, ("just", "only")) or n
            for found, end in noun_phrase(p, n):
                only = p.words[n - 1] in ("just", "only")
                yield Reference(span=p.span(i, end), description=(found,), only=only), end
                for part, phrases_ in _ENDS.items() if not only else ():
                    if last := longest(p, end, phrases_):
                        yield Reference(span=p.span(i, last), description=(found,), part=part), last
    if plainly:
        word = p.seq(j, "the word") or j
        text = literal(p, word)
        if text is not None and len(text) > 1:  # "go back to CAT"
            spelt = m.Structure(kind="word", det="the", letter=text, span=p.span(j, word + 1))
            yield Reference(span=p.span(i, word + 1), description=(spelt,)), word + 1
        for found, end in noun_phrase(p, j):
            yield (Reference(span=p.span(i, end), description=(found,)), end)
