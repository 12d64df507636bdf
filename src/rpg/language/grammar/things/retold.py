"""Lists that tell again what was counted: "two blocks, one red and one blue"."""

from __future__ import annotations

import string

from rpg.language.grammar.core import Parser
from rpg.language.grammar.things.ones import says_ones
from rpg.language.grammar.things.some_again import some_again
from rpg.language.meaning import (
    Absolute,
    Amount,
    Clause,
    Coord,
    Into,
    Meaning,
    Noun,
    Pattern,
    Pronoun,
    Size,
    Structure,
    Traits,
    replace,
)


def tally(items: tuple[Meaning, ...]) -> int:
    """How many blocks "red, blue and two green ones" are; 0 where an item is no such description."""
    total = 0
    for item in items:
        if not (isinstance(item, Noun) and item.head == "any" and item.traits != Traits()):
            return 0
        several = 1 if item.traits.either else max(1, len(item.traits.colors), len(item.traits.labels))
        total += item.amount.low if item.amount is not None else several
    return total


def retold(items: tuple[Meaning, ...]) -> bool:
    """ "two blocks, one red and one blue": the list tells the first item again, it does not add to it."""
    whole, last = items[0], items[-1]
    if some_again(items):
        return True
    if isinstance(last, Noun) and last.head == "any" and last.det == "the" and last.plural and last.traits.colors:
        return any(isinstance(x, Noun) and x.amount and x.traits.colors == last.traits.colors for x in items[:-1])
    if isinstance(last, Noun) and bare_color(last) and last.det == "bare" and last.amount is None and len(items) > 2:
        counts = [x.amount for x in items[:-1] if isinstance(x, Noun) and x.traits.colors == last.traits.colors]
        if any(x is not None and x.low > 1 for x in counts):  # "two red and two blue blocks, red (first)"
            return True
    bare = all(isinstance(x, Noun) and x.det == "bare" for x in items[1:])  # "two big ones and a red one" are three
    if uncolored(whole) and bare and only_colored(Coord(op="and", items=items[1:], span=whole.span)):
        return True
    if not isinstance(whole, Noun) or whole.traits != Traits(kind=whole.traits.kind) or whole.amount is None:
        return False
    mere = isinstance(last, Noun) and bare_color(last) and last.det == "bare"
    if whole.traits.kind is not None:
        return len(items) == 2 and mere
    labels = [label for x in items[1:] if isinstance(x, Noun) for label in x.traits.labels]
    named = len(labels) == whole.amount.low > 1 and all(
        getattr(getattr(x, "traits", None), "labels", ()) for x in items[1:]
    )
    return named or tally(items[1:]) > 1 or (len(items) == 2 and mere)


def uncolored(whole: Meaning) -> bool:
    """ "two big blocks", "four 3 cm cubes", "two letter blocks": so many of which no colours are told."""
    if not isinstance(whole, Noun) or whole.amount is None or whole.amount.low < 2 or whole.head != "block":
        return False
    marks = whole.traits
    told = marks.size or marks.edge or marks.kind in ("letter", "digit")
    return bool(told) and marks == Traits(size=marks.size, edge=marks.edge, kind=marks.kind)


def only_colored(listed: Meaning) -> bool:
    """ "two red and two blue": a list of so many of each colour, with nothing else said of them."""
    items = listed.items if isinstance(listed, Coord) and listed.op == "and" else ()
    told = [x for x in items if isinstance(x, Noun) and x.head == "any" and x.amount is not None]
    return 1 < len(items) == len(told) and all(
        len(x.traits.colors) == 1 and x.traits == Traits(colors=x.traits.colors) for x in told
    )


def looks_listed(listed: Meaning) -> tuple[Traits, ...]:
    """The colours or labels of a plain list of them; none of anything else."""
    if isinstance(listed, Coord) and listed.op == "and":
        each = [looks_listed(item) for item in listed.items]
        return tuple(look for looks in each for look in looks) if all(each) else ()
    if not isinstance(listed, Noun) or listed.det != "bare" or listed.amount is not None or listed.head == "patch":
        return ()
    marks = listed.traits
    if marks == Traits(colors=marks.colors) and listed.part_of is None and not listed.conditions:
        return tuple(Traits(colors=(color,)) for color in marks.colors)
    if marks == Traits(labels=marks.labels) and listed.part_of is None and not listed.conditions:
        return tuple(Traits(labels=(label,)) for label in marks.labels)
    return ()


