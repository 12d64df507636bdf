"""What is told of the start beside what is to be done, "the red block, now on the mat, ...", "from where it starts", as
rows that tell it plainly; and what tells of other times."""

from __future__ import annotations

from rpg.language.grammar.rows.at_times import AT_TIMES
from rpg.language.grammar.rows.traded import TRADED
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import LENGTH, LINE, MUST

_PLACE = "(?:on|next to|beside|to the left of|to the right of|in front of|behind|in|under) the [^,]+?"
_NOW = "(?:now|at the moment|at present|right now|currently|at first|initially)"
_REGION = "(the (?:(?:left|right|near|far) half|(?:(?:near|far|front|back|left|right) ){2}corner))(?: of the table)?"
BEFORE_IT: tuple[Turn, ...] = (
    (f"^([^,]+?) , (?:which|that) (?:is|lies|stands|sits) ({_PLACE}) {_NOW} , ", "{1} , which starts {2} ,"),
    (f"^([^,]+?) (?:is|lies|stands|sits) ((?:on|next to|left of|right of|behind|in front of|in) [^,]+?) {_NOW}(?: ,)? "
     f"(?:and|but) (it {MUST} .+)$", "at the start , {1} is {2} . {3}"),
    (f"^([^,]+?) (?:is|lies|stands|sits) ((?:on|next to|left of|right of|behind|in front of|in) [^,]+?) {_NOW}(?: ,)? "
     "(?:and|but) belongs (.+)$", "at the start , {1} is {2} . it must be {3}"),
    (f"^move (.+?) at least ({LENGTH}) each$", "move {1} by at least {2}"),
    ("^get (the .+?) out from under (the .+?) and put it (.+)$", "at the start , {2} is on {1} . put {1} {3}"),
    (f"^(?:at the start|initially|at first)(?: ,)? a ({LINE}) has (.+)$", "at the start there is a {1} with {2}"),
    (f"^the ({LINE}) (?:at the start|currently|now) reads (.+)$", "at the start , the {1} is {2}"),
    ("\\bbut only (?:when|once|if) (the .+?) (?:already )?(?:lies|is|stands|sits)(?: already)? (on .+)$",
     "but only after {1} has been put {2}"),
    (f"^(?:put|move|bring|carry|take) (.+?) from {_REGION} (?:to|into) {_REGION}$",
     "at the start , {1} is in {2} of the table . put {1} in {3}"),
    (f"^(an? {LINE}(?: of)? .+?) (?:(?:is )?(?:standing|lying)|stands|lies|is|has been built|was built) (?:on the "
     "table|there)$", "there is {1}"),
    *AT_TIMES,
    *TRADED,
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("present",)
"""Words that these take besides those that are read anyway."""
