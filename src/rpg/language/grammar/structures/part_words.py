"""What parts of structures are called: sides, what is counted, parts with nouns of their own, and the rest."""

from __future__ import annotations

from rpg.language import lexicon

SIDES = {
    "top": "top", "upper": "top", "topmost": "top", "uppermost": "top", "highest": "top",
    "bottom": "bottom", "lower": "bottom", "lowest": "bottom", "bottommost": "bottom", "lowermost": "bottom",
    "ground": "bottom", "base": "bottom",
    "middle": "middle", "center": "middle", "central": "middle",
    "left": "left", "leftmost": "left", "right": "right", "rightmost": "right",
    "front": "front", "near": "front", "nearest": "front", "nearer": "front", "frontmost": "front", "closest": "front",
    "back": "back", "far": "back", "rear": "back", "rearmost": "back",
    **dict.fromkeys(("farther", "further", "farthest", "furthest"), "back"),
    "tallest": "top", "largest": "top", "biggest": "top", "shortest": "bottom", "smallest": "bottom",
    "outer": "outer", "outermost": "outer", "outside": "outer", "end": "ends", "corner": "corners", "edge": "edge",
    "inner": "inner", "inside": "inner", "innermost": "inner", "other": "rest", "remaining": "rest",
    "surrounding": "rest", "last": "last", "next": "next", **{word: str(n) for word, n in lexicon.ORDINAL.items()},
}  # fmt: skip
UNITS = {
    "row": "row", "rows": "row", "column": "column", "columns": "column", "layer": "layer", "layers": "layer",
    "level": "layer", "levels": "layer", "tier": "layer", "tiers": "layer", "floor": "layer", "floors": "layer",
    "story": "layer", "stories": "layer", "course": "layer", "courses": "layer",
    "step": "step", "steps": "step", "stair": "step",
    "block": "block", "blocks": "block", "cube": "block",
    "cubes": "block", "brick": "block", "bricks": "block", "one": "block", "ones": "block", "cell": "block",
    "position": "block", "positions": "block", "place": "block", "places": "block",
    "cells": "block", "half": "half", "third": "third", "tower": "whole", "towers": "whole", "stack": "whole",
    "stacks": "whole", "pyramid": "whole", "wall": "whole", "staircase": "whole", "square": "whole", "circle": "whole",
}  # fmt: skip
NOUNS = {
    "corners": "corners", "ends": "ends", "edges": "edge", "border": "edge", "rim": "edge", "perimeter": "edge",
    "center": "middle", "middle": "middle", "top": "top", "peak": "top", "tip": "top", "apex": "top",
    "bottom": "bottom", "base": "bottom", "foundation": "bottom", "rest": "rest", "others": "rest",
    "remainder": "rest", "corner": "corners", "end": "ends", "inside": "inner", "interior": "inner",
    "outside": "outer", "hole": "middle", "arms": "rest", "foot": "bottom", "frame": "edge", "boundary": "edge",
    "crown": "top", "summit": "top", "point": "point", "bar": "bar", "crossbar": "bar", "crosspiece": "bar",
    "stem": "stem", "leg": "stem", "trunk": "stem",
}  # fmt: skip
"""Parts that are named by a noun of their own."""
TIPS = frozenset({"tip", "apex"})
FROM = tuple(f"from {the}{side}" for side in ("left", "right", "top", "bottom") for the in ("the ", ""))
OWN = frozenset({"the", "its", "their", "all", "both", "each", "every", "either"})
LEADS = ("in", "at", "on", "for", "along", "as", "forming", "in all", "on all", "at all")
PAIRS = tuple(
    f"{one} and {the}{other}"
    for pair in (
        ("top", "bottom"),
        ("left", "right"),
        ("front", "back"),
        ("first", "last"),
        ("leftmost", "rightmost"),
        ("lowest", "highest"),
        ("lowest", "top"),
        ("bottom", "topmost"),
        ("near", "far"),
        ("nearest", "farthest"),
    )
    for one, other in (pair, pair[::-1])
    for the in ("", "the ", "its ")
)
"""Both ends of a line, named one by one."""
_SIDE_OF_IT = {
    **{f"{word}{it}": way for way, words in (("above", ("above", "over")), ("behind", ("behind",)),
                                             ("below", ("below", "under", "beneath", "underneath")))
       for word in words for it in (" it", " that", " that one", " them", " those")},
    **{f"{of} {it}": way for way in ("left", "right") for of in (f"to the {way} of", f"{way} of")
       for it in ("it", "that", "them", "those")},
    **{f"{on} its {way}": way for way in ("left", "right") for on in ("to", "on")},
    **dict.fromkeys(("on top of it", "higher up", "on it"), "above"), **dict.fromkeys(("lower down",), "below"),
    **dict.fromkeys(("in front of it",), "front"),
}  # fmt: skip
BEYOND = {**_SIDE_OF_IT, **{way: way for way in ("above", "below")}, "beneath": "below", "underneath": "below"}
"""On which side of what is told before the rest is: "the four below it"."""
REST = (
    "everything else", "all else", "all the rest", "all the others", "all others", "every other block",
    *(
        f"{rest} {between}"
        for rest in ("everything", "all", "the ones", "all those", "all blocks", "the blocks", "all the blocks",
                     "all the ones", "every block", "those", "the others")
        for between in ("between them", "in between", "in between them", "between", "between the ends")
    ),
)  # fmt: skip
ALL_BEYOND = ("everything", "all", "all those", "all blocks", "all the blocks", "the blocks", "the others", "the rest",
              "the ones", "all the others", "every block", "those")  # fmt: skip
