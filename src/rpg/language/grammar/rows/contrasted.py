"""What is said once more by its contrary, "..., not the other way round", "in descending, not ascending, order", as
rows that say it once; and what only looks denied."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LINE, MUST

_MOST = f"(?:at most|not more than|no more than|maximally) (?:{FEW}|\\d+)"
_LEAST = f"(?:at least|not fewer than|no fewer than|minimally) (?:{FEW}|\\d+)"
_BUT = "(?:(?: ,)?(?: but| and| yet)(?: also)?| ,)"
_ONE = "(?: (?:block|cube|one))?"
_AT = "on(?: top of)?|under|behind|in front of|(?:to the )?(?:left|right) of"
"""What one thing is to another that this one is not to it."""
_JUST = "no more(?: and| ,)? no (?:fewer|less)"
_THEM = "(?: of (?:them|these|those)| one)?(?: ,)?(?: though)?"

CONTRASTED: tuple[Turn, ...] = (
    # which of two it is, told ahead of the place
    (f"^(?:put )?not ({THING}) but ({THING}) ({PLACE} .+)$", "{2} must be {3} . {1} must not be {3}"),
    (f"^(?:put )?({THING}) , not ({THING}) , ({PLACE} .+)$", "{1} must be {3} . {2} must not be {3}"),
    # the contrary, which what is said before excludes
    ("^(.+?)(?: ,)? (?:and )?not (?:the other way (?:round|around)|vice versa|the reverse)$", "{1}"),
    (f"^(.*?\\b({COLOR}){_ONE}(?: {MUST} be| is| goes)? ({_AT}) (?:the )?({COLOR}){_ONE})(?: ,)? (?:and )?not "
     f"(?:the )?\\4{_ONE} \\3 (?:the )?\\2{_ONE}$", "{1}"),
    ("^(.+?)(?: ,)? (?:though )?not necessarily in (?:that|this) order$", "{1} , in any order"),
    ("^(put .+? on .+? and .+? on .+?) , in any order$", "{1}"),
    ("\\bin (\\w+) , not \\w+ , order\\b", "in {1} order"),
    (f"^(.*?\\b)(?<!exactly )({FEW}) ((?:of (?:(?:the|my) )?(?:{FEW} )?)?(?:(?!(?:{FEW}) )\\S+ )+?), {_JUST}$",
     "{1} exactly {2} {3}"),
    (f"^(.*?)({_MOST}) (of .+?){_BUT} ({_LEAST}){_THEM}$", "{1} {4} and {2} {3}"),
    (f"^(.*?)({_LEAST}) (of .+?){_BUT} ({_MOST}){_THEM}$", "{1} {2} and {4} {3}"),
    ("(?: ,)? with no (?:tower|color|group) mixed(?: into another)?$", ""),
    ("(?: ,)? (?:not mixing the two|without mixing them)$", ""),
    # what only looks denied
    ("\\bnowhere but (on|in|at)\\b", "{1}"),
    ("\\bkeep ([^,]+?) out of (the middle|the center|the left half|the right half)\\b", "{1} must not be in {2}"),
    ("\\bthat (?:does|do) not touch any other(?: (?:block|cube|one))?(?= and| ,|$)", "that touches no other block"),
    ("\\b(blocks|cubes|ones) that touch(?= and\\b| ,|$)", "{1} that touch each other"),
    # left out
    ("^(.+?) (is|stands|lies) (left|right|in front|behind|to the left|to the right) of (\\S+) , (\\S+) of (\\S+) and "
     "(\\S+) of (\\S+)$", "{1} {2} {3} of {4} , {5} {2} {3} of {6} and {7} {2} {3} of {8}"),
    (f"\\b(an? )({LINE})( of [^,]+?) and another of\\b", "{1} {2} {3} and {1} {2} of"),
    (f"^(in front of|behind|next to|to the left of|to the right of) (an? {LINE} of .+?) there (?:is|is to be|{MUST} "
     "be) another of (.+)$", "{1} {2} there must be a tower of {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
_ORDER_TOLD = "(?=.*\\b(?:first|then|before|after)\\b)"
_CONTRARY = (
    "(?:doing (?:it|this|that|so) )?(?:the other way (?:round|around)|"
    "in (?:the reverse|the other|the opposite|any other|a different|another) order)(?: it)?"
)
_WRONG = (
    "(?:is|are|would be|will be|would|will|does|counts? as|means?|must|may|can|should)(?: be)? (?:(?:a|an|the) )?"
    "(?:wrong|failure|mistake|error|forbidden|invalid|cheating|"
    "not (?:allowed|okay|ok|permitted|valid|right|correct|count|do|acceptable|good))"
)
WRONG_WAY_ROUND: tuple[Turn, ...] = (
    (f"^({_ORDER_TOLD}.+?)(?: [.;,])?(?: (?:and|but))? {_CONTRARY} {_WRONG}(?= \\.|$)", "{1}"),
)
"""What is said of a text in which one thing comes after another, and is so anyway: that the contrary is wrong."""
WORDS = ("versa vice mixing necessarily nowhere failure mistake invalid cheating",)
"""Words that these take besides those that are read anyway."""
