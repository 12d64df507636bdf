"""What stands before a state: that it is wished, that it is the end or the start of the task; and what ends a text.

None of it carries anything of the instruction, but for when it is so.
"""

from __future__ import annotations

from rpg.language.grammar.talk.people import EVENTS, FINE, PEOPLE, WISHING
from rpg.language.grammar.talk.slots import Patterns

_BEGINNING = "initial|starting|start|original|opening"
_STATES = "state|condition|conditions|configuration|setup|situation|scene|arrangement|layout|picture|position"
STARTS = Patterns(
    "starting|start|starts|begin|beginning with|from",
    "on|at? reset|initialization :",
    "start out with",
    "to begin with",
    "initially|originally|currently|presently|as_of_now|as_it_stands|as_things_stand|as_it_is_now ,|:?",
    "given|assume|assuming|suppose that?",
    "given|currently|initially|before|start|starts|begin|begins|beginning|initial :",
    "assume initially",
    "let us say|assume|suppose that?",
    "before the|this episode|task|run|trial ,",
    "right_now|at_first|as_a_start|at_present|at_the_moment|in_the_beginning",
    "in the beginning :",
    "the start is that?",
    "the starting point is that?",
    "where we|you|i|it start|starts|begin|begins :",
    "this_is? how it|everything|things starts|start|begins|begin|looks_at_first|look_at_first|stands_now|stand_now "
    ":|,?",
    "the|our|your? robot|agent|arm|policy|pupils|children|kids|students|player|players|learners "
    "start|starts|begin|begins|starts_out|starts_off with|from",
    "it|everything starts|begins|starts_out|starts_off like_this|as_follows :|,?",
    "it all starts with",
    "from a start with|where|in_which",
    "starting? from a|an initial|starting? state|scene|situation where|in_which",
    f"in|at|from the|our|my {_BEGINNING} {_STATES} ,|:?",
    f"the|our|my? {_BEGINNING} {_STATES} is|has|shows|looks_like_this|looks_like|contains? that|this|as_follows? :|,?",
    f"the|our|my? {_BEGINNING} {_STATES} :",
    "the|our|this|my|each|every? scene|episode|task|game|simulation|run|trial|story|world|level|exercise|puzzle|test|"
    "experiment|demo|demonstration|benchmark|challenge|round|session|scenario|video "
    "opens|starts|begins|starts_off|starts_out|starts_off with|from|so_that|such_that|: ,?",
    "the|our|this|each|every? test|episode|task|run|trial|experiment shall|must|will|should start|begin with|from",
    "we|you|i|things|everything|it|all start|starts|begin|begins|start_off|starts_off|start_out|starts_out|"
    "are_starting|am_starting with|from|: a_scene_where|a_scene_in_which|a_table_where|a_table_on_which?",
    "at|in the very? start|beginning|outset of? the|this? episode|task|game|run|trial|simulation|exercise|test|"
    "experiment ,|:?",
    "at the very? start|beginning|outset ,|:?",
    "before anything_happens|the_robot_moves|the_robot_starts|you_start|we_start|it_starts|you_begin|we_begin|"
    "anything_is_moved|anything_moves|anything_is_done|the_episode_starts|the_task_starts|the_robot_does_anything ,",
    "when|as the|this|our episode|task|game|simulation|run|trial|exercise starts|begins|opens ,",
    "when you|we|i start|begin ,",
    "the|our|my|a? starting|start|initial|beginning point|situation|position ,|:|,? is?|: :?",
    "the_robot|you|we finds|find|encounters|encounter|faces|face|meets|meet that?",
    "you will find_that|see_that|find|see|be_given|receive|start_with|begin_with|be_faced_with",
    "you find|are_faced_with|are_presented_with",
)
"""What is said after these is so at the start."""
DENIALS = Patterns(
    "<who> do|does|would|should|must|can|may|will not|never ever? want|like|see|wish|expect|have to_see|to_have|"
    "that|it_that?",
    "<who> never want|wish|like|expect to_see|to_have?",
    "it should|must|may|can|shall|is not|never be? seen|shown|true|allowed|permitted|the_case|okay|acceptable|"
    "ok that|for?",
    "it is forbidden|prohibited that|for?",
    "there should|must be no way that",
    classes=WISHING,
)
"""What is said after these must not be."""
_RESULT = "result|outcome|state|condition|conditions|scene|configuration|arrangement|layout|picture|setup|situation"
_QUEST = (
    "task|job|goal|episode|mission|game|puzzle|exercise|level|challenge|run|attempt|trial|test|work|objective|aim|"
    "problem|assignment|round|demo|experiment"
)
_DONE = (
    "done|complete|completed|finished|over|successful|successfully|fulfilled|solved|reached|achieved|met|accomplished|"
    "won|won_the_game|cleared|beaten|mastered|unlocked|passed|a_success|attained|"
    "obtained|succeeded|ready|satisfied|given|through|in_success"
)
_WHEN = (
    "when|if|iff|once|as_soon_as|exactly_when|only_when|only_if|if_and_only_if|precisely_when|exactly_if|only_once|"
    "as_long_as|"
    "provided|provided_that|when_and_only_when|by_having"
)
STATES = Patterns(
    "want to_see|to_have?",
    "would not it be nice|great|good|lovely|fun|cool to_have|to_see|if",
    "i_want_you to_have",
    "the scene|picture|goal|image|table shows",
    "the table should show",
    "level 1|2|3 :",
    "in_the_end|finally|after|finish :",
    "in the end|goal|final_configuration",
    "when you are done|finished",
    "when finished",
    "done when",
    "also|additionally|in_addition|furthermore|moreover ,?",
    "requirement|goal -?",
    "the task|goal :",
    "my wish is that?",
    "could_you? make it so that?",
    "let it be that",
    "let there be",
    "make|show|give|hand|fetch|bring|get me|us?",
    "show|demonstrate|prove|explain|teach to? <who>|everybody|everyone|people|us|me that?",
    "show|demonstrate|prove|explain to|for my|our|the|your folks|audience|class|school|room that?",
    "let|have|get|see|picture|imagine|finally",
    "build me",
    "there goes",
    "make sure that?",
    "please? ensure that?",
    "accept|achieve|obtain|attain|expect|guarantee|aim_for|strive_for|go_for|opt_for|settle_for",
    "see to it that",
    "check|verify|confirm|guarantee that",
    "it shall|must|should|will|has_to|needs_to|is_to be "
    "verified|ensured|checked|confirmed|guaranteed|demonstrated|shown|noted|observed that",
    "the goal is that|to_have|for?",
    "the target is",
    "it should be that",
    "it must be that",
    "it is required|expected|desired|wanted|prescribed|necessary|demanded that",
    "it|we|you should|must|has_to end|end_up with",
    "it ends with",
    "finish|end|end_up with",
    "can|could|may|might i|we <also>? have|get|see",
    "at|by|in the very? end|finish|conclusion of the|this|our episode|task|game|run|trial|simulation|exercise ,|:?",
    "by|at the very? end|finish ,|:?",
    "when|once it|everything is all over|done|finished ,?",
    "it|this|that|the_picture|the_result|the_scene should|must|shall|will|has_to show|look_like|display|depict :?",
    "the|our|my|a? end|final|finish|ending|goal|target point|position|condition|situation is|:|, :?",
    "in_order? to pass|win|succeed|finish|complete_it|solve_it|complete_the_task|solve_the_task ,",
    "anything|everything|all goes|is_fine|is_ok|is_okay|is_good|is_allowed|is_alright|works|will_do "
    "as_long_as|so_long_as|provided|provided_that|if ,?",
    "a|the|every|any successful|good|correct|finished|complete episode|run|attempt|game|task|solution ends|finishes "
    "with|when|if|once|in",
    "consider|count|regard|take it|this|the_task|the_job|the_episode as? "
    "solved|done|complete|finished|successful|a_success|completed when|if|once|as_soon_as",
    "it would make|makes me|us|them|my_boss|everyone really|very|so? happy|glad|proud to_see|to_have|if|when",
    "<who> <want> a|the|some? nice|good? <picture> of|showing|with",
    "<who> says|say|said|thinks|think|believes that|:? ,?",
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
    "<who> should|must|shall|will|have_to|need_to show|see|find|observe|notice|spot|admire|discover|demonstrate|"
    "deliver|present|have|get",
    "on|at display|show|view|offer|stage|exhibit today|here|now? is|are|there_is|there_are|will_be|should_be",
    "<who> <would>? <also>? <want> <also>? for|forward_to? <see>?",
    "<who> <would> <also>? after",
    "what|all <who> <would>? <also>? <want>|after|asking|going|looking|aiming after|for|of? to_see|to_have|"
    "to_get? "
    "here|now|today? is that?",
    "in|on the|this|my|our final|resulting|finished|target|goal|end? <picture> ,? we|one|you|i? can? see? ,?",
    "the|my|our|this picture|scene|result|layout|arrangement i|we want|need|have_in_mind|imagine|picture|see is|:|: :?",
    "we|you|one|i should|must|can|could|will|would|shall? see|observe|notice that?",
    "it can|should|must|could|shall be seen|shown that?",
    "let me|us|<who> see|have|get|admire|find",
    "is it possible|okay|true|allowed|fine that",
    "would|could|might it be possible|conceivable|feasible|arranged that",
    "would it be okay|ok|fine|alright|all_right|possible|acceptable if",
    "is there any|a chance|possibility|way that?",
    "any chance that?",
    "would|is it be? too? much|bold|rude to_ask for",
    "may it be that",
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
    f"the|our|this|my|your? {_QUEST} is|will_be|has_been|gets|becomes|counts_as|ends {_DONE} {_WHEN}",
    f"it|this|that is|will_be|counts_as|counts {_DONE}|right|correct|as_done|as_solved|as_success|as_a_success {_WHEN}",
    f"the|our|this|an|your? {_QUEST}|robot|agent|you|we|i|it succeeds|succeed|wins|win|ends|end|won {_WHEN}",
    f"you|we|i|the_robot are|is|have|will_be|will_have|'ve {_DONE} {_WHEN}",
    f"success is|will_be|gets {_DONE} {_WHEN}",
    f"success|completion|victory|a_win is|means|comes|is_given|is_reached only|exactly? {_WHEN}",
    f"<who> <would>? call|consider|count|regard|take it|this|that|the_task|the_job as? {_DONE} {_WHEN}",
    "reach|achieve|attain|get_to|arrive_at|produce|bring_about|obtain|end_in|end_up_in a|the|one? "
    "final|end|goal|target|desired? state|configuration|situation|arrangement|scene|result|layout|setup|outcome "
    "where|in_which|such_that|so_that|with|that_has|that_shows|:",
    f"success {_WHEN}",
    "the|our|my? goal|success|predicate|condition|goal_condition|success_condition|criterion "
    f"holds|is_met|is_true|is_satisfied|is_fulfilled {_WHEN}",
    f"it|this|that counts only? {_WHEN}",
    f"it|this|that is|counts_as|will_be a? win|success|victory|pass {_WHEN}",
    f"the|this|a|our? check|test|trial|task|case|scenario passes|pass|is_passed|is_met|succeeds {_WHEN}",
    f"the|a|this|any? result|solution|answer|outcome|attempt|run is|gets|counts_as "
    f"accepted|approved|fine|good|valid|acceptable|ok|okay {_WHEN}",
    "the|this|our|my? episode|task|game|run|trial|robot must|should|has_to|shall|will|needs_to "
    "end|finish|conclude|close with|in",
    "end|final|desired|goal|target state|result|picture|layout|scene|arrangement|outcome "
    "wanted|desired|required|needed :",
    "arrange|see_to_it for",
    "please? make|do|see|arrange|care|manage|achieve|cause|provide|take_care|look|act it? so? that",
    "arrange|set_up|set|do|fix|organize|lay|place it|things|everything|them|this up|out? so|such that?",
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
    classes=WISHING,
)

