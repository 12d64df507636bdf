"""What stands behind blocks and says of them how many they are, in brackets or "of the three"; or in brackets what they
look like."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import color, colors
from rpg.language.grammar.things.labels import label_list
from rpg.language.meaning import Amount, Noun, replace

_LEADS = ("there are", "there is", "we have", "there are only", "exactly", "all", "you have", "i have", "in total",
          "together", "altogether", "total", "total :", "just", "also", "again", "there are also")  # fmt: skip
_COUNTED = ("of them", "of those", "of these", "in total", "in all", "altogether", "pieces", "blocks", "cubes",
            "in number", "all together", "total", "each", "too", "as well", "also", "again")  # fmt: skip
_WIDE = ("each", "wide", "edge", "edges", "each side", "a side", "on each side", "on a side", "cubes", "cube", "large",
         "in size", "apiece", "edge length", "side length", "blocks", "block")  # fmt: skip

_SHOWN = ("marked by", "marked in", "marked as", "shown as", "shown in", "shown by", "this is", "that is", "i e",
          "namely", "marked with")  # fmt: skip
_BY = ("marked by", "indicated by", "shown by", "given by", "marked as", "marked with")
_FORMS = {"square": "square", "circle": "circle", "disc": "circle", "disk": "circle", "one": None}


@choice
def bracketed(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "all white blocks (3)", "every red one (there are four)", "the orange block (3 cm)", "two mats (red, blue)",
    "any red block of the three"."""
    yield from _of_so_many(p, i, j, noun)
    opened = p.one(j, "(")
    yield from _patch_shown(p, i, opened or p.any_of(j, _BY), noun, not opened)
    if not opened and noun.head == "patch":
        yield from _patches_named(p, i, p.one(j, (",", ":")), noun)
    if not opened:
        return
    start = p.any_of(opened, _LEADS) or opened
    for many, k in amounts.count(p, start):
        told = p.any_of(k, _COUNTED) or k
        end = p.one(told, ")")
        bare = start == opened and told == k
        if end and p.words[k] != "each" and _countable(noun) and not (bare and noun.traits.kind in ("digit", "symbol")):
            yield _counted(noun, Amount(many, many), p.span(i, end)), end
    for metres, k in amounts.length(p, p.any_of(start, ("edge", "size", "each")) or start):
        end = p.one(p.any_of(k, _WIDE) or k, ")")
        if end and noun.head != "patch" and noun.traits.edge is None:
            yield replace(noun, traits=replace(noun.traits, edge=metres), span=p.span(i, end)), end
    for (labels, more), k in label_list(p, opened, True) if noun.plural and noun.head == "block" else ():
        end = p.one(k, ")")
        marks = noun.traits
        if end and not more and not marks.labels and (len(labels) > 1 or labels[0].isalpha()) and _shows(noun, labels):
            yield replace(noun, traits=replace(marks, labels=labels), span=p.span(i, end)), end
    for (listed, either), k in colors(p, p.any_of(opened, ("one", "namely")) or opened):
        end = p.one(k, ")")
        if end and not either and not noun.traits.colors and _as_many(noun, len(listed)):
            yield replace(noun, traits=replace(noun.traits, colors=listed), span=p.span(i, end)), end
    for listed, k in _one_by_one(p, opened):
        end = p.one(k, ")")
        if end and not noun.traits.colors and _as_many(noun, len(listed)):
            there = Amount(len(listed), len(listed)) if noun.plural else noun.amount
            yield replace(noun, amount=there, traits=replace(noun.traits, colors=listed), span=p.span(i, end)), end


def _patch_shown(p: Parser, i: int, at: int, noun: Noun, named: bool) -> Results[Noun]:
    """ "the target zone (green square)", "the goal marked by the green mat": how the patch looks that was named before.
    `named`: by another patch, and not in brackets."""
    if not at or noun.head != "patch" or noun.plural or noun.traits.colors:
        return
    start = at if named else p.any_of(at, _SHOWN) or at
    for (listed, either), k in colors(p, p.opt(start, "a", "the")):
        form = p.one(k, lexicon.PATCH) or p.one(k, _FORMS)
        end = form if named else p.one(form or k, ")")
        if end and not either and len(listed) == 1:
            shape = (_FORMS.get(p.words[k]) if form else None) or noun.traits.shape
            yield replace(noun, traits=replace(noun.traits, colors=listed, shape=shape), span=p.span(i, end)), end


def _patches_named(p: Parser, i: int, comma: int, noun: Noun) -> Results[Noun]:
    """ "(each of the two mats,) a red one and a blue one, ...", "red and blue, ...": their colours between commas."""
    if not comma or noun.amount is None or noun.amount.low < 2 or noun.traits.colors:
        return
    each = [((found, False), k) for found, k in _one_by_one(p, comma)]
    for (named, either), k in [*colors(p, comma), *each]:
        end = p.one(k, ",") or (k if k >= p.end and not lexicon.COLOR.keys().isdisjoint(p.words[:comma]) else 0)
        if end and not either and _as_many(noun, len(set(named))):
            yield replace(noun, traits=replace(noun.traits, colors=named), span=p.span(i, k)), end


