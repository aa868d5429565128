"""The Python target: a module of numba functions that are plain Python where numba is absent."""
