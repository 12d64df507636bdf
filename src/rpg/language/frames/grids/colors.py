"""The words for the colours and symbols of whole lines of a grid, wall, pyramid or cube, and for their order."""

from __future__ import annotations

import re

from rpg.language.frames.grids.words import AXES, axis_of
from rpg.language.frames.pieces import Pattern, patterns

_HAVE = (
    "(?:(?:is|are|be|being|has|have|having|of|in|with|shows|gets|get|shall|should|must|made|has to|have to|only|just|"
    "exactly|its|their|all|entirely|be) )*"
)
_ONE_COLOR = (
    "(?:a |an |the )?(?:own|one|single|uniform|different|distinct|1)(?: and the same| single| plain|,| and)* "
    "colors?(?: only)?"
)
_READ = "(?:(?:going|reading|listed|counted|told) )?(?:from )?(?:the )?"
_BEGIN = "(?:starting|beginning)"


def _between(one: str, other: str) -> str:
    """ "From the front row to the back"."""
    ends = "(?: (?:layer|row|side|end|one|column))?"
    return f"{_READ}(?:{one}){ends} to (?:the )?(?:{other}){ends}"


_FAR, _NEAR = "far|back|rear|farthest|furthest", "near|front|nearest|closest"
_ENDS = "(?: (?:row|side|end|one|layer|column))?"


def _span(match: re.Match[str]) -> list[str]:
    """All labels from one to another."""
    return [chr(code) for code in range(ord(match["first"].replace("one", "1")), ord(match["last"]) + 1)]


def _listed(match: re.Match[str]) -> list[str]:
    return re.findall(r"\b(?:[A-Z]|\d)(?= )", f"{match[0]} ".replace("one ", "1 "))


