"""Pieces of statements put more plainly, before sentences are made of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relations.reading import NAMES
from rpg.language.frames.relations.words import Relation

_ON = ("on", "on top of")
_ONE = frozenset({"a", "an", "one", "another"})


def plainer(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces without colons in "red: on the mat", with names for "it" and for one and another."""
    colons = {
        n
        for n in range(1, len(pieces) - 1)
        if pieces[n].words == ":" and pieces[n - 1].kind in NAMES and pieces[n + 1].kind in ("rel", "place", "mutual")
    }
    found = [piece for n, piece in enumerate(pieces) if n not in colons]
    for step in (_headed, _counted_out, _no_longer, _listed, _excepted, _one_by_one, _taken, _one_and_other):
        found = step(found)
    return found


def _one_by_one(pieces: list[Piece]) -> list[Piece]:
    """ "The two blue blocks, one on A and one on B", or "the other on B": one of two, and the other."""
    ones = [n for n, piece in enumerate(pieces) if piece.kind == "one"]
    lots = [p for p in pieces[: ones[0]] if p.kind == "thing" and p.value == "block"] if ones else []
    if len(ones) not in (1, 2) or len(lots) != 1 or lots[0].named.get("count") != "2":
        return pieces
    if len(ones) == 1 and not any(p.kind == "rest" for p in pieces[ones[0] :]):
        return pieces
    found = list(pieces)
    lot = {"color": lots[0].named["color"]}
    found[ones[0]] = Piece("part", "one of them", None, {"part": "1", "count": "2", **lot})
    for n in ones[1:]:
        found[n] = Piece("rest", "the other one", None, lot)
    return found


def _headed(pieces: list[Piece]) -> list[Piece]:
    """ "Mat: red, blue": what stands behind the colon is on it."""
    found = list(pieces)
    for n, piece in enumerate(pieces[:-2]):
        if pieces[n + 1].words != ":" or (n and pieces[n - 1].kind != "stop"):
            continue
        end = next((m for m in range(n + 2, len(pieces)) if pieces[m].kind == "stop"), len(pieces))
        listed = pieces[n + 2 : end]
        if any(p.kind not in ("thing", "comma", "join") or p.value == "patch" for p in listed):
            continue
        listed = _as_a_list([p for p in listed if p.kind == "thing"])
        if piece.value == "patch":
            found[n:end] = [*listed, Piece("rel", "on", Relation("on")), piece]
        elif piece.kind == "place":
            found[n:end] = [*listed, replace(piece, words="on the table"), Piece("comma", ",")]
    return found


def _as_a_list(things: Sequence[Piece]) -> list[Piece]:
    """ "A, B and C"."""
    listed = [p for thing in things for p in (Piece("comma", ","), thing)][1:]
    return [*listed[:-2], Piece("join", "and"), listed[-1]] if len(things) > 1 else listed


def _no_longer(pieces: list[Piece]) -> list[Piece]:
    """ "A is not on B any more", "A is no longer on B": it is put off it."""
    found = list(pieces)
    for n, piece in enumerate(pieces):
        if piece.kind != "anymore":
            continue
        begin = max((m + 1 for m in range(n) if pieces[m].kind in ("stop", "join", "then", "that")), default=0)
        end = next(
            (m for m in range(n, len(pieces)) if pieces[m].kind in ("stop", "join", "then", "that")), len(pieces)
        )
        on = [m for m in range(begin, end) if isinstance(r := pieces[m].value, Relation) and r.phrase in _ON]
        denied = [m for m in range(begin, end) if pieces[m].kind == "not" and pieces[m].value == "not"]
        if len(on) == 1 and not pieces[on[0]].value.turned and len(denied) == (not piece.words.startswith("no")):
            found[on[0]] = replace(pieces[on[0]], value=Relation("off"))
            for m in (n, *denied):
                found[m] = Piece("dropped", "")
    return [piece for piece in found if piece.kind != "dropped"]


def _listed(pieces: list[Piece]) -> list[Piece]:
    """ "One cube red one cube blue": two things, one after the other, that make a sentence."""
    found: list[Piece] = []
    for n, piece in enumerate(pieces):
        found.append(piece)
        begin = max((m + 1 for m in range(n) if pieces[m].kind == "stop"), default=0)
        end = next((m for m in range(n, len(pieces)) if pieces[m].kind == "stop"), len(pieces))
        if end > n + 1 and all(p.kind == "thing" and _is_one(p) for p in pieces[begin:end]):
            found.append(Piece("comma", ",") if end > n + 2 else Piece("join", "and"))
    return found


