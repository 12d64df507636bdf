"""Towers and rows that are stacked, one on the other: "put A on B and C on D and stack the two towers", "six blocks in
two rows, one on top of the other"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.relations import Above, On
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Cells, Row, Stack, Towers
from rpg.ir.walk import atoms
from rpg.language import lexicon
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.structures.towers_apart import which_on_which
from rpg.passes.schema.resolve.things.world import refuse

_TOWERS = "|".join(word for word, (kind, many) in lexicon.STRUCTURE.items() if kind == "stack" and many)
_STACK = "|".join(
    word
    for word, forms in lexicon.VERB.items()
    if any((sense, tense) == ("stack", "base") for sense, _, tense in forms)
)
_NOUN = on_demand(rf"\b(?:{'|'.join(sorted({*lexicon.BLOCK, *lexicon.STRUCTURE, *lexicon.PATCH} - {'stack'}))})\b")
_THE = r"(?:the|both|these|those|all)(?: of)?(?: the)?(?: (?:two|three|both))?"
_STACKED = on_demand(
    rf"\b(?:{_STACK})(?: up)? (?:{_THE} (?P<towers>{_TOWERS})|"
    r"(?:them|both|both of them)(?= (?:up )?[.;!?,]| on (?:top of )?each other| and\b))"
)


_LINES = "|".join(word for word, (_, many) in lexicon.STRUCTURE.items() if many)
_OVER = r"(?:on(?: top of)?|above|over|atop|upon)"
_EACH = r"(?:each other|one another)"
_ONE_ON_OTHER = on_demand(
    rf"\b(?P<lines>{_LINES})\b(?: of \w+)?(?: ,)?(?: with)? (?:one(?: \w+)? {_OVER} the other|on top of {_EACH})\b"
)


def check_one_on_other(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "six red blocks in two rows, one on top of the other" as two rows on the table."""
    said = " ".join(token.word for token in words)
    found = _ONE_ON_OTHER.search(said)
    told = [*atoms(task.goal)]
    flat = any(isinstance(x, Row | Towers | Stack) for x in told) and not any(isinstance(x, On | Above) for x in told)
    if found is not None and flat and not any(isinstance(x, Cells) for x in told):
        at = len(said[: found.start()].split())
        raise refuse("ambiguous", "it is not clear which block goes on which", words[at].span,
                     "say how many blocks are in each layer, as in 'a wall of two layers of three'")  # fmt: skip


def check_towers_stacked(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "stack the two towers" where they still stand by themselves in the end."""
    said = " ".join(["", *(token.word for token in words), "."])
    found = _STACKED.search(said)
    if found is None:
        return
    before = _NOUN.findall(said[: found.start()])
    kind = lexicon.STRUCTURE.get(before[-1], ("", False))[0] if before else ""
    of_towers = found["towers"] is not None or kind == "stack"
    apart = [x for x in atoms(task.goal) if isinstance(x, Stack | Towers)]
    if of_towers and (len(apart) > 1 or any(isinstance(x, Towers) for x in apart)):
        at = len(said[: found.start()].split())
        raise which_on_which(words[at].span)
