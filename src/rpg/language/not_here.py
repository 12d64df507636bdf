"""Words that mean nothing here, by kinds: for each kind what is said of it instead of words that look alike."""

from __future__ import annotations

_THINGS = """
    apple apples ball balls banana bananas basket baskets bottle bottles bowl bowls cans cap cone cones cup cups
    cylinder cylinders dish disc discs disk disks doll door drawer fork glass hammer handle knife lid lids mug mugs
    nut pan peg pegs pen pencil plate plates pot prism prisms rod rods screw sphere spheres spoon tomato wheel
"""
_BUILT = """
    bridge bridges castle castles gate gates house houses smiley face heart arch arches tunnel roof church temple snake
    flower fence archway fortress maze airplane rocket boat ship car truck train animal
"""
_DOINGS = """
    poke poking throw throwing toss roll rolling shake shaking kick kiss hug juggle bounce tap tapping trace tracing
    hover wiggle wobble wave squeeze catch fling swing lick tickle knock spill pour hammer bump nudge prod scratch
"""
FEELINGS = ("scared", "afraid", "frightened", "lonely", "shy", "sad", "jealous", "angry", "bored", "hungry", "sleepy",
            "happy")  # fmt: skip
"""What no block feels."""
_STREWN = "scatter strew"
_CENTRES = "centroid barycenter"
_DIRECTIONS = """
    north south east west northern southern eastern western northeast northwest southeast southwest
"""
_KINDS = (
    (_DIRECTIONS, "say 'behind', 'in front of', 'to the left of' or 'to the right of', as in 'put the red block behind "
                  "the blue block'"),
    (_THINGS, "tasks are made of blocks (cubes, plain or with a letter or digit) and flat patches: use one of these"),
    (_BUILT, "say how its blocks lie, as in 'a row of three blocks', 'a tower', 'a pyramid', 'stairs' or 'an L'"),
    (_DOINGS, "only what is so at the end is checked: say where the block should be then, as in 'move the red block "
              "to the left'"),
    (" ".join(FEELINGS), "blocks feel nothing: say where they should be, as in 'put the red block far from the blue "
                         "block', or 'next to' it"),
    (_STREWN, "say 'spread the blocks out' where none should be near another one"),
    (_CENTRES, "of two blocks a third can be halfway 'between' them; of more no middle is known"),
)  # fmt: skip
HINTS = {word: hint for words, hint in reversed(_KINDS) for word in words.split()}
"""What to say of such a word."""
