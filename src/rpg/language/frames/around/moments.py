"""Which part of a text tells of the start and which of the end, by the words that lead to it, told in plain words."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from rpg.language.frames.pieces import coded
from rpg.language.tokens import Token

Moment = Literal["start", "end", ""]

_STATE = (
    "(?:state|configuration|config|layout|arrangement|setup|scene|situation|position|condition|picture|image|scenario|"
    "pose|poses)"
)
_IS = (
    "(?:(?:(?: must| should| shall| has to| needs to)?(?: satisfy| satisfies| fulfills?| meets?| have| show)(?: the "
    "following(?: conditions?| requirements?| constraints?)?)?| is| are| shows| has| contains| looks like this| "
    "consists of| means| requires)?"
    "(?: that| to have| to be)?(?: :)?| ,| -)?"
)
_EPISODE = "(?:episode|task|trial|scene|run|rollout|exercise|game|test|experiment|world|table|simulation)"
_LEADS: tuple[tuple[Moment, str], ...] = (
    ("start", rf"(?:in |with |as )?(?:the |my |our |an |a )?(?:initial|starting|start|beginning|opening) "
        rf"{_STATE}{_IS}"),
    ("start", "(?:start|beginning|initial|init|before) :"),
    ("start", "initially(?: :| ,)?"),
    ("start", rf"(?:right )?(?:at|in) (?:the )?(?:very )?(?:start|beginning|outset)(?: of (?:the|each|every) "
        rf"{_EPISODE})?(?: :| ,)?"),
    ("start", rf"(?:the |each |every )?{_EPISODE} (?:starts|begins|opens|is initialized|is reset)(?: out)?(?: with| "
        rf"from| as| in| to)(?: :)?"),
    ("start", "(?:it|everything|things|we|all)(?: all)? (?:starts|begins|start|begin)(?: out| off)?(?: with| from| "
        "as)(?: :)?"),
    ("start", rf"(?:initialize|reset|sample|set up)(?: (?:the|each|every) (?:start|{_EPISODE}))?(?: with| from| as| "
        rf"to| in)(?: :)?"),
    ("end", rf"(?:in |as )?(?:the |my |our |a )?(?:goal|target|final|end|desired|finished|completed|closing|wanted|"
        rf"required|resulting) {_STATE}{_IS}"),
    ("end", r"(?:the |my |our )?(?:goal|task|aim|objective|mission|job|assignment)(?: itself| here)?(?: is| :)(?: "
        r"to(?: have)?(?= )| that)?(?: :)?"),
    ("end", rf"(?:it|everything|(?:the |each |every )?{_EPISODE})(?: must| should| shall| has to| will)? (?:ends|"
        rf"finishes|end|finish)(?: up)?(?: with| as| in)(?: :)?"),
    ("end", rf"(?:and )?(?:at|by|in) the (?:very )?end(?: of (?:the|each|every) {_EPISODE})?(?: :| ,)?"),
    ("end", "and (?:it )?(?:ends|finishes|end|finish)(?: up)?(?: with| as| in)(?: :)?"),
    ("end", "(?:success|done|solved) (?:means|is|requires)(?: that| when| if)?(?: :)?"),
    ("end", "(?:goal|target|end|result|success|task|todo|finish)(?: :)"),
)  # fmt: skip
PATTERNS = tuple((moment, re.compile(f"{text} ")) for moment, text in _LEADS)
_BREAKS = frozenset({".", "!", "?", ";", ","})
_JOINS = frozenset({"and", "but", "then"})


@dataclass(frozen=True)
class Part:
    """What is said of a moment ("": it is not said of which), the words that lead to it, and its words."""

    moment: Moment
    lead: Sequence[Token]
    said: Sequence[Token]


def parts_of(tokens: Sequence[Token]) -> list[Part]:
    """The parts of a text, each behind the words that lead to it; a lead stands where a clause begins."""
    words = coded(tokens)
    found: list[tuple[int, int, Moment]] = []
    n = 0
    while n < len(words):
        if (
            n == 0
            or words[n] == "and"
            or words[n - 1] in _BREAKS
            or (words[n - 1] in _JOINS and words[n - 2] in _BREAKS)
        ):
            text = "".join(f"{word} " for word in words[n : n + 16])
            met = [(match.end(), moment) for moment, lead in PATTERNS if (match := lead.match(text))]
            if met:
                end, moment = max(met)
                length = text[:end].count(" ")
                found.append((n, n + length, moment))
                n += length
                continue
        n += 1
    ends = [begin for begin, _, _ in found] + [len(tokens)]
    parts = [Part(moment, tokens[begin:end], _trimmed(tokens[end:after]))
             for (begin, end, moment), after in zip(found, ends[1:], strict=True)]  # fmt: skip
    ahead = _trimmed(tokens[: ends[0]])
    return [Part("", (), ahead), *parts] if ahead else parts


def _trimmed(tokens: Sequence[Token]) -> Sequence[Token]:
    """Without marks and "and" at the ends."""
    begin, end = 0, len(tokens)
    while end > begin and (tokens[end - 1].word in _BREAKS or tokens[end - 1].word in _JOINS):
        end -= 1
    while begin < end and tokens[begin].word in _BREAKS:
        begin += 1
    return tokens[begin:end]


def told_in_time(tokens: Sequence[Token]) -> list[Part]:
    """The parts, if the text leads to the start or the end and says something of it once; else none. What no words
    lead to is of the end, where the start is told; where only the end is, it may be of the start."""
    parts = parts_of(tokens)
    moments = [part.moment for part in parts]
    if "" in moments and "end" in moments:
        return []
    led = any(moments) and all(part.said for part in parts)
    return parts if led and moments.count("start") < 2 and moments.count("end") < 2 else []
