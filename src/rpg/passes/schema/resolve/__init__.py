"""From meanings to a task: which objects they speak of, and the goal that they state."""
