"""How people put it who ask aloud: "here are a 2 and a 3", "number 1 up front", "don't stack them more than two high",
"A, and only A, is on the mat", "how can I build ...", "while stacking the others", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, BUILD, COLOR, CUBE, MANY, MUST, PATCH

_BLOCKS = f"(?:{CUBE}s|bricks|boxes|ones)"
_THEM = f"(?:them|these|those|any|any of them|(?:the )?{_BLOCKS})"
_HIGH = "(?:high|tall|up|levels|layers|blocks|blocks high|levels high|layers high)"
_FIRM = "(?:keep|leave|hold|do not|never)"
_SYMBOL = "(?:\\d|plus|minus|equals|times)"
_KIND = "(odd|even)"
_NUMBERS = "(numbers|digits|number blocks|number cubes|cubes|blocks)"
_PRIME = "[2357]"
_RANGE = "(?:from )?(\\d) (?:to|through|until|till|up to) (\\d)"
_WHERE = "((?:(?!\\b(?:order|row|line|column|first|then)\\b).)+?)"
_RISING = "(?:increasing|ascending|rising|decreasing|descending|falling|alphabetical|reverse alphabetical)"
_SHOWN = "(?:letter|digit|number|cube|block)"
_TURNED = "(?:turned|rotated|tilted|twisted|upside down|turned over|on its (?:side|head))"
_HUE = "(?:its own|a different|a unique|an own|another)"
_NONE = ("(?:none of which is|none of which are|none of them is|none of them are|that are not|which are not|that are "
         "neither)")  # fmt: skip
_SOLE = f"(?:(?:{MUST} )?(?:be|lie|rest|stand|sit)|is|lies|rests|stands|sits)"
_OF_ITS_OWN = (
    "(?:(?:each|every) (?:row|one)(?: ,| is| has| in| of| with| having| being)*|of) (?:a|one|its own|a different|a "
    "single|one single|another)(?: single| different)? color(?: each| of its own)?"
)

ASKED_ALOUD_AT_ONCE: tuple[Turn, ...] = (
    # what there is
    (f"^here are (?=(?:an?|the|some|{MANY}) )", "there are "),
    (f"^there (?:are|is) ((?:an? {_SYMBOL}(?: sign| symbol| cube| block)?(?: ,| and| , and) )+an? {_SYMBOL})(?: "
     "sign)?$",
     "there is {1}"),
    (f" (?:in the presence of|with|among|amid) ({MANY} distractors?(?: {CUBE}s)?)(?: ,)? {_NONE} ({COLOR}) (?:or|nor) "
     f"({COLOR})$", " . there are {1} , none of them {2} or {3}"),
    (f"\\b({MANY} distractors?(?: {CUBE}s)?)(?: ,)? {_NONE} ({COLOR}) (?:or|nor) ({COLOR})\\b", "{1} , none of them "
     "{2} or {3}"),
    (f"\\b({MANY}(?: {COLOR})? {CUBE}s) , (?:each|every one)(?: of them)? (?:in|of|with|having) {_HUE} color(?: of its "
     "own)? , ", "{1} of different colors "),
    (f"^({MANY} {CUBE}s) ([^,]+?\\b(?:heap|pile)) , (?:each|every one)(?: of them)? (?:in|of|with|having) {_HUE} "
     "color$",
     "{1} of different colors {2}"),
    (f"^({MANY} of (?:each|every)(?: color| kind)?)(?: ,)? and (they|all of them|these) ", "there are {1} . {2} "),
    (f"^(?:the )?total (?:number of )?{CUBE}s?(?: number)? (?:is|are) ({MANY})\\b", "there are {1} blocks"),
    (f"(?: ,)? (?:so )?(?:the |in )?total (?:is|of|number is|:) (?={MANY} (?:{_BLOCKS}|{CUBE})$)", " , in total "),
    # what else there is
    ("(?:^|(?: ,| and| but)* )(?:everything|anything|all|the) (?:else|rest) (?:is|are|remains|stays|can be) "
     "(?:completely |totally )?(?:free|open|left open|arbitrary|unconstrained|optional|irrelevant|unimportant|free to "
     "move|as you like|anywhere)$", ""),
    (f"\\bnothing ({COLOR}) (?=(?:may|must|should|can|is|{MUST})\\b)", "no {1} block "),
    # numbers
    ("^(?:please )?(?:return|bring|put|restore|get|sort) (it|them)(?: back)? (?:to|in|into) (?:their|its|the)(?: "
     "proper| right| correct| usual| natural| original)? order\\b",
     "put {1} in order"),
    (f"\\b(?:the )?number of {CUBE}s? on (the [^,]+?) {MUST} be (?:bigger|larger|higher|greater|more) than (?:the "
     f")?(?:number|one|that)(?: of {CUBE}s?)? on (the [^,]+)$", "there must be more blocks on {1} than on {2}"),
    (f"\\b{_KIND} {_NUMBERS} {_RANGE} {_WHERE} (?:the )?(odd|even) (?:ones|numbers|digits)(?! (?:from )?\\d)",
     "{1} {2} from {3} to {4} {5} the {6} {2} from {3} to {4}"),
    (f"\\b(?:primes|prime numbers) (?=(?:{_PRIME}{AND} )+{_PRIME}\\b(?!{AND} \\d))", "numbers "),
    # who does it
    ("^how (?:can|could|do|would|should) (?:i|we|you|one) (?=\\w)|^how (?:i|we|you) (?:can|could|do|would|should) "
     "(?=\\w)",
     ""),
    # who alone
    (f"\\b(on|onto) (the (?:{COLOR} )?{PATCH})(?: ,)? all (?:alone|by itself|on its own|by themselves)$",
     "{1} {2} , alone"),
    (f"^((?:the )?(?:{CUBE} )?\\S+|the \\S+ (?:{CUBE}|one)) , (?:and )?only \\1 , ({_SOLE})\\b", "only {1} {2}"),
    # over several
    ("\\bon top of (?:the )?(both(?: of (?:them|these|those))?)(?=$| ,| and )", "across {1}"),
    ("\\b(?:rests?|lies|sits) on (both(?: of (?:them|these|those))?)(?=$| ,| and )", "lies across {1}"),
    (f"\\bon top of (two (?:{COLOR} )?(?:ones|{CUBE}s)) (?=(?:that|which) (?:touch|are touching|stand side by side|are "
     "side by side))",
     "across {1} "),
    # where it comes to lie
    ("\\b(?:lands|comes to rest|comes to lie|winds up) (?=(?:on|in|next|beside|behind)\\b)", "is "),
    ("\\b(?:hides|is hidden|is buried|is trapped|is stuck|lies hidden) (?=(?:beneath|under|below|underneath)\\b)",
     "is "),
    ("\\b(?:is|lies|sits|is trapped|is stuck|is buried) at the bottom of (?:a|the) (?:tower|stack|pile)(?: ,)? "
     "(?=(?:under|beneath|below|underneath)\\b)", "is "),
    ("^free (?:it|them|the [^,]+?)(?: ,| and| then)+ (?=(?:get|put|place|bring|move|take)\\b)", ""),
    (f"\\b(an?) (tower|stack|pile)(?: ,| :) ({COLOR}(?: (?:over|on|on top of|above) {COLOR})+)", "{1} {2} of {3}"),
    (f"^(?:{MANY} {_BLOCKS} )?(?:start|begin|are)(?: out)? stacked(?: up)?(?: ,| :) ({COLOR}(?: (?:over|on|on top of) "
     f"{COLOR})+)$",
     "at the start there is a tower of {1}"),
    ("\\bstays? standing(?= the whole time| all the time| throughout|$| while)", "stay as it is"),
    # how they are turned
    ("\\buntil its (?:label|letter|symbol|digit|number|face) is (?=upright|readable|legible)", "until it is "),
    (f"\\bwith no ({_SHOWN}) (?:being )?{_TURNED}\\b", "with all {1s} upright"),
    (f"\\b(?:that )?no ({_SHOWN}) (?:may be|should be|must be|is(?: to be)?) {_TURNED}\\b", "all {1s} must be upright"),
    # how high
    (f"(?: ,)?(?: but| and)? (?:do not|never) stack(?: up)?(?: {_THEM})?(?: up)? (?:more than|higher than|over) "
     f"({MANY})(?: {_HIGH})?$", " , no tower higher than {1}"),
    (f"(?: ,)?(?: but)? not (?:stacked |piled )(?:up )?(?:more than|higher than|over) ({MANY})(?: {_HIGH})?$",
     " , no tower higher than {1}"),
    # orders
    (f"\\b(?:so that |such that )?(?:they are |they are to be )?neither in ({_RISING})(?: order)? nor in ({_RISING}) "
     "order((?: from .+)?)$",
     ". they must not be in {1} order {3} . they must not be in {2} order {3}"),
    ("(?<!line)(?<!lined) up front(?! to)", " at the front"),
    # for each line
    (f"^(?:please )?{BUILD} {MANY} {_BLOCKS} (?:in|into|as) ({MANY}) rows of ({MANY})(?: {_BLOCKS})?(?: ,| with| "
     f"where)* {_OF_ITS_OWN}$",
     "build {1} rows of {2} blocks"),
    (f"\\b({MANY}) rows of ({MANY})(?: {_BLOCKS})?(?: ,| with| where)* {_OF_ITS_OWN}$", "{1} rows of {2} blocks"),
    # what it is not to lie on
    (f"(?<!you )\\b(?:do not|never) (?:put|place|stack|set|lay) ({THING}) on (?:anything|any other {CUBE}|another "
     f"{CUBE})$",
     "{1} must not be on anything"),
    # where it is now, and where it is not to stay
    ("^(.+? (?:sits?|lies?|stands?|is|are|rests?|sitting|lying|standing) on [^,]+?)(?: ,)? and (it|they|these|those|"
     f"all of them) ({MUST}) (?:go|be moved|be|move) (somewhere else|elsewhere)$", "{1} . {2} {3} go {4}"),
    # so many of each
    (f"\\b(\\w+ of each)(?: ,)? (?:and|but) (?={_FIRM} |put |place )", "{1} . "),
    ("\\b(\\w+ of each)(?: ,)? (?:and|but) (the [^,]+?) (on|off|next to|in|outside) ", "{1} . {2} must be {3} "),
    # one after the other
    ("^(ensure|make sure) that (.+?)(?: ,)? and that ", "{1} that {2} . {1} that "),
    ("^not both of the (.+?s) (?:may|must|can|should) (be|lie|stand|rest|sit|go) ([^,]+?)(?= ,|$)",
     "at most one of the two {1} may {2} {3}"),
    # which corner
    ("\\bcorner (?:behind|at the back|in the back|at the far end) (?:at|on|to) the (left|right)\\b", "far {1} corner"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
ASKED_ALOUD: tuple[Turn, ...] = (
    (f"^(?:tidy|sort|clean|clear|put)(?: up| out| in order)? ({_THEM}|(?:the |all )?(?:{MANY} )?{_BLOCKS})(?: up| out| "
     "in order)? (?=so that |such that )", "arrange {1} "),
    ("^(?:tidy|clean|clear)(?: up)? (?:so|such) that ", "ensure that "),
    (f"^(?:please )?({_FIRM} [^;]+?)(?: ,)? while (?:you (?:are )?)?(\\w+ing (?:an?|the|two|three|four|five|all|\\w+) "
     ".+)$",
     "while {2} , {1}"),
    ("\\bletters of (?:my|your|his|her|our|their|the)(?: \\w+ 's)? (?:first |last |full )?name(?: ,| :)? (?=\\S)",
     "letters of the word "),
    (f"\\bit (?:{MUST} be|is) (?=(?:at least|at most|exactly|only) )", "there must be "),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("primes prime presence trapped hides buried proper correct usual",)
"""Words that these take besides those that are read anyway."""
