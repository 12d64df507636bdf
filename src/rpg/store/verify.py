"""Whether a workspace can be trusted: hashes, lineage, HEAD, and that task.yaml still gives the code beside it."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator
from pathlib import Path

from rpg.core.diagnostics import Diagnostic, UsageError
from rpg.core.digest import sha256
from rpg.store.layout import HEAD, VERSION_NAME, Family, Version, version_at, version_name
from rpg.store.records import CODE, GOAL_CODE, HASHED, PICTURES, SNAPSHOT, SOURCE, Snapshot

Lowered = Callable[[Version], bool]
"""Whether the code of a version is what the code generator makes of its task.yaml."""
Replayed = Callable[[Version, Version], bool]
"""Whether the edits that a version records, applied to its parent (given second), lead to its task.yaml."""
_PNG = b"\x89PNG\r\n\x1a\n"


def verify_family(
    family: Family, lowered: Lowered | None = None, replayed: Replayed | None = None
) -> tuple[Diagnostic, ...]:
    """Everything that is wrong with a family; `lowered` generates code anew to compare it, `replayed` applies edits."""
    found: list[Diagnostic] = []
    readable: list[Version] = []
    whole: set[str] = set()
    for directory in family.directories():
        problems = tuple(verify_directory(directory, lowered))
        found.extend(problems)
        version = version_at(directory)
        if version and not any(problem.code == "snapshot-unreadable" for problem in problems):
            readable.append(version)
            whole |= set() if problems else {version.hash}
    found.extend(_lineage(readable))
    parents = {version.hash: version for version in readable if version.hash in whole}
    for version in readable:
        found.extend(_origin(version))
        if version.hash in whole and version.snapshot.parent in parents:
            found.extend(_descent(version, parents[version.snapshot.parent], replayed))
    found.extend(_head(family))
    return tuple(found)


def verify_version(version: Version, lowered: Lowered | None = None) -> tuple[Diagnostic, ...]:
    """Everything that is wrong with one version, its ancestors left aside."""
    return tuple(verify_directory(version.directory, lowered))


def verify_lineage(version: Version) -> tuple[Diagnostic, ...]:
    """What is wrong with one version or, if nothing is, with the nearest of its ancestors that is not sound."""
    directories = Family(version.directory.parent).directories()
    seen: set[Path] = set()
    at: Path | None = version.directory
    while at is not None and at not in seen:
        seen.add(at)
        problems = tuple(verify_directory(at))
        current = version_at(at)
        if problems or current is None:
            return problems
        problems = tuple(_origin(current))
        parent = current.snapshot.parent
        at = next((path for path in directories if parent and path.name.endswith(f"-{parent[:7]}")), None)
        if at is None:
            problems += tuple(_lineage([current])) if parent or current.number else ()
        if problems:
            return problems
    return ()


def verify_directory(directory: Path, lowered: Lowered | None = None) -> Iterator[Diagnostic]:
    """What is wrong with the version that `directory` should hold."""
    present = [name for name in (*HASHED, SNAPSHOT) if (directory / name).is_file()]
    for name in (*HASHED, SNAPSHOT):
        if name not in present:
            yield _problem("version-incomplete", directory, f"{name} is missing")
    version = version_at(directory)
    if version is None:
        return
    try:
        snapshot = version.snapshot
    except UsageError as error:
        yield _problem("snapshot-unreadable", directory, str(error).removeprefix(f"{directory}/"))
        return
    yield from _snapshot(version, snapshot)
    changed = False
    for name in sorted(set(present) - {SNAPSHOT}):
        if sha256((directory / name).read_bytes()) != snapshot.files.get(name):
            changed = True
            yield _problem("file-changed", directory, f"{name} differs from what was written", file=name)
    yield from _pictures(directory)
    if lowered and not changed and snapshot.backend == "lower" and not set(HASHED) - set(present):
        yield from _code(version, lowered)


def _snapshot(version: Version, snapshot: Snapshot) -> Iterator[Diagnostic]:
    """The snapshot against its own hash, its directory's name, and the bytes it was written as."""
    directory = version.directory
    written = (directory / SNAPSHOT).read_bytes()
    if snapshot.expected_hash() != snapshot.hash:
        yield _problem("snapshot-changed", directory, f"{SNAPSHOT} does not have the hash that it states")
    elif version_name(snapshot.snapshot.version_id, snapshot.hash) != directory.name:
        right = version_name(snapshot.snapshot.version_id, snapshot.hash)
        yield _problem("snapshot-changed", directory, f"by its snapshot this directory is {right}")
    elif snapshot.text().encode() != written:
        yield _problem("snapshot-changed", directory, f"{SNAPSHOT} is not laid out as it was written")
    if snapshot.files.get(CODE) != snapshot.snapshot.code_hash:
        yield _problem("snapshot-changed", directory, "code_hash is not the hash of code.py")
    for name in sorted(set(HASHED) ^ set(snapshot.files)):
        yield _problem("snapshot-changed", directory, f"{SNAPSHOT} does not record just the files of a version: {name}")


