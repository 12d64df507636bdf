"""What goes on patches that are listed behind it, on the same one or the one and the other, what is cleared off them
and what none but one may be on, as rows that name the patches where they are meant."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.said_short import BLOCK, IS, PLACE, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, MANY, MUST, PATCH, PATCHES

_THE = f"(?:(?:the|an?) )?({COLOR})(?: {PATCH}| one)?"
_GET = f"(?:{MUST} )?(?:gets?|has|have|holds?|carry|carries|receives?|bears?|needs?)"
_SO_MANY = f"((?:exactly |just |only )?(?:{MANY}|an?) [^,:]+?)"
_ON_IT = "(?: on (?:it|them)| on top(?: of (?:it|them))?)?"
_TOWER_OF_IT = "(?:an? )?(tower|stack|pile)s?(?:(?: made)? (?:of|from) (?:the )?(?:blocks|cubes))?"
_ITS_COLOR = (
    f"(?:of|in|with) (?:its|its own|their own|the same|the matching|that|the) color(?: as (?:the|that|this) {PATCH})?"
)
_LISTS = (
    (f"{_THE}{AND} {_THE}", "{1} and {2}", 2),
    (f"{_THE}{AND} {_THE}{AND} {_THE}", "{1} , {2} and {3}", 3),
)
"""Patches that are told one after the other: what is looked for, how they are named together, how many they are."""
_HERE = f"the (?:{COLOR} )?{PATCH}"
_LIES = "(?:lies?|is|are|stands?|sits?|rests?|starts?|begins?)"
_NOW = "(?: now| (?:at|in) the (?:start|beginning)| initially| at first| right now)?"
_SO = "(?:exactly |just |only |at least |at most )?"
_BLOCKS = f"(?:{BLOCK}s|{BLOCK}|bricks?|ones?)"
_OWN = "(?:its own|their own|the same|the matching|its|own|the right)"
_CLEAR = "(?:clear|empty|vacate|free|remove everything from|take everything (?:off|from)|clear everything off)"
_EVERYTHING_OFF = "(?:clear|take|get|remove|move) (?:everything|anything|all of it) (?:off|from|off of|away from)"
_AWAY = ("(?:go|leave|go away|be removed|be taken off|be taken away|come off|disappear|get off|be moved away|get out "
"of "
         "there)")  # fmt: skip
_DEAL = "(?:put|place|set|move|bring|distribute|spread|share|divide|deal)"
_OVER = "(?:out )?(?:on|onto|over|among|between|across|in|into|to)"
_ON_EACH = f"(?:(?:on|in|onto|to) (?:each|every)(?: one| {PATCH}| of them)?|per {PATCH})"
_ALL_OF = "(?:all )?(?:of )?(?:the |these |my )?"
_ANYWHERE = "(?:can|may|could) (?:go|be|be put|be moved|lie)(?: to)? (?:anywhere|wherever)\\b.*"


def _shifted(named: str) -> str:
    """The same groups where another one stands ahead of them."""
    return re.sub(r"\d", lambda nth: str(int(nth[0]) + 1), named)


def _listed() -> tuple[Turn, ...]:
    """ "On each of these patches: the red and the blue one", "red, green and blue, each on the patch of its color"."""
    rows: list[Turn] = []
    for told, named, many in reversed(_LISTS):
        later, last = (" , {3} and {4}" if many > 2 else " and {3}"), f"{{{many + 1}}}"
        each = f"the {named} blocks must each be on the patch of their own color"
        rows += [
            (f"^(.+? on each)(?: of (?:these|the following|the|those) {PATCHES}| {PATCH})(?: ,| :)"
             f"(?: the {PATCHES} (?:being|are))?(?! an?\\b) {told}$", f"{{1}} of the {{2}}{later} patches"),
            (f"^(?=[^:]*{PATCH}){told} : (.+? on each)(?: of them| of these| one| {PATCH})?$",
             f"{last} of the {named} patches"),
            (f"^{told} : (?:each|every one|each one)(?: of them)? (?:gets|has|carries|receives) (?:the|an?) {BLOCK} of "
             f"{_OWN} color$", each),
            (f"^for (?:each|every one) of (?:the )?{told}(?: {PATCHES}| ones)?(?: ,)? (?:put|place|set) (?:the|an?) "
             f"{BLOCK} of {_OWN} color on it$", each),
            (f"^{told}(?: {BLOCK}s?)?(?: ,)? each (?:one )?on (?:the |a )?{PATCH} (?:of|with|in) {_OWN} color$", each),
            # "three red cubes, three patches, red, white and blue: one cube on each"
            (f"^({MANY} (?:{COLOR} )?(?:blocks|cubes))(?: ,| and) (?:{MANY} )?{PATCHES} (?:,|:|\\() {told}(?: "
             f"\\))?(?: ,| :) "
             f"(?:exactly )?one(?: {BLOCK}| of them)? (?:on|onto|per|for) (?:each|{PATCH})(?: one| {PATCH}| of them)?$",
             f"there are {{1}} . put one of them on each of the {_shifted(named)} patches"),
            # "the red patch and the blue patch get one yellow block each"
            (f"^(?=[^:]*\\b(?:{PATCH}|{PATCHES})\\b.* each$){told}(?: {PATCHES})? {_GET} {_SO_MANY}{_ON_IT} each$",
             f"put {last} on each of the {named} patches"),
            (f"^(?=[^:]*\\b(?:{PATCH}|{PATCHES})\\b){told}(?: {PATCHES})? (?:{MUST} )?each {_GET} {_SO_MANY}{_ON_IT}$",
             f"put {last} on each of the {named} patches"),
            (f"^each of (?:the )?(?:two |three )?{PATCHES} , {told} , {_GET} {_SO_MANY}{_ON_IT}$",
             f"put {last} on each of the {named} patches"),
            (f"^(?:each|every) {PATCH} {_GET} {_SO_MANY}{_ON_IT} : {told}$",
             f"put {{1}} on each of the {_shifted(named)} patches"),
            (f"^(?:{BLOCK}s|cubes) and {PATCHES} : {told}$", f"there are {named} blocks"),
            (f"^(?:each of the colors {told} has (?:one|an?) {BLOCK} and (?:one|an?) {PATCH})$",
             f"there are {named} blocks and {named} patches"),
            (f"^there is (?:one|an?) {BLOCK} and (?:one|an?) {PATCH} (?:for|of|in) each of the colors {told}$",
             f"there are {named} blocks and {named} patches"),
        ]  # fmt: skip
    return tuple(rows)


PATCHES_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b((?:exactly )?({MANY}) (?:{COLOR} )?{_BLOCKS}) on one {PATCH}(?: ,)? and (?:exactly )?\\2(?: more| others)? "
     f"on the other(?: one| {PATCH})?(?=$| ,)", "{1} on each of the two patches"),
    *_listed(),
    (f"^(?:(?:put|place|set|move|bring|lay) )?({THINGS})(?: {IS}| are|(?: {MUST} (?:be|go|lie)))? (?:on|onto) the same "
     f"((?:{COLOR} )?{PATCH}) (?:as|(?:that|which|where)(?= .* (?:is|are|lies?|stands?)(?: on)?$)) ({THINGS})"
     "(?: (?:is|are|lies?|stands?)(?: on)?)?$", "{1} and {3} must be on the same {2}"),
    # the colours told once more
    (f"^((?:put|place|set|move) (?:the|all|all the|each|every) {BLOCK}s? on the (?:matching {PATCHES}?|{PATCHES}? "
     f"(?:that|which) match(?:es)?(?: it| them)?|{PATCHES}? of (?:its|their|the same)(?: own)? color) : "
     f".*?)\\b(?<!the )({COLOR}) on (?:the )?\\2(?= ,|$| and)", "{1} the {2} block on the {2} patch"),
    (f"^(?:put|place|set|move) (?:the|all|all the|each|every) {BLOCK}s? on the [^:]+ : (the {COLOR} block on the "
     f"{COLOR} patch.*)$", "put {1}"),
    # so many of them on each
    *((f"^(?:{_DEAL} )?({_ALL_OF}((?:{MANY} )?(?:{COLOR} )?{BLOCK}s))(?: (?:{IS}|go|belong))? {_OVER} {marks} [,:] "
       f"({_SO}{MANY})(?: of them| {BLOCK}s?)? {_ON_EACH}$",
       f"{last} of the {{2}} must be on each of {each} . the {{2}} must be on {each}")
      for marks, each, last in ((f"((?:(?:the|both|all)(?: of)?(?: the)? )?((?:{MANY} )?{PATCHES}))", "the {4}", "{5}"),
                                (f"(the .+ and .+?(?: {PATCH}| {PATCHES})?)", "{3}", "{4}"))),
    (f"^(?:{_DEAL} )?({MANY} (?:{COLOR} )?{BLOCK}s) , ({_SO}{MANY} (?:{_ON_EACH}|(?:on|onto) each of .+))$",
     "there are {1} . put {2}"),
    # different ones
    *((f"^({lead}(?:[^.,]|, (?:and )?(?:an?|the) )+?){verb}(?: each)? (?:on|onto) (?:an?|one|some) {PATCH}(?: each)?"
       f"(?: ,)? but (?:not|never)(?: both)? (?:on|onto) the same(?: one| {PATCH})?$", said)
      for lead, verb, said in (
        ("(?:put|place|set|move|bring) ", "", "{1} on different patches"),
        ("(?!put |place |set |move |bring )", f"(?: each)? (?:go|lie|are|{MUST} (?:each )?(?:be|go|lie))",
         "{1} must be on different patches"))),
    # what is cleared
    (f"^{_EVERYTHING_OFF} ({_HERE})$", "clear {1}"),
    (f"^(?:{_CLEAR}|{_EVERYTHING_OFF}) ({_HERE}) [,:] there (?:is|are) ([^,]+?) (?:on (?:it|there)|there){_NOW}$",
     "at the start , {2} are on {1} . {1} must be empty"),
    (f"^{_CLEAR} ({_HERE}) of ((?:both|all|the|all of the) (?:[^,]|, (?:and )?the )+)$", "take {2} off {1}"),
    (f"^{_CLEAR} ({_HERE}) , (?:on|in) which ((?:(?! at the )[^,])+?) {_LIES}{_NOW}$",
     "at the start , {2} are on {1} . {1} must be empty"),
    (f"^{_CLEAR} ({_HERE}) [,:] ({THINGS}) (?:(?:(?:that|which) (?:{_LIES}|are|lie)|sitting|lying|standing|resting) "
     f")?(?:there|on "
     f"it){_NOW} ({MUST}|goes?|belongs?) (.+)$", "at the start , {2} are on {1} . {2} {3} {4} . {1} must be empty"),
    (f"^{_CLEAR} ({_HERE}) [,:] ({THINGS}) (?:that|which) {_LIES} (?:there|on it){_NOW} ({MUST}|goes?|belongs?) (.+)$",
     "at the start , {2} are on {1} . {2} {3} {4} . {1} must be empty"),
    (f"^{_CLEAR} ({_HERE}) , (?:that is|i e|namely)(?: ,)? ([^,]+?) (?:that|which) {_LIES} (?:there|on it){_NOW}$",
     "at the start , {2} are on {1} . {1} must be empty"),
    (f"^{_CLEAR} ({_HERE}) [:,] ({THINGS}) (?:(?:that|which) {_LIES}|sitting|lying|standing|resting) (?:there|on "
     f"it){_NOW} {_ANYWHERE}$", "at the start , {2} are on {1} . {1} must be empty"),
    (f"^({THING}) (?:that|which) {_LIES} on ({_HERE}){_NOW} {MUST} {_AWAY}(?: from (?:it|there))?$",
     "at the start , {1} is on {2} . {1} must not be on {2}"),
    # only one
    (f"^the only {BLOCK} (on|in) ({_HERE}) (?:{MUST} be|is) (the [^,]+)$", "only {3} must be {1} {2}"),
    ("^(only .+?) (?:may|can|is allowed to|are allowed to) (?:be|lie|stand|go) ((?:on|in) [^,]+?)(?: ,)? and (?:it|"
     f"they) {MUST}(?: be| be there| go there| lie there)?$", "{1} must be {2}"),
    (f"^only ({THING}) ({MUST} (?:be|go|lie|stand)|goes|belongs|is) ((?:on|in) {_HERE}) , not ({THING}) (?:and|or|and "
     f"not|nor) (?:not )?({THING})$", "only {1} must be {3} . {4} and {5} must not be {3}"),
    (f"^(?:the )?({COLOR} {PATCH}) gets ([^,]+?) , but (?:(?:it )?does not get|not) (the .+)$",
     "{2} must be on the {1} . {3} must not be on the {1}"),
    (f"^neither (.+?) nor (.+?) (?:may|must|should|can) (?:be|lie|go|stand) ((?:on|in) {_HERE}) , only (the .+)$",
     "{1} and {2} must not be {3} . {4} must be {3}"),
    # what both of them hold
    (f"^both (?:of (?:the |these ))?(?:the )?(?:two )?({PATCHES}) {_GET} (?=an? "
     f"(?:tower|stack|row|pile|line)\\b)((?:(?! each$).)+?)"
     f"{_ON_IT}(?: each)?$", "put {2} on both {1}"),
    # so many here, and one there
    (f"^({_DEAL} {MANY}) ((?:{COLOR} )?)({BLOCK}s|bricks) ((?:on|in|onto|into) the (?:\\w+ )?{PATCH})(?: ,| and| , "
     f"and) one "
     f"(?!\\4(?: |$))(?=(?:on|in|onto|into) the (?:\\w+ )?{PATCH}\\b)", "{1} {2} {3} {4} and one {2} block "),
    # what each of them holds
    (f"^for each of the colors ({COLOR}) and ({COLOR})(?: ,)? (stack|put|place) the ({MANY}) (blocks|cubes) of "
     f"(?:the|that) color on the ({PATCH}) {_ITS_COLOR}$", "{3} {4} {1} and {4} {2} {5} on the {6s} of the same color"),
    ("\\beach color of blocks?\\b", "each color"),
    (f"^(?:on|onto) (?:each|every)(?: colored)?(?: goal)? ({PATCH})(?: ,)? (?:build|make|put|place|set up|set|stack) "
     f"{_TOWER_OF_IT} {_ITS_COLOR}", "stack the blocks of each color on the {1} of that color"),
    (f"^(?:each|every)(?: colored)?(?: goal)? ({PATCH}) {_GET} {_TOWER_OF_IT} {_ITS_COLOR}(?: on it)?",
     "stack the blocks of each color on the {1} of that color"),
    (f"^(?:on|for|at) (?:each|every)(?: colored)?(?: goal)? ({PATCH})(?: ,)? (?:stack|pile)(?: up)? (?:all )?(?:the )?"
     f"(?:blocks|cubes) {_ITS_COLOR}(?: on it)?", "stack the blocks of each color on the {1} of that color"),
    (f"^(?:each|every) ({PATCH}) (?:{MUST} (?:have|get|hold|carry|bear)|gets|needs) the (?:{BLOCK} (?:of|in) "
     f"(?:{_OWN}|that) color|matching {BLOCK}|{BLOCK} (?:that|which) matches(?: it)?)(?: "
     "(?:sitting|standing|lying|resting|placed))?(?: on (?:it|top(?: of it)?))?(?=$| [,:])",
     "each block must be on the {1} of the same color"),
    (f"^of the (?:two|three) {PATCHES}(?: ,)? the ({COLOR}) one (.+?) and the ({COLOR}) one (.+)$",
     "the {1} patch {2} and the {3} patch {4}"),
    *((f"^the ({COLOR} {PATCH}) {verb} ({_SO}{MANY}) ({COLOR}) ({_BLOCKS})(?: on it)?(?: ,)? and the ({COLOR} {PATCH}) "
       f"(?:{verb} )?({_SO}{many})(?: of them)?(?: on it)?$",
       f"{{2}} {{3}} {{4}} {be} on the {{1}} and {{6}} {{3}} {blocks} {be} on the {{5}}")
      for many, blocks in (("(?:one|1)", "block"), (MANY, "blocks"))
      for verb, be in ((f"(?:gets|{MUST} (?:hold|have|get|carry))", "must be"), ("(?:holds|has|carries)", "are"))),
    # all but one
    (f"^((?:all|every) {BLOCK}s? (?:except|except for|but|apart from) the ({COLOR})[^,]*?) , (?:namely|that is|i "
     f"e)(?: ,)? (?:the|an?) ({COLOR})(?: {BLOCK})? and (?:the|an?) ({COLOR})(?: one| {BLOCK})? ?,? (.+)$",
     "there are a {2} , a {3} and a {4} block . {1} {5}"),
    # without what touches
    ("(?: ,)? without (?:any of them )?touching (?:each other|one another)$", "so that they do not touch each other"),
    (f"\\bin contact with ({THING}) and with ({THING})", "in contact with {1} and {2}"),
    # how many that are
    (f"^(.*)\\b(?:every|each) ({COLOR}) (block|cube)( .+?) , all ({MANY}) of them$", "{1} the {5} {2} {3s} {4}"),
    ("^all (?:two |three |four |five |six )?of them$", ""),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
PATCHES_UNREAD: tuple[Turn, ...] = (
    (f"(?<!with )\\b({_HERE}) (?:is |to be )?(?:left|kept) (?:empty|clear|free)\\b", "{1} must be empty"),
    (f"\\b(?:is|are) (not )?(?:allowed|permitted)(?: to be)? (?=(?:{PLACE}|at) )", "may {1} be "),
)  # fmt: skip
"""What makes no sense as it stands."""
_HAS = "(has|holds|gets|carries|bears|contains|receives)"
_STAYS = (
    f"(?:{_HAS[1:-1]}|(?:is|stays|remains|is left|is kept) (?:empty|free|clear)|"
    f"{MUST} (?:be|stay|remain|hold|have|get|carry))"
)
_ONE_MAT = f"(?:one|the (?:left|right|front|back|near|far|first)) ({PATCH})"
_NO_ONE = f"(?!(?:.* (?:[.,;:]|and) )?(?:put )?one (?:of|on|{COLOR}|{BLOCK})\\b)"
_OTHER = "(?<![^ ])the other(?: one| of them)?"
_SOME = f"(?:{MANY}|an?|the|nothing)"
_ON_THE_OTHER = f"(.*?\\b(?:on|onto|in|into) the other)(?: one| of them| {PATCH})?(?= [.,;!]|$)"
_NO_BLOCKS = "(?:(?!blocks|cubes|bricks|towers|stacks)[^ ]+ )*?"
ONE_AND_THE_OTHER: tuple[Turn, ...] = (
    (f"^(.*\\b(?:on|onto|in|into|to) (?:the |an? )?({PATCH})\\b.* [.,;]) (?:the )?\\2 : ({COLOR})(?= [.,;!]|$)",
     "{1} the {2} is {3}"),
    (f"^(.*\\b(?:two|2) {PATCHES} [.,:;] {_NO_BLOCKS}(?:on|onto|in|into) one)(?: of them| of (?:the )?(?:two |2 )?"
     f"{PATCHES}| {PATCH}) {_ON_THE_OTHER}", "{1} {2}"),
    (f"^(.*\\b(?:on|onto|in|into)) one of (?:the )?(?:two|2) {PATCHES} {_ON_THE_OTHER}", "{1} one patch {2} patch"),
    (f"\\bthe one (?={PATCH} .*\\bthe other\\b)", "one "),
    (f"^(.*\\b(?:two|2) {PATCHES} [.,:;] )one(?: of them)? (?={_STAYS} .*\\bthe other\\b)",
     "{1} one patch "),
    (f"^{_NO_ONE}(.*\\b{_ONE_MAT} .*){_OTHER} (?={_STAYS} )", "{1} the other {2} "),
    (f"^{_NO_ONE}(.*\\b{_ONE_MAT} (?:[a-z]+ )?empty .*\\b(?:on|onto)) {_OTHER}(?= [.,;]| there\\b|$)",
     "{1} the other {2}"),
    (f"^{_NO_ONE}(.*\\b{_ONE_MAT} {_HAS} [^.;]+? (?:and|,|, and|;)) the other"
     f"(?: one(?= {_SOME} )| {PATCH})? (?={_SOME} )", "{1} the other {2} {3} "),
)  # fmt: skip
"""Over a whole text: "the other" of two patches, where it tells what is there. A block is "the other one" as well."""
WORDS = ("vacate namely",)
"""Words that these take besides those that are read anyway."""
