"""The sections of a document, each from the story of a derivation."""
