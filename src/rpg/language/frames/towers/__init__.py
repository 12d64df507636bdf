"""Towers told part by part."""
