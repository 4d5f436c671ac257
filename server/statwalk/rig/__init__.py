"""Skeletons: joints and bones, and the evaluation of their transforms."""
