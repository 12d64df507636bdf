"""Clauses whose subject has something: "the red block should have the blue one on it"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.each_has import denied, each_of, is_owner, may_have, said_of_each
from rpg.language.grammar.clauses.shared import all_patches, are_patches
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.absolutes import part_list
from rpg.language.grammar.places.gaps import apart_by
from rpg.language.grammar.places.onto import one_on_another
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.places.two_relations import brought_up
from rpg.language.grammar.structures.along import listed_along
from rpg.language.grammar.structures.sizes import size_phrase
from rpg.language.grammar.structures.structures import structure
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.pronouns import pronoun
from rpg.language.meaning import (
    OWNER,
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Size,
    Spacing,
    Structure,
    TableTop,
    That,
    Toward,
    Traits,
    replace,
)

_HAS = (
    "should have", "must have", "has to have", "needs to have", "shall have", "will have", "has", "have",
    "ends up with", "gets",
    "get", "should get", "needs", "should end up with", "must end up with", "should be left with",
    *(f"{must} {so} have" for so in ("finally", "also")
      for must in ("should", "must", "shall", "has to", "is to", "needs to", "ought to", "will", "is supposed to")),
    "is to have", "wants", "wants to have", "ought to have", "is supposed to have",
    *(f"{must} get" for must in ("must", "shall", "has to", "is to")),
)  # fmt: skip
_GIVE = ("give", "give to")
_IS_FOR = ("is for", "are for", "is reserved for", "is meant for", "is the place for", "takes", "should take", "for")
_SHARE = ("share", "shares", "should share", "must share", "have to share", "are to share", "shall share")
_CARRIES = (
    "is to hold", "are to hold", "holds up", "hold up",
    "should hold up", "must hold up", "has to carry", "has to hold", "has to support",
    "is to carry", "is to support", "needs to carry", "shall carry", "shall hold", "shall support", "shall contain",
    "shall bear", "is carrying", "is supporting", "is holding",
    "should carry", "must carry", "carries", "carry", "should hold", "must hold", "holds", "supports", "should support",
    "must support", "support", "bear", "bears", "should bear", "must contain", "should contain", "contains",
)  # fmt: skip
_NONE = ("none at all", "none")
_OF_TWO = ("the former", "the latter")
_IS = ("is", "should be", "must be", "shall be", "has to be", "is to be", "goes", "should go", "reads", "should read",
       "will be", "needs to be", "consists of", "is made of", "is built of", "must go")  # fmt: skip
_THAT_IS = tuple(f"{that} {stands}" for that in ("that", "which") for stands in ("is", "stands", "lies", "sits"))
_MADE_OF = ("consists of", "is made of", "is made up of", "is built of", "is built from", "contains")
_MADE_UP = tuple(
    f"{must} {made}"
    for must in ("shall", "must", "should", "has to", "is to")
    for made in ("be made up of", "be made of", "be formed by", "be formed of", "be composed of", "consist of")
)
_ARE = (*_IS, *_MADE_UP, "are", "have to be", "are to be", "go", "read")
_MEMBERS = frozenset({"blocks", "cubes", "bricks", "boxes", "colors", "letters", "digits", "numbers"})


@rule
def having(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "the red block should have the blue one on it", "the patch must contain two blocks", "A has B to its left",
    "give each patch two blocks"."""
    given = p.any_of(i, _GIVE)
    for owner, j in noun_phrase(p, given or i):
        yield from _it_has(p, i, j, owner, mode) if isinstance(owner, Pronoun) and owner.word == "it" else ()
        if isinstance(owner, TableTop) or (isinstance(owner, Pronoun) and owner.word not in _OF_TWO):
            continue
        yield from _made_up(p, i, j, owner, mode)
        yield from denied(p, i, j, owner, mode)
        for mark, end in simple(p, k) if (k := p.any_of(j, _SHARE)) else ():
            if isinstance(mark, Noun) and mark.head == "patch" and not mark.plural:
                on = Loc(rel="on", landmark=mark, span=p.span(j, end))
                yield _stated(p, i, end, owner, (on,), mode), end
        patch = isinstance(owner, Noun) and owner.head == "patch"
        owner = _each_of_both(owner, p.stands(given or i, ("both",)))
        had = p.any_of(j, _HAS) or may_have(p, owner, j) or (p.any_of(j, _IS_FOR) if patch else 0)
        if k := j if given else had:
            yield from ((replace(far, mode=mode), end) for far, end in apart_by(p, i, k, owner))
            for theme, start in noun_phrase(p, k):
                if (told := _of_its_color(owner, theme, p.span(i, start))) is not None:
                    yield _stated(p, i, start, *told, mode), start
                    continue
                if (lying := _on_patch(owner, theme, p.span(i, start))) is not None:
                    stated = _stated(p, i, start, *lying, mode)
                    yield stated, start
                    yield from _next_owner(p, i, start, stated, mode)
                for found, end in adjuncts(p, p.opt(start, "resting", "lying", "standing", "sitting", "placed")):
                    if isinstance(owner, Structure) and owner.members is not None and _parts(found):
                        detail = Absolute(theme=theme, adjuncts=found, span=p.span(k, end))
                        built = Clause(verb="build", theme=owner, adjuncts=(detail,), mode=mode, span=p.span(i, end))
                        yield built, end
                        continue
                    places = _owned(found, owner)
                    if places is not None:
                        said, places = said_of_each(theme, places, owner)
                        stated = _as_told(p, j, k, _stated(p, i, end, said, places, mode))
                        stated = replace(stated, subject=owner)
                        yield stated, end
                        yield from _another(p, i, end, owner, stated, mode)
        if i and patch and (k := p.any_of(j, _CARRIES) or p.any_of(j, _HAS)) and (end := p.any_of(k, _NONE)):
            none = Noun(head="any", det="no", plural=True, span=p.span(k, end))
            yield _stated(p, i, end, none, (Loc(rel="on", landmark=owner, span=p.span(i, j)),), mode), end
        if k := p.any_of(j, _CARRIES):
            for theme, start in noun_phrase(p, k) if not _symbols(p, k) else ():
                every = p.one(start, ("each", "apiece")) if each_of(owner) else 0
                if every and getattr(owner, "det", "") not in ("each", "all", "both"):
                    continue  # "two of the three carry a green one each": as many as these
                for found, end in adjuncts(p, every or start):
                    if not found or _owned(found, owner) is not None:
                        place = Loc(rel="on", landmark=owner, span=p.span(i, j))
                        said, places = said_of_each(theme, (place,), owner)
                        yield replace(_as_told(p, j, k, _stated(p, i, end, said, places, mode)), subject=owner), end


