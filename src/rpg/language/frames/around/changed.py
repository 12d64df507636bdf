"""A tower that is there, and one change to it: its top taken off, a block put in or replaced."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from rpg.language import lexicon
from rpg.language.frames.around.attached import SIDES
from rpg.language.frames.pieces import Pattern, Unclear, coded
from rpg.language.tokens import Token

Plainly = Callable[[Sequence[Token]], str | None]

_KNOWN = "(?:existing|given|present|current|initial|starting|whole|standing|old)"
_TOWER = rf"(?:(?:the|that|this|your|its) (?:{_KNOWN} )?(?:tower|stack|pillar)|it)"
_OF_TOWER = rf"(?: (?:(?:off|from|of|out of|in|on|down from|away from|off of) )+{_TOWER})"
_PART = (
    r"(?:the (?P<end>top|topmost|uppermost|upper|highest|bottom|lowest|bottommost|lower|middle|center)(?: most)?|"
    r"the (?P<known>COLOR))"
)
_ITS = rf"{_PART}(?: (?P<count>\d+|one))?(?: COLOR)?(?: (?:BLOCK|one|ones))?"
_NEW = r"(?:a|an|one|1|another|the)(?: new| further)? (?P<new>COLOR)(?: (?:BLOCK|one))?"
_LEAD = (
    r"(?:(?:please|now|then|just|,|\.|:|and|so|first|can you|could you|would you|will you|you should|you must|i "
    r"want you to|"
    r"(?:let|have|make) the robot|"
    r"i would like you to|we want to|i want to|the robot (?:should|must|has to|shall|is to|needs to)|robot|your "
    r"(?:task|job|"
    r"goal) is to|(?:the )?(?:goal|task|aim)(?: is)?(?: to)?(?: :)?) )*"
)
_THEM = "(?:it|them|that|this|that (?:one|block)|the (?:block|cube|BLOCK)|the COLOR (?:one|block|cube|BLOCK))"
_PUT = "(?:put|place|lay|set|position|move|leave|stand)"
_TAKE = "(?:take|remove|lift|pull|pick|grab|get|move|put|place|bring|lay|set|unstack|shift|transfer)"
_AWAY = "(?:off|away|down|up|out|aside)"
_DOWN = "(?: (?:down|on the TABLE|onto the TABLE|to the TABLE|flat|again|back))*"
_REST = (
    rf"(?:{_TOWER}|the (?:rest|others|remaining (?:tower|stack|blocks|ones)|rest of {_TOWER}|remainder|others)|"
    rf"what is left|them|"
    r"the (?:remaining|other) (?:\d+|BLOCK|blocks|cubes|tower))"
)
_WHERE = rf"(?P<where>{'|'.join(f'(?P<side{n}>{ways})' for n, (_, ways) in enumerate(SIDES[:6]))}) {_REST}"
_AIM = (
    rf"(?: (?:,|\.|;)?(?: ?(?:so that|so|such that|until|then|at the end|finally))*(?: {_TOWER}| the result)?(?: "
    rf"(?:then|now|"
    r"finally|should|must|will|shall|has to))*(?: (?:read|reads|is|be|becomes|become|goes|go|shows|consists of|has|"
    r"looks|"
    r"have))(?: like)?(?: :)? (?P<aim>COLOR(?:(?: ,| and| then)+ COLOR)+)(?P<way> from (?:the )?(?:bottom|top) to "
    r"(?:the )?"
    r"(?:top|bottom)| (?:bottom|top) to (?:top|bottom))?)?"
)
TOLD = [
    Pattern("take",
        rf"{_LEAD}(?:(?:from|off) {_TOWER} (?:, )?)?(?:{_TAKE} )(?:{_AWAY} )*{_ITS}(?:{_OF_TOWER})?(?: "
        rf"{_AWAY})*{_OF_TOWER}?(?:(?: ,| and| then)* {_PUT} "
        rf"{_THEM})?{_DOWN} {_WHERE}"),
    Pattern("replace",
        rf"{_LEAD}(?:replace|exchange|substitute|change|swap)(?: out)? {_ITS}{_OF_TOWER}? (?:with|by|for|against|"
        rf"to|into) "
        rf"{_NEW}{_AIM}"),
    Pattern("insert",
        rf"{_LEAD}(?:insert|put|place|slide|add|squeeze|push|slip) {_NEW}(?: in| into)? between (?:(?:the|its) "
        rf"(?:two|2|both) "
        rf"(?:(?P<two>COLOR) )?(?:BLOCK|ones)|them|(?:the )?(?P<one>COLOR)(?: BLOCK| one)? and (?:the "
        rf")?(?P<other>COLOR)"
        rf"(?: BLOCK| one)?){_OF_TOWER}?{_AIM}"),
    Pattern("under",
        rf"{_LEAD}(?:insert|put|place|slide|add|squeeze|push|slip) {_NEW} (?:underneath|under|below|beneath|at the "
        rf"bottom|"
        rf"(?:underneath|under|below|beneath|at the bottom of) (?:{_TOWER}|them)){_AIM}"),
]  # fmt: skip
_TOLD = re.compile(
    rf"\b(?:the|an?) (?:{_KNOWN} )?(?:(?P<color>[a-z]+) )?(?P<figure>tower|stack|pillar)(?P<list> (?:made |built |"
    rf"consisting |formed )?"
    rf"(?:of|from|out of|with) (?:(?!, and |and (?:put|place|lay|set|then)|, (?:put|then|so)|by |with a |so |to |"
    rf"for ).)+?)"
    rf"(?= (?:and (?:put|place|lay|set|then|move)|, and|, (?:remove|take|lift|move)|remove|take|lift|move|by|with "
    rf"an?|so|to|for|, so|, then|off|next|beside|in front|behind|"
    rf"on|onto|down)\b|\s*$)"
)


def changes(tokens: Sequence[Token], plainly: Plainly, given: Sequence[tuple[str, Sequence[Token]]]) -> Iterator[str]:
    """A text in plain sentences, for each way in which a tower and a change to it can be found. `given`: towers that
    are told ahead of what is to be done, and that."""
    for start, aim in given:
        if (blocks := _listed(start)) and (said := _changed(blocks, _text(aim))):
            yield said
    text = _text(tokens)
    for match in _TOLD.finditer(text):
        n, m = text[: match.start()].count(" "), text[: match.end()].count(" ") + 1
        figure = [*tokens[n + 1 : m], tokens[n].saying(".")]
        blocks = _listed(plainly(figure) or "")
        if blocks and (told := _changed(blocks, f"{text[: match.start()]}the tower{text[match.end() :]}")):
            yield told
    if told := _from_aim(text):
        yield told


def _text(tokens: Sequence[Token]) -> str:
    return " ".join(coded(tokens)).strip(" .;!")


def _listed(said: str) -> list[str]:
    """The looks of a tower's blocks from bottom to top, where they follow from what is told of it."""
    alike = re.fullmatch(r"(?:Build|At the start, there is) a tower from (\d+) ([a-z]+) blocks?\.", said)
    if alike:
        return [alike[2]] * int(alike[1])
    order = re.fullmatch(
        r"(?:Build|At the start, there is) a tower from [^.:]+, from (bottom|top) to \w+: ([a-z, ]+)\.", said
    )
    listed = order[2].split(", ") if order else []
    return listed if order and order[1] == "bottom" else listed[::-1]


