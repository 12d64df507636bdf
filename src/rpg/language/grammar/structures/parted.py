"""What goes into which group, told of each kind: "odd numbers in one, even numbers in the other"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import OrderBy

_KINDS = {
    "vowel": "vowel", "vowels": "vowel", "consonant": "consonant", "consonants": "consonant", "odd": "odd",
    "even": "even", "odds": "odd", "evens": "even", "letters": "letter", "letter": "letter", "digits": "digit",
    "digit": "digit", "numbers": "digit", "number": "digit",
}  # fmt: skip
_OPPOSED = {
    frozenset({"vowel", "consonant"}): "vowel",
    frozenset({"odd", "even"}): "parity",
    frozenset({"letter", "digit"}): "kind",
}
_NOUNS = frozenset({"numbers", "digits", "ones", "letters", "cubes", "blocks"})
_HOMES = Patterns(
    "go|belong|are? all? together? in|into|on|to|in_the|into_the one|first|other|another|a_different|the_other|"
    "a_second|a_separate|second|the_one|the_first|the_second "
    "group|pile|heap|bunch|cluster|side|set|place?",
    "form|forms|make|makes|build|builds one|another|a|the_other|the_first|the_second group|pile|heap|bunch|cluster",
    "form|forms|make|makes|build|builds? another|the_other|a_second|another_one|the_other_one",
    "here|there",
)
_HEAPS = frozenset({"group", "pile", "heap", "bunch", "cluster"})
_OWN = Patterns(
    "each|every|same|the_same|one color|kind|letter|sort|type|colors together|be_together|goes|go|is|should_be|"
    "in? in|on|to its_own|one|a_separate|its_own_separate|a|a_single group|pile|heap|bunch|cluster|place of_its_own?",
)
_FORMS = Patterns(
    "each|every|the? color|colors|kind|kinds|letter|sort|type should|must|shall? form|forms|make|makes|get|gets|"
    "has|have|build|is|are|be its|their|a|one|the? own|separate|single? group|groups|pile|heap|bunch|cluster|piles "
    "of_its_own|for_itself|of_their_own|by_itself?",
)
_OWNED = {"color": "color", "colors": "color", "kind": "kind", "sort": "kind", "type": "kind", "letter": "label"}

_WITH = tuple(
    f"{go}{to}{the}"
    for go in ("", "are ", "is ", "go ", "goes ", "belong ", "belongs ", "should go ", "must go ", "stay ", "stays ")
    for to in ("with", "to")
    for the in ("", " the", " other", " the other")
)
_LOOKS = "color|colors|letter|letters|number|numbers|digit|digits|symbol|symbols"
_SAME = Patterns(
    f"same|equal|identical|the_same {_LOOKS} "
    f"goes|go|belongs|belong|should_go|must_go|is|are? with|to same|equal|identical|the_same {_LOOKS}",
)


def parted(p: Parser, i: int) -> Results[OrderBy]:
    """ "vowels in one group and consonants in the other", "every colour in its own group"."""
    j = p.opt(i, ",", ":")
    j = p.any_of(j, ("so that", "such that")) or p.opt(j, "with")
    for k in (*_OWN.matches(p, j), *(() if p.follows(j, ("that",)) else _FORMS.matches(p, j))):
        said = next((_OWNED[word] for word in p.words[j:k] if word in _OWNED), "color")
        yield OrderBy(by="parted", attribute=said, span=p.span(i, k)), k
    if k := max(_SAME.matches(p, j), default=0):
        yield OrderBy(by="parted", attribute=_OWNED.get(p.words[k - 1], "label"), span=p.span(i, k)), k
    yield from _colors(p, i, j, ())
    first, k = _one(p, j)
    for home in _homes(p, k, first) if first else ():
        second, m = _one(p, p.opt(p.opt(home, ","), "and"))
        attribute = _OPPOSED.get(frozenset({first, second})) if second else None
        for end in _homes(p, m, second) if attribute else ():
            yield OrderBy(by="parted", attribute=str(attribute), values=(first, second), span=p.span(i, end)), end


def _colors(p: Parser, i: int, j: int, had: tuple[str, ...]) -> Results[OrderBy]:
    """ "red with red, blue with blue": one group of each colour."""
    named = p.lex(j, lexicon.COLOR) or p.lex(j, lexicon.COLOR_PLURAL)
    again = p.any_of(j + 1, _WITH) if named else 0
    if not named or not again or named in had:
        return
    if (p.lex(again, lexicon.COLOR) or p.lex(again, lexicon.COLOR_PLURAL)) == named:
        if had:
            yield OrderBy(by="parted", attribute="color", span=p.span(i, again + 1)), again + 1
        yield from _colors(p, i, p.opt(p.opt(again + 1, ",", ";"), "and"), (*had, named))


def _homes(p: Parser, i: int, kind: str) -> Iterator[int]:
    """Positions after "in one group", "here", or after "with letters" behind the letters."""
    yield from (k for k in _HOMES.matches(p, i) if not p.stands(k, _HEAPS))
    again = p.any_of(i, _WITH)
    if again and _one(p, again)[0] == kind:
        yield _one(p, again)[1]


def _one(p: Parser, i: int) -> tuple[str, int]:
    """The kind that is named at i, and the position after it."""
    j = p.opt(p.opt(i, "all"), "the")
    kind = p.peek(j, _KINDS)
    return (kind, p.opt(p.reach(j + 1), *_NOUNS)) if kind is not None else ("", i)
