"""So many of each colour on a patch: "at least one of each color must be on the mat", told of each colour by itself."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turn, Turns, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_LOTS = on_demand(f"\\b(?:{MANY}|an?|some|several) ({COLOR})\\b(?! {PATCH}\\b)")
_HUES = on_demand(f"\\b({COLOR})\\b(?! (?:{PATCH}|one on)\\b)")
_SO_MANY = f"((?:exactly |just |only |at least |at most |(?:no|not) (?:more|fewer|less) than )?{MANY})"
_OF_EACH = (
    "(?: (?:block|cube|brick|box|boxes|one)s?)? (?:of|in|from) (?:each|every|both)(?: of the)?(?: two| three)? colors?"
)
_BE = f"(?:is|are|lies?|stands?|sits?|(?:{MUST}|may|can) (?:be|go|lie|stand|sit|end up))"
_PART = "(?:(?:near|far|front|back|left|right) ){1,2}(?:half|corner)(?: of the table)?"
_ON = f"((?:on|in) (?:the|a) (?:(?:{COLOR} )?{PATCH}|{_PART}))"
_HOLDS = f"(?:(?:{MUST} )?(?:have|hold|carry|contain|bear)|has|holds|carries|contains|bears)"


def of_each_color(tokens: list[Token]) -> list[Token]:
    """The tokens with the colors in the place of each, where two or more are told with their numbers, and no others."""
    words = {token.word for token in tokens}
    if words.isdisjoint(("color", "colors")) or words.isdisjoint(("each", "every", "both")):
        return tokens
    text = text_of(tokens)
    told = dict.fromkeys(_LOTS.findall(text))
    if len(told) < 2 or not told.keys() >= {*_HUES.findall(text)} or len(told) > _FEW:
        return tokens
    return turned(tokens, Turns(_rows([*told])))


_FEW = 4
"""Of more colors nobody is meant to be told one by one."""


def _rows(colors: list[str]) -> list[Turn]:
    lots = " and ".join(f"{{1}} of the {color} blocks" for color in colors)
    return [
        (f"\\b(?:put |place |set |have |get )?{_SO_MANY}{_OF_EACH} {_BE} {_ON}", f"{lots} must be {{2}}"),
        (f"^(?:put|place|set|have|get|(?:i|we) would (?:love|like) to (?:see|have)) {_SO_MANY}{_OF_EACH} "
         f"{_ON}$", f"{lots} must be {{2}}"),
        (f"^(the (?:{COLOR} )?{PATCH}) {_HOLDS} {_SO_MANY}{_OF_EACH}(?: on it)?$",
         f"{lots.replace('{1}', '{2}')} must be on {{1}}"),
        (f"^on (the (?:{COLOR} )?{PATCH}) there (?:is|are|{MUST} be) {_SO_MANY}{_OF_EACH}$",
         f"{lots.replace('{1}', '{2}')} must be on {{1}}"),
        (f"^there (?:{MUST} be) {_SO_MANY}{_OF_EACH} {_ON}$", f"{lots} must be {{2}}"),
    ]  # fmt: skip
