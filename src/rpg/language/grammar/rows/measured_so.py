"""How all distances of a text are to be measured, told behind them: "both distances being measured between the
centers", which is how they are meant anyway where no gap is told."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import LENGTH, MUST

_NO_GAP = f"(?!.*\\b(?:gaps?|spaces?|spacing|clearance|room|faces|edges?|margins?|{LENGTH} (?:of \\w+ )?between)\\b)"
_ALL = "(?:all|both|the|these|those|all the|both these)"
_FAR = f"(?:(?:{_ALL} )?(?:distances?|lengths?|measurements?)|(?:the )?{LENGTH})"
_IS = f"(?:(?:is|are|being|to be|{MUST} be) )?(?:all |both )?(?:measured|meant|taken|counted|given|understood)"
_CENTERS = "(?:(?:the|their|block) )?(?:centers?|middles?)"
_BETWEEN = f"(?:between|from) {_CENTERS}(?: of (?:the |all )?(?:blocks|cubes)| to (?:the )?(?:centers?|middles?))?"
_TOLD = f"(?:with )?{_FAR} {_IS} {_BETWEEN}|(?:please )?(?:always )?measure (?:(?:{_FAR}|it|them|this) )?{_BETWEEN}"

MEASURED_SO: tuple[Turn, ...] = (
    (f"^{_NO_GAP}(.*\\b{LENGTH}\\b.*?)(?: [.,;(:])+ (?:and )?(?:{_TOLD})(?: \\))?(?= \\.|$)", "{1}"),
)
"""What is looked for in a text, and what is said instead."""
WORDS = ("measurement measurements understood",)
"""Words that these take besides those that are read anyway."""
