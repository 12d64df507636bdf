"""Shares told in a roundabout way, in the words of plainer ones: "half of the six here, the other half there"."""

from __future__ import annotations

from math import prod

from rpg.language import lexicon
from rpg.language.phrases import behind
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_ENDS = {
    "row": frozenset({"ends", "left", "right", "middle", "center", "end"}),
    "tower": frozenset({"top", "bottom", "middle", "center", "base"}),
    "column": frozenset({"ends", "front", "back", "middle", "center", "end"}),
}
_LINES = {"row": "row", "line": "row", "tower": "tower", "stack": "tower", "column": "column"}
_OF = {("consists", "of"): "has", ("consist", "of"): "have", ("consisting", "of"): "with", ("made", "of"): "with",
       ("made", "up", "of"): "with", ("of",): "with"}  # fmt: skip
_HAS = {"is": "has", "are": "have", "be": "have"}
_AT = frozenset({"at", "on", "in"})
_THE = frozenset({"the", "both", "each", "very", "its", "far"})
_ONE = frozenset({"a", "one", "each", "every", "exactly", "1"})
_MARKS = frozenset(word for word, plural in lexicon.PATCH.items() if not plural)
_LISTED = frozenset({",", "and", "the", "numbers", "digits", "cubes", "blocks", "signs", "sign", "symbols"})
_SIGNS = {"+": "+", "plus": "+", "*": "*", "times": "*", "=": "=", "equals": "="}
_RESULTS = (("that", "equals"), ("which", "equals"), ("that", "gives"), ("that", "makes"), ("equal", "to"),
            ("which", "gives"), ("that", "comes", "to"), ("with", "the", "result"), ("whose", "result", "is"),
            ("with", "a", "result", "of"), ("that", "adds", "up", "to"), ("resulting", "in"))  # fmt: skip
_DIGIT = 9
"""Larger numbers are shown by several blocks."""
_WITH = (("with",), ("using",), ("from",), ("out", "of"), ("made", "of"))


