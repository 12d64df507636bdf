"""Which blocks and patches the phrases speak of: those there are, and those that they bring in."""
