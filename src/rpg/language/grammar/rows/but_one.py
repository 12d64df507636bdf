"""What is left as it is but for one, with the exception behind all that stays or in its own clause, as rows that say
the exception first: "leave all of them where they are except the black one, which goes on the brown one"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, FEW, MUST

_BLOCKS = f"(?:{CUBE}s?|bricks?|boxes|ones)"
_ALL = (
    f"(?:all(?: (?:of )?(?:them|these|those|(?:the |these |those )?(?:(?:{FEW}) )?{_BLOCKS}))?|everything|"
    f"(?:every|each) {CUBE}|the {_BLOCKS}|the (?:{FEW}))"
)
_EXCEPT = "(?:except(?: for)?|but(?: for| not)?|apart from|other than|save(?: for)?|with the exception of)"
_THERE = "(?:(?:right |exactly |just )?where (?:they are|it is)|in (?:its |their )?places?|put|as (?:they are|it is))"
_STAY = f"(?:(?:{MUST} )?(?:stays?|remains?|be left|be kept)|is left|are left|is kept|are kept)"
_GOING = f"(?:goes|go|moves?|belongs?|comes?|ends? up|{MUST})"
_GOES = f"({_GOING} .+)"
_MOVES = f"(?:moves?|(?:may|can|{MUST}) (?:move|be moved|be touched)|is (?:to be )?(?:moved|touched)|gets? moved)"
_TAKE = "(?:take|get|clear|move|lift|pull|bring|push)"

_BESIDE = "(?:touching|next to|beside|adjacent to|near|close to)"
_IS = f"(?:(?:{MUST}|may|can) (?:be|stand|lie|sit|go|rest)|is|sits|stands|lies|rests)"

_LETTER = "(?:the )?(?:(?:letters?|blocks?|cubes?) )?(?:[a-z0-9](?: blocks)?|vowels?|consonants?)(?= |$)"
_LETTERS = f"{_LETTER}(?:(?: ,)?(?: and)? {_LETTER})*"
_ALL_LETTERS = (
    "(?:(?:all(?: of)?|each|every(?: one)?(?: of)?)(?: the| its)?(?: letters?| blocks?| cubes?)?|"
    "everything|the letters|the (?:other )?(?:blocks|cubes))"
)
_WITH = "(?: ,)?(?: with| ,)"

BUT_ONE_AT_ONCE: tuple[Turn, ...] = (
    # what some letters of a word are an exception to
    (f"^(.+?){_WITH} {_ALL_LETTERS} {_EXCEPT} ({_LETTERS}) (?:being |are )?(?:in )?({COLOR})(?: ({PLACE} .+))?$",
     "{1} {4} . all blocks except {2} are {3}"),
    (f"^(.+?){_WITH} {_ALL_LETTERS} (?:being |are )?(?:in )?({COLOR}) {_EXCEPT} ({_LETTERS})$",
     "{1} . all blocks except {3} are {2}"),
    (f"^(?:(?:take|get|lift) only|only (?:take|get|lift)) ({THING}) ((?:off|away|down)(?: .+)?)$",
     "take {1} {2} . all blocks except {1} must stay where they are"),
    (f"\\b({MUST}) only (touch|have|hold|carry|bear|contain|be {_BESIDE}) ", "{1} {2} only "),
    (f"\\b({MUST} be) only ({_BESIDE}) ", "{1} {2} only "),
    (f"^(?:no (?:other )?{CUBE}|nothing|none) {_IS} ({PLACE} .+?)(?: ,)? "
     f"{_EXCEPT} ({THINGS})$", "no block except {2} may be {1}"),
)  # fmt: skip
"""What could be meant in several ways as it stands."""
BUT_ONE: tuple[Turn, ...] = (
    (f"\\ball (?:but|except|save)(?: for)? ({FEW})(?=$| ,| and\\b| {PLACE} )", "all but {1} of them"),
    *((f"^(leave|keep) ({_ALL}) ({_THERE})(?: ,)? {_EXCEPT} ({THINGS}){tail}$",
       f"{{1}} {{2}} except {{4}} {{3}} {more}")
      for tail, more in (("", ""), (f"(?: ,)? (?:which|that) {_GOES}", ". {4} {5}"))),
    *((f"^({_ALL}) ({_STAY} {_THERE})(?: ,)? {_EXCEPT} ({THINGS}){tail}$", f"{{1}} except {{3}} {{2}} {more}")
      for tail, more in (("", ""), (f"(?: ,)? (?:which|that) {_GOES}", ". {3} {4}"))),
    (f"^({_ALL}) stays?(?: ,)? {_EXCEPT} ({THINGS})$", "{1} except {2} must stay where they are"),
    *((f"^{_EXCEPT} ({THINGS}){tail}(?: ,)? nothing(?: else)? {_MOVES}",
       f"all blocks except {{1}} must stay where they are {more}")
      for tail, more in (("", ""), (f"(?: ,)? (?:which|that) ({_GOING} [^,]+)", ". {1} {2}"))),
    (f"^(?:nothing|no (?:{CUBE}|other {CUBE}|one)) {_EXCEPT} ({THINGS}) {_MOVES}$",
     "all blocks except {1} must stay where they are"),
    (f"^(?:nothing|no {CUBE}) {_MOVES} {_EXCEPT} ({THING})(?: ,)? (?:which|that) {_GOES}$",
     "all blocks except {1} must stay where they are . {1} {2}"),
    # all but one are taken off what they lie on
    (f"^(?:{_TAKE} ({_ALL})|{_TAKE} them (all))(?: ,)? (off(?: .+?)?)(?: ,)? {_EXCEPT} ({THINGS})$",
     "take {1} {2} except {4} {3}"),
    (f"^(?:discard|get rid of) ({_ALL} {_EXCEPT} {THINGS}|{_ALL}|{THINGS}|them|it)$", "remove {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
_ARE = f"(?:is|are|being|{MUST} be)"
_BEHIND = f"(?: ,)? (?:[.,;:]|but|and|while)+ (?:only )?(?:that one|those(?: two| ones)?|these(?: two)?|it) {_ARE}"
EXCEPTED_ACROSS: tuple[Turn, ...] = (
    # what the exception looks like, told behind it
    (f"\\b((?:they are |are )?all(?: of (?:them|these|those)| (?:the )?{_BLOCKS})?(?: {_ARE})? (?:in )?{COLOR}(?: ,)?) "
     f"{_EXCEPT} (the [^.,;:]+?){_BEHIND} (?:all |both )?({COLOR})(?= [.,;!]|$)", "{1} except {2} , which are {3}"),
    (f"\\b(all(?: of (?:them|these|those)| (?:the )?{_BLOCKS})?(?: {_ARE})? (?:in )?{COLOR}) but not (?=the )",
     "{1} except "),
    (f"\\ball {_EXCEPT} (the [^.,;:]+?)(?: {_ARE})? ({COLOR}){_BEHIND} (?:all |both )?({COLOR})(?= [.,;!]|$)",
     "{1} {3} , all the others {2}"),
)  # fmt: skip
"""What is looked for in a text, and what is said instead: "all are red except the middle one. That one is blue"."""
WORDS = ("rid discard",)
"""Words that these take besides those that are read anyway."""
