"""rpg validate: a task's gates, run again."""

from __future__ import annotations

from rpg.cli.options import WORKSPACE, Json, Quiet, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg validate red-on-blue"


def run(task: Task, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False) -> None:
    """Run the gates of TASK again on the files as they are, and print what they measure. Exit status 1 if one fails.

    Files that were edited are validated as they stand; code that is not what task.yaml gives runs confined.
    """
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.cli.progress import progress
    from rpg.cli.report import print_diagnostics
    from rpg.cli.summary import gate_table
    from rpg.pipeline import load_program, validate_program
    from rpg.publishing import gate_data

    out = Output(as_json, quiet)
    version = find(task, tasks)
    program = load_program(version.directory, version.schema)
    with progress(out) as listen:
        gates = validate_program(program, listen=listen)
    passed = all(gate.passed for gate in gates)
    found = [diagnostic for gate in gates for diagnostic in gate.diagnostics]
    out.document(
        {
            "status": "passed" if passed else "failed",
            "family": version.family,
            "version": version.number,
            "directory": str(version.directory),
            "gates": [gate_data(gate) for gate in gates],
            "diagnostics": [diagnostic.model_dump(mode="json") for diagnostic in found],
        }
    )
    out.result.print(gate_table(gates))
    if not as_json:
        print_diagnostics(out.errors, found, program.task.instruction)
    out.finish(0 if passed else 1)
