"""Requests that add objects, put them somewhere, or remove them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.blocks.traits import VOWELS
from rpg.steer.places import given_up, place, places
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, colors, label_list, longest, m, noun_phrase, phrases, simple
from rpg.steer.requests.phrases import fresh, labelled, old, plural_kind, subjects, things

ADD = frozenset(
    {"add", "include", "insert", "append", "introduce", "attach", "bring", "throw", "pop", "stick", "slide", "slip"}
    | {"squeeze", "wedge", "slot", "toss", "sneak", "squish"}
)


PUT = frozenset(
    {"put", "place", "stack", "set", "lay", "position", "drop", "move", "bring", "shift", "transfer", "relocate"}
    | {"slide", "stick", "push", "pop", "lift", "send"}
)


_UNWANTED = phrases(
    "i do not want | i do not need | i no longer want | i no longer need | we do not need | we do not want | "
    "there should be no | there should not be | i do not like"
)
_GOES = phrases(
    "can go | should go | must go | has to go | have to go | needs to go | may go | is not needed | has to leave"
)
_ALL_BUT = phrases("all but | everything but | everything except | all except | everything apart from | all apart from")


def _let_go(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "the red one can go", "I don't want the green block any more"."""
    j = longest(p, i, _UNWANTED)
    for theme, k in noun_phrase(p, j) if j else ():
        end = longest(p, k, "any more | anymore | any longer | in it | there | at all") or k
        yield r.Remove(theme=theme, span=p.span(i, end)), end
    for theme, k in noun_phrase(p, i):
        if end := longest(p, k, _GOES):
            yield r.Remove(theme=theme, span=p.span(i, end)), end