TAGS = Patterns(
    "please|thanks|ok|okay|either|now|too",
    "thanks a lot",
    "spell|write it|that|this out? please?",
    "got_it|understood|agreed",
    "and|then? done|finished|ready",
    "thank you very_much?",
    "if you can|could|please",
    "if possible",
    "so|so_that it|they|none_of_them|not_a_single_one does_not|do_not|can_not falls|fall|tips|topples|tip|topple "
    "over|down|off?",
    "so|so_that nothing|none_of_them|not_a_single_one can? falls|fall|tips|topples over|down|off?",
    "for me",
    "would|will|can|could you",
    "as well",
    "on your own",
    "at|in the end",
    f"at|by the very? end of the|this|our? {_QUEST}",
    "when you are done",
    "once|when finished",
    "in the final state",
    "as the|a|our? final|goal|target|end|desired state|goal|target|configuration|result|arrangement|layout|condition",
    f"that|which|it|this? would|will|'d be so|really|very|just? {FINE}",
    "when|if|whenever you have|find|get|'ve_got? a|the|some? time|moment|minute|chance",
    "so|so_that i|we can|could|may take|get|make|shoot a|some|my|the? nice|good? picture|pictures|photo|photos|video|"
    "photograph of_it|of_them|of_this|of_that|afterwards?",
    f"for my|our|the|your little? {PEOPLE}|{EVENTS}",
    "real|really|very? quick|quickly|fast please|pls|plz?",
    "is|that_is|that_'s|would_be what|all <who> want|wants|need|needs|have_in_mind|would_like|'d_like|am_after|"
    "am_looking_for|imagine",
    "if you do not mind|if_it_is_not_too_much_trouble|please",
    "can|could|will you manage|help",
    "do_you_think? can|could|will|would you do|manage|handle|make|arrange|try it|this|that for_me|for_us|please?",
    "is|would that|this|it be? possible|okay|ok|doable|feasible|alright|clear|all_right for_you?",
    "can|could that|this|it be? done|possible|arranged|work",
    "does|would that|this|it work for_you?",
    "nothing|anything else really? matters",
    "other_than|apart_from|besides|beyond that ,? i|we do not care|mind",
    "other_than|apart_from|besides|beyond that ,? nothing|anything is? asked_for|wanted|required|matters",
    classes=WISHING,
)
"""What an instruction may end with."""
