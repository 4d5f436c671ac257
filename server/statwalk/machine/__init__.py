"""State machines (FAQ Q19): the table as authored and as run, one tick of it, and what can be proved of
it.
"""
