"""Commands killed at random moments: `python -m tests.steer.kills --times 200` (or `make kills`).

Every command runs as a process of its own and is killed by a signal that it cannot catch; with `--forked` these are
copies of a process that has loaded everything, so that more of the moments fall into the work itself. Half of the
moments are spread evenly over all the time that the command takes; the others follow the moment at which it begins to
write. After each kill `rpg verify` must accept the workspace, and every version that was there, or that the command had
told of, must be there with the very same bytes.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass, field
from io import StringIO
from pathlib import Path

from rpg.cli.main import run
from rpg.core.digest import sha256

WRITING = 0.03
"""Seconds after a sign of writing within which half of the kills fall."""
EACH = 25
"""Kills in one workspace."""
SIGNS = {"compile": 2, "steer": 2, "session": 8}
"""Signs of writing that a command gives: every draft and every version is one."""
SESSION = """\
- name: session {number}
  base: put the red block on the blue block
  edits:
  - add a green block on top
  - loosen the tolerance to {size} mm
  - make the green block white
"""


@dataclass
class Report:
    """What became of so many kills. `begun`: killed after writing had begun; `finished`: versions that came about."""

    kills: int = 0
    outlived: int = 0
    begun: int = 0
    finished: int = 0
    problems: list[str] = field(default_factory=list)


def compiling(place: Path, number: int) -> list[str]:
    return ["compile", "stack the red block on the blue one", "--name", f"task-{number}", "--seed", str(number)]


def steering(place: Path, number: int) -> list[str]:
    if not (place / "tasks" / "tower").is_dir():
        assert told(["compile", "put the red block on the blue block", "--name", "tower", *common(place)])[0] == 0
    return ["steer", "tower", f"loosen the tolerance to {11 + number} mm"]


def session(place: Path, number: int) -> list[str]:
    file = place / "session.yaml"
    file.write_text(SESSION.format(number=number, size=11 + number))
    return ["session", str(file)]


KINDS: dict[str, Callable[[Path, int], list[str]]] = {"compile": compiling, "steer": steering, "session": session}


def common(place: Path) -> list[str]:
    return ["--tasks", str(place / "tasks"), "--no-pictures", "-q"]


def told(arguments: list[str]) -> tuple[int, str]:
    """Exit status and output of a command in this process."""
    said = StringIO()
    with redirect_stdout(said), redirect_stderr(said):
        status = run(arguments)
    return status, said.getvalue()


class Fork:
    """A command in a copy of this process, with as much of the ways of Popen as is needed here."""

    def __init__(self, arguments: list[str]) -> None:
        reading, writing = os.pipe()
        self.status: int | None = None
        self.number = os.fork()
        if self.number == 0:
            os.dup2(writing, 1)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            status = 1
            with suppress(BaseException):
                status = run(arguments)
                sys.stdout.flush()
            os._exit(status)
        os.close(writing)
        self.reading = reading

    def poll(self) -> int | None:
        if self.status is None and os.waitpid(self.number, os.WNOHANG)[0]:
            self.status = 0
        return self.status

    def send_signal(self, sent: int) -> None:
        if self.poll() is None:
            os.kill(self.number, sent)
            os.waitpid(self.number, 0)
            self.status = -sent

    def communicate(self, timeout: float = 0.0) -> tuple[str, None]:
        with os.fdopen(self.reading) as file:
            said = file.read()
        while self.poll() is None:
            time.sleep(0.001)
        return said, None


def started(arguments: list[str], forked: bool = False) -> subprocess.Popen[str] | Fork:
    if forked:
        return Fork(arguments)
    command = [sys.executable, "-m", "rpg", *arguments]
    quiet = {**os.environ, "MUJOCO_GL": "disable"}
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=quiet)


def contents(tasks: Path) -> dict[str, str]:
    """The hash of every file of every version that is in place."""
    return {
        str(path.relative_to(tasks)): sha256(path.read_bytes())
        for path in sorted(tasks.glob("[!.]*/v*/*"))
        if path.is_file()
    }


def written(tasks: Path) -> set[str]:
    """Names that say that somebody writes: drafts and versions."""
    found = _names(tasks)
    return {name for name in found if name.startswith(".new-")} | {
        f"{family}/{name}"
        for family in found
        if not family.startswith(".")
        for name in _names(tasks / family)
        if name.startswith((".new-", "v"))
    }


def _names(directory: Path) -> list[str]:
    """What is in a directory; nothing where it has just gone."""
    with suppress(FileNotFoundError, NotADirectoryError):
        return [path.name for path in directory.iterdir()]
    return []


def duration(kind: str, place: Path, forked: bool) -> float:
    """Seconds that the whole command takes."""
    arguments = [*KINDS[kind](place, -1), *common(place)]
    begun = time.perf_counter()
    started(arguments, forked).communicate(timeout=120)
    return time.perf_counter() - begun


def killed(arguments: list[str], tasks: Path, after: float, signs: int, forked: bool = False) -> tuple[str, bool, bool]:
    """Run a command and kill it so many seconds after its start, or after that many signs of writing: what it said,
    whether writing had begun, and whether it had ended by itself."""
    before, seen = written(tasks), set[str]()
    process = started(arguments, forked)
    while len(seen) < signs and process.poll() is None:
        seen |= written(tasks) - before
        time.sleep(0.0005)
    end = time.perf_counter() + after
    while process.poll() is None and (left := end - time.perf_counter()) > 0.0:
        time.sleep(min(0.001, left))
    outlived = process.poll() is not None
    process.send_signal(signal.SIGKILL)
    said = process.communicate()[0]
    return said, not written(tasks) <= before, outlived


def kills(kind: str, times: int, place: Path, seed: int = 0, forked: bool = False) -> Report:
    """Kill a command so many times, `EACH` times in one workspace and then in the next."""
    rng, report, root = random.Random(f"{kind} {seed}"), Report(), place
    whole = duration(kind, root, forked)
    for number in range(times):
        place = root / str(number // EACH)
        place.mkdir(exist_ok=True)
        tasks = place / "tasks"
        arguments = [*KINDS[kind](place, number), *common(place)]
        before = contents(tasks)
        signs = rng.randint(1, SIGNS[kind]) if number % 2 else 0
        after = rng.uniform(0.0, WRITING if signs else whole)
        said, begun, outlived = killed(arguments, tasks, after, signs, forked)
        report.kills += not outlived
        report.outlived += outlived
        report.begun += begun and not outlived
        now = contents(tasks)
        report.finished += len(versions(now) - versions(before))
        report.problems += [f"{kind} {number}: {fault}" for fault in faults(tasks, before, now, said)]
    return report


def versions(files: dict[str, str]) -> set[str]:
    return {str(Path(file).parent) for file in files}


def faults(tasks: Path, before: dict[str, str], now: dict[str, str], said: str) -> Iterator[str]:
    """What a kill broke."""
    for file in sorted(before):
        if now.get(file) != before[file]:
            yield f"{file} is not what it was"
    for line in said.splitlines(keepends=True):
        if line.endswith("\n") and not (Path(line.strip()) / "snapshot.json").is_file():
            yield f"{line.strip()} was told of and is not there"
    if tasks.is_dir():
        status, text = told(["verify", "--tasks", str(tasks)])
        if status:
            yield text.strip()


def main() -> int:
    """Kill every command in turn and say what became of it."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--times", type=int, default=200)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--forked", action="store_true")
    options.add_argument("kinds", nargs="*", default=sorted(KINDS))
    chosen = options.parse_args()
    failed = 0
    for kind in chosen.kinds:
        with tempfile.TemporaryDirectory() as directory:
            found = kills(kind, chosen.times, Path(directory), chosen.seed, chosen.forked)
        failed += len(found.problems)
        print(
            f"rpg {kind:8} {found.kills} killed ({found.begun} of them while or after writing), {found.outlived} ended "
            f"first; {found.finished} versions finished; {len(found.problems)} problems",
            flush=True,
        )
        for problem in found.problems:
            print(f"    {problem}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
