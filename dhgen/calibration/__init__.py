"""Arms as they were built: the robot file of one arm from that of its kind and what was measured.

Read `read`, the files that people have; `chain`, the joints that they mean; `calibrate`, the robot
file.
"""
