"""A second account of an instruction, apart from the grammar: what words name must be found in the task.

Whichever way a sentence is read, a colour that was named belongs to some object, a symbol to some cube, a number to a
count, a length or an angle, and words that can mean one thing alone to that. A rule that loses one of them, or takes it
for part of something else, is caught here.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import groupby, pairwise

from pydantic import BaseModel

from rpg.blocks.traits import VOWELS
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.relations import On, OnPatch
from rpg.ir.schema import COLORS_BARRED, COLORS_UNSAID, EXCHANGED, EXCHANGED_LATER, NONE_BESIDES, REPLACED, TaskSchema
from rpg.ir.structures import Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Towers
from rpg.ir.walk import atoms, names
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import Numbers, edges_of, numbers_of, symbols_of
from rpg.passes.schema.worked_out import worked_out

PASSING = frozenset({"the", "no", "any", "every", "those", "these", "other", "all", "step", "stage", "row", "column",
                     "level", "layer", "floor", "tier"})  # fmt: skip
"""What stands before a two that is said in passing, or counts off: "the two towers", "no two of them", "row two"."""
DIGITS = frozenset("0123456789")
PATCHES = frozenset({"patch", "patches", "mat", "mats"})
SIGNS = "+*/="
"""Signs of arithmetic; in a list of symbols they are nothing else, but for the minus, which may be a dash."""
UNCOUNTED = ("corners", "sides", "edges", "thirds", "quarters", "fourths")
"""Of the table and of a square there are four; and so many parts come to another number of what they are parts of."""
ONLY = frozenset({"only", "just", "exactly"})
THERE = frozenset({"are", "is", "have", "has", "get", "got"})
"""What leads to "only" in a sentence that says what there is."""
STAY = frozenset({"stay", "stays", "remain", "remains", "leave", "keep"})
SYMBOLS = {
    **dict.fromkeys(("letter", "letters"), str.isalpha),
    **dict.fromkeys(("digit", "digits", "numeral", "numerals"), str.isdigit),
}
"""Words for symbols of a kind, with what tells that kind: "the letters 1, 2 and 3" are none."""
LASTING = frozenset({"never", "always"})
STATES = frozenset({"is", "are", "stays", "stay", "remains", "remain", "lies", "lie", "stands", "stand"})
PRONOUNS = "AI"
OPEN = "NK"
"""Letters for a number that is left open: "N blocks"."""
_PLAIN = {"alphabet alphabetic alphabetical alphabetically alphabetized": "label number",
          "alternate alternates alternating alternately alternatingly": "alternating checkerboard given",
          "ascending descending increasing decreasing": "number size label staircase",
          "checkerboard chessboard": "checkerboard", "circle ring": "circle", "column": "x grid staircase",
          "columns rows": "row grid staircase spells checkerboard towers figure", "equation": "equation",
          "diagonal diagonally": "rising falling diagonal checkerboard given grid figure behind in_front_of corner",
          "evenly": "evenly spacing count", "grid wall": "grid", "groups": "group_by towers",
          "heap": "heaps group_by",
          "mirror mirrored symmetric symmetrical symmetrically palindrome": "mirrored given",
          "neither nor": "not count stayed turned empty clear on_table", "pyramid": "pyramid", "rainbow": "rainbow",
          "row": "row grid spells equation checkerboard pyramid", "staircase stairs": "staircase",
          "swap swapped exchange": "swapped", "tower towers stacks": "stack towers on above grid pyramid",
          "triangle": "triangle", "upside": "facing stack figure"}  # fmt: skip
PLAIN = {word: frozenset(terms.split()) for words, terms in _PLAIN.items() for word in words.split()}
"""Words whose meaning depends on no other word, with the terms of a goal one of which they come to."""


def _spelt(token: Token, task: TaskSchema) -> bool:
    """ "Spell MAT": a word that the cubes show, and nothing that lies on the table."""
    return any(isinstance(atom, Spells) and atom.word == token.raw for atom in atoms(task.goal))


def unfounded(words: Sequence[Token], task: TaskSchema, chosen: Collection[str] = ()) -> Iterator[Token]:
    """The words that name something of which nothing in the task comes. `chosen`: of no colour that was said."""
    colors = {asset.color for asset in task.assets if asset.name not in chosen} | _barred(task)
    shown = {symbol for asset in task.assets for symbol in symbols_of(asset)}
    shown |= {atom.shape for atom in atoms(task.goal) if isinstance(atom, Figure)}
    numbers: Numbers | None = None
    parts = (task.goal, *task.init.arranged, *task.patches)
    terms = {term for part in parts for term in _terms(part)} | _shown_orders(task, words) | _beside_goals(task)
    for index, token in enumerate(words):
        if token.word not in _TELLING and token.kind not in ("number", "sign") and len(token.raw) != 1:
            continue
        color = lexicon.COLOR.get(token.word) or lexicon.COLOR_PLURAL.get(token.word)
        if color is not None and color not in colors and not _spelt(token, task):
            yield token
        symbol = token.kind == "word" and len(token.raw) == 1 and token.raw.isupper() and token.raw not in PRONOUNS
        open_ = (token.raw in OPEN and _counts(words[index + 1 : index + 3])) or worked_out(words, index, shown)
        if symbol and token.raw not in shown and not open_ and not ("label" in terms and _alphabet(words, index)):
            yield token
        listed = index > 0 and words[index - 1].word in (",", "and")
        if token.kind == "sign" and listed and token.word in SIGNS and token.word not in shown:
            yield token
        if _nowhere(words, index, terms) and not (_spelt(token, task) or worked_out(words, index, shown)):
            yield token
        if token.word in SYMBOLS and not any(map(SYMBOLS[token.word], shown)):
            yield token
        if token.word in PATCHES and not task.patches and not _spelt(token, task):
            yield token
        if token.word == "ones" and chosen and _of_counted(words, index, task):
            yield token
        if (token.word in _BESIDES and _joined_by_others(task)) or (token.word == "while" and _meanwhile(words, index)):
            yield token
        if color is not None and _one_of_invented(words, color, task):
            yield token
        if token.word == "order" and words[index - 1 : index] and words[index - 1].word == "any" and _as_listed(task):
            yield token
        if token.word == "each" and (_on_one(words, index, task) or _in_one(words, index, task)):
            yield token
        if token.word == "row" and index and words[index - 1].word == "bottom" and _deep_pyramid(task):
            yield token
        if token.word == "to" and _from_side_to_side(words, index) and _in_no_order(task, terms):
            yield token
        if token.word in STAY and (_where_it_is(words, index, terms) or _left_alone(words, index, task)):
            yield token
        if token.word in ONLY and (more := _more_than(words, index, task, terms)) is not None:
            yield more
        said, after = _number(token), words[index + 1].word if index + 1 < len(words) else ""
        if said is not None and said > 4 and after == "corners":
            yield token
        said = None if after in UNCOUNTED else said
        if said is not None and shown & DIGITS and _listed(words, index) and f"{said:g}" not in shown:
            yield token
        passing = _numbered(words, index, task) or (said == 2 and _in_passing(words, index))
        if said is not None and said > 1 and not (passing or worked_out(words, index, shown)):
            numbers = numbers or Numbers(numbers_of(task))
            told = numbers.among(said) or (_measured(words, index + 1) and Numbers(edges_of(task)).among(said))
            told = told or (_below(words, index) and numbers.among(said - 1))
            if not told and not any(numbers.among(said + few) for few in _beside_others(words, index)):
                yield token


def _barred(task: TaskSchema) -> set[str]:
    """The colours that some blocks are said not to have: none of these need be there."""
    noted = next((x.partition(": ")[2] for x in task.assumptions if x.startswith(COLORS_BARRED)), "")
    return {*noted.split(", ")} - {""}


def _below(words: Sequence[Token], index: int) -> bool:
    """ "Fewer than three": two at most."""
    return [t.word for t in words[max(index - 2, 0) : index]] in (["fewer", "than"], ["less", "than"])


def _beside_others(words: Sequence[Token], index: int) -> set[float]:
    """How many there are beside "the other three": with these they are all."""
    if not index or words[index - 1].word != "other":
        return set()
    return {1.0, *(number for token in words[:index] if (number := _number(token)) is not None)}


def _nowhere(words: Sequence[Token], index: int, terms: Collection[str]) -> bool:
    """Whether a word that means one thing alone comes to nothing; "a column three blocks high" is a tower."""
    word = words[index].word
    column = word in ("column", "columns") and "stack" in terms
    high = column and not _HIGH.isdisjoint(t.word for t in words[max(index - 6, 0) : index + 13])
    return word in PLAIN and PLAIN[word].isdisjoint(terms) and not high


_HIGH = frozenset({"high", "tall", "height", "heights"})


def _beside_goals(task: TaskSchema) -> set[str]:
    """What a task has that no condition names: heaps, a swap that is told by its result, the rim of a grid."""
    swapped = any(map(task.assumed, (EXCHANGED, EXCHANGED_LATER, REPLACED)))
    rim = any(isinstance(x, Figure) and (x.shape, x.sides) == ("square", (3, 3)) for x in atoms(task.goal))
    told = {"heaps" for _ in task.init.heaps} | ({"swapped"} if swapped else set())
    return told | ({"grid", "circle"} if rim else set())


def _in_passing(words: Sequence[Token], index: int) -> bool:
    """Whether a two need not be found: "the two of them", "two of the three"."""
    told = index > 0 and words[index - 1].word in PASSING
    return told or (index + 1 < len(words) and words[index + 1].word in ("of", "are"))


def _numbered(words: Sequence[Token], index: int, task: TaskSchema) -> bool:
    """ "Red block 3": the number is part of a name."""
    named = index > 0 and words[index - 1].word in lexicon.BLOCK
    return named and any(asset.name.endswith(f"_{words[index].raw}") for asset in task.assets)


def _one_of_invented(words: Sequence[Token], color: str, task: TaskSchema) -> bool:
    """Whether groups were given colours, of which some are told: "group by colour, reds left, blues right"."""
    noted = next((x for x in task.assumptions if x.startswith("the colours are not said: ")), "")
    if not noted:
        return False
    listed = noted.partition(": ")[2].split(", ")
    said = {lexicon.COLOR.get(x.word) or lexicon.COLOR_PLURAL.get(x.word) for x in words}
    return color in listed and not said.issuperset(listed) and any(isinstance(x, GroupBy) for x in atoms(task.goal))


def _where_it_is(words: Sequence[Token], index: int, terms: Collection[str]) -> bool:
    """Whether it is said to stay "where it is", with a few words between, and does not."""
    told = [t.word for t in words[index + 1 : index + 7]]
    there = any(first == "where" and last in ("is", "are") for first, last in zip(told, told[2:], strict=False))
    return there and {"stayed", "always"}.isdisjoint(terms)


def _left_alone(words: Sequence[Token], index: int, task: TaskSchema) -> bool:
    """ "Leave the white one alone on the mat", where there are no others that could have gone from there."""
    alone = any(t.word in ("alone", "only") for t in words[index + 1 : index + 6])
    return alone and task.assumed(NONE_BESIDES)


def _as_listed(task: TaskSchema) -> bool:
    """Whether blocks stand in the order in which they are named, one by one."""
    told = any(note.startswith(("the order is read from", "in the order in which")) for note in task.assumptions)
    asked = (task.goal, *getattr(task.goal, "goals", ()))
    orders = [x.order.ranks for x in asked if isinstance(x, Row | Stack) and x.order.by == "given"]
    return told or (len(orders) == 1 and len(orders[0]) > 2 and all(len(rank) == 1 for rank in orders[0]))


def _more_than(words: Sequence[Token], only: int, task: TaskSchema, terms: Collection[str]) -> Token | None:
    """The number in "there are only two blocks", where there are more or fewer; the word in "exactly two of the five
    are in a row", where more may join them."""
    if _of_more(words, only) and {"count", "not", "exact"}.isdisjoint(terms):
        return words[only]
    there, after = words[only - 1 : only], words[only + 1 : only + 4]
    if len(after) < 2 or not there or there[0].word not in THERE or after[1].word not in lexicon.BLOCK:
        return None
    plain = len(after) == 2 or after[2].kind == "punct"
    said = _number(after[0]) if plain else None
    return after[0] if said is not None and said != len(task.blocks) else None


