"""Virtual instruments: spectrophotometer, glossmeter."""
