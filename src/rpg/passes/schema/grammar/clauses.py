"""Clauses: commands, states, descriptions, what there is; and chains of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rpg.passes.schema import lexicon
from rpg.passes.schema.grammar.adjectives import adjectives, of_quality
from rpg.passes.schema.grammar.adjuncts import adjunct, adjuncts, direction, manner
from rpg.passes.schema.grammar.core import Parser, Results, rule
from rpg.passes.schema.grammar.frames import COMMAND_FRAMES, FIRST, START_FRAMES, STATE_FRAMES, TAG, THEN
from rpg.passes.schema.grammar.having import having
from rpg.passes.schema.grammar.labels import label_list, literal
from rpg.passes.schema.grammar.lists import listed
from rpg.passes.schema.grammar.nouns import noun_phrase
from rpg.passes.schema.grammar.piled import piled
from rpg.passes.schema.grammar.relations import bounds
from rpg.passes.schema.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Quality,
    Size,
    Structure,
    That,
    Toward,
    Traits,
    Using,
)

_PARTICLES = ("up", "out", "down", "together", "over", "around", "apart", "back", "off", "away", "aside")
_MODALS = frozenset(
    {
        "should",
        "must",
        "shall",
        "will",
        "would",
        "can",
        "could",
        "may",
        "might",
        "need",
        "needs",
        "has",
        "have",
        "ought",
        "does",
        "do",
    }
)
_NOT = frozenset({"not", "never"})
_BE = frozenset({"is", "are", "be", "being", "been", "was", "were"})


@rule
def chain(p: Parser, i: int) -> Results[Chain]:
    """Clauses joined by "and", "then", "or", "before", commas."""
    for lead, late in (("after", False), ("once", False), ("before", True)):
        if j := p.one(i, lead):
            j = p.opt(j, "you", "that")
            fronts = [*gerund_clause(p, j), *chain(p, j)]
            for front, k in fronts:
                for main, end in chain(p, p.one(k, ",") or k) if k < p.end else ():
                    both = (main, front) if late else (front, main)
                    clauses = (*both[0].clauses, *both[1].clauses)
                    links = (*both[0].links, "then", *both[1].links[1:])
                    yield Chain(clauses=clauses, links=links, span=p.span(i, end), cost=1), end
    for first, j in clause(p, i):
        yield Chain(clauses=(first,), links=("and",), span=p.span(i, j)), j
        yield from _more(p, i, (first,), ("and",), j)


def _more(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], at: int) -> Results[Chain]:
    if len(had) > 16:
        return
    for link, j in _link(p, at):
        previous = had[-1] if isinstance(had[-1], Clause) else None
        items = [*clause(p, j), *(gerund_single(p, j) if link in ("before", "after") else ())]
        bare = previous is not None and not previous.adjuncts and link == "and" and p.words[j - 1] in (",", ";")
        for item, k in items:
            if bare and isinstance(item, Clause) and item.cost and not isinstance(item.theme, Structure):
                item = replace(item, cost=item.cost + 2)
            whole = (*had, item)
            yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
            yield from _more(p, i, whole, (*links, link), k)
        if previous is not None:
            denied = p.words[p.opt(at, ",")] == "but" if p.opt(at, ",") < p.end else False
            if link in ("before", "after"):
                for theme, k in noun_phrase(p, j):
                    whole = (*had, replace(previous, theme=theme, span=p.span(j, k)))
                    yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
            for item, k in gapped(p, j, replace(previous, negated=False) if denied else previous):
                whole = (*had, item)
                yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
                yield from _more(p, i, whole, (*links, link), k)


def _link(p: Parser, i: int) -> Results[str]:
    j = p.opt(i, ",", ";")
    if k := p.any_of(j, ("but first", "but before that", "and before that", "but only after")):
        yield "after", p.opt(k, ",")
    elif k := p.any_of(j, THEN):
        yield "then", p.opt(k, ",")
    elif k := p.any_of(j, ("before you", "before the robot", "before")):
        yield "before", k
    elif k := p.any_of(j, ("after",)):
        yield "after", k
    elif k := p.any_of(j, ("or else", "or")):
        yield "or", k
    elif k := p.any_of(j, _ALSO):
        k = p.opt(k, "also", "both")
        yield "and", k
    elif j > i:
        yield "and", j


_ALSO = ("and also", "and make sure that", "and ensure that", "and", "while also", "while", "but also", "but",
    "as well as", "also", "whereas", "&",
         "yet", "although", "though")  # fmt: skip


@rule
def clause(p: Parser, i: int) -> Results[Meaning]:
    """One clause with whatever frame stands before it."""
    for start, mode in _frames(p, i):
        yield from ((piled(found), j) for found, j in _plain(p, start, mode))
        yield from ((piled(found), j) for found, j in _fronted(p, start, mode))


@rule
def _plain(p: Parser, i: int, mode: str) -> Results[Meaning]:
    state = "start" if mode == "start" else "goal"
    if mode in ("command", "any"):
        yield from _command(p, i)
    yield from _gap(p, i)
    yield from _state(p, i, state)
    yield from _exists(p, i)
    yield from _describe(p, i, state)
    yield from having(p, i, state)


@rule
def _fronted(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "from left to right put ...", "on the left of the blue block there is ...", "with six blocks build ..."."""
    for first, j in adjunct(p, i):
        if isinstance(first, Absolute | Size):
            continue
        j = p.opt(j, ",", ":")
        k = p.any_of(j, ("there is", "there are", "there should be", "there must be", "is", "are", "should be",
            "comes", "goes", "sits", "stands", "lies", "go", "you put",
                         "place", "put", "comes then", "come"))  # fmt: skip
        if isinstance(first, Loc | In | At):
            for theme, end in noun_phrase(p, k or j):
                if (
                    isinstance(theme, Noun)
                    and not k
                    and theme.det == "bare"
                    and theme.amount is None
                    and not (theme.traits.colors or theme.traits.labels)
                ):
                    continue
                for more, last in adjuncts(p, end):
                    verb = "build" if isinstance(theme, Structure) else "be"
                    said = Clause(
                        verb=verb,
                        theme=theme,
                        adjuncts=(first, *more),
                        mode="start" if mode == "start" else "goal",
                        span=p.span(i, last),
                        cost=1 if k else 2,
                    )
                    yield said, last
        for found, end in _plain(p, j, mode):
            if isinstance(found, Clause) and found.verb != "exist":
                yield replace(found, adjuncts=(*found.adjuncts, first), span=p.span(i, end), cost=found.cost + 1), end
        if isinstance(first, Toward):
            for items, end in listed(p, j):
                given = OrderBy(by="given", items=items, span=p.span(j, end))
                for more, last in adjuncts(p, end):
                    yield (
                        Clause(
                            verb="arrange", adjuncts=(first, given, *more), mode="goal", span=p.span(i, last), cost=1
                        ),
                        last,
                    )


