"""Clauses about single blocks, small lots and patches: thing, relation, thing, in every way that they can be read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relation_words import Relation

NAMES = frozenset({"thing", "part", "rest", "it", "they"})
"""Kinds of pieces that name what a statement is about."""
_POINTING = frozenset({"it", "they"})
_ASKING = frozenset({
    "is", "are", "must", "should", "shall", "will", "has", "have", "need", "needs", "ought", "being",
})  # fmt: skip
"""A sentence that begins with one of these asks whether something is so, or tells under which condition."""
_PARTICIPLES = ("carrying", "supporting", "bearing", "topped", "crowned", "capped", "touching")


@dataclass(frozen=True)
class Statement:
    """What is said of `subjects`. `how`: its kind, as the piece that tells it; `what` it tells; `denied`: "not" or
    "never"; `ahead`: it is told before them; `beside`: on which side it is besides; `stacked`: they are stacked."""

    subjects: tuple[Piece, ...]
    how: str
    what: Relation | str = ""
    objects: tuple[Piece, ...] = ()
    denied: str = ""
    ahead: bool = False
    beside: str = ""
    stacked: bool = False


Parse = tuple[tuple[Statement, ...], int]


def sentence_read(pieces: Sequence[Piece]) -> Iterator[tuple[Statement, ...]]:
    """Every way to read a sentence."""
    if pieces[0].value in ("is", "must") and pieces[0].words.split()[0] in _ASKING:
        return
    if any(piece.value == "could" for piece in pieces[1:]):
        return
    limited = any(p.kind == "neither" or p.named.get("how", "").endswith(("at most", "more than")) for p in pieces)
    if any(piece.value == "may" for piece in pieces) and not limited:
        return
    yield from _clauses(pieces, 0, first=True, denied=False)


def _clauses(pieces: Sequence[Piece], at: int, *, first: bool, denied: bool) -> Iterator[tuple[Statement, ...]]:
    """Every way to read what begins at a place, to the end. `denied`: something was denied ahead of it, which holds of
    this too if it has no verb of its own. Only of what the first clause is about more is said behind a joint: behind a
    second one that may be said of both."""
    for statements, end in _clause(pieces, at, first=first):
        if denied and not any(piece.kind == "be" for piece in pieces[at:end]):
            continue
        all_named = all(statement.how == "named" for statement in statements)
        if end == len(pieces):
            yield statements
        elif behind := _joint(pieces, end) or _begins(pieces, end, at, only_named=all_named):
            named = first and all_named
            if not named and any(piece.words == "until" for piece in pieces[end:behind]):
                continue  # it is so only as long as something else is not
            for rest in _clauses(pieces, behind, first=named, denied=any(s.denied for s in statements)):
                yield (*statements, *rest)


def _joint(pieces: Sequence[Piece], at: int) -> int:
    """The end of what binds two clauses, or 0."""
    end = at
    while end < len(pieces) and pieces[end].kind in ("comma", "join", "that"):
        end += 1
    return end if end > at else 0


def _begins(pieces: Sequence[Piece], end: int, at: int, *, only_named: bool) -> int:
    """The place where another clause begins without any word that says so, or 0."""
    whole = _kind(pieces, at) == "there" if only_named else pieces[end - 1].kind in (*NAMES, "place", "mutual")
    return end if whole and _kind(pieces, end) in NAMES else 0


def _known(named: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """Names as those of things that are known by now: "a red block" is the red block."""
    return tuple(
        replace(piece, named={**piece.named, "det": "the"}) if piece.named.get("det") in ("a", "an", "one") else piece
        for piece in named
    )


def _verb(pieces: Sequence[Piece], at: int) -> int:
    """The end of verbs that tell of no relation themselves."""
    while at < len(pieces) and pieces[at].kind == "be":
        at += 1
    return at


def _kind(pieces: Sequence[Piece], at: int) -> str:
    return pieces[at].kind if at < len(pieces) else ""


def _words(pieces: Sequence[Piece], at: int) -> str:
    return pieces[at].words if at < len(pieces) else ""


def _lists(pieces: Sequence[Piece], at: int) -> Iterator[tuple[tuple[Piece, ...], int]]:
    """Names from a place on: one, "A and B", "A, B and C"."""
    if _kind(pieces, at) not in NAMES:
        return
    named, end = [pieces[at]], at + 1
    yield (pieces[at],), end
    while _kind(pieces, end) == "comma" and _kind(pieces, end + 1) in NAMES:
        named.append(pieces[end + 1])
        end += 2
    end += _kind(pieces, end) == "comma" and len(named) > 1
    listing = _words(pieces, end) in ("and", "plus", "as well as")
    if listing and _kind(pieces, end + 1) in NAMES:
        yield (*named, pieces[end + 1]), end + 2


def _clause(pieces: Sequence[Piece], at: int, *, first: bool) -> Iterator[Parse]:
    """Every way to read a clause."""
    if _kind(pieces, at) == "neither":
        yield from _neither(pieces, at)
        return
    introduced = _kind(pieces, at) in ("there", "take")
    start = _verb(pieces, at + (introduced or _words(pieces, at) == "with"))
    if _words(pieces, at) == "with" and start > at + 1:
        return
    keeps = _kind(pieces, start) in ("keep", "still")
    stacked = any(piece.value == "stack" for piece in pieces[at:start])
    for named, end in _lists(pieces, start + keeps):
        if keeps:
            stays = _kind(pieces, end) == "stay"
            if stays or _kind(pieces, start) == "still":
                yield (Statement(named, "stay"),), end + stays
            if named[0].kind == "rest":
                yield from _of(pieces, named, end, more=False)
            continue
        if not stacked and (introduced or start > at or _kind(pieces, end) == "that" or end == len(pieces)):
            yield (Statement(named, "named"),), end
        if _kind(pieces, end) == "aside" and _words(pieces, end + 1) == "and":
            yield from _both_beside(pieces, named, end)
        for statements, last in _of(pieces, named, end, more=first):
            yield tuple(replace(statement, stacked=stacked) for statement in statements), last
        yield from _inserted(pieces, named, end)
    if not stacked:
        yield from _of_two(pieces, start + keeps)
    if not introduced and not stacked:
        yield from _ahead(pieces, start)


def _neither(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """ "Neither A nor B is on C", "neither on C": it is denied of each."""
    end = at + 1
    one, nor, other = (_kind(pieces, end) in NAMES, _words(pieces, end + 1) == "nor", _kind(pieces, end + 2) in NAMES)
    if one and nor and other:
        named: tuple[Piece, ...] = (pieces[end], pieces[end + 2])
        end += 3
    else:
        named = (replace(pieces[at], kind="they"),)
    for statements, last in _said(pieces, named, end):
        (first, *more) = statements
        if not more and not first.denied and first.how in ("rel", "place"):
            yield (replace(first, denied="each"),), last


def _inserted(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A, which carries B, is on C": what is said of one thing by the way."""
    comma = _kind(pieces, at) == "comma"
    which = at + comma + (_kind(pieces, at + comma) == "which")
    participle = comma and _kind(pieces, which) == "rel" and _words(pieces, which).startswith(_PARTICIPLES)
    if len(named) > 1 or not (which > at + comma or participle):
        return
    for statements, end in _said(pieces, named, which):
        behind = end + (_kind(pieces, end) == "comma")
        if comma != (behind > end) or any(statement.denied for statement in statements):
            continue
        for more, last in _of(pieces, _known(named), behind, more=False):
            yield (*statements, *more), last


