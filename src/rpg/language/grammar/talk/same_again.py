"""What is said of another thing as of the one before: "Put A on the mat. Do the same with B.", "and B likewise"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences, text_of
from rpg.language.grammar.rows.said_short import THINGS
from rpg.language.grammar.rows.vocabulary import FEW, MUST
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_SAME = (
    "(?:(?:please )?do (?:exactly |just )?the (?:very )?same(?: thing)?|(?:exactly )?the same(?: thing)?|same)"
    f"(?: (?:goes|holds|applies|{MUST} be done))?(?: again)?"
)
_AGAIN = on_demand(
    f"^(?:and |then |now |also )*(?:{_SAME} (?:with|for|to)|likewise(?: for| with)?|"
    f"so {MUST}|so (?:does|do|goes|is|are)) (?:, )?({THINGS})(?: as well| too)?$|"
    f"^(?:and )?({THINGS})(?: ,)? (?:likewise|too|as well|also|the same way)$"
)
_PARTED = on_demand(
    f"(?: ,| ;)?(?: and| then| but)? (?=(?:(?:please )?do (?:exactly |just )?the (?:very )?same|(?:the )?same (?:goes|"
    f"holds|applies|for|with)) )|(?: ,)?(?: and|(?<=,)) (?=(?:{THINGS})(?: ,)? likewise\\b)"
)
_BID = on_demand(f"^((?:then |now |please |first )*(?:line up|lay out|\\w+) )({THINGS})( .+)?$")
_TOLD = on_demand(
    f"^()({THINGS})( (?:{MUST}|may|can|is|are|goes|go|belongs|belong|stands|stand|lies|lie|comes|come) .+)$"
)
"""What is said before: a verb, of what, and where; or of what, and what of it."""
_COLORED = on_demand(f"^(?:the )?({'|'.join(lexicon.COLOR)})(?: (?:ones?|blocks?|cubes?))?$")
_LED = on_demand("^(?:and |then |now |also )*")


def same_again(tokens: list[Token]) -> list[Token]:
    """The tokens with what is left out said again, of the other thing."""
    words = {token.word for token in tokens}
    if words.isdisjoint(("same", "likewise", "too", "well", "so", "also", "way")):
        return tokens
    out: list[list[Token]] = []
    for sentence in (half for whole in sentences(tokens) for half in _halves(whole)):
        said = _said(out[-1], sentence) if out else None
        out.append(sentence if said is None else said)
    return [token for sentence in out for token in sentence]


def _halves(sentence: list[Token]) -> list[list[Token]]:
    """ "put A on the mat and do the same with B": what is said of the other thing is a sentence of its own."""
    text = text_of(sentence)
    for found in _PARTED.finditer(text):
        begin, end = text[: found.start() + 1].count(" "), text[: found.end()].count(" ")
        joint = replace(sentence[begin], kind="punct", word=".", raw=".", value=None)
        before, behind = [*sentence[:begin], joint], sentence[end:]
        if begin and end > begin and _said(before, behind) is not None:
            return [before, behind]
    return [sentence]


def _bare(sentence: list[Token]) -> list[Token]:
    return sentence[:-1] if sentence[-1].word in STOPS else sentence


def _part(tokens: list[Token], text: str, span: tuple[int, int]) -> list[Token]:
    """The tokens that a stretch of their text is made of."""
    if span[0] >= span[1]:
        return []
    stretch = text[slice(*span)]
    begin = text[: span[0]].count(" ") + (stretch[0] == " ")
    return tokens[begin : begin + len(stretch.split())]


def _said(before: list[Token], sentence: list[Token]) -> list[Token] | None:
    """What a sentence says of another thing, in full; None where it is none of these, or not clear."""
    text, plain = text_of(_bare(sentence)), _bare(sentence)
    again = _AGAIN.match(text)
    if again is None:
        return None
    group = 1 if again[1] else 2
    other = _part(plain, text, again.span(group))
    was, told = _bare(before), text_of(_bare(before))
    stop = sentence[len(plain) :]
    later = [token for token in plain[: _LED.match(text).end()] if token.word == "then"][:1]  # type: ignore[union-attr]
    if (shown := _recolored(was, told, again[group], plain)) is not None:
        return [*later, *shown, *stop]
    found = _TOLD.match(told) or _BID.match(told)
    if found is None or (found[1] and not _verb(found[1])):
        return None
    lead, theme, rest = (_part(was, told, found.span(n)) for n in (1, 2, 3))
    if (" and " in again[group]) > (" and " in text_of(theme)) and not _on_patch(rest):
        return None
    return [*later, *lead, *_like(other, theme), *rest, *stop]


def _verb(lead: str) -> bool:
    words = [word for word in lead.split() if word not in ("then", "now", "please", "first")]
    return bool(words) and words[0] in lexicon.COMMANDS


def _on_patch(rest: list[Token]) -> bool:
    """Whether what is said of the first thing can be true of any number of others."""
    return bool(rest) and rest[-1].word in lexicon.PATCH


def _like(other: list[Token], theme: list[Token]) -> list[Token]:
    """ "the green one" as what the other thing is: "the green cube"."""
    noun = theme[-1]
    if other[-1].word == "one" and lexicon.BLOCK.get(noun.word) is False:
        return [*other[:-1], noun]
    return other


_MADE = on_demand(
    f"(?<!left )(?<!right )(?<!front )(?<!back )(?<!top )(?<!side )\\b(?:of|from|out of|with) (?:the |{FEW}|\\d+)"
)


def _recolored(was: list[Token], told: str, other: str, plain: list[Token]) -> list[Token] | None:
    """ "Build a tower of three red cubes. Do the same with blue ones.": another in that colour."""
    found = _COLORED.match(other)
    colors = [n for n, token in enumerate(was) if token.word in lexicon.COLOR]
    if found is None or len(colors) != 1 or _MADE.search(told) is None or _on_patch(was):
        return None
    color = next(token for token in plain if token.word == found[1])
    return [*was[: colors[0]], color, *was[colors[0] + 1 :]]
