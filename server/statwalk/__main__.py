"""`python -m statwalk`: the command `statwalk`, where it is not on the PATH."""

from statwalk.cli import main

main()
