"""Where else a task is told, and how it is graded: "as in figure 3", "like I showed you yesterday", "worth 5 points",
"difficulty: easy", "anything else is a failure".

A text that is complete without it asks for nothing by it. It is left out where it is set off, and a note says so.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.phrases import Classes, Rows
from rpg.language.tokens import Token

_NUMBERS = "|".join(str(number) for number in range(31))
_WORDS = "one|two|three|four|five|six|seven|eight|nine|ten|twelve|fifteen|twenty|thirty"
_CLASSES = Classes({
    "n": (f"{_NUMBERS}|40|45|50|60|90|100|120|180|300|{_WORDS}|sixty|ninety",),
    "source": ("figure|fig|section|sec|chapter|page|appendix|paper|article|video|demo|clip|tutorial|picture|photo|"
               "slide|slides|spec|specification|specs|docs|documentation|protocol|manual|benchmark|readme|handout|lecture|"
               "original|original_paper|last_video|last_demo|project_description",),
    "whose": ("the|our|my|your|this|that|their",),
    "told": ("described|specified|shown|defined|stated|noted|explained|told|demonstrated|mentioned|written|"
             "discussed|agreed|illustrated|depicted|outlined|seen|required|requested|drawn|sketched|done|used",),
    "earlier": ("yesterday|before|earlier|previously|above|below|last_time|last_week|the_other_day|this_morning|"
                "in_class|in_the_video|in_the_demo|in_the_lab|in_the_meeting|at_the_meeting|a_minute_ago|just_now|already",),
    "who": ("i|we|you|he|she|they|my_boss|my_advisor|my_supervisor|the_teacher|my_teacher|the_instructor",),
    "showed": ("showed|told|taught|demonstrated|explained|said|did|used|asked|mentioned|described|promised|agreed|"
               "discussed|practised|practiced|had",),
    "says": ("says|say|said|wants|want|wanted|requires|require|needs|demands|asks|asked|ordered|prescribes|expects|"
             "recommends|insists_on",),
    "rule": ("safety|the_rules|the_rule|the_spec|the_specification|the_paper|the_protocol|the_manual|management|"
             "the_boss|my_boss|the_customer|the_client|the_benchmark|the_plan|the_book|the_recipe|the_task|mom|dad|mum|"
             "the_teacher|my_teacher|my_advisor|my_supervisor|the_reviewer|the_foreman|the_kids|the_grader",),
    "hard": ("hard|easy|difficult|tricky|fun|doable|possible|simple|challenging|trivial|interesting|feasible|"
             "straightforward|a_challenge|no_problem|manageable|fine",),
    "much": ("too|very|so|quite|really|rather|pretty|fairly|a_bit|a_little|super|still",),
    "level": ("easy|medium|hard|low|high|moderate|trivial|simple|beginner|advanced|expert|intermediate",),
    "unit": ("second|seconds|s|sec|secs|minute|minutes|min|mins|step|steps|timestep|timesteps",),
    "else": ("anything|everything|all|any_other_result|any_other_outcome|any_other_state else?",),
    "fails": ("fails|loses|failed", "does|do|will|would not count",
              "is|counts_as|means|will_be|would_be|counts|'s considered|regarded|as? a|an? "
              "failure|fail|wrong|invalid|incorrect|unsuccessful|loss|no_success|not_accepted|not_a_success"),
})  # fmt: skip
_ELSEWHERE = (
    "just|exactly? as|like <told>? in|on|by|per <whose>? <source> <n>?",
    "as|per|as_per|see|see_also|cf|following|according_to|like_in|ref <whose>? <source> <n>?",
    "just|exactly? as|like <told> in|on|by? <earlier>?",
    "just|exactly? as|like <earlier>",
    "just|exactly? like|as|same_as|the_same_as always|usual|ever|in_the_last_round|in_the_previous_round|the_last_time",
    "just|exactly? the|our|my usual thing|procedure|drill|way?",
    "just|exactly? like|as|the_way|how <who> <showed> you|us|me|it|that|them|to_you|with_you? <earlier>?",
    "and|but? that|this is|'s what|how <rule> <says> for|it|us? here?",
    "<rule> says|said|insists so?",
)
_NAMED = (
    "a|an|another|one|the? edge|corner|base|boundary|special|limit|side_effect|failure|worst|best|use case",
    "should you choose|wish|decide to_accept_it|to_accept",
    "back to basics|work|business|square_one",
    "challenge accepted",
    "oh no|dear|boy|man|my|well|yes|great|cool|wow|dear_me",
    "no idea if|whether this|it|that works|will_work|is_possible|makes_sense",
    "not_sure|unsure|not_certain if|whether this|it|that works|will_work|is_possible|makes_sense",
    "hide_and_seek|ready_,_set_,_go|on_your_marks|get_set|tidy_up_time|clean_up_time|play_time|story_time",
    "before|after|at|until bath|bed|dinner|lunch|play|nap|snack|story time",
    "this|it|that is|'s a|an|our|the|my warm_up|test|trial|drill|sanity_check|benchmark|probe|baseline|"
    "warm_-_up|warm_-_up_exercise|warm_up_exercise",
    "check|checked|tick|roger|copy_that|affirmative",
    "tell|notify|ping|call me|us when|once|as_soon_as it|that|this|everything is|'s|has_been "
    "done|finished|complete|over|ready",
    "i|we will|'ll be|come|check back|in? in|within|after <n>|a_few|some minutes|hours|minute|hour|seconds|moment",
)
"""What a text begins or ends with that names or announces it."""
_GRADED = (
    "it|this|that? is|'s? worth <n> point|points|pts|marks|credits?",
    "<n> point|points|pts|marks|credits|star|stars",
    "points|marks|bonus|a_bonus|extra_points for style|elegance|neatness|speed|accuracy|precision",
    "difficulty|difficulty_level|level|tier|rating|level_of_difficulty|complexity :|is|=? <n>|<level>",
    "<level> difficulty|level|mode|tier|case|variant|version",
    "time|step limit|budget|horizon :|is|of? <n> <unit>",
    "timeout|horizon|time_budget :|is|of|after? <n> <unit>",
    "in|within|in_under|under|in_less_than|within_less_than|in_at_most|in_no_more_than|within_at_most <n>|a|half_a "
    "second|seconds|s|sec|secs|minute|minutes|min|mins please|flat|tops?",
    "in|with|using a|one|just_one|only_one single? move|movement|motion|action|swoop",
    "it|this|that is|'s level|stage|task|number|exercise|problem|item|case|round|test|level_number <n>",
    "it|this|that|which should|shall|might|may|will|would|can|could not? be <much>? <hard> enough|for_you|i_think?",
    "but? it|this|that|which is|'s not? <much>? <hard> enough|for_you|i_think?",
    "it|this|that is|'s|looks|seems harder|easier|trickier|simpler than|then it|you|this looks|think|seems|sounds|is|"
    "thought",
    "it|this|that? sounds|looks|seems|appears <much>? <hard>",
    "but? it|this|that is|'s|does not really|at_all?",
    "<else> <fails>",
    "only|just then it|this|that|the_task|the_episode|the_run? counts|succeeds|passes|is_done|is_solved|is_a_success",
    "only|just then does|is it|this|that|the_task|the_episode|the_run count|succeed|pass|done|solved|a_success",
    "or|otherwise the|my|our? demo|test|episode|run|task|experiment|exam|show|video fails|will_fail|is_over|is_ruined|"
    "is_lost|is_failed",
    "or|otherwise|or_else i|we|you|it fail|lose|fails the? course|class|exam|test|game|round?",
    "or else",
    "otherwise it|this|that is|'s|counts_as a? failure|fail|fails",
    "the? exact|precise|all|small? details|detail|timing|speed|position|positions|place|location|"
    "spot do|does|is|are not? matter|important|relevant|"
    "irrelevant|unimportant here|to_me|at_all?",
    "idc|idk|dont_care|do_not_care what|where|how|which|when|which_one|which_ones|about_the_rest|about_that|"
    "about_anything_else?",
    "tags|tag|keywords|keyword|category|topic :|, stacking|sorting|spelling|building|<level>|long_horizon|tabletop|"
    "blocks|letters|numbers|math|towers|patches|demo|test ,? stacking|sorting|spelling|building|<level>|long_horizon|"
    "tabletop|blocks|letters|numbers|math|towers|patches|demo|test?",
)
_ROWS = Rows((*_ELSEWHERE, *_NAMED, *_GRADED), _CLASSES)


def refers_or_grades(tokens: Sequence[Token]) -> bool:
    """Whether these words only say where else the task is told, or how it is graded."""
    plain = tokens and all(token.kind in ("word", "number") or token.word in (":", "'s", ",", "=") for token in tokens)
    return bool(plain) and _ROWS.whole([token.word for token in tokens])
