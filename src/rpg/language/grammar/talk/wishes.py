"""Wishes, questions and pictures around an instruction, by their parts: who wishes, how, for what.

A pattern is a row of slots; each slot lists what may stand there, with "_" inside a phrase and "?" behind a slot that
may be left out. What a pattern matches carries nothing of the instruction.
"""

from __future__ import annotations

from rpg.language.grammar.talk.slots import Patterns

PEOPLE = (
    "customer|customers|client|clients|boss|user|users|teacher|friend|friends|daughter|son|student|students|pupil|"
    "pupils|class|kid|kids|child|children|little_ones|little_one|team|colleague|colleagues|mother|father|mom|dad|wife|"
    "husband|grandmother|grandfather|grandma|grandpa|niece|nephew|brother|sister|sponsor|reviewer|reviewers|professor|"
    "audience|visitors|guests|public|viewers|family"
)
"""Whom an instruction may be for."""
_WHOSE = ("my", "our", "the", "your", "my_little", "my_younger", "my_older", "my_big", "our_little", "the_little")
_WHO = "|".join(["i|we|you", *(f"{whose}_{who}" for whose in _WHOSE for who in PEOPLE.split("|"))])
_WOULD = "would|will|should|'d|do|may|might|can|could|must|am|are|is|was|were"
_ALSO = "have_always|always|just|also|simply|now|like|here|still"
_WANT = (
    "asked|be_delighted|be_thankful|be_thrilled|want|wants|wanted|like|likes|love|loves|need|needs|prefer|prefers|wish|wishes|hope|hopes|ask|asks|require|requires|"
    "expect|expects|imagine|imagines|request|requests|have_in_mind|picture|propose|suggest|envision|look|looking|"
    "hoping|asking|wondering|wanting|dreaming|thinking|appreciate_it|be_happy|be_glad|be_pleased|be_grateful|wishing"
)
_SEE = (
    "to_see|to_have|to_get|to_find|to_end_up_with|to_be_shown|seeing|having|for|that|it_if|if|of|there_to_be|it_that|"
    "me_for|us_for|you_for|:"
)
_DO = (
    "to|you_to|you_could|you_would|you_can|you_might|the_robot_to|us_to|to_ask_you_to|it_if_you_would|"
    "it_if_you_could|if_you_could|if_you_would|it_if_you|"
    "the_arm_to|that_you|if_you|when_you|you_if_you_could|you_if_you_can|me_to|us_to|me_if_you_could|us_if_you_could"
)
_PICTURE = "picture|image|photo|photograph|drawing|sketch|figure|scene|view|arrangement|result|layout|setup|state"


FINE = (
    "great|nice|good|lovely|wonderful|perfect|cool|awesome|amazing|fantastic|super|brilliant|kind|helpful|appreciated|"
    "very_kind|much_appreciated|the_best|fine|fun|enough"
)
"""What is said of good work."""
_EVENTS = (
    "demo|demonstration|test|experiment|game|exercise|show|presentation|puzzle|video|photo|picture|figure|paper|lesson|"
    "class|course|lecture|school|homework|exam|project|birthday|party|story|story_time|workshop|practice|training|task|"
    "session|fun|photograph|poster|slide|slides|thesis|report|website"
)
"""What an instruction may be given for."""
_PREFACES = (
    "as a|an|the user|player|customer|tester|developer|operator|product_owner|manager|parent|teacher|child|robot|"
    "engineer ,?",
    "as|for a|an|your warm_up|warmup|favor|little_favor|test|challenge|quick_test|small_favor|treat|change ,|:?",
    "to warm_up ,|:",
    "just? for fun|practice|training|demonstration|the_record|now|today ,|:?",
    f"for|in the|this|our|my|your|today_'s|tomorrow_'s|a? little|math|spelling|robotics? {_EVENTS} ,|:?",
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
    "easy|simple|quick|hard|tricky one|task|job|question|request|thing|exercise|puzzle|challenge :",
    "do|would_you_do me|us a|one|this small|little|big? favor ,|:|and please?",
    "goal|aim|objective|target|task is to?",
    "per|as_per|following|according_to the|our|my|your? client|customer|boss|teacher|user|manager 's? "
    "request|wish|order|instruction|instructions ,|:",
    "before anything|all|everything else ,",
    "here_is|this_is|that_is the deal|thing|story|point :|,",
    "whatever you do|happens ,",
    "no matter what happens? ,",
    "it is very|really|also? important|essential|crucial|necessary|vital that|to|:",
    "sorry|apologies|excuse_me to|for bother|bothering|disturb|interrupt you|me? ,? but ,?",
    "no need to hurry|rush|worry :|,|but|and",
    "i am? not sure if|whether you can do this|that|it ,? but ,?",
    "i am? not sure if|whether this|that|it is possible|doable|easy ,? but ,?",
    "let me|us think|see ,|:|… ,?",
    "be a friend|good_robot|good_sport|hero|sport? and",
    f"it would|will be {FINE}|ideal if you|we|the_robot could|would|can?",
    "mind",
)
"""What stands before commands and states alike: whom or what it is for, that there is more of it."""


