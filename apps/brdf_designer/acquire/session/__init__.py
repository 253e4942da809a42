"""Step 1: the folder of photographs."""
