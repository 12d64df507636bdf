"""Which block stands where within a structure: orders, ranks, ends, parts."""
