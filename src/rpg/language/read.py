"""Tokens -> sentences -> their readings, cheapest first; where the reading stops, a diagnostic says so."""

from __future__ import annotations

from dataclasses import dataclass, replace

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.language import lexicon
from rpg.language.bracketed import adds, unbracketed
from rpg.language.colons import told_first
from rpg.language.conditions import conditional, inverted
from rpg.language.grammar.clauses.chains import chain
from rpg.language.grammar.clauses.clauses import tail
from rpg.language.grammar.clauses.links import emphasised, next_step, now_again
from rpg.language.grammar.clauses.numbers_denied import denies_a_number
from rpg.language.grammar.clauses.or_listed import one_of_which, or_listed
from rpg.language.grammar.core import Parser, TooMuchWork
from rpg.language.grammar.rows.formal import plainly
from rpg.language.grammar.structures.copies import in_one_sentence
from rpg.language.grammar.structures.levels import in_one
from rpg.language.grammar.talk.answered import with_answers
from rpg.language.grammar.talk.asides import SOFT
from rpg.language.grammar.talk.chatter import announces, idle
from rpg.language.grammar.talk.commands import AFTER_THAT, WHEN_OVER
from rpg.language.grammar.talk.legible import legible
from rpg.language.grammar.things.lists import with_commas
from rpg.language.meaning import Chain, Clause, cost_of
from rpg.language.numbered import as_steps
from rpg.language.runon import places, runs_on
from rpg.language.tokens import Token
from rpg.language.turns import announced, heads, in_turn

MAX_KEPT = 24
TANGLED = "too-complex"
_ENDS = frozenset({".", "!", "?"})
_STEPS = frozenset({"step", "stage", "task", "action", "move", "phase", "part"})
_THE = frozenset({"the", "a", "an", "both", "all"})
"""Behind these "stack" and "line" are no nouns: "second, stack the red block on the blue one"."""
_COUNTED = frozenset({"step", "stage", "phase", "subtask"})
_LISTED = frozenset({"requirement", "condition", "rule", "constraint", "point", "criterion", "wish", "subgoal"})
"""These are counted as well, and hold all at once."""
_ASKING = frozenset({"is", "are", "was", "were", "does", "did", "which", "where", "why", "who", "when"})
"""What a question begins with that is no polite command."""
_THEN = (
    "only then",
    "and only then",
    "and finally",
    "and then finally",
    "and lastly",
    "and at last",
    "and after that",
    "and afterwards",
    "and next",
    "only after that",
    "only afterwards",
    "once done",
    "after doing so",
    "having done that",
    "as the last step",
    "at last",
    "and then",
    "then",
    "after that",
    "afterwards",
    "finally",
    "next",
    "lastly",
    "last of all",
    "subsequently",
    "thereafter",
    "second of all",
    "second",
    "third",
    "secondly",
    "thirdly",
    "continue with",
    "continue by",
    "go on with",
    "proceed with",
    "after this",
    "finish by",
    "end by",
    "conclude by",
    "finish off by",
    "to finish",
    "to finish off",
    "to end",
    "to conclude",
    "to finish with",
    "to end with",
    "to top it off",
    "and to finish",
    "as a finish",
)

_FIRST = ("first ,", "firstly", "first put", "first place", "first stack", "first build", "first make", "first move",
          "first the", "start by", "begin by")  # fmt: skip
"""Words that a following sentence comes after, even if it does not say so."""
_LEADING_WORDS = (
    "to must should shall may might can could will would do does not never please and then or but you i we just so "
    "that first now finally next a an the one two three four five six each every this"
)
_LEADING = frozenset(_LEADING_WORDS.split())
"""What stands before a verb, or a noun that looks like one, in the middle of a sentence."""
_BEFORE_ONE = frozenset({*lexicon.COLOR, *lexicon.SIZE, "other", "last"})
"""Behind these "one" is a thing and ends what is said of it: "a red one put it there"."""
_EARLIER = ("before that", "but before that", "beforehand", "but first", "before this", "before doing so",
            "before you do that")  # fmt: skip


