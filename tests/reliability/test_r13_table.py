"""R-13: each limit of docs/limits.md is reached by a test; here those that no other test reaches."""

import pickle
import re
import socket
from collections.abc import AsyncIterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import httpx
import pytest
import tiny_model
from paths import ROOT
from serving import PATIENCE, open_and_never_read, serving, wait_for
from statwalk.errors import BusyError
from statwalk.services.access.roles import EVERYTHING
from statwalk.services.hosting import actor_tracks, machine_versions, stage_lock
from statwalk.services.hosting.audience import Audience
from statwalk.services.hosting.stage_lock import StageLock
from statwalk.services.limits import Limits
from statwalk.services.publish.fanout import Fanout
from statwalk.services.publish.outbox import Outbox
from statwalk.web import client_protocol, server, upload_limiter
from statwalk.web.app import create_app
from statwalk.web.routes import new_machines, uploads
from statwalk.web.settings import Settings
from watcher import Watcher
from websockets.exceptions import InvalidStatus

MODEL = {"content-type": "model/gltf-binary"}
WALKER = {"clock": "manual", "actors": [{"machine": "faq-walker"}]}
UPLOAD = (
    b"PUT /api/characters/robot HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/gltf-binary\r\n"
    b"Content-Length: 1000\r\n\r\nglT"
)
HERE = "reliability/test_r13_table.py"
WORKERS = "services/work/test_workers.py"
REACHED_BY = {
    "stages": "services/hosting/test_registry.py::test_a_stage_more_than_there_may_be_is_refused",
    "actors": "services/hosting/test_registry.py::test_an_actor_more_than_there_may_be_is_refused",
    "entries": "services/hosting/test_log_room.py::test_a_full_log_forgets_and_says_where_it_begins",
    "tick_entries": "web/test_rate_limits.py::test_one_tick_takes_so_many_inputs_and_the_next_takes_more",
    "tick_share": "services/hosting/test_pacing.py"
    "::test_a_costly_stage_slows_down_and_its_neighbour_does_not",
    "rest_seconds": "services/hosting/test_attention.py::test_a_stage_that_nobody_uses_takes_no_ticks",
    "idle_seconds": "services/hosting/test_registry.py::test_idle_stages_are_let_go_and_no_others",
    "viewers": f"{HERE}::test_one_viewer_more_is_refused",
    "CAMERAS_PER_SECOND": f"{HERE}::test_one_camera_more_is_refused",
    "LIST_SECONDS": f"{HERE}::test_the_list_of_viewers_is_not_sent_more_often",
    "LONGEST_STAGE_NAME": f"{HERE}::test_a_longer_name_of_a_stage_is_refused",
    "LONGEST_VIEWER_NAME": f"{HERE}::test_a_longer_name_of_a_viewer_is_refused",
    "MOST_UPLOADS": f"{HERE}::test_one_character_or_machine_more_is_refused",
    "requests": "web/test_rate_limits.py::test_requests_of_one_address_are_limited_and_others_are_not",
    "TURN_SECONDS": "web/test_turns.py::test_a_long_request_holds_nobody_up_for_long",
    "stage_requests": "web/test_rate_limits.py"
    "::test_requests_about_one_stage_are_limited_and_other_stages_are_not",
    "inputs": "web/test_rate_limits.py::test_inputs_are_limited_and_questions_are_not",
    "stage_inputs": "web/test_rate_limits.py::test_inputs_are_limited_and_questions_are_not",
    "INPUTS_PER_SECOND": "web/socket/test_inbox.py::test_who_floods_with_what_means_nothing_is_cut_off",
    "IDLE_ACKS_PER_SECOND": "web/socket/test_inbox.py::test_who_floods_with_what_means_nothing_is_cut_off",
    "MOST_FORKS": "web/socket/test_inbox.py::test_one_viewer_opens_few_forks_in_a_row",
    "cooling_seconds": "web/socket/test_stream_refusals.py"
    "::test_who_floods_is_cut_off_and_does_not_come_straight_back",
    "LARGEST_MESSAGE_BYTES": "web/socket/test_stream_refusals.py"
    "::test_a_message_that_is_too_long_ends_the_connection",
    "CREDITS": "web/socket/test_stream.py::test_no_more_than_three_frames_without_acknowledgement",
    "ACKNOWLEDGE_SECONDS": "web/socket/test_stream.py::test_a_viewer_that_never_acknowledges_is_cut_off",
    "PONG_SECONDS": "reliability/alone/test_r13_limits.py::test_who_acknowledges_without_reading_is_cut_off",
    "UNWRITABLE_SECONDS": "web/socket/test_protocol.py::test_a_viewer_that_never_reads_is_cut_off",
    "MOST_FACTS": "services/publish/test_outbox.py"
    "::test_too_many_facts_cut_the_viewer_off_rather_than_lose_one",
    "connections": "web/test_client_protocol.py::test_where_all_are_in_use_one_more_is_told_to_wait",
    "MOST_CONNECTIONS": f"{HERE}::test_one_connection_more_is_told_that_the_server_is_busy",
    "header_seconds": "web/test_client_protocol.py::test_half_a_header_is_a_408",
    "body_rate": "web/test_client_protocol.py::test_a_body_that_does_not_come_leaves_its_place",
    "MOST_UNREAD": "web/socket/test_protocol.py::test_reading_stops_when_several_messages_wait",
    "SOCKET_BYTES": "web/test_client_protocol.py::test_a_socket_is_read_in_small_parts",
    "ARRIVAL_SECONDS": f"{HERE}::test_an_upload_that_takes_too_long_is_refused",
    "UNREAD_SECONDS": f"{HERE}::test_a_client_that_does_not_read_its_answer_is_cut",
    "LARGEST_BODY_BYTES": "web/test_matrix.py::test_a_body_without_a_length_is_cut_off_at_the_limit",
    "LARGEST_UPLOAD_BYTES": "web/routes/test_uploads.py"
    "::test_a_body_without_a_length_is_cut_off_at_the_limit",
    "MOST_LEFT_OUT": "web/routes/test_uploads_without.py::test_so_many_meshes_are_left_out_and_no_more",
    "MOST_VALUES": "web/test_bounded_json.py::test_more_than_any_model_asks_for_is_refused",
    "DEEPEST": "web/test_bounded_json.py::test_the_deepest_that_is_allowed_is_read",
    "MOST_AT_ONCE": f"{HERE}::test_one_upload_more_at_once_is_refused",
    "MOST_CHILDREN": f"{HERE}::test_one_model_more_waits_to_be_read",
    "MEMORY_BYTES": "services/library/test_upload_sandbox.py::test_out_of_memory",
    "PROCESSOR_SECONDS": "services/library/test_upload_sandbox.py::test_out_of_time",
    "WALL_SECONDS": "web/routes/test_uploads.py::test_a_child_that_is_out_of_time",
    "MOST_RUNNING": "web/test_long_work.py::test_as_many_run_as_may_and_the_next_gets_the_first_free_place",
    "MOST_ABOUT_ONE": "web/test_long_work.py::test_one_stage_does_not_take_all_places",
    "MOST_WAITING": "web/test_long_work.py::test_one_more_than_may_wait_is_refused",
    "WAIT_SECONDS": "web/test_long_work.py::test_who_has_waited_long_is_told_to_try_again",
    "work_seconds": "reliability/alone/test_r13_limits.py"
    "::test_a_long_step_has_a_deadline_and_says_what_to_do",
    "MOST_WORKERS": f"{WORKERS}::test_a_job_is_cancelled_and_the_worker_does_the_next_one",
    "IDLE_SECONDS": f"{WORKERS}::test_a_worker_without_work_ends",
    "CANCEL_SECONDS": f"{WORKERS}::test_a_job_that_does_not_hear_ends_with_its_process",
    "MOST_MEMORY": f"{WORKERS}::test_a_worker_has_limits_and_nothing_of_the_server",
    "services/limits.MOST_TICKS": f"{HERE}::test_one_tick_more_is_refused",
    "services/hosting/actor_tracks.MOST_TICKS": f"{HERE}::test_a_longer_recording_is_refused",
    "MOST_JOINT_POSES": f"{HERE}::test_a_fuller_recording_is_refused",
    "MOST_DETAILED": "web/routes/test_differences.py::test_too_long_a_span_and_too_many_details_are_refused",
    "MOST_PICTURES": "web/routes/test_actors_skeleton.py::test_what_cannot_be_drawn_is_refused",
    "BUSY_SECONDS": f"{HERE}::test_a_stage_that_stays_busy_is_given_up",
    "MOST_OPERATIONS": f"{HERE}::test_one_operation_more_is_refused",
    "MOST_TRIES": "services/hosting/test_machine_edits.py::test_an_edit_that_is_always_late_is_given_up",
    "MOST_VERSIONS": f"{HERE}::test_the_oldest_version_is_forgotten",
}
"""by limit, a test that reaches it"""
CHANGE = re.compile(r"\| (?:`--limit (\w+)=`|fixed: `([\w/]+\.)(\w+)`) \|$", re.MULTILINE)


