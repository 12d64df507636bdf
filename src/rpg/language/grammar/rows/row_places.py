"""Lines that are told block by block, each with its place: "in the row red is leftmost, then come two blues, and a pink
one ends it on the right". Where the places make up the whole line, it is told from one end to the other instead."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass, replace
from itertools import groupby

from rpg.language import lexicon
from rpg.language.grammar.rows import place_words as w
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.tokens import Token

_ACROSS, _DEEP = ("left", "right"), ("front", "back")
_ENDS = {"row": (_ACROSS,), "line": (_ACROSS, _DEEP)}
"""Between which ends the lines of a name may run; else from front to back."""
_TOGETHER = 3
"""So many sentences may tell of one line: "There is a row of five. The first is red; the others are gray."."""


@dataclass(frozen=True)
class _Part:
    """Blocks of one look, and where they are said to be: a place of `w.PLACES`, "next", or a number from one end.
    `bare`: no more is said than a colour."""

    look: str
    many: int
    place: str | int
    bare: bool = False


def told_by_places(tokens: list[Token]) -> list[Token]:
    """The tokens with every sentence that tells a line place by place told in order; what is told of a line that is
    there already, and is to change, is left as it is."""
    said = {t.word for t in tokens}
    if w.LINES.isdisjoint(said) or not w.CHANGED.isdisjoint(said):
        return tokens
    told = sentences(tokens)
    lined = [not w.LINES.isdisjoint({t.word for t in one}) for one in told]
    if sum(lined) != 1:
        return tokens
    out: list[Token] = []
    while told:
        long = next((n for n in range(min(len(told), _TOGETHER), 0, -1) if _told(_joined(told[:n]))), 0)
        out += _told(_joined(told[:long])) if long else told[0]
        told = told[max(long, 1) :]
    return out


def _told(tokens: list[Token]) -> list[Token]:
    """A sentence, or some that go together, told in order; nothing where they do not tell a line place by place."""
    stop = tokens[-1:] if tokens[-1].word in STOPS else []
    words = [word_of(tokens, n) for n in range(len(tokens) - len(stop))]
    text = re.sub(w.SAID, "", " ".join(";" if word in STOPS else word for word in words))
    mirrored = re.search(w.MIRRORED, text) is not None
    text = re.sub(w.STOCKED, r"\1 : \2 : ", re.sub(w.MIRRORED, "", text))
    for frame in w.FRAMES:
        found = re.search(frame, text)
        if found is None:
            continue
        rest = " ".join(f"{text[: found.start()]} {text[found.end() :]}".split())
        size = _count(found.groupdict().get("size"))
        for ends in _ENDS.get(found["line"], (_DEEP,)):
            if line := _in_order(re.sub(f" of the {w.LINE}\\b", "", rest), ends, size, mirrored):
                span = (tokens[0].span[0], tokens[-1].span[1])
                there = ["there", "is"] if re.match("there (?:is|are) ", text) else []
                return [*(_token(word, span) for word in (*there, *line)), *stop]
    return []


def _joined(parts: list[list[Token]]) -> list[Token]:
    return [token for part in parts for token in part]


def word_of(tokens: list[Token], n: int) -> str:
    """A word of the text; a capital that stands alone is a label."""
    token = tokens[n]
    after = tokens[n + 1].word if n + 1 < len(tokens) else ""
    label = (
        len(token.raw) == 1
        and token.raw.isupper()
        and token.word != "i"
        and (token.word != "a" or after not in _AFTER_A)
    )
    return f"@{token.word}" if label and token.kind == "word" else token.word.replace(" ", "_") or "_"


_AFTER_A = frozenset({*lexicon.COLOR, *lexicon.BLOCK, "row", "line", "column", "single", "straight", "lone",
                      "symmetric", "symmetrical", "mirrored", "mirror", "palindromic"})  # fmt: skip


def _token(word: str, span: tuple[int, int]) -> Token:
    if word.isdigit():
        return Token("number", word, word, span, float(word))
    label = word.startswith("@")
    said = word.lstrip("@")
    return Token("word" if said.isalpha() else "punct", said, said.upper() if label else said, span)


def _in_order(text: str, ends: tuple[str, str], size: int | None, mirrored: bool) -> list[str]:
    """A line from one end to the other; nothing where its places do not make up all of it, or it is to be its own
    mirror image and is not."""
    for place, utmost in w.UTMOST.items() if ends == _DEEP else ():
        text = re.sub(f"(?: ,)? {utmost}(?= ,| and| ;|$)", f" {place}", text)
    stock, text = _stock(re.sub(w.DO, "", text))
    text = re.sub("(?:^| )(?:,|and|;)* ?then\\b", " , then", text)
    parts: list[_Part] = []
    for said in re.split("(?: ,| ;| :| and)+(?: |$)", f"{text.strip(' ,:;.')} "):
        part = _part(said.strip(), ends, parts) if said.strip() else None
        if said.strip() and part is None:
            return []
        parts += [part] if part is not None else []
    bare = len(parts) > 1 and parts[0].place == "" and size is not None and all(p.place == "next" for p in parts[1:])
    parts = [replace(parts[0], place=ends[0]), *parts[1:]] if bare else parts
    parts = _counted(parts, size, stock)
    taken = {part.place for part in parts}
    outwards = taken == {"middle", "ends"} or (taken == {"ends", "inner"} and size is not None)
    laid = _laid(parts, ends) if len(parts) > (1 if bare or stock or outwards else 2) else []
    if not laid or (size is not None and size != len(laid)) or (stock and Counter(laid) != stock):
        return []
    if mirrored and laid != laid[::-1]:
        return []
    runs = [list(run) for _, run in groupby(enumerate(laid), lambda x: x[1] if x[1] in lexicon.COLOR else x[0])]
    told = [run[0][1] if len(run) == 1 else f"{len(run)} {run[0][1]} blocks" for run in runs]
    way = "" if bare else f"from {ends[0]} to {ends[1]} "
    shape = "column" if ends == _DEEP else "row"
    return f"a {shape} {way and ', '}{way}: {' , then '.join(told)}".split()


def _stock(text: str) -> tuple[Counter[str], str]:
    """How many of each look a heading names, and the rest: "two green cubes and one white cube: ..."."""
    head, colon, rest = text.strip(" ,").partition(" : ")
    found = [_thing(said.strip(), "") for said in re.split(" ,| and", head)] if colon and rest else []
    if not found or any(part is None or part.many == 0 for part in found):
        return Counter(), text
    return Counter({part.look: part.many for part in found if part is not None}), rest


def _counted(parts: list[_Part], size: int | None, stock: Counter[str]) -> list[_Part]:
    """The parts with as many blocks as the stock has, or as the others leave."""
    told = [replace(p, many=stock[p.look]) if p.place == "rest" and stock[p.look] > 1 else p for p in parts]
    told = [replace(p, many=0) if p.place == "rest" and p.bare and size is not None else p for p in told]
    around = {p.place for p in told} == {"middle", "sides"} and size is not None and size % 2 == 1
    told = [replace(p, place="ends", many=0 if around else p.many) if p.place == "sides" else p for p in told]
    told = [replace(p, many=2) if p.place in _PAIRS and p.many in (0, 1) and not around else p for p in told]
    open_ones = [p for p in told if p.many == 0]
    left = (size or 0) - sum(p.many for p in told)
    if len(open_ones) > 1 or (open_ones and left < 1):
        return []
    return [replace(p, many=left) if p.many == 0 else p for p in told]


def _count(word: str | None) -> int | None:
    if not word:
        return None
    return 2 if word == "both" else int(word) if word.isdigit() else lexicon.NUMBER[word]


def _part(said: str, ends: tuple[str, str], before: list[_Part]) -> _Part | None:
    """What one of the phrases tells."""
    said = re.sub("^(?:with|so that|that|which|where|in which|have|having) ", "", said)
    for pattern in (w.WITH, w.CLOSES):
        if (told := re.fullmatch(pattern, said)) is not None:
            sides = [told.groupdict().get("side"), told.groupdict().get("side1")]
            begins = told.groupdict().get("verb", "ends")[0] in "sb"
            side = next((x for x in sides if x), ends[0] if begins else ends[1])
            return _thing(told["thing"], side) if side in ends else None
    told = re.fullmatch(w.INNER, said) if before and before[-1].place == "ends" else None
    if told is not None and (part := _thing(told["thing"], "inner")) is not None:
        return part
    if (told := re.fullmatch(w.NEXT, said)) is not None:
        thing = next(x for x in (told["thing"], told["thing1"], told["thing2"], told["thing3"]) if x)
        part = _thing(thing, "next")
        return part if part is not None else _part(thing, ends, before)
    onward = w.ONWARD[ends[0] if _from_the_last(before, ends) else ends[1]]
    in_turn = bool(before) and before[0].place != "middle"
    told = re.fullmatch(f"(?:then )?(?P<thing>.+?)(?: {w.IS})? {onward}", said) if in_turn else None
    if told is not None and (part := _thing(told["thing"], "next")) is not None:
        return part
    if before and before[-1].place == "next" and (part := _thing(said, "next")) is not None:
        return part
    if (told := re.fullmatch(w.REMAINING, said)) is not None:
        return _Part(told[2], _count(told["many"]) or 0, "rest")
    if not before and (part := _thing(said, "")) is not None:
        return part
    aside = [(end, w.ASIDE[end]) for end in ends] if before and before[0].place == "middle" else []
    for place, pattern in (*((p, w.PLACES[p]) for p in (*ends, "middle", "ends", "rest")), *aside, ("nth", w.NTH)):
        for order in (
            f"(?P<thing>.+?)(?: {w.IS})?(?: ,)? (?:{pattern})",
            f"(?:{pattern})(?: {w.IS})?(?: ,)? (?P<thing>.+)",
        ):
            told = re.fullmatch(order, said)
            part = _thing(told["thing"], _numbered(told, ends) if place == "nth" else place) if told else None
            if part is not None and place == "ends" and part.many > 1 and _EACH.search(said):
                part = replace(part, many=2 * part.many)
            elif part is not None and place == "ends" and (part.bare or not part.many) and _SIDES.search(said):
                part = replace(part, place="sides")
            if part is not None and (part.many or place in ("ends", "rest") or part.look):
                return replace(part, many=before[-1].many) if part.many < 0 and before else part
    return None


_EACH = re.compile(r"\b(?:each|either) (?:end|side)")
"""So many as are told are at either of them."""


_SIDES = re.compile(r"\b(?:both|either|each|the two) sides?\b")
"""All that is there beside the middle."""


def _from_the_last(before: list[_Part], ends: tuple[str, str]) -> bool:
    """Whether the places told before go from the last end towards the first."""
    told = [part for part in before if part.place != "next"]
    if not told or told[-1].place != ends[1]:
        return False
    return told[-1] is before[0] or before[before.index(told[-1]) - 1].place != "next"


def _numbered(told: re.Match[str], ends: tuple[str, str]) -> int:
    """The place that is counted from one of the ends: 1 is the second from the first end, -2 from the last."""
    number = w.ORDINALS.index(told["nth"])
    return -1 - number if told["from"] == ends[1] else number


def _thing(said: str, place: str | int) -> _Part | None:
    """Blocks of one look; as many as before where their number is below nought, and some where it is nought."""
    told = re.fullmatch(w.THING, said)
    if told is None:
        return None
    if told["several"]:
        return _Part(told["several"], 0, place)
    if told["same"]:
        return _Part(told["like"], -1, place)
    if told["colors"]:
        return _Part(told["colors"], _count(told["many"]) or 0, place)
    return _Part(told["color"] or told["label"], 1, place, bare=said == told["color"])


def _laid(parts: list[_Part], ends: tuple[str, str]) -> list[str]:
    """The looks of the blocks from the first end to the last; nothing where a place is taken twice or left free."""
    total = sum(part.many for part in parts)
    there: dict[int, str] = {}
    late: list[_Part] = []
    last, way = -1, 1
    parts = [one for part in parts for one in _both_ends(part, ends)]
    for n, part in enumerate(parts):
        match part.place:
            case "next":
                if n == 0 or parts[n - 1].place in ("middle", "rest"):
                    return []
                begin = last + 1 if way > 0 else last - part.many
            case "" | "inner":
                return []
            case "middle" | "rest":
                late.append(part)
                continue
            case int(number):
                if part.many != 1:
                    return []
                begin = number % total
            case side:
                way = 1 if side == ends[0] or (n and parts[n - 1].place == "next") else -1
                begin = 0 if side == ends[0] else total - part.many
        places = range(begin, begin + part.many)
        if any(k in there or not 0 <= k < total for k in places):
            return []
        there.update((k, part.look) for k in places)
        last = places[-1] if way > 0 else places[0]
    for part in late:
        free = [k for k in range(total) if k not in there]
        if part.place == "rest" and len(free) == part.many:
            there.update((k, part.look) for k in free)
            continue
        centre = range((total - part.many) // 2, (total + part.many) // 2)
        middle = part.place == "middle" and (total - part.many) % 2 == 0 and not any(k in there for k in centre)
        places_left = list(centre) if middle else free
        if len(places_left) != part.many or places_left != list(range(places_left[0], places_left[-1] + 1)):
            return []
        there.update((k, part.look) for k in places_left)
    return [there[k] for k in range(total)] if len(there) == total else []


_PAIRS = frozenset({"ends", "inner"})
"""Places that there are two of."""


def _both_ends(part: _Part, ends: tuple[str, str]) -> list[_Part]:
    """Half of what is at both ends, or next to them, at each of them."""
    if part.place not in _PAIRS or part.many % 2 or (part.place == "inner" and part.many > 2):
        return [part]
    places = ends if part.place == "ends" else (1, -2)
    return [replace(part, many=part.many // 2, place=place) for place in places]
