"""Words and equations that are to be read, grids in reading order: told by who reads them or by what comes out, as rows
that spell or write them."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MUST, READER

_CUBES = "(?:letter (?:cubes|blocks|tiles)|letters|the (?:letter )?(?:cubes|blocks|letters)|(?:the )?cubes|blocks)"
_LETTERS = "((?:the )?(?:letters |letter cubes )(?:\\w (?:,|and|, and) )+\\w)"
_FROM = "(?:with|from|using|out of)"
_WORD = "(?:the (?:word|name) )?((?!from\\b)[a-z0-9]{2,})"
_SPELL = "(?:spell|write|make|form|spell out|write out|lay out|read|say)"
_SPELLED = "(?:spelled(?: out)?|written(?: out)?|spelt|formed|displayed|laid out|shown|read|readable)"
_SPELLS = "(?:spells?|reads?|says?|forms?|makes?(?: up)?|gives?|shows?)"
_DOWN = "(?:downwards?|from (?:the )?top to (?:the )?bottom|from the top down(?:wards)?|top to bottom)"
_STACK = "(?:tower|stack|pile)"
_FAR = "(?:far|back|rear)"
_NEAR = "(?:near|front|nearer)"
_IN_FRONT = "(?:in front of (?:it|that)|nearer to me|closer to me|in front|before it)"
_EQUATION = "(?:equation|calculation|sum)"
_TRUE = "(?:true|correct|valid|right)"
_SYMBOLS = "((?:the )?(?:cubes |blocks )?\\d (?:,|and).*?)"
_PAGE = (
    "(?:like (?:in )?an? (?:book|page)|as in a book|like on a page|as on a page|like a text|the way you read a book)"
)
_PHONE = "(?:just |laid out |arranged )?(?:like|as) (?:on|in) an? (?:phone|telephone)(?: keypad| pad)?"
_READ = "(?:(?:you|one|i|we) (?:can )?read (?:them|it)|they (?:can be |are )?read|it (?:can be |is )?read)"
_READS = (
    ("(?: ,)? so(?: that)? (?:it|they) reads? ([a-z]{2,})(?: from left to right)?", "backwards so that it reads {2}"),
    ("", "backwards"),
)
"""What a word reads when it is turned round: told once more, and held against it."""

WRITTEN_AT_ONCE: tuple[Turn, ...] = (
    # signs that are called by their bare names, beside digits
    ("^(?=.*\\b\\d\\b)(?!.*\\b(?:build|make|form|lay|create|shape|arrange|blocks|cubes|cm|mm)\\b)(.*?)\\b(the|an?) "
     "(plus|minus|equals|times)(?= (?:between|left|right|to|on|behind|in|next|beside|and|is|must)\\b|$)",
     "{1} {2} {3} sign"),
    # words down a tower
    ("\\b(tower|stack) of (?:letter (?:cubes|blocks|tiles)|letters)(?: ,)? (?=(?:that|which|spelling|reading|saying) "
     ")",
     "{1} "),
    ("\\ban? letter (tower|stack)(?= (?:spelling|reading|saying|that|which) )", "a {1}"),
    (f"\\b(tower|stack) (?:spelling|reading|saying) {_WORD} (?:when read |if read |read |reading )?{_DOWN}$",
     "{1} that reads {2} from top to bottom"),
    (f"^(?:(?:build|make) )?an? {_STACK}(?: of letter (?:cubes|blocks)| of letters)?(?: ,)? (?:such|so) that ,? ?when "
     f"(?:it is )?read {_DOWN} ,? ?{_WORD} (?:results|appears|comes out|is read)$",
     "a tower that reads {1} from top to bottom"),
    (f"^(?:stack|pile)(?: up)? letter (?:blocks|cubes) (?:so|such) that {_WORD} (?:can be read|is readable|reads) "
     f"{_DOWN}$", "a tower that reads {1} from top to bottom"),
    (f"^{_WORD} {MUST} be {_SPELLED} (?:{_DOWN} )?by an? {_STACK}(?: of letter (?:cubes|blocks)| of letters)?(?: "
     f",)?(?: (?:which is to be )?read(?:ing)?)?(?: {_DOWN})?$", "a tower that reads {1} from top to bottom"),
    (f"^(?:build|make) an? {_STACK} of {_LETTERS} (?:in which|where) (?:you|one|i) (?:can )?read {_WORD} {_DOWN}$",
     "stack {1} so that they read {2} from top to bottom"),
    # words in a row
    (f"\\b(row|line) of (?:(?:letter )?(?:cubes|blocks|tiles)|letters)(?: ,)? (?=(?:(?:that|which) (?:spells|reads|"
     f"says)|"
     f"spelling|reading|saying) (?!(?:from|left|right|the|both|{COLOR})\\b)[a-z]{{2,}}(?: on | in |$))", "{1} "),
    (f"^(?:please )?(?:lay out|lay|put|place|arrange|write|stick|set|line)(?: out| up)? the letters of {_WORD} (?:in a "
     f"row|side by side|next to each other|in a line)(?: ,)? so(?: that)? (?:{READER} can (?:easily |all )?read (?:it|"
     "them|the word)|(?:it|they) can be read|(?:it is|they are) (?:readable|legible))$", "spell {1} in a row"),
    (f"^(.*\\bletters (?:\\w (?:,|and|, and) )+\\w (?:in a row|side by side|in a line))(?: ,)? so(?: that)? {READER} "
     "can (?:easily |all )?read (?:it|the word)$", "{1} in this order from left to right"),
    *(
        (f"^{head}(?: ,)? (?:backwards|in reverse(?: order)?|(?:from )?back to front){tail}$", f"spell {{1}} {said}")
        for head in (
            f"(?:lay out|lay|put|place|arrange|line up) the letters of {_WORD} in a (?:row|line)",
            f"(?:lay out|write|spell) {_WORD}",
            f"(?:the letters of )?{_WORD}(?:(?: ,)? in a row)?(?:(?: ,)? (?:spelled|written))?",
        )
        for tail, said in _READS
    ),
    (f"^(?:put|arrange|line up|place) {_LETTERS} in a row (?:so|such|so that|such that) (?:that )?(?:they|it|you|one|i|"
     f"we)(?: can)? {_SPELLS} {_WORD}( from left to right)?$", "there are {1} . spell {2}"),
    (f"^(?:stack|pile)(?: up)? {_LETTERS} (?:so|such|so that|such that) (?:that )?(?:they|it|you|one|i|we)(?: can)? "
     f"{_SPELLS} {_WORD} {_DOWN}$", "there are {1} . a tower that reads {2} from top to bottom"),
    (f"^(?:put|place|lay|arrange) {_CUBES} in a row (?:so|such|so that|such that) (?:that )?(?:they|it|you|one|i|"
     f"we)(?: "
     "can)? (?:reads?|shows?|says?) (\\S*=\\S*)$", "write {1}"),
    # two words
    (f"^two words {MUST} be {_SPELLED}(?: ,| :)? {_WORD} in the {_FAR} row(?: ,| and| , and) {_WORD} in the {_NEAR} "
     "row$", "{1} in the far row and {2} in the near row"),
    (f"^{_SPELL} {_WORD} in (?:the {_FAR}|one|a) row(?: ,)? and {_WORD} in (?:the {_NEAR} row|another row in front of "
     "it|(?:the|a) (?:next )?row (?:below|underneath|beneath|under)(?: it)?)$",
     "{1} in the far row and {2} in the near row"),
    (f"^(?:the )?(?:{_FAR}) row {_SPELLS} {_WORD}(?: ,| and| , and) the {_NEAR} row {_SPELLS} {_WORD}$",
     "{1} in the far row and {2} in the near row"),
    # grids
    (f"\\b(?:so that|so|such that) {_READ} {_PAGE}", "in reading order"),
    (f"(?: ,)? (?:that|which) (?:{_READ}|you (?:can )?read|is read|can be read|reads) {_PAGE}", " in reading order"),
    (f"^(.*\\b(?:numbers|digits) 1 to 9 .*\\b(?:grid|square))(?: ,)? {_PHONE}$", "{1} in reading order"),
    ("(?: ,)? reading order(?: ,)? (?:(?:starting|beginning) (?:with|in) the far row|the far row first)",
     " reading order"),
    ("(?: ,)? row by row(?: ,)? (?:starting|beginning) (?:at the |in the |from the )?far left(?: corner)?",
     " in reading order"),
    ("^((?:the )?(?:digits|numbers)(?: from)? \\d to \\d) (?:form|make|are laid out as|fill) (\\w+ rows of \\w+|an? "
     "\\S+ "
     "(?:square|grid)) (in reading order)$", "put {1} in {2} {3}"),
    ("\\b(the (?:digits|numbers)) from (\\d to \\d)(?=.*reading order)", "{1} {2}"),
    # what no word has in it, and how its cubes look
    (f"^(distractors? [:,] .+?) , (?:which|that) {MUST} not (?:be part of|join) (?:the|that) word$", "{1}"),
    (f"\\b({MUST}) not join (?=(?:the|that) word\\b)", "{1} not be part of "),
    ("\\bmust stay out of (?=(?:the|that) word\\b)", "must not be part of "),
    (f"^all (?:of )?(?:the )?letters {MUST} be ({COLOR}) when (?:you|we|i) ((?:spell|write) .+)$",
     "{2} , all letters {1}"),
    (f"\\ball (?:the )?(?:cubes|letters|blocks)(?: of the word| in the word)? have (?:the |a )?({COLOR}) color\\b",
     "all letters {1}"),
    # equations
    (f"\\ban? {_EQUATION} (?:that|which) is {_TRUE}\\b", "a true equation"),
    ("^i (?:want|would like) to (?:read|see) (\\S*=\\S*) (?:in|with) (?:cubes|blocks)$", "write {1}"),
    *(
        (f"^(?=.*\\b{_EQUATION}\\b)(.*?)\\b(?:the |an? )?{word}(?: (?:sign|symbol|cube|block)s?(?= |$)|(?= ,|$| and | "
         f"to | "
         f"with | {MUST}\\b))", f"{{1}} {sign}")
        for word, sign in (("plus", "+"), ("times", "*"), ("multiplication", "*"), ("division", "/"), ("equals?", "="))
    ),
    (f"^(?=.*\\b{_EQUATION}\\b)(.*?)\\b(?:the |an? )minus(?: (?:sign|symbol|cube|block))?(?= |$)", "{1} minus"),
    (f"\\b(?:so|such)(?: that)? an? {_TRUE} {_EQUATION} (?:comes out|results|is formed|appears|arises|can be read|"
     "emerges)$", "so that they form a true equation"),
    (f"^from {_SYMBOLS}(?: ,)? an? {_TRUE} {_EQUATION} {MUST} (?:come out|be made|be formed|result|be built)$",
     "make a true equation with {1}"),
    (f"^from {_SYMBOLS} {MUST} (?:come out|be made|be formed) an? {_TRUE} {_EQUATION}$",
     "make a true equation with {1}"),
    (f"^(?:take|use) {_SYMBOLS} (?:and|to) {_SPELL[:-1]}|build) an? {_TRUE} {_EQUATION}(?= |$)",
     "make a true equation with {1} "),
    (f"\\b({_TRUE} {_EQUATION}|equation) (?:out of|made of|made from|from|using) (?=.*\\d .*=)", "{1} with "),
    (f"\\b({_TRUE} {_EQUATION} with (?:the )?(?:cubes |blocks )?\\d , \\d)(?: and| ,|, and) (\\d) (?:and|with|, with|"
     f", and) "
     "(\\S+) and (=)", "{1} , {2} , {3} and {4}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""

WRITTEN: tuple[Turn, ...] = (
    (f"^{_WORD} is what {_CUBES} (?:{MUST} )?{_SPELLS}$", "spell {1}"),
    (f"^{_WORD} is what {_CUBES} {MUST} {_SPELLS[:-2]})(?: at the end| in the end)?$", "spell {1}"),
    (f"^{_CUBES} {MUST} make up {_WORD}(?: (?:at|in) the end)?((?: in a row)?)$", "spell {1}"),
    (f"^the word (?:that|which) {MUST} be {_SPELLED}(?: (?:by|with|in|from) {_CUBES})? is {_WORD}$", "spell {1}"),
    (f"^{_WORD} {MUST} be {_SPELLED}(?: (?:in a row|on the table|with letter cubes|in letters|from left to right))*$",
     "spell {1}"),
    (f"^(?:i (?:want|would like)(?: to)?|let me) (?:see|read) {_WORD}(?: (?:on the table|in a row|in letters|in letter "
     "cubes|in blocks))*$", "spell {1}"),
    (f"^(?:can you |please )?{_SPELL} {_WORD} {_FROM} {_CUBES}$", "spell {1}"),
    (f"^{_SPELL} {_WORD}(?: to me| for me)?(?: {_FROM} {_CUBES})?$", "spell {1}"),
    (f"^read {_WORD}(?: ,)?(?: in a row)?(?: ,)?(?: from left to right)?$", "spell {1}"),
    (f"^{_WORD} , one letter per (?:cube|block)$", "spell {1}"),
    (f"^(?:use|take|{_FROM}) {_LETTERS}(?: ,)? (?:to |and )?{_SPELL} {_WORD}(?: (?:with|from|out of) them)?$",
     "there are {1} . spell {2}"),
    (f"^(?:there are|i have|here are) {_LETTERS}$", "there are {1}"),
    (f"^{_LETTERS}(?: in a row| side by side)?(?: ,)? (?:spelling|reading|forming|saying) {_WORD}$",
     "there are {1} . spell {2}"),
    # two words
    (f"^(?:(?:put|spell|lay|write) )?{_WORD} behind {_WORD}$", "{1} in the far row and {2} in the near row"),
    (f"^(?:(?:put|spell|lay|write) )?{_WORD} in front of {_WORD}$", "{2} in the far row and {1} in the near row"),
    (f"^(?:{_SPELL}|i (?:want|would like) to (?:read|see)) {_WORD}(?: ,)? and(?: ,)? (?:{_IN_FRONT}|in front of "
     f"\\1)(?: "
     f",)? {_WORD}$", "{1} in the far row and {2} in the near row"),
    (f"^(?:{_SPELL} )?the words (\\S+) and (\\S+) in two rows(?: ,)? \\1 (?:further|farther) (?:away|back)$",
     "{1} in the far row and {2} in the near row"),
    (f"^(?:{_SPELL} )?the words (\\S+) and (\\S+) in two rows(?: ,)? \\1 (?:in the far one|behind|at the back)$",
     "{1} in the far row and {2} in the near row"),
    (f"^the words (\\S+) and (\\S+) {MUST}(?: both)? be (?:on the table|readable|visible|there) ,?(?: with)? \\1 "
     f"(?:is |"
     "being )?behind \\2$", "{1} in the far row and {2} in the near row"),
    # equations
    ("^(?:make |there is )?an? row (?:that|which) (?:shows|says|reads) (\\S*=\\S*)$", "write {1}"),
    ("^(.+? (?:equals|is|makes|gives) [a-z0-9]+) , (?:written|laid out|built|made|shown) (?:in|with|out of) "
     "(?:number |digit )?(?:and sign )?(?:cubes|blocks)$", "write {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("appears book emerges keypad phone readable results telephone",)
"""Words that these take besides those that are read anyway."""
