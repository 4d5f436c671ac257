"""The faults that a table may have, one module for each subject."""
