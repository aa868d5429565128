"""What the templates of a solver name in every language: frozen groups of strings and numbers."""
