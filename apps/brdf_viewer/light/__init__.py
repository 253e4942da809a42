"""Environment, lamps and exposure."""
