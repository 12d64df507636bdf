"""Words that are not in the lexicon: the one near match, or a diagnostic with the nearest known ones."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib import import_module
from itertools import takewhile
from pkgutil import walk_packages
from types import CodeType, ModuleType

from rpg.core.diagnostics import Diagnostic
from rpg.language import frames, grammar, lexicon
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.harmless import EVERYDAY
from rpg.language.not_here import HINTS
from rpg.language.other_words import OTHER_WORDS
from rpg.language.roles import as_anyone, as_nice, names_as_words
from rpg.language.symbol_runs import runs_apart
from rpg.language.tokens import Token
from rpg.language.who_acts import as_robot

LONG_WORD = 7
"""From this length on, two slips are still taken for a misspelling."""
_ROWS = ("qwertyuiop", "asdfghjkl", "zxcvbnm")
NEAR_KEYS = {
    key: "".join(
        other
        for r, around in enumerate(_ROWS)
        for c, other in enumerate(around)
        if abs(r - line) <= 1 and abs(c - place) <= 1 and other != key
    )
    for line, keys in enumerate(_ROWS)
    for place, key in enumerate(keys)
}
"""Keys beside each key."""
_SPELLERS = frozenset({"spell", "spells", "spelling", "spelled", "spelt"})
_WRITERS = frozenset({"write", "writes", "read", "reads", "say", "says", "writing", "reading", "saying"})
_ORDERS = frozenset({"write", "writes"})
_THINGS = (lexicon.STRUCTURE, lexicon.BLOCK, lexicon.PATCH, lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL)
_WITH = frozenset({"with", "using", "from", "in", ".", "!", ",", "please"})
_SPELT = frozenset({"spelled", "spelt", "written"})
_WORD_LEADS = frozenset({"word", "name"})
_NOT_LITERAL = frozenset({"a", "an", "the", "out", "word", "words", "some", "any", "it", "with", "using", "from",
                          "by", "something", "my", "your", "in", "on", "across", "down", "that", "these", "this",
                          "those", "again", "backwards", "backward", "another"})  # fmt: skip


SHORT_FORMS = {
    "twr": "tower", "twrs": "towers", "blks": "blocks", "sq": "square", "pic": "picture", "pics": "pictures",
    "pcs": "pieces", "grn": "green", "ylw": "yellow", "yel": "yellow", "wht": "white", "orng": "orange",
    "prpl": "purple", "brn": "brown", "pnk": "pink", "lft": "left", "rgt": "right", "btm": "bottom", "bot": "bottom",
    "mid": "middle", "ctr": "center", "ea": "each", "clr": "color", "clrs": "colors", "cols": "columns",
    "btwn": "between", "betw": "between", "abt": "about", "dist": "distance", "horiz": "horizontal", "vert": "vertical",
    "alt": "alternating", "seq": "sequence", "rect": "rectangle", "tri": "triangle", "pyr": "pyramid",
    "num": "number", "nums": "numbers", "nbr": "number", "ltr": "letter", "ltrs": "letters", "ppl": "people",
    "cw": "clockwise", "asc": "ascending", "desc": "descending", "ccw": "counterclockwise",
    "nd": "and", "rn": "now", "outta": "from", "hight": "height", "pyramide": "pyramid",
    "permute": "arrange",
    "vs": "and", "versus": "and",
}  # fmt: skip
"""Words typed in short, in small letters."""


_COUNTS = frozenset({"none", "not", "all", "both", "each"})
"""Besides numbers what must not be guessed at: "thee red blocks" are three of them, or the red ones."""


@cache
def vocabulary() -> frozenset[str]:
    """Every word of the language: those of the lexicon's tables and those that the grammar and the frames name."""
    words: set[str] = set(lexicon.DEGREES.split())
    for value in _own(lexicon):
        if isinstance(value, dict | frozenset):
            words.update(str(word) for word in value)
    told = _Told()
    for found in walk_packages(grammar.__path__, f"{grammar.__name__}."):
        module = import_module(found.name)
        for value in _own(module):
            code = getattr(getattr(value, "__wrapped__", value), "__code__", None)
            if code is not None and code.co_filename == module.__file__:
                told.by_code(code)
            elif not isinstance(value, str):  # a string of its own is a part of others, or a pattern
                told.by(value)
    words |= told.words() | frames.words()
    words -= _FIELDS
    return frozenset(w for w in words if (w.isalpha() and w.islower()) or w in lexicon.ORDINAL)


_FIELDS = frozenset({"al", "det", "ed", "est", "ing", "loc", "nd", "op", "rel", "ther", "xor"})
"""Strings of the grammar that are names of fields, or parts of words."""


