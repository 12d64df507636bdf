"""Set phrases that ask for nothing and tell nothing of a task, where they are set off from the rest.

Rows of slots as in `phrases`; each is the whole of what is said between two marks.
"""

from __future__ import annotations

from rpg.language.grammar.talk.people import PEOPLE, RELATIONS
from rpg.language.phrases import Classes, Rows

_CLASSES = Classes({
    "who": ("i|we|he|she|they|you|everybody|everyone|people", f"the|my|our|your little|dear? {PEOPLE}", RELATIONS,
            "my|our|the guests|boss|dog|cat|bus|train|taxi|inspector|show|others"),
    "skill": ("pick_and_place|pick_place|picking_and_placing|stacking|sorting|spelling|building|grasping|placing|"
              "manipulation|rearrangement|rearranging|tidying|reading|counting|arithmetic|math|maths|logic|geometry|"
              "precision|dexterity|balance|stability|memory|planning|patience|accuracy|coordination|teamwork|robotics",),
    "errand": ("task|test|exercise|job|challenge|puzzle|game|problem|benchmark|trial|drill|experiment|demo|scenario|"
               "round|question|level|lesson|one|case|example|episode|instruction|request|command|assignment",),
    "sort": ("simple|easy|quick|small|little|short|basic|standard|classic|hard|tricky|tabletop|robot|practice|warm_up|"
             "first|second|third|next|last|final|new|typical|usual|very|really|another|only|test", "<skill>"),
    "is": ("is|are|am|was|were|be|will_be|'s|have|has|had|get|gets",),
})  # fmt: skip
_WHOLE = (
    "this|it|here|that is|'s just|only|again? a|an|another|our|my|the? <sort>* <errand> for_you|for_today|today|"
    "of_mine?",
    "this|our|the|my|each|every? <sort>* <errand> tests|checks|measures|evaluates|trains|covers|involves|requires|"
    "demands|needs|is_about|is_for|is_a_test_of|is_to_test|is_meant_to_test|is_testing|focuses_on|deals_with "
    "your|our|the|basic|fine|only|mainly|just? <skill> and|or? <skill>? skills|abilities|ability|only|here?",
    "this|it|that one|round? is|'s for|from|part_of a|an|the|our|my <sort>* <errand>|class|course|exam|competition|"
    "thesis|paper|study|data_set|dataset|curriculum|training",
    "today|now|this_week|next|first? ,? we|i|you|they practice|practise|train|test|study|learn|are_practising|"
    "are_practicing|are_learning|are_training|are_testing|are_studying|will_practice|will_practise|talk_about|"
    "talked_about|learned_about|learnt_about|are_learning_about|work_on|are_working_on|'re_testing|'re_practising|"
    "'re_learning|'re_learning_about|'re_working_on|focus_on|are_doing|do your|our|the|basic? <skill> and? <skill>? "
    "skills|again|today|here|at_the_moment|in_class|in_school?",
    "in class|school|the_lab|the_lesson|today_'s_lesson|kindergarten ,? we|i are_doing|do|did|learn|learned|"
    "learned_about|are_learning|are_learning_about|talked_about|talk_about|are_practising|practise|practice <skill>",
    "<errand> one|two|three|four|five|six|seven|eight|nine|ten|a|b|c",
    "nothing more|else and|or|,? nothing less|else",
    "this|that|it|these|those|which is|'s|are|was my|our|his|her|their|your|the little|dear? name|nickname|initials|"
    "favorite_word|name_day|birthday|street|school|team|club|<who>",
    "thats|its|thats_,? my|our|his|her name|nickname|initials",
    "that|this|it is|'s what|how they|we|people|everybody|everyone|friends|i call|calls|name|spell|write|pronounce "
    "me|it|him|her|us|this",
    "it|this|that does|need not need_to|have_to? be perfect|pretty|precise|exact|fancy|beautiful|so_precise|"
    "a_work_of_art|nice exactly|though|at_all?",
    "or|otherwise|else i|we will|'ll cry|be_sad|be_angry|be_mad|be_late|fail|tell_mom|get_angry",
    "and|okay|ok|but? i|we can|will|'ll|could just|happily? wait|not_wait",
    "thank you|god|goodness|heavens so|very? much? in_advance|again|indeed?",
    "and|but|so? that|this is all|it|that|everything for_now|for_today|folks|i_ask|we_ask|really|today|then|there_is?",
    "and? that|this is the whole|entire|main|actual? job|task|goal|exercise|assignment|idea|plan|point|game",
    "that will|would|should be|do all|it|the_job|nicely|for_now|for_today?",
    "nothing fancy|special|complicated|to_add|to_say|to_worry_about|more_to_say|more_to_add please?",
    "let me|us know please? when|once|as_soon_as you are|have|'re done|finished|ready|through please?",
    "tell|call|wake|ping|text|show me|us please? when|once|as_soon_as you are|have|'re done|finished|ready|"
    "through please?",
    "you can|may|will then? rest|relax|sleep|go_home|go_to_sleep|take_a_break|have_a_break|stop now|then|after_that|"
    "afterwards?",
    "what shall|should|do|can|could we do|try|play|build next|now|today|then?",
    "take your time|all_the_time_you_need|it_easy|care|a_deep_breath with_it|with_this|with_that|please?",
    "take as long as you like|need|want",
    "there is|'s? no|not_any need|reason|cause to? hurry|rush|worry|panic|for_panic?",
    "no need|reason to hurry|rush|worry|panic|be_afraid",
    "no hurry|rush|problem|problems|worries|stress|pressure|panic|trouble|offence|offense|joke|kidding|doubt|"
    "wonder|idea|"
    "big_deal|biggie|fuss|frills|pun_intended|sweat|"
    "excuses|questions|questions_asked|arguments at_all|please|though|today|really|here?",
    "i|we am|are not joking|kidding",
    "this|that|it is not a joke|prank",
    "watch|look|listen|observe|behold",
    "time is short|tight|money|precious|running_out",
    "do not overthink|overcomplicate|overdo it|this|that",
    "do not worry|fret|stress|bother about the|any? time|mess|speed|details|detail|dust|noise|cost|clock",
    "do not worry|panic|laugh|ask|cry|hurry|rush|stress|despair|sweat|giggle|be_afraid|be_shy|be_angry|be_mad|"
    "be_scared|"
    "be_sad|be_cross|be_nervous|you_worry|mind_me|mind_the_mess|mind_the_noise|get_nervous|get_angry|thank_me|"
    "ask_me_why|ask_why|judge_me please|about_it|me?",
    "take it easy",
    "never mind me|the_mess|the_noise",
    "trust|believe|forgive|excuse|pardon|humor|thank|bless|help me|us|you please|here|later|for_that|for_asking|"
    "for_bothering_you|for_being_picky|for_being_fussy|for_being_late?",
    "excuse|forgive|pardon my|the|our english|french|mess|noise|handwriting|spelling|typos|language",
    "have fun with_it|everybody|everyone|guys|kids|all?",
    "the end",
    "call it a day",
    "over and out",
    "report back to_me?",
    "take|snap a picture|photo|snapshot|screenshot of_it|of_this|of_the_result|afterwards?",
    "in|inside|within|on the|our|my? simulator|simulation|sim|mujoco|real_robot|real_arm|test_bench only|please?",
    "so we|you|i can move|go on",
    "because|cause why not",
    "until i|we say stop|so|enough",
    "when|whenever you get|have a chance|minute|moment|second",
    "if that|this|it is|'s not too hard|difficult|much|complicated for_you?",
    "as per the|our spec|specification|protocol|plan|manual|instructions|rules",
    "new|next|fresh|another scene|episode|trial|level",
    "reset|clear|prepare the scene|world|simulation|environment please|first?",
    "just? to warm_up|get_started|get_going|be_sure|be_safe|be_clear|make_it_clear",
    "just? for beginners|warm_up|practice|testing_purposes|debugging|completeness",
    "all? in one|a_single|just_one go|episode|run|rollout|attempt|trial|try|sitting please?",
    "within|during one|a_single|just_one|this|the|each episode|run|rollout|attempt|trial|try please?",
    "i|we? hope that|this|it|everything is|'s|was clear|understandable|fine|okay|ok|doable|possible|not_too_hard|"
    "not_too_easy enough|to_you?",
    "if that|this|it makes|make any? sense to_you?",
    "you know the drill|rules|game|procedure",
    "have a|some fun|nice_day|good_day|lovely_day|great_day|nice_weekend|nice_evening|good_time|good_one|seat|heart",
    "enjoy it|yourself|yourselves|the_day|the_weekend|your_day?",
    "hurry up please|now?",
    "wake|cheer|listen|hurry up",
    "come on robot|now|please|then?",
    "go go go|on|ahead|for_it",
    "chop chop",
    "here|there|off we|you|goes go|are|nothing then?",
    "go for it",
    "your attention please?",
    "here goes",
    "fingers|everything crossed",
    "is everything|all clear|understood|okay|ok|fine|ready for_you|so_far?",
    "report back|to_me? when|once|as_soon_as you are|have|'re done|finished|ready?",
    "i|we? would|'d|just|only|am|are? like|love|need|want|fancy|after|looking_for to_see|to_have|to_get|to_try? "
    "something|sth|smth|smt really|very|quite|super? nice|new|special|beautiful|fun|cool|lovely|interesting|simple|"
    "easy|quick|basic|straightforward|classic please|for_now|first|here|today|now|from_you?",
    "ok|okay|so|and|well? now|next|then|first? for|let_us_do|let_us_try|lets_do|do|try|comes? something|sth|smth|smt "
    "a_bit|slightly|a_little|even|much|really? harder|trickier|easier|easy|simple|different|bigger|tricky|hard|"
    "more_fun|fancier|more_difficult|more_interesting first|now|please|for_you|next?",
    "just|only|simply? wondering|curious|asking|checking",
    "pay close|good|full? attention please|now|everybody|robot|here?",
    "attention attention|please|now|everybody?",
    "listen|concentrate|focus|relax|attention|quiet carefully|well|please|everybody|everyone|all|to_me|now?",
    "watch out",
    "look here|at_this please?",
    "stay|keep calm|cool|tuned|focused",
    "please? be patient|nice|kind|quick|good|careful|brave|honest|precise|exact|accurate with_me|with_us|"
    "with_this_one|with_it|please|now|about_it|to_me?",
    "bear|stay with me please|here?",
    "careful|easy|steady now|does_it|please",
    "listen|watch|look carefully|up|closely|well|this|me|out|now|here please|everybody|everyone|robot|kids?",
    "chin up",
    "well|nicely|good|great|nice|bravely done|said|job|work|boy|girl|robot|luck|one|going everybody|everyone|team?",
    "good luck with_it|with_that?",
    "good morning|evening|afternoon|day|night|old_friend robot|everyone|everybody|all|my_friend|my_dear|dear|there|"
    "dear_robot|team|class|children|kids?",
    "hello|hi|hey|ahoy|howdy|greetings|yo|hiya my? dear|old|little? robot|friend|friends|everyone|everybody|all|there|"
    "mate|team|class|to_all|from_the_lab|from_the_office|again|folks|world|you|to_you|to_you_all",
    "ladies and gentlemen",
    "sleep|stay|fare|keep|be|get well|tight|safe|good|warm|strong|soon",
    "see|talk|speak|write you|to_you|ya soon|later|tomorrow|around|then|there|next_week|on_monday?",
    "long time no see",
    "long story short?",
    "nice|good|great|lovely|pleased|glad to meet|see|know|have|hear_from you|you_again|you_here|you_around|you_all",
    "how are|is you|things|life|everything|it_going today|doing|going|this_morning?",
    "i|we? hope you are|slept|feel|had|have well|fine|okay|good|better|a_good_day|a_nice_day|a_good_night|a_good_time "
    "today|too?",
    "what is|'s? up|new|the_matter today?",
    "guess what",
    "you know what|why",
    "can|could|may|might i ask|bother|trouble|interrupt you something|for_a_moment|for_a_favor|a_favor|a_question?",
    "can|could|would|will you please? do something|one_thing|me_a_favor|us_a_favor for_me|for_us|please?",
    "do me|us a|one|this small|little|big? favor please?",
    "can|could|will|would you please? help|do|manage|handle|solve me|us|that|this|it with_this|with_that|"
    "with_something|"
    "for_me|for_us|please|out|today?",
    "do you hear|understand|follow|get|see me|it|this|that|us|the_problem?",
    "do you think? you can|could manage|do|handle|solve it|that|this|alone? for_me|for_us|please?",
    "do you understand",
    "are you there|awake|ready|listening|okay|free|sure|with_me robot|now|today|for_this?",
    "have you got? a|some|one? minute|moment|second|time",
    "got a|one|some minute|moment|second|sec|time please|for_me?",
    "one|just_one more|last|final|small|little thing|question|request|task|favor|game|exercise|puzzle for_today|"
    "for_you|"
    "today|now|before_lunch|before_we_go|please|first?",
    "a|an|another|the|okay|ok|now_,? new|next|easy|quick|simple|tricky|final|fresh|little start|attempt|try|game|"
    "question|"
    "request|task|puzzle|exercise|challenge|experiment for_today|for_you|to_start_with|to_begin_with|today|now|please?",
    "last one for_today|before_lunch|before_we_go|today",
    "new game|day|task|try|attempt , new game|day|task|luck",
    "last|first one for_today|today|please?",
    "here|this|now comes|is|'s|we_have a|an|the|your|my? new|next|quick|easy|tricky|hard|nice|little|simple|another "
    "one|task|exercise|puzzle for_you|today|now?",
    "this one is|'s for experts|beginners|you|my_mother|the_pros|advanced_students",
    "this|it|that should|will|would|must|is be? a piece of cake for_you?",
    "piece of cake",
    "easy peasy|enough|as_pie|as_that lemon_squeezy?",
    "easy|simple|not_hard|not_too_hard|not_so_hard|not_difficult , no|right|is_it_not|is_it|huh",
    "simple|easy as that|pie|abc",
    "should|must|will be easy|simple|fun|doable|possible|a_doddle|no_problem enough|for_you|right?",
    "how hard can|could it|this|that be then|really?",
    "it|this|that can not be that|so|too hard|difficult|complicated",
    "is|was that|it|this clear|understood|okay|ok|too_much|so_hard|asking_too_much|easy|a_problem enough|to_you?",
    "does|did that|this|it make sense|clear to_you?",
    "make|makes|made sense|clear?",
    "understood|got|gotcha|agreed|deal|ready|capito it|that|then|now|set_go?",
    "any questions|problems|doubts|objections|news?",
    "what do you think|say|mean about_it|about_that|to_that?",
    "what are you waiting for|doing|up_to robot?",
    "what for|else|if|a_day|a_mess|a_morning|fun|now|next|joy",
    "what the heck|hell|devil",
    "why|why_not|why_so|how_so|how_come|what_for",
    "because|just_because|because_i_say_so|because_i_said_so|because_that_is_why",
    "that will|would make my|our|her|his day|week|year",
    "the|this|my|our place|room|house|flat|kitchen|lab|office|desk is|'s|looks in|like a|an|such_a|complete? "
    "state|mess|disaster|bomb_site|pigsty|shambles|tip|nightmare today|again?",
    "i|we? hope|trust|know|believe|think|bet|guess|suppose|reckon you|that_you|we can|will|'ll|could do|manage|handle|"
    "understand|solve|like|love|enjoy it|this|that well|easily|just_fine?",
    "you can do it|this|that",
    "you will|'ll|would|must like|love|enjoy this|it|that|them one?",
    "i|we know|believe in|trust|count_on|rely_on|am_counting_on|are_counting_on|rely|believe|am_watching|are_watching|"
    "am_waiting_for|thank|love|like|appreciate|need|trust_in|miss|salute|greet|beg you all|so_much?",
    "i|we will|'ll|would be back|grateful|here|waiting|watching|happy|right_back|obliged|there|quiet|off soon|later|"
    "in_a_minute|forever|now?",
    "i would appreciate|love|like it|that so_much|very_much|greatly?",
    "i promise|guess|think|suppose|believe|swear|bet|insist|repeat|mean_it|beg_you|am_begging_you|am_serious|hope|"
    "know|see|"
    "wonder|would_say|must_say|have_to_say|must_admit|admit|confess|would_think|imagine|fear|am_told|was_told|hear|"
    "know_,_i_know",
    "you know|see|see_,_right|bet|know_why|get_it|know_me|know_the_game|know_how_it_is",
    "believe it or not",
    "come to think of it",
    "now that i|we think of it",
    "while i_am|we_are|you_are at it|that",
    "between you and me|us",
    "just? between|among us|ourselves|friends",
    "for heaven|goodness|god|pete|christ|crying 's|out|out_loud sake|loud?",
    "show this|it|that with|using cubes|blocks",
    "in my|all|our humble|honest? opinion|view|mind|honesty|seriousness",
    "to my|our mind|knowledge|surprise|delight|shame",
    "to be honest|fair|frank|precise|exact|clear|sure|safe with_you?",
    "to tell|say the|you truth|the_truth",
    "as you|we|i|everyone|everybody|they all? know|see|say|knows|says|said|asked|promised|requested|agreed|discussed|"
    "can_imagine|can_guess|may_know|might_know|told_you|mentioned|wished yesterday|before|earlier|already|today|"
    "last_time?",
    "as always|usual|ever|promised|agreed|requested|discussed|planned|expected|ordered|follows",
    "as every|any child|kid|one|robot|fool knows",
    "as|like my|our|her|his dear|old? grandmother|grandma|granny|mother|mum|mom|father|dad|grandpa|teacher|aunt|"
    "uncle|boss "
    "always|used_to|often? does|do|did|says|said|say|taught_me|taught_us|liked|likes|loved|wanted always|back_then?",
    "as|like we|i|they|people always|all|used_to|often? did|do|learnt|learned at|in school|kindergarten|college|france|"
    "england|italy|spain|germany|india|china|japan|america|those_days|the_old_days|my_day",
    "like|as in the|my|our good? old days|times|childhood|youth",
    "like a|the good|real|true|proper|big? robot|pro|professional|champion|boss|champ|expert|hero|grown_up",
    "as fast|quickly|soon as you can|like|possible|are_able",
    "whenever|when|once|if|should|as_soon_as you are|'re|have|feel|find|get ready|awake|time|a_minute|a_moment|"
    "a_second|"
    "like_it|free|not_too_busy|not_busy|up_for_it|able|around|the_time|nothing_better_to_do please|today|again?",
    "when|whenever you can|like|have_time|please|may",
    "if i|we may|might|could|dare|can ask|say_so|bother_you|be_so_bold|ask_you|trouble_you?",
    "if i|we may|might|could|dare|can ask|wish for something slightly|a_bit|a_little|even|rather|really? "
    "bigger|larger|harder|fancier|special|more_difficult|more_complicated|more_ambitious|different|new",
    "it|this|that|today is|'s? my|our? very? first|second|third|last day|week|time|try|attempt|shift here|today|"
    "at_work|in_the_lab|on_the_job|at_this_job|with_you|with_a_robot|with_robots?",
    "we|i|everyone|everybody|the_kids|the_children|the_students|all_of_us all? sit|are_sitting|stand|are_standing|"
    "gather|are_gathered in|around a|one|our|the? big|small|little? circle|ring|semicircle|table|carpet "
    "today|now|here|together?",
    "one of these|them|those|the_things|the_blocks|the_cubes is not like the_others|the_other|the_rest|the_other_ones",
    "if you would|could|will|can? please|be_so_kind|be_so_good|be_so_nice|be_kind_enough|do_not_mind|would_not_mind|"
    "do_not_mind_me_asking|ask_me",
    "if that|it|this is|'s okay|ok|alright|fine|all_right|possible|convenient|no_bother|no_trouble|not_a_bother|"
    "not_a_problem|not_too_much_trouble|not_too_much_bother|not_too_much_to_ask|no_problem|not_asking_too_much "
    "with_you|for_you|by_you?",
    "in the meantime",
    "meanwhile",
    "for the fun|sake|hell|love of it|science|argument|art|beauty|god|peace",
    "for fun|science|once|now|me|us|a_change|good_luck|luck|real|today|tonight|sure|the_record|the_moment|"
    "my_peace_of_mind|your_information|pleasure please|dear|thanks|only|again|this_time?",
    "just|only for fun|science|me|us|you|a_change|today|once|now|the_kids|the_children|laughs",
    "all right|good|set|ready|clear then|now?",
    "well well|then|now|yes|okay well?",
    "dear|my|good|oh|thank|holy|bloody|for_the_love_of me|goodness|god|gosh|grief|heavens|lord|cow|hell|"
    "lordy gracious|me?",
    "very|so? much obliged|appreciated indeed?",
    "rain or shine",
    "so far so good",
    "fair|good|nice enough|then",
    "at last|least_that|long_last",
    "once again please?",
    "right now|away|then robot|please?",
    "this|that one|thing|time is|'s|was important|easy|fun|tricky|urgent|for_you|special",
    "every|all day|morning|evening|the_time|the_best|my_love|the_better",
    "how it|how_you_do|how_it_is_done|everything_else|the_rest it|that|this? is|are|is_all|remains up_to_you|"
    "your_business|your_choice|your_decision|your_problem|entirely_up_to_you|not_my_business|none_of_my_business",
    "the|all details|rest|remaining_details|small_details is|are up_to_you|yours|your_business",
    "how|the_rest|the_details|how_you_do_it|how_you_do_that|everything_else|all_the_rest|where_they_go|the_where|"
    "the_how "
    "i|we leave|will_leave|'ll_leave to|up_to you|the_robot|your_taste|your_imagination",
    "i|we leave|will_leave|'ll_leave the_rest|the_details|everything_else|the_how|all_else|how_you_do_it|how_to_do_it|"
    "how_to_get_there to|up_to you|the_robot|your_taste|your_imagination",
    "i|we do not care|mind|bother how|which_way_you_do|why you? do_it|do_that|you_do_it|you_do_that|it_is_done|"
    "you_get_there|long_it_takes|fast_you_are|long_you_take|much_time_you_need?",
    "it|this|that does not matter how|how_long|why you|it? do_it|takes|do_that|is_done|get_there",
    "how|it_does_not_matter_how|no_matter_how long|much_time it|that|you|this takes|take|need does_not_matter|"
    "is_not_important|is_up_to_you|makes_no_difference?",
    "color|colors|the_color|the_colors makes|make no difference to_me|to_us|at_all|here?",
    "i|we need the rest|rest_of_the_table|other_half|space for my|our|the coffee|tea|lunch|breakfast|laptop|books|"
    "papers",
    "it|they|this|that|these|those is|are|'s from|for|by|part_of me|you|us|him|her|a_game|a_test|an_experiment|"
    "a_joke_book|"
    "a_spot_the_mistake_game|a_spot_the_difference_game|a_story|a_study|a_contest",
    "it|this|that is for a|my|our|the spot_the_mistake|spot_the_difference|find_the_mistake game|quiz|puzzle|lesson",
    "not|it_is_not really|my|just? my|an_easy|an? idea|fault|choice|problem|business",
    "nice|clean|neat|short|quick and|but readable|simple|easy|quick|sweet|nice",
    "simple and easy|sweet|clear|fun",
    "my|our|the|a|your? boss|teacher|kids|wife|mother|mum|doctor|client|customer|grandma|daughter|son 's orders|"
    "order|idea|"
    "wish|request|choice|fault|favorite",
    "doctor|boss|teacher|captain|chef 's? orders",
    "i|we have|'ve|had|got a|an|one small|little|big|quick|important? favor|question|request|job|task|wish "
    "to_ask|for_you|today|to_make?",
    "let me|us test|see|show|try|find_out|know|play|begin|start|hope|go how_good_you_are|"
    "what_you_can_do|you_something|something_new|this|now|a_game|if_you_can_do_it|if_this_works|the_fun_begin|"
    "begin|it?",
    "show me|us what you|robots can do|are_made_of|have_got|got",
    "as a|by_way_of|by_way_of_a|for_a warm_up|warmup|favor|treat|joke|present|test|demonstration|surprise|farewell|"
    "thank_you|first_exercise|start|little_game|exercise|break|change to_me|to_us|for_me|for_us|for_the_kids?",
    "breakfast|lunch|dinner|coffee|tea|nap|story|play|party|school|work|cleaning|holiday|bed|bath|game|tidy_up|"
    "quiz|show|"
    "snack|exam time again|everybody|everyone|kids|now?",
    "my name is|was always? what|not_important",
    "would|will|could|can|wo not? you please|now|dear|darling|love?",
    "i|we need|could_use|want a|your|some little? hand|help|assistance please|here?",
    "take care|be_careful not_to hurt|burn|strain|cut yourself|anybody|anyone|somebody",
    "you know|see how to_do it|that|this|these_things|such_things",
    "it|that|this should|will|would|might keep you busy|occupied|entertained|happy for_a_while|today?",
    "in|at your own time|pace|leisure|convenience",
    "without further|any|more|a|making_a ado|delay|hesitation|fuss|mess|noise",
    "by popular|special|general|public? demand|request|tradition",
    "as|like only you can|could|know_how",
    "mind your fingers|head|step|language|manners",
    "you will not regret|be_sorry it|that?",
    "to break|pass|kill the_ice|the|some? time?",
    "without breaking|damaging|hurting|scratching|spilling anything|anybody|anyone|yourself",
    "do not worry|despair|panic if it|this|that takes a_while|long|some_time|time|forever",
    "end of story|discussion|message",
    "hugs|love|kisses and hugs|kisses",
    "a? piece of cake for_you|for_a_robot?",
    "with a big? smile|grin on_your_face?",
    "it|this|that will|would|should|does|need not take long|a_minute|forever|much_time|you_long",
    "is|was|does|did not? it|this|that|he|she not?",
    "if it|that is all? the_same|one to you",
    "it|this|that|that_one|this_one|they|those|these is|are|'s very|really|quite? hers|his|theirs|yours|ours|mine|"
    "not_mine|fragile|delicate|precious|valuable|expensive|reserved|taken|borrowed|an_heirloom|a_keepsake",
    "and|et|then? voila|presto|bingo|high_five|drumroll please?",
    "capisce|comprende|savvy|kapish|mkay|gosh|knock_knock|drumroll|abracadabra|beep_boop",
    "gosh|darn|dang|damn|drat|gosh_darn it",
    "the rest is history",
    "as_per|see|see_also|cf the|my|our? attached|enclosed? sketch|photo|picture|drawing|attachment|image|diagram|"
    "appendix|illustration below|attached|enclosed?",
    "photo|picture|sketch|drawing|image|diagram attached|enclosed|below|follows",
    "up|ready|game|feel_up for a|another|some|the? little|new|next? challenge|game|fun|it|puzzle|round",
    "dear sir|madam|sirs|colleagues|all or|and? madam|sir|colleagues?",
    "last time it|they|this|that took|fell|collapsed|broke|went ages|forever|hours|so_long|over|down|apart|wrong?",
    "if you catch|get|see|take|know my|our|what_i drift|meaning|point|idea|mean",
    "mark|heed|remember|trust my|our words|word|advice",
    "please|and|but? careful|be_careful|take_care|try not to break|drop|damage|scratch|spill|lose anything|it|them|"
    "something|any_of_them please|though|this_time?",
    "as|like|just_as|the_way|how one|everyone|everybody|people|<who> always|usually|often|normally? does|do|did|wants|"
    "want|likes|like|wanted|liked|asked|said|says it|this|that|things|so? always|best|today?",
    "which|that is where|how|as it|they|he|she belongs|belong|should_be|likes_it|like_it",
    "i|we can_not|could_not|can|could reach|do|manage|lift|get|see|find it|them|this|that myself|alone|ourselves|"
    "any_more|anymore|well|properly?",
    "nothing|not_much to it|that|this",
    "come on ,? you|robot can|you_can do_it|do_this",
    "poor|bless|lucky|clever thing|her|him|them|you|me|boy|girl|dear|us",
)
TIMES = (
    "today|tonight|now|right_now|right_away|immediately|at_once|this_time|soon|asap|real_quick|quickly|"
    "in_the_meantime|meanwhile|"
    "this_minute|this_instant|for_now|for_today|just_now|pronto|straight_away please|thanks|robot|ok|okay|then?",
    "this|tomorrow|every_monday? morning|afternoon|evening|week|weekend|time please?",
    "by tonight|tomorrow|noon|lunch|dinner|dinner_time|lunch_time|breakfast|bedtime|the_evening|monday|friday please?",
    "before|after lunch|dinner|breakfast|school|work|supper|tea|bedtime|class|the_show|the_party|the_lesson|"
    "the_meeting|"
    "the_break|christmas please?",
    "before <who> come|comes|arrive|arrives|go|goes|leave|leaves|get|gets|wake|wakes|notice|notices|see|sees|have|"
    "has|must "
    "here|there|home|back|up|to_bed|to_work|to_school|it|this|the_mess|in|lunch|dinner|leave|go?",
    "by_the_time|when|once <who> <is> back|here|ready|awake|there|home again?",
    "by_the_time|when|once <who> come|comes|return|returns|arrive|arrives|get|gets back|home|here|in|again?",
    "pretty please with_a_cherry_on_top|with_sugar_on_top?",
    "please and thank you",
    "when|whenever|as_soon_as you can|like|have_time|have_a_minute|have_a_moment please?",
    "if you can|have_time|have_a_minute|have_a_moment please?",
)
"""When it is to be done: now, or some time of the day."""
IDIOMS, TIMELY = Rows(_WHOLE, _CLASSES), Rows(TIMES, _CLASSES)
