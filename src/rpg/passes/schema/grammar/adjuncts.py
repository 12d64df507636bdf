"""Whatever may follow a verb and its theme: places, orders, structures to form, what to use, conditions."""

from __future__ import annotations

from dataclasses import replace

from rpg.passes.schema.grammar.amounts import length
from rpg.passes.schema.grammar.core import Parser, Results, rule
from rpg.passes.schema.grammar.labels import label_list, literal
from rpg.passes.schema.grammar.lists import listed
from rpg.passes.schema.grammar.nouns import noun_phrase, simple
from rpg.passes.schema.grammar.orders import SIDES, at, order
from rpg.passes.schema.grammar.relations import loc
from rpg.passes.schema.grammar.structures import size_phrase
from rpg.passes.schema.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Spacing,
    Structure,
    TableTop,
    That,
    Toward,
    Using,
    parts_of,
)

_INTO = ("into", "in", "as", "to form", "to make", "to create", "to build", "forming", "making", "creating", "like",
    "to be", "so as to form",
         "so they form", "so that they form", "such that they form", "so that it forms",
         "in such a way that they form", "to become", "in the form of",
         "in the shape of", "so it forms", "so as to make", "so that they make", "to construct", "and form",
         "to spell", "to get", "so you get",
         "so that you get", "arranged in", "lined up in", "placed in", "standing in", "arranged as", "arranged into",
         "that form", "which form", "that forms", "that make", "that make up", "set up as", "laid out in",
         "laid out as",
         "laid out like", "all in", "stacked in", "organized in", "down", "up in", "so as to create",
         "so that they create", "so it makes", "each in", "standing as", "stacked as", "stacked into", "set in",
         "shaped like", "in the pattern of", "arranged like", "along")  # fmt: skip
_USING = ("using", "with", "from", "out of", "by using", "made of", "made from", "made out of", "consisting of",
    "composed of", "built from",
          "made up of", "use", "made with")  # fmt: skip


@rule
def adjunct(p: Parser, i: int) -> Results[Meaning]:
    """One adjunct."""
    if i >= p.end:
        return
    yield from loc(p, i)
    yield from order(p, i)
    yield from at(p, i)
    yield from _into(p, i)
    yield from _using(p, i)
    yield from _absolute(p, i)
    yield from _that(p, i)
    yield from manner(p, i)
    yield from size_phrase(p, i)


