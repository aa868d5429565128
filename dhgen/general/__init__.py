"""Arms that no order of steps solves: the general algorithms for 6R, 5R1P and 4R2P."""
