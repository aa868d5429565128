"""From a derivation to a program, step by step; and from joint values to pose and Jacobian."""
