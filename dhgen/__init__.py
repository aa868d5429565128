"""dhgen: a compiler from Denavit-Hartenberg tables to exact inverse kinematics."""
