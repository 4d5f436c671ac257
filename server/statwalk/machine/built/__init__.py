"""The machine as it runs: immutable arrays, and how they are made of the authored one."""
