"""What is thought of a figure before it is built: "a gorgeous, sturdy tower" is a tower."""

from __future__ import annotations

from rpg.language import harmless, lexicon
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
_ARTICLES = listed("a an the one my our your this that some two three four five")
_BETWEEN = frozenset({*lexicon.COLOR, *lexicon.SIZE, *lexicon.NUMBER, "tall", "long", "short", "straight", ",", "and",
                      "single", "vertical", "horizontal"})  # fmt: skip


def without_praise(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens without such words in front of figures and blocks, and a note of them."""
    left_out: set[int] = set()
    said: list[str] = []
    for n, token in enumerate(tokens):
        if token.word not in _PRAISE or not _told_of_a_thing(tokens, n):
            continue
        begin = n - 1 if tokens[n - 1].word in (",", "and") and n - 2 in left_out else n
        left_out.update(range(begin, n + 1))
        said.append(token.raw)
    if not said:
        return tokens, []
    return [token for n, token in enumerate(tokens) if n not in left_out], [f"left out: {', '.join(said)}"]


def _told_of_a_thing(tokens: list[Token], at: int) -> bool:
    """Whether it stands behind an article or number, or behind more of its kind, and a figure or a block of a colour is
    named behind it."""
    begin = at
    while begin and (tokens[begin - 1].word in _PRAISE or tokens[begin - 1].word in _BETWEEN):
        begin -= 1
    if not ((begin and tokens[begin - 1].word in _ARTICLES) or tokens[begin].word in _ARTICLES):
        return False
    end = at + 1
    while end < len(tokens) and (tokens[end].word in _PRAISE or tokens[end].word in _BETWEEN):
        end += 1
    if end == len(tokens):
        return False
    colored = any(token.word in lexicon.COLOR for token in tokens[at:end])
    return tokens[end].word in lexicon.STRUCTURE or (colored and tokens[end].word in lexicon.BLOCK)
