"""Colours by turns and all different, as people put them: "alternating red/blue", "a striped tower, white and red
stripes", "checkered black and white", "pick two colors and alternate them", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LINE, MANY

_FIGURE = f"(?:{LINE}|wall|grid|square|circle|ring)"
_STRIPED = f"(?:{LINE}|circle|ring)"  # the stripes of a wall may go either way
_ALTERNATING = "(?:alternating(?: colors)?|alternate(?: colors)?|alternately|alternates|alternation of|by turns)"
_CHECKERED = "(?:checkered|chequered|checkerboard)"
_TWO = f"({COLOR}) (?:and|/|-|&) ({COLOR})"
_CHOOSE = "(?:pick|choose|take|select|use)(?: me| any| yourself)?"

_EACH = "(?:each|every)(?: (?:one|block|cube|brick))?(?: of (?:them|these|those))?"

BY_TURNS_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b((?:an?|one) (?:{LINE})) (where|in which|so that|such that) ((?:every|each|no two) [^,:]+?) , ({MANY}) "
     f"{CUBE}s(?: (?:in total|in all|altogether|high|long|tall))?$", "{1} of {4} blocks {2} {3}"),
    (f"\\b({_FIGURE}) of (blocks|cubes)\\b(.*?) , ({MANY}) of them(?=$| ,)", "{1} of {4} {2} {3}"),
    (f" , {_EACH} (?:a different|its own|another) color$", " , each a different color"),
    (f"(?: ,)? (?:where|in which|so that|such that|with|and) {_EACH} (?:is|has|having|being|must be|must have|"
     f"should be|should have)(?: of| in)? (?:a different|another|a unique|its own) color$", " , each a different "
     "color"),
    (f"\\b({_ALTERNATING})(?: between| of| in| from)?(?: :)? ({COLOR}) [/-] ({COLOR})\\b", "alternating {2} and {3}"),
    (f"\\b(?:with |in |of )?alternating colors(?: of| :| ,)? ({COLOR}) and ({COLOR})\\b", " alternating {1} and {2}"),
    ("\\b(?:the )?colors (?:changing|going|taking turns) (?:alternately|by turns|in turn|each time)\\b",
     "alternating colors"),
    (f"\\b(?:with |in |of )?alternating colors(?: :| ,)? ({COLOR}) (?:at the (?:bottom|base|foot)|below) and ({COLOR}) "
     "(?:above|on|over|on top of) (?:it|that)$", " alternating {1} and {2} , {1} at the bottom"),
    (f"\\b((?:grid|wall|square|rectangle|array|arrangement|matrix|\\d+x\\d+)\\b[^;]*?)(?: ,| :| with| whose| where| "
     f"in which| the| its| and)* (rows|columns|layers) (?:alternate|alternating|alternates|alternately)(?: between| "
     f"in)?(?: the)?(?: colors?)?(?: :)? {_TWO}\\b", "{1} with {2} alternating {3} and {4}"),
    (f"\\b(grid\\b[^;]*?)(?: ,| with| where)+ (?:the )?odd (rows|columns)(?: are| being)? ({COLOR})(?: ,| and)+ "
     f"(?:the )?even \\2(?: are| being)? ({COLOR})$", "{1} with {2} alternating {3} and {4}"),
    (f"\\b({COLOR}) [/-] ({COLOR})(?: ,)? (alternating|alternately|by turns)\\b", "{1} and {2} alternating"),
    (f"^(?:an? |one )?({_FIGURE}) : ({MANY} {CUBE}s)(?: ,)? ({_ALTERNATING})\\b", "a {1} of {2} , {3}"),
    (f"\\b(an?|one|the) striped ({_STRIPED})(.*?) (?:,|with|in|of)(?: (?:in|of|with))? {_TWO}(?: stripes| "
     f"striped)?(?=$| ,)",
     "{1} {2} {3} , alternating {4} and {5}"),
    (f"\\b({_STRIPED})(.*?) (?:,|with|in)(?: in| with)? {_TWO} stripes(?=$| ,)", "{1} {2} , alternating {3} and {4}"),
    (f"(?: ,)? (?:in |a )*(?:checkers|chequers|chess)(?: in| of| :)? {_TWO}(?=$| ,)",
     " in a checkerboard pattern of {1} and {2}"),
    (f"\\b(?:with|in|of)? ?{_CHECKERED}(?: (?:in|with))? {_TWO}(?! checker)", "in a checkerboard pattern of {1} and "
     "{2}"),
    ("\\b(?:checker|checkers|chess|checkered|chequered|checked|checkerboard|chessboard) (?:pattern|coloring|colors)\\b",
     "checkerboard pattern"),
    (f"\\b(checkerboard pattern)((?! of\\b).*?)(?: ,| in)+ (?:the )?(?:colors )?{_TWO}$", "{1} of {3} and {4} {2}"),
    (f"^{_CHOOSE} (two|three)(?: different)? colors(?: you like| of your choice)?(?: ,| and| then|;)+ (.+?)(?: that| "
     "which)? (?:alternates?|alternating)(?: between| with| in)?(?: (?:them|these|those|the two|the three))?$",
     "{2} alternating between {1} colors"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
