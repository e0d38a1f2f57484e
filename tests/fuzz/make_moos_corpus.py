#!/usr/bin/env python3
"""Writes the corpus of moos_import_fuzz: the examples' files, whole and in pieces."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples/moos"
CORPUS = ROOT / "tests/fuzz/corpus/moos_import"


def write(name, *texts):
    (CORPUS / name).write_bytes(b"\0".join(texts))


def main():
    CORPUS.mkdir(parents=True, exist_ok=True)
    abe = (EXAMPLES / "meta_abe.moos").read_bytes()
    vessel = (EXAMPLES / "avoid/meta_vehicle.moos").read_bytes().replace(b"plug_origin.moos", b"plug")
    circle = (EXAMPLES / "avoid/meta_vehicle.bhv").read_bytes().replace(b"plug_modes.bhv", b"plug")
    modes = (EXAMPLES / "avoid/plug_modes.bhv").read_bytes()
    avoid = (EXAMPLES / "avoid/plug_avoid.bhv").read_bytes()
    survey = (EXAMPLES / "meta_abe.bhv").read_bytes()
    write("survey", abe, survey)
    write("circle", vessel, circle, modes)
    write("avoid", vessel, b"#include plug\n#include plug\n" + survey, avoid)
    write("cut", vessel[:700], circle[:300], modes[:100])
    write("macros", vessel.replace(b"54.40", b"$(V)"), b"speed = $(V)$(V)\n" + circle, b"1,2:3,4")
    write("circular", b"#include plug\n" + abe, survey, b"#include plug\n#ifdef V\n")
    types = [
        "Waypoint", "Loiter", "StationKeep", "ConstantDepth", "AvoidCollision", "AvdColregsV22",
        "ConstantSpeed", "ConstantHeading", "AvoidObstacleV24", "Timer", "PeriodicSurface", "Trail",
        "MaxDepth", "MaxSpeed", "CutRange", "ConvoyV21", "GoToDepth", "LegRun", "OpRegionV24",
        "MemoryTurnLimit", "PeriodicSpeed", "Shadow", "FixedTurn", "ZigZag", "FullStop",
        "TestFailure"]
    blocks = "".join(f"Behavior = BHV_{each} {{\n name = {each}_\n pwt = 5\n}}\n" for each in types)
    write("types", abe, blocks.encode())


if __name__ == "__main__":
    main()