COMMAND_WISHES = Patterns(
    *_PREFACES,
    f"{_WHO} {_WOULD}? {_ALSO}? {_WANT} {_ALSO}? {_DO} {_ALSO}?",
    "would|will|could|can you be? so|that|as? kind|nice|good|friendly and|as? to?",
    "be so kind|nice|good and|as to?",
    "is|would|might there be? a|any|some way|chance|possibility to|you_could|you_can|for_you_to|that_you",
    "is|would it be? possible|okay|ok|fine|feasible|alright to|for_you_to|if_you|for_the_robot_to|that_you|that_we",
    "i|we want|need|wish|ask|would_like you",
    "would|could|are|will you be? so? willing|able|prepared|ready|happy|good|nice|generous enough? to",
    "would|is it be? too? much|bold|rude to_ask_you|to_ask_for_you|if_i_asked_you|if_we_asked_you|to_expect_you to",
    "please you",
    "the_robot|the_arm|the_agent|the_machine|the_gripper|you|we|i is|are|am also|now|just? "
    "supposed|meant|expected|asked|requested|required|told|instructed|programmed|going|about to",
    "clean|tidy|sort up|out :|,",
    "a|the? sequential|final|main|first|simple|small|multi_step|two_step|step_by_step? task|job|exercise|goal :",
    "how|what about",
    "why do? not you|we",
    "do you think|suppose you could|can|would",
    "can|could|may|might i|we ask|request|trouble|bother you to",
    "i was? wonder|wondering if|whether you could|can|might",
    "would|do you mind|care",
    "any chance you could|can",
    "it would be nice|great|good|lovely|wonderful|perfect|cool|best|helpful|ideal to|if_you|if_you_could|if_we|"
    "if_we_could",
    "ask|tell|have|let|make|get|instruct|command|program the|your robot|arm|machine|gripper|manipulator to?",
    "right|good|great|fine|alrighty|alright|okay|ok|now|well|so|yes team|everyone|folks|guys|kids? ,|:|so|then so? ,?",
    "hello|hi|hey|hiya|dear|good_morning|good_evening|good_afternoon|greetings|yo there? "
    "team|everyone|everybody|all|folks|guys|robot|friend|friends|children|kids|sir|class|there|again|computer|"
    "assistant|machine|helper|buddy|mate|my_friend|dear_friend ,|:?",
    "helper|assistant|machine|computer|builder|friend|friends|arm ,|:",
    "team|everyone|everybody|folks|guys|children|kids|class|boys_and_girls ,|: let_us|please?",
    "to",
    "the|your|our|my next|main|first|whole|only|actual|new? task|job|goal|mission|exercise|challenge|puzzle|"
    "plan|idea|aim|"
    "assignment|request|instruction|wish|setup|objective for_you|today|here|now|this_time? is|:|would_be|"
    "will_be to|:? :?",
)
_BEGINNING = "initial|starting|start|original|opening"
_STATES = "state|configuration|setup|situation|scene|arrangement|layout|picture|position"
START_WISHES = Patterns(
    f"in|at|from the|our|my {_BEGINNING} {_STATES} ,|:?",
    f"the|our|my? {_BEGINNING} {_STATES} is|has|shows|looks_like_this|looks_like|contains? that|this|as_follows? :|,?",
    f"the|our|my? {_BEGINNING} {_STATES} :",
    "the|our|this|my scene|episode|task|game|simulation|run|trial|story|world|level|exercise|puzzle "
    "opens|starts|begins|starts_off|starts_out|starts_off with|from|: ,?",
    "we|you|i|things|everything|it|all start|starts|begin|begins|start_off|starts_off|start_out|starts_out|"
    "are_starting|am_starting with|from|:",
    "at|in the very? start|beginning|outset of? the|this? episode|task|game|run|trial|simulation|exercise ,|:?",
    "at the very? start|beginning|outset ,|:?",
    "before anything_happens|the_robot_moves|the_robot_starts|you_start|we_start|it_starts|you_begin|we_begin|"
    "anything_is_moved|the_episode_starts|the_task_starts|the_robot_does_anything ,",
    "when the|this|our episode|task|game|simulation|run|trial|exercise starts|begins|opens ,",
    "when you|we|i start|begin ,",
    "the|our|my|a? starting|start|initial|beginning point|situation|position ,|:|,? is?|: :?",
    "the_robot|you|we finds|find|encounters|encounter|faces|face|meets|meet",
    "you will find|see|be_given|receive|start_with|begin_with|be_faced_with",
    "you find|are_faced_with|are_presented_with",
)
"""What is said after these is so at the start."""
DENIALS = Patterns(
    f"{_WHO} do|does|would|should|must|can|may|will not|never ever? want|like|see|wish|expect|have to_see|to_have|"
    f"that|it_that?",
    f"{_WHO} never want|wish|like|expect to_see|to_have?",
    "it should|must|may|can|shall|is not|never be? seen|shown|true|allowed|permitted|the_case|okay|acceptable|"
    "ok that|for?",
    "it is forbidden|prohibited that|for?",
    "there should|must be no way that",
)
"""What is said after these must not be."""
_RESULT = "result|outcome|state|scene|configuration|arrangement|layout|picture|setup|situation"
_QUEST = (
    "task|job|goal|episode|mission|game|puzzle|exercise|level|challenge|run|attempt|trial|test|work|objective|aim|"
    "problem|assignment|round|demo|experiment"
)
_DONE = (
    "done|complete|completed|finished|over|successful|successfully|fulfilled|solved|reached|achieved|met|accomplished|"
    "won|won_the_game|passed|a_success|attained|obtained|succeeded|ready|satisfied|given|through|in_success"
)
_WHEN = (
    "when|if|once|as_soon_as|exactly_when|only_when|only_if|if_and_only_if|precisely_when|exactly_if|only_once|as_long_as|"
    "provided|provided_that|when_and_only_when|by_having"
)
STATE_WISHES = Patterns(
    "at|by|in the very? end|finish|conclusion of the|this|our episode|task|game|run|trial|simulation|exercise ,|:?",
    "by|at the very? end|finish ,|:?",
    "when|once it|everything is all over|done|finished ,?",
    "it|this|that|the_picture|the_result|the_scene should|must|shall|will|has_to show|look_like|display|depict :?",
    "the|our|my|a? end|final|finish|ending|goal|target point|position|condition|situation is|:|, :?",
    "to pass|win|succeed|finish ,",
    "a|the|every|any successful|good|correct|finished|complete episode|run|attempt|game|task|solution ends|finishes "
    "with|when|if|once|in",
    "consider|count|regard|take it|this|the_task|the_job|the_episode as? "
    "solved|done|complete|finished|successful|a_success|completed when|if|once|as_soon_as",
    "it would make|makes me|us|them|my_boss|everyone really|very|so? happy|glad|proud to_see|to_have|if|when",
    f"{_WHO} {_WANT} a|the|some? nice|good? {_PICTURE} of|showing|with",
    f"{_WHO} says|say|said|thinks|think|believes that|: ,?",
    "a|the|one|any correct|right|valid|good|successful|finished|complete|proper solution|result|answer|outcome "
    "has|shows|is|looks_like|consists_of|contains|would_be|would_have|must_have|must_show|should_have|should_show "
    ":|,?",
    "what counts as? a? success|solved|done|correct|solution|finished is|:|, :?",
    "a? reward|points|point|score is|are|will_be given|granted|earned|due|paid|awarded "
    "when|if|once|as_soon_as|for|only_if",
    "you|we|i|the_robot|the_agent get|gets|earn|earns|receive|receives|score|scores a|the|your|full? "
    "reward|points|point when|if|once|as_soon_as|for",
    "passing|success|winning|completion|solving|finishing it|this|the_task? requires|demands|needs|takes that?",
    "the|my picture|image|scene|arrangement|idea i|we have|imagine in_mind? :|is :?",
    "the|our|my? acceptance|success|completion|goal|pass|test|definition_of? "
    "criteria|criterion|condition|conditions|requirement|requirements|done|user_story|specification|spec|deliverable|"
    "deliverables :|is|are that?",
    f"the|our|my final|finished|end|desired|expected|target|goal? deliverable|product|end_product|{_RESULT} "
    "should|must|shall|will|has_to? be|consist_of|consists_of|contain|contains|include|includes|comprise|comprises|is|"
    "feature|features|have|has that|:?",
    f"{_WHO} should|must|shall|will|have_to|need_to show|see|demonstrate|deliver|present|have|get",
    f"{_WHO} {_WOULD}? {_ALSO}? {_WANT} {_ALSO}? for|forward_to? {_SEE}?",
    f"{_WHO} {_WOULD} {_ALSO}? after",
    f"what|all {_WHO} {_WOULD}? {_ALSO}? {_WANT}|after|asking|going|looking|aiming after|for|of? to_see|to_have|"
    f"to_get? "
    "here|now|today? is that?",
    f"in|on the|this|my|our final|resulting|finished|target|goal|end? {_PICTURE} ,? we|one|you|i? can? see? ,?",
    "the|my|our|this picture|scene|result|layout|arrangement i|we want|need|have_in_mind|imagine|picture|see is|:|: :?",
    "we|you|one|i should|must|can|could|will|would|shall? see|observe|notice that?",
    "it can|should|must|could|shall be seen|shown that?",
    f"let me|us|{_WHO} see|have|get|admire|find",
    "is it possible|okay|true|allowed|fine that",
    "would|is it be? too? much|bold|rude to_ask for",
    "could|can|would|may|might it be that",
    "is there a way that",
    "how|what about having|that|if?",
    "why not have?",
    "arrange|set_up|set|organize|change|make|build|lay_out|prepare|configure|design|rearrange|modify|adjust|"
    "create|fix "
    "the|a|this|our scene|table|workspace|setup|picture|world|things|desk up? such_that|so|so_that|until|"
    "in_such_a_way_that",
    f"it|this|that would|will be really|so|very|just? {FINE}|best|ideal if|that|to_see|to_have|to_get",
    "the|our|my end|final|desired|target|goal|finished|expected|wanted "
    "result|picture|image|state|scene|outcome|arrangement|layout|configuration|setup|situation "
    "i_want|we_want|we_need|i_need? is|should_be|must_be|shows|should_show|has|should_have|would_be|: "
    "this|as_follows|like_this|that|when|where|one_where|one_in_which? :?",
    "a|one picture|scene|situation|state|layout|arrangement where|in_which|such_that|that_shows|showing",
    "end|final|desired|target|goal|wanted|finished state|result|picture|layout|scene|arrangement|configuration? :",
    f"the|our|this|my|your {_QUEST} is|will_be|has_been|gets|becomes|counts_as|ends {_DONE} {_WHEN}",
    f"it|this|that is|will_be|counts_as|counts {_DONE}|right|correct|as_done|as_solved|as_success|as_a_success {_WHEN}",
    f"the|our|this|an|your? {_QUEST}|robot|agent|you|we|i|it succeeds|succeed|wins|win|ends|end|won {_WHEN}",
    f"you|we|i|the_robot are|is|have|will_be|will_have|'ve {_DONE} {_WHEN}",
    f"success is|will_be|gets {_DONE} {_WHEN}",
    f"success|completion|victory|a_win is|means|comes|is_given|is_reached only|exactly? {_WHEN}",
    f"{_WHO} {_WOULD}? call|consider|count|regard|take it|this|that|the_task|the_job as? {_DONE} {_WHEN}",
    "reach|achieve|attain|get_to|arrive_at|produce|bring_about|obtain|end_in|end_up_in a|the|one? "
    "final|end|goal|target|desired? state|configuration|situation|arrangement|scene|result|layout|setup|outcome "
    "where|in_which|such_that|so_that|with|that_has|that_shows|:",
    f"success {_WHEN}",
    f"it|this|that is|counts_as|will_be a? win|success|victory|pass {_WHEN}",
    f"the|this check|test|trial passes|is_passed|is_met {_WHEN}",
    "the|this|our|my? episode|task|game|run|trial|robot must|should|has_to|shall|will|needs_to "
    "end|finish|conclude|close with|in",
    "end|final|desired|goal|target state|result|picture|layout|scene|arrangement|outcome "
    "wanted|desired|required|needed :",
    "arrange|see_to_it for",
    "please? make|do|see|arrange|care|manage|achieve|cause|provide|take_care|look|act it? so? that",
    "success|done|finished|win|victory|completion means? that? :",
    "what should|must|has_to|will come_out|result|be_there|be_seen|stand_there|appear in_the_end|at_the_end? is|:",
    f"the|our|my end|final|desired|target|goal? {_RESULT} "
    "i_am_after|we_are_after|i_am_looking_for|i_aim_for|i_have_in_mind|i_want_at_the_end|i_want_in_the_end|"
    "we_want_at_the_end|i_want_to_see|we_want_to_see|i_dream_of|i_had_in_mind is|:|, :?",
    "success requires|demands|means|is|condition|criterion is|:? that|:?",
    "success|completion|passing|winning requires|demands that?",
    f"the|our|my|a? final|finished|end|desired|expected|target|goal|whole? {_RESULT}|thing|table|it|everything "
    "should|must|shall|will|has_to|have_to|ought_to|needs_to|is_to look|appear|be|end_up|come_out "
    "like_this|as_follows|like_so|this_way :|,?",
    f"the|our|my|a? final|finished|end|desired|expected|target|goal|whole? {_RESULT}|thing|table|everything "
    "should|must|shall|will|has_to|have_to|ought_to|needs_to|is_to look like|so|this :?",
    "here goes|we_go|it_is|you_go|it_comes :|,",
    "the way i|we|you imagine|picture|see|want|envision it|this|things|that ,|:?",
    "in my|our mind|head|imagination|dream|dreams|thoughts|opinion|plan ,? i|we|there? "
    "see|picture|imagine|is|want|have? ,|:?",
    "the|this|an|my picture|image|scene|arrangement|idea|plan|vision|thing|view|pattern|layout that? i|we? "
    "have|had|is|of? in my|our mind|head|imagination|thoughts is|shows|has|looks_like|looks_like_this|:? :|,?",
    "what i|we picture|envision|envisage|am_after|are_after|am_thinking_of|had_in_mind|dream_of is|:|,? :?",
    "when|once|after|as_soon_as everything|all|it|the_task|the_job|the_work|you|we|the_robot "
    "is|are|has_been|have|have_been|has all? done|finished|completed|complete|ready|over ,",
    "my|our|the|your request|wish|task|goal|job|idea|instruction|aim is quite|very? "
    "simple|easy|clear|this|the_following|as_follows :",
)

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
    "once|when you|we have done|finished that|this|it|so ,?",
    "once|when you|we are done|finished with that|this|it ,?",
)
"""What is told behind these comes after what was told before."""
TAGS = Patterns(
    f"that|which|it|this would|will|'d be so|really|very|just? {FINE}",
    "when|if|whenever you have|find|get|'ve_got? a|the|some? time|moment|minute|chance",
    "so|so_that i|we can|could|may take|get|make|shoot a|some|my|the? nice|good? picture|pictures|photo|photos|video|"
    "photograph of_it|of_them|of_this|of_that|afterwards?",
    f"for my|our|the|your little? {PEOPLE}|{_EVENTS}",
    "real|really|very quick|quickly",
    f"is|that_is|that_'s|would_be what|all {_WHO} want|wants|need|needs|have_in_mind|would_like|'d_like|am_after|"
    "am_looking_for|imagine",
    "if you do not mind|if_it_is_not_too_much_trouble|please",
)
"""What an instruction may end with."""
