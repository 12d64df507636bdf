"""Words that join or part blocks, "two towers: A, B and C, D": they must come to something in the task."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, pairwise

from rpg.ir import goal as g
from rpg.ir.assets import FACES, SemanticCube
from rpg.ir.node import members
from rpg.ir.relations import Behind, InFrontOf, InRegion, On, OnPatch, Stayed, Turned
from rpg.ir.schema import COLORS_BARRED, COLORS_UNSAID, SYMBOLS_UNSAID, TaskSchema
from rpg.ir.structures import Equation, Figure, Grid, GroupBy, Row, Spells, Stack, Towers
from rpg.ir.walk import atoms, children, names
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.by_turns import ALTERNATE, alternating, in_turn
from rpg.passes.schema.resolve.things.world import refuse
from rpg.passes.schema.stacked_at_last import stacked_at_last
from rpg.passes.schema.worked_out import asked_for

_ANEW = frozenset({"other", "others", "another", "more", "further", "new", "separate", "second", "too", "also"})
"""What says that a second word is of other cubes than the first."""
_TOWERS = frozenset({"towers", "stacks", "piles"})
_ENDS = frozenset({".", ";", "!", "?", "(", ")"})


def check_joints(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse what joins, or tells apart, blocks in a way that nothing in the task shows."""
    said = {token.word for token in words}
    for joints, check in _CHECKS:
        if joints is None or not said.isdisjoint(joints):
            check(words, task)
    _strangers(task)


_NO_CHOICE = frozenset({"more", "less", "fewer", "higher", "longer", "farther", "further", "minus", "take", "so",
                        "greater", "bigger", "larger", "smaller", "lower"})  # fmt: skip
"""What follows an "or" that is part of a measure: "20 cm or more", "give or take 5 mm"."""
_SORTS = frozenset({"vowel", "parity", "kind"})


