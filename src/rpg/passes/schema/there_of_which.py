"""Where things are at the start, or how many there are, told so that it could be said of one of them, or of all: "a
tower and a green block by itself on the mat", "take the red blocks off the blue ones", "the same thing in blue"."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Above, InRegion, OnPatch, Stayed
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms, within
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.rows.vocabulary import COLOR
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.resolve.things.world import refuse

_ONE = f"(?:{'|'.join(lexicon.BLOCK)}|ones?)"
_MAT = f"(?:{COLOR} )?(?:{'|'.join(lexicon.PATCH_NOUNS.split())})"
_BUILT = "(?:row|tower|stack|line|column|pile|wall|grid|pyramid)"
_ON_MAT = rf"(?:on|in|inside) (?:the|a|an) {_MAT}\b"
_LAST_THERE = on_demand(
    rf"\b{_BUILT} .*\band (?:a|an|one) (?:[\w+=*/-]+ ){{1,2}}{_ON_MAT}"
    rf"|^[^,]*[^ ,] , and (?:a|an|one) (?:\w+ ){{1,2}}{_ON_MAT}"
    rf"|\b(?:and|,) (?:a|an|one) (?:\w+ ){{1,2}}(?:all )?(?:by itself|over there) {_ON_MAT}"
)
_SAME_IN = on_demand(rf"\bthe same(?: thing| one)?(?: again)? in ({COLOR})\b")
_SIDE_TOLD = on_demand(
    rf", (?:and )?(?:the )?({COLOR}|[a-z])(?: {_ONE})? (?:left|right)(?= ,| and|$)"
    rf"|\b({COLOR})(?: {_ONE})? is left$"
)
_ASSIGNED = on_demand(r" = (?:left|right|middle|center|front|back)(?= ,| and|$)")
_SIDES = frozenset({"left", "right"})
_LEFT_ON = on_demand(r"\b(?:leave|leaves|leaving|left|keep|keeping)\b.* on (?:the|a|it)\b")
_LEFT_THE_OTHERS = on_demand(
    rf"\boff (?:of )?(?:the|a) {_MAT}\b.*\b(?:leave|leaving|keep) (?:the|all) (?:the )?(?:other|others|rest)\b"
)
_OFF_AS_WELL = on_demand(rf"\boff\b.* and the ({COLOR}) {_ONE} off (?:of )?(?:the|a) {_MAT}\b")
_MANY_OFF_MANY = on_demand(
    rf"\b(?:take|get|remove|lift|pull|move|unstack|taken|come|removed) (?:all )?(?:of )?(?:the )?{COLOR} "
    rf"(?:blocks|cubes|ones) (?:off|from) (?:of )?(?:the )?{COLOR} (?:blocks|cubes|ones)\b"
)


def check_there_of_which(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse what is there of one or of all of them, or not said to be there at all.

    Raises:
        Refusal: "ambiguous", or "misplaced" where the start, or what is there, is told of too little.
    """
    texts = [([t for t in sentence if t.word not in STOPS]) for sentence in sentences([*tokens])]
    for said in texts:
        text = " ".join(token.word for token in said)
        if len(texts) > 1 or any(token.word in lexicon.STRUCTURE for token in said):  # else the whole list is meant
            _the_last_alone(said, text, task)
        _side_of_which(said, text, task)
        _assigned(said, text, task)
        _same_in_a_color(said, text, task)
        _left_there(said, text, task)
        _many_off_many(said, text, task)
    _a_different_one([token for said in texts for token in said], task)


