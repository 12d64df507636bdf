"""What a command's exit code says; 0 is success."""

NO, USAGE, REFUSED, UNAVAILABLE, INTERRUPTED = 1, 2, 3, 4, 130
"""The answer is no; wrong usage; refused with diagnostics; something is not installed or not there; Ctrl-C."""
