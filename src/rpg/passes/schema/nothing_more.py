"""Clauses that follow from the rest: "not all three", "so four in total", "and leave one off it", "nothing on top of
anything". A text that makes no sense with one is read without it, and must then say that by itself."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import pairwise

from rpg.ir import goal as g
from rpg.ir.assets import Block
from rpg.ir.node import Node, members
from rpg.ir.relations import Above, Behind, InFrontOf, LeftOf, On, OnTable, RightOf
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.structures import Figure, Grid, Pyramid, Row, Stack, Staircase, Towers
from rpg.ir.walk import atoms, within
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.said_of_figures import SAID_OF_FIGURES
from rpg.passes.schema.said_of_success import SAID_OF_SUCCESS, Check, Parts

_MARKS = frozenset({",", ".", ";", ":", "!", "?", "(", ")", "-"})
_JOINS = frozenset({"and", "but", "while", "so", "with", "or"})
MOST = 4
"""So many ways at most are tried."""


def _so_many_at_most(task: TaskSchema, told: Parts) -> bool:
    """Whether no more than are asked for may be so; where the clause says how many, or how many not, fewer than all."""
    counts = [goal for goal in within(task.goal) if isinstance(goal, g.Count) and goal.at_most is not None]
    number = _number(told)
    if told.get("n") in ("zero", "0"):
        return False
    bounds = [(goal.at_most or 0, len(goal.over)) for goal in counts]
    return any(not number or most < number or most + number == over for most, over in bounds)


def _flat(task: TaskSchema, told: Parts) -> bool:
    """Whether no block has to be on another."""
    raised = (On, Above, Stack, Towers, Staircase, Pyramid, Figure)
    return not any(isinstance(atom, raised) for atom in atoms(task.goal))


def _beside(task: TaskSchema, told: Parts) -> bool:
    """Whether what is told last is no place on a block."""
    told_last = [*atoms(task.goal)][-1:]
    return bool(told_last) and not isinstance(told_last[0], On | Above | Stack | Towers)


def _so_many_there(task: TaskSchema, told: Parts) -> bool:
    """Whether there are just so many blocks."""
    return sum(_of_each(task).values()) == _number(told)


def _so_many_of_each(task: TaskSchema, told: Parts) -> bool:
    """Whether there are just so many of each of several colours."""
    colors = _of_each(task)
    return len(colors) > 1 and set(colors.values()) == {_number(told)}


def _of_each(task: TaskSchema) -> Counter[str]:
    return Counter(asset.color for asset in task.assets if isinstance(asset, Block))


def _any_of_them(task: TaskSchema, told: Parts) -> bool:
    """Whether so many of some are asked for, whichever these are."""
    counts = [goal for goal in within(task.goal) if isinstance(goal, g.Count)]
    number = _number(told)
    return any(not number or number == goal.at_most for goal in counts)


def _of_any_color(task: TaskSchema, told: Parts) -> bool:
    return bool(task.assumed(COLORS_UNSAID))


def _there(task: TaskSchema, told: Parts) -> bool:
    """Whether the block that may go anywhere is one of the task's."""
    colors = {asset.color for asset in task.assets if isinstance(asset, Block)}
    return lexicon.COLOR.get(told["color"] or "") in colors


def _lowest(task: TaskSchema, told: Parts) -> bool:
    """Whether the block of that colour is the one at the foot, with the others on it."""
    color = lexicon.COLOR.get(told["color"] or "")
    own = {a.name for a in task.assets if isinstance(a, Block) and a.color == color}
    pairs = [atom for atom in atoms(task.goal) if isinstance(atom, On)]
    bearing = {name for atom in pairs for name in members(atom.b)} - {n for atom in pairs for n in members(atom.a)}
    for atom in atoms(task.goal):
        if isinstance(atom, Stack) and atom.order.by == "given" and atom.order.ranks:
            bearing |= {*atom.order.ranks[-1 if atom.order.first == "top" else 0]}
    return len(bearing) == 1 and bearing <= own


def _piled(task: TaskSchema, told: Parts) -> bool:
    """Whether the blocks are one tower."""
    return any(isinstance(atom, Stack | On) or getattr(atom, "along", "") == "stack" for atom in atoms(task.goal))


