"""Parts that every figure may have: where it is, and the words that only bind parts together."""

from __future__ import annotations

import re

from rpg.language.frames.pieces import Pattern, patterns

_PLACED = r"(?:(?!that |which )BE )?(?:put |placed |set |built )?"
WHERE: list[Pattern] = [
    *patterns("where", lambda match: f"on the {match['patch']}",
        rf"{_PLACED}(?:on|onto|upon|on top of) (?:(?:the|a) )?(?P<patch>(?:(?:SIZE|long|round|square|circular) )?COLOR "
        rf"PATCH)"),
    *patterns("where", lambda match: f"in the {match['side']} half of the table",
        rf"{_PLACED}(?:in|on) the (?P<side>left|right|near|far) half(?: of (?:the )?TABLE)?"),
    *patterns("where", "in the middle of the table", rf"{_PLACED}(?:in|at) the (?:middle|center) of the TABLE"),
    *patterns("glue", None, rf"{_PLACED}(?:flat )?(?:on|upon) the TABLE"),
]  # fmt: skip
"""Kind "where": what is said of the whole figure, to be told behind "The figure is"."""
BREAKS: list[Pattern] = patterns("break", None, r"[,.;:!?]", "and|with|while|where|but|whereas|plus")
"""What parts two things that are said; "then" does not, for it tells an order."""
GLUE: list[Pattern] = [
    *patterns("glue", None, "the|a|an|of|from|using|use|uses|out of|in|into|as|to form|so as to form|in the shape "
        "of|shaped like"),
    *patterns("glue", None, "(?:made|consisting|consists|composed|built|formed up|formed|laid out|laid|constructed|"
        "assembled|arranged|put together|set up)"
        "(?: out)?(?: of| from| by| with)?"),
    *patterns("glue", None, "(?:is it |would it be |it be |it is )?possible (?:to|for (?:you|the robot) to|that you)"),
    *patterns("glue", None, "make|build up|build|create|construct|put together|put|place|set up|set out|set|arrange|"
        "lay out|lay down|lay|assemble|"
        "organize|form|forms|give|"
        "show|shows|line up|bring|produce|prepare|contains|contain|containing|has|having|i "
        "have to|you have to"),
    *patterns("glue", None, "please|could|can|would|will|you|i|we|want|need|like|see|wish|to|me|us|for|let|shall|"
        "kindly|now|just|get|there (?:should|must|shall|has to|needs to) be|there to be"),
    *patterns("glue", None, "is|are|be|being|should|must|stands|stand|lies|lie|it has|it is|they are|(?:which|"
        "that)(?: (?:is|are))?(?! (?:(?:is|are) )?(?:on|in|at|upon|onto) )"),
    *patterns("glue", None, "(?:the |these |all the |those )?(?:blocks|cubes|pieces)"),
    *patterns("glue", None, "(?:the |my |our |your |this )?(?:task|goal|aim|objective|job|mission|assignment|"
    "exercise)(?: "
        "here| now| for you)?(?: (?:is|will be))? (?:consists of|consists in|involves|requires|demands|calls for|"
        "asks for|"
        "about)", "producing|making|building|creating|forming|arranging|placing|constructing|laying out|setting up|"
        "assembling|obtaining|getting"),
    *patterns("glue", None, "(?:my|our|the|his|her) (?:son|daughter|kid|kids|child|children|boy|girl|boss|teacher|"
    "friend|"
        "wife|husband|customer|client|student|students|colleague) (?:wants|want|needs|need|would like|wishes|wish|asks "
        "for|asked for|wanted)(?: to (?:see|have|get))?", "(?:ensure|make sure|be sure|see to it|take care)(?: "
        "that)?", "(?:it )?would be "
        "(?:great|nice|good|lovely|perfect|cool|fine|helpful|ideal|wonderful)(?: if| to have| to see)?", "were|"
        "had", "basically|essentially|simply|actually|out(?= in (?:a|one) )",
        "for (?:a |the |my |our |this )?(?:lesson|class|demo|experiment|test|game|exercise|homework|school|kids|"
        "children|"
        "video|photo|benchmark)"),
    *patterns("glue", None, "for (?:my|our|his|her) (?:(?:little|dear|young|small|old) )?(?:son|daughter|kid|kids|"
        "child|children|boy|boys|girl|"
        "girls|baby|toddler|boss|friend|friends|wife|husband|customer|customers|client|class|student|students|pupils|"
        "doll|"
        "dolls|toy|toys|grandson|granddaughter|niece|nephew|mother|father|mom|dad|sister|brother|teacher|demo|"
        "experiment|"
        "benchmark|test|paper|video|photo|lesson|game|birthday)(?! (?:BE|must|has|have) )",
        "(?:the )?BLOCK colors?(?: (?:BE|:))?"),
    *patterns("glue", None, "nice|neat|tidy|simple|proper|little|final|whole|together"),
    *patterns("glue", None, "(?:would|will|could) (?:be|look) (?:really |very |so |just )?(?:lovely|nice|great|good|"
        "cool|perfect|"
        "wonderful|fun|sweet|awesome|fine|appreciated|ideal)(?: to (?:have|see|get))?"),
    *patterns("glue", None, "(?:in )?(?:the |my |a )?(?:final |end |finished |last |closing |goal |target "
        ")?(?:picture|image|scene|shot|view|photo|frame|state|result|goal|task)(?: is| shows| :)"),
]  # fmt: skip
"""Words that say nothing of their own beside parts. No word that denies, compares, or binds parts in another way."""

_IS_THERE = re.compile(r"\b(The \w+) (?:is|are) (?=(?:on|in|at) )")


def asked(told: str) -> str:
    """Plain sentences ahead of others, "the tower must be on the mat": ahead of a command, "is" tells of the start."""
    return _IS_THERE.sub(r"\1 must be ", told)
