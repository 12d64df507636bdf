"""Remarks with words that mean nothing here: "in a row on the red mat, like taxis", "(which always gets lost)".

A comparison says once more what is told in plain words; a sentence with nothing of blocks, patches and places asks for
nothing. Both are left out, with a note; where a comparison may be all that tells of a shape, it stays to be asked for.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, takewhile

from rpg.language import lexicon
from rpg.language.harmless import ANIMALS, INTERJECTIONS, OCCASIONS, PEOPLE, THINGS, exclaimed
from rpg.language.headlines import named_errand
from rpg.language.idle_talk import idle, idle_at_an_end, of_their_doings, reason_at
from rpg.language.lead_ins import command_behind, state_behind, thing_behind
from rpg.language.phrases import length_at
from rpg.language.signatures import signature
from rpg.language.spelling import vocabulary
from rpg.language.spoken_leads import judged, name_alone
from rpg.language.spoken_wishes import led_by_form
from rpg.language.talk_forms import addressed_at
from rpg.language.telling import LAID_OUT, in_its_order, tells
from rpg.language.tokens import Token
from rpg.language.ways_of_working import way_of_working

_ENDS = frozenset({".", "!", "?", ";", "…"})
_MARKS = frozenset({",", ":", "-"})
_BREAKS = _ENDS | _MARKS | {"(", ")"}
_LIKE = (("like",), ("just", "like"), ("a", "bit", "like"), ("sort", "of", "like"), ("kind", "of", "like"),
         ("as", "in"), ("as", "on"), ("as", "if"), ("as", "though"), ("looking", "like"),
         ("similar", "to"), ("resembling",),
         *((*who, "looks", *bit, "like") for who in ((), ("it",), ("that",), ("then", "it"))
           for bit in ((), ("a", "bit"))),
         *((*just, "as", who, *would) for just in ((), ("just",), ("exactly",))
           for who in ("one", "you", "we", "people", "they", "i") for would in (("would",), ("do",), ("might",), ())
           if would or who != "one"),
         *(("so", *that, who, *look, "like") for that in (("that",), ()) for who in ("it", "they", "this")
           for look in (("looks",), ("look",), ("looks", "a", "bit"), ("will", "look"))))  # fmt: skip
"""What leads to something that it is compared with."""
_CONNECTING = frozenset({"because", "since", "as", "so", "cause", "cos", "coz", "for", "before", "after", "when",
                         "whenever", "if", "by", "today", "tonight", "now", "right", "immediately", "at", "this",
                         "soon", "asap", "real", "quickly", "in", "just", "straight", "pretty", "please",
                         "once", "to", "with", "provided", "such", "while", "whilst", "until", "till", "during",
                         "without", "within", "unless", "using", "according", "per", "on", "or"})  # fmt: skip
"""What a reason or a time of the day begins with that nothing parts from the task in front of it."""
_PLEASE = frozenset({"please", "just", "now", "then", "could", "can", "kindly"})
_TURNED = frozenset({"would", "will", "i", "we", "let", "do", "you", "make"})
"""What a task begins with behind whom it is said to."""
_LEADING = _PLEASE | {",", "you", "and", "to", "first"}
"""Behind these a command may begin in another sentence."""
_WISHED = frozenset({"need", "want", "would", "wish"})
"""Who wishes it is told in front of an "and": "we are making a video and need a row"."""
_BINDING = frozenset({"not", "no", "never", "only", "except", "nor", "or", "and", "but", "just", "even", "than", "as",
                      "is", "are", "be", "to", "if", "unless", "until", "without", "instead"})  # fmt: skip
"""Behind these no reason is told, but which one it is, or is not."""
_KIND = frozenset({"thank", "thanks", "many", "have", "take", "good", "enjoy"})
"""What is said behind an "and" at the end: "and thank you for that"."""
_TAKES_BACK = frozenset({"sorry", "oops", "pardon", "well", "oh", "actually", "hm", "hmm", "um", "uh", "er", "erm",
                         "ah", "okay", "ok", "indeed", "really", "surely"})  # fmt: skip
"""What is said behind these may be put in the place of what was said before."""
_MOST = 400
"""In longer texts nothing is looked for."""


def without_remarks(tokens: list[Token]) -> tuple[list[Token], list[str]] | None:
    """The tokens without what asks for nothing, and notes of it; None where there is no such thing, or nothing else."""
    gone: set[int] = set()
    notes: list[str] = []
    found = (*_said_around(tokens), *_comparisons(tokens), *_in_brackets(tokens)) if len(tokens) <= _MOST else ()
    for begin, end in found:
        if gone.isdisjoint(range(begin, end)):
            told = [t for t in tokens[begin:end] if t.word not in _BREAKS]
            raws = " ".join({t.span: t.raw for t in told}.values())
            why = "it is how the work is done" if way_of_working(told) else "it asks for nothing"
            notes.append(f"left out, for {why}: '{raws}'")
            gone.update(range(begin, end))
    rest = _closed([token for n, token in enumerate(tokens) if n not in gone])
    while rest and rest[-1].word == "…":
        rest.pop()
    return (rest, notes) if gone and any(tells(t) or t.word in lexicon.COMMANDS for t in rest) else None


def _said_around(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where idle talk stands: in sentences of its own, set off in front of a task, behind it or within it, and
    behind it where nothing sets it off."""
    begin = 0
    if signed := signature(tokens):
        yield signed, len(tokens)
        tokens = tokens[:signed]
    for end in [*(n for n, token in enumerate(tokens) if token.word in _ENDS), len(tokens)]:
        if end > begin:
            yield from _in_sentence(tokens, begin, end, min(end + 1, len(tokens)))
        begin = end + 1


