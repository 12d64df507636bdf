"""The words for grids, walls, pyramids and cubes of blocks, and for their parts."""

from __future__ import annotations

import re
from typing import NamedTuple

from rpg.language.frames.pieces import Pattern, patterns


class Place(NamedTuple):
    """Where blocks are. `kind`: "line" (`axis` where it is told), "cells", or "rest"; `many`: how many lines or blocks
    are meant, 0 where that is not told."""

    kind: str
    side: str
    axis: str | None = None
    many: int = 0


_SIDES = {
    "far": "far|farther|farthest|further|furthest|back|backmost|rear|rearmost|hind|hindmost",
    "near": "near|nearer|nearest|front|frontmost|foremost|closest|closer",
    "left": "left|left hand|leftmost",
    "right": "right|right hand|rightmost",
    "top": "top|topmost|upper|uppermost|higher|highest|tip|peak|apex|summit",
    "bottom": "bottom|bottommost|lower|lowermost|lowest|undermost|base|ground|foundation",
    "middle": "middle|center|central|intermediate",
    "other": "other|remaining",
    "outer": "outer|outside|outermost",
    "1": "first|1st", "2": "second|2nd", "3": "third|3rd", "4": "fourth|4th", "5": "fifth|5th", "6": "sixth|6th",
    "last": "last",
}  # fmt: skip
_SIDE_OF = {word: side for side, words in _SIDES.items() for word in words.split("|")}
_AXIS_OF = {"row": "row", "column": "column", "file": "column"}
"""Axes by their words; all the others are layers."""


def _side(*sides: str) -> str:
    """A group for the words of some sides, of all of them where none is named."""
    words = [word for word, side in _SIDE_OF.items() if side in sides or not sides]
    return f"(?P<side>{'|'.join(sorted(words, key=len, reverse=True))})"


def _line(match: re.Match[str]) -> Place:
    named = match.groupdict()
    axis, number, many = named.get("axis"), named.get("number"), named.get("many")
    side = _number(number) if number else _SIDE_OF[named["side"]]
    return Place("line", str(side), _AXIS_OF.get(axis, "layer") if axis else None, int(many or 1))


def _number(said: str) -> int:
    return int(said) if said.isdigit() else 1


def _size(match: re.Match[str]) -> dict[str, int]:
    return {name: _number(said) for name, said in match.groupdict().items() if said and name != "taken"}


def _dims(match: re.Match[str]) -> tuple[int, ...]:
    return tuple(int(n) for n in re.findall(r"\d+", match[0]))


def _axis(match: re.Match[str]) -> str:
    return _AXIS_OF.get(match["axis"], "layer")


def _corner(match: re.Match[str]) -> Place:
    return Place("cells", f"{_SIDE_OF[match['a']]} {_SIDE_OF[match['b']]}")


def _rest(match: re.Match[str]) -> Place:
    return Place("rest", "", None, int(match.groupdict().get("many") or 0))


