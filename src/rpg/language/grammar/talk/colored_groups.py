"""Groups named by their colours that have strangers in them: they are groups by colour."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

GROUPS = frozenset({"group", "pile", "bunch", "cluster", "groups", "piles", "bunches", "clusters"})
_STRANGE = frozenset({"outlier", "outliers", "stranger", "strangers", "misfit", "intruder", "odd", "wrong", "other",
                      "another", "different", "foreign"})  # fmt: skip
_JOINTS = frozenset({"and", ","})


def colored_groups(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A red group and a blue one, with one stranger in each", "two groups, a red one and a blue one, ...": two groups
    by colour, where these are the colours of the blocks."""
    for at in range(len(words) - 3):
        if words[at] not in ("a", "an", "one") or words[at + 1] not in lexicon.COLOR:
            continue
        end, hues, noun = _listed(words, at)
        ahead = words[at - 3 : at]
        headed = len(ahead) == 3 and ahead[1] in GROUPS and ahead[2] in (",", ":") and tokens[at - 3].many == hues
        if hues < 2 or not (noun or headed) or not _strange(words[end:]):
            continue
        if _hues(words[at:end]) != _hues([*words[:at], *words[end:]]):
            return None
        begin = at - 3 if headed else at
        end += headed and words[end : end + 1] == [","] and words[end + 1 : end + 2] in (["out"], ["from"])
        said = (lexicon.NUMBERS.get(hues, "two"), "groups", "by", "color")
        return [*tokens[:begin], *(tokens[at].saying(word) for word in said), *tokens[end:]]
    return None


def _listed(words: list[str], at: int) -> tuple[int, int, bool]:
    """Where a list "a red group and a blue one" ends, how many colours it has, and whether it names groups."""
    hues, noun, end = 0, False, at
    while words[at : at + 1] in (["a"], ["an"], ["one"]) and words[at + 1 : at + 2] and words[at + 1] in lexicon.COLOR:
        thing = words[at + 2] if at + 2 < len(words) else ""
        if thing not in ("one", "group", "pile", "bunch", "cluster"):
            break
        noun = noun or thing != "one"
        hues, end = hues + 1, at + 3
        at = end
        while words[at : at + 1] and words[at] in _JOINTS:
            at += 1
    return end, hues, noun


def _hues(words: list[str]) -> set[str]:
    return {hue for word in words if (hue := lexicon.COLOR.get(word) or lexicon.COLOR_PLURAL.get(word))}


def _strange(words: list[str]) -> bool:
    return "each" in words and not _STRANGE.isdisjoint(words)
