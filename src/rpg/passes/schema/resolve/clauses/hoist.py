"""What a later clause says of the parts of a structure belongs to the clause that builds it."""

from __future__ import annotations

from functools import reduce

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Quality,
    Structure,
    TableTop,
    Toward,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.colors_told import colors_told
from rpg.passes.schema.resolve.clauses.denied_of_it import denied_of_it
from rpg.passes.schema.resolve.clauses.enough import as_many_as_it_takes
from rpg.passes.schema.resolve.clauses.left_alone import left_alone
from rpg.passes.schema.resolve.clauses.leftovers import all_used
from rpg.passes.schema.resolve.clauses.one_each import plainly
from rpg.passes.schema.resolve.clauses.there_later import standing_there
from rpg.passes.schema.resolve.clauses.told_fully import told_fully
from rpg.passes.schema.resolve.orders.above_it import others_beyond
from rpg.passes.schema.resolve.orders.inside_lines import as_a_grid, between_in_line, in_a_line
from rpg.passes.schema.resolve.orders.nothing_beyond import at_that_end
from rpg.passes.schema.resolve.orders.one_more_at_an_end import at_its_end
from rpg.passes.schema.resolve.places.drawn import drawn, grounded
from rpg.passes.schema.resolve.places.heaped import heaped
from rpg.passes.schema.resolve.places.opposite import opposite_sides
from rpg.passes.schema.resolve.places.overs import in_one_tower
from rpg.passes.schema.resolve.structures.grouped import groups_joined, sorted_with_strangers, told_apart
from rpg.passes.schema.resolve.structures.hubs import brought_up, in_outline, in_the_middle, told_first
from rpg.passes.schema.resolve.structures.lined_towers import of_all_that_follows
from rpg.passes.schema.resolve.structures.named_again import named_again
from rpg.passes.schema.resolve.structures.told_towers import (
    one_more_tower,
    other_side,
    side_by_side,
    told_after,
    told_towers,
)
from rpg.passes.schema.resolve.things.listed_after import built_first, filled, listed_inside, shapes_pictured
from rpg.passes.schema.resolve.things.world import refuse

_IN_OTHER_WORDS = (denied_of_it, heaped, between_in_line, at_that_end, others_beyond, as_many_as_it_takes, left_alone,
                   plainly, drawn, colors_told)  # fmt: skip
"""What a clause says for all of its blocks, as it is said elsewhere."""


