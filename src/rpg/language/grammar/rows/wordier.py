"""What is said with more words than it takes, or of a part of what it is said of, "whose numbers increase", "two blocks
by four blocks", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import CUBE, FEW, LENGTH, LINE, MANY, ME, MUST, WAY

_PATCH = "(?:patch|mat|zone|target|area|spot|pad|goal)"
_TRUE = "(?:true|correct|right|valid)"
_KINDS = "(?:letter|digit|number|vowel|consonant)"
_LIKING = "(?: you (?:like|want|please|wish|choose|prefer))?"
_RISE = "(?:increase|rise|grow|ascend|go up|get bigger|get larger)"
_FALL = "(?:decrease|fall|shrink|descend|go down|get smaller)"
_PUSH = "(?:move|bring|push|slide|shift|carry|nudge|drag|pull)"
_MOST = "(largest|biggest|greatest|highest|smallest|lowest|least)"
_ENDWISE = "(left|right|front|back|near|far)"
_SIDE = "(left|right)(?: end| side)?"
_STARTED = "where (?:it|they) (?:starts|start|started|is now|are now|was|were|began|begins)"

_NO_FAVOR = "".join(f"(?<!{word})" for word in (
    "upright", "readable", "legible", "visible", "enough", "fine", "good", "possible", "ok", "okay", "right", "work",
    "works", "do", "easy", "hard", "easier", "important", "best", "nice"))  # fmt: skip
"""Behind these "for us" tells for whom it is so."""

_OF = "(?:exactly |just |only |at least |at most )?(?:each|one|any|any one|none|all|both|either|neither|two|three)"

_THAT_IS = "(?:(?: ,)+|(?: ,)* (?:that is|so|so basically|meaning|it means|which means|in other words)(?: ,)?)"
"""Or a comma behind which "i.e." is not said."""

WORDIER_AT_ONCE: tuple[Turn, ...] = (
    # for whom
    (f"\\b(build|make|show|give) us (?=(?:an?|the|one|some|\\d+|{FEW}) )", "{1} me "),
    (f"{_NO_FAVOR} for (?:me|us)(?=$| ,| with | on | in | and | as | from )", " "),
    # who touches whom
    (f"^(?:(?:i|we) (?:want|need|would like) )?(?!no )(.+?) (?:{MUST}|to) be touched by (?!the (?:robot|arm|"
     "gripper))(.+)$", "{2} must touch {1}"),
    ("^(?!no )([^,]+?) (?:is|are) touched by (?!the (?:robot|arm|gripper))([^,]+)$", "{2} must touch {1}"),
    (f"\\b({_PUSH}) ((?:the|an?) [^,]+? {CUBE}|the \\w+ one|\\w+|it) (?:up|over|right up|all the way) to (it|the "
     f"[^,]+?|\\w)(?: ,)? (so that|until) (they|the two|both|the two {CUBE}s)(?: just)? touch\\b(?! the table)",
     "put {2} next to {3} so that they touch"),
    # how much there is
    (f"\\b({MANY}) {CUBE}s (by|x) ({MANY}) {CUBE}s\\b", "{1} {2} {3} blocks"),
    (f"^((?:every|each) [^,]+? {CUBE}) , (?:and )?there are ({MANY})(?: of (?:them|those|these))? , (.+)$",
     "{1} {3} . there are {2} of them"),
    (f"\\bsome ((?:\\w+ )?{CUBE}) (?!of\\b|.*\\b(?:not|no|never)\\b)", "at least one {1}"),
    # numbers and letters
    ("^((?:(?!equation|sum).)+?)(?: ,)? (?:so|such) that the (?:equation|sum|calculation) (?:is|comes out|works out|"
     f"holds|becomes) ?{_TRUE}?$", "{1} so that they form a true equation"),
    ("^of (the (?:digits|numbers|letters) [^;]+?) , (the (?:even|odd) (?:ones|digits|numbers) .+)$",
     "there are {1} . {2}"),
    (f"\\b(in|into|form|make|are|be) an? ({LINE})(?: ,)? whose (?:numbers|digits) {_RISE}\\b",
     "{1} a {2} in ascending order"),
    (f"\\b(in|into|form|make|are|be) an? ({LINE})(?: ,)? whose (?:numbers|digits) {_FALL}\\b",
     "{1} a {2} in descending order"),
    (f"^(?:the word )?(\\S+) (?:{MUST} be|is) (?:spelled|spelt|written|shown|formed) by (an? {LINE}\\b[^,]*)(.*)$",
     "{2} must spell {1} {3}"),
    # one of several that are listed with an article each
    *((f"\\b({_OF}) of the (\\w+) , the (\\w+)(?: ,)? (?:and|or) the (\\w+) ({noun})\\b",
       f"{{1}} of the {{2}} , {{3}} and {{4}} {plural}")
      for noun, plural in (("block|cube", "blocks"), (_PATCH, "patches"))),
    ("\\b(gradient|rainbow|rainbow order|spectrum)(?: ,)? from (\\w+) (?:on|at) the (left|right|front|back|top|bottom) "
     "to (\\w+) (?:on|at) the (left|right|front|back|top|bottom)$", "{1} from {2} to {4} from {3} to {5}"),
    (f"\\b(checkerboard|chessboard)( of [^,]+?)?(?: ,| with| of| in) ({FEW}) rows of ({FEW})(?: {CUBE}s)?(?: each)?$",
     "{1} {2} , {3} by {4}"),
    (f"^((?:to|on|behind|in front of|next to|beside) .*?\\b(?:a|the) {LINE}) , ((?:in|on) which [^,]+) , (.+)$",
     "{1} {2} {3}"),
    # the same place in other words
    ("\\bbe moved off$", "be taken off"),
    # of all that was told of, and not of the lot that was told of last
    ("^((?:please )?(?:put|stack|move|bring|place|lay|take|line|pile|arrange|sort|set)(?: up)?) them all\\b(?! (?:but|"
     "except|of))", "{1} all of them"),
    (f"^they ({MUST}) all (be|go|lie|stand|end up|belong)\\b", "all of them {1} {2}"),
    (f"\\b((?:nearer|closer) to {ME} than [^,]+?){_THAT_IS} in front of (?:it|that)$", "{1}"),
    (f"\\b(in front of [^,]+?){_THAT_IS} (?:nearer|closer) to {ME}$", "{1}"),
    (f"\\b(behind [^,]+?){_THAT_IS} (?:(?:farther|further)(?: away)? from {ME}|(?:farther|further) away)$", "{1}"),
    # what is where
    ("(?:\\bdirectly )?\\b(behind|in front of) ([^,]+?)(?: please)?(?: , (?:directly|straight|exactly)(?: \\1(?: "
     "(?:it|that one))?)?)?(?: ,| and)* not off to (?:one|the|a|either) side$", "directly {1} {2}"),
    (f"^({WAY})(?: ,)? (?:we|you|i) (?:have|see|find|get) ", "{1} there are"),
    ("\\b(left|right) hand (end|edge|position|place|one|block|half)\\b", "{1} {2}"),
    ("\\b(half|corner|middle|center|edge) of the table\\b(.+?)\\b(half|corner|middle|center|edge) of it$",
     "{1} of the table {2} {3} of the table"),
    ("^((?:the|an?|both|block|cube) [^,]+?|\\w+) (starts|begins|stands|sits|is|lies)(?: now| initially| at first| at "
     "the start)? ((?:on|in|next to|behind|under) [^,]+?)(?: at the start| now| at first| initially)?(?: ,)? (?:and|"
     "but) (?:(?:i|we) (?:would like|want|need) it not to|it (?:should|must|may|shall) (?:not|no longer)|(?:should|"
     "must|may) (?:not|no longer)) (?:be|stay|remain) there(?: any more| anymore| any longer)?(?: (?:at|in) the end)?$",
     "at the start , {1} is {3} . {1} must not be {3}"),
    (f"^on (?:either|each) side of (the [^,]+?) there (?:is|{MUST} be) one of the two (\\w+) {CUBE}s\\b",
     "on either side of {1} there is a {2} block"),
    (f"^(?:in (?:the|an?) ({LINE})|an? ({LINE}) (?:in which|where))(?: ,)? (?:both|the two|the) ends (?:are|{MUST} "
     f"be) (\\w+) and the ({FEW}) (?:{CUBE}s |ones )?(?:in )?between(?: them)? (?:are |{MUST} be )?(\\w+)$",
     "a {1} {2} of {4} {5} blocks with a {3} block at each end"),
    (f"^(?:take|get|pick|pick up|grab) (the (?:{MANY} )?(?:\\w+ )?{CUBE}s)(?: up)? (?:from|out of) (?:their|a) (heap|"
     "pile)(?: ,)? (?:and|then|and then) (.+)$", "{1} start in a {2} . {3}"),
    (f"^({MANY} \\w+ {CUBE}s?(?: ,| and| , and) {MANY} \\w+ {CUBE}s?) , and (on (?:every|each) .+)$", "{1} . {2}"),
    ("^(.+?) (?:may|can|could) (?:be|stand|lie|go) (?:placed )?(?:anywhere|wherever)(?: (?:in|on) "
     f"[^,]+?)?{_LIKING}(?: ,)? (?:as long as|so long as|provided(?: that)?|but only if) (?:it|they) (?:is|are|does|"
     "do|stands?|lies?) (not )?(?:stand |lie |be )?(.+)$", "{1} must {2} be {3}"),
    # lines and figures by what they show
    (f"^(line up|line them up|arrange) , (?:from )?{_ENDWISE} to {_ENDWISE} : (.+)$", "{1} from {2} to {3} : {4}"),
    ("\\b(every corner|each corner)( of the table)? receives? (.+)$", "{1} {2} gets {3}"),
    (f"(?: ,)? (?:in which|where|so that|such that|in such a way that) the {_MOST} (number|digit|letter) (?:is|stands|"
     f"comes|lies) (?:on|at) the {_SIDE}(?: ,)? and the {_MOST}(?: one| \\2)? (?:is |stands |comes |lies )?(?:on|at) "
     f"the {_SIDE}$", ", the {1} {2} on the {3} and the {4} on the {5}"),
    (f"(?: ,)? (?:that|which) (?:goes|runs|leads) from the {_MOST}(?: number| digit)? (?:on|at) the {_SIDE} to the "
     f"{_MOST}(?: number| digit)? (?:on|at) the {_SIDE}$", ", the {1} number on the {2} and the {3} on the {4}"),
    ("\\b(?:that|which) follows? the (?:colors of the )?rainbow\\b", "in rainbow order"),
    ("(?: ,)? (?:colored|arranged|patterned|laid out) like an? (?:checkerboard|chessboard|chess board)$",
     "in a checkerboard pattern"),
    ("^the (?:finished|final) (?:table|scene|picture|layout|state) shows (them|these|those|the [^,]+?) (in an? .+|in "
     "one .+)$", "{1} must be {2}"),
    ("\\bput together (?:as|into|to form|to make) (an?) ", "arranged as {1} "),
    ("(?: ,)? in which (the [^,]+?) (?:are|is|form|make up) the (far|near|back|front) row and (the [^,]+?) (?:(?:are|"
     "is|form|make up) )?the (far|near|back|front) row$", "with {1} in the {2} row and {3} in the {4} row"),
    (f"\\b(?:are|be) (?:a )?part of (the same|one|a single) ({LINE})$", "belong to {1} {2}"),
    ("(?: ,)? without (?:being|standing|lying|sitting|resting) (on .+|in .+|next to .+|beside .+)$", "but not {1}"),
    ("\\bin that (?:corner|half|region|area|part)\\b", "there"),
    ("^(.*\\bnever\\b.*?) (?:on|along) the way(?: there)?$", "{1}"),
    # who does what
    ("^file ((?:the|all|these|those|them) ?.*\\border\\b.*)$", "arrange {1}"),
    ("\\b(change|swap|trade|exchange|switch) (?:their )?(places|positions|spots) with (?:each other|one another)\\b",
     "{1} {2}"),
    (f"^(?:just )?{_PUSH} (the [^,]+?) , (?:and )?(?:i want|(?:so that|until) (?:i have)?) ?(?:it|it is) at least "
     f"({LENGTH})(?: away)? from {_STARTED}$", "move {1} by at least {2}"),
    (f"^(?:i|we) (?:want|need|would like) ([^,]+?) (?:to be )?at least ({LENGTH})(?: away)? from {_STARTED}$",
     "move {1} by at least {2}"),
    ("\\b(an? (?:plus|cross)) (?:out of|from|of) (an? .+ in the center and .+ around it)$", "{1} with {2}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

WORDIER: tuple[Turn, ...] = (
    # what each is
    (f"\\bby whether (?:they|it|each(?: one)?|the \\w+) (?:are|is) (?:an? )?({_KINDS})s? or (?:an? )?({_KINDS})s?$",
     "into {1s} and {2s}"),
    # what may be anywhere
    ("^(?:you (?:may|can|could|are free to) |feel free to )?(?:put|place|set|move) (.+?) (?:just )?(?:anywhere|"
     f"wherever){_LIKING}(?: ,)? (?:as long as|so long as|provided(?: that)?|but only if) (?:it|they) (?:is|are|stays|"
     "stay|ends up|end up|remains|remain) (.+)$", "{1} must be {2}"),
    ("\\bonly (.+?) (?:may|can) be (on .+?)(?: ,)? and (?:there it must be|it must be there|it must)$",
     "only {1} must be {2}"),
    # lines
    (f"\\b({LINE}(?: of [^,]+?)?)(?: ,)? (?:which|that)(?: ,)? (?:going |read |reading |seen )?({WAY})(?: ,)? (?:is|"
     "are|reads|goes|read) (.+)$", "{1} , {2} : {3}"),
    (f"\\b({LINE}(?: of [^,]+?)?)(?: ,)? (?:whose gaps are|with) (?:all )?(?:the )?(?:gaps )?(?:all )?(?:equal|"
     "equally wide|the same)$", "{1} with equal gaps"),
    (f"\\bat (either|each|both|one) ends? of (?:the|that|this) {LINE}$", "at {1} end"),
    ("(?<!filled )\\b(square|rectangle|circle|triangle) whose (?:outline|perimeter) (?:is|consists of|is made of|is "
     "formed by) (.+)$", "{1} of {2}"),
    ("\\bflat (in (?:the (?:form|shape) of )?an? \\w+)$", "{1}"),
    (f"^(each of .+?|[^,]+? {_PATCH}s?|[^,]+? patches)(?: {MUST})? receives? (.+)$", "{1} gets {2}"),
    # together and apart
    ("^(.*\\b(?:together|grouped|group|groups|sorted|gathered)\\b.*?)(?: ,)?(?: and)? (?:away|apart|separate|"
     "separated) from (?:the )?(?:blocks of |those of |ones of )?(?:the )?other colors$", "{1}"),
    (f"^(.+? (?:on|onto|on top of) the [^,]+?) , which (?:{MUST} be|is|comes) at the (?:very )?bottom(?: of (?:it all|"
     f"all|the {LINE}|the pile|everything))?(| , .+| and .+)$", "{1} , which must be on the table {2}"),
    # one after another
    (f"\\b(?:has reached|have reached|reaches|reached) ((?:the|its|an?) (?:\\w+ )?{_PATCH})\\b", "is on {1}"),
    (f"\\b(?:{MUST} )?reach ((?:the|its|an?) (?:\\w+ )?{_PATCH})\\b", "must be on {1}"),
    # to and from
    ("^([^,]+? and [^,]+?) , (?:please )?(?:now )?(?:change|swap|trade|exchange|switch) (?:places|positions|spots)$",
     "{1} must swap places"),
    ("\\bwhere (.+?) in turn (is|rests|stands|sits|lies|must)\\b", "where {1} {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("wherever touched turn reach reaches reached whether outline perimeter",)
"""Words that these take besides those that are read anyway."""