def _frames(p: Parser, i: int) -> list[tuple[int, str]]:
    """Positions after the polite and framing words at i, with what they leave open."""
    found = [(i, "any")]
    seen = {i}
    for start, mode in found:
        for table, kind in (
            (COMMAND_FRAMES, "command"),
            (STATE_FRAMES, "state"),
            (START_FRAMES, "start"),
            (FIRST, mode),
        ):
            for j in table.matches(p, start):
                if p.words[j - 1] == "next" and p.words[j] == "to":
                    continue
                j = p.opt(j, ",") if table in (FIRST, START_FRAMES) else j
                if j not in seen and len(found) < 40:
                    seen.add(j)
                    found.append((j, kind if mode != "start" else "start"))
    return found


_GAPS = (
    ("gap", "faces"),
    ("space", "faces"),
    ("distance", "centres"),
    ("spacing", "centres"),
    ("separation", "centres"),
)


@rule
def _gap(p: Parser, i: int) -> Results[Meaning]:
    """ "leave a gap of 6 cm between the red and the green block", "the distance between A and B should be 12 cm"."""
    j = (
        p.any_of(
            i,
            (
                "leave",
                "keep",
                "have",
                "put",
                "make",
                "maintain",
                "there should be",
                "there must be",
                "there is",
                "there has to be",
                "there needs to be",
                "leaving",
            ),
        )
        or i
    )
    j = p.opt(j, "a", "an", "the")
    spans: list[tuple[Any, int, str]] = []
    for noun, measure in _GAPS:
        if (k := p.one(j, noun)) and (k := p.one(k, "of")):
            spans += [(b, e, measure) for b, e in bounds(p, k)]
        spans += [
            (b, e, measure)
            for b, k in bounds(p, j)
            if (e := p.any_of(k, (noun, f"of {noun}", f"wide {noun}", f"of free {noun}", f"of empty {noun}")))
        ]
        if (k := p.one(j, noun)) and (k := p.one(k, "between")):
            for theme, end in noun_phrase(p, k):
                end = p.any_of(end, ("is", "should be", "must be", "has to be", "shall be", "be"))
                for (low, high), last in bounds(p, end) if end else ():
                    yield _far_apart(p, i, last, theme, low, high, measure), last
    spans += [(b, e, "faces") for b, e in bounds(p, j)]
    for (low, high), k, measure in spans:
        if m := p.one(k, "between"):
            if centres := p.any_of(m, ("the centers of", "centers of", "the middles of")):
                m, measure = centres, "centres"
            for theme, end in noun_phrase(p, m):
                yield _far_apart(p, i, end, theme, low, high, measure), end


