"""Figures of blocks with their parts, and frames and phrasings in which they are told."""
