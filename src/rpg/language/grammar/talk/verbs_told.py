"""What is done, told roundabout: "with three blocks the robot should build ...", "get that mat cleared"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
OUT_OF = frozenset({"with", "from", "out", "using"})
_WHO = (("the", "robot"), ("the", "arm"), ("the", "agent"), ("the", "gripper"), ("a", "robot"), ("you",),
        (",", "the", "robot"), (",", "you"), (",", "the", "arm"))  # fmt: skip
_SHALL = frozenset({"should", "must", "shall", "will", "can", "could"})
_WHAT = frozenset({"the", "that", "this", "all", "both", "those", "these", "my", "every", "everything"})
_SHORT = 6
_MADE = frozenset({"make", "build", "create", "construct", "form"})
_STAIRS = frozenset({"stairs", "stair", "staircase", "stairway", "ladder", "pyramid"})


def who_builds(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "With three red blocks the robot should build a tower": with three red blocks build one."""
    for begin in (n for n in range(len(words) - 5) if n == 0 or words[n - 1] in _STOPS):
        end = next((n for n in range(begin, len(words)) if words[n] in _STOPS), len(words))
        for at in range(begin + 3, end - 1) if words[begin] in OUT_OF else ():
            who = length_at(words, at, _WHO)
            modal = at + who
            if who and modal + 1 < end and words[modal] in _SHALL and words[modal + 1] in lexicon.COMMANDS:
                return [*tokens[:at], *tokens[modal + 1 :]]
    return None


def got_done(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Get that mat cleared": clear that mat."""
    for begin in (n for n in range(len(words) - 3) if n == 0 or words[n - 1] in (*_STOPS, "please", "and", ",")):
        end = next((n for n in range(begin, len(words)) if words[n] in _STOPS), len(words))
        done = [base for _, base, form in lexicon.VERB.get(words[end - 1], ()) if form == "past" and base != "leave"]
        what = words[begin + 1 : end - 1]
        if words[begin] in ("get", "have") and done and what and what[0] in _WHAT and len(what) <= _SHORT:
            return [*tokens[:begin], tokens[begin].saying(done[0]), *tokens[begin + 1 : end - 1], *tokens[end:]]
    return None


def steps_built(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Make three steps going up to the left": stairs of three steps."""
    for at in (n for n in range(1, len(words) - 1) if tokens[n].many > 1 and words[n - 1] in _MADE):
        hue = words[at + 1] in lexicon.COLOR
        begin = max((n + 1 for n in range(at) if words[n] in _STOPS), default=0)
        end = next((n for n in range(at, len(words)) if words[n] in _STOPS), len(words))
        if words[at + 1 + hue : at + 2 + hue] != ["steps"] or not _STAIRS.isdisjoint(words[begin:end]):
            continue
        say = tokens[at].saying
        return [
            *tokens[:at],
            *tokens[at + 1 : at + 1 + hue],
            say("stairs"),
            say("of"),
            tokens[at],
            *tokens[at + 1 + hue :],
        ]
    return None


def laid_flat(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Lay ten blocks flat in a rectangle": in a rectangle."""
    for at in range(2, len(words) - 2):
        if words[at] == "flat" and words[at + 1] in ("in", "as", "into") and words[at + 2] in ("a", "an", "the"):
            return [*tokens[:at], *tokens[at + 1 :]]
    return None
