"""Which sentences tell of the end, and what there is before that: "There is a row of five. At the end there should be a
tower of five"."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Into, Meaning, Structure, parts_of, replace
from rpg.passes.schema.resolve.clauses.joined_facts import added, demanded, orders_something
from rpg.passes.schema.resolve.clauses.there_later import there_is

END = re.compile(
    r"\b(?:at|in|by) the (?:very )?end\b|\bfinally\b|\bfinal\b|\b(?:finish|end)(?:es|s|ed|ing)?(?: up)? with\b",
    re.IGNORECASE,
)
"""Words of a fact about the end."""
_ASKED = re.compile(r"\b(?:must|should|shall|has to|have to|needs? to|ought to|is to|are to)\b", re.IGNORECASE)


def of_its_end(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    """Whether a sentence has words of the end, the frames around its clauses included; what is ordered "also" comes
    on top of what the sentence in front of it asks for."""
    begun, ended = chains[n].span
    if n + 1 < len(chains) and orders_something(chains[n + 1]) and added(chains[n], chains[n + 1], text):
        return True
    if END.search(text) is None:
        return False
    before = text[chains[n - 1].span[1] if n else 0 : begun]
    after = text[ended : chains[n + 1].span[0] if n + 1 < len(chains) else len(text)]
    own = re.split(r"[.;!?]", before)[-1] + text[begun:ended] + re.split(r"[.;!?:,]|\s[-–—]\s", after)[0]
    return bool(END.search(own))


def there_before(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with structures that there are told of the start where another one is wished for behind them: they
    are no picture of the end. Nor are towers of which the end is told behind them, while the end of a row is a place.
    """
    final = [of_its_end(chains, n, text) or demanded(chains, n, text) for n in range(len(chains))]
    wished = (n for n, chain in enumerate(chains) if any(_wished(c, text, final[n]) for c in chain.clauses))
    last = max(wished, default=0)
    ended = max((n for n in range(1, len(chains)) if _ENDED.search(_before(chains, n, text))), default=0)
    return tuple(
        replace(chain, clauses=tuple(_begun(c, flat=n < last) for c in chain.clauses))
        if n < max(last, ended) and not final[n]
        else chain
        for n, chain in enumerate(chains)
    )


def _before(chains: tuple[Chain, ...], n: int, text: str) -> str:
    """What stands in front of the first words of a sentence, up to the one before it."""
    return text[chains[n - 1].span[1] : chains[n].clauses[0].span[0]]


_ENDED = re.compile(
    r"\b(?:at|in|by) the (?:very )?end\s*(?:of the (?:episode|task|game|run|trial)\s*)?,?\s*$|\bfinally\b", re.I
)
"""Words of the end in front of what is so then."""


def _wished(clause: Meaning, text: str, final: bool) -> bool:
    """Whether a structure that was not spoken of is to be there."""
    if not isinstance(clause, Clause) or clause.mode != "goal" or clause.negated:
        return False
    shapes = [clause.theme, *(x.structure for x in clause.adjuncts if isinstance(x, Into))]
    new = any(isinstance(x, Structure) and x.det in ("a", "bare") for shape in shapes for x in parts_of(shape))
    return new and (final or _ASKED.search(text[slice(*clause.span)]) is not None)


def _begun(clause: Meaning, flat: bool) -> Meaning:
    """The clause, told of the start if it tells of a structure that there is. `flat`: of lines on the table too."""
    theme = clause.theme if there_is(clause) else None
    told = isinstance(theme, Structure) and (flat or theme.kind not in _LINES)
    return replace(clause, lemma="begun") if told and isinstance(clause, Clause) else clause


_LINES = ("row", "line", "column")
