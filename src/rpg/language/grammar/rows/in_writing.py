"""How tasks are written in notes and lists: "grid 2 rows x 4 cols", "(bottom -> top)", "gap = 2 cm", "env with 5
blocks", "PASS when", as rows that say it in a sentence."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, END, LENGTH, LINE, MANY, MUST, WAY

_BLOCKS = "(?:blocks|cubes|ones)"
_NO_PLACE = f"(?:(?!\\b{PLACE}\\b)[^,.])+"
_STOCK = "(?:quantity|quantities|amounts?|counts?|numbers?|stock|parts|pieces|props)"
_WORLD = "(?:env|environment|scene|setup|set up|world|table|scenario)"
_LISTED = f"{MANY} {COLOR}(?: {_BLOCKS})?(?:(?: ,| and| , and) {MANY} {COLOR}(?: {_BLOCKS})?)*"

_EACH_COLOR = f"(?:1|one|an?) ({COLOR})(?: one)?(?: ,)? (?:and )?(?:1|one|an?) ({COLOR})(?: one)?"

IN_WRITING: tuple[Turn, ...] = (
    (f"\\b({MANY}) rows (?:x|by) ({MANY}) (?:columns|cols)\\b", "{1} rows and {2} columns"),
    (f"\\b({MANY}) (?:columns|cols) (?:x|by) ({MANY}) rows\\b", "{1} columns and {2} rows"),
    (f"\\(? ?({END}) → ({END})(?: \\))?(?=$| ,|\\s)", "from {1} to {2}"),
    (f"\\bin (?:the |a )?directions? (?:from )?(?:the )?({END}) to (?:the )?({END})\\b", "from {1} to {2}"),
    (f"^the (tower|stack|row|line|column) order(?: ,| \\(|)? (?:from )?({END}) to ({END})(?: ,| \\))? (?:{MUST} be|is) "
     "?:? ?(.+)$", "{1} order from {2} to {3} : {4}"),
    (f"\\b(?:gaps?|spacing|distance|space)(?: between (?:the |neighbou?ring )?(?:{_BLOCKS}|them|neighbou?rs))? = "
     f"({LENGTH})", "with gaps of {1}"),
    (f"\\b({MANY}) (?:blocks|cubes) of (length|width|height|depth)\\b", "{1} blocks in {2}"),
    (f"\\b(wall|grid|tower|rectangle|row) with ({MANY} blocks in (?:length|width|depth)(?: ,| and| , and) {MANY} "
     "blocks in "
     "(?:height|width|depth))", "{1} {2}"),
    (f"\\b({MANY}) blocks in length\\b", "{1} blocks long"), (f"\\b({MANY}) blocks in width\\b", "{1} blocks wide"),
    (f"\\b({MANY}) blocks in height\\b", "{1} blocks high"), (f"\\b({MANY}) blocks in depth\\b", "{1} blocks deep"),
    (f"^{_STOCK} : ({_LISTED})$", "there are {1}"),
    (f"^(?:an? |the )?{_WORLD} (?:with|of|has|contains) ({MANY} {_NO_PLACE})$", "there are {1}"),
    ("^(?:pass|passes|passed|success|ok|done) (?:when|if|once) ", "at the end "),
    (f"^(?:an? )?{LINE} ?[:,] ({_LISTED}) , {WAY}$", "{1}"),
    (f"^({MANY}) (towers|stacks)(?: ,| :)? {_EACH_COLOR}(?: ,)?(?: each)? ({MANY}) (?:{_BLOCKS} )?(?:high|tall)(?: "
     "each)?$", "{1} {2} , one {3} , one {4} , each {5} blocks high"),
    (f"^({MANY}) (towers|stacks)(?: ,)? ({MANY}) {_BLOCKS} (?:high|tall)(?: each)?(?: ,)? (?:all )?(?:lined up|in a "
     f"row|side by side|next to each other)?(?: ,)? ?({WAY})?$", "make {1} {2} of {3} and line them up"),
    (f"^two rows of ({MANY})(?: {_BLOCKS})? , (?:with )?the ({COLOR})(?: row| one)? (behind|in front of) the ({COLOR})"
     "(?: row| one)?$", "a row of {1} {2} blocks {3} a row of {1} {4} blocks"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""
WORDS = ("env quantity quantities spacing amounts stock props",)
"""Words that these take besides those that are read anyway."""
