"""How actors move: what states play, how it is blended, and what dies out of the motions before."""