def _of_more(words: Sequence[Token], index: int) -> bool:
    """ "exactly two of the five red ones": no more of them may join these."""
    number = _number(words[index + 1]) if index + 2 < len(words) and words[index + 2].word == "of" else None
    return number is not None and number > 1


def _listed(words: Sequence[Token], index: int) -> bool:
    """Whether a number is the first of a list of three or more: beside cubes with digits, it is one of these."""
    rest = words[index + 1 : index + 5]
    return [_number(t) is None for t in rest] == [True, False, True, False] and rest[0].word == "," == rest[2].word


def _of_counted(words: Sequence[Token], index: int, task: TaskSchema) -> bool:
    """Whether "the red ones" are of the blocks counted before, "line up five blocks", beside which there are others."""
    looks = lexicon.COLOR.get(words[index - 1].word) is not None
    counts = [_number(number) for number, noun in pairwise(words[:index]) if noun.word in lexicon.BLOCK]
    return looks and any(count is not None and count < len(task.blocks) for count in counts)


def _alphabet(words: Sequence[Token], index: int) -> bool:
    """ "from A to Z", "from Z to A": the letters from one end to the other, none of them named."""
    begins = [at for at in (index - 1, index - 3) if at >= 0 and words[at].word == "from"]
    return any([t.word for t in words[at + 1 : at + 4]] in (["a", "to", "z"], ["z", "to", "a"]) for at in begins)


