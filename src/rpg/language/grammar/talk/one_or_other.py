"""One of two different things, and the other: "put one of A and B on the mat, leave the other on the table" is either
A on the mat and B on the table, or B on the mat and A on the table."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.tokens import Token

_ARTICLES = frozenset({"the", "a", "an", "one"})
_BLOCKS = lexicon.BLOCK.keys() | lexicon.LETTER.keys() | lexicon.DIGIT.keys()
_NOUNS = _BLOCKS | lexicon.PATCH.keys()
_THEM = (["the", "two"], ["these", "two"], ["them"], ["these"], ["the"])
_GUIDES = frozenset({"first", "then", "after", "before", "finally", "either", "or", "each", "both", "start", "starts",
                     "beginning", "initially", "if", "unless"})  # fmt: skip
"""With these it is not a plain choice between two things that are so at the end."""
_BACK = frozenset({"it", "they", "them", "this", "that", "these", "those", "one", "its", "their", "former", "latter",
                   "both"})  # fmt: skip
"""Behind them these may mean whichever was chosen."""
_BEGINS = frozenset({"one", "either", "the"})
_PUT = frozenset({"put", "place", "set", "lay", "move", "stack"})
_PLACES = frozenset({"on", "onto", "in", "into", "to", "of", "off", "beside", "behind", "under", "above", "near", "at",
                     "from", "touching", "with", "below", "against", "inside"})  # fmt: skip
_RELATING = frozenset({*_PLACES, "is", "goes", "must", "should", "be", "go", "lie", "lies", "the", "top", "left",
                       "right", "front", "next", "directly", "exactly", "cm"})  # fmt: skip
"""Words of which one to the other is told."""
_ELSE = frozenset({"blocks", "cubes", "bricks", "boxes", "letters", "digits", "side", "half", "end", "corner", "way",
                   "hand", "order", "ones", *lexicon.STRUCTURE, *lexicon.NUMBER}) - {"one", "square"}  # fmt: skip
"""Behind "the other" these are none of the two."""
_VERBS = frozenset({"is", "goes", "should", "must", "has", "stands", "lies", "needs", "belongs", "ends", "shall"})
_JOINS = frozenset({"and", ",", "but", "while", "with", "whereas"})
Pair = tuple[list[Token], list[Token]]


def one_or_the_other(tokens: list[Token]) -> list[Token] | None:
    """The words with both ways to choose told in full; None where no one of two different blocks is chosen."""
    words = [token.word for token in tokens]
    if "other" not in words or any(n and words[n - 1] == "other" for n, word in enumerate(words) if word in _ELSE):
        return None
    last = len(words) - 1 - words[::-1].index("other")
    for at, word in enumerate(words[:last]):
        found = _one_of(tokens, at) if word in _BEGINS or words[at + 1] == "or" else None
        if found is not None:
            if _patch(found[1][0][-1]):
                return None  # told of the whole text once for each of them
            meant = _related(words[found[0] : last]) or all(
                _meant(words, n, found[1]) for n in range(found[0], last + 1) if words[n] == "other"
            )
            return _told(tokens, at, *found, last) if meant else None
    return None


def _related(between: list[str]) -> bool:
    """ "one (is on top of the) other": no more than how the two stand to each other."""
    return between[-1:] == ["the"] and _RELATING.issuperset(between)


def _meant(words: list[str], at: int, pair: Pair) -> bool:
    """Whether "the other" is one of the two: what something is put on is not, unless they are patches."""
    noun = words[at + 1] if at + 1 < len(words) else ""
    if noun in _NOUNS:
        return (noun in lexicon.PATCH) == _patch(pair[0][-1])
    return _patch(pair[0][-1]) or words[at - 2] not in _PLACES


def _told(tokens: list[Token], at: int, end: int, pair: Pair, last: int) -> list[Token] | None:
    """Both ways of what is said between the sentence of the one and that of the other."""
    words = [token.word for token in tokens]
    stops = [n for n, token in enumerate(tokens) if token.kind == "punct" and token.word in STOPS]
    begin = max((n + 1 for n in stops if n < at), default=0)
    close = min((n for n in stops if n > last), default=len(tokens))
    said = [*words[begin:at], *words[end:close]]
    if not _GUIDES.isdisjoint(said) or not _BACK.isdisjoint(words[close:]) or _unclear(said):
        return None
    if any(token.many > 1 and token.kind == "word" for token in (*tokens[begin:at], *tokens[end:close])):
        return None
    first = _way(tokens[begin:at], pair[0], tokens[end:close], pair[1])
    second = [token.saying("the") if _new(token) else token for token in tokens[begin:at]]
    rest = [token.saying("the") if _new(token) else token for token in tokens[end:close]]
    mark = tokens[at]
    either = [mark.saying("either"), *first, mark.saying(","), mark.saying("or"), *_way(second, pair[1], rest, pair[0])]
    return [*tokens[:begin], *either, *tokens[close:]]


def _unclear(said: list[str]) -> bool:
    """Whether "it" may mean one of the two: no mat is spoken of in front of it, and it is not "where it is"."""
    its = [n for n, word in enumerate(said) if word in ("it", "there") and said[n - 1] != "where"]
    return any(lexicon.PATCH.keys().isdisjoint(said[:n]) for n in its)


def _way(before: list[Token], one: list[Token], behind: list[Token], other: list[Token]) -> list[Token]:
    """What is said with one of the two in its place, and the other in its own."""
    words = [*(token.word for token in behind), "", ""]
    way = [*(token for token in before if token.word != "exactly"), *one]
    at = 0
    while at < len(behind):
        if words[at : at + 2] == ["the", "other"]:
            at += 2 + (words[at + 2] in _NOUNS or words[at + 2] == "one")
            way += other
            continue
        kept = words[at] == "keep" and words[at + 1 : at + 3] == ["the", "other"] and "table" in words[at:]
        if kept:  # "keep the other one on the table": at the end
            way.append(behind[at].saying("put"))
        elif behind[at].word in STOPS or words[at : at + 3] == [",", "the", "other"]:
            way.append(behind[at].saying("and"))
        elif words[at] != "," or words[at + 1] not in _JOINS:
            way.append(behind[at])
        at += 1
    return way


def _new(token: Token) -> bool:
    """Whether this begins the name of something that was not spoken of before."""
    return token.word in ("a", "an") and not _shown(token.raw)


def _one_of(tokens: list[Token], at: int) -> tuple[int, Pair] | None:
    """Where "one of A and B", "either A or B" that begins here ends, and the two."""
    words = [token.word for token in tokens]
    begins = words[at] == "one" and at > 0 and words[at - 1] in STOPS and words[at + 1] in _VERBS
    put = words[at] == "one" and words[at - 1] in _PUT and words[at + 1] in _RELATING - {"of"}
    if begins or put:
        pairs = [pair for part in sentences(tokens[:at])[-1 if begins else -2 :] for pair in _listed(part)]
        return (at + 1, pairs[0]) if len(pairs) == 1 else None
    if words[at : at + 2] != ["one", "of"]:
        return _two(tokens, at + (words[at] == "either"), ("or",)) if words[at] != "one" else None
    if (told := _two(tokens, at + 2, ("and",))) is not None:
        return told
    them = next((t for t in _THEM if words[at + 2 : at + 2 + len(t)] == t), [])
    end = at + 2 + len(them)
    end += bool(them) and words[end] in _NOUNS
    pairs = [pair for part in sentences(tokens[:at])[-2:] for pair in _listed(part)]
    fits = len(pairs) == 1 and (words[end - 1] not in _NOUNS or _patch(tokens[end - 1]) == _patch(pairs[0][0][-1]))
    return (end, pairs[0]) if fits and words[end - 1] != "the" else None


def _listed(part: list[Token]) -> list[Pair]:
    """The two things that a sentence lists, if it names no others."""
    words = [token.word for token in part]
    begins = [n for n in range(len(part)) if words[n] in _ARTICLES or (n > 1 and _counted(words[n - 2 : n]))]
    found = dict(two for n in begins if (two := _two(part, n, *_ALSO)) is not None)
    named = sum(word in lexicon.COLOR for word in words) if len(found) == 1 else 0
    return list(found.values()) if named in (0, 2) else [*found.values()] * 2


def _counted(ahead: list[str]) -> bool:
    """ "(two) blocks, (A and B)"."""
    return ahead[0] in _NOUNS and ahead[1] in (",", ":")


_ALSO = (("and", "there", "is"), ("and",))


def _two(tokens: list[Token], at: int, *joints: tuple[str, ...]) -> tuple[int, Pair] | None:
    """Where two different things that are joined here end, and each of them by its full name."""
    words = [token.word for token in tokens]
    noun = at + (words[at] == "the")
    noun += words[noun : noun + 1] == ["two"]
    at = noun + 1 if noun < len(words) and words[noun] in _NOUNS and words[noun].endswith("s") else at
    one = _named(tokens, at)
    joint = next((j for j in joints if one and words[one[0] : one[0] + len(j)] == [*j]), None)
    other = _named(tokens, one[0] + len(joint)) if one and joint else None
    if one is None or other is None or one[1].word == other[1].word:
        return None
    if (one[1].word in lexicon.COLOR) != (other[1].word in lexicon.COLOR):
        return None
    what = other[2] or one[2]
    if what is not None and one[2] is not None and _patch(one[2]) != _patch(what):
        return None
    return other[0], (_full(one[1], what), _full(other[1], what))


def _named(tokens: list[Token], at: int) -> tuple[int, Token, Token | None] | None:
    """Where the name of a thing ends, the colour or the symbol in it, and its noun."""
    words = [token.word for token in tokens[at : at + 3]]
    if (
        len(words) > 1
        and words[0] in _ARTICLES
        and (words[1] in lexicon.COLOR or words[1] in _NOUNS or _shown(tokens[at + 1].raw))
    ):
        at, words = at + 1, words[1:]
    ahead = tokens[at] if len(words) > 1 and words[0] in _BLOCKS else None
    at += ahead is not None
    look = tokens[at] if at < len(tokens) else None
    if look is None or not (look.word in lexicon.COLOR or _shown(look.raw)):
        return None
    behind = tokens[at + 1] if at + 1 < len(tokens) else None
    noun = behind if behind is not None and behind.word in _NOUNS else None
    return at + 1 + (noun is not None or (behind is not None and behind.word == "one")), look, noun or ahead


def _shown(raw: str) -> bool:
    """Whether this is written as a symbol that a block shows."""
    return len(raw) == 1 and (raw.isupper() or raw.isdigit())


def _full(look: Token, noun: Token | None) -> list[Token]:
    if look.word in lexicon.COLOR:
        return [look.saying("the"), look, look.saying("patch" if noun is not None and _patch(noun) else "block")]
    return [look.saying("block"), look]


def _patch(noun: Token) -> bool:
    return noun.word in lexicon.PATCH
