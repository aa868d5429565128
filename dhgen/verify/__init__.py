"""Verification: the files as they will be written, on random, singular, boundary and impossible poses."""