def counted_again(items: tuple[Meaning, ...]) -> bool:
    """ "red and blue blocks, three red and two blue", "next to each other, two red and two blue": the list goes on
    with how many these are."""
    nouns = [x for x in items if isinstance(x, Noun) and x.det == "bare" and x.head != "patch"]
    open_ = {color for x in nouns if x.amount is None for color in x.traits.colors}
    told = [x.traits.colors for x in nouns if x.amount is not None]
    if any(isinstance(x, Pronoun) and x.word == "each other" for x in items):
        return bool(told)
    return len(told) > 1 and open_ == {color for colors in told for color in colors} and nouns[0].amount is None


def the_other(first: Meaning, item: Meaning) -> Noun | None:
    """ "the other patch, the red one": one thing told twice."""
    if not (isinstance(first, Noun) and isinstance(item, Noun)) or first.det != "other" or item.det != "the":
        return None
    plain = first.traits == Traits() and not first.plural and not item.plural and first.amount == item.amount
    same = plain and item.head in ("any", first.head) and item.traits != Traits() and item.part_of is None
    return replace(item, head=first.head if first.head != "any" else item.head) if same else None


def universal(item: Meaning) -> bool:
    """ "all blocks", "everything", "nothing": what "but" takes something from."""
    if isinstance(item, Pronoun):
        return item.word in ("everything", "all", "all of them", "nothing")
    any_patch = isinstance(item, Noun) and item.head == "patch" and item.det == "any"
    return any_patch or (isinstance(item, Noun) and item.det in ("all", "each", "no") and item.amount is None)


def restates(before: Meaning, item: Meaning) -> bool:
    """ "a square of red blocks, three rows of three": with neither "and" nor blocks of its own, it tells of it; but
    "a red tower of two, a blue tower of three" are two."""
    if not (isinstance(before, Structure) and isinstance(item, Structure)):
        return False
    if before.traits.colors and item.traits.colors and not {*before.traits.colors} & {*item.traits.colors}:
        return False
    return item.members is None or (isinstance(item.members, Noun) and item.members.head == "any")


def apposed(before: Clause, item: Meaning) -> bool:
    """ "a square of red blocks, three rows of three", "(stack them) into three towers, each three high": a comma alone
    brings no structure without blocks of its own."""
    high = isinstance(item, Clause) and isinstance(item.theme, Pronoun) and item.theme.word == "each" and item.adjuncts
    if high and isinstance(item, Clause) and all(isinstance(x, Size) for x in item.adjuncts):
        return any(isinstance(x, Into) and getattr(x.structure, "plural", False) for x in before.adjuncts)
    told = isinstance(item, Clause) and not item.adjuncts and item.mode != "command"
    theme = item.theme if told and isinstance(item, Clause) else None
    return isinstance(before.theme, Structure) and isinstance(theme, Structure) and restates(before.theme, theme)


def told_anew(before: Meaning, item: Meaning, behind: str) -> bool:
    """ "a tower of three blocks, four red ones": blocks of no look and a comma, and then so many that have one; "a row
    of three, the left one", "the word CAT, its first letter": a structure and a comma, and then one of its blocks.
    (Of one "being black" it is told elsewhere how it looks.)"""
    if isinstance(item, Noun) and item.head != "patch" and item.det in ("the", "its") and not item.plural:
        looks = item.traits.colors + item.traits.labels
        several = isinstance(before, Noun) and before.det == "bare" and before.plural and looks
        whole = isinstance(before, Structure) and behind != "being" and item.traits != Traits()
        return bool(several or whole) and item.amount is None and item.part_of is None
    if not (isinstance(before, Noun) and isinstance(item, Noun)) or before.traits != Traits() or before.head != "block":
        return False
    return before.amount is not None and item.amount is not None and bool(item.traits.colors)


