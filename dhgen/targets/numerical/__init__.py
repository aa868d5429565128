"""What the templates of the numerical solver are filled in with: finished strings."""