"""What is told with its side is all of the rest."""
BETWEEN = (
    "around it", "all around it", "around the outside", "round it", "around the middle", "around the center",
    "around that", "in between", "anywhere in between", "somewhere in between", "between them", "elsewhere",
    "everywhere else", "in between them", "between the ends",
)  # fmt: skip
_BE = ("is", "are", "should be", "must be", "shall be", "has to be", "have to be", "will be", "is to be", "are to be",
       "ought to be", "needs to be", "need to be")  # fmt: skip
_MUST = ("should", "must", "shall", "has to", "have to", "will", "is to", "are to")
_MADE = tuple(f"{made} {of}" for made in ("made", "made up", "built", "composed", "formed", "constructed")
              for of in ("of", "from", "out of"))  # fmt: skip
IS = (
    *_BE, *(f"{be} {all_}" for be in (*_BE, "being")
            for all_ in ("all", "both", "entirely", "completely", "only", *_MADE)),
    *(f"{must} {word}" for must in _MUST for word in ("all be", "both be", "only be", "consist of", "contain", "have",
                                                      "consist only of", "consist entirely of")),
    "consists of", "consist of", "consists only of", "consist only of", "contains", "contain", "being", "in", "of",
    "all", "is a", ":", "has", "has only", "to be", "all in", "is in", "are in", "should be in",
    "must be in", "being in", "all being", "both being", "both", "both in", "entirely", *_MADE,
)  # fmt: skip
"""What joins a part and its look."""
NOT = ("not", "is not", "are not", *(f"{must} not be" for must in ("should", "must", "may", "can", "shall")),
       *(f"{must} never be" for must in ("should", "must", "may", "can")))  # fmt: skip
"""What joins a part and a look that it does not have."""
NEAREST = tuple(f"{near} {me}".strip() for near in ("nearest", "closest") for me in (
    "to me", "to the robot", "to the viewer", "to the camera", "to us", "to you", "me", ""))  # fmt: skip
FARTHEST = tuple(f"{far} {me}".strip() for far in ("farthest", "furthest") for me in (
    "away", "away from me", "away from the robot", "away from the viewer", "from me", "from the robot",
    "from the viewer", "from the camera", "back", ""))  # fmt: skip
THERE = {
    **dict.fromkeys(("in front", "at the front", "in the front", "on the near side", "at the near side", *NEAREST),
                    "front"),
    **dict.fromkeys(("at the back", "in the back", "at the rear", "on the far side", "at the far side", *FARTHEST),
                    "back"),
    **{f"{on} {far}{side}{end}": side for on in ("on the", "at the", "to the", "on its") for far in ("", "far ")
       for side in ("left", "right") for end in ("", " side", " hand side", " end")},
    **dict.fromkeys(("at the bottom", "at the base", "on the bottom", "lowest down", "at the very bottom"), "bottom"),
    **dict.fromkeys(("on top", "at the top", "on the top", "at the very top"), "top"),
    **dict.fromkeys(("in the middle", "in the center", "in between", "between them", "in between them"), "middle"),
}  # fmt: skip
"""Where a row, a column or a layer is, told behind it: "the row at the back", "the column farthest to the left"."""