def retelling(items: tuple[Meaning, ...], item: Meaning) -> tuple[Noun, ...] | None:
    """ "some distractors, exactly three purple ones": the first thing with what a comma adds to it; with nothing where
    "digits, A, B, C" would list things beside a word for all of them. None: the list goes on."""
    first = items[-1]
    if len(items) == 1 and what_is_left(first) and isinstance(item, Noun) and item.traits != Traits():
        return ()
    if len(items) == 1 and isinstance(first, Noun) and isinstance(item, Noun) and _counted_symbols(first, item):
        many = len(item.traits.labels)
        named = replace(item, det="the" if first.det == "the" else "bare", cost=0)
        return (named,) if first.amount == Amount(many, many) else ()
    if isinstance(first, Noun) and isinstance(item, Noun) and first.amount is not None and _some_of_it(item):
        return ()
    if not (isinstance(first, Noun) and isinstance(item, Noun)) or first.amount is not None or first.traits.labels:
        return None
    if len(items) == 1 and first.det == "some" and item.amount is not None and item.head == "any":
        return (replace(first, amount=item.amount, traits=replace(first.traits, colors=item.traits.colors)),)
    general = first.det in ("bare", "the", "all") and first.plural and first.traits.kind is not None
    if general and len(items) == 1 and first.det in ("all", "the") and _named_by(first, item):
        return (replace(first, traits=replace(first.traits, labels=item.traits.labels), cost=0),)
    return () if general and not first.traits.colors and item.traits.labels and item.det == "bare" else None


def what_is_left(whole: Meaning) -> bool:
    """ "The remaining blocks, green and white, ...": what follows tells which these are."""
    if isinstance(whole, Pronoun):
        return whole.word in _LEFT
    return isinstance(whole, Noun) and whole.det == "other" and whole.plural and whole.traits == Traits()


_LEFT = frozenset({"the rest", "the others", "the other ones", "the remaining ones", "the remainder", "all the rest",
                   "all the others", "everything else", "all others"})  # fmt: skip


def _named_by(first: Noun, item: Noun) -> bool:
    """ "all letters (A, B, C)": just which they are."""
    kind, labels = first.traits.kind, item.traits.labels
    fits = all(x.isalpha() for x in labels) if kind == "letter" else all(x.isdigit() for x in labels)
    plain = first.traits == Traits(kind=kind, quality=first.traits.quality) and item.traits == Traits(labels=labels)
    return plain and fits and bool(labels) and kind in ("letter", "digit") and item.det == "bare"


_SORTS = {"odd": "13579", "even": "02468", "vowel": "AEIOU", "consonant": "BCDFGHJKLMNPQRSTVWXYZ",
          "digit": string.digits}  # fmt: skip


def named_by(whole: Noun, labels: tuple[str, ...]) -> bool:
    """Whether these symbols may be the ones that a phrase speaks of: odd digits, three letters."""
    marks, many = whole.traits, whole.amount
    among = _SORTS.get(marks.quality or marks.kind or "", string.ascii_uppercase)
    plain = marks == Traits(kind=marks.kind, quality=marks.quality) and whole.part_of is None and not whole.conditions
    return plain and all(label in among for label in labels) and (many is None or many.low == many.high == len(labels))


def _counted_symbols(first: Noun, item: Noun) -> bool:
    """ "two letters, X and Y", "two vowels, A and E": symbols behind a number of them tell which these are, they are no
    further ones."""
    kind, quality = first.traits.kind, first.traits.quality
    fits = kind in ("letter", "symbol") or (kind == "digit" and all(x.isdigit() for x in item.traits.labels))
    if quality is not None:
        fits = quality in _SORTS and all(x in _SORTS[quality] for x in item.traits.labels)
    plain = first.traits == Traits(kind=kind, quality=quality) and item.traits == Traits(labels=item.traits.labels)
    return first.amount is not None and fits and plain and bool(item.traits.labels)


def _some_of_it(item: Noun) -> bool:
    """ "two" after "five orange blocks,": some of them, no others."""
    return item.head == "any" and item.det == "bare" and item.amount is not None and item.traits == Traits()


def so_many_of_it(p: Parser, before: Meaning, item: Meaning, at: int) -> bool:
    """ "four red boxes, 2 on the mat": a number behind counted blocks, and where these are, is no block with it."""
    counted = isinstance(before, Noun) and before.head != "patch" and not before.traits.labels and before.amount
    if not counted or not isinstance(item, Noun) or p.words[at : at + 1] != [","] or at + 2 >= p.end:
        return False
    mere = item == Noun(head=item.head, det="bare", traits=Traits(labels=item.traits.labels), span=item.span,
                        cost=item.cost)  # fmt: skip
    return mere and p.tokens[at + 1].kind == "number" and p.words[at + 2] in _THERE and counted.low > 1


