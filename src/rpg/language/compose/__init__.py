"""A third reader: noun phrases, places and clauses with a meaning each, put together in any way.

The grammar and the families read what they know. What both refuse is parsed here by a small grammar in which every
rule is general: any noun phrase may stand wherever one fits (`phrases`, `clauses`). What a way to read the text means
is worked out against a scene of blocks, figures and patches (`nouns`, `statements`), which is then told in plain
sentences (`telling`) that the grammar reads and everything behind it checks. Every word has to be read, and all ways
to read a text that make sense have to come to the same sentences; else there is no reading.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import islice

from rpg.language.compose.clauses import Reader
from rpg.language.compose.items import FIGURES, items_of
from rpg.language.compose.scene import Scene, Unclear
from rpg.language.compose.statements import say
from rpg.language.compose.syntax import Both, Chain, Clause, Made, Noun, Phrase, Place, Predicate, Pronoun
from rpg.language.compose.telling import tell
from rpg.language.frames.retelling import standing
from rpg.language.tokens import Token

_MOST = 300
"""So many ways to read a text are looked at; one with more of them is not read."""


def composed(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text in plain sentences, and the words of that, if all ways to read it come to the same."""
    told = meanings(tokens)
    if len(told) == 1:
        yield standing(told[0], tokens), told[0]


def meanings(tokens: Sequence[Token]) -> list[str]:
    """All that a text can mean, each in plain sentences."""
    items = items_of(tokens)
    if not items:
        return []
    ways = list(islice(Reader(items).readings(), _MOST + 1))
    if len(ways) > _MOST:
        return []
    found: dict[str, None] = {}
    for way in ways:
        scene = Scene()
        with suppress(Unclear):
            _check_in_time(way)
            for clause in way:
                say(scene, clause)
            found[tell(scene)] = None
    return list(found)


def _check_in_time(way: Sequence[Clause]) -> None:
    """What is told to be so, or to be there, beside what is to be done may be so at the start alone."""
    if any(clause.first for clause in way) and not any(clause.later for clause in way):
        raise Unclear
    asks = [n for n, clause in enumerate(way) if clause.mood == "put" or clause.later or _builds_of(clause)]
    for n, clause in enumerate(way):
        ahead = bool(asks) and n < asks[-1]
        told = bool(clause.predicates) or isinstance(clause.subject, Chain)
        if clause.mood == "there" and any(_of_table(said) for said in clause.predicates):
            raise Unclear
        if clause.mood == "there" and len(way) > 1 and (told or (ahead and _is_figure(clause.subject))):
            raise Unclear
        if asks and clause.mood == "so" and isinstance(clause.subject, Noun) and clause.subject.det == "a":
            raise Unclear
        if ahead and told and clause.mood in {"so", ""}:
            raise Unclear
        if n == 0 < len(way) - 1 and clause.mood == "so" and _is_bare(clause.predicates, "table"):
            raise Unclear
        behind = way[n + 1] if n + 1 < len(way) else None
        if behind is None or behind.mood not in {"", "there", "so"}:
            continue
        if clause.mood == "start" != behind.mood or (
            behind.mood == "" and any(_is_denied(p) for p in clause.predicates)
        ):
            raise Unclear
        if _is_figure(clause.subject) and not clause.predicates and _is_figure(behind.subject) and behind.predicates:
            place = behind.predicates[0]
            if isinstance(place, Place) and place.of is not None and not isinstance(place.of, Pronoun):
                raise Unclear  # of both, or of the last one


def _builds_of(clause: Clause) -> bool:
    """Whether something is built of what was told ahead."""
    return clause.mood == "build" and any(isinstance(said, Made) for said in clause.predicates)


def _is_denied(said: Predicate) -> bool:
    return isinstance(said, Place) and said.no


def _is_bare(predicates: Sequence[Predicate], name: str) -> bool:
    return any((isinstance(said, Place) and said.relation == name) or _of_table(said) for said in predicates)


def _of_table(said: Predicate) -> bool:
    return isinstance(said, Place) and isinstance(said.of, Noun) and said.of.noun == "table"


def _is_figure(phrase: Phrase) -> bool:
    if isinstance(phrase, Both):
        return any(map(_is_figure, phrase.parts))
    return isinstance(phrase, Noun) and phrase.noun in FIGURES
