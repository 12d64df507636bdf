"""What people say around a request: thanks, hesitations, politeness, and turns of speech that mean a plain word.

The text keeps its length, so that places in it stay what they are.
"""

from __future__ import annotations

import re

_ASIDE = (
    r"(?:great|nice|wonderful|perfect|cool|lovely|excellent|awesome|fantastic|good(?: job)?|fine|thanks(?: a lot)?"
    r"|thank you(?: very much| so much)?|ok(?:ay)?|well(?: done)?|oh|hm+|ah+|um+|uh+|ye(?:s|ah|p)|nah|nope|sorry|hey|hi"
    r"|hello|wait|all ?right|on second thoughts?|i(?:'ve| have)? changed my mind|by the way|looks good|very good)"
)
_ASIDES = re.compile(rf"(?P<before>^\s*|[.!;,?]\s*)(?P<gone>(?:and\s+|but\s+)?{_ASIDE}\s*[,.!:;-]+)", re.IGNORECASE)
_LEADS = re.compile(
    r"^(?P<before>\W*(?:(?:and|but|now|no|then|so|also|please|,)\s*,?\s*)*)"
    r"(?P<gone>i (?:think|guess|suppose|believe|feel)(?: that)?|why (?:not|don'?t (?:you|we))|i'?d say"
    r"|it would (?:be|look) (?:great|nice|good|lovely|better|cool|best)(?: if (?:we|you) (?:could|would)?| to| if)?"
    r"|i'?d (?:rather|prefer)(?: it)?(?= (?:on|in|to|behind|under|above|at|next)\b))\b",
    re.IGNORECASE,
)
_HEDGES = re.compile(
    r"\b(?:should|must|could|would|ought to|has to|have to|can|shall)\s+"
    r"(?P<gone>perhaps|maybe|please|preferably|really|better|actually)\s",
    re.IGNORECASE,
)
_CLOSES = re.compile(
    r"(?P<gone>[,\s]+(?:would be (?:great|nice|better|good|lovely|perfect|fine)|if you please|though|i mean|thanks"
    r"|thank you|if that is ok(?:ay)?|if you don'?t mind))[\s.!?]*$",
    re.IGNORECASE,
)
_REMARKS = re.compile(
    r"^\W*(?:undo|revert|go back|roll back|back)\b[^,.;:]*"
    r"(?P<gone>[,.;]\s*(?:that|it|this)(?:'s| is| was| looks| looked| seems)"
    r" (?:too|not|wrong|bad|ugly|worse|silly|a mistake|better before)\b[^,.;:]*)$",
    re.IGNORECASE,
)
"""Why a step is taken back."""
_ALREADY = re.compile(
    r"^\W*(?:start|begin|at the start|the start)\b[^.]*?\b"
    r"(?P<gone>already(?: lying| standing| sitting| placed| stacked)?|lying"
    r"|standing|sitting|placed)(?= on (?:top of )?(?:(?:the|a|an) \w+|[A-Z0-9]\b))",
    re.IGNORECASE,
)
_GONE = (_ALREADY, _ASIDES, _ASIDES, _ASIDES, _LEADS, _HEDGES, _CLOSES, _REMARKS)
_WORDS = (
    (re.compile(r"\b(?:what|how) about (?:making|having)\b", re.IGNORECASE), "make"),
    (re.compile(r"\b(?:what|how) about (?:adding|putting)\b(?= (?:a|an|one|two|three|another|some)\b)", re.I), "add"),
    (re.compile(r"\bmore high\b|\bmore tall\b", re.IGNORECASE), "higher"),
    (re.compile(r"\bmore long\b", re.IGNORECASE), "longer"),
    (re.compile(r"^the start (?:should be|must be|is|has to be)\b(?= .*\bon\b)", re.IGNORECASE), "start with"),
    (re.compile(r"\bthe (?:finished|completed|resulting)(?= (?:tower|stack|row|column|structure)\b)", re.I), "the"),
    (re.compile(r"\bmost top\b", re.IGNORECASE), "top"),
    (re.compile(r"\bmost (?:bottom|low)\b", re.IGNORECASE), "bottom"),
    (re.compile(r"\bmost left\b", re.IGNORECASE), "leftmost"),
    (re.compile(r"\bmost right\b", re.IGNORECASE), "rightmost"),
    (re.compile(r"\bplease to\b(?= \w)", re.IGNORECASE), "please"),
    (re.compile(r"\b(?:be|become) (?:with|of|in) (?:the )?colou?r\b", re.IGNORECASE), "be"),
)


def plainly(request: str) -> str:
    """The request without what is said around it, as long as it was."""
    said = request
    for pattern in _GONE:
        said = pattern.sub(_blanked, said)
    for pattern, word in _WORDS:
        said = pattern.sub(lambda found, word=word: word.ljust(len(found.group())), said)  # type: ignore[misc]
    return said if re.search(r"\w", said) else request


def _blanked(found: re.Match[str]) -> str:
    """The passage with spaces for what goes; a word in capitals may be what cubes are to spell."""
    start, end = (place - found.start() for place in found.span("gone"))
    whole = found.group()
    if len(found["gone"]) > 2 and found["gone"].strip(" ,.!:;-").isupper():
        return whole
    return whole[:start] + " " * (end - start) + whole[end:]
