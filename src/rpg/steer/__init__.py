"""A request about a task -> typed edits -> a new version, with the proof of what it preserved."""
