"""How tasks are told to somebody: "can it do a pyramid", "he has to ...", "say you have ...", "a row will do", as rows
that ask for it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LINE, MANY, MUST, PATCH

_BLOCKS = "(?:blocks|cubes|ones)"
_DO = (
    "(?:put|place|move|bring|take|stack|build|make|form|turn|sort|line|lay|set|add|swap|arrange|spell|write|create|pile|"
    "rotate|flip|group|order|clear|remove|leave|keep)"
)
_FIGURE = (
    "(?:tower|stack|row|line|column|pyramid|wall|grid|square|circle|ring|staircase|cube|letter|triangle|rectangle)"
)
_AGENT = "(?:the|your|our|this) (?:robot|arm|robot arm|gripper|policy|agent|machine|system|model)"
_CORNERS = ("near left", "near right", "far left", "far right")
_SCRAMBLED = "(?:scrambled|jumbled|mixed up|mixed|shuffled|random|unsorted|wrong|disordered|arbitrary)"
_MEETS = "(?:sits?|lies?|stands?|is|are|rests?|comes?|goes|be)"

IN_CONVERSATION: tuple[Turn, ...] = (
    (f"^(.*\\b({PATCH})\\b.*?\\b({COLOR})(?: block| cube| one)?(?: goes| is| {MUST} be)?) on the \\3 one(?= |$)",
     "{1} on the {3} {2}"),
    # as many people put it
    ("\\bin(?:to)? (?:one and )?the same corner\\b", "in a corner"),
    ("(?: ,| and| , and) i want to read it (from .+)$", " that reads {1}"),
    (f"^(?:i |we |i have |we have )?got ({MANY} {_BLOCKS})(?: here)?$", "there are {1}"),
    (f"^one ({LINE})(?: ,)? all of them$", "make one {1} of all of them"),
    *((f"^(?:put )?(?:an?|one) ((?:{COLOR} )?{CUBE})(?: is| goes| {MUST} be)? in (?:every|each) corner(?: of the "
    "table)?(?: ,)? "
       f"(?:but|except)(?: for)?(?: in)? the {out}(?: one| corner)?(?: of the table)?$",
       "put " + " and ".join(f"a {{1}} in the {corner} corner" for corner in _CORNERS if corner != out))
      for out in _CORNERS),
    ("\\bno two (?:vertically |horizontally |directly |immediately )?(?:adjacent|neighbou?ring|consecutive|touching) "
     "(?:blocks|cubes)"
     "(?: may| can| should)? (?:share|have|are of) (?:a|the same|one) color\\b", "no two blocks of the same color "
     "touch"),
    ("\\bstill (resting|lying|standing|sitting)\\b", "{1}"),
    ("\\bat (?:episode |task )?(?:termination|completion|the finish)\\b", "at the end"),
    (f"^use ({MANY}) of each(?: color| kind)?$", "there are {1} of each"),
    ("^using ((?:the |these )?(?:letters|digits|numbers|blocks|cubes) .+?) once each(?: ,)?", "using {1} ,"),
    (f"^({MANY} (?:\\w+ )?{_BLOCKS})(?: of (?:equal|the same) size)? are (?:given|available|provided|at "
     "hand|supplied)$",
     "there are {1}"),
    (f"^(an? (?:{_FIGURE}) of [^,]+?) (?:surrounds|encloses|encircles) (an? [^,]+)$", "{1} around {2}"),
    ("^(.+?\\b(?:on|in) the (?:left|right|near|far)) (side|half) (of the table .+? (?:on|in) the "
     "(?:left|right|near|far))$", "{1} {2} {3} {2} of the table"),
    (f"^(.+?\\b{MANY}) blocks with an? (\\S) and (?:1|one) with an? (\\S) and ", "{1} {2} blocks and a {3} block and "),
    (f"^add ({MANY} [^,]*?distractors?(?: {_BLOCKS}| block)?)(?: to (?:the|this) (?:scene|table|world|setup))?$",
     "there are {1}"),
    (f"^(an? [^,]+?)(?: at the bottom)? (?:has to|{MUST}) (?:carry|bear|support) (an? (?:{_FIGURE}) of [^,]+)$", "put "
     "{2} on {1}"),
    ("^i want that (?:the robot|you) (?:makes?|builds?|do|does) ", "build "),
    (f" , after the ({COLOR})(?=$| ,)", " , then the {1}"),
    (f"^on (the [^,]+?) (?:it|there) (?:should|must) be nothing(?: ,)? but on (the [^,]+?) ({MANY} {_BLOCKS})$",
     "{1} must be empty . {3} must be on {2}"),
    ("\\b(?:and )?only after (?:this|that)\\b", "and then"),
    ("\\bon the top of\\b", "on top of"),
    ("\\bfrom up to down\\b", "from top to bottom"), ("\\bfrom down to up\\b", "from bottom to top"),
    (f"\\b({COLOR}) 's (?=(?:left of|right of|on|behind|in front|next|under|above|to the)\\b)", "{1} is "),
    ("\\bhard (?:up )?against\\b", "touching"),
    ("\\binto corners(?: ,)? no two in(?:to)? the same(?: one| corner)?$", "into the corners , one in each corner"),
    ("\\bhang(?:s|ing)? (?:around|about)\\b", "lie around"),
    (f"^(?:ideally ,? ?)?(?:he|she) (?:has to|{MUST}|would|can|could)(?: first| then)? ({_DO}) ", "{1} "),
    (f"^(?:say|suppose|let us say|assume|imagine)(?: that)? (?:you|we|i|there) (?:have|are|is|had|were) ({MANY} .+)$",
     "there are {1}"),
    (f"^(?:can|could) (?:it|you|he|she|{_AGENT}|we) (?:do|manage|handle|pull off) ((?:an?|\\d+x\\d+(?:x\\d+)?|{MANY}) "
     f".*?\\b(?:{_FIGURE})\\b.*)$", "build {1}"),
    (f"^((?:an?|one) (?:{_FIGURE}) of [^,]+?) will do(?: nicely| fine| just fine)?$", "build {1}"),
    ("^at the end of (?:the|this|an?|each|every) (?:\\w+ ){0,3}?(?:exercise|session|lesson|task|game|round|activity) "
     "(?:,"
     " )?", "at the end "),
    (f"^(?:the )?((?:letters|digits|numbers|blocks|cubes) (?:(?!are\\b|is\\b).)+?|(?:{MANY}) "
     "(?:letters|digits|numbers|blocks|cubes)) "
     f"(?:are|start|begin|lie|come)(?: out| off)?(?: given| laid out)?(?: in (?:a |an )?{_SCRAMBLED} order| "
     f"{_SCRAMBLED})$",
     "there are {1}"),
    (f"^starting (?:from|with|in) (?:an? |the )?(?:{_SCRAMBLED}|scattered|messy) (?:arrangement|configuration|layout|"
     f"state|order|placement|set|pile) of ({MANY} {_BLOCKS}) ,? ?(.+)$", "there are {1} . {2}"),
    ("^(.+?)(?: ,)? starting (?:from|with|in) a (?:heap|jumble|mess|pile)$", "at the start all blocks are in a heap . "
     "{1}"),
    (f"\\b(?:the same color|blocks of the same color) (?:never|{MUST} not|{MUST} never|does not|is never) {_MEETS}(?: "
     "directly| ever)? (?:on|on top of) (?:the same color|itself|each other|another of the same color)$",
     "no two blocks of the same color touch"),
    (f"\\b(tower|stack) (?:with|of) ({MANY} \\w+ {_BLOCKS}) and (?:the |an? )?(?:letter|digit|number)(?: {CUBE})? "
     "(\\S+) "
     "on (?:the )?top$", "{1} of {2} with the letter {3} on top"),
    (f"^(put|place|set|stack) an? ({COLOR}) ({CUBE}) on (?:top of )?(the [^,]+?) and another(?: {COLOR})?(?: {CUBE}| "
     "one)?"
     " on (?:top of )?(?:that one|it|that|the first)$", "build a tower of two {2} {3s} on {4}"),
    (f"^(.+?)\\bone ({COLOR}) ({CUBE}) ({PLACE} .+?) and the other(?: one)? ({PLACE} .+)$",
     "{1} one of the two {2} {3s} {4} and the other {5}"),
    (f"^the first(?: one)? in (?:the )?({LINE}) is (.+?)(?: ,| and| , and)+ the last(?: one)?(?: is)? (.+?)(?: ,| and| "
     ", "
     f"and)+ (.+?) (?:stand|are|lie|is|stands|lies)(?: in)? between(?: them)?$", "a {1} : first {2} , then {4} , last "
     "{3}"),
    ("^neither (the .+?) nor (the .+?) (?:is|may be|must be|should be) empty$", "{1} is not empty and {2} is not "
     "empty"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""

TOLD_OF_BOTH: tuple[Turn, ...] = (
    (f"\\b(({COLOR}) and (?:{MANY} )?({COLOR}) (?:{_BLOCKS})) \\. (at least|exactly|at most|only|just) ({MANY}) of "
     "each(?: "
     f"color| kind)? (?:goes|go|is|are|belongs?|lies?|{MUST} (?:be|go|lie)) ((?:on|in|onto|into) [^.,]+)(?= \\.|$)",
     "{1} . {4} {5} of the {2} blocks must be {6} . {4} {5} of the {3} blocks must be {6}"),
    ("^(.*\\b(?:mat|patch|zone|mats|patches|zones) \\. .*?)\\bon different ones(?= \\.|$)", "{1} on different patches"),
)  # fmt: skip
"""The same over a whole text."""
WORDS = ("hang hanging scrambled jumbled shuffled unsorted disordered arbitrary messy",)
"""Words that these take besides those that are read anyway."""
