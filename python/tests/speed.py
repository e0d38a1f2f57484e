"""Measures how long it takes to read a log, and to use every column of every channel.

    python3 tests/speed.py LOG [--without-numpy]
"""

import sys
import time
from pathlib import Path

if "--without-numpy" in sys.argv:
    sys.modules["numpy"] = None  # type: ignore[assignment]
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import shoal  # noqa: E402


def use(table: shoal.Table) -> None:
    for name in table.columns:
        if isinstance(column := table[name], shoal.Table):
            use(column)


begin_s, begin_cpu_s = time.perf_counter(), time.process_time()
log = shoal.read(sys.argv[1])
for channel in log.channels:
    use(log[channel])
    log[channel].time_s  # noqa: B018
print(
    f"{len(log)} messages: {time.process_time() - begin_cpu_s:.2f} s of processor time, "
    f"{time.perf_counter() - begin_s:.2f} s"
)
