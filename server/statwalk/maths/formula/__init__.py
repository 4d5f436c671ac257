"""Formulas: a small language of numbers, parsed to a postfix program over arrays.

It has no strings, attributes or loops.
"""
