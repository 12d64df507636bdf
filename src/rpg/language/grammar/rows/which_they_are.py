"""Blocks told by what they are behind "that", and those that are not: "those that are vowels form a row, while the ones
that aren't are stacked", as rows that call them by it."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_ONES = "(?:the |all |all the )?(?:ones|those|cubes|blocks|letters|symbols)(?: of them)?"
_ONE = "the (?:one|cube|block|letter|symbol)"
_THAT = "(?:that|which|who)"
_DOES = (
    f"(?:{MUST}|are|form|make|build|go|get|be|lie|stand|sit|stay|remain|come|belong|stacked|placed|put|left|lined|in|on|"
    "next|beside|behind)"
)
_SORT = "letter|digit|number|vowel|consonant"
_MOST = "(largest|biggest|highest|greatest|smallest|lowest|tallest)"
WHICH_THEY_ARE: tuple[Turn, ...] = (
    (f"\\b{_ONES} {_THAT} (?:are|show|bear|carry|have|happen to be) (vowels|consonants)\\b(?: on them)?", "the {1}"),
    (f"\\b{_ONE} {_THAT} (?:is|shows|bears|carries|has) an? (vowel|consonant)\\b(?: on it)?", "the {1}"),
    (f"\\bthe (number|digit|block|cube|one|letter|tower|stack) {_THAT} is (?:the )?{_MOST}(?: one| of all| of them)*"
     "\\b", "the {2} {1}"),
    # "whatever is red", "whichever letter is a vowel"
    (f"\\b(?:whatever|whichever (?:block|cube|one)) is (?:an? )?({_SORT})\\b", "all {1s}"),
    (f"\\bwhichever (?:{_SORT}) is (?:an? )({_SORT})\\b", "all {1s}"),
    (f"\\b(?:whatever|whichever (?:block|cube|one)) is ({COLOR}|odd|even)\\b", "all {1} blocks"),
    (f"\\b(?:that|he|the one) (?:who|which) is (?:labell?ed|marked|numbered|called) (?:with )?(?:an? |the )?"
     f"((?:{_SORT}) )?(?=(?:\\w|\\d)(?: |$))", "the block "),
    (f"^(?:all )?(?:the )?(cubes|blocks) , (?:of which there are|being) ({MANY})(?: in number)?"
     f"(?: and (?:which are |of )?(?:all )?({COLOR})(?: color)?)? , ", "{2} {3} {1} "),
    # those that are not
    (f"\\b{_ONES} {_THAT} (?:are|do|have) not(?=$| ,| {_DOES}\\b)", "the others"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
