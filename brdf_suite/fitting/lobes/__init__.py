"""The fixed cosine lobes and the linear program that weighs them (Westlund and Meyer, sections 3 and 4)."""
