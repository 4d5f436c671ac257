"""Arrays, rotations, transforms, curves, formulas and compiled kernels; nothing here depends on characters or
machines.
"""
