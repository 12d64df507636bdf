"""What a version preserved: both tasks compared, as data where that will do, else on states."""
