"""Leads of any words: "Parity benchmark: (...)", "my idea is (a plus ...)", "reward 1 if (...), else 0".

The form says that what stands behind is all that is asked for. So the words of a lead may be any that cannot tell of
blocks; but none that denies, that is of the start or of another time, that compares or leaves something open, and none
by which what stands behind is something else than a goal, as a distractor.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.harmless import DOINGS, OCCASIONS, PEOPLE
from rpg.language.slips import slips_of
from rpg.language.smalltalk import is_strange, takes_back
from rpg.language.spelling import vocabulary
from rpg.language.telling import may_tell, may_tell_how, tells
from rpg.language.tokens import Token
from rpg.language.told_again import CHANGES, ordered_again, told_again
from rpg.language.word_lists import listed

_BINDING = listed(
    "rest remainder if unless until till before after while when whenever once or either whether except but than "
    "then again same only always never ever constantly permanently throughout meanwhile during least most worst "
    "worse too start starts started starting begin begins beginning initial initially current currently now "
    "present existing old previous previously former formerly earlier yesterday already given givens original "
    "originally later afterwards eventually optional optionally bonus alternative alternatively alternatives "
    "option options choice maybe perhaps possibly them they these those it he she so much opposite contrary reset "
    "world background setup safety invariant available inventory material materials ingredients stock parts "
    "objects props fixed frozen immobile immovable static stationary movable question questions why who which "
    "what how hint false true version versions undo add remove delete change replace swap also"
)
"""Words of a lead with which more hangs on what stands behind, or something else, than that it is asked for."""
_AGAINST = (
    "forbid", "forbad", "prohibit", "avoid", "fail", "penal", "punish", "illegal", "invalid", "wrong", "bad", "negativ",
    "incorrect", "error", "mistak", "violat", "counter", "anti", "distract", "decoy", "obstacle", "ignor", "exclu",
    "hate", "hating", "dislik", "fear", "worr", "problem", "trouble", "danger", "taboo", "mess", "chaos", "nightmare",
    "warn", "caution", "never", "non", "unwanted", "undesir", "unaccept", "unallow", "disallow", "ban", "stop",
    "refus", "reject", "rumo", "joke", "lie", "imposs", "hardly", "barely", "rare", "seldom", "revers", "mirror",
    "rotat", "flip", "prevent", "lose", "loose", "losing", "lost", "unlik", "deduct", "minus", "cost", "decreas",
    "bewar", "inhibit", "hinder", "cancel", "abort", "resist", "oppos", "deny", "deni",
    "exempt", "skip",
    "omit", "lack", "missing", "destroy", "ruin", "dismantl", "disassembl", "wreck", "demolish", "unstack", "unbuild",
    "protect", "nope", "nogo", "unsaf", "hazard", "pitfall", "verbot",
    "sabotag", "trap", "doubt", "instead", "rather", "suppos", "assum", "hypothe", "imagin", "pretend",
)  # fmt: skip
"""How words of a lead begin that turn against what stands behind, or make no goal of it."""
_HARMLESS_HERE = listed(
    "mini big small little huge tiny short great up complete completed finished display sign setting returns "
    "final clean"
)
"""Of an occasion, and of no block, where no block is spoken of."""
DET = listed("the my our his her their your this a an today tonight tomorrow")
_MADE = listed(
    "state configuration solution answer outcome result picture scene image arrangement structure figure "
    "formation composition layout construction design pattern display sign"
)
"""What is built may be spoken of, where a figure is told behind."""
_IS = tuple(
    tuple(said.split())
    for said in (
        "is", "'s", "should be", "must be", "will be", "shall be", "would be", "has to be", "needs to be", "is to be",
        "should look like", "must look like", "looks like", "will look like", "shows", "should show", "must show",
        "depicts", "consists of", "features", "contains", "calls for", "asks for", "requires", "is called", "says",
        "specifies", "demands", "prescribes", "describes", "wants", "is that", "accepts", "will look for", "looks for",
    )
)  # fmt: skip
_POINTING = listed(
    "there here i we you somebody someone everybody everyone nobody nothing something anything everything and but "
    "so please in on at to of with by from"
)
_HAS = (("has",), ("must", "have"), ("should", "have"), ("has", "to", "have"), ("needs",), ("needs", "to", "have"))
_PLACES = listed("scene setup world table workspace inventory stock box set kit")
_MERELY = listed("simply just basically actually simple really : following")
BEGINS = listed("a an the any") | frozenset(lexicon.NUMBER)
TESTS = listed(
    "benchmark test challenge task exercise puzzle quiz classification problem drill lesson game demo experiment "
    "evaluation check skill scenario episode mission assignment activity training practice trial stacking "
    "building sorting spelling instructions instruction guide recipe counting arranging ordering grouping placing "
    "placement manipulation variant"
)
"""Heads of titles that may have in front of them what is tried, in words that tell of blocks elsewhere."""
_SHAPES = (lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.PATCH, lexicon.STRUCTURE, lexicon.NUMBER, lexicon.ORDINAL,
           lexicon.SIZE)  # fmt: skip
_NOT = listed("not no never without none non un upside left right front back top bottom all each every any both")
LONGEST = 8


def heading(tokens: Sequence[Token]) -> int:
    """How many of the first words are a heading: "Colour logic drill:", "Grandma's birthday surprise:", "variant with
    distractors (from the pilot study):"."""
    end = next((n for n in range(min(2 * LONGEST, len(tokens) - 1)) if sets_off(tokens, n)), 0)
    mark = end
    if end > 1 and tokens[end - 1].kind == "number" and _numbered([token.word for token in tokens[: end - 1]]):
        end -= 1
    told = _without_aside(tokens[:end])
    words = [token.word for token in told]
    short = mark and mark + 3 > len(tokens) and tokens[mark + 1].kind != "equation"
    if not 0 < len(told) <= LONGEST or short or not of_words(told) or "'re" in words:
        return 0
    shaped = any(w in table for w in words for table in _SHAPES)
    plainly = _NOT.isdisjoint(words) and not shaped
    tried = words[-1] in TESTS and plainly
    kinds = {word for word in words[:-1] if word.startswith(CHANGES)} if tried else set()
    plain = all(_names_nothing(told, n) for n in range(len(told))) or (
        tried and not any(bends(word) for word in words[:-1] if word not in kinds)
    )
    seen = tuple(words[:3]) in _TRYING and plainly
    behind = tokens[mark + 1 :]
    named = plain or seen or _named_again(told, behind)
    return mark + 1 if named and ordered_again(words, behind) else 0


