"""What is kept on disk: lobe maps and baked occlusion."""
