"""What people say around an instruction: who it is for, how it feels, that it comes now. None of it asks for anything.

Patterns as in `wishes`: rows of slots with what may stand there.
"""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.framing import CLOSING, POINTING
from rpg.language.grammar.talk.let_go import LET_GO
from rpg.language.grammar.talk.people import FINE, PEOPLE
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_ERRAND = (
    "task|job|request|plan|idea|goal|instruction|instructions|wish|exercise|challenge|puzzle|problem|question|mission|"
    "game|assignment"
)
_OPEN = (
    "the_order_of_the_rest|the_order_of_the_others|the_order|the_exact_order|order|which_order|which_one_goes_where|"
    "what_order|the_direction|which_direction|"
    "the_orientation|the_exact_position|the_exact_positions|their_order|their_exact_order|their_exact_positions|"
    "the_exact_place|the_exact_places|the_exact_spot|where_exactly|where_on_the_table|where|where_it_is|where_they_are|"
    "where_it_stands|where_they_stand|where_you_build_it|where_you_put_it|where_you_put_them|which_is_which|"
    "which_goes_where|which_comes_first|which_one_comes_first|what_they_are|the_rest|everything_else|anything_else|"
    "how_you_do_it|how_you_do_that|how_you_get_there|how_it_is_done|how|the_colors|their_colors|the_color|its_color|"
    "the_numbers|which_numbers|what_numbers|which_numbers_they_are|the_digits|which_digits|the_letters|which_letters|"
    "what_color|what_color_it_is|what_color_they_are|which_color|which_colors|which_color_it_is|which_colors_they_have"
)
_FREE = (
    "up_to_you|irrelevant|unimportant|not_important|of_no_importance|your_choice|your_decision|left_to_you|"
    "all_the_same_to_me|all_the_same|not_relevant|arbitrary|for_you_to_decide|for_you_to_choose"
)
_WHERE = (
    "position|positions|location|locations|place|places|spot|spots|placement|orientation|orientations|rotation|"
    "rotations|yaw|angle|angles|heading|direction|alignment"
)
"""Where something is, and how it is turned."""
_OF_WHAT = (
    "of|in|on? the|each|every|them|these|a? stack|stacks|tower|towers|group|groups|block|blocks|cube|cubes|letters|"
    "digits|"
    "numbers|table|grid|row|line|column|wall|pyramid|square|circle|ring|word|figure|structure|shape|pattern|"
    "checkerboard|"
    "whole|arrangement?"
)
_MATTERS = "do|does not really|actually? matter at_all|to_me|here|much?"
CHATTER = Patterns(
    f"the|their|its exact|final|precise|overall|absolute? {_WHERE} {_OF_WHAT} {_MATTERS}",
    f"the|their|its exact|final|precise|overall|absolute? {_WHERE} and|or the|its|their? {_WHERE} {_OF_WHAT} "
    f"{_MATTERS}",
    f"the|their|its exact|final|precise|overall|absolute? {_WHERE} {_OF_WHAT} is|are {_FREE}|free|open|left_open",
    "i|we|my_boss|my_teacher|they do|does|really not really|particularly|much|actually? care|mind|worry|bother "
    f"about|at_all|much? {_OPEN}?",
    f"it|that does not really|actually? matter|make_a_difference|make_any_difference at_all|to_me|here? {_OPEN}?",
    "it|that does not really|actually? matter how|in_which_direction|which_way|at_which_angle|in_what_direction it|"
    "they|"
    "the_row|the_line|the_grid|the_tower|the_wall is|are|runs|run|goes|go|turned|rotated|oriented|placed|faces|face "
    "turned|rotated|oriented|placed?",
    f"it|that is|remains|stays really|entirely|completely|totally|quite? {_FREE} {_OPEN}?",
    f"{_OPEN} is|are|remains|stays entirely|completely|totally|really|quite? {_FREE}|free|open|left_open",
    f"{_OPEN} do|does not really|actually? matter at_all|to_me|here?",
    f"you can|may|are_free_to choose|pick|decide|select|decide_on yourself|freely? {_OPEN} yourself|freely?",
    f"i|we have|'ve|got|brought a|an|another|one|this|some|your? new|little|small|simple|quick|easy|nice|special? "
    f"{_ERRAND} for_you|for_the_robot|today|here|now?",
    "i|we need|could_use|want|would_like|require your|some|a_bit_of|a_little? help|assistance|support with_this|"
    "with_something|here|now|today?",
    "can|could|will|would you help|assist me|us with_this|with_something|here|out|now|today?",
    f"let us play|try|do a|another|the|this? little|quick|new|nice? {_ERRAND}|experiment|trick",
    "let us do|try some? stairs|towers|rows|pyramids|letters|words|numbers|shapes|figures|steps|colors now|today?",
    "it_is? time to|for tidy|clean|clear|play|build|learn|count|spell|begin|start|work|cleaning|tidying|playing "
    "up|away? together|again|with_the_blocks|our_blocks|the_blocks|now|everyone?",
    "shall|should|can|could|may|will we|i count|play|try|learn|begin|start|see|practise|practice|sing together|a_game|"
    "something|a_bit|a_little|now|some_more?",
    "let us begin|start|go|get_started|get_going|do_this|do_it|get_to_work|try_this|try_something|see|go_ahead|play",
    f"my|our|the? {PEOPLE} wants|want|likes|like|loves|love|prefers|prefer|needs|need|expects a|the? "
    "tidy|neat|clean|nice|orderly? tidy|neat|clean|nice|orderly? table|desk|workspace",
    f"this|it|that is for my|our|the? {PEOPLE}|class|classroom|lesson|school|demo|presentation|birthday|homework|"
    "exam|fun|video|photo",
    f"here is|comes|are the|my|our|your|a|another|one? next|new|first|little|simple|today_'s? {_ERRAND}",
    "can|could|will|would you please? do|try|solve|handle|manage|start a|an|another|the|this|my|our? easy|simple|"
    f"quick|new|next|little|small|unscramble|spelling|stacking|sorting|building|pick_and_place? {_ERRAND} for_me|"
    "for_us|now|today|please?",
    "listen|attention|listen_up|look|look_here|pay_attention|ready|are_you_ready|wake_up|come_on|here_we_go|"
    "off_we_go|here_goes please|everyone|everybody|robot|now?",
    f"that|this|it would|will|'d be so|really|very|just? {FINE}",
    f"you are|'re so|really|very|simply? {FINE}",
    "thank_you|thanks so_much|very_much|a_lot|a_million|for_your_help|for_helping|in_advance|again?",
    "that|this is|was all|it|everything for_now|for_today|i_need|we_need|i_want|we_want?",
    "that|this|it should do it|be_it|be_easy|be_simple|be_enough|be_fun|be_doable|be_no_problem",
    "this|that|it|all|everything is|seems|sounds quite|very|really|not|not_so? "
    "easy|simple|fun|difficult|hard|tricky|important|clear",
    "i hope this|that|it is|works|helps|makes_sense clear|easy|simple|okay|ok?",
    "good|nice|well job|work|done|luck|boy",
    "we|you|i start|begin with|from|in a|the|this|total|complete? total|complete|big|real? mess|chaos",
    "everything|it|the_table|the_desk|the_blocks|the_cubes is|are a|in|in_a|one|such_a? total|complete|big|real? "
    "mess|chaos|disorder",
    "do not worry|hurry|rush about_it|anything?",
    "and|now|please? spell|write it|that|this out? please|now?",
    "take your time",
    "both|both_of_them|all|all_three|all_four|all_of_them|they|these|those|everything are|is|being? "
    "just|only|simple|plain|ordinary|normal? cubes|blocks|bricks|a_cube|a_block",
    "do_you_think? can|could|will|would you do|manage|handle|arrange it|this|that for_me|for_us|please?",
    "is|would that|this|it be? possible|okay|ok|doable|feasible for_you?",
    "any|whatever|whichever orientation|rotation is|will|would fine|ok|okay|do|be_fine|allowed",
    "done|finished|over|ready|go|stop",
    "have fun",
    "show|tell me|us please? with|using|in the? letter? blocks|cubes|letters please?",
    "please|now|let_us? tidy|clean|clear up? please|now|everybody|kids?",
    "i|we am|are making|doing|shooting|preparing|planning|taking a|the|some|this? nice|little|short? "
    "picture|pictures|photo|photos|video|videos|demo|poster|presentation|game|exercise for|of? my|our|the|a? "
    "school|class|lab|team|website|paper|lesson|project? website|project|page|today?",
    "the|my table|desk|workspace is messy|untidy|a_mess|in_disorder",
)
"""Whole sentences that ask for nothing. Disorder is how things begin anyway."""


def idle(tokens: list[Token]) -> bool:
    """Whether a sentence asks for nothing."""
    return _wholly(tokens, CHATTER, CLOSING, POINTING, LET_GO)


def announces(tokens: list[Token]) -> bool:
    """Whether a sentence says no more than that the next one describes it all: "The table looks like this."."""
    return _wholly(tokens, POINTING)


def _wholly(tokens: list[Token], *tables: Patterns) -> bool:
    first = tokens[1 if tokens[0].word == "," and len(tokens) > 1 else 0].word
    if not any(first in table.firsts for table in tables):
        return False
    p = Parser(tokens)
    start = p.opt(0, ",")
    return any(p.opt(j, ",", ":") == p.end for table in tables for j in table.matches(p, start))
