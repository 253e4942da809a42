"""The open paints: tabs, recovery, paints from other programs."""
