"""Two words, each in a row of its own, or one that is there twice: "spell DOG in one row and CAT in another row in
front of it", "spell SEA twice, one word behind the other". The second is spelled in a sentence of its own."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW

_ASKED = "^((?:please |can you |could you )?(?:spell|write)) (?:the word )?(?!(?:the|an?|it|them)\\b)"
_NUMBER = f"(?!(?:{FEW})\\b)"
_WORD = "([a-z]{2,})"
_FIRST = f"{_ASKED}{_NUMBER}{_WORD}"
_THINGS = "(?:block|cube|box|letter|digit|number|symbol|patch|mat|tower|stack|row|word|(?:no|any|some|every)thing)"
_OTHERS = (
    "(?:none|another|others?|more|some|any|all|both|each|every|enough|plenty|nobody|no|not|space|room|gaps?|air|only|"
    "just|also|still|them|this|that|these|those|it|the|an?)"
)
_SECOND = f"(?:the word |(?!(?:{COLOR}|{FEW}|{_OTHERS}|{_THINGS}s?(?:es)?)\\b)){_WORD}"
_BESIDE = "((?:right |directly |just )?(?:behind|in front of|to the left of|to the right of))"
_IT = "(?:it|that|this|the first(?: one| row| word)?)"
_ROW = "(?: row| line)"
_ONE = f"(?: in (?:an?|one){_ROW}?)?"
_OTHER = f"in (?:another|a second)(?: one|{_ROW})?"
_AND = "(?: ,)?(?: and(?: then)?)?(?: ,)?"
_TWICE = "(?: ,)? (?:twice|two times)(?: ,)?(?: with)?"
_ENDS = "(?= [.!;]|$)"
_THERE = "((?:in|on|at|to) [^,.;!]+?)"
_TO_EACH_OTHER = (
    "(side by side|next to each other|beside each other|one (?:behind|in front of) the other|(?:at least )?[\\d.]+ cm "
    "apart)"
)
_BEHIND_IT = "{1} {2} . {1} {3} {4} it"

TWO_WORDS: tuple[Turn, ...] = (
    (f"{_FIRST}{_ONE}{_AND} {_SECOND} {_OTHER} {_BESIDE} {_IT}{_ENDS}", _BEHIND_IT),
    (f"{_FIRST}{_ONE}(?: [.;])?{_AND} {_OTHER} {_BESIDE} {_IT}(?: ,)?(?: spell| write)? {_SECOND}{_ENDS}",
     "{1} {2} . {1} {4} {3} it"),
    (f"{_FIRST}{_ONE}{_AND} {_BESIDE} {_IT}(?: ,)? {_SECOND} {_OTHER}{_ENDS}", "{1} {2} . {1} {4} {3} it"),
    (f"{_FIRST} [.;] and {_SECOND} {_BESIDE} {_IT}{_ENDS}", _BEHIND_IT),
    (f"{_FIRST}(?: ,)? with {_SECOND} {_BESIDE} {_IT}{_ENDS}", _BEHIND_IT),
    (f"{_ASKED}{_WORD} in the (?:front|near){_ROW}{_AND} (?:the word )?{_WORD} in the{_ROW} (behind) {_IT}{_ENDS}",
     _BEHIND_IT),
    (f"{_ASKED}{_WORD} in the (?:back|far|rear){_ROW}{_AND} (?:the word )?{_WORD} in the{_ROW} (in front of) "
     f"{_IT}{_ENDS}", _BEHIND_IT),
    (f"{_FIRST}{_TWICE} one(?: of them| word| row)? {_BESIDE} the other{_ENDS}", "{1} {2} . {1} another {2} {3} it"),
    (f"{_FIRST}{_TWICE}(?: ,)? once {_THERE}{_AND} once {_THERE}{_ENDS}", "{1} {2} {3} . {1} another {2} {4}"),
    (f"^(?:please )?(?:spell|write) (?:(?:the )?(?:two )?words )?(?:the word )?{_NUMBER}{_WORD} and {_SECOND}(?: ,)? "
     f"{_TO_EACH_OTHER}{_ENDS}", "the word {1} and the word {2} must be {3}"),
    (f"{_FIRST}{_TWICE}{_ENDS}", "{1} {2} . {1} another {2}"),
)  # fmt: skip
"""What is looked for over a whole text, and what is said instead."""
