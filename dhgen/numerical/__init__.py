"""An arm's constants for damped least squares; the steps themselves are in the runtime."""
