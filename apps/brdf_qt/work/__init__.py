"""Work in the background: tasks and fits."""
