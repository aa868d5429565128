"""Robot descriptions as people have them, turned into robot files: a stage before `robot`.

Read `convert`, the front door; then `xml` and `urdf`, the reader; `model`, what is read; `chain`,
which joints are the arm's; `mimic`, which follow others; `snap`, what is nearly right; `lines` and
`table`, from axes in space to a Denavit-Hartenberg table with `choices`, what is free in one, and
`cost`, what a reader likes; `write`, the robot file; `forward` and `compare`, whether it is the
robot that was described.
"""
