"""Clauses about single blocks, small lots and patches: thing, relation, thing, in every way that they can be read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relations.pairs import of_two
from rpg.language.frames.relations.reading import (
    NAMES,
    Parse,
    Statement,
    behind_verbs,
    kind_at,
    known_now,
    lists,
    words_at,
)
from rpg.language.frames.relations.words import Relation

_POINTING = frozenset({"it", "they"})
_ASKING = frozenset({
    "is", "are", "must", "should", "shall", "will", "has", "have", "need", "needs", "ought", "being",
})  # fmt: skip
"""A sentence that begins with one of these asks whether something is so, or tells under which condition."""
_PARTICIPLES = ("carrying", "supporting", "bearing", "topped", "crowned", "capped", "touching")


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
                if behind == end and rest[0].how == "named":
                    continue  # nothing is said of what stands there
                yield (*statements, *rest)


def _joint(pieces: Sequence[Piece], at: int) -> int:
    """The end of what binds two clauses, or 0."""
    end = at
    while end < len(pieces) and pieces[end].kind in ("comma", "join", "that"):
        end += 1
    return end if end > at else 0


def _begins(pieces: Sequence[Piece], end: int, at: int, *, only_named: bool) -> int:
    """The place where another clause begins without any word that says so, or 0."""
    whole = kind_at(pieces, at) == "there" if only_named else pieces[end - 1].kind in (*NAMES, "place", "mutual")
    return end if whole and kind_at(pieces, end) in NAMES else 0


def _clause(pieces: Sequence[Piece], at: int, *, first: bool) -> Iterator[Parse]:
    """Every way to read a clause."""
    if kind_at(pieces, at) == "neither":
        yield from _neither(pieces, at)
        return
    if kind_at(pieces, at) == "others":
        yield (Statement((), "others"),), at + 1
    if kind_at(pieces, at) == "nothing":
        yield from _nothing(pieces, at)
        return
    introduced = kind_at(pieces, at) in ("there", "take")
    start = behind_verbs(pieces, at + (introduced or words_at(pieces, at) == "with"))
    if words_at(pieces, at) == "with" and start > at + 1:
        return
    keeps = kind_at(pieces, start) in ("keep", "still")
    stacked = any(piece.value == "stack" for piece in pieces[at:start])
    for named, end in lists(pieces, start + keeps):
        if keeps:
            if kind_at(pieces, end) == "empty":
                yield (Statement(named, "empty"),), end + 1
            stays = kind_at(pieces, end) == "stay"
            if stays or kind_at(pieces, start) == "still":
                yield (Statement(named, "stay"),), end + stays
            if named[0].kind == "rest":
                yield from _of(pieces, named, end, more=False)
            continue
        if not stacked and (introduced or start > at or kind_at(pieces, end) == "that" or end == len(pieces)):
            yield (Statement(named, "named"),), end
        if kind_at(pieces, end) == "aside" and words_at(pieces, end + 1) == "and":
            yield from _both_beside(pieces, named, end)
        lies = kind_at(pieces, at) == "take" and kind_at(pieces, end) == "rel" and not stacked
        if lies and getattr(pieces[end].value, "phrase", "") not in ("off", "from", "inside"):
            continue  # where it is when it is taken
        for statements, last in _of(pieces, named, end, more=first):
            yield tuple(replace(statement, stacked=stacked) for statement in statements), last
        yield from _inserted(pieces, named, end)
    if not stacked:
        yield from of_two(pieces, start + keeps)
    if not introduced and not stacked:
        yield from _ahead(pieces, start)


def _nothing(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """ "Nothing is on A"."""
    start = behind_verbs(pieces, at + 1)
    relation = pieces[start].value if kind_at(pieces, start) == "rel" else None
    if isinstance(relation, Relation) and relation.phrase in ("on", "on top of") and not relation.turned:
        for objects, end in lists(pieces, start + 1):
            yield (Statement(objects, "empty"),), end


def _neither(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """ "Neither A nor B is on C", "neither on C": it is denied of each."""
    end = at + 1
    one, nor, other = (
        kind_at(pieces, end) in NAMES,
        words_at(pieces, end + 1) == "nor",
        kind_at(pieces, end + 2) in NAMES,
    )
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
    comma = kind_at(pieces, at) == "comma"
    which = at + comma + (kind_at(pieces, at + comma) == "which")
    participle = comma and kind_at(pieces, which) == "rel" and words_at(pieces, which).startswith(_PARTICIPLES)
    if len(named) > 1 or not (which > at + comma or participle):
        return
    for statements, end in _said(pieces, named, which):
        behind = end + (kind_at(pieces, end) == "comma")
        if comma != (behind > end) or any(statement.denied for statement in statements):
            continue
        for more, last in _of(pieces, known_now(named), behind, more=False):
            yield (*statements, *more), last


def _both_beside(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A to the left and B to the right of C"."""
    for other, end in lists(pieces, at + 2):
        relation = pieces[end].value if kind_at(pieces, end) == "rel" else None
        if not isinstance(relation, Relation) or not relation.phrase.endswith((" of", "behind")):
            continue
        if not pieces[at].words.startswith("to ") or relation.phrase == pieces[at].value.phrase:
            continue  # on the left of the table?
        for objects, last in lists(pieces, end + 1):
            first = Statement(named, "rel", pieces[at].value, objects)
            yield (first, Statement(other, "rel", relation, known_now(objects))), last