def _both_beside(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A to the left and B to the right of C"."""
    for other, end in _lists(pieces, at + 2):
        relation = pieces[end].value if _kind(pieces, end) == "rel" else None
        if not isinstance(relation, Relation) or not relation.phrase.endswith((" of", "behind")):
            continue
        if not pieces[at].words.startswith("to ") or relation.phrase == pieces[at].value.phrase:
            continue  # on the left of the table?
        for objects, last in _lists(pieces, end + 1):
            first = Statement(named, "rel", pieces[at].value, objects)
            yield (first, Statement(other, "rel", relation, _known(objects))), last


def _of(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int, *, more: bool) -> Iterator[Parse]:
    """What is said of names that stand ahead, one thing after the other."""
    for statements, end in _said(pieces, named, at):
        yield statements, end
        if _kind(pieces, end) == "still":
            for kept, last in _lists(pieces, end + 1):
                yield (*statements, Statement(kept, "stay")), last
        behind = _joint(pieces, end)
        if not more or not behind or any(piece.kind == "that" for piece in pieces[end:behind]):
            continue
        if _kind(pieces, behind) in NAMES or _words(pieces, behind) == "with":
            continue
        denied = any(statement.denied for statement in statements)
        for others, last in _of(pieces, _known(named), behind, more=True):
            if not denied or all(statement.denied for statement in others):
                yield (*statements, *others), last


def _said(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """One thing that is said of names that stand ahead."""
    listed = _kind(pieces, at) == "comma" and _kind(pieces, at + 1) == "mutual"
    start = _verb(pieces, at + listed)
    denied = str(pieces[start].value) if _kind(pieces, start) == "not" else ""
    start = _verb(pieces, start + bool(denied))
    if denied and _kind(pieces, start) == "they" and _words(pieces, start - 1) == "without":
        named, start = (pieces[start],), start + 1
    if start == len(pieces):
        return
    kind, piece = pieces[start].kind, pieces[start]
    if kind in ("mutual", "place", "elsewhere"):
        yield (Statement(named, kind, piece.value or "", denied=denied),), start + 1
    if kind == "keep" and not denied and _kind(pieces, start + 1) == "stay":
        yield (Statement(named, "stay"),), start + 2
    if kind == "within" and not denied:
        yield (Statement(named, "within", piece.value, denied="not"),), start + 1
    width = start + (kind == "have")
    if _kind(pieces, width) == "width" and not denied:
        how, what = pieces[width].value
        yield (Statement(named, "gap" if how == "gap" else "mutual", what),), width + 1
    if kind == "stays" and not denied:
        yield (Statement(named, "stay"),), start + 1
    if kind == "have" and not denied:
        yield from _of_two(pieces, start + 1)
        for other, end in _lists(pieces, start + 1):
            yield from _beside(pieces, named, other, end)
    if kind == "rel":
        yield from _related(pieces, named, start, denied)


def _related(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int, denied: str) -> Iterator[Parse]:
    """How names that stand ahead stand to others."""
    piece = pieces[at]
    for objects, end in _lists(pieces, at + 1):
        stated = Statement(named, "rel", piece.value, objects, denied)
        side = end + (_kind(pieces, end) == "comma")
        close = isinstance(piece.value, Relation) and piece.value.phrase.endswith("next to") and not denied
        if _kind(pieces, side) == "aside":
            if close:
                yield (replace(stated, beside=pieces[side].value.phrase),), side + 1
            continue
        yield (stated,), end
        if denied:
            continue
        told = not any(p.value in ("make", "stack") for p in pieces)  # else it may be that another is not put there
        if (
            piece.value == Relation("touch")
            and told
            and _words(pieces, end) == "but"
            and _kind(pieces, end + 1) == "not"
        ):
            for others, last in _lists(pieces, end + 2):
                yield (stated, Statement(_known(named), "rel", piece.value, others, "not")), last
        if _kind(pieces, side) == "mutual" and pieces[side].words.endswith(("away", "apart")):
            far = Relation(f"{pieces[side].value.removeprefix('be ').removesuffix(' apart')} from")
            yield (stated, Statement(_known(named), "rel", far, _known(objects))), side + 1
        wide = side + (_kind(pieces, side) == "have")
        if _kind(pieces, wide) == "width" and _kind(pieces, wide + 1) != "they":
            how, what = pieces[wide].value
            both = _known((*named, *objects))
            yield (stated, Statement(both, "gap" if how == "gap" else "mutual", what)), wide + 1
        if _kind(pieces, end) == "have" or (_kind(pieces, end + 1) == "have" and _kind(pieces, end) == "comma"):
            yield from _with(pieces, stated, end + (_kind(pieces, end) == "comma"))
        if getattr(piece.value, "phrase", "") == "from" and _kind(pieces, end) == "rel":
            for more, last in _said(pieces, _known(named), end):
                yield (stated, *more), last
        if _kind(pieces, end) == "rel" and len(objects) == 1 and _piled(piece, pieces[end]):
            for more, last in _said(pieces, _known(objects), end):
                yield (stated, *more), last


def _piled(*pieces: Piece) -> bool:
    """Whether relations go on one from the other: "red on blue on green"."""
    phrases = {p.value.phrase if isinstance(p.value, Relation) else "" for p in pieces}
    return phrases <= {"on", "on top of"} or (len(phrases) == 1 and "off" not in phrases and "" not in phrases)


def _with(pieces: Sequence[Piece], stated: Statement, at: int) -> Iterator[Parse]:
    """ "... with the blue one on it", "... with a gap of 3 cm between them" behind a statement."""
    for other, end in _lists(pieces, at + 1):
        sided = isinstance(stated.what, Relation) and stated.what.phrase.endswith(("left of", "right of"))
        if _kind(pieces, end) == "amid" and sided:
            sides = _known((*stated.subjects, *stated.objects))
            yield (stated, Statement(other, "rel", Relation("between", count=2), sides)), end + 1
        for statements, last in _said(pieces, other, end):
            (first, *more) = statements
            if not more and first.how == "rel" and any(piece.kind in _POINTING for piece in first.objects):
                yield (stated, first), last
    for both, last in _of_two(pieces, at + 1):
        yield (stated, *both), last


def _beside(pieces: Sequence[Piece], named: tuple[Piece, ...], other: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A has B on its left": what is said of the second stands to the first."""
    if _kind(pieces, at) == "aside":
        stated = Statement(other, "rel", pieces[at].value, named)
        yield (stated,), at + 1
        if _words(pieces, at + 1) in ("and", ","):
            for another, end in _lists(pieces, at + 2):
                for others, last in _beside(pieces, _known(named), another, end):
                    yield (stated, *others), last
    for statements, last in _said(pieces, other, at):
        (first, *more) = statements
        if not more and first.how == "rel" and len(first.objects) == 1 and first.objects[0].kind in _POINTING:
            yield (replace(first, objects=named),), last


def _ahead(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """What is said of names that stand behind: "on the mat there is a red block"."""
    if at >= len(pieces):
        return
    kind, first = pieces[at].kind, pieces[at]
    told: list[tuple[Statement, int]] = []
    if kind == "place":
        told = [(Statement((), kind, first.value, ahead=True), at + 1)]
    if kind == "rel":
        told = [
            (Statement((), "rel", first.value, objects, ahead=True), end) for objects, end in _lists(pieces, at + 1)
        ]
    for statement, end in told:
        start = end + (_kind(pieces, end) == "comma")
        behind = _verb(pieces, start + (_kind(pieces, start) == "there"))
        stacked = any(piece.value == "stack" for piece in pieces[start:behind])
        for named, last in _lists(pieces, behind):
            yield (replace(statement, subjects=named, stacked=stacked),), last


def _of_two(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """What two things are to each other, where it stands ahead of them."""
    kind, first = _kind(pieces, at), pieces[at] if at < len(pieces) else None
    if first is None:
        return
    if kind == "rel" and first.value == Relation("between", count=2):
        for named, end in _lists(pieces, at + 1):
            wide = _verb(pieces, end + (_kind(pieces, end) == "comma"))
            wide = _verb(pieces, wide + (_kind(pieces, wide) == "there"))
            if _kind(pieces, wide) == "width":
                how, what = pieces[wide].value
                yield (Statement(named, "gap" if how == "gap" else "mutual", what),), wide + 1
        return
    if kind not in ("apart", "gap", "between", "swap"):
        return
    for named, end in _lists(pieces, at + 1):
        if kind in ("apart", "gap"):
            yield (Statement(named, "mutual" if kind == "apart" else "gap", first.value),), end
        if kind == "swap":
            yield (Statement(named, "mutual", "swap places"),), end
            if _words(pieces, end) == "with":
                for other, last in _lists(pieces, end + 1):
                    yield (Statement((*named, *other), "mutual", "swap places"),), last
        if first.value == "from" and _words(pieces, end) == "to":
            for other, last in _lists(pieces, end + 1):
                if _kind(pieces, last) == "measure":
                    yield (Statement((*named, *other), "mutual", f"be {pieces[last].value} apart"),), last + 1
        elif kind == "between" and _kind(pieces, end) == "measure":
            far = pieces[end].value
            apart = first.value == "apart"
            yield (Statement(named, "mutual" if apart else "gap", f"be {far} apart" if apart else far),), end + 1
