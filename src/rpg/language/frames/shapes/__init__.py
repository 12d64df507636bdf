"""Flat figures and staircases told part by part."""
