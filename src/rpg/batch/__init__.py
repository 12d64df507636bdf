"""Many instructions and sessions at once: lists in files, warm workers, rebuilt only where needed."""