_SIDES: dict[str, type[Node]] = {"in front": Behind, "behind": InFrontOf, "left": RightOf, "right": LeftOf}


def _other_side(task: TaskSchema, told: Parts) -> bool:
    """Whether something is on the side across from the one that is denied."""
    side = (told["side"] or "").removeprefix("to the ").removeprefix("on the ")
    return any(isinstance(atom, _SIDES[side]) for atom in atoms(task.goal))


def _built(task: TaskSchema, told: Parts) -> bool:
    """Whether there is a figure that could be built."""
    figures = (Stack, Towers, Row, Grid, Pyramid, Staircase, Figure)
    return any(isinstance(atom, figures) for atom in atoms(task.goal))


def _turned_round(task: TaskSchema, told: Parts) -> bool:
    """Whether a line of the start is to stand the other way round."""
    begun, ended = ({pair for goal in goals for pair in _pairs(goal)} for goals in (task.init.arranged, [task.goal]))
    return bool(begun) and {(b, a) for a, b in begun} == ended


def _pairs(goal: g.Goal) -> Iterator[tuple[str, str]]:
    """Neighbours in a tower from the bottom up, or in a row from its left or its front."""
    for atom in atoms(goal):
        if isinstance(atom, On):
            yield from ((below, above) for below in members(atom.b) for above in members(atom.a))
        if isinstance(atom, Stack | Row) and atom.order.by == "given":
            line = [name for rank in atom.order.ranks for name in rank]
            yield from pairwise(line[::-1] if atom.order.first in ("top", "right", "back") else line)


def _taken_apart(task: TaskSchema, told: Parts) -> bool:
    """Whether blocks start on each other, and are on the table at the end."""
    piled = any(isinstance(atom, On | Stack | Towers) for goal in task.init.arranged for atom in atoms(goal))
    return piled and all(isinstance(atom, OnTable) for atom in atoms(task.goal))


_BOUNDS = frozenset({"exactly", "precisely", "just", "only", "least", "most"})
"""With one of these a number is one where the others may be anywhere; "two go there, the rest anywhere" may be more."""


def _some_counted(task: TaskSchema, told: Parts) -> bool:
    """Whether so many of some are asked for, so that there are others."""
    return any(isinstance(goal, g.Count) for goal in within(task.goal))


def _anyway(task: TaskSchema, told: Parts) -> bool:
    return True


