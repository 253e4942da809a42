"""Relief and masks on the GPU."""
