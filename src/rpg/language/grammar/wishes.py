"""Wishes, questions and pictures around an instruction, by their parts: who wishes, how, for what.

A pattern is a row of slots; each slot lists what may stand there, with "_" inside a phrase and "?" behind a slot that
may be left out. What a pattern matches carries nothing of the instruction.
"""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.frames import Phrases

_WHO = (
    "i|we|you|the_customer|our_customer|my_customer|the_client|our_client|my_boss|the_boss|the_user|my_teacher|"
    "the_teacher|my_friend|my_daughter|my_son"
)
_WOULD = "would|will|should|'d|do|may|might|can|could|must|am|are|is|was|were"
_ALSO = "have_always|always|just|also|simply|now|like|here|still"
_WANT = (
    "want|wants|wanted|like|likes|love|loves|need|needs|prefer|prefers|wish|wishes|hope|hopes|ask|asks|require|requires|"
    "expect|expects|imagine|imagines|request|requests|have_in_mind|picture|propose|suggest|envision|look|looking|"
    "hoping|asking|wondering|wanting|dreaming|thinking|appreciate_it|be_happy|be_glad|be_pleased|be_grateful|wishing"
)
_SEE = (
    "to_see|to_have|to_get|to_find|to_end_up_with|to_be_shown|seeing|having|for|that|it_if|if|of|there_to_be|it_that|:"
)
_DO = (
    "to|you_to|you_could|you_would|you_can|you_might|the_robot_to|us_to|to_ask_you_to|it_if_you_would|"
    "it_if_you_could|if_you_could|if_you_would|it_if_you|"
    "the_arm_to|that_you"
)
_PICTURE = "picture|image|photo|photograph|drawing|sketch|figure|scene|view|arrangement|result|layout|setup|state"


class Patterns(Phrases):
    """Phrases by their parts."""

    def __init__(self, *patterns: str) -> None:
        super().__init__()
        self.rows: dict[str, list[list[tuple[tuple[tuple[str, ...], ...], bool]]]] = {}
        found: set[str] = set()
        for pattern in patterns:
            row = [_slot(part) for part in pattern.split(" ")]
            found.update(word for phrases, _ in row for phrase in phrases for word in phrase)
            for first in _firsts(row):
                self.rows.setdefault(first, []).append(row)
        self.words = frozenset(found)

    def matches(self, p: Parser, i: int) -> Iterator[int]:
        """Positions after the patterns that stand at i."""
        for row in self.rows.get(p.words[i] if i < p.end else "", ()):
            ends = {i}
            for phrases, optional in row:
                after = {j for at in ends for phrase in phrases if (j := _stands(p, at, phrase))}
                ends = after | ends if optional else after
            for j in sorted(ends - {i}):
                yield p.reach(j)


def _slot(part: str) -> tuple[tuple[tuple[str, ...], ...], bool]:
    phrases = tuple(tuple(phrase.split("_")) for phrase in part.rstrip("?").split("|"))
    return phrases, part.endswith("?")


def _firsts(row: list[tuple[tuple[tuple[str, ...], ...], bool]]) -> set[str]:
    firsts: set[str] = set()
    for phrases, optional in row:
        firsts |= {phrase[0] for phrase in phrases}
        if not optional:
            break
    return firsts


def _stands(p: Parser, at: int, phrase: tuple[str, ...]) -> int:
    """The position after a phrase that stands at `at`, or 0."""
    for word in phrase:
        if at >= p.end or p.words[at] != word:
            return 0
        at += 1
    return at


