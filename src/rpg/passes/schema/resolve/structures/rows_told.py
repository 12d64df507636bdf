"""Words in rows of which nothing else is said: "CAT in the far row and DOG in the near row"."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Places,
    Size,
    Structure,
    TableTop,
    Traits,
    replace,
)

_SIDES = ("front", "back", "middle")
_HOSTS = ("row", "word", "grid")


def words_in_rows(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, where words that are each told with their row make up so many rows."""
    chains = tuple(map(_each_its_own, chains))
    told = [(n, k, _told(c)) for n, chain in enumerate(chains) for k, c in enumerate(chain.clauses)]
    parts = [part for _, _, found in told for part in found]
    sides = [place.side for part in parts for place in part.adjuncts if isinstance(place, Places)]
    first = next(((n, k) for n, k, found in told if found), None)
    last = max(((n, k) for n, k, found in told if found), default=(0, 0))
    if first is None or len(parts) < 2 or len(set(sides)) < len(sides) or _in_time(links, chains):
        return links, chains
    many = [getattr(chains[n].clauses[k], "theme", None) for n, k, found in told if found]
    counted = {x.amount for x in many if isinstance(x, Structure) and x.plural and x.amount is not None}
    if counted - {Amount(len(parts), len(parts))}:
        return links, chains  # "three words: CAT in the far row and DOG in the near row"
    hosts = [(n, k) for n, chain in enumerate(chains) for k, c in enumerate(chain.clauses) if _hosts(c, len(parts))]
    host = hosts[0] if hosts else first
    if len(hosts) > 1 or (hosts and (host < last or not _bare_grid(chains[host[0]].clauses[host[1]]))):
        return links, chains
    out = []
    for n, chain in enumerate(chains):
        kept = [
            (link, _rows(parts, c if hosts else None) if (n, k) == host else c)
            for k, (link, c) in enumerate(zip(chain.links, chain.clauses, strict=True))
            if (n, k) == host or not (_told(c) or _announced(c, len(parts)))
        ]
        if kept:
            whole = replace(chain, links=tuple(link for link, _ in kept), clauses=tuple(c for _, c in kept))
            out.append((links[n], whole))
    return [link for link, _ in out], tuple(chain for _, chain in out)


def _each_its_own(chain: Chain) -> Chain:
    """ "Spell GO and NO as two words", "... in two towers": each of them has its own line or tower."""
    words = [c for c in chain.clauses if isinstance(c, Clause) and _spells(c)]
    if len(words) < 2:
        return chain
    clauses: list[Meaning] = []
    for clause in chain.clauses:
        if isinstance(clause, Clause) and _spells(clause):
            own = [x for a in clause.adjuncts if (x := _own_line(a, len(words))) is not None]
            clause = replace(clause, adjuncts=tuple(own))
        clauses.append(clause)
    return replace(chain, clauses=tuple(clauses))


def _spells(clause: Clause) -> bool:
    return clause.verb == "spell" and isinstance(clause.theme, Structure) and bool(clause.theme.letter)


def _own_line(told: Meaning, many: int) -> Meaning | None:
    """What is left to say of one word where so many rows, words or towers are told for so many words."""
    size = told.amount if isinstance(told, Size) and told.what == "rows" else None
    shape = told.structure if isinstance(told, Into) else None
    if size == Amount(many, many):
        return None
    if not isinstance(told, Into) or not isinstance(shape, Structure) or shape.amount != Amount(many, many):
        return told
    if shape.members or shape.sizes or shape.dims or shape.details or replace(shape.traits, shade=None) != Traits():
        return told
    if shape.kind == "stack":
        return replace(told, structure=replace(shape, plural=False, amount=Amount(1, 1), det="a"))
    return None if shape.kind in ("word", "row", "line") else told


def _in_time(links: list[str], chains: tuple[Chain, ...]) -> bool:
    return any(link != "and" for link in (*links, *(link for chain in chains for link in chain.links[1:])))


def _bare_grid(clause: Meaning) -> bool:
    """ "..., together a 2x3 grid": told behind its rows, and nothing else said of it."""
    if not isinstance(clause, Clause) or any(getattr(a, "rel", "") != "together" for a in clause.adjuncts):
        return False
    shape = clause.theme if clause.verb == "build" else None
    plain = isinstance(shape, Structure) and shape.kind in ("grid", "square") and shape.members is None
    return plain and isinstance(shape, Structure) and shape.traits == Traits() and not shape.details


