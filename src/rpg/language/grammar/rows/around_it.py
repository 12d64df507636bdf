"""What goes around "it", the one block that was named before: "put the white block in the middle; six red ones form a
ring around it"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import CUBE, MANY
from rpg.language.tokens import Token

ONE = f"(?:the|an?) \\w+ (?:{CUBE}|one|brick)"
_AROUND = frozenset({"around", "round", "surrounding", "surround", "encircle", "ring"})
_VERBS = frozenset({"surround", "encircle", "ring"})
_OTHERS = frozenset({"other", "others", "rest"})
_ONE = frozenset({"block", "cube", "brick", "one"})
_JOINTS = STOPS | {"and", ",", "with"}


def around_named(tokens: list[Token]) -> list[Token]:
    """The tokens, with "it" behind "around" or "surround" as that block."""
    words = [token.word for token in tokens]
    at = words.index("it") if "it" in words else 0
    if at < 1 or words[at - 1] not in _AROUND or not (words[at - 1] in _VERBS or _ends(words, at)):
        return tokens
    begin = next((n for n, word in enumerate(words) if word in ("the", "a", "an")), at)
    joint = next((n for n, word in enumerate(words) if word in _JOINTS), at)
    if begin + 3 > joint or not _alone(words, begin, joint, at) or _in_one(words, begin, joint):
        return tokens
    the, color, noun = (replace(token, span=tokens[at].span) for token in tokens[begin : begin + 3])
    out = [*tokens[:at], the.saying("the"), color, noun]
    if words[joint] == "with":
        out[joint] = tokens[joint].saying("and")
    return [*out, *tokens[at + 1 :]]


def _in_one(words: list[str], begin: int, joint: int) -> bool:
    """ "A green block in the middle and four white ones around it": in the middle of these, and of one figure."""
    return words[joint] not in STOPS and " ".join(words[begin + 3 : joint]) in _MIDDLE


_MIDDLE = frozenset({"in the middle", "in the center", "at the center"})


def _ends(words: list[str], at: int) -> bool:
    """Whether the sentence ends with "around it", or tells of one on each side of it, and tells which blocks are: of
    "the others" it is told elsewhere."""
    ends = at + 1 == len(words) or words[at + 1] in STOPS or words[at + 1 : at + 4] == [",", "one", "on"]
    return ends and _OTHERS.isdisjoint(words[:at])


def _alone(words: list[str], begin: int, joint: int, at: int) -> bool:
    """Whether the first thing that is named is one block with a place, and nothing else told before could be "it"."""
    if words[begin + 1] not in lexicon.COLOR or words[begin + 2] not in _ONE:
        return False
    place = [word for word in words[begin + 3 : joint] if word in lexicon.COLOR or word in _ONE]
    ringed = {word for word in words[joint:at] if word in lexicon.COLOR}
    return not place and len(ringed) < 2 and not any(word in lexicon.PATCH for word in words[:at])


AROUND_AT_ONCE: tuple[Turn, ...] = (
    (
        f"\\b(?:surround|ring|encircle) ({ONE}) (?:with|by) an? (?:circle|ring) of ({MANY} [^,]+)$",
        "surround {1} with {2} in a circle",
    ),
    (
        f"\\b(?:ring|encircle) ({ONE}) (?:with|by) ({MANY} [^,]+?)(?: in an? (?:circle|ring))?$",
        "surround {1} with {2} in a circle",
    ),
    (f"\\b(and|,) an? (?:circle|ring) of ({MANY} [^,]+? around {ONE})$", "{1} {2}"),
)
"""A ring around a block is the blocks around it, where they are told after the place of that block."""
