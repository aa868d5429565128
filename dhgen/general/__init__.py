"""Arms without three concurrent or parallel axes: the general 6R algorithm, up to 16 solutions."""
