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
    are no picture of the end."""
    final = [of_its_end(chains, n, text) or demanded(chains, n, text) for n in range(len(chains))]
    wished = (n for n, chain in enumerate(chains) if any(_wished(c, text, final[n]) for c in chain.clauses))
    last = max(wished, default=0)
    return tuple(
        replace(chain, clauses=tuple(map(_begun, chain.clauses))) if n < last and not final[n] else chain
        for n, chain in enumerate(chains)
    )


def _wished(clause: Meaning, text: str, final: bool) -> bool:
    """Whether a structure that was not spoken of is to be there."""
    if not isinstance(clause, Clause) or clause.mode != "goal" or clause.negated:
        return False
    shapes = [clause.theme, *(x.structure for x in clause.adjuncts if isinstance(x, Into))]
    new = any(isinstance(x, Structure) and x.det in ("a", "bare") for shape in shapes for x in parts_of(shape))
    return new and (final or _ASKED.search(text[slice(*clause.span)]) is not None)


def _begun(clause: Meaning) -> Meaning:
    """The clause, told of the start if it tells of a structure that there is."""
    return replace(clause, lemma="begun") if there_is(clause) and isinstance(clause.theme, Structure) else clause