def _numbered(words: Sequence[str]) -> bool:
    """Whether a number behind these tells which one it is: "reviewer (2)", "regression test for issue (12)"."""
    return words[-1] in TESTS | PEOPLE | OCCASIONS or (is_strange(words[-1]) and not TESTS.isdisjoint(words))


def name_alone(tokens: Sequence[Token], behind: Sequence[Token]) -> bool:
    """Whether the first sentence of a text is but a name of what the others tell: "Traffic light."; with a verb that
    is not known it would be something to do."""
    if [token.word for token in tokens[:2]] in (["what", "a"], ["what", "an"]):
        tokens = tokens[2:]  # "what a lousy day"
    words = [token.word for token in tokens]
    if not 0 < len(words) <= LONGEST or not behind or behind[0].word in _THEN or not _OBJECTS.isdisjoint(words):
        return False
    head = words[: next((n for n, word in enumerate(words) if word in ("of", "with")), len(words))]
    if words[0] in ("a", "an", "one", "some") or any(word in lexicon.VERB or word in DOINGS for word in head):
        return False  # "a lighthouse, please", "we need a lighthouse"
    strange = any(word not in vocabulary() for word in words)
    plain = all(_names_nothing(tokens, n) for n in range(len(words)))
    again = any(word in ("of", "with") for word in words[1:]) and _named_again(tokens, behind)
    return strange and of_words(tokens) and (plain or again) and ordered_again(words, behind)


