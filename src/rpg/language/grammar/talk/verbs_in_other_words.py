"""Verbs of several words: "throw together a tower" and "start building a tower" are "build a tower"."""

from __future__ import annotations

from rpg.language import lexicon

_DOING = {
    form: verb
    for form, senses in lexicon.VERB.items()
    for sense, verb, tense in senses
    if tense == "ing" and sense in ("place", "stack", "build", "arrange", "sort", "spell")
}
_UP = (
    "whip",
    "rig",
    "knock",
    "conjure",
    "mock",
    "throw",
    "rustle",
    "cook",
    "dream",
    "run",
    "draw",
    "set",
    "put",
    "make",
)
_TOGETHER = ("throw", "knock", "cobble", "piece", "slap", "cook", "patch")
_LIFT = ("pick", "pick up", "grab", "take", "lift", "lift up", "grasp")
_PUT = ("place", "put", "set", "stack", "move", "lay", "drop")

VERBS_IN_OTHER_WORDS = {
    **{f"{verb} up a{n}": f"build a{n}" for verb in _UP for n in ("", "n")},
    **{f"{verb} together a{n}": f"build a{n}" for verb in _TOGETHER for n in ("", "n")},
    **{f"come up with a{n}": f"build a{n}" for n in ("", "n")},
    **{f"{lift} and {put} the": f"{put} the" for lift in _LIFT for put in _PUT},
    **{f"{start} {form}": verb for start in ("start", "begin", "try", "practice", "practise", "attempt", "keep on")
       for form, verb in _DOING.items()},
}  # fmt: skip
"""What people write, and what it is read as."""
