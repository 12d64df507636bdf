"""Verbs that make one structure of another: reverse, turn into, make it a row, take apart."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjunct, adjuncts
from rpg.language.grammar.clauses.exchanged import exchanged
from rpg.language.grammar.clauses.out_of_line import out_of_line
from rpg.language.grammar.clauses.ranked_anew import PUT, made_first
from rpg.language.grammar.clauses.told_piled import made_piled
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.structures.structures import structure
from rpg.language.grammar.things.amounts import amount
from rpg.language.grammar.things.labels import literal
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.retold import begins_anew, universal
from rpg.language.meaning import (
    Amount,
    At,
    Clause,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    PartOf,
    Pronoun,
    Structure,
    TableTop,
    That,
    Using,
    replace,
)

_NEW_ORDER = ("the order to", "its order to", "their order to", "the order into", "the order of the blocks to")
_ORDER_OF = ("the order of the blocks in", "the order of the cubes in", "the order of", "order of")
_ITS_ORDER = ("its order", "the order", "their order")


def reverse(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "reverse the tower", "reverse the order of the row", "reverse its order"."""
    if p.stands(j, ("alphabetical", "alphabetic", "numerical")):
        return  # "reverse alphabetical row of ..."
    for (theme, _), k in _ordered(p, j):
        for found, end in adjuncts(p, k):
            yield _clause(p, i, end, "reverse", theme, found), end


def _ordered(p: Parser, j: int) -> Results[tuple[Meaning, bool]]:
    """What has an order, and whether this is named: "the tower", "the order of the row", "its order"."""
    if k := p.any_of(j, _ITS_ORDER):
        yield (Pronoun(word="it", span=p.span(j, k)), True), k
    start = p.any_of(j, _ORDER_OF)
    yield from (((theme, start > 0), k) for theme, k in noun_phrase(p, start or j))


def remade(p: Parser, i: int, j: int, sense: str, lemma: str) -> Results[Clause]:
    """ "turn it into a row", "make it a tower", "take the tower apart"."""
    if sense == "turn" and lemma in ("turn", "transform", "convert", "change"):
        yield from _reordered(p, i, j)
        yield from _turned_into(p, i, j)
    if sense == "turn" and lemma in ("turn", "flip"):
        yield from _flipped(p, i, j)
    if lemma in _RESPELLED or sense in ("build", "stack"):
        yield from made_piled(p, i, j)
    if sense == "swap":
        yield from exchanged(p, i, j)
    if lemma in _RESPELLED:
        yield from _respelled(p, i, j)
        yield from _in_new_order(p, i, j)
    if sense in ("build", "spell") and p.stands(j, _WITH):
        yield from _of_these(p, i, j, sense)
    if lemma in ("make", "build"):
        yield from _heightened(p, i, j)
        yield from _straightened(p, i, j)
    if lemma in ("make", *PUT):
        yield from made_first(p, i, j, lemma)
    if lemma == "make":
        for theme, k in noun_phrase(p, j):
            told = isinstance(theme, Pronoun) and theme.word in ("it", "them", "these", "those", "that", "this")
            yield from _listed(p, i, k, theme) if told else ()
            for shape, end in simple(p, p.opt(k, "into")) if told else ():
                if isinstance(shape, Structure):
                    into = Into(structure=shape, span=shape.span)
                    for found, last in adjuncts(p, end):
                        yield _clause(p, i, last, "arrange", theme, (into, *found)), last
    if lemma in ("take", "pull", "break", "knock", "tear"):
        parted = p.one(i + 1, _DOWN)
        for theme, k in noun_phrase(p, parted or i + 1):
            it = isinstance(theme, Pronoun) and lemma in ("knock", "pull")  # "take it down" may be said of one block
            single = not (it or isinstance(theme, Structure))
            if p.words[k if not parted else i + 1] == "down" and single:
                continue
            if end := k if parted else p.one(k, _DOWN):
                for found, last in adjuncts(p, end):
                    yield _clause(p, i, last, "unstack", theme, found), last


