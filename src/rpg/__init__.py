"""A compiler from sentences to verified MuJoCo manipulation tasks."""

__version__ = "0.1.0"
