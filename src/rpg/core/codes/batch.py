"""Codes reported by batches, and when a workspace is verified after an upgrade."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        "entry-fails",
        "an entry could not be built",
        "Building the entry of a list ended in an error that its instruction is not to blame for by any known rule. "
        "The message says which; the other entries are built.",
    ),
    Code(
        "worker-breaks",
        "the process that built an entry broke down",
        "An error in rpg itself, or a full disk or memory, ended the building of one entry. The next batch tries "
        "again.",
    ),
    Code(
        "worker-lost",
        "the process that built an entry was killed",
        "The process was killed twice on the same entry, most often because memory ran out. The next batch tries "
        "again; fewer workers (`--jobs 1`) need less memory.",
    ),
    Code(
        "gives-other-code",
        "after an upgrade, task.yaml gives other code",
        "The installed rpg writes other code for this task than the one that built it. The task on disk is unchanged; "
        "a batch builds it anew.",
    ),
    Code(
        "gate-no-longer-passed",
        "after an upgrade, a task fails a gate",
        "Under the installed rpg and MuJoCo the task does not pass all gates that it passed when it was built.",
    ),
    Code(
        "goal-changed",
        "after an upgrade, a goal judges states otherwise",
        "The goal was judged on a bank of states when the task was built. It now judges at least one of them "
        "otherwise: the task means something else.",
    ),
    Code(
        "figures-changed",
        "after an upgrade, the gates measure other figures",
        "All gates are passed and the goal judges as before, but some measured figure is not the one on record. This "
        "is a note: physics differs in its last digits between versions of MuJoCo.",
    ),
)
