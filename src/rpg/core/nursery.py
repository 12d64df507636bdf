"""A process kept at hand to fork fresh children from.

Forking a large process costs it milliseconds, and slows it down afterwards while pages are copied. A nursery is forked
once; it then forks a child for every request, on another core, at no cost to the process that asks.
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import threading
import time
from collections.abc import Callable
from typing import Any

Work = Callable[[Any], Any]
"""What a child does: plain data in, plain data out, both as JSON."""


class Gone(Exception):
    """The nursery has ended, or did not answer in time."""


class Nursery:
    """Runs `work` on requests, each in a process that has done nothing else before. Safe to use from threads."""

    def __init__(self, work: Work) -> None:
        requests, self._requests = os.pipe()
        self._answers, answers = os.pipe()
        if os.fork() == 0:
            os.close(self._requests)
            os.close(self._answers)
            _serve(work, requests, answers)
        os.close(requests)
        os.close(answers)
        self._lock = threading.Lock()
        self._asked = 0
        self._rest = b""
        self._known: dict[int, Any] = {}
        self._dropped: set[int] = set()

    def ask(self, request: Any) -> int:
        """Start a child on `request`; the number to ask for its answer with. Raises Gone."""
        with self._lock:
            self._asked += 1
            line = json.dumps([self._asked, request]).encode() + b"\n"
            try:
                while line:
                    line = line[os.write(self._requests, line) :]
            except OSError as error:
                raise Gone from error
            return self._asked

    def answer(self, number: int, seconds: float) -> Any:
        """What the child answered; None where it broke down. Raises Gone."""
        deadline = time.monotonic() + seconds
        with self._lock:
            while number not in self._known:
                self._read(deadline - time.monotonic())
            return self._known.pop(number)

    def drop(self, number: int) -> None:
        """Nobody waits for this answer any more."""
        with self._lock:
            if self._known.pop(number, None) is None:
                self._dropped.add(number)

    def _read(self, seconds: float) -> None:
        if seconds <= 0 or not select.select([self._answers], [], [], seconds)[0]:
            raise Gone
        chunk = os.read(self._answers, 1 << 16)
        if not chunk:
            raise Gone
        *lines, self._rest = (self._rest + chunk).split(b"\n")
        for line in lines:
            number, answer = json.loads(line)
            if number in self._dropped:
                self._dropped.discard(number)
            else:
                self._known[number] = answer


def _serve(work: Work, requests: int, answers: int) -> None:
    """The nursery's whole life: until the process that made it is gone."""
    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        null = os.open(os.devnull, os.O_RDWR)
        for standard in (0, 1, 2):
            os.dup2(null, standard)
        gc.freeze()
        with os.fdopen(requests, "rb") as lines:
            for line in lines:
                number, request = json.loads(line)
                child = os.fork()
                if child == 0:
                    _answer(work, number, request, answers)
                _, status = os.waitpid(child, 0)
                if status != 0:
                    os.write(answers, json.dumps([number, None]).encode() + b"\n")
    finally:
        os._exit(0)


def _answer(work: Work, number: int, request: Any, answers: int) -> None:
    """A child's whole life."""
    try:
        gc.disable()  # it would touch, and so copy, the pages that are shared with the nursery
        line = json.dumps([number, work(request)], allow_nan=False).encode() + b"\n"
        while line:
            line = line[os.write(answers, line) :]
    except BaseException:
        os._exit(1)
    finally:
        os._exit(0)
