"""Colours, and pictures of cube faces with their symbols, drawn with Pillow's built-in font."""

from __future__ import annotations

import io
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from rpg.ir.assets import Block, Color, Face, SemanticCube

RGB: dict[Color, tuple[int, int, int]] = {
    "red": (208, 38, 40),
    "orange": (244, 124, 22),
    "yellow": (248, 206, 34),
    "green": (44, 150, 62),
    "cyan": (36, 186, 200),
    "blue": (36, 88, 200),
    "purple": (126, 58, 168),
    "pink": (244, 132, 178),
    "brown": (122, 76, 42),
    "black": (38, 38, 42),
    "gray": (134, 138, 142),
    "white": (246, 246, 246),
    "ivory": (240, 228, 200),
}
INK_ON_LIGHT, INK_ON_DARK = (28, 28, 32), (250, 250, 250)
PIXELS = 192
"""Side of a face's picture."""

CUBE_FACES: tuple[Face, ...] = ("front", "back", "left", "right", "top", "bottom")
"""Order of a cube texture's images: +X, -X, +Y, -Y, +Z, -Z."""
QUARTER_TURNS: dict[Face, int] = {"front": 1, "back": -1, "left": 2, "right": 0, "top": -1, "bottom": 1}
"""Counter-clockwise quarter turns that bring an upright picture into the frame of its cube texture image."""


def rgba(color: Color) -> tuple[float, float, float, float]:
    """Colour with components in [0, 1]."""
    r, g, b = RGB[color]
    return (r / 255, g / 255, b / 255, 1.0)


def ink_on(color: Color) -> tuple[int, int, int]:
    """The colour in which a symbol stands out on a body."""
    r, g, b = RGB[color]
    return INK_ON_LIGHT if 0.299 * r + 0.587 * g + 0.114 * b > 120 else INK_ON_DARK


@lru_cache(maxsize=128)
def face_image(symbol: str, color: Color) -> Image.Image:
    """An upright face: a body with a darker rim, so that neighbours of one colour are told apart, and its symbol."""
    scale = 2
    side = PIXELS * scale
    body = RGB[color]
    rim = tuple(int(c * 0.78) for c in body)
    image = Image.new("RGB", (side, side), rim)
    draw = ImageDraw.Draw(image)
    edge = side // 32
    draw.rounded_rectangle((edge, edge, side - edge - 1, side - edge - 1), radius=side // 16, fill=body)
    if symbol:
        _draw_symbol(draw, symbol, side, ink_on(color))
    return image.resize((PIXELS, PIXELS), Image.Resampling.LANCZOS)


def _draw_symbol(draw: ImageDraw.ImageDraw, symbol: str, side: int, ink: tuple[int, int, int]) -> None:
    middle, arm, half = side / 2, side * 0.26, side * 0.05

    def bar(x: float, y: float, dx: float, dy: float) -> None:
        draw.line((x - dx, y - dy, x + dx, y + dy), fill=ink, width=round(2 * half))

    match symbol:
        case "+" | "-":
            bar(middle, middle, arm, 0)
            if symbol == "+":
                bar(middle, middle, 0, arm)
        case "*":
            bar(middle, middle, arm * 0.8, arm * 0.8)
            bar(middle, middle, arm * 0.8, -arm * 0.8)
        case "/":
            bar(middle, middle, arm, 0)
            for y in (middle - arm * 0.75, middle + arm * 0.75):
                draw.ellipse((middle - 1.3 * half, y - 1.3 * half, middle + 1.3 * half, y + 1.3 * half), fill=ink)
        case "=":
            bar(middle, middle - arm * 0.45, arm, 0)
            bar(middle, middle + arm * 0.45, arm, 0)
        case _:
            font = ImageFont.load_default(size=side * 0.95 / max(1, len(symbol)))
            left, top, right, bottom = draw.textbbox((0, 0), symbol, font=font, stroke_width=side // 60)
            place = (middle - (left + right) / 2, middle - (top + bottom) / 2)
            draw.text(place, symbol, font=font, fill=ink, stroke_width=side // 60)
            if symbol == "0":
                draw.ellipse((middle - half, middle - half, middle + half, middle + half), fill=ink)
            elif symbol in ("6", "9"):
                line = (middle - arm * 0.8, middle + arm * 1.55, middle + arm * 0.8, middle + arm * 1.55)
                draw.line(line, fill=ink, width=round(half * 0.8))


def face_pixels(block: Block, face: Face) -> NDArray[np.uint8]:
    """RGB pixels of an upright face, row 0 at the glyph's top."""
    return np.asarray(face_image(_symbol(block, face), block.color))


def cube_files(block: Block) -> dict[str, bytes]:
    """PNG files for the six images of the block's cube texture, in order; equal pictures share a file name."""
    files: dict[str, bytes] = {}
    for face in CUBE_FACES:
        name = face_file(block, face)
        if name not in files:
            turned = np.rot90(face_pixels(block, face), _turns(block, face))
            buffer = io.BytesIO()
            Image.fromarray(np.ascontiguousarray(turned)).save(buffer, "PNG", compress_level=1)
            files[name] = buffer.getvalue()
    return files


def face_file(block: Block, face: Face) -> str:
    """Name of the PNG file with the picture of a face, turned as the cube texture needs it."""
    symbol = _symbol(block, face)
    shown = {"+": "plus", "-": "minus", "*": "times", "/": "divide", "=": "equals", "": "plain"}.get(symbol, symbol)
    return f"{block.color}_{shown}_{_turns(block, face)}.png"


def _symbol(block: Block, face: Face) -> str:
    return block.symbol(face) if isinstance(block, SemanticCube) else ""


def _turns(block: Block, face: Face) -> int:
    """Quarter turns of a face's picture; a blank face looks the same however it is turned."""
    return QUARTER_TURNS[face] % 4 if _symbol(block, face) else 0
