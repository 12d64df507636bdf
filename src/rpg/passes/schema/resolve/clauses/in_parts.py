"""Lines that are there before an order and are told in parts: "there is a tower, red at the bottom, blue on it"."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Quality,
    Structure,
    Toward,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.joined_facts import by_itself, orders_something

_SEE = re.compile(
    r"(?:now |here |first |currently |right now )?(?:i|you|we|the robot|the camera)(?: can| now)? sees?,?:?"
    r"|here (?:is|are):?",
    re.IGNORECASE,
)
_DOING = ("place", "pick", "build", "stack", "unstack", "reverse", "swap", "turn", "use", "remove")


def _seen_there(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "You see a tower of two red blocks. Put a blue block on it.": what is seen before something is done to what is
    there, or before what is said of the end, is there."""
    first, seen = chains[0].clauses[0], chains[0].clauses
    done = (c for chain in chains[1:] for c in chain.clauses if isinstance(c, Clause) and c.mode == "command")
    act = next((c for c in done if not c.negated), None)
    them = act is not None and any(isinstance(part, Pronoun) for part in parts_of(act))  # "make a tower of them"
    later = (act is not None and (act.verb in _DOING or them)) or _LATER.search(text[chains[0].span[1] :]) is not None
    if _SEE.fullmatch(text[: first.span[0]].strip()) is None or not later or not all(map(_shown, seen)):
        return chains
    there = (_as_there(c) for c in seen if isinstance(c, Clause))
    return (replace(chains[0], clauses=tuple(there)), *chains[1:])


_LATER = re.compile(r"\b(?:afterwards?|at the end|in the end|finally)\b", re.IGNORECASE)


def _shown(said: Meaning) -> bool:
    return isinstance(said, Clause) and said.verb in ("build", "be") and said.mode == "goal" and not said.negated


def _as_there(said: Clause) -> Clause:
    return replace(said, mode="start") if said.verb == "be" else replace(said, verb="exist", mode="given", cost=0)


_ASKED = re.compile(
    r"\b(?:must|should|shall|has to|have to|needs? to|ought|will|may|can|let|want|wish|make|put|end|finally|final)\b",
    re.IGNORECASE,
)
_RANKS = ("left", "right", "middle", "top", "bottom", "front", "back")
_ENDS_OF = {"stack": ("bottom", "top", "middle", "next"), "row": ("left", "right", "middle", "next", "ends"),
            "column": ("front", "back", "middle", "next", "ends")}  # fmt: skip
"""Where a part of a line is, so that it is told of the line and not of a place on the table."""