def _each_of_both(owner: Meaning, both: bool) -> Meaning:
    """ "Both mats (have two blocks on them)", "both the red and the blue mat": each of them."""
    if both and isinstance(owner, Coord) and are_patches(owner):
        return Noun(head="patch", det="each", plural=True, part_of=all_patches(owner), span=owner.span)
    if not isinstance(owner, Noun) or (owner.head, owner.det, owner.part_of) != ("patch", "both", None):
        return owner
    two = replace(owner, det="the", amount=Amount(2, 2))
    return Noun(head="patch", det="each", plural=True, part_of=two, span=owner.span)


def _it_has(p: Parser, i: int, j: int, it: Pronoun, mode: str) -> Results[Clause]:
    """ "(a white block is on the mat,) and it has a gray one on top": what stands on it, or beside it."""
    k = p.any_of(j, _HAS)
    it = replace(it, word=OWNER)
    for theme, start in simple(p, k) if k else ():
        block = isinstance(theme, Noun) and theme.head != "patch" and theme.det in ("a", "the", "bare")
        for found, end in adjuncts(p, start) if block else ():
            if (places := _owned(found, it)) is not None:
                yield _as_told(p, j, k, _stated(p, i, end, theme, places, mode)), end


def _as_told(p: Parser, j: int, k: int, stated: Clause) -> Clause:
    """ "It has a gray block on it", "it carries one": a fact, which may be so at the start; "should have" is none."""
    told = " ".join(p.words[j:k]) in _TELLS
    return replace(stated, lemma="fact") if told and stated.mode == "goal" else stated


_TELLS = ("has", "carries", "holds", "holds up", "supports", "bears", "contains", "is carrying", "is supporting",
          "is holding")  # fmt: skip


def _symbols(p: Parser, i: int) -> bool:
    """ "five cubes carry the letters A to E": what they show, not what lies on them."""
    word = p.words[p.opt(i, "the")]
    return any(word in table for table in (lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL)) and word.endswith("s")


