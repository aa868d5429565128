"""What damped least squares know of an arm; the steps themselves are in the runtime."""