def _own(module: ModuleType) -> Iterator[object]:
    """What a module defines or imports, without what Python puts into every module."""
    return (value for name, value in vars(module).items() if not name.startswith("__"))


class _Told:
    """The strings in values; what several modules import is looked through once."""

    def __init__(self) -> None:
        self.texts: set[str] = set()
        self._seen: set[int] = set()

    def by(self, value: object) -> None:
        """Add the strings in a value; of a dictionary, of its keys and of its patterns."""
        if isinstance(value, str):
            self.texts.add(value)
        elif isinstance(value, Patterns):
            self.texts |= value.words
        elif isinstance(value, dict | tuple | frozenset) and id(value) not in self._seen:
            self._seen.add(id(value))
            self.texts.update(item for item in value if isinstance(item, str))
            for item in value:
                if not isinstance(item, str):
                    self.by(item)
            for item in value.values() if isinstance(value, dict) else ():
                if isinstance(item, Patterns):
                    self.by(item)

    def by_code(self, code: CodeType) -> None:
        """Add the strings in a function, its documentation left out."""
        for index, constant in enumerate(code.co_consts):
            if isinstance(constant, CodeType):
                self.by_code(constant)
            elif not (index == 0 and isinstance(constant, str)):
                self.by(constant)

    def words(self) -> set[str]:
        """The words of these strings."""
        return set(" ".join(self.texts).split())


