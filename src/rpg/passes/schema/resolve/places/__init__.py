"""Where blocks are to each other, to patches and to the table."""
