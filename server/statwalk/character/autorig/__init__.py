"""Gives a mesh a skeleton and a skin (DS4)."""
