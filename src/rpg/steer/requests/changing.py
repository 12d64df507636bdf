"""Requests that change how objects look, or what they form."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import (
    Parser,
    adjectives,
    colors,
    label_list,
    length,
    literal,
    longest,
    m,
    noun_phrase,
    phrases,
)
from rpg.steer.requests.phrases import fresh, labelled, old, plural_kind, subjects

CHANGE = ("change", "turn", "make", "convert", "transform", "switch", "modify", "set", "have", "let", "transition")


SHOULD = phrases(
    "should become | should be | must be | becomes | is now | are now | should all be | need to be | needs to be | "
    "ought to be | has to be | have to be | shall be | could be | can be | might be | is to be | are to be | "
    "should rather be | would rather be | "
    "should now be | should instead be | must become | had better be | were | will be | should both be"
)


_PAINTED = phrases(
    "painted | painted in | recolored | recoloured | recolored in | recoloured in | recolored to | recoloured to | "
    "dyed | turned | changed to | changed into"
)
PAINT = frozenset({"paint", "color", "colour", "recolor", "recolour", "dye", "repaint"})


def change(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change the base cube to purple", "make it bigger", "turn the tower into a row"."""
    for phrase in CHANGE:
        j = p.seq(i, phrase)
        if not j:
            continue
        for theme, k in _themes(p, j):
            if theme is None or not old(theme):
                continue
            n = longest(p, k, "back to | to be | back into | into | to | as | in | be | become | for | with")
            linked = bool(n)
            for found, end in becomes(p, i, n or k, theme):
                if linked or phrase in ("make", "turn", "have", "paint", "color", "set", "let"):
                    yield found, end
    for theme, k in _themes(p, i):
        if (n := longest(p, k, SHOULD)) and theme is not None and old(theme):
            yield from becomes(p, i, longest(p, n, _PAINTED) or n, theme, cost=1)
        elif (n := longest(p, k, "is | are")) and theme is not None and old(theme):
            for found, end in becomes(p, i, n, theme, cost=1):
                if isinstance(found, r.Restyle) and found.former != r.NO_TRAITS:
                    yield found, end


def _themes(p: Parser, i: int) -> Iterator[tuple[m.Meaning | None, int]]:
    """What is changed: objects, or the colour, letter or size of objects."""
    yield from subjects(p, i)
    for phrase in (
        "the color of",
        "the colour of",
        "the letter of",
        "the label of",
        "the size of",
        "the edge length of",
        "the edge of",
        "the side length of",
        "the number on",
        "the letter on",
        "the symbol on",
        "the kind of",
        "the type of",
    ):
        if j := p.seq(i, phrase):
            yield from subjects(p, j)
    for theme, j in noun_phrase(p, i):
        if (k := p.one(j, "'s")) and (end := longest(p, k, "color | colour | letter | label | size | number | symbol")):
            yield theme, end


def becomes(p: Parser, i: int, n: int, theme: m.Meaning | None, cost: int = 0) -> Iterator[tuple[r.Request, int]]:
    """What `theme` is to be, from n on: another size, colour, symbol, structure, or something else altogether."""
    for how, k in _scale(p, n):
        yield r.Restyle(theme=theme, scale=how, span=p.span(i, k), cost=cost), k
    start = p.opt(n, "all", "both", "each")
    of_some = isinstance(theme, m.Pronoun) and theme.word in _DETERMINERS
    for marks, k in adjectives(p, start):
        if of_some and {"kind", "colors"} <= set(marks):
            continue
        if marks and not set(marks) & (_NO_LOOKS if _patch(theme) else _NO_LOOKS | _OF_PATCHES):
            styled = r.Restyle(theme=theme, traits=m.Traits(**marks), span=p.span(i, k), cost=cost)
            yield styled, k
            n_former = longest(p, k, _INSTEAD_OF)
            for former, end in adjectives(p, n_former) if n_former else ():
                if set(former) == set(marks):
                    yield replace(styled, former=m.Traits(**former), span=p.span(i, end)), end
    if _no_symbols(p, n):
        return
    said = longest(p, n, "the letter | the number | letter | number | a | an")
    for (labels, _), k in label_list(p, said or n, True):
        plainly = bool(said) or not all(label.isdigit() for label in labels)
        told = r.Restyle(theme=theme, traits=m.Traits(labels=labels), plainly=plainly, span=p.span(i, k), cost=cost + 1)
        yield told, k
    said = longest(p, n, "spell | spell out | say | read | write") or n
    text = literal(p, said)
    if text is not None and len(text) > 1 and isinstance(theme, m.Structure | m.Pronoun):
        word = m.Structure(kind="word", letter=text, span=p.span(said, said + 1))
        yield (r.Reshape(structure=word, theme=theme, span=p.span(i, said + 1), cost=cost), said + 1)
    for new, k in noun_phrase(p, n):
        if isinstance(new, m.Structure):
            if new.kind == "equation":
                continue
            if new.kind == "column" and (end := p.seq(k, "on the table")):
                k = end
            yield r.Reshape(structure=new, theme=theme, span=p.span(i, k), cost=cost), k
            n = longest(p, k, _INSTEAD_OF)
            for lost, end in noun_phrase(p, n) if n else ():
                if isinstance(lost, m.Structure):
                    yield r.Reshape(structure=new, theme=theme, span=p.span(i, end), cost=cost), end
        elif plural_kind(new) and isinstance(new, m.Noun) and _sized(new.traits):
            yield r.Restyle(theme=theme, traits=new.traits, span=p.span(i, k), cost=cost), k
        elif (fresh(new) and not _mere_number(new)) or plural_kind(new):
            yield r.Replace(old=theme, new=new, span=p.span(i, k), cost=cost), k
        elif (
            isinstance(new, m.Noun)
            and new.det == "bare"
            and new.head == "block"
            and labelled(new)
            and theme is not None
        ):
            one = replace(new, det="a", amount=m.Amount(1, 1))
            yield r.Replace(old=theme, new=one, span=p.span(i, k), cost=cost + 2), k


