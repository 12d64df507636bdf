"""What stands over a text: "Level 5:", "Question:", "Benchmark item 12b:", "Stacking task #3 -"."""

from __future__ import annotations

from rpg.language.tokens import Token

_TITLES = frozenset({"level", "task", "exercise", "problem", "example", "question", "puzzle", "challenge", "scene",
                     "scenario", "instruction", "job", "mission", "number", "round", "riddle", "benchmark", "item",
                     "test", "case", "sample", "episode", "trial", "prompt", "entry", "experiment", "demo", "eval",
                     "evaluation", "id", "no", "request", "assignment", "quiz", "ticket", "query", "run", "warmup",
                     "subtask", "testcase", "drill"})  # fmt: skip
"""What texts are called."""
_KINDS = frozenset({"stacking", "sorting", "spelling", "building", "arrangement", "manipulation", "rearrangement",
                    "robot", "robotics", "lab", "easy", "hard", "simple", "new", "short", "quick", "unit", "regression",
                    "baseline", "held", "out", "training", "validation", "tabletop", "sanity", "check", "warm", "up",
                    "proposed", "contributed", "suggested", "another", "my", "our", "the", "a"})  # fmt: skip
"""What may be said of them in front."""
_SIGNS = (":", ".", ",")
LONGEST = 5


def title(tokens: list[Token]) -> int:
    """How many of the first tokens are a title. One without a number ends with a colon.

    "Task 1: ... Task 2: ..." has two of them, and is none.
    """
    words = [token.word if token.kind == "word" else "" for token in tokens]
    at = 0
    while at < min(LONGEST, len(tokens)) and words[at] in _TITLES | _KINDS:
        at += 1
    code = len(tokens) > 1 and _single(tokens[0]) and tokens[1].kind == "number" and _bound(tokens, 1)
    at = 1 if code else at
    called = words[at - 1] if at else ""
    if not code and called not in _TITLES:
        return 0
    if called == "no" and _stands(tokens, at, "."):
        at += 1
    numbered = at < len(tokens) and tokens[at].kind == "number"
    if numbered:
        at += 1
        if at < len(tokens) and _single(tokens[at]) and _bound(tokens, at):
            at += 1
    again = any(words[n] == called and tokens[n + 1].kind == "number" for n in range(at, len(tokens) - 1))
    if at + 1 >= len(tokens) or again or not any(_stands(tokens, at, sign) for sign in _SIGNS):
        return 0
    return at + 1 if tokens[at].word == ":" or (numbered and not code) else 0


def _stands(tokens: list[Token], at: int, sign: str) -> bool:
    return at < len(tokens) and tokens[at].kind == "punct" and tokens[at].word == sign


def _single(token: Token) -> bool:
    return token.kind == "word" and len(token.word) == 1


def _bound(tokens: list[Token], at: int) -> bool:
    """Whether nothing stands between a token and the one before it: "T12", "4b"."""
    return tokens[at - 1].span[1] == tokens[at].span[0]
