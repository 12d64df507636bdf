"""The reference tasks: ten admitted tasks to learn from, looked up by what they are about.

`python -m rpg.library [DIRECTORY]` builds them anew from their index; with `--check` it only says what differs.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import yaml

from rpg.core.diagnostics import Refusal, UsageError
from rpg.ir.base import Record
from rpg.pipeline import CompileOptions, compile_instruction
from rpg.store import dump_schema

INDEX = "index.yaml"


class Reference(Record):
    """A task of the library and its four attributes for retrieval."""

    name: str
    instruction: str
    asset: tuple[Literal["ColoredCube", "SemanticCube", "GoalPatch"], ...]
    reasoning: Literal["spatial", "semantic"]
    complexity: Literal["atomic", "compositional", "hierarchical"]
    action: Literal["stacking", "arranging", "pick-and-place", "rotating"]

    @property
    def family(self) -> str:
        """`StackBlocks` -> `stack-blocks`."""
        return re.sub(r"(?<!^)(?=[A-Z])", "-", self.name).lower()


def place() -> Path:
    """Where the library is: beside the sources of a checkout, else inside of the installed package."""
    package = Path(__file__).resolve().parent
    return next(path for path in (package.parents[1] / "library", package / "data" / "library") if path.is_dir())


def references(directory: Path) -> tuple[Reference, ...]:
    """The entries of a library's index, in its order."""
    entries = yaml.safe_load((directory / INDEX).read_text(encoding="utf-8"))
    return tuple(Reference.model_validate(entry) for entry in entries)


def build(reference: Reference) -> dict[str, str]:
    """The files of a reference task. Raises Refusal where its instruction is not admitted."""
    outcome = compile_instruction(reference.instruction, CompileOptions(name=reference.family))
    if outcome.status != "admitted" or outcome.program is None:
        raise Refusal(outcome.diagnostics)
    program = outcome.program
    return {
        "task.yaml": dump_schema(program.task),
        "code.py": program.code,
        "goal_state_code.py": program.goal_code,
        "validation.log": outcome.log,
    }


def built(directory: Path) -> Iterator[tuple[Path, str]]:
    """Every file of the library as it should be."""
    for reference in references(directory):
        for name, text in build(reference).items():
            yield directory / reference.name / name, text


def main(arguments: list[str]) -> int:
    """Write the library, or compare it. Exit status 1 where it differs."""
    check = "--check" in arguments
    folders = [Path(argument) for argument in arguments if not argument.startswith("--")]
    directory = folders[0] if folders else place()
    if not (directory / INDEX).is_file():
        raise UsageError(f"{directory} has no {INDEX}")
    differing = 0
    for path, text in built(directory):
        if path.is_file() and path.read_bytes() == text.encode():
            continue
        differing += 1
        print(f"{'differs' if check else 'written'}: {path.relative_to(directory)}")
        if not check:
            path.parent.mkdir(exist_ok=True)
            path.write_bytes(text.encode())
    return 1 if check and differing else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (Refusal, UsageError) as problem:
        sys.exit(f"error: {problem}")