def _pictures(directory: Path) -> Iterator[Diagnostic]:
    for name in PICTURES:
        path = directory / name
        if path.is_file() and not _sound_png(path.read_bytes()):
            yield _problem("picture-damaged", directory, f"{name} is damaged", file=name)


def _sound_png(data: bytes) -> bool:
    """Whether every chunk of a PNG has its checksum and nothing follows the last one."""
    if not data.startswith(_PNG):
        return False
    at = len(_PNG)
    while at + 12 <= len(data):
        length = int.from_bytes(data[at : at + 4])
        end = at + 8 + length
        if end + 4 > len(data) or zlib.crc32(data[at + 4 : end]) != int.from_bytes(data[end : end + 4]):
            return False
        if data[at + 4 : at + 8] == b"IEND":
            return end + 4 == len(data)
        at = end + 4
    return False


def _code(version: Version, lowered: Lowered) -> Iterator[Diagnostic]:
    try:
        same = lowered(version)
    except UsageError as error:
        yield _problem("schema-unreadable", version.directory, str(error))
        return
    if not same:
        yield _problem("does-not-lower", version.directory, f"{SOURCE} gives other code than {CODE} and {GOAL_CODE}")


def _lineage(versions: list[Version]) -> Iterator[Diagnostic]:
    hashes = {version.hash for version in versions}
    numbers: dict[int, Version] = {}
    for version in versions:
        parent = version.snapshot.parent
        if parent and parent not in hashes:
            yield _problem(
                "parent-missing", version.directory, f"no version of the family has its parent's hash {parent[:7]}"
            )
        if not parent and version.number != 0:
            yield _problem("parent-missing", version.directory, "it names no parent, and only version 0 has none")
        if version.number in numbers:
            other = numbers[version.number].directory.name
            yield _problem("number-clash", version.directory, f"{other} has the same number")
        numbers[version.number] = version


def _origin(version: Version) -> Iterator[Diagnostic]:
    """An origin that nothing in the store speaks for: what a model answered is not recorded."""
    if version.snapshot.backend != "lower":
        message = f"{SNAPSHOT} says that a model wrote {CODE}, and nothing here records what a model answered"
        yield _problem("origin-unsupported", version.directory, message)


def _descent(version: Version, parent: Version, replayed: Replayed | None) -> Iterator[Diagnostic]:
    """What a version says of how it came from its parent, against the two of them."""
    steering = version.snapshot.steering
    assert steering is not None
    if steering.reference not in (None, parent.number):
        message = f"it says that it was made from version {steering.reference}, and its parent is {parent.number}"
        yield _problem("does-not-replay", version.directory, message)
    elif replayed and not replayed(version, parent):
        message = f"its edits do not lead from version {parent.number} to its {SOURCE}"
        yield _problem("does-not-replay", version.directory, message)


def _head(family: Family) -> Iterator[Diagnostic]:
    path = family.directory / HEAD
    name = family.head_name()
    whole = path.is_file() and path.read_bytes() == f"{name}\n".encode()
    if not whole or not VERSION_NAME.fullmatch(name) or version_at(family.directory / name) is None:
        said = f"HEAD says {name!r}, not the directory of a version" if path.is_file() else "HEAD is missing"
        known = [version.number for version in family.versions()]
        hint = f"rpg checkout {family.name} {known[-1]}" if known else None
        yield Diagnostic(
            code="head-broken",
            message=f"{family.name}: {said}",
            hint=hint,
            facts={"path": f"{family.name}/{HEAD}"},
            origin="store",
        )


def _problem(code: str, directory: Path, message: str, file: str | None = None) -> Diagnostic:
    place = f"{directory.parent.name}/{directory.name}"
    facts = {"path": f"{place}/{file}" if file else place}
    return Diagnostic(code=code, message=f"{place}: {message}", facts=facts, origin="store")
