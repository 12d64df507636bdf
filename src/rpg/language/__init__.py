"""The English of blocks: its words, the grammar of phrases and clauses, and what they mean apart from any task."""
