"""The machine as its file defines it, with line numbers, and the state table as text."""
