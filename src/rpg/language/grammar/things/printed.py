"""What is printed on cubes: "the block with an A on it", "the one that has a 5 on it"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.adjectives import Marks, color, of_quality
from rpg.language.grammar.things.labels import label_list
from rpg.language.grammar.things.values import by_value
from rpg.language.meaning import Absolute, Clause, Coord, Loc, Meaning, Noun, Pronoun, Quality, Traits, replace

_ON_IT = ("on it", "on them", "on its top", "on its top face", "on its faces", "on its sides", "on all sides",
          "on each side", "on their faces", "on all faces", "on every face", "on each of them", "painted on it",
          "printed on it", "written on it", "written on them", "printed on them", "painted on them")  # fmt: skip
_BEARING = frozenset({"with", "that", "which", "bearing", "having", "carrying"})
_NAMED = frozenset({*lexicon.LETTER, *lexicon.DIGIT, *lexicon.SYMBOL})


@choice
def with_symbols(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "the cube with K on it": of no colour, besides which K could be a block that lies on it."""
    yield from _among(p, i, j, noun)
    yield from by_value(p, i, j, noun)
    told = noun.traits.colors or noun.traits.labels or noun.head == "patch"
    start = p.one(j, "with") if not told else 0
    if not start:
        return
    start = p.opt(start, "a", "an")
    start = p.one(p.opt(start, "the"), _NAMED) or start
    for (labels, more), k in label_list(p, start):
        end = p.any_of(k, _ON_IT)
        if end and not more:
            plural = noun.plural or len(labels) > 1
            marks = replace(noun.traits, labels=labels)
            yield replace(noun, head="block", plural=plural, traits=marks, span=p.span(i, end)), end


_OF = ("of", "among", "out of", "in")
_SUCH = ("the letters", "the digits", "the numbers", "letters", "digits", "numbers", "the")


def _among(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "the vowels of the letters A, B and E": those among the blocks that are listed."""
    start = p.any_of(j, _OF) if noun.traits.quality and noun.plural and noun.part_of is None else 0
    start = p.any_of(start, _SUCH) or start if start else 0
    for (labels, more), k in label_list(p, start) if start else ():
        if len(labels) > 1 and not more and not noun.traits.labels:
            whole = Noun(head="block", det="the", plural=True, traits=Traits(labels=labels), span=p.span(start, k))
            yield replace(noun, part_of=whole, span=p.span(i, k)), k


def printed(p: Parser, i: int, j: int, k: int, noun: Noun) -> Results[Noun]:
    """ "the block with an A on it", "the one that has a K on it": what it shows."""
    j = p.opt(j, ",")
    end = p.any_of(k, _ON_IT) if noun.traits.labels and p.stands(j, _BEARING) else 0
    end = 0 if noun.plural and not {"it", "its"}.isdisjoint(p.words[k:end]) else end
    letter = not _NAMED.isdisjoint(p.words[j:k])
    if end and (letter or "the" not in p.words[j:k] or not noun.traits.colors):
        yield replace(noun, span=p.span(i, end)), end


def shown(p: Parser, i: int, part_: Absolute) -> bool:
    """ "the cube with the number 5 on it", "cubes with letter on the left": that is what it shows, rather than what
    lies on it, or where."""
    theme, place = part_.theme, part_.adjuncts[0]
    it = isinstance(place, Loc) and isinstance(place.landmark, Pronoun) and place.rel == "on"
    symbol = isinstance(theme, Noun) and bool(theme.traits.labels) and not theme.traits.colors
    bare = isinstance(theme, Noun) and (theme.det, theme.plural, theme.traits) == ("bare", False, _kind_alone(theme))
    bearer = p.words[i - 1] if i else ""
    one = bearer == "one" or lexicon.BLOCK.get(bearer) is False
    return ((it and symbol and one) or (bare and bearer in lexicon.BLOCK)) and not _names_block(p, part_)


def _kind_alone(theme: Noun) -> Traits | None:
    """The looks of "letter" or "number", of which nothing else is said."""
    return Traits(kind=theme.traits.kind) if theme.traits.kind in ("letter", "digit", "symbol") else None


def _names_block(p: Parser, part_: Absolute) -> bool:
    """ "with an A block on it": a block is named."""
    end = part_.theme.span[1] if part_.theme is not None else 0
    return any(token.span[1] == end and token.word in lexicon.BLOCK for token in p.tokens)


_CUBES = frozenset({*lexicon.BLOCK, "one", "ones"})


def colored_cubes(p: Parser, i: int, j: int, theme: Meaning) -> Results[Clause]:
    """ "A, B and C (are) red cubes", "D (is) a blue one": there are such; "the H and the O are blue cubes"."""
    if isinstance(theme, Coord) and theme.op == "and" and all(map(_shows_a_letter, theme.items)):
        for named, k in color(p, j):
            if end := p.one(k, _CUBES):
                look = Quality(traits=Traits(colors=(named,)), span=p.span(j, end))
                told = Clause(verb="be", theme=theme, adjuncts=(look,), mode="goal", span=p.span(i, end))
                yield replace(told, lemma="fact"), end
    if not isinstance(theme, Noun) or not theme.traits.labels or theme.traits.colors or theme.part_of is not None:
        return
    for named, k in color(p, p.opt(j, "a")):
        if end := p.one(k, _CUBES):
            those = replace(theme, traits=replace(theme.traits, colors=(named,)), cost=0)
            yield Clause(verb="exist", lemma="stock", theme=those, mode="given", span=p.span(i, end)), end


def _shows_a_letter(thing: Meaning) -> bool:
    return isinstance(thing, Noun) and thing.det == "the" and bool(thing.traits.labels) and not thing.traits.colors


_WAYS = frozenset({"upside", "upright", "sideways", "facing", "turned", "rotated", "readable"})


def turned_part(p: Parser, i: int, j: int, k: int) -> bool:
    """ "(put the Q cube on the green block) with the Q upright": how a cube that was named before is to be turned, and
    not what the green block shows."""
    told = p.stands(j, ("with",)) and p.stands(j + 1, ("the",)) and p.stands(k, _WAYS)
    return told and p.words[k - 1] in p.words[:i]


_PAINTED = frozenset({"in", "colored", "painted"})


def in_one_color(p: Parser, j: int, head: str) -> Results[Marks]:
    """ "(the letter A) in red", "(the digits 1, 2 and 3) in blue", but not in more colours than one."""
    for update, k in of_quality(p, j, head) if p.stands(j, _PAINTED) else ():
        further = p.one(k, ("and", "or", ",")) if k < p.end else 0
        goes_on = further and p.words[further] in lexicon.COLOR and p.words[further + 1] not in lexicon.BLOCK
        if len(update.get("colors", ())) == 1 and not goes_on:
            yield update, k