_THERE = frozenset({"on", "in", "onto", "at", "next", "behind", "beside", "near", "under", "of"})


def bare_color(item: Noun) -> bool:
    """ "red" after a structure and a comma says something of the structure."""
    return item.head == "any" and item.det in ("bare", "all") and item.amount is None and bool(item.traits.colors)


def mere_size(item: Noun) -> bool:
    """ "5 cm cubes" behind a comma says how large the blocks are, it names no further ones."""
    marks = item.traits
    sized = bool(marks.edge or marks.size) and marks == Traits(edge=marks.edge, size=marks.size)
    return sized and item.head == "block" and item.plural and item.det == "bare" and item.amount is None


def part_after(before: Meaning, item: Meaning) -> bool:
    """ "a tower with black ends and white ..." goes on with the tower's parts."""
    parts = isinstance(before, Structure) and any(isinstance(d, Absolute | Coord | Pattern) for d in before.details)
    return parts and not isinstance(item, Structure)


def named_together(items: tuple[Meaning, ...]) -> Noun | None:
    """ "the red and the blue blocks": the plural noun stands for both, as in "the red and blue blocks"."""
    last = items[-1]
    if not (isinstance(last, Noun) and last.det == "the" and last.plural and last.amount is None):
        return None
    colors: tuple[str, ...] = ()
    for item in items:
        bare = isinstance(item, Noun) and item.det == "the" and item.amount is None and not item.conditions
        if not (bare and isinstance(item, Noun) and item.traits == Traits(colors=item.traits.colors)):
            return None
        if len(item.traits.colors) != 1 or (item is not last and (item.head != "any" or item.plural)):
            return None
        colors += item.traits.colors
    return replace(last, traits=replace(last.traits, colors=colors)) if last.head != "any" else None


