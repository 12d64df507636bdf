"""What is built: towers, lines, grids, figures, groups, words, equations."""
