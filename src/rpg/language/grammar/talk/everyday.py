"""Everyday turns in plainer ones: "the red team" is the red blocks, "this lot" these blocks."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.talk.denied import DENIED
from rpg.language.grammar.talk.table_parts import TABLE_PARTS

_NOT_TOUCHING = tuple(
    f"any{two} touching{other}"
    for two in ("", " two", " two of them", " of them", " two blocks", " blocks")
    for other in ("", " each other", " one another", " another", " the others")
)

_AT_FIRST = ("originally", "to begin with", "to start with", "at first", "in the beginning", "at the outset",
             "at reset", "presently", "at present", "currently", "when the episode begins", "when the episode starts",
             "at the beginning of the episode", "at the start of the episode")  # fmt: skip
_IS = ("is", "are", "sits", "sit", "stands", "stand", "lies", "lie", "rests", "rest")

EVERYDAY = {
    **TABLE_PARTS, **DENIED,
    **{f"{first} {is_}": f"initially {is_}" for first in _AT_FIRST for is_ in _IS},
    **{f"{is_} presently": f"{is_} currently" for is_ in _IS},
    **{f"{starts} {each} {episode}": starts for starts in ("starts", "begins") for each in ("the", "each", "every")
       for episode in ("episode", "run", "trial", "rollout", "round")},
    **{f"{must} initially be": "initially is" for must in ("should", "must", "shall", "will", "has to", "is to")},
    **{f"without {touching}": "so that no two of them touch" for touching in _NOT_TOUCHING},
    **{f"{away}one from the other": f"{away}from each other" for away in ("away ", "apart ", "")},
    **{f"this {lot}": "these blocks" for lot in ("lot", "bunch", "stuff", "collection", "assortment")},
    **{f"{color} {team}": f"{color} blocks" for color in lexicon.COLOR for team in ("team", "gang", "squad", "crew")},
    **{f"{color} {disc}": f"{color} {circle}" for color in lexicon.COLOR
       for disc, circle in (("disc", "circle"), ("disk", "circle"), ("discs", "circles"), ("disks", "circles"))},
    **{f"color sort {them}": f"sort {them} by color" for them in ("them", "the blocks", "everything", "all blocks",
                                                                "these blocks", "the cubes", "the lot")},
    **{f"{gather} the {what}": "group the blocks by color"
       for gather in ("gather", "bunch", "group", "collect", "cluster", "bring together", "gather together", "herd")
       for what in ("blocks of each color", "cubes of each color", "colors together", "blocks of the same color",
                    "cubes of the same color")},
    **{f"tidy {them}by color": "group the blocks by color"
       for them in ("", "up ", "them ", "them up ", "up the blocks ", "the blocks ", "the blocks up ", "everything ",
                    "everything up ")},
    **{f"{soon} {after}": "after that" for soon in ("immediately", "directly", "right", "straight", "shortly")
       for after in ("after that", "after this", "afterwards", "thereafter")},
    **dict.fromkeys(("following that", "following this", "with that done", "with this done"), "after that"),
    **{f"alphabet {what}": f"letter {what}" for what in lexicon.BLOCK},
    **{f"a sandwich {where}": f"a tower {where}" for where in ("where", "with", "of", "in which", "made of")},
    **{f"{with_}{two}colors alternating{around}": "alternating" for with_ in ("with ", "")
       for two in ("the two ", "both ", "the ", "its two ") for around in ("", " all the way around", " all around")},
    **{f"alternating all the way {around}": "alternating" for around in ("around", "round", "through", "along", "up")},
    **{f"{take} {it} down first": f"first put {it} on the table"
       for take in ("take", "get", "lift", "bring") for it in ("it", "that one")},
    **{f"{during} {the}{execution}": "at all times" for during in ("during", "throughout")
       for the in ("all the ", "the whole ", "the entire ", "all of the ", "the ")
       for execution in ("execution", "operation", "procedure", "process", "maneuver", "manoeuvre", "motion")},
    **{f"{piece} of {paper}": "patch" for piece in ("piece", "sheet", "bit", "scrap", "square")
       for paper in ("paper", "cloth", "felt", "carpet", "cardboard")},
    **{f"{to}{side} of the {middle} of the {table}": f"in the {side} half of the table"
       for to in ("", "to the ", "on the ") for side in ("left", "right") for middle in ("middle", "center")
       for table in ("table", "desk", "workspace", "tabletop")},
    **{f"over {to} the {side} side": f"to the {side} side" for to in ("to", "on") for side in ("left", "right")},
    **{f"{touching} each other": "touching each other" for touching in (
        "butted against", "butted up against", "abutting", "snug up against")},
    "abutting": "touching", "making contact": "touching",
    **{f"{a}{n} {block} {gap}": f"{one}{gap} of {n} {block}{s}" for n, s in (("one", ""), ("two", "s"), ("three", "s"))
       for block in ("block", "cube") for a, gap, one in (("a ", "gap", "a "), ("", "gaps", ""))},
    **{f"{n} {block} of space": f"a gap of {n} {block}" for n in ("one", "two", "three", "a")
       for block in ("block", "cube", "blocks", "cubes")},
    **{f"{gap} {wide} {a} {block}": f"{gap} of one {block}" for gap in ("gap", "gaps") for a in ("a", "one")
       for wide in ("as wide as", "the size of", "as big as", "as large as") for block in ("block", "cube")},
    "capital letters": "letters",
    **dict.fromkeys(("gap free", "gapless", "gaplessly", "seamlessly", "with a gap of zero"), "without gaps"),
    **{f"one {part} turn": f"a {part} turn" for part in ("quarter", "half", "full")},
    "a right angle": "ninety degrees",
    **{f"in {a}{clockwise} direction": clockwise for a in ("a ", "")
       for clockwise in ("clockwise", "counterclockwise", "anticlockwise")},
    "the wrong way up": "upside down", "around the middle of": "near the middle of",
    "into the middle of": "to the middle of",
    **{f"portion of the {table}": f"part of the {table}" for table in ("table", "desk", "workspace", "tabletop")},
    "centrally on": "in the middle of", "midpoint of the": "middle of the", "heart of the": "middle of the",
    "in between of": "between",
    **{f"{along} the depth{direction}": "from front to back" for along in ("along", "in") for direction in (
        "", " direction", " axis", " dimension")},
    **{f"{pairwise} {distinct}": "different" for pairwise in ("pairwise", "mutually") for distinct in (
        "distinct", "different")},
    "square frame": "square outline", "rectangular frame": "rectangle outline",
    "but not both of them": "but not both", "not both of them": "not both", "and not both of them": "but not both",
    **{f"{every} {block} but {the}": f"{every} {block} except {the}"
       for every, many in (("every", False), ("each", False), ("no", False), ("all", True), ("all the", True),
                           ("none of the", True))
       for block, plural in lexicon.BLOCK.items() if plural == many for the in ("the", "a", "an")},
}  # fmt: skip
"""What people write, and what it is read as."""
