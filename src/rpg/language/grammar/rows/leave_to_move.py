"""Leave to move a block, which asks for nothing: "you may move the blue block but not the red one", "blue can be
moved, red must stay"."""

from __future__ import annotations

from functools import lru_cache

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import THINGS
from rpg.language.grammar.rows.turned import Turn, Turns, all_of_it, turned
from rpg.language.tokens import Token

_MAY = "(?:may|can|could|might|(?:is|are) (?:allowed|permitted|free) to)"
_FINE = "(?:allowed|permitted|ok|okay|fine|all right|alright)"
_LEAVE = (
    f"(?:(?:you|we|i|it|the robot|the robot arm|the arm|the gripper|the agent) {_MAY}|it is {_FINE} to|feel free to) "
    "(?:move|touch|shift)"
)
_MOVED = f"{_MAY} be (?:moved|touched|shifted)"
_BUT = "(?: ,)? (?:but|and|yet|while)"
_NOT = "(?:may|can|must|should|is) not(?: be)?(?: moved| touched| shifted)?"
_STAYS = "(?:must|should|has to) (?:stay|remain)(?: where it is| in place| put)?"
_END = "(?= \\.|$)"
_SENTENCE = "(^|\\. )"
_GIVEN = frozenset({"may", "can", "could", "might", "allowed", "permitted", "free", "fine", "ok", "okay"})
_MOVING = frozenset({"move", "moved", "touch", "touched", "shift", "shifted"})


def leave_to_move(tokens: list[Token]) -> list[Token]:
    """The tokens without such leave, where the rest speaks of the block; what must not be moved stays."""
    words = [token.word for token in tokens]
    if _GIVEN.isdisjoint(words) or _MOVING.isdisjoint(words) or "." not in words[:-1]:
        return tokens
    again = sorted({word for word in words if word in lexicon.COLOR and words.count(word) > 1})
    return turned(tokens, _turns(tuple(again)), all_of_it)


@lru_cache(maxsize=256)
def _turns(again: tuple[str, ...]) -> Turns:
    """Rows for leave to move what is named more than once; any other is told as what is not asked for."""
    rows: list[Turn] = []
    if again:
        one = f"(?:the )?(?:{'|'.join(again)})(?: block| cube| one)?"
        one = f"{one}(?:(?: ,)? (?:and|or) {one})*(?: blocks| cubes| ones)?"
        given = f"{_SENTENCE}(?:{_LEAVE} {one}|{one} {_MOVED})"
        rows = [
            (f"{given}{_BUT} (?:not ({THINGS})|({THINGS}) (?:{_NOT}|{_STAYS})){_END}", "{1} {2} {3} must not be moved"),
            (f"{given}(?: \\.|$)", "{1}"),
        ]
    return Turns((*rows, (f"{_SENTENCE}{_LEAVE} ({THINGS})(?={_BUT} not | \\.|$)", "{1} {2} may be moved")))
