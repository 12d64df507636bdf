"""Colons between what is told and what is to be done: "green is on red: take it off and put it on the table"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_SO_IS = frozenset({"is", "are", "stands", "stand", "lies", "lie", "sits", "sit", "rests", "rest", "was", "were"})
_WANTED = frozenset({
    "must", "should", "shall", "will", "has", "have", "need", "needs", "end", "finally", "goal", "task", "want", "job",
    "here", "this", "that", "it", "idea", "aim", "plan", "order", "step", "steps", "rule", "rules", "wanted", "what",
    "to", "so", "as",
})  # fmt: skip
"""With these nothing is told of how it is."""
_ASKED = frozenset({"must", "should", "shall"})
_AHEAD = frozenset({"please", "now", "so", "just", "then"})
_TAKES = frozenset({"clear", "empty", "free", "unstack", "dismantle", "remove", "take", "move", "get", "lift"})
_FIRST = frozenset({"first", "firstly", ","})
"""What is taken away, or goes from where it is: behind such a command a fact tells where that was."""
_PLACES = frozenset({"on", "onto", "in", "at", "under", "behind", "next", "left", "right", "beside", "there", "stacked",
                     "between", "above", "upon", "atop"})  # fmt: skip


def told_first(parts: list[list[Token]]) -> list[list[Token]]:
    """The sentences, a fact and the command behind its colon being two of them; so are a command and how it ends, and
    "clear the mat" and what is on it."""
    out: list[list[Token]] = []
    for part in parts:
        words = [token.word for token in part]
        colon = words.index(":") if words.count(":") == 1 else 0
        told = {*words[:colon]}
        fact = bool(told & _SO_IS) and bool(told & _PLACES) and not told & _WANTED
        begun = colon + 1
        while begun < len(words) and words[begun] in _AHEAD:
            begun += 1
        verb = words[begun] if begun < len(words) else ""
        asked = verb in lexicon.COMMANDS or not _ASKED.isdisjoint(words[begun:])
        ended = words[colon + 1 : colon + 4] in (["in", "the", "end"], ["at", "the", "end"])
        if colon and ((fact and asked) or (ended and _commands(words[:colon])) or _taken_from(words, colon)):
            out += [part[:colon], part[colon + 1 :]]
        else:
            out.append(part)
    return out


def _taken_from(words: list[str], colon: int) -> bool:
    """ "(First) clear the mat: red is on it", "move red: it is on the mat"."""
    verb = next((word for word in words if word not in _AHEAD | _FIRST), "")
    told = {*words[colon + 1 :]}
    so = bool(told & _SO_IS) and bool(told & _PLACES) and told.isdisjoint(_WANTED - {"it", "this", "that"})
    return verb in _TAKES and so


def _commands(words: list[str]) -> bool:
    """ "(Please) separate them: in the end ..."."""
    verb = next((word for word in words if word not in _AHEAD), "")
    return verb in lexicon.COMMANDS
