"""Where things are: relations, sides, regions, distances, one on the other."""
