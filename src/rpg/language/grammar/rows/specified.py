"""What is told in the order of words of a specification, "..., the centre of which shall be red", or required as in a
test plan, as rows that say it in a plain order."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LENGTH, LINE, MANY, MUST, TOWER, WAY

_MANY = "(?:\\d+|two|three|four|five|six|seven|eight|nine|ten|twelve)"
_LINE = "(?:tower|stack|row|line|column|heap|pile|circle|ring|pyramid|grid|wall|staircase)"
_THING = "(?:block|cube|patch|mat|target|tile|zone)"
_THINGS = f"(?:{_THING}s?|patches)"
_CM = "[\\d.]+ (?:cm|mm|(?:centi|milli)met(?:er|re)s?)"
_BESIDE = "(?:on|on top of|to the left of|to the right of|behind|in front of|next to|beside)"
_STAND = "(?:be|stand|lie|sit|rest)(?: placed| put| found)?"
_THEN = "(?:then|thereafter|afterwards|subsequently|after that)"
_MOVED = "(?:moved|transferred|shifted|relocated|brought|carried)"
_SIDED = f"(?:{_MANY} (?:lower|upper|bottom|top|left|right)|(?:lower|upper|bottom|top|left|right) {_MANY})"
_IS = f"(?:is|are|{MUST} be)"
_WANTED = "(?:required|needed|wanted|desired|prescribed|requested|asked for)"
_SYMBOL = "(?:letter|digit|symbol|number)"
_ROW = "(?:far|near|front|back|first|second|top|bottom)"
_FREE = "(?:arbitrary|free|open|irrelevant|of no importance)"

SPECIFIED_AT_ONCE: tuple[Turn, ...] = (
    (f"^at no (?:time|point|moment) ({MUST}|may|can) any (.+?) (be|stand|lie|touch|rest|sit) (.+)$",
     "no {2} {1} ever {3} {4}"),
    (f"^(.+?)(?: ,)? (?:which|that) (start|begin|are initially) (?:out )?(in an?|in one) ({_LINE})(?: ,)? ({MUST} .+|"
     "end up .+|form .+)$", "{1} {2} {3} {4} . they {5}"),
    ("(?:so|such) that the word (\\S+) (?:can be read|can be seen|is read|is spelled|is formed|appears)\\b",
     "so that they spell {1}"),
    (f"^((?:a|the|one) {_LINE}) , ((?:in|on) which [^,]+) , ({MUST} .+)$", "{1} {2} {3}"),
    (f"^of the two (\\w+) {CUBE}s , the (small|big|large)(?:er|ger|r)? one (.+) the (small|big|large)(?:er|ger|r)? "
     "one\\b", "the {2} {1} block {3} the {4} {1} block"),
    (f"^(the [^,]+?) , (?:together|along) with ((?:the|an?|both|{_MANY}) [^,]+?) , ({MUST} .+)$", "{1} and {2} {3}"),
    (f"^in addition to (the [^,]+?) , (the [^,]+?) ({MUST} .+)$", "{1} and {2} {3}"),
    ("\\b((?:spell(?:ed)?|write|show|word|equation|sum)\\b[^,]*?)(?: ,)?(?: with)? (?:each|every) (?:letter|symbol|"
     f"digit|sign) (?:being |is )?on (?:its own|a separate|one) {CUBE}$", "{1}"),
    (f"^(.+?) ({MUST}) not (be \\w+ .+?) until (.+? (?:has|have) been .+)$", "{1} {2} {3} , but only after {4}"),
    ("^in a first step(?: ,)? (.+?)(?: ,)? (?:and )?(?:then )?in a second step(?: ,)? (.+)$",
     "first , {1} . then , {2}"),
    ("^in a first step(?: ,)? (.+)$", "first , {1}"),
    ("^in a (?:second|third|further|next|last|final) step(?: ,)? (.+)$", "then , {1}"),
    ("\\b(?:on|to|at) whose (left|right)(?: side)?\\b", "to the {1} of which"),
    ("\\b(?:arithmetically|mathematically) (?:correct|true|valid|right)\\b", "correct"),
    ("^(.*\\bnever\\b.*?)(?: ,)? while (?:this is (?:being )?done|this happens|doing so|doing this)$", "{1}"),
    ("\\b(exactly .+?) , (?:neither|no) more (?:nor|and no|or|and not) (?:fewer|less)(?: ,)?", "{1}"),
    ("\\b(come|comes) to (?:rest|lie|stand)\\b", "end up"),
    (f"^(.+?) (in \\w+ order ,? ?(?:beginning|starting) with .+?) , ({MUST} be (?:made|formed|built) (?:of|from) .+)$",
     "{1} {3} {2}"),
    ("\\b(be (?:formed|made|built|laid)) (?:of|from|out of) (.+ in the center and .+ around it)$", "{1} with {2}"),
    ("\\ban? (row|line|column) (?:that|which) (?:decreases|descends|falls)\\b", "a descending {1}"),
    ("\\ban? (row|line|column) (?:that|which) (?:increases|ascends)\\b(?= from )", "an ascending {1}"),
    (f"^({_MANY} [^,]+?) ({MUST}) be (?:divided|distributed|split|placed|arranged) so that (?:exactly )?(one|{_MANY}) "
     f"(?:is|are|lie) (on .+?) and (?:exactly )?(one|{_MANY}) (?:is|are|lie)? ?(on .+)$",
     "{3} of {1} {2} be {4} and the other {5} {6}"),
    ("\\b(rearrange|reorder|arrange) the (?:row|line) so that it reads\\b", "{1} them so that they read"),
    (f"^given that (.+?) initially (.+?) , (.+ {MUST} .+)$", "at the start , {1} {2} . {3}"),
)  # fmt: skip
"""Turns of phrase that are read wrongly, or not at all, where they stand."""
SPECIFIED: tuple[Turn, ...] = (
    # what is asked for
    ("^the (?:task|goal|goal state|target|test|objective) (?:shall be|must be|is) (?:deemed |considered |regarded as "
     ")?(?:reached|complete|completed|achieved|fulfilled|met|passed|done|successful)(?: only)? (?:when|once|if|as soon "
     "as) (.+)$", "{1}"),
    ("^care (?:shall|must|should|is to) be taken (?:that|to ensure that) (.+)$", "{1}"),
    (f"^(.+?) ({MUST} (?!not |never ).+?) , (?:as|and so) {MUST} (the .+)$", "{1} and {3} {2}"),
    (f"^(.+ {CUBE}s?) (?:standing |lying |located |placed |resting )?(on the [^,]+?) ({MUST} be {_MOVED} .+)$",
     "{1} , which starts {2} , {3}"),
    ("^(?:it shall be the case|it shall be so|it shall hold) that (.+)$", "{1}"),
    ("^(?:all of )?the following(?: conditions| requirements)? (?:shall|must|should)(?: all)? (?:hold|apply|be met|be "
     "satisfied|be fulfilled)(?: at the end)? : (.+)$", "{1}"),
    ("^(.+?) having been (.+?) , (.+)$", "after {1} has been {2} , {3}"),
    # what there is besides
    ("^(.+?)(?: ,)? there being (.+?)(?: in all| in total| altogether)?$", "{1} . there are {2}"),
    (f"^there being ({_MANY} [^,]+) , (.+)$", "there are {1} . {2}"),
    ("^(.+?)(?: ,)? in the presence of (.+)$", "{1} . there are {2}"),
    (f"^(the [^,]+?) ({MUST} be .+?) ,(?: and)? no other {CUBE} (?:being|is|{MUST} be) (?:moved|touched|displaced)$",
     "{1} {2} . all blocks except {1} shall stay where they are"),
    (f"^the order of (?:the {CUBE}s (?:in|of) )?the ({_LINE})(?: ,)? ({WAY})(?: ,)? ({MUST}) be (.+)$",
     "the {1} {3} be , {2} : {4}"),
    (f"^the stacking order(?: ,)? ({WAY})(?: ,)? ({MUST}) be (.+)$", "the tower {2} be , {1} : {3}"),
    ("\\bin such a (?:manner|fashion) that\\b", "so that"),
    # relative clauses
    (f"(?:, )?the (center|middle|base|top|bottom) of which {_IS}\\b", "whose {1} is"),
    (f"(?:, )?the (base|top|bottom) of which (?:consists|consist|{MUST} consist) of\\b", "whose {1} consists of"),
    (f"^(.+?) {MUST} (?:be|form|make) the (top|base|bottom) of (an? \\w+) whose (.+)$",
     "{3} whose {2} is {1} and whose {4} shall be built"),
    (f", each of which {_IS}\\b", ", each"),
    (f"^(.+?) , (?:which|that) ({MUST} [^,]+) , ({MUST} .+)$", "{1} {2} and {3}"),
    (f"^(.+?)(?: ,)? (?:which|that) (start|begin)(?: out)? (as an?|as one|in an?|in one) ({_LINE})(?: ,)? ({MUST} .+)$",
     "{1} {2} {3} {4} . they {5}"),
    (f"(?:, )?whose (?:order|{CUBE}s)(?: {_IS} ,)? ({WAY}) (?:is|reads|{MUST} be|{MUST} read|[:,]) (.+)$",
     "in the order {2} {1}"),
    ("(?:, )?(?:whose (?:edges?|edge length|side length) (?:is|are|measures?)|(?:which|that) (?:has|have) an edge(?: "
     f"length)? of) ({_CM})(?: long)?(?: ,)?", "with an edge of {1}"),
    (f"\\b({_LINE}(?: of (?:\\w+ ){{1,3}}{CUBE}s)?)(?: ,)? (?:that|which) (?:runs|goes|extends|leads) ({WAY})",
     "{1} {2}"),
    (f"^(.*?)\\b((?:(?!the |every |each )\\w+ )?)({_THINGS}) , of which there (?:are|is) ({_MANY})(?: in all| in total|"
     " altogether)?(?: ,)?( .+)?$", "{1} {2} {3} {5} . there are {4} {2} {3s}"),
    (f"^(.+) the ((?:\\w+ )?)({_THING}) , ({_BESIDE}) which (.+?) ({MUST} {_STAND})( on the table)?$",
     "{1} the {2} {3} . {5} {6} {7} {4} the {2} {3}"),
    (f"^(.+ {MUST} be (?:built|formed|made|erected)) , ({_BESIDE}) which (.+?) ({MUST} {_STAND})( on the table)?$",
     "{1} . {3} {4} {5} {2} it"),
    (f"^(.+ {MUST} (?:be|stand|lie)(?: \\w+ed| put)? on) the same (?:patch|mat|zone|target)(?: ,)? (?:which|that) "
     "(?:may|can|must|shall|should) be(?: either)? (.+) or (.+)$", "{1} {2} or {1} {3}"),
    (f"(?:, )?(?:of which|whereof) the (\\w+)(?: one| {CUBE})? (?:{_IS}|{MUST} stand|{MUST} lie|stands|lies) (at the "
     "(?:bottom|top|left|right|front|back)|on top|in the middle|leftmost|rightmost)$", "with the {1} one {2}"),
    (f", the ({_SIDED}) (?:{CUBE}s )?of which {_IS} (\\w+) and the ({_SIDED}) (?:{CUBE}s )?(?:of which )?(?:{_IS} "
     ")?(\\w+)$", ", the {1} being {2} and the {3} {4}"),
    (" , (?:originally|initially) (?:located |placed |standing |lying |situated |positioned |resting )?((?:on|next to|"
     "to the|in front|behind) [^,]+?) ,", ", which starts {1} ,"),
    (f"^(.+?) ({MUST} (?:lie|stand|be|be placed|be put)) (to the left|to the right|in front) , and (.+?) (to the left|"
     "to the right|in front) , of (.+)$", "{1} {2} {3} of {6} and {4} {5} of {6}"),
    (f"(?:, )?the (corners|edges) of which {_IS} (\\w+)(?: and the (?:other|remaining) blocks(?: of which)?(?: {_IS})? "
     "(\\w+))$", "whose {1} are {2} and whose other blocks are {3}"),
    # what there is
    (f"^the height of the (tower|stack|wall|pyramid) ({MUST} be .+ {CUBE}s)$", "the {1} {2} high"),
    (f"^the number of ((?:\\w+ )?{CUBE}s) (on .+?) ({MUST} be) ((?:exactly |at least |at most ){_MANY})$",
     "there {3} {4} {1} {2}"),
    (f"^the number of ((?:\\w+ )?{CUBE}s) (on .+?) ({MUST} be) ({_MANY})$", "there {3} exactly {4} {1} {2}"),
    (f"^the number of ((?:\\w+ )?{CUBE}s) in the ({_LINE}) ({MUST}) be ((?:exactly |at least )?{_MANY})$",
     "the {2} {3} consist of {4} {1}"),
    (f"^the grid ({MUST}) (?:consist of|comprise|have) ({_MANY} rows) of ({_MANY}) {CUBE}s(?: each)?$",
     "a grid of {2} and {3} columns {1} be built"),
    # what is said aside
    ("^(?:it is|it shall be) assumed that (.+?) (?:initially )?(lies|stands|is|are|lie|stand|rests|rest) (.+)$",
     "at the start , {1} {2} {3}"),
    ("^with (.+?) (?:left|being|kept) (?:empty|free|clear) , (.+)$", "{1} must be empty . {2}"),
    ("^(.+) , with (the [^,]+?) (?:left|being|kept) (?:empty|free|clear)$", "{1} . {2} must be empty"),
    ("^with (.+?) (?:remaining|staying|being kept) (on .+?|in .+?|where it is) , (.+)$", "{1} must remain {2} . {3}"),
    (f"^(.+?) , ({WAY}) , ((?:of|from|out of) .+)$", "{2} , {1} {3}"),
    (f"^(.*{MUST}) (?:read|be|show) , ({WAY}) [:,] (.+)$", "{1} be , {2} : {3}"),
    (f"^(.+ {MUST}) first (be \\w+|stand|lie|sit|go) (.+?) (?:and|, and|,) {_THEN}(?: {MUST} be \\w+| be \\w+)? (.+)$",
     "{1} {2} first {3} and then {4}"),
    ("^(.+?)(?: ,)? (?:provided|on condition|on the condition|under the condition) that (.+?) (has|have) (?:first |"
     "previously |already |before )?been (.+)$", "{1} , but only after {2} {3} been {4}"),
    ("(?:, )?except that\\b", ", but"),
    (", during which\\b", ", and"),
    (f"^(?:it|he|she) {MUST} (?:not|never) ((?:move|place|put|lift|displace|shift|push|stack) .+)$", "do not {1}"),
    ("\\bbetween (?:neighboring|adjacent) faces\\b", "between neighboring blocks"),
    (f"\\b({MUST}) not exceed\\b", "{1} be at most"),
    (f"\\b({MUST}) not (?:fall below|be less than)\\b", "{1} be at least"),
    # structures
    (f"^(.+?) (?:consisting of|comprising|composed of) , ({WAY}) , (.+)$", "{2} , {1} of {3}"),
    (f"\\b({MUST}) comprise\\b", "{1} consist of"),
    ("\\bcomprising\\b", "consisting of"),
    (f", of which (one|{_MANY}) (?:is|are|{MUST} be) (\\w+) and (one|{_MANY}) (?:(?:is|are|{MUST} be) )?(\\w+)",
     ", {1} {2} and {3} {4}"),
    ("\\bthe (row|column|layer) (?:on|at|in) the (front|back|left|right|top|bottom|middle|center)\\b(?! of)",
     "the {2} {1}"),
    ("\\bthe (row|column|layer) in (front)\\b(?! of)", "the {2} {1}"),
    ("\\bthe (layer) on (top)\\b(?! of)", "the {2} {1}"),
    (f"\\b(a|the|one) (?:cuboid|prism)(?: grid| arrangement)? (of {_MANY} (?:rows|columns|layers))", "{1} grid {2}"),
    (f"(?:, )?so that each side (?:counts|has|consists of|contains) ({_MANY}) {CUBE}s(?: and (?:that )?the (?:center|"
     "middle|inside|interior) is (?:left )?(?:empty|free|hollow))?", "with {1} blocks per side"),
    ("\\b(equation)(?: ,)? (?:all (?:of them|of these) being used|with all of them used|using all of them)$", "{1}"),
    ("\\bbe left standing with\\b", "stand with"),
)  # fmt: skip
"""What makes no sense as it stands, in an order of words that does."""
REQUIRED_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b(?:so|such) that the (?:word|number) (\\S+) (?:is|can be|{MUST} be) (?:shown|displayed|seen|formed)\\b",
     "so that they read {1}"),
    ("\\b(?:so|such) that the (?:word|number) (\\S+) (?:appears|results|is obtained)\\b", "so that they read {1}"),
    # what there is
    (f"^(?:the )?following ({CUBE}s) (?:are|will be) (?:required|needed|necessary|available|given|provided|present|"
     "used|there)(?: for this)? : (.+)$", "there are {2}"),
    (f"\\b(of|all|both|none of|each of) (?:the )?(?:said|aforesaid|aforementioned) ({CUBE}s)\\b", "{1} the {2}"),
    (f"\\b(no two [^,]+?) (?:are|be|{MUST} be) in contact(?: with each other| with one another)?$", "{1} touch"),
    ("\\b(?:hereinafter|hereafter|henceforth) (?:named|called|referred to as)\\b", "named"),
    ("\\b(?:pairwise|mutually) (?:distinct|different)\\b", "different"),
    # what is left open
    ("(?: ,)? (?:the )?colors? (?:do not matter|does not matter|(?:is |are |being )?(?:immaterial|irrelevant|"
     "unimportant|of no (?:importance|matter)))(?: to (?:me|us))?(?: at all)?$", ""),
    (f"^the order of the (?:{CUBE}s|letters|digits|numbers) ({MUST}) be (.+?)(?: ,)? (?:when|as|if) (?:read |seen |"
     f"viewed )?({WAY})$", "the blocks {1} be in the order {2} {3}"),
    (f"^(the [^,]+?) and either (the [^,]+?) or (the [^,]+?)(?: ,)? but not both(?: ,)? ({MUST} be [^,]+)$",
     "{1} {4} . either {2} or {3} {4} , but not both"),
    ("^it is (?:needed|necessary|required|important) to (?=\\w+ )", ""),
    ("^(?:assert|verify|check)(?: that)? (?=.+\\b(?:above|below|on|behind|in|next|left|right|under)\\b)", ""),
    # how it begins
    *(("^(?:randomi[sz]e|shuffle|scramble) (?:the )?(?:start|beginning|starting positions?|initial (?:state|"
       f"positions?|arrangement|configuration)){end}", said) for end, said in (("$", ""), (" : ", "start :"))),
    ("^(initially|at the start|at the beginning)(.*?) (?:stands?|lies?|sits?|is|rests?) (?:alone|by itself|on its own) "
     "(on the table)\\b", "{1} {2} is {3}"),
    (f"^given (an? [^,]*?{TOWER} (?:with|of) [^,]+) , (?:invert|reverse|flip|turn)(?: over)? it(?: over)? (?:such|so) "
     "that (.+)$", "there is {1} . at the end {2}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
REQUIRED: tuple[Turn, ...] = (
    # parts told by "of which"
    (f"(?: ,)? the width of which {MUST} be ({MANY}) {CUBE}s? and the height of which {MUST} be ({MANY}) {CUBE}s?$",
     " {1} blocks wide and {2} blocks high"),
    (f"(?: ,)? the ({_ROW}) (row|layer) of which {MUST} (?:consist of|be formed of) (.+?) and the ({_ROW}) \\2 of "
     f"which {MUST} (?:consist of|be formed of) (.+)$", " with {3} in the {1} {2} and {5} in the {4} {2}"),
    (f"(?: ,)? the lower {CUBE} of which {MUST} be ({COLOR}) and the upper {CUBE} of which {MUST} be ({COLOR})$",
     " with {1} at the bottom and {2} on top"),
    (f"^there {MUST} be ({MANY}) ([^,]+?) , of which ((?:at least|at most|exactly|no more than|no fewer than) {MANY}) "
     f"({MUST} be .+)$", "{3} of the {1} {2} {4}"),
    (f"^(.+ )(the {COLOR} {CUBE}) , which ({MUST} (?:be (?:located|placed|put)|stand|lie) .+)$", "{1} {2} . {2} {3}"),
    # what is left open
    (f"(?: ,)? (?:the order of which (?:is|being|{MUST} be) {_FREE}|no particular order being (?:required|"
     "prescribed))$", " , in any order"),
    (f"(?: ,)? (?:whereas|while|and) the order of the (?:remaining blocks|others|rest) is {_FREE}$", ""),
    # with what it is done
    ("^by means of (?:the )?(?:letter|digit|symbol) (?:cubes|blocks) , (.+)$", "{1}"),
    ("(?: ,)? by means of (?:letter|digit|symbol) (?:cubes|blocks)$", ""),
    (f"\\ban? ({COLOR} {CUBE}) having an edge length of ({LENGTH})", "a {2} {1}"),
    # what is exchanged and turned
    (f"^the positions? of (the [^,]+?) and (?:the position )?of (the [^,]+?) {MUST} be (?:exchanged|swapped|"
     "interchanged)$", "{1} and {2} must swap places"),
    (f"^(an? {LINE}|three .+? stacked|.+? {MUST} be stacked) such that the lowest of them rests on (the .+)$",
     "{1} on {2}"),
    # what is required
    (f"^(an? {LINE}\\b.+|an? \\w+ {LINE}\\b.+?) (?:is|are) (?:both )?{_WANTED}(?:$| , (.+)$)", "{1} , {2}"),
    (f"^(.+?) (?:is|are) (?:both |all )?{_WANTED} (on|in|behind|next to|under|in front of|to the) (.+)$",
     "{1} must be {2} {3}"),
    ("\\b(?:is|are) (?:required|supposed|expected|meant|obliged) to (be|sit|stand|lie|rest|go|touch|form|end)\\b",
     "must {1}"),
    # what is there besides
    ("^with (.+?) (?:present |there |around )?(?:only )?as (?:a )?distractors?(?: ,)? (.+)$",
     "{2} . {1} are distractors"),
    # what is where
    ("\\b(which|that|and \\w+|and the \\w+ one) in turn (is|rests|stands|sits|lies|must|should)\\b", "{1} {2}"),
    ("(?: ,)? on (?:whatever|whichever) side(?: ,|$)", ","),
    (f"^with (the .+?) on one side and (the .+?) on the other(?: side)? , (the .+?) (?:is|{MUST} be) between them$",
     "{3} must be between {1} and {2}"),
    (f"^each corner(?: of the table)? (?:is occupied by|holds|contains|gets) one of the four (\\w+) {CUBE}s$",
     "a {1} block must be in each corner of the table"),
    (f"^(.+?) , which (?:are|is) (stacked|in an? (?:heap|tower|row)) at the start , ({MUST} .+)$",
     "{1} start {2} . they {3}"),
    # what is done
    ("\\b(?:have|has) exchanged (?:their )?(?:places|positions)\\b", "must swap places"),
    # symbols
    (f"^the {_SYMBOL} (\\w) on (?:the )?top(?: face)? of its {CUBE} (.+)$", "the block {1} {2}"),
    (f"^the {_SYMBOL} on (?:the )?top(?: face)? of the ({CUBE} \\w) (.+)$", "the {1} {2}"),
    # what is there, and how it begins
    (f"^spawn ({MANY} [^,]+?) (in an? (?:heap|pile|row|line|tower|stack)|on the [^,]+)(?= ,|$)", "{1} start {2}"),
    ("^(.*\\b(?:dismantle|unstack|take apart|disassemble|take down|break up)\\b [^,]+?) , (?:placing|putting|laying|"
     f"setting) (?:each|all|every one)(?: one| of them| {CUBE}| of its {CUBE}s)? (?:down )?(?:on|onto) the table(?= ,)",
     "{1}"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read, and what is said instead."""
WORDS = (
    "arithmetically ascends assumed care centrally comprise comprising considered cuboid decreases deemed descends "
    "exceed exchanged falls fashion increases located manner marks mathematically obliged occupied immaterial "
    "irrelevant unimportant importance assert verify needed necessary said aforesaid aforementioned hereinafter "
    "hereafter henceforth pairwise mutually distinct dismantle randomize randomise shuffle scramble spawn invert "
    "contact prescribed presence previously prism regarded requested required settled situated termination whatever "
    "whereas whereof whichever",
)
"""Words that these take besides those that are read anyway."""
