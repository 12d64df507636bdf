"""Codes reported by the validation gates and the repair agents."""

from __future__ import annotations

from rpg.core.codes.base import Code

_TEXT = (
    Code(
        "code-syntax",
        "a file does not parse",
        "code.py or goal_state_code.py is no Python; the line and column are given. Compile from task.yaml to have "
        "both files written again.",
    ),
    Code("code-too-long", "a file is too long", "A file of code has more characters than any task needs."),
    Code(
        "code-forbidden",
        "a construct that tasks are written without",
        "Tasks are a small part of Python: calls, values, comprehensions, conditions and bounded loops. Imports of "
        "modules, exceptions, closures, private names and formatting are not in it, so that a task can be run safely.",
    ),
    Code(
        "code-shape",
        "a file that is not one task class",
        "A file of code is a docstring, one import and one class with the hooks _initialize_env, _on_reset, _on_step, "
        "_success and _fail; goal_state_code.py has a subclass of the task with its own _on_reset.",
    ),
    Code(
        "code-import",
        "an import from elsewhere",
        "Generated code imports from rpg.env alone, and goal_state_code.py the task's class from code.py beside it.",
    ),
    Code("code-unknown-name", "a name that does not exist", "Neither the file nor rpg.env defines this name."),
    Code(
        "code-unknown-hook",
        "a method that no task has",
        "The environment calls _initialize_env, _on_reset, _on_step, _success and _fail; a method under another name "
        "would never run.",
    ),
    Code(
        "code-unknown-attribute",
        "an attribute that does not exist",
        "The task has no such method or attribute, or it is not for tasks to use.",
    ),
    Code(
        "code-bad-call",
        "arguments that do not fit",
        "A method or a record of rpg.env is called with arguments that it does not take, or without one it needs.",
    ),
)
_RUN = (
    Code("code-load", "a file that breaks down when it is loaded", "Running the file to define its class fails."),
    Code(
        "code-times-out",
        "code that does not end",
        "Code that is not the lowering of its task.yaml runs in a confined process with a limit of time.",
    ),
    Code(
        "code-crashes",
        "code that takes its process down",
        "The confined process ended before its gates were through: by a signal, for want of memory, or otherwise.",
    ),
    Code(
        "code-not-confined",
        "code that cannot be confined here",
        "Code that is not the lowering of its task.yaml only runs where the kernel can shut it in, with seccomp or "
        "with Landlock; `rpg doctor` says what holds on this machine.",
    ),
    Code("task-crashes", "a task that breaks down", "An exception leaves a hook of the task; its traceback is given."),
    Code(
        "assets-differ",
        "objects other than in task.yaml",
        "The blocks and patches that the code adds are not those that task.yaml lists.",
    ),
    Code("physics-diverges", "a simulation that diverges", "Positions are no longer finite numbers after a few steps."),
)
_GOAL = (
    Code(
        "unsupported-block",
        "a block with nothing under it",
        "The goal asks for a block on something that itself rests on nothing that reaches the table.",
    ),
    Code(
        "redundant-predicate",
        "a condition that others imply",
        "A part of the goal follows from other parts; it does no harm.",
    ),
    Code(
        "goal-topples",
        "a goal state that falls",
        "A block of the goal state ends more than 2 cm higher or lower than it was placed or than it had settled.",
    ),
    Code(
        "goal-drifts",
        "a goal state that slides",
        "A block of the goal state moves by more than 1 cm from where it was placed or had settled.",
    ),
    Code("goal-moves", "a goal state that is not at rest", "A block still moves after 100 control steps."),
    Code(
        "goal-not-met",
        "a goal that does not hold in the goal state",
        "The success check is false after the goal state has settled; the parts that do not hold are listed.",
    ),
    Code(
        "goal-not-kept",
        "a goal that breaks again",
        "The success check is true after settling and false at some later step while nothing is touched.",
    ),
    Code(
        "goal-out-of-bounds",
        "a goal state outside of the workspace",
        "The centre of a block leaves x 0.40 to 0.70 m, y -0.25 to 0.25 m, or lies below the table top.",
    ),
)
_RESET = (
    Code("reset-solved", "a start that is solved already", "The success check is true at a sampled start."),
    Code("reset-lost", "a start that is lost already", "The episode has failed before anything was done."),
    Code(
        "reset-overlap", "blocks inside each other at the start", "Bodies overlap by more than 1 mm at a sampled start."
    ),
    Code(
        "reset-out-of-bounds",
        "a start outside of the workspace",
        "A block starts where the robot cannot be asked to go.",
    ),
    Code(
        "reset-moves", "a start that is not at rest", "Blocks move at a sampled start before the robot does anything."
    ),
)
_MUTATION = (
    Code(
        "goal-vacuous",
        "a goal that almost anything satisfies",
        "The success check is true in states that only nearly satisfy the goal: a block moved off, two swapped, one "
        "lifted, tilted or missing. The survivors are listed.",
    ),
    Code(
        "goal-over-tight",
        "a goal that hardly anything satisfies",
        "The success check is false in other states that satisfy every condition of task.yaml.",
    ),
    Code(
        "not-deterministic",
        "a task that does not repeat",
        "The same seed gives another state in a fresh process, or the fresh process did not get that far.",
    ),
)
_REPAIR = (
    Code("repaired", "a task that was mended", "A gate failed first; what was changed to pass it is said."),
    Code(
        "repair-refused",
        "a repair that would weaken the task",
        "A change that would have passed the gate drops a condition that the instruction asks for; it was not made.",
    ),
)
CODES: tuple[Code, ...] = (*_TEXT, *_RUN, *_GOAL, *_RESET, *_MUTATION, *_REPAIR)
