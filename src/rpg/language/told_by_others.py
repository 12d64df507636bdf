"""What is told by another that was told before it: "the second from the bottom is red, the one above it is blue",
"three towers ..., with the blue one in the middle", "tower A has two red blocks ...; A is left of B"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.compared_and_counted import compared_and_counted
from rpg.language.grammar.rows.parting import STOPS, text_of
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MANY, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_ORDINALS = {n: words.split()[0] for n, words in lexicon.ORDINALS.items()}
_SIDES = {"above": "top", "over": "top", "on top of": "top", "below": "bottom", "under": "bottom", "beneath": "bottom",
          "underneath": "bottom", "to the right of": "right", "right of": "right", "to the left of": "left",
          "left of": "left", "behind": "back", "in front of": "front"}  # fmt: skip
_ACROSS = {"top": "bottom", "bottom": "top", "left": "right", "right": "left", "front": "back", "back": "front"}
_NEXT = on_demand(
    rf"\bthe (?P<nth>{'|'.join(lexicon.ORDINAL)})(?: one| {CUBE})? from the (?P<end>{'|'.join(_ACROSS)})"
    rf" (?:(?:is|be|must be|should be) )?(?:an? )?{COLOR}(?: one| {CUBE})?(?: [,;.])?(?: and)? "
    rf"(?P<next>the (?:next )?(?:one|{CUBE}) (?:(?:right|directly|just|immediately) )?"
    rf"(?:(?P<way>{'|'.join(_SIDES)}) (?:it|that|this)(?: one)?|to its (?P<its>left|right)))(?= )"
)
_FIGURES = "tower|stack|pile|row|line|column"
_LOT = on_demand(rf"\bof {MANY} (?P<of>{COLOR})\b|\b(?P<color>{COLOR}) (?:{_FIGURES})s?\b|\b(?:{_FIGURES})s?\b")
_IN_THE_MIDDLE = on_demand(
    rf"(?:[,.;] |\bwith |\band )the (?P<color>{COLOR}) (?P<noun>one|{_FIGURES}) (?:(?:is|stands|standing|being) )?"
    r"(?P<place>in the (?:middle|center))(?= [.;!?]|$)"
)
_NAMED = on_demand(
    rf"\b(?P<noun>{_FIGURES}) (?P<name>[a-z]|\d) "
    r"(?:has|consists of|contains|is (?:of|(?:made|built|made up) of))\b"
)
_BEHIND_NAMES = frozenset({"is", "stands", "goes", "must", "should", "will", "stays", "lies", "comes", "and", "on",
                           "to", "left", "right", "behind", "in", "next", "beside", ",", *STOPS})  # fmt: skip
_AHEAD_OF_NAMES = frozenset({"of", "and", "between", "behind", "beside", "to", "than", ",", "then", *STOPS})
_WITH_ONE_ON_IT = on_demand(
    rf"\beach of the (?:{MANY} )?(?:{PATCHES}|corners)\b[^.;!?]*(?P<color>\b{COLOR}) {CUBE} "
    rf"(?P<with>with an? (?P<other>{COLOR}) (?:one|{CUBE}) on (?:top(?: of it)?|it))(?= )[^.;!?]*(?= [.;!?]|$)"
    rf"|(?P<color2>\b{COLOR}) {CUBE} (?P<with2>with an? (?P<other2>{COLOR}) (?:one|{CUBE}) on (?:top(?: of it)?|it))"
    rf" [^.;!?]*\beach of the (?:{MANY} )?(?:{PATCHES}|corners)\b[^.;!?]*(?= [.;!?]|$)"
)
_THREE = 3


def told_by_others(tokens: list[Token]) -> list[Token]:
    """The tokens with such places and figures by what they are themselves."""
    words = {token.word for token in tokens}
    if "from" in words and not words.isdisjoint(lexicon.ORDINAL):
        tokens = _counted_on(tokens)
    if not words.isdisjoint(("middle", "center")):
        tokens = _between_the_others(tokens)
    if not words.isdisjoint(("has", "made", "built", "consists", "contains", "of")):
        tokens = _with_nouns(tokens)
    if "each" in words and "with" in words:
        tokens = _one_on_each(tokens)
    return compared_and_counted(tokens)


def _counted_on(tokens: list[Token]) -> list[Token]:
    """ "(The second from the bottom is red,) the one above it": the third from the bottom."""
    text = text_of(tokens)
    while (found := _NEXT.search(text)) is not None:
        side = found["its"] or _SIDES[found["way"]]
        step = {found["end"]: -1, _ACROSS[found["end"]]: 1}.get(side, 0)
        nth = _ORDINALS.get(lexicon.ORDINAL[found["nth"]] + step)
        if not step or nth is None:
            break
        begin, end = (text[:at].count(" ") for at in found.span("next"))
        said = ["the", nth, "from", "the", found["end"]]
        tokens = [*tokens[:begin], *map(tokens[begin].saying, said), *tokens[end + 1 :]]
        text = text_of(tokens)
    return tokens


def _between_the_others(tokens: list[Token]) -> list[Token]:
    """ "(A tower of two red blocks, one of three blue ones and one of two white ones,) with the blue one in the
    middle": the blue tower between the other two."""
    text = text_of(tokens)
    found = _IN_THE_MIDDLE.search(text)
    if found is None:
        return tokens
    lots = list(_LOT.finditer(text, 0, found.start()))
    colors = [lot["of"] or lot["color"] for lot in lots if lot["of"] or lot["color"]]
    nouns = {word.removesuffix("s") for lot in lots for word in lot.group().split()} & {*_FIGURES.split("|")}
    if len(colors) != _THREE or len({*colors}) != _THREE or found["color"] not in colors or len(nouns) != 1:
        return tokens
    noun, begin, end = (text[: found.start(part)].count(" ") for part in ("noun", "place", "place"))
    end += len(found["place"].split())
    said = map(tokens[begin].saying, ("between", "the", "other", "two"))
    return [*tokens[:noun], tokens[noun].saying(*nouns), *tokens[noun + 1 : begin], *said, *tokens[end:]]