@rule
def adjuncts(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """Any number of adjuncts, the longest run first; commas and "and" may stand between them."""
    for first, j in adjunct(p, i):
        for rest, k in adjuncts(p, j):
            yield (
                (
                    (replace(first, cost=first.cost + 1), *rest)
                    if rest and (isinstance(first, That) or _side_after(first, rest[0]))
                    else (first, *rest)
                ),
                k,
            )
        for joined in {p.opt(j, ","), p.opt(p.opt(j, ","), "and"), p.opt(j, "and", "but")} - {j}:
            for rest, k in adjuncts(p, joined):
                if rest:
                    yield (first, *rest), k
    yield (), i


def _side_after(first: Meaning, second: Meaning) -> bool:
    """A side right after "with ... beside it" belongs to that, not to the clause."""
    return isinstance(first, Absolute) and isinstance(second, At) and isinstance(first.adjuncts[0], Loc)


def _into(p: Parser, i: int) -> Results[Meaning]:
    if j := p.any_of(
        i,
        (
            "in another",
            "in the other",
            "in a second",
            "into another",
            "into the other",
            "in another one",
            "in the other one",
        ),
    ):
        yield Into(structure=Structure(kind="again", span=p.span(i, j)), span=p.span(i, j)), j
    if j := p.any_of(i, ("so that the equation is right", "so that the equation is correct",
        "so that the equation is true", "so the equation is correct", "so that the equation holds",
                         "so the equation is true", "so that the math is right",
                         "so that the math is correct")):  # fmt: skip
        yield Into(structure=Structure(kind="equation", span=p.span(i, j)), span=p.span(i, j)), j
    for lead in _INTO:
        if j := p.seq(i, lead):
            for target, k in simple(p, j):
                if isinstance(target, Structure):
                    yield Into(structure=target, span=p.span(i, k)), k
            for target, k in noun_phrase(p, j):
                if not isinstance(target, Structure) and isinstance(getattr(target, "items", (None,))[0], Structure):
                    yield Into(structure=target, span=p.span(i, k)), k


def _using(p: Parser, i: int) -> Results[Meaning]:
    for lead in _USING:
        if j := p.seq(i, lead):
            for members, k in noun_phrase(p, j):
                if not any(isinstance(part, Structure) for part in parts_of(members)):
                    yield Using(members=members, span=p.span(i, k), cost=1), k


def _absolute(p: Parser, i: int) -> Results[Meaning]:
    """ "with the red block on top and the blue one below it"; "the green one on top" after a comma."""
    comma = p.opt(i, ",", ":")
    j = p.any_of(
        comma,
        (
            "with",
            "having",
            "where",
            "keeping",
            "and with",
            "but with",
            "whose",
            "crowned by",
            "crowned with",
            "topped by",
            "topped with",
        ),
    ) or (comma if comma > i else 0)
    if not j:
        return
    if p.words[j - 1] in ("by", "with") and p.words[j - 2] in ("crowned", "topped"):
        for theme, k in simple(p, j):
            yield Absolute(theme=theme, adjuncts=(At(side="top", span=p.span(i, j)),), span=p.span(i, k)), k
        return
    for first, end in _one_absolute(p, j):
        first_place = first.adjuncts[0]
        table = isinstance(first_place, Loc) and isinstance(first_place.landmark, TableTop)
        cost = 2 if table or (j == comma and isinstance(first_place, Loc)) else 1 if isinstance(first_place, At) else 0
        first = replace(first, cost=cost)
        yield first, end
        yield from _absolute_more(p, i, end, (first,))


@rule
def sided(p: Parser, i: int) -> Results[Meaning]:
    """Absolutes about the sides of a structure alone."""
    for found, j in _absolute(p, i):
        parts = found.items if isinstance(found, Coord) else (found,)
        if all(isinstance(x, Absolute) and isinstance(x.adjuncts[0], At) for x in parts):
            if isinstance(found, Coord):
                found = replace(found, items=(replace(parts[0], cost=0), *parts[1:]))
            yield replace(found, cost=0), j


def _one_absolute(p: Parser, j: int) -> Results[Absolute]:
    """ "a red block at the bottom" or "bottom red"."""
    for theme, k in noun_phrase(p, j):
        k = p.opt(k, "is", "are", "being", "goes", "should", "lying", "standing", "left")
        k = p.opt(k, "be")
        k = p.opt(k, "placed", "sitting", "standing", "resting", "positioned", "located", "put", "lying")
        for found, end in _places(p, k):
            yield Absolute(theme=theme, adjuncts=found, span=p.span(j, end)), end
    the = p.opt(j, "the", "whose")
    the = p.opt(the, "the")
    side = {**SIDES, "lower": "bottom", "upper": "top", "middle": "middle"}.get(p.words[the]) if the < p.end else None
    if side:
        k = p.opt(p.reach(the + 1), "one", "block", "cube", "layer")
        k = p.opt(k, "is", "being", ":", "should")
        k = p.opt(k, "be")
        for theme, end in simple(p, k):
            if isinstance(theme, Noun):
                yield (
                    Absolute(theme=theme, adjuncts=(At(side=side, span=p.span(j, k)),), span=p.span(j, end), cost=1),
                    end,
                )


def _absolute_more(p: Parser, i: int, at_: int, had: tuple[Meaning, ...]) -> Results[Meaning]:
    """ "... and blue on top", "... then green": further ones, in one record."""
    j = p.opt(at_, ",")
    then = p.any_of(j, ("and then", "then", "followed by"))
    j = then or p.any_of(j, ("and",)) or j
    if j == at_ or len(had) > 12:
        return
    more = list(_one_absolute(p, j))
    if then:
        more += [
            (Absolute(theme=t, adjuncts=(At(side="next", span=t.span),), span=t.span), k)
            for t, k in simple(p, j)
            if isinstance(t, Noun)
        ]
    for one, end in more:
        if then and len(getattr(one.theme, "items", ())) > 1:
            one = replace(one, cost=one.cost + 1)
        whole = (*had, one)
        yield Coord(op="absolutes", items=whole, span=p.span(i, end)), end
        yield from _absolute_more(p, i, end, whole)


def _places(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    for found, k in loc(p, i):
        yield (found,), k
        if isinstance(found, Loc) and not isinstance(found.landmark, TableTop):
            yield from (
                ((found, side), end)
                for side, end in at(p, k)
                if isinstance(side, At) and side.side in ("left", "right", "front", "back")
            )
    for found, k in at(p, i):
        yield (found,), k
    for phrase, side in (
        ("below", "bottom"),
        ("underneath", "bottom"),
        ("beneath", "bottom"),
        ("above", "top"),
        ("under", "bottom"),
    ):
        if k := p.one(i, phrase):
            yield (At(side=side, span=p.span(i, k)),), k
    if p.words[i : i + 1] in (["first"], ["last"]):
        yield (At(side="first", index=1 if p.words[i] == "first" else -1, span=p.span(i, i + 1)),), p.reach(i + 1)
    if k := p.any_of(
        i,
        (
            "lying around",
            "as distractors",
            "as a distractor",
            "lying on the table",
            "on the side as distractors",
            "for distraction",
            "as distraction",
        ),
    ):
        yield (Manner(kind="extra", span=p.span(i, k)),), k


def _that(p: Parser, i: int) -> Results[Meaning]:
    from rpg.passes.schema.grammar.clauses import chain, gerund_clause

    j = p.any_of(i, (", so that", "so that", "such that", "in such a way that", "so as", ", such that",
        "making sure that", "making sure", "ensuring that", "ensuring",
                     "where", ", where", "in a way that", "and make sure that", "and ensure that",
                     "in which", "on which", "so", ", making sure", ", ensuring that", ", ensuring",
                     "while making sure", "while ensuring"))  # fmt: skip
    if j:
        for clauses, k in chain(p, j):
            yield That(kind="so", clauses=clauses, span=p.span(i, k)), k
    comma = p.opt(i, ",")
    if j := p.any_of(comma, ("that read", "that reads", "that spell", "that spells", "to spell", "to read",
        "which spell", "which spells", "that say", "that says", "to say", "spelling", "so it reads",
                             "so they read", "so they spell", "so they say", "so that it reads", "so that it spells",
                             "to write", "reading", "saying", "which read", "which reads")):  # fmt: skip
        text = literal(p, j)
        if text is not None and len(text) > 1:
            word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
            them = Pronoun(word="them", span=p.span(i, j))
            for found, k in adjuncts(p, j + 1):
                said = Clause(
                    verb="spell", theme=word, adjuncts=(Using(members=them, span=them.span), *found), span=p.span(i, k)
                )
                yield That(kind="so", clauses=Chain(clauses=(said,), links=("and",), span=said.span), span=said.span), k
    if j := p.any_of(comma, ("without", "while not", "while never", "but without", "and without", "but not")):
        for clauses, k in gerund_clause(p, j):
            yield That(kind="without", clauses=clauses, span=p.span(i, k)), k
    if j := p.any_of(comma, ("while keeping", "while leaving", "keeping", "leaving", "but keep", "but leave")):
        for clauses, k in gerund_clause(p, j - 1):
            yield That(kind="while", clauses=clauses, span=p.span(i, k)), k


_FACE_WORDS = {"up": "up", "upward": "up", "upwards": "up", "down": "down", "downward": "down", "downwards": "down",
    "left": "left",
               "right": "right", "front": "front", "forward": "back", "back": "back", "backward": "front",
               "camera": "viewer", "viewer": "viewer", "me": "viewer",
               "robot": "front", "us": "viewer"}  # fmt: skip


@rule
def direction(p: Parser, i: int) -> Results[str]:
    """ "up", "to the left", "towards the camera"."""
    j = p.any_of(i, ("to the", "toward the", "towards the", "to", "towards", "toward", "the")) or i
    if j < p.end and p.words[j] in _FACE_WORDS:
        yield _FACE_WORDS[p.words[j]], p.reach(j + 1)


@rule
def manner(p: Parser, i: int) -> Results[Meaning]:
    """How something is turned, spelt, spaced or counted."""
    if j := p.any_of(
        i,
        (
            "upside down",
            "flipped upside down",
            "inverted",
            "in an inverted orientation",
            "turned upside down",
            "rotated upside down",
        ),
    ):
        yield Manner(kind="turn", value=180.0, span=p.span(i, j)), j
    if j := p.any_of(
        i, ("upright", "right side up", "right way up", "the right way up", "the right way round", "right side upward")
    ):
        yield Manner(kind="turn", value=0.0, span=p.span(i, j)), j
    if j := p.any_of(i, ("sideways", "on its side")):
        yield Manner(kind="turn", value=90.0, span=p.span(i, j)), j
    comma = p.opt(i, ",")
    k = p.any_of(
        comma,
        (
            "facing",
            "faces",
            "face",
            "to face",
            "pointing",
            "points",
            "pointed",
            "showing",
            "turned",
            "so that it faces",
            "visible from",
        ),
    )
    if k:
        for side, end in direction(p, k):
            yield Manner(kind="facing", value=side, span=p.span(i, end)), end
    if (j := p.any_of(comma, ("with its", "with the", "its", "with", "the"))) or True:
        start = j or comma
        end = p.any_of(
            start,
            (
                "corner",
                "foot",
                "opening",
                "open side",
                "open end",
                "tip",
                "apex",
                "point",
                "top",
                "stem",
                "base",
                "tail",
                "ends",
            ),
        )
        if end and j:
            k = (
                p.any_of(
                    end,
                    (
                        "pointing",
                        "facing",
                        "points",
                        "faces",
                        "to",
                        "towards",
                        "toward",
                        "on",
                        "at",
                        "directed",
                        "going",
                        "is",
                        "extending",
                    ),
                )
                or end
            )
            for side, e in direction(p, k):
                yield Manner(kind="pointing:" + p.words[end - 1], value=side, span=p.span(i, e)), e
    if j := p.any_of(i, ("rising to the", "going up to the", "ascending to the", "climbing to the",
        "rising towards the", "going up towards the", "that goes up to the",
                         "rising toward the", "leading up to the", "climbing towards the", "going upward to the",
                         "going upwards to the", "that rises to the", "up to the", "ascending towards the",
                         "going up from left to", "rising from left to", "ascending from left to",
                         "climbing from left to")):  # fmt: skip
        if p.words[j : j + 1] and p.words[j] in ("left", "right", "front", "back"):
            yield Manner(kind="rising", value=p.words[j], span=p.span(i, j + 1)), p.reach(j + 1)
    if j := p.any_of(
        i,
        (
            "going up from right to left",
            "rising from right to left",
            "ascending from right to left",
            "climbing from right to left",
        ),
    ):
        yield Manner(kind="rising", value="left", span=p.span(i, j)), j
    for n, j in _degrees(p, i):
        turned = p.any_of(j, ("clockwise",))
        counter = p.any_of(
            j, ("counterclockwise", "counter clockwise", "anticlockwise", "anti clockwise", "to the left")
        )
        end = turned or counter or j
        sign = -1.0 if turned else 1.0
        kind = "by" if turned or counter else "by?"
        yield Manner(kind=kind, value=sign * n, span=p.span(i, end)), end
    for phrase, kind, value in _LITTLE:
        if j := p.seq(i, phrase):
            yield Manner(kind=kind, value=value, span=p.span(i, j)), j


_LITTLE = (
    ("before that", "time", 0.0), ("beforehand", "time", 0.0), ("before this", "time", 0.0),
    ("right where it is", "stay", None), ("exactly where it is", "stay", None), ("where it stands", "stay", None),
    ("please", "idle", None), (", please ,", "idle", None), ("if possible", "idle", None),
    ("from where i stand", "idle", None), ("as i see it", "idle", None), ("from my side", "idle", None),
    ("with exactly one outlier in each pile", "outliers", 1.0),
    ("with exactly one outlier in each group", "outliers", 1.0),
    ("so that each group has exactly one stranger", "outliers", 1.0),
    ("so that each pile has exactly one outlier", "outliers", 1.0),
    ("so that each group has exactly one outlier", "outliers", 1.0),
    ("with one outlier in each pile", "outliers", 1.0), ("with one outlier in each group", "outliers", 1.0),
    ("with one outlier each", "outliers", 1.0), ("with exactly one outlier each", "outliers", 1.0),
    ("so that each pile has one outlier", "outliers", 1.0), ("with exactly one stranger in each group", "outliers",
    1.0),
    ("with exactly one stranger in each pile", "outliers", 1.0), ("so each has one outlier", "outliers", 1.0),
    (", with exactly one outlier in each pile", "outliers", 1.0),
    (", with exactly one outlier in each group", "outliers", 1.0),
    ("with exactly two outliers in each group", "outliers", 2.0), ("with two outliers in each group", "outliers", 2.0),
    ("but not both", "xor", None), (", but not both", "xor", None), (", not both", "xor", None),
    ("but not on both", "xor", None),
    ("first", "time", 1.0), ("second", "time", 2.0), ("third", "time", 3.0), ("last", "time", 99.0),
    ("finally", "time", 99.0), ("afterwards", "time", 50.0), ("initially", "start", None),
    ("at the start", "start", None), ("at the beginning", "start", None), ("at first", "start", None),
    ("in the beginning", "start", None), ("to begin with", "start", None), ("originally", "start", None),
    ("currently", "start", None), ("at the start of the episode", "start", None), ("as distractors", "extra", None),
    ("as a distractor", "extra", None), ("lying around", "extra", None),
    ("there as distractors", "extra", None), ("lying around as distractors", "extra", None),
    ("distractors", "extra", None), ("a distractor", "extra", None), ("just distractors", "extra", None),
    ("only distractors", "extra", None), ("as decoration", "extra", None), (", which do not matter", "extra", None),
    ("that do not matter", "extra", None), ("irrelevant", "extra", None),
    ("by the robot", "idle", None), ("by the arm", "idle", None), ("with the gripper", "idle", None),
    ("there", "idle", None), ("from above", "idle", None), ("as seen from above", "idle", None),
    ("in the final scene", "finally", None), ("when you are done", "finally", None),
    ("in the target orientation", "turn", 0.0), ("in the right orientation", "turn", 0.0), ("readable", "turn", 0.0),
    ("in the correct orientation", "turn", 0.0), ("the right way around", "turn", 0.0),
    ("readable upright", "turn", 0.0), ("readable from above", "idle", None), (", letters on top", "idle", None),
    ("with the letters facing up", "idle", None), ("with letters facing up", "idle", None),
    (", letters facing up", "idle", None), (", letters readable from above", "idle", None),
    ("partially stacked", "partial", None),
    ("partly stacked", "partial", None), ("of equal height", "equal", None), ("of the same height", "equal", None),
    ("equally tall", "equal", None), ("equally high", "equal", None), ("of equal heights", "equal", None),
    ("the same height", "equal", None), ("with the same height", "equal", None), ("reversed", "backwards", None),
    ("the whole time", "always", None), ("all the time", "always", None), ("from start to finish", "always", None),
    ("during the whole task", "always", None), ("during the task", "always", None), ("at any time", "always", None),
    ("at any point", "always", None), ("ever", "always", None),
    ("respectively", "respectively", None), ("backwards", "backwards", None), ("in reverse", "backwards", None),
    ("backward", "backwards", None),
    ("at the end", "finally", None), ("in the end", "finally", None), ("at once", "idle", None),
    ("one by one", "idle", None),
    ("one at a time", "idle", None), ("carefully", "idle", None), ("gently", "idle", None), ("neatly", "idle", None),
    ("exactly", "idle", None),
    ("again", "idle", None), ("precisely", "idle", None), ("instead", "idle", None),
     ("for me", "idle", None), ("slowly", "idle", None), ("quickly", "idle", None),
    ("in any way", "idle", None), ("in any arrangement", "idle", None), ("in any direction", "idle", None),
    ("in the picture", "idle", None), ("at all times", "always", None),
    ("the whole time", "always", None), ("throughout", "always", None), ("always", "always", None),
    ("in the scene", "idle", None), ("side up", "idle", None),
    ("where it is", "stay", None), ("where they are", "stay", None), ("in place", "stay", None),
    ("as it is", "stay", None), ("as they are", "stay", None),
    ("untouched", "stay", None), ("alone", "stay", None), ("still", "stay", None), ("where they were", "stay", None),
    ("unmoved", "stay", None),
    ("in its place", "stay", None), ("in their places", "stay", None), ("at its place", "stay", None),
    ("where it was", "stay", None), ("undisturbed", "stay", None),
    ("in its current position", "stay", None), ("in its original position", "stay", None),
    ("where it started", "stay", None), ("as is", "stay", None),
    ("in the same place", "stay", None), ("where it currently is", "stay", None),
    ("in their current positions", "stay", None), ("in the same position", "stay", None),
    ("in its initial position", "stay", None), ("in its starting position", "stay", None),
    ("where they started", "stay", None), ("at its current position", "stay", None),
    ("left to right", "idle2", None), ("in a single file", "idle", None), ("apart", "idle2", None),
    ("in a loop", "idle2", None), ("by hand", "idle2", None),
)  # fmt: skip


def _degrees(p: Parser, i: int) -> Results[float]:
    from rpg.passes.schema import lexicon

    j = p.one(i, "by") or i
    j = p.opt(j, "about")
    if (n := p.figure(j)) is not None and j + 1 < p.end and p.words[j + 1] in lexicon.DEGREES.split():
        yield n, p.reach(j + 2)
    for phrase, n in (("a quarter turn", 90.0), ("a half turn", 180.0), ("half a turn", 180.0),
        ("a quarter of a turn", 90.0), ("halfway around", 180.0),
                      ("quarter turn", 90.0), ("half turn", 180.0), ("around", 180.0)):  # fmt: skip
        if phrase != "around" and (k := p.seq(j, phrase)):
            yield n, k


def spelt_word(p: Parser, i: int) -> str | None:
    """The word after "spell"."""
    return literal(p, i)


__all__ = [
    "Loc",
    "Noun",
    "OrderBy",
    "Spacing",
    "Toward",
    "adjunct",
    "adjuncts",
    "direction",
    "label_list",
    "length",
    "listed",
    "manner",
]
