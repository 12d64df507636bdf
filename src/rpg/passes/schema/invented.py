"""Blocks that nobody named: what a task adds to the words must have been left open by them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, takewhile

from rpg.ir.assets import FACES, SemanticCube
from rpg.ir.goal import Not
from rpg.ir.node import members
from rpg.ir.relations import Between
from rpg.ir.schema import COLORS_UNSAID, SYMBOLS_UNSAID, TaskSchema
from rpg.ir.structures import Cells, Equation, Figure, Grid, Pyramid, Row, Spells, Stack
from rpg.ir.walk import atoms, names, within
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.fewer_there import check_fewer_there
from rpg.passes.schema.listed_as_counted import check_listed_as_counted
from rpg.passes.schema.resolve.things.world import refuse
from rpg.passes.schema.stock_told import check_stock

_OPEN = frozenset({"anything", "everything", "all", "each", "any", "rest", "them", "one", "ones", "other", "others",
                   "another", "something", "cover", "uncover", "distractor", "distractors", "piece", "pieces",
                   "letter", "letters", "digit", "digits",
                   *lexicon.BLOCK, *lexicon.STRUCTURE})  # fmt: skip
"""What may speak of blocks without saying how they look."""
_NUMBERED = frozenset({"step", "stage", "task", "number"})
"""What stands before a number that counts nothing: "step two green on red"."""


def check_invented(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse blocks of which nothing was said, and fewer or more of a colour than were counted."""
    _as_many_as_said(words, task)
    _one_of_its_look(words, task)
    _so_many_of_them(words, task)
    _one_of_those(words, task)
    _rainbow_beside(words, task)
    _rainbow_between(words, task)
    _made_up_beside(words, task)
    _one_word(task)
    _counts_with_a_slash(words, task)
    _sum_of_colors(words, task)
    _ones_beside_patches(words, task)
    if task.assumed(SYMBOLS_UNSAID):
        _ascending(words, task)
    check_stock(words, task)
    check_listed_as_counted(words, task)
    _listed_in_turn(words, task)
    if task.assumed(_NUMBER_UNSAID):
        _lines_of_the_counted(words)
    if task.assumed(COLORS_UNSAID):
        _spoken_of(words, task)
        _set_off(words)
        _as_many_named(words, task)
        _named_bare(words, task)
        _counted_bare(words, task)
        _of_the_counted(words, task)
        _of_those_left(words, task)
        _one_in_between(words, task)
        check_fewer_there(words, task)