def _the_last_alone(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "a tower of red on blue and a green block by itself on the mat" as all three on the mat."""
    if _LAST_THERE.search(text) is None:
        return
    for x in _facts(task):
        if isinstance(x, OnPatch) and len(members(x.a)) > 1:
            raise refuse("ambiguous", "is the last one there, or are all of them?", said[-1].span,
                         "say in a sentence of its own what is there")  # fmt: skip


def _side_of_which(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "a red and a blue block, the red one left" as of the left half of the table: it could be left of blue."""
    told = _SIDE_TOLD.search(text)
    if told is None or len(_SIDES & {token.word for token in said}) > 1:
        return
    look = told[1] or told[2]
    those = {
        block.name
        for block in task.blocks
        if {lexicon.COLOR.get(look), look.upper()} & {block.color, *symbols_of(block)}
    }
    if any(isinstance(x, InRegion) and those & {*members(x.a)} for x in _facts(task)):
        raise refuse("ambiguous", "left or right of the other one, or of the table?", said[-1].span,
                     "say 'left of ...', or 'in the left half of the table'")  # fmt: skip


def _assigned(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "red=left, blue=right" as of blocks that show "="."""
    if _ASSIGNED.search(text) is not None and any("=" in {block.color, *symbols_of(block)} for block in task.blocks):
        raise refuse("ambiguous", "on these sides of each other, or of the table?", said[0].span,
                     "say 'red is to the left of blue', or 'in the left half of the table'")  # fmt: skip


def _same_in_a_color(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "on the left two red blocks, on the right the same thing in blue" as one blue block."""
    told = _SAME_IN.search(text)
    if told is not None and sum(block.color == lexicon.COLOR.get(told[1]) for block in task.blocks) == 1:
        raise refuse("misplaced", "it is not read what is the same here", said[-1].span,
                     "say how many blocks of this colour there are, and how they lie")  # fmt: skip


def _left_there(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "leave one on the mat and take the others off" with nothing on the mat at the start."""
    begun = {(name, x.patch) for x in _begun(task) if isinstance(x, OnPatch) for name in members(x.a)}
    off = {(name, x.goal.patch) for x in within(task.goal) if isinstance(x, g.Not) and isinstance(x.goal, OnPatch)
           for name in members(x.goal.a)}  # fmt: skip
    on = {(name, x.patch) for x in atoms(task.goal) if isinstance(x, OnPatch) for name in members(x.a)} - off
    mats = {patch for _, patch in off}
    gone = _OFF_AS_WELL.search(text)
    color = lexicon.COLOR.get(gone[1]) if gone is not None else None
    lost = [name for name, patch in off - begun if (name in {b.name for b in task.blocks if b.color == color})]
    if _LEFT_ON.search(text) is not None:
        lost += [name for name, patch in (on | off) - begun if patch in mats]
    if _LEFT_THE_OTHERS.search(text) is not None:
        stay = {name for x in atoms(task.goal) if isinstance(x, Stayed) for name in members(x.a)}
        lost += [name for name in stay for patch in mats if (name, patch) not in begun]
    if lost:
        raise refuse("misplaced", "it is not said that all of these are on it at the start", said[0].span,
                     "say what is on it at the start, in a sentence of its own")  # fmt: skip


def _many_off_many(said: Sequence[Token], text: str, task: TaskSchema) -> None:
    """Refuse "take the red blocks off the blue ones": on which of these is each of them at the start?"""
    if _MANY_OFF_MANY.search(text) is None:
        return
    off = {name for x in within(task.goal) if isinstance(x, g.Not) and isinstance(x.goal, Above)
           for name in members(x.goal.a)}  # fmt: skip
    begun = {name for x in _begun(task) if isinstance(x, Above) for name in members(x.a)}
    told = any(not isinstance(x, Above) for x in _begun(task))
    if len(off) > 1 and not told and off - begun:
        raise refuse("ambiguous", "which of these lie on which at the start?", said[0].span,
                     "say how they are stacked at the start")  # fmt: skip


def _a_different_one(said: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "three blocks of the same colour. Stack them, with a different one on top" as all of one colour."""
    words = [token.word for token in said]
    for n, word in enumerate(words[:-1]):
        same = "same" in words[:n] and word == "different" and words[n + 1] in (*lexicon.BLOCK, "one")
        if same and words[n - 1] in ("a", "one") and len({block.color for block in task.blocks}) == 1:
            raise refuse("ambiguous", "of another colour, or another one of these?", said[n].span,
                         "say how many blocks of which colour there are")  # fmt: skip


def _begun(task: TaskSchema) -> Iterable[g.Goal]:
    return (x for part in task.init.arranged for x in atoms(part))


def _facts(task: TaskSchema) -> Iterable[g.Goal]:
    yield from _begun(task)
    yield from atoms(task.goal)
