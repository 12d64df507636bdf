"""Sentences that begin with what stands last elsewhere, a place or a participle: "standing on the mat should be a
tower", "to the left of it is to be placed the green one, to the right the blue one", "to be stacked: A, B and C", as
rows in the usual order of words."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import LINE, MANY, MUST

_LYING = "(?:standing|lying|resting|sitting|placed|located|situated|positioned|perched)"
_PUT = "(?:put|placed|laid|set|found|located|positioned|situated|seen|brought|moved)"
_BUILT = "(?:built|erected|formed|made|constructed|created|laid|assembled|set up|stacked)"
_TIME = "(?: ,)?(?: at the end| in the end| finally| at last)?(?: ,)?"
_SOME = f"(?:(?:the|an?|one|both|all|all the|{MANY}) [^,]+?)"
_THERE = f"((?:{PLACE}|at) (?:the|an?|it|its|them) ?(?:\\w+ ){{0,3}}?\\w+(?: of (?:the|a) (?:\\w+ )?\\w+)?)"
_THEN = "(?: ,| and| , and| , while| while)"
_GOES = f"(?:{MUST} (?:be )?(?:{_PUT}|lie|stand|come|go|sit)|comes?|goes|go|belongs?)"
_WANTED = "(?:wanted|required|desired|asked for|needed|requested|what (?:i|we) (?:want|need)|the (?:goal|task|aim))"
_OF_IT = "(?:whose|of which|in which|the \\w+ \\w* ?of which|where|with)"
_DONE = {"stack": "(?:stacked|piled)", "sort": "(?:sorted|grouped)", "arrange": "(?:arranged|ordered|aligned|lined)"}

TURNED_ROUND_AT_ONCE: tuple[Turn, ...] = (
    ("\\b(touch(?:ing)?|next to|beside|against) themselves\\b", "{1} each other"),
)
"""What is of nothing as it stands."""
TURNED_ROUND: tuple[Turn, ...] = (
    # a participle, or what is to be done, first
    (f"^{_LYING} {_THERE} ((?:is|are|{MUST} be)(?: found| seen)?){_TIME} ({_SOME}|{THING})$", "{3} {2} {1}"),
    (f"^to be {_PUT} ({PLACE} [^:]+?) : (.+)$", "put {2} {1}"),
    *((f"^to be {done}(?: up)?( [^:]+?)? : (.+)$", f"{do} {{2}} {{1}}") for do, done in _DONE.items()),
    (f"^to be {_BUILT}(?: up)? : (.+)$", "build {1}"),
    # a place first
    (f"^{_THERE} {_GOES} ({_SOME}|{THING})$", "{2} must be {1}"),
    (f"^{_THERE} {_GOES} ({_SOME}|{THING}){_THEN} {_THERE} ({_SOME}|{THING})$",
     "{2} must be {1} , {4} {3}"),
    (f"^{_THERE} ({_SOME}|{THING}) {_GOES}{_THEN} {_THERE} ({_SOME}|{THING})$",
     "{2} must be {1} , {4} {3}"),
    # what is wanted first, or last
    (f"^that (.+?)(?: ,)? is (?:what is )?{_WANTED}$", "{1}"),
    (f"^where ({THING}) (?:{MUST} (?:go|be|stand|lie|come)|goes|belongs) is ({PLACE} .+)$", "{1} must be {2}"),
    (f"^the (?:letter|digit|number|block|cube|one) (?:that|which) (?:is|stands|lies|sits|rests) ({PLACE} [^,]+?) "
     f"{MUST} be ({THING})$", "{2} must be {1}"),
    ("^let there (?:come|go) ", "put "),
    # a figure, and far behind it what it is like
    (f"^(an?|one) ({LINE}(?: of [^,]+?)?) {MUST} be {_BUILT}(?: ,)? ({_OF_IT} .+)$", "build {1} {2} {3}"),
    (f"^(?:it|there) {MUST} be {_BUILT} (an?|one) ({LINE}.*)$", "build {1} {2}"),
    # "there must not stand any cube on it"
    (f"^there ({MUST}|may|can) not (?:be|stand|lie|sit|rest|stay) an?y? (blocks?|cubes?) ({PLACE} .+)$",
     "no {2} {1} be {3}"),
    (f"\\b({MUST}) so be ({_PUT}|{_BUILT}|arranged|ordered) that\\b", "{1} be {2} so that"),
    ("\\bby (?:the )?(?:means|use|help) of\\b", "with"),
    ("\\bbe so (?:kind|good|nice)(?: as)? (?:to|and) ", ""),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("means kind help perched situated themselves",)
"""Words that these take besides those that are read anyway."""
