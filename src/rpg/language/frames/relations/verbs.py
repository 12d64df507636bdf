"""Verbs, joints and words without meaning in statements about single blocks, small lots and patches."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, patterns

_REST = (
    "sit|stand|lie|rest|perch|hide|live|dwell|end up|finish|finish up|end|land|settle|settle down|wait|balance|stop|"
    "come to rest|come to stand|come to lie|come to sit|find its place|find a place|take its place|"
    "nestle|appear"
)
_RESTS = (
    "sits|stands|lies|rests|perches|hides|lives|dwells|waits|balances|has its place|nestles|appears|"
    "sitting|standing|lying|resting|perching|perched|hiding|hidden|sat|stood|located|situated|positioned|placed|"
    "set|laid|found|seen|put|parked|balanced|balancing|waiting|installed|deposited|moved|brought|settled"
)
_COMES = (
    "end up|finish|finish up|land|settle|come to rest|come to stand|come to lie|come to sit|ends up|finishes|"
    "finishes up|ends|lands|settles|stops|comes to rest|comes to stand|comes to lie|comes to sit|"
    "finds its place|finds a place|takes its place"
)
_MUST = (
    "must|should|shall|has to|have to|need to|needs to|needs|ought to|"
    "is to(?! (?:the|its) )|are to(?! (?:the|its|each) )|is supposed to|are supposed to|will|"
    "is going to|has got to|is required to|are required to"
)
_DO = (
    "put|place|set|move|bring|lay|position|shift|push|slide|get|stick|pop|plop|stand|sit|rest|drop|carry|transfer|"
    "locate|make|let|perch|balance|plonk|pull|drag|nudge|set down|put down|lay down|relocate|arrange|deposit|shove|"
    "lift|park|have"
)
_DOING = "putting|placing|setting|moving|bringing|laying|positioning|pushing|sliding|getting|sticking|popping|stacking"
_WANTS = "(?:i|I|we) (?:want|would like|need|wish|would love)"
_SHOWN = "(?:picture|image|scene|shot|view|photo|frame|state|result|goal|task|arrangement|configuration)"
MOODS: list[Pattern] = [
    *patterns("be", "moved",
        f"(?:{_MUST}) be (?:moved|brought|taken|transferred|shifted|relocated|pushed)"),
    *patterns("be", "must",
        f"(?:{_MUST})(?: also)?(?: to)?(?: (?:be|go|come|get|touch(?= each| one)|{_REST}))?(?: (?:{_RESTS}))?",
        f"(?:wants |want |likes |like )?to (?:be|go|come|{_REST})",
        f"{_COMES}|goes|go|belongs|belong|comes|come|going|(?:may|can)(?= not )"),
    *patterns("be", "could", "could"),
    *patterns("be", "must", "(?:(?:must |should |shall )?(?:remains?|stays?))(?= on the TABLE)", "go over(?= to)"),
    *patterns("be", "may", f"(?:may|can) (?:be|go|come|{_REST})"),
    *patterns("be", "make",
        f"(?:{_DO})(?: (?:down|over|up))?(?= (?!where|alone|as))", "(?:move|slide|push|shift) (?:away|over|back)"),
    *patterns("be", "make", f"(?:would you mind|how about) (?:{_DOING})"),
    *patterns("be", "is", "(?:do|does)(?= not (?:touch|stand|lie|sit|go|belong|rest|end|come|get|land|finish|stay) )"),
    *patterns("be", "stack", "stack(?: up)?"),
    *patterns("be", "is", "is|are|being|be", f"(?:(?:is|are|be|being|has been|have been) )?(?:{_RESTS})",
        "lie|hide|live|wait"),
    *patterns("there", "is",
        "there (?:is|are)|(?:i|I|we|you) have(?: got)?|"
        "got(?= (?:a|an|NUM|some) )|you see|one sees|i see|I see|we see|here (?:is|are)"),
    *patterns("there", "must", "there (?:must|should|shall|has to|have to|needs to|will) be|let there be"),
    *patterns("take", None, "take|use|pick|pick up|grab|using|given|you get|we use"),
    *patterns("keep", None,
        "keep|leave|leaves|keeps|leaving|keeping|stays|stay|remains|(?:must |should |shall |has to |have to |is to )"
        "(?:stay|remain)"),
    *patterns("not", "not", "not|without(?: being)?"),
    *patterns("not", "never", "never"),
    *patterns("have", None, "with|has|have|having|(?:must|should|shall|is to|has to) have"),
    *patterns("which", None,
        "(?:which|that)(?= (?:is|are|must|should|carries|supports|bears|touches|stands|sits|lies|rests) )"),
    *patterns("that", None, "so that|such that|in such a way that|until|so(?= (?:it|they|the) )"),
    *patterns("first", None, "first|firstly|first of all|first off"),
    *patterns("then", None,
        "then|after that|afterwards|and then|after this|and after that|and afterwards|thereafter|thereupon|finally",
        "next(?= ,)",
        "secondly|second(?= ,)", "(?:once|when|as soon as) (?:that|this) is (?:done|finished)", "only then",
        "in a second step|in the second step|in the next step|as a second step"),
    *patterns("glue", None, f"now(?= (?:{_DO}|take) )"),
    *patterns("now", None, "(?:right |just )?now|currently|at the moment|at present|at first|to begin with"),
    *patterns("end", None, "(?:at|in) the end"),
    *patterns("join", None, "and|n|while|whereas|but|and also|as well as|plus|whilst|yet|nor"),
    *patterns("comma", None, ","),
    *patterns("stop", None, "[.;:!?]"),
]  # fmt: skip
"""Words that bind things and relations together. The value of "be" tells whether something is told or asked for."""
GLUE: list[Pattern] = [
    *patterns("glue", None, "please|kindly|pls|(?:could|can|would|will) you|you|i|we|me|us|for (?:me|us)|maybe"),
    *patterns("glue", None,
        "you (?:must|should|have to)|let us|want|would like|(?:i|I|we) (?:want|would like|need) you to|shall we"),
    *patterns("glue", None, "(?:be )?so (?:kind|good) (?:as to|and)|thanks|thank you(?: (?:very|so) much)?|cheers"),
    *patterns("glue", None, "hello|hi|hi there|hey|dear|okay|ok|carefully|gently|simply|just|nicely|neatly"),
    *patterns("glue", None,
        "also(?= (?:must|should|put|place|set|move|is|are|touch|on|next|to|in|left|right|behind|under|near|beside) )"),
    *patterns("glue", None, "that(?= the)", "(?:dear |my )?(?:robot|friend|buddy|computer)", "over(?= (?:until|so) )",
        "down(?= (?:so|until) )", "off(?= (?:and|,) )"),
    *patterns("sure", "must", f"{_WANTS}(?: that| to (?:see|have)| it so that)?", "let (?:me|us) (?:see|have)",
        "it must be that",
        "it is (?:important|necessary|required|essential|desired|wanted|vital) that"),
    *patterns("sure", "must",
        f"(?:in )?(?:the |my |a )?(?:final |end |finished |last |closing |goal |target )?{_SHOWN}"
        f"(?: is| shows| :)(?: that)?",
        f"in (?:the (?:final |finished )|this ){_SHOWN}",
        rf"(?:the |my |a )?(?:final |end |finished |last |closing |goal |target )?{_SHOWN} (?:(?:must|should|shall|has "
        r"to|needs to) )?(?:satisfy|satisfies|fulfills?|meets?|show|be|look like this)(?: the following)?"
        r"(?: conditions?| requirements?| constraints?)?(?: :| that)",
        "(?:the|your) (?:goal|task|aim|job) is(?: for| to| that| to have)?"),
    *patterns("glue", None, "not (?:necessarily|needing to be) touching"),
    *patterns("sure", "do", "(?:(?:make|be) sure|ensure|make it so)(?: that)?|see to it that|see that|take care that",
        "(?:arrange|set up|make) (?:it|things|everything) (?:so|such) that"),
]  # fmt: skip
"""Words that say nothing of their own beside parts: none that denies, compares, or binds parts in another way. Behind
those of the kind "sure" stands what shall come about."""
