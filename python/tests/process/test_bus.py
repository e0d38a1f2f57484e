"""The live bus: sockets with ttl=0, on ports of their own, against liblcm and running missions."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
import time
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest
import shoal
from conftest import ROOT, log_bytes
from shoal.running import choose_mission

PORT = 29_480
URL = f"udpm://239.255.76.67:{PORT}?ttl=0"
T = shoal.types


@pytest.fixture
def bus() -> Iterator[shoal.Bus]:
    with shoal.Bus(URL) as opened:
        yield opened


def test_a_message_arrives_as_it_was_published(bus: shoal.Bus) -> None:
    taken: list[tuple[str, object]] = []
    bus.subscribe("NAV_*", lambda channel, message: taken.append((channel, message)))
    bus.publish("DESIRED_ALPHA", T.desired_t())
    bus.publish("NAV_ALPHA", T.nav_t(x_m=3))
    bus.publish("NAV_BRAVO", b"of no known type")
    count = 0
    while count < 2:
        count += bus.handle(5)
    assert taken == [("NAV_ALPHA", T.nav_t(x_m=3)), ("NAV_BRAVO", b"of no known type")]
    assert bus.handle(0.01) == 0


def test_a_long_message_arrives_in_fragments(bus: shoal.Bus) -> None:
    packet = T.acoustic_tx_t(payload=bytes(500_000))
    received = bus.iterate("ACOUSTIC_TX", timeout_s=5)
    bus.publish("ACOUSTIC_TX", packet)
    assert next(received).message == packet


def test_iterating_ends_where_nothing_comes(bus: shoal.Bus) -> None:
    assert list(bus.iterate(timeout_s=0.05)) == []


def test_foreign_datagrams_are_counted_and_raise_nothing(bus: shoal.Bus) -> None:
    received = bus.iterate("*", timeout_s=5)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        for datagram in (b"HTTP/1.1", b"LC03", b"LC02\0\0\0\0A\0" + T.nav_t().encode()[:-1]):
            sender.sendto(datagram, ("239.255.76.67", PORT))
    bus.publish("LAST", T.nav_t())
    assert next(received).channel == "LAST"
    assert (bus.num_malformed, bus.num_undecodable) == (2, 1)


def test_liblcm_receives_what_is_published(bus: shoal.Bus, tmp_path: Path) -> None:
    logger = shutil.which("lcm-logger")
    if logger is None:
        pytest.skip("there is no lcm-logger; scripts/setup installs it")
    path = tmp_path / "bus.lcm"
    long = T.acoustic_tx_t(payload=bytes(range(256)) * 1000)
    process = subprocess.Popen([logger, "-q", f"--lcm-url={URL}", path])
    try:
        deadline = time.monotonic() + 20
        while len(messages := logged(path, "LONG")) == 0 and time.monotonic() < deadline:
            bus.publish("LONG", long)
            bus.publish("SHORT", T.nav_t(x_m=5))
            time.sleep(0.1)
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()
    assert messages[0] == long and logged(path, "SHORT")[0] == T.nav_t(x_m=5)


def logged(path: Path, channel: str) -> list[shoal.Message]:
    """Returns the messages of a channel in a log that is being written."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if not path.exists():
            return []
        return [each.message for each in shoal.read(path) if each.channel == channel]


def test_what_liblcm_plays_back_is_received(bus: shoal.Bus, tmp_path: Path) -> None:
    player = shutil.which("lcm-logplayer")
    if player is None:
        pytest.skip("there is no lcm-logplayer; scripts/setup installs it")
    long = T.acoustic_tx_t(payload=bytes(100_000))
    sent = [T.nav_t(x_m=1), long, T.nav_t(x_m=2)]
    log = log_bytes((i, "A", each.encode()) for i, each in enumerate(sent))
    (tmp_path / "a.lcm").write_bytes(log)
    received = bus.iterate("A", timeout_s=10)
    subprocess.run([player, "-s", "0", "-l", URL, tmp_path / "a.lcm"], check=True, stdout=-3)
    assert [next(received).message for _ in sent] == sent


