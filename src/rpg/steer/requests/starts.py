"""Requests about how the blocks start: scattered, or in the tower of the goal turned round."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, longest, m, noun_phrase

_WHO = (
    "them | they | it | everything | all of them | all | both | both of them | the two | the two blocks | the blocks | "
    "all blocks | all the blocks | the tower | the stack | these | those | all three | all four | everything else | "
    "all three blocks | all four blocks | them all | all three of them | all of the blocks | all five | "
    "the three blocks"
)
_STARTS = (
    "start | starts | start out | starts out | start off | begin | begins | should start | should start out | "
    "must start | should begin | all start | all start out | both start | both start out | to start | to start out | "
    "should all start | are at the start | should be at the start"
)
_BEFORE = "at the start | in the beginning | at the beginning | initially | at first | to begin with | when it starts"
_SCATTERED = (
    "scattered | scattered about | scattered around | scattered on the table | apart | separately | spread out | "
    "unstacked | on the table | each on the table | lying around | anywhere | anywhere on the table | lying about | "
    "at random places | in random places | randomly"
)
_HEAPED = (
    "in a heap | in a pile | in one heap | in one pile | as a heap | as a pile | heaped up | in a messy heap | "
    "in a messy pile | in a jumbled heap | in a jumbled pile | jumbled in a heap | all in a heap | all in a pile | "
    "in a big heap | in a big pile | lying in a heap | lying in a pile | already in a heap | piled up in a heap"
)
_LINED = (
    "in a row | in a line | in one row | in one line | lined up | lined up in a row | all in a row | side by side | "
    "next to each other in a row | standing in a row | lying in a row | side by side in a row | in a single row"
)
_THE_START = (
    "let the start be | the start should be | the start is | the start must be | the start has to be | "
    "have the start be | "
    "make the start | the start state should be | let the initial state be | the initial state is | "
    "the initial state should be | change the start to | let the beginning be | the beginning should be | "
    "let the episode start | the episode should start | the episode starts | let it start | it should start"
)
_FROM_HEAP = (
    "start from a heap | start from a pile | start with a heap | start out from a heap | start in a heap | "
    "start in a pile | begin from a heap | begin with a heap | begin in a heap | start out in a heap"
)
_TURNED = (
    "stacked the other way round | stacked the other way around | stacked upside down | stacked in reverse | "
    "stacked in reverse order | stacked in the opposite order | the other way round | the other way around | "
    "upside down | in reverse order | in the opposite order | reversed | as the reversed tower | in the reverse order"
)


_NOT_STACKED = "instead of stacked | rather than stacked | not stacked | , not stacked | instead of in a stack"


@dataclass(frozen=True, slots=True, kw_only=True)
class Begin(r.Request):
    """How the episode begins: "scattered", "heap", "row", "reverse". `told`: the blocks of a stack from its top."""

    how: str
    told: tuple[m.Meaning, ...] = ()


def starts(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """How the blocks begin, in a sentence of its own."""
    if j := longest(p, i, _FROM_HEAP):
        yield Begin(how="heap", span=p.span(i, j)), j
    yield from _starts(p, i)


def _starts(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "let them start scattered", "the two start out stacked the other way round, white on red"."""
    for j in _subject(p, i):
        j = p.opt(j, "all", "out", "off", "both")
        if k := longest(p, j, _SCATTERED):
            k = longest(p, k, _NOT_STACKED) or k
            yield Begin(how="scattered", span=p.span(i, k)), k
        if k := longest(p, j, _HEAPED):
            yield Begin(how="heap", span=p.span(i, k)), k
        if k := longest(p, j, _LINED):
            yield Begin(how="row", span=p.span(i, k)), k
        if k := longest(p, j, _TURNED):
            yield Begin(how="reverse", span=p.span(i, k)), k
            for told, end in _pile(p, p.opt(k, ",", ":")):
                yield Begin(how="reverse", told=told, span=p.span(i, end)), end


def _subject(p: Parser, i: int) -> Iterator[int]:
    """The position after "they start", "let them start", "start with all of them", "at the start they are"."""
    if j := longest(
        p, i, "start | begin | start out | start them | start them all | start all of them | begin with them"
    ):
        yield j
    if begun := longest(p, i, _THE_START):
        yield begun
        whose = longest(p, longest(p, begun, "with | that | such that | having") or begun, _WHO)
        if whose:
            yield longest(p, whose, "are | is | being | lying | standing | stand | lie") or whose
    lead = longest(p, i, "let | have | make") or i
    if (j := longest(p, lead, _WHO)) and (k := longest(p, j, _STARTS)):
        yield k
    if (j := longest(p, i, "start with | begin with | start out with")) and (k := longest(p, j, _WHO)):
        yield k
    j = longest(p, i, _BEFORE)
    k = longest(p, p.opt(j, ","), _WHO) if j else 0
    if k and (end := longest(p, k, "are | is | should be | must be | lie | stand | should stand | should lie")):
        yield end


def _pile(p: Parser, i: int) -> Iterator[tuple[tuple[m.Meaning, ...], int]]:
    """Phrases such as "white on red": what lies on what, from the top."""
    for upper, j in noun_phrase(p, i):
        k = longest(p, j, "on | on top of | is on | lies on")
        for lower, end in noun_phrase(p, k) if k else ():
            yield (upper, lower), end
        for rest, end in _pile(p, k) if k else ():
            yield (upper, *rest), end
