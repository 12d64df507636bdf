"""The grammar of edits: verbs of change over the noun phrases and places of the instruction language."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from rpg.steer import requests as r
from rpg.steer.amounts import loosening, recount
from rpg.steer.grouping import group, mixture, outliers
from rpg.steer.language import (
    Parser,
    Results,
    adjectives,
    colors,
    label_list,
    length,
    literal,
    longest,
    m,
    noun_phrase,
    rule,
    simple,
)
from rpg.steer.places import place, places
from rpg.steer.sorting import reorder

ADD = frozenset({"add", "include", "insert", "append", "introduce", "attach", "bring", "throw"})
PUT = frozenset(
    {"put", "place", "stack", "set", "lay", "position", "drop", "move", "bring", "shift", "transfer", "relocate"}
)
REMOVE = ("remove", "delete", "drop", "discard", "eliminate", "lose", "omit", "leave out", "take out", "take away", "take off",
          "get rid of", "do without", "throw away", "throw out", "ditch", "cut", "take", "pull out", "clear away", "exclude")  # fmt: skip
CHANGE = ("change", "turn", "make", "convert", "transform", "switch", "modify", "set", "have", "let", "transition")
PAINT = frozenset({"paint", "color", "colour", "recolor", "recolour", "dye", "repaint"})
REPLACE = ("replace", "substitute", "exchange", "swap out", "switch out", "swap", "switch", "trade")
TRADE = ("swap the positions of", "swap the places of", "exchange the positions of", "swap positions of", "interchange",
         "switch the positions of", "swap the order of", "swap places of", "exchange the places of", "switch places of", "swap",
         "switch", "exchange", "trade")  # fmt: skip
ALSO = ("too", "as well", "also", "instead", "again", "please", "now", "there", "then")


@rule
def request(p: Parser, i: int) -> Results[r.Request]:
    """One request, with the small words around it."""
    j = skip(p, i)
    for found, k in _request(p, j):
        yield found, tail(p, k)


def skip(p: Parser, i: int) -> int:
    """The position after words that ask politely, or only say that this is an edit."""
    phrases = (
        "please", "kindly", "now", "actually", "ok", "okay", "then", "next", "also", "instead", "just", "well", "great", "good",
        "can you", "could you", "would you", "will you", "i want you to", "i would like you to", "i want to", "i would like to",
        "let us", "you should", "you can", "we should", "go ahead and", "try to", "and", "but", "finally", "additionally", "but also",
        "i need you to", "from here", "from this", "from this version", "from this simpler version", "in this version", "for this one",
        "from there", "this time", "hmm", "no", "wait", "yes", "oh", "so", "from the current version", "in addition", "furthermore",
    )  # fmt: skip
    while True:
        j = longest(p, i, phrases) or i
        j = p.opt(j, ",", ":")
        if j == i:
            return i
        i = j


def tail(p: Parser, i: int) -> int:
    while True:
        j = longest(p, i, ALSO) or i
        j = longest(p, j, ("for me", "if you can", "if possible")) or j
        if j == i:
            return i
        i = j


def _request(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    yield from _instead(p, i)
    yield from _add(p, i)
    yield from _put(p, i)
    yield from _remove(p, i)
    yield from _replace(p, i)
    yield from _trade(p, i)
    yield from _keep(p, i)
    yield from reorder(p, i)
    yield from recount(p, i)
    yield from loosening(p, i)
    yield from outliers(p, i)
    yield from mixture(p, i)
    yield from group(p, i)
    yield from _change(p, i)
    yield from _paint(p, i)
    yield from _resize(p, i)
    yield from _arrange(p, i)


def _add(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "add a green block on top of the blue one", "with another red block"."""
    leads = ("there should also be", "there should be", "there must be", "with", "give it", "have")
    j = p.one(i, ADD) or longest(p, i, leads) or i
    j = longest(p, j, ("in", "back")) or j
    verb = p.words[i] in ADD
    for theme, k in things(p, j):
        if _fresh(theme) or (verb and _labelled(theme)):
            for spots, end in places(p, k):
                if spots or j > i:
                    yield r.Add(theme=theme, places=spots, span=p.span(i, end), cost=0 if verb else 2), end
    for spots, k in places(p, j) if verb else ():
        for theme, end in things(p, k) if spots else ():
            if _fresh(theme):
                yield r.Add(theme=theme, places=spots, span=p.span(i, end), cost=1), end