COMMAND_WISHES = Patterns(
    "solve the|this puzzle|task|problem|exercise|riddle :|,|by?",
    "as a|an|the user|player|customer|tester|developer|operator|product_owner|manager|parent|teacher|child|robot|"
    "engineer ,?",
    "for|in the|this|our|my|today_'s demo|demonstration|test|experiment|game|exercise|show|presentation|puzzle|video|"
    "photo|picture|figure|paper ,?",
    f"{_WHO} {_WOULD}? {_ALSO}? {_WANT} {_ALSO}? {_DO} {_ALSO}?",
    "would|will|could|can you be? so|that|as? kind|nice|good|friendly and|as? to?",
    "be so kind|nice|good and|as to?",
    "is|would|might there be? a|any|some way|chance|possibility to|you_could|you_can|for_you_to|that_you",
    "is|would it be? possible|okay|ok|fine|feasible|alright to|for_you_to|if_you|for_the_robot_to|that_you|that_we",
    "i|we want|need|wish|ask|would_like you",
    "please you",
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
    "team|everyone|everybody|all|folks|guys|robot|friend|friends|children|kids|sir|class|there|again ,|:?",
    "team|everyone|everybody|folks|guys|children|kids|class|boys_and_girls ,|: let_us|please?",
    "to",
    "the|your|our|my next|main|first|whole|only|actual|new? task|job|goal|mission|exercise|challenge|puzzle|"
    "plan|idea|aim|"
    "assignment|request|instruction|wish|setup|objective for_you|today|here|now|this_time? is|:|would_be|"
    "will_be to|:? :?",
)
DENIALS = Patterns(
    f"{_WHO} do|would|should|must|can|may|will not|never ever? want|like|see|wish|expect|have to_see|to_have|"
    f"that|it_that?",
    f"{_WHO} never want|wish|like|expect to_see|to_have?",
    "it should|must|may|can|shall|is not|never be? seen|shown|true|allowed|permitted|the_case|okay|acceptable|"
    "ok that|for?",
    "it is forbidden|prohibited that|for?",
    "there should|must be no way that",
)
"""What is said after these must not be."""
_RESULT = "result|outcome|state|scene|configuration|arrangement|layout|picture|setup|situation"
STATE_WISHES = Patterns(
    "the|my picture|image|scene|arrangement|idea i|we have|imagine in_mind? :|is :?",
    "acceptance|success|completion|goal|pass|test|definition_of? criteria|criterion|condition|conditions|requirement|"
    "requirements|done|user_story|specification|spec|deliverable|deliverables :|is|are that?",
    "as a|an|the user|player|customer|tester|developer|operator|product_owner|manager|parent|teacher|child|robot|"
    "engineer ,?",
    "for|in the|this|our|my|today_'s demo|demonstration|test|experiment|game|exercise|show|presentation|puzzle|video|"
    "photo|picture|figure|paper ,?",
    f"the|our|my final|finished|end|desired|expected|target|goal? deliverable|product|end_product|{_RESULT} "
    "should|must|shall|will|has_to? be|consist_of|consists_of|contain|contains|include|includes|comprise|comprises|is|"
    "feature|features|have|has that|:?",
    f"{_WHO} should|must|shall|will|have_to|need_to show|see|demonstrate|deliver|present|have|get",
    "solve the|this puzzle|task|problem|exercise :|,",
    f"{_WHO} {_WOULD}? {_ALSO}? {_WANT} {_ALSO}? for|forward_to? {_SEE}?",
    f"{_WHO} {_WOULD} {_ALSO}? after",
    f"what|all {_WHO} {_WOULD}? {_ALSO}? {_WANT}|after|asking|going|looking|aiming after|for|of? to_see|to_have|"
    f"to_get? "
    "here|now|today? is that?",
    f"in|on the|this|my|our final|resulting|finished|target|goal|end? {_PICTURE} ,? we|one|you|i? can? see? ,?",
    "the|my|our|this picture|scene|result|layout|arrangement i|we want|need|have_in_mind|imagine|picture|see is|:|: :?",
    "we|you|one|i should|must|can|could|will|would|shall? see|observe|notice that?",
    "it can|should|must|could|shall be seen|shown that?",
    "let me|us see|have|get|admire|find",
    "is it possible|okay|true|allowed|fine that",
    "could|can|would|may|might it be that",
    "is there a way that",
    "how|what about having|that|if?",
    "why not have?",
    "arrange|set_up|set|organize|change|make|build|lay_out|prepare|configure|design|rearrange|modify|adjust|"
    "create|fix "
    "the|a|this|our scene|table|workspace|setup|picture|world|things|desk up? such_that|so|so_that|until|"
    "in_such_a_way_that",
    "it would be nice|great|good|lovely|wonderful|perfect|best|ideal if|that|to_see|to_have",
    "the|our|my end|final|desired|target|goal|finished|expected|wanted "
    "result|picture|image|state|scene|outcome|arrangement|layout|configuration|setup|situation "
    "i_want|we_want|we_need|i_need? is|should_be|must_be|shows|should_show|has|should_have|would_be|: "
    "this|as_follows|like_this|that|when|where|one_where|one_in_which? :?",
    "a|one picture|scene|situation|state|layout|arrangement where|in_which|such_that|that_shows|showing",
    "end|final|desired|target|goal|wanted|finished state|result|picture|layout|scene|arrangement|configuration? :",
    "the|our task|job|goal is done|complete|finished|over|successful|fulfilled|solved|reached|achieved when|if|once",
    "it|this is|will_be|counts_as done|right|correct|finished|solved|complete when|if|once",
)
