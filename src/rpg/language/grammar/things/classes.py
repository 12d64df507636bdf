"""Classes that tell blocks apart: "into the odd ones and the even ones", "letters, digits and plain cubes"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.meaning import Meaning, OrderBy

_CLASSES = {
    "odd": ("parity", "odd"), "odds": ("parity", "odd"), "even": ("parity", "even"), "evens": ("parity", "even"),
    "vowel": ("vowel", "vowel"), "vowels": ("vowel", "vowel"), "consonant": ("vowel", "consonant"),
    "consonants": ("vowel", "consonant"), "letter": ("kind", "letter"), "letters": ("kind", "letter"),
    "number": ("kind", "digit"), "numbers": ("kind", "digit"), "digit": ("kind", "digit"), "digits": ("kind", "digit"),
    "plain": ("kind", "plain"),
}  # fmt: skip
"""What a word says of a block: of which attribute, and its value."""
_HEADS = (
    "ones", "numbers", "digits", "letters", "blocks", "cubes", "group", "pile", "heap", "bunch", "number cubes",
    "number blocks", "letter blocks", "letter cubes", "colored blocks", "colored cubes", "colored ones", "bricks",
)  # fmt: skip
_LEADS = ("into", "in", "as", "by")
_OF = tuple(
    f"{det} {heap} {of}"
    for det in ("a", "one", "another", "the")
    for heap in ("group", "pile", "heap", "bunch", "cluster")
    for of in ("of all the", "of all", "of the", "of", "with the", "with")
)


@rule
def classes(p: Parser, i: int) -> Results[Meaning]:
    """Both classes, or all three kinds, after "into" or behind a comma or a colon."""
    j = p.any_of(i, _LEADS) or p.opt(i, ",", ":")
    for (attribute, one), k in _class(p, j) if j > i else ():
        for (other, two), end in _class(p, p.one(k, ",")) if p.one(k, ",") else ():
            joint = p.one(p.opt(end, ","), "and")
            for (third, three), last in _class(p, joint) if joint else ():
                if attribute == other == third and len({one, two, three}) == 3:
                    named = (one, two, three)
                    yield OrderBy(by="attribute", attribute=attribute, values=named, span=p.span(i, last)), last
        joint = p.one(p.opt(k, ","), "and")
        for (other, two), end in _class(p, joint) if joint else ():
            if attribute == other and one != two:
                yield OrderBy(by="attribute", attribute=attribute, values=(one, two), span=p.span(i, end)), end


def _class(p: Parser, i: int) -> Results[tuple[str, str]]:
    """ "the odd ones", "all vowels", "a group of letters", "an odd pile"."""
    of = p.any_of(i, _OF)
    j = of or p.any_of(i, ("all the", "all", "the", "an", "a")) or i
    found = p.lex(j, _CLASSES)
    if found is None:
        return
    k = p.any_of(j + 1, _HEADS)
    plural = p.words[j].endswith("s") or k > 0 or p.words[j] in ("odd", "even")
    plural = plural and (k > 0 or p.words[j] != "plain")
    if plural:
        yield found, k or j + 1
