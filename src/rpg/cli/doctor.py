"""rpg doctor: what works on this machine, and what to install for the rest."""

from __future__ import annotations

from rpg.cli.options import Json, Quiet

EXAMPLE = "rpg doctor"


def run(as_json: Json = False, quiet: Quiet = False) -> None:
    """Say what works on this machine: MuJoCo, graphics, the sandbox, model keys, robot assets."""
    from rich.text import Text

    from rpg.cli.health import findings
    from rpg.cli.output import Output

    out = Output(as_json, quiet)
    found = findings()
    out.document(
        {finding.name: {"ok": finding.ok, "detail": finding.detail, "hint": finding.hint} for finding in found}
    )
    for finding in found:
        sign = ("✓ ", "green") if finding.ok else ("– ", "yellow")
        out.result.print(Text.assemble(sign, (f"{finding.name:<9} ", "bold"), finding.detail), soft_wrap=True)
        if finding.hint:
            out.result.print(f"            {finding.hint}", style="dim", soft_wrap=True)
    out.finish(0 if all(finding.ok for finding in found if finding.needed) else 4)
