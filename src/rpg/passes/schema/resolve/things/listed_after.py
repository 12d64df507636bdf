"""Lines whose blocks the sentence behind them lists: "make a row of three. From left to right: red, green, blue"."""

from __future__ import annotations

from rpg.language.lexicon import RAINBOW
from rpg.language.meaning import (
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
    Pronoun,
    Spacing,
    Structure,
    TableTop,
    Toward,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.things.layers_listed import layers_listed

_LINES = ("stack", "row", "line", "column")
_FLAT = ("square", "grid", "rectangle")


def shapes_pictured(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "There is a row of 4. From the left I see red, ...": what is built, where nothing is ordered and no start told.

    Of the blocks of such a row nothing is known but what the picture tells.
    """
    clauses = [c for chain in chains for c in chain.clauses]
    if not all(isinstance(c, Clause) and c.mode in ("goal", "given") for c in clauses) or len(clauses) < 2:
        return chains
    return tuple(replace(chain, clauses=tuple(map(_built, chain.clauses))) for chain in chains)


def built_first(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "The biggest block must not be at the bottom: red, blue, green in a tower": the tower tells which."""
    first = chains[0].clauses if chains else ()
    if len(first) < 2 or chains[0].links[1] != "and":
        return chains
    said, built = first[0], first[1]
    theme = said.theme if isinstance(said, Clause) and said.verb == "be" and said.negated else None
    extreme = isinstance(theme, Noun) and theme.traits.rank in ("largest", "smallest") and theme.part_of is None
    inside = isinstance(said, Clause) and bool(said.adjuncts) and all(isinstance(a, At) for a in said.adjuncts)
    shaped = isinstance(built, Clause) and (
        any(isinstance(a, Into) for a in built.adjuncts) or isinstance(built.theme, Structure) or built.verb == "stack"
    )
    if not extreme or not inside or not shaped:
        return chains
    return (replace(chains[0], clauses=(built, said, *first[2:])), *chains[1:])


def listed_inside(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Put them in a row, red, blue, green": with nothing before it the list tells what the row is of."""
    first = chains[0].clauses[0] if chains and chains[0].clauses else None
    theme = first.theme if isinstance(first, Clause) and first.mode == "command" else None
    if not isinstance(first, Clause) or not isinstance(theme, Pronoun) or theme.word not in ("them", "all of them"):
        return chains
    shapes = [a.structure for a in first.adjuncts if isinstance(a, Into) and isinstance(a.structure, Structure)]
    orders = [x for s in shapes if s.members is None for x in s.details if isinstance(x, OrderBy) and x.items]
    alone = len(shapes) == len(orders) == 1 and not any(isinstance(a, OrderBy) for a in first.adjuncts)
    if not alone or len(orders[0].items) < 2 or orders[0].by not in ("given", "named"):
        return chains
    told = replace(first, theme=Coord(op="and", items=orders[0].items, span=orders[0].span))
    return (replace(chains[0], clauses=(told, *chains[0].clauses[1:])), *chains[1:])


def _built(clause: Meaning) -> Meaning:
    there = isinstance(clause, Clause) and (clause.verb, clause.mode, clause.lemma) == ("exist", "given", "")
    pictured = there and isinstance(clause, Clause) and (_unlooked(clause.theme) or _unlooked(clause.theme, _FLAT))
    if not pictured or not isinstance(clause, Clause) or not _on_the_table(clause):
        return clause
    return replace(clause, verb="build", mode="goal")


def _on_the_table(clause: Clause) -> bool:
    """Whether it is at most said that something is on the table."""
    return all(isinstance(a, Loc) and isinstance(a.landmark, TableTop) and not a.negated for a in clause.adjuncts)


def _unlooked(shape: Meaning | None, kinds: tuple[str, ...] = _LINES) -> bool:
    """ "a row", "a tower of three (blocks)": of its blocks no more than the number is said."""
    if not isinstance(shape, Structure) or shape.kind not in kinds or shape.plural or shape.traits != Traits():
        return False
    blocks = shape.members
    plain = isinstance(blocks, Noun) and blocks.head == "block" and blocks.traits == Traits() and not blocks.part_of
    bare = isinstance(blocks, Noun) and blocks.det == "bare"
    return shape.det in ("a", "bare") and not shape.details and (blocks is None or (plain and bare))


def _many(shape: Structure) -> int | None:
    """How many blocks it is said to have."""
    told = shape.size or (shape.members.amount if isinstance(shape.members, Noun) else None)
    return None if told is None else told.low if told.low == told.high else -1


def filled(last: Clause, said: Clause, together: bool) -> Clause | None:
    """The clause that builds a line, with the blocks and their order, or the gaps, that the next one tells of it.

    `together`: both are in one sentence.
    """
    if last.negated or last.mode == "start" or said.negated or said.mode == "start":
        return None
    if _gaps_of_it(said) and _one_line(last):
        return replace(last, adjuncts=(*last.adjuncts, *said.adjuncts))
    if (rainbow := _rainbow(last, said)) is not None:
        return rainbow
    if together and (layered := layers_listed(last, said)) is not None:
        return layered
    if (sorted_ := _sorted_ones(last, said, together)) is not None:
        return sorted_
    items = next((a.items for a in said.adjuncts if isinstance(a, OrderBy) and a.by == "given" and a.items), ())
    listed = said.verb == "arrange" and said.theme is None and said.mode == "goal"
    if not listed or not items or any(not isinstance(a, OrderBy | Toward) for a in said.adjuncts):
        return None
    shape = last.theme
    if last.verb != "build" or not isinstance(shape, Structure):
        return None
    told = any(isinstance(a, OrderBy | Toward | Into) for a in last.adjuncts)
    if told or not _unlooked(shape) or _many(shape) not in (None, len(items)):
        return None
    return replace(last, adjuncts=(*last.adjuncts, *said.adjuncts))


_NAMED = ("ascending", "label", "number", "rainbow", "size", "mirrored")


def _sorted_ones(last: Clause, said: Clause, together: bool) -> Clause | None:
    """ "A row in descending order, 8, 2, 6, from left to right", "a column running from front to back: red, blue":
    which blocks those are that are sorted, or stand in the direction that is told."""
    shape, theme = last.theme, said.theme
    if last.verb != "build" or not isinstance(shape, Structure) or not _unlooked(shape):
        return None
    ordered = any(isinstance(a, OrderBy) and a.by in _NAMED and not a.items for a in last.adjuncts)
    if not ordered and not (together and any(isinstance(a, Toward) for a in last.adjuncts)):
        return None
    if any(isinstance(a, Into) or (isinstance(a, OrderBy) and a.items) for a in last.adjuncts):
        return None
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    nouns = [x for x in items if isinstance(x, Noun) and x.det in ("bare", "a") and x.head != "patch" and not x.part_of]
    looks = [x for x in nouns if x.traits in (Traits(labels=x.traits.labels), Traits(colors=x.traits.colors))]
    many = sum(x.amount.low if x.amount else len(x.traits.labels or x.traits.colors) for x in looks)
    told = said.verb in ("be", "exist") and said.lemma in ("", "tally", "listed")
    if not told or len(looks) < len(items) or many < 2 or any(not isinstance(a, Toward) for a in said.adjuncts):
        return None
    if theme is None or _many(shape) not in (None, many):
        return None
    return replace(last, theme=replace(shape, members=theme, sizes=()), adjuncts=(*last.adjuncts, *said.adjuncts))


def _rainbow(last: Clause, said: Clause) -> Clause | None:
    """ "Make a rainbow! Red, orange, yellow, green in a line": in its order."""
    shape, listed = last.theme, said.theme
    bare = isinstance(shape, Structure) and shape == Structure(kind="gradient", det=shape.det, amount=shape.amount,
                                                               span=shape.span)  # fmt: skip
    items = listed.items if isinstance(listed, Coord) and listed.op == "and" else (listed,)
    colors = [c for x in items if isinstance(x, Noun) and x.amount in (None, Amount(1, 1)) for c in x.traits.colors]
    lines = [a for a in said.adjuncts if isinstance(a, Into) and getattr(a.structure, "kind", "") in _LINES]
    if not bare or last.adjuncts or len(colors) < max(3, len(items)) or not set(colors) <= set(RAINBOW):
        return None
    if len(lines) != 1 or any(not isinstance(a, Into | Toward) for a in said.adjuncts):
        return None
    return replace(said, adjuncts=(*said.adjuncts, OrderBy(by="rainbow", span=last.span)))


def _gaps_of_it(said: Clause) -> bool:
    """ "There must be at most 1 cm between them": of a line it is said of neighbours."""
    told = said.adjuncts[0] if said.verb == "be" and len(said.adjuncts) == 1 else None
    them = isinstance(said.theme, Pronoun) and said.theme.word in ("them", "they", "same")
    mutual = isinstance(told, Loc) and getattr(told.landmark, "word", "") == "each other" and not told.negated
    return them and mutual and isinstance(told, Loc) and told.rel == "distance" and told.high is not None


def _one_line(last: Clause) -> bool:
    """Whether a clause lays blocks in one line, and says nothing of its gaps."""
    shapes = [a.structure for a in last.adjuncts if isinstance(a, Into)]
    shapes += [last.theme] if isinstance(last.theme, Structure) else []
    spaced = any(isinstance(a, Spacing) or (isinstance(a, Loc) and a.rel == "distance") for a in last.adjuncts)
    line = shapes[0] if len(shapes) == 1 and not spaced else None
    return isinstance(line, Structure) and line.kind in ("row", "line", "column") and not line.plural
