"""Pyramids told layer by layer, "three at the bottom, then two, then one", "four in the bottom row and one fewer in
each row above", "grey two by two at the bottom and a red cube as the tip", as rows that say how large they are."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import FEW, MUST, Turn

_COLOR = f"(?:{'|'.join(sorted(lexicon.COLOR))})"
_MANY = f"(?:\\d+|{FEW})"
_MORE = "(?: (?:ones?|more))?"
_N = "(?: (?:blocks?|cubes?|bricks?|ones?))?"
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
_HEAD = "\\b(pyramid\\b[^,:]*?)(?: ,| :| with| of| that has| which has|;)+"
_TOTAL = "(?: ,)? (?:(?:so|that is|i.e.|making|which makes|in all)(?: it is| that is)? )"
_DOWN = (("two|2", ""), ("three|3", "two|2"), ("four|4", "three|3 two|2"), ("five|5", "four|4 three|3 two|2"))


def _layers(look: str = "") -> tuple[tuple[str, str], ...]:
    """How the layers of pyramids are told, and how many blocks the lowest one has. `look`: what is said of the others
    where one is said of the lowest."""
    one, noun = ("(?:one|1)", look + _MORE) if look else ("(?:one|1|a)", _N)
    found = []
    for base, above in _DOWN:
        inner = "".join(f"{_AND}{_IS} (?:{many}){noun}{_IS}(?:{_ABOVE})?" for many in above.split())
        told = f"(?:{base})LOOK{_N}{_IS}{_BOTTOM}{inner}{_AND} (?:(?:a )?single |just )?{one}{noun}{_IS}(?:{_TOP})?"
        found.append((base.partition("|")[0], told))
    return tuple(found)


PYRAMIDS: tuple[Turn, ...] = (
    ("\\b(pyramid) on (an? base of)\\b", "{1} with {2}"),
    (f"{_HEAD} ({_MANY}){_N}{_BOTTOM}{_AND}(?: always)? one{_N} (?:fewer|less){_N}(?: (?:in|on|for|with|at))? (?:each|"
     "every)(?: next| following| further)?(?: row| layer| level| course| step)?(?: above(?: it| that| them)?| up| "
     "higher "
     "up| on top)?$", "{1} with a base of {2}"),
    # one colour, or none
    *((f"{_HEAD} {layers.replace('LOOK', '')}$", f"{{1}} with a base of {base}") for base, layers in _layers()),
    *((f"\\b(pyramid)(?: ,| :| with| of| that has)+ {layers.replace('LOOK', f' ({_COLOR})')}$",
       f"{{1}} of {{2}} blocks with a base of {base}") for base, layers in _layers("(?: \\2)?")),
    *((f"^{layers.replace('LOOK', f' ({_COLOR})')} (?:make up|form|make|are|give) (an? (?:\\w+ )?pyramid)$",
       f"{{2}} of {{1}} blocks with a base of {base}") for base, layers in _layers("(?: \\1)?")),
    # square ones
    *((f"\\b(?:square )?(pyramid\\b[^,:]*?)(?: ,| :| with)+ (?:{nine}){_N}{_BOTTOM}{_AND} (?:four|4){_N}{_ABOVE}{_AND} "
       f"(?:one|1){_N}{_TOP}$", f"{{1}} with a {side} base")
      for nine, side in (("nine|9", "three by three"), ("16|sixteen{_AND} (?:nine|9){_N}{_ABOVE}", "four by four"))),
    (f"\\b(?:square )?(pyramid)(?: ,| :| with| of)+(?: an?)? ({_COLOR}) {_SQUARE}{_BOTTOM}{_AND} (?:an?|one)(?: "
     f"single)? "
     f"({_COLOR}){_N}{_TOP}$", "{1} with a two by two base of {2} blocks and a {3} block on top"),
    (f"^(?:four|4) ({_COLOR}){_N}(?: (?:in a|as a|in|,))? {_SQUARE}(?: square)?(?:{_BOTTOM}| base){_AND} (?:an?|"
     f"one)(?: "
     f"single| fifth)? ({_COLOR}){_N}{_TOP}(?: ,| :)+ (an? (?:\\w+ )?pyramid)$",
     "{3} with a two by two base of {1} blocks and a {2} block on top"),
    (f"\\b(pyramid)(?: ,| :| with| of)+ (?:four|4){_N} {_SQUARE}{_BOTTOM}{_AND} (?:an?|one){_N}{_IS}{_TOP}$",
     "{1} with a two by two base"),
    (f"\\b(pyramid) (?:with|on) (?:an? )?base of {_SQUARE} ({_COLOR}){_N} and (an?|one) ({_COLOR}){_N}{_TOP}$",
     "{1} with a two by two base of {2} blocks and {3} {4} block on top"),
    (f"\\b(pyramid) on (an?) {_SQUARE} base(?: ,| with| and)+ (?:an?|one)(?: "
     f"single)?{_N}{_TOP}$", "{1} with a two by two base"),
    (f"\\b(pyramid) on (an?) {_SQUARE} base(?: ,| with)+ the (?:four )?base{_N}{_IS} ({_COLOR}) and the (?:peak|"
     f"tip|top)"
     f"{_N}{_IS} ({_COLOR})$", "{1} with a two by two base of {3} blocks and a {4} block on top"),
    # layers in colours of their own
    (f"\\b(pyramid)(?: ,| :| of| with)+ an? ({_COLOR}) base of (3|three){_AND} an? ({_COLOR}) layer of (?:two|2){_AND} "
     f"an? ({_COLOR}){_N}{_TOP}$",
     "{1} with a base of {3} , the bottom layer {2} , the middle layer {4} and the top {5}"),
    (f"\\b(pyramid)(?: ,| :| of| with)+ (3|three){_N}{_BOTTOM}(?: all)? ({_COLOR}){_AND} (?:2|two){_N}{_ABOVE} "
     f"({_COLOR})"
     f"{_AND} (?:1|one|an?) ({_COLOR}){_N}{_TOP}$",
     "{1} with a base of {2} , the bottom layer {3} , the middle layer {4} and the top {5}"),
    (f"\\b(pyramid)(?: ,| :| of| with| that has)+ (3|three) ({_COLOR}){_N}{_BOTTOM}{_AND} (?:2|two){_MORE}(?:{_ABOVE})?"
     f"{_AND} (?:1|one|an?) ({_COLOR}){_N}{_TOP}$", "{1} with a base of {2} with a {4} top and the rest {3}"),
    # how many there are in all
    (f"\\b(pyramid)\\b(.*\\b(?:base|bottom)\\b.*?){_TOTAL}({_MANY}(?: {_COLOR})? (?:blocks|cubes|bricks))(?: in "
     f"(?:total|"
     "all)| altogether)?$", "{1} of {3} {2}"),
    # the tip
    (f"\\b(pyramid\\b.*?)(?: ,)? all(?: of it)? ({_COLOR}) (?:but|except|apart from|save)(?: for)? the "
     f"({_COLOR}){_N} (?:at|"
     "on) (?:the )?top$", "{1} with a {3} top and the rest {2}"),
    (f"\\b(pyramid of {_MANY} {_COLOR} (?:blocks|cubes)) and (?:an?|one) ({_COLOR}){_N} (?:at|on) (?:the )?(?:very "
     f")?top$",
     "{1} and one {2} block with the {2} block on top"),
    (f"^(?:use|take) the ({_MANY} {_COLOR} (?:blocks|cubes)) as (?:the|a) base (?:of|for) (an? pyramid) whose "
     f"(?:top|tip|"
     f"peak) is the ({_COLOR})(?: one| block| cube)?$", "{2} with a base of {1} and a {3} block on top"),
    (f"\\b(pyramid) (?:in which|where) the ({_MANY} {_COLOR} (?:blocks|cubes)) are the base and the ({_COLOR})(?: one| "
     "block| cube)? is (?:the|its) (?:top|tip|peak)$", "{1} with a base of {2} and a {3} block on top"),
    (f"(?:, )?the (?:base|lowest layer|bottom layer|bottom row) of which (?:is|{MUST} be|is formed by|consists of) "
     f"a row "
     f"of ({_MANY}) (?:blocks|cubes)$", "with a base of {1} blocks"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
