"""The FAQ's own text formats: skeletons and key frames."""