def _from_aim(text: str) -> str:
    """What is told of a tower that was there before, by what it is to be when a block is put in."""
    for pattern in TOLD:
        match = pattern.expression.fullmatch(f"{text} ")
        if pattern.kind != "insert" or not match or not match["aim"]:
            continue
        aim = _aim(match)
        if (
            len(aim) != 3
            or aim[1] != match["new"]
            or (match["two"] or aim[0]) != aim[0]
            or (match["two"] and aim[2] != aim[0])
        ):
            continue
        if match["one"] and {match["one"], match["other"]} != {aim[0], aim[2]}:
            continue
        if aim == aim[::-1] or match["way"]:
            return _outcome([aim[0], aim[2]], aim)
    return ""


def _aim(match: re.Match[str]) -> list[str]:
    """The looks that the tower is to have, from bottom to top, or as they are told."""
    listed = re.findall(r"[a-z]+", re.sub(r"\b(?:and|then)\b", "", match["aim"]))
    down = re.match(r" (?:from )?(?:the )?top ", match["way"] or "")
    return listed[::-1] if down else listed


def _changed(blocks: list[str], text: str) -> str:
    """What comes out of a change, if that is clear."""
    for pattern in TOLD:
        match = pattern.expression.fullmatch(f"{text} ")
        if match is None:
            continue
        try:
            return _CHANGE[pattern.kind](blocks, match)
        except Unclear:
            return ""
    return ""


