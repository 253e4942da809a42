"""Pictures that are traced and not drawn: a process of its own makes them, and the window shows them as its own."""
