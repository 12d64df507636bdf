"""What leaves out a part that stands nearby: "red on blue or vice versa", "the red cube, not the blue one, goes ...",
"to the left and to the right of C, respectively", "one of them here, the other there", as rows that say all of it."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LINE, MUST, PATCH, WAY

BLOCK = "(?:block|cube|letter|digit|number)"
_NOUN = f"(?:{BLOCK}s?|{PATCH}s?|patches|ones?)"
_BEHIND = ("and|or|on|onto|in|at|to|left|right|behind|above|below|next|beside|not|must|should|is|goes|belongs|has|gets|"
           "each|instead|rather")  # fmt: skip
LABEL = f"(?:[b-z0-9](?= |$)|a(?! \\w)|a(?= (?:{_BEHIND}) ))"
"""Symbols; the article is none."""
_ONE = f"(?:{BLOCK}|{PATCH}|one)(?= |$)"
_WORD = ("(?:(?!(?:on|onto|in|into|to|of|and|or|not|is|are|must|should|goes|behind|above|below|under|next|beside|near|"
         "from|with|to|where|each|has|gets) )\\w+ )")  # fmt: skip
THING = (f"(?:(?:the|an?|all|both|every|my|{FEW}) {_WORD}{{0,3}}?{_NOUN}(?= |$)(?: {LABEL})?|"
         f"(?:the )?(?:{COLOR}(?: {_NOUN})?(?= |$)|{LABEL}))")  # fmt: skip
_SINGLE = f"(?:(?:the|an?|one) {_WORD}{{0,3}}?{_ONE}(?: {LABEL})?|(?:the )?(?:(?:{COLOR})(?= |$)|{LABEL}))"
_KNOWN = f"(?:the {_WORD}{{0,3}}?{_ONE}(?: {LABEL})?|(?:the )?(?:(?:{COLOR})(?= |$)|{LABEL}))"
"""One thing, and one that is the same when it is named twice."""
_JOINED = f"{THING}(?:(?: ,)? and {THING})*"
THINGS = f"{THING}(?:(?: ,)? and {THING}| , {THING})*"
"""Things by what they are called: "the red cube", "red", "A", "the letter A"; and several of them."""
PUT = "(?:put|place|set|move|lay|bring|stand)"
_SIDE = "(?:to the left of|to the right of|on the left of|on the right of|left of|right of|in front of|behind)"
ASIDE = f"(?:(?:directly |immediately |right |somewhere )?{_SIDE}|above|below|under|beneath|underneath)"
OVER = "(?:directly )?(?:on top of|on|onto|upon)"
PLACE = f"(?:{ASIDE}|{OVER}|in|into|inside|next to|beside|near|close to|against|between|touching)"
"""Words of place: those that tell a side, those that tell what bears a thing, and all of them."""
_BE = "(?:be placed|be put|be|go|stand|lie|sit|rest|end up)"
IS = f"(?:(?:{MUST}|may|can) {_BE}|is|goes|belongs|stands|lies|sits|comes|rests)"
_ARE = f"(?:{IS}|are|go|belong|stand|lie|sit|come|rest)"
_THAT = f"(?:that |which )?(?:{_ARE}|has|gets|carries|touches|forms?|makes?)"
_AROUND = "(?:vice versa|the other way (?:round|around)|the reverse|the opposite|the other way)"
_NOT = "(?:and not|but not|not|rather than|instead of|as opposed to)"
_NEITHER = (f"neither(?: one| of (?:them|these|the two))?(?: {MUST}| may| can| is)?"
            "(?: be| being| lie| lying| stand| rest| sit)?")  # fmt: skip
_EACH_GETS = (f"(?:{MUST} )?(?:each )?(?:{MUST} )?(?:each )?(?:get|gets|have|has|carry|carries|receive|bear) (.+?)"
              " (?:on top(?: of (?:it|them))?|on (?:it|them))")  # fmt: skip
_TO = "(?:to|towards|toward) the"
_ELLIPTIC = "to the left|to the right|on the left|on the right|left|right|in front|behind|above|below|under"
_HALF = "(left|right|near|far|front|back)"
_PAIRS = (
    (f"the ({COLOR}) and (?:the )?({COLOR}) (?:block|cube)s?", "the {1} one", "the {2} one"),
    (f"(?:the (?:two )?(?:letters|cubes|blocks|digits|numbers) )?({_KNOWN}) and ({_KNOWN})", "{1}", "{2}"),
)
"""Two things: how they are told, and each of them."""


def _respectively() -> tuple[Turn, ...]:
    """ "A and B to the left and to the right of C, respectively": each of the two at one of the two places."""
    rows: list[Turn] = []
    for two, one, other in _PAIRS:
        begun = f"^(?:please )?(?:{PUT} )?{two}(?: {_ARE})?"
        rows += [
            (f"{begun} ({_ELLIPTIC})(?: of)? and ({ASIDE}) ({THING})(?: ,)? respectively$",
             f"{one} must be {{3}} of {{5}} and {other} must be {{4}} {{5}}"),
            (f"{begun} ({PLACE} {THING}) and ({PLACE} {THING})(?: ,)? respectively$",
             f"{one} must be {{3}} and {other} must be {{4}}"),
            (f"{begun} (?:in|on) the {_HALF} halfs?(?: of the table)? and (?:(?:in|on) )?the {_HALF} half"
             "(?: of the table)?(?: ,)? respectively$",
             f"{one} must be in the {{3}} half and {other} must be in the {{4}} half of the table"),
        ]  # fmt: skip
    return tuple(rows)


SHORT_AT_ONCE: tuple[Turn, ...] = (
    # "the red cube, not the blue one, goes on the green cube"
    (f"^((?:please )?{PUT} {_JOINED})(?: ,| \\()? {_NOT} ({THINGS})(?: ,| \\))? (?={PLACE}\\b)", "{1} and not {2}"),
    (f"^({_JOINED})(?: ,| \\()? {_NOT} ({THINGS})(?: ,| \\))? (?={_THAT}\\b)", "{1} and not {2}"),
    # "the block with a 5 goes on the one with a 3"
    ("\\bthe one (?:with|showing|bearing|carrying|that (?:has|shows|says|reads)) (?:an? |the )?(?:letter |number |"
     f"digit )?({LABEL})(?= ,| and| {MUST}| is|$)", "the {1} block"),
    ("^(?:the )?(?:first|second|third|another|one|next|other|a) (group|pile|bunch|cluster) : ([^:]+)$", "a {1} of {2}"),
    # "to the right of B, not to the left"
    (f"^(.+ (?:{ASIDE}) ({_KNOWN}))(?: ,)? {_NOT} ((?:(?:to|on) the )?(?:left|right)|in front)$",
     "{1} , not {3} of {2}"),
    # "like this: A B C in the back row, ..."
    (f"^(?:{PUT}|arrange|lay|order) (?:them|it|everything|(?:all )?(?:the |these )?(?:blocks|cubes|letters|"
     "numbers))(?: out)? (?:like this|as follows|this way)(?: [:,])? (?=.+ (?:row|column|left|right|middle|top|"
     "bottom)\\b)", ""),
    ("\\b(together) in (?:one|the same|a single) (?:spot|place|area)\\b", "{1}"),
    ("\\bin front and (to the (?:left|right)) of\\b", "in front of and {1} of"),
    ("^(start with .+?)(?: ,)? and (?:then )?((?:end|finish)(?: up)? with .+)$", "{1} . {2}"),
    *_respectively(),
    # "each get a white cube on top"
    (f"^({THINGS}) (?=.*\\beach\\b){_EACH_GETS}$", "put {2} on each of {1}"),
    ("^(.*\\bat least .+?) , (?:both|all of them)$", "{1}"),
    ("^(?:it does not matter which(?: one)?|which(?: one| of them)?(?: it is)? does not matter|no matter which(?: "
     "one)?)$", ""),
    # "C has A on its left and B on its right"
    (f"^({_KNOWN}) (?:gets|has|{MUST} have) ({_SINGLE}) (?:on|to) its (left|right)(?: side)?(?: ,)? and ({_SINGLE}) "
     "(?:on|to) its (left|right)(?: side)?$", "{2} must be to the {3} of {1} and {4} must be to the {5} of {1}"),
    # what is one of a kind that was named before
    (f"^(.*?\\b(?:an?|one) ({LINE}) (?:of|made of|made from) .*?)\\b(?:one|another(?: one)?) (made (?:of|from) .+)$",
     "{1} a {2} {3}"),
    (f"^({THINGS}) (?:{MUST} )?(?:make up|form|make) (?:an?|one) ({LINE})(?: ,)?(?: and)? ({THINGS})(?: make up| form|"
     " make)? another(?: one)?$", "{1} form a {2} and {3} form another {2}"),
    ("^(?:separate|sort|divide|split) [^:]+ : (.+ in one (group|pile|bunch)\\b.+ in another(?: \\2| one)?)$", "{1}"),
    ("^(.+ at the ends(?: ,)? and .+) inside$", "{1} in the middle"),
    # "neither may be on the other"
    (f"(?: ,)?(?: but| and| with)? {_NEITHER} (on top of|on|touching|next to|beside|near|above) the other(?: one)?$",
     ". they must not be {1} each other"),
    # "of the two, one is on the other"
    (f"^of {_PAIRS[0][0]} ,? ?(?:exactly )?one (?:{IS} )?({PLACE}) the other(?: one)?$",
     "the {1} one must be {3} the {2} one or the {2} one must be {3} the {1} one"),
    # "move red first and then green, both onto the mat"
    *((f"^{first} ({_KNOWN}){behind}(?: ,)?(?: and)? then ({_KNOWN}){both} ((?:{OVER}|into|in|to) (?:{_KNOWN}|the "
       f"{_HALF} half(?: of the table)?))$", "first {1} {2} {4} , then {1} {3} {4}")
      for first, behind, both in ((f"(?:first(?: ,)? )?({PUT})", " first", "(?: ,)? both"),
                                  (f"first(?: ,)? ({PUT})", "", "(?:(?: ,)? both)?"))),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

SHORT: tuple[Turn, ...] = (
    # "a red cube to the left of, and a blue cube to the right of, the white cube"
    (f"^(?:{PUT} )?({THING})(?: {IS})? ({PLACE})(?: ,)? and ({THING})(?: {IS})? ({PLACE})(?: ,)? ({_KNOWN})$",
     "{1} must be {2} {5} and {3} must be {4} {5}"),
    # "start with ...; end with ..."
    ("^(?:end|finish)(?: up)? with (.+?) ((?:in|on|at|next to|stacked) .+)$", "at the end {1} must be {2}"),
    (f"^(?:instead of|rather than) ({THINGS})(?: ,)? ({PUT}) ({THINGS}) (.+)$", "{2} {3} and not {1} {4}"),
    (f"^unlike ({THINGS}) , (?:which|that) ({_THAT} [^,]+) , (.+)$", "{1} {2} . {3}"),
    ("^(?:likewise|similarly)(?: ,)? (?=\\w)", ""),
    # "on the red patch rather than on the blue one", "to the right of B, not to the left"
    (f"^(.+ {WAY})(?: ,)? (?:and |but )?(?:not|rather than|instead of) {WAY}$", "{1}"),
    (f"^(.* (?:goes|going|go|rises?|rising|climbs?|climbing|up|down) {_TO} (left|right))(?: ,)? {_NOT} {_TO} "
     "(?!\\2)(?:left|right)$", "{1}"),
    (f"^((?:{PUT} )?{LABEL}(?: {_ARE})? ({PLACE}) the {COLOR} (\\w+))(?: ,| \\()? {_NOT} the ({COLOR})(?: one| "
     f"{BLOCK})?(?: \\))?$", "{1} , not {2} the {4} {3}"),
    # "red on blue or vice versa"
    (f"^((?:please )?(?:{PUT}|stack) )?(?:either )?({_KNOWN}) ({_ARE} )?({PLACE}) ({_KNOWN})(?: ,)? or {_AROUND}$",
     "{1} {2} {3} {4} {5} or {5} {3} {4} {2}"),
    (f"^((?:{PUT} )?the ({COLOR}) ({BLOCK}) ((?:{_ARE} )?{OVER} the) ({COLOR}) ({PATCH}))(?: ,)? and {_AROUND}$",
     "{1} and the {5} {3} {4} {2} {6}"),
    ("(?: ,)? and vice versa : (?=\\S)", " and"),
    # "not this but that"
    (f"^not (?:only|just|merely) ({THINGS})(?: ,)? but(?: also)? ({THINGS})(?: as well| too)? ((?:{MUST}|{_ARE}) .+)$",
     "{1} and {2} {3}"),
    (f"^it is ({THINGS})(?: ,)? (?:and )?not ({THINGS})(?: ,)? (?:that|which) (.+)$", "{1} and not {2} {3}"),
    # what follows
    ("^(.+?)(?: ,)? and , (?:after that|then|afterwards|next|finally) , (.+)$", "{1} , and then {2}"),
)  # fmt: skip
"""What makes no sense as it stands, with the part that it leaves out."""
WORDS = ("respectively likewise similarly versa vice opposed unlike possibly maybe perhaps reverse opposite",)
"""Words that these take besides those that are read anyway."""