@dataclass(frozen=True)
class Sentence:
    """A sentence with its readings. `link` "then": it follows the one before in time."""

    link: str
    readings: tuple[Chain, ...]


Parts = list[tuple[list[Token], Sentence]]
"""Sentences, each with its tokens."""


def split(tokens: list[Token]) -> list[list[Token]]:
    """Sentences; semicolons end one too, and so do brackets, whose inside is a sentence of its own."""
    out: list[list[Token]] = [[]]
    for index, token in enumerate(tokens):
        ends = token.word in _ENDS or token.word == ";"
        if ends and token.kind == "punct":
            if (
                token.word == "."
                and out[-1]
                and len(out[-1]) == 1
                and out[-1][0].kind == "number"
                and index + 1 < len(tokens)
            ):
                out[-1] = []
                continue
            out.append([])
        else:
            out[-1].append(token)
    return [s for s in out if s]


def read_sentences(tokens: list[Token]) -> list[Sentence]:
    """Every sentence of an instruction with its readings."""
    parts = in_one(_with_predicates(told_first(with_answers(legible(split(as_steps(tokens)))))))
    parts = in_one_sentence(parts)
    read: Parts = []
    headed: int | None = None
    for part in [part for part in parts if not idle(part)] or parts:
        if heads(part) and headed is None and part is not parts[-1]:
            headed = len(read)
            continue
        found = _read(part)
        if announced(part) and found:
            (own, first), *more = found
            found = [(own, Sentence(first.link, tuple(map(in_turn, first.readings)))), *more]
        read += found
    sentences = [sentence for _, sentence in read]
    for n in range(headed + 1 if headed is not None else len(read), len(read)):
        sentences[n] = Sentence("then", sentences[n].readings) if sentences[n].link == "and" else sentences[n]
    for n in range(1, len(read)):
        if sentences[n].link == "and" and sentences[n - 1].link == "and" and Parser(read[n - 1][0]).any_of(0, _FIRST):
            sentences[n] = Sentence("then", sentences[n].readings)
        if sentences[n - 1].link == "then" and Parser(read[n][0]).any_of(0, _LAST):
            sentences[n] = Sentence("then", sentences[n].readings)
        p = Parser(read[n][0])
        over = sentences[n].link == "and" and any(next_step(p, k) for k in WHEN_OVER.matches(p, 0))
        if over and any(map(_asks, sentences[:n])):
            sentences[n] = Sentence("then", sentences[n].readings)
    for n, (part, sentence) in enumerate(read):
        if sentence.link == "then" and any(AFTER_THAT.matches(Parser(part), 0)) and not any(map(_asks, sentences[:n])):
            raise Refusal([stuck(Parser(part))])
    if not sentences:
        hint = "say what should be done with which blocks"
        raise Refusal([Diagnostic(code="no-words", message="there are no words in this", hint=hint, origin="schema")])
    return sentences


def _asks(sentence: Sentence) -> bool:
    """Whether a sentence asks for something, and tells more than how it starts."""
    clauses = sentence.readings[0].clauses
    return any(not isinstance(c, Clause) or c.mode not in ("start", "given") for c in clauses)


_LAST = ("finish with", "end with", "conclude with")
"""Behind steps these begin one more; else they tell of the end."""
_BARE = frozenset({"is", "are", "must", "should", "does", "may", "not", "be", "shall"})
"""What a sentence ends with that leaves its predicate to the one before it."""
_RELATIVE = frozenset({"where", "as", "what", "how", "that", "which"})
"""With these "is" at the end is no predicate that is left out: "where it is"."""
_NO_MORE = {
    (*there, "nothing", "else", *where)
    for there in ((), ("there", "is")) for where in ((), ("there",), ("on", "the", "table"))
}  # fmt: skip
"""Sentences that say no more than that what was told is all there is."""
_JUST_SO = frozenset({"no", "not", "more", "fewer", "less", "and", "or", ",", "neither", "nor"})
"""Of such words are sentences that say no more than that a number is exact: "No more, no fewer."."""


