"""What a condition may ask: the names and kinds of its variables, its code, and the compiled functions that
read and evaluate it.
"""
