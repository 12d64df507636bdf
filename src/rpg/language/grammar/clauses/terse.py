"""Notes: "blue pile left", "purple block: far left corner", "ROBOT, spelled out in letter blocks"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.all_colored import all_colored
from rpg.language.grammar.clauses.into_groups import into_groups
from rpg.language.grammar.clauses.sorted import ordered
from rpg.language.grammar.clauses.turned import but_turned
from rpg.language.grammar.clauses.wheres import is_where
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.alongside import alongside
from rpg.language.grammar.places.cornered import cornered
from rpg.language.grammar.places.regions import named, named_regions
from rpg.language.grammar.structures.alternation import alternation_alone
from rpg.language.grammar.structures.equations import solved
from rpg.language.grammar.structures.order_told import order_told
from rpg.language.grammar.structures.parted import parted
from rpg.language.grammar.talk.people import WHO
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.bodies import bodies
from rpg.language.grammar.things.labels import digits_of, literal
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import (
    Absolute,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    PartOf,
    Pronoun,
    Quality,
    Spacing,
    Structure,
    Toward,
    Traits,
    Using,
    replace,
)
from rpg.language.phrases import Classes

_READ = Patterns(
    "<person>|<viewer> <may>? then|there|finally? read|see_written|find_written <what>?",
    "make|let|have it|them|the_table|the_row|the_blocks|the_letters say|read|spell <what>?",
    "it|they <may>? say|says|read|reads|spell <what>?",
    "show|display me|us? <what>?",
    "the|our|my word|name|text|inscription is|should_be|must_be|shall_be|to_spell_is|will_be :?",
    classes=Classes(
        {
            **WHO,
            "may": (
                "can|could|should|must|shall|will|may|has_to|have_to|want_to|wants_to|would_like_to|would_love_to|need_to",
                "should|must|shall|will be able_to",
                "am|is|are to|able_to|supposed_to",
            ),
            "what": (
                "the? word|name|number|year|text|inscription|acronym|abbreviation|term|equation|sum|formula|letters",
                "that",
            ),
        }
    ),
)
"""What a word follows that is to be there at the end."""
_SPELT = (
    *(
        f"{lead} {what}"
        for lead in ("with", "in", "out of", "from", "of", "using", "made of", "made from", "made with")
        for what in ("blocks", "cubes", "letter blocks", "letter cubes", "letters")
    ),
    "spelled out", "spelt out", "written out", "spelled", "spelt", "written", "reads", "appears",
    *(
        f"{must} {read}"
        for must in ("must", "should", "shall", "has to", "is to")
        for read in ("read", "be read", "be readable", "be spelled", "be spelt", "be written", "appear")
    ),
    *(f"{there} {read}" for there in ("is", "can be") for read in ("read", "spelled", "spelt", "written")),
)  # fmt: skip
_SAME = "same|equal|identical|matching|like"
_ALIKE = frozenset({*_SAME.split("|"), "each"})
_KINDRED = Patterns(
    f"all? the? {_SAME} color|colors|colored|letter|letters|number|numbers|digits|symbols blocks|cubes|bricks|ones?",
    f"all? the? blocks|cubes|bricks|ones|letters|those of|with|showing|that_have the? {_SAME} "
    "color|letter|number|digit|symbol",
    "each color|letter",
)
_TOGETHER = Patterns(
    "should|must|shall|have_to|has_to|are_to? be|are|go|stay|belong|come? together|in_one_group|in_the_same_group"
)
_APART = Patterns(", and? different|other ones|colors|letters apart|separate", ", no|not mixing|mixed groups?")


_SET_OFF = (",", ":", "so", "such", "with")


@rule
def terse(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """Clauses without a verb."""
    yield from _placed(p, i, mode)
    yield from _place_first(p, i, mode)
    yield from _figure_first(p, i, mode)
    yield from cornered(p, i)
    yield from _patch_first(p, i, mode)
    yield from alongside(p, i)
    yield from _spelt(p, i)
    yield from _solved(p, i)
    yield from kept_clear(p, i)
    yield from _left_empty(p, i)
    yield from _nobody_there(p, i)
    yield from all_colored(p, i)
    yield from into_groups(p, i, mode)
    yield from ordered(p, i)
    yield from order_told(p, i)
    for found, j in alternation_alone(p, i):
        yield Clause(verb="part", adjuncts=(found,), mode="goal", span=p.span(i, j)), j
    if i == 0:
        yield from _laid(p)
    own = [(x, j) for x, j in parted(p, i) if x.attribute != "color"] if p.words[i] not in _SET_OFF else []
    for found, j in own:
        everything = Pronoun(word="everything", span=found.span)
        sort = Clause(verb="sort", lemma="sort", theme=everything, adjuncts=(found,), span=p.span(i, j), cost=1)
        yield sort, j
    gathered = p.any_of(i, ("group", "gather", "sort", "collect", "cluster", "bunch"))
    start = gathered or p.any_of(i, ("let", "put", "keep", "have", "make")) or i
    j = max(_KINDRED.matches(p, start), default=0) if p.anywhere(_ALIKE) else 0
    if j and (k := max(_TOGETHER.matches(p, j), default=j if gathered else 0)):
        k = max(_APART.matches(p, k), default=k)
        everything = Pronoun(word="everything", span=p.span(i, j))
        told = "color" if {*p.words[start:j]} & {"color", "colors", "colored"} else "label"
        by = OrderBy(by="attribute", attribute=told, span=p.span(i, k))
        yield Clause(verb="sort", lemma="sort", theme=everything, adjuncts=(by,), span=p.span(i, k), cost=1), k


def _laid(p: Parser) -> Results[Meaning]:
    """ "Left to right.", "Touching, in rainbow order.": a sentence of its own about the line that was built before."""
    for found, j in adjuncts(p, 0):
        if found and j >= p.end and all(map(_of_a_line, found)):
            yield Clause(verb="part", adjuncts=found, mode="goal", span=p.span(0, j), cost=2), j


def _of_a_line(found: Meaning) -> bool:
    """Directions, spacing, and orders that have a name."""
    if isinstance(found, Loc):
        mutual = getattr(found.landmark, "word", "") == "each other"
        return mutual and not found.negated and found.rel in ("distance", "touching", "side_by_side", "adjacent")
    if isinstance(found, Toward):
        return found.first is not None
    return isinstance(found, Spacing) or (isinstance(found, OrderBy) and not found.items and found.by != "attribute")


@choice
def _placed(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "red pile right", "purple block: far left corner": a part of the table ends the note."""
    for theme, j in noun_phrase(p, i):
        bare = isinstance(theme, Noun) and theme.head == "any" and not (theme.traits.colors or theme.traits.labels)
        if bare or not isinstance(theme, Noun | Structure | Coord) or getattr(theme, "op", "and") == "except":
            continue
        start = p.opt(j, ":", ",")
        if isinstance(theme, Structure) and theme.kind == "L" and p.stands(start, ("corner",)):
            continue  # it has a corner of its own
        for region, k in named(p, start):
            if p.words[k - 1] in _BARE_SIDES and _end_of_line(p, i, j, theme):
                continue
            if k >= p.end or p.words[k] in (",", ";", "and"):
                verb = "build" if isinstance(theme, Structure) else "be"
                place = In(region=region, vague=p.words[k - 1] in _BARE_SIDES, span=p.span(j, k))
                yield Clause(verb=verb, theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, k), cost=3), k


