"""The exact forward model: chains of constant and joint transforms, and their products."""
