"""Sentences: commands, states, descriptions, notes; and chains of them."""