_BARE_SIDES = frozenset({"left", "right", "front", "back"})


def _end_of_line(p: Parser, i: int, j: int, theme: Meaning) -> bool:
    """ "a row of red, white and blue, red left": an end of the line, and no side of the table."""
    if not isinstance(theme, Structure) and p.anywhere(_LINES):
        return True
    words = p.words[i:j]
    commas = [n for n, word in enumerate(words) if word == ","]
    return "and" in words and bool(commas) and commas[-1] > words.index("and")


_LINES = frozenset({"row", "line"})


_AIMS = ("goal", "target", "aim", "mark", "spot", "area", "zone")
"""What a text may begin with that speaks of no patch."""
_NOTHING = ("nothing", "no block", "no blocks", "empty", "stays empty", "nothing on it", "no cube", "none")


@choice
def _patch_first(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "red mat: two red cubes", "on the green mat: nothing": what lies on a patch, behind a colon."""
    on = p.one(i, "on") or i
    for patch, j in simple(p, on):
        goal = p.stands(on, _AIMS) and j == on + 1
        if not isinstance(patch, Noun) or patch.head != "patch" or patch.plural or goal:
            continue
        if not (colon := p.any_of(j, _SIGNS if on > i or patch.det == "each" else _SIGNS_OR_FOR)):
            continue
        figure = on == i and patch.det != "the" and p.words[j - 1] in _FIGURES and not patch.traits.colors
        if figure and "," in p.words[colon:]:
            continue  # "a circle: red, blue, green, white" is one of blocks
        if (end := p.any_of(colon, _NOTHING)) and (end >= p.end or p.words[end] in (",", ";")):
            empty = Quality(traits=Traits(empty=True), span=p.span(colon, end))
            yield Clause(verb="be", theme=patch, adjuncts=(empty,), mode="goal", span=p.span(i, end), cost=1), end
        for theme, k in noun_phrase(p, colon):
            block = isinstance(theme, Noun) and theme.head != "patch"
            if (block or isinstance(theme, Coord | Structure)) and (k >= p.end or p.words[k] in (",", ";", "and")):
                verb = "build" if isinstance(theme, Structure) else "be"
                place = Loc(rel="on", landmark=patch, span=p.span(i, j))
                yield Clause(verb=verb, theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, k), cost=1), k


_SIGNS = (":", "=")
_FIGURES = ("circle", "square", "rectangle")
_SIGNS_OR_FOR = (*_SIGNS, "for", "is for")
_FOR = (
    *_SIGNS_OR_FOR,
    "goes to",
    "belongs to",
    "is reserved for",
    "is meant for",
    "gets",
    "holds",
    "has",
    "contains",
)
"""What stands between a part of the table and what lies there."""


@rule
def _place_first(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "near left corner: the X": what lies in a part of the table, behind a colon."""
    start = p.opt(i, "the")
    for region, j in dict.fromkeys([*named(p, start), *named_regions(p, start)]):
        told = region.endswith("_corner") or p.words[j - 1] in ("half", "side", "edge", "table")
        yield from is_where(p, i, j, In(region=region, span=p.span(i, j)), mode) if told else ()
        colon = p.any_of(j, _FOR) if told else 0
        for theme, k in noun_phrase(p, colon) if colon else ():
            if isinstance(theme, Noun | Coord | Structure) and (k >= p.end or p.words[k] in (",", ";", "and")):
                verb = "build" if isinstance(theme, Structure) else "be"
                place = In(region=region, span=p.span(i, j))
                yield Clause(verb=verb, theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, k), cost=1), k
            for more, end in adjuncts(p, k) if isinstance(theme, Noun) and p.stands(k, ("with",)) else ():
                place = In(region=region, span=p.span(i, j))
                if len(more) == 1 and isinstance(more[0], Absolute) and (end >= p.end or p.words[end] in (",", ";")):
                    said = (place, *more)
                    yield Clause(verb="be", theme=theme, adjuncts=said, mode=mode, span=p.span(i, end), cost=1), end


