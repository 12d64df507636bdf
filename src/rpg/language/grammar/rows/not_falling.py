"""Towers that are there and must not fall: "do not let the tower fall while moving green onto the mat", "without
knocking it over", as rows that say that they stay standing."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST
from rpg.language.tokens import Token

_TOWER = f"(?:the|this|that|my|our) (?:{COLOR} )?(?:tower|stack|pile)(?: of (?:(?!\\b(?:while|when)\\b)[^.,;:])+?)?"
_IT = f"({_TOWER}|it)"
_DOWN = "(?: over| down| apart| off| to the ground)?"
_FALL = f"(?:fall|collapse|topple|tip|tumble|crash|come down|break){_DOWN}"
_FALLING = f"(?:falling|collapsing|toppling|tipping|tumbling|crashing|coming down){_DOWN}"
_OVER = "(?:over|down|apart)"
_TOPPLING = "(?:knocking|tipping|pushing|kicking|bringing|throwing|toppling|wrecking|breaking|destroying|collapsing)"
_BEGUN = f"((?:{_TOWER} (?:is|stands|consists of) |there (?:is|stands) an? (?:\\w+ )?(?:tower|stack|pile)\\b)[^.]*)"
"""A tower that stands there; of one that is built it is no news that it must not fall."""
_SENTENCE = "(?:^|(?<= [.;] ))(?:please |and |but |also )*"
_END = "(?= [.;!]|$)"
_VERBS = {"moving": "move", "putting": "put", "placing": "place", "stacking": "stack", "setting": "set",
          "bringing": "bring", "building": "build", "making": "make", "taking": "take"}  # fmt: skip
_WHO = "(?:you|we|the robot|it)"
_STAYS = "must stay standing"

_TURNS = Turns((
    *((f"{_SENTENCE}(?:do not|never) (?:let|make) {_IT} (?:ever )?{_FALL}(?: ,)? (?:while|when|as) {doing} ",
       f"{{1}} {_STAYS} . {verb} ")
      for done, verb in _VERBS.items() for doing in (done, f"{_WHO} (?:are |is )?(?:{done}|{verb}s?)")),
    (f"{_SENTENCE}(?:do not|never) (?:let|make) ({_TOWER}) (?:ever )?{_FALL}{_END}", f"{{1}} {_STAYS}"),
    (f"{_SENTENCE}({_TOWER}) (?:{MUST}|may|can) (?:not|never) (?:ever )?{_FALL}{_END}", f"{{1}} {_STAYS}"),
    (f"^{_BEGUN} \\. (?:do not|never) let it (?:ever )?{_FALL}{_END}", f"{{1}} . it {_STAYS}"),
    (f"^{_BEGUN} \\. it (?:{MUST}|may|can) (?:not|never) (?:ever )?{_FALL}{_END}", f"{{1}} . it {_STAYS}"),
    *((f"(?: ,)? (?:without|but do not|and do not) {way}{_END}", f" . {{1}} {_STAYS}")
      for way in (f"{_TOPPLING} {_OVER} ({_TOWER})", f"{_TOPPLING} ({_TOWER}){_DOWN}",
                  f"(?:letting |making )?({_TOWER}) {_FALLING}", f"(?:letting|making) ({_TOWER}) {_FALL}")),
    (f"(?: ,)? (?:and keep|keeping|and leave|leaving) ({_TOWER}) (?:intact|upright|standing|up){_END}",
     f" . {{1}} {_STAYS}"),
    (f"{_SENTENCE}without {_TOPPLING} ({_TOWER})(?: ,)? (?=put|place|move|stack|set|bring|build)",
     f"{{1}} {_STAYS} . "),
    (f"{_SENTENCE}(?:keep|leave) ({_TOWER}) (?:intact|upright|standing|up){_END}", f"{{1}} {_STAYS}"),
    (f"{_SENTENCE}({_TOWER}) (?:{MUST} )?(?:stays?|remains?|be left|be kept) (?:intact|upright|up){_END}",
     f"{{1}} {_STAYS}"),
))  # fmt: skip
_DO = (
    "(?:build|make|form|create|construct|erect|stack|pile|move|put|place|bring|take|set|lift|carry|push|shift|turn|"
    "rebuild|unstack|swap|replace|remove|reverse)s?"
)
_SOME = f"(?:(?:an?|the|this|that|your|my|our|another|each|all|both|{MANY}) )*(?:\\w+ ){{0,2}}"
_HANDLED = re.compile(
    f"\\b{_DO} (?:{_SOME}(?:towers?|stacks?|piles?)|it|them)\\b|\\bto the tower\\b|"
    f"\\bon(?:to)? (?:top|the (?:{COLOR} )?tower|it)\\b"
)
"""What makes a tower, moves it or builds on it: it is not to stay as it is."""


def not_falling(tokens: list[Token]) -> list[Token]:
    """The tokens with a tower that stays standing, where nothing is done with it."""
    if _TOWERS.isdisjoint(token.word for token in tokens) or _HANDLED.search(text_of(tokens)):
        return tokens
    return turned(tokens, _TURNS, all_of_it)


_TOWERS = frozenset({"tower", "stack", "pile"})
WORDS = ("collapsing toppling tipping tumbling crashing knocking kicking wrecking breaking destroying intact upright",)
"""Words that these take besides those that are read anyway."""
