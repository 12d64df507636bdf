"""Frozen data that crosses passes: assets, goal expressions, initial states, the task schema."""
