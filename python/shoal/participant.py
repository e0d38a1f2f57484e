"""A process that takes part in a mission: the clock waits for it (docs/extending/step_protocol.md).

    me = shoal.Participant()                      # started by `shoal run`
    me.subscribe("NAV_ALPHA")

    def think(utime):
        nav = me.newest("NAV_ALPHA")
        me.publish("ACTUATORS_ALPHA", shoal.types.actuators_t(utime=utime, thrust_pct=40.0))

    me.run(think)

The result does not depend on the machine's speed as long as `think` and the handlers take time
from `utime` alone, and chance from a generator with a seed.
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable, Mapping
from typing import Any

from .errors import BusError, DecodeError, StepError
from .message import Message
from .ports import GROUP, PortPlan
from .seal import Seal, append_seal, is_genuine, split_seal
from .socket_set import SocketSet, now_s
from .step_inbox import StepInbox
from .type_set import Types, own_types

_HELLO_S = 0.2
_REPEAT_S = 0.05
_GIVE_UP_S = 3.0
_LINGER_S = 0.3  # After END: the clock may not have received the answer.
_DIGITS = 64

Handler = Callable[[str, Any], object]
Think = Callable[[int], object]


def read_secret(environ: Mapping[str, str]) -> bytes:
    """Returns the mission's secret. Raises StepError where no variable leads to it."""
    text = b""
    descriptor = environ.get("SHOAL_SECRET_FD", "")
    if descriptor.isdecimal():
        try:
            text = os.pread(int(descriptor), _DIGITS + 2, 0)
        except (OSError, OverflowError):
            text = b""  # A program between may have closed it: the file may be there.
    path = environ.get("SHOAL_SECRET_FILE")
    if not text and path:
        try:
            with open(path, "rb") as file:
                text = file.read(_DIGITS + 2)
        except OSError as error:
            raise StepError(f"{path}: the mission's secret cannot be read: {error}") from error
    try:
        if len(text) == _DIGITS + 1:
            return bytes.fromhex(text.decode("ascii"))
    except ValueError:
        pass
    raise StepError(
        "no secret of the mission: neither SHOAL_SECRET_FD nor SHOAL_SECRET_FILE leads to it; "
        "`shoal run` sets both"
    )


def _give_up_after(mission_file: str) -> float:
    """Returns 3 s, or half of the mission's participant_timeout_s where that is less."""
    try:
        with open(mission_file, "rb") as file:
            timeout_s = float(tomllib.load(file)["mission"]["participant_timeout_s"])
    except (OSError, ValueError, KeyError, TypeError):
        return _GIVE_UP_S  # The default is 5 s.
    return min(_GIVE_UP_S, timeout_s / 2) if timeout_s > 0 else _GIVE_UP_S


