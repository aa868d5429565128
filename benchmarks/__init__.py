"""What is measured, not asserted: each module prints a table."""
