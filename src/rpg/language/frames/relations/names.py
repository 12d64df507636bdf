"""The words for what statements are about: blocks and lots of a look, letters, patches, some of a lot, pronouns."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, number, patterns

_NOUN = "blocks?|cubes?|bricks?|box(?:es)?|pieces?|ones?"
_ONE = "block|cube|brick|box|piece|one"
_PATCH = "patch|mat|zone|pad|spot|target|goal|area|rug|carpet|coaster|marker|field|sheet"
_PLAIN_PATCH = "patch|mat|zone|pad|rug|carpet|coaster|target patch|target zone|goal patch|goal zone|target"
_DET = "the|this|these|those|that|my|our|your|a|an|both|both the|all|all the|all of the|both of the|another"
_THE = "the|this|that|a|an|my|our|your|one"
_HOW_MANY = "exactly|precisely|at least|at most|no more than|not more than|no fewer than|no less than|not fewer than"
_BUT = (
    "(?:all|every one|everyone)(?: of them)?(?: ,)? (?:but|except|except for|save|apart from|bar) (?:for )?(?P<but>NUM)"
)
_PART = rf"(?:(?:(?P<how>{_HOW_MANY}) )?(?P<part>NUM)(?: (?:block|cube|piece)s?)?|(?:exactly )?(?P<half>half)|{_BUT})"
_OF = rf"{_PART} (?:out )?of"
_SHAPED = "(?:(?P<size>SIZE|long) )?(?:(?P<shape>round|square|circular) )?"
THINGS: list[Pattern] = [
    *patterns("thing", "block",
        rf"(?:(?P<only>only) )?(?:(?P<det>{_DET}) )?(?:(?P<count>NUM) )?(?:(?P<size>SIZE) )?(?P<color>COLOR)"
        rf"(?P<many>s)?(?: colored)?(?: (?P<noun>{_NOUN}))?",
        r"(?:(?P<det>the|a|an) )?(?P<noun>block|cube) (?:(?:that|which) is |of (?:the )?color )?(?P<color>COLOR)"
        r"(?= (?!block|cube|one|patch|mat|zone))",
        rf"(?:(?P<det>the|a|an) )?(?P<color>COLOR) (?P<noun>{_ONE}) (?:which|that) is (?P<size>SIZE)(?= [,.])"),
    *patterns("thing", "block",
        rf"(?P<color>COLOR)(?P<many>s)? (?P<noun>{_NOUN}) (?P<count>NUM)(?: pieces?)?"
        "(?= (?:on|onto|in|must|should|is|are|go|next) )"),
    *patterns("thing", "block",
        rf"(?P<count>NUM) (?P<noun>{_NOUN}) (?:of (?:the )?color |colored |in )?(?P<color>COLOR)"
        rf"(?= (?!blocks?|cubes?|{_PATCH}|(?:, |and )*COLOR))"),
    *patterns("except", None,
        "(?:, )?(?:but|except|except for|save|apart from|with the exception of)(?: for)? (?P<but>NUM)(?: of them)?"
        "(?= (?:[.,;!?]|$))"),
    *patterns("thing", "letter",
        r"(?:(?P<det>the|a|an) )?(?:letters?|block|cube|letter block|letter cube) (?P<letter>[A-Z])"
        r"(?: (?P<noun>block|cube))?",
        r"(?:(?P<det>the|a|an) )?(?P<letter>[A-HJ-Z])(?: (?P<noun>block|cube))?",
        r"(?P<letter>a)(?= (?:is|must|should|goes|stands|sits|lies|on|onto|next|left|right|behind|in|touches|under) )",
        r"(?P<det>the) (?P<letter>I)(?: (?P<noun>block|cube))?",
        r"(?P<det>the|a) (?:block|cube) (?:with|labeled|labelled|marked|showing|bearing) (?:the |an? )?(?:letter )?"
        r"(?P<letter>[A-Z])(?: on it)?"),
    *patterns("thing", "number",
        r"(?:(?P<det>the|a|an) )?(?:number|digit|cube|block|number block|number cube) (?P<number>\d)(?! \d| cm| of)",
        r"(?P<det>the) (?P<number>\d) (?:block|cube)"),
    *patterns("thing", "patch",
        rf"(?:(?P<det>{_THE}) )?{_SHAPED}(?P<color>COLOR)(?: colored)?(?: (?P<behind>round|square|circle|circular))?"
        rf" (?P<noun>{_PATCH})(?: of (?P<form>circle|circular|round|square) (?:shape|form))?",
        rf"(?P<det>{_THE}) {_SHAPED}(?P<noun>{_PLAIN_PATCH})", "(?P<noun>patch|mat|zone)",
        rf"(?:(?P<det>{_THE}) )?(?P<noun>{_PATCH}) (?:in )?(?P<color>COLOR)(?= (?:[.,;]|and|$))"),
    *patterns("part", None,
        rf"{_OF} (?:(?:the|these|those|my|our|all) )*(?P<count>NUM) (?P<color>COLOR)s?(?: (?:{_NOUN}))?",
        rf"{_OF} (?:the|these|those|my|our) (?P<color>COLOR)s?(?: (?:{_NOUN}))?",
        rf"{_OF} (?:them|these|those|the 2|the (?:blocks|cubes))", f"{_BUT}(?: (?:block|cube|one)s?)?(?! of )",
        rf"all (?:the |my |of the )?(?P<count>NUM) (?P<color>COLOR) (?:{_NOUN}) (?:but|except|save) (?P<but>NUM)",
        rf"(?:(?P<how>{_HOW_MANY}) )?(?P<part>NUM) (?P<color>COLOR) (?:{_NOUN}) (?:out )?of (?:the )?(?P<count>NUM)"),
    *patterns("rest", None,
        rf"(?:the |all the |all )?(?:other|remaining|others) (?:(?P<count>NUM) )?(?:(?P<color>COLOR) )?(?:{_NOUN})",
        r"(?:the |all the |all )?(?:other|remaining) (?P<count>NUM)", "(?:the )?other (?P<color>COLOR)",
        rf"(?:the |all the |all )(?:others|rest|remainder)(?: of them| of the (?P<color>COLOR) (?:{_NOUN}))?",
        rf"the (?P<nth>third|fourth|fifth|sixth|last)(?: (?P<color>COLOR))?(?: (?:{_ONE}))?", "the other"),
    *patterns("total", lambda match: number(match["count"]),
        r"(?:the )?(?P<count>[2-9]) (?:blocks|cubes|bricks|boxes|letters|things|objects)(?: colored| in)?"),
    *patterns("one", None,
        "one(?= (?:on|onto|in|to|next|left|right|behind|beside|under|near|must|should|goes|touches|touching|is|at) )"),
    *patterns("neither", None, "neither(?: of (?:them|the 2|these))?"),
    *patterns("it", "any", "it|that one|this one"),
    *patterns("it", "block", "(?:the|that|this) (?:block|cube)"),
    *patterns("it", "former", "the former(?: one| block| cube)?"),
    *patterns("it", "latter", "the latter(?: one| block| cube)?"),
    *patterns("they", None,
        "they|them|both|both of them|the 2|the 2 of them|these 2|both (?:blocks|cubes)|the 2 (?:blocks|cubes)",
        "the (?:blocks|cubes)", "all (?:of )?(?:the )?(?P<all>[3-9])(?: of them| (?:blocks|cubes))?"),
]  # fmt: skip
"""Kinds of what statements are about."""
