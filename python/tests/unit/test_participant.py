"""The step protocol as a participant follows it, over a fake bus.

docs/extending/step_protocol.md has the protocol.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import shoal
from shoal import participant
from shoal.seal import Seal, append_seal, split_seal

T = shoal.types
SECRET = bytes(32)
MISSION_ID = 42
TICKS, DONES, SHORE = 7665, 7666, 7667


class FakeNetwork:
    """Stands for the sockets: a script of what comes in, and all that went out.

    The clock goes on by what each receive waits for.
    """

    def __init__(self, *_: object) -> None:
        self.script: list[list[tuple[int, str, bytes]]] = []
        self.sent: list[tuple[int, str, shoal.Message]] = []
        self.now_s = 100.0

    def open(self, port: int) -> None:
        assert port in (TICKS, SHORE)

    def send(self, port: int, channel: str, data: bytes) -> None:
        body, seal = split_seal(data)
        assert seal is not None and seal.publisher == b"me"
        self.sent.append((port, channel, T.decode(body)))

    def receive(self, timeout_s: float) -> Iterator[tuple[int, str, bytes]]:
        self.now_s += timeout_s
        assert self.now_s < 120, "it ends"
        if self.script:
            yield from self.script.pop(0)

    def close(self) -> None:
        pass

    def of(self, channel: str) -> list[Any]:
        return [message for _, name, message in self.sent if name == channel]


def sealed(
    channel: str, message: shoal.Message, step: int, publisher: bytes = b"clock", sequence: int = 0
) -> bytes:
    seal = Seal(publisher, MISSION_ID, step, sequence)
    return append_seal(message.encode(), seal, SECRET, channel)


def tick(step: int, *totals: tuple[str, str, int], kind: int = 0, **members: Any) -> Any:
    """Returns a tick; totals are publisher, channel and count."""
    listed = [T.step_total_t(publisher=p, channel=c, count=n) for p, c, n in totals]
    message = T.tick_t(
        utime=step * 100_000, mission_id=MISSION_ID, step=step, kind=kind, totals=listed, **members
    )
    return TICKS, "TICK", sealed("TICK", message, step)


def first_tick(step: int, *totals: tuple[str, str, int]) -> Any:
    return tick(step, *totals, joined=["me"], joined_pids=[os.getpid()])


def nav(step: int, x_m: float, sequence: int = 0, publisher: bytes = b"sim") -> Any:
    data = sealed("NAV", T.nav_t(x_m=x_m), step, publisher, sequence)
    return SHORE, "NAV", data


END: int = getattr(T.tick_t, "END")


@pytest.fixture
def network(monkeypatch: pytest.MonkeyPatch) -> FakeNetwork:
    made = FakeNetwork()
    monkeypatch.setattr(participant, "SocketSet", lambda *_: made)
    monkeypatch.setattr(participant, "now_s", lambda: made.now_s)
    return made


@pytest.fixture
def me(network: FakeNetwork, tmp_path: Path) -> shoal.Participant:
    (tmp_path / "secret").write_text(SECRET.hex() + "\n")
    made = shoal.Participant(
        environ={
            "SHOAL_PORT": str(TICKS),
            "SHOAL_MISSION_ID": str(MISSION_ID),
            "SHOAL_PARTICIPANT": "me",
            "SHOAL_VEHICLES": "alpha",
            "SHOAL_LAYOUT": "shared",
            "SHOAL_SECRET_FILE": str(tmp_path / "secret"),
        }
    )
    made.subscribe("NAV")
    return made


def run(me: shoal.Participant, network: FakeNetwork, *script: list[Any]) -> list[Any]:
    """Returns utime and newest NAV of each step that was taken."""
    network.script = list(script)
    taken: list[Any] = []

    def think(utime: int) -> None:
        newest = me.newest("NAV")
        taken.append((utime, None if newest is None else newest.x_m))
        me.publish("DESIRED", T.desired_t(utime=utime))

    me.run(think)
    return taken


def test_it_sends_a_hello_until_its_first_tick(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    run(me, network, *[[]] * 10, [first_tick(0)], [tick(1, kind=END)])
    steps = [done.step for done in network.of("STEP_DONE")]
    assert steps == [-1, -1, -1, 0, 1]
    assert {done.pid for done in network.of("STEP_DONE")} == {os.getpid()}


def test_it_waits_for_the_tick_that_names_this_very_process(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    former = tick(3, joined=["me"], joined_pids=[os.getpid() + 1])
    taken = run(me, network, [former], [tick(4)], [first_tick(5)], [tick(6, kind=END)])
    assert [utime for utime, _ in taken] == [500_000]


def test_it_answers_each_step_with_what_it_published(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    run(me, network, [first_tick(0)], [tick(1)], [tick(2, kind=END)])
    dones = network.of("STEP_DONE")[-3:]
    assert [[(p.channel, p.count) for p in done.published] for done in dones] == [
        [("DESIRED", 1)],
        [("DESIRED", 1)],
        [],
    ]
    assert all(done.fault == "" and done.mission_id == MISSION_ID for done in dones)


def test_a_tick_that_comes_again_is_answered_again_and_no_step_is_taken_twice(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    taken = run(me, network, [first_tick(0)], [tick(0)], [tick(1)], [tick(0)], [tick(2, kind=END)])
    assert len(taken) == 2
    assert [done.step for done in network.of("STEP_DONE")] == [-1, 0, 0, 1, 2]


def test_it_waits_for_all_messages_and_asks_for_those_that_are_missing(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    taken = run(
        me,
        network,
        [first_tick(0)],
        [nav(0, 1.0), nav(0, 1.0), tick(1, ("sim", "NAV", 2), ("other", "NOT_SUBSCRIBED", 5))],
        *[[]] * 3,
        [nav(0, 2.0, sequence=1)],
        [tick(2, kind=END)],
    )
    assert taken == [(0, None), (100_000, 2.0)]
    requests = network.of("RESEND")
    assert 2 <= len(requests) <= 4
    assert {(r.publisher, r.channel, r.step, r.requester) for r in requests} == {
        ("sim", "NAV", 0, "me")
    }
    assert network.of("STEP_DONE")[-1].repeated == len(requests)


def test_what_never_comes_is_a_fault_that_names_no_other_step(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    script = [[first_tick(0)], [tick(1, ("sim", "NAV", 1))], *[[]] * 80, [tick(2, kind=END)]]
    with pytest.raises(shoal.StepError, match="never reached it"):
        run(me, network, *script)
    faults = [done for done in network.of("STEP_DONE") if done.fault]
    assert faults[0].step == 1


def test_more_messages_than_were_counted_are_a_fault_of_their_publisher(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    surplus = [nav(0, 1.0), nav(0, 2.0, sequence=1), tick(1, ("sim", "NAV", 1))]
    with pytest.raises(shoal.StepError, match="sim published 2 messages on NAV and counted 1"):
        run(me, network, [first_tick(0)], surplus, [tick(2, kind=END)])


def test_what_it_published_is_sent_again_when_asked_for(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    request = T.resend_t(mission_id=MISSION_ID, step=0, publisher="me", channel="DESIRED")
    asked = (TICKS, "RESEND", sealed("RESEND", request, 0))
    ended = [tick(3, kind=END)]
    run(me, network, [first_tick(0)], [asked], [tick(1)], [asked], [tick(2)], [asked], ended)
    utimes = [message.utime for message in network.of("DESIRED")]
    assert utimes == [0, 0, 100_000, 0, 200_000]


def test_what_is_not_of_the_mission_is_counted_and_dropped(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    foreign = append_seal(T.nav_t(x_m=8).encode(), Seal(b"sim", 7, 0, 0), SECRET, "NAV")
    forged = append_seal(T.nav_t(x_m=9).encode(), Seal(b"sim", 42, 0, 0), b"x" * 32, "NAV")
    wrong = (SHORE, "NAV", sealed("NAV", T.nav_t(), 0, b"sim")[8:])
    strays = [(SHORE, "NAV", foreign), (SHORE, "NAV", forged), wrong]
    unsealed_tick = (TICKS, "TICK", T.tick_t(mission_id=MISSION_ID, step=1, kind=END).encode())
    taken = run(
        me,
        network,
        [(SHORE, "NAV", T.nav_t(x_m=7).encode())],  # Before the mission.
        [first_tick(0)],
        [*strays, unsealed_tick],
        [tick(1)],
        [(SHORE, "NAV", T.nav_t(x_m=3).encode())],  # From outside.
        [(SHORE, "NAV", b"what is this")],
        [tick(2)],
        [tick(3, kind=END)],
    )
    assert taken == [(0, None), (100_000, None), (200_000, 3.0)]
    done = network.of("STEP_DONE")[-1]
    assert (done.foreign, done.refused, done.outside, done.undecodable) == (1, 3, 2, 1)


def test_after_the_end_it_stays_to_answer_until_nothing_comes_for_a_while(
    me: shoal.Participant, network: FakeNetwork
) -> None:
    end = tick(1, kind=END)
    run(me, network, [first_tick(0)], [end], [], [], [end], *[[]] * 4)
    assert [done.step for done in network.of("STEP_DONE")] == [-1, 0, 1, 1]
    assert network.script == []


def test_a_channel_that_is_not_subscribed_to_has_no_newest_message(
    me: shoal.Participant,
) -> None:
    with pytest.raises(shoal.StepError, match="'DEPTH' is not subscribed to"):
        me.newest("DEPTH")
