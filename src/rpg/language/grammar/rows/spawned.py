"""How blocks come to lie there at the start: "eight cubes spawn in a heap", "nine blocks thrown into a heap"."""

from __future__ import annotations

from rpg.language.grammar.rows.begun import HEAP
from rpg.language.grammar.rows.turned import Turn

_SPOT = "(?=(?:all )?(?:in|on|onto|into|at|next|beside|behind|under|near|to|above|stacked|scattered|side|randomly)\\b)"
_MADE = "(?:spawned|initiali[sz]ed|generated|instantiated)"
_THROWN = "(?:thrown|dumped|tipped|dropped|tossed|poured|emptied)(?: out| together)?"
_ON_A_HEAP = f"(?:in|into|on|onto) (?:an?|one) (?:single |big |large |loose |messy )?{HEAP}"

SPAWNED: tuple[Turn, ...] = (
    ("\\b(lies?|lying|stands?|sits?) (?:around|about|there)(?: on the table)? (?:randomly|at random|loosely|anywhere)"
     "(?=$| ,| and| but)", "{1} around"),
    (f"\\bspawns? {_SPOT}", "start "),
    (f"\\b(?:is|are|gets?|will be) {_MADE} {_SPOT}", "start "),
    (f"\\b(?:is|are|was|were|has been|have been|gets?) {_THROWN} {_ON_A_HEAP}\\b", "start in a heap"),
    (f"\\b(?:(?:which|that) (?:is|are|was|were) )?{_THROWN} {_ON_A_HEAP}\\b", "in a heap"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("spawn spawned generated instantiated thrown dumped tipped dropped tossed poured emptied",)
"""Words that these take besides those that are read anyway."""
