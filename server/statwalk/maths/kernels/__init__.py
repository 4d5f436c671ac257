"""Inner loops of readers, skinning and exports, compiled by numba when they are imported."""