def _no_symbols(p: Parser, i: int) -> bool:
    """Whether a digit and a letter are one word, "3D": they are no symbols for cubes."""
    pair = p.tokens[i : i + 2]
    joined = len(pair) == 2 and pair[0].span[1] == pair[1].span[0]
    return joined and {token.raw.isdigit() for token in pair} == {True, False} and pair[1].raw.isalnum()


def _mere_number(phrase: m.Meaning) -> bool:
    """Phrases such as "three": how many something is, rather than what comes instead of it."""
    return isinstance(phrase, m.Noun) and phrase.head == "any" and phrase.det == "bare" and phrase.traits == m.Traits()


def _sized(traits: m.Traits) -> bool:
    """Phrases such as "5 cm cubes": blocks by their size alone."""
    return traits == m.Traits(edge=traits.edge, size=traits.size) and bool(traits.edge or traits.size)


_DETERMINERS = frozenset({"all", "both", "each", "these", "those"})
"""Words that belong to what follows them: "make all letters blue" is about the letters alone."""


_NO_LOOKS = frozenset({"rank", "extra", "target", "matching", "empty"})
_OF_PATCHES = frozenset({"shape", "long"})


def _patch(theme: m.Meaning | None) -> bool:
    """Whether a phrase may speak of a patch, which has a shape."""
    return isinstance(theme, m.Pronoun) or (isinstance(theme, m.Noun) and theme.head in ("patch", "any"))


_INSTEAD_OF = phrases("instead of | rather than | and not | , not | not | in place of")


_SCALES = {
    "twice as big": 2.0, "twice as large": 2.0, "half as big": 0.5, "half as large": 0.5, "twice the size": 2.0,
    "half the size": 0.5, "double the size": 2.0, "a bit bigger": 1.25, "slightly bigger": 1.25,
    "slightly larger": 1.25, "a bit smaller": 0.75, "bigger": 1.25, "slightly smaller": 0.75, "larger": 1.25,
    "smaller": 0.75, "tinier": 0.75, "a little bigger": 1.25, "a little smaller": 0.75,
}  # fmt: skip


def _scale(p: Parser, i: int) -> Iterator[tuple[float, int]]:
    for phrase, factor in _SCALES.items():
        if j := p.seq(i, phrase):
            yield (factor, longest(p, j, "than the others | than the rest | than before | than the other one") or j)


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
    "spread",
    "spread out",
    "set out",
    "string",
    "distribute",
    "group",
)


_INTO_LINES = {
    "stack": "stack", "pile up": "stack", "stack up": "stack", "pile": "stack", "line up": "row", "line": "row",
}  # fmt: skip


