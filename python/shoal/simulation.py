"""A whole mission inside this process: the same steps and the same log as `shoal sim`.

    with shoal.Simulation("missions/alpha.toml", seed=7) as sim:
        while sim.step(10):
            print(sim.time_s, sim["alpha"].x_m)
        print(sim.summary())
"""

from __future__ import annotations

import ctypes
import json
import math
import os
import weakref
from collections.abc import Callable, Iterable, Mapping
from types import TracebackType
from typing import Any

from .errors import SimulationError
from .message import Message
from .sim_library import sim_library
from .type_set import Types, own_types

_MOST_HELD_US = 1_000_000  # vehicle_sim stops thrusters that have had no order for 2 s.


def _override_text(key: str, value: object) -> str:
    if isinstance(value, str | bool | int | float | list | tuple):
        # What JSON writes of these is TOML, too.
        return f"{key}={json.dumps(value, ensure_ascii=False)}"
    raise TypeError(f"{key}: a {type(value).__name__} is not a value of a mission file")


def _finite(name: str, value: object) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"'{name}' is set to {value!r}; it takes a finite number")
    return number


class Simulation:
    """One mission, stepped by this program, which takes part as "embedder".

    A message that is published in one step is read in the next, as on every bus of shoal; what this
    program publishes reaches the others in the second step after. Use it from one thread at a time.
    """

    def __init__(
        self,
        mission: str | os.PathLike[str],
        *,
        overrides: Mapping[str, object] | Iterable[str] = (),
        seed: int | None = None,
        log: str | os.PathLike[str] | None = None,
        watch: Iterable[str] = (),
        collect: Iterable[str] = (),
        types: Types | None = None,
    ) -> None:
        """Loads the mission.

        Args:
            mission: The mission file.
            overrides: {"comms.comms_range": 100}, or texts as --set takes them.
            seed: In place of the mission file's.
            log: Where to write a log.
            watch: Channels to be read besides NAV_<V>, such as "NODE_REPORT_LOCAL".
            collect: Channels of which every message is wanted, such as "COMMS_FATES": `messages`.
            types: Message types; shoal's own by default.

        Raises:
            SimulationError: what is wrong with the mission file, one error per line.
        """
        self._handle: int | None = None
        self._freed: weakref.finalize | None = None
        self._library = library = sim_library()
        self._types = types or own_types()
        self._data = ctypes.c_void_p()
        self._size = ctypes.c_size_t()
        self._count = ctypes.c_int64()
        self._out = tuple(map(ctypes.byref, (self._data, self._size, self._count)))
        self._held: dict[str, Message] = {}
        self._handle = library.shoal_sim_new(os.fsencode(mission))
        if not self._handle:
            raise SimulationError("out of memory")
        self._freed = weakref.finalize(self, library.shoal_sim_free, self._handle)
        try:
            if isinstance(overrides, Mapping):
                overrides = [_override_text(key, value) for key, value in overrides.items()]
            for text in overrides:
                self._check(library.shoal_sim_set(self._handle, text.encode()))
            if seed is not None:
                if not 0 <= seed < 1 << 64:
                    raise SimulationError(f"the seed {seed} is not from 0 to 2^64 - 1")
                self._check(library.shoal_sim_set_seed(self._handle, seed))
            if log is not None:
                self._check(library.shoal_sim_set_log(self._handle, os.fsencode(log)))
            self._check(library.shoal_sim_open(self._handle))
            #: The names of the vehicles, in the mission's order.
            self.vehicles: list[str] = [
                library.shoal_sim_vehicle(self._handle, i).decode()
                for i in range(library.shoal_sim_num_vehicles(self._handle))
            ]
            self._channel_of = {name: f"NAV_{name.upper()}" for name in self.vehicles}
            #: Seconds of mission time in one step.
            self.tick_s: float = library.shoal_sim_tick_us(self._handle) / 1e6
            self._chunk = max(1, int(_MOST_HELD_US / 1e6 / self.tick_s))
            for channel in [*self._channel_of.values(), *watch]:
                self.watch(channel)
            for channel in collect:
                self._check(library.shoal_sim_collect(self._handle, channel.encode()))
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Simulation:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Ends the mission, and closes its log. Without effect after the first time."""
        if self._freed is not None:
            self._freed()
        self._handle = None

    def _check(self, code: int) -> int:
        if code < 0:
            raise SimulationError(self._library.shoal_sim_error(self._handle).decode())
        return code

    def watch(self, channel: str) -> None:
        """Keeps the last message of a channel, for `message`; before the first step."""
        self._check(self._library.shoal_sim_watch(self._handle, channel.encode()))

    def step(self, count: int = 1) -> int:
        """Takes up to `count` steps. Returns how many it took: fewer, down to 0, at the end.

        Raises:
            SimulationError: the mission cannot go on: the disk is full, a participant is lost.
        """
        if not self._held:
            return self._check(self._library.shoal_sim_step(self._handle, count))
        taken = 0
        while taken < count:
            for channel, message in self._held.items():
                message.utime = max(self.utime, 0)
                self.publish(channel, message)
            wanted = min(self._chunk, count - taken)
            done = self._check(self._library.shoal_sim_step(self._handle, wanted))
            taken += done
            if done < wanted:
                break
        return taken

    def end(self) -> None:
        """Ends the mission before its last step."""
        self._check(self._library.shoal_sim_end(self._handle))

    @property
    def step_number(self) -> int:
        """The last step taken, from 0; -1: none yet."""
        return int(self._library.shoal_sim_step_number(self._handle))

    @property
    def utime(self) -> int:
        """Mission time of the last step, microseconds."""
        return int(self._library.shoal_sim_utime(self._handle))

    @property
    def time_s(self) -> float:
        return self.utime / 1e6

    @property
    def has_ended(self) -> bool:
        return bool(self._library.shoal_sim_has_ended(self._handle))

    @property
    def passed(self) -> bool:
        """True where the mission would pass, should it end now."""
        return bool(self._library.shoal_sim_passed(self._handle))

    def summary(self) -> str:
        """Returns the mission's last page, should it end now: PASS, FAIL or INCOMPLETE."""
        return str(self._library.shoal_sim_summary(self._handle).decode())

    def data(self, channel: str) -> bytes | None:
        """Returns the last message of a channel as bytes; None: there was none yet."""
        self._check(self._library.shoal_sim_read(self._handle, channel.encode(), *self._out))
        if not self._data.value:
            return None
        return ctypes.string_at(self._data.value, self._size.value)

    def message(self, channel: str) -> Any:
        """Returns the last message of a channel that is watched; None: there was none yet."""
        data = self.data(channel)
        return None if data is None else self._types.decode(data)

    def messages(self, channel: str) -> list[Any]:
        """Takes all messages of a channel in `collect` since the last call, in their order.

        At most 64 MiB of a channel wait: beyond that `step` raises SimulationError.
        """
        taken = []
        name = channel.encode()
        while self._check(self._library.shoal_sim_take(self._handle, name, *self._out[:2])):
            data = ctypes.string_at(self._data.value or 0, self._size.value)
            taken.append(self._types.decode(data))
        return taken

    def __getitem__(self, vehicle: str) -> Any:
        """Returns the NAV message of a vehicle, where it is in truth; None: there was none yet."""
        channel = self._channel_of.get(vehicle)
        if channel is None:
            raise KeyError(f"no vehicle '{vehicle}'; the mission has {', '.join(self.vehicles)}")
        return self.message(channel)

    def observer(self, names: Iterable[str]) -> Callable[[], list[Any]]:
        """Returns a function that returns the values of these names as of the last step.

        Args:
            names: "alpha.x_m": a member of NAV_ALPHA; "HELM_STATE_ALPHA.state": of another channel,
                which is watched from then on. A value is nan before the first message.

        Raises:
            KeyError: a name that no message has.
            SimulationError: a channel that was not watched before the first step.
        """
        wanted: dict[str, list[tuple[int, str]]] = {}
        count = 0
        for place, name in enumerate(names):
            owner, dot, member = name.rpartition(".")
            if not dot:
                raise KeyError(f"'{name}': write vehicle.member, such as alpha.x_m")
            channel = self._channel_of.get(owner, owner)
            if owner in self._channel_of and member not in self._types["nav_t"].__slots__:
                known = ", ".join(self._types["nav_t"].__slots__)
                raise KeyError(f"'{name}': nav_t has no '{member}'; it has {known}")
            self.watch(channel)
            wanted.setdefault(channel, []).append((place, member))
            count = place + 1
        return _Observer(self, wanted, count)

    def observe(self, *names: str) -> list[Any]:
        """Returns the values of these names, as `observer` does."""
        return self.observer(names)()

    def publish(self, channel: str, message: Message | bytes) -> None:
        """Publishes a message, or its bytes, in the step that comes."""
        data = message if isinstance(message, bytes) else message.encode()
        self._check(
            self._library.shoal_sim_write(self._handle, channel.encode(), data, len(data))
        )

    def command(self, vehicle: str, command: str, *values: float, argument: str = "") -> None:
        """Sends an order to a vehicle's helm: "deploy", "return", "goto" X Y, "speed" V, "task"."""
        self[vehicle]  # Raises KeyError where there is no such vehicle.
        order = self._types["helm_command_t"](
            utime=max(self.utime, 0), command=command, argument=argument, values=list(values)
        )
        self.publish(f"HELM_COMMAND_{vehicle.upper()}", order)

    def act(self, actions: Mapping[str, float]) -> None:
        """Sets actuators by name: {"alpha.thrust_pct": 40, "alpha.rudder_deg": -5}.

        They hold until they are set again. For vehicles with helm = "none": another's helm sets
        them in each step.

        Raises:
            KeyError: no such vehicle, or no such actuator.
            ValueError: a value that is not a finite number. Nothing is set then.
        """
        numbers = {name: _finite(name, value) for name, value in actions.items()}
        for name, number in numbers.items():
            vehicle, _, member = name.rpartition(".")
            actuators = self._types["actuators_t"]
            if vehicle not in self._channel_of or member not in actuators.__slots__:
                known = ", ".join(actuators.__slots__[1:])
                raise KeyError(
                    f"'{name}' is not an actuator: write vehicle.member with {known}; "
                    f"vehicles are {', '.join(self.vehicles)}"
                )
            channel = f"ACTUATORS_{vehicle.upper()}"
            held = self._held.get(channel)
            if held is None:
                held = self._held[channel] = actuators()
            setattr(held, member, number)


