"""Blocks that are counted and then told one by one: "two white cubes, one on the purple patch and one on the other"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Clause, Coord, Loc, Manner, Meaning, Noun, Traits, replace

_LEADS = ("there are", "put", "place", "set", "i see", "i want", "we see", "you see", "i want to see", "i would like")
_JOINTS = (", of which", "of which", ", so that", "so that", ", with", ",", ":", "-", ";")
_FIRST = frozenset({"one", "two", "three", "1", "2", "3"})
_FURTHER = tuple(
    f"{link} {what}" for link in ("and", ",") for what in (*sorted(_FIRST), "the other", "another", "the rest")
)


def counted_ahead(p: Parser, i: int) -> Results[Clause]:
    """The blocks in front of what is told of one, and of another one, of them."""
    if i or not p.anywhere(_FIRST):
        return
    for whole, j in simple(p, p.any_of(i, _LEADS) or i):
        joint = p.any_of(j, _JOINTS)
        if not joint or joint >= p.end or p.words[joint] not in _FIRST or not _counted(whole):
            continue
        if any(p.any_of(k, _FURTHER) for k in range(joint + 2, p.end)):
            yield Clause(verb="exist", lemma="tally", theme=whole, mode="given", span=p.span(i, j)), joint


def _counted(whole: object) -> bool:
    """Several blocks of one look, named for the first time."""
    if not isinstance(whole, Noun) or whole.head != "block" or whole.det != "bare" or whole.amount is None:
        return False
    return (
        whole.amount.low == whole.amount.high
        and whole.amount.low > 1
        and whole.traits == Traits(colors=whole.traits.colors[:1])
    )


def one_for_each(p: Parser, found: Meaning) -> Meaning:
    """ "Yellow and green are each on a white block": as many white blocks, one under each."""
    theme, place = (found.theme, found.adjuncts[:1]) if isinstance(found, Clause) else (None, ())
    if not isinstance(found, Clause) or found.negated or not place or not (many := _one_by_one(theme)):
        return found
    mark = place[0].landmark if isinstance(place[0], Loc) and place[0].rel == "on" else None
    if not isinstance(mark, Noun) or (mark.head, mark.det, mark.amount) != ("block", "a", Amount(1, 1)):
        return found
    if theme is None or not _each_told(p, theme, mark):
        return found
    own = replace(mark, det="bare", amount=Amount(many, many), plural=True)
    dealt = Manner(kind="respectively", value="alike", span=mark.span)
    return replace(found, adjuncts=(replace(place[0], landmark=own), *found.adjuncts[1:], dealt))


def _one_by_one(theme: Meaning | None) -> int:
    """How many blocks are named one by one, or are counted."""
    if isinstance(theme, Coord) and theme.op == "and":
        return len(theme.items) if all(isinstance(x, Noun) and _single(x) for x in theme.items) else 0
    if not isinstance(theme, Noun) or not theme.plural or theme.head == "patch" or theme.traits.either or theme.part_of:
        return 0
    looks = max(len(theme.traits.colors), len(theme.traits.labels))
    if theme.amount is None:
        return looks if looks > 1 else 0
    return theme.amount.low if looks < 2 and theme.amount.low == theme.amount.high else 0


def _single(noun: Noun) -> bool:
    look = len(noun.traits.colors) + len(noun.traits.labels) == 1
    return look and not noun.plural and noun.amount in (None, Amount(1, 1)) and noun.head != "patch"


def _each_told(p: Parser, theme: Meaning, mark: Meaning) -> bool:
    """Whether "each" stands between them."""
    between = range(theme.span[1], mark.span[0])
    return any(token.word == "each" and token.span[0] in between for token in p.tokens)
