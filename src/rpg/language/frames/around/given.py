"""A figure that is there already, and what is to be done: the figure told again as that of the start."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from rpg.language import lexicon
from rpg.language.frames.pieces import coded, joined
from rpg.language.tokens import Token

_TALK = "(?:okay|ok|so|now|look|well|hi|hello|imagine|suppose|assume|say|let us say|that|,|:)"
_THERE = (
    r"(?:i|we|somebody|someone|(?:my|our|the) \w+) (?:(?:have|has) )?(?:already |just )?(?:built|set up|put up)|"
    "(?:the )?(?:scene|"
    "TABLE|world|setup) (?:has|contains|shows|holds)|"
    "there (?:is|are|stands?|lies?|lie)|(?:here )?(?:we|i|you) (?:already )?(?:have|see|get|got|begin with|start "
    "with|are "
    "given)|(?:you are )?given(?: is| are)?|(?:starting|start|beginning|begin|starts) (?:from|with|out with)|on the "
    "TABLE(?: there)? (?:is|are|stands?|lies?|lie)|(?:the )?(?:initial|starting|start) (?:state|configuration|layout|"
    "arrangement|scene|setup)(?: is| :| shows| has)?|(?:initially|at the (?:start|beginning)|in the beginning)(?: "
    ",)?(?: "
    "(?:there (?:is|are)|we have|you have))?|(?:the )?(?:episode|task|scene|trial|world)(?: always)? (?:starts|"
    "begins|opens)"
    "(?: out)? (?:with|from|as|in)|(?:it|everything) (?:starts|begins)(?: out)? (?:with|from|as)|(?:start|before|"
    "init|"
    "initial) :"
)
_ALREADY = (
    "(?:already|ready|currently|now|presently|at present|at the moment|right now|here|there|built|standing|lying)"
)
_AHEAD = rf"(?:{_TALK} )*(?:{_THERE})(?: {_ALREADY})*(?: ,| :)?"
_BEHIND = (
    rf"(?: (?:(?:that|which) )?(?:is |are |stands? |lies? )?(?:{_ALREADY} )*(?:{_ALREADY}|on the TABLE|in front of "
    rf"(?:you|me|the robot|us)))*"
)
_STANDS = (
    rf"(?: (?:(?:{_ALREADY} )*(?:stands?|lies?|is|are)(?: {_ALREADY})+|already (?:stands|lies|is)|(?:is|are) "
    rf"(?:given|"
    rf"there)|(?:stands?|lies?|sits?|rests?|is|are)(?= on the TABLE))(?: on the TABLE)?)"
)
_STOPS = frozenset({".", ";", "!", "?"})
_JOINS = frozenset({",", "and", "then", "but", ":"})
_TURNED = frozenset({"reverse", "turn", "flip", "invert", "reversed", "around"})
_MOST = 4
_GOAL = re.compile(
    r"(?:(?:[,;:.]|and|then|now|please|but|so|i want you to|you (?:should|must|have to|need to)|your (?:task|job|"
    r"goal) is "
    r"to|(?:the )?(?:goal|task|aim|job)(?: is)?(?: to)?(?: :)?|can you|could you|would you|we want to|i want to|i "
    r"would "
    r"like you to|the robot (?:should|must|has to|shall)|it ends (?:with|as|in)|it should end (?:with|as)|and ends "
    r"(?:with|as)|at the end(?: ,)?(?: there (?:is|are|should be|must be))?|in the end(?: ,)?(?: there (?:is|are|"
    r"should "
    r"be|must be))?|end(?: :)?|target(?: :)?|after(?: :)|result(?: :)|first(?: ,)?) )*"
)


def with_given(
    tokens: Sequence[Token], plainly: Callable[[Sequence[Token]], str | None]
) -> Iterator[tuple[str, Sequence[Token], Sequence[Token]]]:
    """What is told of the start in plain sentences, the words that tell it, and those that tell what is to be done."""
    words = coded(tokens)
    found = 0
    for n in range(3, len(words)):
        if words[n - 1] not in _STOPS | _JOINS and words[n] not in _JOINS:
            continue
        start, rest = tokens[:n], tokens[n:]
        while rest and (rest[0].word in _STOPS | _JOINS):
            rest = rest[1:]
        while start and (start[-1].word in _STOPS | _JOINS):
            start = start[:-1]
        if not rest or not start or not _asks(coded(rest)):
            continue
        if (figure := _given(start)) and (said := plainly(figure)) and (told := at_start(said)):
            if ":" not in told and not _TURNED.isdisjoint(coded(rest)):
                continue  # it is not told which way it is now
            yield told, tokens[:n], _aim(rest)
            found += 1
        if found == _MOST:
            return


def existing(
    tokens: Sequence[Token], plainly: Callable[[Sequence[Token]], str | None]
) -> Iterator[tuple[str, Sequence[Token], Sequence[Token]]]:
    """The same of "the existing tower of two red blocks", "a tower of two red blocks that is already there", at the end
    of what is to be done."""
    tokens = tokens[:-1] if tokens and tokens[-1].word == "." else tokens
    words = coded(tokens)
    text, places = joined(words)
    ends = [n for n in range(3, len(words)) if _LAST.fullmatch(text, places[n] - 1)]
    ends = [n for n in ends if not {"already", "that", "which"}.isdisjoint(words[n:])]
    for n in range(1, len(words) - 3):
        if words[n - 1] not in ("the", "a", "an"):
            continue
        known = words[n] in ("existing", "given", "current")
        first, end = (n + 1, len(words)) if known else (n, ends[0] if words[n] in lexicon.STRUCTURE and ends else 0)
        figure = [*tokens[first:end], tokens[n].saying(".")]
        if end > first and (said := plainly(figure)) and (told := at_start(said)):
            yield told, tokens[:first], [*tokens[: n - 1], tokens[n - 1].saying("the"), *tokens[first:end]]


def _given(tokens: Sequence[Token]) -> Sequence[Token]:
    """The words that tell of a figure that is there already; none if they do not."""
    words = coded(tokens)
    text, places = joined(words)
    ahead = _FIRST.match(text)
    end = next((n for n in range(1, len(words)) if _LAST.fullmatch(text, places[n] - 1)), len(words))
    begin = places.index(ahead.end()) if ahead and ahead.end() in places else 0
    stands = next((n for n in range(1, len(words)) if _STAND.fullmatch(text, places[n] - 1)), 0)
    if not begin and not stands:
        return ()
    return tokens[begin : min(end, stands or end)]


def _asks(words: Sequence[str]) -> bool:
    """Whether something is to be done."""
    lead = _GOAL.match("".join(f"{word} " for word in words))
    behind = words[lead[0].count(" ") :] if lead else words
    return bool(behind) and (
        behind[0] in ("do", "leave", "keep", "without")
        or behind[0] in lexicon.COMMANDS
        or bool(lead and lead[0].strip(" ,;:."))
    )


def _aim(tokens: Sequence[Token]) -> Sequence[Token]:
    """What is to be done, without words that only lead to it."""
    words = coded(tokens)
    lead = _GOAL.match("".join(f"{word} " for word in words))
    count = lead[0].count(" ") if lead else 0
    kept = {"first", "then"} & set(words[:count])
    return tokens if kept else tokens[count:]


def at_start(said: str) -> str:
    """Plain sentences about a figure as it is to be, told as how things stand at the start; "" where that is not
    clear."""
    first, *others = re.findall(r"[^.]+\.", _in_order(said))
    figure = re.match(r"Build (?=an? )", first)
    row = re.match(r"Lay (?P<blocks>(?:the )?.+?) in a (?P<row>row|line|column)", first)
    if not figure and not row:
        return ""
    if any(re.match(r" (?:Then|First|Put|Lay|Build|There)\b", text) for text in others):
        return ""
    if row:
        verb = "is" if row["blocks"].startswith("1 ") and " and " not in row["blocks"] else "are"
        text = f"At the start, {row['blocks']} {verb} in a {row['row']}{first[row.end() :]}"
    else:
        text = f"At the start, there is {first[len('Build ') :]}"
    told = [f" At the start, {text.strip()[0].lower()}{text.strip()[1:]}" for text in others]
    return "".join([text, *told])


def _in_order(said: str) -> str:
    """A tower of which it is told where each block is, as one that is told in order."""
    placed = dict(
        reversed(found) for found in re.findall(r"The (\S+) block is (at the bottom|in the middle|at the top)\.", said)
    )
    blocks = re.match(r"Build a tower from ((?:(?: and )?1 \S+ block)+)\.", said)
    if not blocks or len(placed) != blocks[1].count("block"):
        return said
    order = [placed[place] for place in ("at the bottom", "in the middle", "at the top") if place in placed]
    return f"{blocks[0][:-1]}, from bottom to top: {', '.join(order)}."


def _compiled(text: str) -> re.Pattern[str]:
    return re.compile(text.replace("TABLE", f"(?:{'|'.join(lexicon.TABLE_NOUNS.split())})"))


_FIRST = _compiled(f"(?:{_AHEAD}) ")
_LAST = _compiled(f"{_BEHIND[:-2]})+ ")
_STAND = _compiled(f"{_STANDS} ")
