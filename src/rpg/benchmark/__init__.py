"""The benchmark of the compiler: suites of instructions, metrics that need no model, a page for human verdicts."""
