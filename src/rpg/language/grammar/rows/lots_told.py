"""Groups of which each is told, corners that each get one, and numbers that are exact, "not more, not less", as rows
that say it in one way."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import LABEL
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH, PATCHES
from rpg.language.grammar.talk.people import PEOPLE

_BLOCK = "(?:blocks?|cubes?|bricks?|ones?)"
_GROUP = "(?:group|bunch|pile|heap|cluster|lot|set)"
_GROUPS = "(?:groups|bunches|piles|heaps|clusters|lots|sets)"
_MAKE = "(?:make|form|build|create|lay out|arrange|put together)"
_PART = "(?:split|divide|separate|sort|part|arrange|put|group)"
_COUNTED = f"{MANY} (?:{COLOR}|{COLOR} {_BLOCK}|{COLOR}s)"
_LOTS = f"{_COUNTED}(?:(?: ,| and| , and)+ {_COUNTED})*(?: {_BLOCK})?"
_SYMBOL = f"(?:\\d|{LABEL})"
_SYMBOLS = (f"(?:the )?(?:digits|numbers|letters|symbols|blocks|cubes)(?: from)? (?:{_SYMBOL} to {_SYMBOL}|"
            f"{_SYMBOL}(?:(?: ,| and| , and)+ {_SYMBOL})+)")  # fmt: skip
_STOCK = f"(?:(?:the )?{_LOTS}|{_SYMBOLS})"
_EACH = "(?:(?:,|:) (one (?:with|of|for|has|having|made of|containing|consisting of) .+))"
_MIXED = "(?:all )?(?:(?:mixed|jumbled|muddled)(?: up| together)?|thrown together)"
_TOLD = "(?:there (?:are|is)|(?:we|i|you) (?:have|have got|got)|here are)"
_HAND = "(?:give|hand|get|lend|bring|provide|supply)"
_WHOM = f"(?:him|her|them|me|us|it|everyone|the robot|(?:my|our|the) (?:little )?(?:{PEOPLE}))"
_EVERY_PATCH = f"\\b(?:each|every|all|both|{MANY})(?: one)?(?: of)?(?: the)?(?: \\w+)? (?:{PATCH}|{PATCHES})\\b"
_ALIKE = "(?:(?:the )?(?:blocks|cubes|ones|bricks) (?:of|with|in) (?:the|one) same color|(?:the )?same colors?)"
_JUST = "(?:not|no) more(?: ,| and| or| , and| , or)* (?:not|no) (?:less|fewer)"
_PER_CORNER = ("(?:with )?(?:exactly )?(?:a different )?one(?: block| cube| of them)? (?:in|per|at|for|to) each"
               "(?: corner| one| of them)?")  # fmt: skip
_OWN = "(?:a different|its own|their own|another|a separate|different|separate|four different)"
_FOUR = f"(?=.*\\bfour\\b|(?:.*?\\b(?:{'|'.join(sorted(lexicon.COLOR))})\\b){{4}})"
_WHO = (f"(?:(?:my|our|the|a|some) (?:little |young )?(?:{PEOPLE}|toddler)|"
        "somebody|someone|people|they|we|i)")  # fmt: skip
_NUMBERED = "(?: ones| numbers| digits)"
_STRANGER = "(?:outlier|odd one out|odd one|stranger|intruder|misfit)"
_AS = "(?:being|is|as|acting as|serving as|which is)(?: the| an?| its)?(?: only| single| one)?"


def _of_their_kind() -> tuple[Turn, ...]:
    """ "With the vowels A, E and I": those blocks, which are vowels; "blocks with the letters A, B and C" have them."""
    kinds = (("vowels", "[aeiou]"), ("consonants", "[b-df-hj-np-tv-z]"), ("letters", "[a-z]"),
             ("(?:digits|numbers)", "\\d"), ("odd (?:digits|numbers|ones)", "[13579]"),
             ("even (?:digits|numbers|ones)", "[02468]"))  # fmt: skip
    rest = "(?=$| ,? ?(?:and |but )?(?:one|the other|another)\\b)"
    shown = "(?<!blocks )(?<!cubes )(?<!bricks )"
    ahead = {"letters": shown, "(?:digits|numbers)": shown}
    return tuple((f"{ahead.get(kind, '')}\\b(with|of|for|has|contains) the {kind} "
                  f"({one}(?:(?: ,| and| , and) {one})*){rest}", "{1} {2}") for kind, one in kinds)  # fmt: skip


_PLACE = "(?:zone|patch|mat|area|target|region)"

LOTS_AT_ONCE: tuple[Turn, ...] = (
    # "a red a green and a blue block"
    (f"\\b(an? {COLOR}) (?=an? {COLOR}\\b)", "{1} , "),
    (f"^(.*\\b{_GROUPS}\\b.* (?:and|,)) 1 (with|of|for|has) ", "{1} one {2} "),
    *_of_their_kind(),
    (f"\\bone (?:with|of|for|has|having) (?:the )?(odd|even){_NUMBERED}?(?: ,| and| , and)+ (?:one|the other|"
     f"another)(?: one| {_GROUP})? (?:with|of|for|has|having) (?:the )?(odd|even){_NUMBERED}?$",
     "one with the {1} numbers and one with the {2} numbers"),
    # of what there is, what each group has
    (f"^(?:please )?{_MAKE} ({MANY} {_GROUPS}) (?:from|out of|of|with|using) ({_STOCK}) ?{_EACH}$",
     "there are {2} . make {1} , {3}"),
    (f"^(?:please )?{_PART} ({_STOCK}) (?:in|into) ({MANY} {_GROUPS}) ?{_EACH}$", "there are {1} . make {2} , {3}"),
    (f"^({MANY} {_GROUPS}) (?:from|out of|using) ({_STOCK}) ?{_EACH}$", "there are {2} . make {1} , {3}"),
    (f"\\b({_GROUPS}) of (?:blocks|cubes|bricks)(?= ?(?:,|:) one\\b)", "{1}"),
    (f"^((?:{_MAKE} )?{MANY} {_GROUPS}) , (one (?:with|of|has|having|containing) .+)$", "{1} : {2}"),
    # one colour in each group
    (f"\\b({_ALIKE}|color) together(?: again)? (?:in|into) (?:separate|different|their own|{MANY}) {_GROUPS}\\b",
     "{1} together"),
    (f"^({_LOTS}) , (?:kept |put |all )?in separate {_GROUPS} by color$", "sort {1} by color"),
    (f"^{_MAKE} ({MANY}) {_GROUPS} , one ({COLOR}) and one ({COLOR})(?: ,| :)? (?:of|with) ({MANY})(?: {_BLOCK})?(?: "
     "each| in each)$", "make a group of {4} {2} blocks and a group of {4} {3} blocks"),
    (f"^(?:{_MAKE} )?an? ({COLOR}) {_GROUP} and an? ({COLOR}) {_GROUP}(?: ,)? (?:of|with)? ?({MANY}) {_BLOCK}(?: in)? "
     "each$", "make a group of {3} {1} blocks and a group of {3} {2} blocks"),
    (f"^{_MAKE} an? ({COLOR}) {_GROUP} and an? ({COLOR}) {_GROUP}(?: ,)? (?:from|with|out of) ({MANY}) {_BLOCK} of "
     "each(?: color)?(?: ,)? (with .+ in each.*)$", "group {3} {1} and {3} {2} blocks by color {4}"),
    # a lot, and some of it
    *((f"^({MANY} ({COLOR}) (?:block|cube)s) [,:;] (?:only |just )?{some} \\2 (?:block|cube)s? (?:{MUST} be |is |are )?"
       f"(?=(?:on|in|at|next to|behind|beside|between|left|right|to)\\b)", f"{{1}} , {said} of them ")
      for some, said in (("(?:one|an?)", "one"), (f"({MANY})", "{3}"))),
    # how they lie at the start, which is anywhere
    (f"^({_TOLD} .+?) {_MIXED}(?: on the table)?$", "{1}"),
    (f"^((?:the )?{_LOTS}) (?:are|lie|were|got|have been|got all) {_MIXED}(?: on the table)?$", "there are {1}"),
    (f"^(?:{_WHO}) (?:has |have )?(?:mixed|jumbled|muddled) up ((?:my |the )?{_LOTS})$", "there are {1}"),
    # so many, and no other number
    (f"\\b(?:exactly |only )?({MANY})( of (?:them|these|those)| of (?:the|my) [^,]+?) ((?:{MUST} be |go |are |is "
     f")?(?:on|in|onto|into) [^,]+?)(?: ,)? (?:and )?{_JUST}$", "exactly {1} {2} {3}"),
    # one in each corner
    (f"^{_FOUR}(.*?)(?: ,)?(?: each| every one| each one| one each| each of them| all)? (?:in|into|at|to) {_OWN} "
     "corners?( of the table)?$", "{1} in the four corners of the table"),
    (f"^{_FOUR}(.*\\bcorners)( of the table)?(?: ,| ;| :)? {_PER_CORNER}$", "{1} of the table"),
    (f"^{_FOUR}(.*?)(?: ,)? a different one (in|into|at|to) (each corner|every corner|each of the (?:four )?corners|"
     "each)( of the table)?$", "{1} , one {2} {3} {4}"),
    ("^((?:\\w+ )?(?:one|an?) (?:block|cube)(?: each)? (?:in|into|at) (?:each|every|all)(?: of the)?(?: four)? "
     f"corners?(?: of the table)?)(?: ,| and)+ the ({COLOR}) one (?=in|at|on)", "{1} and the {2} block "),
    # what there is
    (f"^(?:please )?{_HAND} {_WHOM} (?:with )?((?:exactly |just )?{MANY}(?: {_BLOCK})? of each(?: color| kind| one)?)$",
     "there are {1}"),
    (f"^(?:the )?({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR} (?:blocks|cubes)) : ((?:put|stack|place|build|make|"
     "arrange|line|move|set|lay) .+)$", "there are the {1} . {2}"),
    # two groups, each with strangers from the other
    (f"^(?:put |sort |part |split |divide )?({MANY}) ({COLOR})(?: {_BLOCK})? and ({MANY}) (?!\\2)({COLOR}) "
     f"{_BLOCK} (?:in|into) "
     f"(?:two {_GROUPS} ?[,:] (?:one|an?) (?:\\2|\\4)(?: one)?(?: ,| and) (?:one|an?) (?:\\2|\\4)(?: one)?|an? "
     f"(?:\\2|\\4)(?: "
     f"one)? and an? (?:\\2|\\4) {_GROUP})(?: ,)? (?:but |and |though )?((?:each|with) .*?\\b(?:{_STRANGER}s?|"
     "(?:other|wrong) color)\\b.*?)(?: in it| inside| inside it)?$",
     "sort {1} {2} and {3} {4} blocks by color , but {5}"),
    # what is sorted
    (f"^sort by color : (.+? into the {COLOR} {_PLACE} .+)$", "put {1}"),
    ("^group by kind : (.+? in one (?:cluster|group|pile) , .+? in another(?: one)?)$", "put {1}"),
    (f"^(.*\\btwo {_GROUPS}(?: ,| :)) ({_COUNTED}) (?:with|and) ({_COUNTED})(?: ,| and| , and) ({_COUNTED}) (?:with|"
     f"and) ({_COUNTED})$", "{1} one of {2} and {3} and one of {4} and {5}"),
    (f"^({MANY} (?:blocks|cubes)) (?:start|begin|lie|are) (in an? (?:heap|pile))(?: ,| and|;|\\.)+ (?:the goal is |"
     f"then |the (?:player|robot) (?:wins|succeeds) by )?sort(?:ing)? (?:them|it) into an? ({COLOR}) {_GROUP} and an? "
     f"({COLOR}) {_GROUP} , ({MANY}) (?:of )?each$", "{1} , {5} {3} and {5} {4} , start {2} . sort them by color"),
    (f"^sort ({MANY} (?:blocks|cubes)) into an? ({COLOR}) {_GROUP} and an? ({COLOR}) {_GROUP} , ({MANY}) (?:of )?each$",
     "there are {1} , {4} {2} and {4} {3} . sort them by color"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
LOTS: tuple[Turn, ...] = (
    # who is the stranger
    (f"^(.*\\b(?:one|an?|single) ({COLOR})\\b.*?)(?: together)? (?:as|in|into|to) (?:one|an?|a single) "
     f"({_GROUP})(?: ,)? "
     f"(?:and |with )?the \\2(?: {_BLOCK})? {_AS} {_STRANGER}$", "{1} in one {3}"),
    (f"^((?:{_MAKE} )?an? {_GROUP} of .+?)(?: ,)? with (?:one|an?|a single) ({COLOR})(?: {_BLOCK})? {_AS} {_STRANGER}$",
     "{1} with one {2} outlier"),
    (f"^(?:group|cluster|bunch(?: together)?) (?:the )?({_COUNTED})(?: ,)? with (?:exactly )?(?:one|an?|a single) "
     f"(?:({COLOR})(?: {_BLOCK})? {_AS} {_STRANGER}|{_STRANGER} , an? ({COLOR}) {_BLOCK})$",
     "make a group of {1} with one {2} {3} outlier"),
    # "the other two are blue and go on the right half"
    (f"^(?:({MANY}) of (?:the {MANY} (?:blocks|cubes)|them)|(?:the (?:other|remaining) )({MANY}))(?: blocks| cubes| "
     f"ones)? are ({COLOR}) and ((?:go|belong|lie|stand|sit|{MUST}|end) .+)$",
     "there are {1} {2} {3} blocks . the {3} blocks {4}"),
    (f"^(?:one(?: of (?:the {MANY} (?:blocks|cubes)|them)| block| cube)?|the (?:other|remaining|last|second|third|"
     f"fourth|fifth)(?: one| block| cube)?) is ({COLOR}) and ((?:goes|belongs|lies|stands|sits|{MUST}|ends) .+)$",
     "there is a {1} block . the {1} block {2}"),
    (f"^(?!.*{_EVERY_PATCH})(.+?) [,:] there (?:is|are) ({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR})$",
     "{1} . there are {2}"),
    (f"^(?:i|we) (?:only|just) (?:want|need|would like) (?:exactly )?({MANY}) of (them|these|those) (on|in) (.+)$",
     "exactly {1} of {2} must be {3} {4}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("mixed jumbled muddled toddler contains",)
"""Words that these take besides those that are read anyway."""
