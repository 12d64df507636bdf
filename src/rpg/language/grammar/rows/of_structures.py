"""What is said of a structure that is named in the same breath: "a red block on each of the three towers of two blue
ones", "given the row A B C: reverse it", as rows that tell it first."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import LABEL
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LINE, MANY

_PUT = "(?:put|place|set|lay|stack)"
_SHOWS = "(?:with|showing|bearing|marked|labelled|labeled)"
_ONE = f"(?: {CUBE}| one| letter| digit| number)?(?: being)?"
_NEAR = "(?:nearest|closest)(?: to (?:me|us|the robot))?"
_FAR = "(?:farthest|furthest)(?: away)?(?: from (?:me|us|the robot))?"

OF_STRUCTURES_AT_ONCE: tuple[Turn, ...] = (
    # what is told of the sides or the ends behind it
    ("^two (stacks|towers|rows|columns|words)(?: ,)? (?:one|the one) (?:to the )?(left|right) of the other"
     "(?: :| ,)* (?=.*\\bleft (?:one|stack|tower|row|column|word)\\b.*\\bright\\b)", "two {1} : "),
    (f"\\beach with (an? {COLOR} {CUBE}) as its (top|bottom|base)$", "each with {1} at its {2}"),
    *((f"\\b((?:alphabetical|alphabetically|order|ascending|descending)\\b.*?)(?: ,)?(?: with)? the first{_ONE} "
       f"{first}(?:(?: ,)? and the last{_ONE} {last})?$", f"{{1}} , {way} first")
      for first, last, way in ((_NEAR, _FAR, "nearest"), (_FAR, _NEAR, "farthest"))),
    ("\\bstacked and (?:stand|stands|lie|lies|sit|sits|rest|rests) (?=on )", "stacked "),
    *((f"\\bthe one {_SHOWS} (?:(?:{a}) )?(?:digit |number |letter |label )?({LABEL}){there}", "the block {1}")
      for a, there in (("an?|the", " on it"), ("the", ""))),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
OF_STRUCTURES: tuple[Turn, ...] = (
    ("^(?:please )?(?:block|wall)(?: up)?(?: me| us) (?:up )?(?=an? )", "build "),
    (f"^(?:make|build|lay) (?:the|an?) flag as (?=an? {MANY} ?x ?{MANY} grid )", "build "),
    (f"^{_PUT} (an? {COLOR} \\w+) (?:on top of|on|onto) each of (?:the )?({MANY} (?:towers|stacks) .+)$",
     "build {2} and put {1} on each"),
    (f"^given (?:the|an?) ({LINE})(?: of)? ([^,:]+?) : (.+)$", "at the start there is a {1} of {2} . {3}"),
    (f"^(?:every|each) corner of the table (?:has|holds|contains|gets) (?:exactly |just )?(one|a) ({CUBE})(?: in it)?$",
     "put one {2} in each corner of the table"),
    ("^(?:and )?(?:the |its )?(?:base|foot) (?:goes|is|stands|sits|rests|belongs) on (.+)$", "the tower is on {1}"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read, and what is said instead."""