_DOWN = ("apart", "down")


def _straightened(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "make the row straight": blocks that are nearly one, in a row."""
    for shape, k in structure(p, j):
        line = isinstance(shape, Structure) and shape.kind in ("row", "line", "column") and is_there(shape)
        for found, end in adjuncts(p, k + 1) if line and p.one(k, ("straight", "even", "neat", "tidy")) else ():
            yield _clause(p, i, end, "build", shape, found), end


_HIGHER = frozenset({"higher", "taller"})


def _heightened(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "make the tower one block higher", "make it taller by two blocks": further blocks go on it."""
    for theme, k in noun_phrase(p, j):
        if not (is_there(theme) and getattr(theme, "kind", "") == "stack") and getattr(theme, "word", "") != "it":
            continue
        higher = p.one(k, _HIGHER)
        by = p.one(higher, "by") if higher else 0
        for many, at in amount(p, by or k) if by or not higher else ((Amount(1, 1), higher),):
            at = p.one(at, lexicon.BLOCK) or (0 if not higher or by else at)
            end = at if higher else p.one(at, _HIGHER) if at else 0
            if not end:
                continue
            span, word = p.span(i, end), p.span(i, i + 1)
            more = Noun(head="block", det="another", amount=many, plural=many.low > 1, span=p.span(k, end))
            on_it = Loc(rel="on", landmark=theme, span=theme.span)
            yield Clause(verb="place", lemma="add", theme=more, adjuncts=(on_it,), span=span, word=word), end


_WITH = frozenset({"with", "using", "from", "out"})


def _of_these(p: Parser, i: int, j: int, sense: str) -> Results[Clause]:
    """ "build with five red blocks a tower", "write with the letter cubes the word DOG": of what, said first."""
    for using, k in adjunct(p, j):
        for theme, end in simple(p, k) if isinstance(using, Using) else ():
            if isinstance(theme, Structure):
                for found, last in adjuncts(p, end):
                    yield _clause(p, i, last, sense, theme, (using, *found)), last


_RESPELLED = frozenset({"turn", "transform", "convert", "change", "rearrange", "arrange", "reorder", "make"})
_INTO_WORD = ("to", "into", "to spell", "into the word", "to the word", "to read", "to say", "to form", "so they spell",
              "so that they spell", "so that it reads", "so it reads", "to make", "to get", "as")  # fmt: skip


def _respelled(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "change it to ACT", "rearrange them into TEN": the letters that are there are to spell this."""
    for theme, k in noun_phrase(p, j):
        into = p.any_of(k, _INTO_WORD)
        text = literal(p, into) if into else None
        letters = isinstance(theme, Noun) and (theme.traits.kind == "letter" or bool(theme.traits.labels))
        word = isinstance(theme, Structure) and theme.kind == "word"
        if text is None or len(text) < 2 or not (isinstance(theme, Pronoun) or letters or word):
            continue
        shape = Structure(kind="word", det="the", letter=text, span=p.span(into, into + 1))
        them = Using(members=theme, span=theme.span)
        for found, end in adjuncts(p, into + 1):
            yield replace(_clause(p, i, end, "spell", shape, (them, *found)), lemma="spell"), end


def _listed(p: Parser, i: int, j: int, theme: Meaning) -> Results[Clause]:
    """ "make it C, B, A": the row or tower that is there, in this order."""
    for items, k in listed(p, j):
        order = OrderBy(by="given", items=items, span=p.span(j, k))
        for found, end in adjuncts(p, k):
            yield _clause(p, i, end, "arrange", theme, (order, *found)), end


def _in_new_order(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "rearrange it to C B A", "change the row into B, A, C"."""
    for theme, k in noun_phrase(p, j):
        known = isinstance(theme, Pronoun) and theme.word in ("it", "them", "this", "that")
        known = known or (isinstance(theme, Structure) and theme.det == "the" and theme.kind in _LINES)
        into = p.any_of(k, _INTO_ORDER) if known else 0
        for found, end in _listed(p, i, into, theme) if into else ():
            if isinstance(found.adjuncts[0], OrderBy) and len(found.adjuncts[0].items) > 1:
                yield found, end


_LINES = ("row", "line", "stack", "column")
_INTO_ORDER = ("to", "into", "as", "to be", "so it reads", "so that it reads", "to the order", "into the order",
               "in the order")  # fmt: skip


def _flipped(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "turn the tower the other way round", "flip the stack over", "turn its order around"."""
    for (theme, order), k in _ordered(p, j):
        if not isinstance(theme, Structure | Pronoun):
            continue
        end = p.any_of(k, _ROUND)
        if order and not end:
            end = p.any_of(k, _OVER) or (k if p.words[i] == "flip" or p.stands(j - 1, _OVER) else 0)
        elif isinstance(theme, Structure) and theme.kind == "stack" and not end:
            end = p.any_of(k, _HEAD_OVER) or (k if p.words[i] == "flip" and (k >= p.end or p.stands(k, _CLOSED)) else 0)
        end, lemma = (end, "reverse") if end else (p.any_of(k, _AROUND), "turn around")
        for found, last in adjuncts(p, end) if end else ():
            yield replace(_clause(p, i, last, "reverse", theme, found), lemma=lemma), last


_ROUND = tuple(f"{the}other way {way}" for the in ("the ", "") for way in ("around", "round", "up"))
_HEAD_OVER = ("over", "upside down", "on its head")
_AROUND = ("around", "round")
_OVER = (*_AROUND, "over", "upside down", "back to front")


def _reordered(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "change the order to B, A, C"."""
    if k := p.any_of(j, _NEW_ORDER):
        yield from _listed(p, i, k, Pronoun(word="it", span=p.span(j, k)))


def _turned_into(p: Parser, i: int, j: int) -> Results[Clause]:
    for theme, k in noun_phrase(p, j):
        if into := p.one(k, "into") if isinstance(theme, Pronoun | Structure) else 0:
            yield from _listed(p, i, into, theme)
        for found, end in adjuncts(p, k):
            if any(isinstance(a, Into) for a in found):
                yield replace(_clause(p, i, end, "arrange", theme, found), lemma="turn into"), end


def _clause(p: Parser, i: int, j: int, verb: str, theme: Meaning, found: tuple[Meaning, ...]) -> Clause:
    return Clause(verb=verb, lemma=verb, theme=theme, adjuncts=found, span=p.span(i, j), word=p.span(i, i + 1))


_OUT_OF = ("out of", "from", "from out of", "away from", "out from", "from within", "from inside")
_OFF_IT = ("from", "off", "off of", "away from", "down from")
_GOING_ON = frozenset({",", "and", "then"})
"""What follows where it is also said where it goes."""
_OFF = ("off", "off again", "off there", "from there", "off from there", "away from there", "off of there", "down",
        "down again", "down from there", "back down", "back off", "away", "away again", "out of there")  # fmt: skip
"""Where something is taken from that was said to be somewhere."""
_AHEAD = frozenset({"off", "away", "down"})
"""What of these may stand behind the verb."""
_CLOSED = frozenset({",", ";", "and", "then", ".", "so", "such"})


def taken_off(p: Parser, i: int, k: int, theme: Meaning, alone: tuple[Meaning, ...]) -> Results[Clause]:
    """What is taken off, and nothing else where it is `alone`: "move only the red one off"."""
    for done, end in _taken_off(p, i, k, theme):
        yield replace(done, adjuncts=(*done.adjuncts, *alone)), end


def _taken_off(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "Take it off": from where it was said to be. "Remove everything from the mat": it is cleared. "Pull the red
    block out of the tower (and put it on top)": where it is at the start."""
    lemma = p.words[i]
    yield from ((replace(found, cost=1), end) for found, end in out_of_line(p, i, k, theme))
    for whole, end in noun_phrase(p, out) if (out := p.any_of(k, _OUT_OF)) else ():
        inside = whole.whole if isinstance(whole, PartOf) else whole
        known = isinstance(inside, Structure) and inside.det in ("the", "its") and not inside.plural
        if (known or isinstance(inside, Pronoun)) and p.stands(end, _GOING_ON):
            source = Using(members=whole, lead="out of", span=p.span(k, end))
            span, word = p.span(i, end), p.span(i, i + 1)
            yield Clause(verb="pick", lemma=lemma, theme=theme, adjuncts=(source,), span=span, word=word), end
    for whole, end in structure(p, out) if (out := p.any_of(k, _OFF_IT)) and lemma != "pick" else ():
        whole_tower = isinstance(whole, Structure) and whole.kind == "stack" and is_there(whole)
        if (
            whole_tower
            and not universal(theme)
            and not p.stands(end, _GOING_ON)
            and not (lemma == "take" and p.words[k] == "off")
        ):
            off = Loc(rel="off", landmark=whole, span=p.span(k, end))
            span, word = p.span(i, end), p.span(i, i + 1)
            yield Clause(verb="use", lemma="take", theme=theme, adjuncts=(off,), span=span, word=word), end
    start = p.any_of(k, ("from", "off", "off of", "out of")) if universal(theme) else 0
    for patch, end in simple(p, start) if start else ():
        if isinstance(patch, Noun) and patch.head == "patch":
            span, word = p.span(i, end), p.span(i, i + 1)
            yield Clause(verb="remove", lemma="clear", theme=patch, span=span, word=word, cost=1), end
    ahead = p.stands(i + 1, _AHEAD)  # "take off the top one"
    end = p.any_of(k, _OFF) or k * ahead
    if end and (end >= p.end or p.stands(end, _CLOSED)):
        there = Pronoun(word="there", span=p.span(k, end) if end > k else p.span(i + 1, i + 2))
        off = Loc(rel="off", landmark=there, span=there.span)
        for so, last in adjuncts(p, end):
            if all(isinstance(a, That) for a in so):
                span, word = p.span(i, last), p.span(i, i + 1)
                done = Clause(verb="place", lemma="put", theme=theme, adjuncts=(off, *so), span=span, word=word)
                yield replace(done, cost=len(so)), last


def is_there(theme: Meaning) -> bool:
    """ "The pile of four": one that is there, where something else is made of it."""
    return isinstance(theme, Structure) and theme.det == "the" and not theme.plural


def read_otherwise(p: Parser, end: int, sense: str, lemma: str, theme: Meaning, found: tuple[Meaning, ...]) -> bool:
    """Whether what stands behind a verb and its theme is read in other ways: "take them apart"."""
    if lemma in ("take", "pull") and isinstance(found[0], Loc) and found[0].rel == "apart":
        return True
    if sense == "use" and is_there(theme) and any(isinstance(x, Into) for x in found):
        return True
    if isinstance(found[0], At) and begins_anew(theme):
        return True
    return sense == "keep" and p.words[end - 1] == "there" and not isinstance(found[-1], Loc)


def of_what_is_there(theme: Meaning, made: Clause) -> Clause | None:
    """ "Use the pile of four to build a tower": it is turned into one."""
    shape = made.theme
    if made.verb != "build" or not is_there(theme) or not isinstance(shape, Structure) or shape.members is not None:
        return None
    into = Into(structure=shape, span=shape.span)
    return replace(made, verb="arrange", lemma="turn into", theme=theme, adjuncts=(into, *made.adjuncts))


def put_down(theme: Meaning, lemma: str, span: Span, word: Span) -> Clause:
    """ "Put the red block down": on the table."""
    table = Loc(rel="on", landmark=TableTop(span=span), span=span)
    return Clause(verb="place", lemma=lemma, theme=theme, adjuncts=(table,), span=span, word=word, cost=1)
