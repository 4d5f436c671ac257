"""`python -m statwalk.web.print_openapi` writes the OpenAPI document to standard output.

Kernels are compiled when their modules are imported; the document needs none, so nothing is compiled here.
"""

from __future__ import annotations

import json
import os
import sys
from importlib import import_module

if __name__ == "__main__":
    os.environ["STATWALK_COMPILED"] = "0"
    json.dump(import_module("statwalk.web.app").openapi_document(), sys.stdout, indent=1)
