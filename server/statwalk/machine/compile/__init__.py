"""Compiles a machine definition into the machine that runs: defaults resolved, tables full; nothing can fail
after it.
"""
