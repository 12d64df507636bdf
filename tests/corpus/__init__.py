"""The instruction corpus: entries, the states they name, and their judgement."""