def _far_apart(
    p: Parser, i: int, end: int, theme: Meaning, low: float | None, high: float | None, measure: str
) -> Clause:
    span = p.span(i, end)
    far = Loc(
        rel="distance", landmark=Pronoun(word="each other", span=span), low=low, high=high, measure=measure, span=span
    )
    return Clause(verb="be", theme=theme, adjuncts=(far,), span=span)


@rule
def _command(p: Parser, i: int) -> Results[Meaning]:
    """ "stack the red block on ...", "do not move ...", "never touch ..."."""
    j, negated = i, False
    if k := p.any_of(i, ("do not", "never", "avoid", "do n't", "not")):
        j, negated = k, True
        j = p.opt(j, "ever")
    never = p.words[i : i + 1] == ["never"]
    for lead in ("let", "allow", "have", "make"):
        if negated and (k := p.one(j, lead)):
            for found, end in _state(p, k, "goal"):
                if isinstance(found, Clause):
                    yield _ever(replace(found, negated=True, span=p.span(i, end)), never), end
    if i > 0 and p.words[i - 1] == "by":
        yield from verb_phrase(p, i, ("ing",))
    for found, k in verb_phrase(p, j, ("ing",) if p.words[i : i + 1] == ["avoid"] else ("base",)):
        yield _ever(replace(found, negated=negated, span=p.span(i, k)), never), k


def _ever(found: Clause, never: bool) -> Clause:
    """ "never": at no time, not only at the end."""
    if not never:
        return found
    return replace(found, adjuncts=(*found.adjuncts, Manner(kind="always", span=found.span)))


@rule
def gerund_single(p: Parser, i: int) -> Results[Clause]:
    """ "putting the red block on ..." after "before"."""
    yield from verb_phrase(p, i, ("ing",))


@rule
def verb_phrase(p: Parser, i: int, forms: tuple[str, ...] = ("base",)) -> Results[Clause]:
    """A verb in one of `forms`, its particle, theme and adjuncts."""
    senses = p.lex(i, lexicon.VERB)
    if senses is None or p.tokens[i].kind != "word":
        return
    for sense, lemma, form in senses:
        if form in forms:
            for particle in dict.fromkeys((p.opt(i + 1, *_PARTICLES), i + 1)):
                yield from _with_theme(p, i, particle, sense, lemma)


def _with_theme(p: Parser, i: int, j: int, sense: str, lemma: str) -> Results[Clause]:
    word = p.span(i, i + 1)
    if sense == "spell":
        yield from _spell(p, i, j, lemma)
        return
    if sense == "turn":
        yield from _turn(p, i, j, lemma)
    if sense == "swap":
        j = p.any_of(j, ("the positions of", "the places of", "the locations of", "positions of", "places of")) or j
    for theme, k in noun_phrase(p, j):
        k = p.opt(k, "places", "positions") if sense == "swap" else k
        k = p.opt(
            k, *(("up", "out", "down", "back") if sense in ("pick", "stack", "arrange", "place", "unstack") else ())
        )
        if sense == "use":
            yield from _use(p, i, k, theme)
        if sense in ("keep", "build") and lemma in ("keep", "leave", "make"):
            for marks, end in adjectives(p, k):
                if marks:
                    quality = Quality(traits=Traits(**marks), span=p.span(k, end))
                    yield Clause(verb="be", theme=theme, adjuncts=(quality,), span=p.span(i, end), word=word), end
        after = [(f, e) for f, e in adjuncts(p, k + 1) if f] if p.words[k : k + 1] == [","] else []
        for found, end in [*adjuncts(p, k), *after]:
            yield Clause(verb=sense, lemma=lemma, theme=theme, adjuncts=found, span=p.span(i, end), word=word), end
    if sense in ("stack", "build", "arrange", "sort", "place"):
        for found, end in adjuncts(p, j):
            if found:
                yield Clause(verb=sense, lemma=lemma, adjuncts=found, span=p.span(i, end), word=word, cost=1), end


