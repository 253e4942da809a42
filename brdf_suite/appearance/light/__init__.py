"""Colours under another light."""
