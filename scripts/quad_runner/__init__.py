"""The headless runner scripts/experiment, an idea a file."""
