"""Export of palettes and contact sheets."""
