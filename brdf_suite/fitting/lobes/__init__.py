"""The fixed cosine lobes and the linear program that weighs them (seed paper, sections 3 and 4)."""
