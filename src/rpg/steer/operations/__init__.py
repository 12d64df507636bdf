"""What each request does to a draft, one family a file."""