def distance(a: str, b: str, limit: int) -> int:
    """Damerau's distance (optimal string alignment), or limit + 1 when it is greater."""
    if abs(len(a) - len(b)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        older, before, row = before, row, [i]
        for j, y in enumerate(b, 1):
            best = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                best = min(best, older[j - 2] + 1)
            row.append(best)
        if min(row) > limit:
            return limit + 1
    return row[-1]


def nearest(word: str, limit: int) -> list[str]:
    """Known words within `limit` slips, nearest first; to mix up the letters inside is one."""
    letters = _letters(word)
    scored = sorted(
        (1 if _mixed(word, known) else distance(word, known, limit), known)
        for known, theirs in _spelt()
        if abs(len(known) - len(word)) <= limit and (letters ^ theirs).bit_count() <= 2 * limit
    )
    return [known for slips, known in scored if slips <= limit]


def _mixed(word: str, known: str) -> bool:
    """ "withe" for "white": the same letters between the first and the last one."""
    return len(word) > 3 and word[0] + word[-1] == known[0] + known[-1] and sorted(word) == sorted(known)


@cache
def _spelt() -> tuple[tuple[str, int], ...]:
    """Every word of the language with its letters."""
    return tuple((word, _letters(word)) for word in vocabulary())


def _letters(word: str) -> int:
    """Which letters a word has, one bit for each: a slip takes away one of them at most, and adds one."""
    found = 0
    for letter in word:
        found |= 1 << (ord(letter) & 31)
    return found


def _one_match(word: str) -> str | None:
    """The one word that `word` is a misspelling of."""
    if len(word) < 3:
        return None
    for limit in (1, 2) if len(word) >= LONG_WORD else (1,):
        close = [k for k in nearest(word, limit) if len(k) > 2 and slip(word, k)]
        counts = [k for k in close if k in lexicon.NUMBER or k in _COUNTS]
        turned = [k for k in close if sorted(k) == sorted(word)]
        if len(turned) == 1:
            return turned[0]
        if len(close) > 1:
            close = _likeliest(word, close)
        if close:
            return close[0] if len(close) == 1 and counts in ([], close) else None
    return None


def slip(word: str, meant: str) -> bool:
    """Whether `word` could be typed for `meant`, rather than be another word: it begins alike, and in a short word a
    letter that stands for another is beside it on the keyboard."""
    if word[0] != meant[0] and word[:2] != meant[1::-1]:
        return False
    if len(word) != len(meant) or len(word) >= LONG_WORD:
        return True
    wrong = [(a, b) for a, b in zip(word, meant, strict=True) if a != b]
    return len(wrong) != 1 or wrong[0][1] in NEAR_KEYS.get(wrong[0][0], "")


def _likeliest(word: str, close: list[str]) -> list[str]:
    """Of several near words those with the very letters of `word`, then those that begin like it, then things."""
    for same in (
        lambda k: sorted(set(k)) == sorted(set(word)),
        lambda k: k[0] == word[0],
        lambda k: any(k in table for table in _THINGS),
    ):
        kept = [k for k in close if same(k)]
        if kept:
            close = kept
    return close


def read_words(tokens: list[Token]) -> tuple[list[Token], list[str], list[Diagnostic]]:
    """The tokens with misspellings mended and words to be spelt marked; assumptions; unknown words."""
    known = vocabulary()
    tokens = _letter_by_letter(as_robot(as_anyone(as_nice(names_as_words(runs_apart(tokens))), known), known))
    shouting = (
        sum(t.raw.isupper() and len(t.raw) > 1 for t in tokens) * 2 > len([t for t in tokens if t.kind == "word"])
        and len(tokens) > 3
    )
    out: list[Token] = []
    notes: list[str] = []
    wrong: list[Diagnostic] = []
    for index, token in enumerate(tokens):
        if token.kind != "word":
            out.append(token)
            continue
        if _is_literal(tokens, index, known):
            out.append(replace(token, kind="literal", value=token.raw))
        elif token.word in SHORT_FORMS and not token.raw.isupper():
            out.append(replace(token, word=SHORT_FORMS[token.word], raw=SHORT_FORMS[token.word]))
        elif token.word in known or len(token.word) == 1:
            quiet = (shouting and len(token.raw) > 1) or _agreed(tokens, index)
            out.append(replace(token, raw=token.raw.lower()) if quiet else token)
        elif token.raw.isupper() and not shouting:
            out.append(replace(token, kind="literal", value=token.raw))
        elif token.word not in NO_SLIPS and (match := _one_match(token.word)):
            notes.append(f"read {token.raw!r} as {match!r}")
            out.append(replace(token, word=match, raw=match))
        else:
            wrong.append(unknown(token))
            out.append(token)
    return out, notes, wrong


def _letter_by_letter(tokens: list[Token]) -> list[Token]:
    """ "Spell c-a-t", "spell P A P E R": one word, told by its letters."""
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        ahead = out[-1].word if out else ""
        end = at
        while [t.raw for t in tokens[end + 1 : end + 2]] == ["-"] and all(
            len(t.raw) == 1 for t in tokens[end : end + 3 : 2]
        ):
            end += 2
        letters = tokens[at : end + 1 : 2]
        if end == at and ahead in _SPELLERS | _WORD_LEADS:
            letters = [*takewhile(lambda token: len(token.raw) == 1 and token.raw.isupper(), tokens[at:])]
            end = at + len(letters) - 1
            letters = [] if [t.word for t in tokens[end + 1 : end + 2]] in ([","], ["and"]) else letters
        word = "".join(t.raw for t in letters)
        if len(letters) > 2 and word.isalpha() and ahead in _SPELLERS | _WRITERS | _WORD_LEADS | {"out"}:
            out.append(
                replace(tokens[at], word=word.lower(), raw=word.upper(), span=(tokens[at].span[0], tokens[end].span[1]))
            )
            at = end + 1
        else:
            out.append(tokens[at])
            at += 1
    return out


def _is_literal(tokens: list[Token], index: int, known: frozenset[str]) -> bool:
    """Whether the word is one to be spelt: it follows "the word" or "spell"."""
    word = tokens[index].word
    before = tokens[index - 1].word if index else ""
    two = tokens[index - 2].word if index > 1 else ""
    if before == "either" and index > 1:  # "spell either DOG or GOD"
        before, two = two, tokens[index - 3].word if index > 2 else ""
        spelt = before in _SPELLERS or before == "write"
        if spelt and tokens[index].raw.isupper() and not tokens[index - 2].raw.isupper():
            return True  # "spell either ON or NO"
    if before == ":" and two in _WORD_LEADS | _SPELLERS:  # "word: robot", and no more
        alone = index + 1 == len(tokens) or tokens[index + 1].kind == "punct"
        return alone and word not in _NOT_LITERAL
    named = (before == "is" and two == "name") or (before in ("called", "named") and two == "is")
    if named and word not in known:  # "my name is Anna"
        return True
    if before in ("", ".", "!") and tokens[index].raw.isupper() and len(word) > 1 and _then_spelt(tokens, index):
        return True
    if before in _WORD_LEADS and two in ("the", "spell", "spells", "a", "out"):
        goes_on = index + 1 < len(tokens) and tokens[index + 1].kind == "word" and not tokens[index].raw.isupper()
        told = index > 2 and tokens[index - 3].word in _MAKERS
        said_of = word in _SAID_OF_A_WORD or word in lexicon.VERB
        return word not in _NOT_LITERAL and not (word in _OF_A_WORD or (goes_on and said_of and not told))
    if before in _SPELLERS or (before == "out" and two in _SPELLERS):
        way = index + 1 < len(tokens) and tokens[index + 1].word == "to"  # "spelled left to right"
        way = way or (word == "either" and any(token.word == "or" for token in tokens[index:]))
        whose = index + 1 < len(tokens) and tokens[index + 1].word in _WORD_LEADS and word in _WHOSE
        return word not in _NOT_LITERAL and not way and not whose
    if (
        (before in _ORDERS or (before == "out" and two in _ORDERS))
        and (index == len(tokens) - 1 or tokens[index + 1].word in _WITH)
        and len(word) > 1
    ):
        return word not in _NOT_LITERAL and not any(word in table for table in _THINGS)
    said = before == "say" and (two in _POINTED or two == "to" or lexicon.BLOCK.get(two) is True)
    if _told_by_letters(tokens, index) or (said and tokens[index + 1 : index + 2] == [] and word not in _NOT_LITERAL):
        return True
    if word in known or len(word) < 2:
        return False
    after = tokens[index + 1].word if index + 1 < len(tokens) else ""
    behind = tokens[index + 2].word if index + 2 < len(tokens) else ""
    return before in _WRITERS or after in _SPELT or (after == "," and behind in _SPELT)


_WHOSE = frozenset({"my", "our", "her", "his", "their", "your"})


def _then_spelt(tokens: list[Token], index: int) -> bool:
    """ "CAT - spell that": what is asked for behind it."""
    marks = [*takewhile(lambda token: token.kind == "punct", tokens[index + 1 :])]
    behind = tokens[index + 1 + len(marks) : index + 3 + len(marks)]
    return bool(marks) and len(behind) == 2 and behind[0].word in _SPELLERS | {"write"} and behind[1].word in _POINTED


_POINTED = frozenset({"it", "this", "that", "the"})


def _told_by_letters(tokens: list[Token], index: int) -> bool:
    """ "Make drop out of the letters D, O, P and R": what these letters are of."""
    word, told = tokens[index].word, []
    for token in tokens[index + 1 :]:
        if len(token.word) == 1 and token.word.isalpha():
            told.append(token.word)
        elif told and token.word not in (",", "and"):
            break
        elif not told and token.word not in _OUT_OF_LETTERS:
            return False
    return len(told) > 2 and sorted(word) == sorted(told)


_OUT_OF_LETTERS = frozenset({"out", "of", "from", "with", "using", "the", "letters", "letter", "blocks", "cubes", ":"})
"""What stands between a word and the letters that it is made of."""


def _agreed(tokens: list[Token], index: int) -> bool:
    """ "OK. Put ...", "Hmm OK. ...": in front of an instruction it is no word to be spelt."""
    begins = index == 0 or tokens[index - 1].word in (".", "!", "?", ";", "hmm", "hm", "um", "uh", "ah", "oh", "well")
    goes_on = index + 2 < len(tokens) and tokens[index + 1].word in (".", "!", "…")
    return tokens[index].word == "ok" and begins and goes_on


_OF_A_WORD = frozenset({"is", "of", "to", "and", "should", "in", "on", "left", "right", "that", "from"})
_SAID_OF_A_WORD = frozenset({
    "must", "shall", "may", "can", "will", "would", "has", "have", "had", "starts", "begins", "needs", "need", "with",
    "for", "at", "by", "behind", "beside", "next", "near", "between", "into", "faces", "was", "which", "stays",
    "remains", "ends", "belongs", "there",
})  # fmt: skip
"""What is not the word to be spelt behind "the word", but says something of it; the latter only where more follows."""
_MAKERS = _SPELLERS | _WRITERS | {"make", "form", "build", "create", "out"}
"""Before "the word" these ask for the word behind it."""


NO_SLIPS = OTHER_WORDS | HINTS.keys() | EVERYDAY
"""Words that are known to mean something else than what they look like."""


def unknown(token: Token) -> Diagnostic:
    """A diagnostic for a word that means nothing here: known words that it could be a slip of, or what there is."""
    near = nearest(token.word, min(3, 1 + len(token.word) // 5))
    told = HINTS.get(token.word)
    close = [known for known in near if known[0] == token.word[0]][:3] if told is None else []
    if close:
        hint = f"did you mean {' or '.join(repr(c) for c in close)}?"
    elif told is not None:
        hint = told
    else:
        hint = "describe the task with blocks, patches and where they should be"
    return Diagnostic(
        code="unknown-word",
        message=f"{token.raw!r} means nothing here",
        span=token.span,
        hint=hint,
        facts={"word": token.raw, "nearest": close},
        origin="schema",
    )
