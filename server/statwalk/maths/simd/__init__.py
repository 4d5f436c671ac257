"""Sixteen float32 numbers side by side: the value type of compiled kernels, and its functions."""
