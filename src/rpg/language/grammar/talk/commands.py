"""What stands before a command: to whom it is said, how politely, in which place of several."""

from __future__ import annotations

from rpg.language.grammar.talk.people import EVENTS, FINE, PEOPLE, WISHING
from rpg.language.grammar.talk.slots import Patterns

_PREFACES = (
    "as a|an|the user|player|customer|tester|developer|operator|product_owner|manager|parent|teacher|child|robot|"
    "engineer ,?",
    "as|for a|an|your warm_up|warmup|favor|little_favor|test|challenge|quick_test|small_favor|treat|change ,|:?",
    "to warm_up ,|:",
    "just? for fun|practice|training|demonstration|the_record|now|today ,|:?",
    f"for|in the|this|our|my|your|today_'s|tomorrow_'s|a? little|math|spelling|robotics? {EVENTS} ,|:?",
    f"for my|our|the|your|these|some? little|younger|older|dear? {PEOPLE}|customer_'s|daughter_'s|son_'s|"
    "class_'s birthday|party|lesson|room|class? ,|:?",
    "in_addition|moreover|furthermore|what_is_more ,?",
    "besides|apart_from_that|apart_from_this|aside_from_that|other_than_that|beyond_that ,?",
    "so|okay|ok|right|well? ,? the thing|point|deal|idea|question|problem is ,|:|that?",
    "this|that|here|it is|shows exactly? what|how|the_way i|we|you "
    "want|need|imagine|picture|see|would_like|expect|wish|have_in_mind|had_in_mind|should_do|should_build|should_see|"
    "must_do|have_to_do|are_to_do it|things|everything? to_look|to_be|for|done? :|,?",
    "this|that|here|it is what to_do|to_build|has_to_be_done|should_be_done|needs_to_be_done|must_be_done :|,?",
    "this|that|here is|are|comes|goes|follows the|my|our|your next|whole|full|first|final? "
    "task|goal|job|plan|idea|wish|instruction|instructions|picture|result|layout|arrangement|aim|setup|request|order|"
    "requirement|challenge|mission|assignment|puzzle :|,",
    "solve the|this puzzle|task|problem|exercise|riddle :|,|by?",
    "now|next|and|then? the|a|an|another? easy|simple|quick|hard|tricky|difficult|fun "
    "one|task|job|question|request|thing|exercise|puzzle|challenge :",
    "do|perform|complete|there_are these|the|this|both|just? two|three|2|3|following things|jobs|tasks for_me|to_do? :",
    "do|would_you_do me|us a|one|this small|little|big? favor ,|:|and please?",
    "goal|aim|objective|target|task is to?",
    "per|as_per|following|according_to the|our|my|your? client|customer|boss|teacher|user|manager 's? "
    "request|wish|order|instruction|instructions ,|:",
    "before anything|all|everything else ,",
    "before you_do|we_do|the_robot_does|doing anything|something else? ,",
    "here_is|this_is|that_is the deal|thing|story|point :|,",
    "whatever you do|happens ,",
    "no matter what happens? ,",
    "it is very|really|also? important|essential|crucial|necessary|vital that|to|:",
    "sorry|apologies|excuse_me to|for bother|bothering|disturb|interrupt you|me? ,? but ,?",
    "sorry|excuse|apologies|pardon for|about? my bad? english ,|:|but ,?",
    "no need to hurry|rush|worry :|,|but|and",
    "i am? not sure if|whether you can do this|that|it ,? but ,?",
    "i am? not sure if|whether this|that|it is possible|doable|easy ,? but ,?",
    "let me|us think|see ,|:|… ,?",
    "be a friend|good_robot|good_sport|hero|sport? and",
    f"it would|will be {FINE}|ideal if you|we|the_robot could|would|can?",
    "clean|tidy|sort up|out :|,",
    "tidy|clean|clear|neaten|straighten up|off? the|this|my|your|our table|desk|mess|workspace|room|area up|out? :|,",
    "mind",
)
"""What stands before commands and states alike: whom or what it is for, that there is more of it."""


