"""What is said of each colour, or of each patch with what has its colour, said of the blocks of each colour."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import behind, length_at
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";", ":"})
_STACKED = frozenset({"stack", "stacked", "pile", "piled"})
_EACH_ON = tuple(
    (",", *link, each, thing, *verb, on)
    for link in ((), ("and",), ("with",))
    for each in ("each", "every")
    for thing in ("color", "stack", "tower", "pile", "one")
    for verb in ((), ("goes",), ("is",), ("stands",), ("belongs",))
    for on in ("on", "onto")
)
_OF_ITS_COLOR = (("of", "its", "color"), ("of", "its", "own", "color"), ("of", "the", "same", "color"),
                 ("of", "that", "color"), ("with", "the", "same", "color"), ("of", "their", "color"),
                 ("which", "has", "its", "color"), ("that", "has", "its", "color"), ("in", "its", "color"),
                 ("in", "its", "own", "color"), ("in", "the", "same", "color"))  # fmt: skip


_BY_COLOR = frozenset({("each", "color"), ("every", "color"), ("same", "color"), ("each", "stack"), ("each", "tower")})
"""What tells already that these are stacked by colour."""


def each_on_its_own(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Stack two red and two blue blocks, each colour on the mat of its colour": stack them by colour, each stack
    there."""
    for at in range(1, len(words)):
        on = at + length_at(words, at, _EACH_ON)
        begin = next((n + 1 for n in range(at - 1, -1, -1) if words[n] in _STOPS), 0)
        if on == at or _STACKED.isdisjoint(words[begin:at]) or not any(w in lexicon.PATCH for w in words[on : on + 4]):
            continue
        its = any(length_at(words, n, _OF_ITS_COLOR) for n in range(on, min(on + 4, len(words)))) or "own" in words[on:]
        told = {*zip(words[begin:at], words[begin + 1 : at], strict=False)}
        if its and not _BY_COLOR.isdisjoint(told):
            patch = next(n for n in range(on, len(words)) if words[n] in lexicon.PATCH)
            end = behind(words, patch + 1, _OF_ITS_COLOR) or patch + 1
            of = [tokens[at].saying(word) for word in ("on", "the", words[patch], "of", "that", "color")]
            return [*tokens[:at], *of, *tokens[end:]]
        if not its:
            continue
        by = [] if "by" in words[begin:at] else [tokens[at].saying(word) for word in ("by", "color")]
        each = [tokens[at].saying(word) for word in (",", "each", "stack", "on")]
        out = [*tokens[:at], *by, *each, *tokens[on:]]
        got = next((n for n in range(begin, at) if words[n] in ("get", "gets") and words[n + 1] in _STACKED), 0)
        must = [tokens[got].saying(word) for word in ("must", "be")] if got else []
        return [*out[:got], *must, *out[got + 1 :]] if got else out
    return None


_LEADS = (("for", "each", "color", ","), ("for", "every", "color", ","), ("for", "each", "of", "the", "colors", ","),
          ("for", "each", "color"), ("for", "each", "of", "the", "colors"), ("per", "color", ","))  # fmt: skip
_OF_IT = (("of", "that", "color"), ("of", "the", "color"), ("in", "that", "color"), ("of", "this", "color"),
          ("with", "that", "color"))  # fmt: skip


def for_each_color(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "For each colour, put the blocks of that colour on the mat of that colour": the blocks of each colour."""
    for at in range(len(words)):
        verb = behind(words, at, _LEADS)
        if not verb or verb >= len(words) or words[verb] not in lexicon.COMMANDS:
            continue
        the = verb + 1
        the += words[the : the + 1] == ["up"]
        the += words[the : the + 1] == ["all"]
        block = the + (words[the : the + 1] == ["the"])
        if block >= len(words) or words[block] not in lexicon.BLOCK or not lexicon.BLOCK[words[block]]:
            continue
        end = behind(words, block + 1, _OF_IT) or block + 1
        of = [tokens[block].saying(word) for word in ("of", "each", "color")]
        return [*tokens[:at], *tokens[verb : block + 1], *of, *tokens[end:]]
    return None


_HAS = (("gets",), ("has",), ("holds",), ("carries",), ("bears",), ("receives",), ("should", "get"), ("must", "get"),
        ("should", "hold"), ("must", "hold"), ("should", "have"), ("must", "have"), ("must", "carry"),
        ("should", "carry"), ("is", "for"))  # fmt: skip


def mats_have(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Each mat gets the blocks of its colour": the blocks of each colour must be on the mat of that colour."""
    for at in range(len(words) - 5):
        if words[at] not in ("each", "every") or lexicon.PATCH.get(words[at + 1]) is not False:
            continue
        has = behind(words, at + 2, _HAS)
        all_ = has + (words[has : has + 1] == ["all"])
        block = all_ + (words[all_ : all_ + 1] == ["the"])
        plural = block < len(words) and lexicon.BLOCK.get(words[block]) is True
        end = behind(words, block + 1, _OF_ITS_COLOR) if has and block > has and plural else 0
        if end:
            said = ("the", words[block], "of", "each", "color", "must", "be", "on", "the", words[at + 1], "of", "that",
                    "color")  # fmt: skip
            return [*tokens[:at], *(tokens[at].saying(word) for word in said), *tokens[end:]]
    return None


_SORTED = frozenset({"sort", "distribute", "deal", "divide", "assign", "allocate", "put", "arrange", "place", "share"})
_TO = frozenset({"to", "on", "onto", "over", "among", "between", "across"})
_BY = (("by", "color"), ("by", "their", "color"), ("according", "to", "color"), ("according", "to", "their", "color"),
       ("by", "colors"))  # fmt: skip


def sorted_onto_mats(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Distribute the cubes to the mats by colour": put them on the mats of their colour."""
    for at in range(2, len(words) - 3):
        the = at + 1 + (words[at + 1] == "the")
        end = behind(words, the + 1, _BY)
        if words[at] not in _TO or lexicon.PATCH.get(words[the]) is not True or not end:
            continue
        verb = next((n for n in range(at - 1, -1, -1) if words[n] in _SORTED or words[n] in _STOPS), -1)
        if verb < 0 or words[verb] in _STOPS:
            continue
        said = [tokens[at].saying(word) for word in ("on", "the", words[the], "of", "their", "color")]
        what = [t for n, t in enumerate(tokens[verb + 1 : at]) if n or t.word != "out"]
        return [*tokens[:verb], tokens[verb].saying("put"), *what, *said, *tokens[end:]]
    return None


ORGANIZED = frozenset({"organize", "organise"})
_LINES = frozenset({"row", "line", "column", "tower", "stack", "rows", "lines", "columns", "grid"})


def organized(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Organise them by colour": sort them, where no line is spoken of."""
    at = next((n for n, word in enumerate(words) if word in ORGANIZED), -1)
    by = at >= 0 and any(words[n : n + 2] in (["by", "color"], ["by", "kind"]) for n in range(at, len(words)))
    return [*tokens[:at], tokens[at].saying("sort"), *tokens[at + 1 :]] if by and _LINES.isdisjoint(words) else None
