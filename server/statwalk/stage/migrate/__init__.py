"""Migration to another version of a role during play: states, events and parameters are carried
over by name.
"""
