"""How single cubes are turned, told in the middle of something else: taken out, and told in sentences of their own."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Sequence

from rpg.language.frames.pieces import Pattern, Unclear, coded, joined, patterns
from rpg.language.tokens import Token

_NOUN = "(?:letters?|digits?|numbers?|cubes?|blocks?)"
_MARKED = "(?:labell?ed|marked|with|showing|bearing|carrying)"
_SIGN = r"(?:[A-Z]|\d|(?<=the )[a-z]|(?<=its )[a-z]|(?<=letter )[a-z])"
_SYMBOL = rf"(?:(?:the|a|an|its|it is|only|just|both|either) )*(?:(?:{_NOUN}|{_MARKED}|the) )*{_SIGN}(?: {_NOUN})?"
_WHO = [
    *patterns("symbols", None, rf"{_SYMBOL}(?:(?: ,)?(?: and)? {_SYMBOL})*"),
    *patterns("all", None,
        rf"(?:(?:all|all of|both|each|every|each of) )+(?:(?:the|its|these|those) )*(?:{_NOUN}|them)", "everything",
        "both|all",
        r"(?:the|its) (?:letters|digits|cubes|blocks)(?! [A-Z0-9] )|they"),
    *patterns("rest", None,
        r"(?:all )?(?:the )?(?:others|rest|(?:remaining|other) (?:[2-5] )?(?:letters|cubes|ones|digits|blocks)|other "
        r"[2-5])"),
    *patterns("nth", None,
        rf"(?:(?:only|just) )?(?:the|its) (?P<nth>first|second|third|fourth|last|middle) (?:{_NOUN}|one)",
        rf"(?:(?:only|just) )?(?:the|its) {_NOUN} in the (?P<nth>middle)"),
    *patterns("it", None, "it|its (?:letter|digit|number)|the cube"),
]  # fmt: skip
_VERB = patterns("verb", None,
    "(?:please )?(?:turn|rotate|flip|spin|make|put|place|lay|leave|keep|set|have|want|would like|need)")  # fmt: skip
_SO = patterns("so", None,
    "(?:, )?(?:so that|such that|so|until) (?:(?:its|the) (?:letter|digit|symbol)|it is|its|it|they)",
    "to show (?:its|the) (?:letter|digit|symbol)")  # fmt: skip
_BE = patterns("be", None,
    r"(?:(?:that|which) )?(?:(?:must|should|shall|will|may only|has to|have to|needs to|need to|is to|are to) )?"
    r"(?:(?:be|is|are|stays?|lies?|stands?|appears?|remains?|reads?|shows?|being|lying|standing|reading|facing|kept|"
    r"put|given|held|placed) )*(?:be|is|are|stays?|lies?|stands?|appears?|remains?|reads?|being|lying|standing|"
    r"reading|kept|put|given|held|placed|must|has to)")  # fmt: skip
_TURNED = r"(?:(?:just )?(?:turned|rotated|given|spun|flipped|twisted) )?(?:by )?"
_ROUND = "(?P<way>(?:counter |anti )?clockwise|counterclockwise|anticlockwise|cw|ccw|to the left|to the right)"
_STATES = [
    *patterns("state", "upright",
        "(?:readable and |normal and )?(?:upright|(?:the )?right (?:side|way) up|(?:the )?(?:right|correct) way "
        "(?:up|round)|normal|as usual)(?: on top)?(?: (?:,|and|/) (?:readable|legible))?"),
    *patterns("state", "upside down",
        "(?:turned |flipped |rotated )?(?:upside down|on (?:its|their) heads?)",
        rf"{_TURNED}(?:(?:a |one )?half (?:of )?(?:a )?turn|180 (?:degrees|deg|°))(?: {_ROUND})?"),
    *patterns("state", "sideways", "(?:turned |lying |put )?(?:sideways|on (?:its|their) sides?)"),
    *patterns("state", lambda match: _turned_by(match["angle"], match["way"]),
        rf"{_TURNED}(?P<angle>\d+) (?:degrees|deg|°) {_ROUND}",
        rf"{_TURNED}(?:a |one )?(?P<angle>quarter)(?: (?:of )?(?:a )?(?:turn|turned))? {_ROUND}(?: turn)?",
        rf"{_TURNED}(?:(?P<angle>quarter) )turned {_ROUND}"),
    *patterns("state", lambda match: f"turned with its top to the {match['side']}",
        r"(?:with )?(?:(?:its|the) )top (?:pointing|points|directed) (?:to |towards? )?(?:the )?"
        r"(?P<side>left|right)"),
]  # fmt: skip
_SEEN = patterns("seen", None,
    r"(?:, )?(?:as )?(?:seen|viewed|looked at|read) (?:from above|from the (?:camera|top)|by the (?:camera|viewer))",
    "(?:, )?(?:for|to) (?:me|the (?:camera|viewer|reader))", "from upright",
    "(?:, )?(?:when|as) [iI] look at (?:it|them|its top)", "please", "though", "i e", "that is")  # fmt: skip
PATTERNS = [*_WHO, *_VERB, *_SO, *_BE, *_STATES, *_SEEN]
_LEAD = re.compile(
    "(?:(?:[,;.:(]|and|with|but|where|while|whereas|though|then|also|please|(?:can|could|would|will) you|[iI]) )*"
)
_BOUNDS = frozenset({
    ".", ",", ";", ":", "!", "?", "(", ")", "and", "but", "with", "where", "while", "whereas", "though", "both",
    "i", "I",
})  # fmt: skip
_ABOUT = re.compile(
    r"\b(?:upside|upright|turn|turned|rotate|rotated|sideways|flipped|flip|heads?|quarter|half|degrees|facing|way up|"
    r"on (?:its|their) sides?)\b"
)
_LEFT_TURN = frozenset({
    "counter clockwise", "counterclockwise", "anti clockwise", "anticlockwise", "ccw", "to the left",
})  # fmt: skip
_UNIT = re.compile(r"(?:letters|digits|cubes|blocks|ones|degrees?|deg|°|cm|mm|centimet(?:er|re)s?)$")
_SPEAKS = re.compile(r"(?:look|want|would|see|like|need|can|am|have|stand|sit|read|think|do|mean|wish|hope|picture)$")
_ONLY = frozenset({"only", "just"})
_SHOWN = frozenset({"letter", "letters", "digit", "digits", "number", "numbers", "symbol", "symbols", "vowels",
                    "consonants", "alphabetical", "equation", "sum", "word", "spell", "write"})  # fmt: skip
"""Words of a text about cubes that show something."""
_NTH = {"first": 0, "second": 1, "third": 2, "fourth": 3, "last": -1}


def _turned_by(angle: str, way: str) -> str:
    degrees = "90" if angle == "quarter" else angle
    return f"turned by {degrees} degrees {'counterclockwise' if way in _LEFT_TURN else 'clockwise'}"


def without_turns(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], list[Token], str]]:
    """The text without the stretches that tell how cubes are turned; the first of those, and what all of them say."""
    words = coded(tokens)
    text, places = joined(words)
    if not _ABOUT.search(text):
        return
    said: list[tuple[str, str, str]] = []
    rest: list[Token] = []
    stretch: list[Token] = []
    n = 0
    while n < len(words):
        bound = not n or words[n] in _BOUNDS or words[n - 1] in _BOUNDS
        found = _statement(text, places[n]) if bound and not _excepted(words, n) else None
        if found is None:
            rest.append(tokens[n])
            n += 1
            continue
        end, statement = places.index(found[0]), found[1]
        said.append(statement)
        stretch = stretch or list(tokens[n:end])
        n = end
    left = coded(rest)
    if not said or _ABOUT.search(" ".join(left)):
        return
    try:
        told = " ".join(_told(said, words, tokens))
    except Unclear:
        return
    yield rest, stretch, told


def _excepted(words: Sequence[str], n: int) -> bool:
    """ "All but (B should be upside down)": who this is of begins before."""
    but = n if words[n] == "but" else n - 1
    return but > 0 and words[but] == "but" and words[but - 1] in _WHOLE


_WHOLE = frozenset({"all", "everything", "each", "every", "none", "nothing", "cubes", "blocks", "letters", "digits",
                    "them", "these", "those", "ones"})  # fmt: skip
"""Of these "but" takes something out."""


def _statement(text: str, at: int) -> tuple[int, tuple[str, str, str]] | None:
    """A statement that begins here: where it ends, who it is of (the kind, and the words), and how they are turned."""
    begun, lead = at, _LEAD.match(text, at)
    at = lead.end() if lead else at
    binding = lead[0].split() if lead else []
    verb = _longest(text, at, _VERB)
    at = verb.end() if verb else at
    ways = [(m.end(), p.kind, m) for p in _WHO if (m := p.expression.match(text, at))]
    who = max(ways, key=lambda way: way[0], default=(at, "it", re.match("", "")))
    if verb and at == who[0]:
        return None
    listed = re.search(rf"(?<!\S){_SIGN} (?:, |and )*$", text[:begun]) and set(binding) <= {",", "and"} and not verb
    first = re.search(rf"(?<!\S){_SIGN}(?!\S)", who[2][0]) if who[1] == "symbols" and who[2] else None
    if first and listed and first[0] not in text[:begun].split():
        return None  # "the letters L and F upright": the list began before
    at = who[0]
    for known in (_SO, _BE) if verb else (_BE,):
        between = _longest(text, at, known)
        at = between.end() if between else at
    states = [(m.end(), p, m) for p in _STATES if (m := p.expression.match(text, at))]
    if not states:
        return None
    at, pattern, match = max(states, key=lambda x: x[0])
    while (seen := _longest(text, at, _SEEN)) is not None:
        at = seen.end()
    ahead = text[at:].split(" ", 1)[0]
    if ahead and ahead not in _BOUNDS:
        return None
    said = f"{who[2][0]} {who[2].groupdict().get('nth', '')}" if who[2] else ""
    return at, (who[1], said.strip(), pattern.says(match))


def _longest(text: str, at: int, known: Sequence[Pattern]) -> re.Match[str] | None:
    found = [match for pattern in known if (match := pattern.expression.match(text, at))]
    return max(found, key=lambda match: match.end(), default=None)


def _told(said: Sequence[tuple[str, str, str]], words: Sequence[str], tokens: Sequence[Token]) -> list[str]:
    """The statements in plain sentences.

    Raises:
        Unclear: it is not known which cubes are meant, or one is turned in two ways.
    """
    spelt = [str(token.value).upper() for token in tokens if token.kind in ("literal", "quote")]
    symbols = list(dict.fromkeys([*_symbols(words, tokens), *"".join(spelt)]))
    rest = any(kind == "rest" for kind, _, _ in said)
    turned: dict[str, str] = {}
    found: list[str] = []
    for kind, who, state in said:
        if kind == "all":
            if not symbols and _SHOWN.isdisjoint(words):  # plain blocks look the same on every side
                raise Unclear
            found.append(f"All letters must be {state}.")
            continue
        named = _named(kind, who, spelt, symbols, turned)
        if not named or any(turned.get(symbol, state) != state for symbol in named):
            raise Unclear
        only = not _ONLY.isdisjoint(who.split()) and not rest
        if only and len(named) > 1:
            raise Unclear
        found += [f"{'Only the' if only else 'The'} {symbol} block must be {state}." for symbol in named]
        turned |= dict.fromkeys(named, state)
    if len(found) > 1 and any(text.startswith(("All", "Only")) for text in found):
        raise Unclear
    return found


def _named(kind: str, who: str, spelt: Sequence[str], symbols: Sequence[str], turned: Container[str]) -> list[str]:
    """The symbols of the cubes that are meant."""
    if kind == "symbols":
        return [word.upper() for word in re.findall(rf"(?<!\S){_SIGN}(?!\S)", who)]
    if kind == "rest":
        return [symbol for symbol in symbols if symbol not in turned]
    if kind == "nth":
        return [_nth(spelt, who.split()[-1])]
    return list(symbols) if len(symbols) == 1 else []


def _symbols(words: Sequence[str], tokens: Sequence[Token]) -> Iterator[str]:
    """The symbols that stand by themselves, as far as no word of a number, no measure and no person is one of them."""
    for n, (word, behind) in enumerate(zip(words, [*words[1:], ""], strict=True)):
        sign = tokens[n].raw
        if word.isdigit() and len(word) == 1 and sign == word and not _UNIT.match(behind):
            yield word
        article = sign == "A" and word != "A" and behind not in (",", "and", "is", "must", "should")
        if re.fullmatch("[A-Z]", sign) and not article and not (sign == "I" and _SPEAKS.match(behind)):
            yield sign


def _nth(spelt: Sequence[str], which: str) -> str:
    if len(spelt) != 1 or (which == "middle" and len(spelt[0]) % 2 == 0):
        raise Unclear
    at = len(spelt[0]) // 2 if which == "middle" else _NTH[which]
    letter = spelt[0][at] if at < len(spelt[0]) else ""
    if spelt[0].count(letter) != 1:
        raise Unclear
    return letter
