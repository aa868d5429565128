"""All solutions by search, for any arm; of the compiler it shares the robot file, nothing else.

Read `arm` and `forward`, the arm in numbers, with `arm_angle`; `problem`, a pose to reach;
`search`, from very many starts, by `descent` and `levenberg_marquardt`. `poses` are joint values to
try.
"""
