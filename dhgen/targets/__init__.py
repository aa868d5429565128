"""Targets: a program printed as a language, through the templates."""
