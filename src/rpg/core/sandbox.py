"""What the kernel can hold a process to: resource limits, Landlock, seccomp. Applied by a process to itself, for good.

Each layer is tried on its own and reported as it took, for older kernels lack some. Linux on x86-64 and arm64;
elsewhere only the resource limits hold.
"""

from __future__ import annotations

import ctypes
import os
import platform
import resource
import struct
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

PR_SET_NO_NEW_PRIVS, PR_SET_SECCOMP, SECCOMP_MODE_FILTER = 38, 22, 2
LANDLOCK_CREATE, LANDLOCK_ADD_RULE, LANDLOCK_RESTRICT = 444, 445, 446
READ_ONLY = 1 << 2 | 1 << 3
"""Landlock's rights to read files and to list directories."""
NETWORK_ABI = 4
"""The first Landlock ABI that can refuse TCP."""
WRITE_FLAGS = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND

# What evaluating Python and stepping MuJoCo needs, opening files for reading included; all else is refused.
_X86_64 = (
    0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 20, 21, 24, 25, 28, 35, 39, 60, 63, 72, 79, 89, 96, 98,
    102, 104, 107, 108, 131, 186, 202, 204, 217, 218, 228, 229, 230, 231, 262, 267, 273, 318, 324, 332, 334,
)  # fmt: skip
_ARM64 = (
    17, 25, 48, 57, 61, 62, 63, 64, 65, 66, 67, 73, 78, 79, 80, 93, 94, 96, 98, 99, 101, 113, 114, 115, 123, 124, 132,
    134, 135, 139, 160, 165, 169, 172, 174, 175, 176, 177, 178, 214, 215, 216, 222, 226, 233, 278, 283, 291, 293,
)  # fmt: skip
SYSCALLS: dict[str, tuple[int, int, tuple[int, ...]]] = {
    "x86_64": (0xC000003E, 257, _X86_64),
    "aarch64": (0xC00000B7, 56, _ARM64),
}
"""Per machine: its audit number, the number of openat, and the numbers of the calls that are let through."""


@dataclass(frozen=True)
class Layers:
    """Which layers hold. `landlock` is the kernel's ABI version, 0 where there is none."""

    rlimits: bool = False
    landlock: int = 0
    seccomp: bool = False

    @property
    def enough(self) -> bool:
        """Whether files and network are out of reach."""
        return self.seccomp or self.landlock >= NETWORK_ABI


def confine(cpu_seconds: int, memory_bytes: int, readable: Iterable[Path] = ()) -> Layers:
    """Shut this process in: no network, no new processes, no writing to files, reading below `readable` alone."""
    limits = _limit(cpu_seconds, memory_bytes)
    if sys.platform != "linux":
        return Layers(limits)
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    return Layers(limits, _landlock(libc, readable), _seccomp(libc))


def _limit(cpu_seconds: int, memory_bytes: int) -> bool:
    """Bound processor time and memory beyond what is mapped now; no files, no core dump."""
    try:
        used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    except OSError:
        used = 0
    wanted = {
        resource.RLIMIT_CPU: cpu_seconds,
        resource.RLIMIT_AS: used + memory_bytes,
        resource.RLIMIT_FSIZE: 0,
        resource.RLIMIT_CORE: 0,
    }
    try:
        for kind, value in wanted.items():
            resource.setrlimit(kind, (value, value))
    except (OSError, ValueError):
        return False
    return True


def _landlock(libc: ctypes.CDLL, readable: Iterable[Path]) -> int:
    """Refuse all of the file system but reading below `readable`, and TCP; the ABI version, 0 where it did not take."""
    abi = int(libc.syscall(LANDLOCK_CREATE, None, ctypes.c_size_t(0), 1))
    if abi < 1:
        return 0
    files = (1 << {1: 13, 2: 14, 3: 15, 4: 15}.get(abi, 16)) - 1
    attributes = struct.pack("QQQ", files, 3, 3)[: 8 if abi < NETWORK_ABI else 16 if abi < 6 else 24]
    ruleset = int(libc.syscall(LANDLOCK_CREATE, attributes, ctypes.c_size_t(len(attributes)), 0))
    if ruleset < 0:
        return 0
    for path in readable:
        _allow_reading(libc, ruleset, path)
    done = int(libc.syscall(LANDLOCK_RESTRICT, ruleset, 0))
    os.close(ruleset)
    return abi if done == 0 else 0


def _allow_reading(libc: ctypes.CDLL, ruleset: int, path: Path) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    rights = READ_ONLY if path.is_dir() else READ_ONLY & ~(1 << 3)
    libc.syscall(LANDLOCK_ADD_RULE, ruleset, 1, struct.pack("=Qi", rights, place), 0)
    os.close(place)


def _seccomp(libc: ctypes.CDLL) -> bool:
    """Refuse every system call that is not on the list; opening files only for reading."""
    known = SYSCALLS.get(platform.machine())
    if known is None:
        return False
    program = _filter(*known)
    code = ctypes.create_string_buffer(b"".join(program))
    header = struct.pack("HxxxxxxP", len(program), ctypes.addressof(code))
    return int(libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, header, 0, 0)) == 0


def _filter(machine: int, openat: int, allowed: tuple[int, ...]) -> list[bytes]:
    """The BPF program over seccomp_data (number at 0, machine at 4, arguments from 16, low word first)."""
    load, equal, at_least, any_bit, give = 0x20, 0x15, 0x35, 0x45, 0x06
    allow, refuse, kill = 0x7FFF0000, 0x00050000 | 1, 0x80000000

    def op(code: int, value: int, yes: int = 0, no: int = 0) -> bytes:
        return struct.pack("HBBI", code, yes, no, value)

    count = len(allowed)
    return [
        op(load, 4),
        op(equal, machine, 1, 0),
        op(give, kill),
        op(load, 0),
        op(at_least, 0x40000000, count + 4, 0),
        op(equal, openat, count + 1, 0),
        *(op(equal, number, count - index + 3, 0) for index, number in enumerate(allowed)),
        # the three ways out: openat (flags are its third argument), refused, allowed
        op(0x05, 2),
        op(load, 32),
        op(any_bit, WRITE_FLAGS, 0, 1),
        op(give, refuse),
        op(give, allow),
    ]
