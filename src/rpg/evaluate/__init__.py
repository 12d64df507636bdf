"""How well policies and recorded states do at tasks."""
