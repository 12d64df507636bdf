"""Prepositions: "on top of", "to the left of", "right next to", and how close they mean."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule

_SIMPLE = {
    "on top of": "on", "on the top of": "on", "atop of": "on", "atop": "on", "on top": "on", "onto": "on",
    "on to": "on", "upon": "on",
    **{f"up {on}": "on" for on in ("on", "onto", "upon", "on top of", "on top")},
    "on": "on", "onto the top of": "on", "to the top of": "on", "over": "above", "above": "above",
    "over the top of": "above",
    "on to the top of": "on", "at the top of": "on", "on the surface of": "on",
    "to rest on": "on", "to the above of": "on", "on the upper face of": "on",
    **{
        f"{held}{close} by": "on"
        for held in ("supported", "carried", "borne", "held up", "upheld")
        for close in ("", " directly", " immediately")
    },
    "on the top face of": "on", "on the upper side of": "on", "onto the upper face of": "on",
    "onto the top face of": "on", "higher than": "above", "higher up than": "above",
    "in": "in", "inside": "in", "inside of": "in", "into": "in", "within": "in", "at": "in", "to": "in",
    "over to": "in",
    "under": "under", "underneath": "under", "beneath": "under", "below": "under",
    "in front of": "front", "ahead of": "front", "to the front of": "front", "on the front side of": "front",
    "at the front of": "front", "on the near side of": "front", "on the front of": "front", "nearer than": "front",
    "closer to me than": "front", "nearer to me than": "front", "nearer to the viewer than": "front",
    "closer to the camera than": "front", "nearer to the camera than": "front", "closer to the robot than": "front",
    "nearer to the robot than": "front", "farther away than": "behind", "farther from me than": "behind",
    "farther away from me than": "behind", "farther back than": "behind", "farther than": "behind",
    "farther from the robot than": "behind", "farther from the camera than": "behind",
    "to the far side of": "behind", "off to the far side of": "behind", "over to the far side of": "behind",
    "to the near side of": "front",
    "behind": "behind", "in back of": "behind", "to the back of": "behind", "at the back of": "behind",
    "to the rear of": "behind", "behind of": "behind", "in behind of": "behind", "at the behind of": "behind",
    "on the back side of": "behind", "beyond": "behind", "on the far side of": "behind", "at the rear of": "behind",
    "next to": "beside", "beside": "beside", "alongside": "beside", "by the side of": "beside",
    "at the side of": "beside",
    "side by side with": "beside", "by": "beside", "to the side of": "beside", "besides": "beside",
    "adjacent to": "adjacent", "adjoining": "adjacent", "adjacent with": "adjacent", "right next to": "adjacent",
    "touching": "touching", "in contact with": "touching", "into contact with": "touching",
    "against": "touching", "up against": "touching",
    "flush against": "touching", "flush with": "touching", "making contact with": "touching", "to touch": "touching",
    "snug against": "touching", "right against": "touching",
    "snugly against": "touching", "right up against": "touching", "tight against": "touching",
    "tightly against": "touching", "nestled against": "touching", "pressed against": "touching",
    "pushed against": "touching", "pushed up against": "touching", "leaning against": "touching",
    "near": "near", "close to": "near", "near to": "near", "nearby": "near", "in the vicinity of": "near",
    "far from": "apart", "away from": "apart", "far away from": "apart", "well away from": "apart",
    **{f"at {some} distance from": "apart" for some in ("a", "some", "a safe", "a certain", "a good")},
    "apart from": "apart", "nowhere near": "apart", "nowhere close to": "apart", "anywhere near": "near",
    "anywhere close to": "near", "off": "off", "off of": "off", "away off": "off",
    "along with": "together", "together with": "together",
    **{
        f"{more}{side} than": side
        for more in ("further ", "farther ", "more ", "further to the ", "farther to the ", "more to the ",
                     "further on the ")
        for side in ("left", "right")
    },
    "further back than": "behind", "further away than": "behind", "further away from me than": "behind",
    "further from me than": "behind", "further from the robot than": "behind", "further than": "behind",
    "further from the camera than": "behind", "further away from the robot than": "behind",
    **{f"{more} to the {end} than": side for more in ("further", "farther", "more", "nearer", "closer")
       for end, side in (("front", "front"), ("back", "behind"))},
    "further forward than": "front", "farther forward than": "front", "closer to the viewer than": "front",
}  # fmt: skip
"""Prepositions with a landmark. "in" and "to" only fit patches and structures; resolution says so where they do not."""


_CHOICE = ("left", "right")


DIRECT = ("directly", "exactly", "straight", "precisely", "squarely")


CLOSE = ("immediately", "right", "just")


_LOOSE_TOO = ("front", "behind", "apart")
"""Relations of which "nearer than" and "apart from" are looser kinds."""
_LOOSE = ("somewhere", "anywhere", "generally")
_NAMING = frozenset({*lexicon.BLOCK, *lexicon.COLOR, "one", "it", "them"})
_FLAT = ("flat", "flatly", "loosely")
"""Before "on" these say no more than that: whatever is on something lies flat on it."""


@rule
def side_relation(p: Parser, i: int) -> Results[tuple[str, str]]:
    """ "to the left of", "on the right-hand side of", "left of": (relation, how close)."""
    j = (
        p.any_of(
            i,
            (
                "to the",
                "on the",
                "at the",
                "onto the",
                "to",
                "on",
                "in the",
                "at",
                "off to the",
                "towards the",
                "toward the",
                "over to the",
            ),
        )
        or i
    )
    near = p.one(j, ("immediate", "near", "direct"))
    far = p.one(j, "far")
    k = near or far or j
    if p.words[k : k + 1] and p.words[k] in _CHOICE:
        side = p.words[k]
        k = p.reach(k + 1)
        k = p.opt(k, "hand")
        bounded = p.one(k, "side") and p.words[i] in ("on", "onto", "in")
        k = p.any_of(k, ("side",)) or k
        of = p.one(k, ("of", "from"))
        if of and p.words[i] == "onto" and p.words[k - 1] != "side":
            return  # "onto the left of the two blue ones": on that one of them
        if of:
            yield (side, p.words[j] if near else "side" if bounded else ""), of
        elif k > i and p.words[k - 1] != "hand":
            yield (side + "?", ""), k


@rule
def relation(p: Parser, i: int) -> Results[tuple[str, tuple[str, ...]]]:
    """A relation that wants a landmark: (name, modifiers)."""
    starts: list[tuple[tuple[str, ...], int]] = [((), i)]
    for words, mod in ((DIRECT, "directly"), (CLOSE, "immediate"), (_LOOSE, "somewhere")):
        if i < p.end and p.words[i] in words:
            starts.append(((mod,), p.opt(p.reach(i + 1), "and")))
    if p.stands(i, ("top",)) and p.words[i + 1] == "of" and i and p.words[i - 1] in _NAMING:
        yield ("on", ()), p.reach(i + 2)  # "green block top of white"
    if p.stands(i, _FLAT) and p.words[i + 1] in ("on", "onto", "upon"):
        starts.append(((), p.reach(i + 1)))
    for mods, j in starts:
        for phrase, k in p.standing(j, _SIMPLE):
            mutual = mods == ("directly",) and p.stands(k, ("each", "one"))
            if _SIMPLE[phrase] == "beside" and (mods == ("immediate",) or mutual):
                yield ("adjacent", ()), k
                continue
            loose = mods if not phrase.endswith("than") or phrase == "nearer than" else (*mods, "somewhere")
            loose = (*mods, "besides") if phrase == "apart from" else loose
            yield (_SIMPLE[phrase], loose if _SIMPLE[phrase] in _LOOSE_TOO or phrase.endswith("than") else mods), k
        for (side, how), k in side_relation(p, j):
            if not side.endswith("?"):
                extra = {"immediate": ("immediate",), "direct": ("directly",), "side": ("side",)}.get(how, ())
                yield (side, (*mods, *extra)), k