def _in_sentence(tokens: list[Token], begin: int, end: int, stop: int) -> Iterator[tuple[int, int]]:
    said = list(takewhile(lambda token: token.word not in _MARKS, tokens[begin:end]))
    if begin and all(token.word in _TAKES_BACK for token in said):
        return
    marks = [n for n in range(begin, end) if tokens[n].word in _MARKS]
    parts = _between(tokens, begin, end)
    named = begin == 0 and (name_alone(tokens[:end], tokens[stop:]) or named_errand(tokens[:end], tokens[stop:]))
    if named or idle_at_an_end(tokens[begin:end]) or _all_idle(parts):
        yield begin, stop
        return
    first, last = begin, end
    lead, tail = judged(tokens[begin:end])
    if lead:
        yield begin, begin + lead
        first = begin + lead
    if tail:
        yield end - tail, end
        last = end = end - tail
    for mark in reversed(marks):
        if begin and tokens[mark].word == ":" and tokens[mark - 1].word in _OF_A_TIME:
            break  # behind what is so at the start
        if idle_at_an_end(tokens[begin:mark]) or _all_idle(_between(tokens, begin, mark)):
            first = mark + 1 + (tokens[mark + 1].word in ("but", "and", "so"))
            yield begin, first
            break
    while ahead := _ahead(tokens, first, end, begin):
        yield ahead
        first = ahead[1]
    for mark in marks:
        behind = _between(tokens, mark + 1, end)
        if mark > first and (idle_at_an_end(tokens[mark + 1 : end]) or (behind and all(map(idle_at_an_end, behind)))):
            yield mark, end
            last = mark
            break
    laughed = last
    while laughed > first + 2 and tokens[laughed - 1].word in INTERJECTIONS - vocabulary():
        laughed -= 1
    if laughed < last:
        yield laughed, last
        last = laughed
    for at in range(first + 2, last - 1):
        long = last > at + 3 or tokens[at + 1].word in _KIND
        excepted = _PLACED.issuperset(token.word for token in tokens[at + 1 : last])
        if tokens[at].word in ("and", "but") and long and not excepted and idle_at_an_end(tokens[at + 1 : last]):
            yield at, last
            last = at
            break
    for at in range(first + 2, last):
        bound = tokens[at].word not in _CONNECTING or tokens[at - 1].word in _BINDING
        if not bound and reason_at(tokens[:last], at):
            yield at, last
            last = at
            break
    for one, other in pairwise(mark for mark in marks if first <= mark < last):
        if tokens[one + 1].word not in _TAKES_BACK and idle(tokens[one + 1 : other]):
            yield one, other + (tokens[other + 1].word not in ("and", "then", "but"))


