"""Which sentences tell how things stand at the start, and which ask for something, one after the other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.relations.reading import NAMES

Sentence = Sequence[Piece]
Mood = Literal["is", "must", "do", "open"]
"""It is told that something is so; it must be so; it is to be done; none of that is said."""
_STATING = frozenset({"rel", "place", "mutual", "aside", "width", "within"})


def stages_of(pieces: Sequence[Piece]) -> tuple[list[Sentence], list[list[Sentence]]]:
    """The sentences that tell of the start, and those of each stage behind it.

    Raises:
        Unclear: several sentences may belong to a stage, or it is not clear which of them tell of the start.
    """
    stages: list[list[list[Piece]]] = [[[]]]
    first = False
    for n, piece in enumerate(pieces):
        if piece.kind == "first":
            if any(stages[-1][-1]) or len(stages) > 1:
                raise Unclear
            first = True
        elif piece.kind == "then":
            if not n and piece.words == "finally":
                continue
            if n and pieces[n - 1].kind not in ("stop", "comma", "join") and not piece.words.startswith("and"):
                raise Unclear
            stages.append([[]])
        elif piece.kind == "stop":
            if not n or (pieces[n - 1].kind == "stop" and pieces[n - 1].words != piece.words):
                raise Unclear  # a list of steps
            stages[-1].append([])
        else:
            stages[-1][-1].append(piece)
    found: list[list[Sentence]] = [[trimmed for s in stage if (trimmed := _trimmed(s))] for stage in stages]
    moods = [{mood for sentence in stage for mood in _moods(sentence)} - {"open"} for stage in found]
    if not first and len(found) == 2 and moods[0] == {"is"}:
        return found[0], _checked(found[1:])
    if len(found) > 1:
        if "is" in set().union(*moods):
            raise Unclear  # of what is only told it may be said how it was at the start
        return [], _checked(found)
    if first:
        raise Unclear
    start = _told_of_start(found[0])
    return found[0][:start], [found[0][start:]]


def _checked(stages: list[list[Sentence]]) -> list[list[Sentence]]:
    """Stages of one sentence each, but for things that are only named ahead."""
    if not all(stages) or any(len(stage) > 1 for stage in stages[1:]):
        raise Unclear
    if len(stages) > 1 and (any(states(sentence) for sentence in stages[0][:-1]) or _ends_named(stages)):
        raise Unclear
    return stages


def _ends_named(stages: list[list[Sentence]]) -> bool:
    """Whether "at the end" stands in one of several stages: it may be one more."""
    return any(piece.kind == "end" for stage in stages for sentence in stage for piece in sentence)


def _told_of_start(sentences: Sequence[Sentence]) -> int:
    """How many sentences tell how things stand at the start, before something is to be done.

    Raises:
        Unclear: what is told and what is asked for are mixed in another way.
    """
    moods = [_moods(sentence) for sentence in sentences]
    every = set().union(*moods)
    trivial = [not mood and states(sentence) for mood, sentence in zip(moods, sentences, strict=True)]
    if any(trivial[:1]) and every & {"do", "must"} and "is" not in every:
        return trivial.index(False)
    if "is" not in every or not every & {"do", "must"}:
        if "open" in every and "do" in every and _open_ahead(moods):
            raise Unclear
        return 0
    if "do" not in every and "is" not in moods[0]:
        return 0
    begin = next(n for n, mood in enumerate(moods) if mood & {"do", "must"})
    ahead, behind = set().union(*moods[:begin]), set().union(*moods[begin:])
    if ahead != {"is"} or behind != {"do"}:
        raise Unclear
    return begin


def _open_ahead(moods: Sequence[set[Mood]]) -> bool:
    """Whether a sentence without a verb stands before one with a command: it may tell of the start."""
    return any("open" in mood and "do" in later for n, mood in enumerate(moods) for later in moods[n + 1 :])


def _moods(sentence: Sentence) -> set[Mood]:
    """The moods of the parts of a sentence that say something, but for that something is on the table."""
    if not states(sentence) or _on_table(sentence):
        return {"do"} if _acts(sentence) else set()
    parts = [*_at_joints(sentence)]
    moods = {_mood(part) for n, part in enumerate(parts) if not n or not _on_table(part)}
    there: set[Mood] = {piece.value for piece in sentence if piece.kind == "there"}
    return there if moods == {"open"} and there else moods


def _on_table(part: Sentence) -> bool:
    """Whether a part of a sentence tells only that something is on the table, as things are by themselves, or
    elsewhere."""
    said = [piece for piece in part if piece.kind in _STATING or piece.kind == "elsewhere"]
    return bool(said) and all(p.kind == "elsewhere" or p.words.endswith(("on the table", "on table")) for p in said)


def _acts(sentence: Sentence) -> bool:
    return any(piece.kind in ("keep", "swap", "still") or piece.value in ("make", "stack") for piece in sentence)


def states(sentence: Sentence) -> bool:
    """Whether a sentence says more than which things there are."""
    return not all(
        piece.kind in NAMES | {"join", "comma", "there", "take", "have", "be", "end", "sure", "now"}
        for piece in sentence
    )


def _at_joints(sentence: Sentence) -> Iterator[list[Piece]]:
    part: list[Piece] = []
    for piece in sentence:
        if piece.kind == "sure":
            part.append(piece)
        if piece.kind in ("join", "comma", "that", "sure"):
            yield part
            part = []
            if piece.kind in ("that", "sure"):
                return  # behind it stands what shall come about
        else:
            part.append(piece)
    yield part


def _mood(part: Sentence) -> Mood:
    """The mood of a part of a sentence."""
    kinds = {piece.kind for piece in part}
    for n, piece in enumerate(part):
        if piece.kind in ("keep", "swap", "take", "still"):
            return "do" if piece.kind != "keep" or NAMES.isdisjoint(p.kind for p in part[:n]) else "must"
        if piece.value == "moved":
            return "do"
        if piece.kind == "sure":
            return "must" if piece.value == "must" else "do"
        if piece.value in ("make", "stack"):
            return "do" if NAMES.isdisjoint(p.kind for p in part[:n]) else "is"
        if piece.kind == "be":
            return "must" if piece.value == "must" else "is"
        if piece.kind == "there":
            return ("must" if piece.value == "must" else "is") if _STATING & kinds else "open"
    return "open"


def _trimmed(sentence: Sequence[Piece]) -> Sequence[Piece]:
    """A sentence without what binds it to others."""
    begin, end = 0, len(sentence)
    while begin < end and sentence[begin].kind in ("join", "comma"):
        begin += 1
    while end > begin and sentence[end - 1].kind in ("join", "comma"):
        end -= 1
    return sentence[begin:end]