def _use(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "use eight blocks to form a circle"."""
    j = p.any_of(k, ("to", "and", "in order to", "for"))
    if not j:
        return
    for inner, end in verb_phrase(p, j, ("base", "ing")):
        using = Using(members=theme, span=theme.span)
        yield replace(inner, adjuncts=(using, *inner.adjuncts), span=p.span(i, end)), end


def _spell(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "spell CAT with letter blocks", "spell the word 'ROBOT'", "spell a word"."""
    j = p.opt(j, "out")
    text = literal(p, j)
    themes: list[tuple[Meaning, int]] = []
    if text is not None:
        themes.append((Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1)), j + 1))
    themes += [(t, k) for t, k in noun_phrase(p, j) if isinstance(t, Structure) and t.kind in ("word", "equation")]
    for theme, k in themes:
        for found, end in adjuncts(p, k):
            clause_ = Clause(
                verb="spell", lemma=lemma, theme=theme, adjuncts=found, span=p.span(i, end), word=p.span(i, i + 1)
            )
            yield clause_, end


def _turn(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "turn the A block to face left"."""
    for theme, k in noun_phrase(p, j):
        for side, end in direction(p, k):
            faced = Manner(kind="facing", value=side, span=p.span(k, end))
            for found, last in adjuncts(p, end):
                yield (
                    Clause(
                        verb="turn",
                        lemma=lemma,
                        theme=theme,
                        adjuncts=(faced, *found),
                        span=p.span(i, last),
                        word=p.span(i, i + 1),
                    ),
                    last,
                )


@rule
def gerund_clause(p: Parser, i: int) -> Results[Chain]:
    """ "moving the red block", "touching anything else" after "without" and "while"."""
    for found, j in verb_phrase(p, i, ("ing", "base")):
        yield Chain(clauses=(found,), links=("and",), span=p.span(i, j)), j
        for joint in ("or", "and"):
            if k := p.one(j, joint):
                for more, end in verb_phrase(p, k, ("ing", "base")):
                    yield Chain(clauses=(found, more), links=("and", "and"), span=p.span(i, end)), end


@rule
def gapped(p: Parser, i: int, before: Clause) -> Results[Meaning]:
    """ "... and the green one on the yellow one": the verb of the clause before is meant again."""
    for theme, j in noun_phrase(p, i) if before.adjuncts else ():
        for found, k in adjuncts(p, j):
            if found and not isinstance(found[0], That):
                cost = 2 if before.verb in ("build", "spell", "sort") and not isinstance(theme, Structure) else 0
                yield replace(before, theme=theme, adjuncts=found, span=p.span(i, k), cost=cost), k
    if before.theme is not None and before.verb in ("place", "stack", "be", "arrange", "build"):
        for found, k in adjuncts(p, i):
            if found and isinstance(found[0], Loc):
                it = Pronoun(word="same", span=before.theme.span)
                verb = "be" if before.verb in ("build", "arrange", "stack") else before.verb
                yield replace(before, verb=verb, theme=it, adjuncts=found, span=p.span(i, k), cost=1), k


@rule
def _state(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "the red block is on ...", "both blocks are blue", "the blocks form a circle", "A starts on B"."""
    inverted = p.one(i, _BE)
    asked = p.one(i, _ASKING)
    for theme, j in noun_phrase(p, inverted or asked or i):
        j = p.opt(j, "all", "each", "both", "then")
        k, words = _auxiliaries(p, j)
        negated = bool(words & _NOT)
        if inverted:
            yield from _predicate(p, i, j, theme, mode, False)
            continue
        readings = [*_predicate_after_be(p, i, k, theme, mode, negated), *_subject_verb(p, i, k, theme, mode, negated)]
        for phrase in _STARTS:
            if s := p.seq(k, phrase):
                readings += _predicate(p, i, p.opt(s, "being"), theme, "start", negated)
        for found, end in readings:
            lasting = bool(words & {"never", "always"})
            yield (_ever(found, lasting) if isinstance(found, Clause) else found), end


_ASKING = frozenset({"can", "could", "should", "may", "would", "shall", "must"})
_STARTS = ("starts off", "starts out", "starts", "start", "begins", "begin", "started", "starting", "start off",
    "start out", "initially is", "initially sits",
           "starts the episode")  # fmt: skip
_FILLERS = frozenset(
    {
        "to",
        "also",
        "only",
        "all",
        "always",
        "both",
        "each",
        "ever",
        "end", "ends",
        "gets",
        "get",
        "up",
        "then",
        "still",
        "just",
        "simply",
    }
)
_ADVERBS = frozenset(
    {
        "all",
        "both",
        "each",
        "also",
        "still",
        "now",
        "currently",
        "already",
        "initially",
        "being",
        "originally",
        "be",
        "always",
        "then",
        "only",
        "going",
    }
)


def _auxiliaries(p: Parser, j: int) -> tuple[int, set[str]]:
    words: set[str] = set()
    while j < p.end and p.words[j] in _MODALS | _FILLERS | _NOT:
        if p.words[j] == "up" and p.words[j - 1] not in ("end", "ends", "ending"):
            break
        words.add(p.words[j])
        j = p.reach(j + 1)
    return j, words


def _predicate_after_be(
    p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool
) -> list[tuple[Meaning, int]]:
    if j := p.one(k, _BE):
        if p.words[k] in ("was", "were"):
            mode = "start"
        lasting = False
        while n := p.one(j, _NOT | _ADVERBS) or p.seq(j, "to be"):
            negated = negated or p.words[j] in _NOT
            lasting = lasting or p.words[j] in ("always", "never")
            if p.words[j] in ("currently", "already", "initially", "originally"):
                mode = "start"
            j = n
        readings = list(_predicate(p, i, j, theme, mode, negated))
        return [(_ever(c, lasting) if isinstance(c, Clause) else c, e) for c, e in readings]
    if k < p.end and p.words[k] in lexicon.POSTURE:
        if p.words[k] in ("stay", "stays", "remain", "remains") and (
            still := p.any_of(k + 1, ("put", "untouched", "in place", "unmoved"))
        ):
            manner_ = Manner(kind="stay", span=p.span(k, still))
            return [(Clause(verb="be", theme=theme, adjuncts=(manner_,), mode=mode, span=p.span(i, still)), still)]
        lasting = p.words[k] in ("stays", "stay", "remains", "remain", "staying", "remaining")
        readings = list(_predicate(p, i, p.reach(k + 1), theme, mode, negated))
        return [(_stays(c) if lasting and isinstance(c, Clause) else c, e) for c, e in readings]
    if p.words[k - 1 : k] == ["up"] or any(True for _ in manner(p, k)) or p.words[k - 1 : k] in (["always"], ["never"]):
        return list(_predicate(p, i, k, theme, mode, negated))
    return []


def _stays(found: Clause) -> Clause:
    """ "stays on the patch": there from the start on; "stays empty" is about the end."""
    placed = any(isinstance(a, Loc | In) for a in found.adjuncts)
    return _ever(found, placed)


def _predicate(p: Parser, i: int, j: int, theme: Meaning, mode: str, negated: bool) -> Results[Meaning]:
    senses = p.lex(j, lexicon.VERB)
    for sense, lemma, form in senses or ():
        if form == "past" or (form == "base" and lemma in ("put", "set", "spread", "split")):
            end_particle = p.opt(j + 1, *_PARTICLES) if p.words[j] not in ("put", "placed") else j + 1
            for at_ in dict.fromkeys((j + 1, end_particle)):
                for found, k in adjuncts(p, at_):
                    if (
                        found
                        or sense in ("swap", "stack", "keep")
                        or (negated and lemma in ("move", "touch", "disturb", "shift"))
                    ):
                        yield (
                            Clause(
                                verb=sense,
                                lemma=lemma,
                                theme=theme,
                                adjuncts=found,
                                negated=negated,
                                mode=mode,
                                span=p.span(i, k),
                                word=p.span(j, j + 1),
                            ),
                            k,
                        )
    start = j
    if j < p.end and p.words[j] in lexicon.POSTURE:
        start = p.reach(j + 1)
    for found, k in adjuncts(p, start):
        if found:
            yield (
                Clause(
                    verb="be",
                    theme=theme,
                    adjuncts=found,
                    negated=negated,
                    mode=mode,
                    span=p.span(i, k),
                    word=p.span(j, j + 1),
                ),
                k,
            )
    head = theme.head if isinstance(theme, Noun) else "block"
    for marks, k in adjectives(p, j):
        if set(marks) == {"rank"} and marks["rank"] in ("top", "bottom", "left", "right", "front", "back", "middle"):
            side = At(side=marks["rank"], span=p.span(j, k))
            yield Clause(verb="be", theme=theme, adjuncts=(side,), negated=negated, mode=mode, span=p.span(i, k)), k
        elif marks and "rank" not in marks:
            quality = Quality(traits=Traits(**marks), span=p.span(j, k))
            yield Clause(verb="be", theme=theme, adjuncts=(quality,), negated=negated, mode=mode, span=p.span(i, k)), k
    for marks, k in of_quality(p, j, head):
        quality = Quality(traits=Traits(**marks), span=p.span(j, k))
        yield Clause(verb="be", theme=theme, adjuncts=(quality,), negated=negated, mode=mode, span=p.span(i, k)), k


def _subject_verb(p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool) -> Results[Meaning]:
    """ "the blocks form a ring", "the cubes spell CAT", "the red block touches the blue one", "it faces left"."""
    using = Using(members=theme, span=theme.span)
    for sense, lemma, form in p.lex(k, lexicon.VERB) or ():
        if form in ("base", "s") and lemma in ("form", "make", "spell", "build", "create", "compose"):
            if sense == "spell":
                readings = list(_spell(p, i, k + 1, lemma))
            else:
                readings = [
                    r for r in _with_theme(p, i, k + 1, sense, lemma) if isinstance(r[0].theme, Structure | Coord)
                ]
            for found, end in readings:
                yield replace(found, adjuncts=(using, *found.adjuncts), negated=negated, mode=mode), end
    if (
        j := p.any_of(
            k,
            (
                "swap places",
                "swap positions",
                "trade places",
                "change places",
                "exchange places",
                "switch places",
                "be swapped",
                "exchange positions",
                "swap",
                "switch positions",
            ),
        )
    ) and not negated:
        yield Clause(verb="swap", lemma="swap", theme=theme, mode=mode, span=p.span(i, j)), j
    if j := p.one(k, frozenset({"touch", "touches"})):
        for other, end in noun_phrase(p, j):
            touch = Loc(rel="touching", landmark=other, span=p.span(k, end))
            yield (
                Clause(verb="be", theme=theme, adjuncts=(touch,), negated=negated, mode=mode, span=p.span(i, end)),
                end,
            )
        touch = Loc(rel="touching", landmark=Pronoun(word="each other", span=p.span(k, j)), span=p.span(k, j))
        yield Clause(verb="be", theme=theme, adjuncts=(touch,), negated=negated, mode=mode, span=p.span(i, j)), j
    if j := p.one(k, frozenset({"face", "faces", "point", "points"})):
        for side, end in direction(p, j):
            faced = Manner(kind="facing", value=side, span=p.span(k, end))
            yield (
                Clause(verb="be", theme=theme, adjuncts=(faced,), negated=negated, mode=mode, span=p.span(i, end)),
                end,
            )
    if j := p.one(k, frozenset({"read", "reads", "show", "shows", "say", "says", "spell", "spells"})):
        yield from _reads(p, i, j, theme, mode)
    if j := p.one(k, frozenset({"have", "has"})):
        for traits, end in ((m, e) for m, e in of_quality(p, j - 1, "block")):
            quality = Quality(traits=Traits(**traits), span=p.span(k, end))
            yield Clause(verb="be", theme=theme, adjuncts=(quality,), mode=mode, span=p.span(i, end)), end


def _reads(p: Parser, i: int, j: int, theme: Meaning, mode: str) -> Results[Meaning]:
    using = Using(members=theme, span=theme.span)
    text = literal(p, j)
    if text is not None and len(text) > 1:
        word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
        for found, end in adjuncts(p, j + 1):
            yield Clause(verb="spell", theme=word, adjuncts=(using, *found), mode=mode, span=p.span(i, end)), end
    for (labels, more), k in label_list(p, j, True):
        named = Noun(
            head="block", plural=len(labels) > 1, traits=Traits(labels=labels, open_ended=more), span=p.span(j, k)
        )
        for found, end in adjuncts(p, k):
            yield Clause(verb="read", theme=named, adjuncts=(using, *found), mode=mode, span=p.span(i, end)), end
    for other, k in noun_phrase(p, j):
        if isinstance(other, Structure) and other.kind in ("word", "equation"):
            for found, end in adjuncts(p, k):
                yield Clause(verb="spell", theme=other, adjuncts=(using, *found), mode=mode, span=p.span(i, end)), end


@rule
def _exists(p: Parser, i: int) -> Results[Meaning]:
    """ "there are three red blocks", "there should be a tower ..."."""
    j = p.any_of(
        i,
        (
            "there should be",
            "there must be",
            "there has to be",
            "there will be",
            "there shall be",
            "there needs to be",
            "there should only be",
        ),
    )
    mode = "goal"
    if not j:
        j = p.any_of(i, ("there are already", "there is already", "there are", "there is", "you have", "we have",
            "i have", "you are given", "we are given", "you get",
                         "given are", "here are", "the scene has", "the scene contains", "the table has",
                         "the workspace contains", "the table holds", "there also are",
                         "you start with", "there were", "there was", "the table contains", "on the table there are",
                         "on the table are", "on the table there is"))  # fmt: skip
        mode = "given"
    if not j:
        return
    j = p.opt(j, "also", "exactly", "now", "currently", "initially")
    for theme, k in noun_phrase(p, j):
        for found, end in adjuncts(p, k):
            yield Clause(verb="exist", theme=theme, adjuncts=found, mode=mode, span=p.span(i, end)), end


@rule
def _describe(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "a tower of three green blocks", "three red blocks stacked on ...": a picture of the end."""
    for theme, j in noun_phrase(p, i):
        if isinstance(theme, Pronoun) and theme.word in (
            "it",
            "them",
            "they",
            "that",
            "this",
            "one",
            "each",
            "all",
            "both",
        ):
            continue
        shaped = isinstance(theme, Structure) or (
            isinstance(theme, Coord) and any(isinstance(t, Structure) for t in theme.items)
        )
        for found, k in [
            *adjuncts(p, j),
            *((f, e) for f, e in (adjuncts(p, j + 1) if p.words[j : j + 1] == [","] else ()) if f),
        ]:
            if found or shaped:
                cost = 2 if found and isinstance(found[0], At) else 1
                yield (
                    Clause(
                        verb="build" if shaped else "be",
                        theme=theme,
                        adjuncts=found,
                        mode=mode,
                        span=p.span(i, k),
                        cost=cost,
                    ),
                    k,
                )
        colon = p.opt(p.opt(j, ",", ":"), "all")
        for apposed, k in noun_phrase(p, colon) if colon > j else ():
            if isinstance(apposed, Structure) and apposed.members is None and not shaped:
                for found, end in adjuncts(p, k):
                    into = Into(structure=apposed, span=apposed.span)
                    yield (
                        Clause(
                            verb="arrange", theme=theme, adjuncts=(into, *found), mode=mode, span=p.span(i, end), cost=1
                        ),
                        end,
                    )
        for found_, k in _participle(p, i, p.opt(j, "all", "both", "each", "being"), theme, mode):
            yield found_, k


def _participle(p: Parser, i: int, j: int, theme: Meaning, mode: str) -> Results[Meaning]:
    for sense, lemma, form in p.lex(j, lexicon.VERB) or ():
        if form in ("past", "ing"):
            for at_ in dict.fromkeys((p.opt(j + 1, *_PARTICLES), j + 1)):
                for found, k in adjuncts(p, at_):
                    if found or sense == "stack":
                        yield (
                            Clause(
                                verb=sense,
                                lemma=lemma,
                                theme=theme,
                                adjuncts=found,
                                mode=mode,
                                span=p.span(i, k),
                                word=p.span(j, j + 1),
                                cost=1,
                            ),
                            k,
                        )


def tail(p: Parser, i: int) -> int:
    """The position after closing words that carry nothing ("please", "thanks")."""
    while True:
        j = p.opt(i, ",")
        k = max((m for m in TAG.matches(p, j)), default=0)
        if not k:
            return i
        i = k
