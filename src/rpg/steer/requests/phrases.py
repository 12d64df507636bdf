"""What noun phrases of an edit bring in: new objects, kinds of block, distractors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from rpg.steer.requests.language import Parser, adjectives, label_list, lexicon, loc, longest, m, noun_phrase

PLACED = {
    f"{at} {where}": rank
    for at in ("at the", "on the", "at the very", "on the far")
    for where, rank in (
        ("top", "top"), ("bottom", "bottom"), ("base", "bottom"), ("left", "left"), ("right", "right"),
        ("left end", "left"), ("right end", "right"), ("front", "front"), ("back", "back"),
    )
} | {"on top": "top", "in the middle": "middle", "in the center": "middle", "underneath": "bottom"}  # fmt: skip
"""Where a block is in its line, said after it."""
HEADLESS = {"top": "top", "bottom": "bottom", "base": "bottom", "middle": "middle", "foundation": "bottom"}
"""Places in a tower that stand for the block there."""


def things(p: Parser, i: int) -> Iterator[tuple[m.Meaning, int]]:
    """Noun phrases, symbols before what describes their cube, and distractors by that name alone."""
    yield from noun_phrase(p, i)
    if j := longest(p, i, "everything | all blocks | all the blocks | everything that is | all that is"):
        for where, k in loc(p, j):
            condition = (where,) if isinstance(where, m.Loc) else ()
            every = m.Noun(head="block", det="all", plural=True, conditions=condition, span=p.span(i, k))
            if condition:
                yield every, k
    if j := longest(p, i, "something | anything | some block that is | one that is"):
        for marks, k in adjectives(p, j):
            yield (m.Noun(head="block", det="a", amount=m.Amount(1, 1), traits=m.Traits(**marks), span=p.span(i, k)), k)
    yield from _symbol_first(p, i)
    j = longest(p, i, "all the | the | all | any | these | those") or i
    number = 1 if p.one(i, frozenset({"a", "an"})) else p.number(i)
    k = j if j > i else i + 1 if number is not None else i
    k = longest(p, k, ("more", "extra", "random")) or k
    word = p.words[k] if k < p.end else ""
    if word in ("distractor", "distractors", "extras"):
        amount = None if number is None else m.Amount(number, number)
        det = "the" if j > i else "bare" if number is None else "a" if number == 1 else "bare"
        traits = m.Traits(extra=True)
        plural = word.endswith("s")
        yield (
            m.Noun(head="block", det=det, amount=amount, plural=plural, traits=traits, span=p.span(i, k + 1)),
            p.reach(k + 1),
        )


def _symbol_first(p: Parser, i: int) -> Iterator[tuple[m.Meaning, int]]:
    """Phrases such as "a letter 'A' semantic cube", "the 5 blue block"."""
    article = p.words[i] if p.words[i] in ("a", "an", "the", "another") else ""
    j = p.opt(i, article) if article else i
    for (labels, _), k in label_list(p, p.opt(j, "letter", "number", "digit"), True):
        if article in ("a", "an", "another") and p.words[j] in ("letter", "number", "digit") and len(labels) == 1:
            kind = "digit" if labels[0].isdigit() else "letter"
            traits, det = (m.Traits(labels=labels, kind=kind), "another" if article == "another" else "a")
            yield (m.Noun(head="block", det=det, amount=m.Amount(1, 1), traits=traits, span=p.span(i, k)), k)
        for marks, end in adjectives(p, k):
            if marks and "labels" not in marks and p.lex(end, lexicon.BLOCK) is False and len(labels) == 1:
                told = {**marks, "labels": labels, "kind": "digit" if labels[0].isdigit() else "letter"}
                det = {"": "bare", "an": "a"}.get(article, article)
                amount = m.Amount(1, 1) if det in ("a", "another") else None
                noun = m.Noun(head="block", det=det, amount=amount, traits=m.Traits(**told), span=p.span(i, end + 1))
                yield noun, p.reach(end + 1)


def fresh(phrase: m.Meaning) -> bool:
    """Whether a phrase brings in new objects: "a block", "another one", "two more", "some letters"."""
    match phrase:
        case m.Noun():
            counted = phrase.amount is not None and phrase.det in ("bare", "another")
            return phrase.part_of is None and (phrase.det in ("a", "another", "some") or counted or plural_kind(phrase))
        case m.Coord():
            return all(fresh(item) for item in phrase.items)
        case _:
            return False


def labelled(phrase: Any) -> bool:
    """Phrases such as "add letter A": one object, with no article."""
    if isinstance(phrase, m.Coord):
        return all(fresh(item) or labelled(item) for item in phrase.items)
    bare = isinstance(phrase, m.Noun) and phrase.det == "bare" and phrase.part_of is None
    return bare and bool(phrase.traits.labels or phrase.traits.colors or phrase.traits.extra)


def plural_kind(phrase: Any) -> bool:
    """Phrases such as "letters", "coloured blocks": a kind of block rather than certain ones."""
    return isinstance(phrase, m.Noun) and phrase.det in ("bare", "some") and phrase.plural and phrase.amount is None


def subjects(p: Parser, i: int) -> Iterator[tuple[m.Meaning, int]]:
    """Noun phrases, with their place in a line after them, and "the word" for what the cubes spell."""
    for found, j in noun_phrase(p, i):
        yield found, j
        if isinstance(found, m.Noun) and found.det in ("the", "all", "its") and not found.traits.rank:
            for phrase, rank in PLACED.items():
                if k := p.seq(j, phrase):
                    yield (replace(found, traits=replace(found.traits, rank=rank), span=p.span(i, k)), k)
    for word, rank in HEADLESS.items():
        j = longest(p, i, (f"the {word}", f"its {word}", f"the very {word}"))
        if j and p.words[j] != "of" and p.number(j) is None:
            yield (m.Noun(head="block", det="the", traits=m.Traits(rank=rank), span=p.span(i, j)), j)
        if j := longest(p, i, (f"the {word}s", f"both {word}s")):
            yield m.Noun(head="block", det="the", plural=True, traits=m.Traits(rank=rank), span=p.span(i, j)), j
    if j := longest(p, i, "the whole | the entire | all of the | the complete | all the"):
        for found, k in noun_phrase(p, j):
            if isinstance(found, m.Structure):
                yield replace(found, det="the", span=p.span(i, k)), k
    if j := longest(p, i, ("the word", "the text", "the spelling")):
        yield m.Structure(kind="word", det="the", span=p.span(i, j)), j


def old(phrase: m.Meaning) -> bool:
    """Whether a phrase may speak of something that is there: "the tower", "it", "blocks"; not "a tower", "two more"."""
    if isinstance(phrase, m.Structure):
        return phrase.det not in ("a", "bare", "another")
    return not fresh(phrase) or plural_kind(phrase)