def test_each_limit_of_the_table_is_reached_by_a_test() -> None:
    found = CHANGE.findall((ROOT / "docs" / "limits.md").read_text())
    limits = {name or (module + fixed if fixed == "MOST_TICKS" else fixed) for name, module, fixed in found}
    assert limits == set(REACHED_BY)
    for test in REACHED_BY.values():
        file, _, name = test.partition("::")
        assert f"def {name}(" in (ROOT / "tests" / file).read_text(), test


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    app: Any = create_app(Settings(data=tmp_path, main_stage=False))
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
        yield client


async def opened(client: httpx.AsyncClient) -> str:
    return (await client.post("/api/stages", json=WALKER)).headers["location"]


def test_one_viewer_more_is_refused() -> None:
    with (
        serving(create_app(Settings(limits=Limits(viewers=1)))) as address,
        Watcher(address, "/api/stages/main"),
        pytest.raises(InvalidStatus) as refused,
    ):
        Watcher(address, "/api/stages/main")
    assert refused.value.response.status_code == 503
    assert "has 1 viewers" in (refused.value.response.body or b"").decode()


def refusal(message: dict[str, Any], times: int = 1) -> int:
    """The status of the first error that a viewer gets that says something so often."""
    with serving(create_app()) as address, Watcher(address, "/api/stages/main") as viewer:
        for _ in range(times):
            viewer.say(**message)
        status: int = viewer.text("error")["status"]
        return status


