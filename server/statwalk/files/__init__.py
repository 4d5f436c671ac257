"""Readers and writers of files: glTF models, machine folders, scenes, characters in text, zip archives."""
