"""Heights and lengths compared: "two towers from seven blocks, one a block taller than the other": four and three.

How many blocks each has is worked out where it follows from the numbers that are told; where it does not, that is said.
"""

from __future__ import annotations

import re
from itertools import pairwise
from typing import NamedTuple

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.language import lexicon
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_FEW = "|".join(sorted((w for w in lexicon.NUMBER if w.isalpha()), key=len, reverse=True))
_N = f"(?:\\d+|{_FEW})"
_C = "(?:" + "|".join(sorted(lexicon.COLOR, key=len, reverse=True)) + ")"
_K = "(?:tower|stack|row|line)"
_B = "(?:blocks?|cubes?)"
_MORE = {"taller": 1, "higher": 1, "longer": 1, "bigger": 1, "shorter": -1, "lower": -1, "smaller": -1}
_THAN = f"(?:{'|'.join(_MORE)})"
_TIMES = {"twice": 2.0, "double": 2.0, "two times": 2.0, "three times": 3.0, "four times": 4.0, "half": 0.5}
_SO = "(?:tall|high|long|big)"
_ONE = f"(?:one of them|one of which|the one|one|the (?:left|right|first|second|other|{_C})(?: one| {_K})?)"
_MUST = "(?:should|must|has to|shall)"
_IS = f"(?:is|being|are|{_MUST} be|to be|standing|made|has|having|with|{_MUST} have|contains?)"
_AMOUNT = f"(?:exactly |just )?(?:by )?(?P<by>{_N}|an?) (?:{_B}|levels?|layers?|stor(?:y|ies|eys?)|floors?)"
_REL = (
    f"(?:{_AMOUNT} (?P<more>{_THAN})|(?P<more2>{_THAN})(?= than (?:{_ONE}|it|that) by )"
    f"|(?P<by3>{_N}|an?) (?P<more3>more|fewer|less) {_B}"
    f"|(?:exactly |just )?(?P<times>{'|'.join(_TIMES)}) (?:as {_SO}|as many {_B}|the (?:height|length|size))"
    f"|(?P<same>(?:(?:exactly|just) )?as {_SO}|equally {_SO}|as many {_B}|the same (?:height|length|size)))"
)
_OTHER = (
    f"(?:(?: than| as| of) (?P<other>{_ONE}|it|that|an? {_C} {_K})(?: is| has| does)?"
    f"(?: by (?:exactly )?(?P<by2>{_N}|an?)(?: {_B})?)?)"
)
_LINK = "(?: ,)?(?: ;)?(?: \\.)?(?: and| so that| such that| where| with| of which| but)?"
_CLAUSE = on_demand(f"(?:^|{_LINK} )(?P<one>{_ONE})(?: {_IS})? {_REL}{_OTHER}")
_EACH_AS = on_demand(f"{_LINK} (?P<same>as many {_B}) in (?:the )?one as in the other(?: one)?")
_BARE = on_demand(
    f"(?:(?<=tower)|(?<=stack)|(?<=row)|(?<=line)) (?:that is |which is |of |with )?{_REL}{_OTHER}?(?= |$)"
)
_PAIR = on_demand(f"(?:two|2|a pair of) (?:(?P<color>{_C}) )?(?P<kind>{_K})s(?: of (?:(?P<color2>{_C}) )?{_B})?")
_TOTAL = on_demand(
    f"(?: ,)? ?(?:(?:of|from|out of|with|using|made of|made from|built from|use)(?: all)?(?: the)? )?(?P<total>{_N}) "
    f"(?:(?P<color>{_C}) )?{_B}\\b(?! (?:high|tall|long)\\b)(?: (?:in all|altogether|in total|all in all))?"
    "(?: for both)?"
)
_SIZED = on_demand(
    f"(?P<det>an?|the) (?:(?P<color>{_C}) )?(?P<kind>{_K})(?: (?P<plain>of {_B})\\b| "
    f"(?:of|that has|which has|has|consists of|is) (?P<count>{_N})(?: (?:(?P<color2>{_C}) )?"
    f"(?:{_B}|high|tall|long)\\b(?: high\\b| tall\\b| long\\b)?|(?= (?:and|with|,)|$))(?! {_THAN}))?"
)
_STOCK = on_demand(
    f"(?:^|(?<=\\. ))(?:out of|from|with|using|given) ({_N}) ({_C}) and ({_N}) ({_C}) {_B}(?= ,| build| make)"
)
"""All there is of two colours, which the two take up."""
_SIDE = on_demand(
    f"{_LINK} the (?P<which>taller|higher|longer|shorter|lower|smaller)(?: one| {_K})?(?: of the two)? "
    f"(?:stands|is|goes|lies|comes|(?:should|must|has to|shall) (?:be|stand|go|lie))(?: placed)? "
    f"(?:(?:on|to|at) the (?P<side>left|right)(?: side)?(?: of the (?:other|taller|shorter|longer|lower|higher)"
    f"(?: one| {_K})?)?|(?P<color>{_C}))(?= [.,;]| and|$)"
)
_NEXT = (
    "(?:that is |which is |directly |right )*(?:on|to|below|beneath|under|underneath|above|before|after|behind|left|"
    "right)"
)
"""What tells a neighbour: each is compared with that, and not with so many blocks."""
_BY_HOW_MUCH = on_demand(f"(?:^| )(?P<one>{_ONE}) {_IS} {_THAN} than (?:{_ONE}|it)\\b(?! by| {_NEXT}\\b)")
_HAS_SO_MANY = on_demand(f"\\bthe {_C} one (?:has|is|{_MUST} (?:have|be)) {_N}\\b(?! {_B} (?:{_THAN}|more|fewer|less))")
"""How many blocks one of them has, told in a clause of its own: the second reader knows that."""
TELLING = frozenset({*_MORE, "tall", "high", "long", "many", "more", "fewer", "less", "height", "length"})
"""Words without which nothing of this is said."""


