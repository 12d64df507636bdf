"""A session on a terminal: typed edits, interrupts, the end of the input, and a history that is kept."""

from __future__ import annotations

import os
import pty
import select
import sys
import time
from pathlib import Path

PATIENCE = 120.0
"""Seconds that an answer may take on a busy machine."""


class Terminal:
    """A process with a terminal of its own."""

    def __init__(self, arguments: list[str], state: Path) -> None:
        environment = {**os.environ, "MUJOCO_GL": "disable", "XDG_STATE_HOME": str(state), "TERM": "dumb"}
        self.left = b""
        self.number, self.file = pty.fork()
        if self.number == 0:
            os.execve(sys.executable, [sys.executable, "-m", "rpg", *arguments], environment)

    def until(self, wanted: str) -> str:
        """What is shown up to and with `wanted`. What came after it in the same breath is for the next to look at."""
        shown, end = self.left, time.monotonic() + PATIENCE
        while wanted.encode() not in shown:
            assert time.monotonic() < end, shown.decode(errors="replace")
            if select.select([self.file], [], [], 0.1)[0]:
                shown += os.read(self.file, 65536)
        before, found, self.left = shown.partition(wanted.encode())
        return (before + found).decode(errors="replace")

    def prompt(self, wanted: str) -> str:
        """What is shown up to a prompt, once the process waits for what is typed: an interrupt that comes between its
        prompt and its waiting would be noticed only at the next key."""
        shown, end, asleep = self.until(f"{wanted}> "), time.monotonic() + PATIENCE, 0
        while asleep < 3:
            assert time.monotonic() < end, shown
            time.sleep(0.02)
            asleep = asleep + 1 if self._sleeps() else 0
        return shown

    def _sleeps(self) -> bool:
        status = Path(f"/proc/{self.number}/stat")
        return not status.exists() or status.read_text().rpartition(") ")[2].startswith("S")

    def type(self, text: str) -> None:
        os.write(self.file, text.encode())

    def status(self) -> int:
        """Exit status, once the process has ended by itself."""
        return os.waitstatus_to_exitcode(os.waitpid(self.number, 0)[1])


def test_a_typed_session(tmp_path: Path) -> None:
    terminal = Terminal(["session", "--no-pictures", "--tasks", str(tmp_path / "tasks")], tmp_path)
    assert "quit" in terminal.prompt("rpg")
    terminal.type("put the red block on the blue block\n")
    assert "must be on the blue" in terminal.prompt("red-on-blue@0")
    terminal.type("remove the pur\x03")
    terminal.prompt("red-on-blue@0")
    terminal.type("remove the purple one\n")
    assert "no such block" in terminal.prompt("red-on-blue@0")
    terminal.type("add a green block on top\n")
    assert "EXTEND" in terminal.prompt("red-on-blue@1")
    terminal.type("undo\n")
    assert "back at" in terminal.prompt("red-on-blue@0")
    terminal.type("log\n")
    assert "HEAD" in terminal.prompt("red-on-blue@0")
    terminal.type("\x04")
    assert terminal.status() == 0
    typed = (tmp_path / "rpg" / "history").read_text().splitlines()
    assert typed[-3:] == ["add a green block on top", "undo", "log"]


def test_an_interrupt_gives_up_one_line_alone(tmp_path: Path) -> None:
    terminal = Terminal(["session", "--no-pictures", "--tasks", str(tmp_path / "tasks")], tmp_path)
    terminal.prompt("rpg")
    terminal.type("put the red block on the blue block\n")
    terminal.prompt("red-on-blue@0")
    terminal.type("new make a pyramid of blue blocks with a 4x4 base\n")
    terminal.until("4x4 base\r\n")
    time.sleep(0.1)
    terminal.type("\x03")
    shown = terminal.prompt("")
    assert "interrupted; red-on-blue@0 is current" in shown or "pyramid" in shown
    terminal.type("log\n")
    terminal.until("HEAD")
    terminal.prompt("")
    terminal.type("quit\n")
    assert terminal.status() == 0
