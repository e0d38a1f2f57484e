"""What the tests of the package share."""

from __future__ import annotations

import os
import random
import struct
import subprocess
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
sys.path.insert(0, str(Path(__file__).resolve().parent))

from shoal import SimulationError, columns, sim_library  # noqa: E402
from shoal.lcm_file import Member  # noqa: E402
from shoal.message import Message  # noqa: E402

SCHEMA_TEST_TYPES = ROOT / "lib/base/schema/schema_test_types.lcm"


def event(number: int, utime: int, channel: str, data: bytes) -> bytes:
    """Returns one event of an LCM log."""
    name = channel.encode()
    return struct.pack(">IqqII", 0xEDA1DA01, number, utime, len(name), len(data)) + name + data


def log_bytes(messages: Iterable[tuple[int, str, bytes]]) -> bytes:
    """Returns a log of (utime, channel, data)."""
    return b"".join(event(i, *message) for i, message in enumerate(messages))


def random_message(made: type[Message], draw: random.Random) -> Message:
    """Returns a message with something in each member; arrays have up to three elements."""
    lengths: dict[str, int] = {}
    message = made()
    for member, name in zip(made._codec.struct.members, made._codec.attributes, strict=True):
        sizes = []
        for dimension in member.dimensions:
            sizes.append(dimension.size or lengths.setdefault(dimension.text, draw.randint(0, 3)))
        setattr(message, name, _random_value(made, member, sizes, draw))
    for name, length in lengths.items():
        setattr(message, name, length)
    return message


def _random_value(
    made: type[Message], member: Member, sizes: list[int], draw: random.Random
) -> Any:
    if sizes:
        values = [_random_value(made, member, sizes[1:], draw) for _ in range(sizes[0])]
        return bytes(values) if member.type_name == "byte" and len(sizes) == 1 else values
    if not member.is_primitive:
        nested = made._classes[member.type_name]
        return nested() if nested is made else random_message(nested, draw)
    bits = {"int8_t": 8, "int16_t": 16, "int32_t": 32, "int64_t": 64}.get(member.type_name)
    if bits is not None:
        return draw.randrange(-(2 ** (bits - 1)), 2 ** (bits - 1))
    if member.type_name == "string":
        return "".join(draw.choices("abc xyz_°ü:", k=draw.randint(0, 12)))
    if member.type_name == "byte":
        return draw.randrange(256)
    if member.type_name == "boolean":
        return draw.random() < 0.5
    value = draw.uniform(-1e6, 1e6)
    if member.type_name == "float":
        return struct.unpack(">f", struct.pack(">f", value))[0]
    return value


@pytest.fixture(params=["numpy", "without numpy"])
def each_kind_of_column(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Runs the test with numpy, where it is installed, and without."""
    if request.param == "without numpy":
        monkeypatch.setattr(columns, "numpy", None)
    elif columns.numpy is None:
        pytest.skip("numpy is not installed; scripts/setup --with-tests installs it")
    return str(request.param)


@pytest.fixture(scope="session")
def shoal_program() -> Path:
    """The built program `shoal`."""
    program = Path(os.environ.get("SHOAL_BINARY_DIR", ROOT / "build")) / "bin/shoal"
    if not program.is_file():
        pytest.skip(f"{program} is not built")
    return program


@pytest.fixture
def simulation_library(shoal_program: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The built libshoal_sim.so.0, which shoal.Simulation then loads."""
    library = shoal_program.parent.parent / "lib/libshoal_sim.so.0"
    if not library.is_file():
        pytest.skip(f"{library} is not built")
    monkeypatch.setenv("SHOAL_SIM_LIBRARY", str(library))
    try:
        sim_library.sim_library()
    except SimulationError as error:
        if "asan" in str(error) or "tsan" in str(error):
            pytest.skip("this machine cannot load a library with sanitizers into python3")
        raise
    return library


@pytest.fixture(scope="session")
def recorded_logs(
    shoal_program: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[dict[str, Path]]:
    """Logs of missions, by name."""
    folder = tmp_path_factory.mktemp("logs")
    logs = {}
    for name in ("acoustic", "search_gateway"):
        logs[name] = folder / f"{name}.lcm"
        subprocess.run(
            [shoal_program, "sim", ROOT / f"missions/{name}.toml", "--log", logs[name]],
            check=True,
            stdout=subprocess.DEVNULL,
        )
    yield logs
