"""The robot file: from YAML text to a validated, frozen Robot."""
