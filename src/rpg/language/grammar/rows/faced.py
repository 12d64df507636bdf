"""Cubes that are turned, told as a turn that is given or by the face on which the letter is, as rows that turn them."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST

_X = "((?:the )?(?:(?:letter|cube|block|digit) )?\\S(?: cube| block)?|(?:the )?(?:cube|block) with the (?:letter )?\\S)"
_WAY = "((?:counter - ?|counter ?|anti - ?|anti ?)?clockwise)"
_QUARTER = "(?:quarter(?: of a)? turn|90 - degrees? (?:turn|twist|rotation)|90 degrees? (?:turn|twist|rotation))"
_HALF = "(?:half(?: a)? turn|180 - degrees? (?:turn|twist|rotation)|180 degrees? (?:turn|twist|rotation))"
_SEEN = "(?:(?: ,)?(?: as)? (?:seen|viewed) from above)?"
_DEGREES = "[\\d.]+ (?:degrees?|deg|°)"
_TOP = "(?:top|top face|upper face|upper side)"

FACED_AT_ONCE: tuple[Turn, ...] = (
    # without articles
    ("\\bso(?: that)? (top|bottom)(?: (?:side|edge))?(?: of (?:letter|digit|number|symbol|cube|block))? "
     "(?=(?:is |are )?(?:pointing|points?|facing|faces?|looks?|looking)\\b)", "so that its {1} "),
    *((f"\\b{lies} with its (?:letter|symbol|digit|number|face|top) (?=turned .*clockwise)", f"{be} ")
      for lies, be in (("(?:lies|is|stands)", "is"), ("(?:lie|be|stand)", "be"))),
    ("\\btwist (?=(?:the )?(?:\\w+ )?\\w (?:an?|by|clock|counter|anti|90)|(?:the )?(?:cube|block) with )", "turn "),
    (f"^(?:give|let) {_X} (?:(?:make|do) )?an? {_QUARTER} {_WAY}{_SEEN}$", "turn {1} by 90 degrees {2}"),
    (f"^(?:give|let) {_X} (?:(?:make|do) )?an? {_WAY} {_QUARTER}{_SEEN}$", "turn {1} by 90 degrees {2}"),
    (f"^(?:give|let) {_X} (?:(?:make|do) )?an? {_HALF}{_SEEN}$", "turn {1} by 180 degrees"),
    (f"^(turn|rotate) {_X} {_WAY} (?:by )?an? {_QUARTER}{_SEEN}$", "{1} {2} by 90 degrees {3}"),
    (f"^(turn|rotate) {_X} (?:by )?an? {_HALF}{_SEEN}$", "{1} {2} by 180 degrees"),
    (f"^give ([^,]+?) an? (\\d+)(?: -)? degrees? (?:{_WAY} )?(?:turn|twist|rotation|spin)(?: {_WAY})?{_SEEN}$",
     "turn {1} by {2} degrees {3} {4}"),
    (f"^give ([^,]+?) an? (?:{_WAY} )?(?:turn|twist|rotation|spin) (?:of|by) ({_DEGREES})(?: {_WAY})?{_SEEN}$",
     "turn {1} by {3} {2} {4}"),
    (f"\\b((?:turn|rotate|twist|spin)(?:e?d)?\\b(?: [^ .,:]+)*?) (?:(?:by|through|of|with|at) an angle of|of|for|with) "
     f"(?=(?:about )?{_DEGREES}(?= |$))", "{1} by "),
    (f"^(?:make|do|let) an? {_QUARTER} {_WAY} with {_X}{_SEEN}$", "turn {2} by 90 degrees {1}"),
    (f"^(turn|rotate) {_X} an? {_QUARTER} {_WAY}{_SEEN}$", "{1} {2} by 90 degrees {3}"),
    (f"^the {_TOP}(?: face)? of {_X} ({MUST} be|is) (upside down|upright|readable)$", "{1} {2} {3}"),
    (f"^{_X} {MUST} show its letter upside down(?: on its {_TOP})?$", "{1} must be upside down"),
    (f"\\b(?:until|so that|such that) the letter on (?:its |the )?{_TOP} is (upright|readable|upside down)\\b",
     "so that it is {1}"),
    (f"^i (?:want|would like) to be able to read {_X}$", "{1} must be readable"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
_OVER = "(upside down|upright)"

FACED: tuple[Turn, ...] = (
    (f"^((?:spell|write) (?:the word )?\\S{{2,}}|the word \\S{{2,}}|the (?:cubes|letters) read \\S{{2,}} from left to "
     f"right)(?: ,)?(?: but)?(?: with)? (?:its|the) (?:letter )?(\\S)(?: in the middle)? (?:{MUST} be|is|{MUST} "
     f"appear)? ?{_OVER}$", "{1} , but the {2} is {3}"),
    ("^the (?:cubes|letters) read (\\S{2,}) from left to right(?= , but)", "spell {1}"),
    (f"^((?:spell|write) (?:the word )?\\S{{2,}}|the word \\S{{2,}})(?: ,)? with all (?:its|the) letters {_OVER}$",
     "{1} with all letters {2}"),
    ("^the word (\\S{2,})(?= with all letters)", "spell {1}"),
    (f"^{_X} is upside down and to the (right|left) of {_X} , which is upright$",
     "{1} is to the {2} of {3} . {1} must be upside down . {3} must be upright"),
    (f"^both {_X} and {_X} {MUST} be {_OVER[:-1]}|readable) , with \\1 (?:to the )?(left|right) of \\2$",
     "{1} is to the {4} of {2} . {1} and {2} must be {3}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("twist rotation able",)
"""Words that these take besides those that are read anyway."""
