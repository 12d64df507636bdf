"""What families of composed sentences share: a table of cells on which said relations are tried."""
