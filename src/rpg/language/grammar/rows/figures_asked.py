"""Figures that are asked for in other words than commands and wishes: "let us raise a pyramid", "a grid is specified",
"today's sum is ..., please lay it out", "help the letters stand in a row", as rows that ask for them plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY
from rpg.language.grammar.talk.people import RELATIONS

FIGURE = (
    "(?:tower|stack|pillar|row|line|column|grid|wall|pyramid|staircase|stairway|square|rectangle|triangle|circle|ring|"
    "plus|cross|checkerboard|chessboard|rainbow|cuboid|letter|word|equation|sum|t|l|u|v|x)s?"
)
"""What is built, written or laid."""
_A_FIGURE = (
    f"(?:an?|{MANY}) (?:(?:(?!of |that |which |block |blocks )[\\w']+ ){{0,4}}{FIGURE}|\\d+x\\d+(?:x\\d+)? "
    "(?:block|cube|box))(?= |$)"
)
_DOER = "(?:us|to|we|i|you|should|must|shall|will|can|could|would|and|then|now|please|robot|kindly|just)"
_MAKING = (
    "(?<!at )(?:generate|raise|establish|realize|realise|render|specify|define|devise|present|display|try|attempt)"
)
"""Verbs for which "build" is said, as other rows have it."""
_SET = "(?:specified|defined|stipulated|described|prescribed|requested|demanded)"
_THE_GOAL = "(?:is|shall be|has been) (?:given|set|defined|specified|stated) as (?:the|our|my|your) (?:goal|target|aim)"
_DAYS = "(?:(?:today|tomorrow|tonight|this week|this lesson) 's|the|our|my|your|this)"
_NOTED = f"{_DAYS} (?:new |first |next )?"
OF_DAY = "(?: (?:of|for) (?:the day|today|the week|this lesson|this week))?"
_EQUATION = "(\\S*\\d\\S*=\\S+|\\S+=\\S*\\d\\S*)"
_WORD = "([a-z]{2,})"
_ALSO = "(?: ,| :| and| so| then| now| please| kindly)*"
WRITE = "(?:lay|write|spell|build|show|put|make|set|form)"
_IT = "(?:it|this|that|this word|that word|the word|this name|that name|his name|her name|the name|the sum)"
_LAID = f"{WRITE}(?: (?:out|down|up))?(?: {_IT})?(?: (?:out|down|up))?"
_CUBES = (
    "(?: (?:with|in|from|using|out of) (?:the |our |my |your )?(?:(?:number|letter|digit|symbol) )?(?:cubes|blocks))?"
)
_WANTS = "(?:wants?|needs?|would like|would love|likes?|is waiting for|are waiting for|am waiting for)"
_THAT_IS = "(?:(?: ,| :|;)* (?:that is|namely|which is|this means|that means|i mean)(?: ,| :)?| :)"
_SHOWN = "(?:display|exhibit|showcase|stage|counter|shelf|stand)"
_END = "(?:the )?(?:left|right|top|bottom|front|back)(?: side| end)?"
_WAY = f"(?:from )?{_END} to {_END}"
_AGREED = (
    "(?:(?:the|both|all|all the) (?:parties|sides|partners|members|neighbors)(?: hereby)?(?: have)? |"
    "we (?:hereby |have )?)(?:agree|agreed|stipulate|decided|confirm|declare) that "
)
_THEM = "(?:letters|digits|numbers|vowels|consonants|blocks|cubes|bricks|ones)"

FIGURES_ASKED_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b({_DOER} )?{_MAKING} (?={_A_FIGURE})", "{1} build"),
    (f"^({_A_FIGURE}[^:]*?) (?:is|was|has been|shall be|is to be) {_SET}(?: as follows)?(?= :|$)", "{1}"),
    (f"^({_A_FIGURE}.*?) {_THE_GOAL}$", "{1}"),
    # sums and words
    (f"^{_NOTED}(?:sum|equation|calculation|problem|task|exercise|solution){OF_DAY}(?: today| now)? (?:is|:|reads) "
     f"{_EQUATION}(?:{_ALSO} {_LAID}{_CUBES})?$", "write {1}"),
    (f"\\b(spells?|spelling|reads?|reading|says?|saying) {_WORD} (?:when|if)(?: it is| it's| you| one| i| we)? "
     f"read(?:ing)?(?: it)?(?: ,)? ({_WAY}|downwards?|upwards?)$", "{1} {2} {3}"),
    (f"^({WRITE} (?:it|this|that)) (?:out|down|up)({_CUBES})$", "{1} {2}"),
    ("\\b(?:using|with|from|out of) the (?:number|digit) (?:cubes|blocks) and (?:the )?(?:(?:plus |equals |operator )?"
     "signs|symbols|operators|(?:sign|operator|symbol) (?:cubes|blocks))$", "using the cubes"),
    (f"^({WRITE}(?: out)?) {_WORD} (?:in (?:block|capital) letters )?across the (?:table|desk)$", "{1} {2}"),
    (f"^((?:write|spell)(?: out)?) {_WORD} in (?:block|capital) letters$", "{1} {2}"),
    (f"^{_AGREED}(.+?)(?: ,)? and that (.+)$", "{1} . {2}"),
    (f"^{_AGREED}", ""),
    (f"^(?:{RELATIONS}) (?=(?:can|could|will|would) (?:you|we|i) |(?:please )?(?:make|build|put|spell|write|lay|"
     f"stack) )", ""),
    # whose they are, who sees or reads them, and where
    (f"\\b({_WANTS}) (?:her|his|their|my|our|its) ({FIGURE})(?: now| today| please| again)*{_THAT_IS}", "{1} a {2} :"),
    (f"\\b({_WANTS}) (?:her|his|their|my|our|its) ((?:\\w+ ){{0,2}}{FIGURE}) (?=of |made of |from |with )",
     "{1} a {2}"),
    (f"^(?:on|in) (?:this|our|my) (?:\\w+ )?{_SHOWN}(?: ,)? (?=(?:the|an?|{MANY}|all|there) )", ""),
    ("(?: ,)? so(?: that)? (?:\\w+ ){1,3}can (?:count|read|recite|follow|learn|sing) (?:them|it|these|those) in "
     "((?:(?:the|their) )?(?:right |reading |alphabetical |numerical |counting |ascending )?order)$", " in {1}"),
    (f"\\b({FIGURE}) (?:numbered|lettered|labelled|labeled) (?:from )?(\\w) (?:to|through|till|up to) (\\w)\\b",
     "{1} of the blocks {2} to {3}"),
    ("\\b(?:the )?(?:letters of the )?alphabet from (\\w) to (\\w)\\b", "the letters {1} to {2}"),
    ("^(stack|pile)(?: up)?(?: them)? in this order(?: ,)? from (?:below|the bottom)(?: up)? : (.+?)(?: on (?:the "
     ")?(?:very )?top)?$", "{1} from bottom to top : {2}"),
    ("(?: ,)? (?:from )?left to right(?: ,| and|, and|, then| then)+ (?:from )?(?:top to bottom|back to front)$",
     " in reading order"),
    # blocks that do it
    (f"^help ((?:the |these |those |all |our |my |both )*(?:[^:]*? )?{_THEM}(?: (?:\\w|,|and|to))*?)(?: to)? (stand|"
     "form|line up|make|be|sit|lie|spell|sort themselves)\\b", "let {1} {2}"),
    ("\\b(?:hold|holding|holds|join|joining) hands(?= (?:and form |to form |in |around |all around ))", "stand"),
    ("\\b(?:queue|queues|queuing) up(?= (?:in|behind) )", "stand"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("specify define devise defined stipulated tonight nickname shelf parties stipulate",)
"""Words that these take besides those that are read anyway."""
