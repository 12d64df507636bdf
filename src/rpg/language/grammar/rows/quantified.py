"""What is said of each of several, of those of a kind among several, of as many as others and of more here than there,
as rows that say it in the words of the grammar."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import LABEL, PUT
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, PATCH, PATCHES

_BLOCKS = "(?:blocks|cubes|bricks|boxes|ones)"
_BLOCK = "(?:block|cube|brick|box)"
_GO = f"(?:{MUST} (?:all )?(?:be|go|lie|stand)(?: put| placed)?|go|goes|lie|are|is|stand|belong)"
_SIDE = ("((?:directly |immediately |right |just )?(?:behind|in front of|next to|beside|(?:to the |on the )?"
         "(?:left|right) of))")  # fmt: skip
_THERE = f"there (?:is|{MUST} be|{MUST} stand|{MUST} lie|stands|lies|are)"
_ONE = f"((?:exactly one|one|an?) (?:{COLOR} )?(?:\\w+))"
_KINDS = "(?:vowels?|consonants?|letters?|digits?|(?:odd|even) (?:ones?|numbers?|digits?|blocks?|cubes?))"
_KIND = "((?:even |odd )?(?:number|digit)|(?:even|odd) (?:block|cube)|vowel|consonant|letter)"
_LABELS = f"(?:{LABEL} to {LABEL}|{LABEL}(?:(?: , and| ,| and)? {LABEL})*)"
_AS_MANY = "(?:(?:just |exactly )?as many|the same number of|an equal number of)"
_TWO = f"(?:the (?:two )?{PATCHES}|two {PATCHES}|an? {PATCH}|one of (?:the )?(?:two |these )?{PATCHES})"
_A = f"(?:the|an?) ({COLOR})(?: one| {PATCH})?"
_ITS_BLOCKS = f"((?:(?:{COLOR}|\\w)(?: , and | , | and ))+(?:{COLOR}|\\w))"
_LOT = f"{MANY} (?:{COLOR} )?{_BLOCKS}"
_LINES = "towers|stacks|rows|lines|columns"
_SHARE = (
    "(?:sharing|having|of|in|with|(?:may |must |should |can )?(?:share|have|be of|be in)) (?:the same|a|one|an?) color"
)
_APART = f"(?:{MUST}|may|can) not (?:(?:be|stand|lie) (?:next to|beside)|touch) (?:each other|one another)"
_ALIKE = f"(?:the )?(?:same colors|{_BLOCKS} (?:of|in|with) (?:one|the same|a|equal) colors?)"
_WITH = "(?: ,| and| but| , with)"
_MORE = "(more|fewer)(?: of them)?"
_EITHER = "must be on the {{{}}} or the {{{}}} patch"
_ALL = f"((?:both|all|all the|the|all {MANY}|the {MANY}) ({COLOR}) {_BLOCKS})"
_ON = f"(on the (?:{COLOR} )?{PATCH})"

_NOT_ALL = f"not all(?: of (?:them|these|those)| (?:the )?{MANY}(?: of them)?)?"

_LISTED = f"\\b(?:letters|numbers|digits|cubes|blocks|available|are)(?: are| :)? {LABEL}(?: ,| and| , and| to) {LABEL}"

WHICHEVER: tuple[Turn, ...] = (
    *((f"^(?=.*{_LISTED})((?:.*(?:[.,;] |\\band ))?(?:please )?(?:{PUT} )?){det} {_KIND}(?: {_BLOCK})? "
       f"(?={_GO} (?:on|in) |(?:on|onto|in|into) (?:the|an?|each) )", f"{{1}} {some} one of the {{2s}}")
      for det, some in (("an?", "at least"), ("(?:exactly )?one", "exactly"))),
    (f"^(?=.*\\b\\d(?: ,| and| , and| to) \\d\\b)(.*\\b(?:all|every)(?: of)?(?: the)? "
     f"(?:{_BLOCKS}|{_BLOCK}|numbers?|digits?) "
     "(?:except|except for|apart from)) (?=\\d (?:on|in|onto|into|belong|go|goes|are|is|must|should)\\b)", "{1} the "),
)  # fmt: skip
"""Over a whole text, of symbols that are listed: "a vowel" is any of them, and "all except 5" are all but that one."""
EACH_THERE: tuple[Turn, ...] = (
    # so many of them, whichever
    (f"\\b({MANY}) ((?:{COLOR} )?(?:blocks|cubes|bricks)) of (?:your|my|our|any) (?:own )?choice (?:out )?of (?:the "
     f"|all )?"
     f"({MANY})(?: \\2)?\\b", "{1} of the {3} {2}"),
    (f"^(?:please )?(?:put|place|move|bring|set) ({MANY}) ((?:{COLOR} )?(?:blocks|cubes|bricks)) of "
     f"(?:your|my|our|any) "
     f"(?:own )?choice ((?:on|onto|in|into|to) .+)$", "exactly {1} of the {2} must be moved {3}"),
    # some, but not all
    (f"^(at least|more than|no fewer than|not fewer than) ({MANY}) of (.+?) ({_GO}) ((?:on|onto|in|into|to) [^,]+?)"
     f"(?: ,)? (?:but|and|though) {_NOT_ALL}$", "{1} {2} but not all of {3} must be {5}"),
    (f"^not all (?:of )?((?:them|these|the)(?: [^,]+?)?) ({_GO}|may be|can be) ((?:on|onto|in|into) [^,]+?)(?: ,)? "
     f"(?:but|though|yet) at least ({MANY})(?: of them)?(?: {MUST}| is| are| has to)?(?: be)?$",
     "at least {4} but not all of {1} must be {3}"),
    # of a line that is told ahead
    (f"^in (?:an?|the) ({LINE}) (?:of|with|made of|from) ({MANY} {COLOR}(?: (?:,|and) {MANY} {COLOR})*(?: {_BLOCKS})?)"
     f"(?: ,)? ((?:no|neither|none) .+|(?:the|an?) .+? (?:{MUST}|may|can) (?:not|never) .+)$",
     "make a {1} of {2} . {3}"),
    (f"^((?:every|each|all(?: of)?(?: the)?|the) (?:letters?|numbers?|digits?|blocks?|cubes?|ones)) (?:in|of) the "
     f"({LINE}) {_ITS_BLOCKS}(?: ,)? ((?:{MUST}|is|are) .+)$", "there must be a {2} {3} . {1} {4}"),
    (f"^in the ({LINE}) {_ITS_BLOCKS}(?: ,)? ((?:every|each|all|the) .+)$", "there must be a {1} {2} . {3}"),
    # no two alike
    (f"^{_ALIKE} {_APART}$", "no two blocks of the same color may be next to each other"),
    (f"^(.+?)(?: ,| and| , and| but| , but) {_ALIKE} {_APART}$",
     "{1} . no two blocks of the same color may be next to each other"),
    # of each of them
    (f"^{_SIDE} (each|every) ((?:of the )?(?:{MANY} )?{COLOR} \\w+) {_THERE} {_ONE}$",
     "{2} {3} must have {4} {1} it"),
    # as many as of others
    (f"^{PUT} {_ALL} {_ON}(?: ,)? (?:and|together with|plus) {_AS_MANY} ({COLOR}) {_BLOCKS}$",
     "put {1} {3} . there must be as many {4} blocks as {2} blocks {3}"),
    (f"^{_ALL} {_GO} {_ON}(?: ,)? (?:and|together with|plus) {_AS_MANY} ({COLOR}) {_BLOCKS}$",
     "{1} must be {3} . there must be as many {4} blocks as {2} blocks {3}"),
    (f"\\b((?:the same|an equal) number of (?:{COLOR} )?{_BLOCKS}(?: {_GO})? on) {_A} and on {_A}(?= ,| \\(|$)",
     "{1} the {2} and the {3} patch"),
    (f"^the number of ((?:{COLOR} )?{_BLOCKS}) (on the (?:\\w+ )?{PATCH}|in the \\w+ half)(?: of the table)? (?:{MUST} "
     f"equal|equals|(?:{MUST} be|is) (?:equal to|the same as)) (?:the (?:number of \\1|number|one) )?(on the (?:\\w+ )?"
     f"(?:{PATCH}|one)|in the \\w+ (?:half|one))\\b", "there must be as many {1} {2} as {3}"),
    # among those that are listed
    (f"^(.*?)\\b((?:each|every|all|the) {_KINDS}) (?:among|of|out of) the ({_BLOCKS}|letters|numbers|digits) "
     f"({_LABELS}) (?=(?:{_GO}|rests?|sits?|lies?|has|have)\\b)(.+)$", "there are {3} {4} . {1} {2} {5}"),
    # more here than there
    (f"^all of (them|(?:the )?{_LOT}) {_GO} on {_TWO}{_WITH} {_MORE} on {_A} than on {_A}$",
     f"each of {{1}} {_EITHER.format(3, 4)} . put {{2}} of them on the {{3}} patch than on the {{4}} patch"),
    (f"^all ({_LOT}) {_GO} on {_TWO}{_WITH} {_MORE} on {_A} than on {_A}$",
     f"each of the {{1}} {_EITHER.format(3, 4)} . put {{2}} of them on the {{3}} patch than on the {{4}} patch"),
    (f"^(?:{PUT} )?(?:all |the )?({_LOT})(?: {_GO})? on two {PATCHES} ?[,:] {_A} and {_A}{_WITH} {_MORE} on the \\2"
     "(?: one)?$",
     f"each of the {{1}} {_EITHER.format(2, 3)} . put {{4}} of them on the {{2}} patch than on the {{3}} patch"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""
QUANTIFIED: tuple[Turn, ...] = (
    # for each of them
    (f"^for (each|every) ((?:of the )?(?:{MANY} )?{COLOR} \\w+)(?: ,)? {_THERE} {_ONE} {_SIDE} it$",
     "{1} {2} must have {3} {4} it"),
    # no two alike
    (f"\\beach ({MANY} (?:blocks|cubes) (?:high|tall)) and (?:of|in) (?:a single|one) color",
     "each {1} and each of a single color"),
    (f"^(.+?)(?: ,| and| , and| but| , but)? no two ({_LINES}) {_SHARE}$",
     "{1} . all {2} must be of different colors"),
    (f"^no two ({_LINES}) {_SHARE}$", "all {1} must be of different colors"),
    (f"^(.+?)(?: ,| and| , and| but) the (?:{MANY} )?({_LINES}) {MUST} not {_SHARE}$",
     "{1} . all {2} must be of different colors"),
    (f"^(.+?)(?: ,| and| , and| with)? (?:the )?same colors {MUST} (?:be|go|lie|stand) (?:on (?:the |a )?diagonals?|"
     "diagonally)$", "{1} with the same colors on the diagonal"),
    (f"\\b({MUST}) (?:both|all) be$", "{1} be"),
    # more than one
    ("^(.*\\b(?:at least (?:two|2|three|3)|two or more|several) (?:towers|stacks|rows|lines)\\b.*?)(?: ,)? (?:and )?"
     "not (?:just |only )?(?:a single|one)(?: big| large| tall| high)?(?: one| tower| stack| row| line)?$", "{1}"),
)  # fmt: skip
"""What is looked for, and what is said instead, where a sentence cannot be read as it stands."""
WORDS = ("among fewer plus",)
"""Words that these take besides those that are read anyway."""
