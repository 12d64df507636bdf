"""How people at home put it: what is added for good measure, "minimum three", "from the table up", "or more", as rows
that say it as others do."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import IS, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LENGTH, LINE, MANY, MUST

_BLOCKS = "(?:blocks|cubes|ones)"
_PEOPLE = "(?:everyone|everybody|we|i|they|the (?:class|kids|children|pupils|students|kid|child|audience|viewer))"
_ROW = "(?:far|near|front|back|first|second)"
_BLOCK = "(?:block|cube|blocks|cubes)"
_SIZE = "(?:big|large|small|little)"
_MAT = "(?:mat|patch|zone|area|target)"
_PART = "(?:left|right|near|far|front|back)"
_PUT = "(?:put|place|set|lay|move|stack)"

EVERYDAY_AT_ONCE: tuple[Turn, ...] = (
    # how many, and of which size
    (f"\\b(?:two|2) ({COLOR}) {_BLOCK} [,(:] (?:one|an?) ({_SIZE})(?: one)?(?: , and| ,| and) (?:one|an?) "
     f"({_SIZE})(?: one)?(?: \\))?(?= ,| and|$)", "a {2} {1} block and a {3} {1} block"),
    (f"\\b(?:minimum|at minimum|at the minimum|a minimum of) ({MANY})\\b", "at least {1}"),
    (f"\\b(?:maximum|at maximum|at the maximum|a maximum of) ({MANY})\\b", "at most {1}"),
    (f"^((?:at least|at most) {MANY} .+) , (?:more|fewer|less) (?:is|are) (?:also |just as )?(?:fine|ok|okay|good)$",
     "{1}"),
    (f"^(?:out of|from|of) the ({MANY} [^,]+? {_BLOCKS})(?: ,)? ({_PUT}) ((?:exactly |at least |at most |only |just "
     f")?{MANY}) (on|in|onto|into) ", "{2} {3} of the {1} {4} "),
    (f"^(?:(?:in total|in all|altogether|overall) )?there (?:are|is) ({MANY} {COLOR}) ones?(?: (?:in total|in all|"
     f"altogether|overall))?$", "there are {1} blocks"),
    (f"\\b({MANY}) (blocks|cubes) , ({COLOR}) ones(?=$| ,)", "{1} {3} {2}"),
    (f"^(?:in total|in all|altogether|overall)(?: ,)? there are ({MANY} (?:\\w+ )?(?:blocks|cubes))$", "there are {1}"),
    (f"^(.*?)\\b({MANY})( of them .+?) , exactly \\2 , (?:and )?(?:not|no) (?:more|fewer|less)(?: and not (?:more|"
     "fewer|less))?$", "{1} exactly {2} {3}"),
    (f"^(.*?\\b{MANY}) ({COLOR}) ({_BLOCK}) on (the [^,]+? {_MAT})(?: ,)? and one(?: more)? on (the [^,]+? {_MAT})$",
     "{1} {2} {3} on {4} and one {2} block on {5}"),
    (f"^(.*?\\b{MANY}) ({COLOR}) ({_BLOCK}) on (the [^,]+? {_MAT})(?: ,)? and ({MANY})(?: more)? on (the [^,]+? "
     f"{_MAT})$", "{1} {2} {3} on {4} and {5} {2} {3} on {6}"),
    (f"^{_PUT} all ({MANY}) ({COLOR}) {_BLOCK} on the (?:mats|patches) , ({MANY}) on the ({COLOR})(?: one| mat)? and "
     f"(.+?) on the ({COLOR})(?: one| mat)?$",
     "of the {1} {2} blocks , {3} must be on the {4} mat and {5} on the {6} mat"),
    (f"^((?:at least |exactly |at most )?{MANY} of (the {MANY} [^,]+?) {MUST} be on [^,]+?) and none of (?:them|"
     "these) on (the .+)$", "{1} . none of {2} must be on {3}"),
    (f"^(.*?)({_PUT}) (?:them|all of them) (on .+?)(?: ,)? except (?:for )?(the [^,]+?) , which (?:{MUST} (?:be|go|"
     "lie)|go|goes|belong|belongs) (on .+)$", "{1} {2} them {3} except for {4} . {4} must be {5}"),
    (f"^(.*?)({_PUT}) (?:them|all of them) (on .+?)(?: ,)? except (?:for )?({MANY})(?: of them)? , which (?:{MUST} "
     "(?:be|go|lie)|go|goes|belong|belongs) (on .+)$", "{1} {2} all but {4} of them {3} . the others must be {5}"),
    (" , like(?: ,)?(?: at all| ever)?$", ""),
    *((f"\\b({MANY}) ((?:{COLOR} )?{_BLOCK}) {told}(?= (?:on|in|onto|into) |$| ,)", f"{bound} {{1}} {{2}}")
      for told, bound in (("(?:max|maximum|tops|at (?:the )?most)", "at most"),
                          ("(?:min|minimum|at (?:the )?least)", "at least"))),
    (f"^(.*\\b(?:row|line|tower|stack|column|grid|square|rectangle|wall|pyramid|circle|ring|cube)\\b.*?) , only "
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
    # which of them it is
    (f"^(?:(put|make|set|place|have) )?(the two (?:blocks|cubes)) ([^,]+?) , the ({COLOR})(?: one)? and (?:the "
     f")?({COLOR})(?: one| block| cube)?$", "{1} the {4} and the {5} block {3}"),
    (f"^((?:{_PUT}|get|bring|can you {_PUT}|could you {_PUT}) [^,]+? and [^,]+) , both(?: of them)?$", "{1}"),
    (f"\\b(?:right |directly |immediately )next to ({THING}) on \\1 's (left|right)(?: side)?",
     "immediately to the {2} of {1}"),
    ("^([^,]+?) , both (?:of them )?(?:are |being )?(?:cubes|blocks)$", "{1}"),
    (f"^(?:(?:could|can) we )?(?:get |have |put |place |set )?(?:the )?two ({COLOR}) (blocks|cubes|ones) side by "
     f"side(?: ,)? (?:with|and) "
     "(.+? on (?:top of )?the (?:left|right) one)$", "put two {1} blocks side by side and {3}"),
    ("\\b((?:gap|distance|space)(?: of [^,]+?)?) between the (?:two )?(?:towers|stacks|rows|groups|piles)$",
     "{1} between them"),
    ("\\bthe (left|right|upper|lower|top|bottom|front|back)(?: - hand| hand)? one of (?:them|these|the two|those)(?= "
     "|$)",
     "the {1} one"),
    (f"^((?:exactly |only |just |at least |at most )?one of )(?:the )?two (?:blocks|cubes|letters|digits)(?: ,| :) "
     f"(?:either )?({THING}) (?:and|or) ({THING})(?: ,)? (?={MUST}|is|goes|belongs|on|in)", "{1} {2} and {3} "),
    (f"^(?:exactly |only |just )?one of ((?:the )?(?:two )?[^,]+?)(?: ,)? (?:but|and) not (?:both|all)(?: of (?:them|"
     f"these))?(?: ,)? (?={MUST}|is|goes|belongs|on|in)", "exactly one of {1} "),
    # what is wanted
    (f"^((?:an?|one|{MANY}) (?:\\w+ )?(?:row|line|tower|stack|column|circle|square|pyramid|staircase|wall)s? of "
     f"[^,]+?) (?:is|are) (?:needed|wanted|required|desired|called for)$", "{1}"),
    ("^any one of (.+?) ((?:on|in|behind|next to|left of|right of) .+?) (?:will do|is fine|is ok|is okay|is enough)$",
     "put one of {1} {2}"),
    (f"^(?:i|we) (?:need|want|would like)(?: to (?:see|have))? ((?:an?|{MANY}) [^,]+?) (?:that|which) "
     f"(?!.*\\b(?:start|now|"
     f"first|initially|beginning)\\b)(?:(?:are|is) )?({PLACE} [^,]+|touch each other|touching each other)$",
     "{1} must be {2}"),
    (f"^((?:an?|{MANY}) [^,]+?) (?:that|which) (touch each other)$", "{1} must {2}"),
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
    (f"(?: ,| and)* (?:(?:with|leave)(?: me| us)? )?(?:a )?(?:({LENGTH}) gaps?|gaps? of ({LENGTH})) (?:between "
     "each(?: one)? and the next(?: one)?|every time|each time)$", " with gaps of {1} {2}"),
    # from which end
    ("\\bfrom (?:the )?(?:(?:table|ground|floor) (?:up|upwards|to the top)|down (?:to )?up|below to above|bottom to "
     "up)\\b", "from bottom to top"),
    ("\\bfrom (?:up to down|above to below)\\b", "from top to bottom"),
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
    (f"\\b(in {MANY} (?:rows|lines)(?: of {MANY})?) , (?:the )?({_ROW}) row (?!of\\b)(.+?)(?: ,)? and (?:the "
     f")?({_ROW}) row (.+?)(?= ,|$)", "{1} : {3} in the {2} row and {5} in the {4} row"),
    (f"^({MANY} {_BLOCKS} (?:on top of (?:each other|one another)|on each other|stacked)) , ({COLOR} (?:uppermost|on "
     "top|at the top|topmost|at the bottom|lowest) , .+)$", "{1} : {2}"),
    (f"^({MANY}) (in a (?:row|line|tower|stack|column|circle))\\b", "{1} blocks {2}"),
    (f"^(?:from|out of|with|using) the (?:cubes|blocks) ((?:\\w(?: ,)? )+and \\w) , ({_PUT} .+)$",
     "there are the blocks {1} . {2}"),
    (f"\\bas (?:tall|high|long|big) a ({LINE}|pillar) as (?:possible|(?:you|we|the robot) can|it gets|can be)"
     "(?: get| build| make| built| made)? (?:out of|from|with|of|using)\\b", "a {1} of"),
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
    *((f"^(?:please )?(?:spread|distribute)(?: out)? (.+?)(?: out)? (?:all )?(?:over|across|around|throughout) "
       f"(?=the {_PART} (?:half|side|part)\\b{told})", f"{how} {{1}} in ")
      for told, how in ((".*\\b(?:touch|touching|touches|next to|beside|apart|near|cm)\\b", "put"), ("", "spread"))),
    (f"^(.*\\b)(?:let|leave) ({THING})(?: to)? (?:be|alone)$", "{1} leave {2} where it is"),
    ("\\b(leave|keep) ([^,]+?) (?:lying|sitting|standing|resting) (?=(?:on|in|where)\\b)", "{1} {2} "),
    (f"^(.*\\b)let ({THING}) (?:be |stay )?(empty|free|clear)$", "{1} leave {2} {3}"),
    # without a stop in between
    (f"^((?:there (?:is|are) )?{MANY} [^,:;]*?{_BLOCKS}) (?:just |please |simply |now "
     f")?((?:{_PUT}|bunch|group|pile|line|sort|arrange) (?:them|these|those|all of them)\\b.*)$", "{1} , {2}"),
    (f"^((?:(?:can|could|would) you |please |just )?(?:{_PUT}|make|build|line|sort|swap|group|arrange|spell|pile) "
     f"[^,;:]+?){_NOT_SO} (there (?:is|are) (?:an?|only|\\d+|{FEW}) .+)$", "{1} . {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("min max tops minimum maximum upwards audience pupils save ground floor",)
"""Words that these take besides those that are read anyway."""