def _rows(parts: list[Absolute], host: Meaning | None = None) -> Clause:
    span = (parts[0].span[0], parts[-1].span[1])
    if isinstance(host, Clause):
        return replace(host, adjuncts=(Coord(op="absolutes", items=tuple(parts), span=span),))
    parts = [_listed(part) for part in parts]
    rows = Structure(kind="row", det="bare", amount=Amount(len(parts), len(parts)), plural=True, span=span)
    whole = Coord(op="absolutes", items=tuple(parts), span=span)
    return Clause(verb="build", theme=rows, adjuncts=(whole,), mode="goal", span=span)


def _listed(part: Absolute) -> Absolute:
    """Blocks told one by one, as rows of their own have them."""
    items = part.theme.items if isinstance(part.theme, Coord) else ()
    marks = [x.traits for x in items if isinstance(x, Noun)]
    if not marks:
        return part
    all_ = Traits(colors=tuple(c for m in marks for c in m.colors), labels=tuple(c for m in marks for c in m.labels))
    return replace(part, theme=Noun(head="any", plural=bool(all_.labels), traits=all_, span=part.theme.span))


def _told(clause: Meaning) -> tuple[Absolute, ...]:
    """The words that a clause puts into rows, if it says no more."""
    if not isinstance(clause, Clause) or clause.negated or clause.mode == "start":
        return ()
    if clause.verb == "part":
        items = [x for a in clause.adjuncts for x in (a.items if isinstance(a, Coord) else (a,))]
        found = tuple(x for x in items if isinstance(x, Absolute) and _in_row(x))
        found = tuple(replace(x, adjuncts=(replace(x.adjuncts[0], unit="row"),)) for x in found)
        return found if found and len(found) == len(items) else ()
    into = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    row = into.structure if isinstance(into, Into) else None
    word = clause.theme
    if clause.verb not in ("spell", "build") or not isinstance(word, Structure) or not _word(word):
        return ()
    if not isinstance(row, Structure) or row.kind != "row" or row.det != "the" or row.traits.rank not in _SIDES:
        return ()
    if row.traits != Traits(rank=row.traits.rank) or row.members or row.sizes:
        return ()
    place = Places(side=row.traits.rank or "", unit="row", span=row.span)
    one = replace(word, plural=False, amount=None)
    return (Absolute(theme=one, adjuncts=(place,), span=clause.span),)


def _in_row(part: Absolute) -> bool:
    place = part.adjuncts[0] if len(part.adjuncts) == 1 else None
    if not isinstance(place, Places) or place.unit not in ("row", "whole") or place.side not in _SIDES:
        return False
    if isinstance(part.theme, Structure):
        return _word(part.theme)
    theme = part.theme
    if isinstance(theme, Coord):
        return place.unit == "row" and theme.op == "then"
    if isinstance(theme, Noun) and theme.amount is not None and theme.amount.low == theme.amount.high != 1:
        return place.unit == "row" and theme.part_of is None and bool(theme.traits.colors) and theme.det == "bare"
    if not isinstance(theme, Noun) or theme.det != "bare" or theme.amount is not None or theme.traits.either:
        return False
    return place.unit == "row" and max(len(theme.traits.labels), len(theme.traits.colors)) > 1


def _word(theme: Structure) -> bool:
    return theme.kind == "word" and theme.letter is not None and len(theme.letter) > 1 and not theme.details


def _announced(clause: Meaning, many: int) -> bool:
    """ "Two words on the table": no more than how many there are."""
    words = clause.theme if isinstance(clause, Clause) and clause.verb == "build" else None
    if not isinstance(words, Structure) or words.kind != "word" or words.letter is not None or words.details:
        return False
    there = all(isinstance(a, Loc) and isinstance(a.landmark, TableTop) for a in getattr(clause, "adjuncts", ()))
    return there and words.plural and words.amount == Amount(many, many)


def _hosts(clause: Meaning, many: int) -> bool:
    """Whether a clause builds what these could be rows of."""
    if not isinstance(clause, Clause) or _told(clause) or _announced(clause, many):
        return False
    shapes = [clause.theme, *(a.structure for a in clause.adjuncts if isinstance(a, Into))]
    return any(isinstance(x, Structure) and x.kind in _HOSTS for x in shapes)
