"""What a clause says and no reading of its verb has used."""

from __future__ import annotations

from rpg.language.meaning import Clause, Noun, parts_of
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse


def nothing_left(spec: Spec, clause: Clause) -> None:
    """Refuse what no reading of the verb has used: a word must never be dropped in silence."""
    for name in (
        "orders",
        "toward",
        "ats",
        "absolutes",
        "usings",
        "patterns",
        "spacings",
        "sizes",
        "places",
        "intos",
        "qualities",
        "parts",
    ):
        for item in getattr(spec, name):
            raise refuse(
                "misplaced",
                "this is understood, but does not fit what is said here",
                item.span,
                "say it in a sentence of its own",
            )
    said_again = {"extra"} if any(isinstance(x, Noun) and x.traits.extra for x in parts_of(clause)) else set()
    for manner in spec.manners:
        if manner.kind not in {"idle", "finally", "always", *said_again}:
            raise refuse(
                "misplaced",
                "this is understood, but does not fit what is said here",
                manner.span,
                "say it in a sentence of its own",
            )
