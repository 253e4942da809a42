"""What is looked at: sources, subjects and their fits."""
