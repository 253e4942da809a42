"""Commands for maintenance and development: cache, agreement, basis, bench."""
