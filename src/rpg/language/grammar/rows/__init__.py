"""Sentences in the words of others: rows of what is looked for and what is said instead.

`turned` applies rows, `formal` says which: those of every sentence, and those of one that cannot be read as it stands.
A row loses nothing that the sentence asks for; what the grammar can read by a rule is no row.
"""
