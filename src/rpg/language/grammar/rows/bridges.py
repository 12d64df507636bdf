"""Bridges and arches of which it is told what lies across what: "the red block bridges the two blue ones", as rows that
say it with "across". How "an arch of three blocks" is to look, and whether one can pass below it, is not told."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MUST

_LET = "^(?:let |have |make )?"
_BRIDGE = "(?:bridge|arch|archway)"
_MAKE = "(?:build |make |form |construct )?"
_OF = "(?:of|from|with|using|out of|made of|made from|built of|built from)"
_ACROSS = "(?:bridg(?:es?|ing)|spans?|straddles?)"
_PAIR = "((?:the |both )?two .+?|both .+?)"

BRIDGES: tuple[Turn, ...] = (
    (f"^{_MAKE}an? {_BRIDGE} : (.+)$", "{1}"),
    (f"^{_MAKE}an? {_BRIDGE} {_OF} (?:a|one) ({COLOR}) (?:{CUBE}|one) (?:on|over|across) (two .+)$",
     "put a {1} block across {2}"),
    (f"^((?:put |place |lay |set )?two {CUBE}s [^,.]*?) a third (?=(?:lying )?across (?:both|them|the two)\\b)",
     "{1} a third block"),
    # which is a bridge, as is told
    (f"\\b((?:on|across|over) (?:top of )?{_PAIR})(?: ,)? (?:just |a bit )?(?:like|as|forming|making) an? (?:\\w+ )?"
     f"{_BRIDGE}(?=$| ,| and)", "{1}"),
    (f"^bridge {_PAIR} (?:with|by) ({THING})$", "put {2} across {1}"),
    (f"{_LET}({THING}) (?:{MUST} )?{_ACROSS} {_PAIR}$", "put {1} across {2}"),
    (f"^{_PAIR}(?: ,| {MUST} be| are)? (?:bridged|spanned) by ({THING})$", "put {2} across {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("bridge bridges bridged spans spanned straddle straddles arch archway",)
"""Words that these take."""
