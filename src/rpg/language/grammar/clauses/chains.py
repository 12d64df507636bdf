"""Chains of clauses: "and", "then", "or", "before", commas."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.clauses.again import but_that, in_its_turn, there_in_turn
from rpg.language.grammar.clauses.becoming import and_touches
from rpg.language.grammar.clauses.carried_on import carried_on, on_with_it
from rpg.language.grammar.clauses.clauses import clause
from rpg.language.grammar.clauses.dealt import counted_ahead
from rpg.language.grammar.clauses.denials import denies_places, nor_does, nor_there, of_none
from rpg.language.grammar.clauses.done_there import afterthought, done_there
from rpg.language.grammar.clauses.either_side import alternatives, two_sides
from rpg.language.grammar.clauses.links import all_in_one, emphasised, last_of_the_order, linked, told_again, told_of_it
from rpg.language.grammar.clauses.lists import ends_a_list, in_labels, in_list, of_the_list
from rpg.language.grammar.clauses.moves import of_the_same
from rpg.language.grammar.clauses.or_cut import cut_by_or
from rpg.language.grammar.clauses.out_of_these import none_of_the_others, out_of_these
from rpg.language.grammar.clauses.same_letters import same_letters
from rpg.language.grammar.clauses.starts import begun_of, begun_with, still_begun
from rpg.language.grammar.clauses.there import stands_behind, there_too
from rpg.language.grammar.clauses.unless import WORDS as UNLESS
from rpg.language.grammar.clauses.unless import unless
from rpg.language.grammar.clauses.verb_again import verb_again
from rpg.language.grammar.clauses.verbs import gapped, gerund_clause, gerund_single
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.absolutes import STARTING
from rpg.language.grammar.places.borne import and_bears, has_it_too
from rpg.language.grammar.places.relations import of_one_kind
from rpg.language.grammar.things.alike import color_at_last
from rpg.language.grammar.things.bodies import bodies
from rpg.language.grammar.things.inventory import inventory
from rpg.language.grammar.things.listing import looks_told
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.grammar.things.retold import apposed
from rpg.language.grammar.things.spare import spare
from rpg.language.grammar.things.stock import stock
from rpg.language.meaning import (
    Absolute,
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    Structure,
    Traits,
    Using,
    replace,
)

_LEADS = {
    "after": "then",
    "once": "then",
    "as soon as": "then",
    "when": "then",
    "before": "before",
    "while": "and",
    "only when": "then",
    "only once": "then",
    "only after": "then",
    "having": "then",
}
"""What stands before a clause, and how the one behind it follows: then, before it, or at the same time."""
_HAVING = ("you have", "we have", "the robot has", "it has", "the arm has", "having", "they have", "i have")


@rule
def chain(p: Parser, i: int) -> Results[Chain]:
    """Clauses joined by "and", "then", "or", "before", commas."""
    for lead, j in p.standing(i, _LEADS):
        order = _LEADS[lead]
        done = j if lead == "having" else p.any_of(j, _HAVING)
        j = p.opt(j, "you", "that")
        fronts = [*gerund_clause(p, j), *chain(p, j), *(gerund_clause(p, done, ("past", "base")) if done else ())]
        for front, k in fronts:
            for main, end in chain(p, emphasised(p, k)) if k < p.end else ():
                both = (main, front) if order == "before" else (front, main)
                clauses = (*both[0].clauses, *both[1].clauses)
                links = (*both[0].links, "and" if order == "and" else "then", *both[1].links[1:])
                yield Chain(clauses=clauses, links=links, span=p.span(i, end), cost=1), end
    for begun, j in (*begun_with(p, i), *counted_ahead(p, i), *out_of_these(p, i)):
        for main, end in chain(p, j):
            if begun.lemma == "stock" and len(main.clauses) == 1 and of_the_list(p, j, end, main.clauses[0]):
                continue
            told = map(none_of_the_others, main.clauses) if begun.lemma == "stock" else main.clauses
            yield Chain(clauses=(begun, *told), links=("and", *main.links), span=p.span(i, end)), end
    if j := p.one(i, "either"):
        if joined := list(alternatives(p, j)):
            yield from joined
            return
        placed = ((two_sides(p, j, x, k), k, getattr(x.clauses[-1], "adjuncts", ())) for x, k in chain(p, j))
        yield from ((x, k) for x, k, at in placed if "or" in (*x.links, *(getattr(one, "op", "") for one in at)))
    for first, j in clause(p, i):
        yield Chain(clauses=(first,), links=("and",), span=p.span(i, j)), j
        for alike, k in color_at_last(p, j, first) if isinstance(first, Clause) else ():
            yield Chain(clauses=(first, alike), links=("and", "and"), span=p.span(i, k)), k
        yield from _more(p, i, (first,), ("and",), j)


def _more(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], at: int) -> Results[Chain]:
    if len(had) > 16 or at >= p.end:
        return
    yield from _told_of_it(p, i, had, links, at)
    for place, k in done_there(p, at, had, links):
        yield Chain(clauses=(*had, place), links=(*links, "and"), span=p.span(i, k)), k
    for link, j in linked(p, at):
        previous = had[-1] if isinstance(had[-1], Clause) else None
        if previous is not None and previous.negated and link in ("before", "after"):
            continue
        ended = p.words[j - 3] == "and" and previous is not None and previous.verb in _WHOLE_ALONE
        if previous is not None and not previous.adjuncts and not ended and in_list(p, j):
            continue  # unless its last thing was named: "swap red and blue, green stays where it is"
        items = [
            *clause(p, j),
            *(carried_on(p, j, previous) if previous is not None else ()),
            *(and_bears(p, j, previous) if previous is not None and link == "and" else ()),
            *(and_touches(p, j, previous) if previous is not None and link == "and" else ()),
            *(gerund_single(p, j) if link in ("before", "after") else ()),
            *(there_too(p, j, previous) if previous is not None and link == "and" else ()),
        ]
        bare = previous is not None and not previous.adjuncts
        bare = bare and (link == "then" or (link == "and" and p.words[j - 1] in (",", ";")))
        denies = previous is not None and previous.negated and previous.mode == "command" and link == "or"
        for item, k in items:
            if previous is not None and _no_clause(p, j, k, previous, item):
                continue
            item = _of_all_of_them(previous, item) if previous is not None else item
            item = cut_by_or(p, j, previous, item) if link == "or" and previous is not None else item
            if item is None:
                continue
            if denies and isinstance(item, Clause) and item.mode == "command" and not item.negated:
                continue
            if previous is not None and (more := told_again(previous, item)) is not None:
                yield Chain(clauses=(*had[:-1], more), links=links, span=p.span(i, k)), k
                continue
            if bare and isinstance(item, Clause) and item.cost and _adds(p, j, previous, item):
                item = replace(item, cost=item.cost + 2)
            item = _less_likely(previous, verb_again(p, j, previous, item))
            item = same_letters(previous, item) if link in ("or", "then") and previous is not None else item
            item = begun_of(previous, still_begun(p, j, k, previous, item)) if link == "and" else item
            yield from ((found, k) for found in _so_far(p, (i, j, k), (*had, item), (*links, link)))
            yield from _more(p, i, (*had, item), (*links, link), k)
        if previous is not None:
            denied = p.stands(p.opt(at, ","), ("but",)) or (
                p.words[at] == "," and j == at + 1 and _denies_looks(previous)
            )
            for theme, k in noun_phrase(p, j) if link in ("before", "after") or there_in_turn(previous, link) else ():
                said = replace(previous, theme=theme, span=p.span(j, k))
                if (other := in_its_turn(p, k, previous, said) if link == "then" else said) is not None:
                    yield Chain(clauses=(*had, other), links=(*links, link), span=p.span(i, k)), k
            for item, k in gapped(p, j, replace(previous, negated=False) if denied else previous):
                item = _of_all_of_them(previous, item)
                if (told := _meant_again(p, (at, j, k), had, item, link)) is not None:
                    whole, joint = (*_shared(had, told[0], told[1]), told[0]), told[1]
                    yield from ((found, k) for found in _so_far(p, (i, j, k), whole, (*links, joint)))
                    yield from _more(p, i, whole, (*links, joint), k)


def _denies_looks(clause: Clause) -> bool:
    """ "(Three blocks,) none of them blue(, on the mat)": what follows is denied of none of them."""
    looks = clause.negated and isinstance(clause.theme, Pronoun) and bool(clause.adjuncts)
    return looks and all(isinstance(x, Quality) for x in clause.adjuncts)


def _of_all_of_them(previous: Clause, item: Meaning) -> Meaning:
    """ "(Three blocks, none of which is blue), on the mat": all of them are."""
    none = previous.theme if isinstance(previous.theme, Noun) and previous.theme.det == "no" else None
    looks = bool(previous.adjuncts) and all(isinstance(x, Quality) for x in previous.adjuncts)
    same = isinstance(item, Clause) and getattr(item.theme, "word", "") == "same"
    if none is None or none.part_of is None or not looks or not same or not isinstance(item, Clause):
        return item
    return replace(item, theme=none.part_of) if any(isinstance(x, Loc) for x in item.adjuncts) else item


def _meant_again(
    p: Parser, places: tuple[int, int, int], had: tuple[Meaning, ...], item: Meaning, link: str
) -> tuple[Meaning, str] | None:
    """A clause whose verb is that of the one before, and how it is joined to that; None where it is no clause."""
    at, j, k = places
    previous = had[-1]
    if not isinstance(previous, Clause) or (
        link == "or" and [",", "and"] in (p.words[n : n + 2] for n in range(j, k - 1))
    ):
        return None  # "put A on B or C, and D on the mat": a comma parts more than "or" does
    own = cut_by_or(p, j, previous, item) if link == "or" else item
    if own is None:
        return None
    item = same_letters(previous, own) if link in ("or", "then") else _less_likely(previous, own)
    if nor_does(p, j, k, previous, item):
        return None
    same = isinstance(item, Clause) and getattr(item.theme, "word", "") == "same"
    if link == "or" and isinstance(item, Clause) and denies_places(p, previous):
        if not same or p.words[at] == ",":
            return None  # "on the mat but not on B, or on C": is it denied, or the other possibility?
        item, link = nor_there(item), "and"
    neither = link == "or" and (previous.negated or of_none(previous.theme))
    link = "and" if neither and isinstance(item, Clause) and (item.negated or same) else link
    apart = p.words[j - 1] == "," and (apposed(previous, item) or (len(had) == 1 and all_in_one(item)))
    if apart or told_of_it(p, j, k, previous, item) or told_again(previous, item) is not None:
        return None
    return item if p.stands(p.opt(at, ","), ("but",)) else _contrasted(previous, item, link), link


def _so_far(p: Parser, at: tuple[int, int, int], told: tuple[Meaning, ...], links: tuple[str, ...]) -> Iterator[Chain]:
    """What was told up to here, the last clause of it from the second place on."""
    begin, last, end = at
    yield Chain(clauses=told, links=links, span=p.span(begin, end))
    for parted in afterthought(p, last, told[:-1], told[-1]):
        joined = (*links, "and")[: len(told) - 1 + len(parted)]
        yield Chain(clauses=(*told[:-1], *parted), links=joined, span=p.span(begin, end))


_WHOLE_ALONE = ("swap", "stack", "sort", "reverse", "unstack")
"""Verbs that need no more than their blocks."""


def _told_of_it(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], at: int) -> Results[Chain]:
    """What may follow a clause without a word that joins clauses: looks, colours, what a colon brings."""
    yield from _behind_colon(p, i, had, links, colon) if (colon := p.one(at, ":")) else ()
    if (comma := p.one(at, ",")) and isinstance(had[-1], Clause) and (many := _counted(had[-1].theme)):
        for looks, k in looks_told(p, comma):  # "the two cubes touch, blue and yellow"
            if isinstance(looks.theme, Coord) and len(looks.theme.items) == many and not looks.adjuncts:
                yield Chain(clauses=(*had, looks), links=(*links, "and"), span=p.span(i, k)), k
    for those, k in unless(p, at, had[-1]) if p.rarely(UNLESS) else ():
        yield Chain(clauses=(*had[:-1], those), links=links, span=p.span(i, k)), k
    for passed, k in spare(p, p.opt(at, ",")) if p.stands(p.opt(at, ","), ("without",)) else ():
        yield Chain(clauses=(*had, passed), links=(*links, "and"), span=p.span(i, k)), k
    yield from _not_until(p, i, had, links, at) if isinstance(had[-1], Clause) and had[-1].negated else ()
    for told, k in (*bodies(p, at, had[-1]), *on_with_it(p, at, had[-1])):
        whole, joined = (*had, *told), (*links, *("and" for _ in told))
        yield Chain(clauses=whole, links=joined, span=p.span(i, k)), k
        yield from _more(p, i, whole, joined, k)


def _behind_colon(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], colon: int) -> Results[Chain]:
    """What is said in more detail: a clause, or what there is."""
    for item, k in clause(p, colon):
        if (apart := _set_apart(had[-1], item)) is not None:
            yield Chain(clauses=(*had[:-1], apart), links=links, span=p.span(i, k)), k
            yield from _more(p, i, (*had[:-1], apart), links, k)
            continue
        begun = getattr(item, "mode", "") == "start"
        if isinstance(had[-1], Clause) and isinstance(had[-1].theme, Structure) and _mere_colors(item) and not begun:
            continue
        item = begun_of(had[-1], item)
        told = isinstance(had[-1], Clause) and (had[-1].adjuncts or had[-1].lemma in ("tally", "size", "stock"))
        told = told or getattr(item, "mode", "") == "start"
        if isinstance(item, Clause) and told and item.verb != "exist":
            whole = (*had, replace(item, cost=item.cost + 3))
            yield Chain(clauses=whole, links=(*links, "and"), span=p.span(i, k)), k
            if item.mode == "start" or getattr(had[-1], "mode", "") == "start":
                yield from _more(p, i, whole, (*links, "and"), k)
    if isinstance(had[-1], Clause) and had[-1].adjuncts and had[-1].verb != "exist":
        for item, k in looks_told(p, colon):
            yield Chain(clauses=(*had, item), links=(*links, "and"), span=p.span(i, k)), k
    for item, k in (*inventory(p, colon), *stock(p, colon)):
        whole = (*had, item)
        yield Chain(clauses=whole, links=(*links, "and"), span=p.span(i, k)), k
        yield from _more(p, i, whole, (*links, "and"), k)


def _adds(p: Parser, j: int, before: Clause | None, item: Clause) -> bool:
    """ "a tower, red on blue": more of what was told before; but "from a tower, end up with red on blue" is the end."""
    ends = before is not None and before.mode == "start" and item.mode == "goal"
    framed = ends and item.theme is not None and p.char(j, 0) < item.theme.span[0]
    return not isinstance(item.theme, Structure) and not framed


def _set_apart(before: Meaning, item: Meaning) -> Clause | None:
    """ "Separate them: red and blue must be 20 cm apart", "separate A and B: they ...": how far apart they are."""
    told = isinstance(before, Clause) and before.lemma == "separate" and not (before.adjuncts or before.negated)
    if not told or not isinstance(before, Clause) or not isinstance(item, Clause) or item.verb != "be" or item.negated:
        return None
    if not item.adjuncts or not all(isinstance(a, Loc) and a.rel in ("apart", "distance") for a in item.adjuncts):
        return None
    if isinstance(item.theme, Pronoun):
        return None if isinstance(before.theme, Pronoun) else replace(item, theme=before.theme)
    return item if isinstance(before.theme, Pronoun) else None


def _no_clause(p: Parser, j: int, k: int, previous: Clause, item: Meaning) -> bool:
    """Whether what looks like a clause belongs to the one before it."""
    if p.words[j - 1] == "," and (apposed(previous, item) or _mere_time(item)):
        return True
    listed = p.words[j - 1] == "and" and p.tokens[j - 2].word in lexicon.COLOR and in_list(p, j - 2)
    if any(no(p, j, previous, item) for no in (stands_behind, has_it_too, last_of_the_order, of_the_same, but_that)):
        return True
    shape = item.theme if isinstance(item, Clause) else None
    part = listed and isinstance(shape, Structure) and shape.det == "bare"  # "a staircase of red, blue and green steps"
    part = part or (previous.mode == "goal" and in_labels(p, j, previous))
    if part or told_of_it(p, j, k, previous, item) or nor_does(p, j, k, previous, item):
        return True
    if p.any_of(j, STARTING) and isinstance(shape, Noun | Coord) and not getattr(item, "adjuncts", ()):
        return True  # "a row of A, B, C, starting with C": which comes first, and not what there is at the start
    return ends_a_list(p, j, k, previous, item)


def _not_until(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], at: int) -> Results[Chain]:
    """ "do not put red on blue until green is on the mat": afterwards it is put there."""
    *before, last = had
    if not isinstance(last, Clause) or last.verb not in ("place", "stack") or last.mode != "command":
        return
    if not all(isinstance(a, Loc) and a.landmark is not None for a in last.adjuncts) or not last.adjuncts:
        return
    j = p.any_of(p.opt(at, ","), ("until", "before", "until after", "unless and until"))
    for item, k in [*clause(p, j), *gerund_single(p, j)] if j else ():
        if isinstance(item, Clause) and not item.negated:
            whole = (*before, replace(last, negated=False), item)
            yield Chain(clauses=whole, links=(*links, "after"), span=p.span(i, k)), k


def _mere_colors(item: Meaning) -> bool:
    """ "red, white, blue from front to back" behind a colon tells of the structure in front of it."""
    theme = item.theme if isinstance(item, Clause) else None
    listed = theme.items if isinstance(theme, Coord) else (theme,)
    return isinstance(item, Clause) and item.verb == "be" and all(
        isinstance(x, Noun) and x.head == "any" and x.det == "bare" and x.amount is None for x in listed
    )  # fmt: skip


_OTHERS = ("the others", "the rest", "others", "all others", "all the others", "all the rest", "the remaining ones")


def _less_likely(before: Clause | None, item: Meaning) -> Meaning:
    """A clause that is hardly meant: "it should be red, green and blue ..." lists colours, and what stands in a list
    before "which do not matter" does not matter altogether; the others beside a part are a part as well."""
    if before is None or not isinstance(item, Clause):
        return item
    colored = any(isinstance(a, Quality) and a.traits.colors for a in before.adjuncts)
    others = isinstance(item.theme, Pronoun) and item.theme.word in _OTHERS and item.verb == "be"
    told = (*before.adjuncts, *(before.theme.details if isinstance(before.theme, Structure) else ()))
    if others and any(isinstance(x, Absolute) or (isinstance(x, Coord) and x.op == "absolutes") for x in told):
        return replace(item, cost=item.cost + 1)
    idle = bool(item.adjuncts) and all(isinstance(a, Manner) and a.kind == "extra" for a in item.adjuncts)
    return replace(item, cost=item.cost + 2) if idle or (colored and _mere_colors(item)) else item


def _counted(theme: Meaning | None) -> int:
    """How many blocks of no look a phrase speaks of."""
    plain = isinstance(theme, Noun) and theme.head == "block" and theme.traits == Traits() and theme.part_of is None
    amount = theme.amount if plain and isinstance(theme, Noun) and not theme.conditions else None
    return amount.low if amount is not None and amount.low == amount.high and amount.low > 1 else 0


def _contrasted(before: Clause, item: Meaning, link: str) -> Meaning:
    """ "red is not on blue and green on yellow" may deny both or one; "... and green not on yellow" denies both."""
    if not isinstance(item, Clause) or not (before.negated and item.negated) or link != "and":
        return item
    places = [a for a in item.adjuncts if isinstance(a, Loc | In)]
    if places and all(a.negated for a in places):
        bare = tuple(replace(a, negated=False) if isinstance(a, Loc | In) else a for a in item.adjuncts)
        return replace(item, adjuncts=bare)
    return item if isinstance(item.theme, Pronoun) else replace(item, cost=item.cost + 1)


def _shared(had: tuple[Meaning, ...], item: Meaning, link: str) -> tuple[Meaning, ...]:
    """ "spell SOL or SUN in a tower", "on the red or on the blue patch": what is said of the last is said of all."""
    last = had[-1]
    if not isinstance(last, Clause) or not isinstance(item, Clause):
        return had
    if link == "or" and len(last.adjuncts) == len(item.adjuncts) == 1:
        return (*had[:-1], replace(last, adjuncts=(of_one_kind(last.adjuncts[0], item.adjuncts[0]),)))
    if not last.verb == item.verb == "spell" or any(not isinstance(a, Using) for a in last.adjuncts):
        return had
    if last.adjuncts and any(isinstance(a, Using) for a in item.adjuncts):
        return had  # "UP in red letters and DOWN in blue letters"
    own = tuple(a for a in item.adjuncts if not isinstance(a, Using) or not isinstance(a.members, Pronoun))
    return (*had[:-1], replace(last, adjuncts=tuple(dict.fromkeys((*last.adjuncts, *own)))))


def _mere_time(item: Meaning) -> bool:
    """ "..., the blue ones first": by itself this says of nothing where it should be."""
    bare = isinstance(item, Clause) and item.verb == "be" and item.adjuncts
    return bool(bare) and all(isinstance(a, Manner) and a.kind == "time" for a in getattr(item, "adjuncts", ()))
