"""The state of a stage: arrays of actors by role, contacts, frames, hashes."""
