"""A session that is typed: an instruction, then edits, each answered with what became of it."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rpg.cli.options import clean, find

if TYPE_CHECKING:
    from rpg.cli.output import Output
    from rpg.pipeline import CompileOptions
    from rpg.store import Version, Workspace

HELP = (
    "Type an instruction, then what is to change. Besides: log (the versions), show (the task), new INSTRUCTION "
    "(another family), checkout N, help, quit."
)
QUIT = frozenset({"quit", "exit", "q", "bye", ":q"})


class Conversation:
    """The state of a typed session: the family that is being worked on."""

    def __init__(self, out: Output, workspace: Workspace, options: CompileOptions) -> None:
        self.out = out
        self.workspace = workspace
        self.options = options
        self.version: Version | None = None
        self.status = 0
        self.turns: list[dict[str, Any]] = []

    def take(self, line: str) -> bool:
        """Answer one line; False to end."""
        word, _, rest = line.partition(" ")
        if line.lower() in QUIT:
            return False
        if line.lower() in ("help", "?"):
            self.out.asides.print(HELP)
        elif line.lower() in ("log", "show"):
            self._about(line.lower())
        elif word.lower() == "checkout" and rest.strip():
            self._checkout(rest.strip())
        elif self.version is None or (word.lower() == "new" and rest.strip()):
            self._begin(rest.strip() if word.lower() == "new" and rest.strip() else line)
        else:
            self._change(line)
        return True

    def interrupted(self) -> None:
        """A line that was given up on while it was worked on: the family is as that left it."""
        from rpg.store import Family

        if self.version is not None:
            self.version = Family(self.version.directory.parent).head()
        where = f"; {self.version} is current" if self.version else ""
        self.out.errors.print(f"interrupted{where}", markup=False)

    def _begin(self, instruction: str) -> None:
        from rpg.cli.summary import print_outcome
        from rpg.pipeline import compile_instruction
        from rpg.publishing import publish, summary
        from rpg.store import Written

        outcome = compile_instruction(instruction, self.options)
        place = publish(outcome, self.workspace)
        self.turns.append({"text": instruction, **summary(outcome, place)})
        print_outcome(self.out, outcome, place)
        self._note(outcome.status)
        if isinstance(place, Written):
            self.version = place.version

    def _change(self, edit: str) -> None:
        from rpg.cli.steered import print_steered
        from rpg.steering import steer, steered_summary

        assert self.version is not None
        done = steer(self.version, edit, self.options)
        self.turns.append({"text": edit, **steered_summary(done)})
        print_steered(self.out, done)
        self._note(done.status)
        self.version = done.version or self.version

    def _checkout(self, number: str) -> None:
        from rpg.core.diagnostics import UsageError
        from rpg.store import resolve, set_head

        if self.version is None:
            self.out.errors.print("there is no task yet; type an instruction")
            return
        try:
            self.version = resolve(self.workspace, f"{self.version.family}@{number.removeprefix('v')}")
        except UsageError as error:
            self.out.errors.print(str(error), markup=False)
            return
        set_head(self.version)
        self.out.result.print(f"{self.version.family} is now at version {self.version.number}")

    def _about(self, what: str) -> None:
        if self.version is None:
            self.out.errors.print("there is no task yet; type an instruction")
            return
        from rpg.cli.tree import lineage_tree
        from rpg.store import Family

        if what == "log":
            family = Family(self.version.directory.parent)
            self.out.result.print(lineage_tree(family.name, family.versions(), family.head()))
            return
        self.out.result.print(f"{self.version}: {self.version.schema.instruction}", markup=False)
        self.out.result.print(self.version.snapshot.snapshot.goal_summary, markup=False)

    def _note(self, status: str) -> None:
        self.status = max(self.status, {"admitted": 0, "failed": 1, "refused": 3}[status])


def converse(out: Output, workspace: Workspace, task: str | None, options: CompileOptions, interactive: bool) -> int:
    """Read lines until the end or `quit`. A terminal gets a prompt and a history; piped input gives an exit status."""
    from rpg.core.diagnostics import UsageError

    talk = Conversation(out, workspace, options)
    if task is not None:
        talk.version = find(task, workspace.root)
    history = _history() if interactive else None
    if interactive:
        out.asides.print(HELP)
    try:
        while True:
            try:
                line = _line(talk, interactive)
                if line is None or (line and not talk.take(line)):
                    break
            except KeyboardInterrupt:
                if not interactive:
                    raise
                talk.interrupted()
            except UsageError as error:
                if not interactive:
                    raise
                out.errors.print(str(error), markup=False)
    finally:
        if history is not None:
            _save(history)
    out.document({"sessions": [{"name": None, "turns": talk.turns}]})
    return 0 if interactive else talk.status


def _line(talk: Conversation, interactive: bool) -> str | None:
    """The next line without blanks around it; None at the end of the input. Comments count as blank."""
    if interactive:
        where = str(talk.version) if talk.version else "rpg"
        try:
            text = input(f"{where}> ")
        except EOFError:
            return None
        except KeyboardInterrupt:
            sys.stderr.write("\n")
            return ""
    else:
        text = sys.stdin.readline()
        if not text:
            return None
    line = clean(text).strip()
    return "" if line.startswith("#") else line


def _history() -> Path | None:
    """The file that keeps what was typed; None where this Python has no line editing."""
    try:
        import readline
    except ImportError:
        return None
    state = Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state")
    path = state / "rpg" / "history"
    with suppress(OSError):
        readline.read_history_file(path)
    return path


def _save(path: Path) -> None:
    import readline

    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        readline.set_history_length(1000)
        readline.write_history_file(path)