_PLACED = frozenset({"the", "for", "one", "ones", "first", "second", "third", "fourth", "fifth", "last", "next", "two",
                     "three", "only", "single", "very"})  # fmt: skip
"""What is left out of all others, or told besides another: "all red but the last one", "the first and the last one"."""
_OF_A_TIME = frozenset({"goal", "end", "result", "target", "start", "task", "outcome", "scene", "finish", "finally"})


def _between(tokens: list[Token], begin: int, end: int) -> list[list[Token]]:
    """What stands between marks."""
    marks = [begin - 1, *(n for n in range(begin, end) if tokens[n].word in _MARKS), end]
    return [tokens[one + 1 : other] for one, other in pairwise(marks) if other > one + 1]


def _all_idle(parts: list[list[Token]]) -> bool:
    """Whether all that stands between marks is idle, or leads to what is: "right, let us begin"."""
    said = [part for part in parts if any(token.word not in _FILLING for token in part)]
    return bool(said) and all(map(idle_at_an_end, said))


_FILLING = frozenset({"right", "so", "now", "then", "well", "and", "but"})


def _ahead(tokens: list[Token], begin: int, end: int, sentence: int) -> tuple[int, int] | None:
    """ "I am in a hurry so put ...", "today put ...": talk that nothing sets off; "we" stays in front of "and need".
    `sentence`: where it begins, with other such talk."""
    words = [token.word for token in tokens[begin:end]]
    if words[:2] == ["from", ":"]:
        return None  # "from: ..., to: ..."
    called = addressed_at(words)
    called = called or (exclaimed(tokens[begin].word) and tokens[begin].word not in vocabulary())
    if called and begin + called < end - 2 and (tokens[begin + called].word in lexicon.COMMANDS | _PLEASE | _TURNED):
        return begin, begin + called
    if (
        not any(map(tells, tokens[:sentence]))
        and exclaimed(tokens[begin].word)
        and tokens[begin].word not in vocabulary()
    ):
        return begin, begin + 1
    ahead, behind = any(map(tells, tokens[:sentence])), any(map(tells, tokens[end:]))
    state = 0 if ahead else state_behind(words)
    if led := command_behind(words) or state or (0 if ahead or behind else thing_behind(words)):
        return begin, begin + led
    commanded = any(t.word in lexicon.COMMANDS and t1.word in _ENDS | _LEADING for t1, t in pairwise(tokens[end - 1 :]))
    if led := 0 if ahead else led_by_form(tokens[begin:end], commanded):
        return begin, begin + led
    for at in range(begin + 1, end - 2):
        if tokens[at].word in _MARKS:
            return None
        wished = tokens[at + 1].word in _WISHED and tokens[begin].word in ("i", "we")
        joined = tokens[at].word in ("and", "but") and (wished or tokens[at + 1].word in lexicon.COMMANDS | _PLEASE)
        if (joined or tokens[at].word == "so") and idle_at_an_end(tokens[begin:at]):
            return begin + (joined and wished), at + 1
        told = tokens[at - 1].word in ("has", "have", "had") or tokens[at - 1].word in PEOPLE  # "someone has put ..."
        if tokens[at].word in lexicon.COMMANDS and at < begin + 3 and not told and idle_at_an_end(tokens[begin:at]):
            return begin, at
    return None


