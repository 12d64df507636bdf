"""Where a block belongs, told by a noun, and what would be a failure: "the destination of the blue cube is the red
mat", "the task fails if red is not on blue", as rows that say how it must be."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MUST, PATCH

_RIGHT = "(?:right|correct|proper|intended|final|own|assigned|designated|desired|target|goal|end)"
_HOME = f"(?:(?:{_RIGHT} )?(?:place|spot|destination|home|target|goal)|{_RIGHT} (?:position|location))"
"""Where something belongs; its position alone may be the one that it has."""
_MAT = f"(the (?:(?:{COLOR}|left|right|near|far) )?{PATCH})"
_ONE = f"((?:the )?{COLOR}(?: block| cube| one)?|(?:the )?(?:block|cube|letter) \\w|the (?:block|cube))"
_BE = f"(?:is|{MUST} be|will be)"
_TASK = "(?:the|this|an?|each|every|your|my) (?:task|episode|run|trial|attempt|robot|agent|policy|mission|job|test)"
_FAILS = (
    f"(?:(?:{_TASK}|it|you|we|i) (?:fails?|loses?|has failed|have failed|is failed|{MUST} fail|counts? as (?:a )?"
    "(?:failure|failed|fail)|is (?:considered |deemed |judged )?(?:a )?(?:failure|fail|failed|unsuccessful|lost|not "
    "solved|not done|not successful))|failure)"
)
_NOTHING_WON = (
    "(?:(?:there is |there will be )?no (?:success|reward|points?|credit)(?: is given)?|not (?:done|solved|finished)|"
    f"(?:{_TASK}|it|you|we) (?:is|are) not (?:done|solved|finished|complete|over|successful))"
)
_END = "(?: (?:at|in|by) the (?:very )?end(?: of (?:the|an|each) (?:episode|task|run))?)?"

DESTINATIONS: tuple[Turn, ...] = (
    (f"^the {_HOME} (?:of|for) {_ONE} {_BE} {_MAT}$", "{1} must be on {2}"),
    (f"^{_ONE} 's {_HOME} {_BE} {_MAT}$", "{1} must be on {2}"),
    (f"^{_MAT} {_BE} (?:the {_HOME} (?:of|for) {_ONE}|where {_ONE} (?:goes|belongs|{MUST} (?:be|go)))$",
     "{2} {3} must be on {1}"),
    (f"^the {_HOME} (?:of|for) {_ONE} {_BE} ({PLACE} .+)$", "{1} must be {2}"),
    (f"^{_ONE} 's {_HOME} {_BE} ({PLACE} .+)$", "{1} must be {2}"),
    (f"^{_FAILS}(?: ,)? (?:if|when|whenever|as long as) ({THING}) (?:is|are) not (.+?){_END}$", "{1} must be {2}"),
    (f"^(?:{_FAILS}|{_NOTHING_WON})(?: ,)? (?:unless|if not|until) (.+?){_END}$", "at the end {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("destination fail fails failed failure lose loses lost deemed unsuccessful assigned designated unless",)
"""Words that these take besides those that are read anyway."""
