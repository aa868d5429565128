"""dhgen: a compiler from Denavit-Hartenberg tables to exact inverse kinematics."""

__version__ = "0.1.0"