class Participant:
    """This process as a participant of the mission that has started it.

    Attributes:
        name: Its name on the bus, as [[participant]] has it.
        vehicles: The mission's vehicles, in its order.
        step: The last step that was taken; -1: none yet.
    """

    def __init__(
        self, types: Types | None = None, environ: Mapping[str, str] | None = None
    ) -> None:
        """Reads the SHOAL_* variables.

        Args:
            types: Message types; shoal's own by default.
            environ: The variables; those of the process by default.

        Raises:
            StepError: a variable is missing.
            BusError: the bus cannot be opened.
        """
        environ = os.environ if environ is None else environ
        try:
            base = int(environ["SHOAL_PORT"])
            self.mission_id = int(environ["SHOAL_MISSION_ID"])
            self.name = environ["SHOAL_PARTICIPANT"]
            names = environ["SHOAL_VEHICLES"]
            layout = environ["SHOAL_LAYOUT"]
        except (KeyError, ValueError) as error:
            raise StepError(
                f"no variable of a mission: {error}; `shoal run` starts participants and sets it, "
                "or shows all of them where it waits for one that is started by hand"
            ) from error
        self.vehicles = [each for each in names.split(",") if each]
        self.step = -1
        self._secret = read_secret(environ)
        self._own_name = self.name.encode()
        self._plan = PortPlan(base, layout == "communities", tuple(self.vehicles))
        self._types = types or own_types()
        self._handlers: dict[str, list[Handler]] = {}
        self._newest: dict[str, Message] = {}
        self._inbox = StepInbox(self._own_name)
        self._sockets = SocketSet(GROUP)
        self._sockets.open(self._plan.tick_port)
        self._in_step = False
        self._has_ended = False
        self._fault = ""
        self._sequence = 0
        self._published: dict[str, int] = {}  # Of the step that is taken.
        self._sent: dict[int, list[tuple[str, bytes]]] = {}  # Sealed datagrams by step.
        self._give_up_s = _give_up_after(environ.get("SHOAL_MISSION_FILE", ""))
        self._answer = b""
        self._tick: Message | None = None  # Whose messages are not all here yet.
        self._tick_since_s = 0.0
        self._next_repeat_s = 0.0
        self._repeated = self._foreign = self._undecodable = self._refused = 0

    def subscribe(self, channel: str, handler: Handler | None = None) -> None:
        """Receives a channel in each step, in the fixed order; to be called before `run`.

        Args:
            channel: Its whole name, such as "NAV_ALPHA".
            handler: Called with (channel, message) before `think`; `newest` has the message, too.
        """
        handlers = self._handlers.setdefault(channel, [])
        if handler is not None:
            handlers.append(handler)
        self._sockets.open(self._plan.port_of(channel))

    def newest(self, channel: str) -> Any:
        """Returns the newest message of a channel that is subscribed to; None: none came yet."""
        if channel not in self._handlers:
            raise StepError(f"'{channel}' is not subscribed to")
        return self._newest.get(channel)

    def publish(self, channel: str, message: Message | bytes) -> None:
        """Publishes a message; all receive it in the next step. Only within a step.

        Raises:
            StepError: not within a step: outside of `think` and the handlers, or at the end.
        """
        if not self._in_step:
            raise StepError(f"{channel}: messages are published within a step only")
        data = message.encode() if isinstance(message, Message) else bytes(message)
        sealed = self._seal(channel, data, self.step, self._sequence)
        self._sockets.send(self._plan.port_of(channel), channel, sealed)
        self._sequence += 1
        self._published[channel] = self._published.get(channel, 0) + 1
        self._sent.setdefault(self.step, []).append((channel, sealed))

    def run(self, think: Think) -> None:
        """Takes part to the mission's end; calls `think(utime)` once in each step.

        What `think` or a handler raises ends it: the process is lost to the mission then, and
        `on_loss` of the mission file decides what follows.

        Raises:
            StepError: messages of the mission never came.
        """
        next_hello_s = last_news_s = 0.0
        while not self._has_ended or now_s() < last_news_s + _LINGER_S:
            if self.step < 0 and self._tick is None and now_s() >= next_hello_s:
                self._send_done(0, -1)
                next_hello_s = now_s() + _HELLO_S
            for port, channel, data in self._sockets.receive(_REPEAT_S):
                last_news_s = now_s()
                self._take(port, channel, data)
            if self._tick is not None:
                self._try_step(self._tick, think)
        self._sockets.close()
        if self._fault:
            raise StepError(self._fault)

    # ---- what comes off the bus ----

    def _take(self, port: int, channel: str, data: bytes) -> None:
        if port == self._plan.tick_port:
            if channel in ("TICK", "RESEND"):
                self._take_control(channel, data)
        elif channel in self._handlers:
            self._take_message(channel, data)

    def _take_control(self, channel: str, data: bytes) -> None:
        body, seal = split_seal(data)
        if seal is not None and seal.mission_id != self.mission_id:
            self._foreign += 1
            return
        if seal is None or not is_genuine(data, self._secret, channel):
            self._refused += 1
            return
        try:
            if channel == "TICK":
                self._take_tick(own_types().tick_t.decode(body))
            else:
                self._take_resend(own_types().resend_t.decode(body))
        except DecodeError:
            self._undecodable += 1

    def _take_tick(self, tick: Message) -> None:
        if tick.step == self.step:
            self._send_answer()  # The clock did not receive it.
            return
        if tick.step < self.step or self._has_ended:
            return
        self._inbox.forget_before(tick.step - 1)
        if self._takes_part(tick) and (self._tick is None or tick.step > self._tick.step):
            self._tick = tick
            self._tick_since_s = now_s()
            self._next_repeat_s = self._tick_since_s + _REPEAT_S

    def _takes_part(self, tick: Message) -> bool:
        """Returns true from the tick on with which the clock waits for this very process."""
        if self.step >= 0 or self._tick is not None or tick.kind == tick.END:
            return True
        return (self.name, os.getpid()) in zip(tick.joined, tick.joined_pids, strict=True)

    def _take_resend(self, request: Message) -> None:
        if request.mission_id != self.mission_id or request.publisher != self.name:
            return
        for channel, sealed in self._sent.get(request.step, []):
            if channel == request.channel:
                self._sockets.send(self._plan.port_of(channel), channel, sealed)

    def _take_message(self, channel: str, data: bytes) -> None:
        body, seal = split_seal(data)
        if seal is None:
            # What came before the first tick was published before the mission.
            if self.step >= 0 or self._tick is not None:
                self._inbox.add_outside(channel, body)
        elif seal.mission_id != self.mission_id:
            self._foreign += 1
        elif not is_genuine(data, self._secret, channel):
            self._refused += 1
        elif self.step < 0 or self.step <= seal.step <= self.step + 2:
            self._inbox.add(channel, seal, body)

    # ---- one step ----

    def _try_step(self, tick: Message, think: Think) -> None:
        """Takes the step where all is here; else asks for what is missing when that is due."""
        now = now_s()
        is_due = now >= self._next_repeat_s
        is_complete = True
        for total in tick.totals:
            publisher = total.publisher.encode()
            if total.channel not in self._handlers or self._is_of_former(publisher):
                continue
            count = self._inbox.count(total.channel, publisher, tick.step - 1)
            if count > total.count:
                self._give_up(
                    tick,
                    f"{total.publisher} published {count} messages on {total.channel} and counted "
                    f"{total.count}",
                )
                return
            if count == total.count:
                continue
            is_complete = False
            if is_due:
                self._ask_for(tick, total)
        if is_complete:
            self._tick = None
            self._take_step(tick, think)
        elif is_due:
            self._next_repeat_s = now + _REPEAT_S
            if now > self._tick_since_s + self._give_up_s:
                self._give_up(tick, "messages of the step before never reached it")

    def _is_of_former(self, publisher: bytes) -> bool:
        """Returns true for this process's own name in its first step: that process is gone."""
        return self.step < 0 and publisher == self._own_name

    def _ask_for(self, tick: Message, total: Message) -> None:
        self._repeated += 1
        request = own_types().resend_t(
            utime=tick.utime,
            mission_id=self.mission_id,
            step=tick.step - 1,
            requester=self.name,
            publisher=total.publisher,
            channel=total.channel,
        )
        self._send_control(self._plan.tick_port, "RESEND", request, request.step)

    def _give_up(self, tick: Message, fault: str) -> None:
        """States to the clock why this process cannot go on, again while it does not end."""
        self._fault = fault
        self._published = {}
        self._send_done(tick.utime, tick.step)
        self._has_ended = tick.kind == tick.END
        self._next_repeat_s = now_s() + _REPEAT_S

    def _take_step(self, tick: Message, think: Think) -> None:
        announced = {(each.channel, each.publisher.encode()) for each in tick.totals}
        messages = self._inbox.take(tick.step - 1, announced, first=self.step < 0)
        self.step = tick.step
        self._sequence = 0
        self._published = {}
        self._sent = {step: sent for step, sent in self._sent.items() if step >= tick.step - 1}
        self._has_ended = tick.kind == tick.END
        self._in_step = not self._has_ended
        for channel, data in messages:
            self._handle(channel, data)
        if not self._has_ended:
            think(tick.utime)
        self._in_step = False
        self._send_done(tick.utime, tick.step)

    def _handle(self, channel: str, data: bytes) -> None:
        try:
            message = self._types.decode(data)
        except DecodeError:
            self._undecodable += 1
            return
        self._newest[channel] = message
        for handler in self._handlers[channel]:
            handler(channel, message)

    # ---- what is sent ----

    def _seal(self, channel: str, data: bytes, step: int, sequence: int) -> bytes:
        seal = Seal(self._own_name, self.mission_id, step, sequence)
        return append_seal(data, seal, self._secret, channel)

    def _send_control(self, port: int, channel: str, message: Message, step: int) -> None:
        self._sockets.send(port, channel, self._seal(channel, message.encode(), step, 0))

    def _send_done(self, utime: int, step: int) -> None:
        """Answers a tick; step -1 is the hello before the first."""
        types = own_types()
        done = types.step_done_t(
            utime=utime,
            mission_id=self.mission_id,
            step=step,
            participant=self.name,
            pid=os.getpid(),
            repeated=self._repeated,
            outside=self._inbox.num_outside,
            foreign=self._foreign,
            undecodable=self._undecodable,
            refused=self._refused + self._inbox.num_refused,
            fault=self._fault,
            published=[
                types.step_count_t(channel=channel, count=count)
                for channel, count in self._published.items()
            ],
        )
        self._answer = self._seal("STEP_DONE", done.encode(), step, 0)
        self._send_answer()

    def _send_answer(self) -> None:
        self._sockets.send(self._plan.done_port, "STEP_DONE", self._answer)


__all__ = ["BusError", "Participant", "StepError", "read_secret"]
