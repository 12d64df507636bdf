"""What a text says of a line must show in the task: all blocks that are to be in it, their order, its ends, and how
many they are. It is looked for in the words as they were typed."""

from __future__ import annotations

from itertools import pairwise

from rpg.ir.goal import Not
from rpg.ir.node import members
from rpg.ir.relations import (
    Adjacent,
    Behind,
    Beside,
    Between,
    Distance,
    InFrontOf,
    InRegion,
    LeftOf,
    Near,
    RightOf,
    Touching,
)
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Equation, Grid, GroupBy, Row, Spells, Stack
from rpg.ir.walk import names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, TOWER
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.ends_counted import ends_counted
from rpg.passes.schema.line_numbers import (
    all_but,
    and_counted,
    as_long,
    counted,
    in_total,
    kinds_in_turn,
    numbered,
    of_each,
    of_which,
)
from rpg.passes.schema.line_said import Said, asked, lines_of
from rpg.passes.schema.numbers_had import symbols_of


def check_lines(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a task whose line is not the one that is told of.

    Raises:
        Refusal: "in one row" of some of its blocks alone, an order that is told and not asked for, other numbers.
    """
    told = sentences(tokens)
    texts = [text_of(sentence) for sentence in told]
    lines = lines_of(task.goal)
    for n, sentence in enumerate(told):
        said = Said(sentence, texts[n], " ".join(texts[:n]), task, lines, alone=len(told) == 1)
        for check in _CHECKS:
            check(said)


_A_LINE = f"(?:an?|one|a single|the same) {LINE}\\b"
_ALL_IN_ONE = on_demand(
    f"(?:, (?:all )?|\\ball (?:of (?:them|these) )?)in {_A_LINE}|\\bin (?:one|a single|the same) {LINE}\\b"
    f"|\\bin {_A_LINE} of {MANY}\\b|\\bbetween .* in {_A_LINE}(?=$| [.;,])"
)
"""What takes in all that the sentence speaks of."""
_ONE_LINE = on_demand(f"\\b(?:in|into|to form) (?:one|a single|the same) {LINE}\\b")
_FIRST_IN_IT = on_demand(f"^in {_A_LINE}(?= .*\\bfirst\\b.*\\bthen\\b)")
"""A line in which something comes first."""
_TOGETHER = on_demand(f"\\bin {_A_LINE}")
_BESIDE = (Adjacent, Behind, Beside, Between, GroupBy, InFrontOf, LeftOf, Near, RightOf, Touching)
"""What is told of blocks beside each other, which those of one row are."""


def _in_one(said: Said) -> None:
    """Refuse "put two green cubes between a red one and a blue one, all in one row" as a row of green ones."""
    inside = {*said.lines[0].blocks} if len(said.lines) == 1 else set()
    blocks = {block.name for block in said.task.blocks}
    for atom in (x for x in asked(said.task.goal) if inside and isinstance(x, _BESIDE)):
        spoken = {*names(atom)} & blocks
        match = (_TOGETHER if isinstance(atom, GroupBy) else _ALL_IN_ONE).search(said.text)
        mixed = spoken & inside or (match and _ONE_LINE.search(match[0]))
        told = match and atom.span and (match.start() == 0 or atom.span[0] < said.at(match))
        if match and told and mixed and spoken - inside and " from " not in said.text[match.end() :]:
            raise said.refusal(match, "ambiguous", "are all of these in one line, or only some of them?",
                               "say first which blocks are in it, and then where")  # fmt: skip


_TOWERS = on_demand(f"\\b{TOWER}s?\\b")
_OTHER = frozenset({"another", "other", "second", "next", "each", "every", "one", "two", "below", "underneath"})


def _apart(said: Said) -> None:
    """Refuse "spell CAT and DOG in one row" as of a row for each of them, one beside or one after the other."""
    match = _ONE_LINE.search(said.text) or _FIRST_IN_IT.search(said.text)
    if match is None or not _OTHER.isdisjoint((said.text[: match.start()] + said.text[match.end() :]).split()):
        return
    of_towers = _TOWERS.search(said.text[: match.start()])  # "three towers in one row"
    lines = [{*line.blocks} for line in said.lines if not (of_towers and isinstance(line, Stack))]
    lines += [{*members(word.blocks)} for word in asked(said.task.goal) if isinstance(word, Spells)]
    if any(not one & other for n, one in enumerate(lines) for other in lines[:n]):
        raise said.refusal(match, "contradiction", "these are told to be in one line, and make several",
                           "say 'in two rows', or list the blocks of the one row")  # fmt: skip


_A_LOT = f"(?:(?:an?|{MANY}) )?{COLOR}(?: blocks?| cubes?)?"
_MADE_OF = on_demand(
    f"\\b{LINE} (?:made )?(?:of|from|with) (?P<listed>{_A_LOT}(?: , {_A_LOT})*(?: ,)? and {_A_LOT})"
    "(?=$| [,.;]| with\\b)"
)
_OF_IT = on_demand(
    f" , (?:the )?{COLOR}(?: one| block)? (?:on |to |at )?(?:the )?(?:left|right|behind|in front) (?:side )?"
    "(?:of )?it\\b"
)


def _all_listed(said: Said) -> None:
    """Refuse "a row of red, white and blue, white to the right of it" as a row of red and white."""
    match = _MADE_OF.search(said.text)
    if match is None or len(said.lines) != 1 or said.begun:
        return
    listed = {lexicon.COLOR[word] for word in match["listed"].split() if word in lexicon.COLOR}
    inside = {block.color for block in said.blocks(said.lines[0])}
    if not listed <= inside or _OF_IT.match(said.text[match.end() :]):
        raise said.refusal(match, "ambiguous", "are all of these in the line, or is more told of the last one?",
                           "tell where it is in a sentence of its own")  # fmt: skip


_TWICE = on_demand(r"\b(?:together|side by side)\b.*\b(?:together|side by side)\b")


def _each_together(said: Said) -> None:
    """Refuse "the reds together and the blues together, all in one row" as of a row in any order."""
    match = _TWICE.search(said.text)
    loose = len(said.lines) == 1 and said.lines[0].order.by == "any" and not said.begun
    mixed = loose and len({block.color for block in said.blocks(said.lines[0])}) > 1
    if match and mixed and not any(isinstance(part, _BESIDE) for part in asked(said.task.goal)):
        raise said.refusal(match, "ambiguous", "how these are together in the line is not clear",
                           "say 'in a row, the same colors together'")  # fmt: skip


_AMID = on_demand(f"\\b{LINE} of .*\\bbetween\\b")


def _amid(said: Said) -> None:
    """Refuse "a row of red and blue with two green between them" as of a row of two, with blocks in its gap, and "a
    tower of red, blue and green with a white block between red and blue" as of a tower of three."""
    match = _AMID.search(said.text)
    inside = {*said.lines[0].blocks} if len(said.lines) == 1 and match else set()
    others = {block.name for block in said.task.blocks} - inside
    for part in (part for part in asked(said.task.goal) if isinstance(part, Between)):
        if match and {*members(part.b), *members(part.c)} <= inside and {*members(part.a)} & others:
            raise said.refusal(match, "ambiguous", "in the row as well, or between its blocks?",
                               "list the row from one end to the other")  # fmt: skip


_AT_LEAST = on_demand(
    f"\\b{LINE} (?:with|having|containing|including|that has|that contains|which has|which contains) "
    f"(?:at least|no fewer than|not fewer than) {MANY} {COLOR}(?: blocks?| cubes?| ones?)?(?= in it\\b|$| [,.;])"
)


def _at_least(said: Said) -> None:
    """Refuse "a tower with at least two red blocks" as a tower of two: what else is in it is not said."""
    match = _AT_LEAST.search(said.text)
    if match is not None:
        raise said.refusal(match, "ambiguous", "it is not said which other blocks are in this line",
                           "say of which blocks it is built, and of how many")  # fmt: skip


_ONE_ON_IT = on_demand(
    f"\\b{TOWER} of {MANY}(?: {COLOR})?(?: blocks| cubes)?(?: ,| and| , and| with) one on (?:top of )?(?:it|them)\\b"
)


def _one_on_it(said: Said) -> None:
    """Refuse "a tower of three red blocks with one on top of it" as a tower of three."""
    match = _ONE_ON_IT.search(said.text)
    if match is not None:
        raise said.refusal(match, "ambiguous", "is this one of the blocks of the tower, or a further one?",
                           "say how many blocks the tower has with it")  # fmt: skip


_BOTH_ENDS = on_demand(r"\bleft end\b(?! of).*\bright end\b(?! of)|\bright end\b(?! of).*\bleft end\b(?! of)")


def _ends_of_none(said: Said) -> None:
    """Refuse "red is at the left end, blue at the right end" as red somewhere to the left of blue."""
    match = _BOTH_ENDS.search(said.text)
    if match and not said.begun and not any(hasattr(part, "blocks") for part in asked(said.task.goal)):
        raise said.refusal(match, "ambiguous", "it is not said of which line these are the ends",
                           "say 'a row with ...', or 'of the table'")  # fmt: skip


_EACH_TWO = on_demand(r"\bbetween (?:each|every|any|all)(?: two| pair| 2)\b")


def _between_each(said: Said) -> None:
    """Refuse "a row of red blocks with a blue between each two" as red, blue, blue, red."""
    match = _EACH_TWO.search(said.text)
    for line in said.lines if match else ():
        colors = {block.name: block.color for block in said.blocks(line)}
        ranks = [{colors[name] for name in rank} for rank in line.order.ranks if len(rank) == 1]
        if len({*colors.values()}) == 1:
            continue
        alike = len(ranks) < len(line.blocks) or any(one == other for one, other in pairwise(ranks))
        if match and alike and line.order.by != "alternating":
            raise said.refusal(match, "ambiguous", "it is not clear how many these are",
                               "say how many blocks alternate, or list them from one end to the other")  # fmt: skip


_ITS_ROWS = on_demand("(?:,|with|and|whose|where) (?:the |its |all |all the )?(?:rows|columns) (?!of\\b)")


def _rows_of_it(said: Said) -> None:
    """Refuse "a grid of 2x4, rows alternating red and blue" as of a grid, and of rows beside it."""
    match = _ITS_ROWS.search(said.text)
    cells = {name for part in asked(said.task.goal) if isinstance(part, Grid) for name in members(part.blocks)}
    if match and cells and said.lines and not any(cells & {*line.blocks} for line in said.lines):
        raise said.refusal(match, "ambiguous", "the rows of the grid, or further ones?",
                           "say 'each row of the grid', or 'and two rows beside it'")  # fmt: skip


_TOUCHING = on_demand(r"\ball (?:of (?:them|these) )?(?:touching|touch)\b")


def _all_touching(said: Said) -> None:
    """Refuse "a row of three red and behind it a row of two blue, all touching" as said of one of the rows alone."""
    match = _TOUCHING.search(said.text)
    rows = [line for line in said.lines if isinstance(line, Row)]
    if match is not None and len(rows) > 1 and not all(row.touching for row in rows):
        raise said.refusal(match, "ambiguous", "do the blocks of each row touch, or the rows each other?",
                           "say it in a sentence of its own")  # fmt: skip


_LISTED = f"{COLOR}(?:(?: ,)?(?: and(?: then)?| then)?(?: an?| one)? {COLOR})+"
_THEY = "(?:they|it|these|the (?:blocks|cubes|letters|digits|numbers)|(?:the|its|their) (?:colors?|order|sequence))"
_GO = f"{_THEY} (?:(?:{MUST} )?(?:go|run|read|come)|goes|runs|reads)(?: ,| :)?"
_ARE = f"(?:the|its|their) colors (?:are|{MUST} be)(?: ,| :)?"
_ORDERED = on_demand(f"\\b{_GO} (?P<listed>{_LISTED})")
_REPEATED = on_demand(f"\\b(?:{_ARE} |in |: )(?P<listed>{_LISTED})")
_SYMBOLS = on_demand(f"\\b{_GO} (?P<listed>[a-z\\d](?:(?: ,)? (?:and )?[a-z\\d])+)(?=$| )")


def _in_order(said: Said) -> None:
    """Refuse "three blocks in a row and they go red, white, blue", "the colours are red, red, blue, red" as of blocks
    in any order."""
    if not said.lines or said.begun or any(line.order.by != "any" for line in said.lines):
        return
    told = [(match, pattern is _ORDERED) for pattern in (_ORDERED, _REPEATED) for match in pattern.finditer(said.text)]
    for match, ordered in told:
        listed = [word for word in match["listed"].split() if word in lexicon.COLOR]
        if ordered or len({*listed}) < len(listed):
            raise said.refusal(match, "misplaced", "this is an order, and no line here has one",
                               "say it where the line is told, as in 'a row: red, white, blue'")  # fmt: skip


def _in_order_of(said: Said) -> None:
    """Refuse "a row of letters and they read C, A, T" as of a row of some of them."""
    match = _SYMBOLS.search(said.text)
    if match is None:
        return
    shown = {block.name: symbols_of(block) for block in said.task.blocks}
    listed = {word.upper() for word in match["listed"].split() if len(word) == 1 and word != ","}
    ordered = [line.blocks for line in said.lines if line.order.by != "any"]
    ordered += [members(x.blocks) for x in asked(said.task.goal) if isinstance(x, Spells | Equation)]
    if not any(listed <= {symbol for name in blocks for symbol in shown[name]} for blocks in ordered):
        raise said.refusal(match, "misplaced", "this is an order, and no line here has it",
                           "say it where the line is told, as in 'a row: A, B, C'")  # fmt: skip


_MIRRORED = on_demand("\\b(?:mirrored|symmetric|symmetrical)\\b")


def _mirrored(said: Said) -> None:
    """Refuse "the letters of HELP mirrored" as with mirrored colours, which they have anyway."""
    match = _MIRRORED.search(said.text)
    for line in said.lines if match else ():
        blocks = said.blocks(line) if (line.order.by, line.order.attribute) == ("mirrored", "color") else []
        if match and len({block.color for block in blocks}) == 1 and any(map(symbols_of, blocks)):
            raise said.refusal(match, "misplaced", "nothing here could be mirrored",
                               "say 'from right to left', or list the blocks in their order")  # fmt: skip


_OTHER_END = on_demand(r"\b(?:the|its) (?:other|opposite) end\b")
_KNOWN = on_demand(f"\\b(?:one|an?|left|right|top|bottom|front|back|near|far|either) end\\b|\\b(?:start|begin)|{LINE}s")


def _other_end(said: Said) -> None:
    """Refuse "there is a row: red, green, blue. Put the green one at the other end." as though it were there."""
    match = _OTHER_END.search(said.text)
    if match and said.lines and said.earlier and not said.begun and not _KNOWN.search(f"{said.earlier} {said.text}"):
        raise said.refusal(match, "ambiguous", "it is not clear which end this is",
                           "say 'left' or 'right', and of the start 'at the start, there is a row of ...'")  # fmt: skip


_SIDED = on_demand(
    f"\\b{LINE}(?: of {MANY}(?: blocks| cubes)?)? (?:with|having|that has|:) .*\\b(?:side|left|right|center|middle)\\b"
)
_TABLE = frozenset({*lexicon.TABLE_NOUNS.split(), "half", "halves", "workspace"})


def _side_of_it(said: Said) -> None:
    """Refuse "a row with 2 yellow left side, 2 green right side" as of two sides of the table."""
    match = _SIDED.search(said.text)
    regions = {part.region for part in asked(said.task.goal) if isinstance(part, InRegion)}
    if match is not None and len(said.lines) == 1 and len(regions) > 1 and _TABLE.isdisjoint(said.text.split()):
        raise said.refusal(match, "ambiguous", "sides of the line, or of the table?",
                           "say 'at the left end' or 'of the table'")  # fmt: skip


_SPACED = on_demand(r"\b(?:cm|mm|inches) apart\b")
_IN_LINE = on_demand(
    f"\\b(?:{LINE}s?|lined?|aligned|spac\\w+|neighbou?rs?|neighbou?ring|next|adjacent|side by side|queue|from left|one "
    "after|in order|gaps?|words?|spell\\w*)\\b"
)


_ANY_MORE = on_demand(r"\b(?:any|every) (?:three|four|five|six|[3-9])\b")


def _spaced(said: Said) -> None:
    """Refuse "red, blue and green are all 10 cm apart" as a line, for they may be so in a triangle, and "any three of
    them" as any two."""
    match = _SPACED.search(said.text)
    many = bool(_ANY_MORE.search(said.text)) or any(
        len(line.blocks) > 2 for line in said.lines if isinstance(line, Row) and line.spacing
    )
    if match and many and not _IN_LINE.search(f"{said.earlier} {said.text}"):
        raise said.refusal(match, "ambiguous", "in a line, or every two of them?",
                           "say 'in a row, 10 cm apart', or 'every two of them 10 cm apart'")  # fmt: skip


_NEXT = on_demand(r"\b(?:(?:from|to) (?:the next|its neighbors?)|neighbors|neighboring)\b")


def _to_the_next(said: Said) -> None:
    """Refuse "no block of the line is more than 6 cm from the next" as from any other one; "at least" is from all."""
    match = _NEXT.search(said.text)
    parts = [*asked(said.task.goal)] if match is not None else []
    near = [x for x in parts if isinstance(x, Distance) and x.maximum is not None]
    denied = [x.goal for x in parts if isinstance(x, Not) and isinstance(x.goal, Distance)]
    near += [x for x in denied if x.minimum is not None]
    pairs = {frozenset((*members(x.a), *members(x.b))) for x in near}
    blocks = frozenset[str]().union(*pairs)
    if match is not None and len(blocks) > 2 and len(pairs) == len(blocks) * (len(blocks) - 1) // 2:
        raise said.refusal(match, "ambiguous", "how far the next is in a line is told as one distance, or by gaps",
                           "say 'with gaps of at most 2 cm', or 'with 6 cm between centers'")  # fmt: skip


_WAY = on_demand(r"\b(left|right|bottom|top|front|back) to (?:the )?(left|right|bottom|top|front|back)\b")


def _both_ways(said: Said) -> None:
    """Refuse "a row of A, B from right to left in front of a row of 1, 2 from left to right" as of one of the ways."""
    ways = {match.groups(): match for match in _WAY.finditer(said.text)}
    firsts = {line.order.first for line in said.lines}
    for (first, last), match in ways.items():
        if (last, first) in ways and len(said.lines) > 1 and not said.begun and first not in firsts:
            raise said.refusal(match, "ambiguous", "which of the lines has this order?",
                               "tell of each line in a sentence of its own")  # fmt: skip


_CHECKS = (
    in_total, as_long, and_counted, numbered, counted, of_each, of_which, all_but, _in_one, _apart, _all_listed,
    _each_together, _amid, _at_least, _one_on_it, _ends_of_none, _between_each, _rows_of_it, _all_touching, _in_order,
    _in_order_of, _mirrored, _other_end, _side_of_it, _spaced, _both_ways, _to_the_next, ends_counted,
    kinds_in_turn,
)  # fmt: skip