def _all_but(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "remove all but the red one", "keep only the red and the blue block"."""
    verb = longest(p, i, REMOVE)
    j = (
        longest(p, verb, _ALL_BUT)
        if verb
        else longest(p, i, "keep only | keep just | only keep | just keep | leave only")
    )
    for theme, k in noun_phrase(p, j) if j else ():
        yield r.Remove(theme=theme, others=True, span=p.span(i, k)), k


REMOVE = phrases(
    "remove | delete | drop | discard | eliminate | lose | omit | leave out | take out | take away | take "
    "off | get rid of | do without | throw away | throw out | ditch | cut | take | pull out | clear away "
    "| exclude"
)


def _only_a_kind(phrase: m.Meaning) -> bool:
    """Phrases such as "letters", "blues": without a verb of adding, they say what blocks are, not that more come."""
    return any(plural_kind(each) for each in (phrase.items if isinstance(phrase, m.Coord) else (phrase,)))


_IDLE = phrases(
    "as a distractor | as distractors | as a distraction | as an extra | as extras | as clutter | to distract | "
    "that plays no role | that play no role | that does nothing | that is not part of the goal | that has no role | "
    "that are not part of the goal | which plays no role | that does not matter | "
    "that do not matter | just lying around "
    "| as a decoy | as decoys | that is not needed | that are not needed"
)


_SOMEWHERE = phrases(
    "to the scene | to the task | to the table | on the table | to the setup | somewhere | somewhere on the table | "
    "in the scene | to it | to this | anywhere | to the side | at the side | off to the side"
)
_IT_GOES = tuple(
    f"{stop} {goes}"
    for stop in (".", ",", ";", ", and", "and", ". and")
    for goes in phrases(
        "it goes | it should go | it should be | it must be | it belongs | put it | place it | set it | it is | "
        "it sits | it stands | it lies | it has to be | it comes"
    )
)
_LIES = phrases(
    "lie around | lies around | lie there | lies there | lie on the table | lies on the table | are lying around | "
    "is lying around | stand around | stands around | are there | is there | serve | serves | are | is | be"
)
_STAYS = phrases(
    "that has to stay where it is | that must stay where it is | that must not be moved | that may not be moved | "
    "that should not be moved | which must not be moved | that has to stay put | that must not move | that stays put | "
    "that stays where it is | that should stay where it is | that nobody may move | not to be moved"
)


def _namely(p: Parser, i: int, theme: m.Meaning) -> Iterator[tuple[m.Meaning, int]]:
    """The phrases that go on from "two distractors": ", a white and a black block"."""
    j = longest(p, i, ", namely | namely | , | :")
    if not j or not isinstance(theme, m.Noun) or not theme.traits.extra or theme.amount is None:
        return
    for listed, k in noun_phrase(p, j):
        items = listed.items if isinstance(listed, m.Coord) else (listed,)
        nouns = [replace(each, traits=replace(each.traits, extra=True)) for each in items if isinstance(each, m.Noun)]
        number = sum(each.amount.low if each.amount else 1 for each in nouns)
        if len(nouns) == len(items) and all(fresh(each) for each in nouns) and number == theme.amount.low:
            yield (m.Coord(op="and", items=tuple(nouns), span=listed.span) if len(nouns) > 1 else nouns[0]), k


def _idle(p: Parser, i: int, theme: m.Meaning) -> Iterator[tuple[m.Meaning, int]]:
    """Phrases that go on with "as a distractor", "lie around as distractors"."""
    end = longest(p, longest(p, i, _LIES) or i, _IDLE)
    items = theme.items if isinstance(theme, m.Coord) and theme.op == "and" else (theme,)
    nouns = [replace(each, traits=replace(each.traits, extra=True)) for each in items if isinstance(each, m.Noun)]
    if end and len(nouns) == len(items):
        yield (m.Coord(op="and", items=tuple(nouns), span=theme.span) if len(nouns) > 1 else nouns[0]), end


def _further(p: Parser, i: int, told: r.Add) -> Iterator[tuple[r.Request, int]]:
    """What describes a new block after its place: "put one more cube on top, a gray one"."""
    theme = told.theme
    uncoloured = isinstance(theme, m.Noun) and not theme.traits.colors and not theme.traits.scheme
    for (listed, _), end in colors(p, longest(p, i, ", in | in")) if uncoloured and longest(p, i, ", in | in") else ():
        if isinstance(theme, m.Noun) and len(listed) == 1:
            painted = replace(theme, traits=replace(theme.traits, colors=listed))
            yield replace(told, theme=painted, span=(told.span[0], p.span(i, end)[1])), end
    plain = isinstance(theme, m.Noun) and theme.traits == m.Traits() and theme.amount == m.Amount(1, 1)
    for noun, end in noun_phrase(p, longest(p, i, ", namely | ,")) if plain and longest(p, i, ", namely | ,") else ():
        if isinstance(noun, m.Noun) and noun.det == "a" and noun.head in ("block", "any") and not noun.conditions:
            yield replace(told, theme=noun, span=(told.span[0], p.span(i, end)[1])), end


def add(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "add a green block on top of the blue one", "with another red block"."""
    leads = (
        "i would like",
        "i would love",
        "we need",
        "i need",
        "we also need",
        "i also need",
        "we want",
        "let there be",
        "there has to be",
        "how about",
        "what about",
        "there should also be",
        "there should be",
        "there must be",
        "with",
        "give it",
        "have",
    )
    j = p.one(i, ADD) or longest(p, i, leads) or i
    j = longest(p, j, ("in", "back")) or j if j > i else j
    verb = p.words[i] in ADD
    for theme, k in things(p, j):
        if (j == i or p.words[i] == "with") and _only_a_kind(theme):
            continue
        if fresh(theme) or (verb and labelled(theme)):
            if isinstance(theme, m.Noun) and theme.traits.extra and (end := longest(p, k, _SOMEWHERE)):
                yield r.Add(theme=theme, span=p.span(i, end)), end
            for idle, end in _idle(p, k, theme):
                yield r.Add(theme=idle, span=p.span(i, end)), end
            if isinstance(theme, m.Noun) and (end := longest(p, k, _STAYS)):
                yield r.Add(theme=theme, stay=True, span=p.span(i, end)), end
            for listed, end in _namely(p, k, theme):
                yield r.Add(theme=listed, span=p.span(i, end)), end
            for start in (k, p.one(k, "in"), longest(p, k, _IT_GOES)):
                for spots, end in places(p, start) if start else ():
                    if spots or (start == k and (j > i or p.words[i - 1] == "also")):
                        new = r.Add(theme=theme, places=spots, span=p.span(i, end), cost=0 if verb else 2)
                        yield new, end
                        yield from _further(p, end, new)
    if verb and (k := longest(p, j, "the letter | the number | the digit | the symbol | the vowel | the consonant")):
        for (labels, _), n in label_list(p, k, True):
            if p.words[k - 1] in ("vowel", "consonant") and any(
                (each in VOWELS) != (p.words[k - 1] == "vowel") or not each.isalpha() for each in labels
            ):
                continue
            kind = "digit" if labels[0].isdigit() else "letter"
            noun = m.Noun(head="block", det="a", traits=m.Traits(labels=labels, kind=kind), span=p.span(j, n))
            for spots, end in places(p, n) if len(labels) == 1 else ():
                yield r.Add(theme=noun, places=spots, span=p.span(i, end)), end
    yield from _filling(p, i)
    for spots, k in places(p, j) if verb else ():
        for theme, end in things(p, k) if spots else ():
            if fresh(theme):
                yield r.Add(theme=theme, places=spots, span=p.span(i, end), cost=1), end


_FILL = phrases(
    "fill it with | fill it in with | fill the hole with | fill the middle with | fill the center with | "
    "fill the centre with | fill the circle with | fill the square with | fill the ring with | fill the inside with"
)


def _filling(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "fill it with a gray block": into the middle of an outline."""
    j = longest(p, i, _FILL)
    for theme, k in things(p, j) if j else ():
        if isinstance(theme, m.Noun) and fresh(theme) and not theme.plural:
            end = longest(p, k, "in the middle | in the center | in the centre | in its middle | in its center") or k
            yield r.Add(theme=theme, places=(r.Spot(side="middle"),), span=p.span(i, end)), end


def put(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "put a green block on top" adds; "put the green block on top" moves."""
    yield from _belongs(p, i)
    yield from _taken(p, i)
    yield from _with_on_top(p, i)
    j = p.one(i, PUT)
    if not j:
        return
    for theme, k in things(p, j):
        if fresh(theme):
            listed = _listed(theme)
            for where, end in place(p, k) if listed else ():
                yield r.Move(theme=theme, place=where, span=p.span(i, end), cost=1), end
            for spots, end in places(p, k):
                if spots:
                    new = r.Add(theme=theme, places=spots, lacking=listed, span=p.span(i, end))
                    yield new, end
                    yield from _further(p, end, new)
            for lost, n in noun_phrase(p, k + 1) if p.one(k, "where") else ():
                if end := longest(p, n, "was | is | used to be | stands | stood | sits | has been | was before"):
                    yield r.Replace(old=lost, new=theme, span=p.span(i, end)), end
        elif not isinstance(theme, m.Structure) or old(theme):
            for where, end in place(p, k):
                end = given_up(p, end)
                piled = p.words[i] == "stack" and _several(theme)
                yield r.Move(theme=theme, place=where, piled=piled, span=p.span(i, end)), end
                named = labelled(theme) or (getattr(theme, "det", "") == "the" and p.follows(i, ("also",)))
                if isinstance(theme, m.Noun) and named and not theme.plural:
                    yield r.Add(theme=theme, places=(where,), lacking=True, span=p.span(i, end), cost=3), end
    for where, k in place(p, j):
        for theme, end in noun_phrase(p, k):
            if fresh(theme):
                yield (r.Add(theme=theme, places=(where,), span=p.span(i, end), cost=1), end)


def _several(theme: m.Meaning) -> bool:
    """Phrases such as "them", "the red blocks", "the red and the blue one"."""
    several = isinstance(theme, m.Coord | m.Pronoun) and getattr(theme, "word", "") not in ("it", "this", "that")
    return several or (isinstance(theme, m.Noun) and theme.plural)


def _listed(theme: m.Meaning) -> bool:
    """Phrases such as "put D and A ...": symbols without an article, which are those that are there."""
    return isinstance(theme, m.Noun) and plural_kind(theme) and bool(theme.traits.labels)


_BELONGS = phrases(
    "belongs | belong | goes | go | should go | must go | should be | must be | needs to be | has to be | should sit | "
    "should rather be | should rather go | must rather be | should better be | "
    "should come | should move | ought to be | should stand"
)


_GIVING_WAY = frozenset({"belongs", "belong", "goes", "go", "now", "instead", "rather"})


def _belongs(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "the blue one belongs on top"."""
    for theme, j in noun_phrase(p, i):
        k = longest(p, j, _BELONGS)
        k = longest(p, k, "now | instead | rather") or k
        for where, end in place(p, k) if k and not fresh(theme) else ():
            stop = given_up(p, end)
            if (
                isinstance(theme, m.Structure)
                or isinstance(where, r.Spot)
                or stop > end
                or _GIVING_WAY.intersection(p.words[i:end])
            ):
                yield r.Move(theme=theme, place=where, span=p.span(i, stop), cost=1), stop


def _with_on_top(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "with the pink one on top", "the blue one at the bottom": where a block is in its line."""
    j = longest(p, i, "with | and with | but with | having") or i
    for theme, k in noun_phrase(p, j):
        for where, end in place(p, k) if not fresh(theme) else ():
            if isinstance(where, r.Spot) and where.whole is None and where.side != "beside":
                yield r.Move(theme=theme, place=where, span=p.span(i, end), cost=2), end


def _taken(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "take the green block from the top and put it next to the tower"."""
    j = longest(p, i, "take | grab | pick | pick up | lift")
    for theme, k in noun_phrase(p, j) if j else ():
        k = (
            longest(p, k, "from the top | off the top | from the bottom | from the tower | off the tower | from there")
            or k
        )
        n = longest(
            p, k, "and put it | and place it | and move it | and stack it | and set it | and lay it | and stick it"
        )
        for where, end in place(p, n) if n and not fresh(theme) else ():
            yield r.Move(theme=theme, place=where, span=p.span(i, end)), end


def remove(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    yield from _let_go(p, i)
    yield from _all_but(p, i)
    for phrase in (*REMOVE, "leave", "without", "no more", "no"):
        if j := p.seq(i, phrase):
            for theme, k in dict.fromkeys([*things(p, j), *subjects(p, j)]):
                if "apart" in p.words[j:k]:
                    continue  # what is taken apart is still there
                end = longest(p, k, "away | out | off | again") or k
                if from_ := longest(p, end, ("from", "out of", "off")):
                    for whole, stop in simple(p, from_):
                        if isinstance(whole, m.Structure | m.Pronoun | m.TableTop):
                            yield r.Remove(theme=theme, span=p.span(i, stop)), stop
                if phrase not in ("take", "leave") or end > k:
                    yield r.Remove(theme=theme, span=p.span(i, end)), end
