"""How people word things on a table and the places they have to each other."""

from __future__ import annotations

from random import Random

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
LETTERS = "BCDEFGHJKLMNPQRSTVWXYZ"

_LEFT = (
    "to the left of",
    "left of",
    "on the left of",
    "on the left side of",
    "on the left-hand side of",
    "to the left side of",
)
PLACE = {
    "on": ("on", "on", "on top of", "upon", "atop", "directly on", "right on top of", "directly on top of"),
    "under": ("under", "underneath", "beneath", "directly under", "right underneath"),
    "above": ("somewhere above", "anywhere above"),
    "-front": ("in front of",),
    "-behind": ("behind", "in back of"),
    "dfront": ("directly in front of", "straight in front of"),
    "dbehind": ("directly behind", "straight behind"),
    "ifront": ("immediately in front of",),
    "ibehind": ("immediately behind",),
    "sfront": ("somewhere in front of", "anywhere in front of"),
    "sbehind": ("somewhere behind", "anywhere behind"),
    "beside": ("beside", "next to", "alongside"),
}
"""Behind the first and before the second."""
HAVING = {
    "on": ("on it", "on top", "on top of it", "on its top", "directly on top of it", "right on it"),
    "under": ("under it", "underneath", "underneath it", "beneath it", "directly under it"),
    "above": ("somewhere above it",),
    "-front": ("in front of it",),
    "-behind": ("behind it",),
    "dfront": ("directly in front of it",),
    "dbehind": ("directly behind it",),
    "ifront": ("immediately in front of it",),
    "ibehind": ("immediately behind it",),
    "sfront": ("somewhere in front of it",),
    "sbehind": ("somewhere behind it",),
    "beside": ("beside it", "next to it", "alongside it"),
}
"""What is had there: "with the green one on it"."""
for _side in ("left", "right"):
    for _key, _how in (("-", ""), ("d", "directly "), ("i", "immediately "), ("s", "somewhere ")):
        _plain = ("to the {s} of", "{s} of") if _how else tuple(x.replace("left", "{s}") for x in _LEFT)
        PLACE[_key + _side] = tuple(_how + x.format(s=_side) for x in _plain)
        _its = ("to its {s}", "to the {s} of it", "on its {s}")
        _more = (
            () if _how else ("{s} of it", "on its {s} side", "on the {s} of it", "at its {s}", "on its {s}-hand side")
        )
        HAVING[_key + _side] = tuple(_how + x.format(s=_side) for x in _its + _more)
FLAT = tuple(kind for kind in PLACE if kind not in ("on", "under", "above"))
PLAIN = ("-left", "-right", "-front", "-behind")

PUT = ("put", "put", "place", "set", "move", "get", "bring", "position", "stand", "lay")
SHOULD = (
    "should be",
    "must be",
    "has to be",
    "is to be",
    "shall be",
    "needs to be",
    "ought to be",
    "is",
    "should go",
    "goes",
    "has to go",
    "belongs",
    "must stand",
    "stands",
    "should end up",
    "ends up",
    "must end up",
    "should be placed",
    "must be put",
    "is placed",
    "has to be located",
    "should sit",
    "is supposed to be",
    "will be",
    "has to end up",
    "is positioned",
    "rests",
    "has to stand",
    "should rest",
    "must be sitting",
    "should be standing",
    "is to go",
    "gets placed",
    "is going to be",
    "lies",
)
MUST = ("must", "should", "has to", "needs to", "is to", "shall", "is supposed to", "ought to", "will", "is going to")
BE_THERE = (
    "be",
    "stand",
    "be placed",
    "go",
    "sit",
    "end up",
    "be put",
    "lie",
    "rest",
    "be located",
    "be standing",
    "be found",
)
INVERTED = (
    "is",
    "goes",
    "stands",
    "sits",
    "there is",
    "there should be",
    "there must be",
    "comes",
    "should be",
    "must stand",
    "put",
    "place",
    ", put",
    ", place",
    "should stand",
    "there has to be",
    "shall be",
    "I want",
    "I would like to have",
    "must be",
    "we need",
    "there stands",
    "has to be",
    "you put",
    ", please put",
    "belongs",
    ", there is",
    "lies",
)
HAS = (
    "has",
    "should have",
    "must have",
    "is to have",
    "shall have",
    "needs",
    "has to have",
    "gets",
    "should get",
    "wants",
)
WANT = (
    "I want",
    "I'd like",
    "I would like",
    "make sure that",
    "see to it that",
    "we want",
    "I need",
    "let's have",
    "have",
)
CARRY = (
    "carries",
    "supports",
    "should carry",
    "must support",
    "has to carry",
    "is carrying",
    "bears",
    "should bear",
    "shall carry",
    "is to support",
    "holds up",
)
CARRIED = (
    "is carried by",
    "should be carried by",
    "is supported by",
    "must be supported by",
    "rests on",
    "must rest on",
    "sits on",
    "lies on",
    "should lie on",
    "is resting on",
    "is borne by",
)
TOPPED = (
    "is topped by",
    "is topped with",
    "should be topped by",
    "must be topped with",
    "is crowned by",
    "is covered by",
)
END = (
    "at the end",
    "in the end",
    "finally",
    "when you are done",
    "when it's over",
    "in the final state",
    "afterwards",
    "at last",
    "eventually",
    "once finished",
    "by the end",
    "at the end of the episode",
)


class Names:
    """Noun phrases of the blocks of one sentence, all in one style; a noun is said once and is "one" from then on."""

    def __init__(self, rng: Random, count: int) -> None:
        self.rng = rng
        self.style = rng.choice(("the", "the", "the", "the", "a", "bare", "label", "mixed", "articleless"))
        self.noun = rng.choice(("block", "block", "cube", "brick"))
        self.said = False
        self.inverted = rng.choice(INVERTED)
        colors = rng.sample(COLORS, count)
        letters = rng.sample(LETTERS, count)
        lettered = {n for n in range(count) if self.style == "label" or (self.style == "mixed" and rng.random() < 0.5)}
        self.looks = {"abcd"[n]: letters[n] if n in lettered else colors[n] for n in range(count)}
        self.label = rng.choice(
            (
                "the {}",
                "the letter {}",
                "cube {}",
                "block {}",
                "the {} cube",
                "the cube with the {}",
                "the cube labelled {}",
                "the block with the {} on it",
                "the {} block",
                "{}",
            )
        )
        if self.style == "label" and self.label == "{}":
            self.noun = "cube"

    def first(self, key: str, indefinite: bool = False) -> str:
        """Where it is mentioned for the first time."""
        look = self.looks[key]
        if look.isupper():
            return (self.label if self.style == "label" else "the letter {}").format(look)
        noun = self.noun
        if self.said:
            noun = self.rng.choice((noun, "one", "one"))
        self.said = True
        if self.style == "bare":
            return look
        if self.style == "articleless":
            return f"{look} {self.noun}"
        if indefinite or self.style == "a":
            return f"{'an' if look[0] in 'aeiou' else 'a'} {look} {noun}"
        return (
            f"the {look} {noun}"
            if self.rng.random() < 0.93
            else f"the {noun if noun != 'one' else self.noun} that is {look}"
        )

    def again(self, key: str) -> str:
        """Where it has been mentioned."""
        look = self.looks[key]
        if look.isupper():
            return self.first(key)
        if self.style == "bare":
            return look
        if self.style == "articleless":
            return f"{look} {self.noun}"
        return f"the {look} {self.rng.choice((self.noun, 'one', 'one'))}"