_THEN = listed("then next afterwards now and")
_OBJECTS = listed("everything all anything something it this that these those them")


def _without_aside(tokens: Sequence[Token]) -> Sequence[Token]:
    """A heading without what it says in brackets, "size ordering (from the infant paper)", if that tells nothing."""
    begin = next((n for n, token in enumerate(tokens) if token.word == "("), len(tokens))
    aside = tokens[begin + 1 : -1]
    closed = len(aside) > 1 and tokens[-1].word == ")" and aside[0].word in _FROM and of_words(aside)
    return tokens[:begin] if closed and all(t.word in OCCASIONS or tells_nothing(t.word) for t in aside) else tokens


_FROM = listed("from as in by after per see like for")


def _names_nothing(tokens: Sequence[Token], n: int) -> bool:
    """Whether a word of a heading carries nothing: "(treasure) room" is a name, and so is "long-(horizon)"."""
    word, after = tokens[n].word, [token for token in tokens[n + 1 : n + 3] if token.word != "-"]
    named = word == "room" and not after and n > 0 and tells_nothing(tokens[n - 1].word)
    joined = after[0].word if after and after[0].joined else ""
    bound = joined in _AT_A_TIME or (is_strange(joined) and not tells(tokens[n]))
    how = is_strange(word) and may_tell_how(word)
    return named or (tells_nothing(word) and not how) or (bound and not bends(word))


_AT_A_TIME = listed("shot step stage hop")
"""So many of these a task has: "zero-shot", "two-step"."""


def _named_again(told: Sequence[Token], behind: Sequence[Token]) -> bool:
    """Whether a heading names what is told behind it as well: "long-horizon variant with letter cubes: (stack A ...)",
    "two teams of three: (three white blocks ...)"."""
    words = [token.word for token in told]
    named = any(word in TESTS or word not in vocabulary() for word in words)
    return (
        named
        and (_NOT | PLACING).isdisjoint(words)
        and all(_names_nothing(told, n) or told_again(words, n, behind) for n in range(len(words)))
    )


PLACING = listed("on in onto into at to inside next against off")


_TRYING = {("let", who, done) for who in ("us", "me") for done in ("see", "try", "test", "check", "find", "practise")}


def subject(tokens: Sequence[Token]) -> int:
    """How many of the first words say what a figure is, "the finished mosaic should be (a 3x3 grid ...)"."""
    words = [token.word for token in tokens]
    if words[1:3] in (["'s", "either"], ["is", "either"]) and words[0] == "it":
        return 2
    if not words or not (
        words[0] in DET or words[0] == "what" or (tells_nothing(words[0]) and words[0] not in _POINTING)
    ):
        return 0
    for at in range(3 if words[0] == "what" else 1 + (words[0] in DET), min(LONGEST + 1, len(words) - 3)):
        said = max((len(x) for x in _IS if tuple(words[at : at + len(x)]) == x), default=0)
        if not said and words[at - 1] in _MADE:
            said = next((len(x) for x in _HAS if tuple(words[at : at + len(x)]) == x), 0)
        if said:
            plain = of_words(tokens[:at]) and all(
                word in _MADE or tells_nothing(word) or (word == "target" and words[n + 2] in _MADE)
                for n, word in enumerate(words[1:at])
            )
            if words[at - 1] in _PLACES and words[at] in ("contains", "features", "has", "shows"):
                return 0  # that is what there is
            end = at + said
            while end < len(words) and words[end] in _MERELY:
                end += 1
            begun = end < len(words) - 2 and (words[end] in BEGINS or words[end - 1] == ":")
            return end if plain and begun else 0
    return 0


