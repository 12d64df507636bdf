"""Two rows or two words, one behind the other: "the far row spells CAT and the near row DOG", "CAT and, in front of it,
DOG", "A and B in the back row and C and D in the front row", "first row: ..., second row: ..."."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import permutations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MANY, MUST, WAY
from rpg.language.tokens import Token

_WORD = f"((?!(?:the|an?|them|it|{FEW})\\b)[a-z]{{2,}})"
_LINE = "(?:row|line|tower|stack)"
_END = "(far|back|near|front)"
_AND = "(?: ,)?(?: and| ;)? ?"
_SHOWS = "(?:reads|spells|says|shows)"
_WRITE = "(?:write|spell|put|lay out|lay|make)"
_BESIDE = "(?:behind|in front of|to the left of|to the right of)"
_NEAR = "(?:nearer|nearest|closer|closest)(?: to (?:me|us|you|the viewer|the robot))?"
_TWO = f"(?:{_WRITE} )?(?:the words )?{_WORD} and {_WORD}"
_UNDER = "(?:underneath|below|beneath|under)(?: it| that)?(?: ,)?"
_SPELL = "(?:let (?:us|'s) )?(?:write|spell)"
_LOWER = "(?:right |directly |just )?(?:below|under|underneath|beneath)"
_IN_LETTERS = "(?: (?:with|from|using)(?: the)? (?:letters?|letter (?:blocks|cubes)|blocks|cubes))?"
_TWO_LINES = f"(?:{_WRITE} )?(?:the word )?{_WORD}{_AND}(?:{_UNDER} )?(?:the word )?{_WORD}"
_OF = "(?: of (?:digits|numbers|letters|words|blocks|cubes))?"
_IT = "(?:it|that|this|them|these|those)"
_JOINT = "(?: ,| ;| \\.| and)+"
_ROW = "(?: (?:row|line|one|word))?"
_FARTHER = f"(?:the )?(?:first|top|upper|far|back|rear){_ROW}"
_NEARER = (
    f"(?:the )?(?:second|bottom|lower|near|front|next){_ROW}|the (?:row|line|one|word) (?:below|beneath|under|"
    f"underneath|in front of)(?: {_IT})?"
)
_BEYOND = f"(?:the )?(?:second|far|back|rear|top|upper){_ROW}|the (?:row|line|one|word) (?:above|behind)(?: {_IT})?"
_READS = "(?:reads|spells|says|must read|must spell|must say|should read|should spell|should say)"
_LETTERS = "(?:letter (?:cubes|blocks)|letters|words)"
_THE_WORD = f"(?:the word )?(?!{COLOR}\\b){_WORD}"
_TWO_WORDS = f"(?:(?:{_WRITE}|build|form|show) )?(?:the |these )?(?:two|2) words(?: ,| :)+"
_BEFORE_IT = f"(?:in front of|before) {_IT}|(?:in|at)(?: the)? front(?: row)?"
_BEHIND_IT = f"behind(?: {_IT})?|(?:in|at) the (?:back|rear)(?: row)?"
_SYMBOL_LIST = "((?:\\w (?:, and |, |and ))+\\w)"
_COLOR_LIST = f"((?:{COLOR} (?:, and |, |and ))+{COLOR})"
_BEGUN = "^(?:(?:put|lay|make|build) )?(?:an? |one )?row(?: of (?:letters|digits|numbers|blocks|cubes))? : "
_AGAIN = f"(?: {_IT}| the first(?: one| row)?)(?: ,)?(?: there is)? (?:an?|one|another)(?: second)? row : "


def _row_beside_row(listed: str, near: str, far: str) -> tuple[Turn, ...]:
    """ "Row: B, E, A, R. Below it a second row: C, A, T, S."."""
    return tuple(
        (f"{_BEGUN}{listed} [.;] (?:and )?(?:{where}){_AGAIN}{listed}(?= \\.|$)", said)
        for where, said in ((near, "back row : {1} ; front row : {2}"), (far, "back row : {2} ; front row : {1}"))
    )


WORDS_IN_ROWS: tuple[Turn, ...] = (
    *_row_beside_row(_SYMBOL_LIST, "in front of|below|under|underneath|beneath", "behind|above"),
    *_row_beside_row(_COLOR_LIST, "in front of", "behind"),
    (f"^(?:(?:{_WRITE}|put|arrange|place|line up|set) )?(?:(?:the )?{_LETTERS} (?:in|into|as) )?(?:two|2) (?:rows|"
     f"lines)(?: of {_LETTERS})?(?: ,| :| \\.)+ (?={_FARTHER} {_READS} )", ""),
    (f"^{_FARTHER} {_READS} {_THE_WORD}{_JOINT} (?:{_NEARER})(?: {_READS})? {_THE_WORD}(?= \\.|$)",
     "write {1} in the far row and {2} in the near row"),
    (f"^(?:the )?(?:near|front|bottom|lower){_ROW} {_READS} {_THE_WORD}{_JOINT} (?:{_BEYOND})(?: {_READS})? "
     f"{_THE_WORD}(?= \\.|$)", "write {2} in the far row and {1} in the near row"),
)  # fmt: skip
"""Words and lists that are told row by row, over a whole text."""
_ROWS = f"(?:two rows{_OF}(?: ,| :) )?"
_SAME = f"(an? {_LINE} of (?:{FEW}) ({COLOR}) (?:blocks|cubes|ones))"
_MADE = "(?:blocks|cubes)"
_LOOK = "^(?:it should look like this : )?"
_LISTED = "((?:\\S+ , )+(?:and )?\\S+|(?:\\S+ , )*\\S+ and \\S+)"
_AT = "(?:back|far|rear|front|near)"
_BARE = ("^(?!.*\\b(?:grid|square|rectangle|pyramid|wall|checkerboard|\\d+x\\d+|column|columns|rows|lines|words?|spell|"
             "write|read|reads)\\b)")  # fmt: skip
_SYMBOLS = "((?:\\w(?: ,)?(?: and)? ?\\b)+)"
_KINDS = (("odd(?: ones| numbers| digits| blocks)?", "odd numbers"),
          ("even(?: ones| numbers| digits| blocks)?", "even numbers"),
          ("vowels", "vowels"), ("consonants", "consonants"))  # fmt: skip
_ENDS = (("(?:back|rear|far)", "(?:front|near)", "in front of"), ("(?:front|near)", "(?:back|rear|far)", "behind"))
_PUT = "(?:put|place|set|lay|stack|build)"
_DONE = "(?:(?:put|place|set|arrange|lay|make|build|form|line up) )?"
_ALSO = "(?: ,| and| , and)?"
_HAS = f"(?:of|with|made of|made from|has|is|are|contains|consists of|being|{MUST} (?:be|have|contain|consist of))"


def _doubled(many: int) -> Turn:
    """ "A row of red and blue from left to right, and on top of it a second row with the same colors in the same
    order": a wall of two."""
    listed = _ALSO.join([f" ({COLOR})"] * many).strip()
    colors = " , ".join(f"{{{n}}}" for n in range(1, many + 1))
    return (
        f"\\ban? row of {listed}(?: ,)? ({WAY}){_ALSO} on top of it (?:an?|a second|another) row (?:with|of|in) "
        "the same colors(?: ,)?(?: and)? in the same order$",
        f"a wall of 2 rows and {many} columns , each column in one color : {colors} {{{many + 1}}}",
    )


