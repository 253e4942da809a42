"""Picture files: stills, turntables, films."""
