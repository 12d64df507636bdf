"""Words and equations told part by part."""
