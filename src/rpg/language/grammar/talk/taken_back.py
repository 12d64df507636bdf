"""What takes back the sentence before it, or a part: "Put A on B. Sorry, the other way round.", "Red on green? No,
green on red.", "Build a tower of three. No, four."."""

from __future__ import annotations

import re
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences, text_of
from rpg.language.grammar.rows.said_short import IS, PLACE, PUT, THING
from rpg.language.grammar.rows.vocabulary import FEW, WAY
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_APART = frozenset({",", "…"})
_REPAIR = "(?:sorry|oops|whoops|correction|my mistake|my bad|scratch that|strike that|actually|i misspoke)"
_MEANT = "(?:i (?:mean|meant)(?: to say)?|make that|make it|rather|wait|better|that should be|it should be)"
_TAKEN_BACK = on_demand(
    f"^(?:(?:oh |ah |um |uh )?(?:no ,|no(?= {_MEANT}| {_REPAIR}| [,:])|{_REPAIR}|i meant|i mean|or rather))"
    f"(?: ?[,:])?(?: (?:{_REPAIR}|{_MEANT}|no)(?: [,:])?)*$"
)
_AROUND = ("the other way round", "the other way around", "the other way", "vice versa", "the reverse", "reverse that",
           "the opposite", "reversed")  # fmt: skip
_TWO = on_demand(f"^((?:please )?(?:{PUT}|stack) )?({THING}) ((?:{IS} )?{PLACE}) ({THING})$")
_PLACED = on_demand(f"^(.+?) ((?:directly |immediately |right )?{PLACE}) ((?:the|an?) .+|{THING})$")
_SIDE = on_demand(f"^({PLACE}) (.+)$|^((?:to|on) the (?:left|right)|in front|behind|above|below|beside)$")
_MANY = on_demand(f"^(\\d+|{FEW})$")


def taken_back(tokens: list[Token]) -> list[Token]:
    """The tokens with what is taken back left out, where it is clear what that is; else as they were."""
    out: list[list[Token]] = []
    for sentence in (half for whole in sentences(tokens) for half in _halves(whole)):
        begins = _begins(sentence) if out else 0
        mended = _mended(out[-1], sentence[begins:]) if begins else None
        if mended is None:
            out.append(sentence)
        else:
            out[-1] = mended
    return [token for sentence in out for token in sentence]


def _halves(sentence: list[Token]) -> list[list[Token]]:
    """What is taken back in the same sentence: "red on green, no, the other way round"."""
    for n in range(len(sentence) - 2, 1, -1):
        before, behind = sentence[:n], sentence[n + 1 :]
        if sentence[n].word in _APART and (begins := _begins(behind)) and _mended(before, behind[begins:]) is not None:
            return [before, behind]
    return [sentence]


def _begins(sentence: list[Token]) -> int:
    """How many words at the beginning take back what was said; 0 where none do. Nothing else may be said by "no"."""
    words = [token.word for token in sentence]
    inside = range(min(len(words) - 1, 8), 0, -1)
    return next((n for n in inside if _TAKEN_BACK.match(" ".join(words[:n]))), 0)


def _mended(before: list[Token], said: list[Token]) -> list[Token] | None:
    """What was said before as it was meant; None where that is not clear."""
    stop = [token for token in (said[-1], before[-1]) if token.word in STOPS][:1]
    said = _plainly(said[:-1] if said[-1].word in STOPS else said)
    was = before[:-1] if before[-1].word in STOPS else before
    text, told = text_of(said), text_of(was)
    if not text:
        return None
    if text in _AROUND:
        found = _turned_around(was)
    elif re.match(f"^{WAY}$", text):
        found = _put_for(was, said, WAY)
    elif _MANY.match(text):
        found = _put_for(was, said, f"(?:\\d+|{FEW})(?= )")
    elif len(said) == 1 and text in lexicon.COLOR:
        found = _put_for(was, said, f"(?:{'|'.join(lexicon.COLOR)})(?= |$)")
    elif _SIDE.match(text):
        found = _moved(was, said)
    else:
        found = said if _looks(was) == _looks(said) and (_TWO.match(text) or _clause(told, text)) else None
    return None if found is None else [*found, *stop]


_CIVIL = (("please",), ("thanks",), ("thank", "you"))


def _plainly(said: list[Token]) -> list[Token]:
    """Without the courtesy at the end, which takes no part in what is put for what: "No, four, thank you"."""
    for words in _CIVIL:
        if len(said) > len(words) and tuple(token.word for token in said[-len(words) :]) == words:
            rest = said[: -len(words)]
            return rest[:-1] if len(rest) > 1 and rest[-1].word in _APART else rest
    return said


def _clause(told: str, text: str) -> bool:
    """Whether both say where something goes with the same verb first: the whole of it is said anew."""
    return told.split()[:1] == text.split()[:1] and text.split()[0] in lexicon.VERB


def _looks(tokens: list[Token]) -> list[str]:
    """The colours and symbols that are named, which are the same ones where the same is told anew."""
    return sorted(t.word for t in tokens if t.word in lexicon.COLOR or (len(t.raw) == 1 and t.raw.isupper()))


def _part(tokens: list[Token], text: str, span: tuple[int, int]) -> list[Token]:
    """The tokens that a stretch of their text is made of."""
    return tokens[text[: span[0]].count(" ") : text[: span[1]].count(" ") + 1]


def _turned_around(was: list[Token]) -> list[Token] | None:
    """ "Put A on B": B on A; "from left to right": from right to left."""
    text = text_of(was)
    if (two := _TWO.match(text)) is not None:
        lead = _part(was, text, two.span(1))[:-1] if two[1] else []
        one, place, other = (_part(was, text, two.span(n)) for n in (2, 3, 4))
        return [*lead, *other, *place, *one]
    ways = list(re.finditer(WAY, text))
    if len(ways) != 1:
        return None
    way = _part(was, text, ways[0].span())
    to = next(n for n, token in enumerate(way) if token.word == "to")
    at = text[: ways[0].start()].count(" ")
    turned = [way[0], *way[to + 1 :], way[to], *way[1:to]]
    return [*was[:at], *turned, *was[at + len(way) :]]


def _put_for(was: list[Token], said: list[Token], kind: str) -> list[Token] | None:
    """What is said in place of the one thing of its kind that was said before."""
    text = text_of(was)
    found = list(re.finditer(f"\\b{kind}", text))
    if len(found) != 1:
        return None
    at = text[: found[0].start()].count(" ")
    return [*was[:at], *said, *was[at + len(_part(was, text, found[0].span())) :]]


def _moved(was: list[Token], said: list[Token]) -> list[Token] | None:
    """Another place for what was placed: "to the right of it" is beside the same block."""
    text = text_of(was)
    placed = _PLACED.match(text)
    if placed is None or len(re.findall(f"\\b{PLACE} ", text)) > 1:
        return None
    theme, mark = _part(was, text, placed.span(1)), _part(was, text, placed.span(3))
    words = [token.word for token in said]
    if re.fullmatch(f"(?:\\w+ )?{PLACE} (?:it|that|them)", text_of(said)):
        return [*theme, *said[:-1], *mark]
    if _SIDE.match(text_of(said))[3] is None:  # type: ignore[index]
        one = said[-1].word == "one" and mark[-1].word in (lexicon.PATCH.keys() | lexicon.BLOCK.keys())
        return [*theme, *said[:-1], mark[-1]] if one else [*theme, *said]
    of = [replace(said[-1], word="of", raw="of")] if words[-1] in ("left", "right", "front") else []
    return [*theme, *said, *of, *mark]
