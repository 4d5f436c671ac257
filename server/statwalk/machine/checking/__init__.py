"""The faults that the verifier looks for, by what they are about."""
