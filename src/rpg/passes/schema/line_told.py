"""What a text says of a line must show in the task: all blocks that are to be in it, their order, how many they are,
and which of them are left out. It is looked for in the words as they were typed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rpg.core.diagnostics import Span
from rpg.ir.assets import Block
from rpg.ir.goal import Goal, Not
from rpg.ir.node import members
from rpg.ir.relations import InRegion
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import GroupBy, Row, Spells, Stack
from rpg.ir.walk import atoms, children, names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.resolve.things.world import refuse

Line = Row | Stack


def check_lines(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a task whose line is not the one that is told of.

    Raises:
        Refusal: "in one row" of some of its blocks alone, an order that is told and not asked for, other numbers.
    """
    told = sentences(tokens)
    lines = [*_lines(task.goal)]
    for sentence in told:
        text = text_of(sentence)
        _in_total(text, sentence, task, alone=len(told) == 1)
        _numbered(text, sentence, task)
        _counted(text, sentence, task)
        _apart(text, sentence, task)
        if lines:
            _all_touching(text, sentence, lines)
            _as_long(text, sentence, lines)
            _mirrored(sentence, lines, task)
            _other_end(text, sentence, told, task)
        if lines and not task.init.arranged:
            _in_order(text, sentence, lines)
            _all_but(text, sentence, lines, task)
        if len(lines) == 1:
            _in_one(text, sentence, lines[0], task)
            _all_listed(text, sentence, lines[0], task)
            _side_of_it(text, sentence, lines[0], task)


def _lines(goal: Goal) -> Iterator[Line]:
    """The lines that are asked for, and not denied."""
    if isinstance(goal, Row | Stack):
        yield goal
    for part in () if isinstance(goal, Not) else children(goal):
        yield from _lines(part)


def _span(text: str, sentence: Sequence[Token], match: re.Match[str]) -> Span:
    """Where the words of a match stand in the instruction."""
    first, last = (text[:at].strip().count(" ") for at in match.span())
    first += match.start() > 0
    return sentence[first].span[0], sentence[last].span[1]


def _looks(block: Block) -> set[str]:
    return {block.color, *symbols_of(block)}


_A_LINE = f"(?:an?|one|a single|the same) {LINE}\\b"
_ALL_IN_ONE = re.compile(
    f"(?:, (?:all )?|\\ball (?:of (?:them|these) )?)in {_A_LINE}|\\bin (?:one|a single|the same) {LINE}\\b"
    f"|\\bin {_A_LINE} of {MANY}\\b|\\bbetween .* in {_A_LINE}(?=$| [.;,])"
)
"""What takes in all that the sentence speaks of."""
_TOGETHER = re.compile(f"\\bin {_A_LINE}")


def _in_one(text: str, sentence: Sequence[Token], line: Line, task: TaskSchema) -> None:
    """Refuse "put two green cubes between a red one and a blue one, all in one row" as a row of green ones."""
    blocks = {block.name for block in task.blocks}
    inside = {*line.blocks}
    for atom in (x for x in atoms(task.goal) if x is not line):
        spoken = {*names(atom)} & blocks
        match = (_TOGETHER if isinstance(atom, GroupBy) else _ALL_IN_ONE).search(text)
        if match and spoken & inside and spoken - inside and text[match.end() :].count("from") == 0:
            raise refuse("ambiguous", "are all of these in one line, or only some of them?",
                         _span(text, sentence, match), "say first which blocks are in it, and then where")  # fmt: skip


_ONE_LINE = re.compile(f"\\b(?:in|into|to form) (?:one|a single|the same) {LINE}\\b(?!s)")
_OTHER = frozenset({"another", "other", "second", "next", "each", "every", "one", "two"})


