"""rpg diff: what differs between two versions."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, NoPictures, Quiet, Tasks, find, load_mujoco

EXAMPLE = "rpg diff red-on-blue@0 red-on-blue@1"
First = Annotated[str, typer.Argument(metavar="A", help="A version: family@0, a directory, the start of a hash.")]
Second = Annotated[str, typer.Argument(metavar="B", help="Another version.")]
Out = Annotated[
    Path | None, typer.Option("--out", metavar="DIR", help="Where pictures of witness states go; drawn only if given.")
]


def run(
    a: First,
    b: Second,
    target: Out = None,
    tasks: Tasks = WORKSPACE,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Show how B differs from A in its assets, its start, its goal and its words; and how the two goals compare on a
    bank of states, with a picture of a state that only one of them accepts."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.cli.steered import print_proof, print_witnesses
    from rpg.steering import compared, draw_witnesses

    out = Output(as_json, quiet)
    first, second = find(a, tasks), find(b, tasks)
    found = compared(first, second)
    pictures = draw_witnesses(found, target) if target is not None and not no_pictures else {}
    out.document(found.document(pictures))
    out.result.print(f"{first} → {second}")
    print_proof(out.result, found.proof)
    print_witnesses(out.result, found.witnesses, pictures)
    if found.witnesses and target is None:
        out.asides.print("--out DIR draws these states")
