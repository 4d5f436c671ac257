"""The pydantic models of the REST bodies, one file for each noun, and of the socket's messages."""