def _of(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int, *, more: bool) -> Iterator[Parse]:
    """What is said of names that stand ahead, one thing after the other."""
    for statements, end in _said(pieces, named, at):
        yield statements, end
        if kind_at(pieces, end) == "still":
            for kept, last in lists(pieces, end + 1):
                yield (*statements, Statement(kept, "stay")), last
        behind = _joint(pieces, end)
        if not more or not behind or any(piece.kind == "that" for piece in pieces[end:behind]):
            continue
        if kind_at(pieces, behind) in NAMES or words_at(pieces, behind) == "with":
            continue
        denied = any(statement.denied for statement in statements)
        for others, last in _of(pieces, known_now(named), behind, more=True):
            if not denied or all(statement.denied for statement in others):
                yield (*statements, *others), last


def _said(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """One thing that is said of names that stand ahead."""
    listed = kind_at(pieces, at) == "comma" and kind_at(pieces, at + 1) == "mutual"
    start = behind_verbs(pieces, at + listed)
    denied = str(pieces[start].value) if kind_at(pieces, start) == "not" else ""
    start = behind_verbs(pieces, start + bool(denied))
    if denied and kind_at(pieces, start) == "they" and words_at(pieces, start - 1) == "without":
        named, start = (pieces[start],), start + 1
    if start == len(pieces):
        return
    kind, piece = pieces[start].kind, pieces[start]
    empty = start + (kind == "keep")
    if kind_at(pieces, empty) == "empty" and not denied:
        yield (Statement(named, "empty"),), empty + 1
    if kind == "aside" and not denied and not piece.value.phrase.endswith(("left of", "right of")):  # of the table?
        yield (Statement(named, "rel", piece.value, (replace(piece, kind="other"),)),), start + 1
    if kind in ("mutual", "place", "elsewhere"):
        stated = Statement(named, kind, piece.value or "", denied=denied)
        yield (stated,), start + 1
        if kind == "place" and not denied and kind_at(pieces, start + 1) == "rel":
            for more, last in _said(pieces, known_now(named), start + 1):
                yield (stated, *more), last
    if kind == "keep" and not denied and kind_at(pieces, start + 1) == "stay":
        yield (Statement(named, "stay"),), start + 2
    if kind == "within" and not denied:
        yield (Statement(named, "within", piece.value, denied="not"),), start + 1
    width = start + (kind == "have")
    if kind_at(pieces, width) == "width" and not denied:
        how, what = pieces[width].value
        yield (Statement(named, "gap" if how == "gap" else "mutual", what),), width + 1
    if kind == "stays" and not denied:
        yield (Statement(named, "stay"),), start + 1
    if kind == "have" and not denied:
        yield from of_two(pieces, start + 1)
        for other, end in lists(pieces, start + 1):
            yield from _beside(pieces, named, other, end)
    if kind == "rel":
        yield from _related(pieces, named, start, denied)


def _related(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int, denied: str) -> Iterator[Parse]:
    """How names that stand ahead stand to others."""
    piece = pieces[at]
    for objects, end in lists(pieces, at + 1):
        stated = Statement(named, "rel", piece.value, objects, denied)
        side = end + (kind_at(pieces, end) == "comma")
        close = isinstance(piece.value, Relation) and piece.value.phrase.endswith("next to") and not denied
        if kind_at(pieces, side) == "aside":
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
            and words_at(pieces, end) == "but"
            and kind_at(pieces, end + 1) == "not"
        ):
            for others, last in lists(pieces, end + 2):
                yield (stated, Statement(known_now(named), "rel", piece.value, others, "not")), last
        if kind_at(pieces, side) == "mutual" and pieces[side].words.endswith(("away", "apart")):
            far = Relation(f"{pieces[side].value.removeprefix('be ').removesuffix(' apart')} from")
            yield (stated, Statement(known_now(named), "rel", far, known_now(objects))), side + 1
        wide = side + (kind_at(pieces, side) == "have")
        measured = kind_at(pieces, wide) in ("width", "apart", "gap")
        if measured and kind_at(pieces, wide + 1) not in NAMES:
            how, what = (pieces[wide].value if kind_at(pieces, wide) == "width"
                         else (pieces[wide].kind, pieces[wide].value))  # fmt: skip
            both = known_now((*named, *objects))
            yield (stated, Statement(both, "gap" if how == "gap" else "mutual", what)), wide + 1
        if kind_at(pieces, end) == "have" or (kind_at(pieces, end + 1) == "have" and kind_at(pieces, end) == "comma"):
            yield from _with(pieces, stated, end + (kind_at(pieces, end) == "comma"))
        if getattr(piece.value, "phrase", "") == "from" and kind_at(pieces, end) in ("rel", "place"):
            for more, last in _said(pieces, known_now(named), end):
                yield (stated, *more), last
        if kind_at(pieces, end) == "rel" and len(objects) == 1 and _piled(piece, pieces[end]):
            for more, last in _said(pieces, known_now(objects), end):
                yield (stated, *more), last