def _with_predicates(parts: list[list[Token]]) -> list[list[Token]]:
    """ "A must be on the patch. C must not be.": one sentence, for the second has no predicate of its own; and so are
    "The table looks like this." and what follows it."""
    out: list[list[Token]] = []
    for part in parts:
        if out and tuple(token.word for token in part) in _NO_MORE:
            comma = replace(part[0], kind="punct", word=",", raw=",", value=None)
            out[-1] = [*out[-1], comma, *(token for token in part if token.word in ("nothing", "else"))]
            continue
        if out and ({token.word for token in part} <= _JUST_SO or denies_a_number(part)):
            out[-1] = [*out[-1], replace(part[0], kind="punct", word=",", raw=",", value=None), *part]
            continue
        if out and announces(out[-1]):
            out[-1] = [*out[-1], replace(part[0], kind="punct", word=":", raw=":", value=None), *part]
            continue
        own = part[0].word in _ASKING or any(token.word in _RELATIVE for token in part) or _tells_before(part)
        if out and len(part) > 1 and part[-1].word in _BARE and not own:
            joint = replace(part[0], kind="word", word="and", raw="and", value=None)
            out[-1] = [*out[-1], joint, *part]
        else:
            out.append(part)
    return out


def _tells_before(part: list[Token]) -> bool:
    """ "One is on the mat, the other is not": what the end leaves out is told in the sentence itself."""
    words = [token.word for token in part]
    while words and words[-1] in _BARE:
        words.pop()
    return not _BARE.isdisjoint(words)


def _read(tokens: list[Token]) -> Parts:
    """A sentence; where it makes no sense as one, the two that it is made of.

    One that makes none is looked at again with nothing spared, for a diagnostic to say how far it was understood.
    """
    found = _parts(tokens)
    if not isinstance(found, Refusal):
        return found
    if found.diagnostics[0].code == TANGLED:
        raise found
    plain = [_parts(part) for part in plainly(tokens)]
    if plain and not any(isinstance(parts, Refusal) for parts in plain):
        return [part for parts in plain if not isinstance(parts, Refusal) for part in parts]
    return [(tokens, read_sentence(tokens, thorough=True))]


def _parts(tokens: list[Token]) -> Parts | Refusal:
    """The sentence or the two that it is made of.

    They meet where a command begins without a stop, or where each of two says where a block goes. Only one place to
    part them may make sense, for else it is not clear what was said.
    """
    whole = _whole(tokens)
    if not isinstance(whole, Refusal) or whole.diagnostics[0].code == TANGLED:
        return whole
    inside = range(2, len(tokens) - 2)
    commands = [n for n in inside if _commands(tokens, n)]
    found = [parts for n in commands if (parts := _parted(tokens[:n], tokens[n:]))]
    for n in (n for n in inside if n not in commands and runs_on(tokens, n)):
        parts = _parted(tokens[:n], tokens[n:])
        found += [parts] if parts and all(places(sentence.readings[0]) for _, sentence in parts) else []
    return found[0] if len(found) == 1 else whole


def _parted(first: list[Token], second: list[Token]) -> Parts:
    """Two parts of a sentence; nothing where one of them makes no sense."""
    before = _whole(first)
    if isinstance(before, Refusal):
        return []
    after = _parts(second)
    return [] if isinstance(after, Refusal) else [*before, *after]


def _whole(tokens: list[Token]) -> Parts | Refusal:
    """The sentence as one."""
    try:
        return [(tokens, read_sentence(tokens))]
    except Refusal as refusal:
        return refusal


def _commands(tokens: list[Token], n: int) -> bool:
    """Could a command begin here, nothing before it leading to it?"""
    plain = tokens[n].kind == "word" and tokens[n].word in lexicon.COMMANDS
    denied = tokens[n].word == "do" and tokens[n + 1].word == "not"
    denied = denied or (tokens[n].word == "goal" and tokens[n + 1].word == "is")
    before = tokens[n - 1]
    leads = before.word in _LEADING and not (before.word == "one" and tokens[n - 2].word in _BEFORE_ONE)
    now = tokens[n].word == "now" and tokens[n + 1].word in lexicon.COMMANDS
    return (plain or denied or now) and not leads and (before.kind in ("word", "literal") or before.word == "one")


