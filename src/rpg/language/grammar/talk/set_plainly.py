"""Texts that are set in another way than sentences: "GIVEN ... WHEN ... THEN ...", "the tall tower (four blocks)", a
heading "Sort by colour." over what goes where, "get me a wall going"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token

_STEPS = frozenset({"given", "when", "then"})
_BY = frozenset({"color", "letter", "number", "size", "kind", "type", "class", "category"})
SORTED = frozenset({"sort", "group", "organize", "organise", "arrange"})
_ALL = frozenset({"them", "everything", "all", "the", "these", "it", "blocks", "cubes", "bricks", "please", "boxes"})


def given_when_then(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "GIVEN red on blue WHEN the robot is done THEN blue is on red": it begins and ends so. Other whens are kept."""
    at = {word: [n for n, w in enumerate(words) if w == word] for word in _STEPS}
    if words[:1] != ["given"] or any(len(found) != 1 for found in at.values()):
        return None
    when, then = at["when"][0], at["then"][0]
    told = [word for word in words[when + 1 : then] if word != ","]
    over = any(word in ("done", "finished", "ends", "over", "finishes", "stops", "runs", "acts") for word in told[-2:])
    if not 1 < when < then - 1 or then == len(words) - 1 or not over or any(w in lexicon.COLOR for w in told):
        return None
    begun = tokens[1 : when - (words[when - 1] in (",", "."))]
    say = tokens[0].saying
    start = [say(word) for word in ("at", "the", "start", "there", "are")]
    if any(word in lexicon.POSTURE for word in words[1:when]):
        start = start[:3]
    return [*start, *begun, say("."), *tokens[then + 1 :]]


def number_in_brackets(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The tall tower (four blocks)": of four blocks; "two (2) red blocks": two."""
    for at in range(1, len(words) - 2):
        if words[at] == "(" and words[at + 2] == ")" and 0 < tokens[at - 1].many == tokens[at + 1].many:
            rest = [*tokens[:at], *tokens[at + 3 :]]
            return number_in_brackets(rest, [token.word for token in rest]) or rest
        end = next((n for n in range(at, min(at + 5, len(words))) if words[n] == ")"), 0)
        inside = tokens[at + 1 : end]
        named = words[at - 1] in lexicon.STRUCTURE or words[at - 1] == "one"
        told = inside and inside[0].many > 1 and inside[-1].word in lexicon.BLOCK
        if words[at] == "(" and end and named and told:
            return [*tokens[:at], tokens[at].saying("of"), *inside, *tokens[end + 1 :]]
    return None


def heading_of_sorting(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Sort by colour. Reds to the red zone, blues to the blue zone": only what goes where is told."""
    end = next((n for n, word in enumerate(words) if word in STOPS | {":"}), 0)
    heading = [word for word in words[:end] if word not in _ALL]
    if len(heading) != 3 or heading[0] not in SORTED or heading[1] != "by" or heading[2] not in _BY:
        return None
    placed = sum(a in lexicon.COLOR and b in lexicon.PATCH for a, b in pairwise(words[end:]))
    return tokens[end + 1 :] if placed > 1 else None


def of_the_symbols(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "For the digits 1 to 6, all odd ones ...": of these."""
    if words[:2] != ["for", "the"] or words[2:3] not in (["digits"], ["letters"], ["numbers"]) or "," not in words:
        return None
    return [tokens[0].saying("of"), *tokens[1:]]


def got_going(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Get me a wall going": build one."""
    for at in (n for n, word in enumerate(words) if word == "going" and n > 2 and words[n - 1] in lexicon.STRUCTURE):
        begin = next((n for n in range(at - 2, max(at - 6, -1), -1) if words[n] == "get"), -1)
        what = begin + 1 + (begin >= 0 and words[begin + 1] in ("me", "us"))
        if begin >= 0 and words[what] in ("a", "an", "one", "the"):
            return [*tokens[:begin], tokens[begin].saying("build"), *tokens[what:at], *tokens[at + 1 :]]
    return None
