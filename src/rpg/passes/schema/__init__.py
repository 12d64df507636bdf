"""Pass 1: from an instruction to a task schema."""
