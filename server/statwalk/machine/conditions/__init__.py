"""Conditions and senses: a small language of numbers, read to a postfix program over arrays. No strings, attributes or loops."""
