"""All tables, one after the other: `python benchmarks`."""

import frame
import load
import machine
import morph
import pose
import skin
import tick
import world

for table in (tick, pose, skin, morph, load, frame, world, machine):
    table.main()
    print()
