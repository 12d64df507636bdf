"""Grids, walls, pyramids and cubes of cubes told part by part."""
