"""Frames: when, in which picture, who sees it, how it looks. None of it is of the blocks."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.people import PEOPLE, WHO
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.phrases import Classes

_CLASSES = Classes(
    {
        **WHO,
        "may": (
            "can|could|may|might|should|must|will|would|shall|do|does|'d|'ll",
            "am|is|are|was|were going? to|supposed_to|meant_to|able_to",
            "have|has|had|ought|need|needs|want|wants|wish|wishes|hope|hopes|expect|expects|like|likes|love|loves to",
            "would|should|'d also|really|just? like|love|wish|hope|prefer to",
            "should|must|will|would be|have able_to|to",
        ),
        "just": ("just|only|also|simply|always|now|still|then|clearly|basically|again|really|indeed",),
        "see": (
            "see|sees|seeing|notice|notices|observe|observes|recognize|recognizes|spot|spots|discover|discovers",
            "behold|perceive|perceives|view|views|make_out|makes_out|look_at|looks_at|looking_at|be_looking_at",
            "be_shown|get_to_see|gets_to_see|be_seeing",
        ),
        "get": ("have|has|get|gets|find|finds|end_up_with|ends_up_with|be_left_with|receive|obtain|obtains",),
        "want": (
            "want|wants|wanted|need|needs|needed|like|likes|wish|wishes|imagine|imagines|imagined|picture|pictured",
            "envision|envisage|prefer|expect|expects|require|visualize|visualise|mean|describe|love|have_in_mind",
            "has_in_mind|had_in_mind|am_after|are_after|am_looking_for|are_looking_for|am_thinking_of|dream_of|think_of",
            "thought_of|drew|draw|took|take|made|painted|sketched|photographed|am_describing|am_imagining|am_picturing",
            "aim_for|aim_at|strive_for|go_for|hope_for|wish_for|ask_for|asks_for|ask|demand|demands|care_about|care_for",
        ),
        "kind": (
            "final|finished|end|target|goal|desired|wanted|imagined|completed|complete|whole|resulting|mental|expected",
            "correct|ideal|attached|overall|entire|required|requested|intended|planned|following|perfect|nice|simple",
            "finishing|closing|concluding|reference|envisioned",
        ),
        "scene": (
            "picture|image|photo|photograph|snapshot|drawing|sketch|illustration|scene|view|arrangement|result|layout|shot",
            "setup|state|configuration|outcome|situation|composition|painting|postcard|pic|screenshot|end_result",
            "goal_state|end_state|floor_plan|floorplan|ground_plan|blueprint|photos|pictures|camera_image|camera_picture|goal_picture|still_life|end_product",
            "final|finished|completed|complete|whole|resulting|desired|wanted|end "
            "thing|product|work|construction|model|build|structure|creation",
        ),
        "anyone": ("<person>", f"{PEOPLE}|mommy|mummy|mum|daddy|granny|grandma|grandpa|auntie|she|he"),
        "surface": ("table|desk|workspace|tabletop|work_surface",),
        "whose": (
            "in|inside my|our|your|the mind|head|imagination|dreams|thoughts",
            "in|before|in_front_of my|our|me|us eyes|nose?",
            "that|which? <person> <just>? <may>? <just>? <want>|<see>|<get> <just>? to_have|to_see|to_get? <time>?",
            "that|which? <person> <just>? <may>? have|has|had in my|our|your|their mind|head|imagination",
            "that|which? is|are|must|should|has_to|'s be? "
            "reached|built|made|seen|achieved|wanted|needed|desired|required|expected",
            "to be reached|built|made|seen|achieved",
            "to build|make|reach|achieve|aim_for|produce",
            "of|for|from the|this|my|our|your? task|job|table|game|goal|blocks|scene|desk|puzzle",
            "of <work>",
            "that|which? was|were|is|has_been taken|made|drawn|shot|painted by_me|yesterday|today? <time>?",
            "for you|me|us|the_robot|today",
            "here|below|above|attached|on_the_wall|on_the_card|on_my_desk|on_the_box|in_the_book|in_the_manual",
            "<time>",
        ),
        "table": ("the|my|our|your|this? <kind>? <surface>",),
        "pictured": ("<which>? <kind>* <scene> ,? <whose>*",),
        "over": (
            "done|finished|completed|complete|ready|over|through|accomplished|fulfilled|solved|set|in_place|at_an_end",
            "settled|tidied_up|cleaned_up",
        ),
        "work": (
            "everything|all|all_this|it_all|the_whole_thing|all_of_it|things",
            "the|this|your|my|our|all_the whole|entire? "
            "work|task|job|episode|building|construction|mission|moving|stacking|sorting|tidying|test|run|trial|procedure|"
            "experiment|operation|session",
        ),
        "worker": ("you|we|i|the_robot|he|she|they|the_arm|the_robot_arm|the_gripper|the_manipulator|the_agent",),
        "have": ("is|are|has|have|am|is_all|are_all|has_all|'ve|'re|will_be|has_been|have_been|gets",),
        "when": ("when|once|as_soon_as|after",),
        "time": (
            "at|by|in the very? end",
            "at|by the very? end|finish|close|conclusion|completion of|for <work>|the_day",
            "on|upon the? completion|conclusion|termination",
            "on|upon the? completion|conclusion|termination of <work>",
            "at the finish|close",
            "as a|an|the final|end|overall result|outcome",
            "<when> <work>|<worker> <have> <over> <work>|its_work|its_job|their_work|their_job|with_it_all?",
            "<when> <worker> finish|finishes|stop|stops|end|ends <work>|working|building?",
            "<when> <work> ends|end|finishes|finish|stops",
            "when|once all is? said_and_done",
            "when|if|as <person> look|looks|am_looking|are_looking|is_looking at|upon <pictured>|<table>",
            "if|when|provided everything|all|it|things|the_work <went> <well>",
            "if|when|provided|once <worker> <did> <well>",
            "<when> done|finished|completed|finishing|completing|ready",
            "after the|your|all_the|all work|job|building",
            "in|for the|a finished|final|end|completed|target|goal|desired|wanted "
            "state|version|form|scene|picture|situation|arrangement|layout|configuration|setup|result",
            "at|by quitting|closing|bed|finishing time",
        ),
        "where": (
            "<time>",
            "at|in|by|on end|finish",
            "through|in|with|by the|my|your|a? camera|camera_lens|lens|own_eyes|eyes",
            "finally|eventually|ultimately|lastly|at_last|at_long_last",
            "in|on <pictured>",
        ),
        "break": (",|:|that|how|…",),
        "is": ("is|are|was|were|would_be|will_be|should_be|must_be|shall_be|has_to_be|'s|be|is_to_be|is_just",),
        "this": (
            "this|the_following|as_follows|like_this|like_that|like_so|so|this_one|this_here|this_way|thus|this_picture",
            "the_next_one|exactly_this|just_this|something_like_this|simple|easy",
        ),
        "looks": (
            "look|looks|looking|appear|appears|be|end_up|ends_up|turn_out|turns_out|come_out|comes_out|be_arranged|is",
            "are|be_laid_out|is_arranged|is_laid_out|is_set_up|be_set_up|goes",
        ),
        "so": (
            "exactly|just|precisely|more_or_less|roughly|something? "
            "like_this|as_follows|like_so|this_way|like_that|thus|like_the_following",
            "as|like in|on <pictured>",
        ),
        "fine": (
            "great|nice|good|lovely|wonderful|perfect|cool|fine|fun|enough|ideal|right|correct|the_best|sufficient",
        ),
        "well": ("well|right|fine|correctly|correct|perfectly|properly|as_planned|according_to_plan|smoothly|out",),
        "went": ("go|goes|went|is|works|worked|is_done|was_done|has_gone",),
        "did": ("did|do|does|have_done|has_done|worked|works it|everything|all|this|the_task|the_job|your_job?",),
        "thing": ("what|all|everything|the_thing|the_only_thing that|which?",),
        "wanted": ("wanted|needed|required|desired|requested|asked_for|expected|wished_for|sought|planned|intended",),
        "shows": ("show|shows|showing|depict|depicts|display|displays|present|presents|feature|features|portrays",),
        "has": ("have|has|contain|contains|consist_of|consists_of|include|includes|is_made_of|comprises",),
        "how": ("exactly|precisely|just|basically|roughly? how|what|the_way",),
        "of": ("of|showing|with|in_which|on_which|where|that_shows|which_shows|:|, :?",),
        "here": ("here|there|this|that|it is|comes|follows|are|was|will_be|would_be|should_be|must_be",),
        "told": ("<how> <person>|it|things|everything|all|<table>|<pictured> <may>? <want>|<see>|<get>|<looks>",),
        "wished": ("like|to_see|to_have|it|things",),
    }
)
_FRAME = (
    "<where> ,|:? <where>? ,|:?",
    "<where>? ,? on? <table>? ,? <person> <just>? <may>? <just>? <see> <just>? <this>? on_the_table? <where>* <break>*",
    "on <table> ,? <person> <may>? <get> <where>* <break>*",
    "<where>? ,? <anyone> drew|draws|has_drawn|painted|has_painted|sketched|imagines|describes|dreams_of|photographed "
    "<break>*",
    "<person> <may>? <want> <table>|<pictured>|it|everything|things to? look|be|appear like|as <break>*",
    "<where>? ,? <table>|<pictured>|everything <just>? <may>? <just>? look|looks like|as <break>*",
    "<where> ,? <person> <just>? <may> <just>? <get> <just>? <where>* <break>*",
    "<where>? ,? <person> <may>? <want> <just>? to_see|to_have|to_get|to_find <where>* <break>*",
    "<where> ,? <person> <may>? <want> <just>? <where>* <break>*",
    "<where>? ,? <thing> <person> <just>? <may>? <just>? <see>|<get>|<want> "
    "to_see|to_have|to_get|to_find|to_end_up_with|seen? <where>* ,|:? <is>? <this>? <break>*",
    "<where>? ,? what is|can_be|could_be|should_be|must_be|has_to_be|will_be|remains|stays|results|stands|lies "
    "to_be|then? seen|shown|left|there|visible|left_over|left_behind|standing|present|to_see|on_the_table|wanted? "
    "<where>* ,|:? is|are|will_be|should_be|must_be|: <this>? <break>*",
    "<where>? ,? <table>|<pictured>|it|that|everything|things|all|they <just>? <may>? <just>? <looks> <so> <where>* "
    "<break>*",
    "<person> <just>? <may>? <just>? <see>|<want> it|<table>|everything|things <so> <where>* <break>*",
    "<where>? ,? <table>|<pictured> ,? <just>? <may>? <just>? <shows> <this>? <where>* <break>*",
    "<where>? ,? <table> <just>? <may> <just>? <has> <this>? <where>* <break>*",
    "<where>? ,? <pictured> ,? <just>? <may>? <just>? <has>|<is> <this>? <where>* <break>*",
    "<kind>* <scene> <wanted>? :",
    "<where> ,? is|are|can_be|could_be|it_is|one_can to? be? see|seen|shown|visible|found|depicted <break>*",
    "please? build|make|do|recreate|copy|reproduce|produce|show|set_up what <person> <may>? <see>|<want> <where>* :|,",
    "please? do|build|arrange|put|lay|place|set|make|have it|this|them|everything|things|all? <so> <where>* :",
    "please? do|build|arrange|put|lay|place|set the|all|all_the blocks|cubes|bricks|things|letters <so> <where>* :",
    "the|all|all_the blocks|cubes|bricks|things|letters <just>? <may>? be|are|stand|lie|go|get? "
    "positioned|placed|arranged|put|laid|standing|lying|set_up|distributed|laid_out? <so> <where>* :",
    "<person> am|is|are|will_be|would_be very|really|quite? satisfied|happy|content|pleased|glad if|when|once",
    "<so> <where>* :",
    "so|thus|like_this|this_way it|everything|the_table|things <may>? be|look|stand? <where>* :",
    "so <may> it be|look <where>* :",
    "exactly|just? this|the_following <may> come_out|be_the_result|result|be_there|be_seen <where>* :",
    "<pictured> :",
    "there <may>|is|are|has_to be? seen|found|shown|visible|observed <where>* <break>*",
    "<where>? ,? <person> <may>? look|looks|looking|glance at|upon|on <table>|<pictured>|it from_the_front|"
    "from_above|from_here? and|, <person>? <see> "
    "<where>* <break>*",
    "looking at|upon|on <table>|<pictured> ,? <person> <may>? <see> <where>* <break>*",
    "before us|me|you|my_eyes|our_eyes is|are|lies|lie|stands|stand|we_see|i_see|you_see|one_sees|there_is|there_are",
    "<where>? ,? <table>|<person> <may>? end|ends|end_up|ends_up|finish|finishes|be_left|are_left with <break>*",
    "<person> <did> <well> if|when|once|as_soon_as",
    "<kind>* solution|answer|end_state|requirement|deliverable :|,",
    "the|this? ground_truth|reference|expected_outcome|expected_behavior|gold_standard|spec|specification of|for? "
    "the|this|our? demo|task|episode|test|eval|evaluation|benchmark|video|paper|experiment|ablation|baseline? :|is|,:",
    "for the|an|our|this ablation|baseline|benchmark|evaluation|eval|rollout|rollouts|sanity_check|regression_test ,?",
    "to be? built|made|seen|done|shown|achieved|reached|see|build|achieve|produce|find <where>* :",
    "<wanted> is|are|: <where>* :?",
    "have|take|let_us_have|let_us_take a look|glance|peek|good_look at this|the_following|it|<pictured> :|,",
    "imagine|think_of|picture <pictured>|this|the_following? :|,?",
    "<pictured> was|is|has_been taken|made|drawn|shot|painted <where>* <break>*",
    "here|there|below|now? <person> <just>? <may>? <see> <told> <wished>? <where>* <break>*",
    "<anyone> <may>? have|has|had|am|is|are|'ve? looking_at|holding|look_at|looks_at|got|took|taken|made|drew|"
    "drawn|have|has|sent|showed|shows|show|painted|seen|see|sees|find|found me|us? <pictured> <of>",
    "<where>? ,? it|everything|things|the_story|the_whole_thing|<work> all? <just>? <may>? end|ends|finish|finishes|"
    "conclude|concludes with|by_having",
    "<here> <told> <wished>? <where>* <break>*",
    "<here> <pictured> <of>",
    "imagine|visualize|visualise|envision|envisage|think_of|consider|conjure_up|look_at|recreate|reproduce|give_me|make|"
    "let_us_make|show|show_me|create|build|produce <pictured> <of>",
    "imagine|visualize|visualise|envision|envisage to_yourself|with_me|please? that|:|,? <where>? :|,?",
    "imagine|visualize|visualise|envision|envisage|picture|think_of this|the_following|it_like_this :|,?",
    "a|the|one? <kind>* photo|picture|photograph|image|drawing|sketch|snapshot of|showing|with|: :?",
    "i|we <may>? describe|explain|tell|describing|explaining you|to_you? <how> <person> <may>? <see>|<want> <where>* "
    "<break>*",
    "i|we <may>? describe|describing|explain <pictured> <where>* <break>*",
)
"""What stands before a description of how it is in the end."""
_SEVERAL = (
    "the? two|three|four|five|following|next|these|all_these|all_of_these|both things|conditions|statements|facts|"
    "requirements|points must|have_to|should|need_to|are_to be_true|hold|be_the_case|be_met|be_so|be_fulfilled|"
    "be_satisfied <where>*",
    "all_of_these|all_of_this|both|all_these must|have_to|should|need_to|are_to be_true|hold|be_the_case|be_met "
    "<where>*",
    "there are two|three|four|five things|conditions|requirements|rules|goals|criteria to_meet|to_fulfil|"
    "to_fulfill|to_satisfy|here|for_success?",
)
_POINTING = (
    *_SEVERAL,
    "<where>? ,? <table>|<pictured>|it|that|everything|things|all <just>? <may>? <just>? <looks> <so> <where>*",
    "<where>? ,? <pictured> <is> <this> <where>*",
    "here|this is|comes|follows <pictured> <where>*",
    "<pictured> follows|is_described_below|comes_next|comes_now",
    "here|this is <told> <wished>? <where>*",
    "i|we <may>? describe|explain <pictured> <where>*",
    "i|we|let_me|let_us <may>? describe|explain|tell you|to_you? <how> <person> <may>? <see>|<want> to_see? <where>*",
    "imagine|picture|visualize <pictured>",
    "imagine|picture this|the_following",
)
"""Sentences that say no more than that a description follows."""
_CLOSING = (
    "that|this|which|so|and_that|and_this? is|'s|would_be <told> <wished>? <where>*",
    "that|this|which is|'s <pictured> <where>*",
    "that|this|which|so|and_that? is|'s|would_be <how> <pictured>|<table> <may>? <shows>|<looks>|<has> <where>*",
    "is|are|would_be|will_be exactly|just|really? all|what|everything that? <person> <just>? <may>? <want>|<see>|<get> "
    "to_see|to_have? <where>*",
    "that|this|it|which? would|will|shall be very|really|just|so? <fine>",
    "that|this|it|which? would|will make me|us|everybody|everyone|the_children very|really|so? happy|glad|proud",
    "and? that|this is|'s exactly? the|my|our|a <kind>* tower|stack|row|line|column|grid|figure|shape|word|pyramid|"
    "circle|square|structure|thing|task|job|building that? <person> <may>? <want>|<see>|<get> <where>*",
    "as|like in|on|shown_in|seen_in|you_see_in|you_can_see_in|i_see_in <pictured>",
    "and? that|this is|'s|was|would_be the|my|our|a? <kind>* <scene>|all|it|everything",
)
"""What is said behind a description of it all."""

FRAMES = Patterns(*_FRAME, *(f"{several} :" for several in _SEVERAL), classes=_CLASSES)
POINTING = Patterns(*_POINTING, classes=_CLASSES)
CLOSING = Patterns(*_CLOSING, classes=_CLASSES)
WHEN_DONE = Patterns("<time>", classes=_CLASSES)
IN_PICTURE = Patterns("in|on <pictured>", classes=_CLASSES)
_WHERE = Patterns("<where>", classes=_CLASSES)


_VIEWS = Classes(
    {
        **WHO,
        "look": (
            "look|looks|am_looking|are_looking|is_looking|watch|watches|see|sees|view|views|read|reads|am_reading",
        ),
        "thing": (
            "it|them|this|that|everything|things|all",
            "the|my|our table|row|tower|stack|line|column|blocks|cubes|letters|word|desk|digit|letter",
        ),
        "side": ("point_of_view|perspective|side|view|viewpoint|angle|position|seat|chair|place|standpoint|eyes",),
        "here": (
            "i|we|you|the_viewer|the_camera|the_robot sit|sits|stand|stands|am|are|is|look|looks",
            "i|we|you|the_viewer|the_camera|the_robot am|are|is sitting|standing|seated|looking",
        ),
    }
)
VIEW = Patterns(
    "when|if|as|while|whenever|how <person> <look> at|upon? <thing>? from_above|straight_from_above|from_here?",
    "when|if looking|looked|viewed|seen|read at|upon? <thing>? by|from|for <viewer>",
    "when looking|reading at? <thing>",
    "as? seen|viewed|looked_at|visible? from where <here>",
    "as? seen|viewed|looked_at|visible from|by <viewer> 's? <side>?",
    "as? seen|viewed|looked_at|visible from my|our|your <side>",
    "as|when? seen|viewed|looked_at|watched from above|straight_above",
    "seen|viewed|looked_at from the_top|the_front|in_front",
    "from my|our|your|this? point_of_view|perspective|view|viewpoint|standpoint|angle",
    "from <viewer> 's point_of_view|perspective|viewpoint|standpoint|angle|side",
    "for the viewer|camera|audience|spectator|observer",
    classes=_VIEWS,
)
"""Who looks at it, which changes nothing: sides are the viewer's. From elsewhere it would."""
_PILED = frozenset({"tower", "towers", "stack", "stacks", "stacked"})


def told_down(words: list[str], at: int) -> bool:
    """Whether what is piled up is seen from the top: that it is told downwards, and not who looks at it."""
    return words[at + 1 : at + 4] == ["from", "the", "top"] and not _PILED.isdisjoint(words)


def past(p: Parser, j: int) -> int:
    """The position after ", when all is done,", which may stand in the middle of anything; `j` where nothing does."""
    if not p.stands(j, (",",)):
        return j
    return max((k + 1 for k in _WHERE.matches(p, j + 1) if p.stands(k, (",",))), default=j)
