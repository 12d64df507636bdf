"""Pyramids told layer by layer, "three at the bottom, then two, then one", "four in the bottom row and one fewer in
each row above", "grey two by two at the bottom and a red cube as the tip", as rows that say how large they are."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, N

_MORE = "(?: (?:ones?|more))?"
_IS = f"(?:(?: ,)?(?: is| are| lies?| stands?| being| placed| centered| {MUST} be))?"
_AND = "(?:(?: ,| and| then| :| ;)*)"
_BOTTOM = ("(?: (?:at|on|in|for) (?:the |its )?(?:very )?(?:bottom|base|ground)(?: row| layer| level)?| below| down| "
           "underneath| as (?:the |its |a )?(?:bottom|base|foundation)(?: row| layer)?)")  # fmt: skip
_ABOVE = ("(?: (?:above|over|on|on top of|upon) (?:it|them|that|those|these)| above| in (?:the )?(?:middle|center)"
          "(?: row| layer)?| next| in the (?:second|next|third) (?:row|layer))")  # fmt: skip
_TOP = ("(?: (?:at|on|for|as) (?:the |its )?(?:very )?(?:top|peak|tip|apex)(?: of (?:it|them|that|all))?| up| above| "
        "above (?:them|it)| (?:on|over) (?:it|them|those|that))(?:(?: ,)? (?:in|at) the (?:middle|"
        "center))?")  # fmt: skip
_SQUARE = "(?:2x2|two by two|2 by 2|2 x 2)"
_BASE = "(2x2|two by two|2 by 2|2 x 2|3x3|three by three|3 by 3)"
_HEAD = "\\b(pyramid\\b[^,:]*?)(?: ,| :| with| of| that has| which has|;)+"
_TOTAL = "(?: ,)? (?:(?:so|that is|i.e.|making|which makes|in all)(?: it is| that is)? )"
_DOWN = (("two|2", ""), ("three|3", "two|2"), ("four|4", "three|3 two|2"))


def _layers(look: str = "") -> tuple[tuple[str, str], ...]:
    """How the layers of pyramids are told, and how many blocks the lowest one has. `look`: what is said of the others
    where one is said of the lowest."""
    one, noun = ("(?:one|1)", look + _MORE) if look else ("(?:one|1|a)", N)
    found = []
    for base, above in _DOWN:
        inner = "".join(f"{_AND}{_IS} (?:{many}){noun}{_IS}(?:{_ABOVE})?" for many in above.split())
        told = f"(?:{base})LOOK{N}{_IS}{_BOTTOM}{inner}{_AND} (?:(?:a )?single |just )?{one}{noun}{_IS}(?:{_TOP})?"
        found.append((base.partition("|")[0], told))
    return tuple(found)


_SIZED = "(\\d+x\\d+|(?:\\d+|two|three) by (?:\\d+|two|three))"
_ARE = f"(?:is|are|{MUST} be)"

_OF_SQUARES = "(?:5|five|14|fourteen|30|thirty)"
"""So many blocks make a pyramid with a square base."""

PYRAMIDS: tuple[Turn, ...] = (
    ("\\b(?:planar|two - dimensional|2d|flat) (?=(?:vertical|upright|standing) (?:pyramid|wall)\\b)", ""),
    ("\\bpyramid (?:- )?(?:like|shaped) (?:stack|pile|figure|shape|structure|tower|heap)\\b", "pyramid"),
    ("\\b(pyramid) on (an? base of)\\b", "{1} with {2}"),
    # a pyramid without a square base is in one plane anyway
    (f"\\b(pyramid)(?: ,)? (?:(?:all|standing|built|lying) )*(?:in|within) (?:one|a|a single|one single|the same)(?: "
     f"vertical| upright)? plane\\b(?!.*(?:\\bsquare\\b|\\d+x\\d|\\bby\\b|\\b{_OF_SQUARES} "
     f"(?:{COLOR} )?(?:blocks|cubes)))",
     "{1}"),
    (f"{_HEAD} ({MANY}){N}{_BOTTOM}{_AND}(?: always)? one{N} (?:fewer|less){N}(?: (?:in|on|for|with|at))? (?:each|"
     "every)(?: next| following| further)?(?: row| layer| level| course| step)?(?: above(?: it| that| them)?| up| "
     "higher up| on top)?$", "{1} with a base of {2}"),
    ("\\b(pyramid\\b.*?)(?: ,)? (?:and|which|that|so that it)(?: (?:goes|gets|narrows|tapers|rises|runs|becomes|"
     f"is))+(?: up| down| smaller| narrower)* (?:to )?(?:one|1|a single|just one){N}(?: wide)?(?: (?:at|on) (?:the "
     f")?(?:top|tip|peak))?$",
     "{1}"),
    (f"\\b(pyramid\\b.*? wide{_BOTTOM}) and (?:one|1|a single|just one){N}(?: wide)?{_TOP}$", "{1}"),
    # one colour, or none
    *((f"{_HEAD} {layers.replace('LOOK', '')}$", f"{{1}} with a base of {base}") for base, layers in _layers()),
    *((f"\\b(pyramid)(?: ,| :| with| of| that has)+ {layers.replace('LOOK', f' ({COLOR})')}$",
       f"{{1}} of {{2}} blocks with a base of {base}") for base, layers in _layers("(?: \\2)?")),
    *((f"^{layers.replace('LOOK', f' ({COLOR})')} (?:make up|form|make|are|give) (an? (?:\\w+ )?pyramid)$",
       f"{{2}} of {{1}} blocks with a base of {base}") for base, layers in _layers("(?: \\1)?")),
    # square ones
    (f"\\b(?:square )?(pyramid\\b[^,:]*?)(?: ,| :| with)+ (?:nine|9){N}{_BOTTOM}{_AND} (?:four|4){N}{_ABOVE}{_AND} "
     f"(?:one|1){N}{_TOP}$", "{1} with a three by three base"),
    (f"\\b(?:square )?(pyramid)(?: ,| :| with| of| from| out of| on)+(?: an?)? (?:(?:base of )?{_BASE}(?: base of)? "
     f"({COLOR}){N}(?:{_BOTTOM})?|({COLOR}) {_BASE}{_BOTTOM}|(?:four|4) ({COLOR}){N} as an? (2x2|two by two|2 by 2|2 "
     f"x 2) base){_AND} (?:an?|"
     f"one)(?: single)? ({COLOR}){N}{_TOP}$",
     "{1} with a {2} {5} {7} base of {3} {4} {6} blocks and a {8} block on top"),
    (f"^(?:four|4) ({COLOR}){N}(?: (?:in a|as a|in|,))? {_SQUARE}(?: square)?(?:{_BOTTOM}| base){_AND} (?:an?|one)(?: "
     f"single| fifth)? ({COLOR}){N}{_TOP}(?: ,| :)+ (an? (?:\\w+ )?pyramid)$",
     "{3} with a two by two base of {1} blocks and a {2} block on top"),
    (f"\\b(pyramid)(?: ,| :| with| of| on)+ (?:(?:four|4){N} {_SQUARE}{_BOTTOM}|an? {_SQUARE} base)(?:{_AND}| with) "
     f"(?:an?|one)(?: single)?{N}{_IS}{_TOP}$", "{1} with a two by two base"),
    (f"\\b(pyramid) on (an?) {_SQUARE} base(?: ,| with)+ the (?:four )?base{N}{_IS} ({COLOR}) and the (?:peak|tip|"
     f"top){N}{_IS} ({COLOR})$", "{1} with a two by two base of {3} blocks and a {4} block on top"),
    # layers in colours of their own
    (f"\\b(pyramid)(?: ,| :| of| with)+ (?:an? ({COLOR}) base of (3|three)|(3|three){N}{_BOTTOM}(?: all)? "
     f"({COLOR})){_AND} (?:an? ({COLOR}) layer of (?:two|2)|(?:2|two){N}{_ABOVE} ({COLOR})){_AND} (?:1|one|an?) "
     f"({COLOR}){N}{_TOP}$",
     "{1} with a base of {3} {4} , the bottom layer {2} {5} , the middle layer {6} {7} and the top {8}"),
    # how many there are in all
    (f"\\b(pyramid)\\b(.*\\b(?:base|bottom)\\b.*?){_TOTAL}({MANY}(?: {COLOR})? (?:blocks|cubes|bricks))(?: in "
     "(?:total|all)| altogether)?$", "{1} of {3} {2}"),
    # the tip
    (f"\\b(pyramid\\b.*?) with (?:an?|one|a single) ({COLOR}){N} (?:crowning|topping|capping) (?:it|them|this|"
     f"everything)$",
     "{1} topped by a {2} block"),
    (f"\\b(pyramid\\b.*?)(?: ,)? all(?: of it)? ({COLOR}) (?:but|except|apart from|save)(?: for)? the ({COLOR}){N} "
     "(?:at|on) (?:the )?top$", "{1} with a {3} top and the rest {2}"),
    (f"\\b(pyramid of {MANY} {COLOR} (?:blocks|cubes)) and (?:an?|one) ({COLOR}){N} (?:at|on) (?:the )?(?:very )?top$",
     "{1} and one {2} block with the {2} block on top"),
    (f"^(?:use|take) the ({MANY} {COLOR} (?:blocks|cubes)) as (?:the|a) base (?:of|for) (an? pyramid) whose (?:top|"
     f"tip|peak) is the ({COLOR})(?: one| block| cube)?$", "{2} with a base of {1} and a {3} block on top"),
    (f"\\b(pyramid) (?:in which|where) the ({MANY} {COLOR} (?:blocks|cubes)) are the base and the ({COLOR})(?: one| "
     "block| cube)? is (?:the|its) (?:top|tip|peak)$", "{1} with a base of {2} and a {3} block on top"),
    (f"(?:, )?the (?:base|lowest layer|bottom layer|bottom row) of which (?:is|{MUST} be|is formed by|consists of) a "
     f"row of ({MANY}) (?:blocks|cubes)$", "with a base of {1} blocks"),
    # pyramids
    (f"\\b(pyramid of [^,:]+?) (?:in which|where) the base(?: of \\w+)? {_ARE} (\\w+) , the (?:second|middle) layer "
     f"(?:{_ARE} )?(\\w+)(?: ,)? and the (?:tip|top|topmost block) (?:{_ARE} )?(\\w+)$",
     "{1} : the base {2} , the second layer {3} , the tip {4}"),
    (f"\\b(an?|one) (pyramid with (?:an? )?{_SIZED} base)(?: ,| and| with)+ (?:an?|one|a single) (block|cube) (on "
     f"top)(?: of it)?(?: ,| and)+ (?:they are )?all(?: of them)?(?: (?:block|cube)s)?(?: in)? ({COLOR})$",
     "{1} {6} {2} and one {4} {5}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("crowning capping narrows plane",)
"""Words that these take besides those that are read anyway."""
