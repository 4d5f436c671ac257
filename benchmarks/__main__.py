"""Prints all tables: `python benchmarks`."""

import captures
import crowd
import detail
import feet
import frame
import ik
import lanes
import limbs
import load
import machine
import morph
import muscles
import pose
import skin
import spring
import tick
import whynot
import world

for table in (
    tick,
    spring,
    feet,
    crowd,
    pose,
    lanes,
    skin,
    morph,
    muscles,
    detail,
    load,
    captures,
    frame,
    ik,
    limbs,
    world,
    machine,
    whynot,
):
    table.main()
    print()
