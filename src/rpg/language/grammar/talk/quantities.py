"""Turns of phrase that tell how many, which and where of all: "each and every one", "in a corner of its own"."""

from rpg.language import lexicon

QUANTITIES = {
    "each and every": "every", "every single one of": "each of", "each single": "each", "every last": "every",
    "each and every one": "each", "each individual": "each", "every individual": "every",
    **{f"{into} a second {one}": f"{into} another {one}"
       for into in ("in", "into") for one in ("one", "tower", "stack", "group", "pile")},
    "is allowed to": "may", "are allowed to": "may", "divided fairly": "divided evenly",
    "shared fairly": "shared evenly", "not one of": "none of",
    "both at least": "each at least", "both at most": "each at most",
    **{f", not one {may} be": f", none {may} be" for may in ("may", "must", "should", "can", "is to", "shall")},
    **{f"there {must} be one in {every} corner": f"there {must} be one of them in each corner"
       for must in ("must", "should", "shall") for every in ("each", "every")},
    **{f"all {bar} {n} of": f"all but {n} of" for n in lexicon.NUMBER
       for bar in ("bar", "save", "save for", "except", "except for", "excepting", "apart from", "other than")},
    **{f"{lot} {out}": f"{lot} of" for lot in ("a pair", "a couple", "a duo", "a trio", "a triple")
       for out in ("out of", "from among", "from")},
    **{f"half of {which}": "half of them" for which in ("which", "these", "those")},
    **{f"{of} each of the four corners": f"{of} each corner" for of in ("in", "into", "at")},
    **{f"{of} each one of the four corners": f"{of} each corner" for of in ("in", "into", "at")},
    **{f"{may} {lie} {where}": f"{may} be anywhere"
       for may in ("may", "can", "might", "could")
       for lie in ("be", "lie", "stand", "stay", "sit", "go", "remain", "be placed", "be put", "end up")
       for where in ("wherever", "wherever you like", "wherever you want", "anywhere you like", "wherever they like",
                     "wherever it likes", "wherever they are", "anywhere at all", "wherever they want")},
}  # fmt: skip
"""What people write, and what it is read as."""
