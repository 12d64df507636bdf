"""Parts of the table in plainer words: "on my left" is on the left, "the half farther from me" the far half."""

from __future__ import annotations

_TABLES = ("table", "desk", "workspace", "tabletop", "work area")
_OF_TABLE = tuple(f" of the {table}" for table in _TABLES)
_PARTS = ("part", "area", "section", "region", "portion", "zone")
_SIDES = ("left", "right", "far", "near", "back", "front", "rear", "upper", "lower")
_EDGES = ("left", "right", "far", "near", "back", "front")
_MIDDLE = ("middle", "center")
_AT = ("in", "at", "into", "to")

TABLE_PARTS = {
    **{f"{on} my {side}{hand}": f"{on} the {side}" for on in ("on", "to", "at") for side in ("left", "right")
       for hand in ("", " side", " hand", " hand side")},
    **{f"{side}hand": f"{side} hand" for side in ("left", "right")},
    **{f"the {side} {part} of the {table}": f"the {side} half of the {table}"
       for side in _SIDES for part in _PARTS for table in _TABLES},
    **{f"{of} {mid} line{table}": f"in the {half} half of the table" for half, ofs in (
           ("left", ("left of the", "to the left of the", "on the left of the")),
           ("right", ("right of the", "to the right of the", "on the right of the")),
           ("far", ("behind the", "beyond the")), ("near", ("in front of the",)))
       for of in ofs for mid in _MIDDLE for table in ("", *_OF_TABLE)},
    **{f"{side} of center": f"in the {side} half of the table" for side in ("left", "right")},
    **{f"the half{table} {that}{farther} {to} me": f"the {half} half of the table"
       for half, to, words in (("far", "from", ("farther", "further", "farthest", "furthest", "farther away",
                                                "further away")),
                               ("near", "to", ("nearer", "closer", "nearest", "closest")))
       for farther in words for that in ("", "that is ", "which is ")
       for table in ("", " of the table")},
    **{f"the {farther} half": f"the {half} half" for half, words in (
           ("far", ("farther", "further", "distant", "farthest", "furthest")),
           ("near", ("nearer", "closer", "nearest")))
       for farther in words},
    "the distant left corner": "the far left corner", "the distant right corner": "the far right corner",
    **{f"the corner {at} the {up} {side}": f"the far {side} corner" for at in ("at", "on", "in", "to")
       for up in ("top", "upper", "back", "far") for side in ("left", "right")},
    **{f"the corner {at} the {down} {side}": f"the near {side} corner" for at in ("at", "on", "in", "to")
       for down in ("bottom", "lower", "front", "near") for side in ("left", "right")},
    **{f"{at} {the}{table} {middle}": f"in the middle of the {table}" for at in _AT for the in ("the ", "")
       for table in ("table", "workspace", "desk") for middle in _MIDDLE},
    **{f"in {a} central {place}{table}": "in the middle of the table" for a in ("a", "the") for table in _OF_TABLE
       for place in ("position", "place", "location", "region", "part", "section", "area")},
    **{f"in the {middle} {part}{table}": "in the middle of the table" for middle in _MIDDLE for table in _OF_TABLE
       for part in ("region", "section")},
    **{f"somewhere {at} the {end}": f"{at} the {end}" for at in ("at", "in") for end in ("back", "front", "rear")},
    "at the center point": "in the middle", "centrally": "in the middle",
    **{f"centered on the {table}": f"in the middle of the {table}" for table in _TABLES},
    **{f"{middle} of the work area": "middle of the table" for middle in _MIDDLE},
    **{f"{close} to the {side} {edge}": f"near the {side} edge" for close in ("close", "next") for side in _EDGES
       for edge in ("edge", "rim", "border")},
    **{f"{side} {rim}": f"{side} edge" for side in _EDGES for rim in ("rim", "border", "side edge")},
    "the edge facing me": "the near edge", "the edge on my side": "the near edge", "my edge": "the near edge",
}  # fmt: skip
"""What people write, and what it is read as."""
