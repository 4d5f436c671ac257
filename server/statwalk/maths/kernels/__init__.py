"""Inner loops compiled by numba, and the choice between them and their NumPy twins. Nothing here is compiled before it is wanted."""
