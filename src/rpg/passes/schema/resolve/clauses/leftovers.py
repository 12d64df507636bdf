"""What a clause says and no reading of its verb has used."""

from __future__ import annotations

from rpg.language.meaning import Clause, Meaning, Noun, Pronoun, Structure, Traits, Using, parts_of, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse


def all_used(said: Meaning) -> Meaning:
    """ "three towers out of nine red blocks, using every block": said once more, for no number tells otherwise."""
    theme = said.theme if isinstance(said, Clause) and said.verb == "build" else None
    of = theme.members if isinstance(theme, Structure) and not theme.sizes else None
    if not isinstance(said, Clause) or not isinstance(of, Noun) or of.det != "bare" or of.amount is None or of.part_of:
        return said
    used = [x for x in said.adjuncts if isinstance(x, Using)]
    if len(used) != 1 or not _all(used[0].members):
        return said
    return replace(said, adjuncts=tuple(x for x in said.adjuncts if x is not used[0]))


def _all(members: Meaning) -> bool:
    if isinstance(members, Pronoun):
        return members.word in ("all of them", "all", "them all", "everything")
    plain = isinstance(members, Noun) and members.det in ("all", "each") and members.amount is None
    return plain and isinstance(members, Noun) and (members.traits, members.head) == (Traits(), "block")


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