def dealt_out(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with one such construction in plainer words."""
    if "half" in words:
        return _halves(tokens, words)
    if ("towers" in words or "stacks" in words) and (towers := _two_towers(tokens, words)) is not None:
        return towers
    if "each" in words and (shared := _one_on_each(tokens, words)) is not None:
        return shared
    if "equation" in words or "sum" in words:
        return _with_result(tokens, words)
    return _by_places(tokens, words) if "of" in words and ("and" in words or "," in words) else None


def _halves(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Half of the six blocks on the left, the other half on the right": three of the six, the other three."""
    at = next((n for n in range(len(words) - 4) if words[n : n + 2] == ["half", "of"]), -1)
    count = at + 2 + (words[at + 2 : at + 3] == ["the"])
    many = tokens[count].many if at >= 0 else 0
    rest = next((n for n in range(count, len(words) - 1) if words[n : n + 2] == ["other", "half"]), 0)
    share = lexicon.NUMBERS.get(many // 2)
    if many < 4 or many % 2 or not rest or share is None or not _STOPS.isdisjoint(words[at:rest]):
        return None
    the = [] if words[rest - 1] == "the" else [tokens[rest].saying("the")]
    behind = [*the, tokens[rest], tokens[rest + 1].saying(share), *tokens[rest + 2 :]]
    return [*tokens[:at], tokens[at].saying(share), *tokens[at + 1 : rest], *behind]


def _one_on_each(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "One block on each mat: three mats and three blocks": three blocks on three mats, one on each."""
    cuts = [n for n, word in enumerate(words) if word in (":", ".")]
    parts = [(tokens[: cuts[0]], tokens[cuts[0] + 1 :]), (tokens[cuts[0] + 1 :], tokens[: cuts[0]])] if cuts else []
    for told, listed in parts:
        said = [t.word for t in told if t.word not in ("please", ".")]
        said = said[1:] if said[:1] in (["put"], ["place"], ["set"]) else said
        block = next((n for n, word in enumerate(said[:4]) if word in lexicon.BLOCK), 0)
        looks = said[1:block]
        goes = said[block + 1 :]
        goes = goes[1:] if goes[:1] in (["goes"], ["belongs"]) else goes
        one = block and said[0] in _ONE and all(word in lexicon.COLOR for word in looks)
        on = goes[:2] == ["on", "each"] and len(goes) == 3 and goes[2] in _MARKS
        if one and on and (counted := _as_many(listed)) is not None:
            blocks, marks = counted
            if looks and looks != [t.word for t in blocks[1:-1]]:
                continue
            lead = [told[0].saying("put")]
            one_on = [told[-1].saying(word) for word in (",", "one", "on", "each")]
            return [*lead, *blocks, told[-1].saying("on"), *marks, *one_on]
    return None


def _as_many(listed: list[Token]) -> tuple[list[Token], list[Token]] | None:
    """ "Three mats and three blocks": just as many of both, and nothing else."""
    kept = [t for t in listed if t.word != "."]
    words = [t.word for t in kept]
    lead = next((x for x in (["there", "are"], ["we", "have"], ["you", "have"]) if words[:2] == x), [])
    kept, words = kept[len(lead) :], words[len(lead) :]
    cut = next((n for n, word in enumerate(words) if word in ("and", ",")), 0)
    lots = (kept[:cut], kept[cut + 1 + (words[cut + 1 : cut + 2] == ["and"]) :])
    if not cut or any(len(lot) < 2 or any(t.word not in lexicon.COLOR for t in lot[1:-1]) for lot in lots):
        return None
    marks = [lot for lot in lots if lexicon.PATCH.get(lot[-1].word)]
    blocks = [lot for lot in lots if lexicon.BLOCK.get(lot[-1].word)]
    if len(marks) != 1 or len(blocks) != 1 or not marks[0][0].many == blocks[0][0].many > 1:
        return None
    return blocks[0], marks[0]


_THERE = (("there", "are"), ("there", "should", "be"), ("there", "must", "be"), ("build",), ("make",), ("i", "want"))
_TWO = (("two", "towers"), ("two", "stacks"), ("2", "towers"), ("2", "stacks"))
_FIRST = (("one", "of", "them"), ("one", "tower"), ("the", "first", "one"), ("the", "first"), ("one",))
_SECOND = (("the", "other", "one"), ("the", "other", "tower"), ("the", "other"), ("the", "second", "one"),
           ("the", "second"))  # fmt: skip
_HAVING = (("consists", "of"), ("is", "made", "of"), ("should", "consist", "of"), ("must", "consist", "of"),
           ("should", "have"), ("must", "have"), ("has",), ("of",), ("with",))  # fmt: skip


def _two_towers(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "There are two towers; one has two red blocks, the other two blue ones and a green one on top": a tower of
    these, and one of those. What is told of both at once, or of where they are, is left as it is."""
    at = behind(words, behind(words, 0, _THERE), _TWO)
    begun = behind(words, at + 1, _FIRST) if at and at < len(words) and words[at] in (";", ":", ".", ",") else 0
    first = behind(words, begun, _HAVING) if begun else 0
    joint = next((n for n in range(first, len(words)) if behind(words, n, _SECOND)), 0) if first else 0
    second = behind(words, joint, _SECOND) if joint else 0
    second = behind(words, second, _HAVING) or second if second else 0
    end = len(words) - (words[-1] in _STOPS)
    top = second > 0 and (words[end - 2 : end] == ["on", "top"] or words[0] == "there")
    if not top or not _STOPS.isdisjoint({*words[second:end]} - {";"}):
        return None
    while joint > first and words[joint - 1] in (",", ";", ".", "and", "while"):
        joint -= 1
    lots = (tokens[first:joint], tokens[second:end])
    if any(not _blocks(lot) for lot in lots):
        return None
    of = [tokens[at - 1].saying(word) for word in ("a", "tower", "of")]
    return [*of, *lots[0], tokens[at].saying(";"), *of, *lots[1], *tokens[end:]]


def _blocks(lot: list[Token]) -> bool:
    """ "Two blue ones and a green one on top": counted blocks by their colours, and nothing else of where they are."""
    words = [t.word for t in lot]
    words = words[:-2] if words[-2:] == ["on", "top"] else words
    told = {*lexicon.COLOR, *lexicon.BLOCK, *lexicon.NUMBER, "ones", "a", "an", "and", "with", ","}
    return bool(words) and all(word in told or t.kind == "number" for word, t in zip(words, lot, strict=False))


def _by_places(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A row of two black blocks at the ends and four white ones in the middle": a row with these there."""
    for at, word in enumerate(words):
        line = _LINES.get(word)
        begun = at + 1
        while line and begun < len(words) and words[begun] in ("should", "must", "shall", "is", "has", "to", "be"):
            begun += 1
        of = next((x for x in _OF if tuple(words[begun : begun + len(x)]) == x), ()) if line else ()
        end, items = begun + len(of), 0
        while of and (after := _item(tokens, words, end, _ENDS[line or "row"])):
            items, end = items + 1, after
            joint = end
            joint += words[joint : joint + 1] == [","]
            joint += words[joint : joint + 1] == ["and"]
            if joint == end:
                break
            end = joint
        if items > 1 and (end >= len(words) or words[end] in _STOPS | {","}):
            made = of[0] == "made" and words[begun - 1] in _HAS
            with_ = tokens[begun].saying(_HAS[words[begun - 1]] if made else _OF[of])
            return [*tokens[: begun - made], with_, *tokens[begun + len(of) :]]
    return None


def _item(tokens: list[Token], words: list[str], at: int, places: frozenset[str]) -> int:
    """The position behind "two black blocks at the ends"; 0 where this is something else."""
    if at >= len(words) or not (tokens[at].many or words[at] in ("a", "an")):
        return 0
    end = at + 1
    while end < len(words) and words[end] in lexicon.COLOR:
        end += 1
    if end == at + 1:
        return 0
    end += end < len(words) and (words[end] in lexicon.BLOCK or words[end] in ("one", "ones"))
    if end >= len(words) or words[end] not in _AT:
        return 0
    end += 1
    while end < len(words) and words[end] in _THE:
        end += 1
    if end >= len(words) or words[end] not in places:
        return 0
    return end + 1 + (words[end + 1 : end + 2] in (["end"], ["half"]) and words[end] not in ("end", "ends"))


def _with_result(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The equation that equals 7 with 3, 4, + and =": an equation of all of these, the result among them.

    Of a mere sum or product of the numbers: each side of it then has that result, whichever way it is laid out.
    """
    at = next((n for n, word in enumerate(words) if word in ("equation", "sum", "calculation")), 0)
    first = _result(tokens, words, at + 1)
    using = behind(words, first + 1 if first else at + 1, _WITH) if at else 0
    numbers, signs, end = _listed(tokens, words, using) if using else ([], [], 0)
    last = _result(tokens, words, end) if end and not first else 0
    told = first or last
    rest = last + 1 if last else end
    if not told or tokens[told].many > _DIGIT or not _comes_to(numbers, signs, tokens[told].many):
        return None
    if rest < len(words) and words[rest] not in _STOPS:
        return None
    head = [*tokens[: at - 1], tokens[at - 1].saying("an")] if words[at - 1] == "the" else tokens[:at]
    own = [tokens[told], tokens[told].saying(",")]
    return [*head, tokens[at], tokens[using].saying("with"), *own, *tokens[using:end], *tokens[rest:]]


def _result(tokens: list[Token], words: list[str], at: int) -> int:
    """Where the number is that it is said to come to, or 0."""
    found = behind(words, at, _RESULTS)
    return found if found and found < len(words) and tokens[found].many else 0


def _listed(tokens: list[Token], words: list[str], at: int) -> tuple[list[int], list[str], int]:
    """The numbers and the signs of a list, and the position behind it."""
    numbers: list[int] = []
    signs: list[str] = []
    end = at
    while end < len(words):
        if tokens[end].many or words[end] in ("0", "zero"):
            numbers.append(tokens[end].many)
        elif words[end] in _SIGNS:
            signs.append(_SIGNS[words[end]])
        elif words[end] not in _LISTED:
            break
        end += 1
    return numbers, signs, end


def _comes_to(numbers: list[int], signs: list[str], result: int) -> bool:
    """Whether the numbers make that result with as many equal signs between them."""
    joints = [sign for sign in signs if sign != "="]
    if signs.count("=") != 1 or not joints or len({*joints}) > 1 or len(joints) != len(numbers) - 1:
        return False
    return (sum(numbers) if joints[0] == "+" else prod(numbers)) == result