def what_carries(p: Parser, i: int, mode: str) -> Results[Clause]:
    """ "what supports the red block is the blue one": that is on the blue one."""
    led = p.any_of(i, ("what", "the block that", "the one that", "the cube that"))
    k = p.any_of(led, _CARRIES) if led else 0
    for theme, j in simple(p, k) if k else ():
        j = p.any_of(j, ("at the end", "in the end", "finally")) or j
        end = p.any_of(j, ("is", "should be", "must be", "has to be", "shall be"))
        for owner, last in simple(p, end) if end else ():
            if isinstance(owner, Noun) and owner.head != "patch" and isinstance(theme, Noun):
                yield _stated(p, i, last, theme, (Loc(rel="on", landmark=owner, span=p.span(i, k)),), mode), last


def _made_up(p: Parser, i: int, j: int, owner: Meaning, mode: str) -> Results[Clause]:
    """ "the tower has three blocks", "the stack has yellow at the bottom and red on top": of a structure; "the tower
    (that stands) on the mat has three blocks": it is there."""
    bare = isinstance(owner, Structure) and owner.det in ("the", "its") and not (owner.plural or owner.members)
    for place, there in loc(p, p.any_of(j, _THAT_IS) or j) if bare and i == 0 else ():
        has = p.any_of(there, _HAS) or p.any_of(there, _MADE_UP) or p.any_of(there, _MADE_OF)
        for members, end in noun_phrase(p, has) if has else ():
            counted = isinstance(members, Coord) or (isinstance(members, Noun) and members.amount is not None)
            if isinstance(owner, Structure) and counted and not (owner.sizes or owner.dims) and _new(members):
                whole = replace(owner, det="a", members=members, span=p.span(i, end))
                yield Clause(verb="build", theme=whole, adjuncts=(place,), mode=mode, span=p.span(i, end), cost=1), end
    k = p.any_of(j, _HAS) if bare else 0
    if not k or not isinstance(owner, Structure) or owner.sizes or owner.dims:
        return
    for found, end in part_list(p, k):
        yield Clause(verb="part", theme=owner, adjuncts=(found,), mode="goal", span=p.span(i, end), cost=1), end
    for size, end in size_phrase(p, k - 1) if p.words[k - 1] in ("has", "have") else ():
        made = replace(owner, sizes=(size,), span=p.span(i, end))
        yield Clause(verb="build", theme=made, mode=mode, span=p.span(i, end), cost=1), end
    for members, end in noun_phrase(p, k):
        if isinstance(members, Noun) and members.amount is not None and members.det == "bare":
            if members.traits == Traits() and members.amount.low == members.amount.high:
                size = Size(what="size", amount=members.amount, span=members.span)
                made = replace(owner, sizes=(size,), span=p.span(i, end))
            else:
                made = replace(owner, members=members, span=p.span(i, end))
            for more, last in adjuncts(p, end):
                if all(isinstance(x, Absolute | Coord) for x in more):
                    said = Clause(verb="build", theme=made, adjuncts=more, mode=mode, span=p.span(i, last), cost=1)
                    yield said, last


def _new(members: Meaning) -> bool:
    """ "three red blocks", "a red and a blue block"."""
    items = members.items if isinstance(members, Coord) and members.op == "and" else (members,)
    return all(isinstance(x, Noun) and x.det in ("a", "bare") and x.head != "patch" and not x.part_of for x in items)


@rule
def structure_is(p: Parser, i: int) -> Results[Clause]:
    """ "the row is red, green, blue from left to right", "it should be green on white", "the three cubes of the tower
    are, from bottom to top, red, white and black"."""
    of, many = _blocks_of(p, i)
    for owner, j in [*pronoun(p, i), *structure(p, of or i)]:
        if isinstance(owner, Pronoun) and owner.word not in ("it", "this"):
            continue
        bare = isinstance(owner, Structure) and owner.det in ("the", "its") and not (owner.plural or owner.members)
        k = p.any_of(j, _ARE if of else _IS) if bare or isinstance(owner, Pronoun) else 0
        if isinstance(owner, Structure) and owner.sizes:
            continue
        theme = owner if isinstance(owner, Structure) else None
        orders = [*one_on_another(p, k), *listed_along(p, k), *_listed_then(p, k)] if k else []
        for order, end in [*orders, *(_told_along(p, j) if bare and not k else ())]:
            if not many or (isinstance(order, OrderBy) and many == sum(map(_as_many, order.items))):
                yield Clause(verb="part", theme=theme, adjuncts=(order,), mode="goal", span=p.span(i, end)), end


