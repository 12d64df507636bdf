"""Sentences that say in a roundabout way what a plainer one says, as rows that turn them into it; they are tried where
a sentence cannot be read as it stands."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import FEW, LENGTH, LINE, MANY, MUST, NO_NUMBER, WAY

_IS = f"(?:is|are|{MUST} be|stands|stand|lies|lie|sits|sit)"
_SIDED = "(?:upper|top|lower|bottom|left|right|front|back)"
_BLOCK = "(?:block|cube|brick|one)"
_PATCH = "(?:patch|mat|zone|target|area|spot)"
_CLIMBS = "(?:climbs|rises|ascends|goes up)"
_STARTED = (
    "(?:where (?:it|they|each) (?:starts|start|started|is now|are now|was|began|begins)"
    "|its (?:starting|original|initial) (?:place|position|spot|location))"
)

ROUNDABOUT_AT_ONCE: tuple[Turn, ...] = (
    (f"^(need|want|require) ((?:the|an?|{FEW}|all|both) .+)$", "i {1} {2}"),
    ("(?: ,)? so that there is (?:one|a) (tower|stack) (?:per|for each) color$", "in one {1} per color"),
    (f"^in an? ({LINE}) (with|of) (.+) , ((?:swap|exchange|switch|turn|move|take) .+)$",
     "there is a {1} {2} {3} . {4}"),
    (f"(?: ,)?(?: and)? each of (?:which|them) (?:has|contains|consists of|{MUST} have|is made of) (?:exactly |just "
     f")?((?:{FEW}) (?:\\w+ )?{_BLOCK}s)$", " with {1} each"),
    (f"^(an? stair(?:case|s|way) .+?) {_CLIMBS} to the (left|right|back|front) and (?:is|{MUST} be) (?:made|built) "
     "(?:of|from) (.+)$", "{1} made of {3} , rising to the {2}"),
    ("^(.+?) (starts?|begins?) (in a (?:heap|pile|tower|row|stack)) and (?:is|are) to be (.+)$",
     "{1} {2} {3} and must be {4}"),
    ("\\b(?:the |a )?letter (?:- )?(\\w) shape\\b", "a {1} shape"),
    ("\\b((?:equation|sum) \\S.*?)(?: ,)?(?: written| laid| spelled)?(?: out)? in (?:number |digit )?(?:cubes|blocks)$",
     "{1}"),
    ("(?:so|such) that (\\S+) (?:can be read|is read|reads) (downwards|upwards|from .+)$", "so that they read {1} {2}"),
    ("^remove (?:it|them|the .+?) so that (the .+?) (?:is|becomes) (?:empty|clear|free)$", "{1} must be empty"),
    (f"^(.+?) that (?:are|is) (stacked|in an? (?:heap|pile|tower|row)) at the start ({MUST} .+)$",
     "{1} start {2} . they {3}"),
    ("^do not stack (?:anything|any(?: of them| blocks| block)?)(?: ,)? (?:but |just |only |instead )+(.+ in an? "
     "(?:row|line|column)\\b.*|.+ side by side)$", "{1}"),
    ("^(.+?) touch(?: each other)? side by side( on the table)?$", "{1} are side by side and touch each other"),
    ("^(.+?)(?: ,)? (?:and |but )?not the other way (?:round|around)$", "{1}"),
    ("\\bnot there but (in|on|at|inside)\\b", "{1}"),
    (f"^(use|take) ([^,]+?) for ((?:an?|one) [^,]*\\b{LINE}\\b.*)$", "{1} {2} to build {3}"),
    ("^(?:in |create |build |make )?(an? [^,]*\\bgrid\\b[^,]*?)(?: ,| where| in which)+ the (rows|columns|layers)(?: "
     f",)? ({WAY})(?: ,)? (?:are|{MUST} be) (.+)$", "{1} whose {2} are {4} {3}"),
    (f"^(.+?)(?: {MUST})? (?:be|end up|end|finish|come to lie) at least ({LENGTH})(?: away)? from {_STARTED}$",
     "{1} must be moved by at least {2}"),
    (f"^(.+?)(?: {MUST})? (?:be|end up|end|finish) ({LENGTH}) or more(?: away)? from {_STARTED}$",
     "{1} must be moved by at least {2}"),
    (f"^([^,]+?) {_IS} at the left end of an? (row|line)(?: ,)? with (.+?) to its right$",
     "a {2} , from left to right : {1} , then {3}"),
    (f"^([^,]+?) {_IS} at the right end of an? (row|line)(?: ,)? with (.+?) to its left$",
     "a {2} , from right to left : {1} , then {3}"),
    ("^(?:center|put|place) (?:one|an?|the) (.+?) in (?:the middle of )?an? (row|line) with (.+?) on (?:either|each) "
     "side of it$", "a {2} of {3} , then a {1} , then {3}"),
    (f"^(?:the|an?) ([^,]+?) {_IS} in the middle of an? (row|line)(?: ,)? (?:and there are|with) (.+?) on (?:either|"
     "each) side of it$", "a {2} of {3} , then a {1} , then {3}"),
    ("^(?:in (?:my|the|this|a) (?:tower|stack) )?there are (.+?) between (the .+?) at the bottom and (the .+?) at the "
     "top$", "a tower , from bottom to top : {2} , then {1} , then {3}"),
    (f"\\ban? (\\w+) ({LINE}) of ((?:(?! and ).)+) and an? (\\w+) ({LINE}) (?:with|of) (?:just |exactly )?(?:as "
     f"many(?: blocks| "
     "cubes)?(?: as .+)?|the same (?:height|length|number of blocks))$", "a {1} {2} of {3} and a {4} {5} of {3}"),
    (f"\\ba (tower|stack) of ({FEW}) (\\w+) (blocks|cubes) and an equally (?:tall|high) (?:tower|stack) of (\\w+) "
     "(?:blocks|cubes)$", "a {1} of {2} {3} {4} and a {1} of {2} {5} {4}"),
    ("^(?:hoist|lift|take|raise) ([^,]+?) off the table and (?:rest|put|place|set|stack|lay) it (.+)$", "put {1} {2}"),
    ("\\b(of|from|beside|behind|to) (?:those|these) two$", "{1} them"),
    ("^there are ([^,]+?)(?: ,)? and each(?: one| of them)? (?:has|carries|gets) (an? .+?) on (?:top of it|it|top)$",
     "there are {1} . {2} must be on each of them"),
    ("^(?:a )?(?:vertical )?(?:stack|tower) (?:spelling|reading) (\\S+) , top first$",
     "a tower that reads {1} from top to bottom"),
    (f"\\b((?:numbers|digits) .+) in order ({WAY})(?: ,)? (?:starting|beginning) with the (?:smallest|lowest)$",
     "{1} in ascending order {2}"),
    (f"\\b((?:numbers|digits) .+) in order ({WAY})(?: ,)? (?:starting|beginning) with the (?:largest|biggest|highest)$",
     "{1} in descending order {2}"),
    ("\\b(?:(?:no|not) more(?: and| or| ,)* (?:no|not)|neither more (?:nor|or)) (?:fewer|less) than\\b", "exactly"),
    ("\\bno (?:fewer|less) than\\b", "at least"),
    ("^using (?:(?:just|only) )?(the .+?) , (spell \\S+)(.*)$", "{2} with {1} {3}"),
    (f"^(spell \\S+) on ((?:{FEW}) (?:letter )?(?:cubes|blocks))$", "{1} with {2}"),
    (f"\\b(the (?:{_SIDED} (?:{FEW})|(?:{FEW}) {_SIDED})(?: {_BLOCK}s)? \\w+)(?: ,)? and the {_SIDED} (?:ones|"
     f"{_BLOCK}s) (\\w+)$", "{1} and the others {2}"),
    ("(?: ,)? (?:which|that) itself (is|sits|stands|lies|rests|must|should)\\b", ", which {1}"),
    ("\\btower made of (an? .+?) with (an? .+?) on top$", "tower of {2} on {1}"),
    ("^((?:.+ )?(?:sort|sorted|separated?|split|divided?|grouped|group) .+?)(?: ,)? (?:so that there (?:is|are) (?:two "
     "groups|(?:a|one) group (?:of|for) each(?: kind| color)?|(?:a|one) group of \\w+ and (?:a|one|another) group of "
     "\\w+)|one (?:group|pile|bunch) (?:for|per) each(?: kind| of them)?)$", "{1}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

ROUNDABOUT: tuple[Turn, ...] = (
    (f"^it (?:is|must be|should be) ([^,]+?) (?:that|which|who) ({MUST} .+|(?:is|are|goes|ends|belongs|stands|has|"
     "carries|touches|lies) .+)$", "{1} {2}"),
    # ends of lines
    (f"^(an? .+?|one .+?) at (?:either|each) end of (?:the|an?) ({LINE}) and (.+?) (?:in )?between(?: them)?$",
     "a {2} of {3} with {1} at each end"),
    (f"^(?:the|an?) (.+?) (?:{_IS} )?at one end of (?:the|an?) ({LINE})(?: ,)? and (?:the|an?) (.+?) (?:{_IS} )?at "
     "the other(?: end)?(?: ,)? (?:with|and) (.+?) (?:in )?between(?: them)?$",
     "a {2} in the order a {1} , then {4} , then a {3} in either direction"),
    (f"^(?:cap|close|finish) both ends of (an? (?:row|line) of .+?) with (?:an? )?(.+ {_BLOCK})$",
     "{1} with a {2} at each end"),
    # grids
    (f"^the (rows|columns|layers) of (an? [^,]*\\bgrid\\b[^,]*?) (?:are|{MUST} be) (.+)$", "{2} whose {1} are {3}"),
    (f"^(an? [^,]*\\bgrid\\b[^,]*?) (?:has|{MUST} have) ((?:an? )?\\w+ (?:blocks|cubes) in the (?:.+))$", "{1} , {2}"),
    # gaps
    (f"(?: ,)? (?:(?:and )?(?:leave|with|leaving) )?(?:an? )?(?:gap of )?({LENGTH})(?: of (?:gap|space))? (?:in "
     f")?between (?:each|every|one)(?: {_BLOCK})? and the next(?: {_BLOCK})?$", "with gaps of {1}"),
    (f"^separate (.+?) from (.+?) by ({LENGTH})(?: , center to center| center to center)?$",
     "{1} and {2} must be {3} apart"),
    # numbers in order
    (f"^(.+?) count down ({WAY})( in an? (?:row|line))?$", "{1} in a row in descending order {2}"),
    (f"^(.+?) count up ({WAY})( in an? (?:row|line))?$", "{1} in a row in ascending order {2}"),
    ("\\binto (odd and even|even and odd|vowel and consonant|letter and digit|digit and letter) (?:groups|ones|piles|"
     "clusters|sets)\\b", "into {1}"),
    # as many
    (f"^({NO_NUMBER}\\b({MANY}) {NO_NUMBER})\\b(?:just |exactly )?(?:as many|the same number of|an equal number of) "
     "(?!of\\b|.*\\bas\\b)(.+)$", "{1} {2} {3}"),
    (f"^(?:share|distribute|divide|split|spread) ({FEW}) (.+?) (?:equally|evenly|fairly) (?:between|over|among|"
     f"across) (the .+? {_PATCH}) and (the .+)$", "put half of the {1} {2} on {3} and the other half on {4}"),
    # one relation in the words of another
    (f"^(the .+? {_PATCH}) is where (?:(?:i|we) (?:want|need|would like) (.+?)(?: to (?:be|go|end up|sit|stand|lie))?|"
     f"(.+?) (?:{MUST} (?:be|go|end up|sit|stand|lie)|goes|belongs|ends up|sits))$", "{2} {3} must be on {1}"),
    (f"^(.+? {_PATCH}) receives (.+)$", "{2} must be on {1}"),
    ("\\btouch(?:ing|es)? (?:its|their) neighbors?\\b", "touching each other"),
    ("\\bsandwich (.+?) between (.+?) (?:below|underneath) and (.+?) above$", "put {1} on {2} and {3} on {1}"),
    (f"\\bthe {_BLOCK} on which (.+?) (?:rests|sits|stands|lies|is placed|is|{MUST} be) (?:{MUST} be|is) (the "
     f"[^,]+?)(?=$| ,| and the {_BLOCK})", "{1} must be on {2}"),
    (f"\\bthe {_BLOCK} (?:(?:that|which) (?:carries|supports|holds|bears)|carrying|supporting|holding|bearing) (.+?) "
     f"(?:{MUST} be|is) (the [^,]+?)(?=$| ,| and the {_BLOCK})", "{2} must carry {1}"),
    (f"^(?:not )(the [^,]+?|\\w+) but (the [^,]+?|\\w+) ({MUST}) (.+)$", "{2} {3} {4} . {1} must not {4}"),
    (f"^(the [^,]+?|\\w+) , (?:and )?not (the [^,]+?|\\w+) , ({MUST}) ((?!not\\b).+)$",
     "{1} {3} {4} . {2} must not {4}"),
    (f"^only (the [^,]+?)(?: ,)? and neither (the [^,]+?) nor (the [^,]+?)(?: ,)? (?:is|{MUST} be)(?: to be)?(?: "
     "placed| put)? (.+)$", "{1} must be {4} . {2} must not be {4} . {3} must not be {4}"),
    ("^((?:(?:directly|right|immediately) )?(?:in front of|behind|next to|beside|on|on top of|under|to the left of|to "
     f"the right of) [^,]+?)(?: ,)? (an? [^,]+?) (?:is|can be|{MUST} be) (?:to be )?(?:found|seen|located|placed)$",
     "{1} is {2}"),
    (f"\\bthe top of (the [^,]+?) (?:is|remains|stays|{MUST} be) (?:clear|free|empty|uncovered)\\b",
     "nothing is on {1}"),
    (f"^({LENGTH}) is how far apart (.+?) (?:are|{MUST} be)$", "{2} must be {1} apart"),
    (f"^contact (?:is|{MUST} be) made between (.+?) and (.+?)(?: so that they touch)?$", "{1} must touch {2}"),
    (f"^(.+? and .+?) (?:{MUST} )?(?:make|be in) contact(?: with each other)?$", "{1} must touch each other"),
    ("^will (the .+? and .+?) (?:please )?(?:swap|change|trade|exchange|switch) (?:places|positions)$", "swap {1}"),
    ("^(an? .+?) tops (an? [^,]+)$", "{1} must be on {2}"),
    *((f"^(.+?)(?: (?:may|can|could|{MUST}) (?:be|stand|sit|lie|go))? (?:anywhere|everywhere)(?: ,)? (?:except|but|"
       f"other than|only not|just not)(?: for)? {there}$", f"{{1}} must not be {where}")
      for there, where in (("at the end", "at an end"), ("((?:on|at|in) .+)", "{2}"))),
    (f"^(.+?) , (?:which|that) (?:has|carries|bears) (.+?) on (?:it|top|top of it) , ({_IS} .+)$",
     "{2} must be on {1} and {1} {3}"),
    (f"^underneath (the [^,]+?) there {MUST} be ([^,]+?) , in direct contact$", "{2} must be directly under {1}"),
    ("^(.+) , stacked directly$", "{1}"),
    ("\\b(gets|get|be|are) grouped into\\b", "must be sorted into"),
    # what stays
    ("^(.+) , (?:and|but) ([^,]+?) (?:has|have) not (?:been )?moved$", "{1} without moving {2}"),
    ("\\bbut only after (.+?) (has|have) (?:gone|moved) (?:to|on) (.+)$", "but only after {1} {2} been put on {3}"),
    ("^(\\w+) (the .+?) from (the .+?) , where it (?:starts|begins|is|stands|lies)(?: now| at first)? , to (the .+)$",
     "{2} starts in {3} . {1} it to {4}"),
    # what comes with it
    (f"^(?:the following |these )?(?:(?:{FEW}) )?(?:conditions|requirements|rules|constraints)(?: must hold| must be "
     "met| hold| apply)? : (.+)$", "{1}"),
    ("^(?:type|print) (\\S+)(?: (?:in|with|out of) (?:letter )?(?:cubes|blocks))?$", "spell {1}"),
    ("^([^,]+?) (?:form|make up|make|build) (?:one|a) (tower|stack|row|column|group|pile)(?: ,)? (?:and|while) (.+?) "
     "(?:form|make up|make|build) another(?: one)?$", "{1} form a {2} . {3} form a {2}"),
    ("\\bin (?:exactly|precisely|just) (that|this) order\\b", "in {1} order"),
    (f"\\b(all|both) ({FEW}) of (?:my|your|our|the|these|those) (\\w+ {_BLOCK}s)\\b", "{1} {2} {3}"),
    (f"\\b((?:{FEW}) (?:\\w+ )?{_BLOCK}s) of (?:mine|ours|yours)\\b", "{1}"),
    ("^(?:move|shift|slide|push|bring|nudge) (the .+?|\\w+) (?:over|across|along)(?: ,)? so (?:that )?(?:it is|it 's) "
     "(.+)$", "put {1} {2}"),
    # structures
    (f"(?: ,)? whose base (?:is|has)(?: a row of)? ({FEW})(?: {_BLOCK}s)?(?: long| wide)?$", " with a base of {1}"),
    ("(?: ,)? so that (?:the|their) (?:order|colors) (?:is|are|follow|follows|match|matches) (?:that |those )?(?:of |"
     "like )?(?:the|a) rainbow$", " in rainbow order"),
    (f"\\bwhose width is ({FEW})(?: {_BLOCK}s)? and (?:whose|the) height is ({FEW})(?: {_BLOCK}s)?\\b",
     ", {1} wide and {2} high"),
    (f"\\b(?:descend|decrease|fall) ({WAY})\\b", "are in descending order {1}"),
    (f"\\b(?:ascend|increase|rise) ({WAY})\\b", "are in ascending order {1}"),
    (f"^({WAY})(?: ,)? the (?:digits|numbers) (?:go|run|count) down : (.+)$", "a row in descending order {1} : {2}"),
    (f"^({WAY})(?: ,)? the (?:digits|numbers) (?:go|run|count) up : (.+)$", "a row in ascending order {1} : {2}"),
    (f"\\b({LINE})(?: on the table)? that (?:is|reads|goes) , ({WAY}) , (.+)$", "{1} of {3} {2}"),
    ("^(.+?) going up in (?:a tower|a stack)$", "a tower , from bottom to top : {1}"),
    ("^(.+?) going down in (?:a tower|a stack)$", "a tower , from top to bottom : {1}"),
    (f"^the ({LINE}) on the (left|right) (?:has|consists of|is made of) (.+?)(?: ,)? (?:and|while) the {LINE} on the "
     "(?!\\2)(?:left|right) (?:has|consists of|is made of) (.+)$", "a {1} of {3} must be to the {2} of a {1} of {4}"),
    ("\\b(?:whose|the) (?:rows|columns|layers) are each of one color :", "; each row in one color :"),
    ("^(?:digit|number|letter) (?:cubes|blocks) (?:displaying|showing|spelling|reading) (\\S+)$", "spell {1}"),
    # what comes of it
    (f"^([^,]+?)(?: ,)? (?:which gives|which makes|giving|resulting in) ((?:{FEW}) .+)$", "{1} so that there are {2}"),
    # what there is
    ("^given (.+?) , ((?:make|build|put|sort|separate|stack|arrange|line|spell|form|lay|group) .+)$",
     "there are {1} . {2}"),
    ("^(.+?) (?:are|is) (?:given|available|provided) [:;,] (.+)$", "there are {1} . {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = (
    "conditions requirements rules constraints type print found seen lot mine tops contact receives climbs "
    "supporting displaying nearer available equally fairly",
)
"""Words that these take besides those that are read anyway."""
