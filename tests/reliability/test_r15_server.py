"""R-15 over REST: while the disk of a server refuses, inputs and edits get 507 or 503, and frames go on;
afterwards it takes both again, without a new start.
"""

import json
from pathlib import Path

import httpx
import pytest
from disk_faults import FAILING
from processes import served
from serving import PATIENCE, wait_for
from traced import needs_strace, strace
from watcher import Watcher

MAIN = "/api/stages/main"
TICKS = 30
CONTENT = {"event": "FORWARD"}
MACHINES = "/api/machines"


def edits(rest: httpx.Client) -> list[int]:
    """The statuses of a new machine, a new state, another name and a deletion."""
    mine, state = f"{MACHINES}/mine", {"kind": "add_state", "state": "MORE"}
    answers = (
        rest.post(MACHINES, json={"name": "yours"}),
        rest.patch(mine, json={"operations": [state]}, headers={"If-Match": "1"}),
        rest.post(f"{mine}/rename", json={"to": "yours"}),
        rest.delete(mine),
    )
    return [answer.status_code for answer in answers]


def refusal(rest: httpx.Client) -> str:
    """The reason why an input is not kept."""
    return str(rest.post(f"{MAIN}/events", json=CONTENT).json()["detail"])


@pytest.fixture(scope="module", autouse=True)
def _strace() -> None:
    needs_strace()


@pytest.mark.parametrize(("error", "status"), [("ENOSPC", 507), ("EIO", 503)])
def test_r15_a_server_refuses_shows_and_recovers(tmp_path: Path, error: str, status: int) -> None:
    seqs: list[int] = []
    inject = f"inject={FAILING}:error={error}"
    with (
        served("--data", str(tmp_path)) as (process, address),
        httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest,
    ):

        def post(key: str) -> int:
            answer = rest.post(f"{MAIN}/events", json=CONTENT, headers={"Idempotency-Key": key})
            if answer.status_code == 202:
                seqs.append(answer.json()["seq"])
            return answer.status_code

        assert post("before") == 202
        made = rest.post(MACHINES, json={"name": "mine"}).json()
        with strace(process.pid, "-o", "/dev/null", "-e", f"trace={FAILING}", "-e", inject):
            assert [post(key) for key in ("one", "two", "one")] == [status] * 3
            wait_for(lambda: "the log of the database" in refusal(rest))  # the server has tried again
            assert edits(rest) == [status] * 4
            assert rest.get(MAIN).status_code == 200
            with Watcher(address, MAIN) as viewer:
                viewer.frame_from(viewer.frame().tick + TICKS)
        wait_for(lambda: post("one") == 202)
        assert post("after") == 202
        assert rest.get(f"{MACHINES}/mine").json() == made
        assert [path.name for path in (tmp_path / "machines").glob("*/*")] == ["machine.yaml"]
        assert list((tmp_path / "tmp").iterdir()) == []
        assert edits(rest) == [201, 200, 409, 204]
        log = rest.get(f"{MAIN}/log").text
    numbers = [entry["number"] for entry in map(json.loads, log.splitlines()[1:]) if entry["kind"] == "press"]
    assert [numbers.count(seq) for seq in seqs] == [1] * 3