def test_one_camera_more_is_refused() -> None:
    assert refusal({"type": "camera", "position": [0, 1, 2], "target": [0, 1, 0]}, times=40) == 429


def test_a_longer_name_of_a_viewer_is_refused() -> None:
    assert refusal({"type": "name", "name": "x" * 41}) == 422


@pytest.mark.anyio
async def test_a_longer_name_of_a_stage_is_refused(client: httpx.AsyncClient) -> None:
    statuses = [
        (await client.post("/api/stages", json={"name": "x" * length})).status_code for length in (80, 81)
    ]
    assert statuses == [201, 422]


@pytest.mark.anyio
async def test_one_operation_more_is_refused(client: httpx.AsyncClient) -> None:
    operation = {"kind": "set_cell", "state": "WALK", "event": "LEFT", "text": "STAT"}
    statuses = [
        (
            await client.patch(
                "/api/machines/faq-walker?dry=true",
                json={"operations": [operation] * count},
                headers={"If-Match": '"1"'},
            )
        ).status_code
        for count in (200, 201)
    ]
    assert statuses == [200, 422]


@pytest.mark.anyio
async def test_the_list_of_viewers_is_not_sent_more_often() -> None:
    now, outbox = 0.0, Outbox("pose")
    audience = Audience(Fanout(), pickle.dumps, lambda: now, most=2)
    audience.join(outbox, EVERYTHING)
    outbox.take_texts()
    audience.change(outbox, name="ada")
    assert outbox.take_texts() == []
    now = 1.0
    audience.tell()
    (text,) = outbox.take_texts()
    assert pickle.loads(text).viewers[0].name == "ada"


@pytest.mark.anyio
async def test_one_character_or_machine_more_is_refused(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (uploads, new_machines):
        monkeypatch.setattr(module, "MOST_UPLOADS", 1)
    for name, status in (("one", 201), ("two", 409)):
        upload = {"content": tiny_model.model(), "headers": MODEL}
        assert (await client.put(f"/api/characters/{name}", **upload)).status_code == status
        machine = {"name": name, "character": "one"}
        assert (await client.post("/api/machines", json=machine)).status_code == status


def test_one_connection_more_is_told_that_the_server_is_busy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server, "MOST_CONNECTIONS", 2)
    with serving(create_app()) as address, ExitStack() as viewers:
        viewers.enter_context(open_and_never_read(address, "/api/stages/main/stream"))
        viewers.enter_context(open_and_never_read(address, "/api/stages/main/stream"))
        assert httpx.get(f"http://{address}/healthz", timeout=PATIENCE).status_code == 503


