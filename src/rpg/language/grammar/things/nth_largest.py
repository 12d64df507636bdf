"""Which one in the order of sizes: "the second largest block", "the third smallest one"."""

from __future__ import annotations

from rpg.language import lexicon

_MOST = {"largest": "largest", "biggest": "largest", "smallest": "smallest", "littlest": "smallest"}
NTH_LARGEST = {
    f"{word} {most}": ("rank", f"{nth} {rank}")
    for nth, words in lexicon.ORDINALS.items()
    for word in words.split()
    for most, rank in _MOST.items()
    if 1 < nth < 7
}
"""Adjectives, as in `adjectives`: what they tell, and its value."""
