"""How single blocks, small lots and patches stand to each other, statement by statement."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.related_things import Known, Things
from rpg.language.frames.relation_words import PATTERNS as PATTERNS
from rpg.language.frames.relation_words import Relation

_NAMES = frozenset({"thing", "part", "one", "rest", "it", "they"})
"""Kinds of pieces that name what a statement is about."""
_MOST = 200
"""More readings than these are not looked at."""


@dataclass(frozen=True)
class Statement:
    """What is said of `subjects`. `how`: its kind, as the piece that tells it; `what` it tells; `ahead`: it is told
    before them."""

    subjects: tuple[Piece, ...]
    how: str
    what: Relation | str = ""
    objects: tuple[Piece, ...] = ()
    denied: bool = False
    ahead: bool = False
    beside: str = ""


Parse = tuple[tuple[Statement, ...], int]


def told(pieces: Sequence[Piece]) -> str:
    """The statements in plain sentences.

    Raises:
        Unclear: they can be read in no way, or in several.
    """
    stages = _stages([piece for piece in pieces if piece.kind != "glue"])
    for stage in stages:
        _check_mood(stage)
    readings: list[tuple[Things, list[list[str]]]] = [(Things(), [])]
    for stage in stages:
        readings = [(things, [*said, []]) for things, said in readings]
        for sentence in stage:
            readings = [told for reading in readings for told in _told_of(sentence, *reading)][:_MOST]
            if not readings or len(readings) == _MOST:
                raise Unclear
    texts = {_text(things, said) for things, said in readings if things.all_used and any(said)}
    if len(texts) != 1:
        raise Unclear
    return texts.pop()


def _told_of(sentence: Sequence[Piece], things: Things, said: list[list[str]]) -> Iterator[tuple[Things, list[list[str]]]]:
    """What is known and said behind a sentence, in each way that it can be read."""
    for statements in _sentence(sentence, 0):
        known = things.copied()
        try:
            new = [text for statement in statements if (text := _plain(statement, known))]
        except Unclear:
            continue
        yield known, [*said[:-1], [*said[-1], *new]]


def _stages(pieces: Sequence[Piece]) -> list[list[list[Piece]]]:
    """The sentences of each stage.

    Raises:
        Unclear: several sentences may belong to a stage, or to what holds all the time.
    """
    stages: list[list[list[Piece]]] = [[[]]]
    for n, piece in enumerate(pieces):
        if piece.kind == "first" and (any(stages[-1][-1]) or len(stages) > 1):
            raise Unclear
        if piece.kind == "then":
            stages.append([[]])
        elif piece.kind == "stop":
            stages[-1].append([])
        elif piece.kind != "first":
            stages[-1][-1].append(piece)
    found = [[cleaned for sentence in stage if (cleaned := _stripped(sentence))] for stage in stages]
    if any(piece.kind == "first" for piece in pieces) and len(found) < 2:
        raise Unclear
    if len(found) > 1 and (not all(found) or any(len(stage) > 1 for stage in found[1:])):
        raise Unclear
    if len(found) > 1 and any(_states(sentence) for sentence in found[0][:-1]):
        raise Unclear
    return found


def _states(sentence: Sequence[Piece]) -> bool:
    return not all(piece.kind in _NAMES | {"join", "comma", "there", "take", "have", "be"} for piece in sentence)


def _stripped(sentence: list[Piece]) -> list[Piece]:
    """A sentence without what binds it to others."""
    while sentence and sentence[0].kind in ("join", "comma"):
        sentence = sentence[1:]
    while sentence and sentence[-1].kind in ("join", "comma"):
        sentence = sentence[:-1]
    return sentence


def _check_mood(sentences: Sequence[Sequence[Piece]]) -> None:
    """What is told and what is asked for are not mixed: what is told may be so at the start.

    Raises:
        Unclear: they are.
    """
    moods = set()
    for sentence in sentences:
        if not _states(sentence) or all(p.words.endswith("the table") for p in sentence if p.kind in ("place", "rel")):
            continue
        for part in _at_joints(sentence):
            moods |= {_mood(part)}
    if "do" in moods and "is" in moods or len(sentences) > 1 and len(moods - {"open"}) and _bare_ahead(sentences):
        raise Unclear


def _bare_ahead(sentences: Sequence[Sequence[Piece]]) -> bool:
    """Whether a sentence without a verb stands before one with a command."""
    said = [_mood(sentence) for sentence in sentences if _states(sentence)]
    return "open" in said and "do" in said[said.index("open") :]


def _at_joints(sentence: Sequence[Piece]) -> Iterator[list[Piece]]:
    part: list[Piece] = []
    for piece in sentence:
        if piece.kind in ("join", "comma", "that"):
            yield part
            part = []
            if piece.kind == "that":
                return  # behind it stands what shall come about
        else:
            part.append(piece)
    yield part


def _mood(part: Sequence[Piece]) -> str:
    """Whether something is asked for in a part of a sentence, or told, or neither."""
    kinds = [piece.kind for piece in part]
    for n, piece in enumerate(part):
        if piece.kind in ("keep", "swap", "take") or (piece.kind == "be" and piece.value == "do"):
            return "do"
        if piece.kind == "be" and piece.value == "make":
            return "do" if _NAMES.isdisjoint(kinds[:n]) else "is"
        if piece.kind == "be":
            return "is"
        if piece.kind == "there":
            return "is" if {"rel", "place", "mutual", "aside"} & set(kinds) else "open"
    return "open"


def _sentence(pieces: Sequence[Piece], at: int) -> Iterator[tuple[Statement, ...]]:
    """Every way to read a sentence."""
    for statements, end in _clause(pieces, at):
        if end == len(pieces):
            yield statements
        elif behind := _joint(pieces, end):
            for rest in _sentence(pieces, behind):
                yield (*statements, *rest)


def _joint(pieces: Sequence[Piece], at: int) -> int:
    """The end of what binds two clauses, or 0."""
    end = at
    while end < len(pieces) and pieces[end].kind in ("comma", "join", "that"):
        end += 1
    return end if end > at else 0


def _verb(pieces: Sequence[Piece], at: int) -> int:
    """The end of verbs that tell of no relation themselves."""
    while at < len(pieces) and pieces[at].kind == "be":
        at += 1
    return at


def _kind(pieces: Sequence[Piece], at: int) -> str:
    return pieces[at].kind if at < len(pieces) else ""


def _lists(pieces: Sequence[Piece], at: int) -> Iterator[tuple[tuple[Piece, ...], int]]:
    """Names from a place on: one, "A and B", "A, B and C"."""
    if _kind(pieces, at) not in _NAMES:
        return
    named, end = [pieces[at]], at + 1
    yield (pieces[at],), end
    while _kind(pieces, end) == "comma" and _kind(pieces, end + 1) in _NAMES:
        named.append(pieces[end + 1])
        end += 2
    end += _kind(pieces, end) == "comma" and len(named) > 1
    if _kind(pieces, end) == "join" and pieces[end].words in ("and", "plus", "as well as") and _kind(pieces, end + 1) in _NAMES:
        yield (*named, pieces[end + 1]), end + 2


def _clause(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """Every way to read a clause."""
    introduced = _kind(pieces, at) in ("there", "take")
    start = _verb(pieces, at + 1 if introduced or _kind(pieces, at) == "have" else at)
    keeps = _kind(pieces, start) == "keep"
    for named, end in _lists(pieces, start + keeps):
        if keeps:
            if _kind(pieces, end) == "stay":
                yield (Statement(named, "stay"),), end + 1
            continue
        if end == len(pieces) and start == at + introduced or introduced or _kind(pieces, end) == "that" or start > at:
            yield (Statement(named, "named"),), end
        yield from _of(pieces, named, end)
    if not introduced:
        yield from _ahead(pieces, start)
        yield from _of_two(pieces, start)


def _of(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """What is said of names that stand ahead, one thing after the other."""
    for statements, end in _said(pieces, named, at):
        yield statements, end
        behind = _joint(pieces, end)
        if behind and not any(piece.kind == "that" for piece in pieces[end:behind]) and _kind(pieces, behind) not in _NAMES:
            denied = any(statement.denied for statement in statements)
            for more, last in _of(pieces, named, behind):
                if not denied or all(statement.denied for statement in more):
                    yield (*statements, *more), last


def _said(pieces: Sequence[Piece], named: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """One thing that is said of names that stand ahead."""
    start = _verb(pieces, at)
    denied = _kind(pieces, start) == "not"
    start = _verb(pieces, start + denied)
    kind, piece = _kind(pieces, start), pieces[start] if start < len(pieces) else None
    if piece is None:
        return
    if kind in ("mutual", "place", "aside", "elsewhere"):
        yield (Statement(named, kind, piece.value or "", denied=denied),), start + 1
    if kind == "keep" and not denied:
        stays = start + 1
        if _kind(pieces, stays) == "stay":
            yield (Statement(named, "stay"),), stays + 1
    if kind == "stay" and not denied and piece.words.startswith(("stay", "remain")):
        yield (Statement(named, "stay"),), start + 1
    if kind == "have":
        for other, end in _lists(pieces, start + 1):
            yield from _beside(pieces, named, other, end)
    if kind != "rel":
        return
    for objects, end in _lists(pieces, start + 1):
        stated = Statement(named, "rel", piece.value, objects, denied)
        if _kind(pieces, end) == "aside" and isinstance(piece.value, Relation) and piece.value.phrase.endswith("next to"):
            yield (replace(stated, beside=pieces[end].value.phrase),), end + 1
            continue
        yield (stated,), end
        if _kind(pieces, end) == "have" or (_kind(pieces, end) == "comma" and _kind(pieces, end + 1) == "have"):
            yield from _with(pieces, stated, end + (_kind(pieces, end) == "comma"))
        if _kind(pieces, end) == "rel" and len(objects) == 1 and _piled(piece, pieces[end]) and not denied:
            for more, last in _said(pieces, objects, end):
                yield (stated, *more), last


def _piled(one: Piece, other: Piece) -> bool:
    """Whether two relations go on one from the other: "red on blue on green"."""
    return all(isinstance(p.value, Relation) and p.value.phrase in ("on", "on top of") for p in (one, other))


def _with(pieces: Sequence[Piece], stated: Statement, at: int) -> Iterator[Parse]:
    """ "..., with the blue one on top", "... with a gap of 3 cm between them" behind a statement."""
    for other, end in _lists(pieces, at + 1):
        for statements, last in _said(pieces, other, end):
            if all(s.how in ("aside", "place") or _points(s) for s in statements):
                yield (stated, *statements), last
    for statements, last in _of_two(pieces, at + 1):
        yield (stated, *statements), last


def _points(statement: Statement) -> bool:
    return any(piece.kind in ("it", "they") for piece in statement.objects)


def _beside(pieces: Sequence[Piece], named: tuple[Piece, ...], other: tuple[Piece, ...], at: int) -> Iterator[Parse]:
    """ "A has B on its left": what is said of the second stands to the first."""
    for statements, last in _said(pieces, other, at):
        (first, *more) = statements
        if len(named) == 1 and not more and first.how == "aside":
            yield (replace(first, how="rel", objects=named, what=first.what),), last
        if len(named) == 1 and not more and first.how == "rel" and [p.kind for p in first.objects] == ["it"]:
            yield (replace(first, objects=named),), last


def _ahead(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """What is said of names that stand behind: "on the mat there is a red block"."""
    kind, first = _kind(pieces, at), pieces[at] if at < len(pieces) else None
    if first is None:
        return
    told: list[tuple[Statement, int]] = []
    if kind in ("place", "aside"):
        told = [(Statement((), kind, first.value, ahead=True), at + 1)]
    if kind == "rel":
        told = [(Statement((), "rel", first.value, objects, ahead=True), end) for objects, end in _lists(pieces, at + 1)]
    for statement, end in told:
        start = end + (_kind(pieces, end) == "comma")
        start = _verb(pieces, start + (_kind(pieces, start) == "there"))
        for named, last in _lists(pieces, start):
            yield (replace(statement, subjects=named),), last


def _of_two(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """What two things are to each other, where it stands ahead of them."""
    kind, first = _kind(pieces, at), pieces[at] if at < len(pieces) else None
    if first is None or kind not in ("apart", "gap", "between", "swap"):
        return
    for named, end in _lists(pieces, at + 1):
        if kind in ("apart", "gap"):
            yield (Statement(named, "mutual" if kind == "apart" else "gap", first.value),), end
        if kind == "swap":
            yield (Statement(named, "mutual", "swap places"),), end
            if _kind(pieces, end) == "have" and pieces[end].words == "with":
                for other, last in _lists(pieces, end + 1):
                    yield (Statement((*named, *other), "mutual", "swap places"),), last
        if kind == "between" and _kind(pieces, end) == "measure":
            far = pieces[end].value
            apart = first.value == "apart"
            yield (Statement(named, "mutual" if apart else "gap", f"be {far} apart" if apart else far),), end + 1


def _plain(statement: Statement, things: Things) -> str:
    """A statement in plain words, without its full stop; nothing where it only names things.

    Raises:
        Unclear: it is not clear what it is about, or it cannot be so.
    """
    relation = statement.what if isinstance(statement.what, Relation) else None
    if statement.ahead:
        objects = things.objects(statement.objects, ())
        subjects = things.subjects(statement.subjects, objects)
    else:
        subjects = things.subjects(statement.subjects, ())
        objects = things.objects(statement.objects, subjects)
    if statement.how == "named":
        return ""
    if statement.how == "aside" and relation:
        objects = things.beside(subjects, statement)
    if any(known.patch for known in subjects) and statement.how != "mutual":
        raise Unclear
    things.use(*subjects, *objects)
    must = "must not" if statement.denied else "must"
    them = _listed(subjects)
    if statement.how == "stay":
        if any(known.part for known in subjects):
            raise Unclear
        return f"{them} must stay where {'it is' if _single(subjects) else 'they are'}"
    if statement.how == "place":
        return f"{them} {must} be {statement.what}"
    if statement.how == "elsewhere":
        return f"{them} must not be on {things.only_patch().name}"
    if statement.how in ("mutual", "gap"):
        if sum(known.count for known in subjects) != 2 or any(known.part for known in subjects):
            raise Unclear
        if statement.how == "gap":
            return f"There must be a gap of {statement.what} between {them}"
        return f"{them} {must} {statement.what}"
    if relation is None:
        raise Unclear
    return _related(statement, relation, subjects, objects)


def _related(statement: Statement, relation: Relation, subjects: list[Known], objects: list[Known]) -> str:
    """A statement of a relation in plain words.

    Raises:
        Unclear: things stand to themselves, or not all of them can.
    """
    if {known.look for known in subjects if not known.part} & {known.look for known in objects}:
        raise Unclear
    many = sum(known.count for known in subjects), sum(known.count for known in objects)
    if relation.count and many[1] != relation.count:
        raise Unclear
    on_patch = relation.phrase in ("on", "on top of", "off") and any(known.patch for known in objects)
    if on_patch and (len(objects) > 1 or relation.turned):
        raise Unclear
    flat = on_patch or "of" in relation.phrase.split() and not relation.phrase.endswith("top of")
    if not flat and max(many) > 1 and not _may_be_many(relation, many):
        raise Unclear
    if statement.denied and (max(many) > 1 or relation.phrase == "off"):
        raise Unclear
    if relation.turned:
        subjects, objects = objects, subjects
    denied = statement.denied or relation.phrase == "off"
    phrase = "on" if on_patch else "on top of" if relation.phrase in ("on", "off") else relation.phrase
    be = "" if phrase == "touch" else "be "
    beside = f" on its {statement.beside.split()[-2]}" if statement.beside.endswith(("left of", "right of")) else ""
    if statement.beside and not beside:
        raise Unclear
    return f"{_listed(subjects)} must {'not ' if denied else ''}{be}{phrase} {_listed(objects)}{beside}"


def _may_be_many(relation: Relation, many: tuple[int, int]) -> bool:
    """Whether a relation may hold of several things at once: one between two, several that touch one."""
    if relation.count:
        return many[0] == 1
    return min(many) == 1 and max(many) == 2 and relation.phrase in ("touch", "next to", "in front of", "behind")


def _single(subjects: Sequence[Known]) -> bool:
    return len(subjects) == 1 and subjects[0].count == 1


def _listed(things: Sequence[Known]) -> str:
    names = [known.name for known in things]
    return " and ".join([*([", ".join(names[:-1])] if len(names) > 1 else []), names[-1]])


def _text(things: Things, stages: list[list[str]]) -> str:
    """All of it: what there is, then what must be so."""
    said = [text for stage in stages for text in stage]
    if len(stages) == 1:
        return " ".join([things.told, *(f"{text[0].upper()}{text[1:]}." for text in dict.fromkeys(said))])
    order = [" and ".join(stage) for stage in stages]
    if not all(order):
        raise Unclear
    return " ".join([things.told, *(f"{'Then' if n else 'First'}, {text}." for n, text in enumerate(order))])
