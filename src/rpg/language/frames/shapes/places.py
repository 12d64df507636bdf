"""Words for the parts of flat figures: where they point, and where blocks are in them."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, number, patterns
from rpg.language.frames.shapes.measures import BAR, COUNT, HAS, STEM

IT = (
    "(?:it|them|this|that|which|(?:(?:the|this) )?(?:shape|figure|whole|circle|ring|square|plus|cross|rectangle|"
    "triangle|outline|letter|[TLUVX]))"
)
_ITS = "(?:(?:and |with )?(?:the|its|whose|his|both) )?(?:(?:4|3|2) )?"
_TWO_PARTS = "(?: (?:BLOCK|ones|one|piece|place|places|position|positions|spot|part|parts))?"
_TOWARD = {
    "left": "(?:(?:to|towards?|on|at|in|facing) )?(?:the |its |my |your )?left(?: hand)?(?: side)?|leftwards?",
    "right": "(?:(?:to|towards?|on|at|in|facing) )?(?:the |its |my |your )?right(?: hand)?(?: side)?|rightwards?",
    "front": "(?:(?:towards?|to|facing|at|nearest|nearest to|closest to|close to|nearer to|near|near to) )?"
    "(?:me|us|you|(?:the )?(?:robot|viewer|camera|observer|spectator))|(?:(?:to|towards?|at|on|facing|in) )?(?:the )?"
    "(?:front|near)"
    "(?: side| edge| end)?(?: of the TABLE)?|nearest|closest",
    "back": "(?:(?:to|towards?|at|on|facing|in) )?(?:the )?(?:back|rear|far)(?: side| edge| end)?(?: of the "
    "TABLE)?|away(?: from (?:me|us|you|(?:the )?(?:robot|viewer|camera|observer|spectator)))?|backwards?|"
    "(?:farthest|furthest)(?: away)?(?: from (?:me|us|you|the (?:robot|viewer|camera)))?",
    "top": "(?:(?:at|to|towards?|on) )?(?:the )?top|up(?:wards?)?",
}  # fmt: skip
_VIEWER = "(?:i|I|we|you|me|us|(?:the )?(?:robot|viewer|camera|observer|spectator))"
_SPOT = "(?:side|seat|position|place|point of view|viewpoint|standpoint|perspective|view|angle|chair|eyes)"
_POINTS = (
    "(?:(?:BE |must |should |shall |to |that |which )?(?:point|points|pointing|pointed|face|faces|facing|aim|aims|"
    "aiming|aimed|directed|turned|turn|turns|turning|look|looks|looking|show|shows|showing|open|opens|opening|extend|"
    "extends|extending|go|goes|going|stick|sticks|sticking|reach|reaches|reaching|run|runs|running|come|comes|"
    "coming)(?: out| up| straight| directly)? |BE )?"
)
_PART_OF = {
    "foot": "foot|base|toe|(?:short|shorter|lower|bottom) (?:arm|leg|bar|stroke|side|line|one)",
    "long": "(?:long|longer) (?:arm|leg|bar|stroke|side|line|one)|upright",
    "stem": "(?:(?:foot|end|bottom|bottom end) of the )?(?:stem|leg)|trunk|post|shaft|tail|stalk",
    "bar": "(?:top )?(?:bar|crossbar|cross bar|crosspiece)",
    "opening": "opening|open side|open end|open ends|mouth|open part|gap",
    "tip": "tip|point|apex|peak|vertex|pointed end|pointy end|tip block|sharp end",
}  # fmt: skip
WAYS: list[Pattern] = [
    *(found for part, names in _PART_OF.items() for side, toward in _TOWARD.items()
      for found in patterns("way", (part, side), f"(?:(?:and |with |so that )?(?:its|the|whose|a) )?(?:{names})(?: "
          f"end)?(?: of {IT})? {_POINTS}(?:{toward})")),
    *patterns("way", ("any", ""), "(?:in |with )?(?:any|whichever|whatever|some) (?:orientation|direction|way|"
        "rotation|way round|way around)(?: (?:will do|(?:BE|is) (?:fine|ok|okay|good|allowed)|you like))?",
        "(?:the )?(?:orientation|direction|rotation) (?:(?:BE|is) up to you|does not matter|(?:BE|is) (?:free|open))",
        "(?:it|this|that) (?:may|can) be (?:turned|rotated|oriented) (?:(?:in )?any way|any way round|as you like|"
        "anyhow|freely)"),
    *patterns("way", ("all", "upright"),
        "(?:(?:that|which) )?(?:BE )?(?:upright|right way up|the right way up|readable)(?= [,.;]| and )",
        "upright(?= letter| capital| [TLUV] )"),
    *patterns("way", ("all", "upright"),
        f"(?:(?:as|when|if) )?(?:it BE )?(?:seen|viewed|looked at|visible|read) (?:for|by) {_VIEWER}",
        f"(?:(?:as|when|if) )?(?:it BE )?(?:seen|viewed|looked at|visible|read|reading)? ?from (?:where {_VIEWER} "
        f"(?:sit|sits|stand|"
        f"stands|am|are|is|look|looks)|(?:my|our|your)(?: own)? {_SPOT}|{_VIEWER}(?: 's)?(?: {_SPOT})?)",
        f"(?:as|when|if) {_VIEWER} (?:see|sees|look at|looks at|read|reads)(?: (?:it|them|this|that))?",
        f"(?:that |what )?{_VIEWER} (?:(?:should|must|can|shall|will)(?: be able to)? )?(?:see|sees|read|"
        "reads)(?= (?:is )?(?:an?|the) )"),
    *(found for side in ("left", "right") for found in patterns("way", ("foot", side),
        "(?:(?:its|the) )?foot (?:BE )?(?:at|on|in) the (?:near|bottom|lower|front)(?: end| side| edge)? "
        f"{_POINTS}(?:{_TOWARD[side]})")),
    *(found for side, toward in _TOWARD.items() for found in (
      *patterns("way", ("opening", side),
          f"(?:(?:that|which|it|and|must|should|shall) )*(?:BE )?(?:opens?|opened|opening|open)(?: up)? (?:{toward})"),
      *patterns("way", ("", side),
          f"(?:(?:that|which|it|must|should|shall) )*(?:BE )?(?:points?|pointing|pointed) (?:{toward})"))),
    *patterns("way", ("stem", "front"),
        "(?:, )?(?:which |that )?(?:starts?|starting|begins?|beginning|attached) (?:under|below|underneath|at|from) "
        f"(?:the|its) (?:middle|center)(?: (?:BLOCK|one))?(?: of (?:it|the {BAR}))?"),
    *patterns("way", ("all", "over"), "(?:but )?(?:that |which )?(?:BE )?(?:turned )?upside down", "inverted"),
    *(found for base, tip in (("front|near|nearest", "back"), ("back|far|farthest", "front"), ("left", "right"),
      ("right", "left")) for found in patterns("base", lambda m, tip=tip: (number(m["count"]), tip),
        f"{COUNT} (?:BE )?(?:along|in|at|on|forming|as) (?:its |the )?(?:{base})(?: (?:row|side|edge|line))?")),
    *patterns("side", lambda m: number(m["count"]), f"(?:with )?(?:a |the |its )?base {HAS}{COUNT}(?: wide| long)?",
        f"{COUNT} (?:along|in|at|on|forming|as|for) (?:its |the )?(?:base|bottom)(?: row| side| line)?"),
]  # fmt: skip
"""Value: a part, and where it points; "base": how many blocks there are along the side over against the tip."""

_OF_IT = f"(?: of {IT})?"
_PLACES = {
    "center": ("(?:BE )?(?:right |exactly |directly |placed |set |put )?(?:in|at|as|for|into|forming) (?:(?:the|"
    "its|a|her) )?(?:very |exact |dead )?(?:middle|center|heart|core|hub|crossing|hole)(?: BLOCK| one| piece| "
    f"point| position)?{_OF_IT}(?! of the TABLE| row)",
               "(?:(?:the|its|a|whose) )?(?:middle|center|central|heart|core|hub|crossing|inner(?= (?:BLOCK|one) ))(?: "
               "BLOCK| one| piece)?(?! of "
               f"the TABLE| row){_OF_IT}",
               f"(?:BE )?(?:inside|within)(?: (?:of )?{IT})?", "(?:BE )?(?:in )?between(?: them)?", "dead center"),
    "around": ("(?:BE )?(?:all )?(?:a?round|surrounding)(?: (?:it|them|that|this|the (?:middle|center)(?: BLOCK| "
    "one)?|the one in the (?:middle|center)|that one))?(?: on (?:all|its|the) (?:4 )?sides)?(?! (?:an?|the|NUM|"
    "this) )(?! COLOR)",
               "(?:BE )?on (?:all|the|its) (?:4 )?sides(?: of it)?", "(?:BE )?(?:at|on|for) the outside",
               "(?:that |which )?(?:surrounds?|surrounding|encircles?|encircling|encloses?|enclosing) (?:it|that one|"
               "the (?:middle|center)(?: BLOCK| one)?|the one in the (?:middle|center))",
               "(?:the )?outer (?:ones|BLOCK)"),
    "corners": (f"(?:BE )?(?:(?:in|at|on|as|for) )?{_ITS}(?:corners?|vertices|vertex|corner points)(?: BLOCK| "
    f"ones)?{_OF_IT}", "at corners"),
    "arms": (f"(?:BE )?(?:(?:in|at|as|for|on|forming) )?{_ITS}(?:arms|ends|tips|branches)(?: of it)?{_TWO_PARTS}",
             "(?:BE )?(?:on|at) (?:the|its) outside"),
    "sides": (f"(?:BE )?(?:(?:in|at|as|for|along) )?{_ITS}(?:sides|edges|border|rim|frame|edge)(?: (?:BLOCK|ones))?",
              "(?:BE )?(?:in )?between (?:the corners|corners)"),
    "bar": (f"(?:BE )?(?:(?:in|at|as|for|on|across|forming|along) )?(?:(?:the|its|whose|a) )?{BAR}{_OF_IT}",
    "(?:BE )?across"),
    "stem": (f"(?:BE )?(?:(?:in|at|as|for|forming) )?(?:(?:the|its|whose|a) )?{STEM}{_OF_IT}",
    "(?:BE )?down(?:wards)? (?:in )?the (?:middle|center)",
    "(?:BE )?(?:below|underneath|beneath|under it|below it)(?= [,.;])"),
    "tip": (
    f"(?:BE )?(?:(?:in|at|as|for|on|forming) )?(?:(?:the|its|whose|a) )?(?:tip|point|apex|peak)(?: BLOCK)?{_OF_IT}(?: "
    "(?:where|at which) (?:they|(?:the|its|both) arms) (?:meet|join))?",),
    "base": ("(?:BE )?(?:(?:in|at|as|for|on|forming|along) )?(?:(?:the|its|a) )?(?:base|bottom|bottom (?:row|line|"
    "bar|part))",),
    "rest": ("(?:all )?(?:of )?(?:the |its )?(?:rest|others|remainder|remaining (?:ones|BLOCK)|other (?:ones|"
    "BLOCK))(?: of (?:it|them))?", "everything else", "everywhere else|elsewhere",
    "(?:all )?other BLOCK"),
}  # fmt: skip
PLACES: list[Pattern] = [
    *(found for place, texts in _PLACES.items() for found in patterns("place", place, *texts)),
    *(found for place in ("center", "corners", "tip", "bar") for text in _PLACES[place]
      for found in patterns("place", place, f"(?:the )(?:BLOCK|ones?)(?: (?:that|which) BE)? (?:{text})")),
    *(found for place, texts in _PLACES.items() if place != "rest" for text in texts
      for found in patterns("part", lambda m, place=place: (place, number(m["many"])),
        "(?P<many>NUM)(?: BLOCK)?(?: of (?:them|these))?(?: more| others?)? (?:goes |go |comes |come |on |placed "
        f")?(?:{text})")),
    *patterns("part", ("around", 4), "(?:one |a single one )(?:more )?(?:on|at|for) (?:each|every)(?: one)?(?: of "
        "(?:its|the))?(?: 4)? (?:sides?|arms?|ends?)(?: of it)?"),
    *patterns("part", lambda m: ("rest", number(m["many"])),
        "(?:all )?(?:the )?(?:other|remaining) (?P<many>NUM)(?: ones| BLOCK)?"),
    *patterns("each", "around",
        "(?:BE )?(?:on|at|for) (?:each|every)(?: one)?(?: of (?:its|the))?(?: 4)? sides?(?: of it)?"),
    *patterns("each", "arms",
        "(?:BE )?(?:on|at|for|in) (?:each|every)(?: one)?(?: of (?:its|the))?(?: 4)? (?:arms?|ends?|legs?)(?: of it)?"),
    *patterns("each", "corners",
        "(?:BE )?(?:in|at|on|for) (?:each|every)(?: one)?(?: of (?:its|the))?(?: [34])? corners?(?: of it)?"),
    *patterns("pivot", "around", "(?:BE |all |placed |arranged |set |put )*(?:a?round|surrounding|surround|"
        "surrounds|encircling|encircle|encircles|enclosing)"),
    *patterns("pivot", "within",
        "(?:(?:that |which )?(?:BE )?)?(?:surrounded|encircled|enclosed|ringed|framed)(?: on (?:all|its|all "
        "its)(?: 4)? sides)? (?:by|with)"),
]  # fmt: skip
"""Kinds "place", "part" (a place with a number of blocks) and "pivot" (what stands before it is around what stands
behind it, or "within")."""
