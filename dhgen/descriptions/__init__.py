"""Robot descriptions as people have them, turned into robot files: a stage before `robot`.

Read `convert`, the front door, with `wishes`, its options; then `markup`, `tree` and `urdf`, the
reader, with `unread`, what no URDF has, `locked`, what limits hold, and `expand` and `mjcf` for
other formats; `model`, what is read; `chain`, which joints are the arm's; `mimic`, which follow
others; `free_joints`, which the caller gives; `snap` and `misses`, what is nearly right;
`rotations`, `lines` and `table`, from axes in space to a Denavit-Hartenberg table with `choices`,
what is free in one, and `cost`, what a reader likes; `write`, the robot file; `forward` and
`compare`, whether it is the robot that was described.
"""