def sized_alike(p: Parser, items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "two big and two small red blocks", "a big and a small red one", "small and big red": what is said behind the
    last size is said of all of them."""
    last = items[-1]
    if not (isinstance(last, Noun) and last.traits.size and last.head in ("block", "any") and last.part_of is None):
        return items
    if last.head == "any" and last.traits == Traits(size=last.traits.size):
        return items
    found: list[Meaning] = []
    for item in items[:-1]:
        sized = isinstance(item, Noun) and item.head == "any" and item.traits == Traits(size=item.traits.size)
        if not (sized and isinstance(item, Noun) and item.traits.size) or (last.head == "any" and says_ones(p, item)):
            return items
        found.append(replace(item, head=last.head, traits=replace(last.traits, size=item.traits.size)))
    return (*found, last)


def extra_alike(items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "one gray and one pink distractor": the noun stands for both."""
    last = items[-1]
    if not (isinstance(last, Noun) and last.traits.extra and last.head == "block" and len(last.traits.colors) == 1):
        return items
    found: list[Meaning] = []
    for item in items[:-1]:
        colored = isinstance(item, Noun) and item.head == "any" and len(item.traits.colors) == 1
        if not (colored and isinstance(item, Noun) and item.traits == Traits(colors=item.traits.colors)):
            return items
        if item.amount is None or item.det not in ("a", "bare"):
            return items
        found.append(replace(item, head="block", traits=replace(item.traits, extra=True)))
    return (*found, last)


def shares_head(before: Meaning, item: Meaning, ones: bool = False) -> bool:
    """ "the red and blue blocks": the plural noun stands for both, it is not "the red one and several blue blocks".
    `ones`: it is "ones"."""
    if isinstance(before, Structure) and isinstance(own := before.members, Noun) and isinstance(item, Noun):
        counted = own.amount is not None and item.amount is not None and item.det == own.det == "bare"
        return counted and own.head == "any" and bool(own.traits.colors) and item.head == "block"
    if not (isinstance(before, Noun) and isinstance(item, Noun)):
        return False
    headed = item.head != "any" or ones
    bare = item.det == "bare" and item.plural and item.amount is None and headed and item.traits.colors
    return bool(bare and before.head == "any" and before.traits.colors)


_SINGULAR = frozenset({"is", "lies", "stands", "sits", "rests", "starts", "begins", "has", "was", "remains"})


def one_heap(theme: Meaning, verb: str) -> bool:
    """ "a heap of three red and three blue blocks lies ...": after one verb for one thing it is a heap of both."""
    if verb not in _SINGULAR or not isinstance(theme, Coord) or not isinstance(first := theme.items[0], Structure):
        return False
    last = theme.items[-1]
    several = isinstance(last, Noun) and last.plural and last.det == "bare"
    return several and not first.plural and first.members is not None


def beside_heap(first: Meaning, found: Meaning) -> Meaning:
    """ "a heap of two red cubes and two blue cubes": all of them are in it, rather than the last beside it."""
    if not isinstance(first, Structure) or first.kind != "pile" or not isinstance(found, Coord) or found.op != "and":
        return found
    alike = [x for x in (first.members, *found.items[1:]) if isinstance(x, Noun) and x.det == "bare" and x.plural]
    several = len(alike) == len(found.items) and all(x.head != "patch" and x.amount is not None for x in alike)
    return replace(found, cost=found.cost + 1) if several else found


def some_of_which(p: Parser, i: int, theme: Meaning) -> bool:
    """ "Three blocks, two of which are blue, shall be on the mat": what comes behind it is of all of them."""
    some = isinstance(theme, Noun) and theme.part_of is not None
    return some and any(p.words[n] == "which" and p.char(n, 0) >= theme.span[0] for n in range(i))


def none_of(theme: Meaning) -> bool:
    """ "nothing", "no red block", "none of them"."""
    word = getattr(theme, "word", "")
    return getattr(theme, "det", "") == "no" or word in ("nothing", "nothing else") or word.startswith("none of")


def denied_of(theme: Meaning) -> bool:
    """ "Nothing (may ever ...)", "no other block", "neither A nor B", "only A": some may not."""
    other = getattr(theme, "det", "") == "no other" or getattr(theme, "op", "") in ("nor", "none but", "only")
    return none_of(theme) or other or getattr(theme, "word", "").startswith("neither of")


def told_of(before: Clause, both: bool = False) -> Meaning:
    """Whom a clause tells of, where a further one says no more than "and is ..."."""
    if before.subject is not None:
        again = isinstance(before.subject, Noun) and before.subject.det in ("a", "any", "bare")
        return replace(before.subject, det="the") if again else before.subject
    return Pronoun(word="both the same" if both else "same", span=before.theme.span if before.theme else before.span)


def begins_anew(theme: Meaning) -> bool:
    """ "red, green, blue, red (leftmost)": behind different looks one of them again is told of by itself."""
    looks: tuple[Meaning | str, ...] = ()
    if isinstance(theme, Noun) and theme.amount is None:
        looks = theme.traits.colors or theme.traits.labels
    elif isinstance(theme, Coord) and all(isinstance(x, Noun) and x.amount is None for x in theme.items):
        looks = tuple(look for x in theme.items if isinstance(x, Noun) for look in x.traits.colors + x.traits.labels)
    return len(looks) > 3 and looks[-1] in looks[:-1] and len(set(looks)) == len(looks) - 1


def all_colored(p: Parser, items: tuple[Meaning, ...], j: int) -> tuple[Meaning, ...]:
    """ "one 5 cm cube and two 3 cm cubes, all white": what ends the list is said of everything in it."""
    last = items[-1]
    if not isinstance(last, Noun) or len(last.traits.colors) != 1:
        return items
    those = last.det in ("both", "all") and last.head == "any" and last.traits == Traits(colors=last.traits.colors)
    every = p.words[j - 3 : j - 1] in ([",", "all"], [",", "both"], [",", "each"])
    told = [x for item in items[:-1] for x in (item.items if isinstance(item, Coord) else (item,))]
    open_ = all(isinstance(x, Noun) and not x.traits.colors and x.traits != Traits() for x in told)
    if not every or not open_ or any(isinstance(item, Coord) and item.op != "and" for item in items):
        return items
    named = [replace(x, traits=replace(x.traits, colors=last.traits.colors)) for x in told if isinstance(x, Noun)]
    return (*named,) if those and len(named) > 1 else (*named, last)
