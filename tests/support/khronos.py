"""The Khronos glTF validator, as an independent judge of what statwalk writes: node runs the npm package that
the viewer's tests use.
"""

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path

from paths import ROOT
from playwright._impl._driver import compute_driver_executable

PACKAGE = ROOT / "static" / "node_modules" / "gltf-validator"
SCRIPT = """
const validator = require(process.argv[1]);
const chunks = [];
process.stdin.on('data', (chunk) => chunks.push(chunk));
process.stdin.on('end', async () => {
  const all = Buffer.concat(chunks);
  const reports = [];
  for (let at = 0; at < all.length; ) {
    const size = all.readUInt32LE(at);
    const file = new Uint8Array(all.subarray(at + 4, at + 4 + size));
    const report = await validator.validateBytes(file, { maxIssues: 0 });
    reports.push(report.issues);
    at += 4 + size;
  }
  process.stdout.write(JSON.stringify(reports));
});
"""


@cache
def node() -> str:
    """A node to run: the one on the PATH, else the one that Playwright brings."""
    found = shutil.which("node")
    if found is None:
        found = str(compute_driver_executable()[0])
    return found


def issues(*models: bytes) -> list[dict]:
    """For each GLB the validator's issues: numErrors, numWarnings, messages."""
    assert Path(PACKAGE).is_dir(), f"{PACKAGE} is missing: `npm ci` in static/ brings it"
    framed = b"".join(len(model).to_bytes(4, "little") + model for model in models)
    result = subprocess.run(
        [node(), "-e", SCRIPT, str(PACKAGE)], input=framed, capture_output=True, check=True
    )
    return json.loads(result.stdout)


def errors(*models: bytes) -> list[str]:
    """Every error the validator finds, as `code pointer: message`."""
    return [error for report in issues(*models) for error in in_words(report)]


def errors_by_name(models: dict[str, bytes]) -> dict[str, list[str]]:
    """The same for many models by name, in one run of the validator."""
    return dict(zip(models, map(in_words, issues(*models.values())), strict=True))


def in_words(report: dict) -> list[str]:
    found = [message for message in report["messages"] if message["severity"] == 0]
    return [f"{message['code']} {message.get('pointer', '')}: {message['message']}" for message in found]
