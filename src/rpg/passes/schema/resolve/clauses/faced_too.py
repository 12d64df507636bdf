""" "A faces left and B right": which way the next one faces, without a verb of its own."""

from __future__ import annotations

import re

from rpg.language.meaning import Absolute, At, Chain, Clause, In, Manner, Meaning, replace

_PLACED = re.compile(r"\b(?:half|side|on|in|at)\b")
"""A side told so is a place."""
_REGIONS = {"left_half": "left", "right_half": "right"}


def faced_too(chain: Chain, text: str) -> Chain:
    """The sentence with a bare side behind what faces some way told as a way to face as well."""
    clauses = list(chain.clauses)
    for n, said in enumerate(clauses[1:], 1):
        before = clauses[n - 1]
        faces = _faces(before) if chain.links[n] == "and" else None
        verbless = isinstance(said, Clause) and said.word in (None, getattr(before, "word", None))
        side = _bare_side(said) if verbless and not _PLACED.search(text[slice(*said.span)]) else None
        if faces is not None and side is not None and isinstance(said, Clause):
            too = replace(faces, value=side, span=said.adjuncts[0].span)
            clauses[n] = replace(said, adjuncts=(too,))
    return replace(chain, clauses=tuple(clauses)) if tuple(clauses) != chain.clauses else chain


def _faces(said: Meaning) -> Manner | None:
    """The way that something faces, told last in a clause."""
    last = said.adjuncts[-1] if isinstance(said, Clause | Absolute) and said.adjuncts else None
    if isinstance(last, Absolute):
        return _faces(last)
    return last if isinstance(last, Manner) and last.kind == "facing" and last.value in ("left", "right") else None


def _bare_side(said: Meaning) -> str | None:
    """The side that a clause tells, and no more: "B right", "B to the right"."""
    place = said.adjuncts[0] if isinstance(said, Clause) and said.verb == "be" and len(said.adjuncts) == 1 else None
    if isinstance(place, In) and place.vague and not place.negated:
        return _REGIONS.get(place.region)
    return place.side if isinstance(place, At) and place == At(side=place.side, span=place.span) else None
