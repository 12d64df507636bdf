"""Small words of what becomes of blocks: how empty a patch is, what is upper and lower, what stands on its head."""

from __future__ import annotations

IN_THE_END = {
    **{f"{wholly} empty": "empty" for wholly in ("completely", "entirely", "totally", "fully", "quite")},
    **{f"{upper} {ones}": f"{top} {ones}" for upper, top in (("upper", "top"), ("lower", "bottom"))
       for ones in ("ones", "blocks", "cubes", "bricks")},
    **{f"{be} to {end}": f"must {end}" for be in ("is", "are") for end in ("end", "become")},
    "displace": "move",
    "on its head": "upside down", "upon its head": "upside down", "on their heads": "upside down",
}  # fmt: skip
"""What people write, and what it is read as."""
