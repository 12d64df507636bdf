"""An edit under construction: the schema so far, the typed edits that led there, and what is to be told about them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from rpg.core.diagnostics import Diagnostic, Refusal, Span
from rpg.ir.assets import Asset
from rpg.ir.edits import AddAsset, Edit, EditError, step
from rpg.ir.schema import TaskSchema
from rpg.ir.shrink import TooSmall
from rpg.steer.proof.classify import Category
from rpg.steer.view import View

RANK: tuple[Category, ...] = ("TWEAK", "EXTEND", "MODIFY", "PIVOT", "FRESH")


@dataclass
class Draft:
    """`focus`: objects mentioned or added last. `kept`: objects that the request wants left where they are.
    `beside`: the relation and the objects that something new was last put in, in this request.
    """

    schema: TaskSchema
    focus: tuple[str, ...] = ()
    edits: list[Edit] = field(default_factory=list)
    intent: Category = "TWEAK"
    parameters: dict[str, Any] = field(default_factory=dict)
    assumptions: list[str] = field(default_factory=list)
    kept: tuple[str, ...] = ()
    beside: tuple[str, Any] | None = None

    def do(self, edit: Edit, span: Span | None = None) -> None:
        """Apply one edit; what it breaks is refused, at the words that asked for it."""
        try:
            self.schema = step(self.schema, edit)
        except (EditError, TooSmall) as error:
            raise self.refusal(
                "breaks-structure", str(error), span, "change the structure first, or say what it should be"
            ) from error
        self.edits.append(edit)
        self.__dict__.pop("view", None)

    @cached_property
    def view(self) -> View:
        """The schema so far, as phrases may speak of it."""
        return View(self.schema, self.focus)

    def add(self, assets: list[Asset], span: Span | None = None) -> tuple[str, ...]:
        """New objects; they become the focus."""
        for asset in assets:
            self.do(AddAsset(asset=asset), span)
        self.look_at(tuple(asset.name for asset in assets))
        return self.focus

    def look_at(self, names: tuple[str, ...]) -> None:
        """These objects were mentioned last."""
        self.focus = names
        self.__dict__.pop("view", None)

    def aim(self, category: Category) -> None:
        """The request calls for at least this class of change."""
        self.intent = max(self.intent, category, key=RANK.index)

    def note(self, key: str, value: Any) -> None:
        """Record a structured parameter of the request."""
        self.parameters.setdefault(key, []).append(value)

    def assume(self, text: str) -> None:
        """Record a reading that the request left open."""
        if text not in self.assumptions:
            self.assumptions.append(text)

    def refusal(self, code: str, message: str, span: Span | None, hint: str | None = None) -> Refusal:
        """A refusal at a place in the request."""
        return Refusal([Diagnostic(code=code, message=message, span=span, hint=hint, origin="steer")])
