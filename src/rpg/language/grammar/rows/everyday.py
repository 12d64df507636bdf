"""How people at home put it: what is added for good measure, "minimum three", "from the table up", "or more", as rows
that say it as others do."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import IS, LABEL, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LENGTH, LINE, MANY, MUST, PATCH

_BLOCKS = "(?:blocks|cubes|ones)"
_PEOPLE = (
    "(?:everyone|everybody|we|i|he|she|they|the (?:user|class|kids|children|pupils|students|kid|child|audience|viewer))"
)
_DEEP = "(?:near|far|front|back|rear)"
_ROW = "(?:far|near|front|back|first|second)"
_BLOCK = "(?:block|cube|blocks|cubes)"
_NTH = "(?:first|second|third|fourth|fifth|last)"
_SIZE = "(?:big|large|small|little)"
_MAT = "(?:mat|patch|zone|area|target)"
_PART = "(?:left|right|near|far|front|back)"
_PUT = "(?:put|place|set|lay|move|stack)"
_COMES = "(?: is| comes| goes)(?: the)?"
_AND = "(?: ,| and| , and)"
_C = f"(?:the )?({COLOR})(?: one| block)?"
_FAR_AND_NEAR = (
    f"{_C} is (?:the )?(?:farthest|furthest)(?: away)?(?: from me)?(?: ,| and| , and)+ {_C} (?:is )?(?:the "
    f")?(?:closest|nearest)(?: to me)?(?: ,| and| with)+ {_C}(?: is)? (?:in the middle|in between|between)"
)
_TWO_ENDS = f"(?:the )?({COLOR})(?: one| block| cube)? and (?:the )?({COLOR})(?: one| block| cube)?"
_ONE = f"(?:(?:the |an? )?{COLOR}(?: one| block| cube)?|the {LABEL}(?: block| cube)?|{LABEL})"

EVERYDAY_AT_ONCE: tuple[Turn, ...] = (
    # which block of a wall
    (f"^(.*\\bwall\\b.*)\\bthe ({_BLOCK}|one) (?:in|at) the (?:very )?(?:middle|center)(?: of it| of the wall)?(?= "
     f"is| {MUST}| ,|$)", "{1} the middle {2}"),
    # how many are used, told last
    (f"^(.*?)\\b(?:all )?(?:the )?({COLOR}) (blocks|cubes|bricks)\\b((?:(?!{MANY}).)*?)(?: ,)? use ({MANY})(?: of "
     "them| "
     "in all| in total)?$", "{1} {5} {2} {3} {4}"),
    (f"^(?:make |build )?an? ({LINE})(?: ,)? use ({MANY})(?: blocks| cubes)?$", "a {1} of {2} blocks"),
    (" but not (?:next to|beside|near|on|behind|touching|in|to) both(?= |$)", " but not both"),
    # how many, and of which size
    (f"\\b(?:two|2) ({COLOR}) {_BLOCK} [,(:] (?:one|an?) ({_SIZE})(?: one)?(?: , and| ,| and) (?:one|an?) ({_SIZE})(?: "
     "one)?(?: \\))?(?= ,| and|$)", "a {2} {1} block and a {3} {1} block"),
    (f"\\b(?:minimum|at minimum|at the minimum|a minimum of) ({MANY})\\b", "at least {1}"),
    (f"\\b(?:maximum|at maximum|at the maximum|a maximum of) ({MANY})\\b", "at most {1}"),
    (f"^((?:at least|at most) {MANY} .+) , (?:more|fewer|less) (?:is|are) (?:also |just as )?(?:fine|ok|okay|good)$",
     "{1}"),
    (f"^(?:out of|from|of) the ({MANY} [^,]+? {_BLOCKS})(?: ,)? ({_PUT}) ((?:exactly |at least |at most |only |just "
     f")?{MANY}) (on|in|onto|into) ", "{2} {3} of the {1} {4} "),
    (f"^(?:(?:in total|in all|altogether|overall) )?there (?:are|is) ({MANY} {COLOR}) ones?(?: (?:in total|in all|"
     "altogether|overall))?$", "there are {1} blocks"),
    (f"\\b({MANY}) (blocks|cubes) , ({COLOR}) ones(?=$| ,)", "{1} {3} {2}"),
    (f"^(?:in total|in all|altogether|overall)(?: ,)? there are ({MANY} (?:\\w+ )?(?:blocks|cubes))$", "there are {1}"),
    (f"^(.*?)\\b({MANY})( of them .+?) , exactly \\2 , (?:and )?(?:not|no) (?:more|fewer|less)(?: and not (?:more|"
     "fewer|less))?$", "{1} exactly {2} {3}"),
    # so many more of them on each of the mats behind
    *((f"\\b({MANY}|an?) ({COLOR}) ({_BLOCK}) on (the (?:{COLOR} |left |right )?{_MAT})(?: ,| and| , and) "
       f"{many}(?: more)? on the ((?:{COLOR}|left|right)) (?:one|{_MAT})(?= ,| and|$)",
       f"{{1}} {{2}} {{3}} on {{4}} and {said} on the {{{mark}}} patch")
      for many, said, mark in (("one", "one {2} block", 5), (f"({MANY})", "{5} {2} {3}", 6))),
    (f"^{_PUT} all ({MANY}) ({COLOR}) {_BLOCK} on the (?:mats|patches) , ({MANY}) on the ({COLOR})(?: one| mat)? and "
     f"(.+?) on the ({COLOR})(?: one| mat)?$",
     "of the {1} {2} blocks , {3} must be on the {4} mat and {5} on the {6} mat"),
    (f"^((?:at least |exactly |at most )?{MANY} of (the {MANY} [^,]+?) {MUST} be on [^,]+?) and none of (?:them|these) "
     "on (the .+)$", "{1} . none of {2} must be on {3}"),
    (f"^(.*?)({_PUT}) (?:them|all of them) (on .+?)(?: ,)? except (?:for )?(the [^,]+?) , which (?:{MUST} (?:be|go|"
     "lie)|go|goes|belong|belongs) (on .+)$", "{1} {2} them {3} except for {4} . {4} must be {5}"),
    (f"^(.*?)({_PUT}) (?:them|all of them) (on .+?)(?: ,)? except (?:for )?({MANY})(?: of them)? , which (?:{MUST} "
     "(?:be|go|lie)|go|goes|belong|belongs) (on .+)$", "{1} {2} all but {4} of them {3} . the others must be {5}"),
    (" , like(?: ,)?(?: at all| ever)?$", ""),
    *((f"\\b({MANY}) ((?:{COLOR} )?{_BLOCK}) {told}(?= (?:on|in|onto|into) |$| ,)", f"{bound} {{1}} {{2}}")
      for told, bound in (("(?:max|maximum|tops|at (?:the )?most)", "at most"),
                          ("(?:min|minimum|at (?:the )?least)", "at least"))),
    ("^(.*\\b(?:row|line|tower|stack|column|grid|square|rectangle|wall|pyramid|circle|ring|cube)\\b.*?) , only "
     f"({COLOR})(?: ones| blocks| cubes)?$", "{1} , all {2}"),
    ("\\bfilled in with\\b", "filled with"),
    ("^(.*(?: by |\\dx\\d|\\bgrid\\b|\\brows of\\b).*?)(?: ,)? (?:in |as )?(?:(?:an? )?single|(?:just |only )?one) "
     "layer(?: only| high)?$", "{1}"),
    ("(?: ,)? (?:leaving|with) (?:none|nothing|no block)(?: left)? over$", ""),
    (f"({THING}) (above|below) ({THING}) somewhere(?= ,| and|$)", "{1} somewhere {2} {3}"),
    (f"(^|, )other (?={COLOR} (?:block|cube|one) (?:is|goes|{MUST})\\b)", "{1} the other "),
    ("\\b(piles|groups|stacks|towers|bunches) that are (?:separated|separate|apart)(?: from (?:each other|one "
     "another))?(?= |$)",
     "separate {1}"),
    # "the pink block it should sit on the purple one"
    (f"^(?:so |well |now )?(the (?:\\w+ )?(?:block|cube|one))(?: ,)? it (?={MUST}\\b|goes|sits|belongs)", "{1} "),
    ("^(can|could) you like (?=[a-z])", "{1} you"),
    # "and a black one at the end": of the row
    (f"^((?:make |build |form )?an? (?:row|line) of {MANY} [^,:]+?)(?: ,)? and (an? (?:{COLOR} )?(?:block|cube|one)) "
     "at the end$", "{1} with {2} at the end"),
    # which of them it is
    (f"^(?:(put|make|set|place|have) )?(the two (?:blocks|cubes)) ([^,]+?) , the ({COLOR})(?: one)? and (?:the "
     f")?({COLOR})(?: one| block| cube)?$", "{1} the {4} and the {5} block {3}"),
    (f"^((?:{_PUT}|get|bring|can you {_PUT}|could you {_PUT}) [^,]+? and [^,]+) , both(?: of them)?$", "{1}"),
    (f"\\b(?:right |directly |immediately )next to ({THING}) on \\1 's (left|right)(?: side)?",
     "immediately to the {2} of {1}"),
    ("^([^,]+?) , both (?:of them )?(?:are |being )?(?:cubes|blocks)$", "{1}"),
    (f"^(?:(?:could|can) we )?(?:get |have |put |place |set )?(?:the )?two ({COLOR}) (blocks|cubes|ones) side by "
     "side(?: ,)? (?:with|and) (.+? on (?:top of )?the (?:left|right) one)$",
     "put two {1} blocks side by side and {3}"),
    ("\\b((?:gap|distance|space)(?: of [^,]+?)?) between the (?:two )?(?:towers|stacks|rows|groups|piles)$",
     "{1} between them"),
    ("\\bthe (left|right|upper|lower|top|bottom|front|back)(?: - hand| hand)? one of (?:them|these|the two|those)(?= |"
     "$)",
     "the {1} one"),
    ("^((?:exactly |only |just |at least |at most )?one of )(?:the )?two (?:blocks|cubes|letters|digits)(?: ,| :) "
     f"(?:either )?({THING}) (?:and|or) ({THING})(?: ,)? (?={MUST}|is|goes|belongs|on|in)", "{1} {2} and {3} "),
    ("^(?:exactly |only |just )?one of ((?:the )?(?:two )?[^,]+?)(?: ,)? (?:but|and) not (?:both|all)(?: of (?:them|"
     f"these))?(?: ,)? (?={MUST}|is|goes|belongs|on|in)", "exactly one of {1} "),
    # what is wanted
    (f"^((?:an?|one|{MANY}) (?:\\w+ )?(?:row|line|tower|stack|column|circle|square|pyramid|staircase|wall)s? of "
     "[^,]+?) (?:is|are) (?:needed|wanted|required|desired|called for)$", "{1}"),
    ("^any one of (.+?) ((?:on|in|behind|next to|left of|right of) .+?) (?:will do|is fine|is ok|is okay|is enough)$",
     "put one of {1} {2}"),
    (f"^(?:i|we) (?:need|want|would like)(?: to (?:see|have))? ((?:an?|{MANY}) [^,]+?) (?:that|which) (?!.*\\b(?:start|"
     "now|first|initially|beginning)\\b)(?:(?:are|is) )?(touch each other|touching each other)$", "{1} must be {2}"),
    (f"^((?:an?|{MANY}) [^,]+?) (?:that|which) (touch each other)$", "{1} must {2}"),
    # either of two is there
    (f"^either (.+?) ((?:is|are|goes|go|{MUST} (?:be|go)) (?:on|onto|in) the {PATCH})(?: ,)? or ((?:both|the|all)(?: "
     f"the)? {COLOR} (?:{_BLOCK}|ones))$", "either {1} {2} , or {3} {2}"),
    (f"^either ({THING}) (is|goes|stands|lies|{MUST} (?:be|go|stand|lie)) (on|onto|on top of|next to|beside|behind|in "
     f"front of|under|to the left of|to the right of) ({THING})(?: ,)? or ({THING})$", "{1} {2} {3} {4} or {5}"),
    # who is not
    ("^neither (.+?) nor (.+?) (?:may|can) (?:be )?moved?$", "{1} and {2} must stay where they are"),
    (f"^some of (.+?) ({MUST} be|are|is|{MUST} lie|{MUST} stand) (.+?)(?: ,)? but not all(?: of (?:them|these))?$",
     "some but not all of {1} {2} {3}"),
    ("\\b(touch(?:es)?|next to|near|beside|on) neither$", "{1} neither of them"),
    ("\\beverything (?=(?:except|but) the \\w+ (?:blocks|cubes|ones)\\b)", "all blocks "),
    # where it is not
    ("\\b(not) (?:to the )?(?:left|right)(?: of it)? but (?=(?:to the )?(?:left|right) of\\b)", ""),
    ("\\banywhere (?:else )?(?:but|except) there\\b", "not there"),
    (f"\\bin (?:an?|any|one|some)(?: of the)? corners?(?: of the table)?(?: ,)? (?:but|except|other than)(?: for)?(?: "
     f"not)?(?: in)? the ({_DEEP} (?:left|right)|(?:left|right) {_DEEP})(?: one| corner)?\\b",
     "in a corner and not in the {1} corner"),
    *((f"\\bin (?:one|any|either) of the (?:two )?({side}) corners(?: of the table)?\\b",
       f"in a corner and in the {half} half of the table")
      for side, half in (("near|front", "near"), ("far|back|rear", "far"), ("left", "left"), ("right", "right"))),
    (f"\\b(together|next to each other)(?: ,)? (?:and|but|with) ({THING}) (?:all )?(?:by itself|alone|on its own)$",
     "{1} , and {2} apart from them"),
    # nobody is no block
    ("\\bnobody (?=(?:is|sits|stands|lies|touches|(?:may|must|shall|should|can) (?:be|sit|stand|lie|go))\\b)",
     "no block "),
    ("\\b(nothing|everything|nobody) 's (?=(?:touching|on|in|next|under|behind|left|right|between|near)\\b)",
     "{1} is "),
    # with their like
    (f"\\b(the ({COLOR}) (?:{_BLOCK}|ones)|the ({COLOR})s) together with (?=the (?:\\2|\\3)(?:s| ones| {_BLOCK})\\b)",
     "{1} with "),
    ("(?:has|have|'s|'ve) got to (?=(?:be|go|stand|sit|lie|touch|rest|end|stay|form)\\b)", "must "),
    # measures
    (f"\\bby ({LENGTH}) or more\\b", "by at least {1}"),
    (f"(?: ,| and)* (?:(?:with|leave)(?: me| us)? )?(?:a )?(?:({LENGTH}) gaps?|gaps? of ({LENGTH})) (?:between each(?: "
     "one)? and the next(?: one)?|every time|each time)$", " with gaps of {1} {2}"),
    # from which end
    ("\\bfrom (?:the )?(?:(?:table|ground|floor) (?:up|upwards|to the top)|down (?:to )?up|below to above|bottom to "
     "up)\\b", "from bottom to top"),
    ("\\bfrom (?:up to down|above to below)\\b", "from top to bottom"),
    (f"^(?=.*\\b(?:towers?|stacks?|stacked|pile|layers?|levels?)\\b|.*\\b{_NTH}(?: {_BLOCK}| one| {_ROW})? from "
     "above)((?:.* )?)(?<!seen )(?<!viewed )(?<!looked at )(?<!looking )(?<!read )(?<!readable )(?<!visible "
     ")(?<!watched )from above(?= |$)", "{1} from the top"),
    ("^((?:please )?(?:stack|pile) [^:]+ (?:blocks|cubes|bricks|ones)) from the top$", "{1} , from the top"),
    ("\\b(touching (?:it|that|them)) from above\\b", "{1}"),
    (f"(?: [:,])? ({COLOR})(?: ones?)? (?:on the )?outside(?: ,)? (?:and )?(?:then )?({COLOR})(?: ones?)? (?:next to "
     f"(?:that|it|them|those)|inside (?:that|those)|next|further in)(?: ,)?(?: and)?(?: then)? ({COLOR})(?: one)? in "
     "the (?:middle|center)\\b", "in the order {1} , {2} , {3} , {2} , {1}"),
    ("\\b(in (?:a|one) (?:row|line)) that looks? the same from both (?:ends|sides)(?: ,)? (in the order)\\b",
     "{1} {2}"),
    # what is said once more
    (f"(?: ,)? so (?:that )?{_PEOPLE} can (?:all )?(?:see|follow|count) (?:it|them|the (?:order|word|colors|letters|"
     "numbers))(?: well| better| properly)?$", ""),
    ("^(.+? corner of the table) , so (?:four|4)(?: of them)?(?: in all)?$", "{1}"),
    ("(?: ,)? (?:and )?not where (?:it|he|she) is(?: right)?(?: now| at the moment| at present)?$", ""),
    # what there is besides
    ("^(.+?)(?: ,| and)? (there (?:is|are) (?:also )?[^,]+?)(?: ,)? but (?:you can )?(?:just )?(?:ignore|forget|"
     "disregard)(?: about)? (?:that|it|them|those)(?: ones?)?$", "{1} . {2} , ignore it"),
    # rows and towers told in parts
    ("(\\brow\\b.+?)(?: ,)? both(?: rows)? from left to right$", "{1}"),
    (f"\\b(in {MANY} (?:rows|lines)(?: of {MANY})?) , (?!with\\b)(.+? in the {_ROW} (?:row|one)\\b)", "{1} : {2}"),
    (f"\\b(in {MANY} (?:rows|lines)(?: of {MANY})?) , (?:the )?({_ROW}) row (?!of\\b)((?:(?!row\\b).)+?)(?: ,)? and "
     f"(?:the )?({_ROW}) row (.+?)(?= ,|$)", "{1} : {3} in the {2} row and {5} in the {4} row"),
    (f"^({MANY} {_BLOCKS} (?:on top of (?:each other|one another)|on each other|stacked)) , ({COLOR} (?:uppermost|on "
     "top|at the top|topmost|at the bottom|lowest) , .+)$", "{1} : {2}"),
    (f"^({MANY}) (in a (?:row|line|tower|stack|column|circle))\\b", "{1} blocks {2}"),
    (f"^(?:from|out of|with|using) the (?:cubes|blocks) ((?:\\w(?: ,)? )+and \\w) , ({_PUT} .+)$",
     "there are the blocks {1} . {2}"),
    (f"\\bas (?:tall|high|long|big) a ({LINE}|pillar) as (?:possible|(?:you|we|the robot) can|it gets|can be)(?: get| "
     "build| make| built| made)? (?:out of|from|with|of|using)\\b", "a {1} of"),
    ("\\b(?:at|with|in) equal (?:distances?|spacing|gaps|intervals|spaces?) (?:between (?:them|each other)|in "
     "between)\\b", "evenly spaced"),
    # where they are in the end, and at the start
    ("\\b(?:reaches|ends up at|gets to|arrives at) the ((?:far|near|back|front) (?:left|right) corner|(?:left|right) "
     "half|middle of the table)\\b", "is in the {1}"),
    ("\\b(stacked|up|there|table|other|patch|mat|heap|pile|row|one) when (?:(?:we|i|you) (?:arrive|come in|start|begin|"
     "get there)|the robot (?:arrives|comes in|starts|begins|gets there))\\b", "{1} at the start"),
    # what is asked
    ("^can (the [^,]+?) have (.+)$", "{1} should have {2}"),
    ("^first(?: ,)? you (\\w+) (.+?) , and (?:after|then|after that|afterwards)(?: ,)? you \\1 (.+)$",
     "first , {1} {2} , then {1} {3}"),
    # headings that the sentence says itself
    ("^(?:invert|reverse|unstack|restack|swap)(?: the \\w+)? : ((?:initially|start from|start with|at the start) .+? "
     f"(?:finally|then|end with|at the end|{MUST}) .+)$", "{1}"),
    ("^(.+?) with (?:digit|number|letter) and (?:operator|symbol|sign) (?:blocks|cubes)$", "{1}"),
    # one on the other
    (f"\\b({MANY}(?: {COLOR})? {_BLOCKS})(?: ,)? straight up\\b", "a tower of {1}"),
    (f"\\b({_BLOCKS}) , one (?:on|onto|over|above|atop) (?:the other|another)(?= ,|$)",
     "{1} , one on top of the other"),
    # the one of two that is told first tells where the other is
    *((f"^(?:{_PUT} )?({_ONE}) (?:(?:{MUST} )?(?:be|is|goes) )?(?:{there})(?: ,)?(?: and)? ({_ONE}) (?:(?:{MUST} "
       f")?(?:be|is|goes) )?((?:right |directly |immediately |just )?{beside}) (?:it|that|that one|the other one)$",
       "{2} must be {3} {1}")
      for there, beside in (("in (?:the )?front|at the front", "behind"),
                            ("behind|(?:in|at) the (?:back|rear)", "in front of"),
                            ("(?:on|to) the left", "(?:to the )?right of"),
                            ("(?:on|to) the right", "(?:to the )?left of"))),
    # so many, and of which it is not told where
    (f"^((?:a |the |one )?(?:rainbow |gradient )?{LINE}) , ({MANY})(?: {_BLOCKS}| of them)?$", "{1} of {2} blocks"),
    (f"^(.*\\bof the {MANY} (?:\\w+ )?{_BLOCKS}\\b.*?)(?: ,)?(?: and| but)? the (?:other|others|rest)(?: ones?)? "
     "(?:(?:is|are|stays?|remains?|may be|can be) (?:free|left free|wherever|optional|up to you)|does not matter|do "
     "not matter|goes anywhere|go anywhere)$",
     "{1}"),
    ("^(.*\\b(?:either|or)\\b.*?)(?: ,)? (?:and )?one(?: of them)? (?:is|'s|will be) (?:enough|sufficient|plenty|fine|"
     "okay)$", "{1}"),
    (f" , only (the {COLOR} (?:one|{_BLOCK})) ({MUST}|may|can) not ", " , but {1} {2} not "),
    (f"(?: please)? use (?:only )?({COLOR}) (block|cube)(?: only)?$", "use only {1} {2s}"),
    (f" , only ({COLOR}) (block|cube)(?: please)?$", " , only {1} {2s}"),
    ("^(.*\\b(?:digits|numbers|letters|blocks|cubes) \\w (?:to|through) \\w) , (?:omitting|leaving out|skipping|minus|"
     "excluding|leaving away) (?:the |the (?:digit|letter|number) )?(\\w)(?= ,|$)", "{1} , without the {2}"),
    (f"^(?:oh |and )*make it (?:all )?(one|a single) ({LINE}|circle)$", "put all the blocks in {1} {2}"),
    # where exactly
    (f"\\b(block|cube|one|it|them|{COLOR}) (?:dead )?center of (?=the table\\b)", "{1} in the center of "),
    ("\\b(?:smack|bang|slap|slap bang|smack dab|plumb|dead|right bang) in the (middle|center)\\b", "in the {1}"),
    ("^(?:please )?(?:spread(?: out)?|distribute|scatter) (.+?)(?: out)? (?:all )?(?:over|across|around|throughout) "
     "the table (?=.*\\b(?:touch|touching|touches|apart|cm)\\b)", "put {1} "),
    ("^(.*?\\b(?:move|push|shift|slide)\\b.+?)(?: just)? an? (?:bit|little|little bit|touch) ((?:to|towards) the \\w+|"
     f"away from me|towards me|left|right|back|forward)(?: ,)? (?:like|say|let us say) ({LENGTH})$",
     "{1} {2} by {3}"),
    (" , (?:would|will|could|can) you (?:please )?(?:, )?(?=and\\b)", ", "),
    (f"\\b(set|put|move|push|lay|place) ({THING}) (?:to|on) (?:one|the) side(?= and| ,|$)", "{1} {2} aside"),
    (f"\\bthe other ({MANY})(?: ,)? (?:which|that) are (?:all )?({COLOR})\\b", "the {1} {2} blocks"),
    (f"^(.*\\bthe (?:blocks|cubes)\\b[^,:]*) , ({MANY}) of them , (?:all )?({COLOR})(?: ones)?$", "{1} : {2} {3} "
     "blocks"),
    ("\\b(ascending|descending|increasing|decreasing|sorted|order)(?: ,)?(?: from)? l (?:to|→|-) r$",
     "{1} from left to right"),
    # how they differ in size and color
    (f"^(.+ {_BLOCKS}\\b[^,:]*?)(?: by (?:size|height))?(?: ,| with)* (?:the )?tallest(?: one)? (?:at|on|to) (?:the "
     ")?(left|right)(?: ,| and)+ (?:the )?shortest(?: one)? (?:at|on|to) (?:the )?(left|right)$",
     "{1} by size , largest at the {2} and smallest at the {3}"),
    (f"^(.+ {_BLOCKS}\\b[^,:]*?)(?: by (?:size|height))?(?: ,| with)* (?:the )?shortest(?: one)? (?:at|on|to) (?:the "
     ")?(left|right)(?: ,| and)+ (?:the )?tallest(?: one)? (?:at|on|to) (?:the )?(left|right)$",
     "{1} by size , smallest at the {2} and largest at the {3}"),
    (f"^((?:put|place|arrange|line up|set|lay)(?: out)? the (?:blocks|cubes)) in (?:the|an?) ({LINE})(?: ,| and|;)+ "
     f"(?:the|their) colors? (?:{MUST} )?(?:change|changes|changing|alternate|alternates|go|come|follow|are|be)(?: "
     "like this| as follows| in this order)? : (.+)$", "{1} in a {2} : {3}"),
    (f"\\b(square) , (?:with )?({LENGTH}) (?:sides?|edges?|a side|on a side|side length|edge length)$",
     "{1} with a side of {2}"),
    (f"^(?:make sure |ensure )?(?:that )?there (?:is|are|{MUST} be) at least one (?:block|cube) between {_TWO_ENDS} in "
     f"(?:the|an?) (row|line) of ({MANY})(?: {_BLOCKS})?$", "a {3} of {4} blocks , the {1} and the {2} one are not "
      "next to each other"),
    (f"\\b(?:in|on|at|to) (?:the )?(left|right)(?: side)? from (?=(?:the )?(?:{COLOR}|{LABEL})\\b)", "to the {1} of "),
    (f"^({_ONE}){_COMES} first{_AND} ({_ONE})(?:{_COMES}|(?: the)?) last{_AND} ({_ONE})(?:{_COMES})?(?: somewhere)?(?: "
     "in)? between$", "a row from left to right : {1} , {3} , {2}"),
    (f"^(?:i|we) (?:would|will) be (?:fine|okay|ok|content|satisfied|happy|good) with (?:any |an? )?({LINE}\\b.+)$",
     "i want a {1}"),
    (f" (?:as long as|provided(?: that)?|so long as) the (top|bottom)(?: one| block)? is ({COLOR})$", " with a {2} "
     "block at the {1}"),
    (f"^nothing (?:else )?(?:but|except(?: for)?|other than|besides|apart from) it ({MUST}|may|can) be (?=on|in|there)",
     "no other block {1} be "),
    (f"^(no other (?:block|cube|one|{_BLOCKS})) (?:is|are) (?:allowed|permitted) (?=on|in|there)", "{1} may be "),
    (f"^nothing (?:else )?(?:but|except(?: for)?|other than) (.+?) ({MUST}|may|can) be (?=on|in)",
     "only {1} {2} be "),
    (f"^(?:make |build |form )?({MANY}) pairs(?: of (?:blocks|cubes))?(?: ,| :)? each (?:of |being |consisting of |is "
     f")?(?:a|one) ({COLOR})(?: block| one)? (?:next to|beside|and|with) (?:a|one) ({COLOR})(?: block| one)?$",
     "put each of the {1} {2} blocks next to a {3} block of its own"),
    (f"^(?:pair up|pair|match|couple) (?:up )?(?:each|every|each of the|the) ({COLOR})(?: {_BLOCKS}| block| cube| one)?"
     f" with (?:an?|one|the|its) ({COLOR})(?: {_BLOCKS}| block| cube| one)?(?= ,|$)(?: , one each)?"
     "(?: , side by side)?", "put each {1} block next to its own {2} block"),
    (f"\\bmake two pairs(?: of blocks)?(?: ,| :)? ({COLOR}) (?:with|and) ({COLOR})(?: ,| and| , and)+ ({COLOR}) "
     f"(?:with|and) ({COLOR})$", "put {1} next to {2} and {3} next to {4}"),
    (f"\\b(row|line|tower|stack) of ({MANY})(?: {_BLOCKS})? , all different(?= ,|$)", "{1} of {2} blocks , all in "
     "different colors"),
    (f"^of (?:the )?({MANY}) (blocks|cubes)(?: ,)? ({_PUT}) (?:exactly )?half (on|in|onto) ", "{3} half of the {1} "
     "{2} {4} "),
    (f"^no (?:{LINE}|figure) , (?:please )?(?:just|simply|only) ", ""),
    (f"^(four (?:{COLOR} )?{_BLOCKS}.*|.* four (?:{COLOR} )?{_BLOCKS}.*) (?:in|into|at) the (?:four )?corners(?: of "
     "the table)?(?: ,)? one (?:per|in each|for each) corner$", "{1} in the four corners of the table"),
    ("\\b(?:in such way|(?<!in )such (?:a )?way) that\\b", "so that"),
    (f"\\bmine is ({COLOR})(?: ,| and| , and)+ yours (?:is )?({COLOR})\\b", "one {1} and one {2}"),
    (f"\\bleave (?:a bit of |a little |some )?(?:space|room) between ({THING}) and ({THING})(?: ,)? (?:say |about "
     ")?(?:the width of (?:a|one) block|(?:a|one) block wide|as wide as (?:a|one) block)$",
     "there must be a gap of one block between {1} and {2}"),
    (f"\\b(tower|stack|row|line|circle|column) (?:with|of|from|out of) (?:just |exactly )?(?:as many|(?:the same|an "
     f"equal) number of) ({COLOR})(?: {_BLOCKS})? (?:as|and) ({COLOR})(?: {_BLOCKS})?(?: ,| :) ({MANY})(?: {_BLOCKS})? "
     "(?:in total|in all|altogether|overall)$",
     "{1} of {4} blocks , half of them {2} and half of them {3}"),
    (f"^(?:pair up|pair) (?:the (?:blocks|cubes)|them)(?: ,| :)? ({COLOR}) (?:with|and) ({COLOR})(?: ,| and| , and)+ "
     f"({COLOR}) (?:with|and) ({COLOR})$", "put {1} next to {2} and {3} next to {4}"),
    (f"\\b((?:stack|pile up|line up|put|arrange|place) the (?:blocks|cubes)(?: up)?(?: in an? {LINE})?)(?: ,)? (?:so|"
     "such)(?: that)? (?:the|their) colors (?:go|run|alternate|read|come|follow|are)(?: ,| :)? ([^;:]+?) (from (?:the "
     ")?\\w+)(?: up| down)?$", "{1} {3} : {2}"),
    (f"^(?:the|my) ({COLOR} (?:block|cube|one)) (?:is|stands|lies) (?:now )?in the wrong (?:place|spot|position)$",
     "there is a {1}"),
    (f"^([^,]+?\\bnothing\\b[^,]+?|[^,]+?\\bno(?:thing| block)\\b[^,]+?) , (?:but )?((?:the|an?) {COLOR} (?:one|block|"
     "cube)) is on (?:it|top of it) (?:now|at the moment|right now|at present)$", "{1} . at the start {2} is on it"),
    (f"^(?:{_PUT} (?:them|(?:the )?(?:{MANY} )?{_BLOCKS}) (?:so|such) that )?{_FAR_AND_NEAR}$",
     "{1} must be behind {3} and {3} must be behind {2}"),
    ("^(?:i|we) (?:want|would like) to (?:read|see) (\\d(?: ,? ?(?:and )?\\d)+) (from left to right|from right to "
     "left)$",
     "a row {2} : {1}"),
    (f"^({_PUT}) an? (block|cube) (?:at|on) (each end|both ends) of (?:the|a) (row|line) of ([^,]+?)(?: ,)?(?: both(?: "
     f"of them)?| each)? ({COLOR})$", "{1} a {6} {2} at {3} of a {4} of {5}"),
    (f"\\b({MUST}) (?:not|never) , (?:at any (?:time|point|moment)|under any circumstances|at all times) , ",
     "{1} never "),
    (f"\\b({MUST}) , (?:at all times|at any time|throughout) , (?!not\\b)", "{1} always "),
    ("\\bso (?=the (?:sum|equation|calculation|addition) (?:is|comes out|works out) )", "so that "),
    (f"^(the [^,]+?|\\w+) (?:may|must|can|should|shall) (?:not|never) leave (the (?:table|{_MAT}|\\w+ {_MAT}))(?= ,|$)",
     "{1} must always be on {2}"),
    (f"\\bfrom (?:any|every|all|each) other (?:blocks?|cubes?|ones?) : ((?:(?:the )?{COLOR}(?: ,| and| , and)* "
     "?)+)$", "from {1}"),
    (f"^(.*?)\\bthe (blocks|cubes)\\b([^,:]*) , ({MANY}) of them(?= ,|$)", "{1} {4} {2} {3}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
_LEADING = ("that", "so", "if", "where", "and", "until", "unless", "since", "because", "when", "but", "while", "as",
            "or", "then", "like", "case")  # fmt: skip
_NOT_SO = "".join(f"(?<! {word})" for word in _LEADING)

EVERYDAY: tuple[Turn, ...] = (
    *((f"^{begun}({THINGS}) (?:{IS} )?(?:any|some)where (?:except|but|other than|(?:that|which) (?:is|'s) not) "
       f"({PLACE} .+)$", said)
      for begun, said in ((f"(?:please )?(?:{PUT} )?", "{1} must not be {2}"),
                          ("(.+?) , with ", "{1} . {2} must not be {3}"))),
    *(("^(?:please )?(?:spread|distribute)(?: out)? (.+?)(?: out)? (?:all )?(?:over|across|around|throughout) (?=the "
       f"{_PART} (?:half|side|part)\\b{told})", f"{how} {{1}} in ")
      for told, how in ((".*\\b(?:touch|touching|touches|next to|beside|apart|near|cm)\\b", "put"), ("", "spread"))),
    (f"^(.*\\b)(?:let|leave) ({THING})(?: to)? (?:be|alone)$", "{1} leave {2} where it is"),
    ("\\b(leave|keep) ([^,]+?) (?:lying|sitting|standing|resting) (?=(?:on|in|where)\\b)", "{1} {2} "),
    (f"^(.*\\b)let ({THING}) (?:be |stay )?(empty|free|clear)$", "{1} leave {2} {3}"),
    # without a stop in between
    (f"^((?:there (?:is|are) )?{MANY} [^,:;]*?{_BLOCKS}) (?:just |please |simply |now )?((?:{_PUT}|bunch|group|pile|"
     "line|sort|arrange) (?:them|these|those|all of them)\\b.*)$", "{1} , {2}"),
    (f"^((?:(?:can|could|would) you |please |just )?(?:{_PUT}|make|build|line|sort|swap|group|arrange|spell|pile) "
     f"[^,;:]+?){_NOT_SO} (there (?:is|are) (?:an?|only|\\d+|{FEW}) .+)$", "{1} . {2}"),
    # what it is about
    ("^(?:(?:well|so|hm|now|okay|i was thinking|i thought|you know)(?: ,)? )*what about (an? (?:.+ )?(?:tower|stack|"
     "row|line|circle|pyramid|wall|staircase|square)\\b.*)$", "build {1}"),
    ("^it (?:would|will) look (?:really |very |so )?(?:lovely|nice|great|pretty|good|beautiful|cool) if (.+)$", "{1}"),
    (f"^(.+) took turns (in an? {LINE}\\b.*)$", "{1} take turns {2}"),
    ("^it (?:has to|must|should|shall|needs to) be (made|built|formed|created|laid) (an? .+)$", "make {2}"),
    (f"\\bthe (block|cube) ({COLOR})\\b(?! (?:block|cube|one|patch|mat)\\b)", "the {2} {1}"),
    (f"\\bthe (?:blocks|cubes) ({COLOR})\\b(?! (?:block|cube|one|patch|mat|ones|blocks|and|,)\\b)", "the {1} blocks"),
    ("^(stack|line up|sort|pile up|put) whatever (?:is|lies) (?:there|on the table)(?= :| ,|$)", "{1} the blocks"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = (
    "dead smack bang slap dab plumb lovely look enough sufficient plenty min max tops minimum maximum upwards audience "
    "pupils save ground floor",
)
"""Words that these take besides those that are read anyway."""