def things(p: Parser, i: int) -> Iterator[tuple[m.Meaning, int]]:
    """Noun phrases, and distractors by that name alone."""
    yield from noun_phrase(p, i)
    j = longest(p, i, ("all the", "the", "all", "any", "these", "those")) or i
    number = 1 if p.one(i, frozenset({"a", "an"})) else p.number(i)
    k = j if j > i else i + 1 if number is not None else i
    k = longest(p, k, ("more", "extra", "random")) or k
    word = p.words[k] if k < p.end else ""
    if word in ("distractor", "distractors", "extras"):
        amount = None if number is None else m.Amount(number, number)
        det = "the" if j > i else "bare" if number is None else "a" if number == 1 else "bare"
        traits = m.Traits(extra=True)
        plural = word.endswith("s")
        yield (
            m.Noun(head="block", det=det, amount=amount, plural=plural, traits=traits, span=p.span(i, k + 1)),
            p.reach(k + 1),
        )


def _put(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "put a green block on top" adds; "put the green block on top" moves."""
    j = p.one(i, PUT)
    if not j:
        return
    for theme, k in noun_phrase(p, j):
        if _fresh(theme):
            for spots, end in places(p, k):
                if spots:
                    yield r.Add(theme=theme, places=spots, span=p.span(i, end)), end
        else:
            for where, end in place(p, k):
                yield r.Move(theme=theme, place=where, span=p.span(i, end)), end
    for where, k in place(p, j):
        for theme, end in noun_phrase(p, k):
            if _fresh(theme):
                yield r.Add(theme=theme, places=(where,), span=p.span(i, end), cost=1), end


def _remove(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    for phrase in (*REMOVE, "without", "no more", "no"):
        if j := p.seq(i, phrase):
            for theme, k in things(p, j):
                end = longest(p, k, ("away", "out", "off", "again")) or k
                if from_ := longest(p, end, ("from", "out of", "off")):
                    for whole, stop in simple(p, from_):
                        if isinstance(whole, m.Structure | m.Pronoun | m.TableTop):
                            yield r.Remove(theme=theme, span=p.span(i, stop)), stop
                if phrase != "take" or end > k:
                    yield r.Remove(theme=theme, span=p.span(i, end)), end


def _replace(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "replace the green cube with a yellow one", "swap the red block for a blue one", "substitute X for Y"."""
    for phrase in REPLACE:
        j = p.seq(i, phrase)
        for old, k in noun_phrase(p, j) if j else ():
            links: tuple[str, ...] = ("with", "by") if phrase == "substitute" else ("with", "by", "for", "out for")
            if n := longest(p, k, links):
                for new, end in noun_phrase(p, n):
                    if _fresh(new) or _plural_kind(new):
                        yield r.Replace(old=old, new=new, span=p.span(i, end)), end
        if j and phrase == "substitute":
            for new, k in noun_phrase(p, j):
                if n := p.one(k, "for"):
                    for old, end in noun_phrase(p, n):
                        yield r.Replace(old=old, new=new, span=p.span(i, end)), end


def _instead(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "use letters instead of colours", "add letter cubes instead of colored ones", "a blue block in place of the red one"."""
    j = (
        longest(
            p,
            i,
            (
                "use",
                "add",
                "put",
                "have",
                "make it with",
                "make them with",
                "with",
                "do it with",
                "try",
                "build it with",
                "take",
                "make it from",
            ),
        )
        or i
    )
    for new, k in noun_phrase(p, j):
        for phrase in ("instead of", "in place of", "rather than", "in lieu of", "and not", "not"):
            if n := p.seq(k, phrase):
                for old, end in _old(p, n):
                    yield r.Replace(old=old, new=new, span=p.span(i, end)), end
        if (end := p.one(k, "instead")) and j > i:
            yield r.Replace(old=None, new=new, span=p.span(i, end), cost=1), end
        if j > i and p.words[i] == "use" and _plural_kind(new):
            yield r.Replace(old=None, new=new, span=p.span(i, k), cost=2), k
    if (j := p.seq(i, "instead of")) or (j := p.seq(i, "rather than")):
        for old, k in _old(p, j):
            n = longest(p, k, (", use", "use", ", put", ",", ", i want"))
            for new, end in noun_phrase(p, n) if n else ():
                yield r.Replace(old=old, new=new, span=p.span(i, end)), end


def _old(p: Parser, i: int) -> Iterator[tuple[m.Meaning | None, int]]:
    """What is given up: blocks of the task, or only their colours."""
    yield from noun_phrase(p, i)
    if j := longest(p, i, ("the colors", "colors", "color", "the color", "colours", "colored", "plain", "the colours")):
        yield m.Noun(head="block", det="all", plural=True, traits=m.Traits(kind="plain"), span=p.span(i, j)), j


def _trade(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap the red and the blue block", "switch the red one with the blue one"."""
    for phrase in TRADE:
        j = p.seq(i, phrase)
        if not j:
            continue
        for both, k in noun_phrase(p, j):
            if isinstance(both, m.Coord) and len(both.items) == 2:
                end = longest(p, k, ("around", "places", "positions")) or k
                yield r.Trade(a=both.items[0], b=both.items[1], span=p.span(i, end)), end
            pair = _pair(both)
            if pair:
                end = longest(p, k, ("around", "places", "positions")) or k
                yield r.Trade(a=pair[0], b=pair[1], span=p.span(i, end)), end
            if n := longest(p, k, ("with", "and", "for")):
                for other, end in simple(p, n):
                    if not _fresh(both) and not _fresh(other):
                        yield r.Trade(a=both, b=other, span=p.span(i, end)), end


def _pair(both: m.Meaning) -> tuple[m.Noun, m.Noun] | None:
    """Phrases such as "the red and blue blocks": two phrases in one."""
    if not isinstance(both, m.Noun) or both.det not in ("the", "bare", "both", "its"):
        return None
    colored, labelled = both.traits.colors, both.traits.labels
    if len(colored) == 2 and not labelled:
        each = [m.Traits(colors=(color,)) for color in colored]
    elif len(labelled) == 2 and not colored:
        each = [m.Traits(labels=(label,)) for label in labelled]
    else:
        return None
    one, two = (m.Noun(head=both.head, det="the", traits=traits, span=both.span) for traits in each)
    return one, two


def _keep(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "keep the letter A on top", "leave the base where it is"."""
    j = longest(p, i, ("keep", "keeping", "leave", "leaving", "except for", "except", "apart from", "other than", "without moving", "without touching", "do not move",
                     "do not touch", "do not change", "without changing"))  # fmt: skip
    for theme, k in noun_phrase(p, j) if j else ():
        end = longest(p, k, ("where it is", "where they are", "as it is", "as they are", "as is", "in place", "the same", "unchanged", "in its place",
                           "alone", "fixed", "there", "untouched", "still", "the way it is", "the way they are"))  # fmt: skip
        if end:
            yield r.Keep(theme=theme, span=p.span(i, end)), end
            continue
        for _, stop in place(p, k):
            yield r.Keep(theme=theme, span=p.span(i, stop)), stop
        if p.words[i] in ("except", "apart", "other", "without", "do"):
            yield r.Keep(theme=theme, span=p.span(i, k)), k


def _change(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change the base cube to purple", "make it bigger", "turn the tower into a row", "make the blocks letters"."""
    for phrase in CHANGE:
        j = p.seq(i, phrase)
        if not j:
            continue
        for theme, k in _themes(p, j):
            n = longest(
                p, k, ("back to", "to be", "back into", "into", "to", "as", "in", "be", "become", "for", "with")
            )
            linked = bool(n)
            for found, end in _becomes(p, i, n or k, theme):
                if linked or phrase in ("make", "turn", "have", "paint", "color", "set", "let"):
                    yield found, end
    for theme, k in noun_phrase(p, i):
        if n := longest(
            p,
            k,
            (
                "should become",
                "should be",
                "must be",
                "becomes",
                "is now",
                "are now",
                "should all be",
                "need to be",
                "needs to be",
            ),
        ):
            yield from _becomes(p, i, n, theme, cost=1)


def _themes(p: Parser, i: int) -> Iterator[tuple[m.Meaning | None, int]]:
    """What is changed: objects, or the colour, letter or size of objects."""
    yield from noun_phrase(p, i)
    if j := longest(p, i, ("the word", "the text", "the spelling")):
        yield m.Structure(kind="word", det="the", span=p.span(i, j)), j
    for phrase in (
        "the color of",
        "the colour of",
        "the letter of",
        "the label of",
        "the size of",
        "the number on",
        "the letter on",
        "the symbol on",
        "the kind of",
        "the type of",
    ):
        if j := p.seq(i, phrase):
            yield from noun_phrase(p, j)
    for theme, j in noun_phrase(p, i):
        if (k := p.one(j, "'s")) and (
            end := longest(p, k, ("color", "colour", "letter", "label", "size", "number", "symbol"))
        ):
            yield theme, end


def _becomes(p: Parser, i: int, n: int, theme: m.Meaning | None, cost: int = 0) -> Iterator[tuple[r.Request, int]]:
    for how, k in _scale(p, n):
        yield r.Restyle(theme=theme, scale=how, span=p.span(i, k), cost=cost), k
    start = p.opt(n, "all", "both", "each")
    for marks, k in adjectives(p, start):
        if marks and not set(marks) & {"rank", "extra", "target", "matching", "empty", "shape", "long"}:
            yield r.Restyle(theme=theme, traits=m.Traits(**marks), span=p.span(i, k), cost=cost), k
    for (labels, _), k in label_list(
        p, longest(p, n, ("the letter", "the number", "letter", "number", "a", "an")) or n, True
    ):
        yield r.Restyle(theme=theme, traits=m.Traits(labels=labels), span=p.span(i, k), cost=cost + 1), k
    text = literal(p, n)
    if text is not None and len(text) > 1 and isinstance(theme, m.Structure | m.Pronoun):
        word = m.Structure(kind="word", letter=text, span=p.span(n, n + 1))
        yield r.Reshape(structure=word, theme=theme, span=p.span(i, n + 1), cost=cost), n + 1
    for new, k in noun_phrase(p, n):
        if isinstance(new, m.Structure):
            yield r.Reshape(structure=new, theme=theme, span=p.span(i, k), cost=cost), k
        elif _fresh(new) or _plural_kind(new):
            yield r.Replace(old=theme, new=new, span=p.span(i, k), cost=cost), k


def _scale(p: Parser, i: int) -> Iterator[tuple[float, int]]:
    for phrase, factor in (
        ("twice as big", 2.0), ("twice as large", 2.0), ("half as big", 0.5), ("half the size", 0.5), ("double the size", 2.0),
        ("a bit bigger", 1.25), ("slightly bigger", 1.25), ("slightly larger", 1.25), ("a bit smaller", 0.75), ("slightly smaller", 0.75),
        ("bigger", 1.25), ("larger", 1.25), ("smaller", 0.75), ("tinier", 0.75), ("a little bigger", 1.25), ("a little smaller", 0.75),
    ):  # fmt: skip
        if j := p.seq(i, phrase):
            yield factor, j


_FORM = (
    "arrange",
    "rearrange",
    "put",
    "place",
    "line up",
    "build",
    "stack",
    "set",
    "lay out",
    "organize",
    "lay",
    "form",
    "make",
)


def _arrange(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "arrange them in a circle instead", "make a pyramid out of the same blocks", "in a row instead"."""
    for phrase in _FORM:
        j = p.seq(i, phrase)
        for theme, k in noun_phrase(p, j) if j else ():
            n = longest(p, k, ("so that they form", "in the shape of", "in", "into", "as", "to form", "up as", "up in"))
            for shape, end in noun_phrase(p, n) if n else ():
                if isinstance(shape, m.Structure) and not isinstance(theme, m.Structure) and not _fresh(theme):
                    yield r.Reshape(structure=shape, theme=theme, span=p.span(i, end)), end
        for shape, k in noun_phrase(p, j) if j else ():
            end = longest(p, k, _SAME_BLOCKS)
            if isinstance(shape, m.Structure) and end:
                yield r.Reshape(structure=shape, span=p.span(i, end)), end
            if isinstance(shape, m.Structure) and shape.members is None and (end := p.one(k, "instead")):
                yield r.Reshape(structure=shape, span=p.span(i, end), cost=1), end
    if j := longest(p, i, ("in", "as", "into")):
        for shape, k in noun_phrase(p, j):
            if isinstance(shape, m.Structure) and (end := p.one(k, "instead")):
                yield r.Reshape(structure=shape, span=p.span(i, end)), end
    for shape, k in noun_phrase(p, i):
        n = longest(p, k, ("instead of", "rather than"))
        for old, end in noun_phrase(p, n) if n else ():
            if isinstance(shape, m.Structure) and isinstance(old, m.Structure):
                yield r.Reshape(structure=shape, theme=replace(old, det="the"), span=p.span(i, end)), end


_SAME_BLOCKS = tuple(
    f"{by} {blocks}"
    for by in ("out of", "from", "with", "of", "using")
    for blocks in (
        "the same blocks",
        "the same cubes",
        "these blocks",
        "them",
        "the blocks",
        "those blocks",
        "all of them",
        "these",
    )
)


def _paint(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    j = p.one(i, PAINT)
    for theme, k in noun_phrase(p, j) if j else ():
        k = p.opt(k, "in", "to")
        for (listed, either), end in colors(p, k):
            yield r.Restyle(theme=theme, traits=m.Traits(colors=listed, either=either), span=p.span(i, end)), end
    if j := p.one(i, frozenset({"relabel", "label", "rename"})):
        for theme, k in noun_phrase(p, j):
            k = longest(p, k, ("as", "to", "with")) or k
            for (labels, _), end in label_list(
                p, longest(p, k, ("the letter", "letter", "number", "a", "an")) or k, True
            ):
                yield r.Restyle(theme=theme, traits=m.Traits(labels=labels), span=p.span(i, end)), end


def _resize(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "resize the red block to 5 cm", "enlarge it", "shrink the patch"."""
    for word, factor in (("enlarge", 1.25), ("grow", 1.25), ("shrink", 0.75), ("reduce", 0.75), ("resize", None)):
        j = p.one(i, word)
        for theme, k in noun_phrase(p, j) if j else ():
            if n := p.one(k, "to"):
                for metres, end in length(p, n):
                    yield r.Restyle(theme=theme, traits=m.Traits(edge=metres), span=p.span(i, end)), end
            if factor:
                yield r.Restyle(theme=theme, scale=factor, span=p.span(i, k)), k


def _fresh(phrase: m.Meaning) -> bool:
    """Whether a phrase brings in new objects: "a block", "another one", "two more", "some letters"."""
    match phrase:
        case m.Noun():
            counted = phrase.amount is not None and phrase.det in ("bare", "another")
            return phrase.part_of is None and (
                phrase.det in ("a", "another", "some") or counted or _plural_kind(phrase)
            )
        case m.Coord():
            return all(_fresh(item) for item in phrase.items)
        case _:
            return False


def _labelled(phrase: Any) -> bool:
    """Phrases such as "add letter A": one object, with no article."""
    if isinstance(phrase, m.Coord):
        return all(_fresh(item) or _labelled(item) for item in phrase.items)
    bare = isinstance(phrase, m.Noun) and phrase.det == "bare" and phrase.part_of is None
    return bare and bool(phrase.traits.labels or phrase.traits.colors or phrase.traits.extra)


def _plural_kind(phrase: Any) -> bool:
    """Phrases such as "letters", "coloured blocks": a kind of block rather than certain ones."""
    return isinstance(phrase, m.Noun) and phrase.det in ("bare", "some") and phrase.plural and phrase.amount is None
