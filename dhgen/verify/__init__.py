"""Verification of the files as they will be written, on ordinary, singular and impossible poses."""
