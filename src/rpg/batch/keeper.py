"""Puts results into the workspace in the order of the lists, while the next entries are being built."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor

from rpg.batch.entries import Entry
from rpg.batch.ledger import Ledger, Made, record
from rpg.batch.lines import Line, ended
from rpg.batch.signals import undisturbed
from rpg.batch.work import Result
from rpg.core.diagnostics import UsageError
from rpg.store import Workspace, write_rejected
from rpg.store.adopt import Draft

SAVE_EVERY, SAVE_SHARE = 25, 20
"""Entries between two writings of the ledger, which is written as a whole: so many, or a 20th of it if that is more."""
WRITERS = 4
"""Drafts written at once: each waits for the disk most of the time."""
WAITING = 16
"""Entries that may wait for the disk before the batch waits too."""


class Keeper:
    """Drafts are written by several threads; one thread puts them in place, in order, and keeps the ledger.

    Names therefore do not depend on who was faster.
    """

    def __init__(self, workspace: Workspace, ledger: Ledger, pictures: bool) -> None:
        self.workspace, self.ledger, self.pictures = workspace, ledger, pictures
        self.made: dict[str, Made] = {}
        self.verdicts: dict[str, str] = {}
        self._writers = ThreadPoolExecutor(WRITERS, "writer")
        self._placer = ThreadPoolExecutor(1, "placer")
        self._under_way: deque[Future[Line]] = deque()

    def keep(self, entry: Entry, result: Result) -> Iterator[Line]:
        """Take an entry's result; yields the lines of entries that are done by now, in order."""
        with undisturbed():
            draft = self._writers.submit(Draft, self.workspace, result.tree) if result.status == "admitted" else None
            self._under_way.append(self._placer.submit(self._kept, entry, result, draft))
        while self._under_way and (self._under_way[0].done() or len(self._under_way) > WAITING):
            yield self._under_way.popleft().result()

    def say(self, line: Line) -> Iterator[Line]:
        """Take the line of an entry with which nothing is to be done."""
        said: Future[Line] = Future()
        said.set_result(line)
        self._under_way.append(said)
        while self._under_way and self._under_way[0].done():
            yield self._under_way.popleft().result()

    def finish(self) -> Iterator[Line]:
        """The lines that are still to come; then the ledger is written."""
        while self._under_way:
            yield self._under_way.popleft().result()
        self._placer.submit(self._save).result()

    def close(self) -> None:
        """Wait for what was handed in, whatever became of the batch, and write the ledger."""
        self._placer.shutdown()
        self._writers.shutdown()
        self._save()

    def _kept(self, entry: Entry, result: Result, draft: Future[Draft] | None) -> Line:
        line, made = self._placed(entry, result, draft.result()) if draft else self._not_admitted(entry, result)
        if made is not None:
            self.made[entry.digest] = made
            self.verdicts |= result.verdicts
        if len(self.made) >= max(SAVE_EVERY, len(self.ledger.entries) // SAVE_SHARE):
            self._save()
        return line

    def _not_admitted(self, entry: Entry, result: Result) -> tuple[Line, Made | None]:
        found, rejected = result.diagnostics, ""
        if result.tree:
            directory = write_rejected(self.workspace, result.family, result.tree)
            rejected = directory.relative_to(self.workspace.root).as_posix()
        line = ended(entry, result.status, found, result.turn, rejected)
        if not result.lasting:
            return line, None
        made = Made(status=result.status, title=entry.title, diagnostics=found, turn=result.turn, rejected=rejected)
        return line, made

    def _placed(self, entry: Entry, result: Result, draft: Draft) -> tuple[Line, Made | None]:
        name = entry.name or result.family
        own = self.ledger.versions_of(name) | _versions(self.made, name) if entry.name else frozenset()
        try:
            family = draft.place(name, explicit=entry.name is not None, replaceable=own).family.name
        except UsageError as error:
            return Line(entry, "failed", detail=str(error)), None
        versions = tuple(sorted(draft.made))
        made = Made(status="admitted", title=entry.title, family=family, versions=versions, pictures=self.pictures)
        return Line(entry, "built", family, diagnostics=result.diagnostics), made

    def _save(self) -> None:
        if self.made:
            self.ledger = record(self.workspace, self.made, self.verdicts)
            self.made, self.verdicts = {}, {}


def _versions(made: dict[str, Made], family: str) -> frozenset[str]:
    return frozenset(name for one in made.values() if one.family == family for name in one.versions)
