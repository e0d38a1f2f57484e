"""LCM's datagrams, seals, ports, and the order in which a participant handles messages."""

from __future__ import annotations

import hashlib
import re

import pytest
from conftest import ROOT
from shoal.ports import DONE_PORT_CHANNELS, TICK_PORT_CHANNELS, PortPlan
from shoal.seal import Seal, append_seal, is_genuine, split_seal
from shoal.step_inbox import MOST_OUTSIDE, StepInbox
from shoal.wire import MOST_OF_SENDER, MOST_PENDING_BYTES, Assembler, split_message

SECRET = bytes(range(32))


def test_a_short_message_is_one_datagram_as_lcm_sends_it() -> None:
    assert list(split_message("NAV", b"data", 7)) == [b"LC02\0\0\0\7NAV\0data"]
    (largest,) = split_message("NAV", bytes(65495), 0)
    assert len(largest) == 65507  # The most that UDP carries.


@pytest.mark.parametrize("size", [65496, 65497, 200_000, 1_000_000])
def test_a_long_message_is_put_together_from_its_fragments(size: int) -> None:
    data = bytes(i % 251 for i in range(size))
    datagrams = list(split_message("NAV", data, 1))
    assert len(datagrams) > 1 and max(map(len, datagrams)) <= 65507
    assert datagrams[0][:8] == b"LC03\0\0\0\1"
    for order in (datagrams, datagrams[::-1]):
        assembler = Assembler()
        whole = [assembler.add("sender", each) for each in order]
        assert whole[-1] == ("NAV", data) and whole[:-1] == [None] * (len(order) - 1)
        assert assembler.pending_bytes == 0


def test_fragments_of_different_senders_are_kept_apart() -> None:
    assembler = Assembler()
    first, second = list(split_message("A", bytes(70_000), 1)), list(
        split_message("B", bytes(70_001), 1)
    )
    assert assembler.add(1, first[0]) is None and assembler.add(2, second[0]) is None
    assert assembler.add(1, first[1]) == ("A", bytes(70_000))
    assert assembler.add(2, second[1]) == ("B", bytes(70_001))


def test_interleaved_messages_of_one_sender_are_put_together() -> None:
    assembler = Assembler()
    first = list(split_message("A", bytes(70_000), 1))
    second = list(split_message("B", bytes(70_001), 2))
    assert assembler.add(1, first[0]) is None and assembler.add(1, second[0]) is None
    assert assembler.add(1, first[1]) == ("A", bytes(70_000))
    assert assembler.add(1, second[1]) == ("B", bytes(70_001))
    assert (assembler.num_abandoned, assembler.pending_bytes) == (0, 0)


def test_a_message_whose_rest_never_comes_is_given_up() -> None:
    assembler = Assembler()
    for sequence in range(MOST_OF_SENDER + 2):
        first, *_ = split_message("A", bytes(70_000), sequence)
        assembler.add(1, first)
    assert (assembler.num_pending, assembler.num_abandoned) == (MOST_OF_SENDER, 2)


def test_memory_of_fragments_is_bounded() -> None:
    assembler = Assembler()
    largest = list(split_message("A", bytes(MOST_PENDING_BYTES), 1))[:-1]
    for sender in range(3):
        for each in largest:
            assembler.add(sender, each)
    assert assembler.pending_bytes <= MOST_PENDING_BYTES + (1 << 20)
    assert assembler.num_abandoned >= 2


@pytest.mark.parametrize(
    "datagram",
    [
        b"",
        b"LC02",
        b"LC02\0\0\0\0",
        b"LC02\0\0\0\0\0data",
        b"LC02\0\0\0\0" + b"A" * 64 + b"\0data",
        b"LC03\0\0\0\0\0\0\0\4\0\0\0\0\0\0\0\1",
        b"LC03\0\0\0\0\0\0\0\4\0\0\0\0\0\1\0\1data",
        b"LC03\0\0\0\0\xff\xff\xff\xff\0\0\0\0\0\0\0\1A\0data",
        b"LC03\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0\1A\0data",
        b"HTTP/1.1 400 Bad Request",
    ],
)
def test_a_datagram_that_lcm_cannot_have_sent_is_counted(datagram: bytes) -> None:
    assembler = Assembler()
    assert assembler.add(1, datagram) is None
    assert assembler.num_malformed == 1


