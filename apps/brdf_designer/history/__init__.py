"""The history of a paint as a strip of states."""