def _blocks_of(p: Parser, i: int) -> tuple[int, int]:
    """ "the three cubes in (the row)", "the colours of (the tower)": the position behind it, and how many are told."""
    j = p.opt(i, "the")
    many = p.number(j) if j > i else None
    j = p.one(j if many is None else j + 1, _MEMBERS)
    return p.one(j, ("in", "of")) if j else 0, many or 0


def _as_many(item: Meaning) -> int:
    """So many blocks are named: one, "two red", "white and black"."""
    if not isinstance(item, Noun):
        return 0
    return item.amount.low if item.amount is not None else max(1, len(item.traits.colors), len(item.traits.labels))


def _told_along(p: Parser, j: int) -> Results[OrderBy]:
    """ "(the tower) starting from the top is gray, brown, pink"."""
    for way, k in toward(p, p.opt(p.opt(j, ","), "read", "seen", "counted")):
        if not isinstance(way, Toward) or way.first is None:
            continue
        start = p.any_of(p.opt(k, ","), _ARE)
        for items, end in listed(p, p.opt(start, ":")) if start else ():
            yield OrderBy(by="named", items=items, first=way.first, span=p.span(j, end)), end


def _listed_then(p: Parser, k: int) -> Results[OrderBy]:
    """ "red, green and blue from top to bottom"."""
    for items, j in listed(p, k):
        for way, end in toward(p, p.opt(j, ",")):
            if isinstance(way, Toward) and way.first is not None:
                yield OrderBy(by="named", items=items, first=way.first, span=p.span(k, end)), end


def _another(p: Parser, i: int, at: int, owner: Meaning, first: Clause, mode: str) -> Results[Meaning]:
    """ "... and the white block on its right": a second thing that the owner has."""
    joint = p.one(p.opt(at, ","), "and")
    owner = brought_up(owner)  # the one that has the first
    if isinstance(owner, Noun) and owner.amount == Amount(1, 1):
        owner = replace(owner, amount=None)
    for theme, j in noun_phrase(p, joint) if joint else ():
        for found, end in adjuncts(p, j):
            if (places := _owned(found, owner)) is not None:
                stated = replace(_stated(p, joint, end, theme, places, mode), cost=0)
                second = Chain(clauses=(stated,), links=("and",), span=theme.span)
                told = That(kind="so", clauses=second, span=second.span)
                yield replace(first, adjuncts=(*first.adjuncts, told), span=p.span(i, end)), end


def _next_owner(p: Parser, i: int, at: int, first: Clause, mode: str) -> Results[Meaning]:
    """ "(the red mat gets the blue block,) the blue mat the red one": a second patch with what lies there."""
    joint = p.opt(p.opt(at, ",", ";"), "and", "while")
    for owner, j in simple(p, joint) if joint > at else ():
        patch = isinstance(owner, Noun) and owner.head == "patch" and not owner.plural and owner.det == "the"
        for theme, end in noun_phrase(p, j) if patch else ():
            if (lying := _on_patch(owner, theme, p.span(joint, end))) is not None:
                second = replace(_stated(p, joint, end, *lying, mode), cost=0)
                chain = Chain(clauses=(second,), links=("and",), span=second.span)
                said = (*first.adjuncts, That(kind="so", clauses=chain, span=chain.span))
                whole = replace(first, adjuncts=said, span=p.span(i, end))
                yield whole, end
                yield from _next_owner(p, i, end, whole, mode)


def _of_its_color(owner: Meaning, theme: Meaning, span: Span) -> tuple[Meaning, tuple[Meaning, ...]] | None:
    """ "each patch gets the block of its own colour": every block lies on the patch of its colour."""
    each = isinstance(owner, Noun) and owner.head == "patch" and (owner.det in ("each", "all") or owner.plural)
    if not each or not isinstance(theme, Noun) or not isinstance(owner, Noun) or not theme.traits.matching:
        return None
    if theme.head == "patch" or theme.det not in ("the", "its", "all", "bare") or theme.amount is not None:
        return None
    blocks = replace(theme, det="all", plural=True, traits=replace(theme.traits, matching=False))
    patch = replace(owner, det="its", plural=False, amount=None, traits=replace(owner.traits, matching=True))
    return blocks, (Loc(rel="on", landmark=patch, span=span),)


