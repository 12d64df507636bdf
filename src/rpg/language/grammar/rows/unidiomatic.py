"""What people say who think in another language, or write a specification, and is not quite idiomatic: "from my left to
my right", "starting at the left with the biggest", "the one beside the other", "not allowed: red on blue", as rows."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import LABEL, PLACE, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import (
    AND,
    COLOR,
    CUBE,
    END,
    LENGTH,
    LINE,
    MANY,
    MUST,
    NO_NUMBER,
    PATCH,
    PATCHES,
)

_WHO = "(?:my|your|our|his|her|(?:the |a )?(?:viewer|observer|robot|camera|reader|onlooker|spectator) 's)"
_FIRST = "(biggest|largest|highest|smallest|lowest)(?: one| number| digit)?"
_PART = "(lowest|bottom|uppermost|topmost|top|highest|middle|leftmost|rightmost)(?: one| block| cube)?"
_SHOWING = "(?:with|(?:that|which) (?:show|bear|carry|have)|showing|bearing|carrying)"
_AS_FOR = "(?:as for|regarding|concerning|as regards|with regard to)"
_WISH = "(?:i|we) (?:want|need|wish|prefer|would (?:like|love|prefer|want))(?: to (?:have|see|get))?"
_SHOWN = f"(?: {_SHOWING} (?:an? |the )?(?:letter |number |digit )?{LABEL}(?: on (?:it|them|top))?)?"
_UNMOVED = "alone|there|untouched|in place|unmoved|(?:as|where) (?:it is|they are)"
_BARRED = "(?:not (?:allowed|permitted|ok|okay)|forbidden|prohibited|disallowed|banned|no go)"
_DOES = "(?:put|place|stack|set|lay|build|make|move|take|arrange|form|bring)"
_HAS = "(?:contains?|comprises?|have|has|consists? of)"
_STAY = "(?:leave|keep)"
_GERUNDS = ("moving", "touching", "shifting", "disturbing", "lifting", "turning", "changing", "breaking", "destroying")
_SIZED = "(?:by|in order of|according to) (?:the(?:ir)? )?size|(?:of|with|in|have|has) different sizes?"
_WORDED = "(?: (?:one|block|cube))?"
_AT_END = (
    "(?=(?: (?:is|goes|comes|being|has to be|must be|should be))?(?: (?:at|in|on|to))?(?: the)? (?:bottom|top|left|"
    "right|front|back|first|last|start|end|base|below|lowest|nearest)\\b)"
)
_FIGURE = "(?:wall|tower|stack|row|line|column|pyramid|square|circle|ring|grid|triangle|staircase)"
_TWO_LOTS = "(?:2|two) (?:groups|piles|bunches)"
_A = f"(?:{MANY}|an?)"
_LOT = f"{_A} {COLOR} {CUBE}s?"
_OF_TWO = "(?:one|the other)"
_SORT = "(vowels|consonants|letters|digits|numbers|numerals)"

UNIDIOMATIC_AT_ONCE: tuple[Turn, ...] = (
    (f"\\ba couple of (?=(?:\\w+ ){{0,2}}{CUBE}s\\b)", "two "),
    (f"\\b(starting|beginning) (?:at|from|on) the ({END}) with (?:the )?{_FIRST}", "{1} with the {3} at the {2}"),
    (f"\\b(?:the (?:cubes|blocks|ones)|those) {_SHOWING} the {_SORT} (?=(?:\\w|\\d) (?:,|and) )"
     "(?!.*\\bon (?:them|it)\\b)", "the {1} "),
    # each on its own, told as an order
    (f"\\b((?:on|onto) the (?:{COLOR} (?:, and |, |and )?)+{PATCHES})(?: ,)? in (?:that|this|the same) order$",
     "{1} respectively"),
    # who is meant is named ahead of its pronoun
    (f"^(?:{_AS_FOR} )?({THINGS}{_SHOWN}) , {_WISH} (?:it|them|these|those) ", "i want {1} "),
    (f" , and ({THING}) , it (?=(?:{MUST}|is|goes|stands|lies|sits|belongs) )", " , and {1} "),
    (f"^((?:.* )?(?:,|but|, and) |)({THINGS}) (?:you |please )*(leave|keep) ({_UNMOVED})(?=$| ,| and)",
     "{1} {3} {2} {4}"),
    (f"^(?:please )?({PLACE} {THING}) ({THINGS}) (?:you |please )*(put|place|stack|set)$", "{3} {2} {1}"),
    (f"\\b((?:take|grab|get|lift|pick|pick up) {THING} and(?: then)? (?:put|place|set|lay)) (?=(?:down )?(?:{PLACE}|to"
     "|at) )", "{1} it "),
    # what is behind another one has that in front
    (f"^({THING})(?: is| stands)? (?:in|at the) front{AND} ({THING})(?: is| stands)? behind (?:it|that|\\1)"
     "(?= |$)", "{2} is behind {1}"),
    # so many blocks, and no block that shows a number
    (f"\\b((?:tower|stack|pile|row|line)s?\\b.*? (?:higher|taller|longer) than) ({MANY})$", "{1} {2} blocks"),
    # a bound that is told last
    *((f"^({NO_NUMBER})\\b((?:a |an )?{many})\\b({NO_NUMBER})(?: ,|-)? (at least|at most|minimum|maximum|exactly)$",
       "{1} {4} {2} {3}") for many in (LENGTH, MANY)),
    # what takes the place of another one is named last
    (f"\\b(and|,) in its (?:place|spot|stead)(?: ,)? (put|place|set|lay) ({THING}|an? {LINE} of {MANY} {COLOR}(?: "
     f"{CUBE}s)?)(?=$| ,| and)", "{1} {2} {3} in its place"),
    # one thing and then the next: behind what is done, "after" with a bare verb is "after that"
    (f" , (?:and )?after (?={_DOES} )", " , then "),
    (f"^after ,? ?(?={_DOES} |{THING} (?:goes |comes )?{PLACE} {THING}$)", "then "),
    (f"^(first .+?) , (?:and )?after (?={THING} (?:goes |comes )?{PLACE} {THING}$)", "{1} , then "),
    (f"\\bthere is (?=(?!one\\b|1\\b){MANY}(?:$| of (?:them|each)\\b| {COLOR}\\b))", "there are "),
    # what it does once more
    ("\\b((?:it|they|one|block|cube|" f"{COLOR}|{LABEL}) (?:{MUST} )?(?:goes|go|comes|come)) back (?:up |down )?"
     "(?=(?:on|onto|into|to) (?!the (?:left|right|front|back|far|near)\\b))", "{1} "),
    # which block of different sizes it is
    *((f"^(?=.*\\b(?:{_SIZED})\\b)(.*?)(?:\\bthe )?\\b(?:{sizes}){_WORDED}{_AT_END}", f"{{1}} the {most} one ")
      for sizes, most in (("big|large", "largest"), ("small|little|tiny", "smallest"))),
    # what is asked of the tower that is there
    ("^(?:the )?(top|bottom) (block|cube|one) (?:goes|comes|moves) to the (?!\\1)(bottom|top)(?=$| ,)",
     "put the {1} {2} at the {3} of the tower"),
    # places, without the small words that go with them
    ("\\b(?:to |on |at )?the (left|right)(?: side)? or (?:to |on |at )?the (left|right)(?: side)? of\\b",
     "{1} or {2} of"),
    ("\\b(?:change|exchange|switch|swap|trade) (?:their )?(?:places?|positions?|spots)(?: with (?:each other|one "
     "another))?(?! with\\b)", "swap places"),
    (f"\\b(leave|keep|have) gap(?: of)? ((?:about |exactly )?{LENGTH})", "{1} a gap of {2}"),
    ("\\b(is|are|goes|comes|be) (?:at )?(?:the )?most (top|bottom|left|right)(?=$| ,| and)", "{1} at the {2}"),
    *((f"\\b(?:the )?most (?:{said})(?: away)?\\b(?! of)", most)
      for said, most in (("near", "nearest"), ("close", "closest"), ("far", "farthest"), ("left", "leftmost"),
                         ("right", "rightmost"))),
    ("\\bon (?:the |all )?(?:(?:four|4) )?corners of the table\\b", "in the corners of the table"),
    ("\\bone on top of other\\b", "one on top of the other"),
    ("\\bone (?:near|by|next to|beside|close to|near to) (?:an ?|the )?other(?: one)?\\b", "next to each other"),
    (f"\\b((?:is|are|be|lies|stands|lie|stand|lying|standing|sits|placed) )(?:from|at|by) (?:the )?(left|right)(?: "
     f"side)? of (?={THING})", "{1} to the {2} of "),
    (f"^(?:i|we) (?:would |do )?(?:want|like|wish|need) (?:that )?you (?:to )?(?={_DOES} )", ""),
    ("^(?:i am|we are) (?:wanting|needing|wishing(?: for)?|requiring) ", "i want "),
    (f"\\b(tower|stack|row|line|column|wall) (?:which is |that is )?as (?:high|tall|long) as (?={MANY} "
     f"{CUBE}s\\b)", "{1} of "),
    (" ,? ?but (?=(?:start|starting|begin|beginning) (?:from|at|on) )", " , "),
    ("\\bon top (?=each other\\b|one another\\b)", "on top of "),
    ("\\b(?:with|in|of) (?:alternate|alternating) color\\b", "with alternating colors"),
    ("^(?:please )?no (touch|move) (?=(?:the|it|them|any)\\b|" f"{THING})", "do not {1} "),
    ("\\b(?:just )?(?:slightly|a little|a bit|a little bit|a tiny bit) (?=(?:(?:to|on) the )?(?:left|right) of|in "
     "front of|behind)", ""),
    ("\\bwhich ever\\b", "whichever"),
    ("(?: ,| but| and)+ no two (?:of )?(?:the )?same colors?$", " , no two of the same color"),
    (" now , should be (?:the )?other way (?:a)?round$", " now , it should be the other way around"),
    (f"^((?:.* )?(?:stack|pile)\\b.* ,) ({THING}) (bottom|top)$", "{1} {2} at the {3}"),
    (f"^({COLOR}) ({CUBE}s) , there are ({MANY}) of (?:them|these) , (stack|line up|group) (?:all|them|all of them)$",
     "{4} the {3} {1} {2}"),
    ("\\bin the 4 corners\\b", "in the four corners"),
    (f"\\b(one (?:{CUBE}|one)?) ?(?=(?:each|every) corner$)", "{1} in "),
    (" , so (?=(?:counted|read|seen|told|listed) from )", " , "),
    (f" , (?:it|this|that) is an? ({COLOR}) ({PATCH})$", " . the {2} is {1}"),
    (f"^(?:i |we )?need (?={MANY} {COLOR} {MANY} {COLOR})", ""),
    (f"^(?:i |we )?need (?:to )?(?={_DOES} )", ""),
    (f"\\b(not (?:on|beside|next to|touching|under)) other (?={CUBE}\\b)", "{1} another "),
    # the tower that is taken apart
    (f"^(unstack|dismantle|take apart|disassemble) (?!.*\\b(?:{LINE}|pile|{PATCH}|table)\\b)({THING}(?: "
     f"(?:on|on top of) {THING})+)(?=$| ,| and)", "{1} the tower of {2}"),
    (f"\\bthe (tower|stack|pile) (?=a on {LABEL}(?:$| ))", "the {1} of "),
    # what there is
    (f"^one ({PATCH})(?: is)? ({COLOR}) ,(?: and)? {_OF_TWO}(?: {PATCH}| one)?(?: is)? ({COLOR}) , (?={_DOES} )",
     "there is a {2} {1} and a {3} {1} . "),
    (f"\\bthe ({PATCH}) (left|right) is (?={COLOR}\\b)", "the {2} {1} is "),
    ("\\b(?:on|at) (?:the )?table edge(?: (?:on|at|to))?(?: the)? (left|right|front|back)\\b(?! (?:of|side))",
     "at the {1} edge of the table"),
    (f"\\b({_FIGURE}(?: \\d+x\\d+)? (?:of|from|with|out of)) ((?:{COLOR} )?(?:brick|{CUBE}))(?=$| ,| {MANY} "
     "(?:long|wide|high|tall)\\b)", "{1} {2s}"),
    # where it is not, of one that was listed
    (f"^((?:.* )?{LINE}\\b.*?\\b({COLOR})\\b.*) , (?:the )?\\2(?: one| {CUBE})? not (?=(?:at|in|on|next|"
     "beside|touching|near)\\b)", "{1} . {2} is not "),
    # of how many groups are
    (f"^(.*\\b{MANY} [^,]*\\bin(?:to)? {_TWO_LOTS}) , ({MANY}) and ({MANY})$", "{1} , one of {2} and one of {3}"),
    (f"^(?:put |sort |split |make )?(?:the )?({CUBE}s) in(?:to)? {_TWO_LOTS} , ({MANY}) and ({MANY})$",
     "{2} {1} in one group and {3} {1} in another group"),
    ("^((?:put |place )?(?:the )?(?:biggest|largest|highest|smallest|lowest) (?:number|digit)\\b.*) , "
     "((?:\\d(?: ,| and)? )+\\d)$", "there are {2} . {1}"),
    # the third of three, and not what is done third
    (f"\\b((?:two|2) of (?:the )?(?:three|3)\\b.*?) (,|and|, and) (?:the )?third(?: one| {CUBE})? (?=(?:is |goes |"
     f"stands )?{PLACE})", "{1} {2} the other one "),
    # what there is, and where one of it goes
    (f"^((?:{_LOT}{AND} )*{_A} ({COLOR}) {CUBE}s?(?:{AND} {_LOT})*) , ((?:the )?\\2(?: ones?| {CUBE}s?)? (?:goes |is |"
     f"are )?{PLACE} .+)$", "there are {1} . {3}"),
    # what lies there
    (f"^(.*\\bon (the (?:{COLOR} )?{PATCH})\\b.*) (?:,|, but|but) (?:now|right now|at the moment) there (?:is|are) "
     "([^,]+)$", "at the start there are {3} on {2} . {1}"),
    *((f"\\b{end} most\\b(?= (?:one|{CUBE}))", f"{end}most") for end in ("left", "right", "top", "bottom")),
    ("\\b(?:qty|quantity)(?: :| of)? (?=(?:\\d+|two|three|four|five|six)\\b)", ""),
    # all but some
    (f"^((?:put )?(?:all|everything)) (on the [^,]+?)(?: ,)? but(?: not)? (?:the )?({COLOR})(?: one| {CUBE})?"
     "(?: (?:stays|is|must stay|should stay) (?:off|outside)(?: it)?)?$", "{1} except {3} {2}"),
    (f"^(.+? {PLACE} [^,]+?)(?: ,| and| , and) (?:the )?(?:rest|others) off(?: it)?$", "{1} , the others not"),
    # from the one on top of all to the one below all
    (f"^(.+ on ({COLOR}))(?: , that is the whole tower)?(?: ,| and| , and) \\2 (?:is |goes )?"
     "(?:at the (?:very )?bottom|lowest)$", "{1} , that is the whole tower"),
    (f"\\b({LINE}) of ({COLOR})(?= (?:in|on|at|behind|next)\\b(?! (?:\\w+ )?{COLOR})|(?: ,| and| , and) (?:an? )?{LINE}"
     "\\b)", "{1} of {2} blocks"),
    (f"( {CUBE}s\\b.*?) with (?:some |enough |a little )?(?:space|room|gaps?) between$", "{1} with space between them"),
    ("^(?:an? )?(\\d+x\\d+) base of (?=.* on top$)", "a {1} layer of "),
    ("\\beach one (?=(?:with|has|having) |(?:of|in) (?!the\\b|these\\b|them\\b))", "each "),
    (f"\\bthe ({COLOR}) (?=(?:are|have) (?:all )?to be )", "the {1} blocks "),
    (f"\\b({CUBE}s) ({COLOR})s\\b", "{2} {1}"),
    # a figure and one part of it
    *((f"^(?:the|an?|one) ({LINE}) (?:{MUST} )?{_HAS} (?:exactly )?({MANY} (?:\\w+ )?{CUBE}s)(?: ,)? {part} "
       f"(?:{MUST} be|is) (.+)$", "a {1} of {2} , the {3} one {4}")
      for part in (f"of which the {_PART}", f"the {_PART} of which")),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
UNIDIOMATIC: tuple[Turn, ...] = (
    # orders
    (f"\\bfrom {_WHO} ({END})(?: side)? to (?:the |{_WHO} )?({END})(?: side)?\\b", "from {1} to {2}"),
    ("^(?:the )?stacking (?:order|sequence)(?: is)?(?: ,| \\()? ?(?:from )?(?:the )?(bottom|top) to "
     "(?:the )?(top|bottom)(?: \\))?(?: is| :)? (.+)$", "stack from {1} to {2} : {3}"),
    (f"^((?:four|4) [^,]+?)(?: ,)? (?:{MUST} )?(?:be|are|build|form|make(?: up)?|mark) (?:the )?(?:four )?corners of "
     "(?:an? )?(?:imaginary )?square$", "{1} must form a square"),
    ("\\bin (?:rising|growing|mounting|climbing) order\\b", "in ascending order"),
    ("\\bin (?:falling|sinking|shrinking) order\\b", "in descending order"),
    # one on the other, each time told of the one before
    *((f"^({THING}){AND} {at} (?:it|that|this) ({THING}){AND} {at} (?:it|that|this) ({THING})$",
       f"a tower , {first} {{1}} , {then} it {{2}} , {then} it {{3}}")
      for at, first, then in (("(?:on|on top of|above|over)", "at the bottom", "above"),
                              ("(?:under|below|beneath|underneath)", "on top", "under"))),
    # each other
    ("\\bthe one (beside|behind|on|upon|above|next to|in front of) the other\\b", "one {1} the other"),
    # what is wanted, and who does it
    ("^(?!.*\\b(?:no|none|neither|nothing|nobody|not)\\b)(.+?) (?:is|are) (?:requested|intended|desired|required|"
     "wanted|asked|planned|due|bound) to (?=\\w+ )", "{1} must "),
    ("^it is (?:wished|requested|asked|intended|demanded|prescribed|planned) that ", ""),
    (f"^it {MUST} not be (?:so |the case )?that ", "it is forbidden that "),
    *((f"^one {does}s (?=(?:the|an?|both|all|{MANY}) )", f"{does} ") for does in _DOES.strip("(?:)").split("|")),
    (f"^there (?:is|are) to ({_DOES}) ", "{1} "),
    (f"^is there (?:an?|any) (?:way|chance|possibility|option)(?: for| that) ({THING}) to ", "{1} must "),
    (f"^{_AS_FOR} ({THING}) [:,] ({_DOES}) it ", "{2} {1} "),
    (f"^{_AS_FOR} ({THING}) [:,] it (?={MUST} |is |goes |belongs )", "{1} "),
    ("\\b(each|every) (block|cube|one) (?:in|of|with|having) another color\\b", "{1} {2} in a different color"),
    ("^are ([^,]+?) able to be ", "can {1} be "),
    ("\\bbe interchanged\\b", "be swapped"),
    ("\\b(?:at|by) the side of (?=\\w)", "beside "),
    # so, too
    (f"\\b({THING}) (?:likewise|similarly|in turn|correspondingly) (?=(?:{PLACE}|over) )", "{1} "),
    ("^(?:and )?the same (?:goes|applies|holds|is true|is valid|is to be done) (?:for|to|of|with) ", "same for "),
    # what must not be
    (f"^{_BARRED} : ({THING}(?: and {THING})?|the \\w+) (?:standing |lying |being |sitting )?"
     f"(touching|{PLACE}) (.+)$", "{1} must not be {2} {3}"),
    # where it is
    (f"\\b(right|left) from (?={THING})", "{1} of "),
    (f"\\b({_STAY} it|{_STAY} {THING}) (?:at|in|on) its (?:original |old |current |present )?"
     "(?:position|spot|location)\\b", "{1} in its place"),
    ("\\bleave (it|them|that|this) be\\b(?=$| ,| and| \\.)", "leave {1} where it is"),
    ("\\bin the table\\b(?! 's)", "on the table"),
    ("\\bin top of ", "on top of "),
    (f"\\bin the (left|right) of (?={THING})(?!the table|it)", "to the {1} of "),
    ("\\bone (?:on|upon) (?:the )?other\\b", "one on top of the other"),
    (f"\\b(?:on|at|to) (?:the (?:two|both)|both the) sides of (?={THING})", "on both sides of "),
    ("(?<! ,)(?<! but)(?<! or) not both$", " , not both"),
    *((f"\\bwithout to {gerund[:-3]}e? ", f"without {gerund} ") for gerund in _GERUNDS),
    (f"\\b(on|on top of|beside|next to|touching|touches|touch) other (?={CUBE}\\b)", "{1} another "),
    ("^(?:change|exchange|swap|switch) (?:the )?(?:places?|positions?|spots?) (?:of|between) ", "swap "),
    ("\\b(?:on|at) the (left|right) table edge\\b", "at the {1} edge of the table"),
    ("^([^,]+?) (on the [^,]+?) , (?:all )?lying flat(?= ,|$)", "{1} flat {2}"),
    (f"^(.*\\b{COLOR}(?: ones?| {CUBE}s?)?) down( and| ,| , and) (.*\\b{COLOR}(?: ones?| {CUBE}s?)?) up(?= ,|$)",
     "{1} at the bottom {2} {3} on top"),
    ("(?<!from )\\b(small|smallest|little) to (big|biggest|large|largest)\\b", "from {1} to {2}"),
    ("(?<!from )\\b(big|biggest|large|largest) to (small|smallest|little)\\b", "from {1} to {2}"),
    ("^(rotate|turn) (.+? degrees?) to (left|right)$", "{1} {2} to the {3}"),
    ("\\b(at|in) (beginning|start|end)(?=$| ,)", "{1} the {2}"),
    (f"^({THING}) and ({THING}) (?:exchange|trade|switch)(?=$| ,)", "{1} and {2} swap"),
    (f"(?<= )({THING}) (?:no|not) (move|change|touch)$", "{1} does not {2}"),
    (f"(?<!the )\\b(tower|row|column|pyramid|wall) (?={MANY} (?:{COLOR} )?(?:{CUBE}|brick)s?\\b)", "{1} of "),
    ("\\bbesides$", "beside it"),
    # by turns
    ("\\bwhere (?:there is )?always (an? \\w+ and an? \\w+) (?:change|alternate)(?: each other)?\\b",
     "where {1} alternate"),
    ("\\bcolors? changes?(?: every time| always| each time)? between\\b", "color alternates between"),
    (f"\\b(of {MANY}) (?:changing|alternating) colors ({COLOR})(?: and| ,)? ({COLOR})\\b",
     "{1} with alternating colors {2} and {3}"),
    (f"^({MANY} (?:{CUBE}|brick)s high\\b[^:]*: .+)$", "a tower {1}"),
    # which and how many they are
    (f"^(.*\\b(?:each|every|per) {PATCH}\\b.*?) , ({MANY} {PATCHES}\\b.*)$", "{1} . there are {2}"),
    *((f"^(.*\\btower\\b.*? (?:{COLOR}|\\w)(?: {CUBE}| one)?) from (?:the )?{one}$", f"{{1}} from {one} to {other}")
      for one, other in (("bottom", "top"), ("top", "bottom"))),
    (f"^((?:an? )?{LINE} of {MANY}) , (letters|digits|numbers|vowels|consonants) only$", "{1} {2}"),
    (f"\\ball of (?={CUBE}s\\b)", "all of the "),
    (f"^({MUST}) be (?=(?:an?|one) )", "there {1} be "),
    (f"\\b(with|have|has) (?:the )?height of (?={MANY} {CUBE}s)", "{1} a height of "),
    (f"\\b(with|have|has) ({MANY} {CUBE}s) of height\\b", "{1} a height of {2}"),
    ("\\bwith (?:the |their )?colors (?:alternated|alternatingly|interchanging)\\b", "with alternating colors"),
    (f"^({_DOES}) with them (?:only |just )?(?=(?:an?|one) {LINE})", "{1} from them "),
    (f"^({THING}) is necessary to ({_DOES}) ", "{2} {1} "),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = (
    "viewer observer onlooker spectator regarding concerning regards banned disallowed prohibited "
    "correspondingly qty quantity imaginary valid interchanged mounting climbing growing falling sinking "
    "shrinking rising alternated alternatingly interchanging",
)
"""Words that these take besides those that are read anyway."""
