"""Towers, lines, grids, figures, words, equations: their nouns, sizes, makeup, orders and parts."""
