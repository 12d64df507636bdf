"""Places told in later sentences, of blocks that were only counted: "Three blocks in a row. Red is on the left."."""

from __future__ import annotations

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
    OrderBy,
    Pronoun,
    Structure,
    That,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.orders.onward import onward

_LINES = {"stack": ("bottom", "top", "middle"), "row": ("left", "right", "middle"),
          "line": ("left", "right", "front", "back", "middle"), "column": ("front", "back", "middle")}  # fmt: skip


def places_told(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with what is said of the places of counted blocks of no look as parts of what they form.

    Only where it tells the place of each of them, or of some in a tower: "Red is on the left" after "three blocks in a
    row" could be the left of the table.
    """
    chains = tuple(_one_by_one(_out_of_so(chain)) for chain in chains)
    said = [(n, k) for n, chain in enumerate(chains) for k in range(len(chain.clauses))]
    links, rows = list(links), [list(chain.clauses) for chain in chains]
    joints = [list(chain.links) for chain in chains]
    for at, (n, k) in enumerate(said):
        builder = rows[n][k]
        shape = _counted(builder) if isinstance(builder, Clause) else None
        if shape is None or not isinstance(builder, Clause):
            continue
        kind, many = shape
        parts: list[tuple[int, int, Absolute]] = []
        unread = False
        for line, place in said[at + 1 :]:
            link = joints[line][place] if place else links[line]
            if _inventory(rows[line][place]):
                continue
            told = _told(rows[line][place], _LINES[kind], link)
            told = told or _onward_from([part for _, _, part in parts], rows[line][place])
            if told is None:
                unread = unread or _somewhere(rows[line][place], _LINES[kind])
                break
            parts.append((line, place, told))
        after = said[at + 1] if at + 1 < len(said) else None
        if after is not None and getattr(rows[after[0]][after[1]], "verb", "") == "part":
            rows[n][k] = _stacking(builder)
        some = kind == "stack" or _alternates(builder)
        if unread or not parts or len(parts) > many or (len(parts) < many and not some):
            continue
        rows[n][k] = _stacking(builder)
        for line, place, told in parts:
            rows[line][place] = Clause(verb="part", adjuncts=(told,), mode="goal", span=told.span)
            joints[line][place] = "and"
            links[line] = "and" if place == 0 else links[line]
    return links, tuple(
        replace(chain, clauses=tuple(row), links=tuple(joint))
        for chain, row, joint in zip(chains, rows, joints, strict=True)
    )


def _counted(builder: Clause) -> tuple[str, int] | None:
    """The kind of line, and of how many of its blocks nothing was told."""
    if builder.negated or builder.mode not in ("goal", "command") or builder.verb == "exist":
        return None
    turns = _alternates(builder)
    shapes = [a.structure for a in builder.adjuncts if isinstance(a, Into)]
    shape = builder.theme if isinstance(builder.theme, Structure) else shapes[0] if len(shapes) == 1 else None
    kind = "stack" if shape is None and (builder.verb == "stack" or _heaped(builder)) else getattr(shape, "kind", "")
    if kind not in _LINES or (shape is None and len(builder.adjuncts) > 1):
        return None
    own = _own_places(shape, _LINES[kind])
    if isinstance(shape, Structure) and (shape.plural or shape.traits.colors or (own is None and not turns)):
        return None
    if turns:
        return kind, 1
    blocks = shape.members if isinstance(shape, Structure) and shape is builder.theme else builder.theme
    size = shape.size if isinstance(shape, Structure) and blocks is None else None
    bare = isinstance(blocks, Noun) and blocks.traits == Traits(kind=blocks.traits.kind) and not blocks.part_of
    size = blocks.amount if bare and isinstance(blocks, Noun) and blocks.det == "bare" else size
    return (kind, size.low - (own or 0)) if size is not None and size.low == size.high and size.low > 1 else None


def _own_places(shape: Meaning | None, sides: tuple[str, ...]) -> int | None:
    """In how many places it is told already which block stands there; None where more is said of the structure."""
    details = shape.details if isinstance(shape, Structure) else ()
    told = [part for x in details for part in (x.items if isinstance(x, Coord) and x.op == "absolutes" else (x,))]
    said = [Clause(verb="part", adjuncts=(part,), mode="goal", span=part.span) for part in told]
    return len(told) if all(_told(part, sides, "and") for part in said) else None


def _somewhere(said: Meaning, sides: tuple[str, ...]) -> bool:
    """ "Blue is not on top": something else about places of the line, so that this is not all of it."""
    places = said.adjuncts if isinstance(said, Clause) and said.verb == "be" else ()
    return any(isinstance(a, At) and a.side in sides for a in places)


def _alternates(builder: Clause) -> bool:
    """ "alternating red and white": the first of them is of one of these colours."""
    details = builder.theme.details if isinstance(builder.theme, Structure) else ()
    return any(isinstance(x, OrderBy) and x.by == "alternating" and x.items for x in (*builder.adjuncts, *details))


def _inventory(said: Meaning) -> bool:
    """ ", two of each": how many there are, and nothing of where they go."""
    return isinstance(said, Clause) and said.verb == "exist" and said.mode == "given" and said.theme is None


def _heaped(builder: Clause) -> bool:
    """ "Three blocks, one above the other"."""
    places = [a for a in builder.adjuncts if isinstance(a, Loc)]
    return builder.verb == "be" and len(places) == 1 and places[0].rel == "heaped" and _mutual(places[0].landmark)


def _mutual(mark: Meaning | None) -> bool:
    return isinstance(mark, Pronoun) and mark.word == "each other"


def _stacking(builder: Clause) -> Clause:
    if not _heaped(builder):
        return builder
    return replace(builder, verb="stack", lemma="stack", adjuncts=())


def _told(said: Meaning, sides: tuple[str, ...], link: str) -> Absolute | None:
    """What is said of a place of the line: which block stands there."""
    part = said.adjuncts[0] if isinstance(said, Clause) and said.verb == "part" and len(said.adjuncts) == 1 else None
    if isinstance(part, Absolute) and isinstance(part.adjuncts[0], At) and link == "and":
        one = part.adjuncts[0].side in sides and isinstance(part.theme, Noun) and _single(part.theme)
        return part if one else None
    place = _place(said)
    if place is None or not isinstance(said, Clause) or place.side not in (*sides, "next"):
        return None
    if (link != "and" and place.side != "next") or not isinstance(said.theme, Noun) or not _single(said.theme):
        return None
    return Absolute(theme=said.theme, adjuncts=(place,), span=said.theme.span)


def _onward_from(parts: list[Absolute], said: Meaning) -> Absolute | None:
    """ "(Red is at the bottom, yellow comes next,) green is above yellow": green comes next, too."""
    going = any(isinstance(place := part.adjuncts[0], At) and place.side == "next" for part in parts)
    if not going or not isinstance(said, Clause) or said.verb != "be" or said.negated or len(said.adjuncts) != 1:
        return None
    if not isinstance(said.theme, Noun) or not _single(said.theme) or not isinstance(said.adjuncts[0], Loc):
        return None
    last = onward([*parts, Absolute(theme=said.theme, adjuncts=said.adjuncts, span=said.theme.span)])[-1]
    return last if isinstance(last.adjuncts[0], At) else None


def _place(said: Meaning) -> At | None:
    """The place of a line that a clause says, and nothing else, of its theme."""
    if not isinstance(said, Clause) or said.verb != "be" or said.negated or said.mode != "goal":
        return None
    place = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    return place if isinstance(place, At) else None


def _out_of_so(chain: Chain) -> Chain:
    """ "Stack them so that red is at the bottom, yellow comes next": told as in a sentence behind it."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        last = said.adjuncts[-1] if isinstance(said, Clause) and said.adjuncts else None
        inside = last.clauses if isinstance(last, That) and last.kind == "so" else None
        told = [_place(c) for c in inside.clauses] if isinstance(inside, Chain) else []
        going = any(place is not None and place.side == "next" for place in told)
        if not isinstance(said, Clause) or not isinstance(inside, Chain) or not going:
            clauses.append(said)
            links.append(link)
            continue
        clauses += [replace(said, adjuncts=said.adjuncts[:-1]), *inside.clauses]
        links += [link, "and", *inside.links[1:]]
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _one_by_one(chain: Chain) -> Chain:
    """ "At the bottom is black, then white": white comes next."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        links.append(link)
        if not isinstance(said, Clause) or _place(said) is None or not isinstance(said.theme, Coord):
            clauses.append(said)
            continue
        first, *more = said.theme.items if said.theme.op == "then" else (said.theme,)
        clauses.append(replace(said, theme=first))
        clauses += [replace(said, theme=x, adjuncts=(At(side="next", span=x.span),)) for x in more]
        links += ["and" for _ in more]
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _single(x: Noun) -> bool:
    """One block, told by its look."""
    look = len(x.traits.colors) + len(x.traits.labels) == 1 and x.traits.rank is None and not x.traits.extra
    return look and x.head != "patch" and x.amount in (None, Amount(1, 1)) and not x.plural and x.part_of is None
