"""`python -m statwalk`: the command `statwalk`, where it is not on the PATH."""

import sys

from statwalk.cli import main

sys.exit(main())
