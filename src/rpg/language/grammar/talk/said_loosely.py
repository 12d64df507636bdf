"""What is said with a word more or less than a plainer sentence has: "the green block, it must be under ..."."""

from __future__ import annotations

from collections.abc import Callable

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_MUST = frozenset({"must", "should", "shall", "is", "goes", "belongs", "has", "needs"})
_OTHERS = frozenset({"others", "rest", "remainder"})
_LEAST = (("at", "least"), ("at", "most"), ("exactly",))
_PLURAL = frozenset(word for word, (_, plural) in lexicon.STRUCTURE.items() if plural)
_SINGLE = frozenset(lexicon.STRUCTURE) - _PLURAL
_ENDS = frozenset({"bottom", "top", "left", "right", "front", "back"})
_HAVING = (("has",), ("consists", "of"), ("contains",), ("is", "made", "of"))
_TOWERS = frozenset({"towers", "stacks", "piles"})
_Change = Callable[[list[Token], list[str]], list[Token] | None]


def said_loosely(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with one such construction in plainer words."""
    for change, telling in _CHANGES:
        if not telling.isdisjoint(words) and (found := change(tokens, words)) is not None:
            return found
    return None


def _counted(tokens: list[Token], at: int) -> int:
    """Where "six pink blocks" ends that begins here; 0 if it does not."""
    end = at + 1
    while end < len(tokens) and tokens[end].word in lexicon.COLOR:
        end += 1
    return end + 1 if end < len(tokens) and tokens[at].many and tokens[end].word in lexicon.BLOCK else 0


def _it(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The green block, it must be under the yellow one": the green block must be there."""
    for at in range(2, len(words) - 2):
        if words[at] not in (",", ":", "-") or words[at + 1] != "it" or words[at + 2] not in _MUST:
            continue
        begin = max((n + 1 for n in range(at) if words[n] in _STOPS), default=0)
        begin += words[begin] == "the"
        looks = words[begin : at - 1]
        single = lexicon.BLOCK.get(words[at - 1]) is False
        if single and looks and all(word in lexicon.COLOR or word in lexicon.SIZE for word in looks):
            return [*tokens[:at], *tokens[at + 2 :]]
    return None


def _anywhere_else(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(Two of them on the mat,) the others anywhere else": elsewhere."""
    for at in range(1, len(words) - 1):
        led = words[at - 1] in (*_OTHERS, "ones", "are", "is", "go")
        others = not (_OTHERS | {"other"}).isdisjoint(words[max(0, at - 3) : at])
        if words[at : at + 2] == ["anywhere", "else"] and led and others:
            return [*tokens[:at], tokens[at].saying("elsewhere"), *tokens[at + 2 :]]
    return None


def _of_the_same(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "At least two of the five blue blocks are here, and at least one is there": one of the five blue blocks."""
    for at in range(len(words) - 4):
        lead = length_at(words, at, _LEAST)
        of = at + lead + 1
        if not lead or not tokens[of - 1].many or words[of : of + 2] != ["of", "the"]:
            continue
        end = _counted(tokens, of + 2)
        stop = next((n for n in range(at, len(words)) if words[n] in _STOPS), len(words))
        for again in range(end, stop - 2) if end else ():
            more = length_at(words, again, _LEAST)
            number = again + more
            told = more and words[again - 1] in (",", "and") and number + 1 < stop and tokens[number].many
            if told and words[number + 1] in ("is", "are", "on"):
                return [*tokens[: number + 1], *tokens[of:end], *tokens[number + 1 :]]
    return None


def _formed_there(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Lay six blocks on the table so that they form a triangle": a triangle is on the table anyway."""
    said = ["on", "the", "table", "so", "that", "they", "form"]
    for at in range(2, len(words) - len(said)):
        patched = any(word in lexicon.PATCH for word in words)
        if words[at : at + len(said)] == said and not patched and words[at - 1] in lexicon.BLOCK:
            return [*tokens[:at], *tokens[at + 3 :]]
    return None


def _in_towers(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Eight pink blocks, two towers, four in each tower": eight of them in two towers.
    "One tower, 2 red and 2 blue blocks, alternating": one tower of these."""
    comma = _counted(tokens, 0) if tokens else 0
    if comma and words[comma : comma + 1] == [","] and words[comma + 2 : comma + 3] and words[comma + 2] in _PLURAL:
        last = words[comma + 3 : comma + 4] == [","] and "each" in words[comma + 4 :]
        if last and tokens[comma + 1].many > 1:
            return [*tokens[:comma], tokens[comma].saying("in"), *tokens[comma + 1 :]]
    if words[:1] in (["one"], ["a"], ["1"]) and words[1] in _SINGLE and words[2:3] == [","] and len(words) > 5:
        end = next((n for n in range(3, len(words)) if words[n] in (",", *_STOPS)), len(words))
        listed = all(t.many or t.word == "and" or t.word in lexicon.COLOR for t in tokens[3 : end - 1])
        blocks = listed and words[end - 1] in lexicon.BLOCK and tokens[3].many
        if blocks and words[end : end + 2] == [",", "alternating"]:
            return [*tokens[:2], tokens[2].saying("of"), *tokens[3:]]
    return None


def _touched(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "No red block is touched by a blue one": none touches a blue one."""
    for at in range(2, len(words) - 3):
        if words[at] in ("is", "are") and words[at + 1 : at + 3] == ["touched", "by"] and "no" in words[:at]:
            touches = "touches" if words[at] == "is" else "touch"
            return [*tokens[:at], tokens[at].saying(touches), *tokens[at + 3 :]]
    return None


def _going_down(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Write SUN going down a tower": down a tower. "8 cm apart from one to the next": 8 cm apart."""
    for at in range(1, len(words) - 3):
        down = words[at + 1] in ("down", "up") and words[at + 2] in ("a", "the", "one")
        if words[at] in ("going", "running") and down and words[at + 3] in _SINGLE:
            return [*tokens[:at], *tokens[at + 1 :]]
        if words[at] == "apart" and words[at + 1 : at + 6] == ["from", "one", "to", "the", "next"]:
            return [*tokens[: at + 1], *tokens[at + 6 :]]
    return None


def _having(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A tower which has, from bottom to top, A, B and C": a tower, from bottom to top: A, B and C."""
    for at in range(1, len(words) - 6):
        if words[at] not in ("which", "that") or words[at - 1] not in _SINGLE:
            continue
        has = length_at(words, at + 1, _HAVING)
        way = at + 1 + has + (words[at + 1 + has] == ",")
        told = words[way : way + 1] == ["from"] and words[way + 2 : way + 3] == ["to"]
        if has and told and {words[way + 1], words[way + 3]} <= _ENDS and len(words) > way + 5:
            rest = way + 4 + (words[way + 4] in (",", ":"))
            comma, colon = tokens[at].saying(","), tokens[at].saying(":")
            return [*tokens[:at], comma, *tokens[way : way + 4], colon, *tokens[rest:]]
    return None


def _dealt(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Distribute eight blocks over two towers": into two towers."""
    end = _counted(tokens, 1) if words[:1] in (["distribute"], ["spread"], ["divide"]) else 0
    led = end and words[end : end + 1] in (["over"], ["among"], ["across"], ["between"])
    if led and len(words) > end + 2 and tokens[end + 1].many > 1 and words[end + 2] in _TOWERS:
        return [tokens[0].saying("distribute"), *tokens[1:end], tokens[end].saying("into"), *tokens[end + 1 :]]
    return None


def _alone(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(Stack two of five,) the rest lie alone on the table": apart."""
    for at in range(3, len(words) - 3):
        each = words[at - 1] == "each"
        led = words[at - 1 - each] in ("lie", "are", "stay", "stand") and words[at - 2 - each] in (*_OTHERS, "ones")
        if words[at : at + 4] == ["alone", "on", "the", "table"] and led:
            return [*tokens[: at - each], tokens[at].saying("apart"), *tokens[at + 1 :]]
    return None


def _also_called(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A ring of six blocks, that is, a circle": another word for the same figure."""
    for at in range(2, len(words) - 5):
        if words[at : at + 5] != [",", "that", "is", ",", "a"] or words[at + 5] not in _SINGLE:
            continue
        ends = words[at + 6 : at + 7] in ([], ["."])
        kinds = {lexicon.STRUCTURE[word][0] for word in words[:at] if word in _SINGLE}
        if ends and kinds == {lexicon.STRUCTURE[words[at + 5]][0]}:
            return [*tokens[:at], *tokens[at + 6 :]]
    return None


def _wanted(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "I would like three towers of two blocks each, one red, ...": I want them."""
    if words[:3] == ["i", "would", "like"] and len(words) > 5 and tokens[3].many > 1 and words[4] in _PLURAL:
        return [tokens[0], tokens[1].saying("want"), *tokens[3:]]
    return None


def _taken(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Take the six green blocks: three of them become a tower, the rest a row": there are six, and three form it."""
    at = 1 + (words[1:2] == ["the"])
    end = _counted(tokens, at) if words[:1] == ["take"] and at < len(tokens) else 0
    told = end and words[end : end + 1] in ([":"], [","], [";"]) and words[end + 2 : end + 4] == ["of", "them"]
    if not told or not tokens[end + 1].many or words[end + 4 : end + 5] not in (["become"], ["form"], ["make"]):
        return None
    there = [tokens[0].saying(word) for word in ("there", "are")]
    rest = [token.saying("form") if token.word in ("become", "make") else token for token in tokens[end + 1 :]]
    return [*there, *tokens[at:end], tokens[end].saying(":"), *rest]


def _one_look(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A tower four blocks high, white only": all white."""
    for at in range(2, len(words) - 1):
        ends = at + 2 == len(words) or words[at + 2] in _STOPS
        if words[at - 1] == "," and words[at] in lexicon.COLOR and words[at + 1] == "only" and ends:
            return [*tokens[:at], tokens[at].saying("all"), tokens[at], *tokens[at + 2 :]]
    for at in range(2, len(words) - 2):  # "... White blocks only."
        ends = at + 3 == len(words) or words[at + 3] in _STOPS
        only = words[at] in lexicon.COLOR and words[at + 1] in lexicon.BLOCK and words[at + 2] == "only"
        if words[at - 1] in (".", ",", ";") and only and ends:
            say = tokens[at].saying
            return [*tokens[: at - 1], say(","), say("all"), tokens[at], *tokens[at + 3 :]]
    return None


def _made_of(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "One big cube which is made from eight yellow ones": of these."""
    for at in range(1, len(words) - 4):
        made = length_at(words, at, _WHICH_IS_MADE)
        cube = words[at - 1] == "cube" and words[at - 2] in ("big", "large", "bigger", "solid")
        if made and (cube or words[at - 1] in _SINGLE):
            return [*tokens[:at], tokens[at].saying("of"), *tokens[at + made :]]
    return None


_WHICH_IS_MADE = tuple(
    (which, "is", made, *of) for which in ("which", "that") for made in ("made", "built", "formed", "composed")
    for of in (("of",), ("from",), ("out", "of"), ("up", "of"))
)  # fmt: skip


def _everything(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Everything should be in one tower: A, then B": all blocks, where none were told before."""
    if words[:1] == ["everything"] and words[1:2] and words[1] in _MUST and words[2:3] != ["look"]:
        return [tokens[0].saying("all"), tokens[0].saying("blocks"), *tokens[1:]]
    return None


def _of_one_there(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A tower consisting of a cyan block at the bottom and two pink ones above it": with one there."""
    for at in (n + 1 for n, word in enumerate(words[:-4]) if word in _SINGLE):
        comma = at + (words[at] == ",")
        made = length_at(words, comma, _MADE_OF)
        first = comma + made
        if not made or first >= len(words) or words[first] not in ("a", "an", "one", "the"):
            continue
        end = first + 1
        while end < len(words) and (words[end] in lexicon.COLOR or words[end] in lexicon.SIZE):
            end += 1
        end += end < len(words) and (words[end] in lexicon.BLOCK or words[end] == "one")
        if length_at(words, end, _AT_AN_END):
            return [*tokens[:at], tokens[at].saying("with"), *tokens[first:]]
    return None


_MADE_OF = (("of",), ("consisting", "of"), ("made", "of"), ("made", "up", "of"), ("composed", "of"), ("made", "from"),
            ("formed", "of"), ("that", "consists", "of"), ("which", "consists", "of"), ("built", "from"))  # fmt: skip
_AT_AN_END = tuple(
    (*at, side) for at in (("at", "the"), ("on", "the"), ("in", "the"), ("as", "the"), ("on",))
    for side in ("bottom", "top", "middle", "left", "right", "base")
)  # fmt: skip


_CHANGES: tuple[tuple[_Change, frozenset[str]], ...] = (
    (_it, frozenset({"it"})),
    (_anywhere_else, frozenset({"anywhere"})),
    (_of_the_same, frozenset({"least", "most", "exactly"})),
    (_formed_there, frozenset({"so"})),
    (_in_towers, frozenset({"each", "alternating"})),
    (_touched, frozenset({"touched"})),
    (_going_down, frozenset({"going", "running", "apart"})),
    (_having, frozenset({"which", "that"})),
    (_dealt, frozenset({"distribute", "spread", "divide"})),
    (_alone, frozenset({"alone"})),
    (_also_called, frozenset({"that"})),
    (_wanted, frozenset({"like"})),
    (_taken, frozenset({"take"})),
    (_one_look, frozenset({"only"})),
    (_made_of, frozenset({"made", "built", "formed", "composed"})),
    (_everything, frozenset({"everything"})),
    (_of_one_there, frozenset({"of", "from"})),
)
"""The changes, and words without one of which there is nothing for each to change."""
LOOSE = frozenset(word for _, telling in _CHANGES for word in telling)
