"""Wishes for places that there are not."""

from __future__ import annotations

import re

from rpg.passes.schema.hints.wish import Wish

_PATCH = r"(?:\w+ ){0,2}(?:patch(?:es)?|mats?|carpets?|rugs?|fields?|pads?|squares?)"
PLACES = (
    Wish(
        re.compile(rf"\b(?:corners?|edges?|borders?|sides?) of (?:the|an?|each|every|its) {_PATCH}\b", re.I),
        "a block is on a patch, or in its middle: the corners and edges of a patch are no places of their own",
        "say what the blocks on it form, as in 'put four cubes in a square on the blue patch'",
    ),
    Wish(
        re.compile(r"\b(?:partly|partially|in part|to some extent)\b", re.I),
        "a block is on a patch if its middle is: that it is only partly on it is not told apart",
        "leave this out, as in 'put every cube on a patch'",
    ),
    Wish(
        re.compile(
            r"\b(?:dark|light|pale|bright|warm|cool|cold)(?:er)?[ -]?(?:colou?red |toned |hued )?"
            r"(?:blocks?|cubes?|ones?|colou?rs?|tones?|boxes|bricks)\b",
            re.I,
        ),
        "which colours these are is not said",
        "name them, as in 'put the red, orange and yellow blocks in the left half of the table and the blue, green and "
        "purple blocks in the right half of the table'",
    ),
    Wish(
        re.compile(
            r"\b(?:can ?not|can't|cant|could not|couldn't|no longer|never) (?:be )?seen?\b|\bout of sight\b|"
            r"\bhidden from\b|\bfrom (?:view|sight)\b",
            re.I,
        ),
        "what is seen from somewhere is no goal here, but only where blocks are",
        "say where it is, as in 'put the green block directly behind the big red block'",
    ),
    Wish(
        re.compile(r"\b(?:my|your|his|her|our|their) (?:side|end|half|edge)\b", re.I),
        "whose side of the table that is is not clear",
        "say 'near' or 'far', as in 'put 1 in the near half of the table and 2 and 3 in the far half of the table'",
    ),
)