_SO_MANY = f"(?:{'|'.join(sorted(lexicon.NUMBER))}|\\d+)"
_MANY = f"(?P<n>{_SO_MANY})"
_THEM = "(?:it|them|there|any of them|the (?:\\w+ )?(?:mat|patch|zone|spot|target|area|pad))"
_OTHERS = (
    f"(?:the )?(?:other|others|rest|remaining|third|fourth|fifth|last)(?: {_SO_MANY})?"
    f"(?: (?:{'|'.join(sorted(lexicon.COLOR))}))?(?: ones?| blocks?| cubes?)?"
)
_MAY_BE = "(?:may|can|could) (?:be|go|stay|lie|stand|end up|be put|be placed|be moved to)"
_ANYWHERE = "(?:anywhere|wherever (?:you|they) (?:like|want))"
_OFF = f"(?:off|out of|outside(?: of)?|away from|not on|not in)(?: {_THEM})?"
_STAYS = "(?: is| are| stays?| must be| must stay| remains?| has to stay| have to stay| should be| should stay)?"
_A_LINE = "(?:a|an|the|this)(?: given| existing)? (?:tower|stack|pile|row|line|column)"
_TOLD: tuple[tuple[str, Check], ...] = (
    (f"(?:the )?(?:(?:reversal|inversion) of|reverse|invert|reversing|inverting) {_A_LINE}", _turned_round),
    (f"(?:the )?(?:dismantling|unstacking) (?:of )?{_A_LINE}|(?:dismantle|unstack|take apart) {_A_LINE}", _taken_apart),
    (r"(?:not|never) (?:the )?(?:other way (?:round|around)|vice versa|the reverse)", _anyway),
    (f"not (?:all |all of the |all of them |both |both of them )?{_MANY}(?: of them| at once)?", _so_many_at_most),
    (f"not {_SO_MANY} (?:rows|columns|towers|stacks|lines|layers) of {_SO_MANY}(?: blocks| cubes)?", _anyway),
    (f"not (?:a|one) (?:single |big |large )?(?:tower|stack|row|line|one) of {_SO_MANY}(?: blocks| cubes)?", _anyway),
    (f"not one of {_SO_MANY}", _anyway),
    ("(?:i |we )?do not (?:care|mind) how (?:far apart|close|far|wide the gaps are|they are turned)(?: they are| that "
     "is)?",
     _anyway),
    ("whichever you (?:like|want|prefer|choose)|whichever of them", _anyway),
    ("the (?:others?|rest)(?: blocks| ones)? (?:may|can) (?:be )?moved?(?: freely)?", _anyway),
    (f"{_OTHERS} {_MAY_BE} {_ANYWHERE}(?: on the table)?", _some_counted),
    (f"{_OTHERS} {_MAY_BE} {_ANYWHERE} else(?: on the table)?", _so_many_at_most),
    ("(?:leave|leaving) (?:the arrangement|the rest|everything else|it|all else)(?: otherwise)? (?:free|open|as it "
     "comes)", _anyway),
    ("no more(?: and|,| ,)? no (?:less|fewer)", _so_many_there),
    ("(?:please )?(?:build|make|create|show|construct|do|arrange) (?:it|this|that|the "
     "(?:tower|row|figure|picture|scene)|(?:one|a) "
     "possible arrangement)", _built),
    (f"(?:no matter which|whichever)(?: ones?| {_MANY})?", _any_of_them),
    ("one (?:letter |digit )?(?:block|cube|letter|one|digit) on (?:top of )?the other", _piled),
    ("not (?P<side>in front|behind|to the left|to the right|on the left|on the right)(?: of (?:it|them))?",
     _other_side),
    ("(?:nothing|none|no block) on the others?(?: ones?)?", _so_many_at_most),
    ("not (?:all|both|more|all of them|both of them)(?: than that)?", _so_many_at_most),
    ("no more(?: than that)?", _so_many_at_most),
    (f"(?:keep|leave) (?:{_OTHERS}|{_MANY}(?: of them)?) {_OFF}", _so_many_at_most),
    (f"{_OTHERS}{_STAYS} (?:{_OFF}|elsewhere|somewhere else)", _so_many_at_most),
    (f"(?:leave|keep) {_OTHERS} (?:on|in) {_THEM}", _so_many_at_most),
    (f"(?:that (?:is|'s|makes) |there (?:are|is) |it is )?{_MANY} (?:in total|in all|altogether|all together|total|"
     "all in all)", _so_many_there),
    (f"(?:that (?:is|'s|makes) |there are )?{_MANY} (?:of )?each(?: colou?r)?", _so_many_of_each),
    (f"all {_MANY}(?: of them| of these)?", _so_many_there),
    (r"(?:nothing|none)(?: (?:lying|sitting|stacked|is|stands|lies))? on(?: top of)? (?:anything|another|any other|"
     "each other|one another|any of them|others)", _flat),
    (r"not on top(?: of (?:it|them|any of them|each other|one another|any other))?", _beside),
    (r"(?:none|no block|no one|nobody|nothing)(?: is| are)?(?: being)? left(?: over| out| behind)?", _anyway),
    ("(?:there (?:is|are) )?no (?:other|further|more|additional|extra) (?:blocks?|cubes?|objects?|things?)(?: "
     "(?:are|is))?"
     "(?: present| used| needed| around| involved| visible| in the scene| in sight)+", _anyway),
    (r"(?:(?:no matter |it does not matter |(?:i|we) do not (?:care|mind) )which|whichever)(?: one| of them| of the "
     r"two)? "
     r"(?:is|comes|goes|ends up)(?: lying)? (?:on top|at the bottom|first|last|on the left|on the right|uppermost)",
     _anyway),
    (r"(?:it (?:does not matter|makes no difference|is not important)|no matter|(?:i|we) do not (?:care|mind)) "
     r"(?:whether|if) (?:\w+ ){1,3}or (?:\w+ ){1,3}(?:is|comes|goes|ends up) (?:on top|at the bottom|first|last|on the "
     r"left|on the right|uppermost)", _anyway),
    (r"(?:the )?(?P<color>\w+)(?: one| block| cube)?(?: is| being| as)? (?:the )?(?:bottom|lowest|bottommost) "
     r"(?:one|block)?",
     _lowest),
    (r"(?:no|without) (?:special |particular )?colou?r (?:constraints?|requirements?|preferences?|restrictions?)",
     _of_any_color),
    (r"(?:any|all) colou?rs?(?: (?:is|are|will))? (?:fine|ok|okay|allowed|good|do|possible|permitted)", _of_any_color),
    (r"colou?rs? (?:is|are|be) (?:free|arbitrary|open|irrelevant|up to (?:you|the robot)|not important)",
     _of_any_color),
    (r"(?:the )?colou?rs? (?:does|do) not matter(?: here)?", _of_any_color),
    *SAID_OF_SUCCESS,
    *SAID_OF_FIGURES,
    (r"(?:it )?(?:is |counts as )?(?:a )?(?:fail|fails|failed|failure|false)(?: it)? otherwise", _anyway),
    (r"otherwise(?: it is| it)?(?: a)? (?:fail|fails|failed|failure|false)", _anyway),
    (f"the (?P<color>{'|'.join(sorted(lexicon.COLOR))})(?: one| block| cube)? (?:may|can) (?:go|be|stay|lie|move|stand|"
     "end up) (?:anywhere|everywhere|wherever it (?:likes|wants|pleases))(?: else)?(?: on the table)?", _there),
    (r"(?:touching|contact) (?:is|be) (?:ok|okay|fine|allowed|permitted)", _anyway),
    (r"(?:they|the blocks|the cubes) (?:may|can) (?:also )?touch(?: each other)?", _anyway),
)  # fmt: skip


