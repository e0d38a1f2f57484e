"""Finds and loads libshoal_sim.so.0, the C interface to a mission in one process."""

from __future__ import annotations

import ctypes
import os
from functools import cache
from pathlib import Path

from .errors import SimulationError

_NAME = "libshoal_sim.so.0"
_ABI_VERSION = 0
_VARIABLE = "SHOAL_SIM_LIBRARY"

_HANDLE = ctypes.c_void_p
_TEXT = ctypes.c_char_p
_COUNT = ctypes.c_int64
_FUNCTIONS: dict[str, tuple[type | None, list[object]]] = {
    "abi_version": (ctypes.c_int, []),
    "version": (_TEXT, []),
    "new": (_HANDLE, [_TEXT]),
    "free": (None, [_HANDLE]),
    "error": (_TEXT, [_HANDLE]),
    "set": (ctypes.c_int, [_HANDLE, _TEXT]),
    "set_seed": (ctypes.c_int, [_HANDLE, ctypes.c_uint64]),
    "set_log": (ctypes.c_int, [_HANDLE, _TEXT]),
    "watch": (ctypes.c_int, [_HANDLE, _TEXT]),
    "collect": (ctypes.c_int, [_HANDLE, _TEXT]),
    "take": (
        ctypes.c_int,
        [_HANDLE, _TEXT, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(ctypes.c_size_t)],
    ),
    "open": (ctypes.c_int, [_HANDLE]),
    "step": (_COUNT, [_HANDLE, _COUNT]),
    "end": (ctypes.c_int, [_HANDLE]),
    "read": (
        ctypes.c_int,
        [
            _HANDLE,
            _TEXT,
            ctypes.POINTER(ctypes.c_void_p),
            ctypes.POINTER(ctypes.c_size_t),
            ctypes.POINTER(ctypes.c_int64),
        ],
    ),
    "write": (ctypes.c_int, [_HANDLE, _TEXT, _TEXT, ctypes.c_size_t]),
    "step_number": (_COUNT, [_HANDLE]),
    "utime": (_COUNT, [_HANDLE]),
    "tick_us": (_COUNT, [_HANDLE]),
    "has_ended": (ctypes.c_int, [_HANDLE]),
    "num_vehicles": (_COUNT, [_HANDLE]),
    "vehicle": (_TEXT, [_HANDLE, _COUNT]),
    "passed": (ctypes.c_int, [_HANDLE]),
    "summary": (_TEXT, [_HANDLE]),
}


def _candidates() -> list[str]:
    chosen = os.environ.get(_VARIABLE)
    if chosen:
        return [chosen]
    here = Path(__file__).resolve().parent
    # Of a checkout, of another prefix (lib/python3/dist-packages/shoal), of the system.
    files = [here.parent.parent / "build/lib" / _NAME, here.parents[2] / _NAME]
    return [str(file) for file in files if file.is_file()] + [_NAME]


@cache
def sim_library() -> ctypes.CDLL:
    """Returns the library with the types of its functions set.

    Raises:
        SimulationError: it is not installed, or is that of another version.
    """
    problem = ""
    for path in _candidates():
        try:
            library = ctypes.CDLL(path)
            for name, (result, arguments) in _FUNCTIONS.items():
                function = getattr(library, "shoal_sim_" + name)
                function.restype = result
                function.argtypes = arguments
        except (OSError, AttributeError) as error:
            problem = problem or str(error)
            continue
        version = library.shoal_sim_abi_version()
        if version == _ABI_VERSION:
            return library
        problem = f"{path} has ABI version {version}, this package needs {_ABI_VERSION}"
    raise SimulationError(
        f"cannot load {_NAME}: {problem}; install shoal's package, or build it and set "
        f"{_VARIABLE} to its path"
    )