def hoisted(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with "the top block is red" said where the tower is built; sentences that say no more are gone."""
    found: list[list[tuple[str, Meaning]]] = []
    chains = standing_there(opposite_sides(told_fully(chains)))
    for chain in shapes_pictured(built_first(listed_inside(named_again(chains)))):
        of_all_that_follows(chain)
        kept: list[tuple[str, Meaning]] = []
        found.append(kept)
        for link, said in zip(chain.links, chain.clauses, strict=True):
            if not isinstance(said, Clause):
                kept.append((link, said))
                continue
            said = grounded(reduce(lambda one, told: told(one), _IN_OTHER_WORDS, said), chains)
            _below_what(_last(found), said)
            if link != "then" and other_side(found, said):
                continue
            said = as_a_grid(said)
            if parts := in_a_line(said) or told_apart(said):
                kept += [(link if n == 0 else "and", part) for n, part in enumerate(parts)]
                continue
            if (parts := in_one_tower(said)) and not any(found[:-1]) and not kept:
                kept += [(link if n == 0 else "and", part) for n, part in enumerate(parts)]
                continue
            clause = at_its_end(_of_the_rest(_of_one(said), found), _last(found) if link != "then" else None)
            if _asked_again(found, said, link) or _shape_alone(found, said, link) or _looks_listed(found, said, link):
                continue
            if link not in ("then", "or") and _blocks_listed(found, said):
                continue
            if said.lemma == "listed":
                kept.insert(0, ("and", _there_are(said, _last(found))))
                continue
            if in_outline(found, said, link) or (link not in ("then", "or") and _on_the_part(found, said)):
                continue
            if (inside := in_the_middle(said)) is not None and (brought_up(inside[1]) or told_first(inside[1], found)):
                built = replace(said, verb="build", lemma="", theme=inside[1], adjuncts=(inside[0],))
                kept.append((link, built))
                continue
            if link not in ("then", "or") and (told_after(found, clause) or one_more_tower(found, clause)):
                continue
            if link == "or" and clause.verb == "part" and clause.theme is None:
                raise refuse("ambiguous", "it is not clear what this is the other possibility to", clause.span,
                             "tell both of them in full: 'the row is A B C or the row is C B A'")  # fmt: skip
            host = _host(found, clause) if clause.verb == "part" and link != "then" else None
            if host is None:
                alone = isinstance(clause.theme, Structure) and clause.verb == "part"
                towers = (told_towers(found, clause) if link != "then" else None) or side_by_side(clause)
                kept.append((link, towers or (replace(clause, verb="build") if alone else said)))
                continue
            line, place, builder = host
            _ordered_once(builder, clause)
            built = replace(builder, adjuncts=(*builder.adjuncts, *clause.adjuncts))
            found[line][place] = (found[line][place][0], built)
    found = [groups_joined(kept) for kept in found]
    left = [n for n, kept in enumerate(found) if kept]
    said_so = {n: tuple(sorted_with_strangers(all_used(c)) for _, c in found[n]) for n in left}
    return [links[n] for n in left], tuple(
        replace(chains[n], clauses=said_so[n], links=tuple(link for link, _ in found[n])) for n in left
    )


def _on_the_part(found: list[list[tuple[str, Meaning]]], said: Clause) -> bool:
    """ "Build a tower of four blocks. The bottom one is black. On it there is a white one.": the next of the four."""
    last = _last(found)
    place = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    if last is None or _unlooked(last) < 2 or said.verb != "be" or said.negated:
        return False
    if not isinstance(place, Loc) or place.rel not in ("on", "above") or place.negated:
        return False
    upon = isinstance(place.landmark, Pronoun) and place.landmark.word in ("it", "that", "this", "that one")
    said_of = last.adjuncts or (last.theme.details if isinstance(last.theme, Structure) else ())
    told = said_of[-1].items[-1] if said_of and isinstance(said_of[-1], Coord) else said_of[-1] if said_of else None
    part = told.adjuncts[0] if isinstance(told, Absolute) else None
    if not upon or not isinstance(part, At) or part.side not in ("bottom", "middle", "next") or said.mode == "start":
        return False
    if not isinstance(said.theme, Noun) or place.rel == "above":
        raise refuse("ambiguous", "this could be the next block of the tower, or one above all of it", said.span,
                     "say 'the second block from the bottom', or 'on top of the tower'")  # fmt: skip
    onward = Absolute(theme=said.theme, adjuncts=(At(side="next", whole="on", span=place.span),), span=said.span)
    line = max(n for n, lot in enumerate(found) if lot)
    found[line][-1] = (found[line][-1][0], replace(last, adjuncts=(*last.adjuncts, onward)))
    return True


def _below_what(built: Clause | None, said: Clause) -> None:
    """Refuse "a tower of four with blue second from the top and red right below it": below blue, or below all four?"""
    shape = built.theme if built is not None else None
    inside = [x for x in shape.details if isinstance(x, Absolute)] if isinstance(shape, Structure) else []
    inside = [x for x in inside for a in x.adjuncts if isinstance(a, At) and (a.side, a.index) != ("top", None)]
    for place in said.adjuncts if inside and said.verb == "be" else ():
        it = isinstance(place, Loc) and isinstance(place.landmark, Pronoun) and place.landmark.word in ("it", "that")
        if it and isinstance(place, Loc) and place.rel in ("on", "above", "under"):
            raise refuse("ambiguous", "this could be of the block or of all of it", place.span, "name what you mean")


def _asked_again(found: list[list[tuple[str, Meaning]]], said: Clause, link: str) -> bool:
    """ "From top to bottom: white, black. Build it.": no more than that what was told is wanted."""
    last = _last(found)
    bare = isinstance(said.theme, Pronoun) and said.theme.word in ("it", "that", "this") and not said.adjuncts
    wanted = last is not None and last.mode in ("goal", "command") and last.verb not in ("part", "keep", "pick")
    return said.verb == "build" and said.lemma in _MAKING and bare and not said.negated and link == "and" and wanted


_MAKING = frozenset({"build", "make", "create", "construct", "form", "assemble"})


def _shape_alone(found: list[list[tuple[str, Meaning]]], said: Clause, link: str) -> bool:
    """ "Bottom to top: black, gray, white. One stack.": what the blocks just listed are to form."""
    last, shape = _last(found), said.theme
    there = all(isinstance(a, Loc) and isinstance(a.landmark, TableTop) and not a.negated for a in said.adjuncts)
    if last is None or not isinstance(shape, Structure) or not there or said.negated or link != "and":
        return False
    listed = last.verb == "arrange" and last.theme is None and last.mode == "goal" and not last.negated
    listed = listed and any(isinstance(a, OrderBy) and a.items for a in last.adjuncts)
    plain = shape.kind in ("stack", "row", "line", "column") and not shape.plural and shape.det in ("a", "bare")
    if not listed or not plain or shape.members or shape.details or any(isinstance(a, Into) for a in last.adjuncts):
        return False
    into = Into(structure=shape, span=said.span)
    line = max(n for n, lot in enumerate(found) if lot)
    found[line][-1] = (found[line][-1][0], replace(last, adjuncts=(*last.adjuncts, into, *said.adjuncts)))
    return True


def _blocks_listed(found: list[list[tuple[str, Meaning]]], said: Clause) -> bool:
    """ "Make a row on the table: from left to right it is red, green": the blocks of the line that was asked for."""
    last = _last(found)
    built = filled(last, said, bool(found[-1])) if last is not None else None
    if built is None:
        return False
    line = max(n for n, lot in enumerate(found) if lot)
    found[line][-1] = (found[line][-1][0], built)
    return True


def _looks_listed(found: list[list[tuple[str, Meaning]]], said: Clause, link: str) -> bool:
    """ "Four cubes in a row with 2 cm gaps: cyan, cyan, brown, brown": the looks of the blocks that were counted."""
    last = _last(found)
    if last is None or link != "and" or said.verb != "be" or said.negated:
        return False
    if last.verb not in ("be", "arrange", "build", "place") or last.negated or last.mode == "start":
        return False
    items = _bare_looks(said.theme)
    if len(items) < 2:
        return False
    ways = all(isinstance(a, Toward) for a in said.adjuncts)
    ordered = any(isinstance(a, OrderBy | Toward) for a in last.adjuncts)
    if not ways or ordered or _unlooked(last) != len(items):
        return False
    order = OrderBy(by="named", items=items, span=said.span)
    line = max(n for n, lot in enumerate(found) if lot)
    found[line][-1] = (found[line][-1][0], replace(last, adjuncts=(*last.adjuncts, order, *said.adjuncts)))
    return True


def _there_are(said: Clause, last: Clause | None) -> Clause:
    """ "... in the colours of the rainbow: purple, blue, green": what blocks there are."""
    items = _bare_looks(said.theme)
    marks = [x for x in parts_of(last) if isinstance(x, Noun) and x.head == "patch" and not x.traits.matching]
    if any(not x.traits.colors and (x.plural or x.det == "each") for x in marks):
        raise refuse("ambiguous", "what is listed could be the patches or the blocks", said.span,
                     "say 'blocks' or 'patches' where they are listed")  # fmt: skip
    if said.adjuncts or len(set(items)) < len(items) or len({x.traits for x in items}) < len(items):
        raise refuse("misplaced", "it is not clear of which blocks these are the looks", said.span,
                     "list them where the blocks are counted")  # fmt: skip
    return replace(said, verb="exist", lemma="tally", mode="given")


def _bare_looks(theme: Meaning | None) -> tuple[Noun, ...]:
    """The blocks of "cyan, cyan, brown", one for each colour; none of anything else."""
    lots = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    if not all(isinstance(x, Noun) and x.head == "any" and x.det == "bare" and x.amount is None for x in lots):
        return ()
    nouns = [x for x in lots if isinstance(x, Noun)]
    if any(x.traits != Traits(colors=x.traits.colors) or x.part_of or x.conditions for x in nouns):
        return ()
    return tuple(replace(x, plural=False, traits=Traits(colors=(c,)), cost=0) for x in nouns for c in x.traits.colors)


def _unlooked(clause: Clause) -> int:
    """How many blocks of no look a clause lays in one line or tower; 0 where it does not, or does not say."""
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    theme = clause.theme
    shape = theme if isinstance(theme, Structure) else shapes[0] if len(shapes) == 1 else None
    if not isinstance(shape, Structure) or shape.kind not in ("stack", "row", "line", "column") or shape.plural:
        return 0
    if shape.traits != Traits() or any(isinstance(a, OrderBy) for a in shape.details):
        return 0
    blocks = shape.members if shape is theme else theme
    if shape is theme and blocks is None:
        return shape.size.low if shape.size is not None and shape.size.low == shape.size.high else 0
    plain = isinstance(blocks, Noun) and blocks.traits == Traits() and blocks.det == "bare" and not blocks.part_of
    amount = blocks.amount if isinstance(blocks, Noun) and plain else None
    return amount.low if amount is not None and amount.low == amount.high else 0


def _last(found: list[list[tuple[str, Meaning]]]) -> Clause | None:
    """The clause said last."""
    kept = next((lot[-1][1] for lot in reversed(found) if lot), None)
    return kept if isinstance(kept, Clause) else None


def _of_one(clause: Clause) -> Clause:
    """ "the far row is red", "the other is blue": perhaps of one of several structures that were built before."""
    theme, quality = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    plain = isinstance(quality, Quality) and quality.traits == Traits(colors=quality.traits.colors)
    if clause.verb != "be" or clause.negated or not plain or not isinstance(quality, Quality):
        return clause
    if isinstance(theme, Pronoun) and theme.word in _ONES:
        place = Places(side="one", unit="whole", span=theme.span)
    elif isinstance(theme, Structure) and theme.traits == Traits(rank=theme.traits.rank) and theme.det == "the":
        place = Places(side=theme.traits.rank or "", unit=f"whole {theme.kind}", span=theme.span)
        if theme.members or theme.sizes or theme.dims or theme.traits.rank not in _SIDES:
            return clause
    else:
        return clause
    look = Noun(head="any", traits=quality.traits, span=quality.span)
    return replace(clause, verb="part", theme=None,
                   adjuncts=(Absolute(theme=look, adjuncts=(place,), span=clause.span),))  # fmt: skip


def _of_the_rest(clause: Clause, found: list[list[tuple[str, Meaning]]]) -> Clause:
    """ "(Both ends are red.) The rest are blue.": the other blocks of what parts were told of just before."""
    theme, quality = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    plain = isinstance(quality, Quality) and quality.traits == Traits(colors=quality.traits.colors[:1])
    if not isinstance(theme, Pronoun) or theme.word not in _OTHERS or clause.verb != "be" or clause.negated:
        return clause
    last = _last(found)
    told = [x for a in last.adjuncts for x in (a.items if isinstance(a, Coord) else (a,))] if last is not None else []
    if not plain or not isinstance(quality, Quality) or not any(isinstance(x, Absolute) for x in told):
        return clause
    look = Noun(head="any", traits=quality.traits, span=quality.span)
    rest = Places(side="rest", unit="block", span=theme.span)
    return replace(clause, verb="part", theme=None,
                   adjuncts=(Absolute(theme=look, adjuncts=(rest,), span=clause.span),))  # fmt: skip


_OTHERS = ("the rest", "the others", "the other ones", "the remaining ones", "all others", "all the others",
           "all the rest")  # fmt: skip
_ONES = ("one", "the other", "the other one", "another", "one of them")
_SIDES = ("left", "right", "front", "back", "middle")


def _ordered_once(builder: Clause, clause: Clause) -> None:
    """Refuse "the stack is red, green, blue from top to bottom; it should be green, blue, red from top to bottom"."""
    own = builder.theme.details if isinstance(builder.theme, Structure) else ()
    before, after = ([x for x in parts if isinstance(x, OrderBy) and x.by == "named" and x.items]
                     for parts in ((*own, *builder.adjuncts), clause.adjuncts))  # fmt: skip
    sided = any(isinstance(x, Toward) or (isinstance(x, OrderBy) and x.first) for x in builder.adjuncts)
    if before and after and sided and not _ranked(clause.theme) and _looks(before[0]) != _looks(after[0]):
        raise refuse("ambiguous", "is this the order that it has at the end, or is it there in another one at first?",
                     after[0].span, "say 'there is a row A B C' of the start, or leave one order out")  # fmt: skip


def _ranked(theme: Meaning | None) -> bool:
    """ "The left tower": one of several."""
    return isinstance(theme, Structure) and theme.traits != Traits()


def _looks(order: OrderBy) -> list[Traits | None]:
    return [getattr(item, "traits", None) for item in order.items]


def _units(clause: Clause) -> set[str]:
    """What the parts that a clause speaks of are: blocks, rows, wholes."""
    parts = [x for a in clause.adjuncts for x in (a.items if isinstance(a, Coord) else (a,))]
    if all(isinstance(x, OrderBy) and x.by == "each" for x in parts):
        return {"whole"}
    if all(isinstance(x, Manner) and x.kind == "outliers" for x in parts):
        return {"pile"}
    return {getattr(x.adjuncts[0], "unit", "") if isinstance(x, Absolute) else "" for x in parts}


def _host(found: list[list[tuple[str, Meaning]]], clause: Clause) -> tuple[int, int, Clause] | None:
    """Where the structure was built that is spoken of: the clause before, if it builds a single one (or several)."""
    for line in range(len(found) - 1, -1, -1):
        for place in range(len(found[line]) - 1, -1, -1):
            builder = found[line][place][1]
            if not isinstance(builder, Clause):
                return None
            if builder.verb == "exist" and builder.mode == "given":
                continue
            return (line, place, builder) if _builds(builder, _units(clause)) else None
    return None


def _builds(clause: Clause, units: set[str]) -> bool:
    """Whether a clause builds the one structure, or the several ones, that parts of these kinds are parts of."""
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    if isinstance(clause.theme, Structure):
        shapes.append(clause.theme)
    if clause.negated or clause.mode == "start" or len(shapes) > 1:
        return False
    whole = any(unit.startswith("whole") for unit in units)
    if units == {"pile"} and (clause.verb == "sort" or not shapes):
        return clause.verb == "sort"
    if not shapes:
        return clause.verb in ("stack", "arrange") and not whole
    shape = shapes[0]
    if not isinstance(shape, Structure):
        return False
    if shape.plural:
        return units <= {"whole", shape.kind, f"whole {shape.kind}"}
    return not whole
