"""Where a figure, or a part of it, points: "with its foot to the right", "the point of the V towards me"."""

from __future__ import annotations

from rpg.language.grammar.clauses.some_way import SOME_WAY, SOME_WAYS
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Manner

_FACE_WORDS = {"up": "up", "upward": "up", "upwards": "up", "down": "down", "downward": "down", "downwards": "down",
    "left": "left",
               "right": "right", "front": "front", "forward": "back", "back": "back", "backward": "front",
               "camera": "viewer", "viewer": "viewer", "me": "viewer",
               "robot": "front", "us": "viewer"}  # fmt: skip


_AWAY = ("away from me", "away from us", "away from the camera", "away from the viewer", "away from the robot")


@rule
def direction(p: Parser, i: int) -> Results[str]:
    """ "up", "to the left", "towards the camera"."""
    j = p.any_of(i, ("to the", "toward the", "towards the", "to", "towards", "toward", "the")) or i
    if side := p.peek(j, _FACE_WORDS):
        k = p.any_of(p.reach(j + 1), ("side of the table", "side", "edge of the table", "end of the table")) or j + 1
        yield side, k if p.words[j] in ("left", "right") else j + 1
    if j := p.any_of(i, _AWAY):
        yield "back", j
    if j := p.any_of(i, SOME_WAYS):
        yield SOME_WAY, j


_POINTERS = {
    **{word: word.rpartition(" ")[2] for word in (
        "corner", "foot", "opening", "open side", "open end", "mouth", "tip", "apex", "point", "top", "stem", "base",
        "tail", "ends", "leg")},
    **{f"{short} {arm}": "foot" for short in ("short", "shorter") for arm in ("side", "arm", "leg", "bar", "one")},
    **dict.fromkeys(("bar", "crossbar", "cross bar", "top bar", "crosspiece", "horizontal bar"), "bar"),
}  # fmt: skip
_OF_FIGURE = Patterns(
    "of it", "of|in the|this|that v|u|t|l|letter|shape|figure|v_shape|u_shape|t_shape|l_shape|pyramid|triangle|arrow"
)
_LONG = tuple(f"{long} {arm}" for long in ("long", "longer") for arm in ("side", "arm", "leg", "bar"))
_POINTING = (
    "pointing", "facing", "points", "faces", "to", "towards", "toward", "on", "at", "directed", "going", "is",
    "extending", "coming", "being", "is at", "is on", "is pointing", "is facing", "points to", "goes to",
    "comes towards", "sticking out", "shows", "shows to", "shows towards", "shows toward", "is to", "looks", "looks to",
    "looks towards", "looking", "looking towards", "showing", "showing towards", "pointed",
    *(f"{must} {point}" for must in ("should", "must", "shall", "has to", "is to", "needs to")
      for point in ("point", "face", "be", "go", "be at", "be on", "point to", "lie at", "open")),
)  # fmt: skip


_WITH_ITS = ("with its", "with the", "its", "with", "the", "whose", "with a", "but with its", "but with the",
             "and with its", "and its", "but its")  # fmt: skip


@rule
def points(p: Parser, i: int, comma: int) -> Results[Manner]:
    """ "with its foot to the right", "tip pointing left"."""
    j = p.any_of(comma, _WITH_ITS)
    j = j or (comma if comma > i else 0)
    if opened := p.any_of(comma, ("open to", "open towards", "open toward", "open on",
                                  "with the opening at", "with its opening at", "with the open side at",
                                  "opening to", "opening towards", "open at",
                                  "that opens to", "which opens to", "opens to", "opened to")):  # fmt: skip
        for side, e in whither(p, opened):
            yield Manner(kind="pointing:opening", value=side, span=p.span(i, e)), e
    for phrase, end in p.standing(j, _POINTERS) if j else ():
        end = max(_OF_FIGURE.matches(p, end), default=end)
        for side, e in whither(p, p.any_of(end, _POINTING) or end):
            yield Manner(kind="pointing:" + _POINTERS[phrase], value=side, span=p.span(i, e)), e
    away = p.any_of(j, _LONG) if j else 0
    if e := p.any_of(p.any_of(away, _POINTING) or away, _AWAY) if away else 0:
        yield Manner(kind="pointing:long", value="back", span=p.span(i, e)), e


ENDS = frozenset({"foot", "opening", "mouth", "tip", "apex", "point", "stem", "tail", "leg", "bar", "long"})
"""What figures have, and blocks do not."""


@choice
def pointed(p: Parser, i: int) -> Results[Manner]:
    """In a sentence of its own: "Its foot should point to the right." """
    if p.stands(i, ("the", "its")):
        yield from ((how, j) for how, j in points(p, i, i) if how.kind.partition(":")[2] in ENDS)


def whither(p: Parser, i: int) -> Results[str]:
    """Where a part of a figure points, or where it lies: "to the left", "(at) the far side"."""
    yield from direction(p, p.opt(i, "the"))
    for phrase, j in p.standing(p.opt(i, "the"), _LIES_AT):
        yield _LIES_AT[phrase], j


_LIES_AT = {
    "far side": "back", "far end": "back", "top": "back", "top side": "back", "near side": "front", "near end": "front",
    "bottom": "front", "bottom side": "front", "back side": "back", "front side": "front", "side facing me": "front",
    "far": "back", "near": "front", "far away": "back", "farthest from me": "back", "nearest to me": "front",
    "closest to me": "front", "near me": "front", "rear": "back",
}  # fmt: skip