def _on_patch(owner: Meaning, theme: Meaning, span: Span) -> tuple[Meaning, tuple[Meaning, ...]] | None:
    """ "each patch has one block", "each letter gets its own patch", "the mat gets a tower": what lies on what."""
    single = isinstance(owner, Noun) and owner.head == "patch" and not owner.plural and owner.det in _SINGLE
    if single and (isinstance(theme, Structure) or _all_blocks(theme)):
        return theme, (Loc(rel="on", landmark=owner, span=span),)
    if not (isinstance(owner, Noun) and isinstance(theme, Noun)) or (owner.head == "patch") == (theme.head == "patch"):
        return None
    if theme.head == "patch" and theme.traits.scheme != "different":
        return None
    block, patch = (theme, owner) if owner.head == "patch" else (owner, theme)
    return block, (Loc(rel="on", landmark=patch, span=span),)


_SINGLE = frozenset({"the", "each", "a", "other", "another"})


def _all_blocks(theme: Meaning) -> bool:
    return isinstance(theme, Coord) and all(isinstance(x, Noun) and x.head != "patch" for x in theme.items)


def _parts(found: tuple[Meaning, ...]) -> bool:
    return bool(found) and all(isinstance(part, At | Places) for part in found)


def _owned(found: tuple[Meaning, ...], owner: Meaning) -> tuple[Meaning, ...] | None:
    """The places with the owner where they say "it" or leave it unsaid; None where they speak of something else."""
    if not found:
        return None
    places: list[Meaning] = []
    for part in found:
        if isinstance(part, Loc) and is_owner(part.landmark):
            places.append(replace(part, landmark=owner))
        elif isinstance(part, At) and part.side in ("top", "left", "right") and part.index is None:
            places.append(Loc(rel={"top": "on"}.get(part.side, part.side), landmark=owner, span=part.span))
        elif (isinstance(part, Into | Spacing) and getattr(owner, "head", "") == "patch") or (
            isinstance(part, Loc) and part.rel == "on" and isinstance(part.landmark, TableTop)
        ):
            places.append(part)
        else:
            return None
    return tuple(places) if any(isinstance(part, Loc) and part.landmark is owner for part in places) else None


def _stated(p: Parser, i: int, end: int, theme: Meaning, places: tuple[Meaning, ...], mode: str) -> Clause:
    verb = "build" if isinstance(theme, Structure) else "be"
    return Clause(verb=verb, theme=theme, adjuncts=places, mode=mode, span=p.span(i, end), cost=1)


_END = frozenset({"end", "final", "finally", "result", "finished", "done"})
_LASTLY = frozenset({"finally", "eventually", "ultimately", "lastly"})
REACH = 2
"""So many words may lead to what there is finally: "Finally, there is ..."."""


def finally_there(p: Parser, i: int, there: Meaning, end: bool = False) -> Meaning:
    """ "At the end there is a red block with a blue one on it": both are so in the end. `end`: a frame tells of it."""
    end = end or (p.stands(0, _LASTLY) and i <= REACH) or p.seq(0, "at last") > 0
    if not isinstance(there, Clause) or (not end and _END.isdisjoint(p.words[:i])):
        return there
    if with_more(there.theme, there.adjuncts):
        return replace(there, verb="be", mode="goal")
    shapes = there.theme.items if isinstance(there.theme, Coord) else (there.theme,)
    shaped = any(isinstance(shape, Structure) for shape in shapes)
    told = end and there.mode == "given" and (there.adjuncts or shaped)
    return replace(there, mode="goal") if told else there


def with_more(theme: Meaning | None, found: tuple[Meaning, ...]) -> bool:
    """ "a red block with a blue one on it", "three red blocks in a row"."""
    if isinstance(theme, Noun) and any(isinstance(a, Into) for a in found):
        return True
    beside = any(isinstance(a, Absolute) or (isinstance(a, Coord) and a.op == "absolutes") for a in found)
    return beside and isinstance(theme, Noun)