class _Observer:
    """Reads each channel once, and messages of numbers alone without making an object."""

    def __init__(
        self, sim: Simulation, wanted: dict[str, list[tuple[int, str]]], count: int
    ) -> None:
        self._sim = sim
        self._wanted = [(channel.encode(), members) for channel, members in wanted.items()]
        self._count = count
        self._plans: dict[bytes, list[tuple[int, int]]] = {}  # By channel: place and member.

    def __call__(self) -> list[Any]:
        sim = self._sim
        read, handle = sim._library.shoal_sim_read, sim._handle
        values: list[Any] = [math.nan] * self._count
        for channel, members in self._wanted:
            sim._check(read(handle, channel, *sim._out))
            if not sim._data.value:
                continue
            data = ctypes.string_at(sim._data.value, sim._size.value)
            codec = sim._types.codec_of(data[:8])
            if codec is None:
                raise SimulationError(f"{channel.decode()}: its type is not known")
            if codec.flat is not None and codec.flat.size == len(data):
                row = codec.flat.unpack(data)
            else:
                row = codec.read_message(data, 0, len(data))
            plan = self._plans.get(channel)
            if plan is None:
                try:
                    plan = [(place, codec.attributes.index(name)) for place, name in members]
                except ValueError as error:
                    known = ", ".join(codec.attributes)
                    raise KeyError(f"{channel.decode()}: {error}; it has {known}") from None
                self._plans[channel] = plan
            for place, member in plan:
                values[place] = row[member]
        return values
