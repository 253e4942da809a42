"""Steps 6 and 7: the table from the photographs, and its coverage."""