@rule
def _figure_first(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "in a row with gaps of 2 cm: three yellow cubes": what blocks form, said in front of a colon."""
    for found, j in adjuncts(p, i) if p.stands(i, ("in", "as", "into")) else ():
        colon = p.one(j, ":") if found and isinstance(found[0], Into) else 0
        for theme, k in noun_phrase(p, colon) if colon else ():
            if not isinstance(theme, Noun | Coord) or getattr(theme, "head", "") == "patch":
                continue
            for more, end in adjuncts(p, k):
                said = Clause(verb="arrange", theme=theme, adjuncts=(*found, *more), mode=mode, span=p.span(i, end))
                yield replace(said, cost=1), end


@choice
def _spelt(p: Parser, i: int) -> Results[Meaning]:
    """A word, and that it is spelt."""
    k = max(_READ.matches(p, i), default=0)
    if k and (read := literal(p, k) or digits_of(p, k)) is not None and len(read) > 1:
        word = Structure(kind="word", det="the", letter=read, span=p.span(k, k + 1))
        it = Pronoun(word="it", span=p.span(i, k))
        using = (Using(members=it, span=it.span),) if "it" in p.words[i:k] else ()
        for found, end in adjuncts(p, k + 1):
            yield Clause(verb="spell", theme=word, adjuncts=(*using, *found), span=p.span(i, end), cost=1), end
    text = literal(p, i)
    j = p.any_of(p.opt(i + 1, ","), _SPELT) if text is not None else 0
    if text is None:
        return
    word = Structure(kind="word", det="the", letter=text, span=p.span(i, i + 1))
    noted = Clause(verb="spell", theme=word, span=p.span(i, i + 1), cost=2)
    headed = p.follows(i, (":",)) and i + 1 >= p.end  # "Goal: CAT"
    if len(text) > 1 and text.isalpha() and (headed or any(True for _ in bodies(p, i + 1, noted))):
        yield noted, i + 1
    yield from but_turned(p, i, text, word)
    if not j and (len(text) < 2 or not p.stands(i + 1, ("in", "as", "down", "from", "along"))):
        return
    for found, k in adjuncts(p, i + 1) if not j else ():
        if found and isinstance(found[0], Into | Toward) and k >= p.end:
            yield Clause(verb="spell", theme=word, adjuncts=found, span=p.span(i, k), cost=2), k
    if not j:
        return
    for found, k in adjuncts(p, j):
        yield Clause(verb="spell", theme=word, adjuncts=found, span=p.span(i, k), cost=1), k


_WHOLLY = ("as an equation in blocks", "as an equation in cubes", "in cubes", "in blocks", "as an equation",
           "in an equation", "as a whole equation", "and show the whole equation",
           "and show the equation", "and build the equation", "and show it", "and build it", "and lay it out",
           "and build the whole equation", "and show the result", "and write it out")  # fmt: skip


@choice
def _solved(p: Parser, i: int) -> Results[Meaning]:
    """ "solve 8/2 with blocks": an equation whose result is not said."""
    for text, k in solved(p, i):
        found = Structure(kind="equation", det="the", letter=text, span=p.span(i, k))
        for more, end in adjuncts(p, p.any_of(k, _WHOLLY) or k):
            yield Clause(verb="build", theme=found, adjuncts=more, span=p.span(i, end), cost=1), end


@rule
def about(p: Parser, i: int) -> Results[tuple[Noun, int]]:
    """ "the blue one, put that on ...": what a clause is about, said first, with the position of the clause."""
    for theme, j in simple(p, i):
        if isinstance(theme, Noun) and theme.det == "the" and p.words[j : j + 1] == [","]:
            yield (theme, j + 1), j + 1


def said_of(theme: Noun, found: Meaning) -> Clause | None:
    """`found` with its pronoun as the thing that was said first."""
    if isinstance(found, Clause) and isinstance(found.theme, Pronoun) and found.theme.word in ("it", "that", "this"):
        return replace(found, theme=theme, cost=found.cost + 1)
    return None


_CLEAR = ("clear", "free", "empty", "bare", "vacant", "uncovered", "unoccupied")


_STAYS = (
    "stays", "stay", "remains", "must stay", "should stay", "must be", "should be", "is", "has to be", "has to stay",
    "must remain", "should remain", "shall be", "is to be", "is to stay",
)  # fmt: skip


@choice
def _nobody_there(p: Parser, i: int) -> Results[Meaning]:
    """ "the right half stays empty", "keep the middle of the table free": no block is there."""
    kept = p.any_of(i, ("keep", "leave", "make sure to keep", "make sure to leave"))
    for region, j in named_regions(p, p.opt(kept or i, "the")):
        stays = j if kept else p.any_of(j, _STAYS)
        if stays and (free := p.one(stays, frozenset(_CLEAR))):
            nothing = Noun(head="block", det="no", plural=True, span=p.span(i, free))
            place = In(region=region, span=p.span(i, j))
            yield Clause(verb="be", theme=nothing, adjuncts=(place,), mode="goal", span=p.span(i, free)), free


@choice
def _left_empty(p: Parser, i: int) -> Results[Meaning]:
    """ "yellow patch empty", "everything off the yellow patch": a note that nothing lies there."""
    off = p.any_of(i, ("everything off", "everything away from", "everything gone from"))
    for theme, j in simple(p, off) if off else ():
        if isinstance(theme, Noun) and theme.head == "patch" and (p.words[j] in ("", ",", "and")):
            empty = Quality(traits=Traits(empty=True), span=p.span(i, off))
            yield Clause(verb="be", theme=theme, adjuncts=(empty,), mode="goal", span=p.span(i, j), cost=1), j
    for theme, j in simple(p, i):
        end = p.one(j, frozenset(_CLEAR)) if isinstance(theme, Noun) and theme.head == "patch" else 0
        if end and (p.words[end] in ("", ",", "and")):
            empty = Quality(traits=Traits(empty=True), span=p.span(j, end))
            yield Clause(verb="be", theme=theme, adjuncts=(empty,), mode="goal", span=p.span(i, end), cost=1), end


@rule
def kept_clear(p: Parser, i: int) -> Results[Meaning]:
    """ "keep the zone clear of the red box", "leave the top of the red block free": that nothing lies there."""
    j = p.any_of(i, ("keep", "leave", "make sure to keep", "make sure to leave", "get", "make", "have"))
    for theme, k in noun_phrase(p, j) if j else ():
        place = theme.whole if isinstance(theme, PartOf) and theme.part == "top" else theme
        end = p.one(k, frozenset(_CLEAR))
        if not end or not isinstance(place, Noun | Pronoun):
            continue
        on = Loc(rel="on", landmark=place, span=theme.span)
        nothing = Noun(head="block", det="no", plural=True, span=p.span(k, end))
        yield Clause(verb="be", theme=nothing, adjuncts=(on,), mode="goal", span=p.span(i, end), cost=1), end
        for other, last in noun_phrase(p, p.any_of(end, ("of", "from"))) if p.any_of(end, ("of", "from")) else ():
            yield Clause(verb="be", theme=other, adjuncts=(on,), negated=True, mode="goal", span=p.span(i, last)), last
