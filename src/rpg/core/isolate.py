"""Functions run in a child process of their own: for a fresh start, or to hold code that nobody has vouched for.

The child is forked, so it starts in milliseconds with everything imported. It answers with JSON alone, which the parent
reads as data: nothing that a child says is ever executed or unpickled.
"""

from __future__ import annotations

import json
import os
import select
import signal
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from rpg.core.sandbox import Layers, confine

Send = Callable[[Any], None]
"""Hands one JSON-serialisable message to the parent."""
LARGEST_ANSWER = 32_000_000
"""Bytes a child may say before it is cut off."""


@dataclass(frozen=True)
class Limits:
    """What a confined child may use: seconds by the clock, and memory beyond what it was born with."""

    seconds: float = 60.0
    memory_bytes: int = 1_000_000_000


@dataclass(frozen=True)
class Answer:
    """What a child said, and how it ended.

    "done"; "crashed" (an exception that `detail` shows, or a signal); "timeout"; "unconfined": it was to be shut in,
    and no layer of this kernel could, so nothing ran.
    """

    messages: tuple[Any, ...]
    end: Literal["done", "crashed", "timeout", "unconfined"]
    detail: str = ""
    layers: Layers | None = None


def run(work: Callable[[Send], None], *, confined: bool, limits: Limits | None = None) -> Answer:
    """Run `work(send)` in a forked child and collect what it sends."""
    return Child(work, confined=confined, limits=limits or Limits()).answer()


class Child:
    """A child at work. `answer` waits for it; meanwhile the parent can do something else."""

    def __init__(self, work: Callable[[Send], None], *, confined: bool, limits: Limits) -> None:
        self._deadline = time.monotonic() + limits.seconds
        self._over = False
        self._pipe, theirs = os.pipe()
        self._pid = os.fork()
        if self._pid == 0:
            os.close(self._pipe)
            _child(work, theirs, confined, limits)
        os.close(theirs)

    def answer(self) -> Answer:
        """Everything the child said, once it has ended or its time is over. To be asked once."""
        data, late = self._read()
        return _understood(data, late, self._end(kill=late))

    def cancel(self) -> None:
        """End the child where nobody has waited for its answer."""
        if not self._over:
            self._end(kill=True)

    def _end(self, kill: bool) -> int:
        self._over = True
        if kill:
            os.kill(self._pid, signal.SIGKILL)
        _, status = os.waitpid(self._pid, 0)
        os.close(self._pipe)
        return os.waitstatus_to_exitcode(status)

    def _read(self) -> tuple[bytes, bool]:
        chunks: list[bytes] = []
        size = 0
        while size <= LARGEST_ANSWER:
            left = self._deadline - time.monotonic()
            if left <= 0 or not select.select([self._pipe], [], [], left)[0]:
                return b"".join(chunks), True
            chunk = os.read(self._pipe, 1 << 20)
            if not chunk:
                return b"".join(chunks), False
            chunks.append(chunk)
            size += len(chunk)
        return b"".join(chunks), True


def _understood(data: bytes, late: bool, status: int) -> Answer:
    messages: list[Any] = []
    layers: Layers | None = None
    for line in data.split(b"\n")[:-1]:
        try:
            kind, content = json.loads(line)
        except ValueError:
            return Answer(tuple(messages), "crashed", "the process did not answer in its own words", layers)
        if kind == "layers":
            layers = Layers(*content)
            if not layers.enough:
                return Answer((), "unconfined", "", layers)
        elif kind == "error":
            return Answer(tuple(messages), "crashed", str(content), layers)
        elif kind == "done":
            return Answer(tuple(messages), "done", "", layers)
        else:
            messages.append(content)
    if late:
        return Answer(tuple(messages), "timeout", "", layers)
    return Answer(tuple(messages), "crashed", f"the process ended with status {status}", layers)


def _child(work: Callable[[Send], None], pipe: int, confined: bool, limits: Limits) -> None:
    """The child's whole life; it never returns into the parent's code."""
    said = [False]

    def say(kind: str, content: Any) -> None:
        line = json.dumps([kind, content], allow_nan=False).encode() + b"\n"
        while line:
            line = line[os.write(pipe, line) :]

    try:
        if confined:
            _leave_files(pipe)
            layers = confine(int(limits.seconds) + 1, limits.memory_bytes, readable_places())
            say("layers", [layers.rlimits, layers.landlock, layers.seccomp])
            said[0] = not layers.enough
        if not said[0]:
            work(lambda content: say("said", content))
            say("done", None)
    except BaseException:
        try:
            say("error", traceback.format_exc(limit=-8))
        finally:
            os._exit(1)
    finally:
        os._exit(0)


def _leave_files(pipe: int) -> None:
    """Keep no file of the parent's open but the pipe."""
    null = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1, 2):
        os.dup2(null, standard)
    os.closerange(3, pipe)
    os.closerange(pipe + 1, 65536)


def readable_places() -> tuple[Path, ...]:
    """Where Python and what it imports are installed."""
    here = Path(__file__).resolve().parents[2]
    system = tuple(Path(path) for path in ("/usr", "/lib", "/lib64"))
    return tuple(dict.fromkeys((Path(sys.prefix), Path(sys.base_prefix), here, *system)))


def probe() -> Layers:
    """Which layers this machine's kernel can confine a process with."""
    answer = run(lambda send: None, confined=True, limits=Limits(seconds=10))
    return answer.layers or Layers()
