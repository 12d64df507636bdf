"""What is told of a part behind the line that it is of: "a row of five red blocks, but the middle one is blue", "three
blocks one behind the other. The front one is red."."""

from __future__ import annotations

import re

from rpg.language.meaning import (
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
    Places,
    Pronoun,
    Size,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_LINES = ("stack", "row", "line", "column")
_FIGURES = ("plus", "square", "rectangle", "grid", "wall", "pyramid", "triangle", "circle", "T", "L", "U", "V", "X")
_BUT = re.compile(r"\b(?:but|except|only|save|though|however|instead|being)\b", re.IGNORECASE)


_IN_LINE = ("one_behind", "side_by_side")
"""How blocks stand to each other that are in one line."""


def parts_behind(links: list[str], chains: tuple[Chain, ...], text: str) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with each such part told with its line."""
    told: list[str] = []
    found: list[Chain] = []
    for link, chain in zip(links, chains, strict=True):
        clauses: list[Meaning] = []
        inner: list[str] = []
        for n, clause in enumerate(chain.clauses):
            ahead = clauses if clauses else list(found[-1].clauses) if found else []
            then = chain.links[n] if n else link
            joined = _joined(ahead[-1], clause) if ahead and then == "and" else None
            if joined is not None and (whole := _whole(joined, text)) is not None:
                if clauses:
                    clauses[-1] = whole
                else:
                    found[-1] = replace(found[-1], clauses=(*ahead[:-1], whole))
                continue
            alone = _whole(clause, text) if isinstance(clause, Clause) else None
            clauses.append(alone or clause)
            inner.append(chain.links[n])
        if clauses:
            told.append(link)
            found.append(replace(chain, clauses=tuple(clauses), links=tuple(inner)))
    if "instead" in text.lower():
        _check_instead(found, text)
    return told, tuple(found)


def _check_instead(chains: list[Chain], text: str) -> None:
    """Refuse "a tower of red, green and blue. The top one is white instead." as one of them, or a further one."""
    for part in (x for chain in chains for x in parts_of(chain) if isinstance(x, Absolute)):
        if text[part.span[0] : part.span[1]].lower().endswith("instead"):
            raise refuse("misplaced", "it is not said of what this is there instead", part.span,
                         "say it at once, as in 'five red blocks, but the middle one is blue'")  # fmt: skip


_TWO = 2


def _joined(ahead: Meaning, clause: Meaning) -> Clause | None:
    """A clause with what the next one tells of parts, if that is all that it tells."""
    if not isinstance(ahead, Clause) or not isinstance(clause, Clause) or clause.negated:
        return None
    parts = clause.adjuncts if clause.verb == "part" and clause.theme is None else ()
    theme = clause.theme
    looks = {color for part in parts_of(ahead) if isinstance(part, Noun) for color in part.traits.colors}
    none = isinstance(theme, Noun) and (theme.det, theme.amount, theme.part_of) == ("no", None, None)
    none = none and len(looks) == _TWO  # what is no red one there is a blue one
    if none and theme is not None and len(clause.adjuncts) == 1 and isinstance(clause.adjuncts[0], At | Places):
        parts = (Absolute(theme=theme, adjuncts=clause.adjuncts, span=clause.span),)
    return replace(ahead, adjuncts=(*ahead.adjuncts, *parts), span=(ahead.span[0], clause.span[1])) if parts else None


def _whole(clause: Clause, text: str) -> Clause | None:
    return _excepted(clause, text) or _lined(clause) or _without(clause) or _of_several(clause)


def _of_several(clause: Clause) -> Clause | None:
    """ "Four towers stand in a row. The two outer ones are black.": the outer towers."""
    shape, told = clause.theme, clause.adjuncts[-1] if clause.adjuncts else None
    parts = told.items if isinstance(told, Coord) and told.op == "absolutes" else (told,)
    places = [x.adjuncts[0] for x in parts if isinstance(x, Absolute)]
    several = isinstance(shape, Structure) and shape.plural and shape.kind in _LINES and not clause.negated
    some = any(isinstance(x, Places) and x.side in ("outer", "inner") for x in places)
    return clause if several and some and len(places) == len(parts) else None


def _without(clause: Clause) -> Clause | None:
    """ "Stack three red and two blue blocks, but no red one at the bottom": told of the tower."""
    *ahead, last = clause.adjuncts or (None,)
    none = last.theme if isinstance(last, Absolute) else None
    shapes = [clause.theme, *(x.structure for x in ahead if isinstance(x, Into))]
    lines = any(isinstance(x, Structure) and x.kind in _LINES and not x.plural for x in shapes)
    denied = isinstance(none, Noun) and none.det == "no"
    return clause if denied and (lines or clause.verb == "stack") and not clause.negated else None


def _lined(clause: Clause) -> Clause | None:
    """ "Three blocks one behind the other, the front one red": a column of three."""
    place, *parts = clause.adjuncts or (None,)
    rel = place.rel if isinstance(place, Loc) and isinstance(place.landmark, Pronoun) else ""
    told = [x for part in parts for x in (part.items if isinstance(part, Coord) else (part,))]
    counted = isinstance(clause.theme, Noun) and clause.theme.amount is not None and clause.theme.plural
    if rel not in _IN_LINE or not told or not counted or clause.negated or not isinstance(place, Loc) or place.mods:
        return None
    first = told[0].adjuncts[0] if isinstance(told[0], Absolute) else None
    placed = (At, Places, Loc) if isinstance(first, At) else (At, Places)  # "the one behind it"
    if place.negated or not all(isinstance(x, Absolute) and isinstance(x.adjuncts[0], placed) for x in told):
        return None
    line = Structure(kind="column", det="a", amount=Amount(1, 1), span=place.span)
    ahead: Meaning = Into(structure=line, span=place.span) if rel == "one_behind" else place
    return replace(clause, adjuncts=(ahead, *told))


def _excepted(clause: Clause, text: str) -> Clause | None:
    shape, sizes = clause.theme, [x for x in clause.adjuncts if isinstance(x, Size)]
    told = [x for x in clause.adjuncts if not isinstance(x, Size)]
    parts = [x for part in told for x in (part.items if isinstance(part, Coord) else (part,))]
    if not isinstance(shape, Structure) or shape.plural or not parts or clause.negated or clause.verb != "build":
        return None
    blocks, lines = shape.members, shape.kind in _LINES
    if not isinstance(blocks, Noun) or shape.details or shape.kind not in (*_LINES, *_FIGURES):
        return None
    color = shape.traits.colors or blocks.traits.colors
    plain = {replace(x, colors=()) for x in (shape.traits, blocks.traits)} == {Traits()}
    many = blocks.amount
    alone = blocks.det == "bare" and (many.low == many.high if many is not None else not lines)
    if not plain or not alone or len(color) != 1 or (lines and (shape.sizes or sizes)):
        return None
    if not all(isinstance(x, Absolute) and _in_part(x) and _other_look(x.theme, color[0]) for x in parts):
        return None
    if _BUT.search(text[shape.span[1] : clause.span[1]]) is None:
        return None
    parts = [replace(x, span=x.theme.span) for x in parts if isinstance(x, Absolute)]
    if many is None:  # of a grid: as many as it takes
        return replace(clause, adjuncts=(*sizes, *parts))
    others = Noun(head="any", traits=Traits(colors=color), span=blocks.span)
    rest = Absolute(theme=others, adjuncts=(Places(side="rest", unit="block", span=blocks.span),), span=blocks.span)
    bare = replace(shape, members=replace(blocks, traits=Traits()), traits=Traits())
    if lines:
        size = Size(what="size", amount=many, span=blocks.span)
        bare = replace(bare, members=None, sizes=(size,))
    return replace(clause, theme=bare, adjuncts=(*sizes, *parts, rest))


def _in_part(item: Absolute) -> bool:
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    return isinstance(place, At) or (isinstance(place, Places) and place.side != "rest")


def _other_look(look: Meaning, color: str) -> bool:
    if not isinstance(look, Noun) or look.det not in ("bare", "some") or look.amount is not None:
        return False
    return look.traits == Traits(colors=look.traits.colors[:1]) and look.traits.colors not in ((), (color,))
