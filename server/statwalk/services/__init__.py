"""The server without HTTP: the library of content, the stages that run, the frames for viewers."""
