"""Numbers told in a roundabout way: "two, no more and no fewer", "no cube of the three red cubes"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

NO_MORE = frozenset({"more", "fewer", "less"})
_NEITHER = tuple(
    (*comma, "no", one, *joint, *no, other)
    for comma in ((",",), ("(",), ())
    for one, other in (("more", "fewer"), ("more", "less"), ("fewer", "more"), ("less", "more"))
    for joint in (("and",), (",",), ("or",))
    for no in (("no",), ("not",), ())
)  # fmt: skip
_NOT_MORE = ((",", "no", "more"), (",", "not", "more"), (",", "and", "no", "more"))
_EXACT = frozenset({"exactly", "just", "precisely", "only"})


def no_more_no_fewer(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Two, no more and no fewer, of them", "one block out of three, no more, goes there": exactly so many."""
    for at in range(1, len(words)):
        both = length_at(words, at, _NEITHER)
        long = both or length_at(words, at, _NOT_MORE)
        end = at + long
        if not long or (words[end : end + 1] in (["than"], ["of"]) and not both):
            continue
        closed = words[end : end + 1] in ([","], [")"])
        if not both and not closed:
            continue
        begin = next((n for n in range(at - 1, -1, -1) if words[n] in _STOPS), -1) + 1
        number = next((n for n in range(begin, at) if tokens[n].many or words[n] in ("a", "an")), -1)
        if number < 0 or (number and words[number - 1] in (*_EXACT, "least", "most", "than", "the")):
            continue
        exactly = tokens[number].saying("exactly")
        return [*tokens[:number], exactly, *tokens[number:at], *tokens[end + closed :]]
    return None


_STOPS = frozenset({".", "!", "?", ";", ":"})
EXACTLY = frozenset({"exactly", "precisely"})
_BEGUN = frozenset({*_STOPS, ",", "and", "but", "that", "put", "place", "move", "bring", "end", "want", "have"})


