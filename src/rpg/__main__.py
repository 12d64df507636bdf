"""`python -m rpg`, the same as `rpg`."""

from rpg.cli import start

start()
