"""Other ways to say what a task asks for: other verbs, moods, nouns and orders, from the same clauses."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import product

from rpg.blocks.english.goals import spoken
from rpg.blocks.english.scene import objects, starts, told_by_goal
from rpg.blocks.english.speaker import Inexpressible, Speaker
from rpg.blocks.nouns import join
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema

MARK = "§"
"""Stands for the modal verb of a statement while its mood is open."""
STATEMENT = re.compile(rf"(?P<subject>[^{MARK}]*) {MARK} (?P<no>not )?(?P<verb>\w+)(?: (?P<rest>[^{MARK}]*))?")
Mood = Callable[[str], str | None]
"""Turns a clause with its mark into one of a mood; None where the mood does not suit it."""


def _with(modal: str) -> Mood:
    return lambda text: text.replace(MARK, modal)


def _wish(text: str) -> str | None:
    return f"I want {text.replace(f'{MARK} not', 'not to').replace(MARK, 'to')}" if text.count(MARK) == 1 else None


COMMANDS: tuple[tuple[str, str, str, str], ...] = (
    ("be", r"stacked(?P<more>.*)", "stack {subject}{more}", "pile {subject} up{more}"),
    ("be", r"(?P<more>in a (row|line|column).*)", "line up {subject} {more}", "arrange {subject} {more}"),
    ("be", r"sorted (?P<more>.*)", "sort {subject} {more}", "separate {subject} {more}"),
    ("be", r"turned (?P<more>.*)", "turn {subject} {more}", "rotate {subject} {more}"),
    ("be", r"(?P<more>upright|upside down)", "turn {subject} {more}", "rotate {subject} {more}"),
    ("be", r"moved (?P<more>.*)", "move {subject} {more}", "shift {subject} {more}"),
    ("be", r"empty", "leave {subject} empty", "keep {subject} empty"),
    ("be", r"on (?P<more>.*)", "put {subject} on {more}", "move {subject} onto {more}"),
    ("be", r"(?P<more>.*)", "put {subject} {more}", "place {subject} {more}"),
    ("form", r"(?P<more>.*)", "arrange {subject} into {more}", "build {more} from {subject}"),
    ("spell", r"(?P<more>.*)", "spell {more} with {subject}", "arrange {subject} so that they spell {more}"),
    ("read", r"(?P<more>.*)", "arrange {subject} so that they read {more}", "put {subject} so that they read {more}"),
    ("touch", r"(?P<more>.*)", "make {subject} touch {more}", "put {subject} so that it touches {more}"),
    ("stay", r"(?P<more>.*)", "leave {subject} {more}", "keep {subject} {more}"),
    ("swap", r"(?P<more>.*)", "swap {subject}", "exchange {subject}"),
    ("face", r"(?P<more>.*)", "turn {subject} so that it faces {more}", "rotate {subject} to face {more}"),
)
"""Verb and rest of a statement, and two commands that ask for it."""


def _command(choice: int) -> Mood:
    def command(text: str) -> str | None:
        said = STATEMENT.fullmatch(text)
        if said is None or said["subject"] in ("nothing", "something", "there"):
            return None
        for verb, rest, *forms in COMMANDS:
            found = re.fullmatch(rest, said["rest"] or "") if said["verb"] == verb else None
            if found:
                order = forms[choice].format(subject=said["subject"], more=found.groupdict().get("more", ""))
                return f"do not {order}" if said["no"] else order
        return None

    return command


STYLES: tuple[tuple[Mood, str, dict[str, str]], ...] = (
    (_command(0), "{}", {}),
    (_with("should"), "{}", {"block": "cube"}),
    (_command(1), "please {}", {"block": "cube", "patch": "target"}),
    (_with("must"), "{}", {}),
    (_command(0), "could you {}?", {"block": "brick", "patch": "mat"}),
    (_wish, "{}", {}),
    (_command(0), "your task is to {}", {"block": "box"}),
    (_with("must"), "in the end, {}", {"block": "cube"}),
    (_command(1), "{}, thanks", {}),
    (_with("should"), "make sure that {}", {"patch": "goal patch"}),
)
"""Mood, frame and nouns of one way to speak."""


def variants(schema: TaskSchema) -> Iterator[str]:
    """Texts that should mean what `schema` says, the more natural ones first; not all of them need to compile."""
    world = World(schema.assets)
    numbered: frozenset[str] = frozenset()
    for brief, turn in product((True, False) if told_by_goal(schema) else (False,), (0, 1)):
        for style, (mood, frame, nouns) in enumerate(STYLES):
            while True:
                try:
                    say = Speaker(world, modal=MARK, numbered=numbered)
                    text = _text(schema, say, mood, frame, style % 2 != turn, brief and not numbered)
                    break
                except Inexpressible as failure:
                    numbered |= {failure.noun}
            if text is not None:
                yield _renamed(text, nouns)


def _text(schema: TaskSchema, say: Speaker, mood: Mood, frame: str, turned: bool, brief: bool) -> str | None:
    opening = [] if brief else objects(schema, Speaker(say.world))
    opening += starts(schema, say)
    parts, timed = _parts(schema.goal)
    if turned and not timed:
        parts = parts[::-1]
    clauses = [mood(spoken(part, say)) for part in parts]
    if None in clauses or (turned and len(parts) == 1):
        return None
    said = [clause for clause in clauses if clause is not None]
    if timed:
        goal = frame.format(", then ".join(said) if turned else " and after that ".join(said))
        goal = goal if turned else goal.replace(said[0], f"first {said[0]}", 1)
    else:
        goal = frame.format(join(said))
    return " ".join(_sentence(s) for s in [*opening, goal])


def _parts(goal: g.Goal) -> tuple[tuple[g.Goal, ...], bool]:
    """What a goal consists of, and whether it comes in order."""
    match goal:
        case g.All():
            return goal.goals, False
        case g.Sequence():
            return tuple(stage.goal for stage in goal.stages), True
    return (goal,), False


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + ("" if text.endswith("?") else ".")


def _renamed(text: str, nouns: dict[str, str]) -> str:
    for noun, other in nouns.items():
        text = re.sub(rf"\b{noun}(e?s)?\b", lambda m, o=other: _number(o, bool(m[1])), text)  # type: ignore[misc]
    return text


def _number(noun: str, plural: bool) -> str:
    return (noun + ("es" if noun.endswith(("x", "ch")) else "s")) if plural else noun
