"""Noun phrases: blocks, patches, and lists of them; how many there are, and what they look like."""
