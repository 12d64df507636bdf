"""Groups told part by part."""