def _listed_in_turn(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "the row is mirrored: red, blue, white, blue, red" as a row that is mirrored in some way."""
    lines = [x for x in atoms(task.goal) if isinstance(x, Row | Stack) and x.order.by in ("mirrored", "alternating")]
    for line in lines:
        for n, token in enumerate(words):
            told = [*takewhile(lambda x: x.word in lexicon.COLOR or x.word in (",", "and"), words[n + 1 :])]
            colors = [x.word for x in told if x.word in lexicon.COLOR]
            if token.word == ":" and len({*colors}) < len(colors) == len(line.blocks):
                raise refuse("ambiguous", "in exactly this order, or in any such order?", told[0].span,
                             "say 'in this order'")  # fmt: skip


def _one_in_between(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of A, B, C and D with one block between A and D" as a fifth block of any colour."""
    said = {lexicon.COLOR.get(token.word) for token in words}
    made_up = {block.name for block in task.blocks if block.color not in said and not isinstance(block, SemanticCube)}
    found, denied = [*atoms(task.goal)], [x.goal for x in within(task.goal) if isinstance(x, Not)]
    lines = [{*x.blocks} for x in found if isinstance(x, Row | Stack) and len(x.blocks) > 2 and x not in denied]
    for between in (x for x in found if isinstance(x, Between) and {*members(x.a)} <= made_up):
        ends = {*members(between.b), *members(between.c)}
        if any(ends <= line and line.isdisjoint(members(between.a)) for line in lines):
            raise refuse("ambiguous", "this could be one of the blocks of the line, or a further one", between.span,
                         "name the block")  # fmt: skip


def _rainbow_beside(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "four cubes in rainbow order, red, yellow, green, blue" as these and an orange one."""
    said = [token for token in words if token.word in lexicon.COLOR]
    named = {lexicon.COLOR[token.word] for token in said}
    run = any("a run of the rainbow" in note for note in task.assumptions)
    colors = {block.color for block in task.blocks}
    if run and len(named & colors) > 1 and colors - named:
        raise refuse("ambiguous", "are these the blocks that were counted, or further ones?", said[0].span,
                     "list them where they are counted: 'a row of three: red, white and blue'")  # fmt: skip


def _rainbow_between(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a rainbow with red at the front and purple at the back" as these two, and "in rainbow order with purple
    at the bottom" as others on a purple one."""
    ends = [
        one for one, at in pairwise(words) if one.word in lexicon.COLOR and at.word in ("at", "on", "first", "last")
    ]
    named = [lexicon.COLOR[token.word] for token in words if token.word in lexicon.COLOR]
    told = {lexicon.COLOR[one.word] for one in ends if named.count(lexicon.COLOR[one.word]) == 1}
    open_ = any("a run of the rainbow" in note for note in task.assumptions)
    led = any(token.word in ("with", "starting") for token in words)
    for line in (x for x in atoms(task.goal) if isinstance(x, Row | Stack) and x.order.by == "rainbow"):
        inside = {block.color for block in task.blocks if block.name in line.blocks}
        beyond = any(block.color in told and block.name not in line.blocks for block in task.blocks)
        if led and (inside <= told or (open_ and beyond)):
            raise refuse("ambiguous", "it is not said which colours the rainbow has", ends[0].span,
                         "list its blocks: 'a rainbow of red, yellow and blue'")  # fmt: skip


def _one_of_its_look(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a white block has a red one on its left and a blue one on its right" as two white ones."""
    told = [token.word for token in words]
    counted = any(lexicon.NUMBER.get(word, 0) > 1 or (word.isdigit() and word != "1") for word in told)
    on_both = any({first, last} == {"left", "right"} and joint == "and" for first, joint, last in _joined(told))
    further = any(joint in ("and", ",") and one == "one" for joint, one in pairwise(told))  # "... and one on the mat"
    further |= any(other == "other" and look not in lexicon.COLOR for other, look in pairwise([*told, ""]))
    if counted or on_both or further or not _SEVERAL.isdisjoint(told):
        return
    said = [lexicon.COLOR.get(token.word) or lexicon.COLOR_PLURAL.get(token.word) for token in words]
    for before, token, noun in zip(words, words[1:], words[2:], strict=False):
        color = lexicon.COLOR.get(token.word)
        single = before.word in ("a", "an", "one", "the") and lexicon.BLOCK.get(noun.word) is False
        if color and single and said.count(color) == 1 and sum(block.color == color for block in task.blocks) > 1:
            raise refuse("ambiguous", f"it is not clear how many {token.word} blocks there are", token.span,
                         "say it in two sentences, and 'the' of a block that was spoken of")  # fmt: skip


def _joined(told: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Three words in a row, those between them left out that tell no more: "to the left and to the right"."""
    kept = [word for word in told if word not in ("the", "to", "on", "its", "of")]
    return zip(kept, kept[1:], kept[2:], strict=False)


_SEVERAL = frozenset({"same", "own", "each", "every", "both", "all", "per", "any", "another", "pair", "pairs",
                      "alternate", "alternating", "mirrored", "symmetric", "ends", "either", "turns", "more",
                      "further"})  # fmt: skip
"""Where one of these stands, what is named once may be there several times."""


def _so_many_of_them(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "three blocks. Two of them are red, and the blue one ..." as three red ones and a blue one."""
    for index, token in enumerate(words):
        many = lexicon.NUMBER.get(token.word, 0)
        rest = [t.word for t in words[index + 1 : index + 1 + _CLAIM]]
        if many < 1 or rest[:2] not in (["of", "them"], ["of", "these"], ["of", "those"]) or len(rest) < _CLAIM:
            continue
        look = lexicon.COLOR.get(rest[3]) if rest[2] in ("are", "is", "must", "should") else None
        if look is not None and sum(block.color == look for block in task.blocks) > many:
            raise refuse("ambiguous", f"it is not clear which the {token.word} {rest[3]} ones are", token.span,
                         "say of all blocks how many there are of each colour")  # fmt: skip


_CLAIM = len(("of", "them", "are", "red"))
"""The words behind a number that say how so many of them look."""


def _one_of_those(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "three white cubes stand in a row. There is one white one between ..." as a fourth white one."""
    for n in range(1, len(words) - 1):
        color = lexicon.COLOR.get(words[n].word)
        if color is None or words[n - 1].word != "one" or words[n + 1].word != "one":
            continue
        counts = [lexicon.NUMBER.get(a.word, 0) for a, b in pairwise(words[:n]) if lexicon.COLOR.get(b.word) == color]
        there = sum(block.color == color for block in task.blocks)
        if counts and 1 < max(counts) < there:
            raise refuse("ambiguous", "this could be one of the blocks before it, or a further one", words[n].span,
                         "say 'one of them', or 'another'")  # fmt: skip


def _counted_bare(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "four white cubes and a black one form a tower. Exactly one cube lies above the black one" as a cube that
    nobody named."""
    of_blocks = [t for t, after in pairwise(words) if t.word in lexicon.COLOR and after.word not in lexicon.PATCH]
    colors = {lexicon.COLOR[token.word] for token in of_blocks}
    told = any(block.color in colors for block in task.blocks)
    made_up = any(block.color not in colors for block in task.blocks if not isinstance(block, SemanticCube))
    for exactly, number, noun in zip(words, words[1:], words[2:], strict=False):
        counted = exactly.word in ("exactly", "only", "just") and number.word in lexicon.NUMBER
        if told and made_up and counted and noun.word in lexicon.BLOCK:
            raise refuse("ambiguous", "these could be of the blocks before them, or further ones", noun.span,
                         "say how they look, or 'of them'")  # fmt: skip


def _of_the_counted(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a tower of three blocks. The white block is on the red one" as a tower with the red one in it, two blocks
    of made-up colours, and the white one beside it."""
    said = {lexicon.COLOR.get(token.word) for token in words}
    plain = [block for block in task.blocks if not isinstance(block, SemanticCube)]
    made_up = sum(block.color not in said for block in plain)
    for number, noun in pairwise(words):
        many = lexicon.NUMBER.get(number.word, 0) if noun.word in lexicon.BLOCK else 0
        named = [token for token in words if token.span > noun.span and token.word in lexicon.COLOR]
        if made_up < many < len(plain) and made_up and len({token.word for token in named}) > 1:
            raise refuse("ambiguous", "are these of the blocks that were counted, or further ones?", named[0].span,
                         "say how all of those look that are counted")  # fmt: skip


def _one_word(task: TaskSchema) -> None:
    """Refuse "a word down a stack: SUN" as some word and the word SUN."""
    spelt = [atom for atom in atoms(task.goal) if isinstance(atom, Spells)] if task.assumptions else []
    if len(spelt) > 1 and task.assumed("the word is not said"):
        raise refuse("ambiguous", "is this the word, or one more?", spelt[-1].span, "say 'the word' in front of it")


def _counts_with_a_slash(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "each white block on a black one (3/3)" with the cubes 3, / and 3 beside them."""
    slash = next((token for token in words if token.word == "/"), None)
    if slash is None:
        return
    spoken_of = set(names(task.goal))
    idle = [b for b in task.blocks if isinstance(b, SemanticCube) and b.name not in spoken_of]
    if any("/" in map(block.symbol, FACES) for block in idle):
        raise refuse("ambiguous", "so many of each, or cubes that show these numbers?", slash.span,
                     "say 'three of each'")  # fmt: skip


def _sum_of_colors(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a sum: 3 = red" as a sum with a red 3 in it."""
    for sign, color in pairwise(words):
        sign, color = (color, sign) if color.kind == "sign" else (sign, color)
        told = sign.kind == "sign" and sign.word in _SIGNS and color.word in lexicon.COLOR
        if told and any(isinstance(atom, Equation) for atom in atoms(task.goal)):
            raise refuse("misplaced", f"{color.raw!r} is no number", color.span,
                         "say which numbers the sum has, as in '3 + 2 = 5', and then their colour")  # fmt: skip


_SIGNS = frozenset("+-*/=")


def _ascending(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "an ascending pyramid" as one of numbers, which nobody brings up: pyramids and walls go up anyway."""
    cells = [x for x in atoms(task.goal) if isinstance(x, Grid | Pyramid | Figure) and x.pattern is not None]
    told = next((token for token in words if token.word in _RISING), None)
    if cells and told is not None and _SYMBOLS.isdisjoint(token.word for token in words):
        raise refuse("ambiguous", "it is not said what goes up or down here", told.span,
                     "say 'with the numbers in ascending order', or which way it goes up")  # fmt: skip


_RISING = frozenset({"ascending", "descending", "increasing", "decreasing"})
_SYMBOLS = frozenset({"number", "numbers", "numbered", "digit", "digits", "letter", "letters", "alphabetical"})


def _ones_beside_patches(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "on any patch; there is a pink one and a gray one" as made-up patches and two blocks, and "a square of
    blocks, and a block beside the square" as such a square and a patch."""
    if not task.assumed("the colour of the patch is not said"):
        return
    figures = [token for token in words if token.word in ("square", "circle", "rectangle")]
    if len(figures) > 1 and not any(token.word in lexicon.PATCH for token in words):
        raise refuse("ambiguous", "is this the figure, or a patch?", figures[-1].span, "say 'the square patch'")
    spoken_of = {name for part in (task.goal, *task.init.arranged) for name in names(part)}
    idle = {str(block.color) for block in task.blocks if block.name not in spoken_of}
    for color, one in pairwise(words):
        if one.word in ("one", "ones") and lexicon.COLOR.get(color.word) in idle:
            raise refuse("ambiguous", "is this a block or a patch?", color.span, f"say 'a {color.word} patch'")


_NUMBER_UNSAID = "the number of blocks is not said"
_MADE_UP = ("the colours are not said", _NUMBER_UNSAID)
"""What is noted of blocks that the words leave open."""


def _as_many_as_said(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two pink ones and two gray ones" as three of one and one of the other, and "checkerboard, 2 red and 2
    black" as these and others that are red."""
    for index, (number, color) in enumerate(pairwise(words)):
        look = lexicon.COLOR.get(color.word) or lexicon.COLOR_PLURAL.get(color.word)
        many = lexicon.NUMBER.get(number.word, 0) if number.kind == "word" else number.value
        other = index and words[index - 1].word in _NUMBERED
        other = other or any(t.word in lexicon.STRUCTURE for t in words[index + 2 : index + 3])  # "two red towers"
        if look is None or other or not isinstance(many, int | float) or many < 2:
            continue
        blocks = sum(block.color == look for block in task.blocks)
        patches = sum(patch.color == look for patch in task.patches)
        made_up = any(note.startswith(_MADE_UP) for note in task.assumptions)
        if blocks and _but_a_part(words[index + 2 :], task, many):
            continue
        if max(blocks, patches) < many or (made_up and blocks > many):
            raise refuse("ambiguous", f"it is not clear which the {many:g} {color.word} ones are", number.span,
                         "say of all blocks how many there are of each colour")  # fmt: skip


def _but_a_part(behind: Sequence[Token], task: TaskSchema, many: float) -> bool:
    """ "(Five red) blocks in a row, but the middle one is blue": five are in it."""
    whole = any(isinstance(x, Row | Stack | Cells) and len(x.blocks) == many for x in atoms(task.goal))
    return whole and not _BUT.isdisjoint(token.word for token in behind)


_BUT = frozenset({"but", "except", "only", "instead", "save", "though", "however", "being"})


def _made_up_beside(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "each colour on its own mat: red on red, blue on blue" as these and a green block that nobody named."""
    if not task.assumptions:
        return
    kinds = ("blocks", "digit blocks", "letter blocks")
    unsaid = any(task.assumed(f"the number of {kind} is not said") for kind in kinds)
    if not unsaid or not (task.assumed(COLORS_UNSAID) or task.assumed(SYMBOLS_UNSAID)):
        return
    shown = {getattr(block, "label", "") for block in task.blocks} - {"", "A", "I"}  # these are words as well
    looks = {block.color for block in task.blocks}
    named = [t for n, t in enumerate(words) if not _of_patches(words[n + 1 :])]
    said = [t for t in named if t.raw in shown or lexicon.COLOR.get(t.word) in looks]
    told = [t for t in said if t.raw in shown or not task.assumed(SYMBOLS_UNSAID)]
    if told:
        raise refuse("ambiguous", "some blocks are named, and of others neither number nor look is said",
                     told[0].span, "say of all blocks how many there are, or name them")  # fmt: skip


def _of_patches(behind: Sequence[Token]) -> bool:
    """Whether a colour that stands before these words is that of a patch: "(red) and blue patches"."""
    noun = next((t for t in behind if t.word not in _LISTED and t.word not in lexicon.COLOR), None)
    return noun is not None and noun.word in lexicon.PATCH


_LISTED = frozenset({"and", "the", "a", ","})


def _spoken_of(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a block without a colour where a colour stands before every word for a block."""
    nouns = [(before, t) for before, t in pairwise(words) if t.word in _OPEN]
    colored = [t for before, t in nouns if before.word in lexicon.COLOR]
    if colored and len(colored) == len(nouns) and words[0].word not in _OPEN:
        raise refuse("ambiguous", "it is not said of which block this is to be so", colored[0].span, "name the block")


def _as_many_named(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "three blocks in a row. Red, white and blue must touch ..." as three others beside the red, white and blue
    ones."""
    said = [lexicon.COLOR.get(token.word) for token in words]
    made_up = sum(block.color not in said for block in task.blocks if not isinstance(block, SemanticCube))
    run: list[Token] = []
    for token, color in zip((*words, Token("punct", ".", ".", (0, 0))), (*said, None), strict=True):
        if color is not None:
            run.append(token)
        elif token.word not in (",", "and"):
            if len(run) == made_up > 1 and len({lexicon.COLOR[t.word] for t in run}) == made_up:
                raise refuse("ambiguous", "are these the blocks that were counted, or further ones?", run[0].span,
                             "list them where they are counted: 'a row of three: red, white and blue'")  # fmt: skip
            run = []


def _named_bare(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a tower of three in which red is under blue but above green" as one of red, blue and another."""
    said = {lexicon.COLOR.get(token.word) for token in words}
    looks = {block.name: block.color for block in task.blocks if not isinstance(block, SemanticCube)}
    nouns = _OPEN | lexicon.COLOR.keys()
    bare = {lexicon.COLOR.get(t.word): t for t, after in pairwise(words) if after.word not in nouns}
    for line in (x for x in atoms(task.goal) if isinstance(x, Stack | Row) and {*x.blocks} <= looks.keys()):
        made_up = [name for name in line.blocks if looks[name] not in said]
        others = [color for name, color in looks.items() if name not in line.blocks]
        if 0 < len(made_up) == len(others) < len(line.blocks) and {*others} <= bare.keys():
            raise refuse("ambiguous", "is this one of the blocks that were counted, or a further one?",
                         bare[others[0]].span, "say how each of the blocks looks")  # fmt: skip


def _lines_of_the_counted(words: Sequence[Token]) -> None:
    """Refuse "two rows of three, a red row in front and a blue row at the back" as two rows of three and others."""
    counted = ""
    one = False
    for token in words:
        kind, several = lexicon.STRUCTURE.get(token.word, ("", False))
        if token.word in (".", ";"):
            counted = ""
        elif kind == counted != "" and not several and one:
            raise refuse("ambiguous", "is this one of those that were counted, or a further one?", token.span,
                         "say of each of them how it is: 'the front row is red'")  # fmt: skip
        elif kind and several:
            counted = kind
        one = token.word in ("a", "one") or (one and token.word in lexicon.COLOR)


def _of_those_left(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "five yellow cubes: a tower of three, a tower of two" as three of them and two others."""
    spoken_of = {name for part in (task.goal, *task.init.arranged) for name in names(part)}
    used = {str(block.color) for block in task.blocks if block.name in spoken_of}
    left = {str(block.color) for block in task.blocks if block.name not in spoken_of} & used
    told = [token for token in words if lexicon.COLOR.get(token.word) in left]
    if told:
        raise refuse("ambiguous", f"it is not clear what the {told[0].word} blocks are for of which so many are there",
                     told[0].span, "say of which blocks each part is")  # fmt: skip


def _set_off(words: Sequence[Token]) -> None:
    """Refuse "a tower of two and a tower of three, pink" as a tower of three pink ones and one of made-up colours."""
    shown = [*(t for t in words if t.word not in ("all", "both")), Token("punct", ".", ".", (0, 0))]
    for n in range(2, len(shown) - 1):
        before, comma, color, after = shown[n - 2 : n + 2]
        alone = comma.word == "," and after.kind == "punct" and after.word not in ("'s", ":")
        listed = any(t.word in lexicon.COLOR for t in (before, *shown[n + 2 : n + 3]))
        if color.word in lexicon.COLOR and alone and not listed:
            raise refuse("ambiguous", "is this the colour of all of them, or of the last ones?", color.span,
                         "put the colour in front of what has it: 'a pink tower'")  # fmt: skip
