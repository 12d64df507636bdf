"""What a sentence tells of two lots or two places must not have become one, nor one word two."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.core.diagnostics import Refusal
from rpg.ir import goal as g
from rpg.ir.assets import GoalPatch
from rpg.ir.relations import InRegion, Stayed
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Cells, GroupBy, Row, Spells, Stack, Towers
from rpg.ir.walk import atoms, names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.grammar.rows.vocabulary import COLOR
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_KINDS = (("odd", "even"), ("even", "odd"), ("vowels", "consonants"), ("consonants", "vowels"), ("letters", "digits"),
          ("digits", "letters"), ("letters", "numbers"), ("numbers", "letters"))  # fmt: skip
_TWO_KINDS = on_demand("|".join(rf"\b{one}\b.* and (?:the )?{other}\b" for one, other in _KINDS))
_NAMED = on_demand(r"\bname is (\S+) .*\b(?:write|spell|lay|build) (?:the word )?(\S+)$")
_EACH_MIDDLE = on_demand(r", (?:each|both|all)(?: of them)? in the (?:very )?(?:middle|center)$")
_TOUCHING = on_demand(r"\b(?:touch|touching|contact)\b")
_SIZES = "|".join(lexicon.SIZE)
_SEVERAL = "|".join(noun for noun, many in lexicon.BLOCK.items() if many)
_TWO_SIZES = on_demand(rf"\b(?:{_SIZES}) and (?:{_SIZES}) (?:\w+ )?(?:{_SEVERAL})\b")
"""Plurals may be of one block of each size, or of several."""
_A_BLOCK = rf"(?:a|an|one) ({COLOR}) (?:{'|'.join(lexicon.BLOCK)}|one)"
_AND_THERE = on_demand(
    rf"\b{_A_BLOCK} , {_A_BLOCK} (?:on|in|at|to|left|right|behind|next|beside|near) (.*?){_A_BLOCK} "
)
_ANOTHER = on_demand(
    r"\b(?:make|build|form|construct|create) another(?: one)?"
    r"(?= (?!\w+ (?:block|cube)|(?:tower|stack|row|line|column|wall|group|pile)\b)|$)"
)
_SHAPES = (Stack, Row, Towers, Cells)
_IT_IS = on_demand(rf"(?:it|this|that)(?: is|'s| 's) an? .*\b(?:{'|'.join(lexicon.BLOCK)}|one)\b")


def check_told_apart(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a task in which two things that are told apart are one.

    Raises:
        Refusal: "ambiguous", with what can be told of each.
    """
    found = list(atoms(task.goal))
    towers = [{*x.blocks} for x in found if isinstance(x, Stack)]
    for n, sentence in enumerate(sentences(tokens)):
        if n:
            _corrected(sentence, task)
        text = " ".join(token.word for token in sentence if token.word not in (".", "!", "?"))
        grouped = [x.groups[0] for x in found if isinstance(x, GroupBy) and x.groups and len(x.groups) == 1]
        if any({*x} in towers and len(x) < len(task.blocks) for x in grouped) and _TOUCHING.search(text):
            raise _asked(sentence, "blocks of one tower touch anyhow: what is to touch what?", "say which blocks touch")
        if grouped and _TWO_KINDS.search(text):
            raise _asked(sentence, "one group, or one of each kind?", "say 'group the digits by odd and even'")
        named = _NAMED.search(text)
        if named and named[1] != named[2] and sum(isinstance(x, Spells) for x in found) > 1:
            raise _asked(sentence, "it is not clear which of the two words is to be written", "name one of them")
        middles = [x for x in found if isinstance(x, InRegion) and x.region == "middle"]
        if middles and any(isinstance(x, GoalPatch) for x in task.assets) and _EACH_MIDDLE.search(text):
            raise _asked(sentence, "in the middle of the table, or of the patches?", "say of what it is the middle")
        there = _AND_THERE.search(text)
        if there and {"it", "its", "that", "which", there[1]}.isdisjoint(there[3].split()):
            raise _asked(
                sentence, "both of these there, or the last one?", "say 'and' between the two, or say it alone"
            )
        shapes = sum(isinstance(x, _SHAPES) and len(x.blocks) > 1 for x in found)
        if shapes == 1 and _ANOTHER.search(text):
            raise _asked(sentence, "another block, or another such figure?", "say 'another tower', or 'another block'")
        unsaid = any(note.startswith("the number of") for note in task.assumptions)
        if unsaid and _TWO_SIZES.search(text):
            raise _asked(sentence, "it is not said how many of each size there are", "say how many there are of each")
        _place_of_another(sentence, text, found)
        if _IT_IS.match(text) and _distractors(task):
            raise _asked(sentence, "it is not clear of which block this is said", "name the block")


_SAME_CORNER = on_demand(r"\bin (?:exactly )?(?:the|that) (?:very )?same (?:corner|edge)\b")
_NOT = on_demand(r"\b(?:not|never|neither|no|none)\b")
_PUT_THERE = on_demand(
    r"\b(?:put|place|set|lay|move|bring|go|goes|come|comes|belongs?|be)(?: \w+)* (?:where it (?:is|was)|(?:in|at|on|to|"
    r"into) (?:its|(?:exactly )?(?:the|that) (?:very )?same) (?:place|spot|position|location))"
    r"(?: instead| too| as well)?$"
)
_OWN = on_demand(
    r"\b(?:back|left|kept|keep|keeping|leave|leaving|stays?|staying|remains?|remaining|own|still|again|held)\b"
)


def _corrected(sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put red on the mat. Put blue there instead" as both: the second is in place of the first."""
    words = [token.word for token in sentence]
    later = [n for n, (a, b) in enumerate(pairwise([*words, ""])) if a == "instead" and b != "of"]
    if not later or words[later[0] - 1] in lexicon.COLOR:  # "the middle one is blue instead"
        return
    parts = task.goal.goals if isinstance(task.goal, g.All) else (task.goal,)
    if any(isinstance(x, g.Sequence) for x in parts):
        return  # "on the green patch first, and in the end on the blue one instead"
    begun = [x.model_copy(update={"span": None}) for x in task.init.arranged]
    kept = any(x.model_copy(update={"span": None}) in begun for x in parts) or not begun
    if kept and not any(isinstance(x, g.Not) for x in parts):
        raise _asked(
            sentence, "is what was said before not to be so then?", "leave out what is not to be so at the end"
        )


def _place_of_another(sentence: Sequence[Token], text: str, found: Sequence[g.Goal]) -> None:
    """Refuse "A is on the mat. B should be in the same place" as B where it is, and "the same corner" as any."""
    corners = any(isinstance(x, InRegion) and x.region in ("corner", "edge") for x in found)
    if _SAME_CORNER.search(text) and (corners or _NOT.search(text)):
        raise _asked(sentence, "it is not clear with what this is in the same corner", "name the corner of each block")
    if _PUT_THERE.search(text) and not _OWN.search(text) and any(isinstance(x, Stayed) for x in found):
        raise _asked(sentence, "its own place, or that of another block?", "say 'stays where it is', or name the place")


def _distractors(task: TaskSchema) -> bool:
    """Whether there are blocks of which neither the goal nor the start says anything."""
    told = {name for goal in (*task.init.arranged, task.goal) for name in names(goal)}
    return any(block.name not in told for block in task.blocks)


def _asked(sentence: Sequence[Token], message: str, hint: str) -> Refusal:
    return refuse("ambiguous", message, (sentence[0].span[0], sentence[-1].span[1]), hint)
