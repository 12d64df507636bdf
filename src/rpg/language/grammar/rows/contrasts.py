"""What is told against something else: "not the red block but the blue one", "on the pink one. Not on the white one.",
"the blocks 1 to 6 in order, but leave out the 4", as rows that say each by itself."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MANY, MUST, PATCH

_MAT = f"the (?:\\w+ )?{PATCH}"
_IS = f"(?:{MUST} (?:be|go|lie|stand)|is|goes|belongs|stands|lies|sits|comes)"
_PUT = "(?:put|place|move|set|lay|stack)"
_BLOCKS = "(?:blocks|cubes|letters|digits|numbers|ones)"
_LEFT_OUT = "(?:leave out|leaving out|omit|omitting|skip|skipping|without using|do not use|not using)"
_SIZE = "|".join(sorted(lexicon.SIZE))
_ONE = f"(?:{THING}|the \\w+ one)"
_STATE = "(stacked|touching|next to each other|on top of each other|in a row)"

CONTRASTS: tuple[Turn, ...] = (
    # the one, and not the other
    (f"^not (the (?:{_SIZE}) ({COLOR}) {CUBE}) but the ({_SIZE}) one (?={_IS} )", "not {1} but the {3} {2} block "),
    (f"^not ({THING})(?: ,)? but ({THING}) ({_IS}) ((?:on|in) {_MAT}|{PLACE} {THING})$",
     "{1} must not be {4} . {2} {3} {4}"),
    (f"^not ({THING})(?: ,)? but ({THING}) ({MUST}) (carry|bear|hold|support|touch) ({THING})$",
     "{1} must not {4} {5} . {2} {3} {4} {5}"),
    (f"^({_PUT}) ({_ONE}) (on|in) ({_MAT})(?: ,)? (?:and |but )?not ({_ONE})$",
     "{1} {2} {3} {4} . {5} must not be {3} {4}"),
    (f"^(.*?(?:one|some|any|two|three) of .+?) ({MUST} be|has to be|have to be|{MUST} lie|goes|go) (on [^,]+?)(?: ,)? "
     f"but not (the {COLOR}(?: one| block| cube)?)$", "{1} {2} {3} . {4} must not be {3}"),
    (f"^((?:nothing|no (?:other )?{CUBE}) (?:{MUST} |may |can )?(?:touch|touches|be) [^,]+?) , (?:but|and|while) "
     "((?:the|both|all) [^,]*?(?:must|should|touch|touches|are|stand|go)\\b(?!.*\\b(?:it|them|they|that|which)\\b).+)$",
     "{1} . {2}"),
    # who is none of them
    ("^(.+?) except (?:for )?(the .+?) , (?:they|it|which|these) (?:stay|remain|lie|are|is|stays|remains|lies)(?: "
     "lying)? "
     "(on the table|where (?:it is|they are))$", "{1} except {2} . {2} must be {3}"),
    # what they are to each other
    (f"^(they|these|the [^,]+?) ({MUST} be|are|may be) neither {_STATE} nor {_STATE}$",
     "{1} must not be {3} . {1} must not be {4}"),
    ("^not (?:one|any) of (them|these) (touches|touch) (?:another|any other|each other|the others?)$",
     "no two of {1} touch"),
    (f"^neither (.+?) nor (.+?) (?:{_IS}) ((?:on|in) [^,]+?)(?: ,)? (?:but )?only (the [^,]+?)(?: is| does| may| must| "
     "should)?$",
     "{1} and {2} must not be {3} . {4} must be {3}"),
    *((f"\\bin a corner(?: ,)? but not in (?:one|any|either) of the (?:{half}) (?:ones|corners)$",
       f"in a corner and in the {other} half") for half, other in
      (("near|front", "far"), ("far|back", "near"), ("left", "right"), ("right", "left"))),
    (f"\\bthan any (?:of the )?({COLOR})(?: ones?| blocks?| cubes?)?(?=$| ,)", "than all {1} blocks"),
    (f"^(.+? (?:stand|are|lie|sit|stay) together)(?: ,| and| , and| but| , but)+ ({THING}) (?:stands|is|lies|stays) "
     "(?:alone|by "
     "itself|on its own)$", "{1} . {2} must be apart from them"),
    # what is left as it is read
    (" , but with (an? [^,]+? in (?:the|its) (?:middle|center)) instead$", " with {1}"),
    (f"\\b({MUST} not|is not|are not) (?:be )?(?:a )?part of (the (?:stack|tower))\\b", "must not be in {2}"),
    ("(?: ,| with)? (?:the )?colors taking turns(?: all the way(?: up)?)?(?=$| ,)", " with alternating colors"),
    ("\\bseparately , (?=one (?:on|for|in) each\\b)", ""),
    (f"^the ({COLOR}) (blocks|cubes) , all ({MANY})(?: of them)?(?: ,)? ", "the {3} {1} {2} "),
    (f"\\b(goes|{MUST} go) there(?: too| as well)?(?: ,)? (on top of|on) ({THING})$", "{1} {2} {3}"),
    (f"^(.+?) ({MUST}(?: not)?|may not|can not) change its (?:place|position|location|spot)$", "{1} {2} be moved"),
    ("\\b(exchange|switch|trade|change) (?:their )?(?:places|positions)\\b", "swap places"),
    ("^(?:an? )?2 ?d (pyramid)\\b", "a flat {1}"),
    ("\\bthe (\\d) (on top of|on|next to|behind|in front of|to the left of|to the right of|under) the (\\d)(?! "
     "\\w+s\\b)",
     "{1} {2} {3}"),
    (f"\\b((?:three|four|five|six|\\d+) ({COLOR}) and (?:three|four|five|six|\\d+) ({COLOR}) "
     "(?:blocks|cubes)\\b.*?)(?: ,)? "
     "(?:so that|with|where) every (?:other|second)(?: one| block| cube)?(?: is)? (?:\\2|\\3)$",
     "{1} with alternating colors"),
    (f"^(?:at the start )?(?:an?|the) (tower|stack) has ({MANY} {COLOR} (?:blocks|cubes)) at the bottom and ({MANY} "
     f"{COLOR})(?: ones| blocks| cubes)? on top$", "at the start there is a {1} of {2} and {3} blocks from bottom to "
     "top"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""

CONTRASTS_ACROSS: tuple[Turn, ...] = (
    (f"^({THING}) (?:stands|is|lies|stays|{MUST} stand) (?:alone|by itself|on its own)(?: [,.;])?(?: and| but| while)? "
     f"((?:all |both |the )[^.,;]+? (?:{MUST} )?(?:stand|are|be|lie|stay) together)(?= \\.|$)",
     "{2} . {1} must be apart from them"),
    (f"^(.*\\b(?:stack|tower|pile|on)\\b.*?) \\. (?:but )?(?:leave|keep) ({THING}) out(?: of (?:it|this|that|the "
     "(?:stack|tower)))"
     "(?= \\.|$)", "{1} . {2} must not be in the stack"),
    (f"^((?:put|place|line up|stack|set|arrange|sort) )?(?:the )?((?:{_BLOCKS}) \\d+ to \\d+)\\b([^.]*?)(?: ,)?"
     f"(?: but| and)? {_LEFT_OUT} (?:the )?(?:{_BLOCKS} )?(\\d+)(?= \\.|$)", "{1} the {2} except {4} {3}"),
    (f"^({_PUT}) ({THING}) on(?: top of)? ({THING}) \\. (?:but )?not on(?: top of)? ({THING})(?= \\.|$)",
     "put {2} on {3} . {2} must not be on {4}"),
    (f"^({THING}) ({_IS}) on ({THING}) and ({THING}) on ({THING}) \\. no ,? ?(?:sorry ,? ?|wait ,? ?)?the other way "
     "(?:round|around)(?= \\.|$)", "{1} {2} on {5} and {4} on {3}"),
)  # fmt: skip
"""The same over a whole text."""
WORDS = ("omit omitting skip skipping taking",)
"""Words that these take besides those that are read anyway."""
