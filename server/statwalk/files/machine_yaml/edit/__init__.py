"""Changes a machine's text by what it means: cells, states, events …; every other letter stays."""
