"""Solvers that change a pose so that it meets a goal: inverse kinematics."""
