"""The description is printed without a compiler: who generates types does not wait for kernels."""

import json
import os
import subprocess
import sys

from statwalk.web.app import openapi_document


def test_the_description_is_printed_and_nothing_is_compiled(tmp_path):
    environment = os.environ | {
        "STATWALK_CACHE": str(tmp_path),
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
    }
    command = [sys.executable, "-m", "statwalk.web.print_openapi"]
    printed = subprocess.run(command, env=environment, capture_output=True, check=True).stdout
    assert json.loads(printed) == openapi_document()
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]
