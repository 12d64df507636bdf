"""Noun phrases: any description of blocks, patches or structures, alone, in lists, in parts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import Marks, adjectives, clash, color, merge, of_quality
from rpg.language.grammar.things.amounts import Quantity
from rpg.language.grammar.things.at_an_end import at_an_end
from rpg.language.grammar.things.at_places import at_places
from rpg.language.grammar.things.brackets import bracketed
from rpg.language.grammar.things.edges import of_edges, one_of_each_edge
from rpg.language.grammar.things.excepted import alone_in_this
from rpg.language.grammar.things.goods import goods
from rpg.language.grammar.things.had_relatives import told_traits, wished_of_new
from rpg.language.grammar.things.in_line import in_line, unnamed_ends
from rpg.language.grammar.things.joined import all_but, apposed, more, of_each, only_these
from rpg.language.grammar.things.labels import label_list, of_such, once_more
from rpg.language.grammar.things.partitives import of_these, partitive
from rpg.language.grammar.things.patch_nouns import patch_noun
from rpg.language.grammar.things.printed import in_one_color, printed, turned_part, with_symbols
from rpg.language.grammar.things.pronouns import pronoun
from rpg.language.grammar.things.retold import beside_heap
from rpg.language.grammar.things.so_many import so_many
from rpg.language.grammar.things.standby import further_extras
from rpg.language.grammar.things.theirs import as_many_colors, of_patch
from rpg.language.grammar.things.told_symbols import both_parities, told_symbols
from rpg.language.later import later
from rpg.language.meaning import Amount, Coord, Meaning, Noun, PartOf, Pronoun, TableTop, Traits, replace

(structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")
relative, which_also = later(__name__, "rpg.language.grammar.things.relatives", "relative", "which_also")

_APART = frozenset({"own", "separate", "distinct"})
"""Before patches: none is shared."""
_OUTLINES = {word + end: (word, bool(end)) for word in ("square", "circle", "rectangle") for end in ("", "s")}
"""Figures by which a patch is called as well: the word, its shape, whether it is a plural."""
_SINGLE = Quantity("bare")
_ONE = ("the", "a", "bare")
_PRESENT = ("present", "in the scene", "lying around", "around", "in view", "also present")
"""What may be said of where distractors are, which is nowhere in particular."""
_YOU_LIKE = ("you like", "you want", "you prefer", "you choose", "you wish", "that you like", "that you want",
             "that you prefer", "that you choose", "of your choice", "of your choosing", "you please")  # fmt: skip
_EVERYTHING = ("everything", "everything that is", "everything which is", "all that is", "anything that is")
_BARE = frozenset({"bare", "naked", "uncovered"})
_LISTING = frozenset({"bare", "the", "all", "both"})
_EVERY = frozenset({"each", "all", "both"})
"""These speak of several: "red on blue, both 5 cm" says nothing of the blue one alone."""
_SYMBOLS = (lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL)
"""Nouns with which symbols are read as what they tell apart, not as blocks of their own."""


@rule
def noun_phrase(p: Parser, i: int) -> Results[Meaning]:
    """One noun phrase or a list of them."""
    start = p.one(i, ("both", "either")) or i
    if k := p.one(i, "neither"):
        for item, j in simple(p, k):
            lists = ((x, k) for x, k in more(p, i, (item,), j, None) if isinstance(x, Coord) and x.op == "or")
            yield from ((replace(found, op="nor"), k) for found, k in lists)
    if k := p.one(i, ("only", "just")):
        for item, j in simple(p, k):
            counted = isinstance(item, Noun) and item.det == "bare" and item.amount is not None
            if isinstance(item, Noun) and not counted and item.amount in (None, Amount(1, 1)) and item.det in _ONE:
                yield Coord(op="only", items=(item,), span=p.span(i, j)), j
                yield from only_these(p, i, k, item, j)
    for item, j in simple(p, start) if start > i else ():
        number = isinstance(item, Noun) and item.amount is not None and item.traits == Traits() and item.head == "any"
        if number or p.words[j : j + 2] == ["and", "both"]:
            continue  # "either two or three of ..." is one number, "both red and both blue" are two of each
        yield from (
            (replace(found, cost=0), k) for found, k in more(p, i, (item,), j, None) if isinstance(found, Coord)
        )
    for item, j in (alone_in_this(p, i, *found) for found in simple(p, i)):
        yield item, j
        for behind in (all_but, apposed, of_each) if j < p.end else ():
            yield from behind(p, i, item, j)
        if not (isinstance(item, Noun) and item.det == "both" and item.head == "any") or p.words[j + 1] == "both":
            yield from ((beside_heap(item, found), k) for found, k in more(p, i, (item,), j, None))


@rule
def simple(p: Parser, i: int) -> Results[Meaning]:
    """A noun phrase that is no list."""
    if i >= p.end:
        return
    yield from pronoun(p, i)
    yield from _table(p, i)
    yield from structure(p, i)
    yield from _part(p, i)
    if j := p.any_of(i, ("the centers of", "the centres of", "the middles of", "centers of")):
        yield from noun_phrase(p, j)
    if j := p.any_of(i, ("the letter on", "the letter of", "the symbol on", "the number on", "the digit on")):
        yield from ((found, k) for found, k in simple(p, j) if isinstance(found, Noun))
    yield from told_symbols(p, i)
    yield from (*one_of_each_edge(p, i), *at_an_end(p, i), *at_places(p, i))
    for phrase, j in p.standing(i, _SIGNS):
        det = "the" if phrase.startswith("the") else "a"
        sign = Traits(labels=(_SIGNS[phrase],), kind="symbol")
        yield Noun(head="block", det=det, traits=sign, span=p.span(i, j), cost=phrase.endswith("plus sign") * 2), j
    if j := p.any_of(i, _EVERYTHING):
        for marks, k in adjectives(p, j):
            if marks.keys() & {"colors", "kind", "size"}:
                yield Noun(head="block", det="all", plural=True, traits=Traits(**marks), span=p.span(i, k)), k
    for found, j in amounts.quantity(p, i):
        if found.det == "its" and (own := p.one(j, "own")):
            yield from (
                (replace(block, det="a", amount=Amount(1, 1), traits=replace(block.traits, scheme="different")), k)
                for block, k in _noun(p, i, own, Quantity("a", Amount(1, 1), False))
                if isinstance(block, Noun) and block.head != "patch" and block.traits.scheme is None
            )
        if found.partitive:
            yield from partitive(p, i, j, found)
        else:
            ended = "or" if p.words[i] == "either" else None
            yield from ((noun, k) for noun, k in _noun(p, i, j, found) if p.words[k] != ended)
    yield from _noun(p, i, i, _SINGLE)
    if of := p.one(i, "of"):
        yield from of_these(p, i, of)


_SIGNS = {
    f"{det} {name}": sign
    for sign, names in {
        "=": ("equals sign", "equal sign", "= sign", "equality sign"), "-": ("minus sign", "- sign", "minus"),
        "+": ("plus sign", "+ sign"), "*": ("times sign", "multiplication sign", "* sign"),
        "/": ("division sign", "/ sign"),
    }.items()
    for name in names
    for det in ("the", "an" if name[0] in "e" else "a", *(("one",) if name.endswith("sign") else ()))
}  # fmt: skip
"""Blocks by the signs that they show; a plus sign may be a figure as well."""


@choice
def _table(p: Parser, i: int) -> Results[Meaning]:
    j = p.opt(i, "the", "a", "this", "your", "my")
    bare = p.one(j, _BARE)
    j = p.opt(bare or j, "work")
    if p.lex(j, lexicon.TABLE) is False:
        end = p.opt(j + 1, "top", "surface")
        itself = p.opt(end, "itself")
        yield TableTop(bare=bool(bare) or itself > end, span=p.span(i, itself)), itself


_PARTS = {
    "top": "top", "bottom": "bottom", "middle": "middle", "base": "bottom", "foot": "bottom", "center": "middle",
    "centre": "middle", "left end": "left", "right end": "right", "end": "end", "front": "front", "back": "back",
    "far end": "back", "near end": "front",
}  # fmt: skip


@choice
def _part(p: Parser, i: int) -> Results[Meaning]:
    """ "the top of the tower", "its top"."""
    if j := p.one(i, "its"):
        for phrase, k in p.standing(j, _PARTS):
            yield PartOf(part=_PARTS[phrase], whole=Pronoun(word="it", span=p.span(i, j)), span=p.span(i, k)), k
    j = p.one(i, "the")
    if not j:
        return
    for phrase, k in p.standing(p.opt(j, "exact", "very", "dead"), _PARTS):
        for whole, end in simple(p, of) if (of := p.one(k, "of")) else ():
            if isinstance(whole, TableTop):
                continue
            yield PartOf(part=_PARTS[phrase], whole=whole, span=p.span(i, end)), end


@choice
def _head(p: Parser, i: int) -> Results[tuple[str, bool, dict[str, Any]]]:
    """The noun itself: (head, plural, traits it brings)."""
    for many, j in goods(p, i):
        yield ("block", many, {}), j
    start = p.one(i, _APART) or i
    j, plural = patch_noun(p, start)
    if j > start:
        yield ("patch", plural, {"scheme": "different"} if start > i else {}), j
    for table, kind in ((lexicon.LETTER, "letter"), (lexicon.DIGIT, "digit"), (lexicon.SYMBOL, "symbol")):
        if (named := p.lex(i, table)) is not None:
            yield ("block", named, {"kind": kind}), i + 1
    for words, quality, kind in (("vowel", "vowel", "letter"), ("consonant", "consonant", "letter")):
        if j := p.one(i, frozenset({words, words + "s"})):
            yield ("block", p.words[i].endswith("s"), {"kind": kind, "quality": quality}), j
    if j := p.one(i, ("odds", "evens")) or both_parities(p, i):
        yield ("block", True, {"kind": "digit", "quality": p.words[i].rstrip("s")}), j
    start = p.one(i, ("random", "arbitrary", "other")) or i
    if j := p.one(start, ("distractor", "distractors")):
        yield ("block", p.words[start] == "distractors", {"extra": True}), j
    if j := p.one(i, ("one", "ones")):
        odd = p.follows(i, ("odd",)) and p.follows(i - 1, ("the",))
        yield ("any", p.words[i] == "ones", {}), (p.opt(j, "out") if odd else j)
    if several := p.peek(i, lexicon.COLOR_PLURAL):
        yield ("block", True, {"colors": (several,)}), p.reach(i + 1)


def _noun(p: Parser, i: int, start: int, quantity: Quantity) -> Results[Meaning]:
    for marks, j in adjectives(p, start):
        for (head, plural, brings), k in _head(p, j):
            both = merge(marks, brings)
            if both is not None:
                yield from _finish(p, i, k, quantity, head, plural, both)
        if (figure := p.peek(j, _OUTLINES)) and (both := merge(marks, {"shape": figure[0]})) is not None:
            yield from _finish(p, i, p.reach(j + 1), quantity, "patch", figure[1], both, cost=1)
        yield from _headless(p, i, start, j, quantity, marks)


def _headless(p: Parser, i: int, start: int, j: int, quantity: Quantity, marks: Marks) -> Results[Meaning]:
    """ "red on blue", "the other two", "A", "a red and a blue block"."""
    ranked = quantity.det == "the" and marks.get("rank") not in (None, *unnamed_ends(p, j))
    named = j > start and p.words[j - 1] not in ("target", "goal", "little") and "shape" not in marks
    looked = marks.get("colors") or marks.get("size") or ranked
    if named and looked and ("edge" not in marks or p.words[j - 1] in lexicon.COLOR):
        plural = bool(quantity.plural) or len(marks.get("colors", ())) > 1
        several = len(marks.get("colors", ())) > 1 and not marks.get("either")
        both = quantity.det == "both" and not several and p.words[j] == "and" and p.words[j + 1] != "both"
        if both or (several and _list_goes_on(p, j)):
            return
        that = 3 if p.stands(i, _THAT) and p.follows(i, _OF) else 0
        yield from _finish(p, i, j, quantity, "any", plural, marks, cost=that + (1 if several else 0))
    counted = quantity.amount is not None and quantity.det in ("the", "bare", "other", "another", "both", "some")
    if counted and quantity.det == "bare" and start > i and p.tokens[start - 1].kind == "number":
        counted = False
    if j == start and (counted or quantity.det in ("other", "another")):
        digit = quantity.det == "the" and p.tokens[start - 1].kind == "number"
        yield from _finish(p, i, j, quantity, "any", bool(quantity.plural), marks, cost=3 if digit else 2)
    for labels, k in once_more(p, i, start) if j == start and quantity.det in ("other", "another") else ():
        yield from _finish(p, i, k, Quantity(quantity.det), "block", False, Marks({"labels": labels}))
    named = j > start and any(p.words[j - 1] in table for table in _SYMBOLS)
    if not named and ((quantity.det in _LISTING and quantity.amount is None) or quantity.det == "a"):
        for (labels, more), k in label_list(p, j):
            held = merge(marks, {"labels": labels, "open_ended": more})
            digit = len(labels) == 1 and labels[0].isdigit()
            if digit and (amounts.makes_number(p, k) or quantity.det == "all" or p.follows(i, ("are",))):
                continue
            if held is not None and (len(labels) == 1 or quantity.det != "a"):
                cost = 2 if digit or ("and" not in p.words[j:k] and "," in p.words[j:k]) else 1
                yield from _finish(p, i, k, quantity, "block", len(labels) > 1, held, cost=cost)


_THAT = frozenset({"that", "this"})
_OF = frozenset({"of", "on", "beside", "upon", "above"})
"""Behind these "that" is what was told before, "on top of that green", and seldom the green block."""


def _list_goes_on(p: Parser, j: int) -> bool:
    """Whether a list of colours continues behind j."""
    k = p.opt(p.opt(j, ","), "and", "or", "&")
    return k > j and k < p.end and p.words[k] in lexicon.COLOR


def _finish(
    p: Parser, i: int, j: int, quantity: Quantity, head: str, plural: bool, marks: Marks, cost: int = 0
) -> Results[Meaning]:
    """The noun with what may follow it: labels, "of ...", "that ..."."""
    low = quantity.amount
    many = plural or bool(low and low.high != 1)
    if (quantity.det == "each" and plural) or (quantity.det == "a" and plural and not low):
        return
    if low is not None and low == Amount(1, 1) and plural and quantity.det in ("a", "bare"):
        return
    if low is not None and low.low > 1 and not plural and head not in ("any",) and quantity.det != "each":
        cost += 1
    if len(marks.get("colors", ())) > 1 and not many and not marks.get("either"):
        cost += 1
        many = True
    if head == "block" and quantity.det == "bare" and low is None and not many and not marks:
        cost += 1
    noun = Noun(
        head=head, det=quantity.det, amount=low, plural=many, traits=Traits(**marks), span=p.span(i, j), cost=cost
    )  # fmt: skip
    yield from _after(p, i, j, noun)


def _numbered(p: Parser, i: int, at: int, noun: Noun) -> Noun | None:
    """ "red block 2", "the 7 block number 2": a number behind a block that has a look counts those of that look."""
    token = p.tokens[at]
    told = bool(noun.traits.colors or noun.traits.labels) and noun.head == "block" and not noun.plural
    before = p.words[at - 1]
    if not told or token.kind != "number" or noun.amount is not None:
        return None
    if before not in lexicon.BLOCK and before != "number":
        return None
    return replace(noun, traits=replace(noun.traits, rank=f"#{p.words[at]}"), span=p.span(i, at + 1))


@rule
def _after(p: Parser, i: int, j: int, noun: Noun) -> Results[Meaning]:
    yield noun, j
    if j >= p.end:
        return
    tried = [(noun, j)]
    if k := p.any_of(j, _PRESENT if noun.traits.extra else _YOU_LIKE if noun.det != "the" else ()):
        yield noun, k
    k = p.one(j, "number") or j
    long = k < p.end and (k > j or (p.tokens[k].kind == "number" and len(p.words[k]) > 1))
    if long and (counted := _numbered(p, i, k, noun)) is not None:
        yield counted, p.reach(k + 1)
    if (k := as_many_colors(p, j, noun)) and (told := _with(noun, {"scheme": "different"}, p.span(i, k))) is not None:
        yield told, k
        tried.append((told, k))
    yield from of_edges(p, i, j, noun)
    yield from in_line(p, i, j, noun)
    yield from so_many(p, i, j, noun)
    yield from with_symbols(p, i, j, noun)
    yield from bracketed(p, i, j, noun)
    for update, k in of_patch(p, j) if noun.head == "patch" and not noun.traits.colors else ():
        if (told := _with(noun, update, p.span(i, k))) is not None:
            yield told, k
    for update, k in further_extras(p, j, noun):
        if (told := _with(noun, update, p.span(i, k))) is not None:
            yield told, k
    for update, k in of_quality(p, j, noun.head):
        behind = p.stands(j, (",",)) and p.follows(i, ("of", "on", "onto"))  # "a block on each mat, all different"
        alone = noun.det == "the" and noun.amount is None and update == {"scheme": "same"}
        if noun.head == "patch" and "scheme" in update and (behind or alone):
            continue
        if "edge" in update and not noun.plural and not _EVERY.isdisjoint(p.words[j : j + 2]):
            continue
        numbered = _numbered(p, i, j, noun) if k == j + 1 else None
        changed = numbered or _with(noun, of_such(p, j, k, noun.traits.quality, update), p.span(i, k))
        if changed is not None and not ("labels" in update and turned_part(p, i, j, k)):
            on_it = [*printed(p, i, j, k, changed)]
            yield from on_it or [(changed, k)]
            tried += [] if on_it else [(changed, k)]
            for hue, end in in_one_color(p, k, noun.head) if "labels" in update else ():
                yield from ((told, end) for told in (_with(changed, hue, p.span(i, end)),) if told is not None)
    single = not noun.plural or (noun.amount is not None and noun.det == "bare" and noun.traits == Traits())
    if noun.head == "block" and single and not noun.traits.colors and not noun.traits.labels:
        for named, k in color(p, j):
            if p.words[k] not in lexicon.BLOCK and p.words[k] not in lexicon.COLOR:
                marked = replace(noun.traits, colors=(named,))
                yield replace(noun, traits=marked, span=p.span(i, k), cost=noun.cost + 2), k
    for base, at in tried:
        for condition, end in relative(p, at, base.head, base.plural):
            k = p.opt(end, ",") if p.stands(at, (",",)) else end
            if isinstance(condition, Traits):
                changed = _with(base, told_traits(condition), p.span(i, end))
                if changed is not None:
                    yield from ((changed, last) for last in {end: None, k: None})
                    yield from (*which_also(p, i, end, changed), *printed(p, i, at, end, changed))
            else:
                told = wished_of_new(p, at, base, condition, p.span(i, end))
                yield from ((told, last) for last in {end: None, k: None}) if told is not None else ()


_SIGNS_INSIDE = frozenset("+-*/=")
"""Between symbols these make a calculation, which is not on one cube: "the cube that shows 2 + 3"."""


def _with(noun: Noun, update: Mapping[str, Any], span: tuple[int, int]) -> Noun | None:
    """`noun` with more traits, unless they contradict those it has."""
    retold = set(update) == {"kind"} and noun.traits.kind is not None
    single = noun.head == "block" and not noun.plural and noun.amount is None
    signs = single and not _SIGNS_INSIDE.isdisjoint(update.get("labels", ())[1:-1])
    if clash(noun.traits, update) or retold or signs:
        return None
    plural = noun.plural or len(update.get("labels", ())) > 1
    return replace(noun, traits=replace(noun.traits, **update), span=span, plural=plural)