_FIGURES = "grid|array|matrix|wall|pyramid|cube|square|rectangle|figure|checkerboard|chessboard|board"
_THE = "(?:the |its |their |your |my )?(?:very )?"
_IN = "(?:all )?(?:in |at |to |along |for )?"
_LEVELS = "(?P<axis>layer|level|tier|floor|storey|story)"
_PLAIN = ("far", "near", "left", "right", "top", "bottom", "middle")
_AXES = "(?P<axis>row|column|file|layer|level|tier|floor|storey|story)"
_OF = f"(?: of (?:it|them|the (?:{_FIGURES})))?"
_FROM = "(?: away)?(?: (?:from|to) (?:me|us|you|the (?:viewer|camera|robot)))?"
_DIMS = r"(?:\d+x\d+(?:x\d+)?|\d+ (?:BLOCK )?(?:by|times) \d+(?: (?:BLOCK )?(?:by|times) \d+)?)"
_KINDS = "(?:(?:small|little|tiny|simple|plain|nice|neat|proper|regular|complete|full|filled|solid|flat|low|short|thick|standing|upright|brick|mini|decent) )*"
FIGURES: list[Pattern] = [
    *patterns("figure", "grid", f"{_KINDS}(?:(?:rectangular|square) )?(?:grid|array|matrix|lattice)(?: (?:pattern|formation|arrangement))?"),
    *patterns("figure", "rectangle", "(?:(?:small|flat|little) )*(?:filled|filled in|solid|full|complete)(?: flat)? rectangle"),
    *patterns("figure", "square", f"{_KINDS}square"),
    *patterns("figure", "wall", f"{_KINDS}(?:long |tall |high |big )?wall"),
    *patterns("figure", "pyramid", f"{_KINDS}(?:big )?(?:step |stepped |layered )?(?:square |square based |flat |two dimensional |triangular )?pyramid"),
    *patterns("figure", "cube", f"{_KINDS}(?:big|large|huge|giant|bigger|larger|solid|compact)(?: solid)? (?:cube|block|cuboid|box)", "cuboid",
        "(?:cube|block)(?= (?:of|from|out of|made|consisting|built) )"),
    *patterns("figure", "board", f"{_KINDS}(?:checkerboard|chessboard|(?:chess|checker|checkers|draughts) board)(?: pattern| grid)?"),
    *patterns("checkered", None,
        "(?:in |with |like |as |has |showing |to form )*(?:a |the )?(?:checkerboard|chessboard|checkered|chequered|checker|chess|chess board)(?: like)? (?:pattern|fashion|style|way|arrangement|order|manner|coloring)",
        "(?:(?:in )?(?:alternating|alternate|alternately|taking turns|(?:with |in |the |their |of )*(?:alternating colors|colors alternate|colors alternating)) )?(?:like|as) (?:on |in )?(?:a |the )?(?:small |real )?(?:checkerboard|chessboard|chess board)",
        "(?:checkered|chequered)"),
]  # fmt: skip
_COLOR_EACH = (
    "(?:(?:is|are|be|being|has|have|having|of|in|with|shows|gets|get|shall|should|must|made|has to|only|just|exactly) )*"
    "(?:a |an |the )?(?:(?:own|one|single|uniform|same|different|distinct|1)(?: and the same| single| plain)?) colors?(?: only)?"
)
COLORS: list[Pattern] = [
    *patterns("each", _axis,
        f"(?:each|every|any)(?: one)?(?: of the)? (?:single )?{_AXES}s?(?: is)?(?: of)?(?: (?:which|that))? (?:in |of |has |have |having |with |is |gets |shows |should have |must have |shall have |must be |shall be |should be )*(?:its |their )?{_COLOR_EACH}",
        f"(?:(?:in|with|of|just|only|exactly) )*(?:one|a|a single|a different|its own) colors? (?:per|for each|for every|to each|to every|in each|in every|to a|each) {_AXES}",
        f"(?:all |the |whose )?{_AXES}s (?:(?:are|have|being|having|of|in|with) )*(?:each )?(?:(?:of|in|a|an) )*(?:single|one|different|own) colors?(?: each)?",
        f"(?:a )?different colors? (?:per|for each|for every|in each|in every) {_AXES}",
        f"(?:each|every) {_AXES} (?:is |being )?(?:colored )?(?:differently|uniformly)(?: colored)?"),
    *patterns("lines", _axis, f"(?:the |its |whose |with the |their |these )?{_AXES}s(?: (?:being|colored|BE))?"),
    *patterns("direction", ("column", "left"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?left(?: side)? to (?:the )?right", "(?:starting|beginning) (?:on|at|from|with) the left", "from the left"),
    *patterns("direction", ("column", "right"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?right(?: side)? to (?:the )?left", "(?:starting|beginning) (?:on|at|from|with) the right", "from the right"),
    *patterns("direction", ("row", "far"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?(?:far|back|rear|farthest|furthest)(?: (?:row|side|end))? to (?:the )?(?:near|front|nearest|closest)(?: (?:row|side|end))?",
        "(?:starting|beginning) (?:at|from|with|in) the (?:back|far|farthest|furthest)(?: (?:row|side|end|one))?", "from the (?:back|far end|far side)"),
    *patterns("direction", ("row", "near"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?(?:near|front|nearest|closest)(?: (?:row|side|end))? to (?:the )?(?:far|back|rear|farthest|furthest)(?: (?:row|side|end))?",
        "(?:starting|beginning) (?:at|from|with|in) the (?:front|near|nearest|closest)(?: (?:row|side|end|one))?", "from the (?:front|near end|near side)"),
    *patterns("direction", ("layer", "bottom"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?(?:bottom|lowest)(?: (?:layer|row|one))? to (?:the )?(?:top|highest)(?: (?:layer|row|one))?", "(?:from )?(?:the )?(?:bottom|ground) up(?:wards)?",
        "(?:starting|beginning) (?:at|from|with) the (?:bottom|base|lowest)(?: (?:layer|row|one))?", "from the bottom", "from below", "going up(?:wards)?", "upwards"),
    *patterns("direction", ("layer", "top"), "(?:going |reading |listed |counted )?(?:from )?(?:the )?(?:top|highest)(?: (?:layer|row|one))? to (?:the )?(?:bottom|lowest)(?: (?:layer|row|one))?", "(?:from )?(?:the )?top down(?:wards)?",
        "(?:starting|beginning) (?:at|from|with) the (?:top|highest)(?: (?:layer|row|one))?", "from the top", "from above", "going down(?:wards)?", "downwards"),
    *patterns("labels", lambda match: _span(match["first"], match["last"]),
        r"(?:the |of )?(?:letters?|letter (?:blocks|cubes)|digits?|digit (?:blocks|cubes)|numbers?|number (?:blocks|cubes)|numerals|blocks|cubes|symbols) (?:from )?(?P<first>[A-Z]|\d) (?:to|through|until|up to|till) (?P<last>[A-Z]|\d)",
        "(?P<first>[A-Z]) (?:to|through|until|up to) (?P<last>[A-Z])"),
    *patterns("labels", lambda match: _span(match["first"], match["last"]),
        r"(?P<first>\d) (?:to|through|until|up to) (?P<last>\d)(?! (?:BLOCK|rows?|columns?|layers?))"),
    *patterns("labels", lambda match: re.findall(r"\b(?:[A-Z]|\d)(?= )", f"{match[0]} "),
        r"(?:the )?(?:(?:letters|letter (?:blocks|cubes)|digits|digit (?:blocks|cubes)|numbers|number (?:blocks|cubes)) )(?:[A-Z]|\d)(?: (?:, |and |, and )?(?:[A-Z]|\d))+",
        "(?:the )?[A-Z](?: (?:, |and |, and )?[A-Z])+"),
    *patterns("reading", "told", "(?:(?:arranged|told|ordered|going|sorted|all) )?(?:in |by )?(?:the )?(?:usual |normal |their )?reading order", "(?:read )?row by row", "(?:read|reads|reading|laid out|to be read|that reads|which reads) (?:like|as|in) (?:a |the )?(?:page|book|text)(?: of a book| of text)?", "(?:line by line)"),
    *patterns("reading", "ordered", "(?:in )?(?:alphabetical|numerical|numeric|ascending|increasing|counting|natural|rising)(?: numerical)? order", "in order", "alphabetically"),
]  # fmt: skip
_N = "(?:BLOCK )?"
_EACH = "(?:each|every|a|one|the)"
_WITH = "(?:(?:of|with|by|having|containing|each of|each with|each having|each containing|that each have|which each have) )"
SIZES: list[Pattern] = [
    *patterns("dims", _dims, rf"(?:measuring |sized |size |dimensions )?{_DIMS}(?: BLOCK)?"),
    *patterns("size", _size,
        r"(?P<rows>NUM) (?:full |complete |straight )?rows?(?: deep)?", r"(?P<columns>NUM) (?:full |complete |straight )?(?:columns?|files?)(?: wide)?",
        r"(?P<layers>NUM) (?:full |complete |flat )?(?:layers?|levels?|tiers?|floors?|stories|storeys)(?: high| tall)?",
        rf"(?P<rows>NUM) rows? {_WITH}(?P<columns>NUM)(?P<taken>(?= (?:plain )?(?:COLOR)))?(?: BLOCK)?(?: (?:each|apiece|per row|in (?:each|every)(?: row| one)?))?",
        rf"(?P<columns>NUM) columns? {_WITH}(?P<rows>NUM)(?P<taken>(?= (?:plain )?(?:COLOR)))?(?: BLOCK)?(?: (?:each|apiece|per column|in (?:each|every)(?: column| one)?))?",
        rf"(?P<layers>NUM) (?:layers?|levels?|tiers?) {_WITH}(?P<layer>NUM)(?P<taken>(?= (?:plain )?(?:COLOR)))?(?: BLOCK)?(?: (?:each|apiece|per layer|in (?:each|every)(?: layer| one)?))?",
        rf"(?:with |of |having |has )?(?P<columns>NUM) {_N}(?:in|per|to|for) (?:{_EACH} )?row", r"(?:each|every) row (?:(?:has|with|of|contains|containing|having|consists|is|holding|holds|shall|should|must|have|consist|contain) )+(?P<columns>NUM)(?: BLOCK)?(?: wide| long)?",
        rf"(?:with |of |having |has )?(?P<rows>NUM) {_N}(?:in|per|to|for) (?:{_EACH} )?column", r"(?:each|every) column (?:(?:has|with|of|contains|containing|having|consists|is|holding|holds|shall|should|must|have|consist|contain) )+(?P<rows>NUM)(?: BLOCK)?(?: high| tall| deep)?",
        rf"(?:with |of |having |has )?(?P<layer>NUM) {_N}(?:in|per|to|for) (?:{_EACH} )?(?:layer|level|tier)", r"(?:each|every) (?:layer|level|tier) (?:(?:has|with|of|contains|containing|having|consists|is|holding|holds|shall|should|must|have|consist|contain) )+(?P<layer>NUM)(?: BLOCK)?(?: wide| long)?",
        rf"(?P<wide>NUM) {_N}(?:wide|across|long|in width|in length|from left to right|along)", r"(?:a |the |its )?(?:width|length) (?:(?:of|is|:|being) )*(?P<wide>NUM)(?: BLOCK)?",
        rf"(?P<high>NUM) {_N}(?:high|tall|in height|up|upwards)", r"(?:a |the |its )?height (?:(?:of|is|:|being) )*(?P<high>NUM)(?: BLOCK)?",
        rf"(?P<deep>NUM) {_N}(?:deep|in depth|from front to back|from back to front)", r"(?:a |the |its )?depth (?:(?:of|is|:|being) )*(?P<deep>NUM)(?: BLOCK)?",
        rf"(?:with )?(?P<side>NUM) {_N}(?:on|along|to|per|at|in) (?:(?:each|every|a|one|its) )?(?:side|edge)", r"(?:a )?(?:side|sides|edge|edges)(?: length)? of (?P<side>NUM)(?: BLOCK)?",
        r"(?:its |whose |the )?(?:(?:square|bottom|lowest) )?(?:base|baseline|base row|base line|base layer|bottom row)(?: (?:of|is|being|has|having|with|containing|consists|contains|:|measures|shall|be|should|consisting|a row of))* (?P<base>NUM)(?: BLOCK)?(?: (?:wide|long|across|in a row|in a line))?",
        rf"(?P<base>NUM) {_N}(?:wide )?base", "(?:starts?|starting|begins?|beginning) (?:with|from) (?P<base>NUM)(?: BLOCK)?(?: (?:at|in|on) the (?:bottom|base))?", rf"(?P<base>NUM) {_N}(?:wide|long|across) (?:at|in|on) the (?:base|bottom)"),
    *patterns("base", _dims, rf"(?:its |whose |the )?(?:square |bottom )?base(?: (?:of|is|being|:|measures|measuring|having|has|shall|be|should|must|a square of|square))* {_DIMS}(?: BLOCK)?", rf"{_DIMS}(?: BLOCK)? (?:square )?(?:base|based)"),
    *patterns("square", None, "(?:a )?square (?:base|ground plan|footprint)", "(?:whose |its |the )base is (?:a )?square"),
    *patterns("taper", None, "(?:with )?(?:always )?(?:one|a BLOCK) (?:BLOCK )?(?:fewer|less) (?:(?:in|on|for|with|at) )?(?:each|every)(?: next| higher)? (?:layer|row|level|step)(?: (?:above|up|going up|higher))?(?: it| that)?",
        "(?:each|every)(?: next| higher)? (?:layer|row|level)(?: above)?(?: it)?(?: (?:has|is|having|being))? (?:one|1) (?:BLOCK )?(?:fewer|less|smaller|shorter)(?: than the (?:one|layer|row) (?:below|under|beneath)(?: it)?)?"),
]  # fmt: skip
PLACES: list[Pattern] = [
    *patterns("place", _line,
        rf"{_IN}{_THE}{_side()}(?: most)? {_AXES}(?: away)?{_OF}", rf"(?:all )?on {_THE}{_side()} {_LEVELS}{_OF}",
        rf"{_IN}{_THE}{_AXES} (?:(?:which|that) )?(?:BE )?(?:in |at |on |to )?(?:the )?{_side(*_PLAIN)}(?: side)?{_FROM}",
        rf"{_IN}{_THE}{_side('far', 'near')} {_AXES}{_FROM}",
        rf"{_IN}(?:the )?{_AXES} (?:number )?(?P<number>NUM)",
        rf"(?:all )?(?:in |on )?(?:(?:the|both|its) )*(?P<many>\d+) {_side()} {_AXES}s",
        rf"{_IN}(?:the |both )?{_side('1', 'last', 'top', 'bottom', 'far', 'near', 'left', 'right', 'other')} (?P<many>\d+) {_AXES}s",
        rf"{_IN}(?:the |its )(?:very )?{_side()}(?: one| end)?", rf"{_IN}(?:the )?{_side('far', 'near')}{_FROM}",
        rf"(?:all )?(?:in|at|on|to|as) (?:(?:the|its|a) )?(?:very )?{_side(*_PLAIN)}(?: side| end)?", rf"(?:at|on|as) (?:its |the )?{_side('top', 'bottom')}{_OF}",
        rf"{_side(*_PLAIN, '1', '2', '3', '4', 'last')} (?=:)"),
    *patterns("place", Place("line", "far"), "(?:all )?behind(?: (?:them|that))?", f"{_IN}the (?:row|one) behind(?: (?:it|them|that))?"),
    *patterns("place", Place("line", "near"), f"{_IN}the (?:row|one) (?:in front|before it)(?: of (?:it|them|that))?"),
    *patterns("place", Place("line", "above"), "(?:on top of|over|above|on|upon) (?:them|that|those|these|this)", "above",
        "(?:in |on )?(?:the )?(?:row|layer|level|one) (?:above|on top of|over|on)(?: (?:it|that|them|this))?", "(?:in |on )?the next (?:row|layer|level|one)(?: up| above)?"),
    *patterns("place", Place("line", "above it"), "(?:on top of|over|above|on|upon) it"),
    *patterns("place", Place("line", "below"), "(?:under|below|underneath|beneath)(?: (?:them|that|those|these))?", "(?:in |on )?(?:the )?(?:row|layer|level|one) (?:below|under|underneath|beneath)(?: (?:it|that|them))?"),
    *patterns("place", Place("cells", "center"),
        f"{_IN}{_THE}(?:exact |dead )?(?:middle|center|central) (?:one|BLOCK|cell|square|position|spot|place|field){_OF}", f"(?:for )?the (?:one|BLOCK|cell|square) (?:in|at) the (?:very )?(?:middle|center){_OF}", f"(?:right )?(?:in|at) (?:the|its) (?:very |exact )?(?:middle|center){_OF}"),
    *patterns("place", Place("cells", "corners"),
        f"{_IN}(?:of )?(?:(?:the|its|all|4) )*(?:corners|corner (?:blocks|cubes|cells|squares|positions|ones|places)){_OF}", f"(?:in|at) (?:each|every)(?: one)?(?: of (?:the|its)(?: 4)?)? corners?{_OF}", "(?:each|every) corner"),
    *patterns("place", Place("cells", "border"), "(?:all )?around(?: (?:it|that|the (?:middle|center)(?: one| block)?))?", f"{_IN}(?:the |its )(?:border|rim|frame)"),
    *patterns("place", _corner,
        rf"{_IN}(?:the )?(?P<a>far|back|rear|near|front|top|upper|bottom|lower) (?P<b>left|right)(?: hand)?(?: (?:corner|BLOCK|cell|one|square|position))?{_OF}",
        rf"{_IN}(?:the )?(?P<b>left|right) (?:hand )?(?P<a>far|back|rear|near|front|top|upper|bottom|lower) (?:corner|BLOCK|cell|one|square|position){_OF}"),
    *patterns("place", _rest,
        f"(?:everywhere|everything|anywhere) else{_OF}", "elsewhere", "otherwise", "everywhere", "(?:all )?(?:(?:of )?the )?(?:others|rest|remainder)", r"(?:all )?the (?P<many>\d+) others",
        r"(?:all )?(?:the )?(?:other|remaining)(?: (?P<many>\d+))?(?: (?:blocks|cubes|pieces|ones|cells|squares|positions|places))", r"the (?:other|remaining) (?P<many>\d+)"),
]  # fmt: skip


def _span(first: str, last: str) -> list[str]:
    """All labels from one to another."""
    return [chr(code) for code in range(ord(first), ord(last) + 1)]




JOINTS: list[Pattern] = [
    *patterns("then", None, "(?:and )?then", "followed by", "and after that"),
    *patterns("except", None, "except(?: for)?", "apart from", "save for"),
    *patterns("some", None, r"(?:a |the )?(?P<count>NUM)(?: (?:of (?:them|these)|ones?))?"),
    *patterns("glue", None, "(?:whose|it|its|they|where|so|so that|such that|in which|here|also|too|completely|"
        "entirely|all over|fill|fills|filled|cover|covers|tile|occupied|occupies|bear|bears|wide|shall|must|be|"
        "stacked|side by side|close together|tightly packed|without gaps|standing|upright|lying|flat)"),
]  # fmt: skip
"""Kinds "then" and "except", which part; "some" (a number of blocks); and words that say nothing beside the parts."""
