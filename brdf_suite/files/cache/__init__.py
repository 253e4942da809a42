"""What the programs keep on disk to save time: entries named by what they were made from."""
