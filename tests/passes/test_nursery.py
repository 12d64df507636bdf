"""Children forked from a process at hand: each one fresh, none in the way of another."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from rpg.core.nursery import Gone, Nursery

STATE: list[int] = []


def work(request: Any) -> Any:
    STATE.append(1)
    match request:
        case "state":
            return [len(STATE), os.getpid()]
        case "crash":
            raise ValueError
        case "die":
            os.kill(os.getpid(), signal.SIGKILL)
        case ["sleep", seconds]:
            time.sleep(seconds)
    return request


@pytest.fixture(scope="module")
def nursery() -> Nursery:
    return Nursery(work)


def test_data_goes_in_and_comes_out(nursery: Nursery) -> None:
    for request in ({"a": [1, None, 2.5]}, "x" * 300_000, []):
        assert nursery.answer(nursery.ask(request), 20) == request


def test_every_request_finds_the_process_as_it_was(nursery: Nursery) -> None:
    seen = [nursery.answer(nursery.ask("state"), 20) for _ in range(3)]
    assert [count for count, _ in seen] == [1, 1, 1]
    assert len({process for _, process in seen} | {os.getpid()}) == 4
    assert STATE == []


def test_answers_may_be_asked_for_in_any_order_or_not_at_all(nursery: Nursery) -> None:
    first, second, third = (nursery.ask(number) for number in (10, 20, 30))
    nursery.drop(second)
    assert nursery.answer(third, 20) == 30
    assert nursery.answer(first, 20) == 10
    assert nursery.answer(nursery.ask(40), 20) == 40


@pytest.mark.parametrize("request_", ["crash", "die"])
def test_a_child_that_breaks_down_answers_nothing_and_harms_nobody(nursery: Nursery, request_: str) -> None:
    assert nursery.answer(nursery.ask(request_), 20) is None
    assert nursery.answer(nursery.ask("after"), 20) == "after"


def test_patience_ends(nursery: Nursery) -> None:
    slow = nursery.ask(["sleep", 0.5])
    with pytest.raises(Gone):
        nursery.answer(slow, 0.05)
    assert nursery.answer(slow, 20) == ["sleep", 0.5]


def test_threads_do_not_take_each_others_answers(nursery: Nursery) -> None:
    found: dict[int, Any] = {}

    def ask(value: int) -> None:
        found[value] = nursery.answer(nursery.ask(value), 20)

    threads = [threading.Thread(target=ask, args=(value,)) for value in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {value: value for value in range(8)}


SCRIPT = """
import os, sys
from rpg.core.nursery import Nursery
nursery = Nursery(lambda request: os.getppid())
print(nursery.answer(nursery.ask(None), 20), flush=True)
"""


def test_a_nursery_ends_with_the_process_that_made_it() -> None:
    done = subprocess.run([sys.executable, "-c", SCRIPT], capture_output=True, text=True, check=True, timeout=60)
    process = int(done.stdout)
    for _ in range(100):
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            return
        if (status := _status(process)) == "Z":
            return
        time.sleep(0.05)
    raise AssertionError(f"still there: {status}")


def _status(process: int) -> str:
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return "Z"