TWO_ROWS_AT_ONCE: tuple[Turn, ...] = (
    *map(_doubled, (2, 3, 4, 5, 6)),
    # words
    (f"^{_TWO} in two rows{_AND}\\1 in the {_END} (?:one|row){_AND}\\2 in the {_END} (?:one|row)$",
     "write {1} in the {3} row and {2} in the {4} row"),
    (f"^{_TWO}(?: ,)? one (?:word )?behind the other(?: ,)?(?: with)? \\1 (?:is |being )?{_NEAR}$",
     "the word {2} behind the word {1}"),
    (f"^{_TWO}(?: ,)? one (?:word )?behind the other(?: ,)?(?: with)? \\2 (?:is |being )?{_NEAR}$",
     "the word {1} behind the word {2}"),
    (f"^(?:write|spell|{_TWO_WORDS}) {_THE_WORD}(?: ,)? (?:{_BEFORE_IT}){_AND}{_THE_WORD} (?:{_BEHIND_IT})$",
     "write {2} in the far row and {1} in the near row"),
    (f"^(?:write|spell|{_TWO_WORDS}) {_THE_WORD}(?: ,)? (?:{_BEHIND_IT}){_AND}{_THE_WORD} (?:{_BEFORE_IT})$",
     "write {1} in the far row and {2} in the near row"),
    *((f"^{_SPELL}(?: the word)? {_WORD}{_IN_LETTERS}(?: ,)? and(?: ,)? {where} it(?: ,)?(?: the word)? {_WORD}$", said)
      for where, said in (("in front of", "write {1} in the far row and {2} in the near row"),
                          ("behind", "write {2} in the far row and {1} in the near row"),
                          ("(to the left of|to the right of)", "the word {3} {2} the word {1}"))),
    # on a table what is written below stands nearer to the viewer
    (f"^{_SPELL}(?: the word)? {_WORD}{_IN_LETTERS}(?: ,)? and(?: ,)? {_LOWER} it(?: ,)?(?: the word)? {_WORD}$",
     "write {1} in the far row and {2} in the near row"),
    (f"^{_SPELL}(?: the word)? {_WORD}{_IN_LETTERS}(?: ,)? (?:and|with)(?: the word)? {_WORD} {_LOWER}"
     "(?: it)?(?: ,)?(?: (?:as|in|on) (?:two|2) (?:rows|lines))?$", "write {1} in the far row and {2} in the near row"),
    (f"^{_SPELL}(?: the word)? {_WORD} {_LOWER}(?: the word)? {_WORD}$",
     "write {2} in the far row and {1} in the near row"),
    (f"^{_SPELL}(?: the word)? {_WORD} (?:right |directly |just )?above(?: the word)? {_WORD}$",
     "write {1} in the far row and {2} in the near row"),
    (f"^((?:write|spell) {_WORD} {_BESIDE} {_WORD}) , each(?: word)? from left to right$", "{1}"),
    (f"^two words ,? ?(?:namely )?{_WORD} and {_WORD} ,(?: with)? {_WORD} ({_BESIDE}) {_WORD}$",
     "the word {3} {4} the word {5}"),
    *((f"^{_TWO_LINES}{lines}$", "write {1} in the far row and {2} in the near row")
      for lines in (" on (?:the|a) (?:next line|line (?:below|underneath|beneath|under it|below it))",
                    "(?: ,)? (?:like|as) (?:two )?lines (?:on|of) a (?:page|text|book|poem)")),
    (f"^(?:{_WRITE} )?{_WORD} (?:on|in) the (?:first|upper|top) line{_AND}{_WORD} (?:on|in) the (?:second|lower|bottom|"
     "next) line$",
     "write {1} in the far row and {2} in the near row"),
    (f"^(?:write|spell) (?:the words )?{_THE_WORD} {_THE_WORD} (?:in|on|as|over) (?:two|2) (?:rows|lines)$",
     "write {1} in the far row and {2} in the near row"),
    # rows
    (f"^{_ROWS}the {_END} row {_SHOWS} {_LISTED}{_AND}the {_END} (?:row|one) {_SHOWS} {_LISTED}$",
     "{1} row : {2} ; {3} row : {4}"),
    (f"^(an? (?:\\w+ )?{_LINE} of) ((?!(?:{FEW})\\b)(?:\\w+ )?{_MADE}) and (an? (?:\\w+ )?{_LINE} of) ((?:\\w+ "
     f")?{_MADE}) , ({FEW}) (?:each|in each|blocks each|of each)$", "{1} {5} {2} and {3} {5} {4}"),
    (f"{_LOOK}(?:in|at) the (?:back|rear) (an? {_LINE} of .+?){_AND}in front of it (an? {_LINE} of .+)$",
     "{2} in front of {1}"),
    (f"\\b(an? (?:front |back )?{_LINE} of [^,]+) and , (?:parallel to it and )?({_BESIDE}) it , (an? {_LINE} of .+)$",
     "{1} and {2} it {3}"),
    (f"\\b(an? {_LINE} of [^,]+) and , (?:parallel to it and )?nearer to me , (an? {_LINE} of .+)$",
     "{1} and in front of it {2}"),
    (f"^{_SAME} parallel to (an? {_LINE} of .+?) ,(?: the)? \\2 (?:row|one) behind$", "{1} behind {3}"),
    (f"^two rows of ({FEW})(?: blocks)? ,(?: the)? first row ({COLOR}){_AND}(?:the )?second row ({COLOR}) ,? ?the "
     "first (?:one |row )?(?:being|is) the (?:far|back) (?:one|row)$",
     "{1} {2} blocks in the far row and {1} {3} blocks in the near row"),
    # rows that are told by where the other one is
    (f"^(.*\\b(?:two|2) rows\\b.*? (?:in|at) the (?:back|rear))(?: row)?{_ALSO} (.+?) (?:in front(?: of)?|before)(?: "
     f"{_IT})?$",
     "{1} and {2} in front"),
    (f"^(.*\\b(?:two|2) rows\\b.*? in)(?: the)? front(?: row)?{_ALSO} (.+?) behind(?: {_IT})?$", "{1} front and {2} "
     "in the back"),
    (f"^(.*\\b(?:three|3) rows\\b.*? (?:in|at)(?: the)? front(?: row)?{_ALSO} (?:.+?)) behind(?: {_IT})?({_ALSO} .+? "
     "(?:in|at) the (?:very )?(?:back|rear)(?: row)?)$", "{1} in the middle {2}"),
    # a row on a row
    (f"\\b(an? row of (?:{MANY} )?(?:{COLOR} )?{_MADE})(?: ,)? (?:with|and)(?: {_PUT})? (an?(?: second| another)? "
     f"row of (?:{MANY} )?(?:{COLOR} )?{_MADE}) (?:(?:stacked|placed|put|lying|standing|sitting) )?(?:directly |right "
     ")?on(?: top of)? (?:it|them)$", "{1} , and on top of them {2}"),
    (f"\\b({MANY}) ranks?\\b", "{1} rows"),
    (f"\\b({_AT}) rank\\b", "{1} row"),
    ("\\b(\\w) thru (\\w)\\b", "{1} to {2}"),
    *(("^(?:put |arrange )?(?:the )?(?:blocks|digits|numbers|cubes|letters) (\\w) to (\\w)(?: ,)?(?: in)? (?:two|2) "
       f"rows(?: :| ,)+ (?:the )?{one}(?: in| at)? (?:the )?{end}(?: row| one)?{_ALSO} (?:the )?{other}(?: in| at)? "
       f"(?:the )?{far}(?: row| one)?$",
       f"there are the blocks {{1}} to {{2}} . the {said} must be in a row . the {rest} must be in a row {where} them")
      for (one, said), (other, rest) in permutations(_KINDS, 2) for end, far, where in _ENDS),
    ("\\b(?:the )?(?:digits|letters|numbers|blocks|cubes) (?:from )?(\\w) to (\\w) in (?:two|2) rows(?: ,| :) "
     f"{_SYMBOLS} (behind|in front of) {_SYMBOLS}$", "there are the blocks {1} to {2} . two rows : {3} {4} {5}"),
    *((f"^(.*\\b(?:two|2) rows(?: ,| :)) {_SYMBOLS} {word} {_SYMBOLS}$", f"{{1}} {{{back}}} in the back and "
     f"{{{front}}} in front")
      for word, back, front in (("behind", 2, 3), ("in front of", 3, 2))),
    (f"^the ({MANY}) (?:blocks|cubes|ones) in the ({_AT}) row (?:{MUST} be|are) ({COLOR})(?: ,| and|;)+ the ({MANY}) "
     f"(?:(?:blocks|cubes|ones) )?in the ({_AT}) row (?:(?:{MUST} be|are) )?({COLOR})$",
     "{1} {3} blocks in the {2} row and {4} {6} blocks in the {5} row"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("rank ranks thru",)
"""Words that these take besides those that are read anyway."""
ROWS_PLACED: tuple[Turn, ...] = (
    (f"{_BARE}{_DONE}(?!.* row .* row .* row)(?!all )(\\S+ .+?) (?:in|as|into|on) (?:the|a) ({_AT}) row{_ALSO} "
     f"(?:{MUST} )?(\\S+ .+?) (?:in|as|into|on) (?:the|a) ({_AT}) row$", "{2} row : {1} . {4} row : {3}"),
    (f"{_BARE}{_DONE}(?!.* row .* row .* row)(?:the|a) ({_AT}) row {_HAS} (.+?){_ALSO} (?:the|a) ({_AT}) row {_HAS} "
     "(.+)$", "{1} row : {2} . {3} row : {4}"),
)  # fmt: skip
"""Those that come last: in words and on boards, rows are told by others."""
_PAGE = {"first": "back", "second": "front"}
_BOARDS = frozenset(
    {"grid", "square", "rectangle", "pyramid", "wall", "checkerboard", "layer", "third", "stack", "tower"}
)


def rows_by_number(tokens: list[Token]) -> list[Token]:
    """The tokens, with a first row as the one at the back and a second as the one in front, as on a page."""
    words = [token.word for token in tokens]
    heads = [n for n in range(len(words) - 2) if words[n + 1] == "row" and words[n + 2] == ":"]
    if [words[n] for n in heads] != [*_PAGE] or not _BOARDS.isdisjoint(words):
        return tokens
    return list(_paged(tokens, heads))


def _paged(tokens: list[Token], heads: list[int]) -> Iterator[Token]:
    for n, token in enumerate(tokens):
        yield replace(token, word=_PAGE[token.word]) if n in heads else token
