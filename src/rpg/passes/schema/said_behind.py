"""What a later sentence says of an earlier one must show in the task: what begins a line, that no order is asked for,
that no two blocks are alike, which way a line goes. It is looked for in the words as they were typed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.assets import Block
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.relations import InRegion
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Equation, Figure, Grid, Row, Spells, Stack
from rpg.ir.walk import atoms, names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.brought_in import check_brought_in
from rpg.passes.schema.could_be_both import check_could_be_both
from rpg.passes.schema.ends_of_which import check_ends_of_which
from rpg.passes.schema.line_told import check_lines
from rpg.passes.schema.mats_listed import check_mat_or_block, check_mats_listed
from rpg.passes.schema.modifiers_had import check_modifiers
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.of_a_part import check_parts
from rpg.passes.schema.one_like_it import check_one_like_it
from rpg.passes.schema.pyramid_told import check_pyramid
from rpg.passes.schema.resolve.things.world import refuse
from rpg.passes.schema.said_of_all import check_said_of_all
from rpg.passes.schema.there_of_which import check_there_of_which
from rpg.passes.schema.told_apart import check_told_apart
from rpg.passes.schema.towers_stacked import check_one_on_other, check_towers_stacked
from rpg.passes.schema.which_has import check_which_has


def check_behind(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a task in which nothing comes of a sentence that tells more of what was said before it."""
    told = sentences(tokens)
    for n, sentence in enumerate(told[1:], 1):
        _begun_with(sentence, task)
        _all_different(sentence, task)
        _done_first(sentence, told[:n], task)
        _also_there(sentence, told[:n], task)
        _there_at_first(sentence, told[:n], task)
    for sentence in told:
        _no_order(sentence, task)
        _reversed(sentence, task)
        _at_an_end(sentence, task)
        _too(sentence, task)
        _corner_of(sentence, task)
        _listed_from(sentence, task)
        _from_end_to_end(sentence, task)
        _lines_within(sentence, task)
        _aslant(sentence)
        _in_different_colors(sentence, task)
    _one_way(tokens, task)
    check_ends_of_which(tokens)
    check_which_has(tokens)
    check_lines(tokens, task)
    check_pyramid(tokens, task)
    check_said_of_all(tokens, task)
    check_told_apart(tokens, task)
    check_parts(tokens, task)
    check_one_like_it(tokens, task)
    check_modifiers(tokens, task)
    check_mats_listed(tokens, task)
    check_brought_in(tokens, task)
    check_mat_or_block(tokens, task)
    check_towers_stacked(tokens, task)
    check_one_on_other(tokens, task)
    check_could_be_both(tokens, task)
    check_there_of_which(tokens, task)


_SIDE = r"(?:on|at) the (?:\w+ )?(?:left|right|top|bottom|front|back|near|far)(?: end| side)?"
_FROM_END_TO_END = on_demand(
    rf"\b(?:row|line|column|tower|stack) from (?:the )?(\w+) {_SIDE} to (?:the )?(\w+) "
    rf"{_SIDE}"
)


