"""What rows have in common, as parts of their patterns."""

from __future__ import annotations

from rpg.language import lexicon

MUST = "(?:shall|must|should|will|has to|have to|needs to|need to|is to|are to|ought to)"
LIES = "(?:lies?|is|are|stands?|sits?|rests?)"
BUILD = "(?:build|make|form|lay|lay out|set out|set up|put|place|arrange|create|construct)"
END = "(?:left|right|front|back|top|bottom|near|far)"
MID = "(?:middle|center)"
WAY = f"from (?:the )?{END} to (?:the )?{END}"
ME = "(?:me|us|you|the (?:viewer|robot|camera|observer))"
FEW = "one|two|three|four|five|six|seven|eight|nine|ten|twelve"
"""Numbers in words, to be put in brackets."""
MANY = f"(?:\\d+|{FEW})"
NO_NUMBER = f"(?:(?!\\b(?:{FEW}|\\d+)\\b).)*?"
"""Words among which there is no number."""
LENGTH = f"(?:[\\d.]+|{FEW}) (?:cm|mm|(?:centi|milli)met(?:er|re)s?)"
COLOR = f"(?:{'|'.join(sorted(lexicon.COLOR))})"
CUBE = "(?:block|cube)"
N = "(?: (?:blocks?|cubes?|bricks?|ones?))?"
"""What is counted behind a number, if it is named."""
PATCH = "(?:patch|mat|zone|target|area|spot|tile)"
PATCHES = "(?:patches|mats|zones|targets|areas|spots|tiles)"
LINE = "(?:tower|stack|row|line|column)"
TOWER = "(?:tower|stack)"
AND = "(?: ,| and| , and)"
READER = "(?:i|you|we|he|she|they|one|everyone|everybody|people|(?:the|my|our|your|his|her|all|an?) (?:\\w+ ){0,2}\\w+)"
"""Who reads what is spelled."""


def number(told: str) -> int:
    """The number that is told by MANY."""
    return int(told) if told.isdigit() else int(lexicon.NUMBER[told])
