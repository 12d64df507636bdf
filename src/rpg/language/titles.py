"""Titles: "Level 5:", "Warehouse note:", "Pick-and-place task.", "URGENT:". They name a text and tell nothing of it.

A title ends with a word for a text or an errand; what stands before that tells what sort of text it is. It may be a
word that means nothing here, for nothing of the task can hang on it; no word that could tell of blocks or places is
passed over.
"""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.fields import field
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.headings import ENDS, headed
from rpg.language.slips import slips_of
from rpg.language.spelling import vocabulary
from rpg.language.spoken_leads import bends
from rpg.language.telling import may_tell
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_NUMBERED = listed(
    "level task exercise problem example question puzzle challenge scene scenario instruction job mission number round "
    "riddle benchmark item test case sample episode trial prompt entry experiment demo eval evaluation id no request "
    "assignment quiz ticket query run warmup subtask testcase drill check station workstation"
)
"""Words of a title with a number behind, or alone."""
_TEXTS = listed(
    "task job note notes memo benchmark exercise lesson game puzzle test drill challenge mission demo experiment "
    "assignment homework quiz reminder request ticket prompt problem question activity scenario episode round level "
    "log message brief riddle story report worksheet project trial announcement command skill errand description "
    "caption summary check checks exam statement station workstation baseline ablation"
) | (_NUMBERED - {"scene", "number", "instruction", "no", "id", "run"})
"""What a title calls its text."""
_NOTES = listed("note notes memo message caption description summary story")
_ORDERS = frozenset({"order", "instruction", "instructions"})
"""These are titles behind a word that means nothing here, or tells whose they are."""
_SORTS = listed(
    "a an the my our your this today tonight of for and in on 's to next first second third last new quick short easy "
    "simple hard tricky little small daily morning evening two three step steps multi stacking building construction "
    "rearrangement rearranging pick place picking placing tidying cleaning clean up tidy robot robotics arm lab desk "
    "tabletop manipulation spelling math maths reading logic memory school kids block blocks cube cubes customer work "
    "sequence sequential toy sorting arrangement unit regression baseline held out training validation sanity check "
    "warm scene goal reject rejects packing packaging assembly inspection quality "
    "incoming outgoing loading proposed contributed suggested another final last color colour"
)
"""What may tell what sort of text it is."""
_ACTIVITIES = listed(
    "stacking building construction rearrangement rearranging pick place and picking placing tidying cleaning up "
    "manipulation spelling tabletop blocks the a"
)
"""What a text may be about, where it says more behind that."""
_ERRANDS = (["pick", "and", "place"], ["pick", "place"], ["pick", "and", "stack"])
"""Such a title alone."""
_ASPECTS = listed(
    "constraint constraints completion relation relations relationship condition conditions requirement requirements "
    "placement alignment rule rules specification spec evaluation reasoning understanding"
)
"""What a title ends with that tells what is tried in a text."""
_TOPICS = listed(
    "sequence distance equation spatial relative support stack stacking tower row grid pattern color colour count "
    "counting quantifier negation grouping sorting spelling ordering rotation orientation symmetry swap region patch "
    "placement tolerance structure size number logic disjunction conjunction temporal multi step goal object"
)
"""What such a title speaks of. Alone it is one only in front of a command, for a list may stand behind it as well."""
_CALLS = listed("urgent important attention fyi hint tip ps nb todo update reminder warning announcement")
_SPEAKERS = frozenset(PEOPLE.split("|")) | listed("me operator human speaker commander instructor")
_MARKS = frozenset({":", "-", "–", "—"})
_LONGEST = 5
"""No title has more words."""


def untitled(tokens: list[Token]) -> list[Token]:
    """The words of a text without the titles in front of its sentences."""
    tokens = headed(tokens)
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        if not out or out[-1].word in ENDS:
            end = max(field(tokens, at), _title(tokens, at))
            if end > at:
                at = end
                continue
        out.append(tokens[at])
        at += 1
    return out


def title(tokens: list[Token]) -> int:
    """How many of the first tokens are a title with a number: "Benchmark item 12b:", "Stacking task #3 -", "T12:".

    "Task 1: ... Task 2: ..." has two of them, and is none.
    """
    if not tokens or not (tokens[0].word in _NUMBERED or tokens[0].word in _SORTS or _single(tokens[0])):
        return 0
    words = [token.word if token.kind == "word" else "" for token in tokens]
    at = 0
    while at < min(_LONGEST, len(tokens)) and words[at] in _NUMBERED | _SORTS:
        at += 1
    code = len(tokens) > 1 and _single(tokens[0]) and tokens[1].kind == "number" and _bound(tokens, 1)
    at = 1 if code else at
    called = words[at - 1] if at else ""
    if not code and called not in _NUMBERED:
        return 0
    if called == "no" and _stands(tokens, at, "."):
        at += 1
    numbered = at < len(tokens) and tokens[at].kind == "number"
    if numbered:
        at += 1
        if at < len(tokens) and _single(tokens[at]) and _bound(tokens, at):
            at += 1
    again = any(words[n] == called and tokens[n + 1].kind == "number" for n in range(at, len(tokens) - 1))
    if at + 1 >= len(tokens) or again or not any(_stands(tokens, at, sign) for sign in (":", ".", ",")):
        return 0
    return at + 1 if numbered and (tokens[at].word == ":" or not code) else 0


