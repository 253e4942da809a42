"""Steps 6 and 7: reconstruction and coverage of the table."""
