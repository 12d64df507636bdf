"""Wishes for what is not checked at the end, or is not there."""

from __future__ import annotations

import re

from rpg.passes.schema.hints.wish import Wish

UNCHECKED = (
    Wish(
        re.compile(r"\bas (?:far|close|near)(?: \w+){0,2} as possible\b", re.I),
        "it is not said how far that is: what is possible depends on the table",
        "say a distance, as in 'put the red block at least 30 cm away from the blue block'",
    ),
    Wish(
        re.compile(
            r"\b(?:hold|keep|stays?|remains?|stands?|stable|wait|leave|lift|there|block|cube|one)\b.*"
            r"\b(?:for|during|over)(?: at least| about| more than)? (?:\w+|\d+(?:\.\d+)?) ?"
            r"(?:s|secs?|seconds?|minutes?|min)\b",
            re.I,
        ),
        "how long it stays so is not measured: it is so at the end, when nothing holds or moves the blocks",
        "leave the time out, as in 'stack the red block on the blue block and let go'",
    ),
    Wish(
        re.compile(
            r"\bhold(?:s|ing)? (?:it|them|the(?! most| fewest| least)|this|that|up|still|an?)\b|"
            r"\b(?:in|into|through) the air\b|\bhover",
            re.I,
        ),
        "a block that is held has no place at the end: what is checked is how blocks lie when nothing holds them",
        "say where it is put down, as in 'put the red block on the blue block'",
    ),
    Wish(
        re.compile(r"\b(?:lift|raise|pick up)\b.*\b(?:put|set|place|lay)\b.*\bdown\b", re.I),
        "a block that is lifted and put down again is where it was, and nothing is left to check",
        "say where it is put down, as in 'put the red block on the blue block'",
    ),
    Wish(
        re.compile(r"\b(?:poke|prod|tap|wiggle|shake|roll|trace|approach|regrasp|throw|kick|hand over)\b", re.I),
        "what the arm does on the way leaves nothing to check at the end",
        "say how the blocks should be at the end, as in 'the red block should be on the blue block'",
    ),
    Wish(
        re.compile(r"\bon (?:the|its) way\b|\bas (?:a unit|one unit|one piece)\b|\bwithout lifting\b", re.I),
        "how a block gets to its place is not checked, but only where it is at the end",
        "leave this out, as in 'put the red block on the blue patch'",
    ),
    Wish(
        re.compile(
            r"\b(?:nearest|closest|furthest|farthest) (?:\w+ )?(?:block|cube|patch|mat|one)\b|"
            r"\b(?:block|cube|patch|mat|one) (?:that|which) is (?:nearest|closest|furthest|farthest)\b",
            re.I,
        ),
        "which block or patch that is depends on how the blocks lie at the start, and may change",
        "name it by its colour, as in 'put the red block on the blue patch'",
    ),
    Wish(
        re.compile(r"\b(?:most|fewest|least) (?:cubes|blocks|boxes|bricks)\b(?! that can)", re.I),
        "on what the most or the fewest blocks lie depends on how they lie at the start, and may change",
        "name it by its colour, as in 'clear the red patch'",
    ),
    Wish(
        re.compile(
            r"\b(?:completely|fully|entirely|totally|wholly) (?:covered|cover|hidden|filled|fill)\b|"
            r"\b(?:covered|cover|hidden|filled|fill)\b.* (?:completely|fully|entirely|totally|wholly)\b",
            re.I,
        ),
        "how much of something is covered is not checked, but only which blocks lie on it",
        "say how many lie there, as in 'put four blocks on the white patch'",
    ),
    Wish(
        re.compile(r"\balready\b|\bkeep stacking until\b", re.I),
        "what is to be done depends on how the blocks lie: a task does not depend on a condition",
        "say how it is at the start and should be at the end, as in 'the red block is on the blue patch; put it on the "
        "green patch'",
    ),
    Wish(
        re.compile(r"\boverhang|\bhalf (?:of it )?(?:is )?(?:on|off)\b|\bhang(?:s|ing)? over\b", re.I),
        "how far a block reaches over an edge is no goal here: it lies where its middle is",
        "say on what it lies, as in 'put the green block on the red block'",
    ),
    Wish(
        re.compile(
            r"\b(?:stars?|hearts?|question marks?|smileys?|arrows?|dots?|pictures?) on\b|\bwith (?:an? )?"
            r"(?:stars?|hearts?|question marks?|smileys?|arrows?|dots?)\b",
            re.I,
        ),
        "blocks are plain, or show a letter, a digit or one of + - * / =, and no other sign",
        "say which of these are meant, as in 'put the block with an A on the blue patch'",
    ),
    Wish(
        re.compile(r"\b(?:person|people|human|child)\b|\b(?:give|hand) .*\bto (?:me|him|her|us)\b", re.I),
        "people are no part of a task",
        "say where on the table, as in 'put the blue block in the left half of the table'",
    ),
    Wish(
        re.compile(r"\bparallel\b|\bedges of\b", re.I),
        "how the sides of a block are turned is no goal here",
        "leave this out, as in 'put the red block in the middle of the blue patch'",
    ),
    Wish(
        re.compile(r"\bany (?:\w+ )?word\b", re.I),
        "it is not said which word",
        "say it in capitals, as in 'spell CAT'",
    ),
)