def _stands(tokens: list[Token], at: int, sign: str) -> bool:
    return at < len(tokens) and tokens[at].kind == "punct" and tokens[at].word == sign


def _single(token: Token) -> bool:
    return token.kind == "word" and len(token.word) == 1


def _bound(tokens: list[Token], at: int) -> bool:
    """Whether nothing stands between a token and the one before it: "T12", "4b"."""
    return tokens[at - 1].span[1] == tokens[at].span[0]


def _title(tokens: list[Token], at: int) -> int:
    """Where to go on behind a title that stands here, or `at`."""
    end = next((n for n in range(at, min(at + _LONGEST + 1, len(tokens))) if _closes(tokens[n])), at)
    if end == at or end + 1 >= len(tokens):
        return at
    words, mark = tokens[at:end], tokens[end]
    head = words[-1]
    if len(words) == 1 and head.word in _TEXTS and mark.word == ":" and (behind := _about(tokens, end)):
        return behind
    if at == 0 and len(words) == 1 and head.word in _NUMBERED | _NOTES and mark.word == ":":
        return end + 1
    if mark.raw == ",":
        return at
    if (
        mark.raw in _MARKS
        and len(words) == 1
        and (head.word in _CALLS or (mark.word == ":" and _speaks(head) and not _spoken_of(tokens, head)))
    ):
        return end + 1
    if [word.word for word in words] in _ERRANDS and mark.word == ":":
        return end + 1
    if mark.raw in _MARKS and len(words) == 1 and _one_name(head):
        return end + 1
    if mark.word == "!" and len(words) == 1 and head.word in _CALLS:
        return end + 1
    sorts = words[:-1]
    if mark.word == ":" and all(word.word in _TOPICS | _SORTS for word in sorts):
        commanded = not sorts and head.word in _TOPICS and _commands(tokens[end + 1 :])
        if commanded or (sorts and head.word in _ASPECTS):
            return end + 1
    if head.word in _TEXTS or (mark.word != ":" and head.word == "time"):
        if not sorts:
            return at
        if all(map(_tells_the_sort, sorts)):
            return end + 1
    whose = any(_strange(w) or w.word in ("customer", "work") for w in sorts)
    named = head.word in _ORDERS and whose and all(map(_tells_the_sort, sorts))
    return end + 1 if named and mark.raw in _MARKS else at


def _closes(token: Token) -> bool:
    return token.raw in _MARKS or (token.kind == "punct" and token.word in (":", ".", "!", ","))


def _about(tokens: list[Token], colon: int) -> int:
    """ "Task: pick-and-place. Goal: ...": behind the title a word for what it is about; nothing else is passed over."""
    end = next((n for n in range(colon + 1, len(tokens)) if tokens[n].kind == "punct"), len(tokens))
    told = tokens[colon + 1 : end]
    whole = end + 1 < len(tokens) and tokens[end].word in ENDS
    return end + 1 if told and whole and all(t.word in _ACTIVITIES for t in told) else 0


def _commands(tokens: list[Token]) -> bool:
    """Whether a command begins here, and no list."""
    begin = 1 if tokens[0].word in ("first", "please") else 0
    commands = len(tokens) > begin + 2 and tokens[begin].word in lexicon.COMMANDS
    placed = (
        commands and tokens[begin].word == "position" and tokens[begin + 1].kind == "number"
    )  # "row: position 1 red"
    return commands and not placed and tokens[begin + 1].word not in (",", "and")


def _tells_the_sort(token: Token) -> bool:
    return token.word in _SORTS | _TEXTS or token.word in _SPEAKERS or _strange(token)


def _strange(token: Token) -> bool:
    """A word that means nothing here, and is no slip for one that does."""
    if (
        token.kind != "word"
        or token.word in vocabulary()
        or len(token.word) < 3
        or bends(token.word)
        or may_tell(token.word)
    ):
        return False
    return not slips_of(token.word)


def _one_name(token: Token) -> bool:
    """ "PushCube - ...": several words written as one."""
    inside = token.raw[1:]
    return token.raw[:1].isupper() and inside != inside.lower() and not token.raw.isupper() and _strange(token)


def _spoken_of(tokens: list[Token], name: Token) -> bool:
    """Whether a name stands where it is no title: what it is may be told behind it, "Alpha: red cube"."""
    return any(t.word == name.word and tokens[n + 1 : n + 2] != [] and tokens[n + 1].word != ":"
               for n, t in enumerate(tokens)) or tokens[-1].word == name.word  # fmt: skip


def _speaks(token: Token) -> bool:
    """ "Teacher: ...", "Bob: ..."."""
    return token.word in _SPEAKERS or (token.raw[:1].isupper() and not token.raw.isupper() and _strange(token))
