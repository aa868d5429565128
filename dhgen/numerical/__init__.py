"""Arms that nothing else solves: damped least squares from many starts."""
