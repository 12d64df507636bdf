"""Who wants something and how it is asked for; this says nothing of what is to be made."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, patterns

_PERSON = (
    "(?:son|daughter|child|kid|baby|toddler|boy|girl|brother|sister|mother|mom|mum|mommy|father|dad|daddy|wife|"
    "husband|friend|cat|hamster|pet|grandma|grandpa|grandmother|grandfather|nephew|niece|cousin|aunt|uncle|boss|"
    "teacher|class|school|team|neighbor|neighbour|professor|student|company|city|town|country|family|partner|"
    "girlfriend|boyfriend|colleague|doll|teddy)"
)
WHOSE = f"(?:(?:my|our|his|her|the|their|your)(?: (?:little|big|older|younger|best|old|new))? {_PERSON})"
"""Somebody or something that has a name."""
MOVED = (
    "deposit|deposited|deliver|delivered|transport|transported|transfer|transferred|bring|brought|carry|carried|drop|"
    "dropped|throw|thrown|toss|tossed|dump|dumped|chuck|pop|stick|shove|slide|store|stored|stow|stowed|send|sent|"
    "put away|put back|tidy away|clear away|clear up|relocate|relocated|assign|assigned|allocate|allocated|locate|"
    "located|position|positioned|push|pushed"
)
"""Ways to bring a block somewhere."""
WISHES: list[Pattern] = patterns(
    "glue", None,
    f"for {WHOSE}s?(?: please)?", f"for {_PERSON}",
    "(?:mommy|daddy|mom|dad|mum|grandma|grandpa)(?= with| of| ,| and)", "(?:tower|stack|pile|color|colors|sorting|"
    "math|maths|spelling|building|letter|word|number|cluster) time", "for (?:kids|children|pupils|students|fun|"
    "school|homework|practice)",
    f"{WHOSE}s? (?:wants?|needs?|likes?|would like|would love|wishes|asks? for|asked for|asked|wanted|loves?)"
    "(?: me| you| us)?(?: to see| to have)?(?: to)?",
    "(?:it )?(?:would be|will be|is) (?:very |really |so )?(?:nice|great|lovely|good|cool|perfect|awesome|wonderful|"
    "fun)(?: to (?:see|have))?(?: if (?:you|we|i)(?: could| can)?)?",
    "(?:how|what) about(?: you| we| if you)?", "if you (?:could|can|would|please)", "(?:do )?(?:you )?mind",
    "(?:i am|i m) (?:hoping|looking|asking) (?:for|to (?:see|get|have))", "(?:i|we) (?:hope|expect|wish|prefer) (?:for|"
    "to see|that)?",
    "(?:it is|this is) (?:required|necessary|desired|requested|important|needed) (?:that|to)",
    "(?:the )?(?:robot|agent|arm|manipulator|robot arm|gripper)(?: (?:must|should|shall|will|has to|is to|needs to|"
    "is required to|is asked to))?",
    "(?:your|the|my|our|its) (?:task|job|goal|mission|assignment|objective|aim)(?: here)? (?:is|:)(?: to)?",
    f"help {WHOSE}(?: to| with)?(?: ,)?(?: and)?",
    "(?:everything|it|my BLOCK|the BLOCK|my TABLE|the TABLE) (?:is|are) (?:such )?(?:in )?(?:a )?(?:total |real |big )?"
    "(?:mess|messy|chaos|all over the place|all mixed up|mixed up|jumbled up|untidy)",
    "help(?: me| us| out)?(?: to)?|go ahead(?: and)?|try(?: to)?|start by|proceed to|make sure(?: that)?|ensure(?: "
    "that)?|see to it that|have (?:it|them)|you see|got|all right|alright|ok|okay|so|well|hey|hi|hello there",
    "picture this|imagine(?: this)?|here is (?:the|my|a) (?:deal|plan|idea|task|challenge|thing)|listen|do(?! not)",
    "(?:keep|make) it (?:simple|short|easy|quick)|away|provide|present|compose|generate|establish|realize|achieve|"
    "obtain|"
    "craft|fashion|assemble|construct|produce|(?:i am|i m) thinking(?: of)?",
    "(?:a )?(?:bunch|number|couple|set|box|bag) of (?:BLOCK|letters|digits|numbers)(?: here)?",
    "obviously|of course|naturally|you know|basically|simply|actually|just",
    "take|pick|grab|get|choose|select|fetch|pick up|with the help of|thanks|thank you|thx|pls|plz",
)  # fmt: skip
