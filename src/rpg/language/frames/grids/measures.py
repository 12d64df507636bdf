"""The words for the sizes of grids, walls, pyramids and cubes of blocks."""

from __future__ import annotations

import re

from rpg.language.frames.pieces import Pattern, number, patterns

_DIMS = (
    r"(?:\d+x\d+(?:x\d+)?|\d+ (?:(?:BLOCK|squares|fields) )?(?:by|times|x) \d+(?: (?:BLOCK )?(?:by|times|x) \d+)?)"
    r"(?: (?:squares|fields))?"
)
_N = "(?:BLOCK )?"
_EACH = "(?:each|every|a|one|the)"
_HAS = (
    "(?:(?:has|with|of|contains|containing|having|consists|is|holding|holds|shall|should|must|have|consist|contain|"
    "there|are) )+"
)
_WITH = "(?:(?:of|by|having|containing|each of|each with|each having|each containing|that each have|which each have) )"
_NO_LINES = "(?! (?:rows?|columns?|files?|layers?|levels?|by|x) )"
_NO_LOOK = "(?! (?:rows?|columns?|files?|layers?|levels?|by|x|plain|SIZE|COLOR)s? )"


_NO_AXIS = "(?! (?:rows?|columns?|files?|layers?|levels?|by|x|COLOR)s? )"


def _size(match: re.Match[str]) -> dict[str, int]:
    return {name.strip("_"): number(said) for name, said in match.groupdict().items() if said}


def _dims(match: re.Match[str]) -> tuple[int, ...]:
    return tuple(int(n) for n in re.findall(r"\d+", match[0]))


def _lines_of(lines: str, name: str, of: str) -> str:
    """ "Two rows of three": lines, and how many blocks each of them has."""
    one = name[:-1]
    return (
        rf"(?P<{name}>NUM) (?:full |straight )?(?:{lines})s? (?:, (?=each ))?{_WITH}(?P<{of}>NUM){_NO_LINES}(?: BLOCK)?"
        rf"(?: (?:each|apiece|per {one}|in (?:each|every)(?: {one}| one)?))?|(?P<{name}_>NUM) (?:{lines})s? with "
        rf"(?P<{of}_>NUM)(?: BLOCK)? (?:each|apiece|per {one}|in (?:each|every)(?: {one}| one)?)"
    )


def _each_has(line: str, of: str, more: str) -> tuple[str, str]:
    """ "Three in each row", "each row has three"."""
    return (
        rf"(?:with |of |having |has )?(?P<{of}>NUM) {_N}(?:in|per|to|for) (?:{_EACH} )?(?:{line})",
        rf"(?:in )?(?:each|every) (?:{line}) (?:{_HAS})?(?P<{of}>NUM)(?: BLOCK)?(?: {more})?{_NO_AXIS}",
    )


