"""A server that others can reach starts only with tokens and TLS; the one line says what to add."""

from pathlib import Path

import pytest
from certificates import certificate_in
from statwalk.cli.exposure import Exposure
from statwalk.errors import ContentError
from statwalk.services.access.access_file import AccessFile

PROXY = {"behind_proxy": True, "public_url": "https://anim.example"}
TLS, TOKEN, URL = "--tls-cert", "--token", "--public-url"


def refusal(folder: Path, *, people: bool = False, **options: object) -> str:
    file = AccessFile(folder)
    if people:
        file.add("ada", "admin")
    try:
        Exposure(**{"host": "127.0.0.1"} | options).check(file)
    except ContentError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("host", ["127.0.0.1", "127.0.0.2", "::1", "localhost"])
@pytest.mark.parametrize("token", [False, True])
def test_on_this_computer_nothing_is_needed(tmp_path: Path, host: str, token: bool) -> None:
    exposure = Exposure(host, token)
    exposure.check(AccessFile(tmp_path))
    assert not exposure.is_shared
    assert (exposure.authenticator(AccessFile(tmp_path)) is not None) == token


@pytest.mark.parametrize(
    ("options", "missing"),
    [
        ({"host": "0.0.0.0"}, {TLS, TOKEN, URL}),
        ({"host": "::"}, {TLS, TOKEN, URL}),
        ({"host": ""}, {TLS, TOKEN, URL}),
        ({"host": "192.168.1.1"}, {TLS, TOKEN}),
        ({"host": "evil.example"}, {TLS, TOKEN}),
        ({"host": "192.168.1.1", "token": True}, {TLS}),
        ({"host": "192.168.1.1", "people": True}, {TLS}),
        ({"host": "192.168.1.1", "people": True, "public_url": "https://anim.example"}, {TLS}),
        ({"behind_proxy": True, "token": True}, {URL}),
        ({"tls_cert": Path("a.pem"), "token": True}, {TLS}),
        (PROXY, {TOKEN}),
        (PROXY | {"host": "0.0.0.0", "people": True}, set()),
        (PROXY | {"token": True}, set()),
    ],
)
def test_the_line_says_what_to_add(tmp_path: Path, options: dict, missing: set[str]) -> None:
    line = refusal(tmp_path, **options)
    assert {option for option in (TLS, TOKEN, URL) if option in line} == missing
    assert "\n" not in line


@pytest.mark.parametrize(
    "url",
    [
        "http://anim.example",
        "anim.example",
        "https://a/b",
        "https://u@a",
        "https://a?x",
        "https://[",
        "https://a b",
    ],
)
def test_the_public_address_is_https_and_a_name(tmp_path: Path, url: str) -> None:
    assert "must be an address like" in refusal(tmp_path, token=True, behind_proxy=True, public_url=url)


def test_files_that_are_no_certificate_are_named(tmp_path: Path) -> None:
    (tmp_path / "a.pem").write_text("no certificate")
    named = {"tls_cert": tmp_path / "a.pem", "tls_key": tmp_path / "a.pem"}
    assert "a.pem" in refusal(tmp_path, host="192.168.1.1", token=True, **named)


def test_a_certificate_and_a_key_that_belong_together_are_enough(tmp_path: Path) -> None:
    certificate, key = certificate_in(tmp_path)
    exposure = Exposure("192.168.1.1", token=True, tls_cert=certificate, tls_key=key)
    exposure.check(AccessFile(tmp_path))
    names = exposure.names(8443)
    assert names.public_url == "https://192.168.1.1:8443"
    assert "192.168.1.1" in names.hosts


def test_the_names_of_a_server_behind_a_proxy() -> None:
    names = Exposure("0.0.0.0", **PROXY | {"public_url": "https://Anim.Example:8443/"}).names(8000)
    assert names.public_url == "https://anim.example:8443"
    assert {"anim.example", "localhost"} <= set(names.hosts)


def test_the_address_has_the_token_of_the_start(tmp_path: Path) -> None:
    exposure = Exposure("::1", token=True)
    authenticator = exposure.authenticator(AccessFile(tmp_path))
    assert authenticator
    assert exposure.address(8000, authenticator) == f"http://[::1]:8000/?token={authenticator.start_token}"
    assert Exposure("::1").address(8000, None) == "http://[::1]:8000/"
