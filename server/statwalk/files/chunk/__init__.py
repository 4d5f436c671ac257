"""The chunk format (FF2; Anderson, Listing 6): a character as nested chunks, exact to the bit."""

from statwalk.files.chunk.chunk_file import read_chunk_file
from statwalk.files.chunk.write_chunk_file import write_chunk_file

__all__ = ["read_chunk_file", "write_chunk_file"]
