"""What is thought of a figure or a block: "a gorgeous, sturdy tower" is a tower, "the grumpy red cube" a red cube, and
"sits proudly" is sits.

A character makes no other block of one, unless it is all that tells two apart.
"""

from __future__ import annotations

from rpg.language import harmless, lexicon
from rpg.language.spelling import vocabulary
from rpg.language.stories.character import TELLING_NOTHING, manner
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_PRAISE = (
    harmless.FINE
    - listed(
        "odd true real magic special simple easy different unusual strange tricky secret private best better worst "
        "worse favorite favourite own fair ideal perfect"
    )
) | listed("""
    stable steady sturdy robust firm secure safe decent mighty impressive grand majestic magnificent modest humble proud
    usual typical fresh quick careful sick dope smart stunning basic orderly clean fancy fine crazy colorful colourful
    desired required requested intended wanted actual
""")
_SAID = _PRAISE | TELLING_NOTHING
_ARTICLES = listed("a an the one my our your this that some two three four five")
_ANY = listed("a an some") | (lexicon.NUMBER.keys() - {"zero"})
"""Behind these any block is meant."""
_LOOKS = frozenset({*lexicon.COLOR, *lexicon.SIZE})
_JOINTS = frozenset({",", "and"})
_BETWEEN = _LOOKS | _JOINTS | {*lexicon.NUMBER, "tall", "long", "short", "straight", "single", "vertical", "horizontal"}


def without_praise(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens without such words in front of figures and blocks, and a note of them."""
    found = [n for n, token in enumerate(tokens) if token.word in _SAID and _told_of_a_thing(tokens, n)]
    found = [] if _tells_apart(tokens, found) else found
    left_out = {n for n, token in enumerate(tokens) if manner(token.word) and token.word not in vocabulary()}
    said = [tokens[n].raw for n in sorted({*left_out, *found})]
    for n in found:
        begin = n - 1 if tokens[n - 1].word in _JOINTS and n - 2 in left_out else n
        left_out.update(range(begin, n + 1))
    if not said:
        return tokens, []
    return [token for n, token in enumerate(tokens) if n not in left_out], [f"left out: {', '.join(said)}"]


def _told_of_a_thing(tokens: list[Token], at: int) -> bool:
    """Whether it stands behind an article or number, or behind more of its kind, and a figure or a block of a colour is
    named behind it. A character may be that of what is known by its colour alone, or of any block."""
    begin, end = _around(tokens, at)
    if end == len(tokens) and tokens[end - 1].word not in lexicon.COLOR:
        return False
    noun = tokens[end].word if end < len(tokens) else ""
    ahead = {tokens[begin].word, *(t.word for t in tokens[max(begin - 1, 0) : begin])}
    colored = any(token.word in lexicon.COLOR for token in tokens[at:end])
    figure = noun in lexicon.STRUCTURE
    if tokens[at].word not in TELLING_NOTHING:
        return not ahead.isdisjoint(_ARTICLES) and (figure or (colored and noun in lexicon.BLOCK))
    if ahead.isdisjoint(_ARTICLES) and any(token.word in _JOINTS for token in tokens[at:end]):
        return False
    return colored or figure or (noun in lexicon.BLOCK and not ahead.isdisjoint(_ANY))


def _around(tokens: list[Token], at: int) -> tuple[int, int]:
    """Where the words begin and end that may stand between an article and a noun, and one of which stands here."""
    begin, end = at, at + 1
    while begin and (tokens[begin - 1].word in _SAID or tokens[begin - 1].word in _BETWEEN):
        begin -= 1
    while end < len(tokens) and (tokens[end].word in _SAID or tokens[end].word in _BETWEEN):
        end += 1
    return begin, end


def _tells_apart(tokens: list[Token], found: list[int]) -> bool:
    """Whether blocks that look alike are told apart by nothing else: "the brave red cube and the shy red cube"."""
    told: dict[int, set[str]] = {}
    for n in (n for n in found if tokens[n].word in TELLING_NOTHING):
        end = next((k for k in range(n, len(tokens)) if tokens[k].word not in _SAID | _LOOKS | {","}), len(tokens))
        told.setdefault(end, set()).add(tokens[n].word)
    apart: dict[frozenset[str], set[str]] = {}
    for end, words in told.items():
        begin, _ = _around(tokens, end - 1)
        if not {t.word for t in tokens[max(begin - 1, 0) : begin + 1]}.isdisjoint(_ANY):
            continue
        looks = frozenset(token.word for token in tokens[begin:end] if token.word in _LOOKS)
        figure = end < len(tokens) and tokens[end].word in lexicon.STRUCTURE
        if not figure and apart.setdefault(looks, words) != words:
            return True
    return False
