"""Orders, directions, patterns, spacing: how the members of a structure are laid out."""

from __future__ import annotations

from rpg.passes.schema import lexicon
from rpg.passes.schema.grammar.core import Parser, Results, rule
from rpg.passes.schema.grammar.lists import listed
from rpg.passes.schema.meaning import At, Meaning, OrderBy, Pattern, Spacing, Toward

SIDES = {
    "left": "left", "right": "right", "top": "top", "bottom": "bottom", "front": "front", "back": "back",
    "near": "front",
    "far": "back", "base": "bottom", "ground": "bottom", "rear": "back", "leftmost": "left", "rightmost": "right",
}  # fmt: skip
_OPPOSITE = {"left": "right", "right": "left", "top": "bottom", "bottom": "top", "front": "back", "back": "front"}
AXIS = {"left": "y", "right": "y", "front": "x", "back": "x", "top": "z", "bottom": "z"}

_NAMED = (
    ("in alphabetical order", "label", {}), ("alphabetically", "label", {}), ("in alphabetic order", "label", {}),
    ("in reverse alphabetical order", "label", {"descending": True}), ("in order of the alphabet", "label", {}),
    ("in abc order", "label", {}), ("in reversed alphabetical order", "label", {"descending": True}),
    ("alphabetical", "label", {}),
    ("reverse alphabetically", "label", {"descending": True}), ("in the order of the alphabet", "label", {}),
    ("in alphabetical sequence", "label", {}), ("by letter", "label", {}),
    ("in backward alphabetical order", "label", {"descending": True}),
    ("in numerical order", "number", {}), ("in numeric order", "number", {}), ("numerically", "number", {}),
    ("in number order", "number", {}),
    ("in strictly increasing numerical order", "number", {}), ("in increasing numerical order", "number", {}),
    ("in counting order", "number", {}),
    ("in ascending numerical order", "number", {}), ("in strictly increasing order", "number", {}),
    ("in descending numerical order", "number", {"descending": True}),
    ("in decreasing numerical order", "number", {"descending": True}),
    ("in reverse numerical order", "number", {"descending": True}),
    ("in ascending order", "ascending", {}), ("in increasing order", "ascending", {}),
    ("in descending order", "ascending", {"descending": True}),
    ("in decreasing order", "ascending", {"descending": True}), ("by number", "number", {}),
    ("from smallest to largest", "ascending", {}),
    ("from lowest to highest", "ascending", {}), ("from highest to lowest", "ascending", {"descending": True}),
    ("ascending", "ascending", {}),
    ("descending", "ascending", {"descending": True}), ("from low to high", "ascending", {}),
    ("from high to low", "ascending", {"descending": True}),
    ("from largest to smallest", "ascending", {"descending": True}),
    ("from biggest to smallest", "ascending", {"descending": True}),
    ("from small to large", "ascending", {}), ("from big to small", "ascending", {"descending": True}),
    ("from small to big", "ascending", {}),
    ("from large to small", "ascending", {"descending": True}), ("from smallest to biggest", "ascending", {}),
    ("in order of size", "size", {}),  ("in size order", "size", {}), ("in order of increasing size", "size", {}),
    ("in order of decreasing size", "size", {"descending": True}), ("by increasing size", "size", {}),
    ("by decreasing size", "size", {"descending": True}),
    ("in rainbow order", "rainbow", {}), ("in a color gradient", "rainbow", {}),
    ("in a colour gradient", "rainbow", {}), ("as a color gradient", "rainbow", {}),
    ("in a gradient", "rainbow", {}), ("in the order of the rainbow", "rainbow", {}),
    ("in the colors of the rainbow", "rainbow", {}),
    ("like a rainbow", "rainbow", {}), ("in spectrum order", "rainbow", {}), ("in color gradient order", "rainbow", {}),
    ("in a rainbow", "rainbow", {}), ("in gradient order", "rainbow", {}), ("as a gradient", "rainbow", {}),
    ("in spectral order", "rainbow", {}),
    ("into a color gradient", "rainbow", {}), ("into a gradient", "rainbow", {}),
    ("in a rainbow gradient", "rainbow", {}), ("in color order", "rainbow", {}),
    ("in order of the rainbow", "rainbow", {}), ("following the rainbow", "rainbow", {}),
    ("in rainbow color order", "rainbow", {}), ("as a rainbow", "rainbow", {}),
    ("in a color spectrum", "rainbow", {}), ("by rainbow order", "rainbow", {}), ("into a rainbow", "rainbow", {}),
    ("in a rainbow order", "rainbow", {}),
    ("with alternating colors", "alternating", {}), ("alternating colors", "alternating", {}),
    ("in alternating colors", "alternating", {}),
    ("alternating in color", "alternating", {}), ("with the colors alternating", "alternating", {}),
    ("so that the colors alternate", "alternating", {}),
    ("with colors alternating", "alternating", {}), ("of alternating colors", "alternating", {}),
    ("in an alternating pattern", "alternating", {}),
    ("in alternating order", "alternating", {}), ("alternately", "alternating", {}),
    ("alternating", "alternating", {}), ("in alternation", "alternating", {}),
    ("in an alternating color pattern", "alternating", {}), ("of alternating color", "alternating", {}),
    ("with alternating color", "alternating", {}),
    ("in a mirrored order", "mirrored", {}), ("in mirrored order", "mirrored", {}), ("symmetrically", "mirrored", {}),
    ("in a symmetric pattern", "mirrored", {}),
    ("with mirrored colors", "mirrored", {}), ("mirrored", "mirrored", {}), ("in a palindrome", "mirrored", {}),
    ("in a symmetrical order", "mirrored", {}),
    ("in a mirrored pattern", "mirrored", {}), ("symmetrical in color", "mirrored", {}),
    ("in mirror symmetry", "mirrored", {}), ("in a symmetric order", "mirrored", {}),
    ("with even numbers before odd numbers", "even_first", {}), ("even numbers first", "even_first", {}),
    ("evens before odds", "even_first", {}),
    ("with the even numbers before the odd numbers", "even_first", {}), ("with even before odd", "even_first", {}),
    ("even before odd", "even_first", {}),
    ("even numbers before odd numbers", "even_first", {}), ("odd numbers before even numbers", "odd_first", {}),
    ("evens first", "even_first", {}),
    ("with the even numbers first", "even_first", {}), ("with odd before even", "odd_first", {}),
    ("odd before even", "odd_first", {}), ("with the odd ones before the even ones", "odd_first", {}),
    ("with the even ones before the odd ones", "even_first", {}), ("with odd ones before even ones", "odd_first", {}),
    ("with even ones before odd ones", "even_first", {}),
    ("with the odd numbers before the even numbers", "odd_first", {}), ("odd ones before even ones", "odd_first", {}),
    ("even ones before odd ones", "even_first", {}), ("with the odd numbers first", "odd_first", {}),
    ("with the odd ones first", "odd_first", {}),
    ("with the even ones first", "even_first", {}), ("with all the vowels before the consonants", "vowel_first", {}),
    ("with the consonants before the vowels", "consonant_first", {}),
    ("with the consonants first", "consonant_first", {}), ("vowels before the consonants", "vowel_first", {}),
    ("with evens before odds", "even_first", {}), ("with odds before evens", "odd_first", {}),
    ("with odd numbers before even numbers", "odd_first", {}),
    ("vowels first", "vowel_first", {}), ("with the vowels first", "vowel_first", {}),
    ("with vowels first", "vowel_first", {}), ("vowels before consonants", "vowel_first", {}),
    ("with vowels before consonants", "vowel_first", {}), ("consonants first", "consonant_first", {}),
    ("consonants before vowels", "consonant_first", {}),
    ("with consonants before vowels", "consonant_first", {}),
    ("with all vowels before all consonants", "vowel_first", {}),
    ("with the vowels before the consonants", "vowel_first", {}), ("even numbers then odd numbers", "even_first", {}),
    ("in any order", "any", {}), (", in any order", "any", {}), (", any order", "any", {}),
    ("the order does not matter", "any", {}), (", the order does not matter", "any", {}),
    ("in whatever order", "any", {}),
    (", order does not matter", "any", {}), ("no matter the order", "any", {}), ("in random order", "any", {}),
    ("in this order", "given", {}), (", in this order", "given", {}), (", in that order", "given", {}),
    ("so that the numbers increase", "number", {}), ("so they count up", "number", {}),
    ("so that they count up", "number", {}), ("so they count down", "number", {"descending": True}),
    ("so that they count down", "number", {"descending": True}),
    ("in reading order", "in_order", {}), (", read like a page", "in_order", {}),
    ("in temporal order", "temporal", {}), ("in exact temporal order", "temporal", {}),
    ("one after the other", "temporal", {}), ("one after another", "temporal", {}),
    ("with the biggest number at the bottom", "number_down", {}),
    ("with the largest number at the bottom", "number_down", {}),
    ("with the highest number at the bottom", "number_down", {}),
    ("with the smallest number on top", "number_down", {}),
    ("with the lowest number at the bottom", "number_up", {}),
    ("with the smallest number at the bottom", "number_up", {}), ("with the largest number on top", "number_up", {}),
    ("with the biggest number on top", "number_up", {}),
    ("evens first and then odds", "even_first", {}), ("evens first then odds", "even_first", {}),
    ("odds first then evens", "odd_first", {}), ("even ones first", "even_first", {}),
    ("odd numbers first", "odd_first", {}), ("odds first", "odd_first", {}),
    (", vowels first", "vowel_first", {}), (", evens first and then odds", "even_first", {}),
    (", consonants first", "consonant_first", {}), (", even numbers first", "even_first", {}),
    (", odd numbers first", "odd_first", {}),
    ("with same colors together", "by_color", {}), ("with the same colors together", "by_color", {}),
    ("with equal colors together", "by_color", {}), ("so that blocks of the same color are next to each other",
    "by_color", {}),
    ("so that equal colors are next to each other", "by_color", {}),
    ("so that the same colors are next to each other", "by_color", {}),
    ("with blocks of the same color next to each other", "by_color", {}), ("grouped by color", "by_color", {}),
    ("with like colors together", "by_color", {}), ("with blocks of the same color side by side", "by_color", {}),
    ("with blocks of the same color together", "by_color", {}),
    ("with blocks of the same color adjacent", "by_color", {}),
    ("so that blocks of the same color are side by side", "by_color", {}),
    ("so that blocks of the same color are together", "by_color", {}),
    ("with blocks of equal color next to each other", "by_color", {}),
    ("so that blocks of the same color are adjacent", "by_color", {}),
    ("so that no two neighbors have the same color", "alternating", {}),
    ("so that no two neighboring blocks have the same color", "alternating", {}),
    ("with no two neighbors of the same color", "alternating", {}),
    ("so that neighbors have different colors", "alternating", {}),
    ("that is the same read from either end", "mirrored", {}), ("that reads the same from both ends", "mirrored", {}),
    ("so that it reads the same from both ends", "mirrored", {}),
    ("that reads the same in both directions", "mirrored", {}), ("that reads the same from either end", "mirrored", {}),
    (", whichever order you like", "any", {}), (", any order will do", "any", {}),
    ("in any order you like", "any", {}), (", order irrelevant", "any", {}), ("whichever order you like", "any", {}),
    ("regardless of order", "any", {}), (", in whatever order", "any", {}),
    ("so that the colors alternate between", "alternating", {}), ("so that the colors are together", "by_color", {}),
    ("with each color together", "by_color", {}), ("so that same colors are adjacent", "by_color", {}),
    ("in no particular order", "any", {}), ("in reverse order", "reverse", {}), ("in reverse", "reverse", {}),
    ("in that order", "given", {}), ("in this order", "given", {}), ("in the order given", "given", {}),
    ("in order", "in_order", {}),
    ("in sequence", "in_order", {}), ("in the right order", "in_order", {}), ("in the given order", "given", {}),
    ("in the stated order", "given", {}),
    ("with the largest at the bottom", "size_down", {}), ("with the biggest at the bottom", "size_down", {}),
    ("largest at the bottom", "size_down", {}),
    ("with the smallest on top", "size_down", {}), ("with the largest on the bottom", "size_down", {}),
    ("biggest at the bottom", "size_down", {}),
    ("with the largest on top", "size_up", {}), ("with the biggest on top", "size_up", {}),
    ("smallest on top", "size_down", {}),
    ("with the smallest at the bottom", "size_up", {}), ("with the smallest at the top", "size_down", {}),
    ("largest on the bottom", "size_down", {}),
    ("with the biggest on the bottom", "size_down", {}), ("smallest at the top", "size_down", {}),
)  # fmt: skip
_LEADS = frozenset(
    {"reading", "sorted", "ordered", "arranged", "lined", "organized", "organised", "going", "running", "placed"}
)


