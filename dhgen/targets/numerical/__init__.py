"""What the templates of the numerical solver are filled in with: strings and numbers."""
