"""Everyday turns in plainer ones: "the red team" is the red blocks, "this lot" these blocks."""

from __future__ import annotations

from rpg.language import lexicon

_NOT_TOUCHING = tuple(
    f"any{two} touching{other}"
    for two in ("", " two", " two of them", " of them", " two blocks", " blocks")
    for other in ("", " each other", " one another", " another", " the others")
)

EVERYDAY = {
    **{f"without {touching}": "so that no two of them touch" for touching in _NOT_TOUCHING},
    **{f"{away}one from the other": f"{away}from each other" for away in ("away ", "apart ", "")},
    **{f"this {lot}": "these blocks" for lot in ("lot", "bunch", "stuff", "collection", "assortment")},
    **{f"{color} {team}": f"{color} blocks" for color in lexicon.COLOR for team in ("team", "gang", "squad", "crew")},
    **{f"alphabet {what}": f"letter {what}" for what in lexicon.BLOCK},
    **{f"a sandwich {where}": f"a tower {where}" for where in ("where", "with", "of", "in which", "made of")},
    **{f"{with_}{two}colors alternating{around}": "alternating" for with_ in ("with ", "")
       for two in ("the two ", "both ", "the ", "its two ") for around in ("", " all the way around", " all around")},
    **{f"alternating all the way {around}": "alternating" for around in ("around", "round", "through", "along", "up")},
    **{f"{take} {it} down{first}": f"{before}put {it} on the table"
       for take in ("take", "get", "lift", "bring") for it in ("it", "them", "that one", "that")
       for first, before in ((" first", "first "), (" again", ""), ("", ""))},
    **{f"for the {digits}": f"of the {digits}" for digits in ("digits", "letters", "numbers")},
    **{f"{during} {the}{execution}": "at all times" for during in ("during", "throughout")
       for the in ("all the ", "the whole ", "the entire ", "all of the ", "the ")
       for execution in ("execution", "operation", "procedure", "process", "maneuver", "manoeuvre", "motion")},
    "no stacking higher than": "no stack higher than", "no piling higher than": "no stack higher than",
    **{f"{up} when {we} {come}": f"{up} at the start"
       for up in ("stacked", "up", "there", "table", "other", "patch", "mat", "heap", "pile", "row", "one")
       for we, comes in (("we", ("arrive", "come in", "start", "begin", "get there")),
                         ("i", ("arrive", "come in", "start", "begin", "get there")),
                         ("you", ("arrive", "come in", "start", "begin", "get there")),
                         ("the robot", ("arrives", "comes in", "starts", "begins", "gets there")))
       for come in comes},
    **{f"{reach} the {side}": f"is in the {side}" for reach in ("reaches", "ends up at", "gets to", "arrives at")
       for side in ("far left corner", "far right corner", "near left corner", "near right corner", "left half",
                    "right half", "middle of the table", "back left corner", "back right corner", "front left corner",
                    "front right corner")},
}  # fmt: skip
"""What people write, and what it is read as."""