def _one_by_one(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """ "a red one, a green one": the colour of each."""
    found: list[str] = []
    while j := p.one(i, _ONE):
        named = next(iter(color(p, j)), None)
        if named is None:
            return
        found.append(named[0])
        end = p.opt(named[1], "one", "block", "cube")
        if len(found) > 1 and (end >= p.end or p.stands(end, (")", ","))):
            yield tuple(found), end
        i = p.any_of(end, (", and", "and", ",", "plus"))
        if not i:
            return


_ONE = frozenset({"a", "an", "one", "the"})


def _countable(noun: Noun) -> bool:
    several = noun.plural or noun.det in ("each", "no", "a")
    one = noun.det == "a" and noun.amount == Amount(1, 1) and noun.head != "patch"  # "on a red block (2)"
    return (noun.amount is None or one) and several and noun.part_of is None and noun.head in ("block", "patch", "any")


_OUT_OF = ("of the", "out of the", "of all", "from the", "of", "out of", "from", "of these", "of those", "of our",
           "of your", "of my")  # fmt: skip
_THERE_BE = ("there are", "we have", "you have", "i have", "there", "available")
_GOES_ON = frozenset({*lexicon.BLOCK, *lexicon.LOOSE_BLOCK, *lexicon.COLOR, *lexicon.COLOR_PLURAL, *lexicon.PATCH,
    *lexicon.LETTER, *lexicon.DIGIT, *lexicon.SYMBOL, *lexicon.STRUCTURE, *lexicon.SIZE, *lexicon.UNIT,
    *lexicon.ORDINAL, "ones", "by", "x", "other", "others", "such", "left", "different", "plain", "vowels",
    "consonants"})  # fmt: skip
"""What may follow a number and makes it one of something else."""


def _of_so_many(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "any red block of the three", "two blue ones out of five": how many there are from which they are taken."""
    of = p.any_of(j, _OUT_OF)
    looks = noun.traits.colors or noun.traits.kind or noun.traits.labels
    if not of or noun.part_of is not None or noun.head == "patch" or not looks or len(noun.traits.colors) > 1:
        return
    if noun.det not in ("a", "any", "bare", "some", "each", "no") or (noun.amount is None and noun.plural):
        return
    least = noun.amount.low if noun.amount is not None else 1
    for many, k in amounts.count(p, of):
        end = p.any_of(k, _THERE_BE) or k
        if many > least and p.words[k - 1] != "one" and not p.stands(k, _GOES_ON) and _word_next(p, end):
            whole = replace(noun, det="the", plural=True, amount=Amount(many, many), cost=0)
            one = noun.amount in (None, Amount(1, 1)) and noun.det in ("a", "any", "bare")
            det = "any" if one else "some" if noun.amount is not None else noun.det
            amount = Amount(1, 1) if one else noun.amount
            yield Noun(head=noun.head, det=det, amount=amount, plural=True, part_of=whole, span=p.span(i, end)), end


def _word_next(p: Parser, k: int) -> bool:
    """Whether no symbol or number stands there, of which so many could be."""
    return k >= p.end or (p.tokens[k].kind in ("word", "punct") and len(p.words[k]) > (p.tokens[k].kind == "word"))


def _shows(noun: Noun, labels: tuple[str, ...]) -> bool:
    """Whether the blocks spoken of may show these symbols, and are as many."""
    kind = noun.traits.kind
    fits = {"letter": all(x.isalpha() for x in labels), "digit": all(x.isdigit() for x in labels)}
    return (
        fits.get(kind or "", True) and noun.part_of is None and noun.amount in (None, Amount(len(labels), len(labels)))
    )


def _as_many(noun: Noun, many: int) -> bool:
    """Whether so many colours tell what each of some objects looks like."""
    if noun.part_of is not None or noun.traits.labels or noun.head == "any":
        return False
    if noun.amount is not None:
        return noun.amount == Amount(many, many)
    return many > 1 if noun.plural else many == 1


def _counted(noun: Noun, amount: Amount, span: tuple[int, int]) -> Noun:
    if noun.det == "a":  # "each of them on a red block (3)"
        return replace(noun, part_of=replace(noun, det="bare", plural=True, amount=amount, cost=0), span=span)
    if noun.det in ("each", "no", "any"):
        whole = replace(noun, det="the", plural=True, amount=amount, cost=0)
        return Noun(head=noun.head, det=noun.det, plural=True, part_of=whole, span=span)
    return replace(noun, amount=amount, span=span)


_THERE_ARE = tuple(
    f"{of}{there}{just}"
    for of in ("", "of which ", "and ", "of them ", "and of them ")
    for there in ("there are", "there is", "i have", "we have", "you have")
    for just in ("", " just", " exactly", " only")
)
"""What a number of the blocks just spoken of follows, between commas."""


def counted_aside(p: Parser, i: int, j: int, whole: Noun) -> Results[Noun]:
    """ "all the red blocks, there are two, ...": how many they are, between commas."""
    there = p.any_of(j + 1, _THERE_ARE) if p.words[j] == "," else 0
    for many, k in amounts.count(p, there) if there else ():
        if end := p.one(p.any_of(k, ("of them", "of those", "in all", "in total", "altogether")) or k, ","):
            yield replace(whole, amount=Amount(many, many), plural=many > 1, span=p.span(i, end)), end
