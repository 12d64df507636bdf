"""Blocks that are only there: "leave out the S", "two black ones serve as a distraction", "distractor: a green one"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.grammar.things.standby import NO_ROLE
from rpg.language.meaning import Clause, Coord, Manner, Meaning, Noun, Pronoun

_PASS_OVER = (
    "leave out", "leave aside", "ignore", "disregard", "forget about", "forget", "skip", "omit", "do not use",
    "do not need", "do not mind", "never mind", "do not bother with", "pay no heed to",
    "you do not need", "we do not need", "not using", "without using", "without", "and not",
    "ignoring", "disregarding", "leaving out", "leaving aside", "omitting", "skipping", "forgetting about",
    "never use", "not", "pay no attention to", "do not care about", "but not",
)  # fmt: skip
"""What stands before blocks that are not to be used. Behind "without" and "not" alone no place may follow."""
_LEAVE = frozenset({"leave", "leaving", "keep", "put", "set", "lay", "add", "include", "have", "place", "throw",
                    "toss", "drop", "mix"})  # fmt: skip
_ASIDE = Patterns(
    "just|simply? aside|out|lying_around|around|unused|out_of_it|off_to_the_side|to_one_side|to_the_side|on_the_side|"
    "on_one_side|out_of_the_way|out_of_play|over|alone_as_distractors|lying_on_the_side|lying_on_the_table_unused "
    "somewhere|anywhere|on_the_table?",
)
_AS = Patterns(
    "in|on_the_table|to_the_scene|to_the_table|lying_around|somewhere|lying_somewhere? ,? merely|only|just|purely? "
    "as|for a|an|some|pure|mere? distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys",
)
_DOING_NOTHING = Patterns(
    "are|is|be|being|should_be|must_be|will_be? also|too|just|only|merely|simply|all? lying|standing|sitting|there|"
    "around|present|lying_around|on_the_table? ,? merely|just|only|purely? as|for|to a|an|some|pure|mere? "
    "distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys|distract|confuse only?",
    "lie|lies|stand|stands|sit|sits also|too|just|only? around|there|about also|too|somewhere|on_the_table? ,? "
    "as|for a? distractor|distractors|distraction",
    "serve|serves|act|acts|function|functions also|just|only|merely|simply? as|for a|an|mere|pure? "
    "distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys",
    "do|does not belong_to_the_word here|at_all?",
)
_AROUND = Patterns(
    "lie|lies|stand|stands|sit|sits|are|is also|too|just|only? around|about|lying_around|lying_about also|too? "
    "somewhere|on_the_table?",
    "are|is|exist|exists? in_the_scene|available|present|in_play|at_hand|in_stock|to_work_with|to_use|to_choose_from",
    "exist|exists in_the_scene|altogether|in_all|in_total?",
)
"""What is said of where blocks are, which is nowhere in particular: there are such, and they may be used or not."""
_FREE = Patterns(
    "may|can|could|might? lie|be|go|stay|stand|sit|rest|remain|land|end_up? anywhere|wherever|where "
    "you|they|it like|likes|want|wants|please|pleases? on_the_table?",
    "may|can|could|might? lie|be|go|stay|stand|sit|rest|remain|land|end_up? anywhere|wherever on_the_table?",
)
"""What is said of the others: nothing is asked of them."""
_OTHERS = frozenset({"the rest", "the others", "the other ones", "the remaining ones", "everything else", "the rest of "
                     "them", "all others", "all the others", "all the rest", "others", "the other two"})  # fmt: skip
_BELONGING = Patterns("that|which do|does not belong to the_word|it|the_tower|the_row|the_structure|them")
_LABELS = (
    "distractor :", "distractors :", "distractor", "distractors", "as distractors :", "as a distractor :", "decoys :",
    "extra :", "extras :", "as distractors", "as a distractor", "unused :", "not used :", "to be ignored :",
    "for distraction :", "for distraction", "decoration :", "with the distractors", "with the distractor",
    "with distractors :", "distraction :", "distractions :",
)  # fmt: skip
_LED = Patterns(
    "as|for a|an|some|the|mere|pure|only? distractor|distractors|distraction|decoration|decorations|decoy|decoys|"
    "extra|extras|extra_blocks ,|:? there_is|there_are|there_should_be|there_must_be|add|put|place|have|include|use|"
    "lay|throw_in|we_have|you_have|we_add|you_find|you_see|i_want|i_need|i_have|take",
    "distractor|distractors|decoy|decoys present|in_the_scene|on_the_table|lying_around|around :|are|is",
)
"""What distractors are told behind, besides."""
_THERE = ("present", "also present", "in the scene", "around", "lying around", "in view", "as well", "too")


_TURNED = frozenset({"turn", "turned", "rotate", "rotated", "flip", "flipped", "spin", "spun", "facing", "faces"})
_PLACED = frozenset({"on", "onto", "in", "into", "to", "behind", "under", "beside", "near", "next", "of", "above",
                     "touch", "touches", "touching", "together", "adjacent", "against", "between", "leave",
                     "leaves", "off", "from", "out", "remove", "removed"})  # fmt: skip


@rule
def spare(p: Parser, i: int) -> Results[Clause]:
    """What there is and is not to be used."""
    over = p.any_of(i, _PASS_OVER)
    for theme, j in noun_phrase(p, over) if over else ():
        bare = p.words[over - 1] in ("not", "without")
        j = (p.any_of(j, _IN_IT) or j) if p.words[over - 1] == "without" else j
        elliptic = isinstance(theme, Noun) and theme.head == "any" and theme.det == "the"
        elliptic = elliptic or (isinstance(theme, Pronoun) and theme.word in _OTHERS)
        if p.words[over - 1] == "not" and elliptic and (i == 0 or not _PLACED.isdisjoint(p.words[:i])):
            continue  # "on the red mat, not the blue one": perhaps the blue mat; "(put red there.) Not the others"
        if isinstance(theme, Pronoun) and theme.word in ("each other", "one another", "all", "all of them"):
            continue  # "red and blue touch green, but not each other", "at least two of them, but not all"
        if p.words[over - 1] == "not" and not _TURNED.isdisjoint(p.words[:i]):
            continue  # "turn A, but not B, upside down": B is there, and must not be so
        if p.words[over - 1] == "not" and not _ELSEWHERE.isdisjoint(p.words[:i]) and _definite(theme):
            stay = Manner(kind="stay", span=p.span(i, j))  # "move A somewhere else, but not B": B stays
            yield Clause(verb="keep", lemma="keep", theme=theme, adjuncts=(stay,), span=p.span(i, j)), j
            continue
        if not bare or (_definite(theme) and (j >= p.end or p.words[j] in _STOPS)):
            yield _said(p, i, p.opt(j, "at", "out", "aside"), theme), p.any_of(j, ("out", "aside")) or j
            lying = p.any_of(j, _ON_TABLE) if isinstance(theme, Noun) and theme.det == "other" and theme.amount else 0
            if lying:  # "ignore the three other blocks on the table": they lie where all blocks do
                yield _said(p, i, lying, theme), lying
    left = p.one(p.opt(i, "also"), _LEAVE)
    for theme, j in noun_phrase(p, p.opt(left, "in")) if left else ():
        aside = {*_ASIDE.matches(p, j)} if p.words[i].startswith("leav") or _told(theme) else set()
        if _told(theme) and not p.words[i].startswith("leav"):  # "throw in two distractors (on the table)"
            aside |= {j, p.any_of(j, _ON_TABLE) or j}
        for k in {*aside, *_AS.matches(p, j)}:
            yield _said(p, i, k, theme), k
    label = p.any_of(i, _LABELS)
    named = max(_LED.matches(p, i), default=0) or (p.opt(label, "are", "is") if label else 0)
    for theme, j in noun_phrase(p, named) if named else ():
        if not _told(theme):
            yield from ((_said(p, i, end, theme), end) for end in {j, p.any_of(j, _THERE) or j})
    for theme, j in noun_phrase(p, i):
        further = isinstance(theme, Noun) and theme.det == "another" and theme.amount is not None
        for k in _AROUND.matches(p, j) if further or _counted(theme) else ():
            there = Clause(verb="exist", lemma="stock", theme=theme, mode="given", span=p.span(i, k))
            yield (_said(p, i, k, theme) if further else there), k
        it = isinstance(theme, Pronoun) and theme.word == "it"
        if isinstance(theme, Pronoun) and theme.word in _OTHERS:
            yield from ((_said(p, i, k, theme), k) for k in _FREE.matches(p, j))
        j = p.any_of(j, _ON_TABLE) or j
        for k in {*_doing_nothing(p, j), *_AS.matches(p, p.opt(j, ","))} if it or _blocks(theme) else ():
            if it and _NAMING.isdisjoint(p.words[j:k]):
                continue
            for end in {k, max(_BELONGING.matches(p, k), default=k)}:
                yield _said(p, i, end, theme), end


def _doing_nothing(p: Parser, j: int) -> Iterator[int]:
    for told in (_DOING_NOTHING, NO_ROLE):
        yield from told.matches(p, j)


_IN_IT = ("in it", "inside it", "among them", "in there", "in the tower", "in the row", "in the word")
_ON_TABLE = ("on the table", "on the desk", "lying on the table", "over there", "there")
_ELSEWHERE = frozenset({"else", "elsewhere", "away"})
_NAMING = frozenset({"distractor", "decoy", "decoration", "distraction", "ignored", "disregarded", "used", "needed",
                     "required", "nothing", "need", "use", "role", "part"})  # fmt: skip
"""What says of a single block spoken of before that it is only there."""
_STOPS = frozenset({",", ":", "and", ";"})


def _said(p: Parser, i: int, j: int, theme: Meaning) -> Clause:
    lemma = "without" if p.words[i] == "without" else "spare"
    return Clause(verb="ignore", lemma=lemma, theme=theme, mode="goal", span=p.span(i, j), cost=1)


def _blocks(theme: Meaning) -> bool:
    if isinstance(theme, Coord):
        return theme.op == "and" and not theme.cost and all(map(_blocks, theme.items))
    return isinstance(theme, Noun) or (isinstance(theme, Pronoun) and theme.word not in ("it", "nothing"))


def _counted(theme: Meaning) -> bool:
    """ "three white and two black blocks": blocks that come up by this, and how many they are."""
    if isinstance(theme, Coord):
        return theme.op == "and" and not theme.cost and all(map(_counted, theme.items))
    if isinstance(theme, Noun) and theme.traits.labels and theme.det in ("bare", "the") and theme.amount is None:
        return not theme.conditions
    single = isinstance(theme, Noun) and theme.amount is not None and not theme.amount.strict
    return single and isinstance(theme, Noun) and theme.det in ("bare", "a") and theme.part_of is None


def _told(theme: Meaning) -> bool:
    """Whether a phrase speaks of distractors."""
    if isinstance(theme, Coord):
        return all(map(_told, theme.items))
    return isinstance(theme, Noun) and theme.traits.extra


def _definite(theme: Meaning) -> bool:
    """ "without the S": of blocks that are there."""
    if isinstance(theme, Coord):
        return all(map(_definite, theme.items))
    return isinstance(theme, Pronoun) or (isinstance(theme, Noun) and theme.det in ("the", "other"))
