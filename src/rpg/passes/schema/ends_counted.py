"""How many ends of a line are told to have a block of some kind, in the words that tell it and in the task."""

from __future__ import annotations

import re
from string import ascii_uppercase, digits

from rpg.blocks.traits import QUALITIES
from rpg.ir.assets import Block
from rpg.language import lexicon
from rpg.language.grammar.rows.vocabulary import COLOR, MUST
from rpg.passes.schema.line_said import Said
from rpg.passes.schema.numbers_had import symbols_of

_EXACTLY = "exactly|precisely|only|just|but"
_BOUND = f"(?P<bound>{_EXACTLY}|at most|no more than|not more than|at least|no fewer than|no less than)"
_KINDS = {**QUALITIES, "letter": ascii_uppercase, "digit": digits, "number": digits}
_SUCH = (
    f"(?:(?P<kind>{COLOR}|{'|'.join(_KINDS)})s?(?: ones?| blocks?| cubes?| numbers?| digits?)?"
    "|(?:letter |digit |block )?(?P<label>[a-z0-9]))"
)
_ENDS = "(?:the |both |either |each |one |an |its )?(?:two |of the |of its )?ends?\\b"
_END = "(?:of the |of its )?(?:two )?ends?\\b"
_IS = f"(?: {MUST} be| is| being)?"
_COUNTED = (
    re.compile(f"\\b{_BOUND} (?:one|an?) (?:of the )?{_SUCH}{_IS} (?:at|on) {_ENDS}"),
    re.compile(f"\\b{_SUCH}{_IS} (?:at|on) {_BOUND} one {_END}"),
    re.compile(f"\\b{_BOUND} one {_END}{_IS} {_SUCH}(?=$| [.,;!?]| and\\b)"),
)


def ends_counted(said: Said) -> None:
    """Refuse "with at most one red one at the ends" as with a red one at both of them, and "with a red one at only one
    end" as with one at that end, and perhaps at the other one."""
    match = next((found for pattern in _COUNTED if (found := pattern.search(said.text)) is not None), None)
    if match is None or len(said.lines) != 1 or said.begun:
        return
    ranks = said.lines[0].order.ranks or (said.lines[0].blocks,)
    such = {block.name for block in said.blocks(said.lines[0]) if _such(block, match)}
    surely = sum(such.issuperset(rank) for rank in (ranks[0], ranks[-1]))
    perhaps = sum(not such.isdisjoint(rank) for rank in (ranks[0], ranks[-1]))
    least = match["bound"] in ("at least", "no fewer than", "no less than")
    exactly = match["bound"] in _EXACTLY.split("|")
    fits = surely == 1 <= perhaps if least else surely == perhaps == 1 if exactly else surely == 0 and perhaps < 2
    hint = "say what is at either end: 'with a red one at one end and a blue one at the other'"
    if not fits and len(such) > (not exactly):
        raise said.refusal(match, "ambiguous", "what is at the two ends cannot be told in this way", hint)


def _such(block: Block, match: re.Match[str]) -> bool:
    """Whether a block is of the kind that is counted."""
    if match["label"]:
        return match["label"].upper() in symbols_of(block)
    if match["kind"] in lexicon.COLOR:
        return block.color == lexicon.COLOR[match["kind"]]
    return not symbols_of(block).isdisjoint(_KINDS[match["kind"]])