@rule
def order(p: Parser, i: int) -> Results[Meaning]:
    """An order, a direction, a pattern, a spacing."""
    j = p.one(i, _LEADS) or i
    for start in {i: None, j: None}:
        for phrase, by, extra in _NAMED:
            if k := p.seq(start, phrase):
                yield OrderBy(by=by, span=p.span(i, k), descending=bool(extra.get("descending"))), k
        yield from toward(p, start)
        yield from _explicit(p, start)
        yield from _by_attribute(p, start, j > i)
        yield from temporal(p, start)
    yield from pattern(p, i)
    yield from spacing(p, i)
    yield from _alternating(p, i)
    yield from _toward_list(p, i)


def _alternating(p: Parser, i: int) -> Results[Meaning]:
    """ "alternating red and white", "alternating between red and blue blocks"."""
    j = p.any_of(
        i,
        (
            "alternating between",
            "whose colors alternate between",
            "with colors alternating between",
            "with alternating colors",
            "in alternating colors ,",
            "so that the colors alternate between",
            "alternating",
            "with alternating",
            "of alternating",
            "that alternate between",
            "which alternate between",
            "switching between",
        ),
    )
    for items, k in listed(p, j) if j else ():
        k = p.opt(k, "blocks", "cubes", "ones")
        yield OrderBy(by="alternating", items=items, span=p.span(i, k)), k
    for items, k in listed(p, i):
        if end := p.any_of(k, ("alternating", "in alternation", "alternately")):
            yield OrderBy(by="alternating", items=items, span=p.span(i, end)), end


