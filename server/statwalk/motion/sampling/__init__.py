"""Poses, pace and root motion at a time, compiled, from the tables of motions."""