COMMANDS = Patterns(
    *_PREFACES,
    "please|pls|plz just?",
    "kindly|just|simply|now|next|today|then",
    "and now?",
    "also|additionally ,?",
    "first off|of_all ,?",
    "to start",
    "meanwhile|in_the_meantime|meantime|at_the_same_time|all_the_while ,?",
    "so|and|well|okay|ok|yeah|just like ,?",
    "hey|hi|hello|ciao|hola|howdy|ok|okay|so|well|alright|please|robot|agent ,?",
    "task|goal|instruction|requirement :|-?",
    "objective|aim|purpose|assignment|mission|job :|-",
    "would not it be nice|great|good|lovely|fun|cool to",
    "that? you|we|the_robot first",
    "constraint|condition|restriction|rule|caveat|limitation|warning|important|addition|additionally|extra :|-",
    "do_not|never forget|hesitate to",
    "the|your|our? real|actual? task|job itself? :",
    "note|reminder to_self|to_myself? :",
    "in|at the end ,?",
    "the|your? robot|robot_arm|arm|agent|machine|manipulator|gripper must|should|shall|has_to|have_to|needs_to|"
    "need_to|can|could|would|will|ought_to|is_to|are_to",
    "can|could|would|will not? the|your|our|this robot|robot_arm|arm|agent|machine|manipulator please|kindly|now?",
    "can|could|would|will not? you|somebody|someone|anybody|anyone please?",
    "can|could|shall|should we",
    "you|we|i only|just|simply? should|must|can|need_to|have_to|are_to|will|shall|would|could|might "
    "just|simply|now|then|probably?",
    "let us",
    "listen|listen_up|listen_carefully|pay_attention|attention ,?",
    "try|attempt|proceed|remember to",
    "try and",
    "go ahead? and?",
    "feel free to",
    "help me to?",
    "show|teach|tell me|us|them|the_kids|the_children|everyone|everybody how to|you_would|one_would|you",
    "i am trying to",
    "make|be sure to",
    "make sure you",
    "take care to",
    "see if you can",
    "how about you",
    "it should be possible to",
    "do me|us?",
    "want|need you to",
    "want to",
    "build me",
    "use the|your robot|robot_arm|arm|gripper to",
    "using|with the|your robot|robot_arm|arm|gripper ,",
    "<who> <would>? <also>? <want> <also>? <do> <also>?",
    "would|will|could|can you be? so|that|as? kind|nice|good|friendly and|as? to?",
    "be so kind|nice|good and|as to?",
    "is|would|might there be? a|any|some way|chance|possibility to|you_could|you_can|for_you_to|that_you",
    "is|would it be? possible|okay|ok|fine|feasible|alright|all_right|acceptable "
    "to|for_you_to|if_you|for_the_robot_to|that_you|that_we",
    "i|we want|need|wish|ask|would_like you",
    "would|could|are|will you be? so? willing|able|prepared|ready|happy|good|nice|generous enough? to",
    "would|is it be? too? much|bold|rude to_ask_you|to_ask_for_you|if_i_asked_you|if_we_asked_you|to_expect_you to",
    "please you",
    "the_robot|the_arm|the_agent|the_machine|the_gripper|you|we|i is|are|am also|now|just? "
    "supposed|meant|expected|asked|requested|required|told|instructed|programmed|going|about to",
    "a|the? sequential|final|main|first|simple|small|multi_step|two_step|step_by_step? task|job|exercise|goal :",
    "how|what about",
    "why do? not you|we",
    "do you think|suppose you could|can|would",
    "can|could|may|might i|we ask|request|trouble|bother you to",
    "i|we was|were|am? wonder|wondering if|whether you|we|i|it could|can|might",
    "i|we was|were|am? wonder|wondering could|can|might",
    "would|do you mind|care",
    "any chance you could|can",
    "it would be nice|great|good|lovely|wonderful|perfect|cool|best|helpful|ideal to|if_you|if_you_could|if_we|"
    "if_we_could",
    "ask|tell|have|let|make|get|instruct|command|program|teach the|your|a|our robot|arm|machine|gripper|"
    "manipulator|agent|policy|model|network to?",
    "right|good|great|fine|alrighty|alright|okay|ok|now|well|so|yes team|everyone|folks|guys|kids? ,|:|so|then so? ,?",
    "hello|hi|hey|hiya|ciao|hola|bonjour|salut|howdy|dear|good_morning|good_evening|good_afternoon|greetings|yo there? "
    "team|everyone|everybody|all|folks|guys|robot|friend|friends|children|kids|sir|class|there|again|computer|"
    "assistant|machine|helper|buddy|mate|my_friend|dear_friend ,|:?",
    "helper|assistant|machine|computer|builder|friend|friends|arm ,|:",
    "team|everyone|everybody|folks|guys|children|kids|class|boys_and_girls ,|: let_us|please?",
    "to",
    "the|your|our|my|the_robot_'s|your_robot_'s|the_arm_'s|the_agent_'s|robot_'s|agent_'s|today_'s "
    "next|main|first|whole|only|actual|new? task|job|goal|mission|exercise|challenge|puzzle|"
    "plan|idea|aim|"
    "assignment|request|instruction|wish|setup|objective for_you|today|here|now|this_time? is|:|would_be|"
    "will_be to|:? :?",
    classes=WISHING,
)

