"""The machine as its file says it: definitions with line numbers, the table, its defaults written out."""
