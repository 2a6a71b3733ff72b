"""Finished runs in other programs' formats: one module a format, flights.py reads the run. Used by export_run."""