_SYMBOLS = "(?:letters?|digits?|numbers?|numerals|symbols|(?:letter|digit|number|alphabet) (?:blocks|cubes))"
_NEXT = "(?: (?:(?:, |and |, and |then |, then )*)"
COLORS: list[Pattern] = [
    *patterns("each", axis_of,
        rf"(?:each|every)(?: one)?(?: of the)?(?: \d)? (?:single )?{AXES}s? {_HAVE}{_ONE_COLOR}",
        f"(?:(?:in|with|of|just|only|exactly) )*(?:one|a|a single|a different|its own) colors? (?:per|for each|"
        f"for every|to each|to every|in each|in every|to a|each) {AXES}",
        f"(?:all |the |whose )?{AXES}s {_HAVE}each {_HAVE}(?:an? )?(?:single|one|different|own) colors?",
        f"(?:all |the |whose )?{AXES}s {_HAVE}(?:an? )?(?:single|one) color each",
        f"(?:all |the |whose )?{AXES}s {_HAVE}(?:different|own) colors?",
        f"(?:a )?different colors? (?:per|for each|for every|in each|in every) {AXES}",
        f"(?:each|every) {AXES} (?:is |being )?(?:colored )?(?:differently|uniformly|unicolored)(?: colored)?"),
    *patterns("every", axis_of, f"(?:each|every) (?:single )?{AXES}(?= of (?:the|this|it))"),
    *patterns("one color", None, f"{_HAVE}{_ONE_COLOR}"),
    *patterns("each", None, f"each(?: of (?:them|which))? {_HAVE}{_ONE_COLOR}"),
    *patterns("glue", None, "(?:the )?colors (?:being|are|:)", "(?:all|each|each one)(?: of)?(?: in)? (?:a )?different"
        "(?: colors?)?(?= [,.;:])"),
    *patterns("any line", axis_of, f"(?:one|another) {AXES}(?: (?:BE|has|of|in|all|with|only|made|entirely))*"),
    *patterns("free order", None, "(?:in )?(?:any|whatever|some) order(?: you like)?", "(?:it )?does not matter which"),
    *patterns("lines", axis_of, f"(?:the |with )?{AXES}s? colors?(?: BE)?",
        f"(?:the )?colors of (?:the |its )?{AXES}s(?: BE)?"),
    *patterns("lines", axis_of, f"(?:the |its |whose |with the |their |these )?{AXES}s(?: (?:being|colored|BE))?(?! "
        f"of )"),
    *patterns("begins", lambda match: (match["color"], match.groupdict().get("side")),
        "(?:(?:and|always) )?(?:starting|start|starts|beginning|begin|begins) (?:with|from) (?:a |the "
        ")?(?P<color>COLOR)(?: (?:one|BLOCK))?"
        "(?: (?:row|column|layer))?(?: (?:at|on|in) (?:the )?(?P<side>bottom|top|left|right|front|back)(?: row| "
        "layer| column)?)?"),
    *patterns("lines", axis_of, f"by {AXES}s?", f"(?:in |with |of )alternating {AXES}s(?: of)?"),
    *patterns("alternating", None, "(?:colored )?(?:alternately|alternate|alternates|alternating|in alternation|"
        "by turns|taking turns)(?: (?:between|in color|colors|from))?"),
    *patterns("direction", ("column", "left"), _between("left", "right"), f"{_BEGIN} (?:on|at|from|with) the left",
        "from the left"),
    *patterns("direction", ("column", "right"), _between("right", "left"), f"{_BEGIN} (?:on|at|from|with) the right",
        "from the right"),
    *patterns("direction", ("row", "far"), _between(_FAR, _NEAR), f"{_BEGIN} (?:at|from|with|in) the (?:{_FAR}){_ENDS}",
        "from the (?:back|far end|far side)"),
    *patterns("direction", ("row", "near"), _between(_NEAR, _FAR),
        f"{_BEGIN} (?:at|from|with|in) the (?:{_NEAR}){_ENDS}", "from the (?:front|near end|near side)"),
    *patterns("direction", ("layer", "bottom"), _between("bottom|lowest", "top|highest"),
        "(?:from )?(?:the )?(?:bottom|ground) up(?:wards)?", f"{_BEGIN} (?:at|from|with) the (?:bottom|base|lowest)"
        f"{_ENDS}", "from the bottom", "from below", "going up(?:wards)?", "upwards"),
    *patterns("direction", ("layer", "top"), _between("top|highest", "bottom|lowest"),
        "(?:from )?(?:the )?top down(?:wards)?", f"{_BEGIN} (?:at|from|with) the (?:top|highest){_ENDS}",
        "from the top", "from above", "going down(?:wards)?", "downwards"),
    *patterns("labels", _span,
        rf"(?:the |of )?(?:{_SYMBOLS}|blocks|cubes) (?:from )?(?P<first>[A-Z]|\d) (?:to|through|until|up to|till) "
        r"(?P<last>[A-Z]|\d)",
        "(?P<first>[A-Z]) (?:to|through|until|up to) (?P<last>[A-Z])",
        r"(?:numbers |digits |the )*(?P<first>\d|one) (?:to|through|until|up to) (?P<last>\d)(?! (?:BLOCK|rows?|"
        r"columns?|layers?))"),
    *patterns("labels", _listed,
        rf"(?:the |of )?(?:{_SYMBOLS}|blocks|cubes) (?:[A-Z]|\d){_NEXT}(?:[A-Z]|\d)(?! (?:by|x|rows?|columns?|"
        rf"layers?)))+",
        rf"(?:the )?[A-Z]{_NEXT}[A-Z])+"),
    *patterns("labels", lambda match: [match["label"]], "(?:the )?(?:letter |block |cube )?(?P<label>[A-Z])(?: "
        "BLOCK)?"),
    *patterns("labels", lambda match: list(match["word"]), "(?:the word )?'(?P<word>[A-Z]{2,5})'"),
    *patterns("digits", _listed, rf"\d{_NEXT}(?:\d|one)(?! (?:by|x|BLOCK|ones|COLOR)))+(?! (?:by|x|rows?|columns?|"
        r"layers?|COLOR))"),
    *patterns("symbols", None, f"(?:of |the |with )?{_SYMBOLS}"),
    *patterns("reading", "verb", "(?:(?:which|that|it|they) )?(?:says?|spells?|reads?|reading)"),
    *patterns("lines", "layer", "(?:in |as |with |of )?(?:horizontal )?stripes"),
    *patterns("reading", "told",
        "(?:(?:so|such) that )?(?:(?:it|they) )?(?:can be |may be )?(?:reads?|reading|read) (?:from )?left to "
        "right(?: ,| and| then)* (?:from )?top to bottom",
        "(?:from )?left to right(?: ,| and| then)* (?:from )?top to bottom",
        "(?:(?:arranged|told|ordered|going|sorted|all) )?(?:in |by )?(?:the )?(?:usual |normal |their )?reading order",
        "(?:read )?row by row", "(?:read|reads|reading|laid out|to be read|that reads|which reads) (?:like|as|in) "
        "(?:a |the )?(?:page|book|text)(?: of a book| of text)?", "(?:line by line)",
        "(?:like|as) (?:on |in )?(?:a|the) (?:page|book|text)(?: of a book| of text)?",
        "(?:so that |so )?(?:(?:we|you|i|one|they) )?(?:can )?(?:be )?read (?:(?:them|it) )?(?:in|like)(?: a page| a "
        "book| order)"),
    *patterns("reading", "ordered",
        "(?:(?:read|reads|reading|sorted|go|run) )?(?:in )?(?:alphabetical|numerical|numeric|ascending|increasing|"
        "counting|natural|rising)(?: numerical)? order", "(?:both |all |each )?in order", "alphabetically|"
        "alphabetical|numerically"),
    *(pattern for side, words in (("told", _FAR), ("near", _NEAR)) for pattern in patterns("reading", side,
        f"(?:with |starting with |beginning with )?(?:the )?(?:{words}) row (?:(?:comes|goes|being|is) )?first",
        f"(?:starting|beginning) (?:with|in|at) the (?:{words}) row")),
]  # fmt: skip
"""Kinds "each", "lines" (an axis), "direction", "alternating"; "labels" and "digits" (symbols), "symbols" (some are
meant), "reading" (in which order)."""