@pytest.mark.anyio
async def test_an_upload_that_takes_too_long_is_refused(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(uploads, "ARRIVAL_SECONDS", 0.0)
    answer = await client.put("/api/characters/late", content=tiny_model.model(), headers=MODEL)
    assert (answer.status_code, "took longer" in answer.json()["detail"]) == (408, True)


def test_a_client_that_does_not_read_its_answer_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nor does the kernel cut it, nor is there a whole answer after which the connection is idle."""
    monkeypatch.setattr(client_protocol, "UNREAD_SECONDS", 1.0)
    monkeypatch.setattr(server, "DEAD_PEER_MILLISECONDS", 600_000)
    with serving(create_app()) as address, socket.socket() as client:
        host, port = address.split(":")
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        client.settimeout(PATIENCE)
        client.connect((host, int(port)))
        client.sendall(b"GET /api/characters/walker/model.glb HTTP/1.1\r\nHost: localhost\r\n\r\n" * 50)
        with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
            assert 'statwalk_held{what="connections"} 2.0' in rest.get("/metrics").text
            wait_for(lambda: 'statwalk_held{what="connections"} 1.0' in rest.get("/metrics").text)


def test_one_upload_more_at_once_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(upload_limiter, "MOST_AT_ONCE", 1)
    app: Any = create_app(Settings(data=tmp_path, main_stage=False))
    with serving(app) as address, socket.create_connection(tuple(address.split(":"))) as first:
        first.sendall(UPLOAD)
        with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
            wait_for(lambda: 'statwalk_held{what="uploads"} 1.0' in rest.get("/metrics").text)
            answer = rest.put("/api/characters/two", content=tiny_model.model(), headers=MODEL)
    assert (answer.status_code, "1 uploads are arriving" in answer.json()["detail"]) == (503, True)


def test_one_model_more_waits_to_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And is read when its turn comes."""
    monkeypatch.setattr(upload_limiter, "MOST_CHILDREN", 1)
    app: Any = create_app(Settings(data=tmp_path, main_stage=False))
    with (
        serving(app) as address,
        ThreadPoolExecutor() as aside,
        httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest,
    ):
        answers = [
            aside.submit(rest.put, f"/api/characters/x{number}", content=tiny_model.model(), headers=MODEL)
            for number in range(3)
        ]
        wait_for(lambda: re.search(r'statwalk_waiting{queue="uploads"} [12]', rest.get("/metrics").text))
        assert [answer.result().status_code for answer in answers] == [201] * 3


@pytest.mark.anyio
async def test_one_tick_more_is_refused(client: httpx.AsyncClient) -> None:
    answer = await client.post(f"{await opened(client)}/step", json={"ticks": 36_001})
    assert answer.status_code == 422


@pytest.mark.anyio
async def test_a_longer_recording_is_refused(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(actor_tracks, "MOST_TICKS", 3)
    stage = await opened(client)
    await client.post(f"{stage}/step", json={"ticks": 9})
    statuses = [(await client.get(f"{stage}/recording.glb?from=1&to={last}")).status_code for last in (3, 4)]
    assert statuses == [200, 409]


@pytest.mark.anyio
async def test_a_fuller_recording_is_refused(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage = await opened(client)
    joints = len((await client.get(f"{stage}/actors/1/pose")).json()["rotation"])
    monkeypatch.setattr(actor_tracks, "MOST_JOINT_POSES", 2 * joints)
    await client.post(f"{stage}/step", json={"ticks": 9})
    statuses = [(await client.get(f"{stage}/recording.glb?from=1&to={last}")).status_code for last in (2, 3)]
    assert statuses == [200, 409]


def test_a_stage_that_stays_busy_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stage_lock, "BUSY_SECONDS", 0.0)
    lock = StageLock()
    with lock.held(), pytest.raises(BusyError, match="busy"), lock.held():
        raise AssertionError("two hold it")


@pytest.mark.anyio
async def test_the_oldest_version_is_forgotten(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(machine_versions, "MOST_VERSIONS", 2)
    machine = (await client.get("/api/machines/elbow")).json()
    for number in (1, 2):
        new = {"text": f"{machine['text']}# {number}\n"}
        edited = await client.put("/api/machines/elbow", json=new, headers={"If-Match": f'"{number}"'})
        assert edited.status_code == 200
    versions = (await client.get("/api/machines/elbow/versions")).json()
    assert sorted(version["version"] for version in versions) == [2, 3]