@cache
def _compiled() -> tuple[tuple[re.Pattern[str], Check], ...]:
    return tuple((re.compile(row), check) for row, check in _TOLD)


def without_more(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], Callable[[TaskSchema], bool]]]:
    """The words without one such clause, and whether a task says what is said in it."""
    words = [token.word for token in tokens]
    for begin, end in _clauses(words):
        text = " ".join(words[begin:end])
        for row, check in _compiled():
            if (met := row.fullmatch(text)) is not None and (check is not _some_counted or _BOUNDS & {*words}):
                follows = words[end + 1 : end + 2] if words[end : end + 1] == [","] else []
                if (rest := _closed(tokens, begin, end)) and not (follows and follows[0] in lexicon.NUMBER):
                    yield rest, partial(_holds, check, met.groupdict())
                break


def _holds(check: Check, told: Parts, task: TaskSchema) -> bool:
    return check(task, told)


def _clauses(words: Sequence[str]) -> Iterator[tuple[int, int]]:
    """Where clauses begin and end: between marks, or behind what joins them to those before."""
    marks = [-1, *(n for n, word in enumerate(words) if word in _MARKS), len(words)]
    for before, end in pairwise(marks):
        begin = before + 1
        while begin < end and words[begin] in _JOINS:
            begin += 1
        if begin < end:
            yield begin, end
        for n in range(begin + 1, end - 1):
            if words[n] in _JOINS:
                yield n + 1, end


def _closed(tokens: Sequence[Token], begin: int, end: int) -> list[Token]:
    """The words without a clause, and without what joins it to the others."""
    ahead, rest = [*tokens[:begin]], [*tokens[end:]]
    while ahead and ahead[-1].word in _JOINS:
        ahead.pop()
    if ahead and ahead[-1].word == "(" and rest and rest[0].word == ")":
        ahead, rest = ahead[:-1], rest[1:]
    if ahead and ahead[-1].word in _MARKS and (not rest or rest[0].word in _MARKS):
        ahead = ahead[:-1] if rest else ahead
        ahead = ahead[:-1] if not rest and ahead[-1].word in (",", "-", ":") else ahead
    elif rest and not ahead:
        rest = rest[1:]
    return [*ahead, *rest]


def _number(told: Parts) -> int:
    """The number that a clause names, or 0."""
    word = told.get("n")
    return 0 if word is None else int(word) if word.isdigit() else lexicon.NUMBER[word]
