"""Commands that make pictures: render, turntable, sheet."""