def _comparisons(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where "like taxis" stands, with the comma that sets it off."""
    words = [token.word for token in tokens]
    plain = any(w in lexicon.STRUCTURE or w in _PLAIN or t.kind == "dims" for w, t in zip(words, tokens, strict=True))
    if not plain and any(lexicon.BLOCK.get(word) for word in words):
        return
    for at in range(len(words)):
        lead = length_at(words, at, _LIKE)
        end = _break(words, at)
        end = next((n for n in range(at, end - 1) if words[n] == "and" and words[n + 1] in lexicon.COMMANDS), end)
        wished = at > 0 and words[at - 1] in _LIKING
        if lead and not wished and end > at + lead and _compared(tokens[at + lead : end], words[:at]):
            opened = at == 0 or words[at - 1] in _BREAKS
            set_off = at > 0 and words[at - 1] in (",", "-")
            yield at - set_off, end + (opened and not set_off and end < len(words))


def _compared(tokens: list[Token], said: list[str]) -> bool:
    """Whether this is nothing of which tasks are made, but something of daily life or that is not known; a figure that
    was said before may be named again, "a circle of ..., like the kids in our circle"."""
    words = [token.word for token in tokens]
    if tuple(words) in _SAYINGS:
        return True
    if in_its_order(words, said):
        return False
    strange = any(t.word not in vocabulary() or t.word in PEOPLE | ANIMALS | OCCASIONS | THINGS for t in tokens)
    lined = {"row", "line"} if not _LINED.isdisjoint(said) else set()
    again = {token for ahead, token in pairwise(tokens) if token.word in (lexicon.STRUCTURE.keys() & {*said}) | lined
             and ahead.word in vocabulary() | OCCASIONS}  # fmt: skip
    symbols = any(word.isdigit() or word in lexicon.DIGIT or word in lexicon.LETTER for word in said)
    laid_out = symbols and any(token.word in LAID_OUT for token in tokens)
    return strange and not laid_out and not any(tells(token) and token not in again for token in tokens)


_SAYINGS = frozenset({("a", "full", "stop"), ("an", "exclamation", "mark"), ("the", "icing", "on", "the", "cake"),
                      ("the", "cherry", "on", "the", "cake"), ("a", "cherry", "on", "a", "cake"),
                      ("the", "cherry", "on", "top"), ("a", "cherry", "on", "top"),
                      *(("a", *small, cover) for small in ((), ("little",), ("small",))
                        for cover in ("roof", "hat", "lid")),
                      ("the", "roof", "of", "a", "house"), ("a", "roof", "on", "a", "house"),
                      ("around", "a", "painting"), ("around", "a", "picture")})  # fmt: skip
"""Like what something comes at an end or on top, in words that mean something else."""
_LINED = frozenset({"row", "line", "lined"})
_LIKING = frozenset({"would", "i", "we", "you", "they", "do", "does", "not", "to", "and", "or"})
"""Behind these "like" is what somebody does."""
_PLAIN = frozenset({"stack", "stacked", "stacking", "line", "lined", "shape", "shaped", "together", "beside", "between",
                    "middle", "corner", "around", "top", "resting"})  # fmt: skip
"""With these it is told how blocks lie."""


def _in_brackets(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where "(which always gets lost)" stands."""
    for at in (n for n, token in enumerate(tokens) if token.word == "("):
        end = next((n for n in range(at, len(tokens)) if tokens[n].word == ")"), at)
        parts = _parted(tokens[at + 1 : end])
        if parts and all(idle_at_an_end(part) or of_their_doings(part) for part in parts):
            yield at, end + 1


def _parted(tokens: list[Token]) -> list[list[Token]]:
    """What stands between commas and stops."""
    marks = [-1, *(n for n, token in enumerate(tokens) if token.word in _ENDS | {","}), len(tokens)]
    return [tokens[one + 1 : other] for one, other in pairwise(marks) if other > one + 1]


def _break(words: list[str], at: int) -> int:
    return next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))


def _closed(tokens: list[Token]) -> list[Token]:
    """The tokens without breaks that set off nothing any more."""
    out: list[Token] = []
    for token in tokens:
        if token.word in _BREAKS - {"(", "-"} and (not out or out[-1].word in _BREAKS - {")"}):
            if out and token.word in _ENDS:
                out[-1] = token
            continue
        out.append(token)
    return out