def _left_open(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put A and B on red or blue respectively" as both: what "or" leaves open, the goal must leave open too."""
    said = [one for one, then in pairwise(words) if one.word == "or" and then.word not in _NO_CHOICE]
    said = [one for one in said if not asked_for(words, one) and not _how_far(_before(words, one)[-3:])]
    if not said or any(isinstance(x, GroupBy) and x.by in _SORTS for x in atoms(task.goal)):
        return
    denied = any(not _DENIED.isdisjoint(t.word for t in _before(words, one)) for one in said)
    if denied and any(isinstance(x, Stayed | Turned) for x in atoms(task.goal)):  # "without moving A or B"
        return
    none = any("none" in (t.word for t in _before(words, one)) for one in said)
    if (denied or none) and task.assumed(COLORS_BARRED):  # "none of them is red or blue"
        return
    if not any(isinstance(x, g.Any | g.Count | g.Not) for x in _nodes(task.goal)):
        raise refuse("ambiguous", "it is not clear what 'or' leaves open here", said[0].span,
                     "say 'and', or name one of them")  # fmt: skip


def _how_far(before: Sequence[Token]) -> bool:
    """ "(no matter) how far left (or right)": what is left open is no part of the task."""
    said = {token.word for token in before}
    return "far" in said and not said.isdisjoint({"how", "however"})


_DENIED = frozenset({"not", "without", "never", "neither"})


def _before(words: Sequence[Token], one: Token) -> list[Token]:
    """The words of the sentence that stand before one of it."""
    at = next(n for n, token in enumerate(words) if token is one)
    begin = max((n + 1 for n in range(at) if words[n].word in _ENDS), default=0)
    return [*words[begin:at]]


def _strangers(task: TaskSchema) -> None:
    """Refuse "a white group and a black group, but with a stranger in each" as a white group and others with these."""
    groups = [x for x in atoms(task.goal) if isinstance(x, GroupBy)]
    for one, two in combinations(groups, 2):
        if {*names(one)} & {*names(two)} and one.outliers != two.outliers:
            odd = one if one.outliers else two
            raise refuse("ambiguous", "it is not clear in which groups the strangers are", odd.span,
                         "say 'sorted by colour with one stranger in each group'")  # fmt: skip


def _nodes(goal: g.Goal) -> Iterator[g.Goal]:
    yield goal
    for child in children(goal):
        yield from _nodes(child)


def _letters_of_words(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "write NO with blue letters on the mat" as a word and a blue letter that nobody named."""
    made_up = task.assumed(SYMBOLS_UNSAID)
    spelt = read = {n for atom in atoms(task.goal) if isinstance(atom, Spells) for n in atom.blocks}
    if not read:
        return
    shown = {asset.name for asset in task.assets if isinstance(asset, SemanticCube)}
    spelt = spelt if ({*names(task.goal)} - spelt) & shown else set()
    said = next((t for t in words if t.word in ("letter", "letters", "digits", "numbers")), None)
    if made_up and spelt and said is not None:
        raise refuse("ambiguous", "these could be the letters of the word, or further ones", said.span,
                     "say 'in blue letters' right behind the word, or name the letters")  # fmt: skip
    below = next((x for x in atoms(task.goal) if isinstance(x, On) and {*members(x.a)} <= read), None)
    pairs = (pair for pair in pairwise(words) if pair[0].word == "on")
    if below is not None and any(b.word in lexicon.COLOR for _, b in pairs):
        raise refuse("ambiguous", "is this the colour of the letter's own cube, or of one below it?", below.span,
                     "say 'a blue A'")  # fmt: skip


def _bodies_of_words(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "spell CAT with blue cubes on the mat" as a word, and so many blue cubes on the mat: it could be written
    with them."""
    read = [x for x in atoms(task.goal) if isinstance(x, Spells | Equation)]
    for index, (lead, look, noun) in enumerate(zip(words, words[1:], words[2:], strict=False) if read else ()):
        number = lexicon.NUMBER.get(look.word) if look.kind == "word" else look.value
        if isinstance(number, int | float) and number in {len(x.blocks) for x in read}:
            look, noun = noun, words[min(index + 3, len(words) - 1)]
        color = lexicon.COLOR.get(look.word) if lead.word in _WRITTEN_WITH and noun.word in lexicon.BLOCK else None
        plain = {x.name for x in task.blocks if color and x.color == color and not isinstance(x, SemanticCube)}
        if plain and all(isinstance(x, OnPatch | InRegion) for x in atoms(task.goal) if plain & {*names(x)}):
            raise refuse("ambiguous", "these could be the cubes of the word, or further ones", look.span,
                         f"say 'in {look.word} letters' right behind the word, or say how many there are")  # fmt: skip


_WRITTEN_WITH = frozenset({"with", "using", "from"})


def _blocks_or_marks(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a red square next to a blue circle" as one of blocks beside a mark on the table, and "put eight blocks in
    a circle, a white one outside it" as a circle that they lie on."""
    several = any(isinstance(x, OnPatch) and len(members(x.a)) > 2 for x in atoms(task.goal))
    for one, two, shape in zip(words, words[1:], words[2:], strict=False) if several else ():
        if one.word == "in" and two.word in ("a", "one") and shape.word in _DRAWN:
            raise refuse("ambiguous", "do the blocks form this, or is it a mark that they lie on?", shape.span,
                         "say 'in the shape of a ...', or 'patch'")  # fmt: skip
    shapes = [token for look, token in pairwise(words) if look.word in lexicon.COLOR and token.word in _DRAWN]
    told = any(x.word in lexicon.BLOCK or (x.word in lexicon.PATCH and x.word not in _DRAWN) for x in words)
    built = any(isinstance(x, Figure | Grid) for x in atoms(task.goal))
    if len(shapes) > 1 and not told and task.patches and built:
        raise refuse("ambiguous", "are these shapes of blocks, or marks on the table?", shapes[-1].span,
                     "say of which blocks they are, or 'patch'")  # fmt: skip


_DRAWN = frozenset({"square", "circle", "rectangle", "triangle"})


def _beside_a_chain(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "tower red-blue-green, yellow on the table" as a tower of four: a comma ends what hyphens join."""
    if not any(token.joined for token in words):
        return
    lines = [len(x.blocks) for x in atoms(task.goal) if isinstance(x, Stack | Row)]
    for index, token in enumerate(words):
        run = 1
        while _named(token) and index + run < len(words) and words[index + run].joined and _named(words[index + run]):
            run += 1
        after = words[index + run : index + run + 2]
        if run > 1 and len(after) == 2 and after[0].word == "," and _named(after[1]) and any(n > run for n in lines):
            raise refuse("ambiguous", "this could be one more block of the line, or one beside it", after[1].span,
                         "say it in a sentence of its own")  # fmt: skip


def _all_of_them(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "all four blocks stacked; red below blue; green on top" as four blocks and three more."""
    for one, many, block, after in zip(words, words[1:], words[2:], [*words[3:], words[-1]], strict=False):
        count = lexicon.NUMBER.get(many.word) if many.kind == "word" else many.value
        plain = one.word == "all" and block.word in lexicon.BLOCK and after.word not in _PART
        if plain and isinstance(count, int | float) and len(task.blocks) > int(count):
            raise refuse("count-mismatch", f"all {int(count)} blocks are spoken of, but there would be more",
                         (one.span[0], block.span[1]), "say which blocks there are")  # fmt: skip


_PART = frozenset({"of", "in", "on", "with", "from", "at", "that", "which"})


def _letter_a(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of a b and c" as one of B and C: written in small letters, "a" may be one of them."""
    small = [
        n for n, t in enumerate(words) if t.kind == "word" and len(t.raw) == 1 and t.raw.islower() and t.raw != "a"
    ]
    if not small:
        return
    plain = any(n == 0 or words[n - 1].word not in ("a", "an") for n in small)
    shown = any(
        "A" in {asset.symbol(face) for face in FACES} for asset in task.assets if isinstance(asset, SemanticCube)
    )
    for n in small if plain and not shown else ():
        if n and words[n - 1].raw == "a" and words[n].raw not in ("i", "s"):
            raise refuse("ambiguous", "this 'a' could be the letter A", words[n - 1].span, "write letters large")


def _parted_lists(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two towers: A, B, C and D, E" where any towers of these blocks would do: which is in which?"""
    found = [atom for atom in atoms(task.goal) if isinstance(atom, Towers) and atom.each is None]
    if not found:
        return
    counts = {one.count for one in found}
    for index, token in enumerate(words[:-1]):
        lot = _list(words, index + 2) if token.word in _TOWERS and words[index + 1].word in (":", ",") else []
        if lot and _parted(lot, counts):
            raise refuse("ambiguous", "it is not clear which blocks form which tower",
                         (lot[0].span[0], lot[-1].span[1]), "say 'one tower of A and B, one of C and D'")  # fmt: skip


_OF_A_BLOCK = frozenset({"the", "block", "cube", "brick", "also", "letter", "number"})
"""What a block in a list is told with, besides what it is called."""


def _two_pairs(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "stack red and blue, and green and yellow", "line up A, B and C, D and E" as one of all of them."""
    plain = [t for t in words if t.word not in _OF_A_BLOCK]
    said = "".join("x" if _named(t) else {"and": "&", ",": ","}.get(t.word, ".") for t in plain)
    for run in re.finditer("x(?:(?:,&|,|&)x)+", said):
        rest = run.group().partition("&x")[2]
        alike = len(set(re.findall(",?&|,", run.group()))) == 1
        if alike or "," not in rest or rest.count("x") < 2:
            continue
        count = run.group().count("x")
        if any(len(blocks) >= count for x in atoms(task.goal) for blocks in _together(x)):
            span = (plain[run.start()].span[0], plain[run.end() - 1].span[1])
            raise refuse("ambiguous", "it is not clear whether this is one structure or two", span, "use two sentences")


def _together(goal: g.Goal) -> tuple[tuple[str, ...], ...]:
    """The blocks of a line, or of each group."""
    return goal.groups if isinstance(goal, GroupBy) else (goal.blocks,) if isinstance(goal, Stack | Row) else ()


def _colors_behind(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two towers of two, 15 cm apart, red and blue" as towers of other colours beside these two blocks."""
    if not task.assumed(COLORS_UNSAID):
        return
    of_patches = {patch.color for patch in task.patches} - {block.color for block in task.blocks}
    for end in [n for n, t in enumerate(words) if t.word in _ENDS] + [len(words)]:
        tail = [t.word for t in words[max(end - 4, 0) : end]]
        colors = len(tail) == 4 and tail[0] == "," and tail[2] == "and" and {tail[1], tail[3]} <= lexicon.COLOR.keys()
        colors = colors and not {lexicon.COLOR[tail[1]], lexicon.COLOR[tail[3]]} <= of_patches
        colors = colors or (tail[1:3] == [",", "both"] and tail[3] in lexicon.COLOR)
        if colors or _some_where(words, end) or _some_of_them(words, end):
            raise refuse("ambiguous", "these could be the colours of the blocks before, or further blocks",
                         (words[end - 3].span[0], words[end - 1].span[1]), "say them in front of 'blocks'")  # fmt: skip


def _some_where(words: Sequence[Token], end: int) -> bool:
    """ "(a block in each corner), red in front and blue at the back": bare colours, each with a place."""
    placed = [
        n
        for n in range(1, end - 1)
        if words[n].word in lexicon.COLOR and words[n - 1].word in (",", "and") and words[n + 1].word in _PLACED
    ]
    return len(placed) > 1 and words[placed[0] - 1].word == "," and _ENDS.isdisjoint(t.word for t in words[1:end])


def _some_of_them(words: Sequence[Token], end: int) -> bool:
    """ "(in every corner a block), the ones on the left red, the ones on the right blue"."""
    ones = [n for n in range(1, end - 1) if words[n].word == "ones" and words[n - 1].word == "the"]
    return len(ones) > 1 and all(any(t.word in lexicon.COLOR for t in words[n + 1 : n + 6]) for n in ones)


_PLACED = frozenset({"in", "on", "at", "to"})


def _counts_or_cubes(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a tower of 2, 3 and 4 blocks" as one of the cubes 2, 3 and 4: so many blocks, perhaps."""
    if not any(token.kind == "number" for token in words):
        return
    shown = {symbol for asset in task.assets if isinstance(asset, SemanticCube) for symbol in map(asset.symbol, FACES)}
    for at in (n for n, t in enumerate(words) if t.word in lexicon.BLOCK and t.word.endswith("s") and n):
        first = at
        while first and (words[first - 1].kind == "number" or words[first - 1].word in (",", "and")):
            first -= 1
        told = [t.raw for t in words[first:at] if t.kind == "number"]
        counted = words[at - 1].kind == "number" and words[first - 1].word == "of"
        upon = [t.raw for a, t in pairwise(words[at:]) if a.word in ("on", "onto") and t.kind == "number"]
        if words[at - 1].kind == "number" and upon and shown.issuperset(upon[:1]) and words[at + 1].word == "on":
            raise refuse("ambiguous", "so many blocks on so many others, or on the cube that shows this number?",
                         words[at].span, "say 'the number 2'")  # fmt: skip
        if counted and len(told) > 1 and shown.issuperset(told):
            raise refuse("ambiguous", "so many blocks, or the cubes that show these numbers?",
                         (words[first].span[0], words[at].span[1]), "say 'of the cubes 2, 3 and 4'")  # fmt: skip


def _named(token: Token) -> bool:
    symbol = token.kind == "number" or (token.kind == "word" and len(token.raw) == 1 and token.raw.isupper())
    return token.word in lexicon.COLOR or symbol


def _same_cubes(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "spell CAT, then CATS": with the cubes of the first word, or with others?"""
    if not any(isinstance(part, g.Sequence) for part in (task.goal, *getattr(task.goal, "goals", ()))):
        return
    spelt = [atom for atom in atoms(task.goal) if isinstance(atom, Spells)]
    for one, two in combinations(spelt, 2):
        contained = not Counter(one.word) - Counter(two.word) or not Counter(two.word) - Counter(one.word)
        if contained and not {*one.blocks} & {*two.blocks} and _ANEW.isdisjoint(t.word for t in words):
            raise refuse("ambiguous", "with the cubes of the first word, or with others?", two.span,
                         "say 'with the same letters', or 'with other cubes'")  # fmt: skip


def _list(words: Sequence[Token], begin: int) -> list[Token]:
    """The blocks listed from here to the end of the sentence; none where it says anything else."""
    lot: list[Token] = []
    for token in words[begin:]:
        if token.word in _ENDS:
            break
        lot.append(token)
    return lot if all(map(_listed, lot)) else []


def _listed(token: Token) -> bool:
    said = token.word in lexicon.COLOR or token.word in lexicon.BLOCK or token.word in lexicon.NUMBER
    symbol = token.kind == "number" or (token.kind == "word" and len(token.raw) == 1 and token.raw.isupper())
    return said or symbol or token.word in (",", "/", "and", "to", "a", "one", "ones", "blocks", "cubes")


def _parted(lot: list[Token], counts: set[int | None]) -> bool:
    """Whether "and" stands between lists, or as many lots are listed as there are towers, each with its number."""
    here = [token.word for token in lot]
    if "/" in here:
        return True
    joints = [n for n, word in enumerate(here) if word == "and"]
    if any("," in here[n + 1 :] or "and" in here[n + 1 :] for n in joints):
        return True
    items = [n for n in range(len(here)) if (n == 0 or here[n - 1] in (",", "and")) and here[n] != "and"]
    colors = any(word in lexicon.COLOR for word in here)
    if not colors:  # "A B and C D", but not "A, B, C and D"
        plain = [word for word in here if word not in (",", "and")]
        return len(plain) > len(items) and not any(word in lexicon.BLOCK for word in plain)
    return len(items) in counts and all(lot[n].kind == "number" or here[n] in lexicon.NUMBER for n in items)


_MAY_NOT = frozenset({"allowed", "permitted"})


def _who_may_not(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "(put red on the mat.) It is not allowed to touch blue" as an order not to move blue: it could be red that
    must not lie against it."""
    said = [token.word for token in words]
    for n in range(1, len(said) - 5):
        barred = said[n : n + 3] == ["it", "is", "not"] and said[n + 3] in _MAY_NOT and said[n + 5] == "touch"
        if barred and any(isinstance(atom, Stayed) for atom in atoms(task.goal)):
            raise refuse("ambiguous", "is the block spoken of before not to touch it, or is it to be left alone?",
                         words[n].span, "name the block, or say 'do not move ...'")  # fmt: skip


def _front_of_a_row(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "at the front of the row" as nearer than all of it: it may be its first block."""
    if not any(isinstance(atom, InFrontOf | Behind) for atom in atoms(task.goal)):
        return
    for at, the, side, of, _, noun in zip(*(words[n:] for n in range(6)), strict=False):
        ahead = [at.word, the.word, of.word] == ["at", "the", "of"] and side.word in _NEAR_OR_FAR
        if ahead and lexicon.STRUCTURE.get(noun.word, ("", False))[0] in ("row", "line"):
            raise refuse("ambiguous", "the first block of it, or in front of or behind all of it?", side.span,
                         "say 'in front of the row', 'behind the row', or which end")  # fmt: skip


_NEAR_OR_FAR = frozenset({"front", "back"})


def _same_number(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two boxes on the red mat, the same number on the blue one" as a cube that shows a number."""
    for same, number in pairwise(words):
        if (same.word, number.word) == ("same", "number") and task.assumed(SYMBOLS_UNSAID):
            raise refuse("ambiguous", "it is not clear what there is as many of", number.span,
                         "say the number again: 'and two on the blue one'")  # fmt: skip


def _different(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "four blocks, each of a different colour, and all of them green"."""
    for look, color in pairwise(words):
        told = look.word == "different" and color.word in ("color", "colors")
        if told and len(task.blocks) > 1 and len({block.color for block in task.blocks}) == 1:
            raise refuse("contradiction", "all of these have one colour", color.span, "leave one of the two out")


_CHECKS: tuple[tuple[frozenset[str] | None, Callable[[Sequence[Token], TaskSchema], None]], ...] = (
    (_TOWERS, _parted_lists),
    (None, _same_cubes),
    (frozenset({"and"}), _two_pairs),
    (None, _colors_behind),
    (None, _letters_of_words),
    (_WRITTEN_WITH, _bodies_of_words),
    (_DRAWN, _blocks_or_marks),
    (None, _counts_or_cubes),
    (frozenset({"stacked", "tower", "stack", "pile"}), stacked_at_last),
    (None, _beside_a_chain),
    (frozenset({"all"}), _all_of_them),
    (frozenset({"turn", "turns"}), in_turn),
    (ALTERNATE, alternating),
    (None, _letter_a),
    (frozenset({"or"}), _left_open),
    (_MAY_NOT, _who_may_not),
    (_NEAR_OR_FAR, _front_of_a_row),
    (frozenset({"same"}), _same_number),
    (frozenset({"different"}), _different),
)
"""What is checked, and words without which there is nothing to check."""
