"""How single blocks, small lots and patches stand to each other, statement by statement."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise

from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.relations.clauses import sentence_read
from rpg.language.frames.relations.names import THINGS
from rpg.language.frames.relations.pieces import plainer
from rpg.language.frames.relations.reading import NAMES, Statement
from rpg.language.frames.relations.stages import Sentence, stages_of
from rpg.language.frames.relations.things import Known, Things
from rpg.language.frames.relations.verbs import GLUE, MOODS
from rpg.language.frames.relations.words import MUTUAL, PLACES, RELATIONS, Relation

PATTERNS = [*THINGS, *MUTUAL, *RELATIONS, *PLACES, *MOODS, *GLUE]
_MOST = 200
"""More readings than these are not looked at."""
_PLACES = frozenset({"inside", "outside", "off", "from"})
_TRIVIAL = "on the table"
_CLOSE = frozenset({"touch", "next to", "right next to", "near"})


@dataclass(frozen=True)
class Said:
    """What is said in plain words, without its full stop. `sort`: of what kind it is ("side", "close", "on", ...);
    `about`: the things in it; `of`: the first of them; `first`: it was so at the start."""

    text: str
    sort: str
    of: frozenset[str]
    about: frozenset[str]
    denied: bool = False
    first: bool = False


Reading = tuple[Things, list[list[Said]]]


def _check_stock(pieces: Sequence[Piece]) -> None:
    """What is listed first is all there is.

    Raises:
        Unclear: "there are three green blocks. The red block must be on a green one".
    """
    end = next((n for n, piece in enumerate(pieces) if piece.kind == "stop"), len(pieces))
    things = [(n, piece) for n, piece in enumerate(pieces) if piece.kind == "thing" and "color" in piece.named]
    listed = {piece.named["color"] for n, piece in things if n < end}
    for n, piece in things:
        if n > end and piece.named.get("det") == "the" and piece.named["color"] not in listed:
            raise Unclear


def _check_gap(sentence: Sentence) -> None:
    """What is told of a gap behind one pair is told of that.

    Raises:
        Unclear: several pairs are told before: "A left of B and C right of B, 2 cm apart".
    """
    for n, piece in enumerate(sentence):
        behind = n + 1 == len(sentence) or sentence[n + 1].kind not in NAMES
        ahead = [other for other in sentence[:n] if other.kind not in ("have", "comma")]
        several = sum(other.kind == "rel" for other in ahead) > 1 and ahead[-1].kind in ("thing", "it")
        if piece.kind in ("mutual", "width", "apart", "gap") and behind and several:
            raise Unclear


def told(pieces: Sequence[Piece]) -> str:
    """The statements in plain sentences.

    Raises:
        Unclear: they can be read in no way, or in several.
    """
    start, stages = stages_of(plainer([piece for piece in pieces if piece.kind != "glue"]))
    if not {"the block", "the cube"}.isdisjoint(piece.words for piece in pieces):
        raise Unclear  # which one?
    if {"never", "while"} <= {piece.words for piece in pieces}:
        raise Unclear  # only as long as something else is so
    if any(piece.kind == "there" and "only" in behind.named for piece, behind in pairwise(pieces)):
        raise Unclear  # "there are only a red and a blue block": then no other may be spoken of
    if pieces[0].kind == "there":
        _check_stock(pieces)
    readings: list[Reading] = [(Things(), [])]
    for n, stage in enumerate([start, *stages]):
        readings = [(things, [*said, []]) for things, said in readings]
        for sentence in stage:
            if n and any(piece.kind == "now" for piece in sentence):
                raise Unclear  # it is told how things stand, and not asked for
            plain = [piece for piece in sentence if piece.kind not in ("end", "sure", "now")]
            _check_gap(plain)
            if not plain:
                continue
            readings = [told for reading in readings for told in _told_of(plain, *reading, start=not n)][:_MOST]
            if not readings or len(readings) == _MOST:
                raise Unclear
    texts = {_text(things, said) for things, said in readings if things.all_used and not things.unclear}
    if len(texts) != 1:
        raise Unclear
    return texts.pop()


def _told_of(sentence: Sentence, things: Things, said: list[list[Said]], *, start: bool) -> Iterator[Reading]:
    """What is known and said behind a sentence, in each way that it can be read."""
    for statements in sentence_read(sentence):
        known = things.copied()
        try:
            new = [said for statement in statements for said in _plainly(statement, known, start=start)]
        except Unclear:
            continue
        begins = [text for text in new if text.first]
        if begins and (start or len(said) != 2):
            continue  # of a later stage it is not told how things stand at the start
        told = [*said[:-1], [*said[-1], *(text for text in new if not text.first)]]
        yield known, [[*said[0], *begins], *told[1:]] if begins else told


def _plainly(statement: Statement, things: Things, *, start: bool) -> list[Said]:
    """A statement in plain words; nothing where it only names things. What is denied of each of two is two of them.
    `start`: it tells how they stand at the start.

    Raises:
        Unclear: it is not clear what it is about, or it cannot be so.
    """
    said = statement.what.phrase if isinstance(statement.what, Relation) else ""
    on, into = said == "on", said in ("inside", "outside")
    if statement.ahead:
        objects = things.objects(statement.objects, (), on=on, into=into)
        subjects = things.subjects(statement.subjects, objects)
    else:
        subjects = things.subjects(statement.subjects, ())
        objects = things.objects(statement.objects, subjects, on=on, into=into)
    if statement.how == "named":
        return []
    if statement.how == "others":
        subjects = things.left()
        if subjects:
            return [_plain(replace(statement, how="stay"), things, subjects, [], start=start)]
        things.others = True
        return [Said("all other blocks must stay where they are", "others", frozenset(), frozenset())]
    if said in _PLACES:
        return _by_place(statement, said, things, subjects, objects)
    if statement.denied == "each":
        each = replace(statement, denied="not")
        return [_plain(each, things, [subject], objects, start=start) for subject in subjects]
    return [_plain(statement, things, subjects, objects, start=start)]


def _by_place(
    statement: Statement, phrase: str, things: Things, subjects: list[Known], objects: list[Known]
) -> list[Said]:
    """What is said of being inside, outside, off or from something.

    Raises:
        Unclear: it is said of something that one is not inside of, or denied.
    """
    seen = any(thing.part or thing.look in things.seen for thing in subjects)
    if statement.denied or len(objects) > 1 or objects[0].count > 1 or _shown(subjects if phrase == "from" else ()):
        raise Unclear
    if phrase in ("inside", "outside") and not objects[0].patch:
        raise Unclear
    on = replace(statement, what=Relation("on"))
    if phrase == "inside":
        return [_plain(on, things, subjects, objects, start=False)]
    begin = _plain(on, things, subjects, objects, start=True) if phrase in ("off", "from") and not seen else None
    begins = [replace(begin, first=True)] if begin else []
    if phrase == "from":
        return begins
    return [*begins, _plain(replace(on, denied="not"), things, subjects, objects, start=False)]


def _plain(statement: Statement, things: Things, subjects: list[Known], objects: list[Known], *, start: bool) -> Said:
    """What is said of some things to others, in plain words.

    Raises:
        Unclear: it cannot be so.
    """
    if any(known.patch for known in subjects) and statement.how not in ("mutual", "rel", "empty"):
        raise Unclear
    if any(known.part for known in subjects) and (len(subjects) > 1 or (statement.denied and not subjects[0].rest)):
        raise Unclear
    alone = _only(statement)
    things.use(*subjects, *objects, start=start)
    be = f"{'is' if _single(subjects) else 'are'}" if start else f"must {statement.denied} be".replace("  ", " ")
    if start and (statement.denied or statement.how not in ("rel", "place", "mutual")):
        raise Unclear
    if statement.how in ("rel", "mutual", "gap"):
        said = _of_several(statement, subjects, objects, be, start=start)
        if alone and (start or said.text.split(" must ")[0] != _listed(subjects) or said.sort not in ("on", "tight")):
            raise Unclear
        return replace(said, text=f"only {said.text}") if alone else said
    if alone:
        raise Unclear
    them, of = _listed(subjects), frozenset(map(_same, subjects))
    if statement.stacked:
        raise Unclear
    if statement.how == "empty" and any(
        p.value == "block" and p.named.get("noun", "one") == "one" for p in (*statement.subjects,)
    ):
        raise Unclear  # a block, or a patch?
    if statement.how == "empty":
        return Said(things.empty(subjects), "empty", of, of, denied=True)
    if statement.how in ("stay", "within") and any(known.part for known in subjects):
        raise Unclear
    if statement.how == "within":
        return Said(f"{them} must not {statement.what}", "stay", of, of, denied=True)
    if statement.how == "stay":
        text = f"{them} must stay where {'it is' if _single(subjects) else 'they are'}"
        return Said(text, "stay", of, of)
    if statement.how == "elsewhere":
        patch = things.only_patch()
        return Said(f"{them} must not be on {patch.name}", "on", of, of | {patch.look}, denied=True)
    return Said(f"{them} {be} {statement.what}", str(statement.what), of, of, denied=bool(statement.denied))


def _only(statement: Statement) -> bool:
    """Whether it is said only of what it is about.

    Raises:
        Unclear: "only" stands somewhere else.
    """
    only = [piece for piece in (*statement.subjects, *statement.objects) if "only" in piece.named]
    if only and (only != [*statement.subjects] or statement.denied):
        raise Unclear
    return bool(only)


def _of_several(statement: Statement, subjects: list[Known], objects: list[Known], be: str, *, start: bool) -> Said:
    """How several things stand to each other, in plain words.

    Raises:
        Unclear: as many things cannot stand so.
    """
    if isinstance(statement.what, Relation):
        return _related(statement, statement.what, subjects, objects, be)
    if sum(known.count for known in subjects) != 2 or any(known.part for known in subjects):
        raise Unclear
    about, them = frozenset(map(_same, subjects)), _listed(subjects)
    if statement.how == "gap":
        return Said(f"There must be a gap of {statement.what} between {them}", "close", about, about)
    how = statement.what.removeprefix("be ")
    if how == statement.what:
        if start:
            raise Unclear
        be = be.removesuffix(" be")
    tight = how.startswith(("touch", "right next"))
    sort = "swap" if how.startswith("swap") else "tight" if tight else "close"
    return Said(f"{them} {be} {how}", sort, about, about, bool(statement.denied))


def _related(statement: Statement, relation: Relation, subjects: list[Known], objects: list[Known], be: str) -> Said:
    """A statement of a relation in plain words.

    Raises:
        Unclear: things stand to themselves, or not all of them can.
    """
    if relation.turned:
        subjects, objects = objects, subjects
    if {known.look for known in subjects if not known.part} & {known.look for known in objects}:
        raise Unclear
    if any(known.patch for known in subjects) or (relation.turned and _shown(subjects) and not _shown(objects)):
        raise Unclear
    many = sum(known.count for known in subjects), sum(known.count for known in objects)
    on_patch = relation.phrase == "on" and any(known.patch for known in objects)
    if (on_patch and (len(objects) > 1 or statement.stacked)) or (relation.count and many[1] != relation.count):
        raise Unclear
    sort = _sort(relation.phrase)
    if any(known.patch for known in objects) and ((sort == "on" and not on_patch) or relation.inside):
        raise Unclear
    if max(many) > 1 and not on_patch and not _may_be_many(relation, sort, many):
        raise Unclear
    apart = relation.phrase in _CLOSE and many[1] == 1  # denied of several, it is denied of each
    if statement.denied and max(many) > 1 and not apart and not (on_patch and subjects[0].rest):
        raise Unclear
    if statement.stacked and (relation.phrase not in ("on", "on top of") or max(many) > 1):
        raise Unclear
    phrase = "on top of" if relation.phrase == "on" and not on_patch else relation.phrase
    if phrase == "touch":
        be = be.removesuffix(" be")
    if be in ("is", "are") and (phrase == "touch" or (sort == "on" and max(many) > 1 and not on_patch)):
        raise Unclear
    beside = f" on its {statement.beside.split()[-2]}" if statement.beside.endswith(("left of", "right of")) else ""
    if statement.beside and not beside:
        raise Unclear
    of = frozenset(map(_same, subjects))
    about = of | frozenset(map(_same, objects))
    text = f"{_listed(subjects)} {be} {phrase} {_listed(objects)}{beside}"
    return Said(text, "both" if beside else sort, of, about, bool(statement.denied))


def _shown(things: Sequence[Known]) -> bool:
    """Whether a block may carry them as what is shown on it."""
    return any(known.look.startswith(("letter", "number")) for known in things)


def _sort(phrase: str) -> str:
    """Of which kind a relation is."""
    words = phrase.split()
    if "on" in words or {"above", "under"} & set(words):
        return "on"
    if phrase in ("touch", "right next to"):
        return "tight"
    return "side" if words[-1] == "behind" or words[-2:] in (["left", "of"], ["right", "of"], ["front", "of"]) else (
        "between" if "between" in words else "close")  # fmt: skip


def _may_be_many(relation: Relation, sort: str, many: tuple[int, int]) -> bool:
    """Whether a relation may hold of several things at once: one between two, several that touch one, sides."""
    if relation.count:
        return many[0] == 1
    if sort == "side":
        return True
    return min(many) == 1 and max(many) <= (4 if relation.phrase in ("touch", "next to") else 1)


def _same(known: Known) -> str:
    """What things, or some of a lot, are told from others by."""
    return known.part or known.look


def _single(subjects: Sequence[Known]) -> bool:
    return len(subjects) == 1 and subjects[0].count == 1


def _listed(things: Sequence[Known]) -> str:
    names = [known.name for known in things]
    return " and ".join([*([", ".join(names[:-1])] if len(names) > 1 else []), names[-1]])


def _text(things: Things, said: list[list[Said]]) -> str:
    """All of it: what there is, how it stands at the start, then what must be so.

    Raises:
        Unclear: nothing is asked for, or things cannot all be so.
    """
    start, *stages = said
    for stage in (start, *stages):
        _check(stage)
    if not all(stages) or all(s.sort == _TRIVIAL and not s.denied for stage in stages for s in stage):
        raise Unclear
    if things.others and any(known.count > 1 for known in things.known):
        raise Unclear
    told = [*([] if things.others else [things.told]), *(f"At the start, {s.text}." for s in start)]
    if len(stages) == 1:
        plain = dict.fromkeys(s.text for s in stages[0])
        return " ".join([*told, *(f"{text[0].upper()}{text[1:]}." for text in plain)])
    if any(s.denied for stage in stages for s in stage):
        raise Unclear
    order = [" and ".join(s.text for s in stage) for stage in stages]
    return " ".join([*told, *(f"{'Then' if n else 'First'}, {text}." for n, text in enumerate(order))])


def _check(said: Sequence[Said]) -> None:
    """That what is said at one time does not contradict itself, as far as this can be seen here.

    Raises:
        Unclear: it does, or may do.
    """
    for one, other in combinations(said, 2):
        if one.text == other.text:
            continue
        sorts = {one.sort, other.sort}
        if "swap" in sorts and one.about & other.about:
            raise Unclear
        if (one.sort == "stay" and other.of & one.of) or (other.sort == "stay" and one.of & other.of):
            raise Unclear
        if len(one.about) > 1 and one.about == other.about and not _agree(one, other):
            raise Unclear
        if one.of & other.of and len(one.about) == len(other.about) == 1 and not sorts & {_TRIVIAL, "empty"}:
            raise Unclear  # in two places


def _agree(one: Said, other: Said) -> bool:
    """Whether two statements about the same things hold together."""
    by_sort = {one.sort: one, other.sort: other}
    if "on" in by_sort and by_sort.keys() & {"close", "tight", "side"}:
        return by_sort["on"].denied and not all(s.denied for s in (one, other))
    if by_sort.keys() == {"between", "tight"}:
        return not (one.denied or other.denied)
    if "side" in by_sort and by_sort.keys() & {"close", "tight"}:
        return not by_sort["side"].denied
    return by_sort.keys() == {"close", "tight"} and by_sort["tight"].denied and not by_sort["close"].denied