def exactly_those(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Exactly the blue cubes are on the mat": these and no others; not "exactly the middle", "exactly the same"."""
    for at in range(len(words) - 2):
        begun = at == 0 or words[at - 1] in _BEGUN
        if words[at] in EXACTLY and words[at + 1] in ("the", "those") and begun:
            end = next((n for n in range(at + 2, len(words)) if words[n] not in _COUNTED), len(words))
            if any(word in lexicon.BLOCK for word in words[at + 2 : end]):
                return [*tokens[:at], tokens[at].saying("only"), *tokens[at + 1 :]]
    return None


MOST = (("at", "most"), ("at", "the", "most"), ("at", "the", "very", "most"), ("or", "fewer"), ("or", "less"),
        ("at", "the", "utmost"), ("maximum",), ("max",), ("tops",), ("at", "maximum"),
        ("as", "a", "maximum"))  # fmt: skip
LEAST = (("at", "least"), ("at", "the", "least"), ("at", "the", "very", "least"), ("or", "more"),
         ("or", "even", "more"), ("minimum",), ("min",), ("at", "minimum"), ("as", "a", "minimum"))  # fmt: skip
"""How a bound is told behind a number, or behind a measure."""
BOUNDS = frozenset({"most", "least", "fewer", "less", "more", "maximum", "max", "tops", "utmost", "minimum", "min"})
_BEHIND = frozenset({"of", "may", "must", "should", "can", "shall", "is", "are", "go", "goes", "lie", "lies", "on", ",",
                     ".", "have", "has", "in", "touch", "left", "right", "behind", "allowed", "to"})  # fmt: skip
_AHEAD = frozenset({",", "and", "but", "which", "that", "of", "put", "want", "place", "move", "have", "with", "be",
                    "are"})  # fmt: skip
_COUNTED = frozenset({"of", "the", "these", "those", "them", *lexicon.BLOCK, *lexicon.COLOR, *lexicon.SIZE,
                      *lexicon.NUMBER})  # fmt: skip


def so_many_at_most(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Two at most of them", "one at least must be there", "two of the blocks or more": at most two; but "the red one
    at least 15 cm from it"."""
    for at in range(1, len(words)):
        most = length_at(words, at, MOST)
        long = most or length_at(words, at, LEAST)
        behind = words[at + long] if at + long < len(words) else "."
        if not long or behind not in _BEHIND:
            continue
        begin = at
        while begin and (words[begin - 1] in _COUNTED or tokens[begin - 1].kind == "number"):
            begin -= 1
        n = next((n for n in range(begin, at) if tokens[n].many and words[n + 1] in ("of", *words[at : at + 1])), at)
        ahead = words[n - 1] if n else ","
        partly = n < at - 1 and ahead not in (*_EXACT, "least", "most", "than")
        if n < at and (partly or ahead in _AHEAD or ahead in _STOPS) and (n == at - 1 or behind != "of"):
            bound = [tokens[at].saying(word) for word in ("at", "most" if most else "least")]
            return [*tokens[:n], *bound, *tokens[n:at], *tokens[at + long :]]
    return None


MORE = {"over": ("more", "than"), "under": ("fewer", "than")}


def over_so_many(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Over one of the four must be there": more than one; but "put the red one over one of the four"."""
    for at in (n for n in range(len(words) - 2) if words[n] in MORE and words[n + 2] == "of" and tokens[n + 1].many):
        if not at or words[at - 1] in _AHEAD or words[at - 1] in (*_STOPS, "not"):
            return [*tokens[:at], *map(tokens[at].saying, MORE[words[at]]), *tokens[at + 1 :]]
    return None


def none_of_so_many(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "No cube of the three red cubes": none of these."""
    for at in range(len(words) - 3):
        if words[at] == "no" and lexicon.BLOCK.get(words[at + 1]) is False and words[at + 2] in ("of", "among"):
            return [*tokens[:at], tokens[at].saying("none"), tokens[at + 2].saying("of"), *tokens[at + 3 :]]
    return None


MANY = ("exactly", "just", "precisely", "only")
_MANY = (*(((many,), 1) for many in MANY), (("at", "least"), 1), (("at", "most"), 1), (("no", "more", "than"), 1),
         (("no", "fewer", "than"), 1), (("not", "more", "than"), 1), (("not", "fewer", "than"), 1),
         (("all", "but"), 1), (("none",), 0), (("half",), 0), (("exactly", "half"), 0))  # fmt: skip
VERBS = frozenset({"is", "are", "should", "must", "may", "can", "shall", "has", "have", "go", "goes", "lie", "lies",
                   "belong", "belongs", "stand", "stands", "need", "needs", "end", "ends", "form"})  # fmt: skip
_OF = ("of", "among", "out")


def so_many_at(tokens: list[Token], words: list[str], at: int) -> int:
    """The position behind a number of things: "exactly two", "all but one", "none"."""
    found = [at + len(said) + more for said, more in _MANY if tuple(words[at : at + len(said)]) == said
             and (not more or (at + len(said) < len(words) and tokens[at + len(said)].many))]  # fmt: skip
    return max(found, default=0)


def of_so_many_ahead(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Of the three white blocks, all but one are on the mat": all but one of the three white blocks."""
    for at in (n for n, word in enumerate(words) if word in _OF and (n == 0 or words[n - 1] in _STOPS)):
        of = at + 1 + (words[at : at + 2] == ["out", "of"])
        comma = next((n for n in range(of, len(words)) if words[n] == "," or words[n] in _STOPS), len(words))
        if comma >= len(words) or words[comma] != ",":
            continue
        end = so_many_at(tokens, words, comma + 1)
        if end and end < len(words) and words[end] in VERBS:
            them = [tokens[at].saying("of"), *tokens[of:comma]]
            return [*tokens[:at], *tokens[comma + 1 : end], *them, *tokens[end:]]
    return None


_MUST_BE = (("must", "be"), ("should", "be"), ("is",), ("shall", "be"), ("has", "to", "be"))


def number_there(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The number of red cubes on the mat must be exactly two": exactly two of the red cubes must be there."""
    for at in range(len(words) - 6):
        if words[at : at + 3] != ["the", "number", "of"]:
            continue
        on = next((n for n in range(at + 3, len(words)) if words[n] in ("on", *_STOPS)), len(words))
        be = next((n for n in range(on, len(words)) if length_at(words, n, _MUST_BE)), 0) if on < len(words) else 0
        if not be or words[on] != "on" or not _STOPS.isdisjoint(words[on:be]):
            continue
        many = be + length_at(words, be, _MUST_BE)
        end = so_many_at(tokens, words, many) or (many + 1 if many < len(words) and tokens[many].many else 0)
        if not end or (end < len(words) and words[end] not in _STOPS | {","}):
            continue
        exactly = [] if so_many_at(tokens, words, many) else [tokens[many].saying("exactly")]
        the = [] if words[at + 3] == "the" else [tokens[at]]
        verb = [tokens[be].saying(word) for word in ("must", "be")]
        head = [*exactly, *tokens[many:end], tokens[at + 2], *the, *tokens[at + 3 : on]]
        return [*tokens[:at], *head, *verb, *tokens[on:be], *tokens[end:]]
    return None
