"""The grammar: tokens -> meanings, every reading of every stretch of words."""
