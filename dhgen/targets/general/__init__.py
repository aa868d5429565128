"""What the templates of the general algorithm are filled in with: strings and numbers."""