def sets_off(tokens: Sequence[Token], n: int) -> bool:
    """A colon, or a dash with room around it; "-1" is a number."""
    apart = n > 0 and tokens[n - 1].span[1] < tokens[n].span[0] and tokens[n].span[1] < tokens[n + 1].span[0]
    return tokens[n].word == ":" or (apart and tokens[n].raw in ("-", "—", "–"))


def of_words(tokens: Sequence[Token]) -> bool:
    """Whether these are words, and no symbols are named."""
    return all(
        (t.kind == "word" and not (len(t.raw) == 1 and t.raw.isupper() and n and t.raw != "I")) or t.word in _CLIPPED
        for n, t in enumerate(tokens)
    )


_CLIPPED = listed("'s 'd 'm 're 've 'll -")


def tells_nothing(word: str) -> bool:
    """Whether a word of a lead carries nothing, and is no slip for one that does."""
    if (may_tell(word) and word not in _HARMLESS_HERE) or bends(word) or takes_back([word]):
        return False
    return word in vocabulary() or not any(map(may_tell, slips_of(word)))


def bends(word: str) -> bool:
    """Whether what stands behind a word may be no goal, or not at the end: "Invariant: (red on blue)"."""
    return word in _BINDING or word.startswith(_AGAINST)


_GIVEN = listed(
    "reward score return give award get grant assign output pay earn receive pass accept success succeed succeeds "
    "win done solved point points the a an one 1 1.0 + full marks true yes agent robot policy you "
    "episode of is are will be it this task only as with and ends end ended finish finishes finished complete "
    "completed considered successful counted counts count positive credit mark judge grade evaluate to trial run we "
    "attempt i ok okay valid receives gets earns gains obtains scores rewarded +1 correct yield yields ticked tick "
    "green light candidate solution sparse binary stop stops : ="
)
"""What is said in front of the condition under which it is well done."""
_VERDICTS = listed(
    "reward score return award grant pass accept success succeed succeeds win end ends ended "
    "stop stops finish finishes done solved credit yield yields successful correct valid point points marks true "
    "accepted complete completed finished passes passed succeeded rewarded wins won receives earns gains "
    "scores +1"
)
_WHEN = (("is", "defined", "as"), ("is", "defined", "by"), ("means", "that"), ("means",), ("requires", "that"),
         ("requires",), ("if", "and", "only", "if"), ("only", "if"), ("only", "when"), ("exactly", "when"),
         ("exactly", "if"),
         ("as", "soon", "as"), ("if",), ("when",), ("iff",), ("once",), ("whenever",), ("as", "long", "as"),
         ("provided", "that"), ("provided",))  # fmt: skip
_ELSE = listed(
    "otherwise else or and 0 0.0 zero false failure fail nothing no not none reward it is return , give get you "
    "the agent gets point points mark marks score credit"
)
_ZERO = listed("0 0.0 zero false failure fail nothing no not none")


def judged(tokens: Sequence[Token]) -> tuple[int, int]:
    """How many of the first words say that it is judged by what comes behind them, "reward 1 if (...)"; and how many
    of the last say what there is else, "(...), otherwise 0"."""
    words = [token.word for token in tokens]
    lead = 0
    for at in range(1, min(LONGEST + 4, len(words) - 3)):
        said = max((len(x) for x in _WHEN if tuple(words[at : at + len(x)]) == x), default=0)
        if said:
            ahead = words[:at]
            known = all(word in _GIVEN or tells_nothing(word) for word in ahead[words[0] == "under" :])
            known = known and not any(token.raw in ("-", "−", "–") for token in tokens[:at])  # "reward -1 if"
            lead = at + said if known and not _VERDICTS.isdisjoint(ahead) else 0
            break
    if not lead:
        return 0, 0
    other = next((n for n in range(lead + 3, len(words)) if words[n] in ("otherwise", "else")), len(words))
    while lead + 3 < other < len(words) and words[other - 1] in _ELSE:
        other -= 1
    behind = words[other:]
    told = bool(behind) and _ELSE.issuperset(behind) and not _ZERO.isdisjoint(behind)
    return lead, len(behind) if told else 0
