"""All solutions by search, for any arm; of the compiler it shares the robot file, nothing else."""