def before_orders(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """What is told before the last sentence that orders something."""
    last = max((n for n, chain in enumerate(chains) if orders_something(chain)), default=0)
    return _told_in_parts(by_itself(chains, last), last, text)


def _told_in_parts(chains: tuple[Chain, ...], ordered: int, text: str) -> tuple[Chain, ...]:
    """ "There is a tower, red at the bottom, white above it, blue on top. Put the blue block on the table.": the parts
    of what is there before the last order (the sentence `ordered`) are told with it, of how it is then."""
    chains = _seen_there(chains, text)
    found: list[list[tuple[str, Meaning]]] = []
    whole: Clause | None = None
    at = (0, 0)
    for n, chain in enumerate(chains):
        found.append([])
        gapped = False
        for link, said in zip(chain.links, chain.clauses, strict=True):
            told = isinstance(said, Clause) and whole is not None and link == "and" and n < ordered
            alone = n > at[0] and len(chain.clauses) == 1 and isinstance(said, Clause) and isinstance(said.theme, Noun)
            told = told and not (alone and _of_it(chains[n + 1]))
            if told and isinstance(said, Clause) and whole is not None and _of_a_part(said, whole, text, gapped):
                whole, gapped = _with_part(whole, said), True
                found[at[0]][at[1]] = (found[at[0]][at[1]][0], whole)
                continue
            whole = said if isinstance(said, Clause) and _there(said) else None
            at = (n, len(found[-1]))
            found[-1].append((link, said))
    kept = zip(chains, found, strict=True)
    return tuple(
        replace(chain, clauses=tuple(c for _, c in told), links=tuple(link for link, _ in told))
        for chain, told in kept
        if told
    )


def links_left(links: list[str], chains: tuple[Chain, ...], told: tuple[Chain, ...]) -> list[str]:
    """The links of the sentences that are left in `told`, where those of `chains` that tell parts are told with others.

    Raises AssertionError if a sentence is in neither.
    """
    spans = {chain.span for chain in told}
    left = [link for link, chain in zip(links, chains, strict=True) if len(told) == len(chains) or chain.span in spans]
    assert len(left) == len(told)
    return left


def says_where(said: Clause) -> bool:
    """Whether a clause says nothing but where something is, or of a line how it is made up as well."""
    line = isinstance(said.theme, Structure) or any(isinstance(a, Into) for a in said.adjuncts)
    inner = (Absolute, OrderBy, Toward, Using, At, Coord) if line else ()
    told = (isinstance(a, (Loc, In, Into, *inner)) or _with_it(a) for a in said.adjuncts)
    return bool(said.adjuncts) and all(told)


def _with_it(told: Meaning) -> bool:
    """ "(a red block stands on the table) with a white block on it"."""
    parts = told.items if isinstance(told, Coord) and told.op == "absolutes" else (told,)
    absolutes = [part for part in parts if isinstance(part, Absolute)]
    return len(absolutes) == len(parts) and all(isinstance(a, Loc | In) for part in absolutes for a in part.adjuncts)


_LIES = re.compile(r"\b(?:is|are|stands?|lies?|sits?|rests?)\b", re.IGNORECASE)


def lie_so(chain: Chain, text: str, bold: bool) -> bool:
    """ "Four pink cubes are stacked up", "the letters A, B and C stand in a row from left to right": whether all of a
    sentence tells, and does not ask, how blocks lie on each other or (`bold`) beside each other."""
    told = [c for c in chain.clauses if isinstance(c, Clause)]
    said = (text[slice(*c.span)] for c in told)
    if any(_LIES.search(words) is None or _ASKED.search(words) for words in said):
        return False
    return len(told) == len(chain.clauses) and all(_lined_up(c) and (bold or c.verb == "stack") for c in told)


def _lined_up(said: Clause) -> bool:
    ways = all(isinstance(a, Into | Toward | OrderBy | Using | At | Coord | Absolute | Loc) for a in said.adjuncts)
    lines = (
        said.verb == "stack"
        or said.lemma in ("line", "align")
        or (said.lemma == "fact" and any(isinstance(a, Into) for a in said.adjuncts))
    )
    return said.mode == "goal" and not said.negated and ways and lines


def _of_it(chain: Chain) -> bool:
    """ "(There is a tower of three blocks. The red one is on top.) Put it on the table.": "it" is the part."""
    return any(isinstance(part, Pronoun) and part.word == "it" for part in parts_of(chain.clauses[0]))


def _with_part(whole: Clause, said: Clause) -> Clause:
    new: tuple[Meaning, ...] = said.adjuncts
    if (order := _read_along(said)) is not None:
        new = (order,)
    elif said.verb == "be" and said.theme is not None:
        new = (_looked_up(said) or Absolute(theme=said.theme, adjuncts=_beside_it(said), span=said.span),)
    every = (*whole.adjuncts, *new)
    told = [a for a in every if isinstance(a, Absolute) or (isinstance(a, Coord) and a.op == "absolutes")]
    items = tuple(_in_it(item) for a in told for item in (a.items if isinstance(a, Coord) else (a,)))
    rest = tuple(a for a in every if a not in told)
    parts = (Coord(op="absolutes", items=items, span=said.span),) if items else ()
    return replace(whole, adjuncts=(*rest, *parts))


def _in_it(part: Meaning) -> Meaning:
    """A part of the one line there is: "in the middle" is a place in it, and not which of several lines it is."""
    where = part.adjuncts[0] if isinstance(part, Absolute) and len(part.adjuncts) == 1 else None
    if not isinstance(part, Absolute) or not isinstance(where, Places) or where.unit != "whole" or where.several:
        return part
    return replace(part, adjuncts=(At(side=where.side, index=where.index, span=where.span),))


def _looked_up(said: Clause) -> Absolute | None:
    """ "The leftmost one is red"."""
    look = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    side = said.theme.traits.rank if isinstance(said.theme, Noun) else None
    if side not in _RANKS or not isinstance(look, Quality) or look.negated:
        return None
    block = Noun(head="any", det="bare", traits=look.traits, span=look.span)
    return Absolute(theme=block, adjuncts=(At(side=side, span=said.span),), span=said.span)


def _beside_it(said: Clause) -> tuple[Meaning, ...]:
    """Where a part is: "(red on the left,) white next to it" is the next place."""
    loc = said.adjuncts[0]
    mark = loc.landmark if isinstance(loc, Loc) and loc.rel == "beside" else None
    it = isinstance(mark, Pronoun) and mark.word == "it"
    return (At(side="next", span=loc.span),) if it and len(said.adjuncts) == 1 else said.adjuncts


def _read_along(said: Clause) -> OrderBy | None:
    """ "From bottom to top it is red, white, blue"."""
    looks = next((a for a in said.adjuncts if isinstance(a, Quality)), None)
    way = next((a for a in said.adjuncts if isinstance(a, Toward)), None)
    it = isinstance(said.theme, Pronoun) and said.theme.word == "it"
    if not it or looks is None or way is None or len(said.adjuncts) > 2 or looks.negated:
        return None
    items = tuple(
        Noun(head="any", det="bare", traits=Traits(colors=(color,)), span=looks.span) for color in looks.traits.colors
    )
    return OrderBy(by="named", items=items, first=way.first, attribute="color", span=said.span)


def _there(said: Clause) -> bool:
    """Whether a clause says that a line is there, or that blocks are in one."""
    shape = _line_of(said)
    begun_ = (said.verb == "exist" or said.mode == "start" or said.lemma == "fact") and not said.negated
    line = isinstance(shape, Structure) and shape.kind in _ENDS_OF and not shape.plural and shape.det in ("a", "bare")
    return begun_ and line and said.lemma in ("", "fact", "begun")


def _line_of(said: Clause) -> Meaning | None:
    """The line that is there: "a row ..." or "three blocks are in a row"."""
    if isinstance(said.theme, Noun):
        return next((a.structure for a in said.adjuncts if isinstance(a, Into)), None)
    return said.theme


def _of_a_part(said: Clause, whole: Clause, text: str, gapped: bool) -> bool:
    """Whether a clause tells, and does not ask, where a part of the line is. `gapped`: it goes on with what is told in
    the same sentence, "(on the left is red,) on the right blue"."""
    if said.mode not in ("goal", "start") or said.negated or _ASKED.search(text[slice(*said.span)]) is not None:
        return False
    if said.verb == "part" or (said.verb == "build" and getattr(said.theme, "det", "") == "the"):
        return True
    if said.verb == "arrange" and said.theme is None:
        return all(isinstance(a, Toward | OrderBy) for a in said.adjuncts)
    if said.lemma == "fact" and _read_along(said) is not None:
        return True
    line = _line_of(whole)
    sides = _ENDS_OF[line.kind] if isinstance(line, Structure) else ()
    where = _beside_it(said) if said.adjuncts and (said.lemma == "fact" or gapped) else ()
    placed = bool(where) and all(isinstance(a, At) and a.side in sides for a in where)
    return placed or (said.lemma == "fact" and _looked_up(said) is not None)
