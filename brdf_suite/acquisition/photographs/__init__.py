"""Photographs read from files, and their order."""