def _with_nouns(tokens: list[Token]) -> list[Token]:
    """ "(Tower A has two red blocks, tower B has three blue ones;) A is left of B": tower A is left of tower B."""
    text = text_of(tokens)
    named = list(_NAMED.finditer(text))
    if not named:
        return tokens
    nouns = {found["name"]: found["noun"] for found in named}
    behind = text[: named[-1].end()].count(" ") + 1
    out = tokens[:behind]
    for at, token in enumerate(tokens[behind:], behind):
        bare = token.word in nouns and (token.raw.isupper() or token.raw.isdigit())
        if bare and tokens[at - 1].word in _AHEAD_OF_NAMES and _follows(tokens, at):
            out.append(token.saying(nouns[token.word]))
        out.append(token)
    return out


def _follows(tokens: Sequence[Token], at: int) -> bool:
    """Whether a name may end here, and a lot of so many blocks or the article of a noun does not begin."""
    return at + 1 == len(tokens) or tokens[at + 1].word in _BEHIND_NAMES


def _one_on_each(tokens: list[Token]) -> list[Token]:
    """ "On each of the two mats is a red block with a blue one on top": on each red block is a blue one."""
    text = text_of(tokens)
    found = _WITH_ONE_ON_IT.search(text)
    if found is None:
        return tokens
    part = "" if found["color"] else "2"
    color, other = found["color" + part], found["other" + part]
    if color == other or any(text.split().count(look) > 1 for look in (color, other)):
        return tokens
    begin, end = (text[:at].count(" ") for at in found.span("with" + part))
    stop = text[: found.end()].count(" ") + 1
    said = map(tokens[begin].saying, (".", "on", "each", color, "block", "is", "a", other, "one"))
    return [*tokens[:begin], *tokens[end + 1 : stop], *said, *tokens[stop:]]
