"""The order of the rainbow in other words, "like the colors of the rainbow", "the way they come in a rainbow", as rows
that call it rainbow order; lines that are told as a rainbow."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, END, MUST, WAY

_LINE = "(?:row|line|column|tower|stack)"
_SPECTRUM = "(?:the |a )?(?:rainbow|spectrum|color spectrum|spectrum of colors)"
_COLORS = "(?:(?:the |its |their )?colors? )?"
_SORTED = "(?:(?:sorted|ordered|arranged|placed|laid out|lined up) )?"
_COME = "(?:appear|come|follow each other|follow one another|follow|occur|stand|are|lie|are found|have)"
_OF_IT = f"(?:(?:the )?colors of {_SPECTRUM}|{_SPECTRUM}(?: colors)?)"
_ALONG = f"(?:the )?{END} to (?:the )?{END}"
_MADE = "(?:formed|made|built|laid|laid out|created|arranged)"

RAINBOWS_AT_ONCE: tuple[Turn, ...] = (
    # the order
    (f"(?: ,)? {_SORTED}(?:(?:exactly |just )?(?:like|as)|the way|in the way|in the (?:same )?order (?:in which|"
     f"that)) (?:(?:the |its )?colors|they) {_COME} in {_SPECTRUM}", " in rainbow order"),
    (f"(?: ,)? {_SORTED}(?:in the (?:same )?order (?:as|like) (?:in )?|(?:by|following|according to|in accordance "
     f"with|based on|along|in keeping with) (?:the order of )?){_OF_IT}", " in rainbow order"),
    (f"(?: ,)? {_SORTED}{_COLORS}(?:(?:in )?order )?(?:just )?(?:like|as) (?:in )?(?:(?:the )?colors of "
     f")?{_SPECTRUM}(?=$| ,| \\.| \\)| {WAY}| with| start| begin| on| in an? {_LINE})", " in rainbow order"),
    ("(?: ,)? (?:so|such|so that|such that|whose|where|in which|with)(?: that)? (?:the |its |their )?(?:colors|they|"
     f"it) (?:{MUST} )?(?:follow|follows|following|match|go through|run through) (?:the order of )?{_OF_IT}",
     " in rainbow order"),
    # where it begins
    (f"(\\brainbow order|\\bgradient .+?)(?: ,| -)? (?:(?:which|that|and|it|and it|the {_LINE}) )?(?:{MUST} "
     f")?(?:begins|begin|starts|start) with ((?:the )?{COLOR}\\b)", "{1} , beginning with {2}"),
    (f"^in rainbow order(?: and| ,| ,  and)? ((?:beginning|starting) with (?:the )?{COLOR}(?: (?:at|on|from) the "
     "\\w+(?: end| side)?)?) , (.+)$", "{2} in rainbow order , {1}"),
    (f"^rainbow order(?: ,)?( (?:from )?{_ALONG})?(?: ,)?( (?:beginning|starting) with (?:the )?{COLOR}(?: (?:at|on|"
     "from) the \\w+(?: end| side)?)?)? : (.+)$", "{3} in rainbow order {1} {2}"),
    # lines that are told as a rainbow
    (f"\\bgradient(?: (?:running|going|that runs|that goes|which runs))? from ({COLOR}) (?:on|at) the (left|right|"
     f"front|back|bottom|top)(?: end| side)?( .+?)?(?: ,)? to ({COLOR}) (?:on|at) the (left|right|front|back|bottom|"
     "top)(?: end| side)?$", "gradient from {1} {3} to {4} from {2} to {5}"),
    (f"^(?:lay out|lay|make|build|form|put|show|create|arrange) a rainbow(?: in an? ({_LINE}))? : (.+?)(?: in an? "
     f"(?:{_LINE}))?( {WAY})?$", "put {2} in a row in rainbow order {3}"),
    (f"\\b({_LINE}) (?:of|with|in) (?:the )?rainbow colors(?: ,)?( {WAY})? (?=[:,])", "rainbow {1} {2}"),
    (f"^an? ({_LINE}) {MUST} be {_MADE}(?: ,)? (?:in which|where) (.+?) (?:follow (?:one another|each other)|are|"
     "stand|come|are placed|are arranged|are laid) (in \\w+ order.*)$", "{2} must be in a {1} {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("spectrum occur way",)
"""Words that these take besides those that are read anyway."""
