"""Goals as a whole: joined and denied, contradictions among them, put in order."""
