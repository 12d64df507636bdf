"""Headings over the parts of a text: how it begins and what should be, in the words that a grammar knows."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

ENDS = frozenset({".", "!", "?", ";"})
_BEGUN = listed(
    "setup setting scene scenario situation state layout configuration arrangement context world environment premise "
    "background initialisation initialization init reset precondition preconditions pre known quo"
)
"""Headings of how it begins, where another one is of what should be done."""
_STOOD = listed("setup situation premise context background init reset precondition preconditions pre known quo")
"""Of these headings it is clear what they stand over where a command stands elsewhere."""
_REACHED = listed("postcondition postconditions post effect effects want wanted")
_AIMED = _REACHED | listed(
    "goal goals task objective aim target job mission result end finish success todo instruction command"
)
_WHICH = listed("reset scene initial starting start episode world status")
"""What stands before a heading of how it begins."""
_SAYS = frozenset({":", "="})
_ARTICLES = frozenset({"the", "my", "our", "your"})


_STATE = "(?:state|configuration|layout|arrangement|setup|scene|situation|position|condition|picture|world)"
_EVENT = "(?:episode|task|run|game|trial)"
_BEFORE = on_demand(
    "pre|pre ?conditions?|before|start|initial|initially|now|input|source|old|original|in|from|as is|today|"
    f"(?:current|present|existing|reset|original|opening|old|initial|starting|start) {_STATE}|{_STATE} before|"
    f"before {_EVENT}|what (?:is there|there is|we have|you have|i have|you get|we start with)"
)
_AFTER = on_demand(
    "post|post ?conditions?|after|afterwards|then|later|goal|task|end|finish|final|finally|success|output|target|new|"
    "result|out|to|to be|tomorrow|wanted|desired|required|"
    f"(?:desired|wanted|required|resulting|success|new|final|end|ending|finishing|goal|target) {_STATE}|{_STATE} after|"
    f"after {_EVENT}|what (?:should be there|there should be|we want|you want|i want|we need|it should be)"
)
"""Of such headings it is clear what they stand over where one of each kind stands in a text."""
_JOINS = frozenset({",", "-", "–", "—"})
_LONGEST = 5


def _paired(tokens: list[Token]) -> list[Token]:
    """The text with two headings, of which one is of how it is before and one of how it is after, as start and goal:
    "Precondition: ... Postcondition: ...", "Current state: ... Desired state: ...", "Now: ... Then: ..."."""
    colons = [n for n, token in enumerate(tokens[:-1]) if token.word == ":"]
    if len(colons) != 2 or colons[0] > _LONGEST:
        return tokens
    first, second = colons
    marks = [n for n in range(first + 1, second) if tokens[n].word in ENDS | _JOINS and n >= second - _LONGEST - 1]
    begin = next((n + 1 for n in marks if _AFTER.fullmatch(_called(tokens[n + 1 : second]))), 0)
    told = tokens[first + 1]
    if not begin or not _BEFORE.fullmatch(_called(tokens[:first])) or told.word in lexicon.COMMANDS:
        return tokens
    if told.word == "none" and begin == first + 3:
        return tokens[begin:]
    start, stop, goal = (tokens[n].saying(word) for n, word in ((0, "start"), (begin - 1, "."), (begin, "goal")))
    return [start, *tokens[first : begin - 1], stop, goal, *tokens[second:]]


def _called(heading: list[Token]) -> str:
    return " ".join(token.word for token in heading if token.word not in _ARTICLES)


def headed(tokens: list[Token]) -> list[Token]:
    """Headings in the words that a grammar knows: "Setup: red on blue. Goal = blue on red"."""
    tokens = _paired(tokens)
    heads = [n for n in range(len(tokens) - 1) if tokens[n + 1].word in _SAYS and _heads(tokens, n)]
    aimed = any(tokens[n].word in _AIMED for n in heads)
    renamed = dict.fromkeys(_BEGUN, "start") | dict.fromkeys(_REACHED, "goal") | {"have": "given"} if aimed else {}
    renamed = renamed or (dict.fromkeys(_STOOD, "start") if heads and commanded(tokens) else {})
    out = list(tokens)
    for n in reversed(heads):
        word = renamed.get(tokens[n].word, tokens[n].word)
        said = replace(tokens[n + 1], kind="punct", word=":", raw=":")
        if word in lexicon.PATCH and word not in _AIMED and _of_patches(tokens, n + 2):
            word, said = "there", replace(said, kind="word", word="is")
        out[n : n + 2] = [replace(tokens[n], word=word), said]
        if n and tokens[n - 1].word == ",":
            out[n - 1] = replace(tokens[n - 1], word=".", raw=".")
        elif n and tokens[n - 1].word in (_ARTICLES | _WHICH if word == "start" else _ARTICLES):
            del out[n - 1]
    return out


def commanded(tokens: list[Token]) -> bool:
    """Whether some sentence of the text is a command."""
    first = (t for n, t in enumerate(tokens) if not n or tokens[n - 1].word in (*ENDS, "please", "then", "now"))
    return any(token.word in lexicon.COMMANDS for token in first)


def _heads(tokens: list[Token], n: int) -> bool:
    """Whether a word is one that stands over a part of the text."""
    whose = _ARTICLES | (_WHICH if tokens[n].word in _BEGUN else frozenset())
    at = n - 1 if n and tokens[n - 1].word in whose else n
    known = tokens[n].word in _BEGUN | _AIMED | {"start", "have", "given"} or tokens[n].word in lexicon.PATCH
    begins = at == 0 or tokens[at - 1].word in ENDS or (tokens[n + 1].word == "=" and tokens[at - 1].word == ",")
    return begins and known


def _of_patches(tokens: list[Token], at: int) -> bool:
    """Whether a part of the text ends with a patch, "Zones: a red mat and a blue mat."."""
    end = next((n for n in range(at, len(tokens)) if tokens[n].word in ENDS), len(tokens))
    return tokens[end - 1].word in lexicon.PATCH
