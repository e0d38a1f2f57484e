"""Sends and receives LCM's datagrams on any number of ports of this machine, with ttl=0."""

from __future__ import annotations

import selectors
import socket
import struct
import time
from collections.abc import Iterator

from .errors import BusError
from .wire import Assembler, split_message

_WANTED_BUFFER = 4 << 20  # Bytes; the kernel gives what net.core.rmem_max allows.
_MOST_AT_ONCE = 1000  # Datagrams of a port before the next port has its turn.
_HINT = "run `shoal doctor`, or see docs/start/troubleshooting.md"


class SocketSet:
    """Sockets of one multicast group, by port."""

    def __init__(self, group: str, ttl: int = 0, buffer_size: int = _WANTED_BUFFER) -> None:
        """Raises BusError where no socket can be opened."""
        self.assembler = Assembler()
        self._group = group
        self._buffer_size = buffer_size
        self._sequence = 0
        self._selector = selectors.DefaultSelector()
        self._sockets: dict[int, socket.socket] = {}
        try:
            self._sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
            self._sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 1)
            self._sender.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 20)
        except OSError as error:
            raise BusError(f"cannot open a socket: {error.strerror}; {_HINT}") from error

    def open(self, port: int) -> None:
        """Receives on a port from now on. Raises BusError where that fails."""
        if port in self._sockets:
            return
        try:
            opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        except OSError as error:
            raise BusError(f"cannot open a socket: {error.strerror}; {_HINT}") from error
        try:
            opened.setblocking(False)
            opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, self._buffer_size)
            opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            # The group's own address: what is sent to this machine's does not come in.
            opened.bind((self._group, port))
            membership = struct.pack("=4sI", socket.inet_aton(self._group), socket.INADDR_ANY)
            opened.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            opened.close()
            raise BusError(
                f"cannot receive on udpm://{self._group}:{port}: {error.strerror}; {_HINT}"
            ) from error
        self._sockets[port] = opened
        self._selector.register(opened, selectors.EVENT_READ, port)

    def send(self, port: int, channel: str, data: bytes) -> None:
        """Raises ValueError for what LCM cannot send, BusError where the machine cannot."""
        for datagram in split_message(channel, data, self._sequence):
            try:
                self._sender.sendto(datagram, (self._group, port))
            except OSError as error:
                raise BusError(
                    f"cannot send to udpm://{self._group}:{port}: {error.strerror}; {_HINT}"
                ) from error
        self._sequence = (self._sequence + 1) & 0xFFFFFFFF

    def receive(self, timeout_s: float | None) -> Iterator[tuple[int, str, bytes]]:
        """Waits for datagrams, then returns (port, channel, message) of those that are there.

        Args:
            timeout_s: The longest to wait; None: without end.
        """
        for key, _ in self._selector.select(timeout_s):
            port = key.data
            for datagram, sender in self._read(key.fileobj):
                whole = self.assembler.add((sender, port), datagram)
                if whole is not None:
                    yield port, *whole

    @staticmethod
    def _read(opened: object) -> Iterator[tuple[bytes, object]]:
        assert isinstance(opened, socket.socket)
        for _ in range(_MOST_AT_ONCE):
            try:
                yield opened.recvfrom(65536)
            except BlockingIOError:
                return
            except OSError:
                return  # An error of a datagram that was sent before: nothing is lost with it.

    def close(self) -> None:
        """Closes all sockets."""
        self._selector.close()
        for opened in (self._sender, *self._sockets.values()):
            opened.close()
        self._sockets.clear()


def now_s() -> float:
    """Returns seconds on a clock that never goes back."""
    return time.monotonic()
