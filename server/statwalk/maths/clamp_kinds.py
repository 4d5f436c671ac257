"""The kinds of limits of a rotation (`clamp_table`)."""

FREE, HINGE, CONE, RANGE, EULER = range(5)
"""none; twist alone; twist, and swing in an elliptic cone; twist, and a range for each axis of the swing;
angles about X, then Y, then Z (FAQ order, R = Rz·Ry·Rx)"""
TOLERANCE = 1e-6
"""radians, or units of length: beyond its limits by less, a joint counts as inside"""
