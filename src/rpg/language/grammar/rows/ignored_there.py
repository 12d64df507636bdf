"""Blocks that lie about and are not meant: "there are two brown ones lying around too, just ignore them", "you will
also see a pink cube, but do not use it"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW

_MANY = f"(?:\\d+|{FEW}|an?)"
_MORE = "(?:(?:more|other|further|extra|additional|plain|blank) )?"
_LOT = f"{_MANY} {_MORE}(?:{COLOR}(?: {BLOCK}s?| ones?)?|{BLOCK}s? \\w)"
_LOTS = f"(?:{_LOT}(?: ,| and| , and) )*{_LOT}(?= )"
_ONE = f"(?:one|an?) {_MORE}(?:{COLOR}(?: {BLOCK}| one)?|{BLOCK} \\w)(?= )"
_LEAD = "(?:(?:and|but|also|besides|additionally|in addition|oh|note that|by the way) ,? ?)*"
_THERE_ARE = (
    "(?:there (?:is|are|will be|might be|may be)(?: also)?|i (?:also )?see|(?:you|we) (?:will |might |may )?(?:also )?"
    "(?:see|find|have))"
)
_AROUND = (
    "(?: (?:(?:lying|standing|sitting) )?(?:around|about|there|nearby)| lying| standing| present| too| as well| also|"
    " on the table| in the scene| somewhere| at the start)*"
)
_ARE = "(?:is|are|lies?|stands?|sits?)(?: also)?(?: lying| standing| sitting)?(?= )"
_AND = "(?: ,| \\.| ;| -| :)?(?: (?:and|but|so|please|just|simply|you can|you may|you should|they should|better|,))*"
_TAIL = "(?: please| here| for (?:now|the moment)| in this task| for this task| , please| at all| though)*"
_BEGIN = "(?:^|(?<= [.;!:?] ))"
_END = "(?= [.;!]|$)"


def _not_meant(them: str, they: str) -> str:
    """What is said of such blocks, by what stands for them."""
    return (
        f"(?:(?:ignore|disregard|forget(?: about)?|do not (?:use|mind|worry about|bother with|bother about|care about)|"
        f"never mind|pay no attention to|leave out) (?:{them})|leave (?:{them}) out|"
        f"(?:{they}) (?:(?:do|does) not (?:matter|count|play a role|belong to it|belong to the task)|"
        "(?:are|is) (?:not (?:needed|used|relevant|important|part of it|part of the task)|irrelevant|unimportant|"
        "(?:just |only )?(?:distractors|a distractor))|(?:play|plays|have|has) no role|"
        "(?:can|should|must|may) be (?:ignored|disregarded)))"
    )


def _rows(lots: str, said: str) -> tuple[Turn, ...]:
    return tuple(
        (f"{_BEGIN}{_LEAD}{there}{_AND} {said}{_TAIL}{_END}", "there are {1} as distractors")
        for there in (f"{_THERE_ARE} ({lots}){_AROUND}", f"({lots}){_AROUND} {_ARE}{_AROUND}")
    )


IGNORED_THERE: tuple[Turn, ...] = (
    *_rows(_LOTS, _not_meant("them|these(?: ones)?|those(?: ones)?|both", "they|these|those")),
    (
        "\\b(?:ignore|disregard) (?:everything else|anything else|all else|(?:all )?the (?:rest|others|other (?:things|"
        f"blocks|cubes)))(?: on the table| there| you see)*(?: :| ,)(?: namely)? ({_LOTS}){_AROUND}{_END}",
        "there are {1} as distractors",
    ),
    (
        "\\b(ignore|disregard) (the (?:digits|letters|numbers|symbols)) \\. (.*\\bthere (?:is|are) [^.]*)(?= \\.$|$)",
        "{3} . {1} {2}",
    ),
    (
        f"{_BEGIN}extra (?:{BLOCK}s|objects|things)(?: on the table| in the scene)? : "
        f"({_LOTS})(?: \\( distractors \\))?{_END}",
        "there are {1} as distractors",
    ),
    *_rows(_ONE, _not_meant("it|this one|that one", "it|this one|that one")),
)
"""Over a whole text: what is looked for, and what is said instead."""
WORDS = ("disregard forget bother attention relevant unimportant irrelevant blank",)
"""Words that these take besides those that are read anyway."""
