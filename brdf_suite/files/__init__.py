"""Reading and writing files that others made, one module per format family."""
