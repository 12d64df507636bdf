"""How high blocks may be stacked at most: "no stack there may be higher than two", "never more than two high"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Amount, Clause, Pronoun, Size

BOUNDED = "bound heights"
"""The verb of such a clause."""
_THERE = (
    "there|here|on_it|in_it|of_them|on_the_patch|on_the_mat|on_that_patch|on_this_patch|on_that_mat|among_them|of_these"
)
_TOWER = "stack|tower|pile|column"
_HIGHER = Patterns(
    f"with? no {_TOWER} {_THERE}? higher|taller than",
    f"with? no {_TOWER} {_THERE}? being|is|gets|becomes|growing|rising higher|taller than",
    f"no {_TOWER} {_THERE}? may|can|must|should|shall|will be|become|get|grow|rise|reach higher|taller than",
    f"with? no {_TOWER} {_THERE}? of more than",
    f"no {_TOWER} {_THERE}? may|can|must|should|shall have|hold|contain|consist_of|comprise|count more than",
    f"with? no {_TOWER} {_THERE}? has|having|holds|contains|containing|exceeds|exceeding more than",
    "nothing|none may|can|must|should|shall be stacked|piled higher than",
    "no|not|never more than", "at most", "do_not|never stack|pile|heap up? more than",
)  # fmt: skip
_UNITS = ("blocks", "cubes", "bricks", "boxes", "block", "cube", "layers", "levels", "of them")
_HIGH = ("high", "tall", "on top of each other", "on top of one another", "in one stack", "in a stack", "in one tower",
         "in a tower", "above each other", "stacked on top of each other")  # fmt: skip
_SHORT = frozenset({"at", "no", "not", "never", "do"})
_OF_THEM = frozenset(_THERE.split("|")) | {"it", "them", "there", "here", "patch", "mat", "these"}


@rule
def heights_bounded(p: Parser, i: int) -> Results[Clause]:
    """The number of blocks of the highest stack; where it is not said of stacks, it is of what is high."""
    for j in _HIGHER.matches(p, i):
        many = p.number(j)
        if many is None or many < 1:
            continue
        end = p.any_of(j + 1, _UNITS) or j + 1
        end = p.any_of(end, ("of them", "of these")) or end
        high = p.any_of(end, _HIGH)
        if not high and ("more" in p.words[i:j] or p.stands(i, _SHORT)) and not _told_of_stacks(p, i, j):
            continue
        there = not _OF_THEM.isdisjoint(p.words[i:j])
        theme = Pronoun(word="them" if there else "everything", span=p.span(i, j))
        most = Size(what="high", amount=Amount(0, many, True), span=p.span(j, end))
        yield Clause(verb=BOUNDED, theme=theme, adjuncts=(most,), mode="goal", span=p.span(i, high or end)), high or end


def _told_of_stacks(p: Parser, i: int, j: int) -> bool:
    return not frozenset(_TOWER.split("|")).isdisjoint(p.words[i:j])


def stacks_more(p: Parser, j: int) -> bool:
    """ "(do not) stack more than two": how many, and not which."""
    k = j + 1 + (p.words[j + 1] == "up")
    return p.words[j] in ("stack", "pile", "heap") and p.words[k : k + 2] == ["more", "than"]
