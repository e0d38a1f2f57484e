"""Messages that are read all at once give what they give one by one, whole or damaged."""

from __future__ import annotations

import random
import warnings
from pathlib import Path
from typing import Any

import pytest
from conftest import log_bytes, random_message
from test_hostile import mutated

import shoal
from shoal import columns, uniform
from shoal import log as log_module
from shoal.codec import Codec
from shoal.message import Message

NAMES = ("node_report_t", "helm_state_t", "swarm_t", "nav_t", "contact_t")


@pytest.fixture(autouse=True)
def _few_messages(monkeypatch: pytest.MonkeyPatch) -> None:
    if columns.numpy is None:
        pytest.skip("numpy is not installed; scripts/setup --with-tests installs it")
    monkeypatch.setattr(uniform, "_FEWEST", 1)


def without_arrays(message: Message, draw: random.Random) -> Message:
    """Empties most messages' arrays: others are left to the codec."""
    if draw.random() < 0.98:
        for member, name in zip(
            message._codec.struct.members, message._codec.attributes, strict=True
        ):
            if member.dimensions:
                setattr(message, name, [])
                setattr(message, member.dimensions[0].text, 0)
    return message


def log_of(draw: random.Random, num_messages: int) -> bytes:
    names = [name for name in NAMES if hasattr(shoal.types, name)]
    return log_bytes(
        (
            i,
            name.upper(),
            without_arrays(random_message(getattr(shoal.types, name), draw), draw).encode(),
        )
        for i in range(num_messages)
        for name in names
    )


def content(table: shoal.Table) -> list[Any]:
    made: list[Any] = [len(table), list(table.time_s), list(table.event)]
    for name in table.columns:
        column = table[name]
        if isinstance(column, shoal.Table):
            made.append((name, content(column)))
        else:
            made.append((name, column.dtype, [repr(each) for each in column.tolist()]))
    return made


def read_all(path: Path, skip_damage: bool) -> list[Any]:
    """Returns what came of reading everything: columns, damages, or the error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", shoal.LogWarning)
        try:
            log = shoal.read(path, skip_damage=skip_damage)
            made = [(channel, content(log[channel])) for channel in log.channels]
        except shoal.LogError as error:
            return [str(error)]
    return [*made, [str(each) for each in log.damages]]


def one_by_one(path: Path, skip_damage: bool, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    def never(codec: Codec) -> bool:
        return False

    with monkeypatch.context() as patch:
        patch.setattr(log_module, "may_be_uniform", never)
        return read_all(path, skip_damage)


def test_columns_are_those_of_the_codec(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw = random.Random(1)
    taken: list[bool] = []
    take: Any = getattr(log_module, "take_uniform")

    def counted(*arguments: Any) -> bool:
        taken.append(take(*arguments))
        return taken[-1]

    monkeypatch.setattr(log_module, "take_uniform", counted)
    path = tmp_path / "a.lcm"
    for _ in range(60):
        path.write_bytes(log_of(draw, draw.randint(1, 50)))
        assert read_all(path, False) == one_by_one(path, False, monkeypatch)
    assert taken.count(True) > 20 and taken.count(False) > 20, taken


def test_a_mutated_log_gives_what_the_codec_gives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw = random.Random(2)
    path = tmp_path / "a.lcm"
    num_errors = 0
    for i in range(1000):
        if i % 50 == 0:
            whole = log_of(draw, 4)
        path.write_bytes(mutated(whole, draw))
        skip_damage = draw.random() < 0.7
        made = read_all(path, skip_damage)
        assert made == one_by_one(path, skip_damage, monkeypatch), path.read_bytes()
        num_errors += isinstance(made[0], str)
    assert 50 < num_errors < 900