def _from_end_to_end(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row from red on the left to purple on the right" as a row of these two alone."""
    told = _FROM_END_TO_END.search(" ".join(token.word for token in sentence))
    if told is not None and told[1] in lexicon.COLOR and len(task.blocks) == len({told[1], told[2]}):
        raise refuse("ambiguous", "it is not said what stands between the two ends", sentence[0].span,
                     "name all the blocks, or say 'in rainbow order'")  # fmt: skip


_LINES_WITHIN = on_demand(r"(?:\bgrid|\bwall|\d+x\d+)\b.*\b(?:rows|columns|layers) alternat")


def _lines_within(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a 4x4 grid, rows alternating" as a grid and some rows besides."""
    told = _LINES_WITHIN.search(" ".join(token.word for token in sentence))
    if told is not None and any(isinstance(x, Row) for x in atoms(task.goal)):
        raise refuse("ambiguous", "are these lines of the figure, or further ones?", sentence[0].span,
                     "say 'with rows alternating red and blue'")  # fmt: skip


_OFF = r"\d[\d.]* cm (?:further )?(?:to )?(?:the )?(?:left|right|behind|in front|away)\b"
_ASLANT = on_demand(rf"\b{_OFF}[^,;]*\band (?:also )?{_OFF}[^,;]*\b(?:it|them|that)\b")


def _aslant(sentence: Sequence[Token]) -> None:
    """Refuse "10 cm left of the blue block and 10 cm behind it": how far two blocks are apart is told once."""
    if _ASLANT.search(" ".join(token.word for token in sentence)):
        raise refuse("misplaced", "how far aside and how far behind cannot both be told of two blocks",
                     (sentence[0].span[0], sentence[-1].span[1]), "say how far apart they are")  # fmt: skip


_LISTED_FROM = on_demand(
    r"(?:\bfrom (?:the )?(?:left|right|top|bottom)|(?<!\brows )\bfrom (?:the )?(?:front|back))(?: to (?:the )?\w+)? :"
)


def _listed_from(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "order from left: gray, white, cyan. It is a row" as a row in any order."""
    if not _LISTED_FROM.search(" ".join(token.word for token in sentence)):
        return
    found = [x for part in (task.goal, *task.init.arranged) for x in atoms(part)]
    if any(isinstance(x, Row | Stack) for x in found) and not any(_ends(x) for x in found):
        raise refuse("misplaced", "this lists blocks in an order, and nothing has one", sentence[0].span,
                     "say the order where the row is told")  # fmt: skip


def _corner_of(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "build a 2x2 grid. The blue block is in the far left corner" as of a corner of the table."""
    corner = next((token for token in sentence if token.word == "corner"), None)
    if corner is None or not _TABLE.isdisjoint(token.word for token in sentence):
        return
    found = list(atoms(task.goal))
    figures = [{*members(x.blocks)} for x in found if isinstance(x, Grid | Figure)]
    cornered = [{*members(x.a)} for x in found if isinstance(x, InRegion) and x.region.endswith("corner")]
    if any(blocks < figure for blocks in cornered for figure in figures):
        raise refuse("ambiguous", "a corner of the table, or of what is built?", corner.span,
                     "say 'of the table' or 'of the grid'")  # fmt: skip


_TABLE = frozenset(lexicon.TABLE_NOUNS.split())
_POLITE = frozenset({"please", "and", "but", "then", "always", "just"})
_BEGIN = frozenset({"begin", "start"})
_ARTICLES = frozenset({"the", "a", "one", "ones", "of", "with", "from"})
_IS_FIRST = on_demand(r"(?:the )?first (?:one |block |cube )?(?:is|are|must be|should be|comes|to be|goes) ")


def _begun_with(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put red next to blue, and green next to white. Begin with the green block" as in any order."""
    said = [token for token in sentence if token.word not in _POLITE | STOPS]
    is_first = _IS_FIRST.match(" ".join(token.word for token in said))
    leads = len(is_first[0].split()) if is_first else 2
    begins = len(said) > 2 and said[0].word in _BEGIN and said[1].word in ("with", "from")
    if not (begins or is_first):
        return
    rest = [token for token in said[leads:] if token.word not in _ARTICLES]
    looks = {lexicon.COLOR.get(t.word) or t.raw.upper() for t in rest if t.word not in lexicon.BLOCK}
    first = {block.name for block in task.blocks if looks & _looks(block)}
    if len(looks) == 1 and first and not _comes_first(first, task):
        raise refuse("misplaced", "nothing here has a beginning with which this could be done", said[0].span,
                     "say what is done first, and what then")  # fmt: skip


_DONE = frozenset({"moved", "placed", "put", "brought", "stacked", "taken", "lifted", "set", "laid"})


def _done_first(sentence: Sequence[Token], before: Sequence[Sequence[Token]], task: TaskSchema) -> None:
    """Refuse "put red on the mat. First put blue on green" as in any order."""
    said = [token for token in sentence if token.word not in _POLITE | STOPS | {","}]
    if len(said) < 3 or said[0].word != "first" or _stages(task.goal):
        return
    done = said[1].word in _ARTICLES and not _DONE.isdisjoint(token.word for token in said)
    if said[1].word not in lexicon.COMMANDS and not done:
        return
    if done or any(token.word in lexicon.COMMANDS for one in before for token in one[:1]):
        raise refuse("misplaced", "it is not clear what is done first, and what then", said[0].span,
                     "say 'first ..., then ...'")  # fmt: skip


_PATCHES = frozenset(lexicon.PATCH_NOUNS.split())
_ALSO = on_demand(r"there (?:is|are) also (?:a|an|one) ")


def _also_there(sentence: Sequence[Token], before: Sequence[Sequence[Token]], task: TaskSchema) -> None:
    """Refuse "stack yellow on red. There is also a yellow block" as of the one that was told of."""
    also = _ALSO.match(" ".join(token.word for token in sentence))
    if also is None or len(sentence) < 5 or not {"distractor", "distractors"}.isdisjoint(t.word for t in sentence):
        return
    look = lexicon.COLOR.get(sentence[4].word) or sentence[4].raw
    told = {lexicon.COLOR.get(token.word) or token.raw for one in before for token, behind in pairwise([*one, one[-1]])
            if behind.word not in _PATCHES}  # fmt: skip
    if look in told and sum(look in _looks(block) for block in task.blocks) == 1:
        raise refuse("ambiguous", "another one, or the one that was told of?", sentence[4].span,
                     "say how many such blocks there are, and put 'one of them'")  # fmt: skip


_THERE = on_demand(r"(?:there (?:is|are) .+ there|at the start ,? ?(?!there ).+ (?:is|are) there)(?: now| right now)?$")
_PLACES = _PATCHES | {"half", "corner", "middle", "edge"}


def _there_at_first(sentence: Sequence[Token], before: Sequence[Sequence[Token]], task: TaskSchema) -> None:
    """Refuse "put red on the mat. There is a blue block there" with the blue block anywhere at the start."""
    said = [token for token in sentence if token.word not in STOPS]
    if not _THERE.match(" ".join(token.word for token in said)):
        return
    place = any(token.word in _PLACES for one in before for token in one)
    looks = {lexicon.COLOR.get(token.word) or token.raw for token in said}
    those = {block.name for block in task.blocks if looks & _looks(block)}
    if place and those and not those <= {name for part in task.init.arranged for name in names(part)}:
        raise refuse("misplaced", "it is not read where these are at the start", (said[0].span[0], said[-1].span[1]),
                     "say 'at the start' and name the place")  # fmt: skip


def _looks(block: Block) -> set[str]:
    return {block.color, *symbols_of(block)}


def _comes_first(blocks: set[str], task: TaskSchema) -> bool:
    """Whether one of some blocks is at an end of a line, or is dealt with in a first stage, or is no matter at all."""
    for part in (task.goal, *task.init.arranged):
        for atom in atoms(part):
            ranks = _ends(atom)
            if any(blocks & {*rank} for rank in ranks):
                return True
    stages = _stages(task.goal)
    return bool(stages) and bool(blocks & {*names(stages[0])})


def _stages(goal: g.Goal) -> list[g.Goal]:
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    return [stage.goal for part in parts if isinstance(part, g.Sequence) for stage in part.stages]


def _ends(atom: g.Goal) -> list[tuple[str, ...]]:
    """The blocks at either end of what is ordered, as far as it is told."""
    order = getattr(atom, "order", None) or getattr(getattr(atom, "pattern", None), "order", None)
    if not isinstance(order, Order):
        if not isinstance(atom, Spells | Equation):
            return []
        read = members(getattr(atom, "blocks", ()))
        return [read[:1], read[-1:]] if getattr(atom, "reverse", False) else [read[:1]]
    if order.by == "given" and order.ranks:
        return [order.ranks[0], order.ranks[-1]]
    return [members(getattr(atom, "blocks", ()))] if order.by != "any" else []


_FREE = frozenset({"matter", "matters", "any", "free", "irrelevant", "important", "regardless", "unimportant", "random",
                   "whatever", "whichever", "open", "particular", "importance", "care", "relevant"})  # fmt: skip
_ORDERED = frozenset({"label", "number", "size", "rainbow"})


def _no_order(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "spell CAT. The order does not matter"."""
    said = {token.word: token for token in sentence}
    if "order" not in said or _FREE.isdisjoint(said) or not {"rest", "others", "other"}.isdisjoint(said):
        return
    found = [x for part in (task.goal,) for x in atoms(part)]
    ordered = _ORDERED | ({"given"} if task.assumed("the order is read from") else set())
    asked = [x for x in found if isinstance(x, Spells | Equation) or _order_by(x) in ordered]
    if asked and not any(_order_by(x) == "any" and isinstance(x, Row | Stack) for x in found):
        raise refuse("contradiction", "the order is told, and yet it is not to matter", said["order"].span,
                     "leave one of them out")  # fmt: skip


def _order_by(atom: g.Goal) -> str:
    order = getattr(atom, "order", None)
    return order.by if isinstance(order, Order) else ""


_SUBJECTS = frozenset({"they", "these", "those", "blocks", "cubes", "colors", "of", "them", "all", "the", "and",
                       "should", "must", "be", "are", "have", "color", "each", "has", "a", "completely", "both",
                       "with"})  # fmt: skip


def _all_different(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "build a tower of three red blocks. They are all different"."""
    words = [token.word for token in sentence if token.word not in STOPS]
    at = next((n for n, word in enumerate(words) if word == "different"), 0)
    if not at or not _SUBJECTS.issuperset([*words[:at], *words[at + 1 :]]):
        return
    used = {*names(task.goal)}
    looks = [(block.color, *sorted(symbols_of(block)), block.size) for block in task.blocks if block.name in used]
    if len({*looks}) < len(looks):
        raise refuse("contradiction", "some of these look alike", sentence[at].span, "say how each of them looks")


_IN_DIFFERENT = on_demand(
    r", (?:(?:all )?(?:in|of) (?:all )?different colors|each (?:in|of) an? (?:different|other) color)(?= [.;!?]|$)"
)


def _in_different_colors(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a tower of three red blocks, in different colors"."""
    colors = [block.color for block in task.blocks if block.name in {*names(task.goal)}]
    told = _IN_DIFFERENT.search(" ".join(token.word for token in sentence))
    if told is not None and len(colors) > 1 == len({*colors}):
        raise refuse("contradiction", "these are all of one color", sentence[-1].span, "say which colors they have")


_ACROSS = {"left": "y", "right": "y", "front": "x", "back": "x", "bottom": "z", "top": "z", "near": "x", "far": "x"}


_CORRECTING = frozenset({"same", "rather", "correction", "instead", "sorry", "mean", "meant", "wait", "actually", "no",
                         "palindrome"})  # fmt: skip
"""What leads to another way that is told for the first one, or beside it."""


def _one_way(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "line up five blocks from left to right. From front to back" as one of the two."""
    if not _CORRECTING.isdisjoint(token.word for token in tokens):
        return
    words = [token for token in tokens if token.word != "the"]
    words = [
        token for before, token in zip([None, *words], words, strict=False) if not (before and before.word == "not")
    ]
    ways: dict[tuple[str, str], Span] = {}
    for lead, start, to, end in zip(words, words[1:], words[2:], words[3:], strict=False):
        axis = _ACROSS.get(start.word)
        if (
            lead.word == "from"
            and to.word == "to"
            and axis
            and axis == _ACROSS.get(end.word)
            and start.word != end.word
        ):
            ways.setdefault((axis, start.word), (lead.span[0], end.span[1]))
    lines = [x for part in (task.goal, *task.init.arranged) for x in atoms(part) if getattr(x, "blocks", ())]
    alone = len(lines) == 1 and isinstance(lines[0], Row | Stack | Spells | Equation)
    if len(ways) > 1 and alone and len({axis for axis, _ in ways}) < len(ways) + isinstance(lines[0], Row):
        raise refuse("contradiction", "a line goes one way", [*ways.values()][-1], "leave one of them out")


def _too(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put red to the left of blue and the green one too" as left of both: is it green that is there, too?"""
    said = [token for token in sentence if token.word not in STOPS]
    words = [token.word for token in said]
    end = len(words) - (2 if words[-2:] == ["as", "well"] else 1)
    if (words[-1:] != ["too"] and end != len(words) - 2) or "and" not in words:
        return
    joint = len(words) - 1 - words[::-1].index("and")
    comma = max((n + 1 for n in range(joint) if words[n] == ","), default=joint)
    if len(_look_words(said[comma:joint])) == 1:
        return  # "A and B touch, C and D too": as these do
    behind = said[joint + 1 : end]
    looks = _look_words(behind)
    those = {block.name for block in task.blocks if len(looks) == 1 and looks & _looks(block)}
    told = [x for x in atoms(task.goal) if those & {*names(x)}]
    if those and told and all(hasattr(x, "b") and those & {*members(x.b)} for x in told):
        raise refuse("ambiguous", "is this one there, too, or what the others are next to?", behind[0].span,
                     "say it in a sentence of its own")  # fmt: skip


def _look_words(tokens: Sequence[Token]) -> set[str]:
    """What these words say but for articles and nouns: the colours and symbols, where they name blocks alone."""
    told = (t for t in tokens if t.word not in _ARTICLES and t.word not in lexicon.BLOCK)
    return {lexicon.COLOR.get(t.word) or t.raw for t in told}


def _reversed(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "sort the red and blue blocks by color in reverse order", where nothing is in any order."""
    for order, before in zip(sentence[1:], sentence, strict=False):
        if order.word != "order" or before.word not in ("reverse", "reversed", "opposite", "inverse"):
            continue
        found = [x for part in (task.goal, *task.init.arranged) for x in atoms(part)]
        kinds = {_order_by(x) for x in found} - {"", "any", "together"}
        if not kinds and not any(isinstance(x, Spells | Equation) or hasattr(x, "up") for x in found):
            raise refuse("misplaced", "there is no order here that could be reversed", before.span,
                         "say which comes first")  # fmt: skip


def _at_an_end(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "line up A, B and C, the red one first" with the red one anywhere in the line."""
    said = [token for token in sentence if token.word not in STOPS]
    if (
        len(said) < 5
        or said[-1].word not in ("first", "last")
        or said[-2].word not in ("one", "ones", "block", "blocks")
    ):
        return
    look, article, comma = said[-3], said[-4], said[-5]
    color = lexicon.COLOR.get(look.word)
    those = {block.name for block in task.blocks if color is not None and block.color == color}
    if article.word == "the" and comma.word == "," and those and not _comes_first(those, task):
        raise refuse("misplaced", "nothing here has such an end", said[-1].span, "say in which order they should be")