_BASE = "(?:(?:square|bottom|lowest) )?(?:base|(?:base|bottom|lowest) (?:layer|level|tier|course))"
_BASE_ROW = "(?:base|bottom|lowest) (?:row|line)|baseline"
_OF = (
    "(?: (?:of|is|being|has|having|with|containing|consists|contains|:|measures|measuring|shall|should|must|be|"
    "consisting|a row of|a square of|square))*"
)
SIZES: list[Pattern] = [
    *patterns("dims", _dims, rf"(?:(?:on a|a|an|the|of|measuring|sized|size|dimensions|full|filled|solid|complete|"
        rf"big|large|small|little|neat|"
        rf"compact|tight|flat|single|one) )*{_DIMS}(?: (?:blocks|cubes|pieces))?(?: (?:per|in each|in every) "
        rf"(?:layer|level))?",
        rf"each (?:layer|level|one|of which|of them)(?: BE| has| having| with| of| a| measuring)* {_DIMS}(?: BLOCK)?"),
    *patterns("size", _size,
        r"(?P<rows>\d+) (?:full |complete |straight |parallel )?rows(?: deep)?", r"(?P<rows>[2-9]|1\d) row",
        r"(?P<columns>\d+) (?:full |complete |straight |parallel )?(?:columns|files)(?: wide)?",
        r"(?P<columns>[2-9]|1\d) column",
        r"(?P<layers>NUM) (?:full |complete |flat )?(?:layers?|levels?|tiers?|floors?|story|storey|stories|storeys|"
        r"courses?)"
        r"(?: high| tall)?",
        _lines_of("row", "rows", "columns"), _lines_of("column", "columns", "rows"),
        _lines_of("layer|level|tier", "layers", "layer"),
        *_each_has("row", "columns", "(?:wide|long)"), *_each_has("column", "rows", "(?:high|tall|deep)"),
        *_each_has("layer|level|tier", "layer", "(?:wide|long)"),
        rf"(?P<wide>NUM) {_N}(?:wide|across|long|in width|in length|from left to right|along)",
        r"(?:a |the |its |whose )?(?:width|length)(?: of (?:which|it|the wall))? (?:(?:of|is|:|being|shall|should|"
        r"must|be) )*(?P<wide>NUM)(?: BLOCK)?",
        rf"(?P<high>NUM) {_N}(?:high|tall|in height|up|upwards)",
        r"(?:a |the |its |whose )?height(?: of (?:which|it|the wall))? (?:(?:of|is|:|being|shall|should|must|be) "
        r")*(?P<high>NUM)(?: BLOCK)?",
        rf"(?P<deep>NUM) {_N}(?:deep|in depth|from front to back|from back to front)",
        r"(?:a |the |its )?depth (?:(?:of|is|:|being) )*(?P<deep>NUM)(?: BLOCK)?",
        rf"(?:with )?(?P<side>NUM) {_N}(?:on|along|to|per|at|in) (?:(?:each|every|a|one|its) )?(?:side|edge)",
        r"(?:with )?(?:an? )?(?:side|sides|edge|edges)(?:(?: lengths?)? (?:of|being|is|:)| lengths?) (?P<side>NUM)"
        "(?: BLOCK)?",
        rf"(?:its |whose |the )?{_BASE}{_OF} (?P<base>NUM){_NO_LOOK}(?: BLOCK)?",
        rf"(?:its |whose |the )?(?:{_BASE_ROW}){_OF} (?P<line>NUM){_NO_LOOK}(?: BLOCK)?",
        rf"(?:its |whose |the )?{_BASE}{_OF} (?P<line>NUM)(?: BLOCK)? (?:wide|long|across|in (?:a|one) (?:row|line))",
        rf"(?P<base>NUM) {_N}base", rf"(?P<line>NUM) {_N}wide base",
        "(?:starts?|starting|begins?|beginning) (?:with|from) (?P<base>NUM)(?: BLOCK)?(?: (?:at|in|on) the "
        "(?:bottom|base))?",
        rf"(?P<line>NUM) {_N}(?:wide|long|across) (?:at|in|on) the (?:base|bottom)"),
    *patterns("base", _dims, rf"(?:(?:its|whose|the|a|with|on) )*(?:square )?{_BASE}{_OF}(?: a| by)* {_DIMS}(?: BLOCK)?"
        "(?: square)?",
        rf"(?:(?:its|the|a|with|on|of) )*{_DIMS}(?: BLOCK)? (?:square )?(?:base|based|footprint)(?: layer)?"),
    *patterns("square", None, "(?:(?:on|with|having) )?(?:a )?square (?:base|ground plan|footprint)", "(?:whose |its "
        "|the )base is (?:a )?square",
        "(?:arranged |placed |laid )?in a square(?= (?:at|on|in|as) the (?:bottom|base) )"),
    *patterns("taper", None,
        "(?:with )?(?:always )?(?:one|a BLOCK) (?:BLOCK )?(?:fewer|less) (?:(?:in|on|for|with|at) )?(?:each|every)"
        "(?: next| higher)? (?:layer|row|level|step)(?: (?:above|up|going up|higher))?(?: it| that)?",
        "(?:each|every)(?: next| higher)? (?:layer|row|level)(?: above)?(?: it)?(?: (?:has|is|having|being))? "
        "(?:one|1) (?:BLOCK )?(?:fewer|less|smaller|shorter|narrower)(?: than the (?:one|layer|row) (?:below|under|"
        "beneath)(?: it)?)?",
        "(?:(?:which|that) )?(?:gets?|getting|becomes?|becoming|is|being) (?:(?:one|a) BLOCK |by one )?(?:narrower|"
        "shorter|smaller) (?:with|in|at|by) (?:each|every)(?: next| higher)? (?:layer|row|level|step)(?: (?:above|up|"
        "upwards))?"),
    *patterns("glue", None, r"(?:by|x|times)(?= \d+ (?:rows|columns|files|layers|levels) )"),
    *patterns("apiece", None, "each", "apiece", "(?:in|per|for) (?:each|every|a)? ?(?:row|column|layer)"),
]  # fmt: skip
"""Kinds "dims" and "base" (numbers), "size" (numbers by name), "square" (base), "taper", "apiece"."""
