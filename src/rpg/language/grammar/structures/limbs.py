"""Bars, stems and arms of letters: "a T whose bar is five wide", "an L with arms equally long"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.meaning import Amount, Manner, Size

_OF_T = {
    **dict.fromkeys(("bar", "top bar", "crossbar", "cross bar", "horizontal bar", "crosspiece"), "bar"),
    **dict.fromkeys(("stem", "leg", "vertical bar", "trunk", "foot"), "stem"),
}
_OF_L = {
    **dict.fromkeys(("long arm", "long side", "longer arm", "longer side", "long leg", "stem"), "long arm"),
    **dict.fromkeys(("short arm", "short side", "shorter arm", "shorter side", "short leg", "foot"), "short arm"),
}
_ACROSS = {
    **dict.fromkeys(("across", "across the bar", "across the top", "across the top bar"), "bar"),
    **dict.fromkeys(("down", "down the middle", "for the stem", "for the leg", "below", "downwards"), "stem"),
}
"""How many blocks of a T lie which way."""
LIMBED: dict[str, dict[str, str]] = {"T": _OF_T, "L": _OF_L, "plus": {}}
"""The parts of letters that have lengths of their own; those of a plus are alike."""
_ARMED = ("L", "plus")
LIMBS = frozenset({"across", "bar", "crossbar", "stem", "leg", "trunk", "foot", "arm", "arms", "legs"})
_EQUAL = (
    *(f"{both}{arms} {same}" for both in ("", "both ", "with ", "with both ", "with its ", "whose ", "the ")
      for arms in ("arms", "sides", "legs", "arms are", "sides are")
      for same in ("equally long", "of equal length", "of the same length", "the same length", "equal in length")),
    *(f"with {equal} {arms}" for equal in ("equal", "equally long") for arms in ("arms", "sides", "legs")),
)  # fmt: skip
_LEADS = ("with a", "with the", "with its", "with", "whose", "the", "its", "a", "and a", "and the", "and")
_LONG = ("blocks long", "blocks wide", "blocks high", "cubes long", "cubes wide", "long", "wide", "high", "blocks",
         "cubes", "block", "bricks")  # fmt: skip
_BOTH = ("both arms", "both sides", "both legs", "with both arms", "two arms")
_BOTH_ARE = (*_BOTH, "arms", "each arm", "with each arm", "each leg", "each of its arms")
_PER_ARM = tuple(f"{along} {arm}" for along, arm in (
    *((along, arm) for along in ("along", "in", "for", "on") for arm in ("each arm", "each leg", "both arms",
                                                                             "both legs", "each of its arms")),
    ("per", "arm"), ("per", "leg"), ("each", "way"), ("both", "ways"), ("in each", "direction"),
    ("in both", "directions"), ("along each", "side"), ("on each", "side"), ("each", "direction")))  # fmt: skip
_ARMS = frozenset({"arm", "arms", "leg", "legs", "way", "ways", "direction", "directions", "side"})
_SHARED = (
    "sharing the corner", "including the corner", "counting the corner", "including the corner block",
    "counting the corner twice", "with the corner shared", "sharing the corner block", "with a shared corner",
)  # fmt: skip


@rule
def limb(p: Parser, i: int, kind: str) -> Results[Size]:
    """ ", the bar five wide", "with a stem of two blocks", "three blocks for the bar"; "with arms of equal length"."""
    start = p.any_of(i, (", and", ",", ":", "and")) or i
    if kind == "L" and (j := p.any_of(start, _EQUAL)):
        yield Size(what="equal arms", span=p.span(i, j)), j
    if kind == "L" and (j := p.any_of(start, _SHARED)):
        yield Size(what="shared", span=p.span(i, j)), j
    both = p.any_of(start, _BOTH_ARE) if kind in _ARMED else 0
    for found, j in amounts.amount(p, p.any_of(both, ("of", "are", "each")) or both) if both else ():
        end = p.any_of(p.any_of(j, _LONG) or j, ("each",)) or p.any_of(j, _LONG) or j
        yield Size(what="each arm", amount=found, span=p.span(i, end)), end
    for found, j in amounts.amount(p, p.opt(start, "with")) if kind in _ARMED and p.rarely(_ARMS) else ():
        if end := p.any_of(p.any_of(j, _LONG) or j, _PER_ARM):
            yield Size(what="each arm", amount=found, span=p.span(i, end)), end
    named = LIMBED[kind]
    lead = p.any_of(start, _LEADS) or start
    for phrase, j in p.standing(lead, named) if lead > i and named else ():
        k = p.any_of(j, ("is", "of", "being", ":", "has", "made of", "should be", "consisting of")) or j
        for found, end in amounts.amount(p, k):
            yield Size(what=named[phrase], amount=found, span=p.span(i, end)), p.any_of(end, _LONG) or end
    for found, j in amounts.amount(p, p.any_of(start, ("with",)) or start) if start > i or p.one(i, "with") else ():
        k = p.any_of(p.any_of(j, _LONG) or j, ("for the", "in the", "as the", "form the", "in its", "for its", "in"))
        for phrase, end in p.standing(k, named) if k else ():
            end = p.any_of(end, ("on top", "at the top", "at the far side")) or end
            yield Size(what=named[phrase], amount=found, span=p.span(i, end)), end
        more = p.opt(p.any_of(j, _LONG) or j, "more", "further")
        beyond = p.words[more - 1] in ("more", "further")  # "two more for the stem": besides the one in the bar
        many = Amount(found.low + 1, found.low + 1, True) if beyond else found
        for phrase, end in p.standing(more, _ACROSS) if kind == "T" else ():
            yield Size(what=_ACROSS[phrase], amount=many, span=p.span(i, end)), end


_SET_OFF = (",", ":", "with", ", with", "from", "of", "made of", "using", ": with", "that is", "which is")
_UP = Patterns(
    "blocks|cubes|bricks|block|cube|of_them? going|straight? up|upward|upwards|away|away_from_me|upright|high|tall",
    "blocks|cubes|bricks|of_them? for|as|in the|its|a? stem|long_arm|long_side|upright",
)
_MORE = ("more", "further", "extra", "additional", "another")
_ALONG = Patterns(
    "block|blocks|cube|cubes|one|of_them? for|as|in|forming|making the|its|a? foot|base|short_arm",
    "block|blocks|cube|cubes|one|of_them? for|as|in|forming|making? the|its|a? foot|base|short_arm? "
    "pointing|going|turning|sticking|sticking_out|out|at_the_bottom|at_the_foot? to|on|towards|at the|its "
    "left|right side?",
)


@rule
def arms_told(p: Parser, i: int) -> Results[tuple[tuple[Size, ...], tuple[Manner, ...]]]:
    """ "(an L:) three blocks up and one more to the right": one block that is no more than the corner is no arm."""
    start = p.any_of(i, _SET_OFF)
    for high, j in amounts.amount(p, start) if start else ():
        for k in _UP.matches(p, j) if high.low == high.high else ():
            joint = p.any_of(k, (", and", ", then", "and then", "and", ",", "plus", ", plus"))
            another = p.any_of(joint, ("another", "a further", "an extra")) if joint else 0
            for wide, m in [*amounts.amount(p, another or joint), *([(Amount(1, 1), another)] if another else [])]:
                further = p.opt(m, *_MORE)
                more = another > 0 or further > m or wide == Amount(1, 1)
                for end in _ALONG.matches(p, further) if wide.low == wide.high else ():
                    span = p.span(i, end)
                    foot = Amount(wide.low + more, wide.low + more)
                    sizes = [
                        Size(what="long arm", amount=high, span=span),
                        Size(what="short arm", amount=foot, span=span),
                    ]
                    sizes += [Size(what="shared", span=span)] if more else []
                    side = next((w for w in p.words[further:end] if w in ("left", "right")), None)
                    way = (Manner(kind="pointing:foot", value=side, span=span),) if side else ()
                    yield (tuple(sizes), way), end