def test_a_seal_is_that_of_the_step_protocol() -> None:
    sealed = append_seal(b"message", Seal(b"planner", 5, 6, 7), SECRET, "NAV")
    before = b"message" + b"planner\x07" + b"\0\0\0\0\0\0\0\5" + b"\0\0\0\0\0\0\0\6\0\0\0\7"
    tag = hashlib.blake2b(b"NAV\0" + before, key=SECRET, digest_size=16).digest()
    assert sealed == before + tag + b"SHO2"
    assert split_seal(sealed) == (b"message", Seal(b"planner", 5, 6, 7))
    assert is_genuine(sealed, SECRET, "NAV")
    assert not is_genuine(sealed, SECRET, "NAV_ALPHA")
    assert not is_genuine(sealed, bytes(32), "NAV")
    assert split_seal(b"SHO2") == (b"SHO2", None)
    assert split_seal(bytes(37) + b"SHO2") == (bytes(37) + b"SHO2", None)


def test_every_channel_is_at_the_port_that_its_page_states() -> None:
    plan = PortPlan(7665, True, ("alpha", "big_bravo", "bravo", "local"))
    homes = {"vehicle": 7670, "shore": 7667, "tick port": 7665, "done port": 7666}
    rows = re.findall(
        r"^\| `(\w+)(_<V>)?` \| `\w+` \| ([\w ]+) \|",
        (ROOT / "docs/reference/channels.md").read_text(),
        re.MULTILINE,
    )
    assert len(rows) > 50
    for topic, of_vehicle, home in rows:
        channel = topic + ("_BRAVO" if of_vehicle else "")
        assert plan.port_of(channel) == homes[home], channel
    at_others = {topic for topic, _, home in rows if "port" in home}
    assert at_others == TICK_PORT_CHANNELS | DONE_PORT_CHANNELS
    assert plan.port_of("NAV_BIG_BRAVO") == 7669  # The longest name that ends it.
    assert plan.port_of("MY_OWN") == 7667
    assert list(plan.data_ports) == [7667, 7668, 7669, 7670, 7671]
    assert PortPlan(7665, False, ("alpha",)).port_of("NAV_ALPHA") == 7667


def test_vehicles_beyond_128_share_ports() -> None:
    plan = PortPlan(7665, True, tuple(f"v{i}" for i in range(200)))
    assert plan.port_of("NAV_V0") == plan.port_of("NAV_V128") == 7668
    assert len(plan.data_ports) == 129


def announced(*pairs: tuple[str, bytes]) -> set[tuple[str, bytes]]:
    return set(pairs)


def test_messages_are_handled_in_the_fixed_order() -> None:
    inbox = StepInbox(b"me")
    inbox.add("B", Seal(b"zulu", 1, 4, 0), b"5")
    inbox.add("A", Seal(b"zulu", 1, 4, 2), b"4")
    inbox.add("A", Seal(b"zulu", 1, 4, 1), b"3")
    inbox.add("A", Seal(b"alpha", 1, 4, 9), b"2")
    inbox.add_outside("A", b"0")
    inbox.add_outside("A", b"1")
    inbox.add("A", Seal(b"lost", 1, 4, 0), b"of a publisher that no total announces")
    inbox.add("A", Seal(b"zulu", 1, 5, 0), b"of the next step")
    assert inbox.count("A", b"zulu", 4) == 2
    taken = inbox.take(4, announced(("A", b"zulu"), ("B", b"zulu"), ("A", b"alpha")), False)
    assert [data for _, data in taken] == [b"0", b"1", b"2", b"3", b"4", b"5"]
    assert inbox.count("A", b"zulu", 4) == 0 and inbox.count("A", b"zulu", 5) == 1


def test_a_datagram_that_comes_twice_is_one_message() -> None:
    inbox = StepInbox(b"me")
    for _ in range(2):
        inbox.add("A", Seal(b"zulu", 1, 4, 0), b"x")
    assert inbox.count("A", b"zulu", 4) == 1
    assert inbox.take(4, announced(("A", b"zulu")), False) == [("A", b"x")]


def test_what_a_former_process_of_the_name_published_is_dropped() -> None:
    inbox = StepInbox(b"me")
    inbox.add("A", Seal(b"me", 1, 4, 0), b"x")
    assert inbox.take(4, announced(("A", b"me")), True) == []


def test_a_flood_from_outside_is_bounded_and_counted() -> None:
    inbox = StepInbox(b"me")
    for _ in range(MOST_OUTSIDE + 5):
        inbox.add_outside("A", b"x")
    assert (inbox.num_outside, inbox.num_refused) == (MOST_OUTSIDE, 5)
    assert len(inbox.take(0, set(), False)) == MOST_OUTSIDE
