"""Words for blocks that are only there: "as distractors on the table", "that play no role", "just to distract"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import Marks, colors
from rpg.language.meaning import Absolute, At, Chain, Clause, Coord, Meaning, Noun, Size, That, Using
from rpg.language.phrases import Classes

_ROLES = "distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys"
_SPOTS = "somewhere|anywhere|on_the_table|on_it|in_the_scene|around|nearby|somewhere_on_the_table|by|there|about|aside"

AS_EXTRAS = Patterns(
    "present|lying|standing|sitting|placed|as_well|too? there|around|present|lying_around|lying_about|standing_around|"
    "standing_by|on_the_table|somewhere|somewhere_on_the_table|nearby|in_the_scene|by|on_the_side|to_the_side? ,? "
    "but|though|and? "
    f"just|only|merely|simply|purely? as|for|to_serve_as|serving_as|acting_as|to_act_as a|an|some|mere|pure? {_ROLES} "
    f"{_SPOTS}?",
    "there|around|present|lying_around|on_the_table? ,? just|only|merely|simply|purely|solely? to "
    "distract|confuse|mislead you|us|the_robot|from_it|from_the_task?",
)
"""Behind blocks, or behind what is said of where they are."""
_IDLENESS = Classes(
    {
        "just": ("just|only|merely|simply|purely|also|too|solely|totally|completely|really|actually|basically|all",),
        "mere": ("just|only|merely|simply|purely",),
        "may": ("can|should|must|may|might|could|will|shall|are_to|is_to|has_to|have_to|need_to|needs_to",),
        "here": (
            "here|there|at_all|whatsoever|for_us|for_me|for_you|today|anymore|any_more|either|too|though|anyway",
            "in|for|to|with|of|about this|that|it|all_this|any_of_it|the_whole_thing|what_we_do",
            "in|for|to|of the|this task|game|goal|plan|result|job|puzzle|story",
            "on the table|desk|workspace",
            "somewhere|anywhere|nearby|in_the_scene|for_now|in_particular",
        ),
        "not": (
            "do|does|did|should|must|may|can|will|would|need|needs|shall|could|has|have not",
            "never|nowhere",
        ),
        "part": (
            "role|part|function|meaning|importance|significance|purpose|relevance|influence|job|task|effect|use|"
            "consequence|bearing|interest|concern|value|duty",
        ),
        "role": (
            "<just>? play|plays|playing|have|has|having|serve|serves|get|gets|with|being_of|are_of|is_of|be_of "
            "no|zero|little real|special|particular|further|other? <part>",
        ),
        "dummy": (
            "a|an|some|mere|pure? "
            "distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys|scenery|background|"
            "ornament|ornaments|filler|fillers|red_herring|red_herrings|dummy|dummies|spectator|spectators",
        ),
        "idle": (
            "irrelevant|unimportant|unused|superfluous|unneeded|spare|extra|left_over|leftover|left_out|ignored|unnecessary|"
            "meaningless|uninvolved|redundant|insignificant|immaterial|pointless|of_no_importance|of_no_interest|"
            "of_no_use|of_no_relevance|of_no_concern|beside_the_point|no_part_of_it|without_meaning|without_a_role|"
            "without_function|without_importance",
            "not|no a? part|member of it|this|that|all_this|the_whole|anything",
            "not|no a? part|member of the|this task|tower|row|structure|goal|game|puzzle|job|picture|plan",
            "not to_be? used|needed|required|relevant|important|involved|of_interest|part_of_it|part_of_this|counted|"
            "wanted|concerned|interesting|to_be_used|necessary",
            "<mere>|mere|pure? there|around|present? but? as? <dummy>",
            "<mere>? for_show|for_decoration|to_look_at|there_to_look_pretty|along_for_the_ride|in_the_way",
            "<mere> around|there|about|by|lying_around|standing_around|lying_there|present|nearby|sitting_around|"
            "standing_by|bystanders|a_bystander",
        ),
        "purpose": (
            "to distract|confuse|mislead|look_pretty|look_nice|fill_the_table you|us|the_robot? from_it|from_the_task?",
            "for|as a|some|mere|pure? distraction|decoration|show|fun|confusion",
        ),
        "lie": (
            "are|is|be|lie|lies|lying|stand|stands|standing|sit|sits|sitting|rest|rests|was|were|remain|remains",
            "stay|stays|left",
        ),
    }
)
NO_ROLE = Patterns(
    "<may>? <role> <here>*",
    "<not> <just>? play|have|serve|get a|any <part> <here>*",
    "<not> be|become part|a_part|parts|used|member|in of|in|for? it|them|this|that <here>*",
    "<not> be|become part|a_part|parts|used|member|in of|in|for? the word|tower|row|stack|structure|pattern|task",
    "<not> <just>? matter|count|participate|take_part|join_in|concern_us|concern_you|interest_us|contribute|"
    "mean_anything|belong_to_it|belong_to_this|belong_here|belong_there|be_used|be_needed|get_used|have_to_be_used|"
    "need_to_be_used|make_a_difference <here>*",
    "are|is|be <just>? <idle> <here>*",
    "<may> be <just>? <idle> <here>*",
    "<may> be ignored|disregarded|left_out|left_aside|left_unused|forgotten|overlooked|skipped <here>*",
    "<may> <just>? remain|stay unused|aside|out_of_it|left_over|out_of_play <here>*",
    "remain|remains|stay|stays|go|goes unused|aside|out_of_it|left_over|out_of_play <here>*",
    "<just>? serve|serves|act|acts|function|functions|count|counts <just>? as|for <dummy> <here>*",
    "<mere> <lie> around|about|by|there|nearby|lying_around|standing_around|present <here>*",
    "<lie> <mere> around|about|by|there|nearby|lying_around|standing_around|lying_there|for_show|in_the_way <here>*",
    "<lie> there|around|present|about|lying_around|on_the_table <just>? <purpose>",
    "<just>? distract|distracts|confuse|confuses <here>*",
    "have|has <just>? nothing to_do with it|this|that|the_others|others|anything",
    "have|has <just>? nothing to_do with the|this task|tower|row|structure|goal|game|puzzle|job",
    "you|we|i|the_robot|one|they <not> <just>? need|use|care_about|have_to_use|need_to_use <here>*",
    "you|we|i|the_robot|one <may> ignore|forget|forget_about|leave_out|skip|disregard|leave_aside <here>*",
    "nobody|no_one needs|uses|wants|cares_about|asks_for|asks_about <here>*",
    classes=_IDLENESS,
)
"""What is said of such blocks."""
_OF_THEM = Patterns(
    "too|as_well|also? ,? and? that|which|who",
    "too|as_well|also? ,? and|but",
    "too|as_well|also? ,? and|but it|they|this_one|these|those",
    "too|as_well|also? , it|they|this_one|these|those",
    classes=_IDLENESS,
)


_AROUND = frozenset({*lexicon.TABLE, "there", "around", "about", "scene", "too", "well"})
"""What is said last of where blocks are that are only there."""


def said_idle(p: Parser, i: int) -> Iterator[int]:
    """Positions after "(on the table) which plays no role", "(there), but has no part in it"."""
    for j in _OF_THEM.matches(p, i) if p.follows(i, _AROUND) else ():
        yield from NO_ROLE.matches(p, j)


def all_extra(meaning: Meaning) -> bool:
    """Whether a phrase speaks of distractors alone."""
    if isinstance(meaning, Coord):
        return meaning.op == "and" and all(map(all_extra, meaning.items))
    return isinstance(meaning, Noun) and meaning.traits.extra


def leads(p: Parser, j: int, first: Meaning) -> bool:
    """Whether an adjunct may stand before its clause, which begins at `j`: it says nothing of parts, and takes no noun
    from it ("with three brown | cubes on the table")."""
    if isinstance(first, Using) or p.words[j - 1] in lexicon.COLOR:
        return not p.stands(j, lexicon.BLOCK)
    if isinstance(first, Absolute):
        return all_extra(first.theme) or (_at_an_end(first) and p.stands(p.opt(j, ","), _MAKING))
    told = first.clauses if isinstance(first, That) else None
    if isinstance(told, Chain) and any(isinstance(x, Clause) and x.verb == "exist" for x in told.clauses):
        return False  # "so I have a red cube ..." tells what there is
    if isinstance(first, Coord) and first.op == "absolutes":
        return all(map(_at_an_end, first.items)) and p.stands(p.opt(j, ","), _MAKING)
    return not isinstance(first, Size)


_MAKING = frozenset({"build", "make", "stack", "create", "form", "construct", "assemble", "erect"})


def _at_an_end(part: Meaning) -> bool:
    """ "With red at the bottom, build a tower of ...": where a block is in what is made."""
    return isinstance(part, Absolute) and all(isinstance(x, At) and x.side in ("top", "bottom") for x in part.adjuncts)


@choice
def further_extras(p: Parser, j: int, noun: Noun) -> Results[Marks]:
    """Behind distractors: "in other colours", which are open anyway; ": green and white", which tells them."""
    if not noun.traits.extra or noun.traits.colors or noun.traits.labels:
        return
    if k := p.any_of(j, _OTHERWISE):
        yield Marks(), k
    opened = p.one(j, (":", ",", "(")) or j
    for (listed, either), k in colors(p, p.opt(opened, "namely", "one")) if opened > j else ():
        closed = p.one(k, ")") if p.words[j] == "(" else k
        many = noun.amount.low if noun.amount is not None else len(listed) if noun.plural else 1
        if closed and not either and many == len(listed) and (p.words[j] == "(" or k >= p.end):
            yield Marks({"colors": listed}), closed


_OTHERWISE = tuple(
    f"{of}{other} {color}"
    for of in ("in ", "of ", "with ", "in a ", "of a ", "with a ", "in some ", "of some ")
    for other in ("other", "any other", "another", "different", "some other", "random", "arbitrary")
    for color in ("color", "colors")
)
