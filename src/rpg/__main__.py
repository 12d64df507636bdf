"""`python -m rpg`, the same as `rpg`."""

from rpg.cli.main import main

main()
