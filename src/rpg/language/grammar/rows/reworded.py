"""What a plainer sentence says as well: pairs that are told one by one, headings that a list repeats, what is shown or
asked in place of being asked for, as rows that tell it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, FEW, LENGTH, MANY, MUST

_A = "(?:an?|one|the)"
_PATCH = "(?:patch|mat|zone|target|area|spot)"
_PUT = "(?:put|place|set|lay|move)"
_LARGER = "(?:larger|bigger|wider|greater|longer|farther|further|higher)"
_SMALLER = "(?:smaller|narrower|shorter|closer|nearer|lower)"
_SO_MANY = f"(?:(?:exactly|at least|at most|only|just) )?{MANY}"
_ON_IT = "(on (?!each|either|every|both|top|(?!a )\\S(?: |$))|in (?=the))"
_NO_LINE = "(?:(?!\\b(?:row|line|tower|stack)s?\\b).)"
_NO_ROWS = "(?:(?!\\brows\\b).)"
_HIGHEST, _LOWEST = "biggest|largest|highest", "smallest|lowest"

REWORDED_AT_ONCE: tuple[Turn, ...] = (
    # what is asked
    ("^(would|could|can|will) you ever (?=\\w)", "{1} you"),
    (f"\\b(at least {MANY} and at most {MANY} of .+?) (?:may|can) (be|lie|stand)\\b", "{1} must {2}"),
    # a heading, and a list that tells all of it
    (f"^each color (?:goes |belongs |lies |is |comes )?on (?:its own|the matching|its) {_PATCH} : ((?:(?:\\w+ "
     f")?({COLOR})(?: \\w+)? on (?:the )?\\2 {_PATCH}(?: , and | , | and |$))+)$", "{1}"),
    ("^(?:\\w+ )?\\w+ (?:separate|separated|apart|away) from (?:\\w+ )?\\w+ : (.+ one group\\b.+ group.*)$", "{1}"),
    ("^(sort .*?by \\w+) : (.+?) , (into (?:\\w+ )?(?:piles|groups|heaps|bunches|clusters))$", "{1} {3} : {2}"),
    (f"\\bmirrored [:,] ({COLOR} outside ,? ?(?:and )?{COLOR} inside)$", "{1}"),
    # so many, and how many of them are where
    (f"^({MANY} (?:\\w+ )?(?:blocks|cubes|letters|digits)) , ({_SO_MANY}) {_ON_IT} ?((?:(?! and )[^,])+)$",
     "{1} , {2} of them {3} {4}"),
    (f"^({MANY}) ((?:\\w+ )?(?:blocks|cubes)) , ({_SO_MANY}) (on [^,]+?)(?: , and | , | and )({_SO_MANY}) (on [^,]+)$",
     "{3} of the {1} {2} {4} and {5} of the {1} {2} {6}"),
    # orders
    ("(?: ,)? (?:in which|so that|such that|where) (?:the )?blocks of the same color (?:never|do not|must not|may not) "
     "touch(?: each other| one another)?$", " where no two blocks of the same color touch"),
    ("(?: ,)? but in the order\\b", " in the order"),
    ("\\bbehind (?:each other|one another)\\b", "one behind the other"),
    ("\\bone behind the other ,? ?(?:all )?in (?:a|one) (?:straight )?(?:row|line)\\b", "one behind the other"),
    (f"^({_NO_LINE}*?)\\b(?:a|one) (?:straight )?(?:row|line) (of {_NO_LINE}+?)(?: ,)? one behind the other$",
     "{1} a column {2}"),
    ("\\bin (?:a|one) (?:straight )?(?:row|line) ,? ?one behind the other\\b", "one behind the other"),
    *((f"(?: ,)? in which the ({one}) (number|digit) is {at}(?: and the (?:{other})(?: one| number| digit)? is "
        f"{opposite})?(?: ,)?(?: in order)?$", f", the {{1}} {{2}} {at}")
      for one, other in ((_HIGHEST, _LOWEST), (_LOWEST, _HIGHEST))
      for at, opposite in (("on top", "at the bottom"), ("at the bottom", "on top"))),
    (f"^(?:{_PUT} )({_NO_ROWS}+?) in the front row , (.+?) in the middle row(?: ,)? and (.+?) in the back row(?: , "
     "each row in order from left to right)?$", "front row : {1} ; middle row : {2} ; back row : {3}"),
    (f"^(?:{_PUT} )({_NO_ROWS}+?) in the front row(?: ,)? and (.+?) in the back row(?: , each row in order from "
     "left to right)?$", "front row : {1} ; back row : {2}"),
    (f"\\b({MANY}) (layers|rows|columns) (?:,|with) ({MANY}(?: {COLOR} {CUBE}s)?)(?: {CUBE}(?:s|es))? in (?:each|"
     "every)(?: of them| one| layer| row| column)?(?=$| ,)", "{1} {2} of {3}"),
    (f"\\b(cube|cuboid|box) (?:that|which) is ({MANY}(?: blocks| cubes)? (?:wide|long|deep|high) (?:,|and) .+)$",
     "{1} , {2}"),
    # places
    (f"\\bbetween {_A} ([^,]+?) (?:on|to) (?:its|the) (left|right)(?: side)? and {_A} ([^,]+?) (?:on|to) (?:its|the) "
     "(?!\\2)(?:left|right)(?: side)?$", "between a {1} and a {3} , the {1} on its {2}"),
    (f"^(.+? to the (?:left|right) of) (it|them) and ({_A} .+?) (?:to|on) the (left|right)$",
     "{1} {2} and {3} to the {4} of {2}"),
    ("^(the [^,]+?) has ([^,]+?) on its (left|right) , ([^,]+?) on its (left|right) and ([^,]+?) on top(?: of it)?$",
     "{2} is to the {3} of {1} , {4} is to the {5} of {1} and {6} is on {1}"),
    (f"^(.*?)({_PUT} [^,]+? (?:on|in) (the [^,]+?))(?: ,)? (?:and|but) none of (the [^,]+)$",
     "{1} {2} . none of {4} must be on {3}"),
    (f"^(.*?)\\b(an?|the|one) ({CUBE})((?: {COLOR} {CUBE}| (?!{CUBE}\\b|another\\b)[^, ]+)+) , (?:an?|the) ({COLOR}) "
     "one$", "{1} {2} {5} {3} {4}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

REWORDED: tuple[Turn, ...] = (
    # measures
    (f"\\b(?:no|not) {_LARGER} than ({LENGTH})", "at most {1}"),
    (f"\\b(?:no|not) {_SMALLER} than ({LENGTH})", "at least {1}"),
    (f"^(.+?) (?:moves|{MUST} move|moves away|{MUST} move away)(?: by)? (at least {LENGTH})$",
     "{1} must be moved by {2}"),
    # what is asked
    ("^let (\\S+) be (?:read|spelled|written|seen)\\b", "spell {1}"),
    ("^not ((?:on|in) [^,]+?) ,? ?but ((?:on|in) [^:,]+) [:,] (?:that|this) is where (?:i|we) (?:want|need|would "
     "like)(?: to see)? (.+)$", "{3} must not be {1} but {2}"),
    ("^how (?:do|would|can|should) (?:you|we|i|one) (?=(?:spell|write) )", "please"),
    ("^([^:,]+) [:,] (?:that|this) is (?:how|the way) (?:i|we) (?:want|need|would like)(?: to see)? (.+)$",
     "{2} must be {1}"),
    (f"^(?:share|distribute|divide|split|spread) ({FEW}) (.+?) (?:between|over|among|across) (the .+? {_PATCH}) and "
     "(the .+?) so that there are (?:just |exactly )?as many on .+$",
     "put half of the {1} {2} on {3} and the other half on {4}"),
    # pairs told one by one
    ("^([^,]+?) gets ([^,]+?) , ([^,]+?) gets ([^,]+?)(?: ,)? and ([^,]+?) gets ([^,]+?) on top(?: of it)?$",
     "put {2} on {1} , {4} on {3} and {6} on {5}"),
    ("^([^,]+?) gets ([^,]+?)(?: ,)? and ([^,]+?) gets ([^,]+?) on top(?: of it)?$", "put {2} on {1} and {4} on {3}"),
    # who, which, where
    ("^all (?=(?:on|in|within|inside|at) )", "all are"),
    (f"^(.*?\\b(?:{CUBE}|one)) for (the (?:near|far|left|right|front|back) half|the (?:\\w+ ){{1,2}}corner)(?: of the "
     f"table)? , (.+?(?:{CUBE}|one)) for (the (?:near|far|left|right|front|back) half|the (?:\\w+ ){{1,2}}corner)(?: "
     "of the table)?$", "{1} in {2} , {3} in {4}"),
    ("^who (?:can|could|would|wants to|is able to|knows how to) (?=\\w)", "please"),
    # words
    ("^(?:a (?:tower|stack) )?read(?:ing)? (?:down|downwards|from the top of) the (tower|stack)(?: down| "
     "downwards)?(?: ,)?(?: top first)?(?: [:,])?(?: you get| it says| it reads| one reads)? (\\S+)$",
     "a {1} that reads {2} from top to bottom"),
    ("\\b(\\S+) and (\\d) with (plus|minus|times)(?: ,)? and equals\\b", "{1} , {2} , {3} and equals"),
    # structures
    (f"\\b(an?|the) {_LARGER} (tower|stack|row|line) of (?={MANY}\\b)", "{1} {2} of"),
    (f"\\b(an?|the) taller (tower|stack) of (?={MANY}\\b)", "{1} {2} of"),
    (f"\\b(an?|the) {_SMALLER} (tower|stack|row|line) of (?={MANY}\\b)", "{1} {2} of"),
    (f"\\b(an?|the) pattern (with|of) (?={MANY} (?:rows|columns))", "{1} grid {2}"),
    ("\\b(row|column|line|tower|stack) of colors\\b", "{1}"),
    (f"^the (leftmost|rightmost) of (?:the )?({MANY}) ({CUBE}s) is (.+?) , the (leftmost|rightmost) (?:one )?is "
     "(.+?)(?: ,)? and (.+?) (?:is|stands|lies|sits) (?:in )?between(?: them)?(?: , all in (?:a|one) row)?$",
     "{2} {3} in a row : the {1} is {4} , the {5} is {6} and {7} is in between"),
    # what stands beside it
    (" (?:too|as well) , (and|but|while)\\b", " , {1}"),
    # what is said besides
    ("(?: ,)? (?:nice|neat|good) and (?:straight|even)$", ""),
    ("(?: ,)? (?:for sure|for certain|full stop|here)$", ""),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
WORDS = (
    "gets bodied closely carefully sure certain stop straight share pattern mirrored taller farther further narrower "
    "wider nearer",
)
"""Words that these take besides those that are read anyway."""
