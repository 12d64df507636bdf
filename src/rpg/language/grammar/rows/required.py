"""What is required, prescribed or to be found, in the manner of a test plan, as rows that ask for it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import LINE, MUST, Turn

_WANTED = "(?:required|needed|wanted|desired|prescribed|requested|asked for)"
_BLOCK = "(?:block|cube)"
_SYMBOL = "(?:letter|digit|symbol|number)"

REQUIRED: tuple[Turn, ...] = (
    # what is required
    (f"^(an? {LINE}\\b.+|an? \\w+ {LINE}\\b.+?) (?:is|are) (?:both )?{_WANTED}(?:$| , (.+)$)", "{1} , {2}"),
    (f"^(.+?) (?:is|are) (?:both |all )?{_WANTED} (on|in|behind|next to|under|in front of|to the) (.+)$",
     "{1} must be {2} {3}"),
    ("\\b(?:is|are) (?:required|supposed|expected|meant|obliged) to (be|sit|stand|lie|rest|go|touch|form|end)\\b",
     "must {1}"),
    (f"\\b({MUST}) make (an?|one|two|three) ((?:\\w+ )?{LINE}s?)\\b", "{1} form {2} {3}"),
    # what is there besides
    ("^with (.+?) (?:present |there |around )?(?:only )?as (?:a )?distractors?(?: ,)? (.+)$",
     "{2} . {1} are distractors"),
    ("\\bsettled (heap|pile)\\b", "{1}"),
    # what is where
    ("\\bwhereas\\b", "while"),
    ("\\b(which|that|and \\w+|and the \\w+ one) in turn (is|rests|stands|sits|lies|must|should)\\b", "{1} {2}"),
    ("(?: ,)? on (?:whatever|whichever) side(?: ,|$)", ","),
    (f"^with (the .+?) on one side and (the .+?) on the other(?: side)? , (the .+?) (?:is|{MUST} be) between them$",
     "{3} must be between {1} and {2}"),
    (f"^(?:in (?:the|a) {LINE} , )?(the .+?) (?:is|{MUST} be) sandwiched between (the .+?) below and (the .+?) above$",
     "{1} must be on {2} and {3} must be on {1}"),
    (f"^each corner(?: of the table)? (?:is occupied by|holds|contains|gets) one of the four (\\w+) {_BLOCK}s$",
     "a {1} block must be in each corner of the table"),
    (f"^(.+?) , which (?:are|is) (stacked|in an? (?:heap|tower|row)) at the start , ({MUST} .+)$",
     "{1} start {2} . they {3}"),
    ("\\bmarks? (the outline of)\\b", "form {1}"),
    # what is done
    ("\\b(?:have|has) exchanged (?:their )?(?:places|positions)\\b", "must swap places"),
    # symbols
    (f"^the (equation .+?) (?:is|{MUST} be) (?:shown|formed|written|displayed) (?:by|with|in|as) an? {LINE} of "
     f"{_BLOCK}s$",
     "write the {1}"),
    (f"^the {_SYMBOL} (\\w) on (?:the )?top(?: face)? of its {_BLOCK} (.+)$", "the block {1} {2}"),
    (f"^the {_SYMBOL} on (?:the )?top(?: face)? of the ({_BLOCK} \\w) (.+)$", "the {1} {2}"),
    (f"^(?:seen by the camera , )?(the {_BLOCK} \\w) shows an upside - down {_SYMBOL}(?: on its top(?: face)?)?$",
     "{1} must be upside down"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read, and what is said instead."""
WORDS = ("required prescribed requested obliged settled whereas whichever whatever occupied exchanged marks",)
"""Words that these take besides those that are read anyway."""
