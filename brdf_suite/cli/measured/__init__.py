"""Commands on measured reflectance: measure, compare, convert, fit, represent, acquire."""
