"""What people wish who were told no more than "type what the robot should do with the cubes and patches".

`python -m tests.corpus.wishes building` (or `building2`) prints what each is read as, in English, or why it is refused;
what the lines mean is noted nowhere. `aside` and `aside2` are kept for counting alone.
"""

from __future__ import annotations

import sys
from pathlib import Path

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd

FOLDER = Path(__file__).parent / "wishes"


def main() -> None:
    """Print every reading of `building`, and how many of either list are read."""
    name = sys.argv[1] if len(sys.argv) > 1 else "building"
    wishes = (FOLDER / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    read = 0
    for wish in wishes:
        schema, diagnostics = BuiltinFrontEnd().read(wish)
        read += schema is not None
        if name.startswith("building"):
            said = describe(schema) if schema else "; ".join(f"{d.code}: {d.message}" for d in diagnostics)
            print(f"{wish}\n  {'' if schema else 'refused: '}{said}")
    print(f"{read} of {len(wishes)} are read")


if __name__ == "__main__":
    main()
