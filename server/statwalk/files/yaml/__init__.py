"""Strict YAML with line numbers, for files that come from anywhere."""
