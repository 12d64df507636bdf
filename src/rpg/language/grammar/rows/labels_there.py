"""Which symbols there are, told behind what is asked for: "(letters in the test: V, X, Y, Z)", ", the numbers being
3, 7 and 5", as a sentence of its own that says so."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_KIND = "(letters|digits|numbers|symbols)"
_WHERE = (
    "(?:(?:in|of|for|on) (?:the|this|our) (?:test|task|scene|set|game|trial|experiment|episode|puzzle|box|kit|table|"
    "demo)|involved|used|in play|in use|given|available|there|at hand)"
)
_SIGN = "(?:\\S|plus|minus|times|equals|divided by)"
_SIGNS = f"({_SIGN}(?:(?: ,| and| , and)? {_SIGN})+)"
_LISTED = "(\\S(?:(?: ,| and| , and| to| through)? \\S)+)"

LABELS_THERE: tuple[Turn, ...] = (
    (f" \\( (?:the |all )?{_KIND}(?: {_WHERE})?(?: are| being)?(?: :)? {_LISTED} \\)$", " . the {1} are {2}"),
    (f" , (?:and )?(?:the |all )?{_KIND}(?: {_WHERE})? (?:are|being) {_LISTED}$", " . the {1} are {2}"),
    (f"^(?:the |all )?{_KIND} {_WHERE} (?:are|:) {_LISTED}$", "the {1} are {2}"),
    (f"^(?:we|i|you|the kids|the children) (?:all |already |now )?(?:know|learned|learnt|study|practise|practice) "
     f"(?:about )?the {_KIND} {_LISTED}$", "there are the {1} {2}"),
    (f"(?:^| ,|;) ?(?:with |using )?one (?:cube|block) (?:each )?(?:for|of) (?:each of )?{_SIGNS}$",
     " . there are the blocks {1}"),
    ("^(.*\\b(?:spell|write|word|equation|show)\\b.*?)(?: ,| with| using)+ (?:one|a) (?:cube|block) (?:for each|per|"
     "for every|each for every) (?:letter|symbol|digit|sign)$", "{1}"),
)  # fmt: skip
"""What is looked for in every sentence."""
