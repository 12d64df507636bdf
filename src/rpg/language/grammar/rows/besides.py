"""What is there besides, what is so at the start and at the end, and which of two it is, said around the goal, as rows
that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, IS, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MUST, PATCH

_MANY = f"(?:\\d+|{FEW}|an?|some|the)"
_COUNTED = f"{_MANY} (?:(?!with\\b|on\\b|distract)\\w+ ){{0,2}}?(?:{BLOCK}s?|{COLOR})"
_LOTS = f"{_COUNTED}(?:(?: ,| and| , and)+ {_COUNTED})*(?: {BLOCK}s?)?"
_DISTRACTION = "(?:a )?(?:distraction|distractors?|distractions)"
_THERE = "(?: (?:lying |standing )?around| there| nearby| present)?(?: on the table)?(?: too| as well| besides)?"
_LIE = f"(?:there (?:are|is|{MUST} be) (?:also )?|we (?:also )?have )"
_HARDER = ("(?:(?:just )?to (?:make (?:it|this|things|the task) (?:a (?:bit|little) )?(?:harder|more difficult|"
           "trickier|more interesting|less easy)|distract|confuse)(?: (?:the robot|the agent|it|you))?)")  # fmt: skip
_AT_FIRST = "(?:at first|(?:at|in) the (?:start|beginning)|initially|originally|now|currently|to begin with)"
_LIES = "(?:is|are|lies?|stands?|sits?|rests?)(?: located| placed| lying| standing| sitting| situated)?"
_RUN = "(?:episode|rollout|run|trial|task|execution|game|simulation|test)"
_SHOWN = "(?:demo|demonstration|video|clip|recording|animation|film|movie|rollout|session)"
_NO_MATTER = ("(?:it is (?:not important|unimportant|irrelevant|all the same|not relevant)|it (?:does not|makes no) "
              "(?:matter|difference)|no matter|(?:i|we) (?:do not|really do not) (?:mind|care)) which"
              "(?: one| of them| of the two)?(?: it is)?")  # fmt: skip
_ALL_THE_SAME = (
    "(?:it (?:does not|makes no) (?:matter|difference)|it is all the same|(?:both|either)(?: one| way)? "
    "(?:is|are) (?:fine|ok|okay|good|all right|allowed)|(?:i|we) do not (?:mind|care))(?: to me| for me)?"
)
BESIDES_AT_ONCE: tuple[Turn, ...] = (
    # what is there besides
    (f"^(?:as|for) {_DISTRACTION}(?: ,)? {_LIE}({_LOTS}){_THERE}$", "there are {1} as distractors"),
    (f"^(?:as|for) {_DISTRACTION}(?: ,)? ({_LOTS}) (?:lie|stand|are|is|lies)(?: also)?{_THERE}$",
     "there are {1} as distractors"),
    ("\\b(as (?:mere |a )?(?:distractors?|distractions?)) , (?:they|these|those|it) (?:have|has|are|is) (?:of )?(?:no "
     "importance|no meaning|not important|unimportant|irrelevant|not relevant)$", "{1}"),
    (f"^(?:in addition ,? ?|additionally ,? ?|also ,? ?)?({_LOTS}) , which (?:only )?(?:serve|act|are there|are)(?: "
     f"only| just| merely)? as distractors(?: only)? , (?:{MUST} be|are)(?: present| there| lying)?(?: on the table)?$",
     "there are {1} as distractors"),
    (f"^{_HARDER}(?: ,)? {_LIE}({_LOTS}){_THERE}$", "there are {1} as distractors"),
    (f"^(?:put|place|lay|set) ({_LOTS})(?: down)? on the table(?: too| as well| also)? {_HARDER}$",
     "there are {1} as distractors"),
    (f"^((?:the )?{_LOTS}) (?:that|which) (?:are|is|lies?|stands?) (?:also )?(?:there|around|on the table)(?: too| "
     "also| as well)? (do not|does not|are not|is not|are|is) ", "{1} {2} "),
    (f"^(.+?)(?: ,)? with ((?:{_MANY} \\w+(?: and | , ))?{_MANY} (?:\\w+ )?distractors?(?: {BLOCK}s?)?)(?: lying| "
     "standing)?(?: around| present| there| nearby)? on the table$", "{1} . there are {2}"),
    (f"^({_LIE}{_LOTS}) you (should|must|can|may) (?=ignore\\b)", "{1} which you {2} "),
    (f"^the table (?:also )?(?:has|holds|carries) ({_LOTS})(?: (?:lying )?on it)?(?: too| as well| also)?"
     "(?= (?:that|which) |$)", "there are {1}"),
    # when it is so
    (f"\\b(the|this|our|my|each|every|a) {_SHOWN}(?= (?:{MUST} )?(?:ends?|finish|finishes|stops?|closes?|concludes?|"
     "starts?|begins?)\\b)", "{1} episode"),
    (f"\\b(start|beginning|end|finish) of (the|this|our|my|each|every) {_SHOWN}\\b", "{1} of {2} episode"),
    (f"^(?:after|following|at the end of|by the end of) (?:the|an|each|every) {_RUN}(?: ,)? (?=\\w)", "at the end ,"),
    # which of two
    (f"(?: ,)?(?: and| but)? {_NO_MATTER}$", ""),
    (f"^(.+? or .+?)(?: ,)?(?: and| but)? {_ALL_THE_SAME}$", "{1}"),
    (f"^(?:one|exactly one|just one) of (?:the two|them|these)(?: {BLOCK}s)? , ({THING}) or ({THING}) , {IS} on the "
     "other(?: one)?$", "{1} must be on {2} or {2} must be on {1}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
BESIDES: tuple[Turn, ...] = (
    # where it is at first
    (f" , (?:which|that) {_AT_FIRST} {_LIES} ((?:on|in|next to|to the|in front of|behind|under) [^,]+?) ,",
     ", which starts {1} ,"),
    (f"^({THING}) (?:starts|begins|is|lies|stands)(?: {_AT_FIRST})? (on|in) (the [^,]+?)(?: and| , and| , but| but) "
     f"(?:it )?{MUST} (?:leave|get off|come off|go away from) (?:it|there|that|that {PATCH}|the {PATCH})$",
     "at the start , {1} is {2} {3} . {1} must not be {2} {3}"),
    # what alone counts
    ("^(?:(?:all|the only thing) (?:that )?|what )(?:matters|counts)(?: here| most)? is (?:that )?(.+)$",
     "at the end {1}"),
    # how it looks
    ("^(?:what|how) (?:it|everything|the table|the scene|the result) (?:should|must|has to|is to) look(?: like)?(?: "
     "(?:at|in) the end| afterwards| finally)? ?(?:is|:|is this :|is like this :) (.+)$", "{1}"),
    # which of two
    (f"^either {PATCH} , (?:the )?({COLOR}) or (?:the )?({COLOR})(?: one)? , (?:is|would be|will be) (?:fine|okay|ok|"
     f"all right|good|allowed) for ({THINGS})$", "{3} must be on the {1} or the {2} patch"),
    (f"^it (?:does not matter|is not important|makes no difference) (?:whether|if) ({THINGS}) (?:is|are|lies?|goes|go|"
     f"stands?) (.+? or .+?)(?: ,)? but (?:it|they) {MUST} be (?:on|in|at) (?:one|either)(?: of them| of the two| or "
     "the other)?$", "{1} must be {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("distraction distractions harder trickier episode rollout execution simulation destination waiting "
         "demonstration video clip recording animation film movie session parked "
         "importance unimportant irrelevant relevant whether",)  # fmt: skip
"""Words that these take besides those that are read anyway."""
