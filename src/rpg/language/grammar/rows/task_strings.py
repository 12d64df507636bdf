"""Task strings of benchmarks: "stack by size, largest at the bottom: red 5 cm, ...", "two stacks, height 2 each", a
distance from centre to centre, as rows that say it in a sentence."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH, MANY, MUST

_BLOCKS = "(?:blocks|cubes)"
_PLACE = "(?:zone|patch|mat|area|target|region)"

TASK_STRINGS: tuple[Turn, ...] = (
    # measures
    (f"(?<=[:,] )({COLOR}) ({LENGTH})(?= ,|$| and)", "a {2} {1} block"),
    ("\\bthe (?:center|center - to - center) distance (?:of|between) ", "the distance between the centers of "),
    ("\\bbetween the facing sides of\\b", "between"),
    # towers and rows
    (f"\\bin ({MANY})(?: separate)? (stacks|towers) , (?:each (?:of|with) (?:a )?)?height(?: of)? ({MANY})(?: each)?$",
     "in {1} {2} of height {3}"),
    (f"^stack {MANY} ({_BLOCKS}) in alternating colors(?: ,| :) ({MANY} {COLOR} and {MANY} {COLOR})\\b",
     "stack {2} {1} in alternating colors"),
    # what is sorted
    (f"^sort by color : (.+? into the {COLOR} {_PLACE} .+)$", "put {1}"),
    ("^group by kind : (.+? in one (?:cluster|group|pile) , .+? in another(?: one)?)$", "put {1}"),
    # headings that the sentence says itself
    ("^(?:invert|reverse|unstack|restack|swap)(?: the \\w+)? : ((?:initially|start from|start with|at the start) .+? "
     f"(?:finally|then|end with|at the end|{MUST}) .+)$", "{1}"),
    ("^(.+?) with (?:digit|number|letter) and (?:operator|symbol|sign) (?:blocks|cubes)$", "{1}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
