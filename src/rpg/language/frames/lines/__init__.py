"""Rows, lines and columns told part by part."""
