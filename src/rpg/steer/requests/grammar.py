"""The grammar of edits: verbs of change over the noun phrases and places of the instruction language."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.requests import requests as r
from rpg.steer.requests.adding import add, put, remove
from rpg.steer.requests.amounts import recount
from rpg.steer.requests.changing import arrange, change, paint, resize
from rpg.steer.requests.elliptic import elliptic
from rpg.steer.requests.grouping import group, mixture, outliers
from rpg.steer.requests.language import Parser, Results, colors, count, lexicon, longest, phrases, rule
from rpg.steer.requests.parties import parties
from rpg.steer.requests.parts import parts
from rpg.steer.requests.replacing import free, instead, keep, replace_with, trade
from rpg.steer.requests.sorting import reorder
from rpg.steer.requests.spacing import loosening
from rpg.steer.requests.starts import starts
from rpg.steer.requests.symbols import symbols
from rpg.steer.requests.terse import terse
from rpg.steer.requests.wishes import wish

ALSO = ("too", "as well", "also", "instead", "again", "please", "now", "then")


_CLOSING = phrases(
    "for me | if you can | if possible | rather | , rather | , please | , too | , instead | , though | though | "
    ", now | after all | , i mean | i mean | thanks | , thanks | thank you | , thank you | would be nice | "
    "would be great | sorry | , sorry | "
    "my mistake | , my mistake | if you do not mind | , if possible | , if you can | , again | actually | , actually"
)


@rule
def request(p: Parser, i: int) -> Results[r.Request]:
    """One request, with the small words around it."""
    starts = [skip(p, i)]
    if p.words[starts[0] - 1] == "no":
        starts = [starts[0] - 1] if _bare(p, starts[0]) else [starts[0], starts[0] - 1]
    for j in starts:
        for found, k in _request(p, j):
            yield found, tail(p, k)


def _bare(p: Parser, i: int) -> bool:
    """Whether "no" speaks of what comes right behind it: "no red please"."""
    block = i < p.end and p.lex(i, lexicon.BLOCK) is not None
    return block or any(True for _ in colors(p, i)) or any(True for _ in count(p, i))


def skip(p: Parser, i: int) -> int:
    """The position after words that ask politely, or only say that this is an edit."""
    asides = phrases(
        "please | kindly | now | actually | ok | okay | then | next | also | instead | just | well | great | "
        "good | can you | could you | would you | will you | i want you to | i would like you to | i want to "
        "| i would like to | let us | you should | you can | we should | go ahead and | try to | and | but | "
        "finally | additionally | but also | i need you to | from here | from this | from this version | from "
        "this simpler version | in this version | for this one | from there | this time | hmm | no | wait | "
        "yes | oh | so | from the current version | in addition | furthermore | nah | nope | hey | alright | "
        "all right | "
        "sure | perfect | nice | cool | thanks | thank you | on second thought | wait no | sorry | i think | maybe | "
        "the same but | same but | the same thing but | same thing but | the same task but | "
        "same task but | same again but "
        "| the same again but | exactly the same but | the same thing only | same thing only | like this but | "
        "like that but | like this one but | just like this but | as it is but | as now but | only | "
        "should we | could we | can we | may we | shall we | would you mind | would you please | "
        "perhaps | rather | let me | good job | one more thing | hi | hello | why not | i would rather you | "
        "how about you"
    )
    while True:
        j = longest(p, i, asides) or i
        if (p.words[i], p.words[j]) in (("instead", "of"), ("next", "to")):
            return i
        j = p.opt(j, ",", ":")
        if j == i:
            return i
        i = j


def tail(p: Parser, i: int) -> int:
    while True:
        j = longest(p, i, ALSO) or i
        j = longest(p, j, _CLOSING) or j
        if j == i:
            return i
        i = j


def _request(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    yield from instead(p, i)
    yield from add(p, i)
    yield from put(p, i)
    yield from remove(p, i)
    yield from replace_with(p, i)
    yield from trade(p, i)
    yield from keep(p, i)
    yield from free(p, i)
    yield from reorder(p, i)
    yield from recount(p, i)
    yield from loosening(p, i)
    yield from outliers(p, i)
    yield from mixture(p, i)
    yield from group(p, i)
    yield from change(p, i)
    yield from wish(p, i)
    yield from paint(p, i)
    yield from resize(p, i)
    yield from arrange(p, i)
    yield from elliptic(p, i)
    yield from parties(p, i)
    yield from parts(p, i)
    yield from symbols(p, i)
    yield from terse(p, i)
    yield from starts(p, i)
