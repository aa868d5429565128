"""The program: what to compute, in a small language that every target prints."""
