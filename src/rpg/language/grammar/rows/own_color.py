"""Patches and blocks of the same colors, and blocks that are on no patch of their own: "three patches, red, green and
blue, and a block of each of these colors", "put each block on a patch of a color other than its own"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import IS, PUT
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH, PATCHES

_BLOCK = "(?:block|cube|brick|box)"
_BLOCKS = "(?:blocks|cubes|bricks|boxes|block|cube|brick|box)"
_MATS = f"(?:{PATCHES}|{PATCH})"
_A = f"(?:an? |one |the )?({COLOR})(?: one)?"
_LISTS = (
    (f"{_A}(?: and| ,| , and) {_A}", "a {0} and a {1}"),
    (f"{_A} , {_A}(?: ,| and| , and) {_A}", "a {0} , a {1} and a {2}"),
    (f"{_A} , {_A} , {_A}(?: ,| and| , and) {_A}", "a {0} , a {1} , a {2} and a {3}"),
)
"""Colors that are told, and one thing of each."""
_SAME = f"(?:of|in|with) (?:each of )?(?:the same|these|those|the|matching|their)(?: {MANY})? colors?(?: each)?"
_THERE = "(?:there (?:is|are) |(?:we|i|you) have |given |with |on the table (?:is|are|lie) )?"
_AND = "(?: ,| and| , and| plus)"
_OTHER = ("(?:(?:of|in|with|that has) (?:(?:another|the wrong|some other) color(?: than its(?: own)?)?|an? (?:color )?"
          "(?:other|different)(?: color)? (?:than|from) its(?: own)?(?: color)?)|(?:that|which) (?:does not match(?: "
          "its(?: own)? color| it)?|is not (?:of |in )?its(?: own)? color|(?:has|is of) (?:another|a different) color "
          "(?:than|from) it(?:s own)?|does not have (?:its(?: own)?|the same) color(?: as it)?)|not of its(?: "
          "own)? color|(?:of|in|with) the (?:other|opposite) color)")  # fmt: skip
_OWN = ("(?:(?:of|in|with|that has|which has|having) (?:its(?: own)?|their own|the same) color|(?:that|which) "
        "(?:matches "
        "it|matches its(?: own)? color|is of its(?: own)? color))")  # fmt: skip
_NONE = "no block may be on the patch of its own color"
_HUE = f"(?:the |an? |one )?{COLOR}(?: {_BLOCK}| {PATCH}| one)?"
_HUES = f"{_HUE}(?:(?: ,| and| , and) {_HUE})+"
_TOLD = (
    f"(?:(?:(?:we|you|i) have|there (?:is|are)|(?:the )?(?:{MANY} )?(?:available "
    f")?(?:colors|{_BLOCKS}|{PATCHES})(?: used)? "
    f"(?:are|:)) {_HUES})"
)
_EACH_HAS = (
    f"(?:each|every) ({PATCH}) (?:{MUST} )?(?:gets?|has|have|holds?|carry|carries|receives?|bears?) (?:exactly )?"
    f"(?:one|an?|the) {_BLOCK} {_OWN}(?: on it)?"
)
_OVER_ALL = "each block must be on the {{{}}} of the same color"


def _stocks() -> tuple[Turn, ...]:
    """What there is, told of the ones by the colors of the others."""
    rows: list[Turn] = []
    for listed, each in _LISTS:
        for one, ones, others in (("patch", _MATS, _BLOCKS), ("block", _BLOCKS, _MATS)):
            other = "block" if one == "patch" else "patch"
            so_many = f"(?:an?|one|{MANY}) (?:{others})(?: each)? {_SAME}"
            for begun, ahead, nth in (("^", "", 0), ("^(.+) : ", "{1} . ", 1)):
                hues = [f"{{{n + nth + 1}}}" for n in range(each.count("{"))]
                lots = each.format(*hues)
                rest = f"{{{len(hues) + nth + 1}}}"
                for lot in (
                    f"(?:{MANY} )?{ones}(?: on the table)? (?:,|:|\\() {listed}(?: \\))?", f"{listed} {ones}"
                ):  # fmt: skip
                    told = f"{ahead}there are {lots} {one} and {lots} {other}"
                    rows += [
                        (f"{begun}{_THERE}{lot}{_AND} {so_many}$", told),
                        (f"{begun}{_THERE}{lot}{_AND} {so_many} , (?:but |and )?(.+)$", f"{told} . {rest}"),
                    ]  # fmt: skip
    return tuple(rows)


OWN_COLOR_ACROSS: tuple[Turn, ...] = (
    # one block of each color: what each patch has tells where each block is
    (f"^{_EACH_HAS} [.,:;] ({_TOLD}) ?\\.?$", f"{_OVER_ALL.format(1)} . {{2}} ."),
    (f"^({_TOLD}) [.,;] {_EACH_HAS} ?\\.?$", f"{_OVER_ALL.format(2)} . {{1}} ."),
    # what is there is told in two sentences
    (f"^([^.]*\\b(?:{_MATS}|{_BLOCKS})\\b[^.]*) \\. (?:and )?((?:the |an? )?(?:{MANY} )?(?:{_BLOCKS}|{_MATS}) {_SAME}) "
     "(?=[.,:])", "{1} and {2}"),
)  # fmt: skip
"""The same over a whole text."""
OWN_COLOR_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b((?:each|every) (?:of the )?(?:{MANY} )?{_BLOCKS}(?: {IS})?(?: of them)? (?:on|onto|to)) (?:the|an?) same "
     f"(?:- )?"
     f"colored ({PATCH})\\b", "{1} the {2} of the same color"),
    (f"^(?:{PUT} |(?:i|we) (?:want|would like) )?(?:all|each|every)(?: one)?(?: of)?(?: the)?(?: {MANY})? {_BLOCKS}(?: "
     f"{IS}|(?: to)? (?:be|go|lie|end up))? on (?:an?|some|any|one of the) (?:{PATCH}|{PATCHES})(?: ,)? (?:but|"
     f"and|though|"
     f"only) (?:none|not one|not|never|no {_BLOCK})(?: of (?:them|these|the blocks))?(?: {IS})?(?: on)? (?:the|an?)(?: "
     f"{PATCH}| one)? {_OWN}$", f"every block must be on a patch . {_NONE}"),
    (f"^{PUT} (?:exactly )?(?:one|an?) {_BLOCK} on (?:each|every) {PATCH}(?: ,)? (?:but|and) (?:none|not one)(?: of "
     f"them)? on (?:(?:the|an?) {PATCH} of )?its own color$", f"each patch gets exactly one block . {_NONE}"),
)  # fmt: skip
"""The same in every sentence."""
OWN_COLOR: tuple[Turn, ...] = (
    *_stocks(),
    (f"\\b(?:on|onto|to) the ({PATCH}) whose color (?:it (?:shares|has|matches)|matches(?: it| its(?: own)?(?: "
     f"color)?| "
     f"that of the {_BLOCK})?|is the same(?: as (?:its(?: own)?|that of the {_BLOCK}))?)(?= [,.:(]|$)",
     "on the {1} of the same color"),
    (f"^there are (?:{MANY} )?(?:different )?colors (?:,|:) ({_HUES})$", "the colors are {1}"),
    (f"^(?:the )?(?:{_BLOCKS} and(?: the)? {_MATS}|{_MATS} and(?: the)? {_BLOCKS}) (?:both )?(?:come|are|exist) "
     f"in(?: the "
     f"(?:same )?(?:{MANY} )?colors)? ({_HUES})$", "the colors are {1}"),
    (f"^(?:for (?:each|every) (?:color|of the (?:{MANY} )?colors)(?: ,|:) ({_HUES})(?: ,)? )there is (?:one|an?) "
     f"(?:{_BLOCK} "
     f"and (?:one|an?) {PATCH}|{PATCH} and (?:one|an?) {_BLOCK})$", "the colors are {1}"),
    (f"^(?:{PUT} )?(?:each|every)(?: one)?(?: of the)? {_BLOCKS}(?: {IS})? on (?:an?|some) {PATCH} {_OTHER}$",
     f"every block must be on a patch . {_NONE}"),
    # "the other" of two
    (f"(?:^|(?<=[:,] ))(?:and )?(?:{PUT} )?(?:each|every)(?: {_BLOCK}| one)?(?: {IS}| ends up| (?:{MUST} )?end up| "
     f"belongs)? (?:on|onto|to) the {PATCH} (?:of|in|with) the (?:other|opposite) color$",
     f"every block must be on a patch . {_NONE}"),
    (f"^(?:each|every) {PATCH} (?:(?:{MUST} )?(?:gets?|has|have|holds?|carry|carries|receives?|bears?)) (?:exactly )?"
     f"(?:one|an?|the) {_BLOCK} {_OTHER}(?: on it)?$", f"each patch gets exactly one block . {_NONE}"),
    (f"^(.*\\b{PATCH}.*?)(?: ,)? (?:but|and|so that|with) (?:no colors? (?:may |must |should )?match(?:es|ing)?|the "
     "colors (?:may|must|should) not match|no matching colors)$", f"{{1}} . {_NONE}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("matching match wrong matches",)
"""Words that these take besides those that are read anyway."""