_ORDERS = (
    "do_it|do_this|do_them|do_that|do_everything|work|proceed|go|stack|stack_them|build|put_them|move_them? "
    "strictly|exactly? in this|the_following|that|exactly_this order :|,",
    "this is the order :",
    "the order|sequence|plan of_events|of_steps|of_actions? is as_follows|this? :",
    "the|in? temporal|time|chronological? order|sequence|steps of_events|of_steps|of_actions|of_operations|in_time? :",
)
IN_ORDER = Patterns(*_ORDERS)
"""What is told behind these is done one after the other."""
FIRST = Patterns(
    "in|do_it_in|the? two|three|four|2|3|4 steps|stages|phases|moves|parts|actions :",
    "as the|a|your|our first step|stage|thing|action|move ,|:?",
    *_ORDERS,
    "start|begin by",
    "phase|stage 1|one :",
    "step 1|2|3|4|one|two|three :?",
    "first things first :|,?",
    "to start ,|with_,",
    "to begin ,?",
    "first ,|:?",
    "firstly|second|secondly|third|thirdly|first_of_all|at_first",
    "1|2|3 :",
    "picture this",
    "like this",
    "as follows",
    "put|arrange it|everything all? like this",
    "do this|the_following|it_like_this :?",
    "it goes like this",
    "make it so that?",
)
"""What is told behind these is told step by step."""
DONT = (
    "do not", "never", "avoid", "do n't", "not", "you are not allowed to", "you are not permitted to",
    "you are not supposed to", "it is not allowed to", "it is not permitted to", "it is forbidden to",
    "it is prohibited to", "nobody may", "no one may", "the robot is not allowed to", "the arm is not allowed to",
    "be careful not to", "please be careful not to", "careful not to", "take care not to", "make sure not to",
    "be sure not to", "mind not to", "try not to", "see that you do not", "make sure you do not", "make sure you never",
    "the robot must not", "the arm must not", "the robot may not", "the robot should not", "you are forbidden to",
    "you may not", "you must never", "you can not",
)  # fmt: skip
"""What is said behind these must not be done."""
HANDS_OFF = ("keep your hands off", "hands off", "keep your fingers off", "stay away from")
"""What is said behind these must not be touched."""
THEN = (
    "continue with", "continue by", "second of all",
    "and last of all", "last of all", "and last but not least",
    "and only then", "only then", "and only afterwards", "only afterwards", "but only then", "and only later",
    "and not before that", "and only after that", "only after that", "and at last", "at last",
    "and at the very end",
    "and finish by", "finish by", "and end by", "end by", "and conclude by", "conclude by", "and finish off by",
    "and then after that", "and then finally", "and after that", "and afterwards", "and finally", "and then",
    "then finally", "then after that", "after that", "afterwards", "after which", "thereafter", "followed by",
    "and next", "and lastly", "next", "finally", "lastly", "then", "subsequently", "before finally",
    "once that is done", "and subsequently", "after this", "when that is done", "once done", "once this is done",
    "when done",
)  # fmt: skip
WHEN_OVER = Patterns(
    "when|once|after|as_soon_as you|we|the_robot? are|have|is|'re|'ve|'s? done|finished|ready|through ,?"
)
"""What a further step stands behind; what is said of the end may stand there as well."""
_MADE = (
    "tower|stack|row|line|wall|pyramid|staircase|grid|word|circle|square|structure|first_tower|first_part|first_step"
)
_AS_SOON = "but|and? only? when|once|after|as_soon_as|only_after"
_THERE_BY_THEN = (
    "standing|built|finished|complete|completed|done|ready|there|in_place|made|in_position|up|achieved|"
    "accomplished|stable"
)
AFTER_THAT = Patterns(
    f"{_AS_SOON} it|that|this|these|those|they|both is|are|has_been|have_been|was|were|'s already? {_THERE_BY_THEN} ,?",
    f"{_AS_SOON} the|this|that {_MADE} is|has_been|was|'s already? {_THERE_BY_THEN} ,?",
    f"{_AS_SOON} the|this|that {_MADE} stands|exists ,?",
    f"{_AS_SOON} it|this|that stands|exists|has_happened ,?",
    "after|having doing|done that|this|so ,?",
    "as the|a next|second|third|fourth|last|final step|thing|action ,|:?",
    "the next|second|third|fourth|last|final step|thing|action is|: to|:?",
    "once|when|as_soon_as you|we have|'ve done|finished that|this|it|so ,?",
    "once|when you|we are done|finished with that|this|it ,?",
)
"""What is told behind these comes after what was told before."""
