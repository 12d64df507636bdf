"""How many of which there are to be, on each of several, in each lot of a line, and where some and others of them go,
as rows that say it in one way."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, IS, LABEL, PLACE, PUT, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, PATCH, PATCHES

_BLOCKS = "(?:blocks|cubes|bricks|ones)"
_GO = f"(?:{MUST} (?:be|go|lie|stand)|may be|go|goes|are|is|belong|belongs)"
_SOME = f"(?:some|(?:at least|more than) {MANY})"
_NOT_ALL = f"(?:but|and|though) (?:not|never) all(?: {MANY})?"
_WHERE = f"{PLACE} .+"
_LOTS = f"{MANY} (?:{COLOR} )?{_BLOCKS}(?: and {MANY} (?:{COLOR} )?{_BLOCKS})*"
_A = f"(?:the |an? )?({COLOR})(?: {BLOCK}| one)?"
_THREE = f"{_A} , {_A}(?: ,| and| , and) {_A}"
_TWO = f"{_A} and {_A}"
_EITHER = f"{THING}(?: , {THING})*(?: ,)?"
_LOT = f"(?:the |(?:the )?{MANY} )?{COLOR}(?:s\\b| {_BLOCKS})?"
_SHOWN = "(?:blocks|cubes|letters|digits|numbers)"
_LABELS = f"{LABEL}(?:(?: ,)?(?: and)? {LABEL})+"
_NONE = f"(?:(?!\\b{COLOR}\\b).)*\\b"
_EITHER_LOT = f"(?:the )?(?:\\2|\\3)(?:s\\b| {_BLOCKS})?"
"""What names no color, and blocks of one of the two that were named."""
_SO_MANY = f"{MANY}(?: {COLOR})? (?:block|cube)s"
_THERE = f"(?:{MUST}|is|are|go|goes|on|in|stands?)"
_OTHERS = f"(?:(?:,|and|, and) {MANY} {_THERE} (?!(?:top )?of them).+)"

_NAMED = f"(?:the )?(?:{COLOR}(?: {BLOCK}| one)?|{LABEL})"
_LISTED = f"((?:the )?(?:{_SHOWN} )?{_NAMED}(?: , {_NAMED})*(?: ,)? and {_NAMED}(?: {_SHOWN})?)"
"""Different blocks that are listed."""
_HALF = "(?:on|in) the (left|right|near|far)(?: hand)?(?: side| half)?(?: of the table)?"

COUNTED: tuple[Turn, ...] = (
    # on either half of the table
    (f"^({_SO_MANY})(?: [:,])? half(?: of them)? {_HALF}(?: ,| and| , and)(?: the other)? half(?: of them)? {_HALF}$",
     "half of the {1} must be in the {2} half of the table and the other half in the {3} half of the table"),
    (f"^(?:everything|all(?: of)?(?: the)? blocks) ({_GO}) ([^,]+?)(?: ,)? except(?: for)? one(?: block| of them)?"
     "(?= ,|$)", "all but one of the blocks {1} {2}"),
    (f"\\b({MANY}) and (?:no|not) more than \\1\\b", "exactly {1}"),
    (f"^(?:out of|of|from) (?:the |my )?({MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? ((?:exactly|at least|at most|only|"
     f"just) {MANY}) {_GO} ((?:on|onto|in|into) .+)$", "{2} of the {1} must be {3}"),
    (f"^(?:out of|of|from) {_LISTED}(?: ,)? ((?:exactly |at least |at most |only |just )?{MANY})(?:(?: ,)? but not "
     f"both)?(?: ,)? {_GO} ((?:on|onto|in|into) .+)$", "{2} of {1} must be {3}"),
    (f"^((?:{PUT} )?)one but not both of {_LISTED} ", "{1} exactly one of {2} "),
    # some, and not all of them
    (f"^(?:out of|of|from) (?:the |my )?({MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? ({_SOME})(?: ,)? {_NOT_ALL}(?: of them)?"
     f"(?: ,)? {_GO} ({_WHERE})$", "{2} but not all of the {1} must be {3}"),
    (f"^({_SOME}) of (?:the |my )?({MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? {_NOT_ALL}(?: of them)?(?: ,)? {_GO} "
     f"({_WHERE})$", "{1} but not all of the {2} must be {3}"),
    (f"^{PUT} ({_SOME}) of (?:the |my )?({MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? ({_WHERE})(?: ,)? {_NOT_ALL}(?: of "
     "them)?$", "{1} but not all of the {2} must be {3}"),
    (f"^{PUT} ({_SOME}) of (?:the |my )?({MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? {_NOT_ALL}(?: of them)?(?: ,)? "
     f"({_WHERE})$", "{1} but not all of the {2} must be {3}"),
    (f"^((?:{PUT} )?{_SOME}(?: ,)? {_NOT_ALL}) ({MANY} (?:{COLOR} )?{_BLOCKS}) ", "{1} of the {2} "),
    (f"^(.+) , with ({_LOTS}) (?:being )?(?:available|present|there|in all|in total|altogether)$",
     "{1} . there are {2}"),
    ("^(.*\\bat least .*\\bof (?:the|my|these|those) .+?)(?: ,| and| , and| , while) the (?:others|rest|other ones|"
     "remaining ones) (?:may|can) (?:be|go|lie|stay|stand) (?:anywhere|wherever(?: you like| they like)?)$", "{1}"),
    (f"\\b(?:an?|one) ({COLOR}) pair(?! of)\\b", "two {1} blocks"),
    # symbols of two colors
    (f"^(?:{PUT} )?(?:the )?({_SHOWN}) ({_LABELS}) (?:are )?({COLOR})(?: ,| and| , and) (?:(?:the )?{_SHOWN} )?"
     f"({_LABELS}) (?:are )?({COLOR})(?: ,)? (?:all )?(in an? {LINE})$",
     "put {1} {2} and {4} {6} . {1} {2} are {3} . {1} {4} are {5}"),
    # each lot of a line together
    (f"^(?:{PUT} )?({_LOT}) together(?: ,| and| , and) ({_LOT}) together(?: ,)? (?:all )?in (?:an?|one|a single) "
     f"({LINE})((?: , .+)?)$", "put {1} and {2} in a {3} , same colors together {4}"),
    (f"^(?=.*\\b{LINE}\\b)({_NONE}({COLOR})\\b{_NONE}({COLOR})\\b{_NONE}) , {_EITHER_LOT} together(?: ,| and| , and) "
     f"{_EITHER_LOT} together$", "{1} , same colors together"),
    # as many as of others
    (f"^((?:{PUT} )?)(an?|one|the) ({LINE}) of ({COLOR}) ({_BLOCKS})(?: ,)? (?:that (?:is|{MUST} be) )?(?:exactly |"
     f"just )?as (?:long|tall|high) as (an?|one|the|another) ({LINE}) of ({MANY}) (?!{LINE})((?:{COLOR} )?{_BLOCKS})$",
     "{1} {2} {3} of {8} {4} {5} . {6} {7} of {8} {9}"),
    # on each of several
    (f"^on each of ((?:the |my )?{MANY} [^,]+?) there (?:{MUST}|is|are) ?(?:be|stand|lie|sit)? ?(?:exactly )?((?:one|"
     "an?) [^,]+?)$", "put {2} on each of {1}"),
    (f"^((?:empty|clear) [^,]+?)(?: ,)? (?:and|then|and then) fill ((?:the |my )(?:{COLOR} )?{PATCH}) with "
     "((?:all|the|my|both) .+)$", "{1} . put {3} on {2}"),
    (f"^fill ((?:the |my )(?:{COLOR} )?{PATCH}) with ((?:all|the|my|both) .+)$", "put {2} on {1}"),
    # on one patch and on another
    (f"^(?:put |place |set )?(?:the two|both) ({COLOR}) {_BLOCKS} (?:(?:{_GO} )?on different {PATCHES}|(?:{MUST}|may|"
     f"can) not share an? {PATCH})(?: ,| :) one (?:is |goes )?on the ({COLOR})(?: one| {PATCH})?(?: and| ,) (?:one|"
     f"the other)(?: one)? (?:is |goes )?on the ({COLOR})(?: one| {PATCH})?$",
     "one of the two {1} blocks must be on the {2} patch and the other on the {3} patch"),
    (f"^(?:put |place |set )?one ({COLOR}) (?:block|cube) on the ({COLOR}) {PATCH} and (?:one|another)(?: one)? on "
     f"the ({COLOR}) {PATCH}(?: ,)? so that the two(?: \\1)? {_BLOCKS} are on different {PATCHES}$",
     "one of the two {1} blocks must be on the {2} patch and the other on the {3} patch"),
    (f"\\bon one of (?:the )?(?:two )?{PATCHES} , (?:either )?the ({COLOR}) or the ({COLOR})(?: one| {PATCH})?$",
     "on the {1} or the {2} patch"),
    (f"^the ({COLOR}) and the ({COLOR}) (?:block|cube) (?:each )?{_GO} on (?:the {PATCH} of the other 's color|each "
     f"other 's {PATCHES})(?: : (?:the )?\\1(?: {BLOCK})? on the \\2(?: {PATCH}| one)?(?: ,| and)+ (?:the )?\\2(?: "
     f"{BLOCK})? on the \\1(?: {PATCH}| one)?)?$",
     "put the {1} block on the {2} patch and the {2} block on the {1} patch"),
    # as many of these as of those
    (f"^(the (?:{COLOR} )?{PATCH}) (?:{MUST} have|has|{MUST} hold|holds) as many (.+?) as ([^,]+?)(?: on it)?$",
     "there must be as many {2} as {3} on {1}"),
    (f"^the number of ({COLOR} {_BLOCKS}) on (the (?:{COLOR} )?{PATCH}) (?:equals|is (?:equal to|the same as)|{MUST} "
     f"(?:equal|be equal to|be the same as)) (?:the number|that) of ({COLOR} {_BLOCKS})(?: (?:on (?:it|\\2)|there))?$",
     "there must be as many {1} as {3} on {2}"),
    # so many here, and the others there
    (f"^(?:divide|split|distribute|sort|arrange|share|part) ((?:the |my )?{MANY} (?:{COLOR} )?{_BLOCKS})(?: ,)? so "
     f"that ({MANY})(?: of them)? (?:is|are|lie|go) ({_WHERE}?)(?: ,)? and the (?:rest|others?|other {MANY})(?: "
     f"(?:is|are|lie|go))? ({_WHERE})$", "{2} of {1} must be {3} and the others {4}"),
    (f"^(?:take )?(?:both|the two|two)(?: of the)? ({COLOR}) {_BLOCKS}(?: ,)? and (?:{PUT}|stick) one(?: of them)? "
     f"({_WHERE}?)(?: ,)? and the other(?: one)? ({_WHERE})$",
     "one of the two {1} blocks must be {2} and the other must be {3}"),
    # one of two, and not both
    (f"^(?:just |only |exactly )?one of the two ([^,]+?) , but not the other(?: one)? , (?:is|{MUST} be) (.+)$",
     "exactly one of the two {1} must be {2}"),
    (f"^(?:have )?({THING}) (?:{MUST} )?touch(?:es)? (?:just |only |exactly )?one of the two ([^,]+?)(?: ,)? but not "
     "the other(?: one)?$", "exactly one of the two {2} must touch {1}"),
    (f"^put ({THING}) and either ({THING}) or ({THING}) (on .+)$", "{1} must be {4} . {2} or {3} must be {4}"),
    (f"(?: ,)? without (?:either|any|one)(?: one)? of (?:them|the two) touching ({THING})$",
     " and they must not touch {1}"),
    *((f"^(?:either )?({_EITHER}) or ({THING})(?: ,)? but not ({THING})(?: ,)? {be} (.+)$",
       f"{{1}} or {{2}} {said} {{4}} . {{3}} {said} not {{4}}")
      for be, said in ((f"(?:{MUST})", "must"), ("is", "is"), ("are", "are"))),
    (f"^(?:put|place|move|set|bring) (?:either )?({_EITHER}) or ({THING})(?: ,)? but not ({THING})(?: ,)? ({PLACE}.*)$",
     "{1} or {2} must be {4} . {3} must not be {4}"),
    ("^in any case(?: ,)? (?=\\w)", ""),
    # and not the other way round
    (f"^(?:it (?:{MUST}) be )?not (\\w+) on (\\w+) ,? ?but (?:the other way (?:round|around) [:,] )?\\2 on \\1$",
     "{2} on {1}"),
    (f"^it is not the ({COLOR}) {BLOCK} (?:that|which) (?:goes|belongs|{MUST} (?:be|go)) on the ({COLOR}) {BLOCK} but "
     f"the \\2 {BLOCK} (?:that|which) (?:goes|belongs|{MUST} (?:be|go)) on the \\1(?: one| {BLOCK})?$",
     "the {2} block must be on the {1} block"),
    ("^(?:i|we) (?:want|need|would like)(?: to have)?(?: it| that| this| them)? the other way (?:round|around) [:,] "
     "(.+)$", "{1}"),
    # only one of those that are listed
    *((f"^(?:put )?only the ({COLOR})(?: one| {BLOCK})? (?:out )?of (?:the (?:{MANY} )?{_BLOCKS} [(,:]? ?)?(?:the "
    f")?{told}(?: [),])? "
       f"(?:{_GO} )?((?:on|in) .+)$", f"there are {named} blocks . only the {{1}} block must be {{{last}}}")
      for told, named, last in ((_THREE, "{2} , {3} and {4}", 5), (_TWO, "{2} and {3}", 4))),
)  # fmt: skip
"""What is looked for, and what is said instead."""
_MAT = f"(the (?:{COLOR} )?{PATCH}|the {COLOR} one)"
SHARED_OUT: tuple[Turn, ...] = (
    (f"^(?:the )?({MANY} (?:blocks|cubes)) : (half|{MANY}) ({_WHERE}?)(?: ,| and| , and) (half|the (?:others|rest)) "
     f"({_WHERE})$", "put {2} of the {1} {3} and {4} {5}"),
    (f"^one (block|cube) ({_WHERE}?)(?: ,| and| , and) the (others|rest) ({_WHERE}?) , (?:there are )?({MANY}) "
     "(blocks|cubes)(?: in (?:all|total))?$", "put one of the {5} {6} {2} and the {3} {4}"),
    *((f"^(?:put |place )?equally many {many} on {_MAT} and (?:on )?{_MAT}{behind}$", f"as many {said}")
      for many, behind, said in (
          ("(blocks|cubes)", "", "{1} on {2} as on {3}"),
          ("(blocks|cubes)", f" , ({MANY}) (?:blocks|cubes)", "{1} on {2} as on {3} . there are {4} {1}"),
          (f"of the ({MANY}) (blocks|cubes)", "", "{2} on {3} as on {4} . there are {1} {2}"))),
    (f"^(?:out )?(?:of|from) (?:the )?({_SO_MANY}) , ({MANY} {_THERE} .+? {_OTHERS})$", "{1} : {2}"),
    (f"^({MANY}) of (?:the )?({_SO_MANY}) ({_THERE} .+? {_OTHERS})$", "{2} : {1} {3}"),
    (f"^(?:{PUT} )?((?:half|{MANY}) of (?:the )?{_SO_MANY}) (?:{_GO} )?({_WHERE}?)(?: ,| and| , and| , while) "
     f"(?:the )?(other half|other {MANY})(?: (?:{_GO}))? in(?:to)? (an?|one) ({LINE})$",
     "put {1} {2} and make {4} {5} of the {3}"),
    (f"^(the (?:\\w+ )?({LINE})(?: with [^,]+?)? {IS} {PLACE} the other)(?: one)?$", "{1} {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""
