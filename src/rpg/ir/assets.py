"""The objects of a task: plain cubes, cubes with symbols, and flat marks on the table."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from rpg.ir.base import Record

Color = Literal[
    "red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white", "ivory"
]
Face = Literal["top", "bottom", "front", "back", "left", "right"]
FACES: tuple[Face, ...] = ("top", "bottom", "front", "back", "left", "right")

AssetName = Annotated[str, Field(pattern=r"^\w[\w -]{0,59}$")]
"""What an object may be called: letters, digits, underscores; blanks and hyphens within."""
EDGE = 0.04
"""Edge of a block in metres unless the instruction says otherwise."""
PATCH_SIDE = 0.10
"""Side of a goal patch in metres unless the instruction says otherwise."""


class Faces(Record):
    """One symbol per face of a cube; an empty string leaves a face blank."""

    top: str = ""
    bottom: str = ""
    front: str = ""
    back: str = ""
    left: str = ""
    right: str = ""


class ColoredCube(Record):
    """A cube in one plain colour. `size` is its edge in metres.

    `origin`: the name under which its start is drawn, where an edit gave it another name since.
    """

    type: Literal["ColoredCube"] = "ColoredCube"
    name: AssetName
    color: Color
    size: float = Field(EDGE, ge=0.01, le=0.12)
    origin: str | None = None


class SemanticCube(Record):
    """A cube that shows symbols: one `label` on all faces, or one per face in `labels`.

    `size` and `origin` as for a ColoredCube.
    """

    type: Literal["SemanticCube"] = "SemanticCube"
    name: AssetName
    label: str = ""
    labels: Faces | None = None
    color: Color = "ivory"
    size: float = Field(EDGE, ge=0.01, le=0.12)
    origin: str | None = None

    def symbol(self, face: Face) -> str:
        """The symbol on `face` of the block's own frame."""
        return str(getattr(self.labels, face)) if self.labels else self.label


class GoalPatch(Record):
    """A flat mark on the table, fixed and not collidable.

    `size` is its full extent along x and y in metres (a circle's diameter twice); `position` its centre on the table,
    chosen by the compiler when it is not given.
    """

    type: Literal["GoalPatch"] = "GoalPatch"
    name: AssetName
    color: Color
    shape: Literal["square", "rectangle", "circle"] = "square"
    size: tuple[float, float] = (PATCH_SIDE, PATCH_SIDE)
    position: tuple[float, float] | None = None


Block = ColoredCube | SemanticCube
Asset = Annotated[ColoredCube | SemanticCube | GoalPatch, Field(discriminator="type")]
