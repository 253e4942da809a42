"""Meshes read by libraries of others, in a child process with limits of time and memory."""