def _at(blocks: list[str], match: re.Match[str]) -> range:
    """Which of the blocks are meant.

    Raises:
        Unclear: it is not clear.
    """
    count = int(match["count"]) if (match["count"] or "one").isdigit() else 1
    if match["known"]:
        if blocks.count(match["known"]) != 1 or count > 1:
            raise Unclear
        at = blocks.index(match["known"])
        return range(at, at + 1)
    if count >= len(blocks):
        raise Unclear
    if match["end"] in ("middle", "center"):
        if len(blocks) % 2 == 0 or count > 1:
            raise Unclear
        return range(len(blocks) // 2, len(blocks) // 2 + 1)
    low = match["end"] in ("bottom", "lowest", "bottommost", "lower")
    if low and count > 1:
        raise Unclear
    found = range(count) if low else range(len(blocks) - count, len(blocks))
    named = re.search(rf"the {match['end']}(?: most)?(?: (?:\d+|one))? ([a-z]+) ", match[0])
    looks = {blocks[n] for n in found}
    if named and named[1] in lexicon.COLORS and looks != {named[1]}:
        raise Unclear
    return found


def _taken(blocks: list[str], match: re.Match[str]) -> str:
    """Blocks are taken off the top, and put beside what is left.

    Raises:
        Unclear: others than those at the top are meant, or too few are left.
    """
    at = _at(blocks, match)
    if at[-1] != len(blocks) - 1 or len(blocks) - len(at) < 2 or len({blocks[n] for n in at}) > 1:
        raise Unclear
    left, look = blocks[: at[0]], blocks[at[0]]
    side = next(SIDES[n][0] for n in range(6) if match[f"side{n}"])
    first = "another" if look in left else "a"
    put = " ".join(f"Put {'another' if n else first} {look} block {side} the tower." for n in range(len(at)))
    return f"Build {_told(left)}. {put} At the start, all blocks form {_ordered(blocks)}."


def _replaced(blocks: list[str], match: re.Match[str]) -> str:
    """One block is replaced."""
    at = _at(blocks, match)
    if len(at) > 1 or match["new"] in blocks:
        raise Unclear
    return _agreed(blocks, [*blocks[: at[0]], match["new"], *blocks[at[0] + 1 :]], match)


def _inserted(blocks: list[str], match: re.Match[str]) -> str:
    """A block is put between two."""
    if match["one"]:
        pair = {match["one"], match["other"]}
        places = [n for n in range(1, len(blocks)) if {blocks[n - 1], blocks[n]} == pair]
    else:
        two = match["two"]
        places = [1] if len(blocks) == 2 and two in (None, *blocks) and (two is None or set(blocks) == {two}) else []
    if len(places) != 1 or match["new"] in blocks:
        raise Unclear
    return _agreed(blocks, [*blocks[: places[0]], match["new"], *blocks[places[0] :]], match)


def _under(blocks: list[str], match: re.Match[str]) -> str:
    """A block is put under all of them."""
    if match["new"] in blocks:
        raise Unclear
    return _agreed(blocks, [match["new"], *blocks], match)


def _agreed(blocks: list[str], after: list[str], match: re.Match[str]) -> str:
    """The outcome, which is what it is told to be, if it is.

    Raises:
        Unclear: it is another one.
    """
    if match["aim"] and after != _aim(match) and (match["way"] or after != _aim(match)[::-1]):
        raise Unclear
    return _outcome(blocks, after)


def _outcome(blocks: list[str], after: list[str]) -> str:
    return f"At the start, there is {_told(blocks)}. Build {_told(after)}."


def _told(blocks: list[str]) -> str:
    counts = Counter(blocks)
    lots = " and ".join(f"{n} {look} block{'s' if n > 1 else ''}" for look, n in counts.items())
    return f"a tower from {lots}{_order(blocks)}"


def _ordered(blocks: list[str]) -> str:
    return f"a tower{_order(blocks)}"


def _order(blocks: list[str]) -> str:
    return f", from bottom to top: {', '.join(blocks)}" if len(set(blocks)) > 1 else ""


_CHANGE: dict[str, Callable[[list[str], re.Match[str]], str]] = {
    "take": _taken,
    "replace": _replaced,
    "insert": _inserted,
    "under": _under,
}
"""What comes out of each kind of change (or it raises Unclear)."""
