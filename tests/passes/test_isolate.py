"""Confined processes: what hostile code must not be able to do, and that honest code still runs."""

from __future__ import annotations

import os
import socket
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rpg.core.isolate import Answer, Child, Limits, probe, run
from rpg.core.sandbox import Layers

needs_layers = pytest.mark.skipif(not probe().enough, reason="this kernel cannot confine a process")


def confined(action: Callable[[], Any], seconds: float = 20.0) -> Answer:
    return run(lambda send: send(repr(action())), confined=True, limits=Limits(seconds=seconds))


def test_messages_come_back_in_order_as_data() -> None:
    def work(send: Callable[[Any], None]) -> None:
        send({"a": [1, 2.5, None]})
        send("second")

    answer = run(work, confined=False)
    assert answer == Answer(({"a": [1, 2.5, None]}, "second"), "done")


def test_a_crash_is_told_with_its_exception() -> None:
    answer = run(lambda send: send(1 // 0), confined=False)
    assert answer.end == "crashed"
    assert "ZeroDivisionError" in answer.detail


@needs_layers
@pytest.mark.parametrize(
    "action",
    [
        lambda: socket.socket(socket.AF_INET, socket.SOCK_STREAM),
        lambda: socket.socket(socket.AF_INET, socket.SOCK_DGRAM),
        lambda: socket.socketpair(),
        lambda: subprocess.run(["/bin/true"], check=True),
        lambda: os.fork(),
        lambda: os.execv("/bin/true", ["true"]),
        lambda: os.kill(os.getppid(), 0),
        lambda: list(Path("/proc/1").iterdir()),
        lambda: Path("/etc/hostname").read_text(),
        lambda: Path("/tmp/made-by-a-confined-process").mkdir(),
        lambda: Path(__file__).unlink(),
        lambda: Path(__file__).rename(__file__ + "x"),
        lambda: Path(__file__).chmod(0o777),
        lambda: Path("/tmp/made-by-a-confined-process").symlink_to("/etc"),
    ],
)
def test_forbidden_actions_raise_inside(action: Callable[[], Any]) -> None:
    answer = confined(action)
    assert answer.end == "crashed"
    assert "Error" in answer.detail


@needs_layers
def test_no_shell_runs(tmp_path: Path) -> None:
    target = tmp_path / "made"
    answer = confined(lambda: os.system(f"touch {target}"))
    assert not target.exists()
    assert answer.end == "crashed" or answer.messages != ("0",)


@needs_layers
@pytest.mark.parametrize("mode", ["w", "a", "r+", "x"])
def test_no_file_is_written(tmp_path: Path, mode: str) -> None:
    target = tmp_path / "kept"
    if mode != "x":
        target.write_text("before")
    answer = confined(lambda: target.open(mode).write("after"))
    assert answer.end == "crashed"
    assert not target.exists() if mode == "x" else target.read_text() == "before"


@needs_layers
def test_files_of_the_parent_are_closed(tmp_path: Path) -> None:
    with (tmp_path / "open").open("w") as file:
        answer = confined(lambda: os.write(file.fileno(), b"through the back door"))
    assert answer.end == "crashed"
    assert (tmp_path / "open").read_text() == ""


@needs_layers
def test_an_endless_loop_is_ended() -> None:
    def endless() -> None:
        while True:
            pass

    begun = time.monotonic()
    assert confined(endless, seconds=0.5).end == "timeout"
    assert time.monotonic() - begun < 5


@needs_layers
def test_an_endless_sleep_is_ended() -> None:
    assert confined(lambda: time.sleep(100), seconds=0.3).end == "timeout"


@needs_layers
def test_a_memory_bomb_stays_small() -> None:
    answer = confined(lambda: bytearray(8_000_000_000))
    assert answer.end == "crashed"
    assert "MemoryError" in answer.detail


@needs_layers
def test_a_flood_of_messages_is_cut_off() -> None:
    def flood(send: Callable[[Any], None]) -> None:
        while True:
            send("x" * 1_000_000)

    assert run(flood, confined=True, limits=Limits(seconds=20)).end == "timeout"


@needs_layers
def test_installed_modules_can_still_be_imported() -> None:
    def honest() -> int:
        import wave

        return wave.WAVE_FORMAT_PCM

    assert confined(honest).messages == ("1",)


def test_nothing_runs_where_no_layer_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rpg.core.isolate.confine", lambda *_: Layers(rlimits=True))
    answer = confined(lambda: "ran")
    assert answer.end == "unconfined"
    assert answer.messages == ()


def test_words_that_are_not_ours_are_not_believed() -> None:
    def forged(_: Callable[[Any], None]) -> None:
        for number in range(3, 256):
            try:
                os.write(number, b"not json\n")
            except OSError:
                continue

    answer = Child(forged, confined=True, limits=Limits(seconds=10)).answer()
    assert answer.end == "crashed"


def test_a_cancelled_child_leaves_nothing_behind() -> None:
    child = Child(lambda send: time.sleep(60), confined=False, limits=Limits())
    child.cancel()
    child.cancel()
    with pytest.raises(ChildProcessError):
        os.waitpid(child._pid, os.WNOHANG)