@rule
def temporal(p: Parser, i: int) -> Results[Meaning]:
    """ "in exact temporal order (blue first, then red)"."""
    j = p.any_of(
        i,
        (
            "in exact temporal order",
            "in temporal order",
            "in the temporal order",
            "in strict temporal order",
            "in the order",
            "one after the other",
            "in time order",
            "in this order",
        ),
    )
    if not j:
        return
    opened = p.one(p.opt(j, ",", ":"), frozenset({"(", "["}))
    k = opened or p.opt(j, ",", ":")
    k = p.opt(k, "first")
    for items, end in firsts(p, k):
        close = p.one(end, frozenset({")", "]"})) if opened else end
        if close:
            yield OrderBy(by="temporal", items=items, span=p.span(i, close)), close


@rule
def firsts(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """ "blue first, then red": an explicit order in time."""
    from rpg.passes.schema.grammar.nouns import simple

    for first, j in simple(p, i):
        j = p.opt(j, "first")
        for rest, k in _after_first(p, j):
            yield (first, *rest), k


def _after_first(p: Parser, at: int) -> Results[tuple[Meaning, ...]]:
    from rpg.passes.schema.grammar.nouns import simple

    j = p.opt(at, ",")
    j = p.any_of(j, ("and then", "then", "and finally", "finally", "and", "followed by"))
    if not j:
        return
    for item, k in simple(p, j):
        k = p.opt(k, "second", "last", "third", "afterwards", "after that")
        yield (item,), k
        for rest, end in _after_first(p, k):
            yield (item, *rest), end


@rule
def toward(p: Parser, i: int) -> Results[Meaning]:
    """ "from left to right", "bottom to top", "from the bottom up", "vertically", "starting from the left"."""
    j = p.one(i, "from") or i
    j2 = p.opt(j, "the")
    first = SIDES.get(p.words[j2]) if j2 < p.end else None
    if first:
        k = p.reach(j2 + 1)
        k = p.opt(k, "side", "end")
        if e := p.one(k, frozenset({"to", "towards"})):
            e = p.opt(e, "the")
            last = SIDES.get(p.words[e]) if e < p.end else None
            if last == _OPPOSITE[first]:
                yield Toward(first=first, axis=AXIS[first], span=p.span(i, e + 1)), p.opt(p.reach(e + 1), "side", "end")
        if p.words[k : k + 1] in (["up"], ["upwards"], ["upward"]) and first == "bottom" and j > i:
            yield Toward(first="bottom", axis="z", span=p.span(i, k + 1)), p.reach(k + 1)
        if p.words[k : k + 1] in (["down"], ["downwards"], ["downward"]) and first == "top" and j > i:
            yield Toward(first="top", axis="z", span=p.span(i, k + 1)), p.reach(k + 1)
    for phrase, side, axis in (
        ("starting from the left", "left", "y"), ("starting at the left", "left", "y"),
        ("starting from the right", "right", "y"),
        ("starting from the bottom", "bottom", "z"), ("starting at the bottom", "bottom", "z"),
        ("starting from the top", "top", "z"),
        ("starting on the left", "left", "y"), ("starting on the right", "right", "y"),
        ("starting at the right", "right", "y"),
        ("starting from the front", "front", "x"), ("starting from the back", "back", "x"),  ("upwards", "bottom", "z"),
        ("going right", "left", "y"), ("going left", "right", "y"), ("downwards", "top", "z"),
        ("going down", "top", "z"), ("bottom up", "bottom", "z"), ("top down", "top", "z"),
        ("upward", "bottom", "z"), ("starting at the top", "top", "z"), ("starting at the front", "front", "x"),
        ("starting with the bottom", "bottom", "z"),
        ("from near to far", "front", "x"), ("from far to near", "back", "x"), ("away from the robot", "front", "x"),
        ("towards the robot", "back", "x"),
    ):  # fmt: skip
        if k := p.seq(i, phrase):
            yield Toward(first=side, axis=axis, span=p.span(i, k)), k
    for phrase, axis in (("horizontally", "y"), ("vertically", "z"), ("upright", "z"), ("along the y axis", "y"),
        ("along the x axis", "x"),
                         ("across the table", "y"), ("lengthwise", "x")):  # fmt: skip
        if k := p.seq(i, phrase):
            yield Toward(axis=axis, span=p.span(i, k)), k


def _explicit(p: Parser, i: int) -> Results[Meaning]:
    """ "in the order red, yellow, green", "in this order: A, B, C", "red first, then blue"."""
    j = p.any_of(i, ("in the following order", "in the order of", "in the order", "in order", "in this order",
        "in the sequence", "in color order",
                     "following the order", "with the order", "with order", "with the color order",
                     "in the color order", "order",
                     "in that order", "ordered as", "ordered", "in the pattern", "as", "like this", "as follows",
                     "that goes", "that go", "which goes", "in order from", "going", "that reads", "which reads",
                     "so they are", "so that they are", "so it goes", "in a sequence of",
                     "in the sequence of"))  # fmt: skip
    if not j:
        return
    j = p.opt(j, ":", ",", "of")
    j = p.opt(j, "first") if p.words[j : j + 1] == ["first"] else j
    j = p.opt(j, "from") if p.words[j : j + 1] == ["from"] and j + 1 < p.end and p.words[j + 1] in lexicon.COLOR else j
    yield from ((OrderBy(by="given", items=items, span=p.span(i, k)), k) for items, k in listed(p, j))


_INTO_ATTRIBUTES = tuple(
    (f"into {one} and {two}", attribute)
    for firsts_, seconds, attribute in (
        (("vowels", "vowel"), ("consonants", "consonant"), "vowel"), (("consonants",), ("vowels",), "vowel"),
        (("odd", "odds", "odd numbers", "odd ones"), ("even", "evens", "even numbers", "even ones"), "parity"),
        (("even", "evens", "even numbers", "even ones"), ("odd", "odds", "odd numbers", "odd ones"), "parity"),
        (("letters",), ("numbers", "digits"), "kind"), (("numbers", "digits"), ("letters",), "kind"),
        (("an odd group",), ("an even group",), "parity"), (("an even group",), ("an odd group",), "parity"),
        (("a vowel group", "a group of vowels"), ("a consonant group", "a group of consonants"), "vowel"),
        (("a group of letters",), ("a group of numbers", "a group of digits"), "kind"),
        (("an odd pile",), ("an even pile",), "parity"),
    )
    for one in firsts_
    for two in seconds
)  # fmt: skip
_ATTRIBUTES = {
    "color": "color", "colour": "color", "colors": "color", "letter": "label", "label": "label", "number": "label",
    "kind": "kind",
    "type": "kind", "size": "size", "symbol": "label", "letters": "label", "parity": "parity", "value": "label",
    "shade": "color", "category": "kind",
}  # fmt: skip


@rule
def _toward_list(p: Parser, i: int) -> Results[Meaning]:
    """ "whose colors from top to bottom are red, white and black", "so that from left to right they are ..."."""
    j = (
        p.any_of(
            i,
            (
                "whose colors",
                "so that the colors",
                "with the colors",
                "with colors",
                "so that",
                "where the colors",
                "such that",
                "in which the colors",
                "where",
                "so",
            ),
        )
        or i
    )
    sides = list(toward(p, j)) if j < p.end else []
    for found, k in sides:
        if not isinstance(found, Toward) or not found.first:
            continue
        end = p.any_of(
            p.opt(k, "order"),
            ("they are", "are", "it is", "they read", "is", "read", "it reads", "the blocks are", "the colors are"),
        ) or (p.one(k, ":") if j == i else 0)
        for items, last in listed(p, p.opt(end, ":")) if end else ():
            yield OrderBy(by="given", items=items, first=found.first, span=p.span(i, last)), last


def _by_attribute(p: Parser, i: int, led: bool) -> Results[Meaning]:
    """ "by colour", "according to size", "by even and odd", "into vowels and consonants"."""
    for phrase, attribute in _INTO_ATTRIBUTES:
        if k := p.seq(i, phrase):
            yield OrderBy(by="attribute", attribute=attribute, span=p.span(i, k)), k
    j = p.any_of(i, ("by", "according to", "based on", "by their", "according to their", "by the", "depending on",
        "by whether they are", "according to whether they are", "on the basis of", "based on their",
                     "by same", "by different", "by block"))  # fmt: skip
    if j:
        word = p.words[j] if j < p.end else ""
        if word in _ATTRIBUTES:
            k = p.reach(j + 1)
            k = p.opt(k, "of")
            yield OrderBy(by="attribute", attribute=_ATTRIBUTES[word], span=p.span(i, k)), k
        for phrase, attribute in (("even and odd", "parity"), ("odd and even", "parity"),
            ("whether they are even or odd", "parity"), ("even or odd", "parity"),
                                  ("vowel and consonant", "vowel"), ("vowels and consonants", "vowel"),
                                  ("whether they are vowels or consonants", "vowel"),
                                  ("vowel or consonant", "vowel"), ("odd or even", "parity")):  # fmt: skip
            if k := p.seq(j, phrase):
                yield OrderBy(by="attribute", attribute=attribute, span=p.span(i, k)), k


_UNITS = {"row": "row", "column": "column", "layer": "layer", "level": "layer", "stack": "stack", "tower": "stack",
    "pile": "pile", "group": "pile",
          "floor": "layer", "line": "row", "bunch": "pile", "tier": "layer", "rows": "row", "columns": "column",
          "layers": "layer", "stacks": "stack",
          "towers": "stack", "piles": "pile", "groups": "pile"}  # fmt: skip
_SAME = ("the same color", "of the same color", "one color", "a single color", "of one color", "a color",
    "of a single color", "single colored", "same colored",
         "of the same colour", "the same colour", "one colour", "a single colour", "in one color",
         "in a single color", "uniform in color", "all one color",
         "the same color throughout", "all the same color", "one solid color", "blocks of the same color",
         "blocks of one color", "only one color",
         "blocks of a single color", "same color", "blocks of only one color")  # fmt: skip
_DIFFERENT = ("a different color", "of a different color", "its own color", "a unique color", "a distinct color",
    "different colors", "in a different color",
              "different in color", "of different colors", "a different colour", "of a different colour",
              "its own colour", "in its own color",
              "a unique colour", "differently colored", "of its own color", "a separate color",
              "different color")  # fmt: skip


@rule
def pattern(p: Parser, i: int) -> Results[Meaning]:
    """ "where each row is a different colour", "one colour per layer", "in a checkerboard pattern"."""
    j = p.any_of(i, ("where", "with", "such that", "so that", "in which", ", where", ", with", "so")) or i
    j2 = p.any_of(j, ("each", "every", "all", "each of the", "all the")) or 0
    if j2 and j2 < p.end and p.words[j2] in _UNITS:
        k = p.reach(j2 + 1)
        unit = _UNITS[p.words[j2]]
        k = p.any_of(k, ("of blocks", "of cubes")) or k
        k = p.any_of(k, ("is made of", "should be", "must be", "consists of", "contains", "should have", "is",
            "being", "has", "having", "in", "are", "be", "made of",
                         "containing", "made up of", "uses", "using", "with", "have", "of")) or k  # fmt: skip
        yield from _agree(p, i, k, unit)
    for phrase, unit in (("one color per row", "row"), ("one color per column", "column"),
        ("one color per layer", "layer"), ("a different color per row", "row"),
                         ("one color for each row", "row"), ("one color for each layer", "layer"),
                         ("one color for each column", "column"),
                         ("a different color for each row", "row"), ("a different color for each column", "column"),
                         ("a different color per layer", "layer"),
                         ("a different color for each layer", "layer"), ("a different color for every row", "row"),
                         ("a different color in each row", "row"),
                         ("a different color in each layer", "layer"), ("a different color per column", "column"),
                         ("one color per level", "layer"),
                         ("a different color for every layer", "layer"),
                         ("a different color for every column", "column"), ("one color per stack", "stack"),
                         ("one color per tower", "stack"), ("one color per pile", "pile"),
                         ("one color each", "stack"), ("a single color per row", "row")):  # fmt: skip
        if k := p.seq(j, phrase):
            yield Pattern(unit=unit, span=p.span(i, k)), k
    for phrase in ("in a checkerboard pattern", "in a chessboard pattern", "like a checkerboard", "like a chessboard",
        "checkerboard style",
                   "in a checkered pattern", "checkered", "in checkerboard style", "as a checkerboard",
                   "in checkerboard fashion"):  # fmt: skip
        if k := p.seq(i, phrase):
            yield Pattern(unit="checkerboard", span=p.span(i, k)), k
    if k := p.any_of(i, ("one per color", "one for each color", "one tower per color", "one stack per color",
        "one tower for each color", "one stack for each color",
                         "one of each color", "one pile per color", "one per colour", "one row per color",
                         "each of a different color", "each in a different color",
                         "each a different color", "each of one color", "each of a single color", "each one color",
                         "each the same color", "each a single color",
                         "each with its own color", "each in its own color", "each in one color",
                         "each of its own color")):  # fmt: skip
        yield Pattern(unit="stack", span=p.span(i, k)), k


def _agree(p: Parser, i: int, k: int, unit: str) -> Results[Meaning]:
    for phrase in _SAME:
        if e := p.seq(k, phrase):
            yield (
                Pattern(
                    unit=unit,
                    different=phrase in ("one color", "a single color", "a color") and False,
                    span=p.span(i, e),
                ),
                e,
            )
    for phrase in _DIFFERENT:
        if e := p.seq(k, phrase):
            yield Pattern(unit=unit, different=True, span=p.span(i, e)), e


@rule
def spacing(p: Parser, i: int) -> Results[Meaning]:
    """ "evenly spaced", "with equal gaps"."""
    if j := p.any_of(i, ("evenly spaced", "equally spaced", "evenly spaced out", "with equal spacing",
        "with even spacing", "spaced evenly", "evenly", "with equal gaps",
                         "spaced equally", "with equal space between them", "at equal distances",
                         "with equal distances between them", "uniformly spaced",
                         "with equal gaps between them", "at even intervals", "at equal intervals",
                         "evenly distributed", "with even gaps", "evenly apart",
                         "with equal distance between them", "equally far apart", "with uniform spacing")):  # fmt: skip
        yield Spacing(kind="even", span=p.span(i, j)), j
    if j := p.any_of(i, ("without gaps", "with no gaps", "without any gaps", "with no gaps between them",
        "with no space between them", "without gaps between them",
                         "with no gap between them", "tightly", "touching each other", "packed together",
                         "without space between them",
                         "with each block touching the next", "each touching the next", "flush together",
                         "without any gaps between them",
                         "with no gap", "with no space in between", "side by side and touching")):  # fmt: skip
        yield Spacing(kind="touching", span=p.span(i, j)), j


_WHOLES = (
    ("row", "row"),
    ("line", "row"),
    ("column", "row"),
    ("stack", "stack"),
    ("tower", "stack"),
    ("pile", "stack"),
    ("pyramid", "pyramid"),
)


@rule
def at(p: Parser, i: int) -> Results[Meaning]:
    """A place within the structure: "at the bottom", "in the middle", "on the left", "third from the left"."""
    j = (
        p.any_of(
            i,
            (
                "at the very",
                "on the very",
                "at the",
                "on the",
                "in the",
                "to the",
                "at",
                "on",
                "as the",
                "being the",
                "in",
                "forming the",
            ),
        )
        or 0
    )
    if j:
        word = p.words[j] if j < p.end else ""
        side = {**SIDES, "middle": "middle", "center": "middle", "centre": "middle"}.get(word)
        if side and word not in ("ground", "near", "far"):
            k = p.opt(
                p.reach(j + 1),
                "end",
                "side",
                "most",
                "layer",
                "layers",
                "position",
                "level",
                "hand",
                "block",
                "spot",
                "place",
            )
            k = p.opt(k, "side")
            wholes = (
                (("row", "row"), ("line", "row"), ("column", "row"))
                if side in ("left", "right", "front", "back")
                else _WHOLES
            )
            for word_, whole in wholes:
                if end := p.any_of(k, (f"of the {word_}", f"of this {word_}", f"of that {word_}")):
                    yield At(side=side, whole=whole, span=p.span(i, end)), end
            yield (
                At(side=side, span=p.span(i, k)),
                p.any_of(k, ("of it",)) if side in ("top", "bottom", "middle") and p.seq(k, "of it") else k,
            )
        if word in ("first", "last", "second", "third", "fourth", "fifth") and (
            k := p.any_of(j + 1, ("position", "place", "spot", "from the left"))
        ):
            index = lexicon.ORDINAL.get(word, -1)
            yield At(side="first", index=index, span=p.span(i, k)), k
    for word in ("leftmost", "rightmost", "topmost", "bottommost", "nearest", "frontmost", "farthest"):
        if k := p.one(p.opt(i, "the"), word):
            side = {
                "leftmost": "left",
                "rightmost": "right",
                "topmost": "top",
                "bottommost": "bottom",
                "nearest": "front",
                "frontmost": "front",
                "farthest": "back",
            }[word]
            yield At(side=side, span=p.span(i, k)), k
    ordinal = p.lex(i, lexicon.ORDINAL)
    if ordinal:
        if k := p.any_of(i + 1, ("from the left", "from left")):
            yield At(side="left", index=ordinal, span=p.span(i, k)), k
        elif k := p.any_of(i + 1, ("from the right", "from right")):
            yield At(side="right", index=ordinal, span=p.span(i, k)), k
        elif k := p.any_of(i + 1, ("from the bottom",)):
            yield At(side="bottom", index=ordinal, span=p.span(i, k)), k
        elif k := p.any_of(i + 1, ("from the top",)):
            yield At(side="top", index=ordinal, span=p.span(i, k)), k
