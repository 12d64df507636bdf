"""One of two patches, whichever, and the other: "one mat stays empty, the other gets all three gray blocks. The mats
are red and blue", told once for either way to choose."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MUST, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_MARK = f"(?:{PATCHES}|{PATCH})"
_NO_BLOCK = "(?! (?:blocks?|cubes?|bricks?|box|boxes|towers?|stacks?|rows?|ones)\\b)"
_JOINT = "(?: ,| and| or| , and| , or| and there is)"
_AN = "(?: (?:one|the one|the other|the|an?|on|either))*"
_LISTED = f"{_AN} ({COLOR})(?: one)?{_JOINT}{_AN} ({COLOR})(?: one)?(?= |$){_NO_BLOCK}"
_LIKED = " (?:you|we) (?:like|want|prefer|choose)"
_EACH_TOLD = (
    f"one(?: {PATCH})? is ({COLOR})(?: ,)?(?: and)? (?:one|the other)(?: one| {PATCH})?(?: is)? ({COLOR})(?= [.!]|$)"
)
_NAMED = tuple(
    on_demand(f"(?<![^ ]){pattern}")
    for pattern in (
        f"({COLOR})(?: {PATCH})?{_JOINT}{_AN} ({COLOR}) {_MARK}(?= |$)",
        f"({COLOR}) {_MARK}{_JOINT}{_AN} ({COLOR}) one(?= |$)",
        f"{PATCHES}(?: are| :| ,| \\()?{_LISTED}",
        f"{PATCH}(?:{_LIKED})?(?: :| ,| \\()?(?: either)?(?: the)? ({COLOR})(?: one)? or(?: the)? ({COLOR})"
        f"(?: one)?(?= |$){_NO_BLOCK}",
        _EACH_TOLD,
        f"({COLOR}) {_MARK}(?= |$)",
    )
)
"""How the colors of patches are told."""
_PLAINLY = Turns(
    [
        (
            f" (?:,|and|\\.) (?:the )?(?:two )?{PATCHES} (?:are|:){_LISTED}(?= [.!]|$)",
            ". there are a {1} and a {2} patch",
        ),
        (f"(?: [,.]| and) {_EACH_TOLD}", ". there are a {1} and a {2} patch"),
        (f"^{_EACH_TOLD}", "there are a {1} and a {2} patch"),
        (
            f"(?: {MUST})? share (?:one|an?|the same|a single)(?: one| {PATCH})?(?= [.,:;(]|$)",
            "must be on the same patch",
        ),
    ]
)
"""Which patches there are, told in a sentence of its own, and what is on one together."""
_WHICH = (
    f"(?: [,:(])?(?: either)?(?: the)? {COLOR}(?: one| {PATCH})? or (?:the )?{COLOR}(?: one| {PATCH})?(?: [,)])?"
    f"|(?: \\( {COLOR} (?:,|and) {COLOR} \\))"
)
_DOES = (
    "(?:gets?|has|have|holds?|stays?|remains?|receives?|carries|bears|is (?:empty|free)|must|should|shall|needs|with)"
)
_ON = "(?:(?<=\\bon )|(?<=\\bonto )|(?<=\\bin ))"
_THEM = "of (?:them|these|those|the two)"
_CHOSEN = on_demand(
    f"(?<![^ ])(?:(?:either )?(?P<on>on |onto )?the {COLOR}(?: {PATCH})? or (?:on |onto )?the {COLOR} {PATCH}(?= |$)"
    f"|(?:one|either) (?:of (?:the |these |both )?(?:two )?{PATCHES}|{PATCH})(?= |$)(?:{_WHICH}(?= |$))?"
    f"|whichever (?:of (?:the |these )?(?:two )?{PATCHES}|{PATCH})(?:{_LIKED})?(?= |$)"
    f"(?:{_WHICH}(?= |$))?"
    f"|{_ON}(?:one|either)(?: {_THEM})?(?= (?:and|or|with|together|[,.;:(])|$)(?:{_WHICH}(?= |$))?"
    f"|(?:(?<=[.:,;] )|^)(?:one|either)(?: {_THEM})? (?={_DOES}))"
)
_OTHER = on_demand(f"(?<![^ ])the other(?: one)?(?: {_THEM})?(?: {PATCH})?(?= |$)")
_THERE = on_demand("(?:^|.* )(?:on|onto|in|into|leave|keep|leaving|keeping|from|off|clear|empty)$")
_SAME = on_demand(f"{_ON}(?:the same|that same|that)(?: one| {PATCH})(?= |$)(?:{_WHICH}(?= |$))?")
_ONE = frozenset({"one", "either", "whichever"})
_BEGINS = frozenset({"one", "either", "whichever", "same", "share", "or"})
"""Words with which one of two patches is spoken of."""
_GUIDES = frozenset({"not", "never", "each", "every", "any", "no", "neither", "none", "if", "unless", "other", "same",
                     "start", "first", "then", "before", "after", "initially", "beginning", "different"})  # fmt: skip
"""With these it is no plain choice of what is so at the end."""


def mats_chosen(tokens: list[Token]) -> list[list[Token]]:
    """The words with the one or the other of two patches that are told by their colors; none where none is chosen."""
    words = {token.word for token in tokens}
    if words.isdisjoint(_BEGINS) or words.isdisjoint(lexicon.PATCH):
        return []
    tokens = turned(tokens, _PLAINLY, all_of_it)
    text = text_of(tokens)
    colors, same = _colors(text), list(_SAME.finditer(text))
    others = [found for found in _OTHER.finditer(text) if _of_patches(found, text)]
    chosen = list(_CHOSEN.finditer(text)) or same[:1]
    if len(colors) != 2 or len(chosen) != 1 or not (others or same or not _ONE.isdisjoint(chosen[0][0].split())):
        return []
    ones = list(dict.fromkeys((*chosen, *same)))
    rest = _without(text, [*ones, *others])
    if not _GUIDES.isdisjoint(rest.split()):
        return []
    there = f". there are a {colors[0]} and a {colors[1]} patch" if len(_colors(rest)) < 2 and not others else ""
    found = []
    for one, other in (colors, colors[::-1]):
        told = _told(tokens, text, {**dict.fromkeys(ones, one), **dict.fromkeys(others, other)})
        found.append([*told, *(told[-1].saying(word) for word in there.split())])
    return found


def _colors(text: str) -> list[str]:
    """The colors that patches are told to have."""
    found = [match.groups() for pattern in _NAMED for match in pattern.finditer(text)]
    return list(dict.fromkeys(color for colors in found for color in colors))


def _of_patches(other: re.Match[str], text: str) -> bool:
    """Whether "the other" is a patch: what blocks are on, or what has them."""
    named = other[0].rpartition(" ")[2] in lexicon.PATCH
    there = _THERE.match(text[: other.start()].rstrip()) or re.match(f" {_DOES}\\b", text[other.end() :])
    return named or there is not None


def _without(text: str, parts: list[re.Match[str]]) -> str:
    for part in sorted(parts, key=re.Match.start, reverse=True):
        text = text[: part.start()] + text[part.end() :]
    return text


def _told(tokens: list[Token], text: str, chosen: dict[re.Match[str], str]) -> list[Token]:
    """The words with patches of these colors in these places."""
    told = [*tokens]
    for part in sorted(chosen, key=re.Match.start, reverse=True):
        begin, end = (len(text[:at].split()) for at in part.span())
        said = f"{part.groupdict().get('on') or ''}the {chosen[part]} patch"
        told[begin:end] = [tokens[begin].saying(word) for word in said.split()]
    return told
