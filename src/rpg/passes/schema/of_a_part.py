"""What is told of one part of a figure besides its colour is not told of the figure: "the outer two red and touching",
"the left one red, on the mat, the right one blue"; and "the left ones" are no single block."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.assets import SemanticCube
from rpg.ir.relations import InRegion
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms
from rpg.ir.walk import names as names_in
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_WHERE = frozenset({
    "left", "right", "upper", "lower", "top", "bottom", "middle", "center", "central", "front", "back", "near", "far",
    "outer", "inner", "outermost", "innermost", "ends", "corners", "last", *lexicon.ORDINAL,
})  # fmt: skip
_NAMED = rf"the (?:\w+ ){{0,2}}(?:{'|'.join(_WHERE)})\b"
_NOUN = "|".join((*lexicon.BLOCK, *lexicon.STRUCTURE, *lexicon.NUMBER, "one", "ones", "end", "side"))
_PART = rf"\b{_NAMED}(?: (?:{_NOUN}|\d+))*(?: (?:is|are|(?:should|must|shall) be))? (?:{COLOR})"
_LAID = r"touching|apart|turned|rotated|facing|upside|\d[\d.]* cm"
_PLACED = rf"{_LAID}|in|on (?=the|an?\b)|next to|beside|behind"
_AND_SO = on_demand(rf"{_PART} and (?:not )?({_PLACED}|on|{'|'.join(lexicon.SIZE)})\b(.*)")
_LOT_SO = on_demand(
    rf", (?:(?:{'|'.join(lexicon.NUMBER)}|\d+) (?:{COLOR}) (?:and|,)|"
    rf"the (?:{COLOR}|\w)(?: (?:{_NOUN}))? (?:on|at|in) (?:the )?\w+ and) (?:not )?({_LAID})\b(.*)"
)
_BETWEEN = on_demand(rf"{_PART}(?: ,)? ({_PLACED})\b[^,;]*[,;] (?:and )?(?:{_NAMED}|the (?:others?|rest)\b)(.*)")
_SIDE = rf"(?:{'|'.join(_WHERE)})"
_ONES = rf"(?:{'|'.join(word for word, many in lexicon.BLOCK.items() if many)}|ones)"
_SEVERAL = on_demand(rf"\bthe {_SIDE} {_ONES} (?:(?:is|are|being|(?:should|must|shall) be) )?(?:all )?({COLOR})\b|"
                      rf"\b({COLOR}) {_SIDE} {_ONES}\b")  # fmt: skip
_ONE = on_demand(rf"\b{_NAMED}(?: (?:one|block|letter|digit))? (?:(?:is|should be|must be) )?({COLOR})$")
_LAST_OF_ALL = on_demand(
    rf"^(?:an?|{'|'.join(lexicon.NUMBER)}|\d+) [^,;:]+ and (?:an?|one) (?:{COLOR}) (?:one|{CUBE}) in the "
    r"(?:very )?(?:middle|center)$"
)
_REST = on_demand(rf"\bthe (?:others|rest|other (?:ones|blocks)) (?:are|is|should be|must be) (?:all )?({COLOR})\b")


def check_parts(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a sentence in which more than its colour is told of a part, unless it is told so of the other part too,
    and one in which a part of several blocks has become one block.

    Raises:
        Refusal: "ambiguous".
    """
    for sentence in sentences(tokens):
        words = [token.word for token in sentence]
        text = " ".join(words)
        _rest(text, sentence, task)
        if "," not in words and _WHERE.isdisjoint(words):
            continue
        told = _AND_SO.search(text) or _LOT_SO.search(text) or _BETWEEN.search(text)
        if told is not None and not (told[1].strip() == "on" and " on " in told[2]):
            raise refuse("ambiguous", f"'{told[1].strip()}': said of this part, or of the whole?",
                         (sentence[0].span[0], sentence[-1].span[1]), "say it in a sentence of its own")  # fmt: skip
        for part in _SEVERAL.finditer(text):
            color = lexicon.COLOR[part[1] or part[2]]
            if sum(block.color == color for block in task.blocks) == 1:
                raise refuse("ambiguous", f"it is not said how many blocks '{part[0]}' are",
                             (sentence[0].span[0], sentence[-1].span[1]), "say 'the two ...'")  # fmt: skip
        _one(text, sentence, task)
        _of_so_many(text, tokens, task)
        several = any(isinstance(x, InRegion) and len(names_in(x)) > 1 for x in atoms(task.goal))
        if several and _LAST_OF_ALL.search(text.rstrip(" .!")):
            raise refuse("ambiguous", "is only the last one in the middle, or are all of them?",
                         (sentence[0].span[0], sentence[-1].span[1]),
                         "say 'all in the middle of the table', or 'in a row with ... in the middle'")  # fmt: skip


_PLACE = rf"(?:the )?(?:\w+ )?(?:{'|'.join(sorted(_WHERE))})(?: \w+)?"
_OF_SO_MANY = on_demand(
    rf"\b({'|'.join(lexicon.NUMBER)}|\d+) ({COLOR}) (?:{'|'.join(lexicon.BLOCK)})\b[^:]*?(?: with| where| in which| ,|"
    rf" but) the {_PLACE}(?:(?: ,| and| , and) {_PLACE})? (?:(?:is|are|being|(?:must|should) be) )?({COLOR})"
    r"(?= ?[,.;!]| and\b|$)"
)


def _of_so_many(text: str, tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of five white blocks with the second and the fourth red" as five white ones, and two red ones."""
    told = _OF_SO_MANY.search(text)
    one, other = (lexicon.COLOR[told[2]], lexicon.COLOR[told[3]]) if told is not None else ("", "")
    many = (lexicon.NUMBER.get(told[1]) or int(told[1])) if told is not None else 0
    named = [token for token in tokens if lexicon.COLOR.get(token.word, "-") == other]
    if one != other and len(named) == 1 and sum(block.color == one for block in task.blocks) >= many:
        raise refuse("ambiguous", "are these of the blocks that are counted, or further ones?", named[0].span,
                     "count without a color, and say how the rest looks: 'five blocks, the second one red and the rest "
                     "white'")  # fmt: skip


def _one(text: str, sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "(put A, B and C in a row.) The first one is green" as of a further block, or of a patch."""
    one = _ONE.search(text.rstrip(" .!"))
    such = [block for block in task.blocks if one is not None and block.color == lexicon.COLOR[one[1]]]
    shown = any(isinstance(block, SemanticCube) for block in task.blocks)
    further = shown and not any(isinstance(block, SemanticCube) for block in such)
    if one is not None and (further or (not such and task.patches)):
        raise refuse("ambiguous", f"it is not clear what '{one[0]}' is said of",
                     (sentence[0].span[0], sentence[-1].span[1]), "name the block")  # fmt: skip


def _rest(text: str, sentence: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "the others are white" where all are."""
    rest = _REST.search(text)
    if rest is not None and {block.color for block in task.blocks} == {lexicon.COLOR[rest[1]]}:
        raise refuse("ambiguous", "it is not said which blocks are no others",
                     (sentence[0].span[0], sentence[-1].span[1]), "say what the first ones look like")  # fmt: skip