def read_sentence(tokens: list[Token], thorough: bool = False) -> Sentence:
    """The readings of one sentence, cheapest first."""
    p = Parser(tokens, thorough)
    start = p.opt(0, ",", ":")
    link = "and"
    if (depends := inverted(p, start)) is not None:
        raise Refusal([depends])
    counted = p.words[start] in _COUNTED or p.words[start] in _LISTED
    if counted and (step := p.number(start + 1)) is not None:
        link = "then" if step > 1 and p.words[start] in _COUNTED else "and"
        start = p.opt(start + 2, ":", ",", "-")
    ordinal = p.lex(start, lexicon.ORDINAL)
    if ordinal and p.words[start + 1] in lexicon.STRUCTURE and p.words[start + 2] == ":":
        raise Refusal([stuck(p)])  # "first tower: red on blue" is one of several, and no step
    if ordinal and p.one(start + 1, _STEPS) and (j := p.one(start + 2, frozenset({":", ",", "-"}))):
        link, start = "then" if ordinal > 1 else "and", j
    for _, j in p.standing(start, _EARLIER)[:1]:
        link, start = "before", p.opt(j, ",", ":")
    for phrase, j in p.standing(start, _THEN):
        part = phrase in ("second", "third") and p.words[j] in lexicon.STRUCTURE and p.words[j + 1] not in _THE
        if not (phrase == "next" and p.words[j] == "to") and not part:
            link, start = "then", emphasised(p, p.opt(j, ",", ":"))
            break
    if link == "and" and (j := now_again(p, start)):
        link, start = "then", j
    first = p.opt(p.opt(start, "first"), ",", ":")
    start = first if p.words[first] == "either" else start
    if link != "before" and (j := max(AFTER_THAT.matches(p, start), default=0)):  # "then, once this is done, ..."
        link, start = "then", emphasised(p, p.opt(j, ",", ":"))
    try:
        read = [(cost_of(c), n, or_listed(p, c)) for n, (c, j) in enumerate(chain(p, start)) if _ends(p, j)]
    except TooMuchWork:
        raise Refusal([stuck(p) if thorough else _tangled(p)]) from None
    found = [(cost, n, c) for cost, n, c in read if c is not None]
    if read and not found:
        raise Refusal([one_of_which(p)])
    if not found and any(t.value == SOFT for t in tokens):
        return read_sentence([t for t in tokens if t.value != SOFT], thorough)
    if not found and (listed := with_commas(tokens)) is not None:
        return read_sentence(listed, thorough)
    if not found and adds(tokens):
        return read_sentence(unbracketed(tokens), thorough)
    if not found:
        raise Refusal([stuck(p)])
    found.sort(key=lambda item: item[:2])
    return Sentence(link, tuple(c for _, _, c in found[:MAX_KEPT]))


def _ends(p: Parser, j: int) -> bool:
    j = tail(p, j)
    return p.opt(j, ",", ":") == p.end


def _tangled(p: Parser) -> Diagnostic:
    return Diagnostic(
        code=TANGLED,
        message="this sentence is too tangled to be read",
        span=p.span(0, p.end),
        hint="use several short sentences",
        origin="schema",
    )


def stuck(p: Parser) -> Diagnostic:
    """Where the reading came to a halt."""
    at = min(p.far, p.end)
    if p.words[0] in _ASKING:
        return Diagnostic(
            code="no-goal", message="this is a question: it asks for nothing to be done", span=p.span(0, p.end),
            hint="say how it should be, as in 'the red block should be on the blue block'", origin="schema",
        )  # fmt: skip
    if at >= p.end:
        return Diagnostic(
            code="incomplete", message="the sentence stops before it says what should be done", span=p.span(0, p.end),
            hint="say what should be done with which blocks, and where they should be", origin="schema",
        )  # fmt: skip
    if (depends := conditional(p, at)) is not None:
        return depends
    token = p.tokens[at]
    return Diagnostic(
        code="misplaced-word", message=f"{token.raw!r} does not fit here", span=token.span,
        hint="say it in a sentence of its own, or in other words",
        facts={"word": token.raw, "understood": " ".join(t.raw for t in p.tokens[:at])}, origin="schema",
    )  # fmt: skip
