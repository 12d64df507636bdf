"""Lines that are there before an order and are told in parts: "there is a tower, red at the bottom, blue on it"."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Absolute,
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
    Quality,
    Structure,
    Toward,
    Traits,
    Using,
    parts_of,
    replace,
)

_SEE = re.compile(
    r"(?:now |here |first |currently |right now )?(?:i|you|we|the robot|the camera)(?: can| now)? sees?,?:?",
    re.IGNORECASE,
)
_DOING = ("place", "pick", "unstack", "reverse", "swap", "turn", "use")


def _seen_there(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "You see a tower of two red blocks. Put a blue block on it.": what is seen before something is done to what is
    there, is there."""
    first = chains[0].clauses[0]
    seen = _SEE.fullmatch(text[: first.span[0]].strip()) is not None
    done = (c for chain in chains[1:] for c in chain.clauses if isinstance(c, Clause) and c.mode == "command")
    acts = [c for c in done if not c.negated]
    shown = isinstance(first, Clause) and (first.verb, first.mode) == ("build", "goal") and not first.negated
    if not seen or not shown or len(chains[0].clauses) > 1 or not acts or acts[0].verb not in _DOING:
        return chains
    assert isinstance(first, Clause)
    there = replace(first, verb="exist", mode="given", cost=0)
    return (replace(chains[0], clauses=(there,)), *chains[1:])


_ASKED = re.compile(
    r"\b(?:must|should|shall|has to|have to|needs? to|ought|will|may|can|let|want|wish|make|put|end|finally|final)\b",
    re.IGNORECASE,
)
_ENDS_OF = {"stack": ("bottom", "top", "middle", "next"), "row": ("left", "right", "middle", "next", "ends"),
            "column": ("front", "back", "middle", "next", "ends")}  # fmt: skip
"""Where a part of a line is, so that it is told of the line and not of a place on the table."""


def told_in_parts(chains: tuple[Chain, ...], ordered: int, text: str) -> tuple[Chain, ...]:
    """ "There is a tower, red at the bottom, white above it, blue on top. Put the blue block on the table.": the parts
    of what is there before the last order (the sentence `ordered`) are told with it, of how it is then."""
    chains = _seen_there(chains, text)
    found: list[list[tuple[str, Meaning]]] = []
    whole: Clause | None = None
    at = (0, 0)
    for n, chain in enumerate(chains):
        found.append([])
        for link, said in zip(chain.links, chain.clauses, strict=True):
            told = isinstance(said, Clause) and whole is not None and link == "and" and n < ordered
            alone = n > at[0] and len(chain.clauses) == 1 and isinstance(said, Clause) and isinstance(said.theme, Noun)
            told = told and not (alone and _of_it(chains[n + 1]))
            if told and isinstance(said, Clause) and whole is not None and _of_a_part(said, whole, text):
                whole = _with_part(whole, said)
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
    lines = said.verb == "stack" or (said.lemma == "fact" and any(isinstance(a, Into) for a in said.adjuncts))
    return said.mode == "goal" and not said.negated and ways and lines


def _of_it(chain: Chain) -> bool:
    """ "(There is a tower of three blocks. The red one is on top.) Put it on the table.": "it" is the part."""
    return any(isinstance(part, Pronoun) and part.word == "it" for part in parts_of(chain.clauses[0]))


def _with_part(whole: Clause, said: Clause) -> Clause:
    if (order := _read_along(said)) is not None:
        return replace(whole, adjuncts=(*whole.adjuncts, order))
    if said.verb != "be" or said.theme is None:
        return replace(whole, adjuncts=(*whole.adjuncts, *said.adjuncts))
    part = Absolute(theme=said.theme, adjuncts=said.adjuncts, span=said.span)
    had = [a for a in whole.adjuncts if isinstance(a, Absolute) or (isinstance(a, Coord) and a.op == "absolutes")]
    told = [item for a in had for item in (a.items if isinstance(a, Coord) else (a,))]
    rest = tuple(a for a in whole.adjuncts if a not in had)
    return replace(whole, adjuncts=(*rest, Coord(op="absolutes", items=(*told, part), span=said.span)))


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
    """Whether a clause says that a line is there."""
    shape = said.theme
    begun_ = (said.verb == "exist" or said.mode == "start" or said.lemma == "fact") and not said.negated
    line = isinstance(shape, Structure) and shape.kind in _ENDS_OF and not shape.plural and shape.det in ("a", "bare")
    return begun_ and line and said.lemma in ("", "fact", "begun")


def _of_a_part(said: Clause, whole: Clause, text: str) -> bool:
    """Whether a clause tells, and does not ask, where a part of the line is."""
    if said.mode not in ("goal", "start") or said.negated or _ASKED.search(text[slice(*said.span)]) is not None:
        return False
    if said.verb == "part" or (said.verb == "build" and getattr(said.theme, "det", "") == "the"):
        return True
    if said.verb == "arrange" and said.theme is None:
        return all(isinstance(a, Toward | OrderBy) for a in said.adjuncts)
    if said.lemma == "fact" and _read_along(said) is not None:
        return True
    sides = _ENDS_OF[whole.theme.kind] if isinstance(whole.theme, Structure) else ()
    return (
        said.lemma == "fact"
        and bool(said.adjuncts)
        and all(isinstance(a, At) and a.side in sides for a in said.adjuncts)
    )