def _lined(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "stack them instead", "line them up"."""
    for verb, kind in _INTO_LINES.items():
        j = p.seq(i, verb)
        for theme, k in noun_phrase(p, j) if j else ():
            if fresh(theme) or isinstance(theme, m.Structure):
                continue
            end = longest(p, k, "up | on top of each other | on top of one another | on each other | side by side") or k
            shape = m.Structure(kind=kind, span=p.span(i, end))
            if verb != "line" or p.words[k : k + 1] == ["up"]:
                yield r.Reshape(structure=shape, theme=theme, span=p.span(i, end)), end


def arrange(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "arrange them in a circle instead", "make a pyramid out of the same blocks"."""
    yield from _lined(p, i)
    for phrase in _FORM:
        j = p.seq(i, phrase)
        for theme, k in noun_phrase(p, j) if j else ():
            n = longest(
                p,
                k,
                "so that they form | in the shape of | in | into | as | to form | up as | up in | out in | "
                "out as | out into "
                "| together in | together into",
            )
            for shape, end in noun_phrase(p, n) if n else ():
                end = _as_it_is(p, end, shape)
                if isinstance(shape, m.Structure) and not isinstance(theme, m.Structure) and not fresh(theme):
                    yield (r.Reshape(structure=shape, theme=theme, span=p.span(i, end)), end)
        for shape, k in noun_phrase(p, j) if j else ():
            if isinstance(shape, m.Structure) and shape.members is None and (end := p.one(k, "instead")):
                yield r.Reshape(structure=shape, span=p.span(i, end), cost=1), end
    verb = longest(p, i, _FORM) or i
    for shape, k in noun_phrase(p, verb):
        end = longest(p, k, _SAME_BLOCKS) if isinstance(shape, m.Structure) else 0
        if end:
            yield r.Reshape(structure=shape, span=p.span(i, end)), end
    if j := longest(p, i, ("in", "as", "into")):
        for shape, k in noun_phrase(p, j):
            if isinstance(shape, m.Structure) and (end := p.one(k, "instead")):
                yield r.Reshape(structure=shape, span=p.span(i, end)), end
    yield from _upright(p, i)
    for shape, k in noun_phrase(p, i):
        n = longest(p, k, ("instead of", "rather than"))
        for given_up, end in noun_phrase(p, n) if n else ():
            if isinstance(shape, m.Structure) and isinstance(given_up, m.Structure):
                yield (r.Reshape(structure=shape, theme=replace(given_up, det="the"), span=p.span(i, end)), end)


_UPRIGHT = phrases("vertically | upright | downwards | as a tower | as a stack | in a tower | in a stack | going down")
_READ = phrases(", read from the top | read from the top | reading from the top | from top to bottom | top to bottom")


def _upright(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "write the word vertically, as a tower read from the top"."""
    j = longest(p, i, "write | spell | read | put | make | build | stack | set | have | arrange")
    for theme, k in [(None, j), *subjects(p, j)] if j else ():
        end = longest(p, k, _UPRIGHT)
        end = longest(p, p.opt(end, ","), _UPRIGHT) or end if end else 0
        stop = longest(p, end, _READ) or end if end else 0
        one = isinstance(theme, m.Noun) and not theme.plural and theme.traits.kind is None  # "turn the A upright"
        if stop and (theme is None or old(theme)) and not one:
            shape = m.Structure(kind="stack", span=p.span(i, stop))
            yield r.Reshape(structure=shape, theme=theme, span=p.span(i, stop), cost=1), stop


def _as_it_is(p: Parser, i: int, shape: m.Meaning) -> int:
    """The position after a direction that a line has anyway."""
    ways = {"row": "from left to right", "line": "from left to right", "stack": "from bottom to top"}
    return longest(p, i, (ways.get(getattr(shape, "kind", ""), "from front to back"),)) or i


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


def paint(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    j = p.one(i, PAINT)
    for theme, k in noun_phrase(p, j) if j else ():
        k = p.opt(k, "in", "to")
        for (listed, either), end in colors(p, k):
            yield (r.Restyle(theme=theme, traits=m.Traits(colors=listed, either=either), span=p.span(i, end)), end)
    if j := longest(p, i, "in | all in | everything in | all of it in"):
        everything = m.Pronoun(word="them", span=p.span(i, j))
        for (listed, either), end in colors(p, j):
            end = longest(p, end, "letters | blocks | cubes | ones | bricks | digits | color") or end
            traits = m.Traits(colors=listed, either=either)
            yield (r.Restyle(theme=everything, traits=traits, span=p.span(i, end), cost=2), end)
    if j := p.one(i, frozenset({"relabel", "label", "rename"})):
        for theme, k in noun_phrase(p, j):
            k = longest(p, k, ("as", "to", "with")) or k
            for (labels, _), end in label_list(p, longest(p, k, "the letter | letter | number | a | an") or k, True):
                yield (r.Restyle(theme=theme, traits=m.Traits(labels=labels), span=p.span(i, end)), end)


def resize(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "resize the red block to 5 cm", "enlarge it", "shrink the patch"."""
    for word, factor in (("enlarge", 1.25), ("grow", 1.25), ("shrink", 0.75), ("reduce", 0.75), ("resize", None)):
        j = p.one(i, word)
        for theme, k in noun_phrase(p, j) if j else ():
            if n := p.one(k, "to"):
                for metres, end in length(p, n):
                    yield (r.Restyle(theme=theme, traits=m.Traits(edge=metres), span=p.span(i, end)), end)
            if factor:
                yield r.Restyle(theme=theme, scale=factor, span=p.span(i, k)), k