def _piled(*pieces: Piece) -> bool:
    """Whether relations go on one from the other: "red on blue on green"."""
    phrases = {p.value.phrase if isinstance(p.value, Relation) else "" for p in pieces}
    return phrases <= {"on", "on top of"} or (len(phrases) == 1 and "off" not in phrases and "" not in phrases)


def _with(pieces: Sequence[Piece], stated: Statement, at: int) -> Iterator[Parse]:
    """ "... with the blue one on it", "... with a gap of 3 cm between them" behind a statement."""
    for other, end in lists(pieces, at + 1):
        sided = isinstance(stated.what, Relation) and stated.what.phrase.endswith(("left of", "right of"))
        if kind_at(pieces, end) == "amid" and sided:
            sides = known_now((*stated.subjects, *stated.objects))
            yield (stated, Statement(other, "rel", Relation("between", count=2), sides)), end + 1
        on = isinstance(stated.what, Relation) and stated.what.phrase in ("on", "on top of") and not stated.what.turned
        aside = pieces[end].value.phrase if kind_at(pieces, end) == "aside" else ""
        if on and aside.endswith(("left of", "right of", "front of", "behind")) and stated.objects[0].value != "patch":
            yield (stated, Statement(other, "rel", pieces[end].value, known_now(stated.objects))), end + 1
        for statements, last in _said(pieces, other, end):
            (first, *more) = statements
            if not more and first.how == "rel" and any(piece.kind in _POINTING for piece in first.objects):
                yield (stated, first), last
    for both, last in of_two(pieces, at + 1):
        yield (stated, *both), last


def _beside(pieces: Sequence[Piece], named: tuple[Piece, ...], other: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A has B on its left": what is said of the second stands to the first."""
    if kind_at(pieces, at) == "aside":
        stated = Statement(other, "rel", pieces[at].value, named)
        yield (stated,), at + 1
        if words_at(pieces, at + 1) in ("and", ","):
            for another, end in lists(pieces, at + 2):
                for others, last in _beside(pieces, known_now(named), another, end):
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
        told = [(Statement((), "rel", first.value, objects, ahead=True), end) for objects, end in lists(pieces, at + 1)]
    for statement, end in told:
        start = end + (kind_at(pieces, end) == "comma")
        behind = behind_verbs(pieces, start + (kind_at(pieces, start) == "there"))
        stacked = any(piece.value == "stack" for piece in pieces[start:behind])
        for named, last in lists(pieces, behind):
            yield (replace(statement, subjects=named, stacked=stacked),), last