class _Rel(NamedTuple):
    """The one is so much more than the other, or so many times as much."""

    more: int
    times: float
    text: str


class _Text:
    """Tokens as one line of words, with the tokens that stand where."""

    def __init__(self, tokens: list[Token]) -> None:
        self.tokens = tokens
        words = [token.word.replace(" ", "_") or "_" for token in tokens]
        self.starts: list[int] = []
        at = 0
        for word in words:
            self.starts.append(at)
            at += len(word) + 1
        self.line = " ".join(words)

    def changed(self, changes: list[tuple[int, int, str]]) -> list[Token]:
        """The tokens with some parts of the line said otherwise."""
        out: list[Token] = []
        at = 0
        for begin, end, said in sorted(changes):
            first = next((n for n, start in enumerate(self.starts) if start >= begin), len(self.tokens))
            last = next((n for n, start in enumerate(self.starts) if start >= end), len(self.tokens))
            out += self.tokens[at:first]
            near = self.tokens[min(first, len(self.tokens) - 1)]
            out += [near.saying(_word(int(word)) if word.isdigit() else word) for word in said.split()]
            at = max(last, at)
        return out + self.tokens[at:]


def sizes_compared(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The structures with the number of blocks of each, in the place of what compares them."""
    if TELLING.isdisjoint(words):
        return None
    text = _told_apart(_Text(tokens))
    for change in (_pair, _named, _by_side):
        if (found := change(text)) is not None:
            return _by_side(_Text(found)) or found
    if (told := _BY_HOW_MUCH.search(text.line)) is not None and re.search(f"\\b{_K}s?\\b", text.line):
        raise _refusal("ambiguous", "it is not said by how many blocks", text, told.span(), "say 'one block taller'")
    return text.tokens if text.tokens is not tokens else None


def _number(said: str | None) -> int:
    return 1 if said in ("a", "an") else int(said) if said and said.isdigit() else lexicon.NUMBER.get(said or "", 0)


def _word(count: int) -> str:
    return next((w for w, n in lexicon.NUMBER.items() if n == count and w.isalpha() and w != "couple"), str(count))


def _relation(match: re.Match[str]) -> _Rel:
    said = match.groupdict()
    if said.get("times"):
        return _Rel(0, _TIMES[said["times"]], match.group())
    way = _MORE.get(said.get("more") or said.get("more2") or "", 0)
    if said.get("more3"):
        way = 1 if said["more3"] == "more" else -1
    return _Rel(way * _number(said.get("by") or said.get("by2") or said.get("by3")), 1.0, match.group())


def _shared(rel: _Rel, total: int, kind: str, text: _Text, at: tuple[int, int]) -> tuple[int, int]:
    """How many blocks the one has, and how many the other."""
    other = (total - rel.more) / (1 + rel.times)
    one = total - other
    if other != int(other) or min(one, other) < 1:
        raise _refusal("count-mismatch", f"{total} blocks cannot be shared between two {kind}s in this way", text, at,
                       "say how many blocks each has")  # fmt: skip
    return int(one), int(other)


def _refusal(code: str, message: str, text: _Text, at: tuple[int, int], hint: str) -> Refusal:
    inside = [t for t, start in zip(text.tokens, text.starts, strict=True) if at[0] <= start < at[1]]
    span = (inside[0].span[0], inside[-1].span[1]) if inside else None
    return Refusal([Diagnostic(code=code, message=message, span=span, hint=hint, origin="schema")])


def _free(text: _Text, taken: list[tuple[int, int]]) -> list[re.Match[str]]:
    """Numbers of blocks that are told outside of what is taken already."""
    found = _TOTAL.finditer(text.line)
    return [m for m in found if not any(a < m.end("total") and m.start("total") < b for a, b in taken)]


def _pair(text: _Text) -> list[Token] | None:
    """ "two towers from seven blocks, one of them a block taller than the other"."""
    pairs = list(_PAIR.finditer(text.line))
    clause = _CLAUSE.search(text.line) or _EACH_AS.search(text.line)
    if len(pairs) != 1 or clause is None or clause.start() < pairs[0].end():
        return None
    pair, rel = pairs[0], _relation(clause)
    one, other = clause.groupdict().get("one") or "one", clause.groupdict().get("other") or "the other"
    kind = pair["kind"]
    sides = [side for side in ("left", "right") if f"the {side}" in one or f"the {side}" in other]
    named = re.search(f"\\b{_C}\\b", f"{one} {other}")
    if named or "first" in one or "second" in one:
        return None
    totals = _free(text, [pair.span(), clause.span()])
    if _goes_on(text, clause.end()) and all(m.start() != clause.end() for m in totals):
        return None
    if len(totals) == 1 and clause.groupdict().get("same") and text.line[totals[0].start() :].strip().startswith("of"):
        return None  # of so many each?
    if len(totals) != 1:
        message = f"it is not said how many blocks there are for the two {kind}s"
        raise _refusal("ambiguous", message, text, clause.span(), f"say 'from {_word(_enough(rel))} blocks'")
    total = totals[0]
    a, b = _shared(rel, _number(total["total"]), kind, text, total.span())
    if min(a, b) < 2 and kind in ("tower", "stack"):
        raise _refusal("too-few", f"a lone block is no {kind}", text, total.span(), "use more blocks")
    if len(sides) == 1 or (sides and "the left" in other and "the left" not in one):
        a, b = (b, a) if ("the right" in one or "the left" in other) else (a, b)
    color = pair["color"] or pair["color2"] or total["color"]
    made = [f"a {kind} of {_word(n)} {color + ' ' if color else ''}blocks" for n in (a, b)]
    said = (" to the left of " if sides else " and ").join(made)
    if _there(text, total) and not sides and kind in ("tower", "stack"):
        said = f"two {color + ' ' if color else ''}{kind}s of heights {_word(a)} and {_word(b)}"
    there = [] if _there(text, total) else [(*total.span(), "")]
    return text.changed([(*pair.span(), said), *there, (*clause.span(), "")])


def _enough(rel: _Rel) -> int:
    """So many blocks as can be shared between the two in that way."""
    shared = ((other * rel.times + rel.more, other) for other in (3, 2, 4, 2 - rel.more))
    return next(int(one + other) for one, other in shared if one == int(one) and one > 1)


def _goes_on(text: _Text, end: int) -> bool:
    """Whether more is said of what something is compared with: "than the blue tower on the mat"."""
    rest = text.line[end:]
    return bool(re.match(" [^.,;!? ]", rest)) and not rest.startswith((" and ", " from ", " out of "))


def _there(text: _Text, total: re.Match[str]) -> bool:
    """ "There are seven blocks": that is said by itself."""
    before = text.line[: total.start()].strip()
    return bool(re.search("(?:there are|we have|i have|you have|given|here are)(?: only| just)?$", before))


_TWO_COLORS = on_demand(f"\\b(an?) ({_C}) and (an?) ({_C}) ({_K})\\b")
_TWO_SIZES = on_demand(
    f"(?:two|2) (?:(?P<color>{_C}) )?(?P<kind>{_K})s (?:of|with)(?: heights?)? (?P<a>{_N}) and (?P<b>{_N})"
    f"(?: (?:(?P<color2>{_C}) )?{_B})?"
)


def _told_apart(text: _Text) -> _Text:
    """ "a red and a blue tower" as a red tower and a blue tower; "two towers of four and three blocks" one by one."""
    if (two := _TWO_COLORS.search(text.line)) is not None:
        text = _Text(text.changed([(*two.span(), f"{two[1]} {two[2]} {two[5]} and {two[3]} {two[4]} {two[5]}")]))
    both = _TWO_SIZES.search(text.line) if _SIDE.search(text.line) else None
    if both is not None:
        color = f"{both['color'] or both['color2'] or ''} "
        made = [f"a {both['kind']} of {both[n]} {color}blocks" for n in ("a", "b")]
        text = _Text(text.changed([(*both.span(), " and ".join(made))]))
    return text


def _named(text: _Text) -> list[Token] | None:
    """ "a red tower of three blocks and a blue tower just as tall", "the red tower is as tall as the blue one"."""
    found: list[tuple[re.Match[str], str]] = []
    for m in _SIZED.finditer(text.line):
        color = m["color"] or m["color2"]
        if color and not (m["color"] and m["color2"]):
            found.append((m, color))
    clause = _CLAUSE.search(text.line)
    bare = None if clause else _BARE.search(text.line)
    told = clause or bare
    if told is None or _HAS_SO_MANY.search(text.line):
        return None
    inside = [(m, c) for m, c in found if told.start() <= m.start() < told.end()]
    outside = [(m, c) for m, c in found if not told.start() <= m.start() < told.end()]
    sizes = {c: _number(m["count"]) for m, c in found if m["count"]}
    if told.groupdict().get("other") and _goes_on(text, max([told.end(), *(m.end() for m, _ in inside)])):
        return None
    one, other = _who(told, clause is not None, outside, inside)
    if one is None or other is None or one == other:
        return None
    rel, kind = _relation(told), next((m["kind"] for m, _ in found), "tower")
    stock = {m[n]: _number(m[n - 1]) for m in _STOCK.finditer(text.line) for n in (2, 4)}
    if {one, other} <= {*stock} and not sizes:
        _from_one(rel, stock[one], stock[other], kind, text, told.span())
        return text.changed([(*told.span(), "")])
    totals = _free(text, [told.span(), *(m.span() for m, _ in found)])
    pairs = list(pairwise(m for m, _ in outside))
    if any(m["color"] or any(a.end() <= m.start() < b.end() for a, b in pairs) for m in totals):
        return None
    if one not in sizes and other not in sizes and len(totals) == 1:
        a, b = _shared(rel, _number(totals[0]["total"]), kind, text, totals[0].span())
    elif one in sizes or other in sizes:
        if totals:
            return None  # of which of them?
        a, b = _from_one(rel, sizes.get(one), sizes.get(other), kind, text, told.span())
    else:
        raise _refusal("ambiguous", f"it is not said how many blocks the two {kind}s have", text, told.span(),
                       "say how many blocks one of them has")  # fmt: skip
    return _with_sizes(text, told, clause is not None, found, outside, {one: a, other: b}, sizes, totals, kind)


def _who(
    told: re.Match[str], clause: bool, outside: list[tuple[re.Match[str], str]], inside: list[tuple[re.Match[str], str]]
) -> tuple[str | None, str | None]:
    """The colours of the two that are compared."""
    first = re.search(f"\\b{_C}\\b", told["one"]) if clause else None
    second = re.search(f"\\b{_C}\\b", told.groupdict().get("other") or "")
    if clause:
        return (first.group() if first else None), (second.group() if second else None)
    mine = [c for m, c in outside if m.end() == told.start()]
    others = [c for m, c in outside if m.end() != told.start()]
    other = second.group() if second else others[0] if len(others) == 1 and not told.groupdict().get("other") else None
    return (mine[0] if mine else None), other


def _from_one(
    rel: _Rel, one: int | None, other: int | None, kind: str, text: _Text, at: tuple[int, int]
) -> tuple[int, int]:
    """Both sizes from that of the one, or of the other."""
    a = one if one is not None else (other or 0) * rel.times + rel.more
    b = other if other is not None else (a - rel.more) / rel.times
    if a != b * rel.times + rel.more:
        raise _refusal("contradiction", f"the {kind}s do not have so many blocks", text, at, "leave one number out")
    if a != int(a) or b != int(b) or min(a, b) < 1:
        raise _refusal("count-mismatch", f"there is no such number of blocks for the {kind}", text, at, "say how many")
    return int(a), int(b)


def _with_sizes(
    text: _Text, told: re.Match[str], clause: bool, found: list[tuple[re.Match[str], str]],
    outside: list[tuple[re.Match[str], str]], wanted: dict[str, int], sizes: dict[str, int],
    totals: list[re.Match[str]], kind: str,
) -> list[Token]:  # fmt: skip
    """The text with each size behind its structure, and without what compares them."""
    changes: list[tuple[int, int, str]] = []
    missing = []
    for color, count in wanted.items():
        mine = [m for m, c in outside if c == color]
        if color in sizes:
            continue
        if not mine:
            missing.append(f"the {color} {kind} has {_word(count)} blocks")
        else:
            at = mine[0].start("plain") if mine[0]["plain"] else mine[0].end()
            changes.append((at, mine[0].end(), f" of {_word(count)} blocks"))
    other = [m for m, c in found if not clause and told.start() <= m.start() < told.end() and m["count"]]
    said = " and a" + other[0].group().removeprefix(other[0]["det"]) if other else ""
    end = max([told.end(), *(m.end() for m in other)])
    lead = re.match(_LINK, told.group())
    if missing:
        said = (lead.group() if lead else "") + " " + " , ".join(missing)
    spans = [m.span() for m in totals if m.start() > 0] if not sizes else []
    return text.changed([*changes, *((a, b, "") for a, b in spans), (told.start(), end, said)])


def _by_side(text: _Text) -> list[Token] | None:
    """ "(two towers of four and three blocks.) The taller one is on the left", "... is red"."""
    sized = [m for m in _SIZED.finditer(text.line) if m["count"] and m["det"] != "the"]
    told = _SIDE.search(text.line)
    if told is None or len(sized) != 2 or sized[0].end() > sized[1].start() or told.start() < sized[1].end():
        return None
    joint = text.line[sized[0].end() : sized[1].start()]
    counts = [_number(m["count"]) for m in sized]
    if joint.strip() not in ("and", ", and", ",") or counts[0] == counts[1]:
        return None
    highest = 0 if counts[0] > counts[1] else 1
    which = highest if told["which"] in ("taller", "higher", "longer") else 1 - highest
    if told["color"]:
        if sized[which]["color"] or sized[which]["color2"]:
            return None
        at = sized[which].start() + len(sized[which]["det"])
        return text.changed([(at + 1, at + 1, told["color"]), (*told.span(), "")])
    left = which if told["side"] == "left" else 1 - which
    said = f"{sized[left].group()} to the left of {sized[1 - left].group()}"
    return text.changed([(sized[0].start(), sized[1].end(), said), (*told.span(), "")])


def sizes_listed(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The big, the medium and the small red block": all of them are red."""
    for last in range(3, len(words) - 2):
        looks = words[last + 1] in lexicon.COLOR and lexicon.BLOCK.get(words[last + 2]) is False
        if words[last] not in lexicon.SIZE or not looks:
            continue
        sizes, at = [], last - 1
        while at > 0:
            at -= words[at] == "the"
            joined = words[at] in (",", "and")
            at -= joined + (joined and words[at - 1] == ",")
            if not joined or at < 0 or words[at] not in lexicon.SIZE:
                break
            sizes.append(at)
            at -= 1
        if sizes and words[sizes[-1] - 1] == "the":
            named = tokens[last + 1 : last + 3]
            return [part for n, token in enumerate(tokens) for part in (token, *(named if n in sizes else ()))]
    return None
