"""Wishes that are often typed and cannot be read: what is wrong with them in their own words, and what works."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic
from rpg.passes.schema.symbol_hints import about_symbols

_VAGUE = frozenset({"incomplete", "misplaced-word", "no-goal", "unknown-word"})
"""Codes of refusals that do not know what was wished."""
_UNLAID = "ABCDEFGHIJKMNOPQRSWYZ"
_LAID = "T, L, U, V and X"


@dataclass(frozen=True)
class _Wish:
    """What a text has in it, the message, and a wording that works."""

    pattern: re.Pattern[str]
    message: str
    hint: str


_UNCHECKED = (
    _Wish(
        re.compile(
            r"\b(?:hold|keep|stays?|remains?|stands?|stable|wait|leave|lift|there|block|cube|one)\b.*"
            r"\b(?:for|during|over)(?: at least| about| more than)? (?:\w+|\d+(?:\.\d+)?) ?"
            r"(?:s|secs?|seconds?|minutes?|min)\b",
            re.I,
        ),
        "how long it stays so is not measured: it is so at the end, when nothing holds or moves the blocks",
        "leave the time out, as in 'stack the red block on the blue block and let go'",
    ),
    _Wish(
        re.compile(
            r"\bhold(?:s|ing)? (?:it|them|the(?! most| fewest| least)|this|that|up|still|an?)\b|"
            r"\b(?:in|into|through) the air\b|\bhover",
            re.I,
        ),
        "a block that is held has no place at the end: what is checked is how blocks lie when nothing holds them",
        "say where it is put down, as in 'put the red block on the blue block'",
    ),
    _Wish(
        re.compile(r"\b(?:lift|raise|pick up)\b.*\b(?:put|set|place|lay)\b.*\bdown\b", re.I),
        "a block that is lifted and put down again is where it was, and nothing is left to check",
        "say where it is put down, as in 'put the red block on the blue block'",
    ),
    _Wish(
        re.compile(r"\b(?:poke|prod|tap|wiggle|shake|roll|trace|approach|regrasp|throw|kick|hand over)\b", re.I),
        "what the arm does on the way leaves nothing to check at the end",
        "say how the blocks should be at the end, as in 'the red block should be on the blue block'",
    ),
    _Wish(
        re.compile(r"\bon (?:the|its) way\b|\bas (?:a unit|one unit|one piece)\b|\bwithout lifting\b", re.I),
        "how a block gets to its place is not checked, but only where it is at the end",
        "leave this out, as in 'put the red block on the blue patch'",
    ),
    _Wish(
        re.compile(
            r"\b(?:nearest|closest|furthest|farthest) (?:\w+ )?(?:block|cube|patch|mat|one)\b|"
            r"\b(?:block|cube|patch|mat|one) (?:that|which) is (?:nearest|closest|furthest|farthest)\b",
            re.I,
        ),
        "which block or patch that is depends on how the blocks lie at the start, and may change",
        "name it by its colour, as in 'put the red block on the blue patch'",
    ),
    _Wish(
        re.compile(r"\b(?:most|fewest|least) (?:cubes|blocks|boxes|bricks)\b(?! that can)", re.I),
        "on what the most or the fewest blocks lie depends on how they lie at the start, and may change",
        "name it by its colour, as in 'clear the red patch'",
    ),
    _Wish(
        re.compile(
            r"\b(?:completely|fully|entirely|totally|wholly) (?:covered|cover|hidden|filled|fill)\b|"
            r"\b(?:covered|cover|hidden|filled|fill)\b.* (?:completely|fully|entirely|totally|wholly)\b",
            re.I,
        ),
        "how much of something is covered is not checked, but only which blocks lie on it",
        "say how many lie there, as in 'put four blocks on the white patch'",
    ),
    _Wish(
        re.compile(r"\balready\b|\bkeep stacking until\b", re.I),
        "what is to be done depends on how the blocks lie: a task does not depend on a condition",
        "say how it is at the start and should be at the end, as in 'the red block is on the blue patch; put it on the "
        "green patch'",
    ),
    _Wish(
        re.compile(r"\boverhang|\bhalf (?:of it )?(?:is )?(?:on|off)\b|\bhang(?:s|ing)? over\b", re.I),
        "how far a block reaches over an edge is no goal here: it lies where its middle is",
        "say on what it lies, as in 'put the green block on the red block'",
    ),
    _Wish(
        re.compile(
            r"\b(?:stars?|hearts?|question marks?|smileys?|arrows?|dots?|pictures?) on\b|\bwith (?:an? )?"
            r"(?:stars?|hearts?|question marks?|smileys?|arrows?|dots?)\b",
            re.I,
        ),
        "blocks are plain, or show a letter, a digit or one of + - * / =, and no other sign",
        "say which of these are meant, as in 'put the block with an A on the blue patch'",
    ),
    _Wish(
        re.compile(r"\b(?:person|people|human|child)\b|\b(?:give|hand) .*\bto (?:me|him|her|us)\b", re.I),
        "people are no part of a task",
        "say where on the table, as in 'put the blue block in the left half of the table'",
    ),
    _Wish(
        re.compile(r"\bparallel\b|\bedges of\b", re.I),
        "how the sides of a block are turned is no goal here",
        "leave this out, as in 'put the red block in the middle of the blue patch'",
    ),
    _Wish(
        re.compile(r"\bany (?:\w+ )?word\b", re.I),
        "it is not said which word",
        "say it in capitals, as in 'spell CAT'",
    ),
)
"""Wishes for what is not checked at the end, or is not there."""
_PATCH = r"(?:\w+ ){0,2}(?:patch(?:es)?|mats?|carpets?|rugs?|fields?|pads?|squares?)"
_OF_PLACES = (
    _Wish(
        re.compile(rf"\b(?:corners?|edges?|borders?|sides?) of (?:the|an?|each|every|its) {_PATCH}\b", re.I),
        "a block is on a patch, or in its middle: the corners and edges of a patch are no places of their own",
        "say what the blocks on it form, as in 'put four cubes in a square on the blue patch'",
    ),
    _Wish(
        re.compile(r"\b(?:partly|partially|in part|to some extent)\b", re.I),
        "a block is on a patch if its middle is: that it is only partly on it is not told apart",
        "leave this out, as in 'put every cube on a patch'",
    ),
    _Wish(
        re.compile(
            r"\b(?:dark|light|pale|bright|warm|cool|cold)(?:er)?[ -]?(?:colou?red |toned |hued )?"
            r"(?:blocks?|cubes?|ones?|colou?rs?|tones?|boxes|bricks)\b",
            re.I,
        ),
        "which colours these are is not said",
        "name them, as in 'put the red, orange and yellow blocks in the left half of the table and the blue, green and "
        "purple blocks in the right half of the table'",
    ),
    _Wish(
        re.compile(
            r"\b(?:can ?not|can't|cant|could not|couldn't|no longer|never) (?:be )?seen?\b|\bout of sight\b|"
            r"\bhidden from\b|\bfrom (?:view|sight)\b",
            re.I,
        ),
        "what is seen from somewhere is no goal here, but only where blocks are",
        "say where it is, as in 'put the green block directly behind the big red block'",
    ),
    _Wish(
        re.compile(r"\b(?:my|your|his|her|our|their) (?:side|end|half|edge)\b", re.I),
        "whose side of the table that is is not clear",
        "say 'near' or 'far', as in 'put 1 in the near half of the table and 2 and 3 in the far half of the table'",
    ),
)
"""Wishes for places that there are not."""
_WISHES = (
    _Wish(
        re.compile(r"\bas (?:far|close|near)(?: \w+){0,2} as possible\b", re.I),
        "it is not said how far that is: what is possible depends on the table",
        "say a distance, as in 'put the red block at least 30 cm away from the blue block'",
    ),
    _Wish(
        re.compile(r"^(?!.*\d ?[-+*/=]).*\b(?:sum|equation|calculation) (?:that|which|with|whose)\b", re.I),
        "it is not said which numbers the equation is made of",
        "say all of it, as in 'make 4 + 6 = 10'",
    ),
    *_UNCHECKED,
    *_OF_PLACES,
    _Wish(
        re.compile(rf"\b(?:letter|shape of an?|shape of the letter) [{_UNLAID}]\b(?! (?:block|cube|on\b))"),
        f"blocks are laid out as {_LAID}, and as no other letter",
        "say for example 'make the letter T from five blocks', or 'put the block A on the patch' for a block that "
        "shows a letter",
    ),
)
_NAMED = re.compile(
    r"\b(?:make|build|create|form|construct|draw|assemble)(?: me| us)? (?:an? |the |my |some )?(?:\w+ )?(\w+)", re.I
)
"""What is to be made."""


def explained(text: str, found: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics of a refusal; one that only says that a word does not fit tells what is wrong with the wish."""
    if told := about_symbols(text, found):
        return told
    if not found or any(one.code not in _VAGUE for one in found):
        return tuple(found)
    wish = next((wish for wish in _WISHES if wish.pattern.search(text)), None) or _thing(text, found)
    if wish is None:
        return tuple(found)
    return (found[0].model_copy(update={"message": wish.message, "hint": wish.hint}),)


def _thing(text: str, found: Sequence[Diagnostic]) -> _Wish | None:
    """ "Make a house": of what is to be made nobody knows how its blocks stand."""
    named = _NAMED.search(text)
    span = found[0].span
    unknown = found[0].code == "unknown-word" and span is not None and named is not None
    if not unknown or named is None or span is None or not named.start() < span[0] < named.end():
        return None
    word = text[span[0] : span[1]]
    return _Wish(
        named.re,
        f"it is not known how the blocks of a {word!r} stand",
        f"say it behind a colon, as in 'build a {word}: a red block on a blue block'",
    )
