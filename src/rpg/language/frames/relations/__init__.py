"""Relations between blocks, told statement by statement."""
