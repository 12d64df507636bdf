"""Read sentences from templates and compare with what they mean: `python -m tests.corpus.fuzz [COUNT] [FIRST_SEED]`."""

from __future__ import annotations

import sys
from collections import Counter
from typing import Literal

from rpg.blocks.equivalence import equivalent
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.templates import Case, case
from tests.english.schemas import begun

Outcome = Literal["right", "refused", "wrong", "crash"]


def outcome(one: Case) -> tuple[Outcome, str]:
    """How a sentence is read, and what was made of it where that is not right."""
    try:
        schema, diagnostics = BuiltinFrontEnd().read(one.text)
    except Exception as error:  # a crash is an outcome of its own, and the report must go on
        return "crash", repr(error)[:200]
    if schema is None:
        return "refused", "; ".join(d.message for d in diagnostics)
    for goal in one.goals:
        wanted = begun(TaskSchema(name="wanted", instruction=one.text, assets=one.assets, goal=goal))
        if equivalent(wanted, schema):
            return "right", ""
    return "wrong", str(schema.goal.model_dump(exclude_defaults=True, exclude={"span"}))


def main(count: int, first: int) -> None:
    """Print misreadings, and the templates that are refused with an example each."""
    totals: Counter[str] = Counter()
    by_template: Counter[tuple[str, str]] = Counter()
    examples: dict[str, str] = {}
    for seed in range(first, first + count):
        one = case(seed)
        found, why = outcome(one)
        totals[found] += 1
        by_template[one.template, found] += 1
        if found in ("wrong", "crash"):
            print(f"{found}: {one.text}\n       {why}")
        elif found == "refused":
            examples.setdefault(one.template, f"{one.text!r}: {why}")
    for template, example in examples.items():
        print(
            f"refused {by_template[template, 'refused']}, right {by_template[template, 'right']}: {template}",
            example,
            sep="\n       ",
        )
    print(dict(totals))


if __name__ == "__main__":
    numbers = [int(argument) for argument in sys.argv[1:]]
    main(numbers[0] if numbers else 400, numbers[1] if len(numbers) > 1 else 0)
