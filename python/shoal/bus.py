"""Reads and writes messages over LCM's UDP multicast, without LCM.

    bus = shoal.Bus("udpm://239.255.76.67:7667?ttl=0")
    bus.subscribe("NAV_*", lambda channel, nav: print(channel, nav.x_m))
    while True:
        bus.handle()
"""

from __future__ import annotations

import fnmatch
import re
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple
from urllib.parse import parse_qsl, urlsplit

from .errors import BusError, DecodeError
from .message import Message
from .ports import GROUP, PortPlan
from .running import RunningMission, choose_mission, running_missions
from .seal import split_seal
from .socket_set import SocketSet, now_s
from .type_set import Types, own_types

DEFAULT_URL = f"udpm://{GROUP}:7667?ttl=0"
Handler = Callable[[str, Any], object]


class Received(NamedTuple):
    """A message off the bus."""

    channel: str
    message: Message | bytes  #: The bytes, without a seal, where the type is not known.
    utime: int  #: When it was handled, by this machine's clock, in microseconds since 1970.
    publisher: str  #: As its seal names it, unproved; empty: it has none.


class _Subscription(NamedTuple):
    matches: Callable[[str], object]
    handler: Handler


def _parse_url(url: str) -> tuple[str, int, int]:
    """Returns group, port and ttl."""
    try:
        parts = urlsplit(url)
        port = 7667 if parts.port is None else parts.port
    except ValueError as error:
        raise BusError(f"{url}: {error}") from error
    if parts.scheme != "udpm":
        raise BusError(f"{url}: only udpm is supported, as in {DEFAULT_URL}")
    options = dict(parse_qsl(parts.query, keep_blank_values=True))
    ttl = options.get("ttl", "0")
    if not ttl.isdecimal() or int(ttl) > 255:
        raise BusError(f"{url}: ttl is a number from 0, this machine alone, to 255")
    group = parts.hostname or GROUP
    if not re.fullmatch(r"2(2[4-9]|3\d)(\.\d{1,3}){3}", group):
        raise BusError(f"{url}: {group} is not a multicast address, such as {GROUP}")
    return group, port, int(ttl)


class Bus:
    """LCM's bus at one port, or all buses of a running mission.

    Attributes:
        num_undecodable: Messages of a known type whose bytes are none of it; they are dropped.
    """

    def __init__(self, url: str = DEFAULT_URL, types: Types | None = None) -> None:
        """Opens the bus at `url`, as LCM writes it. Raises BusError."""
        group, port, ttl = _parse_url(url)
        self._begin(SocketSet(group, ttl), None, (port,), types)

    def _begin(
        self, sockets: SocketSet, plan: PortPlan | None, ports: Iterable[int], types: Types | None
    ) -> None:
        self.num_undecodable = 0
        self.mission: RunningMission | None = None
        self._types = types or own_types()
        self._sockets = sockets
        self._plan = plan
        self._ports = tuple(ports)
        self._may_publish = True
        self._subscriptions: list[_Subscription] = []

    @classmethod
    def of_running_mission(
        cls, port: int | None = None, commands: bool = False, types: Types | None = None
    ) -> Bus:
        """Opens the buses of a mission that this user runs: of its shore and all its vehicles.

        What is published there comes from outside the mission: it is counted, and the run is marked
        "Reproducible: no". A process that is to take part is a `shoal.Participant`.

        Args:
            port: The mission's first port. Without it, the one that was started in this folder; to
                look at only, the only one that runs.
            commands: Publishing is allowed, and the only one that runs will not do.
            types: Message types; shoal's own by default.

        Raises:
            BusError: which mission is meant is not clear (the text lists them), or no bus opens.
        """
        mission = choose_mission(running_missions(), port, commands)
        bus = cls.__new__(cls)
        plan = mission.ports
        bus._begin(SocketSet(GROUP), plan, (plan.tick_port, *plan.data_ports), types)
        bus.mission = mission
        bus._may_publish = commands
        return bus

    def subscribe(self, pattern: str, handler: Handler) -> None:
        """Calls `handler(channel, message)` for channels that match a shell pattern: "NAV_*"."""
        self._open()
        matches = re.compile(fnmatch.translate(pattern)).match
        self._subscriptions.append(_Subscription(matches, handler))

    def publish(self, channel: str, message: Message | bytes) -> None:
        """Publishes a message, or the bytes of one. Raises ValueError, BusError."""
        if not self._may_publish:
            raise BusError("this bus is to look at; open it with commands=True to publish")
        data = message.encode() if isinstance(message, Message) else bytes(message)
        port = self._ports[0] if self._plan is None else self._plan.port_of(channel)
        self._sockets.send(port, channel, data)

    def handle(self, timeout_s: float | None = None) -> int:
        """Waits for messages and hands those that are there to the handlers.

        Args:
            timeout_s: The longest to wait; None: until one comes for which there is a handler.

        Returns:
            How many messages were handled; 0: none came in time.
        """
        self._open()
        count = 0
        for received in self._receive(timeout_s):
            taken = [each for each in self._subscriptions if each.matches(received.channel)]
            for each in taken:
                each.handler(received.channel, received.message)
            count += 1 if taken else 0
        return count

    def iterate(self, pattern: str = "*", timeout_s: float | None = None) -> Iterator[Received]:
        """Returns messages as they come from now on; ends after `timeout_s` without one."""
        self._open()
        return self._iterate(re.compile(fnmatch.translate(pattern)).match, timeout_s)

    def _iterate(
        self, wanted: Callable[[str], object], timeout_s: float | None
    ) -> Iterator[Received]:
        count = -1
        while count != 0:
            count = 0
            for received in self._receive(timeout_s, wanted):
                count += 1
                yield received

    def __iter__(self) -> Iterator[Received]:
        return self.iterate()

    def _receive(
        self, timeout_s: float | None, wanted: Callable[[str], object] | None = None
    ) -> Iterator[Received]:
        """Waits until something wanted is there; without `wanted`, what a handler is for."""
        deadline = None if timeout_s is None else now_s() + timeout_s
        found = False
        while not found:
            left_s = None if deadline is None else max(deadline - now_s(), 0.0)
            for _, channel, data in self._sockets.receive(left_s):
                if wanted is not None and not wanted(channel):
                    continue
                if wanted is None and not any(
                    each.matches(channel) for each in self._subscriptions
                ):
                    continue
                received = self._decode(channel, data)
                if received is not None:
                    found = True
                    yield received
            if deadline is not None and now_s() >= deadline:
                return

    def _decode(self, channel: str, data: bytes) -> Received | None:
        message, seal = split_seal(data)
        publisher = "" if seal is None else seal.publisher.decode("utf-8", "backslashreplace")
        utime = time.time_ns() // 1000
        if self._types.of(data) is None:
            return Received(channel, message, utime, publisher)
        try:
            return Received(channel, self._types.decode(data), utime, publisher)
        except DecodeError:
            self.num_undecodable += 1
            return None

    def _open(self) -> None:
        """Receives from now on: a bus that only publishes opens no port."""
        for port in self._ports:
            self._sockets.open(port)

    @property
    def num_malformed(self) -> int:
        """Datagrams that LCM cannot have sent; they are dropped."""
        return self._sockets.assembler.num_malformed

    @property
    def num_abandoned(self) -> int:
        """Long messages of which a part never came."""
        return self._sockets.assembler.num_abandoned

    def close(self) -> None:
        """Closes the bus. Used as a context manager it closes at the end."""
        self._sockets.close()

    def __enter__(self) -> Bus:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
