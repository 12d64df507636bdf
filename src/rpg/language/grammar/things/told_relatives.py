"""Relative clauses with a verb of their own: "which must be on ...", "on which the white one stands"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.later import later
from rpg.language.meaning import In, Loc, Manner, Meaning, Noun, Structure, replace
from rpg.language.phrases import Classes

if TYPE_CHECKING:
    from rpg.language.grammar.places.prepositions import relation
    from rpg.language.grammar.places.relations import loc
    from rpg.language.grammar.things.nouns import simple
else:
    (relation,) = later(__name__, "rpg.language.grammar.places.prepositions", "relation")
    (loc,) = later(__name__, "rpg.language.grammar.places.relations", "loc")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_WORDS = Classes({
    "must": (
        "should|must|shall|will|ought_to|has_to|have_to|needs_to|need_to|is_to|are_to|is_supposed_to|is_going_to",
        "is|are itself|themselves|in_turn|also to",
    ),
    "there": (
        "be|stand|lie|rest|sit|end_up|come_to_rest|come_to_lie|come_to_stand|be_found|be_standing|be_lying|be_resting|"
        "be_sitting|be_placed|be_put|be_positioned|be_located|be_set|be_laid|be_stacked|finish|go|be_moved|end|"
        "finally_be|finally_stand|finally_lie|remain_standing",
    ),
    "is": (
        "is|are|stands|stand|lies|lie|sits|sit|rests|rest|goes|belongs|ends_up",
        "is|gets standing|lying|sitting|resting|placed|put|stacked|positioned|located|set|laid|moved",
    ),
    "starts": (
        "starts|start|begins|begin|started|began|was|were|has_started|has_begun|used_to_be|initially",
        "shall|must|should|will|is_to|are_to initially|originally be|lie|stand|rest|sit",
    ),
    "out": ("out|off|standing|lying|sitting|resting|placed|located|stands|is|lies|sits|rests",),
    "touched": ("moved|touched|displaced|disturbed|shifted|lifted|picked_up|displaced_at_all|moved_at_all",),
    "still": (
        "where_it_is|in_place|in_its_place|untouched|unmoved|put|still|where_it_stands|at_its_place|as_it_is|where_it_was|"
        "exactly_where_it_is|exactly_where_it_was|at_the_same_place|in_the_same_place|in_the_same_spot",
    ),
    "meanwhile": ("in_the_process|while_doing_so|while_you_do_so|at_all|at_any_time|meanwhile|during_this|on_the_way",),
    "stay": ("stay|remain|be_left|be_kept|keep_standing",),
})  # fmt: skip
_WANTED = Patterns(
    "itself? <must> itself? also? <there>", "gets placed|put|positioned|set|laid|moved|located|stacked", classes=_WORDS
)
_STARTED = Patterns("<starts> <out>?", classes=_WORDS)
_LEFT_ALONE = Patterns(
    "<must> not|never be <touched> <meanwhile>?",
    "is|are not to_be <touched> <meanwhile>?",
    "is|are not <touched> <meanwhile>?",
    "has|have not|never been? <touched> <meanwhile>?",
    "<must> not have been? <touched> <meanwhile>?",
    "has|have|<must> have? stayed|remained|been_left|been_kept <still> <meanwhile>?",
    "<must> not|never move <meanwhile>?",
    "does|did|do|has|have not move|budge|moved|budged <meanwhile>?",
    "has|have|was|were not been? <touched> <meanwhile>?",
    "does|do|did not get <touched> <meanwhile>?",
    "<must> <stay> <still> <meanwhile>?",
    "stays|remains|is_left|is_kept <still> <meanwhile>?",
    "you|we|i|the_robot|the_arm should|must|may|can|are_to|is_to not|never move|touch|disturb|displace <meanwhile>?",
    "nobody|nothing may|must|should touch|move <meanwhile>?",
    classes=_WORDS,
)
STANDS_THERE = Patterns("<is>", "<must> <there>", classes=_WORDS)
_SUBJECT_LAST = Patterns("<is>", "<must> <there>", "there <must> be", "there <is>", classes=_WORDS)
_BORNE = Patterns(
    "is|are carried|supported|borne|held|held_up", "<must> be carried|supported|borne|held|held_up", classes=_WORDS
)
_BACK = {"on": "under", "left": "right", "right": "left", "front": "behind", "behind": "front", "beside": "beside",
         "adjacent": "adjacent", "near": "near", "touching": "touching"}  # fmt: skip
"""How what a relative clause speaks of lies to the block that stands there."""


def told_relative(p: Parser, i: int, that: int, head: str, many: bool) -> Results[tuple[Meaning, ...]]:
    """What a relative clause from i on, whose "which" ends at `that`, says of its noun, with the position behind it."""
    asserted = p.words[i] == ","
    if that:
        for j in _WANTED.matches(p, that):
            for place, k in loc(p, j):
                if isinstance(place, Loc):
                    yield (_asserted(place),), k
        for j in _STARTED.matches(p, that):
            yield from (((place,), k) for place, k in loc(p, j) if isinstance(place, Loc | In) and not place.negated)
        for j in _LEFT_ALONE.matches(p, that):
            yield (Manner(kind="stay", span=p.span(that, j)),), j
    elif not many and head != "patch":
        yield from _carried(p, p.opt(i, ","), asserted)


def _carried(p: Parser, i: int, asserted: bool) -> Results[tuple[Meaning, ...]]:
    """ "on which the green block stands", "to the left of which there shall be a red block"."""
    if by := p.seq(i, "by which"):
        for block, j in simple(p, by):
            for k in _BORNE.matches(p, j) if isinstance(block, Noun) and block.head != "patch" else ():
                wanted = asserted or not _WANTED_WORDS.isdisjoint(p.words[by:k])
                place = Loc(rel="under", landmark=block, mods=("directly",), span=p.span(i, k))
                yield (_asserted(place) if wanted else place,), k
    for (name, mods), j in relation(p, i):
        if name not in _BACK or not (which := p.one(j, ("which", "whom"))):
            continue
        found = [(block, k) for end in _SUBJECT_LAST.matches(p, which) for block, k in simple(p, end)]
        for block, j in simple(p, which):
            found += [(block, k) for k in STANDS_THERE.matches(p, j)]
        for block, k in found:
            if isinstance(block, Noun | Structure) and getattr(block, "head", "") != "patch":
                wanted = asserted or not _WANTED_WORDS.isdisjoint(p.words[which:k]) or _in_picture(p, i, block)
                close = ("directly",) if name == "on" else mods
                place = Loc(rel=_BACK[name], landmark=block, mods=close, span=p.span(i, k))
                yield (_asserted(place) if wanted else place,), k


def _in_picture(p: Parser, i: int, block: Meaning) -> bool:
    """ "A red block should stand behind the green one on which a yellow one sits": of what is wanted, a new block."""
    wished = not _WANTED_WORDS.isdisjoint(p.words[:i]) and lexicon.VERB.keys().isdisjoint(p.words[:1])
    return wished and isinstance(block, Noun) and block.det == "a"


_WANTED_WORDS = frozenset({"should", "must", "shall", "will", "ought"})


def _asserted(place: Loc) -> Loc:
    return replace(place, mods=(*place.mods, "asserted"))
