""" "Build a row or a tower of four blocks", "they form either a row or a tower": two ways, of the same blocks."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Into, Meaning, Noun, Pronoun, Structure, Using, replace


def either_shape(chain: Chain) -> Chain:
    """The sentence with a chain of its own for what is to be of one shape or of another."""
    return replace(chain, clauses=tuple(map(_in_ways, chain.clauses)))


def _in_ways(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or clause.negated:
        return clause
    there = clause.verb == "exist" and clause.mode == "goal"
    if (clause.verb == "build" or there) and (shapes := _shapes(clause.theme)):
        ways = [replace(clause, verb="build", theme=shape) for shape in shapes]
    elif found := [(n, shapes) for n, a in enumerate(clause.adjuncts) if isinstance(a, Into)
                   and (shapes := _shapes(a.structure))]:  # fmt: skip
        n, shapes = found[0]
        into = [Into(structure=shape, span=shape.span) for shape in shapes]
        ways = [replace(clause, adjuncts=(*clause.adjuncts[:n], x, *clause.adjuncts[n + 1 :])) for x in into]
    else:
        return clause
    told = [ways[0], *map(_of_the_same, ways[1:])]
    return Chain(clauses=tuple(told), links=("and", *("or" for _ in told[1:])), span=clause.span)


def _shapes(told: Meaning | None) -> list[Structure]:
    """The shapes that "or" leaves open; none where blocks of its own are said of each."""
    if not isinstance(told, Coord) or told.op != "or":
        return []
    shapes = [shape for shape in told.items if isinstance(shape, Structure)]
    owned = [shape.members for shape in shapes if shape.members is not None]
    if owned and len(owned) == len(shapes) and all(_as_told(owned[0], other) for other in owned[1:]):
        owned, shapes = owned[:1], [*shapes[:-1], replace(shapes[-1], members=owned[0])]
    if len(shapes) < len(told.items) or len(owned) > 1 or (owned and shapes[-1].members is None):
        return []
    plain = [replace(shape, members=None) for shape in shapes]
    return [replace(plain[0], members=owned[0]), *plain[1:]] if owned else plain


def _as_told(one: Meaning, other: Meaning) -> bool:
    """Whether the blocks of one shape are told in the words of the other's: "a row of four red blocks or a tower of
    four red blocks" needs no more than four."""
    return (
        isinstance(one, Noun) and not one.conditions and one.part_of is None and replace(one, span=other.span) == other
    )


def _of_the_same(way: Clause) -> Clause:
    """What is said a second time of the same blocks."""
    them = Pronoun(word="them", span=way.span)
    again = tuple(a for a in way.adjuncts if not isinstance(a, Using))
    if way.verb == "build":
        return replace(way, adjuncts=(Using(members=them, span=way.span), *again))
    return replace(way, theme=them, adjuncts=again)
