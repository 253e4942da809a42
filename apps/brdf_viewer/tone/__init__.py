"""The tone curve and the monitor."""
