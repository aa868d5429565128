"""How programs are built: nodes, every expression once, and the statements that they become."""
