"""What is required, prescribed or to be found, in the manner of a test plan, as rows that ask for it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LENGTH, LINE, MANY, MUST

_WANTED = "(?:required|needed|wanted|desired|prescribed|requested|asked for)"
_SYMBOL = "(?:letter|digit|symbol|number)"

_ROW = "(?:far|near|front|back|first|second|top|bottom)"
_FREE = "(?:arbitrary|free|open|irrelevant|of no importance)"

REQUIRED_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b(?:so|such) that the (?:word|number) (\\S+) (?:is|can be|{MUST} be) (?:shown|displayed|seen|formed)\\b",
     "so that they read {1}"),
    ("\\b(?:so|such) that the (?:word|number) (\\S+) (?:appears|results|is obtained)\\b", "so that they read {1}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
REQUIRED: tuple[Turn, ...] = (
    # parts told by "of which"
    (f"(?: ,)? the width of which {MUST} be ({MANY}) {CUBE}s? and the height of which {MUST} be ({MANY}) {CUBE}s?$",
     " {1} blocks wide and {2} blocks high"),
    (f"(?: ,)? the ({_ROW}) (row|layer) of which {MUST} (?:consist of|be formed of) (.+?) and the ({_ROW}) \\2 of "
     f"which {MUST} (?:consist of|be formed of) (.+)$", " with {3} in the {1} {2} and {5} in the {4} {2}"),
    (f"(?: ,)? the lower {CUBE} of which {MUST} be ({COLOR}) and the upper {CUBE} of which {MUST} be ({COLOR})$",
     " with {1} at the bottom and {2} on top"),
    (f"^there {MUST} be ({MANY}) ([^,]+?) , of which ((?:at least|at most|exactly|no more than|no fewer than) {MANY}) "
     f"({MUST} be .+)$", "{3} of the {1} {2} {4}"),
    (f"^(.+ )(the {COLOR} {CUBE}) , which ({MUST} (?:be (?:located|placed|put)|stand|lie) .+)$", "{1} {2} . {2} {3}"),
    # what is left open
    (f"(?: ,)? (?:the order of which (?:is|being|{MUST} be) {_FREE}|no particular order being (?:required|"
     "prescribed))$", " , in any order"),
    (f"(?: ,)? (?:whereas|while|and) the order of the (?:remaining blocks|others|rest) is {_FREE}$", ""),
    # with what it is done
    ("^by means of (?:the )?(?:letter|digit|symbol) (?:cubes|blocks) , (.+)$", "{1}"),
    ("(?: ,)? by means of (?:letter|digit|symbol) (?:cubes|blocks)$", ""),
    (f"\\ban? ({COLOR} {CUBE}) having an edge length of ({LENGTH})", "a {2} {1}"),
    # what is exchanged and turned
    (f"^the positions? of (the [^,]+?) and (?:the position )?of (the [^,]+?) {MUST} be (?:exchanged|swapped|"
     "interchanged)$", "{1} and {2} must swap places"),
    (f"^(an? {LINE}|three .+? stacked|.+? {MUST} be stacked) such that the lowest of them rests on (the .+)$",
     "{1} on {2}"),
    # what is required
    (f"^(an? {LINE}\\b.+|an? \\w+ {LINE}\\b.+?) (?:is|are) (?:both )?{_WANTED}(?:$| , (.+)$)", "{1} , {2}"),
    (f"^(.+?) (?:is|are) (?:both |all )?{_WANTED} (on|in|behind|next to|under|in front of|to the) (.+)$",
     "{1} must be {2} {3}"),
    ("\\b(?:is|are) (?:required|supposed|expected|meant|obliged) to (be|sit|stand|lie|rest|go|touch|form|end)\\b",
     "must {1}"),
    # what is there besides
    ("^with (.+?) (?:present |there |around )?(?:only )?as (?:a )?distractors?(?: ,)? (.+)$",
     "{2} . {1} are distractors"),
    # what is where
    ("\\b(which|that|and \\w+|and the \\w+ one) in turn (is|rests|stands|sits|lies|must|should)\\b", "{1} {2}"),
    ("(?: ,)? on (?:whatever|whichever) side(?: ,|$)", ","),
    (f"^with (the .+?) on one side and (the .+?) on the other(?: side)? , (the .+?) (?:is|{MUST} be) between them$",
     "{3} must be between {1} and {2}"),
    (f"^(?:in (?:the|a) {LINE} , )?(the .+?) (?:is|{MUST} be) sandwiched between (the .+?) below and (the .+?) above$",
     "{1} must be on {2} and {3} must be on {1}"),
    (f"^each corner(?: of the table)? (?:is occupied by|holds|contains|gets) one of the four (\\w+) {CUBE}s$",
     "a {1} block must be in each corner of the table"),
    (f"^(.+?) , which (?:are|is) (stacked|in an? (?:heap|tower|row)) at the start , ({MUST} .+)$",
     "{1} start {2} . they {3}"),
    # what is done
    ("\\b(?:have|has) exchanged (?:their )?(?:places|positions)\\b", "must swap places"),
    # symbols
    (f"^the {_SYMBOL} (\\w) on (?:the )?top(?: face)? of its {CUBE} (.+)$", "the block {1} {2}"),
    (f"^the {_SYMBOL} on (?:the )?top(?: face)? of the ({CUBE} \\w) (.+)$", "the {1} {2}"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read, and what is said instead."""
WORDS = ("required prescribed requested obliged settled whereas whichever whatever occupied exchanged marks",)
"""Words that these take besides those that are read anyway."""
