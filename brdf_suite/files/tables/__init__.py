"""Tables as people and instruments write them: cells of a text, the meaning of their columns, samples in them."""
