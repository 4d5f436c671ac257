"""Edits from several threads: verified without a lock, stored one at a time, given up when nobody waits."""

import threading
from concurrent.futures import ThreadPoolExecutor

import pytest
from statwalk.errors import CancelledError, VersionConflictError
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting.machine_versions import MachineVersions
from statwalk.services.library.catalogue import Catalogue

WALKER = "faq-walker"
PATIENCE = 60.0


class HeldVerification(CancelToken):
    """A token at whose check the verification stays until it may go on."""

    def __init__(self) -> None:
        super().__init__()
        self.reached, self.may_go_on = threading.Event(), threading.Event()

    def check(self) -> None:
        self.reached.set()
        assert self.may_go_on.wait(PATIENCE)


@pytest.fixture
def versions() -> MachineVersions:
    return MachineVersions(Catalogue(), list)


def other_text(versions: MachineVersions) -> str:
    return versions.current(WALKER).version.text + "# another text\n"


def test_a_machine_is_read_and_edited_while_an_edit_is_verified(versions: MachineVersions) -> None:
    """The faster editor is first; the slower one is told."""
    slow, current, text = HeldVerification(), versions.current(WALKER), other_text(versions)
    with ThreadPoolExecutor(2) as threads:
        slower = threads.submit(versions.change, current, text, "slow", token=slow)
        assert slow.reached.wait(PATIENCE)
        try:
            faster = threads.submit(versions.change, versions.current(WALKER), text, "fast")
            assert faster.result(timeout=PATIENCE).version.number == 2
        finally:
            slow.may_go_on.set()
        assert isinstance(slower.exception(timeout=PATIENCE), VersionConflictError)
    assert [version.what for version in versions.of(WALKER)] == ["as it was read", "fast"]


def test_an_edit_whose_client_has_gone_changes_nothing(versions: MachineVersions) -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(CancelledError):
        versions.change(versions.current(WALKER), other_text(versions), "gone", token=token)
    assert len(versions.of(WALKER)) == 1


def test_the_server_s_end_gives_up_a_verification_on_its_way(versions: MachineVersions) -> None:
    ending, checks = threading.Event(), []

    class EndsAtTheSecondCheck(CancelToken):
        def check(self) -> None:
            checks.append(True)
            if len(checks) == 2:
                ending.set()
            super().check()

    with pytest.raises(CancelledError):
        versions.change(
            versions.current(WALKER), other_text(versions), "ended", token=EndsAtTheSecondCheck(ending)
        )
    assert (len(checks), len(versions.of(WALKER))) == (2, 1)
