"""Verbs of several words: "throw together a tower" and "start building a tower" are "build a tower"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_UP = ("whip", "rig", "knock", "conjure", "mock", "throw", "rustle", "cook", "dream", "run", "draw")
_TOGETHER = ("throw", "knock", "cobble", "piece", "slap", "cook", "patch")
_LIFT = ("pick", "pick up", "grab", "take", "lift", "lift up", "grasp")
_PUT = ("place", "put", "set", "stack", "move", "lay", "drop")

VERBS_IN_OTHER_WORDS = {
    **{f"{verb} up a{n}": f"build a{n}" for verb in _UP for n in ("", "n")},
    **{f"{verb} together a{n}": f"build a{n}" for verb in _TOGETHER for n in ("", "n")},
    **{f"come up with a{n}": f"build a{n}" for n in ("", "n")},
    **{f"{lift} and {put} the": f"{put} the" for lift in _LIFT for put in _PUT},
}
"""What people write, and what it is read as."""

_DOING = {
    form: verb
    for form, senses in lexicon.VERB.items()
    for sense, verb, tense in senses
    if tense == "ing" and sense in ("place", "stack", "build", "arrange", "sort", "spell")
}
BEGUN = frozenset({"start", "begin", "try", "practice", "practise", "attempt", "keep"})


def begun_doing(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Start building a tower", "keep on stacking": build it, stack."""
    out = list(tokens)
    for at in (n for n in range(len(words) - 2, -1, -1) if words[n] in BEGUN):
        doing = at + 1 + (words[at : at + 2] == ["keep", "on"])
        if doing < len(words) and words[doing] in _DOING and (words[at] != "keep" or doing > at + 1):
            out[at : doing + 1] = [tokens[doing].saying(_DOING[words[doing]])]
    return out if len(out) < len(tokens) else None
