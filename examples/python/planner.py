#!/usr/bin/env python3
"""Steers one vessel to a list of waypoints, in step with the mission, in place of shoal's helm.

    planner.py VEHICLE X,Y [X,Y]...       x East, y North, metres

`shoal run missions/python_planner.toml` starts it.
"""

import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "python"))  # Of a checkout.
import shoal  # noqa: E402

CAPTURE_RADIUS_M = 8
CRUISE_THRUST_PCT = 40
RUDDER_GAIN = 1.5  # Degrees of rudder per degree of heading error.
MAX_RUDDER_DEG = 60

vehicle = sys.argv[1].upper()
waypoints_m = [tuple(map(float, point.split(","))) for point in sys.argv[2:]]
me = shoal.Participant()
me.subscribe(f"NAV_{vehicle}")


def think(utime):
    nav = me.newest(f"NAV_{vehicle}")
    command = shoal.types.actuators_t(utime=utime)
    if nav is not None and waypoints_m:
        east_m, north_m = waypoints_m[0][0] - nav.x_m, waypoints_m[0][1] - nav.y_m
        if math.hypot(east_m, north_m) <= CAPTURE_RADIUS_M:
            print(f"planner: t={utime / 1e6:.1f} s: at {waypoints_m.pop(0)}", flush=True)
        bearing_deg = math.degrees(math.atan2(east_m, north_m))
        rudder_deg = RUDDER_GAIN * math.remainder(bearing_deg - nav.heading_deg, 360)
        command.rudder_deg = max(-MAX_RUDDER_DEG, min(MAX_RUDDER_DEG, rudder_deg))
        command.thrust_pct = CRUISE_THRUST_PCT if waypoints_m else 0
    me.publish(f"ACTUATORS_{vehicle}", command)


me.run(think)
