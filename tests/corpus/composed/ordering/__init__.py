"""Rows, columns and towers told by their order, by what they spell or compute, and cubes that are turned."""
