"""What is to be done told by nouns, "placement of the red cube onto the green mat, followed by the stacking of ...", as
rows that tell it by verbs."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn

_DOINGS = {
    "put": "placement|placing|positioning|putting|moving|movement|transfer|relocation|depositing|laying|setting",
    "stack": "stacking|piling(?: up)?",
    "sort": "sorting|grouping",
    "arrange": "arrangement|arranging|ordering|alignment|aligning|lining up",
    "build": "construction|constructing|building|formation|forming|creation|creating|assembly|assembling|erection|"
             "erecting|making",
    "spell": "spelling|writing",
    "swap": "swapping|exchange|exchanging|interchange",
    "separate": "separation|separating",
    "remove": "removal|removing",
    "turn": "rotation|rotating|turning",
}  # fmt: skip
"""Verbs, each with the nouns that tell of doing so."""
_ASKED = (
    "(?:(?:the|my|our|your) )?(?:task|goal|aim|objective|purpose|job|target|assignment|exercise|request|order|"
    "instruction)"
)
_THIS = "(?:this|it|the (?:task|job|assignment|exercise|goal|solution))"
_LED = (
    f"(?:{_ASKED}(?: is| :| consists (?:of|in))|(?:required|desired|needed|wanted|requested|expected|planned)"
    f"(?: is| :)?|{_THIS} (?:requires|demands|involves|calls for|asks for|needs|consists (?:of|in))"
    "|what (?:is|we|i) (?:required|desired|needed|wanted|requested|need|want|require)(?: here)? is|please :?)"
)
_NEXT = "(?: ,)?(?: and)?(?: then)?(?: followed by| after (?:that|which)| then)"

_SPELLED = f"^(?:{_LED} )?(?:the )?(?:{_DOINGS['spell']}) of (?=(?:the )?(?:word|name)\\b)"

NOMINAL_AT_ONCE: tuple[Turn, ...] = ((_SPELLED, "spell "),)
"""A word whose spelling is asked for is not told once more by itself."""
NOMINAL: tuple[Turn, ...] = (
    *((f"^first(?: ,)? the (?:{nouns}) of (?=\\S+ )", f"first , {verb} ") for verb, nouns in _DOINGS.items()),
    *((f"\\bthen(?: ,)? (?:comes )?the (?:{nouns}) of (?=\\S+ )", f"then {verb} ") for verb, nouns in _DOINGS.items()),
    *((f"^(?:{_LED} )?(?:the )?(?:{nouns}) of (?=\\S+ )", f"{verb} ") for verb, nouns in _DOINGS.items()),
    *((f"^((?:{'|'.join(_DOINGS)}) .+?){_NEXT} (?:by )?(?:the )?(?:{nouns}) of (?=\\S+ )", f"{{1}} . then , {verb} ")
      for verb, nouns in _DOINGS.items()),
    *((f"^((?:{'|'.join(_DOINGS)}) .+?)(?: ,| and| , and| as well as) (?:the )?(?:{nouns}) of (?=\\S+ )",
       f"{{1}} . {verb} ") for verb, nouns in _DOINGS.items()),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = (
    "placement placing positioning movement transfer relocation depositing stacking piling sorting grouping "
    "arrangement ordering alignment aligning construction constructing formation creation assembly erection erecting "
    "spelling exchange interchange separation removal rotation requires demands involves calls request instruction "
    "assignment",
)
"""Words that these take besides those that are read anyway."""
