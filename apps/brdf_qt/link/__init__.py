"""The live link between programs."""
