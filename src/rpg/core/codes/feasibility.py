"""Codes reported when an instruction is understood but cannot be carried out."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        "contradiction",
        "two parts cannot both hold",
        "Two conditions on the same blocks exclude each other at the end.",
        "put the red block on the blue block and the red block on the green block",
        "put the red block on the blue block and the blue block on the green block",
    ),
    Code(
        "self-reference",
        "a block is placed relative to itself",
        "A relation needs two blocks.",
        "put the red block on the red block",
        "put the red block on the blue block",
    ),
    Code(
        "count-mismatch",
        "numbers do not agree",
        "The number that is asked for and the number of blocks that are named, listed or needed differ.",
        "build a 3x3 square of eight red blocks",
        "build a 3x3 square of nine red blocks",
    ),
    Code(
        "too-few",
        "there are too few blocks",
        "The structure needs more blocks to be one.",
        "build a tower of one block",
        "build a tower of two blocks",
    ),
    Code(
        "too-many-asked",
        "more are asked for than there are",
        "A part of some blocks is larger than the whole.",
        "put five of the four red blocks on the blue patch",
        "put three of the four red blocks on the blue patch",
    ),
    Code(
        "too-many-blocks",
        "a task has at most 30 blocks",
        "More blocks than that do not fit on the table with room to work.",
        "sort 40 blocks by color",
        "sort 12 blocks by color",
    ),
    Code(
        "too-many-labels",
        "there are more symbols than cubes that show them",
        "A task has at most 26 letter cubes and 10 digit cubes.",
        "sort 27 letter cubes alphabetically in a pile",
        "line up 10 letter cubes in alphabetical order",
    ),
    Code(
        "too-many-colors",
        "there are not so many colours",
        "The palette has twelve colours.",
        "put 14 blocks of different colors on the green patch",
        "put 4 blocks of different colors on the green patch",
    ),
    Code(
        "false-equation",
        "the equation is not true",
        "Equations are computed; only true ones can be built.",
        "build the equation 2+2=5",
        "build the equation 2+2=4",
    ),
    Code(
        "bad-equation",
        "this is no equation",
        "An equation has numbers, + − × ÷ between them, and one equals sign.",
        "",
        "build the equation 2+2=4",
    ),
    Code(
        "unknown-symbol",
        "no block shows this symbol",
        "Cubes show A to Z, 0 to 9 and + − × ÷ =.",
        "spell the word 'A_B'",
        "spell the word 'AB'",
    ),
    Code(
        "missing-symbol",
        "a symbol is not among the blocks",
        "The word or equation needs a symbol that the named blocks do not show.",
        "spell CAT with the blocks C, A and B",
        "spell CAT with the blocks C, A and T",
    ),
    Code(
        "order-misfit",
        "the blocks do not show what the order needs",
        "Alphabetical order needs letters, numerical order digits, and a turn needs a block whose turn can be seen.",
        "line up the red block, the blue block and the green block in alphabetical order",
        "line up the blocks A, B and C in alphabetical order",
    ),
    Code(
        "order-conflict",
        "two orders or structures for the same blocks",
        "The same blocks cannot be in both.",
        "put the blocks A, B and C in a row as a tower",
        "put the blocks A, B and C in a row",
    ),
    Code(
        "one-group",
        "there is nothing to sort",
        "All the blocks agree in what they are to be sorted by.",
        "sort six red blocks by color",
        "sort three red blocks and three blue blocks by color",
    ),
    Code(
        "fixed-patch",
        "patches do not move",
        "Patches are marks on the table.",
        "put the green patch on the red block",
        "put the red block on the green patch",
    ),
    Code(
        "out-of-reach",
        "blocks stay on the table",
        "Nothing can be put beside or off the table.",
        "put the red block behind the table",
        "put the red block in the far half of the table",
    ),
    Code(
        "size-out-of-range",
        "a block of this size cannot be made",
        "Edges are from 1 to 12 cm.",
        "put a 50 cm red block on a blue block",
        "put a 5 cm red block on a blue block",
    ),
)
