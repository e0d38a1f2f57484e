"""Compressed logs are read as plain ones are."""

import random
import shutil
import subprocess
import warnings
from pathlib import Path

import pytest

import shoal
from shoal import frames
from shoal.log_file import HEADER, MAGIC

_zstd = shutil.which("zstd")
needs_zstd = pytest.mark.skipif(
    _zstd is None, reason="no zstd: scripts/setup --with-tests installs it"
)


def _events(count: int) -> list[bytes]:
    draw = random.Random(36)
    return [
        HEADER.pack(MAGIC, i, i * 1000, 1, 500) + b"A" + draw.randbytes(100) + bytes(400)
        for i in range(count)
    ]


def _write(path: Path, events: list[bytes], each: int) -> bytes:
    """Writes frames of `each` events, without a list, as of a writer that was killed."""
    whole = b""
    for i in range(0, len(events), each):
        command = [str(_zstd), "-q", "-1", "--check"]
        whole += subprocess.run(
            command, input=b"".join(events[i : i + each]), capture_output=True, check=True
        ).stdout
    path.write_bytes(whole)
    return whole


@needs_zstd
def test_a_compressed_log_has_the_events_of_the_plain_one(tmp_path: Path) -> None:
    events = _events(1000)
    _write(tmp_path / "mission.lcm.zst", events, 300)
    log = shoal.read(tmp_path)
    assert [record.utime for record in log] == [i * 1000 for i in range(1000)]
    assert b"".join(record.data for record in log) == b"".join(each[29:] for each in events)


@needs_zstd
def test_a_cut_one_is_read_up_to_the_cut_and_states_what_is_lost(tmp_path: Path) -> None:
    whole = _write(tmp_path / "a.zst", _events(900), 300)
    path = tmp_path / "b.zst"
    path.write_bytes(whole[:-10])
    with pytest.warns(shoal.LogWarning, match="ends inside"):
        log = shoal.read(path)
    assert 600 <= len(list(log)) < 900


@needs_zstd
def test_one_whose_writer_was_killed_behind_a_frame_states_it(tmp_path: Path) -> None:
    whole = _write(tmp_path / "a.zst", _events(900), 300)
    path = tmp_path / "b.zst"
    path.write_bytes(frames._OWN_MARK + whole)
    with pytest.warns(shoal.LogWarning, match="ended before it closed the log"):
        log = shoal.read(path)
    assert len(list(log)) == 900


@needs_zstd
def test_a_damaged_frame_is_left_out_where_that_is_asked(tmp_path: Path) -> None:
    whole = bytearray(_write(tmp_path / "a.zst", _events(900), 300))
    whole[len(whole) // 2] ^= 1
    path = tmp_path / "b.zst"
    path.write_bytes(whole)
    with pytest.raises(shoal.LogError, match="of the compressed file is damaged"):
        shoal.read(path)
    with warnings.catch_warnings(record=True):
        log = shoal.read(path, skip_damage=True)
    assert len(list(log)) == 600


@needs_zstd
def test_one_frame_that_does_not_fit_into_memory_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.zst"
    zeros = subprocess.Popen(["head", "-c", "80000000", "/dev/zero"], stdout=subprocess.PIPE)
    with path.open("wb") as file:
        subprocess.run([str(_zstd), "-q"], stdin=zeros.stdout, stdout=file, check=True)
    zeros.wait()
    with pytest.raises(shoal.LogError, match="holds more than 64 MiB"):
        shoal.read(path)


@needs_zstd
def test_a_thousand_mutants_are_read_or_refused(tmp_path: Path) -> None:
    whole = _write(tmp_path / "a.zst", _events(40), 10)
    path = tmp_path / "b.zst"
    draw = random.Random(36)
    for _ in range(1000):
        mutant = bytearray(whole)
        for _ in range(draw.randrange(1, 5)):
            mutant[draw.randrange(len(mutant))] = draw.randrange(256)
        path.write_bytes(mutant[: draw.randrange(1, len(mutant) + 1)])
        with warnings.catch_warnings(record=True):
            try:
                assert len(list(shoal.read(path, skip_damage=True))) <= 40
            except shoal.LogError as error:
                assert str(path) in str(error)


def test_files_that_are_compressed_are_known_by_their_first_bytes() -> None:
    assert frames.is_compressed(b"\x28\xb5\x2f\xfd....")
    assert frames.is_compressed(b"\x5e\x2a\x4d\x18")
    assert not frames.is_compressed(MAGIC)
    assert not frames.is_compressed(b"")
