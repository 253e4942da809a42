"""Fixed cosine lobes and the linear program of their weights (Westlund and Meyer, sections 3 and 4)."""