def _apart(text: str, sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "spell CAT and DOG in one row" as of a row for each of them."""
    match = _ONE_LINE.search(text)
    lines = [{*line.blocks} for line in _lines(task.goal)]
    lines += [{*members(atom.blocks)} for atom in atoms(task.goal) if isinstance(atom, Spells)]
    parted = any(not one & other for n, one in enumerate(lines) for other in lines[:n])
    if match and parted and _OTHER.isdisjoint((text[: match.start()] + text[match.end() :]).split()):
        raise refuse("contradiction", "these are told to be in one line, and make several", _span(text, sentence, match),
                     "say 'in two rows', or list the blocks of the one row")  # fmt: skip


_TOUCHING = re.compile(r"\ball (?:of (?:them|these) )?(?:touching|touch)\b")


def _all_touching(text: str, sentence: Sequence[Token], lines: list[Line]) -> None:
    """Refuse "a row of three red and behind it a row of two blue, all touching" as said of one of the rows alone."""
    match = _TOUCHING.search(text)
    rows = [line for line in lines if isinstance(line, Row)]
    if match is not None and len(rows) > 1 and not all(row.touching for row in rows):
        raise refuse("ambiguous", "do the blocks of each row touch, or the rows each other?", _span(text, sentence, match),
                     "say it in a sentence of its own")  # fmt: skip


_LISTED = f"{COLOR}(?:(?: ,)?(?: and(?: then)?| then)?(?: an?| one)? {COLOR})+"
_GO = f"(?:(?:{MUST} )?(?:go|run|read|come)|goes|runs|reads)"
_LEADS = f"(?:they|it|these|the blocks|the cubes|(?:the|its|their) (?:colors?|order|sequence)) {_GO}(?: ,| :)?"
_ARE = f"(?:the|its|their) colors (?:are|{MUST} be)(?: ,| :)?"
_ORDERED = re.compile(f"\\b{_LEADS} (?P<listed>{_LISTED})")
_REPEATED = re.compile(f"\\b(?:{_ARE} |in |: )(?P<listed>{_LISTED})")


def _in_order(text: str, sentence: Sequence[Token], lines: list[Line]) -> None:
    """Refuse "three blocks in a row and they go red, white, blue", "the colours are red, red, blue, red" as of blocks
    in any order."""
    if any(line.order.by != "any" for line in lines):
        return
    for match in (*_ORDERED.finditer(text), *_REPEATED.finditer(text)):
        listed = [word for word in match["listed"].split() if word in lexicon.COLOR]
        if match.re is _ORDERED or len({*listed}) < len(listed):
            raise refuse("misplaced", "this is an order, and no line here has one", _span(text, sentence, match),
                         "say it where the line is told, as in 'a row: red, white, blue'")  # fmt: skip


_TOTAL = re.compile(f"(?<!there is )(?<!there are )\\b(?P<many>{MANY})(?: blocks| cubes)? (?:in total|in all|altogether"
                    "|overall)\\b")  # fmt: skip
_EACH = frozenset({"each", "every", "per", "distractor", "distractors", "both", "available"})


def _in_total(text: str, sentence: Sequence[Token], task: TaskSchema, *, alone: bool) -> None:
    """Refuse "a row of two red, three blue, six blocks in total" as of five blocks."""
    match = _TOTAL.search(text)
    if match is None or not _EACH.isdisjoint(text.split()) or not _MAKES.search(text):
        return
    said = int(match["many"]) if match["many"].isdigit() else lexicon.NUMBER[match["many"]]
    used = {*names(task.goal)} & {block.name for block in task.blocks}
    if len(used) < said or (alone and len(used) > said):
        raise refuse("count-mismatch", f"{said} blocks are said to be there in all, but {len(used)} are told of",
                     _span(text, sentence, match), f"say {len(used)}, or tell of them all")  # fmt: skip


_AS_LONG = re.compile(f"\\b{LINE} of [^,]*(?: ,)? as (?:long|tall|high) as (?:an?|the|another|one) {LINE}\\b")


def _as_long(text: str, sentence: Sequence[Token], lines: list[Line]) -> None:
    """Refuse "a row of red blocks as long as a row of three blue ones" as of four, and of three."""
    match = _AS_LONG.search(text)
    if match is not None and len({len(line.blocks) for line in lines}) > 1:
        raise refuse("count-mismatch", "these are not of the same length", _span(text, sentence, match),
                     "say how many blocks each of them has")  # fmt: skip


_MAKES = re.compile(f"\\b(?:{'|'.join(sorted(lexicon.STRUCTURE))})\\b")

_NTH = "(?:first|second|third|fourth|fifth|last|middle|leftmost|rightmost|top|bottom|lowest|highest|uppermost)"
_ALL = "(?:all|every|everything|each)(?: of)?(?: them| the blocks| the cubes| one| block| cube| blocks| cubes)?"
_BUT = "(?: ,)? (?:but|except|except for|save|save for|apart from|other than|bar)(?: the)?"
_IS = f"(?:is|are|{MUST} be)"
_EXCEPT = (
    re.compile(f"\\b{_ALL}{_BUT} {_NTH}(?: one| block| cube)?(?: ,)?(?: {_IS})? (?P<color>{COLOR})\\b"),
    re.compile(f"\\b{_ALL}(?: {_IS})? (?P<color>{COLOR})(?: ones| blocks| cubes)?{_BUT} {_NTH}\\b"),
)
"""All of a line but one of its places: what colour they have."""


def _all_but(text: str, sentence: Sequence[Token], lines: list[Line], task: TaskSchema) -> None:
    """Refuse "a row of five, all but the last one red" as with the last one red, or with all of them red."""
    colors = {block.name: block.color for block in task.blocks}
    for match in (found for pattern in _EXCEPT if (found := pattern.search(text)) is not None):
        color = lexicon.COLOR[match["color"]]
        had = [sum(colors[name] == color for name in line.blocks) - len(line.blocks) for line in lines]
        if -1 not in had:
            raise refuse("ambiguous", "it is not clear what this leaves out, and how that looks",
                         _span(text, sentence, match), "say how each block looks, as in 'four red blocks and then a "
                         "blue one'")  # fmt: skip


_SIDE = re.compile(r"\b(?:the|its) (?:other|opposite) end\b")
_KNOWN = re.compile(
    f"\\b(?:one|an?|left|right|top|bottom|front|back|near|far|either) end\\b|\\b(?:start|begin)|{LINE}s"
)


def _other_end(text: str, sentence: Sequence[Token], told: list[list[Token]], task: TaskSchema) -> None:
    """Refuse "there is a row: red, green, blue. Put the green one at the other end." as though it were there."""
    match = _SIDE.search(text)
    earlier = " . ".join(text_of(one) for one in told[: told.index([*sentence])])
    known = _KNOWN.search(text) or _KNOWN.search(earlier)
    if match is not None and earlier and not task.init.arranged and not known:
        raise refuse("ambiguous", "it is not clear which end this is", _span(text, sentence, match),
                     "say 'left' or 'right', and of the start 'at the start, there is a row of ...'")  # fmt: skip


_MADE_OF = re.compile(
    f"\\b{LINE} (?:made )?(?:of|from|with) (?P<listed>{COLOR}(?: , {COLOR})*(?: ,)? and {COLOR})(?=$| [,.;])"
)


_OF_IT = re.compile(
    f" , (?:the )?{COLOR}(?: one| block)? (?:on |to |at )?(?:the )?(?:left|right|behind|in front) (?:side )?"
    "(?:of )?it\\b"
)


def _all_listed(text: str, sentence: Sequence[Token], line: Line, task: TaskSchema) -> None:
    """Refuse "a row of red, white and blue, white to the right of it" as a row of red and white."""
    match = _MADE_OF.search(text)
    listed = {lexicon.COLOR[word] for word in match["listed"].split() if word in lexicon.COLOR} if match else set()
    inside = {block.color for block in task.blocks if block.name in line.blocks}
    if match is not None and (not listed <= inside or _OF_IT.match(text[match.end() :])):
        raise refuse("ambiguous", "are all of these in the line, or is more told of the last one?",
                     _span(text, sentence, match), "tell where it is in a sentence of its own")  # fmt: skip


_NUMBERED = re.compile(
    rf"\b(?:blocks?|cubes?|bricks?|digits?|numbers?) (?P<listed>\d(?: , \d)*(?: ,)? (?:and )?\d) (?P<color>{COLOR})\b"
    "(?! (?:block|cube|brick|one)s?\\b)"
)


def _numbered(text: str, sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "blocks 1 and 3 red, 2 and 4 blue" as three red blocks."""
    for match in _NUMBERED.finditer(text):
        shown = {(label, str(block.color)) for block in task.blocks for label in symbols_of(block)}
        color = lexicon.COLOR[match["color"]]
        if not all((label, color) in shown for label in match["listed"].split() if label.isdigit()):
            raise refuse("ambiguous", "do these numbers count blocks, or are they what the blocks show?",
                         _span(text, sentence, match), "say 'the blocks ... are', or '3 red blocks'")  # fmt: skip


_COUNTED = re.compile(rf"\b{LINE} of (?P<many>\d)(?= ,|$| with\b| where\b| in which\b| :)(?!.*\b\d)")


def _counted(text: str, sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of 3, two red" as of a block that shows a 3, and two red ones."""
    match = _COUNTED.search(text)
    if match is not None and any(match["many"] in symbols_of(block) for block in task.blocks):
        raise refuse("ambiguous", "so many blocks, or what a block shows?", _span(text, sentence, match),
                     f"say '{match['many']} blocks', or 'the block {match['many']}'")  # fmt: skip


def _mirrored(sentence: Sequence[Token], lines: list[Line], task: TaskSchema) -> None:
    """Refuse "the letters of HELP mirrored" as with mirrored colours, which they have anyway."""
    known = {block.name: block for block in task.blocks}
    said = next((token for token in sentence if token.word in ("mirrored", "symmetric", "symmetrical")), None)
    for line in (x for x in lines if x.order.by == "mirrored" and x.order.attribute == "color"):
        blocks = [known[name] for name in line.blocks]
        alike = len({block.color for block in blocks}) == 1
        if said is not None and alike and any(map(symbols_of, blocks)):
            raise refuse("misplaced", "nothing here could be mirrored", said.span,
                         "say 'from right to left', or list the blocks in their order")  # fmt: skip


_SIDED = re.compile(
    f"\\b{LINE}(?: of {MANY}(?: blocks| cubes)?)? (?:with|having|that has|:) .*\\b(?:side|left|right|center|middle)\\b"
)
_TABLE = frozenset({*lexicon.TABLE_NOUNS.split(), "half", "halves", "workspace"})


def _side_of_it(text: str, sentence: Sequence[Token], line: Line, task: TaskSchema) -> None:
    """Refuse "a row with 2 yellow left side, 2 green right side" as of two sides of the table."""
    match = _SIDED.search(text)
    regions = {atom.region for atom in atoms(task.goal) if isinstance(atom, InRegion)}
    if match is not None and len(regions) > 1 and _TABLE.isdisjoint(token.word for token in sentence):
        raise refuse("ambiguous", "sides of the line, or of the table?", _span(text, sentence, match),
                     "say 'at the left end' or 'of the table'")  # fmt: skip
