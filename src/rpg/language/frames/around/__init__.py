"""What is told around a figure: distractors, turns, sizes, what stands beside it, the start, the end."""