@pytest.mark.parametrize(
    ("url", "error"),
    [
        ("tcpq://127.0.0.1:7700", "only udpm is supported"),
        ("udpm://127.0.0.1:7700", "127.0.0.1 is not a multicast address"),
        ("udpm://239.255.76.67:7700?ttl=x", "ttl is a number"),
        ("udpm://239.255.76.67:77000", "Port out of range"),
    ],
)
def test_a_url_that_cannot_be_used_is_refused(url: str, error: str) -> None:
    with pytest.raises(shoal.BusError, match=error):
        shoal.Bus(url)


@pytest.fixture
def mission(shoal_program: Path, tmp_path: Path) -> Iterator[subprocess.Popen[bytes]]:
    """A mission in communities that runs, found by the folder of this test alone."""
    os.environ["SHOAL_RUN_DIR"] = str(tmp_path / "run")
    process = subprocess.Popen(
        [str(shoal_program), "run", str(ROOT / "missions/fleet.toml"), "--port", str(PORT + 10)]
        + ["--warp", "5"],
        stdout=subprocess.DEVNULL,
    )
    try:
        deadline = time.monotonic() + 30
        while not shoal.running_missions() and time.monotonic() < deadline:
            time.sleep(0.05)
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()
        del os.environ["SHOAL_RUN_DIR"]


def test_a_running_mission_is_found_looked_at_and_commanded(
    mission: subprocess.Popen[bytes],
) -> None:
    with shoal.Bus.of_running_mission() as look:
        assert look.mission is not None and look.mission.name == "fleet"
        vehicles = look.mission.ports.vehicles
        seen: dict[str, str] = {}
        for received in look.iterate("NAV_*", timeout_s=30):
            seen[received.channel] = received.publisher
            assert isinstance(received.message, shoal.Message)
            if len(seen) == len(vehicles):
                break
        first = vehicles[0]
        assert seen[f"NAV_{first.upper()}"] == f"vehicle_sim_{first}"
        with pytest.raises(shoal.BusError, match="open it with commands=True"):
            look.publish("HELM_COMMAND", T.helm_command_t(command="return"))

        states = look.iterate(f"HELM_STATE_{first.upper()}", timeout_s=30)
        with shoal.Bus.of_running_mission(PORT + 10, commands=True) as command:
            channel = f"HELM_COMMAND_{first.upper()}"
            command.publish(channel, T.helm_command_t(command="all_stop", argument="of a test"))
        stops = (received.message.all_stop for received in states)  # type: ignore[union-attr]
        assert any("of a test" in stop for stop in stops)


def test_a_mission_that_cannot_be_meant_is_refused_with_those_that_run(
    mission: subprocess.Popen[bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    missions = shoal.running_missions()
    shown = f"no mission runs at port 9; running:\n  port={PORT + 10}"
    with pytest.raises(shoal.BusError, match=shown):
        choose_mission(missions, 9, False)
    with pytest.raises(shoal.BusError, match="several missions are running; choose one"):
        choose_mission(missions * 2, None, False)
    monkeypatch.chdir(tmp_path)
    assert choose_mission(missions, None, False) == missions[0]
    with pytest.raises(shoal.BusError, match="no mission was started in this folder"):
        choose_mission(missions, None, True)
    with pytest.raises(shoal.BusError, match="no mission is running"):
        choose_mission([], None, False)


def test_a_run_folder_of_others_is_not_trusted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SHOAL_RUN_DIR", str(tmp_path))
    assert shoal.running_missions() == []
    (tmp_path / "7665.run").write_text("mission_id 1\npid x\nport_base 7665\n")
    assert shoal.running_missions() == []
    tmp_path.chmod(0o777)
    with pytest.raises(shoal.BusError, match="is not yours alone"):
        shoal.running_missions()
