"""What kind of change a version is, and whether it keeps what that kind promises."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from rpg.ir.base import Record
from rpg.ir.schema import TaskSchema
from rpg.steer.proof.identity import Identity
from rpg.steer.proof.proof import Proof
from rpg.steer.proof.shape import same_duties, same_shape, structures

Category = Literal["TWEAK", "EXTEND", "MODIFY", "PIVOT", "FRESH"]


class Preserve(Record):
    """What an edit promises to leave as it was. Positions are the starts of the blocks that it does not touch."""

    assets: bool
    positions: bool
    goals: bool


@dataclass(frozen=True)
class Verdict:
    """The class of a change, what it preserved, and why it is not the class that the request called for."""

    category: Category
    preserve: Preserve
    reason: str = ""


def classify(old: TaskSchema, new: TaskSchema, proof: Proof, intended: Category) -> Verdict:
    """The class `intended` where the result keeps its guarantee, else the nearest one that does, with the reason.

    Only the wording can tell a recoloured block from a replaced one, so that the request proposes and the result
    disposes.
    """
    identity = Identity(old, new)
    broken: list[str] = []
    for category in (intended, *_fallbacks(intended)):
        reason = _violation(category, identity, proof)
        if reason is None:
            return Verdict(category, _preserve(category, identity, proof), "; ".join(broken))
        broken.append(f"not {category}: {reason}")
    raise AssertionError("a pivot promises nothing that can be broken")


def _fallbacks(intended: Category) -> tuple[Category, ...]:
    order: dict[Category, tuple[Category, ...]] = {
        "TWEAK": ("EXTEND", "MODIFY", "PIVOT"),
        "EXTEND": ("MODIFY", "PIVOT"),
        "MODIFY": ("PIVOT",),
        "PIVOT": (),
        "FRESH": ("PIVOT",),
    }
    return order[intended]


def _violation(category: Category, identity: Identity, proof: Proof) -> str | None:
    """How a change breaks the guarantee of its class; None where it keeps it."""
    match category:
        case "TWEAK":
            return _not_a_tweak(identity)
        case "EXTEND":
            return _not_an_extension(identity, proof)
        case "MODIFY":
            if structures(identity.old.goal) & structures(identity.new.goal) or identity.shared:
                return None
            return "no structure and no block of the reference is left"
        case "FRESH":
            return "it keeps blocks of the reference" if identity.shared else None
        case _:
            return None


def _not_a_tweak(identity: Identity) -> str | None:
    if not same_shape(identity):
        return "the goal changed its shape, not only parameters"
    return None if same_duties(identity) else "blocks have other parts in the goal"


def _not_an_extension(identity: Identity, proof: Proof) -> str | None:
    if proof.diff.assets_removed:
        return f"{', '.join(proof.diff.assets_removed)} left the task"
    if proof.diff.assets_changed:
        return f"{', '.join(change.after for change in proof.diff.assets_changed)} changed"
    if proof.goals.relation not in ("implies", "equal"):
        return f"the new goal does not imply the old one ({proof.goals.relation}, {proof.goals.only_new} states)"
    return None


def _preserve(category: Category, identity: Identity, proof: Proof) -> Preserve:
    """What held, as the proof found it; a fresh task preserves nothing by definition."""
    if category == "FRESH":
        return Preserve(assets=False, positions=False, goals=False)
    changed = {change.before for change in proof.diff.assets_changed}
    return Preserve(
        assets=not identity.removed and not changed,
        positions=bool(identity.untouched) and proof.positions.kept,
        goals=category in ("TWEAK", "EXTEND") and proof.goals.relation in ("equal", "implies"),
    )
