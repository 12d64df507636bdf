"""Blocks as people in a story: how they are, what they do there, and what they wear, in plain words."""