_BESIDES = frozenset({"instead", "too"})
_TELLING = frozenset({*lexicon.COLOR, *lexicon.COLOR_PLURAL, *lexicon.NUMBER, *PLAIN, *SYMBOLS, *PATCHES, *_BESIDES,
                      *STAY, *ONLY, "ones", "order", "each", "while", "row", "to"})  # fmt: skip
"""The words of which something must come."""


def _joined_by_others(task: TaskSchema) -> bool:
    """Whether a block goes where another one is at the start of which no more is said: "put blue there instead"."""
    begun = [(x.patch, {*members(x.a)}) for x in task.init.arranged if isinstance(x, OnPatch)]
    spoken = set(names(task.goal))
    ends = {x.patch for x in atoms(task.goal) if isinstance(x, OnPatch)}
    return any(patch in ends and not lot & spoken for patch, lot in begun)


def _on_one(words: Sequence[Token], index: int, task: TaskSchema) -> bool:
    """Whether "A and B, each on a mat" came to one mat for all of them."""
    here = [t.word for t in words[index + 1 : index + 5]]
    at = next((n for n, word in enumerate(here) if word in ("on", "onto")), 0)
    here = [t.word for t in words[index + 1 + at : index + 5 + at]]
    one = here[:1] in (["on"], ["onto"]) and here[1:2] in (["a"], ["one"]) and bool({*here[2:4]} & lexicon.PATCH.keys())
    stacks = [x for x in atoms(task.goal) if isinstance(x, Stack) and x.patch is not None]
    placed = [x for x in atoms(task.goal) if isinstance(x, OnPatch)]
    if one and not placed and len(stacks) == 1 and _alone(task):
        return True  # "stack three blocks, each on a mat"
    return one and len({x.patch for x in placed}) == 1 and any(len(members(x.a)) > 1 for x in placed)


