"""An arm's constants for damped least squares; the steps themselves are in the runtime.

Read `kernel`, the constants, and `runtime_arm`, the numbers that the runtime gets.
"""
