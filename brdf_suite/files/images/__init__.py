"""Images: environments, pictures, relief maps, colour profiles."""
