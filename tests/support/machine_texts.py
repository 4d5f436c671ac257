"""Texts of machine files."""

ROBOT = """semantics: 1
character: robot.glb
root: Hips
title: A robot
initial: STAT
defaults: {when: now, blend: 0.25, buffer: 0.5}
states:
  STAT: {motion: stand, loop: true}
  WALK: {motion: walk, speed: pace}
table: |
  state | FORWARD | STOP | END
  STAT  | WALK    |      |
  WALK  |         | STAT | WALK
cells:
  WALK/STOP: {blend: 0.1, action: halt, when: end}
keys:
  ArrowUp: {hold: FORWARD, release: STOP}
parameters:
  pace: {default: 1, min: 0.5, max: 2}
properties:
  - WALK only after STAT
"""