def _in_one(words: Sequence[Token], index: int, task: TaskSchema) -> bool:
    """Whether "three red on the left and two blue on the right, each in a row" came to one row."""
    here = [t.word for t in words[index + 1 : index + 4]]
    lines = sum(isinstance(x, Row | Stack | GroupBy | Towers) for x in atoms(task.goal))
    if here[:1] in (["tower"], ["stack"], ["row"]):
        return lines == 1 and _alone(task)
    return here[:2] == ["in", "a"] and here[2:] in (["row"], ["line"], ["tower"], ["stack"]) and lines < 2


def _alone(task: TaskSchema) -> bool:
    """Whether a line is all there is, where "on each tower" speaks of several."""
    built = [x for x in atoms(task.goal) if isinstance(x, GroupBy | Towers | On) or hasattr(x, "blocks")]
    line = next((x for x in built if isinstance(x, Row | Stack)), None)
    return line is not None and not task.init.arranged and all({*names(x)} & {*line.blocks} for x in built)


def _deep_pyramid(task: TaskSchema) -> bool:
    """Whether the base of a pyramid is no row."""
    return any(isinstance(atom, Pyramid) and min(atom.base) > 1 for atom in atoms(task.goal))


_ACROSS = {"left": "right", "right": "left", "front": "back", "back": "front", "top": "bottom", "bottom": "top"}


def _from_side_to_side(words: Sequence[Token], index: int) -> bool:
    """ "from left to right"."""
    behind = [token.word for token in words[index + 1 : index + 3] if token.word != "the"]
    return index > 0 and behind[:1] == [_ACROSS.get(words[index - 1].word)]


def _in_no_order(task: TaskSchema, terms: Collection[str]) -> bool:
    """Whether a line of blocks that look different has no beginning, and nothing else tells what is on which side."""
    if task.assumed(COLORS_UNSAID) or not _SIDED.isdisjoint(terms):
        return False
    found = [node for part in (task.goal, *task.init.arranged) for node in atoms(part)]
    orders = [getattr(node, "order", None) for node in found]
    if any(isinstance(order, Order) and order.first for order in orders) or any(getattr(x, "up", "") for x in found):
        return False
    looks = {block.name: (block.color, getattr(block, "label", "")) for block in task.blocks}
    return any(isinstance(x, Row | Stack) and len({looks[name] for name in x.blocks}) > 1 for x in found)


