"""`python -m statwalk.cli` is `statwalk`."""

from statwalk.cli import main

main()
