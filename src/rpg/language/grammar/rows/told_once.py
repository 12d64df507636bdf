"""Colors and nouns told once for all of a list: "the letters A, B and C in red", "A on a red and B on a blue mat", and
what is said of some only: "with only the vowels in red", "a mat for each"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, CUBE, MUST, PATCH

_SYMBOL = "(?:[a-z]|\\d)"
_KIND = f"(?:(?:letter|number|digit) {CUBE}|letter|vowel|consonant|digit|number|symbol|block|cube)s"
_LIST = f"{_SYMBOL}(?: , {_SYMBOL})*(?: ,)? and {_SYMBOL}"
_AND = "(?:, and|,|and)"
_ENDED = "(?= (?:in an? |on |onto |at |along |next |near |beside |behind |from |to |into |so that |such that )|$)"
_AT = "(?:on|onto|in|near|next to|beside|behind|in front of|to the (?:left|right) of)"
_SOME = "(?:(?:the )?(?:vowels|consonants)|(?:the )?(?:first|last|middle) letter|the [a-z](?: and the [a-z])?)"


def _each_its_own() -> Iterator[Turn]:
    """ "(The letters) A, B and C in red, blue and green": a color for each, in the order in which they are named."""
    for many in (3, 4):
        symbols, colors = (" , ".join([f"({one})"] * (many - 1)) for one in (_SYMBOL, COLOR))
        looks = [f"the {{{n + many + 1}}} {{{n + 1}}}" for n in range(many)]
        yield (
            f"(?<!\\w , )(?:\\bthe {_KIND} )?\\b{symbols}(?: ,)? and ({_SYMBOL}) in {colors}(?: ,)? and ({COLOR})"
            f"(?:(?: ,)? respectively)?{_ENDED}",
            f"{' , '.join(looks[:-1])} and {looks[-1]}",
        )


TOLD_ONCE: tuple[Turn, ...] = (
    *_each_its_own(),
    (f"\\bthe ({_KIND}) ({_LIST}) in ({COLOR}){_ENDED}", "the {3} {1} {2}"),
    (f"\\bthe (letter|digit|number) ({_SYMBOL}) in ({COLOR}){_ENDED}", "the {3} {1} {2}"),
    (f"\\bthe (?:letter|digit|number)s ({_SYMBOL} in {COLOR}(?:{AND} {_SYMBOL} in {COLOR})+){_ENDED}", "{1}"),
    (f"\\b({_AT}) (an?) ({COLOR}) ((?:{_AND} (?:(?!{_AT} )[^,.;: ]+ )+?{_AT} an? {COLOR} )+({PATCH}))\\b",
     "{1} {2} {3} {5} {4}"),
    # of the others nothing is said, and no letter has a color of its own
    (f"^((?:please )?(?:spell|write) [^,]+? with) (?:only|just) ({_SOME} (?:in )?{COLOR})$", "{1} {2}"),
    (f"^((?:please )?(?:spell|write) [^,]+? with) ({_SOME}) (?:only|alone) ((?:in )?{COLOR})$", "{1} {2} {3}"),
    (f"^((?:there (?:is|{MUST} be) )?an?) ((?:{COLOR} |round |square )*{PATCH} for (?:each|every) )(?!.* on )",
     "{1} separate {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