_SIDED = frozenset({"spells", "equation", "left_of", "right_of", "in_front_of", "behind", "facing", "staircase", "grid",
                    "on", "above", "towers", "checkerboard", "pyramid"})  # fmt: skip


def _meanwhile(words: Sequence[Token], at: int) -> bool:
    """ "red never touches the table while blue is on the mat": as long as that is so, which no goal asks for."""
    here = [token.word for token in words]
    ends = [index for index, word in enumerate(here) if word in (".", ";", "!", "?")]
    begin = max((index for index in ends if index < at), default=-1)
    end = min((index for index in ends if index > at), default=len(here))
    return not LASTING.isdisjoint(here[begin + 1 : at]) and not STATES.isdisjoint(here[at + 1 : end])


def _measured(words: Sequence[Token], index: int) -> bool:
    """Whether a unit follows, with the number or with the last of a list of them: "3, 4 and 5 cm"."""
    while index < len(words) and (words[index].word in (",", "and") or _number(words[index]) is not None):
        index += 1
    return index < len(words) and words[index].word in lexicon.UNIT


def _counts(after: Sequence[Token]) -> bool:
    """Whether the words that follow are what is counted."""
    return any(token.kind == "word" and token.word.endswith("s") for token in after)


def _shown_orders(task: TaskSchema, words: Sequence[Token]) -> set[str]:
    """The orders that a list comes to which a goal gives block by block: A, B, C is the one by label; and so is A, E,
    B, C, where vowels are spoken of."""
    symbols = {asset.name: "".join(sorted(symbols_of(asset))) for asset in task.assets}
    orders: list[list[str]] = []
    for atom in atoms(task.goal):
        order = getattr(atom, "order", None)
        if isinstance(order, Order) and order.by == "given":
            orders.append([symbols.get(rank[0], "") for rank in order.ranks])
    told = [one for one in orders if all(one)]
    kinds = [one for one in told if _kind_by_kind(one)] if any(token.word in _KINDS for token in words) else []
    rising = [one for one in told if one == sorted(one)]
    boards = {"checkerboard" for atom in atoms(task.goal) if isinstance(atom, Grid) and _takes_turns(atom, task)}
    shown = {"number" if "".join(one).isdigit() else "label" for one in (*rising, *kinds)}
    return shown | {"group_by" for _ in kinds} | boards


def _takes_turns(grid: Grid, task: TaskSchema) -> bool:
    """Whether a grid whose cells are given one by one has two colours that alternate along its rows and columns."""
    order = grid.pattern.order if grid.pattern is not None else Order()
    colors = {asset.name: asset.color for asset in task.assets}
    told = [colors[rank[0]] for rank in order.ranks if len(rank) == 1]
    across = grid.columns
    turns = [(n // across + n % across) % 2 for n in range(len(told))]
    return len(told) == len(grid.blocks) and len({*told}) == len({*zip(told, turns, strict=True)}) == 2


def _kind_by_kind(symbols: list[str]) -> bool:
    """Whether all of one kind, odd or even, vowel or consonant, come before the others, sorted in themselves."""
    runs = [[*run] for _, run in groupby(symbols, lambda symbol: symbol in VOWELS or symbol in _ODD)]
    return len(runs) == 2 and all(run in (sorted(run), sorted(run, reverse=True)) for run in runs)


_ODD = frozenset("13579")
_KINDS = frozenset({"vowel", "vowels", "consonant", "consonants", "odd", "odds", "even", "evens"})
"""Words that part symbols into two kinds."""


def _number(token: Token) -> float | None:
    if token.kind == "number":
        return float(str(token.value))
    spelt = token.raw.isupper() and len(token.raw) > 1  # "Rearrange them to TEN"
    return lexicon.NUMBER.get(token.word) if token.kind == "word" and not spelt else None


def _terms(value: object) -> Iterator[str]:
    """The kinds of all parts of a goal, the words among their values, and the flags that are set."""
    if isinstance(value, BaseModel):
        for name in type(value).model_fields:
            told = getattr(value, name)
            yield from (name,) if told is True else _terms(told) if name != "span" else ()
    elif isinstance(value, str):
        yield value
    elif isinstance(value, Sequence):
        for item in value:
            yield from _terms(item)
