"""Measures the transitions of a machine on its character: what a table says is played, and looked at."""