def _counted_out(pieces: list[Piece]) -> list[Piece]:
    """ "I have 3 blocks red blue green I want ...": each of them, in a sentence of its own."""
    found: list[Piece] = []
    n = 0
    while n < len(pieces):
        end = n + 1
        things: list[Piece] = []
        while pieces[n].kind == "total" and end < len(pieces) and len(things) < pieces[n].value:
            if pieces[end].kind == "thing" and "many" not in pieces[end].named and "count" not in pieces[end].named:
                things.append(pieces[end])
            elif pieces[end].kind not in ("comma", "join") and (pieces[end].words != ":" or things):
                break
            end += 1
        ends = end == len(pieces) or pieces[end].kind not in ("rel", "place", "mutual", "join", "comma", "be", "keep")
        ends |= end < len(pieces) and pieces[end].value in ("make", "stack")
        if not things or len(things) != pieces[n].value or not ends:
            found.append(pieces[n])
            n += 1
            continue
        told = found[-1:] and found[-1].kind in ("there", "take")
        found += [] if told else [Piece("there", "there are", "is")]
        found += _as_a_list(things)
        found += [] if end == len(pieces) or pieces[end].kind == "stop" else [Piece("stop", ".")]
        n = end
    return found


def _excepted(pieces: list[Piece]) -> list[Piece]:
    """ "All four red blocks on the mat except one": three of the four."""
    found = list(pieces)
    drop = set()
    for n, piece in enumerate(pieces):
        begin = max((m + 1 for m in range(n) if pieces[m].kind in ("stop", "comma", "join", "then")), default=0)
        lots = [m for m in range(begin, n) if pieces[m].kind == "thing" and "count" in pieces[m].named]
        if piece.kind == "except" and len(lots) == 1 and pieces[lots[0]].named.get("det", "").startswith("all"):
            lot = pieces[lots[0]]
            found[lots[0]] = replace(lot, kind="part", named={**lot.named, **piece.named})
            drop.add(n)
    return [piece for n, piece in enumerate(found) if n not in drop]


def _taken(pieces: list[Piece]) -> list[Piece]:
    """ "Take the red block off the blue one and put it on the mat", "move the red block so that it touches the blue one
    and it is on the mat", "the red block is on the blue one. Put it on the mat": what is taken, moved or told."""
    found: list[Piece] = []
    taken: Piece | None = None
    moved: Piece | None = None
    for n, piece in enumerate(pieces):
        if piece.kind in ("stop", "then"):
            taken = moved = None
        if piece.kind == "stop" and all(p.kind != "stop" for p in pieces[:n]):
            taken = _told_of(pieces[:n])
        if piece.kind == "take":
            taken = taken if pieces[n + 1 : n + 2] and pieces[n + 1].kind == "it" else _thing(pieces, n + 1)
        if piece.kind == "that" and n > 1 and pieces[n - 2].value == "make":
            moved = _thing(pieces, n - 1)
        ahead = pieces[n - 1] if n else piece
        meant = (
            taken
            if ahead.value in ("make", "stack") or ahead.kind == "take"
            else moved
            if ahead.kind in ("that", "join")
            else None
        )
        found.append(meant if piece.kind == "it" and meant else piece)
    return found


def _told_of(pieces: list[Piece]) -> Piece | None:
    """What the first sentence tells of, if it tells how one thing is to another."""
    said = [n for n, piece in enumerate(pieces) if piece.kind not in ("there", "now") and piece.value != "is"]
    if [pieces[n].kind for n in said] != ["thing", "rel", "thing"] or len(said) == len(pieces):
        return None
    return _thing(pieces, said[0])


def _thing(pieces: list[Piece], n: int) -> Piece | None:
    """The one thing that a piece names, as it is named again."""
    piece = pieces[n] if n < len(pieces) else None
    if piece is None or piece.kind != "thing" or piece.named.get("count") or "many" in piece.named:
        return None
    return replace(piece, named={**piece.named, "det": "the"})


def _one_and_other(pieces: list[Piece]) -> list[Piece]:
    """ "One red block on A and another red block on B", in one sentence: one of two, and the other."""
    found = list(pieces)
    for color in {piece.named["color"] for piece in pieces if piece.value == "block" and piece.kind == "thing"}:
        same = [n for n, p in enumerate(pieces) if p.named.get("color") == color and p.value != "patch"]
        if len(same) != 2 or any(p.kind in ("stop", "then", "there", "part", "rest") for p in pieces[: same[1]]):
            continue
        one, other = (pieces[n] for n in same)
        if all(_is_one(p) and "size" not in p.named for p in (one, other)):
            found[same[0]] = Piece("part", one.words, None, {"part": "1", "count": "2", "color": color})
            found[same[1]] = Piece("rest", other.words, None, {"color": color, "count": "1"})
    return found


def _is_one(piece: Piece) -> bool:
    """Whether it is one block, which was not told of before."""
    named = piece.named
    return piece.kind == "thing" and "many" not in named and (named.get("det") or named.get("count", "")) in _ONE
