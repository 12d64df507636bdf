"""Blocks that are dealt out by number: "put six blocks on the two mats, two on the red one and four on the blue one",
"three of the six blocks on the red mat and three on the blue one", told of one patch after the other."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH, PATCHES, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_DEAL = "(?:please )?(?:put|place|set|move|bring|lay|distribute|spread|share|divide|deal|split)(?: out)?"
_OVER = "(?:out )?(?:on|onto|over|among|between|across|in|into|to)"
_GO = f"(?:{MUST} (?:be|go|lie)|are|is|go|goes|lie|lies)"
_BLOCKS = f"(?:(?P<color>{COLOR}) )?(?:blocks|cubes|bricks|boxes)"
_ON = f"(?:on|onto|in|into) (?:the )?({COLOR}|left|right)"
_SOME = f"(?:exactly |just )?({MANY})(?: (?:of (?:them|these)|others|more))?"
_LOT = f"{_SOME}(?: {_GO})? {_ON}(?: one| {PATCH})?"
_NEXT = "(?: ,| ;| and| , and)"
_BEGIN, _END = "(?:^|(?<=[.!?;:] ))", "(?= [.!;]|$)"
_DEALT = (
    on_demand(
        f"{_BEGIN}(?:{_DEAL} )?(?:all )?(?:of )?(?:the |my )?(?P<many>{MANY}) {_BLOCKS}(?P<over>(?: {_GO})? "
        f"{_OVER} (?:the "
        f"|these |my |both )?(?:(?P<marks>{MANY}) )?{PATCHES})?(?: [,:(]| so that) (?P<lots>{_LOT}(?:{_NEXT} {_LOT})+)"
        f"(?: \\))?{_END}"
    ),
    on_demand(
        f"{_BEGIN}(?:{_DEAL} )?(?:exactly |just )?(?P<some>{MANY}) of (?:the |my )?(?P<many>{MANY}) "
        f"{_BLOCKS}(?: {_GO})? "
        f"(?:on|onto|in|into) (?:the )?(?P<there>{COLOR}|left|right) {PATCH}(?P<lots>(?:{_NEXT} {_LOT})+){_END}"
    ),
    on_demand(
        f"{_BEGIN}(?P<out>out of|of|from) (?:the |my )?(?P<many>{MANY}) {_BLOCKS}(?: ,)? (?:{_DEAL} )?"
        f"(?P<lots>{_LOT}(?:{_NEXT} {_LOT})+){_END}"
    ),
)
_LOTS = on_demand(_LOT)
_ITEM = f"(?:the )?(?:(?:{COLOR})(?: (?:block|cube|one))?|[a-z0-9])"
_LIST = (
    f"(?P<listed>(?:the )?(?:(?:blocks|cubes|letters) )?{_ITEM}(?: , {_ITEM})*(?: ,)? and {_ITEM}"
    "(?: (?:blocks?|cubes?))?)"
)
_SO_MANY = f"(?:exactly |just |only )?(?P<some>{MANY})"
_REST = f"the (?:others?|other ones?|rest)(?: {MANY})?(?: of them)?"
_OF_THE_LISTED = tuple(
    on_demand(
        f"{_BEGIN}(?:{_DEAL} )?{begun}(?: {_GO})? (?:on|onto|in) the (?P<there>{COLOR}) {PATCH}"
        f"(?:{_NEXT}| , while| while| but| , but| \\.)(?: and| but)? {_REST}(?: {_GO})?(?: (?:put|placed))? "
        f"(?:on|onto|in) the (?P<else>{COLOR}) (?:one|{PATCH}){_END}"
    )
    for begun in (f"{_SO_MANY} of {_LIST}", f"(?:of|out of|from) {_LIST}(?: ,)? {_SO_MANY}")
)
"""Different blocks, of which so many are on one patch and the others on another."""
_OUT_OF = frozenset({"of", ",", ":", "(", "that"})


def so_many_on_each(tokens: list[Token]) -> list[Token]:
    """The tokens with how many of all the blocks are to be on each patch; as they are where the numbers do not fit."""
    words = {token.word for token in tokens}
    if words.isdisjoint(lexicon.PATCH) or words.isdisjoint(_OUT_OF):
        return tokens
    text = text_of(tokens)
    for listed in filter(None, (pattern.search(text) for pattern in _OF_THE_LISTED)):
        if (told := _of_the_listed(listed)) is not None:
            begin, end = listed.span("listed")
            parts = (text[listed.start() : begin], listed["listed"], text[end : listed.end()])
            return turned(tokens, Turns([("{}({}){}".format(*map(re.escape, parts)), told)]), all_of_it)
    for pattern in _DEALT:
        if (dealt := pattern.search(text)) is not None and (told := _told(dealt.groupdict())) is not None:
            return turned(tokens, Turns([(f"^{re.escape(dealt.group())}$", told)]))
    return tokens


def _of_the_listed(listed: re.Match[str]) -> str | None:
    """How many of those that are listed go on each of the two patches."""
    some, of_all = number(listed["some"]), len(re.split(" , and | , | and ", listed["listed"]))
    if not 0 < some < of_all or listed["there"] == listed["else"]:
        return None
    lots = ((some, listed["there"]), (of_all - some, listed["else"]))
    named = "the blocks {1}" if re.match(r"[a-z0-9]\b", listed["listed"]) else "{1}"  # letters by themselves
    return " . ".join(f"exactly {many} of {named} must be on the {color} patch" for many, color in lots)


def _told(dealt: dict[str, str]) -> str | None:
    """How many of them go on each patch; nothing where there are fewer than are dealt, or where some are left over of
    those that are all put there."""
    if "over" in dealt and not (dealt["over"] or re.search(f"\\b{PATCH}\\b", dealt["lots"])):
        return None  # "two on red and four on blue" are on blocks
    some = [(dealt["some"], dealt["there"])] if "some" in dealt else []
    lots = {color: number(many) for many, color in (*some, *_LOTS.findall(dealt["lots"]))}
    total, dealt_out = number(dealt["many"]), sum(lots.values())
    if (
        dealt_out > total
        or (dealt_out < total and not some and "out" not in dealt)
        or number(dealt.get("marks") or str(len(lots))) != len(lots)
    ):
        return None
    blocks = f"the {total} {dealt['color'] or ''} blocks"
    return " . ".join(f"exactly {many} of {blocks} must be on the {color} patch" for color, many in lots.items())
