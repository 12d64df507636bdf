"""Stairs as people tell of them: "stairs that climb to the left", "the lowest step on the right", "one red block, then
two white ones, then three blue ones"; and what a figure is like, said in a sentence of its own behind it."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, ME, MUST, N
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_STAIRS = "(?:staircase|stairs|stairway)"
_UP = ("(?:rises?|rising|climbs?|climbing|ascends?|ascending|goes up|go up|leads? up|leading up|runs? up|running up|is "
       "going up|"
       "are going up|steps? up|be rising|be climbing|be ascending)")  # fmt: skip
_DOWN = "(?:descends?|descending|goes down|go down|going down|leads? down|steps? down|falls?|falling)"
_LINK = f"(?: ,)?(?: and| so that| such that)?(?: which| that| it| they)?(?: {MUST})?"
_TO = "(?:to|towards?) the"
_ON = "(?:(?: is| being|is to be| stands| standing)? (?:on|at) the)"
_STEP = "(?: step| column| one| stair| tower)?"
_HIGH = "(?:highest|tallest|largest|biggest)"
_LOW = "(?:lowest|shortest|smallest)"
_THEN = "(?: ,)?(?: and)?(?: then)?"
_NEXT = f"(?:the )?(?:next|second|middle){_STEP}"
_HAS = "(?: is| has| are| being| of| :)?"
_END = "(?:left|right|front|back)"
_SIDES = (("left", "right"), ("right", "left"), ("front", "back"), ("back", "front"))
_WHOSE = "(?: ,| with| where| whose)*(?: that| which)?(?: is| are)?(?: the| its)?"
_BEFORE = f"\\b((?:{_STAIRS})\\b(?:(?! going up ).)*?)"
_CLIMBING = f"({_STAIRS}\\b.*? going up to the {_END})(?: ,| :)*"

STAIRS: tuple[Turn, ...] = (
    (f"{_BEFORE}{_LINK} {_UP} (?:from (?:the )?{_END} )?(?:to|towards?) (?:the )?({_END})\\b(?! of\\b)",
     "{1} going up to the {2}"),
    (f"{_BEFORE}{_LINK} (?:{_UP}|going up(?:wards)?) away(?: from {ME})?\\b", "{1} going up to the back"),
    (f"{_BEFORE}{_LINK} (?:{_UP}|going up(?:wards)?) (?:to|towards?) {ME}\\b", "{1} going up to the front"),
    # which end is high
    *((f"{_BEFORE}(?:{_LINK} {_DOWN} (?:from (?:the )?{high} )?{_TO} {low}\\b(?! of\\b)|{_WHOSE} {_LOW}{_STEP}{_ON} "
       f"{low}(?:(?: ,| and)+(?: the| its)? {_HIGH}{_STEP}{_ON} {high})?(?= ,|$))", f"{{1}} going up to the {high}")
      for low, high in _SIDES),
    (f"{_BEFORE}{_WHOSE} {_HIGH}{_STEP}{_ON} ({_END})(?:(?: ,| and)+(?: the| its)? {_LOW}{_STEP}{_ON} {_END})?(?= ,|$)",
     "{1} going up to the {2}"),
    (f"{_BEFORE}(?: ,| with| where)* one (?:block|cube) (?:high|tall) (?:on|at) the {_END}(?: ,| and)+ three "
     f"(?:blocks|cubes) (?:high|tall) (?:on|at) the ({_END})$", "{1} going up to the {2}"),
    # step by step
    (f"{_CLIMBING} (?:(?:the )?{_LOW}{_STEP}{_HAS} )?one ({COLOR}){N}{_THEN}(?: {_NEXT}{_HAS})? two "
     f"({COLOR}){N}{_THEN}(?: the (?:{_HIGH}|last|third){_STEP}{_HAS})? three ({COLOR}){N}$",
     "{1} , the lowest column one {2} block , the middle column two {3} blocks and the highest column three {4} "
     "blocks"),
    (f"\\b({_STAIRS}\\b.*?)(?: ,| :)* (?:with )?one(?: step)?{N}(?: high)?{_THEN} two(?: steps)?{N}(?: high)?{_THEN} "
     f"three(?: steps)?{N} high$", "{1} with heights one , two and three"),
    (f"\\b({_STAIRS}\\b.*?) in steps of (one|1) , (two|2) and (three|3)\\b", "{1} with steps of {2} , {3} and {4}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""

_OF_STAIRS = on_demand(
    f"(?:(it|they|the {_STAIRS}|these|this) (?:{MUST} )?(?:{_UP}|{_DOWN}) (?:{_TO}|from)|(?:its|the) (?:{_HIGH}|{_LOW})"
    f"{_STEP}(?:{_ON}| is)|one{N} ?,? (?:and )?then two|one {COLOR}{N} ,)"
)
_OF_LETTERS = on_demand(
    "(?:the|its) (?:bar|crossbar|stem|foot)(?: of (?:it|the [tT]))? (?:is|lies|points|stands) (?:at|on|to)"
)
_OF_GRIDS = on_demand("(?:the |its )?(?:columns|rows) ,? ?from (?:left|right|front|back)")
"""How a sentence begins that tells of what the one before it builds."""
_TOLD = (({"staircase", "stairs", "stairway"}, _OF_STAIRS), ({"t", "T"}, _OF_LETTERS), ({"grid"}, _OF_GRIDS))


def of_the_figure(tokens: list[Token]) -> list[Token]:
    """ "Build a staircase of three steps. It goes up to the left.": one sentence, of the stairs that are built."""
    out: list[Token] = []
    begin = 0
    for n, token in enumerate(tokens):
        out.append(token)
        stops = token.kind == "punct" and token.word in STOPS
        before = {x.word for x in tokens[begin:n]}
        behind = " ".join(x.word for x in tokens[n + 1 : n + 12]) if stops and "up" not in before else ""
        if behind and any(before & names and told.match(behind) for names, told in _TOLD):
            out[-1] = replace(token, word=",", raw=",")
        elif stops:
            begin = n + 1
    return out
