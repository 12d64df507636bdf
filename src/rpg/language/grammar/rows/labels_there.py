"""Which symbols there are, told behind what is asked for: "(letters in the test: V, X, Y, Z)", ", the numbers being
3, 7 and 5", as a sentence of its own that says so."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_KIND = "(letters|digits|numbers|symbols)"
_WHERE = (
    "(?:(?:in|of|for|on) (?:the|this|our) (?:test|task|scene|set|game|trial|experiment|episode|puzzle|box|kit|table|"
    "demo)|involved|used|in play|in use|given|available|there|at hand)"
)
_LISTED = "(\\S(?:(?: ,| and| , and| to| through)? \\S)+)"

LABELS_THERE: tuple[Turn, ...] = (
    (f" \\( (?:the |all )?{_KIND}(?: {_WHERE})?(?: are| being)?(?: :)? {_LISTED} \\)$", " . the {1} are {2}"),
    (f" , (?:and )?(?:the |all )?{_KIND}(?: {_WHERE})? (?:are|being) {_LISTED}$", " . the {1} are {2}"),
    (f"^(?:the |all )?{_KIND} {_WHERE} (?:are|:) {_LISTED}$", "the {1} are {2}"),
)  # fmt: skip
"""What is looked for in every sentence."""
