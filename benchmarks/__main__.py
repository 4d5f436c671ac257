"""All tables, one after the other: `python benchmarks`."""

import frame
import load
import morph
import pose
import skin
import tick
import world

for table in (tick, pose, skin, morph, load, frame, world):
    table.main()
    print()
